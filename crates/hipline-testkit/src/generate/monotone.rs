//! Monotone polygons and chains: tiny ones on grids, degenerate in every way, and large ones.

use super::grid::{Point, is_simple};
use super::random::Random;
use crate::case::{Case, Part, Points};

/// Speeds to choose from: equal ones meet often.
const SPEEDS: [f64; 6] = [1.0, 1.0, 2.0, 0.5, 3.0, 1.0];

/// A small monotone polygon, in any direction, oriented either way: strictly monotone or with edges along the
/// levels, several in a row, with vertices of 180 degrees.
#[must_use]
pub fn monotone_small(seed: u64) -> Case {
    let mut random = Random::new(seed);
    let random = &mut random;
    let ring = loop {
        if let Some(ring) = small_ring(random) {
            break ring;
        }
    };
    Case {
        comments: vec![format!("monotone_small({seed})")],
        ..Case::of(vec![Part::polygon(vec![turned(random, &ring)])])
    }
}

/// The same with speeds.
#[must_use]
pub fn monotone_weighted(seed: u64) -> Case {
    let mut case = monotone_small(seed);
    let mut random = Random::new(seed ^ 0x5eed);
    case.comments = vec![format!("monotone_weighted({seed})")];
    for part in &mut case.parts {
        if let Part::Polygon { rings, speeds } = part {
            let plain = random.one_in(4);
            *speeds = rings
                .iter()
                .map(|ring| {
                    let speed = |_: &[f64; 2]| {
                        if plain && !random.one_in(3) {
                            1.0
                        } else {
                            *random.pick(&SPEEDS)
                        }
                    };
                    ring.iter().map(speed).collect()
                })
                .collect();
        }
    }
    case
}

/// Columns of points from west to east, each going up or down.
fn chain(random: &mut Random, columns: i64, heights: [i64; 2], ends: [i64; 2]) -> Vec<Point> {
    let mut points = vec![[0, ends[0]]];
    // How often a column has no vertex, and how often several.
    let (rare, steep) = (random.range(1, 4) as usize, random.range(1, 6) as usize);
    for x in 0..=columns {
        if x > 0 && x < columns && !random.one_in(rare) {
            continue;
        }
        let mut y = random.range(heights[0], heights[1]);
        if x == 0 || x == columns {
            continue;
        }
        points.push([x, y]);
        if random.one_in(steep) {
            let step = if random.one_in(2) { 1 } else { -1 };
            for _ in 0..random.range(1, 3) {
                y += step * random.range(1, 2);
                if (heights[0]..=heights[1]).contains(&y) {
                    points.push([x, y]);
                }
            }
        }
    }
    points.push([columns, ends[1]]);
    points
}

fn small_ring(random: &mut Random) -> Option<Vec<Point>> {
    let columns = random.range(2, 9);
    let height = random.range(2, 6);
    let [low, high] = if random.one_in(3) {
        [random.range(0, height), random.range(0, height)]
    } else {
        [height / 2, height / 2]
    };
    let wall = |random: &mut Random| {
        let bottom = random.range(0, height);
        let top = if random.one_in(2) {
            bottom
        } else {
            random.range(bottom, height)
        };
        [bottom, top]
    };
    let (west, east) = (wall(random), wall(random));
    let lower = chain(random, columns, [0, low], [west[0], east[0]]);
    let mut upper = chain(random, columns, [high, height], [west[1], east[1]]);
    upper.reverse();
    let mut ring = lower;
    // Walls may be in several pieces.
    let pieces = |random: &mut Random, from: i64, to: i64, x: i64| {
        let (low, high) = (from.min(to), from.max(to));
        let mut list: Vec<Point> = (low + 1..high)
            .filter(|_| random.one_in(3))
            .map(|y| [x, y])
            .collect();
        if from > to {
            list.reverse();
        }
        list
    };
    ring.extend(pieces(random, east[0], east[1], columns));
    ring.extend(upper);
    ring.extend(pieces(random, west[1], west[0], 0));
    ring.dedup();
    if ring.first() == ring.last() {
        ring.pop();
    }
    (ring.len() >= 3 && is_simple(&ring)).then_some(ring)
}

