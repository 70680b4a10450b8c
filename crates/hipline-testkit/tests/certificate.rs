//! The certificate holds for what the engines make of random polygons and of real ones.

mod common;

use common::{count, field};
use hipline::{Options, Region, skeleton::Uncertified};
use hipline_testkit::generate::{Kind, small_of};

#[test]
fn small_polygons_are_certified() {
    let options = Options::default().region(Region::Interior);
    let mut certified = 0;
    let mut wrong = Vec::new();
    for seed in 0..count(20_000, 800) {
        let case = small_of(Kind::POLYGONS[(seed % 8) as usize], seed);
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

#[test]
fn polygons_from_the_field_are_certified() {
    let mut wrong = Vec::new();
    for case in field(count(2000, 100) as usize, 3) {
        let figure = case.figure().expect("it was one before");
        let skeleton = figure.skeleton(Options::default().region(Region::Interior));
        if let Err(other) = skeleton.certify(&figure) {
            wrong.push(format!("{other}\n{}", case.to_text()));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n\n"));
}
