//! How many offsets per second: after one skeleton, distances spread evenly over all times.
//!
//! ```text
//! cargo run --release -p hipline-bench --example offsets -- [N] [FAMILY..]
//! ```
//!
//! If the time per point does not depend on the number of distances, offsets are linear in what
//! they consist of (and what one skeleton costs to read once). CPU time of the one thread that works;
//! the best of three.

use std::time::Duration;

use cpu_time::ThreadTime;
use hipline::{Options, Region};
use hipline_testkit::generate::Family;

const USUAL: [&str; 6] = ["random", "star", "holes", "square-holes", "comb", "coast"];

fn main() -> Result<(), String> {
    let mut arguments = std::env::args().skip(1);
    let n = arguments.next().map_or(Ok(10_000), |n| {
        n.parse().map_err(|_| format!("{n} is not a size"))
    })?;
    let mut names: Vec<String> = arguments.collect();
    if names.is_empty() {
        names = USUAL.map(str::to_owned).to_vec();
    }
    println!(
        "family        vertices  skeleton s  distances    points  offsets s  offsets/s  us/point"
    );
    for name in &names {
        let family = Family::named(name).ok_or_else(|| format!("no family is called {name}"))?;
        one(family, n)?;
    }
    Ok(())
}

fn timed<T>(work: impl FnOnce() -> T) -> (T, f64) {
    let start = ThreadTime::now();
    let result = work();
    (
        result,
        start.elapsed().max(Duration::from_nanos(1)).as_secs_f64(),
    )
}

fn one(family: Family, n: usize) -> Result<(), String> {
    let case = family.generate(n, 1);
    let figure = case.figure().map_err(|flaws| flaws.to_string())?;
    let region = if figure.has_polygon() {
        Region::Interior
    } else {
        Region::Both
    };
    let (skeleton, seconds) = timed(|| figure.skeleton(Options::default().region(region)));
    let times = skeleton.nodes().iter().map(|node| node.time);
    let mut times: Vec<f64> = times.filter(|t| t.is_finite() && *t > 0.0).collect();
    times.sort_by(f64::total_cmp);
    for count in [1, 10, 100, 1000] {
        // At quantiles of the times, so that every distance has something to show.
        let at = |i: usize| times[i * times.len() / (count + 1)] * 0.999;
        let distances: Vec<f64> = (1..=count).map(at).collect();
        let mut best = f64::INFINITY;
        let mut points = 0;
        for _ in 0..3 {
            let (offsets, seconds) = timed(|| skeleton.offsets(&figure, &distances));
            let offsets = offsets.map_err(|e| e.to_string())?;
            let loops = offsets.iter().flat_map(|offset| offset.loops());
            points = loops.map(|ring| ring.points().len()).sum::<usize>();
            best = best.min(seconds);
        }
        println!(
            "{:<12} {:>9} {seconds:>11.3} {count:>10} {points:>9} {best:>10.4} {:>10.0} {:>9.3}",
            family.name(),
            figure.vertices().len(),
            count as f64 / best,
            1e6 * best / points.max(1) as f64
        );
    }
    Ok(())
}
