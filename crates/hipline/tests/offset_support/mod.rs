//! Figures for the tests of offsets and roofs.
#![allow(dead_code, reason = "each test uses a part")]

use hipline::{Figure, FigureBuilder};
use hipline_testkit::data;
pub use hipline_testkit::measure::area;
use serde_json::Value;
use std::path::PathBuf;

pub fn polygon(rings: &[&[[f64; 2]]]) -> Figure {
    let mut builder = FigureBuilder::new();
    builder.polygon(rings.iter().map(|ring| ring.to_vec()).collect());
    builder.build().expect("a valid polygon")
}

pub fn lines(lines: &[&[[f64; 2]]]) -> Figure {
    let mut builder = FigureBuilder::new();
    for line in lines {
        builder.polyline(line.to_vec());
    }
    builder.build().expect("valid lines")
}

pub const SQUARE: &[[f64; 2]] = &[[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0]];
pub const RECTANGLE: &[[f64; 2]] = &[[0.0, 0.0], [8.0, 0.0], [8.0, 4.0], [0.0, 4.0]];
pub const ELL: &[[f64; 2]] = &[
    [0.0, 0.0],
    [6.0, 0.0],
    [6.0, 6.0],
    [4.0, 6.0],
    [4.0, 4.0],
    [0.0, 4.0],
];
pub const PLUS: &[[f64; 2]] = &[
    [2.0, 0.0],
    [4.0, 0.0],
    [4.0, 2.0],
    [6.0, 2.0],
    [6.0, 4.0],
    [4.0, 4.0],
    [4.0, 6.0],
    [2.0, 6.0],
    [2.0, 4.0],
    [0.0, 4.0],
    [0.0, 2.0],
    [2.0, 2.0],
];
pub const OUTER: &[[f64; 2]] = &[[0.0, 0.0], [9.0, 0.0], [9.0, 9.0], [0.0, 9.0]];
pub const HOLE: &[[f64; 2]] = &[[3.0, 3.0], [3.0, 6.0], [6.0, 6.0], [6.0, 3.0]];
pub const FUNNEL: &[[f64; 2]] = &[[0.0, 0.0], [7.0, 1.0], [9.0, 5.0], [4.5, 2.75], [1.0, 6.0]];

fn points(value: &Value) -> Vec<[f64; 2]> {
    let number = |v: &Value| v.as_f64().expect("a number");
    value
        .as_array()
        .expect("points")
        .iter()
        .map(|p| [number(&p[0]), number(&p[1])])
        .collect()
}

/// The names of all files of the data, in order; none where they are not there.
pub fn stems() -> Vec<String> {
    let files = data::folder().map_or_else(Vec::new, |folder| data::files(&folder, "geojson"));
    let stem = |file: &PathBuf| Some(file.file_stem()?.to_str()?.to_owned());
    files.iter().filter_map(stem).collect()
}

/// The valid polygons with at most so many vertices, by name, of some files; nothing where
/// the data are not there. They lie beside the repository, or where `HIPLINE_DATA` says.
pub fn polygons(stems: &[&str], limit: usize) -> Vec<(String, Figure, f64)> {
    let Some(folder) = data::folder() else {
        return Vec::new();
    };
    let mut list = Vec::new();
    for stem in stems {
        let text = std::fs::read_to_string(folder.join(format!("{stem}.geojson"))).expect("text");
        let collection: Value = serde_json::from_str(&text).expect("JSON");
        for feature in collection["features"].as_array().expect("features") {
            let geometry = &feature["geometry"];
            let Some(coordinates) = geometry["coordinates"].as_array() else {
                continue;
            };
            let parts: Vec<&Vec<Value>> = match geometry["type"].as_str() {
                Some("Polygon") => vec![coordinates],
                Some("MultiPolygon") => coordinates
                    .iter()
                    .map(|p| p.as_array().expect("rings"))
                    .collect(),
                _ => continue,
            };
            // Not even looked at, if there are too many.
            let ring_size = |ring: &Value| ring.as_array().map_or(0, Vec::len).saturating_sub(1);
            if parts
                .iter()
                .copied()
                .flatten()
                .map(ring_size)
                .sum::<usize>()
                > limit
            {
                continue;
            }
            let mut builder = FigureBuilder::new();
            let mut size = 0.0;
            for part in parts {
                let rings: Vec<Vec<[f64; 2]>> = part.iter().map(points).collect();
                size += area(&rings[0]).abs();
                size -= rings[1..].iter().map(|ring| area(ring).abs()).sum::<f64>();
                builder.polygon(rings);
            }
            let Ok(figure) = builder.build() else {
                continue;
            };
            if figure.vertices().len() <= limit {
                let id = feature["properties"]["id"].as_str().unwrap_or("?");
                list.push((id.to_owned(), figure, size));
            }
        }
    }
    list
}
