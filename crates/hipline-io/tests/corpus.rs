//! The shared collection of real inputs, read in place: every feature is there, and every
//! number is the f64 nearest to its decimals.

use std::{fs, path::PathBuf};

use hipline_io::{Document, Format, Shape, read};

/// The collection beside the repository, or the one that `HIPLINE_DATA` names.
fn directory() -> Option<PathBuf> {
    let beside = || PathBuf::from(concat!(env!("CARGO_MANIFEST_DIR"), "/../../../shared/data"));
    let directory = std::env::var_os("HIPLINE_DATA").map_or_else(beside, PathBuf::from);
    if !directory.join("index.json").is_file() {
        println!("skipped: there is no {}", directory.display());
        return None;
    }
    Some(directory)
}

/// The places of a shape in the order of the file.
fn places(shape: &Shape, list: &mut Vec<[f64; 2]>) {
    match shape {
        Shape::Polygons(polygons) => list.extend(polygons.iter().flat_map(|p| &p.rings).flatten()),
        Shape::Lines(lines) => list.extend(lines.iter().flat_map(|l| &l.points)),
        Shape::Collection(shapes) => shapes.iter().for_each(|s| places(s, list)),
        Shape::Graph(graph) => list.extend(&graph.vertices),
        Shape::Empty | Shape::Points(_) => {}
    }
}

/// All positions after the word `"coordinates":` in a text, found without a JSON parser and
/// converted by `str::parse`.
fn scanned(text: &str) -> Vec<[f64; 2]> {
    let mut list = Vec::new();
    for part in text.split("\"coordinates\":").skip(1) {
        let mut depth = 0_usize;
        let mut numbers = Vec::new();
        let mut start = None;
        for (i, c) in part.char_indices() {
            let is_part = matches!(c, '0'..='9' | '+' | '-' | '.' | 'e' | 'E');
            match (is_part, start) {
                (true, None) => start = Some(i),
                (false, Some(s)) => {
                    numbers.push(part[s..i].parse::<f64>().unwrap());
                    start = None;
                }
                _ => {}
            }
            match c {
                '[' => depth += 1,
                ']' => {
                    depth -= 1;
                    if let [x, y, ..] = numbers[..] {
                        list.push([x, y]);
                    }
                    numbers.clear();
                }
                _ => {}
            }
            if depth == 0 && !c.is_ascii_whitespace() {
                break;
            }
        }
    }
    list
}

fn assert_exact(text: &str, document: &Document, file: &str) {
    let mut read = Vec::new();
    document
        .features
        .iter()
        .for_each(|f| places(&f.case, &mut read));
    let expected = scanned(text);
    assert_eq!(read.len(), expected.len(), "{file}");
    for (r, e) in read.iter().zip(&expected) {
        assert_eq!(
            r.map(f64::to_bits),
            e.map(f64::to_bits),
            "{file}: {r:?} is not {e:?}"
        );
    }
}

#[test]
fn every_feature_is_read_exactly() {
    let Some(directory) = directory() else { return };
    let index: serde_json::Value =
        serde_json::from_slice(&fs::read(directory.join("index.json")).unwrap()).unwrap();
    let mut total = 0;
    let mut weighted = 0;
    for entry in index["files"].as_array().unwrap() {
        let file = entry["file"].as_str().unwrap();
        let text = fs::read_to_string(directory.join(file)).unwrap();
        let document = read(text.as_bytes(), Format::from_path(file).unwrap())
            .unwrap_or_else(|e| panic!("{file}: {e}"));
        assert_eq!(
            Some(document.features.len() as u64),
            entry["count"].as_u64(),
            "{file}"
        );
        total += document.features.len();
        assert_exact(&text, &document, file);
        for feature in &document.features {
            assert_eq!(
                feature.id.as_deref(),
                feature.properties["id"].as_str(),
                "{file}"
            );
            if let (Shape::Polygons(polygons), Some(weights)) = (
                &feature.case,
                feature
                    .properties
                    .get("edge_weights")
                    .and_then(|w| w.as_array()),
            ) {
                let speeds: Vec<_> = polygons
                    .iter()
                    .flat_map(|p| p.speeds.clone().unwrap())
                    .collect();
                let expected: Vec<Vec<f64>> = weights
                    .iter()
                    .map(|w| {
                        w.as_array()
                            .unwrap()
                            .iter()
                            .map(|w| w.as_f64().unwrap())
                            .collect()
                    })
                    .collect();
                assert_eq!(speeds, expected);
                weighted += 1;
            }
        }
    }
    println!("{total} features, {weighted} of them with weights");
    assert!(weighted > 0);
}

#[test]
fn what_geojson_cannot_carry_gives_a_clear_error_or_nothing() {
    let Some(directory) = directory() else { return };
    for file in ["sfcgal.geojson", "synthetic.geojson"] {
        let document = read(&fs::read(directory.join(file)).unwrap(), Format::GeoJson).unwrap();
        for feature in document.features.iter().filter(|f| f.case == Shape::Empty) {
            assert!(feature.figure().unwrap_err().is_empty_geometry());
            let raw = feature.properties["raw_wkt"].as_str().unwrap();
            match read(raw.as_bytes(), Format::Wkt) {
                Ok(document) => assert!(document.features[0].case.is_empty(), "{raw}"),
                Err(e) => assert!(
                    e.to_string().ends_with("is not a finite number"),
                    "{raw}: {e}"
                ),
            }
        }
    }
}
