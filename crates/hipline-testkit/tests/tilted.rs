//! Heights of vertices: the library against the reference engine, arc for arc and bit for bit.
//!
//! Small cases on integer grids, of every kind of figure, with heights: tilted eaves, level edges that
//! start late, with speeds and changes of them. All arcs must be equal and `verify` must pass, whether heights are reached or
//! not; `check_heights` must say which.
//!
//! In release builds 4000 seeds, in debug builds 100. `HIPLINE_CASES` sets another count, `HIPLINE_FIRST` the
//! first seed; `cargo run --release -p hipline-testkit --example hunt -- tilted FIRST COUNT` reduces what it finds.

use std::sync::atomic::{AtomicUsize, Ordering};

use hipline_testkit::Case;
use hipline_testkit::generate::small_tilted;
use hipline_testkit::hunt::{check_all, failure};
use hipline_testkit::reference::{Graph, reference};

fn number(name: &str, default: u64) -> u64 {
    let given = std::env::var(name).ok().and_then(|text| text.parse().ok());
    given.unwrap_or(default)
}

/// Cases, those that are figures, those with heights that are reached, and of these, those with tilted eaves.
static SEEN: [AtomicUsize; 4] = [const { AtomicUsize::new(0) }; 4];

/// Counts a case that is right.
fn count(case: &Case) {
    SEEN[0].fetch_add(1, Ordering::Relaxed);
    let Ok(figure) = case.figure() else {
        return;
    };
    SEEN[1].fetch_add(1, Ordering::Relaxed);
    let graph = Graph::from(&figure);
    if !reference(&graph, case.region).reaches_heights(&graph) {
        return;
    }
    if graph.has_heights() {
        SEEN[2].fetch_add(1, Ordering::Relaxed);
        let is_tilted = graph.edges.iter().any(|edge| {
            let [p, q] = edge.ends.map(|end| graph.height(end));
            p.total_cmp(&q).is_ne()
        });
        SEEN[3].fetch_add(usize::from(is_tilted), Ordering::Relaxed);
    }
}

#[test]
fn agrees_with_the_reference() {
    let default = if cfg!(debug_assertions) { 100 } else { 4000 };
    let (first, cases) = (number("HIPLINE_FIRST", 0), number("HIPLINE_CASES", default));
    println!("seeds {first} to {}", first + cases);
    check_all((first..first + cases).map(small_tilted), |case| {
        let how = failure(case);
        if how.is_none() {
            count(case);
        }
        how.into_iter().collect()
    });
    let seen = SEEN.each_ref().map(|count| count.load(Ordering::Relaxed));
    println!("cases, figures, with heights that are reached, with tilted eaves: {seen:?}");
    assert!(seen[3] > seen[0] / 3, "too few with tilted eaves: {seen:?}");
}
