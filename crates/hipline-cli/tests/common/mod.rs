//! What tests of the program share: runs of it, what they say, directories for their files.
#![allow(dead_code, reason = "no test needs all of it")]

use std::{fs, path::PathBuf, process::Output};

use assert_cmd::Command;
use serde_json::Value;

/// The program, about to be run.
pub fn hipline(args: &[&str]) -> Command {
    let mut command = Command::cargo_bin("hipline").unwrap();
    command.args(args);
    command
}

/// Runs the program with something on its standard input.
pub fn run(args: &[&str], input: &str) -> Output {
    hipline(args).write_stdin(input).output().unwrap()
}

pub fn text(bytes: &[u8]) -> &str {
    std::str::from_utf8(bytes).unwrap()
}

pub fn out(output: &Output) -> &str {
    text(&output.stdout)
}

pub fn err(output: &Output) -> &str {
    text(&output.stderr)
}

pub fn code(output: &Output) -> i32 {
    output.status.code().expect("the program ends by itself")
}

pub fn json(text: &str) -> Value {
    serde_json::from_str(text).unwrap()
}

/// The output of a run that succeeds.
pub fn result(output: &Output) -> Value {
    assert_eq!(code(output), 0, "{}", err(output));
    json(out(output))
}

/// A directory of its own for one test, gone at its end.
pub struct Scratch(pub PathBuf);

impl Scratch {
    /// The name has to be another one for each test of a file.
    pub fn new(name: &str) -> Self {
        let path = std::env::temp_dir().join(format!("hipline-{name}-{}", std::process::id()));
        fs::create_dir_all(&path).unwrap();
        Self(path)
    }

    pub fn path(&self, name: &str) -> String {
        self.0.join(name).to_str().unwrap().to_owned()
    }

    /// Writes a file, and returns its path.
    pub fn file(&self, name: &str, content: &str) -> String {
        fs::write(self.0.join(name), content).unwrap();
        self.path(name)
    }

    /// The files in it, in order.
    pub fn names(&self) -> Vec<String> {
        let entries = fs::read_dir(&self.0).unwrap();
        let mut names: Vec<_> = entries
            .map(|e| e.unwrap().file_name().into_string().unwrap())
            .collect();
        names.sort();
        names
    }

    /// Runs the program in it.
    pub fn run(&self, args: &[&str]) -> Output {
        hipline(args).current_dir(&self.0).output().unwrap()
    }
}

impl Drop for Scratch {
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(&self.0);
    }
}
