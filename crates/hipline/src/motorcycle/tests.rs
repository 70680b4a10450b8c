//! How much motorcycles look at, in counts that are the same on every machine.

use super::{
    cells::Cells,
    field::{Field, Ground},
    hits::{Found, Step},
    race, start,
    walls::{Edges, Standing},
};
use crate::{Polygon, predicates::Planes};
use hipline_testkit::generate::Random;
use std::cell::Cell;

/// Counts the steps that are taken on a ground, and the hits that are found.
struct Counted<'a, G> {
    ground: G,
    steps: &'a Cell<usize>,
    hits: &'a Cell<usize>,
}

impl<G> Counted<'_, G> {
    fn count(&self, before: usize, found: &Found) {
        self.steps.set(self.steps.get() + 1);
        self.hits.set(self.hits.get() + found.hits.len() - before);
    }
}

impl<G: Ground> Ground for Counted<'_, G> {
    fn start(&mut self, field: &Field, who: u32, found: &mut Found) {
        let before = found.hits.len();
        self.ground.start(field, who, found);
        self.count(before, found);
    }

    fn step(&mut self, field: &Field, step: Step, found: &mut Found) {
        let before = found.hits.len();
        self.ground.step(field, step, found);
        self.count(before, found);
    }
}

/// Steps and hits per motorcycle of a ring.
fn counts(ring: Vec<[f64; 2]>) -> [f64; 2] {
    let polygon = Polygon::new([ring]).expect("a ring");
    let figure = polygon.figure();
    let planes = Planes::new(figure, &[]);
    let starters = start::starters(figure, &planes);
    let count = starters.len() as f64;
    let edges = Standing::Edges(Edges::new(figure, &planes));
    let [steps, hits] = [(); 2].map(|()| Cell::new(0));
    let ground = Counted {
        ground: Cells::new(edges, std::iter::empty()),
        steps: &steps,
        hits: &hits,
    };
    race::run(&planes, starters, ground, true);
    [steps, hits].map(|total| total.get() as f64 / count)
}

/// Points around a circle, at random distances from its centre, 1000 at most.
fn around(count: usize, least: f64) -> Vec<[f64; 2]> {
    let mut random = Random::new(1);
    let quarter = count / 4;
    (0..4 * quarter)
        .map(|i| {
            let t = (i % quarter) as f64 / quarter as f64;
            let radius = least + (1000.0 - least) * random.unit();
            let scale = radius / (1.0 + t * t);
            let [x, y] = [(1.0 - t * t) * scale, 2.0 * t * scale];
            [[x, y], [-y, x], [-x, -y], [y, -x]][i / quarter]
        })
        .collect()
}

#[test]
fn motorcycles_look_at_few_things() {
    let told: Vec<String> = [("star", 300.0), ("shore", 990.0)]
        .into_iter()
        .flat_map(|(name, least)| {
            [1000, 4000, 16_000].map(|size| {
                let [steps, hits] = counts(around(size, least));
                format!("{name} of {size}: {steps:.2} steps, {hits:.2} hits")
            })
        })
        .collect();
    let expected = [
        "star of 1000: 3.80 steps, 1.88 hits",
        "star of 4000: 5.03 steps, 1.50 hits",
        "star of 16000: 6.81 steps, 1.25 hits",
        "shore of 1000: 2.87 steps, 2.77 hits",
        "shore of 4000: 2.88 steps, 1.88 hits",
        "shore of 16000: 3.20 steps, 1.84 hits",
    ];
    assert_eq!(told, expected);
}
