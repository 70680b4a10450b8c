//! Rings that touch themselves, cut into rings that do not: what other programs take for valid.
//!
//! At the moment when a ring-shaped part is pinched its loop touches itself; so do loops two of
//! whose points are rounded to one. A polygon's ring may not (OGC Simple Features, 6.1.11), but two
//! rings of a polygon may touch in a point.

use super::{OffsetLoop, Part, level::is_flat};
use crate::topology::FaceId;
use hipline_num::{BallDd, Number};
use robust::{Coord, orient2d};
use std::collections::BTreeMap;

/// The rings of a part's bounded pieces, the shell first; of a part that is unbounded, only what
/// is cut off from it.
pub(super) fn polygons(part: &Part, loops: &[OffsetLoop]) -> Vec<Vec<OffsetLoop>> {
    let all = part.shell.iter().chain(&part.holes);
    nested(part.shell.is_some(), all.flat_map(|&i| cut(&loops[i])))
}

/// The rings of what is on the other side of loops, the shells first: a part of what has been
/// swept.
pub(super) fn swept_polygons(part: &Part, loops: &[OffsetLoop]) -> Vec<Vec<OffsetLoop>> {
    let all = part.shell.iter().chain(&part.holes);
    nested(true, all.flat_map(|&i| cut(&reversed(&loops[i]))))
}

fn reversed(ring: &OffsetLoop) -> OffsetLoop {
    let points = ring.points.iter().rev().copied().collect();
    // The edge after a point was the one before it.
    let mut faces: Vec<FaceId> = ring.faces.iter().rev().copied().collect();
    if !faces.is_empty() {
        faces.rotate_left(1);
    }
    OffsetLoop { points, faces }
}

/// Shells with their holes, given in the order of their shells.
fn nested(has_shell: bool, rings: impl Iterator<Item = OffsetLoop>) -> Vec<Vec<OffsetLoop>> {
    let (shells, holes): (Vec<_>, Vec<_>) = rings.partition(is_counterclockwise);
    let mut polygons: Vec<Vec<OffsetLoop>> = shells.into_iter().map(|shell| vec![shell]).collect();
    for hole in holes {
        let home = if has_shell && polygons.len() == 1 {
            Some(0)
        } else {
            // At distance 0 a hole can be its shell: then nothing of it is off that.
            let find = |side| {
                let is_there = |rings: &Vec<OffsetLoop>| side_of(&hole, &rings[0]) == side;
                polygons.iter().position(is_there)
            };
            find(Some(true)).or_else(|| find(None))
        };
        if let Some(home) = home {
            polygons[home].push(hole);
        }
    }
    polygons
}

/// A loop cut at the points that it has twice.
pub(super) fn cut(ring: &OffsetLoop) -> Vec<OffsetLoop> {
    // Adding 0 turns -0 into 0.
    let key = |p: [f64; 2]| p.map(|x| (x + 0.0).to_bits());
    let mut rings = Vec::new();
    let mut way: Vec<([f64; 2], FaceId)> = Vec::new();
    let mut at: BTreeMap<[u64; 2], usize> = BTreeMap::new();
    let mut close = |way: &[([f64; 2], FaceId)]| {
        let (points, faces): (Vec<_>, Vec<_>) = way.iter().copied().unzip();
        if !is_flat(&points) {
            rings.push(OffsetLoop { points, faces });
        }
    };
    for (&point, &face) in ring.points.iter().zip(&ring.faces) {
        if let Some(&first) = at.get(&key(point)) {
            close(&way[first..]);
            for (point, _) in way.drain(first..) {
                at.remove(&key(point));
            }
        }
        at.insert(key(point), way.len());
        way.push((point, face));
    }
    close(&way);
    rings
}

fn coord([x, y]: [f64; 2]) -> Coord<f64> {
    Coord { x, y }
}

/// Whether a ring is counterclockwise: by the sign of its area, and where that is too small to
/// tell, by the turn at its leftmost point (of several, the lowest).
fn is_counterclockwise(ring: &OffsetLoop) -> bool {
    let points = &ring.points;
    let origin = points[0];
    let from_origin =
        |p: [f64; 2]| [0, 1].map(|k| BallDd::from_f64(p[k]).minus(&BallDd::from_f64(origin[k])));
    let cross = points.windows(2).map(|step| {
        let [p, q] = [from_origin(step[0]), from_origin(step[1])];
        p[0].times(&q[1]).minus(&p[1].times(&q[0]))
    });
    let area = cross.fold(BallDd::zero(), |sum, term| sum.plus(&term));
    if let Some(sign) = area.sign().filter(|sign| !sign.is_zero()) {
        return sign.is_positive();
    }
    let order = |&i: &usize, &j: &usize| {
        let [p, q] = [points[i], points[j]];
        p[0].total_cmp(&q[0]).then(p[1].total_cmp(&q[1]))
    };
    let first = (0..points.len()).min_by(order).unwrap_or(0);
    let beside = |step: usize| coord(points[(first + step) % points.len()]);
    orient2d(beside(points.len() - 1), beside(0), beside(1)) > 0.0
}

/// Whether a ring lies in another that it does not cross: told by the first point that is not on
/// the other; nothing if all are.
fn side_of(ring: &OffsetLoop, other: &OffsetLoop) -> Option<bool> {
    ring.points.iter().find_map(|&p| contains(other, p))
}

/// Whether a ring contains a point; nothing if the point is on it. Exact.
fn contains(ring: &OffsetLoop, point: [f64; 2]) -> Option<bool> {
    let mut inside = false;
    let next = ring.points.iter().skip(1).chain(ring.points.first());
    for (&a, &b) in ring.points.iter().zip(next) {
        let side = orient2d(coord(a), coord(b), coord(point));
        let within = |k: usize| {
            let (low, high) = (a[k].min(b[k]), a[k].max(b[k]));
            (low..=high).contains(&point[k])
        };
        if side == 0.0 && within(0) && within(1) {
            return None;
        }
        if (a[1] > point[1]) != (b[1] > point[1]) && (side > 0.0) == (b[1] > a[1]) {
            inside = !inside;
        }
    }
    Some(inside)
}
