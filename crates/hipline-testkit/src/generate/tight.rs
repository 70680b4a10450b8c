//! Polygons on which the bound of divide and conquer over slabs is tight: figure 5.1 of Mencil's thesis (2014).

use std::f64::consts::TAU;

use super::random::Random;
use crate::case::{Case, Part};

/// A wall on the left of `chain` edges that are almost upright, whose faces all reach far to the right, and `dips` small dips
/// in the ceiling: each cut across the dips crosses all these faces.
#[must_use]
pub fn tight(chain: usize, dips: usize, seed: u64) -> Case {
    let random = &mut Random::new(seed);
    let (height, bulge, width) = (8192.0, 64.0, 1024.0);
    let mut points = vec![[0.0, 0.0], [3.0 * width, 0.0], [3.0 * width, height]];
    let step = 0.75 * width / dips as f64;
    for dip in 0..dips {
        let x = width - step * (dip as f64 + 0.5 * random.unit());
        let depth = step * (0.1 + 0.1 * random.unit());
        points.extend([
            [x, height],
            [x - 0.2 * step, height - depth],
            [x - 0.4 * step, height],
        ]);
    }
    points.push([0.0, height]);
    for i in (1..chain).rev() {
        let along = 2.0 * i as f64 / chain as f64 - 1.0;
        points.push([
            bulge * (along * along - 1.0),
            height * i as f64 / chain as f64,
        ]);
    }
    Case {
        comments: vec![format!("tight: {chain} edges, {dips} dips, seed {seed}")],
        ..Case::of(vec![Part::polygon(vec![points])])
    }
}

/// A circle with about n / 3 narrow notches that point to its middle, more or less: their valleys cross cells without
/// vertices of motorcycles at all angles.
#[must_use]
pub fn wheel(n: usize, seed: u64) -> Case {
    let random = &mut Random::new(seed);
    let count = (n / 3).max(3);
    let mut points = Vec::with_capacity(3 * count);
    for notch in 0..count {
        let at = notch as f64 + 0.3 * random.unit();
        let depth = 20.0 + 180.0 * random.unit();
        let tilt = 0.1 * (random.unit() - 0.5);
        for (along, radius) in [(0.0, 1000.0), (0.15 + tilt, 1000.0 - depth), (0.3, 1000.0)] {
            let (sin, cos) = (TAU * (at + along) / count as f64).sin_cos();
            points.push([radius * cos, radius * sin]);
        }
    }
    Case {
        comments: vec![format!("wheel: {count} notches, seed {seed}")],
        ..Case::of(vec![Part::polygon(vec![points])])
    }
}
