//! How fast hipline is, and how much memory it takes, on inputs of every character.
//!
//! ```text
//! options    the command line
//! input      the families and the files, and what is asked of each
//! measure    one measurement, within a process of its own
//! worker     that process, seen from outside: started, waited for, ended at the limit
//! campaign   which measurements to make, given those made before
//! report     tables, verdicts, JSON
//! engines    the engines side by side, where several apply
//! roofs      roofs per second, which needs no process of its own
//! ```
//!
//! Every measurement has its own process, so that none inherits the heap of another, the peak of
//! the memory is its own, and one that fails or takes too long takes nothing else with it.
//! `docs/benchmarks.md` tells how to run it and what the columns mean.

mod campaign;
mod engines;
mod input;
mod measure;
mod options;
mod report;
mod roofs;
mod worker;

use std::process::ExitCode;

#[cfg(feature = "mimalloc")]
use mimalloc::MiMalloc as Allocator;
#[cfg(not(feature = "mimalloc"))]
use std::alloc::System as Allocator;

/// Counts what is allocated, and passes everything on.
#[global_allocator]
static MEMORY: cap::Cap<Allocator> = cap::Cap::new(Allocator, usize::MAX);

fn main() -> ExitCode {
    match run() {
        Ok(()) => ExitCode::SUCCESS,
        Err(reason) => {
            eprintln!("hipline-bench: {reason}");
            ExitCode::FAILURE
        }
    }
}

fn run() -> Result<(), String> {
    let mut arguments: Vec<_> = std::env::args_os().skip(1).collect();
    if arguments.first().is_some_and(|first| first == worker::FLAG) {
        arguments.remove(0);
        return worker::serve(&arguments);
    }
    match arguments.first() {
        Some(first) if first == engines::WORKER => return engines::serve(&arguments[1..]),
        Some(first) if first == engines::FLAG => return engines::run(arguments.split_off(1)),
        _ => {}
    }
    let Some(options) = options::parse(arguments)? else {
        print!("{}", options::HELP);
        return Ok(());
    };
    if options.roofs {
        return roofs::run(&options.data);
    }
    let rows = campaign::run(&options);
    print!("{}", report::text(&rows, options.style));
    if let Some(path) = &options.json {
        let json = report::json(&rows, &options);
        std::fs::write(path, json).map_err(|e| format!("{}: {e}", path.display()))?;
    }
    Ok(())
}
