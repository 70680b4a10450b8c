//! Triangles from one small boundary, by cutting off one ear after the other.
//!
//! Every ear has a positive area, exactly, and covers no other corner. A simple polygon always
//! has one (Meisters 1975); a boundary that rounding has made cross itself may run out of them, and
//! is refused.

use super::plane::orientation;
use smallvec::SmallVec;

/// Boundaries with more corners take the first proper ear instead of the best one.
const CHOOSY: usize = 12;

/// Triangulates a boundary that is counterclockwise, and appends the triangles. If that cannot be
/// done, appends nothing and says so.
pub(super) fn cut(
    boundary: &[u32],
    point: &impl Fn(u32) -> [f64; 2],
    triangles: &mut Vec<[u32; 3]>,
) -> bool {
    if let &[a, b, c] = boundary {
        let is_fine = orientation(point(a), point(b), point(c)) > 0.0;
        if is_fine {
            triangles.push([a, b, c]);
        }
        return is_fine;
    }
    if let &[a, b, c, d] = boundary {
        return quadrilateral([a, b, c, d], point, triangles);
    }
    let before = triangles.len();
    let mut ring: Vec<(u32, [f64; 2])> = boundary.iter().map(|&v| (v, point(v))).collect();
    // What is an ear stays one, and as round, as long as its neighbours stay.
    let mut known: SmallVec<[Option<f64>; CHOOSY]> = SmallVec::new();
    let mut from = 0;
    while ring.len() > 3 {
        let n = ring.len();
        let mut best: Option<(f64, usize)> = None;
        if n <= CHOOSY {
            known.resize(n, None);
        }
        for step in 0..n {
            let k = (from + step) % n;
            let old = known.get(k).copied().flatten();
            let Some(roundness) = old.or_else(|| roundness(&ring, k)) else {
                continue;
            };
            if best.is_none_or(|(other, _)| roundness > other) {
                best = Some((roundness, k));
            }
            if n > CHOOSY {
                break;
            }
            known[k] = Some(roundness);
        }
        let Some((_, k)) = best else {
            triangles.truncate(before);
            return false;
        };
        let [prev, next] = [(k + n - 1) % n, (k + 1) % n];
        triangles.push([ring[prev].0, ring[k].0, ring[next].0]);
        ring.remove(k);
        if n <= CHOOSY {
            known[prev] = None;
            known[next] = None;
            known.remove(k);
        }
        // The next one far from this one, lest all triangles share a corner.
        from = (k + 1) % (n - 1);
    }
    let is_fine = ring.len() == 3 && orientation(ring[0].1, ring[1].1, ring[2].1) > 0.0;
    if is_fine {
        triangles.push([ring[0].0, ring[1].0, ring[2].0]);
    } else {
        triangles.truncate(before);
    }
    is_fine
}

/// The diagonal that leaves two triangles of positive area; if both do, the shorter one.
fn quadrilateral(
    [a, b, c, d]: [u32; 4],
    point: &impl Fn(u32) -> [f64; 2],
    triangles: &mut Vec<[u32; 3]>,
) -> bool {
    let [p, q, r, s] = [a, b, c, d].map(point);
    let by_ac = orientation(p, q, r) > 0.0 && orientation(p, r, s) > 0.0;
    let by_bd = orientation(q, r, s) > 0.0 && orientation(q, s, p) > 0.0;
    if by_ac && !(by_bd && square(q, s) < square(p, r)) {
        triangles.extend([[a, b, c], [a, c, d]]);
    } else if by_bd {
        triangles.extend([[b, c, d], [b, d, a]]);
    }
    by_ac || by_bd
}

fn square(p: [f64; 2], q: [f64; 2]) -> f64 {
    (p[0] - q[0]) * (p[0] - q[0]) + (p[1] - q[1]) * (p[1] - q[1])
}

/// Area over the squares of the sides, which is how far from a needle the ear at a corner is;
/// none if it is no ear.
fn roundness(ring: &[(u32, [f64; 2])], k: usize) -> Option<f64> {
    let n = ring.len();
    let corners = [(k + n - 1) % n, k, (k + 1) % n];
    let [a, b, c] = corners.map(|i| ring[i].1);
    let area = orientation(a, b, c);
    if area <= 0.0 {
        return None;
    }
    let low = [0, 1].map(|i| a[i].min(b[i]).min(c[i]));
    let high = [0, 1].map(|i| a[i].max(b[i]).max(c[i]));
    let covers = |p: [f64; 2]| {
        (0..2).all(|i| low[i] <= p[i] && p[i] <= high[i])
            && [a, b, c]
                .iter()
                .all(|q| q.map(f64::to_bits) != p.map(f64::to_bits))
            && orientation(a, b, p) >= 0.0
            && orientation(b, c, p) >= 0.0
            && orientation(c, a, p) >= 0.0
    };
    let is_covering = (0..n).any(|i| !corners.contains(&i) && covers(ring[i].1));
    (!is_covering).then(|| area / (square(a, b) + square(b, c) + square(c, a)))
}
