//! What several tests share: runs of the library, and cases from the field.

#![allow(dead_code, reason = "no test uses everything")]

use std::fs;
use std::path::{Path, PathBuf};

use hipline::{Options, Region, Skeleton};
use hipline_testkit::Case;
use hipline_testkit::case::{Part, Points};
use hipline_testkit::data;
use serde_json::Value;

/// Fewer in debug builds, where everything takes some twenty times as long.
pub const fn count(release: u64, debug: u64) -> u64 {
    if cfg!(debug_assertions) {
        debug
    } else {
        release
    }
}

/// The skeleton of a case in the whole plane.
pub fn run(case: &Case) -> Skeleton {
    let figure = case
        .figure()
        .unwrap_or_else(|flaws| panic!("{}{flaws}", case.to_text()));
    figure.skeleton(Options::default().region(Region::Both))
}

/// The folder of the repository.
pub fn repository() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

/// Polygons from the field with so many vertices at most, a few of each collection; none where
/// the data is absent (it does not belong to the repository).
pub fn field(most: usize, each: usize) -> Vec<Case> {
    let Some(folder) = data::folder() else {
        return Vec::new();
    };
    let mut files = data::files(&folder, "geojson");
    files.retain(|file| fs::metadata(file).is_ok_and(|data| data.len() < 4_000_000));
    let mut cases = Vec::new();
    for file in files {
        let text = fs::read_to_string(&file).expect("text");
        let collection: Value = serde_json::from_str(&text).expect("JSON");
        let features = collection["features"].as_array().expect("features").iter();
        let found = features
            .filter_map(polygon)
            .filter(|case| (10..=most).contains(&case.size()) && case.figure().is_ok());
        cases.extend(found.take(each));
    }
    cases
}

fn polygon(feature: &Value) -> Option<Case> {
    let geometry = &feature["geometry"];
    if geometry["type"] != "Polygon" {
        return None;
    }
    let point = |value: &Value| Some([value[0].as_f64()?, value[1].as_f64()?]);
    let ring = |value: &Value| -> Option<Points> {
        let mut points: Points = value.as_array()?.iter().map(point).collect::<Option<_>>()?;
        points.pop();
        Some(points)
    };
    let rings = geometry["coordinates"].as_array()?.iter().map(ring);
    let mut case = Case::of(vec![Part::polygon(rings.collect::<Option<_>>()?)]);
    case.comments
        .push(format!("{}", feature["properties"]["id"]));
    Some(case)
}
