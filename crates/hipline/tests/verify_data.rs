//! Every skeleton of the inputs from the field passes its own verification.
//!
//! The folder `shared/data` lies beside the repository where it is there at all.

mod field_support;

use field_support::builder;
use hipline::{Options, Region};
use hipline_testkit::data;
use serde_json::Value;
use std::{
    panic::{AssertUnwindSafe, catch_unwind},
    time::{Duration, Instant},
};

/// A number from the environment.
fn setting(name: &str, default: usize) -> usize {
    std::env::var(name)
        .ok()
        .map_or(default, |text| text.parse().expect("a number"))
}

#[test]
fn skeletons_of_the_shared_cases_obey_the_laws() {
    let Some(folder) = data::folder() else {
        return;
    };
    let only = std::env::var("HIPLINE_ONLY").unwrap_or_default();
    let (least, most) = (setting("HIPLINE_LEAST", 0), setting("HIPLINE_MOST", 3000));
    let files = data::files(&folder, "geojson");
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
            let Some(figure) = builder(feature).and_then(|b| b.build().ok()) else {
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
