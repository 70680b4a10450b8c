//! The library against the reference engine, arc for arc and bit for bit, on random small cases; and its own
//! verification.
//!
//! In release builds 20,000 seeds, 10,000 with speeds of zero and speeds that change, and 2,000 with coordinates of many digits; in debug
//! builds, which are some twenty times slower, 500, 300 and 100.
//! `HIPLINE_CASES` sets another count, and a longer run goes by
//! `cargo run --release -p hipline-testkit --example hunt -- FIRST COUNT`.

use std::thread;

use hipline::{Engine, Options};
use hipline_testkit::Case;
use hipline_testkit::case::Part;
use hipline_testkit::generate::{Family, small, small_fine, small_weighted};
use hipline_testkit::hunt::hunt;

/// Runs the seeds of a kind of cases.
fn agrees(generate: fn(u64) -> Case, release: u64, debug: u64) {
    let count = std::env::var("HIPLINE_CASES")
        .ok()
        .and_then(|count| count.parse().ok())
        .unwrap_or(if cfg!(debug_assertions) {
            debug
        } else {
            release
        });
    let threads = thread::available_parallelism().map_or(1, |n| n.get() as u64);
    println!("seeds 0 to {count} on {threads} threads");
    let found: Vec<_> = thread::scope(|scope| {
        let running: Vec<_> = (0..threads)
            .map(|k| scope.spawn(move || hunt(generate, (k..count).step_by(threads as usize), 3)))
            .collect();
        let joined = running.into_iter().map(|thread| thread.join());
        joined
            .flat_map(|found| found.expect("hunts catch panics"))
            .collect()
    });
    // The first comment of each case tells its seed; the text is ready for the corpus.
    let report: Vec<String> = found
        .iter()
        .map(|(case, how)| format!("{}{how}", case.to_text()))
        .collect();
    assert!(report.is_empty(), "{}", report.join("\n\n"));
}

#[test]
fn agrees_with_the_reference() {
    agrees(small, 20_000, 500);
}

#[test]
fn agrees_with_the_reference_on_fine_coordinates() {
    agrees(small_fine, 2_000, 100);
}

#[test]
fn agrees_with_the_reference_on_changing_speeds() {
    agrees(small_weighted, 10_000, 300);
}

/// A vertex may collect a spoke for each vertex of a run along one line, and then have an event for each
/// vertex of an arc. It is relieved of them, so the work per vertex stays the same.
#[test]
fn no_vertex_keeps_many_spokes() {
    let work = |n: usize, speeds: &dyn Fn(usize) -> f64| {
        let mut case = Family::Apse.generate(n, 1);
        let Part::Polygon { rings, speeds: all } = &mut case.parts[0] else {
            unreachable!("an apse is a polygon");
        };
        let of_ring = |ring: &Vec<[f64; 2]>| (0..ring.len()).map(speeds).collect();
        *all = rings.iter().map(of_ring).collect();
        let figure = case.figure().expect("a figure");
        let skeleton = figure.skeleton_by(Engine::Kinetic, Options::default());
        let stats = skeleton.as_ref().expect("it takes all").stats();
        (stats.steps + stats.flips) as f64 / n as f64
    };
    let all: [(&str, &dyn Fn(usize) -> f64); 4] = [
        ("equal", &|_| 1.0),
        ("rising", &|i| 1.0 + i as f64 / 1024.0),
        ("falling", &|i| 9.0 - i as f64 / 1024.0),
        ("alternating", &|i| 1.0 + (i % 2) as f64),
    ];
    for (name, speeds) in all {
        let [small, large] = [500, 4000].map(|n| work(n, speeds));
        println!("{name}: {small:.1}, {large:.1} steps a vertex");
        assert!(large < 2.0 * small, "{name}: {small} {large}");
    }
}
