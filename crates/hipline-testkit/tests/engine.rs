//! The library against the reference engine, arc for arc and bit for bit, on random small cases.
//!
//! In release builds 20,000 seeds; in debug builds, which are some twenty times slower, 500.
//! `HIPLINE_CASES` sets another count, and a longer run goes by
//! `cargo run --release -p hipline-testkit --example hunt -- FIRST COUNT`.

use std::thread;

use hipline_testkit::hunt::hunt;

#[test]
fn agrees_with_the_reference() {
    let count = std::env::var("HIPLINE_CASES")
        .ok()
        .and_then(|count| count.parse().ok())
        .unwrap_or(if cfg!(debug_assertions) { 500 } else { 20_000 });
    let threads = thread::available_parallelism().map_or(1, |n| n.get() as u64);
    println!("seeds 0 to {count} on {threads} threads");
    let found: Vec<_> = thread::scope(|scope| {
        let running: Vec<_> = (0..threads)
            .map(|k| scope.spawn(move || hunt((k..count).step_by(threads as usize), 3)))
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
