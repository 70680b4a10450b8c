//! The engine that takes the lower envelope of slabs, against the kinetic one: arc for arc, bit for bit.

use std::panic::catch_unwind;

use hipline::{Engine, Options, Region};
use hipline_testkit::agreement::drawn;
use hipline_testkit::generate::{Kind, small_of};

/// Kinds of cases that consist of polygons alone, now and then.
const KINDS: [Kind; 8] = [
    Kind::Simple,
    Kind::Star,
    Kind::Shape,
    Kind::Polyomino,
    Kind::Holes,
    Kind::Touching,
    Kind::Symmetric,
    Kind::Islands,
];

fn count(release: u64, debug: u64) -> u64 {
    let given = std::env::var("HIPLINE_CASES").ok();
    given
        .and_then(|count| count.parse().ok())
        .unwrap_or(if cfg!(debug_assertions) {
            debug
        } else {
            release
        })
}

#[test]
fn agrees_with_the_kinetic_engine() {
    let options = Options::default().region(Region::Interior);
    let mut wrong = Vec::new();
    let mut agreed = 0;
    for seed in 0..count(20_000, 500) {
        let case = small_of(KINDS[(seed % 8) as usize], seed);
        let Ok(figure) = case.figure() else { continue };
        let how = match catch_unwind(|| figure.skeleton_by(Engine::Envelope, options)) {
            Err(_) => "it panics".to_owned(),
            Ok(Err(_)) => continue,
            Ok(Ok(skeleton)) if drawn(&skeleton) == drawn(&figure.skeleton(options)) => {
                agreed += 1;
                continue;
            }
            Ok(Ok(skeleton)) => format!("they differ; {:?}", skeleton.verify(&figure)),
        };
        wrong.push(format!("{}{how}", case.to_text()));
        if wrong.len() > 3 {
            break;
        }
    }
    assert!(wrong.is_empty(), "{agreed} agree, but\n{}", wrong.join("\n\n"));
    assert!(agreed > count(20_000, 500) / 2, "only {agreed}");
}
