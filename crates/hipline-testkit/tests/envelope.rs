//! The engine that takes the lower envelope of slabs, against the kinetic one and the reference: arc for arc, bit for bit.

mod common;

use std::panic::catch_unwind;

use common::{count, field};
use hipline::{Engine, Figure, NotApplicable, Options, Region};
use hipline_testkit::agreement::{compare, drawn};
use hipline_testkit::generate::{Family, Kind, small, small_of};
use hipline_testkit::reference::{Graph, reference};

fn inside() -> Options {
    Options::default().region(Region::Interior)
}

/// How the engine fails on a figure, if it does; `None` also if it refuses it.
fn failure(figure: &Figure) -> Option<String> {
    let skeleton = match catch_unwind(|| figure.skeleton_by(Engine::Envelope, inside())) {
        Ok(result) => result.ok()?,
        Err(_) => return Some("it panics".to_owned()),
    };
    let kinetic = figure.skeleton_by(Engine::Kinetic, inside());
    let kinetic = kinetic.expect("it applies to everything");
    (drawn(&skeleton) != drawn(&kinetic)).then(|| "they differ".to_owned())
}

fn applies(figure: &Figure) -> bool {
    figure.motorcycles().is_ok()
}

#[test]
fn agrees_with_the_kinetic_engine() {
    let cases = count(20_000, 400);
    let mut wrong = Vec::new();
    let mut tried = 0;
    for seed in 0..cases {
        let case = small_of(Kind::POLYGONS[(seed % 8) as usize], seed);
        let Ok(figure) = case.figure() else { continue };
        tried += u64::from(applies(&figure));
        if let Some(how) = failure(&figure) {
            wrong.push(format!("{}{how}", case.to_text()));
        }
        if wrong.len() > 3 {
            break;
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n\n"));
    assert!(tried > cases / 2, "only {tried}");
}

#[test]
fn agrees_with_the_reference() {
    let cases = count(1600, 80);
    let mut tried = 0;
    for seed in 1_000_000..1_000_000 + cases {
        let case = small_of(Kind::POLYGONS[(seed % 8) as usize], seed);
        let Ok(figure) = case.figure() else { continue };
        let Ok(skeleton) = figure.skeleton_by(Engine::Envelope, inside()) else {
            continue;
        };
        tried += 1;
        let expected = reference(&Graph::from(&figure), Region::Interior);
        if let Err(difference) = compare(&figure, &skeleton, &expected) {
            panic!("{}{difference}", case.to_text());
        }
    }
    assert!(tried > cases / 2, "only {tried}");
}

#[test]
fn agrees_on_families() {
    for family in Family::all() {
        let case = family.generate(count(160, 40) as usize, 1);
        let figure = case.figure().expect("a family of figures");
        if let Some(how) = failure(&figure) {
            panic!("{}: {how}", family.name());
        }
    }
}

#[test]
fn agrees_on_polygons_from_the_field() {
    for case in field(count(120, 30) as usize, 2) {
        let figure = case.figure().expect("it was one before");
        if let Some(how) = failure(&figure) {
            panic!("{}{how}", case.to_text());
        }
    }
}

/// Of four times as many edges: 5.4 times as many steps, where n log n has 5.3 and all pairs have 16.
#[test]
fn steps_grow_little_faster_than_the_input() {
    let steps = |n: usize| {
        let figure = Family::Random.generate(n, 1).figure().expect("a figure");
        let skeleton = figure.skeleton_by(Engine::Envelope, inside());
        let skeleton = skeleton.expect("it applies");
        (figure.edges().len() as f64, skeleton.stats().steps as f64)
    };
    let [(few, less), (many, more)] = [64, 256].map(steps);
    assert!(
        less > 0.0 && more / less < 2.0 * many / few,
        "{less} {more}"
    );
}

#[test]
fn what_it_does_not_apply_to_is_refused() {
    let mut refused = [0; 3];
    for seed in 0..400 {
        let Ok(figure) = small(seed).figure() else {
            continue;
        };
        let options = Options::default();
        match figure.skeleton_by(Engine::Envelope, options) {
            Ok(skeleton) => {
                assert_eq!(skeleton.region(), Region::Interior);
                assert!(
                    figure
                        .edges()
                        .iter()
                        .all(|e| e.on_ring && e.speeds.map(f64::to_bits) == [1.0_f64.to_bits(); 2])
                );
            }
            Err(NotApplicable::NotInterior) => refused[0] += 1,
            Err(NotApplicable::NotPolygons) => refused[1] += 1,
            Err(NotApplicable::Speed { .. }) => refused[2] += 1,
            Err(other) => panic!("seed {seed}: {other}"),
        }
        let outside = options.region(Region::Both);
        assert_eq!(
            figure.skeleton_by(Engine::Envelope, outside).err(),
            Some(NotApplicable::NotInterior)
        );
    }
    assert!(refused.iter().all(|&n| n > 0), "{refused:?}");
}
