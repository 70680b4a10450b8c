//! Weights and heights on the command line: each result is verified by `hipline check`, told the same.

mod common;

use std::{fs, path::Path};

use common::{Scratch, code, err, json};
use serde_json::Value;

const HOUSE: &str = "POLYGON ((0 0, 12 0, 12 8, 0 8, 0 0))\n";

/// The result of `skeleton`, verified by `check`.
fn skeleton(scratch: &Scratch, input: &str, flags: &[&str]) -> Value {
    let made = scratch.run(&[&["skeleton", input, "-o", "result.json"], flags].concat());
    assert_eq!(code(&made), 0, "{flags:?}: {}", err(&made));
    let checked = scratch.run(&[&["check", input, "--result", "result.json"], flags].concat());
    assert_eq!(code(&checked), 0, "{flags:?}: {}", err(&checked));
    json(&fs::read_to_string(scratch.0.join("result.json")).unwrap())
}

/// The highest node, and how many faces of each phase and creases there are.
fn summary(result: &Value) -> (f64, usize, usize, usize) {
    let list = |name: &str| result[name].as_array().unwrap().clone();
    let times = list("nodes").into_iter().filter_map(|n| n["time"].as_f64());
    let later = list("faces").iter().filter(|f| f["phase"].is_u64()).count();
    let creases = list("arcs")
        .iter()
        .filter(|a| a["kind"] == "crease")
        .count();
    (
        times.fold(0.0, f64::max),
        list("faces").len() - later,
        later,
        creases,
    )
}

#[test]
fn gables_mansards_late_starts_and_heights() {
    let scratch = Scratch::new("houses");
    scratch.file("house.wkt", HOUSE);
    let of = |flags: &[&str]| summary(&skeleton(&scratch, "house.wkt", flags));
    let gables = of(&["--gable", "1", "--gable", "0:3"]);
    assert_eq!(gables, (4.0, 4, 0, 0));
    assert_eq!(of(&["--weight", "1=0", "--weight", "0:0:3=0"]), gables);
    assert_eq!(of(&["--profile", "0:1,2.5:4"]), (2.875, 4, 4, 4));
    assert_eq!(
        of(&["--profile", "0:1,2.5:4", "--gable", "1", "--gable", "3"]),
        (2.875, 4, 2, 2)
    );
    assert_eq!(of(&["--profile", "0=0:1,1:0"]).2, 1, "one edge stops");
    // The others take 4, but one of them starts when its opposite has moved by 2.
    assert_eq!(of(&["--start", "0=2"]), (5.0, 4, 1, 1));
    assert_eq!(of(&["--weight", "*=2"]), (2.0, 4, 0, 0));
    // Between a wall at the height 1 and one at 2.
    let tilted = of(&[
        "--height", "0=1", "--height", "1=2", "--height", "2=2", "--height", "3=1",
    ]);
    assert_eq!((tilted.1, tilted.2), (4, 4), "a wall and a facet each");
    scratch.file(
        "river.wkt",
        "LINESTRING Z (0 2 4, 6 4 3, 12 3 2, 18 6 1, 26 5 0)",
    );
    let river = summary(&skeleton(&scratch, "river.wkt", &["--heights", "z"]));
    assert!(
        river.2 >= 8 && river.3 >= 8,
        "facets and eaves on both sides: {river:?}"
    );
    let level = summary(&skeleton(&scratch, "river.wkt", &[]));
    assert_eq!((level.2, level.3), (0, 0));
}

#[test]
fn check_has_to_be_told_the_same() {
    let scratch = Scratch::new("told");
    scratch.file("house.wkt", HOUSE);
    skeleton(&scratch, "house.wkt", &["--start", "0=2"]);
    let output = scratch.run(&["check", "house.wkt", "--result", "result.json"]);
    assert_eq!(code(&output), 1);
    assert!(err(&output).contains("violation"), "{}", err(&output));
}

