//! One module a command.

mod centreline;
mod check;
mod draw;
mod motorcycles;
mod offset;
mod points;
mod query;
mod rain;
mod roof;
mod scene;
mod skeleton;
mod terrain;
mod write_offset;

use std::io::{self, Write};

use clap::CommandFactory;

use crate::{
    args::{Args, Command, OutputFormat},
    failure::{Failure, Outcome, warn},
    output::Target,
};

/// Does what was asked for.
pub fn run(command: Command) -> Result<Outcome, Failure> {
    // What the library says when it panics is reported with the feature's name.
    std::panic::set_hook(Box::new(|_| {}));
    match command {
        Command::Skeleton(args) => skeleton::run(&args),
        Command::Offset(args) => offset::run(&args),
        Command::Centreline(args) => centreline::run(&args),
        Command::Roof(args) => roof::run(&args),
        Command::Terrain(args) => terrain::run(&args),
        Command::Rain(args) => rain::run(&args),
        Command::Motorcycles(args) => motorcycles::run(&args),
        Command::Query(args) => query::run(&args),
        Command::Check(args) => check::run(&args),
        Command::Draw(args) => draw::run(&args),
        Command::Completions(args) => {
            let mut script = Vec::new();
            clap_complete::generate(args.shell, &mut Args::command(), "hipline", &mut script);
            print(&script)
        }
        Command::Man => {
            let mut page = Vec::new();
            clap_mangen::Man::new(Args::command())
                .render(&mut page)
                .map_err(|e| Failure::file("the man page", &e))?;
            print(&page)
        }
    }
}

/// Prints to standard output.
fn print(bytes: &[u8]) -> Result<Outcome, Failure> {
    let mut out = io::stdout().lock();
    out.write_all(bytes)
        .and_then(|()| out.flush())
        .map_err(|e| Failure::file("standard output", &e))?;
    Ok(Outcome::Done)
}

/// Labels are text, and PNG pictures have none.
fn warn_of_labels(labels: bool, targets: &[Target]) {
    if labels && targets.iter().any(|t| t.format == OutputFormat::Png) {
        warn("PNG pictures have no labels; SVG has");
    }
}
