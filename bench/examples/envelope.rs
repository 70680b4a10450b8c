//! The lower envelope of slabs beside the kinetic engine, and the motorcycle graph that it starts from.
//!
//! ```text
//! cargo run --release -p hipline-bench --example envelope [--only-envelope] [--cells] [FAMILY:SIZE...]
//! ```
//!
//! Seconds on the clock, one run each, by as many threads as `RAYON_NUM_THREADS` allows; and how the counted steps grow. With `--cells`: how many cells there
//! are, how many of them have several valleys and a long list, and are divided no further, and how long the longest list of these is.

use std::hint::black_box;
use std::time::Instant;

use hipline::{Engine, Options, Region};
use hipline_testkit::generate::{Family, tight, wheel};

fn time<T>(job: impl FnOnce() -> T) -> (f64, T) {
    let start = Instant::now();
    let result = job();
    (start.elapsed().as_secs_f64(), result)
}

fn main() {
    let mut arguments: Vec<String> = std::env::args().skip(1).collect();
    let alone = arguments.iter().any(|a| a == "--only-envelope");
    let count_cells = arguments.iter().any(|a| a == "--cells");
    arguments.retain(|a| !a.starts_with("--"));
    if arguments.is_empty() {
        for family in ["random", "star", "regular", "coast", "holes"] {
            arguments.extend([250, 1000, 4000].map(|n| format!("{family}:{n}")));
        }
    }
    println!(
        "{:<14} {:>8} {:>10} {:>9} {:>10} {:>10} {:>10}",
        "family", "n", "motorc. s", "envel. s", "kinetic s", "steps", "steps/n"
    );
    for argument in arguments {
        let (name, size) = argument.split_once(':').expect("FAMILY:SIZE");

        let n: usize = size.parse().expect("a size");
        let case = if name == "tight" {
            tight(n / 2, n / 6, 1)
        } else if name == "wheel" {
            wheel(n, 1)
        } else {
            Family::named(name).expect("a family").generate(n, 1)
        };
        let figure = case.figure().expect("a figure");
        let inside = Options::default().region(Region::Interior);
        let (motorcycles, _) = time(|| black_box(figure.motorcycles().expect("polygons")));
        let (envelope, skeleton) = time(|| figure.skeleton_by(Engine::Envelope, inside));
        let steps = skeleton.expect("polygons").stats().steps;
        let kinetic = if alone {
            f64::NAN
        } else {
            time(|| black_box(figure.skeleton_by(Engine::Kinetic, inside).is_ok())).0
        };
        let n = figure.vertices().len();
        println!(
            "{name:<14} {n:>8} {motorcycles:>10.3} {envelope:>9.3} {kinetic:>10.4} {steps:>10} {:>10.1}",
            steps as f64 / n as f64
        );
        if count_cells {
            let cells = figure.subdivision().expect("polygons").last;
            let whole = cells
                .iter()
                .filter(|cell| cell.valleys > 1 && cell.slabs > 8);
            let lists: Vec<usize> = whole.map(|cell| cell.slabs).collect();
            let longest = lists.iter().max().copied().unwrap_or(0);
            println!(
                "{:>14} {} cells, {} undivided, lists up to {longest}",
                "",
                cells.len(),
                lists.len()
            );
        }
    }
}
