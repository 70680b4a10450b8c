//! The certificate holds for what the engines make of random polygons and of real ones.

mod common;

use hipline::{Options, Region, skeleton::Uncertified};
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
fn small_polygons_are_certified() {
    let options = Options::default().region(Region::Interior);
    let mut certified = 0;
    let mut wrong = Vec::new();
    for seed in 0..count(20_000, 800) {
        let case = small_of(KINDS[(seed % 8) as usize], seed);
        let Ok(figure) = case.figure() else { continue };
        match figure.skeleton(options).certify(&figure) {
            Ok(()) => certified += 1,
            Err(Uncertified::NotApplicable(_)) => {}
            Err(other) => wrong.push(format!("{}{other}", case.to_text())),
        }
        if wrong.len() > 5 {
            break;
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n\n"));
    assert!(certified > count(20_000, 800) / 2, "only {certified}");
}