#[test]
fn tables_and_several_features() {
    let scratch = Scratch::new("tables");
    scratch.file(
        "two.wkt",
        &format!("{HOUSE}LINESTRING (20 0, 26 0, 26 5)\n"),
    );
    scratch.file(
        "t.csv",
        "feature,ring,edge,side,speed,start\n0,0,1,,0,\n1,0,*,left,2,\n1,0,1,right,,3\n",
    );
    let by_table = skeleton(&scratch, "two.wkt", &["--weights", "t.csv"]);
    assert_eq!(by_table["results"].as_array().unwrap().len(), 2);
    let together = skeleton(&scratch, "two.wkt", &["--weights", "t.csv", "--together"]);
    assert!(together["arcs"].is_array());
    let late = scratch.run(&["offset", "two.wkt", "--weights", "t.csv", "-d", "1"]);
    assert_eq!(code(&late), 0, "{}", err(&late));
    let offset = scratch.run(&[
        "offset", "two.wkt", "--gable", "0:0:1", "-d", "1", "-f", "wkt",
    ]);
    assert_eq!(code(&offset), 0, "{}", err(&offset));
    let text = String::from_utf8(offset.stdout).unwrap();
    assert!(
        text.contains("12.0 7.0 1.0") && !text.contains("11.0 7.0"),
        "{text}"
    );
}

#[test]
fn what_is_not_there_or_cannot_be() {
    let scratch = Scratch::new("errors");
    scratch.file("house.wkt", HOUSE);
    scratch.file("bad.csv", "edge,speed\n1,fast\n");
    scratch.file("far.csv", "edge,speed\n\n1,2\n9,2\n");
    let skeleton = |flags: &[&str]| scratch.run(&[&["skeleton", "house.wkt"], flags].concat());
    for (flags, exit, says) in [
        (
            &["--weight", "7=2"][..],
            1,
            "house.wkt: --weight 7=2: feature 0: there is no edge 7 in ring or line 0, which has 4",
        ),
        (
            &["--gable", "1:0"],
            1,
            "--gable 1:0: feature 0: there is no ring or line 1, only 1 of them",
        ),
        (
            &["--start", "yard:0:0=2"],
            1,
            "--start yard:0:0=2: there is no feature `yard`",
        ),
        (
            &["--profile", "9=0:1"],
            1,
            "--profile 9=0:1: feature 0: there is no edge 9",
        ),
        (
            &["--height", "4=1"],
            1,
            "--height 4=1: feature 0: there is no vertex 4",
        ),
        (
            &["--weights", "far.csv"],
            1,
            "far.csv, line 4: feature 0: there is no edge 9",
        ),
        (
            &["--weights", "bad.csv"],
            1,
            "bad.csv: weights table: line 2: speed: `fast` is not a number",
        ),
        (&["--weights", "none.csv"], 1, "none.csv: "),
        (
            &["--heights", "z"],
            1,
            "--heights z: feature 0: ring or line 0: vertex 0 has no third coordinate",
        ),
        (
            &["--weight", "1=2", "--gable", "1"],
            1,
            "--gable 1: --weight 1=2 says otherwise",
        ),
        (
            &["--height", "0=20"],
            1,
            "part 0, ring 0, edge 0 goes from height 20 to 0: that is not less steep than its facets",
        ),
        (&["--weight", "1=-2"], 2, "it must not be below 0"),
        (&["--weight", "1"], 2, "it is EDGE=SPEED"),
        (&["--profile", "1:1"], 2, "a profile starts at the time 0"),
        (&["--heights", "x"], 2, "possible values: z"),
    ] {
        let output = skeleton(flags);
        assert_eq!(code(&output), exit, "{flags:?}: {}", err(&output));
        assert!(err(&output).contains(says), "{flags:?}: {}", err(&output));
        assert!(output.stdout.is_empty(), "{flags:?}");
    }
    let both = scratch.run(&["skeleton", "-", "--weights", "-"]);
    assert_eq!(code(&both), 2);
    assert!(err(&both).contains("cannot be both"), "{}", err(&both));
}

/// A low edge whose facet passes below the eave of a high one.
#[test]
fn walls_have_to_be_allowed() {
    let scratch = Scratch::new("walls");
    scratch.file(
        "lines.wkt",
        "LINESTRING Z (0 0 0, 10 0 0)\nLINESTRING Z (0 1 5, 10 1 5)\n",
    );
    let flags = ["--together", "--heights", "z"];
    let output = scratch.run(&[&["skeleton", "lines.wkt"][..], &flags].concat());
    assert_eq!(code(&output), 1);
    assert!(
        err(&output).contains("part 1, ring 0, edge 0"),
        "{}",
        err(&output)
    );
    assert!(err(&output).contains("--allow-walls"), "{}", err(&output));
    assert_eq!(err(&output).lines().count(), 1);
    assert!(output.stdout.is_empty());
    skeleton(
        &scratch,
        "lines.wkt",
        &["--together", "--heights", "z", "--allow-walls"],
    );
}

