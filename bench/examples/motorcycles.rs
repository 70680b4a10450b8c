//! How long motorcycle graphs take and how much memory, beside a constrained Delaunay triangulation of the same input and
//! its straight skeleton.
//!
//! ```text
//! cargo run --release -p hipline-bench --example motorcycles [FAMILY...] [SIZE...]
//! ```
//!
//! One thread, CPU time, the best of three (of one from 200,000 vertices on). The figure with its triangulation is there before
//! the clock starts. Memory is the most that is in use, figure and result among it; it is known only if nothing before took more,
//! so ask for one family and size at a time.

use std::alloc::System;
use std::hint::black_box;

use cap::Cap;
use cpu_time::ThreadTime;
use hipline::motorcycle::{Launch, MotorcycleGraph};
use hipline::{Figure, Options};
use hipline_testkit::generate::{Family, Random};
use spade::{ConstrainedDelaunayTriangulation, Point2};

const FAMILIES: [Family; 9] = [
    Family::Random,
    Family::Orthogonal,
    Family::Star,
    Family::Coast,
    Family::Snowflake,
    Family::Comb,
    Family::Spiral,
    Family::Holes,
    Family::SquareHoles,
];

#[global_allocator]
static MEMORY: Cap<System> = Cap::new(System, usize::MAX);

/// Nanoseconds for each of n.
fn time(n: usize, mut job: impl FnMut()) -> f64 {
    let rounds = if n < 200_000 { 3 } else { 1 };
    let best = (0..rounds).map(|_| {
        let start = ThreadTime::now();
        job();
        start.elapsed().as_secs_f64()
    });
    1e9 * best.fold(f64::INFINITY, f64::min) / n as f64
}

fn triangulate(figure: &Figure) {
    let points = figure.vertices().iter().map(|&[x, y]| Point2::new(x, y));
    let edges = figure.edges().iter();
    let edges = edges.map(|edge| [edge.from.index(), edge.to.index()]);
    let cdt =
        ConstrainedDelaunayTriangulation::<_>::bulk_load_cdt(points.collect(), edges.collect());
    black_box(cdt.is_ok());
}

fn of_figures(families: &[Family], n: usize) {
    for family in families {
        let (before, most_before) = (MEMORY.allocated(), MEMORY.max_allocated());
        let figure = match family.generate(n, 1).figure() {
            Ok(figure) => figure,
            Err(flaws) => {
                println!("{:<14} {n:>9} {flaws}", family.name());
                continue;
            }
        };
        let vertices = figure.vertices().len();
        let mut count = [0; 2];
        let own = time(vertices, || {
            let graph = figure.motorcycles().expect("a polygon");
            count = [graph.motorcycles().len(), graph.meetings().len()];
        });
        let most = MEMORY.max_allocated();
        let bytes = (most > most_before).then(|| ((most - before) / vertices).to_string());
        let spade = time(vertices, || triangulate(&figure));
        let skeleton = time(vertices, || {
            black_box(figure.skeleton(Options::default()));
        });
        println!(
            "{:<14} {vertices:>9} {:>9} {:>8} {own:>10.0} {skeleton:>10.0} {:>7.2} {spade:>10.0} {:>9}",
            family.name(),
            count[0],
            count[1],
            own / skeleton,
            bytes.unwrap_or_default()
        );
    }
}

/// Motorcycles at random places in a square, with random velocities.
fn of_launches(n: usize) {
    let mut random = Random::new(7);
    let launches: Vec<Launch> = (0..n)
        .map(|_| {
            let numbers = [(); 4].map(|()| random.unit());
            let velocity = [numbers[2] - 0.5, numbers[3] - 0.5];
            Launch::new([numbers[0], numbers[1]], velocity)
        })
        .collect();
    let mut meetings = 0;
    let own = time(n, || {
        let graph = MotorcycleGraph::new(&launches, &[]).expect("motorcycles");
        meetings = graph.meetings().len();
    });
    println!("{:<14} {n:>9} {n:>9} {meetings:>8} {own:>10.0}", "launches");
}

fn main() {
    println!(
        "{:<14} {:>9} {:>9} {:>8} {:>10} {:>10} {:>7} {:>10} {:>9}",
        "family",
        "vertices",
        "m'cycles",
        "meetings",
        "ns/vertex",
        "skeleton",
        "ratio",
        "spade",
        "B/vertex"
    );
    let words: Vec<String> = std::env::args().skip(1).collect();
    let mut sizes: Vec<usize> = words.iter().filter_map(|word| word.parse().ok()).collect();
    if sizes.is_empty() {
        sizes = vec![1000, 10_000, 100_000, 1_000_000];
    }
    let named = |family: &Family| words.iter().any(|word| word == family.name());
    let mut families: Vec<Family> = FAMILIES.into_iter().filter(named).collect();
    let all = families.is_empty();
    if all {
        families = FAMILIES.to_vec();
    }
    for size in sizes {
        of_figures(&families, size);
        if all {
            of_launches(size);
        }
    }
}
