//! The engine that takes the lower envelope of slabs, against the kinetic one and the reference: arc for arc, bit for bit.

mod common;

use std::panic::catch_unwind;

use common::{count, field};
use hipline::{Engine, Figure, NotApplicable, Options, Region};
use hipline_testkit::agreement::{compare, drawn};
use hipline_testkit::generate::{Family, Kind, small, small_of, tight, wheel};
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

/// Large enough for many cuts of both stages.
#[test]
fn agrees_on_larger_polygons() {
    let families = [
        Family::Random,
        Family::Star,
        Family::Coast,
        Family::Holes,
        Family::SquareHoles,
        Family::Spiral,
        Family::Monotone,
        Family::Orthogonal,
        Family::Regular,
        Family::Convex,
        Family::Comb,
        Family::Snowflake,
    ];
    for seed in 0..count(240, 12) {
        let family = families[(seed % 12) as usize];
        let case = family.generate(40 + seed as usize / 2, seed);
        let figure = case.figure().expect("a family of figures");
        if let Some(how) = failure(&figure) {
            panic!("{} of seed {seed}: {how}", family.name());
        }
    }
    for seed in 0..count(20, 2) {
        let seed = seed as usize;
        let case = tight(5 + 3 * seed, 3 + seed, seed as u64);
        let figure = case.figure().expect("a polygon");
        if let Some(how) = failure(&figure) {
            panic!("{how}: {}", case.to_text());
        }
    }
    for seed in 0..count(40, 4) {
        let case = wheel(30 + 6 * seed as usize, seed);
        let figure = case.figure().expect("a polygon");
        if let Some(how) = failure(&figure) {
            panic!("{how}: {}", case.to_text());
        }
    }
}

/// Valleys at all angles: no cell with several of them and a long list is left, and few steps are made.
#[test]
fn chords_divide_valleys_at_all_angles() {
    for n in [99, 300] {
        let figure = wheel(n, 1).figure().expect("a polygon");
        let cells = figure.subdivision().expect("a polygon").last;
        let entered = cells.iter().filter(|cell| cell.valleys > 0).count();
        assert!(entered > n / 12, "{entered}");
        let whole = cells.iter().filter(|c| c.valleys > 1 && c.slabs > 8);
        assert_eq!(whole.count(), 0);
        assert!(steps(&figure) < 80.0 * n as f64, "{}", steps(&figure));
    }
}

#[test]
fn threads_do_not_matter() {
    let n = count(600, 200) as usize;
    for family in [Family::Random, Family::Holes] {
        let figure = family.generate(n, 3).figure().expect("a figure");
        let [one, three] = [1, 3].map(|threads| {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads);
            let pool = pool.build().expect("threads");
            let skeleton = pool.install(|| figure.skeleton_by(Engine::Envelope, inside()));
            let skeleton = skeleton.expect("it applies");
            (drawn(&skeleton), skeleton.stats().steps)
        });
        assert!(one == three, "{}", family.name());
    }
}

/// Cells fill the inside but for what empty cells take.
#[test]
fn cells_lie_apart() {
    let figure = Family::Coast.generate(60, 1).figure().expect("a figure");
    let subdivision = figure.subdivision().expect("a polygon");
    let area = |edges: &[([[f64; 2]; 2], hipline::subdivision::Border)]| {
        let twice = edges.iter().map(|&([p, q], _)| p[0] * q[1] - p[1] * q[0]);
        twice.sum::<f64>() / 2.0
    };
    let whole = figure.edges().iter().map(|edge| {
        let [p, q] = [edge.from, edge.to].map(|v| figure.vertices()[v.index()]);
        p[0] * q[1] - p[1] * q[0]
    });
    let whole = whole.sum::<f64>() / 2.0;
    let sum = |cells: &[hipline::subdivision::SubdivisionCell]| -> f64 {
        let areas: Vec<f64> = cells.iter().map(|cell| area(&cell.edges)).collect();
        assert!(areas.iter().all(|&area| area > -1e-9 * whole), "{areas:?}");
        areas.iter().sum()
    };
    let [first, last] = [&subdivision.first, &subdivision.last].map(|cells| sum(cells));
    assert!(
        0.2 * whole < last && last < first && first < 1.000_001 * whole,
        "{last} {first} {whole}"
    );
    assert!(
        subdivision
            .last
            .iter()
            .all(|cell| cell.valleys <= 1 || cell.slabs <= 8)
    );
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

fn steps(figure: &Figure) -> f64 {
    let skeleton = figure.skeleton_by(Engine::Envelope, inside());
    skeleton.expect("it applies").stats().steps as f64
}

/// Of four times as many edges: about five times as many steps, where n log n log r has 7 and all pairs have 16.
#[test]
fn steps_grow_little_faster_than_the_input() {
    for family in [Family::Random, Family::Star, Family::Coast, Family::Holes] {
        let of = |n: usize| {
            let figure = family.generate(n, 1).figure().expect("a figure");
            (figure.edges().len() as f64, steps(&figure))
        };
        let [(few, less), (many, more)] = [100, 400].map(of);
        assert!(
            less > 0.0 && more / less < 2.0 * many / few,
            "{}: {less} {more}",
            family.name()
        );
    }
}

/// Where all faces meet around one place, and where each cut crosses all faces of a wall.
#[test]
fn steps_grow_as_the_thesis_tells() {
    let regular = [64, 256].map(|n| {
        let figure = Family::Regular.generate(n, 1).figure().expect("a figure");
        steps(&figure)
    });
    assert!(regular[1] < 6.0 * regular[0], "{regular:?}");
    // n log n log r.
    let tight = [16, 64].map(|n| {
        let figure = tight(n, n / 2, 1).figure().expect("a figure");
        let (n, r) = (figure.edges().len() as f64, (n / 2) as f64);
        steps(&figure) / (n * n.log2() * r.log2())
    });
    assert!(tight[1] < 1.3 * tight[0], "{tight:?}");
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
