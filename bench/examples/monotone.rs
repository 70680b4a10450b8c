//! The engine for monotone polygons beside the kinetic one, in one run: everything from the points to the
//! skeleton, per vertex, and decisions (signs of exact numbers) per vertex, which are the same in every run.
//!
//! `cargo run --release -p hipline-bench --example monotone -- [LARGEST] [LARGEST_KINETIC]`

use std::time::Instant;

use hipline::{Engine, FigureBuilder, Options, Skeleton};
use hipline_testkit::generate::monotone_large;

/// Builds the figure and computes its skeleton; microseconds.
fn run(points: &[[f64; 2]], engine: Engine) -> (Skeleton, f64) {
    let start = Instant::now();
    let mut builder = FigureBuilder::new();
    builder.polygon(vec![points.to_vec()]);
    let figure = builder.build().expect("a simple ring");
    let skeleton = figure
        .skeleton_by(engine, Options::default())
        .expect("the engine applies");
    (skeleton, start.elapsed().as_secs_f64() * 1e6)
}

fn main() {
    let mut numbers = std::env::args().skip(1).map(|text| text.parse::<usize>());
    let mut number = |default| numbers.next().and_then(Result::ok).unwrap_or(default);
    let (largest, kinetic) = (number(1_000_000), number(100_000));
    println!("vertices  grid  monotone us/v  kinetic us/v  ratio  decisions/v  /log2(n)");
    let mut size = 1_000;
    while size <= largest {
        for seed in 0..2 {
            let points = monotone_large(seed, size);
            let n = points.len() as f64;
            // The best of a few runs of each, turn by turn.
            let rounds = (200_000 / size).clamp(1, 20);
            let mut best = [f64::INFINITY; 2];
            let mut decisions = 0;
            for _ in 0..rounds {
                let (skeleton, time) = run(&points, Engine::Monotone);
                best[0] = best[0].min(time);
                let stats = skeleton.stats();
                decisions = stats.by_f64 + stats.by_double_double + stats.by_wide + stats.by_exact;
                if size <= kinetic {
                    best[1] = best[1].min(run(&points, Engine::Kinetic).1);
                }
            }
            let each = decisions as f64 / n;
            println!(
                "{size:8}  {}  {:13.3}  {:12.3}  {:5.2}  {each:11.2}  {:8.3}",
                if points[1][1].fract() * 64.0 % 1.0 == 0.0 {
                    " yes"
                } else {
                    "  no"
                },
                best[0] / n,
                best[1] / n,
                best[1] / best[0],
                each / n.log2(),
            );
        }
        size *= 10;
    }
}