#[test]
fn upright_faces_and_creases_in_every_format() {
    let scratch = Scratch::new("upright");
    scratch.file("house.wkt", HOUSE);
    let flags = ["--gable", "1", "--profile", "0:1,1:2"];
    let make = |format: &str| {
        let args = ["skeleton", "house.wkt", "-f", format, "--size", "200"];
        let output = scratch.run(&[&args[..], &flags].concat());
        assert_eq!(code(&output), 0, "{format}: {}", err(&output));
        output.stdout
    };
    let svg = String::from_utf8(make("svg")).unwrap();
    let creases = svg.split("id=\"crease\"").nth(1).unwrap();
    let creases = creases.split("</g>").next().unwrap();
    assert_eq!(creases.matches('M').count(), 3, "{creases}");
    assert!(make("png").starts_with(b"\x89PNG"));
    let map = json(std::str::from_utf8(&make("geojson")).unwrap());
    let kinds: Vec<_> = map["features"]
        .as_array()
        .unwrap()
        .iter()
        .filter(|f| f["properties"]["element"] == "face")
        .map(|f| {
            (
                f["properties"]["edge"].as_u64().unwrap(),
                f["geometry"]["type"].as_str().unwrap(),
            )
        })
        .collect();
    let (line, polygon) = ("LineString", "Polygon");
    let expected = [
        (0, polygon),
        (0, polygon),
        (1, line),
        (2, polygon),
        (2, polygon),
        (3, polygon),
        (3, polygon),
    ];
    assert_eq!(kinds, expected);
    // Nothing ever reaches the corner between edges that stand still.
    let args = [
        "skeleton",
        "house.wkt",
        "--side",
        "exterior",
        "--gable",
        "0",
        "--gable",
        "1",
        "-f",
    ];
    for format in ["geojson", "wkt", "svg", "obj", "png"] {
        let output = scratch.run(&[&args[..], &[format]].concat());
        assert_eq!(code(&output), 0, "{format}: {}", err(&output));
        let text = String::from_utf8_lossy(&output.stdout).into_owned();
        assert!(
            format == "png" || !(text.contains("e308") || text.contains("NaN")),
            "{text}"
        );
    }
}

/// Every command of docs/weights.md runs; those that are said to agree do.
#[test]
fn the_page_runs() {
    let page = include_str!("../../../docs/weights.md");
    let blocks = |language: &str| -> Vec<&str> {
        let fence = format!("```{language}\n");
        let parts = page.split(fence.as_str()).skip(1);
        parts
            .map(|part| part.split("```").next().unwrap())
            .collect()
    };
    let scratch = Scratch::new("page");
    scratch.file("house.geojson", blocks("json")[0]);
    scratch.file("plan.wkt", blocks("text")[0]);
    scratch.file("speeds.csv", blocks("csv")[0]);
    scratch.file("river.wkt", blocks("wkt")[0]);
    let mut all = 0;
    for (i, block) in blocks("sh").into_iter().enumerate() {
        let mut results = Vec::new();
        for line in block.lines() {
            let args: Vec<&str> = line.strip_prefix("hipline ").unwrap().split(' ').collect();
            let output = scratch.run(&args);
            assert_eq!(code(&output), 0, "{line}: {}", err(&output));
            let result = json(std::str::from_utf8(&output.stdout).unwrap());
            if args[0] == "skeleton" {
                skeleton(&scratch, args[1], &args[2..]);
            }
            results.push((
                result["nodes"].clone(),
                result["arcs"].clone(),
                result["faces"].clone(),
            ));
            all += 1;
        }
        if i == 0 {
            assert!(results.iter().all(|r| *r == results[0]), "they agree");
            assert!(results[0].0.as_array().unwrap().len() > 4);
        }
    }
    assert_eq!(all, 7);
    assert!(
        !Path::new("result.json").exists(),
        "nothing is written beside the sources"
    );
}
