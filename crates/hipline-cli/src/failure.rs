//! What can go wrong, and the exit codes that tell.

use std::{fmt::Display, io, process::ExitCode};

/// How a command ended that did not break off.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Outcome {
    /// Everything was done.
    Done,
    /// Something was wrong with a part of the input; it has been reported.
    Flawed,
}

/// Why a command broke off.
#[derive(Debug)]
pub enum Failure {
    /// Something is wrong with the input or a file.
    Input(String),
    /// What was asked for makes no sense.
    Usage(String),
    /// Nobody reads standard output any more.
    NobodyReads,
}

impl Failure {
    /// A failure of the file system, with the file's name.
    pub fn file(path: impl Display, error: &io::Error) -> Self {
        if error.kind() == io::ErrorKind::BrokenPipe {
            Self::NobodyReads
        } else {
            Self::Input(format!("{path}: {error}"))
        }
    }
}

/// Prints an error.
pub fn report(error: impl Display) {
    print_to_stderr(format_args!("error: {error}"));
}

/// Prints a warning.
pub fn warn(warning: impl Display) {
    print_to_stderr(format_args!("warning: {warning}"));
}

/// Prints a line on standard error. If even that fails, nobody can be told.
pub fn print_to_stderr(line: impl Display) {
    use io::Write;
    let _ = writeln!(io::stderr().lock(), "{line}");
}

/// 0 done, 1 something wrong with the input, 2 wrong usage. That nobody reads the output to
/// its end (`hipline ... | head`) is no failure.
pub fn exit_code(result: Result<Outcome, Failure>) -> ExitCode {
    match result {
        Ok(Outcome::Done) | Err(Failure::NobodyReads) => ExitCode::SUCCESS,
        Ok(Outcome::Flawed) => ExitCode::from(1),
        Err(Failure::Input(message)) => {
            report(message);
            ExitCode::from(1)
        }
        Err(Failure::Usage(message)) => {
            report(message);
            ExitCode::from(2)
        }
    }
}
