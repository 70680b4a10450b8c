//! The engine for monotone polygons against the kinetic one and the reference, arc for arc and bit for bit.
//!
//! In release builds 20,000 seeds, in debug builds 500; `HIPLINE_CASES` sets another count, `HIPLINE_FIRST` the
//! first seed.

use std::collections::BTreeMap;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::thread;

use hipline::{Engine, Figure, FigureBuilder, NotApplicable, Options, Skeleton};
use hipline_testkit::Case;
use hipline_testkit::agreement::{compare, drawn};
use hipline_testkit::case::Part;
use hipline_testkit::generate::{monotone_large, monotone_small, monotone_weighted};
use hipline_testkit::reduce::reduce;
use hipline_testkit::reference::{Graph, reference};

fn number(variable: &str, default: u64) -> u64 {
    let value = std::env::var(variable).ok();
    value.and_then(|text| text.parse().ok()).unwrap_or(default)
}

/// The arcs that only one of two skeletons has, in words.
fn difference(one: &Skeleton, other: &Skeleton) -> Option<String> {
    let [mut one, mut other] = [drawn(one), drawn(other)];
    if one == other {
        return None;
    }
    let (a, b) = (one.clone(), other.clone());
    one.retain(|arc| b.binary_search(arc).is_err());
    other.retain(|arc| a.binary_search(arc).is_err());
    let lines = |name: &str, arcs: &[_]| -> String {
        let text = |arc: &hipline_testkit::agreement::Drawn| format!("\n{name} {arc}");
        arcs.iter().take(12).map(text).collect()
    };
    Some(lines("missing", &one) + &lines("extra  ", &other))
}

/// How the engine fails on a figure; the engine's own reason if it does not apply.
fn failure(figure: &Figure, small: bool) -> Result<Option<String>, NotApplicable> {
    let options = Options::default();
    let by = |engine| {
        let run = AssertUnwindSafe(|| figure.skeleton_by(engine, options));
        catch_unwind(run).map_err(|cause| {
            let text = cause.downcast_ref::<String>().cloned();
            let text = text.or_else(|| cause.downcast_ref::<&str>().map(|s| (*s).to_owned()));
            format!("panics: {}", text.unwrap_or_default())
        })
    };
    let skeleton = match by(Engine::Monotone) {
        Err(panic) => return Ok(Some(panic)),
        Ok(result) => result?,
    };
    let expected = by(Engine::Kinetic)
        .expect("the kinetic engine")
        .expect("applies to everything");
    if let Some(how) = difference(&expected, &skeleton) {
        return Ok(Some(how));
    }
    if skeleton.nodes().len() != expected.nodes().len() {
        return Ok(Some("another number of nodes".to_owned()));
    }
    if let Err(violations) = skeleton.verify(figure) {
        return Ok(Some(format!("verification fails: {violations}")));
    }
    if small {
        let expected = reference(&Graph::from(figure), skeleton.region());
        if let Err(difference) = compare(figure, &skeleton, &expected) {
            return Ok(Some(format!("the reference differs: {difference}")));
        }
    }
    Ok(None)
}

/// What a run found.
#[derive(Default)]
struct Tally {
    agree: u64,
    refused: BTreeMap<String, u64>,
    failed: Vec<String>,
}

/// Tries some seeds.
fn tally(generate: fn(u64) -> Case, seeds: impl Iterator<Item = u64>) -> Tally {
    let mut tally = Tally::default();
    for seed in seeds {
        let case = generate(seed);
        let figure = case.figure().expect("a simple ring");
        let fails = |case: &Case| {
            let figure = case.figure().ok()?;
            failure(&figure, case.size() <= 8).ok()?
        };
        match failure(&figure, case.size() <= 8) {
            Ok(None) => tally.agree += 1,
            Ok(Some(_)) if tally.failed.len() < 3 => {
                let least = reduce(&case, |case| fails(case).is_some());
                let how = fails(&least).unwrap_or_default();
                tally.failed.push(format!("{}{how}", least.to_text()));
            }
            Ok(Some(_)) => tally.failed.push(format!("seed {seed}")),
            Err(reason) => {
                let reason: String = reason.to_string();
                let bare = reason.chars().filter(|c| !c.is_ascii_digit()).collect();
                *tally.refused.entry(bare).or_default() += 1;
            }
        }
    }
    tally
}

