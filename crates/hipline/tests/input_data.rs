//! The cases of the `shared/data` folder beside the repository, read in place.

use std::{
    collections::BTreeMap,
    path::{Path, PathBuf},
};

use hipline::{Figure, FigureBuilder, InvalidFigure};
use serde_json::Value;

fn folder() -> Option<PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../../shared/data");
    let folder = std::env::var_os("HIPLINE_DATA").map_or(folder, PathBuf::from);
    folder.is_dir().then_some(folder)
}

fn list<T>(value: &Value, convert: impl FnMut(&Value) -> T) -> Vec<T> {
    value
        .as_array()
        .expect("an array")
        .iter()
        .map(convert)
        .collect()
}

fn point(value: &Value) -> [f64; 2] {
    [0, 1].map(|axis| value[axis].as_f64().expect("a number"))
}

fn rings(value: &Value) -> Vec<Vec<[f64; 2]>> {
    list(value, |ring| list(ring, point))
}

/// The points of a well-known text, in brackets of any depth: all that the four cases that
/// GeoJSON cannot carry need.
fn rings_of_text(text: &str) -> Vec<Vec<[f64; 2]>> {
    let Some(start) = text.find('(') else {
        return Vec::new();
    };
    let ring = |ring: &str| -> Vec<[f64; 2]> {
        let number = |number: &str| number.parse().expect("a number");
        let pair = |pair: &str| -> [f64; 2] {
            let mut numbers = pair.split_whitespace().map(number);
            [numbers.next().expect("x"), numbers.next().expect("y")]
        };
        ring.split(',')
            .filter(|pair| !pair.trim().is_empty())
            .map(pair)
            .collect()
    };
    text[start..]
        .split('(')
        .map(|ring| ring.trim_matches([')', ' ', ',']))
        .filter(|ring| !ring.is_empty())
        .map(ring)
        .collect()
}

fn build(feature: &Value) -> Result<Figure, InvalidFigure> {
    let mut builder = FigureBuilder::new();
    let properties = &feature["properties"];
    let geometry = &feature["geometry"];
    let coordinates = &geometry["coordinates"];
    match geometry["type"].as_str() {
        None => {
            builder.polygon(rings_of_text(
                properties["raw_wkt"]
                    .as_str()
                    .expect("either a geometry or its text"),
            ));
        }
        Some("Polygon") => {
            let weights = &properties["edge_weights"];
            if weights.is_array() {
                let speeds = list(weights, |ring| {
                    list(ring, |weight| weight.as_f64().expect("a number"))
                });
                builder.weighted_polygon(rings(coordinates), speeds);
            } else {
                builder.polygon(rings(coordinates));
            }
        }
        Some("MultiPolygon") => list(coordinates, rings).into_iter().for_each(|rings| {
            builder.polygon(rings);
        }),
        Some("MultiLineString") => rings(coordinates).into_iter().for_each(|line| {
            builder.polyline(line);
        }),
        Some(other) => panic!("geometry of type {other}"),
    }
    builder.build()
}

#[test]
fn the_shared_cases_are_judged_as_they_expect() {
    let Some(folder) = folder() else {
        println!("skipped: there is no shared/data folder beside the repository");
        return;
    };
    let mut files: Vec<PathBuf> = std::fs::read_dir(folder)
        .expect("the folder can be read")
        .map(|entry| entry.expect("the folder can be read").path())
        .filter(|path| {
            path.extension()
                .is_some_and(|extension| extension == "geojson")
        })
        .collect();
    files.sort();
    let mut table: BTreeMap<String, [usize; 2]> = BTreeMap::new();
    let mut wrong = Vec::new();
    for file in files {
        let text = std::fs::read_to_string(&file).expect("the file can be read");
        let collection: Value = serde_json::from_str(&text).expect("the file is JSON");
        for feature in collection["features"].as_array().expect("features") {
            let properties = &feature["properties"];
            let expect = properties["expect"].as_str().expect("an expectation");
            let id = &properties["id"];
            let result = build(feature);
            let refused = result.is_err();
            table.entry(expect.to_owned()).or_default()[usize::from(refused)] += 1;
            let fits = match expect {
                "ok" => !refused,
                "clear-error" => refused,
                _ => {
                    let outcome = match &result {
                        Ok(_) => "accepted".to_owned(),
                        Err(invalid) => {
                            format!("{} flaws, {}", invalid.flaws.len(), invalid.flaws[0])
                        }
                    };
                    println!("{expect:32} {id:50} {outcome}");
                    true
                }
            };
            if !fits {
                wrong.push(format!(
                    "{id} expects {expect}: {}",
                    result.map_or_else(|e| e.to_string(), |_| "accepted".to_owned())
                ));
            }
        }
    }
    println!("{:32} {:>8} {:>8}", "expect", "accepted", "refused");
    for (expect, [accepted, refused]) in table {
        println!("{expect:32} {accepted:8} {refused:8}");
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}