/// The ring after a map of the plane that keeps it monotone, from another vertex on, either way round.
fn turned(random: &mut Random, ring: &[Point]) -> Points {
    let maps = [
        [1, 0, 0, 1],
        [1, 0, 0, 1],
        [0, -1, 1, 0],
        [0, 1, 1, 0],
        [1, 1, 0, 1],
        [1, 0, 1, 1],
        [2, -1, 1, 2],
        [1, -2, 1, 1],
        [3, 1, -1, 2],
        [3, -4, 4, 3],
        [5, 2, 2, 1],
    ];
    let [a, b, c, d] = *random.pick(&maps);
    let scale = *random.pick(&[1.0, 1.0, 0.5, 3.0, 1024.0]);
    let shift = *random.pick(&[[0.0, 0.0], [-7.0, 3.0], [4096.0, 1e6]]);
    let mut points: Points = ring
        .iter()
        .map(|&[x, y]| {
            let p = [(a * x + b * y) as f64, (c * x + d * y) as f64];
            [0, 1].map(|k| p[k] * scale + shift[k])
        })
        .collect();
    if random.one_in(2) {
        points.reverse();
    }
    let by = random.below(points.len());
    points.rotate_left(by);
    points
}

/// A large monotone polygon with the given number of vertices: two rough chains whose heights are sums of
/// waves and noise, on a grid of the given fineness or off any grid.
#[must_use]
pub fn monotone_large(seed: u64, vertices: usize) -> Points {
    let mut random = Random::new(seed);
    let half = vertices / 2;
    let width = half as f64;
    let fine = random.one_in(2);
    let height = |x: f64, random: &mut Random| {
        let noise = random.unit() * 3.0;
        let wide = [7.0, 63.0, 411.0, 3001.0].map(|period| {
            let phase = (x / period).fract() - 0.5;
            phase.abs() * 0.25 * period
        });
        let y = 1.0 + noise + wide.iter().sum::<f64>();
        if fine { y } else { (y * 64.0).floor() / 64.0 }
    };
    let mut ring = vec![[0.0, 0.0]];
    for i in 1..half {
        let x = i as f64;
        ring.push([x, -height(x, &mut random)]);
    }
    ring.push([width, 0.0]);
    for i in (1..vertices - half).rev() {
        let x = i as f64 * width / (vertices - half) as f64;
        ring.push([x, height(x, &mut random)]);
    }
    ring
}

/// A small monotone chain, in any direction, with speeds (left and right) in one case of three.
#[must_use]
pub fn chain_small(seed: u64) -> Case {
    let mut random = Random::new(seed);
    let random = &mut random;
    let columns = random.range(1, 9);
    let height = random.range(1, 6);
    let ends = [random.range(0, height), random.range(0, height)];
    let mut points = chain(random, columns, [0, height], ends);
    points.dedup();
    let points = turned_line(random, &points);
    let speeds = if random.one_in(3) {
        let speed = |_: &[[f64; 2]]| [0, 1].map(|_| *random.pick(&SPEEDS));
        points.windows(2).map(speed).collect()
    } else {
        Vec::new()
    };
    Case {
        comments: vec![format!("chain_small({seed})")],
        ..Case::of(vec![Part::Line { points, speeds }])
    }
}

/// The chain after a map that keeps integers, so that its ends can be prolonged exactly.
fn turned_line(random: &mut Random, line: &[Point]) -> Points {
    let maps = [
        [1, 0, 0, 1],
        [0, -1, 1, 0],
        [0, 1, 1, 0],
        [1, 1, 0, 1],
        [3, -4, 4, 3],
    ];
    let [a, b, c, d] = *random.pick(&maps);
    let mut points: Points = line
        .iter()
        .map(|&[x, y]| [(a * x + b * y) as f64, (c * x + d * y) as f64])
        .collect();
    if random.one_in(2) {
        points.reverse();
    }
    points
}
