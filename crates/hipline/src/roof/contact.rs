//! Do two triangles of a mesh meet where they must not?
//!
//! Exact signs of orientations decide, so an answer is right for the coordinates as they are
//! (as far as products of their differences stay within the range of `f64`).

use super::plane::{orientation, side};

type Point = [f64; 3];
type Triangle = [Point; 3];

/// Two triangles that have more in common than a corner or an edge. Corners are the same if their
/// coordinates are.
pub(super) fn first(vertices: &[Point], triangles: &[[u32; 3]]) -> Option<[usize; 2]> {
    let place = |t: &[u32; 3]| t.map(|v| vertices[v as usize].map(|c| c + 0.0));
    let places: Vec<Triangle> = triangles.iter().map(place).collect();
    let bounds: Vec<[Point; 2]> = places.iter().map(bound).collect();
    // A sweep along the longest extent.
    let extent = |axis: usize| {
        let low = bounds
            .iter()
            .map(|b| b[0][axis])
            .fold(f64::INFINITY, f64::min);
        bounds
            .iter()
            .map(|b| b[1][axis])
            .fold(f64::NEG_INFINITY, f64::max)
            - low
    };
    let axis = (0..3).max_by(|&a, &b| extent(a).total_cmp(&extent(b)))?;
    let mut order: Vec<usize> = (0..places.len()).collect();
    order.sort_by(|&a, &b| bounds[a][0][axis].total_cmp(&bounds[b][0][axis]));
    let mut active: Vec<usize> = Vec::new();
    for t in order {
        active.retain(|&other| bounds[other][1][axis] >= bounds[t][0][axis]);
        for &other in &active {
            if overlap(&bounds[t], &bounds[other]) && is_wrong(&places[t], &places[other]) {
                return Some([t.min(other), t.max(other)]);
            }
        }
        active.push(t);
    }
    None
}

fn bound(triangle: &Triangle) -> [Point; 2] {
    let [a, b, c] = triangle;
    let by = |pick: fn(f64, f64) -> f64| [0, 1, 2].map(|k| pick(pick(a[k], b[k]), c[k]));
    [by(f64::min), by(f64::max)]
}

fn overlap(a: &[Point; 2], b: &[Point; 2]) -> bool {
    (0..3).all(|k| a[0][k] <= b[1][k] && b[0][k] <= a[1][k])
}

/// Whether two triangles have more in common than a corner or an edge.
fn is_wrong(s: &Triangle, t: &Triangle) -> bool {
    let is_same = |p: &Point, q: &Point| p.map(f64::to_bits) == q.map(f64::to_bits);
    let pairs = (0..3).flat_map(|i| (0..3).map(move |j| [i, j]));
    let common: Vec<[usize; 2]> = pairs.filter(|&[i, j]| is_same(&s[i], &t[j])).collect();
    let corners = |side: usize| {
        common.iter().fold([false; 3], |mut is_common, pair| {
            is_common[pair[side]] = true;
            is_common
        })
    };
    if common.len() == 3 {
        return true;
    }
    if is_beside(s, corners(0), t) || is_beside(t, corners(1), s) {
        return false;
    }
    match common[..] {
        [] => edges(s).any(|e| meets(e, t)) || edges(t).any(|e| meets(e, s)),
        // From the corner, what they have in common ends at an edge opposite to it, or nowhere.
        [[i, j]] => meets(opposite(s, i), t) || meets(opposite(t, j), s),
        [[i, j], [k, l]] => folded([s[i], s[k]], s[3 - i - k], t[3 - j - l]),
        _ => true,
    }
}

/// Whether a triangle lies on one side of the plane of another, but for common corners.
fn is_beside(s: &Triangle, is_common: [bool; 3], t: &Triangle) -> bool {
    let &[a, b, c] = t;
    let others = || {
        (0..3)
            .filter(|&k| !is_common[k])
            .map(|k| side(a, b, c, s[k]))
    };
    others().all(|x| x > 0.0) || others().all(|x| x < 0.0)
}

fn edges(t: &Triangle) -> impl Iterator<Item = [Point; 2]> {
    let t = *t;
    (0..3).map(move |k| [t[k], t[(k + 1) % 3]])
}

const fn opposite(t: &Triangle, k: usize) -> [Point; 2] {
    [t[(k + 1) % 3], t[(k + 2) % 3]]
}

/// Whether triangles on a common edge lie in one plane and on one side of it.
fn folded([a, b]: [Point; 2], p: Point, q: Point) -> bool {
    if side(a, b, p, q) != 0.0 {
        return false;
    }
    let [i, j] = shadow(&[a, b, p]);
    let turn = |r: Point| orientation([a[i], a[j]], [b[i], b[j]], [r[i], r[j]]);
    turn(p) * turn(q).signum() > 0.0
}

/// Two axes such that the triangle, seen along the third, has an area.
fn shadow(t: &Triangle) -> [usize; 2] {
    let axes = [[0, 1], [1, 2], [2, 0]];
    let has_area = |&[i, j]: &[usize; 2]| {
        let [a, b, c] = t.map(|p| [p[i], p[j]]);
        orientation(a, b, c) != 0.0
    };
    axes.into_iter().find(has_area).unwrap_or([0, 1])
}

/// Whether a segment and a triangle have a point in common.
fn meets([p, q]: [Point; 2], t: &Triangle) -> bool {
    let &[a, b, c] = t;
    let [s, r] = [p, q].map(|x| side(a, b, c, x));
    if (s > 0.0 && r > 0.0) || (s < 0.0 && r < 0.0) {
        return false;
    }
    if s == 0.0 && r == 0.0 {
        let [i, j] = shadow(t);
        let flat = |x: Point| [x[i], x[j]];
        return meets_flat([flat(p), flat(q)], t.map(flat));
    }
    let turns = [side(p, q, a, b), side(p, q, b, c), side(p, q, c, a)];
    turns.iter().all(|&x| x >= 0.0) || turns.iter().all(|&x| x <= 0.0)
}

fn meets_flat([p, q]: [[f64; 2]; 2], t: [[f64; 2]; 3]) -> bool {
    let sign = orientation(t[0], t[1], t[2]).signum();
    let is_inside =
        |x: [f64; 2]| (0..3).all(|k| sign * orientation(t[k], t[(k + 1) % 3], x) >= 0.0);
    is_inside(p) || is_inside(q) || (0..3).any(|k| cross([p, q], [t[k], t[(k + 1) % 3]]))
}

/// Whether two segments of a plane have a point in common.
fn cross([a, b]: [[f64; 2]; 2], [c, d]: [[f64; 2]; 2]) -> bool {
    let apart = |x: f64, y: f64| (x > 0.0 && y > 0.0) || (x < 0.0 && y < 0.0);
    let [e, f] = [orientation(a, b, c), orientation(a, b, d)];
    let [g, h] = [orientation(c, d, a), orientation(c, d, b)];
    if [e, f, g, h].iter().all(|&x| x == 0.0) {
        return (0..2)
            .all(|k| a[k].min(b[k]) <= c[k].max(d[k]) && c[k].min(d[k]) <= a[k].max(b[k]));
    }
    !apart(e, f) && !apart(g, h)
}
