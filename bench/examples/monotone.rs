//! The engine for monotone polygons beside the kinetic one, in one run, per vertex: the figure, either skeleton, the
//! triangulation that only the kinetic engine needs; and decisions (signs of exact numbers), which are the same in every run.
//! Times are those of the processor, so that other programs disturb less. Ratios are of everything from the points to the skeleton, and of the skeletons alone without the triangulation.
//!
//! `cargo run --release -p hipline-bench --example monotone -- [LARGEST] [LARGEST_KINETIC]`

use cpu_time::ThreadTime;
use hipline::{Engine, Figure, FigureBuilder, Options, Skeleton};
use hipline_testkit::generate::monotone_large;

/// The result and how long it took, in microseconds.
fn timed<T>(run: impl FnOnce() -> T) -> (T, f64) {
    let start = ThreadTime::now();
    let result = run();
    (result, start.elapsed().as_secs_f64() * 1e6)
}

fn built(points: &[[f64; 2]]) -> Figure {
    let mut builder = FigureBuilder::new();
    builder.polygon(vec![points.to_vec()]);
    builder.build().expect("a simple ring")
}

fn by(engine: Engine, figure: &Figure) -> Skeleton {
    let skeleton = figure.skeleton_by(engine, Options::default());
    skeleton.expect("the engine applies")
}

/// Microseconds of one polygon, the best of some runs.
struct Best {
    build: f64,
    monotone: f64,
    /// With the triangulation.
    first: f64,
    /// Without it, which was made before.
    kinetic: f64,
    decisions: u64,
}

fn measured(points: &[[f64; 2]], rounds: usize, kinetic: bool) -> Best {
    let mut best = Best {
        build: f64::INFINITY,
        monotone: f64::INFINITY,
        first: f64::INFINITY,
        kinetic: f64::INFINITY,
        decisions: 0,
    };
    for _ in 0..rounds {
        let (figure, time) = timed(|| built(points));
        best.build = best.build.min(time);
        let (skeleton, time) = timed(|| by(Engine::Monotone, &figure));
        best.monotone = best.monotone.min(time);
        let stats = skeleton.stats();
        best.decisions = stats.by_f64 + stats.by_double_double + stats.by_wide + stats.by_exact;
        drop(skeleton);
        if kinetic {
            best.first = best.first.min(timed(|| by(Engine::Kinetic, &figure)).1);
            best.kinetic = best.kinetic.min(timed(|| by(Engine::Kinetic, &figure)).1);
        }
    }
    best
}

fn main() {
    let mut numbers = std::env::args().skip(1).map(|text| text.parse::<usize>());
    let mut number = |default| numbers.next().and_then(Result::ok).unwrap_or(default);
    let (largest, kinetic) = (number(1_000_000), number(100_000));
    println!(
        "vertices  grid  build us/v  monotone us/v  mesh us/v  kinetic us/v  whole  alone  decisions/v  /log2(n)"
    );
    let mut size = 1_000;
    while size <= largest {
        for seed in 0..2 {
            let points = monotone_large(seed, size);
            let n = points.len() as f64;
            let rounds = (200_000 / size).clamp(1, 20);
            let best = measured(&points, rounds, size <= kinetic);
            let each = best.decisions as f64 / n;
            println!(
                "{size:8}  {}  {:10.3}  {:13.3}  {:9.3}  {:12.3}  {:5.2}  {:5.2}  {each:11.2}  {:8.3}",
                if points[1][1].fract() * 64.0 % 1.0 == 0.0 {
                    " yes"
                } else {
                    "  no"
                },
                best.build / n,
                best.monotone / n,
                (best.first - best.kinetic) / n,
                best.kinetic / n,
                (best.build + best.first) / (best.build + best.monotone),
                best.kinetic / best.monotone,
                each / n.log2(),
            );
        }
        size *= 10;
    }
}
