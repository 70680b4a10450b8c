//! Skeletons of chains and the choice of engines on the command line.

mod common;

use std::{
    fs,
    io::{Read, Write},
    process::Stdio,
};

use common::{Scratch, json, run, text};
use serde_json::Value;

/// A valley between two hills; monotone in x.
const CHAIN: &str = "LINESTRING (0 0, 4 0, 6 3, 9 1, 13 2)";

/// A trough: its ends rise for ever, and meet face to face.
const TROUGH: &str = "LINESTRING (0 5, 0 0, 4 0, 4 5)";

/// The output of a run that succeeds.
fn printed(args: &[&str], input: &str) -> Vec<u8> {
    let output = run(args, input);
    assert_eq!(output.status.code(), Some(0), "{}", text(&output.stderr));
    assert!(output.stderr.is_empty(), "{}", text(&output.stderr));
    output.stdout
}

/// What a run says that fails.
fn fails(args: &[&str], input: &str, code: i32) -> String {
    let output = run(args, input);
    assert_eq!(output.status.code(), Some(code), "{args:?}");
    assert!(output.stdout.is_empty(), "{args:?}");
    text(&output.stderr).to_owned()
}

fn made(args: &[&str], input: &str) -> Value {
    json(text(&printed(args, input)))
}

#[test]
fn each_side_of_a_chain_has_a_face_per_edge() {
    let sides = [("left", [3, 0]), ("right", [4, 1])];
    for (side, [arcs, events]) in sides {
        let result = made(&["skeleton", "-", "--chain", side], CHAIN);
        let faces = result["faces"].as_array().unwrap();
        assert_eq!(faces.len(), 4);
        assert!(faces.iter().all(|face| face["side"] == side));
        assert_eq!(result["arcs"].as_array().unwrap().len(), arcs, "{side}");
        let nodes = result["nodes"].as_array().unwrap();
        let count = |kind: &str| nodes.iter().filter(|node| node["kind"] == kind).count();
        // A valley fewer for each event: what is left goes to infinity.
        assert_eq!([count("event"), count("infinite")], [events, 3 - events]);
        // The first and the last face have one node at infinity, the others two in a row.
        let infinite = |face: &Value| {
            let on_it = face["nodes"].as_array().unwrap().iter();
            let kinds = on_it.map(|n| &nodes[n.as_u64().unwrap() as usize]["kind"]);
            kinds.filter(|kind| *kind == "infinite").count()
        };
        assert_eq!([infinite(&faces[0]), infinite(&faces[3])], [1, 1], "{side}");
    }
}

#[test]
fn the_bisector_of_two_rays_is_exact() {
    let corner = made(
        &["skeleton", "-", "--chain", "left"],
        "LINESTRING (0 0, 4 0, 4 3)",
    );
    let far = &corner["nodes"][3];
    assert_eq!(far["direction"], serde_json::json!([-1, 1]));
    assert_eq!([&far["x"], &far["y"]], [4, 0]);
    assert!(far["time"].is_null());
    assert_eq!(corner["arcs"][0]["kind"], "ridge");
}

#[test]
fn all_formats_are_written() {
    let scratch = Scratch::new("formats");
    let starts: [(&str, &[u8]); 8] = [
        ("json", b"{\"format\":\"hipline-skeleton\""),
        ("geojson", b"{\"type\":\"FeatureCollection\""),
        ("wkt", b"LINESTRING Z ("),
        ("svg", b"<svg"),
        ("png", b"\x89PNG"),
        ("obj", b"o feature_0\n"),
        ("stl", b""),
        ("glb", b""),
    ];
    for (format, start) in starts {
        let name = scratch.path(&format!("result.{format}"));
        let output = run(&["skeleton", "-", "--chain", "right", "-o", &name], CHAIN);
        let said = text(&output.stderr);
        match output.status.code() {
            Some(0) => {
                let bytes = fs::read(&name).unwrap();
                assert!(bytes.starts_with(start), "{format}: {said}");
            }
            code => {
                // A skeleton is no mesh: that is said, and nothing is written.
                assert!(start.is_empty(), "{format}: {code:?} {said}");
                assert!(said.starts_with("error: "), "{format}: {said}");
                assert!(fs::metadata(&name).is_err(), "{format}");
            }
        }
    }
    // Written and given back, and the same without a file.
    let written = fs::read(scratch.path("result.json")).unwrap();
    assert_eq!(
        printed(&["skeleton", "-", "--chain", "right"], CHAIN),
        written
    );
}

#[test]
fn rays_reach_the_border_of_the_picture() {
    let svg = printed(
        &["skeleton", "-", "--chain", "left", "--format", "svg"],
        CHAIN,
    );
    let faces = text(&svg).lines().filter(|line| line.contains("evenodd"));
    let faces: Vec<&str> = faces.collect();
    assert_eq!(faces.len(), 4);
    // The corners of the picture, at the top left and the top right.
    assert!(faces[0].contains("L0 0L"), "{}", faces[0]);
    assert!(faces[3].contains("L1000 0L"), "{}", faces[3]);
    // The ray in the west is level, and comes back where its edge starts.
    let edge = faces[0].split(" d=\"M").nth(1).unwrap();
    let height = edge.split(['L', ' ']).nth(1).unwrap();
    assert!(edge.ends_with(&format!("L0 {height}Z\"/>")), "{edge}");
}

