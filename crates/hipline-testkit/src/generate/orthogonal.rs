//! Orthogonal monotone polygons.
//!
//! Columns side by side, each from one height to another, such that each two neighbours overlap. Equal heights of
//! neighbours and extra vertices give corners of 180 degrees; small grids give
//! everything that general position excludes: events at one time, at one place, walls on one line.

use super::Random;
use crate::case::{Case, Part};

/// How the columns are chosen.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Columns {
    /// Any heights up to this one.
    Any(i64),
    /// Each height near the one before: a landscape.
    Walk(i64),
    /// Floors and ceilings that know nothing of each other, apart by a corridor.
    Apart(i64),
}

/// The ring of so many columns on the integer grid, counterclockwise, with a vertex only where it turns or where
/// a height repeats. `widest` is the largest width of a column.
#[must_use]
pub fn columns(random: &mut Random, count: usize, widest: i64, how: Columns) -> Vec<[i64; 2]> {
    let mut xs = vec![0];
    let mut spans: Vec<[i64; 2]> = Vec::with_capacity(count);
    for k in 0..count {
        xs.push(xs[k] + random.range(1, widest));
        let before = spans.last().copied();
        spans.push(span(random, before, how));
    }
    let mut ring = Vec::with_capacity(4 * count);
    for (k, [low, _]) in spans.iter().enumerate() {
        ring.push([xs[k], *low]);
        ring.push([xs[k + 1], *low]);
    }
    for (k, [_, high]) in spans.iter().enumerate().rev() {
        ring.push([xs[k + 1], *high]);
        ring.push([xs[k], *high]);
    }
    ring.dedup();
    ring
}

/// The next column, which overlaps the one before.
fn span(random: &mut Random, before: Option<[i64; 2]>, how: Columns) -> [i64; 2] {
    for _ in 0..20 {
        let [low, high] = match how {
            Columns::Any(most) => [random.range(0, most), random.range(0, most)],
            Columns::Walk(step) => {
                let [low, high] = before.unwrap_or([0, 2 * step]);
                [
                    low + random.range(-step, step),
                    high + random.range(-step, step),
                ]
            }
            Columns::Apart(most) => [random.range(0, most), random.range(most + 1, 2 * most + 1)],
        };
        let overlaps = before.is_none_or(|[l, h]| low < h && l < high);
        if low < high && overlaps {
            return [low, high];
        }
    }
    before.unwrap_or([0, 1])
}

/// Puts vertices on some edges of a ring, on the integer grid.
pub fn subdivide(random: &mut Random, ring: &[[i64; 2]], one_in: usize) -> Vec<[i64; 2]> {
    let mut finer = Vec::with_capacity(2 * ring.len());
    for (k, &[x, y]) in ring.iter().enumerate() {
        finer.push([x, y]);
        let [to_x, to_y] = ring[(k + 1) % ring.len()];
        let [dx, dy] = [to_x - x, to_y - y];
        let length = dx.abs().max(dy.abs());
        if length > 1 && random.one_in(one_in) {
            let mut cuts: Vec<i64> = (0..random.range(1, 3))
                .map(|_| random.range(1, length - 1))
                .collect();
            cuts.sort_unstable();
            cuts.dedup();
            finer.extend(
                cuts.iter()
                    .map(|cut| [x + dx.signum() * cut, y + dy.signum() * cut]),
            );
        }
    }
    finer
}

/// How integers become coordinates; the order of coordinates stays.
fn placed(random: &mut Random, ring: &[[i64; 2]]) -> Vec<[f64; 2]> {
    let scales = [
        [1.0, 1.0],
        [1.0, 1.0],
        [0.1, 0.1],
        [1.0, 100.0],
        [1e-3, 7.0],
        [1.0 / 3.0, 1e-20],
        [1e40, 1e60],
    ];
    let offsets = [
        [0.0, 0.0],
        [0.0, 0.0],
        [-3.0, 2.0],
        [1e9, -4e9],
        [0.123, 1e5],
    ];
    let scale = *random.pick(&scales);
    let offset = *random.pick(&offsets);
    let points: Vec<[f64; 2]> = ring
        .iter()
        .map(|point| [0, 1].map(|axis| point[axis] as f64 * scale[axis] + offset[axis]))
        .collect();
    // Where the offset swallows differences, it is left out.
    let distinct = |axis: usize| {
        let mut pairs: Vec<(i64, u64)> = (0..ring.len())
            .map(|k| (ring[k][axis], points[k][axis].to_bits()))
            .collect();
        pairs.sort_unstable();
        pairs.dedup();
        pairs.windows(2).all(|pair| pair[0].1 != pair[1].1)
    };
    if distinct(0) && distinct(1) {
        points
    } else {
        let point = |point: &[i64; 2]| [0, 1].map(|axis| point[axis] as f64 * scale[axis]);
        ring.iter().map(point).collect()
    }
}

/// A small orthogonal polygon that is monotone in the direction of an axis, of every kind that an engine may
/// find difficult: one of 16 symmetries, starting anywhere.
#[must_use]
pub fn orthogonal(seed: u64) -> Case {
    let random = &mut Random::new(seed);
    let (count, widest, how) = match random.below(8) {
        0 | 1 => (1 + random.below(5), 2, Columns::Any(4)),
        2 => (2 + random.below(8), 2, Columns::Walk(2)),
        3 => (2 + random.below(8), 3, Columns::Apart(3)),
        4 => (2 + random.below(8), 4, Columns::Any(8)),
        5 => (3 + random.below(10), 4, Columns::Apart(6)),
        6 => (3 + random.below(12), 1, Columns::Walk(1)),
        _ => (3 + random.below(12), 1000, Columns::Apart(1000)),
    };
    let mut ring = columns(random, count, widest, how);
    if random.one_in(2) {
        ring = without_straight(&ring);
    }
    if random.one_in(3) {
        ring = subdivide(random, &ring, 3);
    }
    let mut points = placed(random, &ring);
    let [swap, flip_x, flip_y, turn] = [0; 4].map(|_| random.one_in(2));
    for [x, y] in &mut points {
        if swap {
            std::mem::swap(x, y);
        }
        *x = if flip_x { -*x } else { *x } + 0.0;
        *y = if flip_y { -*y } else { *y } + 0.0;
    }
    if turn {
        points.reverse();
    }
    let by = random.below(points.len());
    points.rotate_left(by);
    Case {
        comments: vec![format!("orthogonal, seed {seed}")],
        ..Case::of(vec![Part::polygon(vec![points])])
    }
}

/// A ring without its corners of 180 degrees.
fn without_straight(ring: &[[i64; 2]]) -> Vec<[i64; 2]> {
    let n = ring.len();
    let turns = |k: usize| {
        let [a, b, c] = [ring[(k + n - 1) % n], ring[k], ring[(k + 1) % n]];
        !(0..2).any(|axis| a[axis] == b[axis] && b[axis] == c[axis])
    };
    (0..n).filter(|&k| turns(k)).map(|k| ring[k]).collect()
}
