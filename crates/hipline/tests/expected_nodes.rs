//! Agreement with the nodes that another exact program found on inputs from the field.
//!
//! The folder `shared/data` lies beside the repository where it is there at all.

use hipline::{Figure, FigureBuilder, Options, Region, Skeleton, skeleton::NodeKind};
use serde_json::Value;
use std::{collections::BTreeMap, path::PathBuf};

fn folder() -> Option<PathBuf> {
    let path = PathBuf::from(concat!(env!("CARGO_MANIFEST_DIR"), "/../../../shared/data"));
    path.is_dir().then_some(path)
}

fn point(value: &Value) -> [f64; 2] {
    [value[0].as_f64().expect("x"), value[1].as_f64().expect("y")]
}

fn points(value: &Value) -> Vec<[f64; 2]> {
    value.as_array().expect("points").iter().map(point).collect()
}

fn rings(value: &Value) -> Vec<Vec<[f64; 2]>> {
    value.as_array().expect("rings").iter().map(points).collect()
}

/// The figure of a feature.
fn figure(feature: &Value) -> Option<Figure> {
    let geometry = &feature["geometry"];
    let coordinates = &geometry["coordinates"];
    let mut builder = FigureBuilder::new();
    match geometry["type"].as_str()? {
        "Polygon" => {
            let rings = rings(coordinates);
            match feature["properties"]["edge_weights"].as_array() {
                Some(lists) => {
                    let speeds = lists
                        .iter()
                        .map(|list| {
                            list.as_array().expect("weights").iter().map(|w| w.as_f64().expect("a weight")).collect()
                        })
                        .collect();
                    builder.weighted_polygon(rings, speeds);
                }
                None => {
                    builder.polygon(rings);
                }
            }
        }
        "MultiPolygon" => {
            for polygon in coordinates.as_array()? {
                builder.polygon(rings(polygon));
            }
        }
        "MultiLineString" => {
            for line in rings(coordinates) {
                builder.polyline(line);
            }
        }
        "LineString" => {
            builder.polyline(points(coordinates));
        }
        _ => return None,
    }
    builder.build().ok()
}

/// Every expected node is there, and every node is expected.
fn compare(skeleton: &Skeleton, expected: &[Value]) -> Result<(), String> {
    let near = |a: [f64; 3], b: [f64; 3], tolerance: f64| (0..3).all(|k| (a[k] - b[k]).abs() <= tolerance);
    let extent = skeleton.nodes().iter().filter(|n| matches!(n.kind, NodeKind::Input(_)));
    let size = extent.fold(0.0_f64, |s, n| s.max(n.x.abs()).max(n.y.abs()));
    let tolerance = |p: [f64; 3]| 1e-7 * (size + p[0].abs() + p[1].abs() + p[2].abs());
    let mut mine: Vec<[f64; 3]> = skeleton
        .nodes()
        .iter()
        .filter(|n| matches!(n.kind, NodeKind::Event) && n.time > 0.0)
        .map(|n| [n.x, n.y, n.time])
        .collect();
    let mut theirs: Vec<[f64; 3]> = expected
        .iter()
        .map(|n| [0, 1, 2].map(|k| n[k].as_f64().expect("a number")))
        .collect();
    mine.sort_by(|a, b| a[2].total_cmp(&b[2]));
    theirs.sort_by(|a, b| a[2].total_cmp(&b[2]));
    // Ghost arcs end in nodes of their own here, which the other program does not have.
    let ghost_ends: std::collections::BTreeSet<_> = skeleton
        .arcs()
        .iter()
        .filter(|arc| arc.kind == hipline::skeleton::ArcKind::Ghost)
        .map(|arc| skeleton.node(arc.nodes[1]))
        .map(|n| [n.x.to_bits(), n.y.to_bits(), n.time.to_bits()])
        .collect();
    let missing = theirs.iter().find(|p| !mine.iter().any(|q| near(**p, *q, tolerance(**p))));
    if let Some(p) = missing {
        return Err(format!("{p:?} is missing among {} nodes of {}", mine.len(), theirs.len()));
    }
    let extra = mine.iter().find(|p| {
        !theirs.iter().any(|q| near(**p, *q, tolerance(**p))) && !ghost_ends.contains(&p.map(f64::to_bits))
    });
    match extra {
        Some(p) => Err(format!("{p:?} is not among the {} expected nodes", theirs.len())),
        None => Ok(()),
    }
}

#[test]
fn nodes_are_those_of_another_exact_program() {
    let Some(folder) = folder() else {
        println!("skipped: no shared/data beside the repository");
        return;
    };
    let only = std::env::var("HIPLINE_ONLY").unwrap_or_default();
    let mut failures = Vec::new();
    let mut count = 0;
    for entry in std::fs::read_dir(folder.join("expected")).expect("a folder") {
        let path = entry.expect("an entry").path();
        let stem = path.file_stem().and_then(|s| s.to_str()).expect("a name").to_owned();
        let mut expected = BTreeMap::new();
        for line in std::fs::read_to_string(&path).expect("text").lines() {
            let value: Value = serde_json::from_str(line).expect("JSON");
            expected.insert(value["id"].as_str().expect("an id").to_owned(), value);
        }
        let text = std::fs::read_to_string(folder.join(format!("{stem}.geojson"))).expect("text");
        let collection: Value = serde_json::from_str(&text).expect("JSON");
        for feature in collection["features"].as_array().expect("features") {
            let id = feature["properties"]["id"].as_str().expect("an id");
            if !id.contains(&only) {
                continue;
            }
            let Some(expected) = expected.get(id) else { continue };
            let Some(figure) = figure(feature) else { continue };
            count += 1;
            let options = Options::default().region(Region::Both);
            let result = std::panic::catch_unwind(|| figure.skeleton(options));
            let outcome = match result {
                Err(_) => Err("a panic".to_owned()),
                Ok(skeleton) => compare(&skeleton, expected["nodes"].as_array().expect("nodes")),
            };
            if let Err(message) = outcome {
                failures.push(format!("{id}: {message}"));
            }
        }
    }
    println!("{count} cases compared, {} differ", failures.len());
    for failure in failures.iter().take(60) {
        println!("{failure}");
    }
    assert!(failures.is_empty(), "{} of {count} cases differ", failures.len());
}
