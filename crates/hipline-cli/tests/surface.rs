//! `hipline terrain`, `rain` and `query` as a user meets them.

mod common;

use std::fs;

use common::{Scratch, err, json, out, run};
use serde_json::Value;

const RIVERS: &str = "MULTILINESTRING ((0 0, 10 2, 20 0), (10 2, 12 9), (3 7, 6 7, 5 10))";

#[test]
fn queries_answer_in_tables_and_json() {
    let square = "POLYGON ((0 0, 8 0, 8 4, 0 4))";
    let table = run(
        &[
            "query",
            "-",
            "--at",
            "3,1.5",
            "--at",
            "7,2",
            "--elevation",
            "10",
        ],
        square,
    );
    assert_eq!(
        out(&table),
        "x,y,height,face,edge,side,feature,part,ring,source_edge\n\
         3,1.5,11.5,0,0,left,0,0,0,0\n\
         7,2,11,1,1,left,0,0,0,1\n"
    );
    assert_eq!(table.status.code(), Some(0));
    let beside = run(&["query", "-", "--at", "9,1", "--format", "json"], square);
    assert_eq!(beside.status.code(), Some(1));
    assert!(
        err(&beside).contains("(9, 1) is outside"),
        "{}",
        err(&beside)
    );
    let answers = json(out(&beside));
    assert_eq!(answers[0]["height"], Value::Null);
    let grid = run(
        &["query", "-", "--grid", "1", "--window", "0,0,8,4"],
        square,
    );
    assert_eq!(out(&grid).lines().count(), 33);
}

#[test]
fn drops_run_to_the_river() {
    let output = run(&["rain", "-", "--at", "5,-2"], RIVERS);
    let drops = json(out(&output));
    let properties = &drops["features"][0]["properties"];
    assert_eq!(properties["ends"], "edge", "{}", out(&output));
    assert_eq!(properties["source_edge"], 0);
    assert_eq!(properties["part"], 0);
}

#[test]
fn areas_of_river_systems_fill_the_window() {
    let args = [
        "rain",
        "-",
        "--catchments",
        "system",
        "--window",
        "0,0,20,10",
        "--format",
        "tsv",
    ];
    let output = run(&args, RIVERS);
    let areas: Vec<f64> = out(&output)
        .lines()
        .skip(1)
        .map(|line| line.split('\t').nth(1).unwrap().parse().unwrap())
        .collect();
    assert_eq!(areas.len(), 2, "{}", out(&output));
    assert!(
        (areas.iter().sum::<f64>() - 200.0).abs() < 1e-9,
        "{areas:?}"
    );
}

#[test]
fn terrains_come_in_all_formats() {
    let scratch = Scratch::new("terrains");
    let formats = ["obj", "asc", "tif", "geojson", "svg", "png"];
    let files: Vec<String> = formats
        .iter()
        .map(|f| scratch.path(&format!("t.{f}")))
        .collect();
    let mut args = vec![
        "terrain",
        "-",
        "--cell",
        "0.5",
        "--contours",
        "1",
        "--size",
        "200",
    ];
    for file in &files {
        args.extend(["-o", file]);
    }
    let output = run(&args, RIVERS);
    assert_eq!(output.status.code(), Some(0), "{}", err(&output));
    let starts: [&[u8]; 6] = [
        b"o terrain\nv ",
        b"ncols 44\nnrows 24\n",
        b"II*\0",
        b"{\"type\":\"Feat",
        b"<svg ",
        b"\x89PNG",
    ];
    for (file, start) in files.iter().zip(starts) {
        let bytes = fs::read(file).unwrap();
        assert!(bytes.starts_with(start), "{file}: {:?}", &bytes[..20]);
    }
}

#[test]
fn errors_tell_what_and_where() {
    let crossing = "MULTILINESTRING ((0 0, 4 4), (0 4, 4 0))";
    let output = run(&["terrain", "-"], crossing);
    assert_eq!(output.status.code(), Some(1));
    assert!(err(&output).contains("cross"), "{}", err(&output));
    let output = run(&["terrain", "-", "--window", "50,50,60,60"], RIVERS);
    assert_eq!(output.status.code(), Some(1));
    assert!(err(&output).contains("misses the data"), "{}", err(&output));
    for wrong in [
        &["terrain", "-", "--window", "1,0,0,1"][..],
        &["terrain", "-", "--cell", "0"],
        &["terrain", "-", "--format", "wkt"],
        &["rain", "-"],
        &["rain", "-", "--at", "1"],
        &["query", "-", "--at", "1,2", "--grid", "1"],
    ] {
        let output = run(wrong, RIVERS);
        assert_eq!(output.status.code(), Some(2), "{wrong:?}: {}", err(&output));
        assert!(out(&output).is_empty(), "{wrong:?}");
    }
    assert_eq!(run(&["terrain", "-"], "POINT (1 2)").status.code(), Some(1));
}
