//! Every skeleton of the inputs from the field passes its own verification.
//!
//! The folder `shared/data` lies beside the repository where it is there at all.

use hipline::{Figure, FigureBuilder, Options, Region};
use serde_json::Value;
use std::{
    panic::{AssertUnwindSafe, catch_unwind},
    path::{Path, PathBuf},
    time::{Duration, Instant},
};

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

/// The figure of a feature, if it is a valid one.
fn figure(feature: &Value) -> Option<Figure> {
    let geometry = &feature["geometry"];
    let coordinates = &geometry["coordinates"];
    let mut builder = FigureBuilder::new();
    match geometry["type"].as_str()? {
        "Polygon" => {
            let weights = &feature["properties"]["edge_weights"];
            if weights.is_array() {
                let speeds = list(weights, |ring| {
                    list(ring, |w| w.as_f64().expect("a number"))
                });
                builder.weighted_polygon(rings(coordinates), speeds);
            } else {
                builder.polygon(rings(coordinates));
            }
        }
        "MultiPolygon" => list(coordinates, rings).into_iter().for_each(|rings| {
            builder.polygon(rings);
        }),
        "MultiLineString" => rings(coordinates).into_iter().for_each(|line| {
            builder.polyline(line);
        }),
        "LineString" => {
            builder.polyline(list(coordinates, point));
        }
        _ => return None,
    }
    builder.build().ok()
}

/// A number from the environment.
fn setting(name: &str, default: usize) -> usize {
    std::env::var(name)
        .ok()
        .map_or(default, |text| text.parse().expect("a number"))
}

#[test]
fn skeletons_of_the_shared_cases_obey_the_laws() {
    let Some(folder) = folder() else {
        println!("skipped: no shared/data beside the repository");
        return;
    };
    let only = std::env::var("HIPLINE_ONLY").unwrap_or_default();
    let (least, most) = (setting("HIPLINE_LEAST", 0), setting("HIPLINE_MOST", 3000));
    let mut files: Vec<PathBuf> = std::fs::read_dir(folder)
        .expect("the folder can be read")
        .map(|entry| entry.expect("the folder can be read").path())
        .filter(|path| {
            path.extension()
                .is_some_and(|extension| extension == "geojson")
        })
        .collect();
    files.sort();
    let (mut count, mut failures) = (0, Vec::new());
    let (mut building, mut checking) = (Duration::ZERO, Duration::ZERO);
    for file in files {
        let text = std::fs::read_to_string(&file).expect("the file can be read");
        let collection: Value = serde_json::from_str(&text).expect("the file is JSON");
        for feature in collection["features"].as_array().expect("features") {
            let id = feature["properties"]["id"].as_str().expect("an id");
            let size = feature["properties"]["n_vertices"]
                .as_u64()
                .expect("a size") as usize;
            if !id.contains(&only) || !(least..=most).contains(&size) {
                continue;
            }
            let Some(figure) = figure(feature) else {
                continue;
            };
            for region in [Region::Interior, Region::Exterior, Region::Both] {
                if region != Region::Both && !figure.has_polygon() {
                    continue;
                }
                count += 1;
                let start = Instant::now();
                let options = Options::default().region(region);
                let skeleton = catch_unwind(AssertUnwindSafe(|| figure.skeleton(options)));
                building += start.elapsed();
                let Ok(skeleton) = skeleton else {
                    failures.push(format!("{id} {region:?}: the engine panics"));
                    continue;
                };
                let start = Instant::now();
                let outcome = catch_unwind(AssertUnwindSafe(|| skeleton.verify(&figure)));
                checking += start.elapsed();
                match outcome {
                    Ok(Ok(())) => {}
                    Ok(Err(found)) => {
                        let some: Vec<String> =
                            found.list.iter().take(4).map(ToString::to_string).collect();
                        failures.push(format!(
                            "{id} {region:?}: {} violations: {}",
                            found.total,
                            some.join("; ")
                        ));
                    }
                    Err(_) => failures.push(format!("{id} {region:?}: the verification panics")),
                }
            }
        }
    }
    println!(
        "{count} skeletons, {} break laws; built in {building:?}, checked in {checking:?}",
        failures.len()
    );
    for failure in &failures {
        println!("{failure}");
    }
    assert!(
        failures.is_empty(),
        "{} of {count} skeletons break laws",
        failures.len()
    );
}
