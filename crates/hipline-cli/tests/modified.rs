//! Modified skeletons on the command line.

mod common;

use common::{Scratch, err, result};
use serde_json::Value;

/// A star of three acute points.
const STAR: &str = "POLYGON ((0 0, 10 2, 20 0, 12 9, 10 20, 8 9, 0 0))\n";

/// A directory with the star in a file.
fn star(name: &str) -> Scratch {
    let scratch = Scratch::new(name);
    scratch.file("star.wkt", STAR);
    scratch
}

#[test]
fn modified_skeletons_are_written_and_checked() {
    let scratch = star("written");
    let args = ["skeleton", "star.wkt", "--side", "exterior"];
    let plain = result(&scratch.run(&args));
    let modified = result(&scratch.run(&[&args[..], &["--modified"]].concat()));
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
    let scratch = star("offset");
    let args = ["offset", "star.wkt", "--side", "exterior", "-d", "2"];
    let farthest = |map: &Value| {
        let text = map["features"].to_string();
        let numbers = text
            .split(|c: char| !(c.is_ascii_digit() || c == '-' || c == '.'))
            .filter_map(|number| number.parse::<f64>().ok());
        numbers.fold(0.0, f64::max)
    };
    let plain = farthest(&result(&scratch.run(&args)));
    let modified = farthest(&result(
        &scratch.run(&[&args[..], &["--modified"]].concat()),
    ));
    assert!(plain > 30.0, "{plain}");
    assert!(
        modified < 20.0 + 2.0 * std::f64::consts::SQRT_2,
        "{modified}"
    );
}

#[test]
fn weights_are_refused() {
    let scratch = star("weights");
    let args = ["skeleton", "star.wkt", "--modified", "--weight", "2=3"];
    let output = scratch.run(&args);
    assert_eq!(output.status.code(), Some(1));
    let reason = "the speed of edge 2 does not allow for it";
    assert!(err(&output).contains(reason), "{}", err(&output));
    assert_eq!(err(&output).lines().count(), 1);
    assert!(output.stdout.is_empty());
}
