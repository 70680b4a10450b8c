//! The command line of hipline: straight skeletons of files.
//!
//! ```text
//! args        what can be asked for; help, completions and the man page derive from it
//! parse       values of flags
//! failure     exit codes
//! input       from a file or standard input to features
//! compute     from features to skeletons, each on its own
//! output      whole files or none, standard output without panics
//! tags        OpenStreetMap's tags of buildings
//! command/    one module a command
//! ```
//!
//! No geometry here: files are converted, the library is called, results are converted.

mod args;
mod command;
mod compute;
mod failure;
mod input;
mod output;
mod parse;
mod tags;

use std::process::ExitCode;

use clap::Parser;

/// Large results come in large pages, and threads allocate without waiting for each other.
#[cfg(feature = "mimalloc")]
#[global_allocator]
static MEMORY: mimalloc::MiMalloc = mimalloc::MiMalloc;

fn main() -> ExitCode {
    let args = args::Args::parse();
    failure::exit_code(command::run(args.command))
}
