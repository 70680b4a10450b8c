//! How often the engine for monotone polygons refuses weighted ones: the table of `docs/engines.md`. Rough polygons
//! (`monotone_large`) with random speeds, refused of tried.
//!
//! `cargo run --release -p hipline-testkit --example refusals`

use hipline::{Engine, FigureBuilder, NotApplicable, Options};
use hipline_testkit::generate::{Random, monotone_large};

/// A kind of speeds: the speed of one edge.
type Speeds = (&'static str, fn(&mut Random) -> f64);

const SPEEDS: [Speeds; 3] = [
    ("0.5 to 3", |random| random.unit().mul_add(2.5, 0.5)),
    ("0.9 to 1.1", |random| random.unit().mul_add(0.2, 0.9)),
    ("2 for one edge of 1,000, else 1", |random| {
        if random.one_in(1000) { 2.0 } else { 1.0 }
    }),
];

/// Vertices, and how many polygons are tried.
const SIZES: [(usize, u64); 4] = [(30, 400), (100, 200), (1_000, 20), (10_000, 6)];

fn is_refused(seed: u64, size: usize, speed: fn(&mut Random) -> f64) -> bool {
    let ring = monotone_large(seed, size);
    let random = &mut Random::new(seed);
    let speeds = ring.iter().map(|_| speed(random)).collect();
    let mut builder = FigureBuilder::new();
    builder.weighted_polygon(vec![ring], vec![speeds]);
    let figure = builder.build().expect("a simple ring");
    match figure.skeleton_by(Engine::Monotone, Options::default()) {
        Ok(_) => false,
        Err(NotApplicable::RunsAhead { .. }) => true,
        Err(other) => panic!("seed {seed}, {size} vertices: {other}"),
    }
}

fn main() {
    let names = SPEEDS.map(|(name, _)| name);
    println!("| vertices | {} |", names.join(" | "));
    println!("| ---: | ---: | ---: | ---: |");
    for (size, tries) in SIZES {
        let cells = SPEEDS.map(|(_, speed)| {
            let refused = (0..tries).filter(|&seed| is_refused(seed, size, speed));
            format!("{} of {tries}", refused.count())
        });
        println!("| {size} | {} |", cells.join(" | "));
    }
}