/// Tries all seeds, on all cores, and returns how many were refused.
fn agrees(generate: fn(u64) -> Case, release: u64) -> u64 {
    let default = if cfg!(debug_assertions) { 500 } else { release };
    let (first, count) = (number("HIPLINE_FIRST", 0), number("HIPLINE_CASES", default));
    let threads = thread::available_parallelism().map_or(1, |n| n.get() as u64);
    let found: Vec<Tally> = thread::scope(|scope| {
        let seeds = |k: u64| (first + k..first + count).step_by(threads as usize);
        let running: Vec<_> = (0..threads)
            .map(|k| scope.spawn(move || tally(generate, seeds(k))))
            .collect();
        running
            .into_iter()
            .map(|thread| thread.join().expect("failures are caught"))
            .collect()
    });
    let agree: u64 = found.iter().map(|tally| tally.agree).sum();
    println!("seeds {first} to {}: {agree} agree", first + count);
    for tally in &found {
        println!("refused: {:?}", tally.refused);
    }
    let failed: Vec<&str> = found
        .iter()
        .flat_map(|tally| tally.failed.iter().map(String::as_str))
        .collect();
    let some: Vec<&str> = failed.iter().copied().take(6).collect();
    assert!(
        failed.is_empty(),
        "{} fail\n{}",
        failed.len(),
        some.join("\n\n")
    );
    count - agree
}

#[test]
fn small_polygons_agree() {
    assert_eq!(
        agrees(monotone_small, 20_000),
        0,
        "the engine applies to all"
    );
}

#[test]
fn weighted_polygons_agree_or_are_refused() {
    let cases = number(
        "HIPLINE_CASES",
        if cfg!(debug_assertions) { 500 } else { 20_000 },
    );
    let refused = agrees(monotone_weighted, 20_000);
    // About a fifth; of a few cases it may be all.
    assert!(refused < 25 + cases / 4, "{refused} of {cases} are refused");
}

/// What it is about, the ring, and the speeds of its edges, or nothing if they are all one.
type Named = (&'static str, &'static [[i32; 2]], &'static [f64]);

/// What went wrong once.
const NAMED: [Named; 9] = [
    (
        "a face of one plane in both chains, and a ridge of one height that cuts it short",
        &[
            [4, 3],
            [6, 3],
            [2, 11],
            [3, 6],
            [0, 6],
            [0, 3],
            [3, 3],
            [0, 0],
        ],
        &[],
    ),
    (
        "edges along the levels, several at one moment",
        &[
            [2, 3],
            [3, 4],
            [3, 1],
            [2, 1],
            [0, 0],
            [1, 1],
            [0, 1],
            [0, 3],
        ],
        &[],
    ),
    (
        "a ridge of one height leads over the merge chain at the moment of a node",
        &[[3, 5], [3, 4], [5, 5], [3, 3], [3, 0], [0, 3], [0, 6]],
        &[],
    ),
    (
        "a joint wavefront edge whose ends meet at a node",
        &[
            [1, 2],
            [0, 2],
            [3, 5],
            [4, 4],
            [3, 3],
            [4, 3],
            [1, 0],
            [2, 2],
            [1, 1],
        ],
        &[],
    ),
    (
        "what overruns its neighbour had just been cut off",
        &[[4, 0], [0, 8], [10, 5], [10, 3], [9, 5], [7, 4], [8, 2]],
        &[3.0, 1.0, 1.0, 1.0, 1.0, 1.0, 3.0],
    ),
    (
        "the same, with a vertex event",
        &[[2, 3], [3, 2], [1, 1], [0, 0], [0, 3], [1, 2]],
        &[3.0, 1.0, 0.5, 1.0, 1.0, 0.5],
    ),
    (
        "what is born where its edge had just been cut off",
        &[
            [1, 3],
            [0, 2],
            [4, 10],
            [6, 9],
            [9, 9],
            [9, 1],
            [10, 3],
            [9, 0],
            [5, 6],
        ],
        &[3.0, 1.0, 1.0, 1.0, 3.0, 1.0, 2.0, 3.0, 1.0],
    ),
    (
        "three planes with a line in common, along the merge chain",
        &[[0, 5], [10, 0], [12, 1], [8, 4], [6, 8]],
        &[1.0, 3.0, 1.0, 1.0, 1.0],
    ),
    (
        "an edge that was cut off comes back",
        &[[0, 0], [3, 3], [2, 4], [2, 3], [0, 4]],
        &[1.0, 3.0, 1.0, 1.0, 3.0],
    ),
];

#[test]
fn named_polygons_agree_or_are_refused() {
    for (name, ring, speeds) in NAMED {
        let points = ring.iter().map(|p| p.map(f64::from)).collect();
        let mut builder = FigureBuilder::new();
        if speeds.is_empty() {
            builder.polygon(vec![points]);
        } else {
            builder.weighted_polygon(vec![points], vec![speeds.to_vec()]);
        }
        let figure = builder.build().expect("a simple ring");
        let found = failure(&figure, true);
        if speeds.is_empty() {
            assert_eq!(found, Ok(None), "{name}");
        } else {
            let refused = matches!(found, Err(NotApplicable::RunsAhead { .. }));
            assert!(refused, "{name}: {found:?}");
        }
    }
}

#[test]
fn large_polygons_agree() {
    let size = if cfg!(debug_assertions) {
        1_000
    } else {
        100_000
    };
    for seed in 0..4 {
        let case = Case::of(vec![Part::polygon(vec![monotone_large(seed, size)])]);
        let figure = case.figure().expect("simple");
        let found = failure(&figure, false).expect("applies");
        assert_eq!(found, None, "seed {seed}");
    }
}
