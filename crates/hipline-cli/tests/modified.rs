//! Modified skeletons on the command line.

use std::{fs, path::PathBuf, process::Output};

use assert_cmd::Command;
use serde_json::Value;

/// A star of three acute points.
const STAR: &str = "POLYGON ((0 0, 10 2, 20 0, 12 9, 10 20, 8 9, 0 0))\n";

/// A directory of its own for one test, gone at its end.
struct Scratch(PathBuf);

impl Scratch {
    fn new(name: &str) -> Self {
        let path =
            std::env::temp_dir().join(format!("hipline-modified-{name}-{}", std::process::id()));
        fs::create_dir_all(&path).unwrap();
        fs::write(path.join("star.wkt"), STAR).unwrap();
        Self(path)
    }

    fn run(&self, args: &[&str]) -> Output {
        let mut command = Command::cargo_bin("hipline").unwrap();
        command.args(args).current_dir(&self.0).output().unwrap()
    }

    /// The output of a run that succeeds, as JSON.
    fn json(&self, args: &[&str]) -> Value {
        let output = self.run(args);
        assert_eq!(output.status.code(), Some(0), "{}", err(&output));
        serde_json::from_slice(&output.stdout).unwrap()
    }
}

impl Drop for Scratch {
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(&self.0);
    }
}

fn err(output: &Output) -> &str {
    std::str::from_utf8(&output.stderr).unwrap()
}

#[test]
fn modified_skeletons_are_written_and_checked() {
    let scratch = Scratch::new("written");
    let args = ["skeleton", "star.wkt", "--side", "exterior"];
    let plain = scratch.json(&args);
    let modified = scratch.json(&[&args[..], &["--modified"]].concat());
    let sides = |result: &Value| -> Vec<String> {
        let faces = result["faces"].as_array().unwrap().iter();
        let sides = faces.map(|face| face["side"].as_str().unwrap().to_owned());
        sides.collect()
    };
    assert_eq!(sides(&plain).len(), 6);
    let found = sides(&modified);
    let count = |name: &str| found.iter().filter(|side| *side == name).count();
    assert_eq!([found.len(), count("start"), count("end")], [12, 3, 3]);
    // The result is checked by what it is.
    for flags in [&["--modified"][..], &[]] {
        let flags = [&args[..], flags, &["-o", "result.json"]].concat();
        assert_eq!(scratch.run(&flags).status.code(), Some(0));
        let checked = scratch.run(&["check", "star.wkt", "--result", "result.json"]);
        assert_eq!(checked.status.code(), Some(0), "{}", err(&checked));
    }
}

#[test]
fn no_offset_shoots_ahead() {
    let scratch = Scratch::new("offset");
    let args = ["offset", "star.wkt", "--side", "exterior", "-d", "2"];
    let farthest = |map: &Value| {
        let text = map["features"].to_string();
        let numbers = text
            .split(|c: char| !(c.is_ascii_digit() || c == '-' || c == '.'))
            .filter_map(|number| number.parse::<f64>().ok());
        numbers.fold(0.0, f64::max)
    };
    let plain = farthest(&scratch.json(&args));
    let modified = farthest(&scratch.json(&[&args[..], &["--modified"]].concat()));
    assert!(plain > 30.0, "{plain}");
    assert!(
        modified < 20.0 + 2.0 * std::f64::consts::SQRT_2,
        "{modified}"
    );
}

#[test]
fn weights_are_refused() {
    let scratch = Scratch::new("weights");
    let args = ["skeleton", "star.wkt", "--modified", "--weight", "2=3"];
    let output = scratch.run(&args);
    assert_eq!(output.status.code(), Some(1));
    let reason = "the speed of edge 2 does not allow for it";
    assert!(err(&output).contains(reason), "{}", err(&output));
    assert_eq!(err(&output).lines().count(), 1);
    assert!(output.stdout.is_empty());
}