#[test]
fn each_feature_is_a_chain_of_its_own() {
    let lines = format!("{CHAIN}\n{TROUGH}\nPOLYGON ((0 0, 4 0, 0 4, 0 0))\n");
    let output = run(&["skeleton", "-", "--chain", "left"], &lines);
    assert_eq!(output.status.code(), Some(1));
    let result: Value = serde_json::from_slice(&output.stdout).unwrap();
    let results = result["results"].as_array().unwrap();
    assert_eq!(results.len(), 3);
    assert_eq!(results[0]["skeleton"]["faces"].as_array().unwrap().len(), 4);
    let reasons = [
        "feature 1: the ray of edge 0 vanishes at once, as far as it goes",
        "feature 2: the figure is not one line",
    ];
    for (result, reason) in results[1..].iter().zip(reasons) {
        assert_eq!(result["error"], reason);
        assert!(text(&output.stderr).contains(reason));
    }
}

#[test]
fn what_is_no_chain_is_refused() {
    let chain = ["skeleton", "-", "--chain", "left"];
    for (input, reason) in [
        (
            "LINESTRING (0 0, 4 0, 4 4, 0 4, 0 2)",
            "edge 3 turns the chain back: it is monotone in no direction",
        ),
        ("POINT (0 0)", ""),
    ] {
        let said = fails(&chain, input, 1);
        assert!(
            said.starts_with("error: ") && said.contains(reason),
            "{said}"
        );
    }
    let still = [&chain[..], &["--weight", "1=0"]].concat();
    let said = fails(&still, CHAIN, 1);
    assert!(
        said.contains("edge 1 does not move with one positive speed"),
        "{said}"
    );
    let said = fails(&["skeleton", "-", "--chain", "up"], CHAIN, 2);
    assert!(said.contains("left, right"), "{said}");
    let both = ["skeleton", "-", "--chain", "left", "--side", "both"];
    assert!(fails(&both, CHAIN, 2).contains("--side"));
    let offset = ["offset", "-", "--chain", "left", "-d", "1"];
    assert!(fails(&offset, CHAIN, 2).contains("--chain"));
    let by = |engine| [&chain[..], &["--engine", engine]].concat();
    for engine in ["kinetic", "envelope", "orthogonal"] {
        let said = fails(&by(engine), CHAIN, 2);
        assert!(
            said.contains("--chain is for the monotone engine"),
            "{said}"
        );
    }
    for engine in ["auto", "monotone"] {
        assert_eq!(
            printed(&by(engine), CHAIN),
            printed(&chain, CHAIN),
            "{engine}"
        );
    }
}

#[test]
fn a_reader_that_goes_away_is_no_error() {
    let steps: Vec<String> = (0..20_000)
        .map(|i| format!("{i} {}", i % 7 * (i % 3)))
        .collect();
    let line = format!("LINESTRING ({})", steps.join(", "));
    let mut child = std::process::Command::new(assert_cmd::cargo::cargo_bin("hipline"))
        .args(["skeleton", "-", "--chain", "left"])
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    let mut input = child.stdin.take().unwrap();
    input.write_all(line.as_bytes()).unwrap();
    drop(input);
    let mut output = child.stdout.take().unwrap();
    let mut start = [0; 16];
    output.read_exact(&mut start).unwrap();
    assert_eq!(&start, b"{\"format\":\"hipli");
    drop(output);
    let mut said = String::new();
    child
        .stderr
        .take()
        .unwrap()
        .read_to_string(&mut said)
        .unwrap();
    child.wait().unwrap();
    assert!(!said.contains("panic"), "{said}");
}

#[test]
fn engines_give_the_same_or_say_why_not() {
    let stairs = "POLYGON ((0 0, 9 0, 9 2, 6 2, 6 5, 2 5, 2 3, 0 3, 0 0))";
    let count = |engine: &str| {
        let result = made(&["skeleton", "-", "--engine", engine], stairs);
        let size = |list: &str| result[list].as_array().unwrap().len();
        [size("nodes"), size("arcs"), size("faces")]
    };
    for engine in ["kinetic", "monotone", "orthogonal", "envelope"] {
        assert_eq!(count(engine), count("auto"), "{engine}");
    }
    let comb = "POLYGON ((0 0, 9 0, 9 9, 7 1, 5 9, 4 1, 0 9, 0 0))";
    let monotone = ["skeleton", "-", "--engine", "monotone"];
    for (flags, input, reason) in [
        (
            &[][..],
            "POLYGON ((0 0, 9 0, 9 9, 8 9, 8 1, 1 1, 1 9, 5 9, 5 10, 0 10, 0 0))",
            "not monotone in any direction",
        ),
        (
            &["--weight", "1=0"],
            comb,
            "the speed of edge 1 does not allow for it",
        ),
        (&["--side", "both"], comb, "only the inside of a polygon"),
    ] {
        let said = fails(&[&monotone[..], flags].concat(), input, 1);
        assert!(said.contains(reason), "{said}");
    }
    // With weights, the chains do not always tell what happens in the polygon.
    let ring = "POLYGON ((0 0, 3 3, 2 4, 2 3, 0 4, 0 0))";
    let fast = ["--weight", "1=3", "--weight", "4=3"];
    let said = fails(&[&monotone[..], &fast].concat(), ring, 1);
    assert!(
        said.contains("what the other chain has cut off comes back"),
        "{said}"
    );
    let slow = ["--weight", "1=1.25"];
    let weighted = |engine: &str| {
        let flags = ["skeleton", "-", "--engine", engine];
        made(&[&flags[..], &slow].concat(), ring)["arcs"]
            .as_array()
            .unwrap()
            .len()
    };
    assert_eq!(weighted("monotone"), weighted("kinetic"));
}
