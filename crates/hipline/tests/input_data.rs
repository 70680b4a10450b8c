//! The cases of the `shared/data` folder beside the repository, read in place.

mod field_support;

use std::collections::BTreeMap;

use field_support::builder;
use hipline::{Figure, FigureBuilder, InvalidFigure};
use hipline_testkit::data;
use serde_json::Value;

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
    let builder = builder(feature).unwrap_or_else(|| {
        let text = feature["properties"]["raw_wkt"].as_str();
        let mut builder = FigureBuilder::new();
        builder.polygon(rings_of_text(text.expect("a geometry or its text")));
        builder
    });
    builder.build()
}

#[test]
fn the_shared_cases_are_judged_as_they_expect() {
    let Some(folder) = data::folder() else {
        return;
    };
    let files = data::files(&folder, "geojson");
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
