//! `hipline motorcycles` as a user meets it.

mod common;

use std::{fs, path::Path};

use common::{Scratch, result, run, text};
use serde_json::Value;

const NOTCH: &str = "POLYGON ((0 0, 8 0, 8 6, 4 2, 0 6))";

const RACE: &str = "x,y,vx,vy,time\n0,0,1,0,0\n3,-4,0,2,0.5\n2,1,-1,0,\n";

#[test]
fn a_polygon_sends_its_reflex_vertices() {
    let output = run(&["motorcycles", "-"], NOTCH);
    // The root of two, exactly rounded.
    let stop = r#""stop":{"x":4,"y":0,"time":1.4142135623730951}"#;
    assert!(
        text(&output.stdout).contains(stop),
        "{}",
        text(&output.stdout)
    );
    let result = &result(&output)["results"][0];
    let motorcycles = result["motorcycles"].as_array().unwrap();
    assert_eq!(motorcycles.len(), 1);
    let one = &motorcycles[0];
    assert_eq!(one["start"], serde_json::json!({"x": 4, "y": 2, "time": 0}));
    assert_eq!(
        (&one["stop"]["x"], &one["stop"]["y"]),
        (&4.into(), &0.into())
    );
    assert_eq!(
        (&one["from"], &one["from_id"]),
        (&"vertex".into(), &3.into())
    );
    assert_eq!((&one["end"], &one["end_id"]), (&"edge".into(), &0.into()));
}

#[test]
fn tracks_are_lines_of_a_map() {
    let lines = result(&run(&["motorcycles", "-", "-f", "geojson"], NOTCH));
    let feature = &lines["features"][0];
    assert_eq!(feature["geometry"]["type"], "LineString");
    assert_eq!(
        feature["geometry"]["coordinates"],
        serde_json::json!([[4, 2], [4, 0]])
    );
    assert_eq!(feature["properties"]["end"], "edge");
    assert_eq!(feature["properties"]["start_time"], 0);
}

#[test]
fn tables_have_motorcycles_of_any_velocity() {
    let folder = Scratch::new("tables");
    let path = |name: &str| folder.path(name);
    fs::write(path("race.csv"), RACE).unwrap();
    fs::write(path("walls.wkt"), "LINESTRING (0 0.5, 0 9)").unwrap();
    let args = [
        "motorcycles",
        &path("race.csv"),
        "--walls",
        &path("walls.wkt"),
    ];
    let result = &result(&run(&args, ""))["results"][0];
    let ends: Vec<&str> = (result["motorcycles"].as_array().unwrap().iter())
        .map(|m| m["end"].as_str().unwrap())
        .collect();
    assert_eq!(ends, ["track", "escape", "wall"]);
    assert_eq!(result["motorcycles"][0]["end_id"], 1);
    assert_eq!(result["motorcycles"][1]["stop"], Value::Null);
    let picture = run(&["motorcycles", "-", "--csv", "-f", "svg"], RACE);
    assert!(text(&picture.stdout).starts_with("<svg "));
    // The one that escapes is cut off where the picture ends.
    assert!(
        !text(&picture.stdout).contains("inf"),
        "{}",
        text(&picture.stdout)
    );
}

#[test]
fn pictures_are_files() {
    let folder = Scratch::new("pictures");
    let png = folder.path("tracks.png");
    let output = run(&["motorcycles", "-", "-o", &png, "--size", "200"], NOTCH);
    assert_eq!(output.status.code(), Some(0), "{}", text(&output.stderr));
    assert!(fs::read(&png).unwrap().starts_with(b"\x89PNG"));
}

#[test]
fn errors_name_what_is_wrong() {
    let fails = |args: &[&str], input: &str, code: i32, expected: &str| {
        let output = run(args, input);
        assert_eq!(output.status.code(), Some(code), "{args:?}");
        let message = text(&output.stderr);
        assert!(message.contains(expected), "{args:?}: {message}");
        assert!(output.stdout.is_empty(), "{args:?}");
    };
    let plain = ["motorcycles", "-"];
    fails(
        &plain,
        "LINESTRING (0 0, 1 1)",
        1,
        "not made of polygons alone",
    );
    let weighted = ["motorcycles", "-", "--weight", "2=3"];
    fails(&weighted, NOTCH, 1, "the speed of edge 2");
    fails(
        &["motorcycles", "-", "--walls", "w.wkt"],
        NOTCH,
        2,
        "a table of motorcycles",
    );
    let table = ["motorcycles", "-", "--csv"];
    fails(&table, "x,y,vx\n", 1, "there is no column vy");
    fails(
        &table,
        "x,y,vx,vy\n0,0,0,0\n1,1,1,0\n1,1,1,0\n",
        1,
        "motorcycle 0: its velocity is zero",
    );
    fails(
        &table,
        "x,y,vx,vy\n0,0,1,0\n1,1,1,0\n1,1,1,0\n",
        1,
        "motorcycles 1 and 2",
    );
    fails(
        &["motorcycles", "-", "--csv", "--together"],
        RACE,
        2,
        "no weights, features",
    );
    let missing = ["motorcycles", "-", "--csv", "--walls", "no-such-file.wkt"];
    fails(&missing, RACE, 1, "no-such-file.wkt");
    assert!(!Path::new("no-such-file.wkt").exists());
}
