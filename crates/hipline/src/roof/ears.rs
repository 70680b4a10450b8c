//! Triangles from one closed boundary, by cutting off one ear after the other.
//!
//! Whatever the coordinates, n corners give n - 2 triangles, each edge of the boundary is in
//! one of them, and each other edge in two: so what was closed stays closed. Coordinates only
//! choose between such results. In a simple polygon there always is an ear of positive area
//! (Meisters 1975); rounded coordinates may leave a sliver without one, which is then cut
//! as well as possible.

use robust::{Coord, orient2d};

/// How good an ear is: better ones are larger.
#[derive(Clone, Copy, PartialEq, PartialOrd)]
struct Worth {
    /// 3: a proper ear. 2: it overlaps another corner. 1: flat. 0: folded over.
    rank: u8,
    /// Area over the squares of its sides: how far from a needle it is.
    roundness: f64,
}

/// Boundaries with more corners take the first proper ear instead of the best one.
const CHOOSY: usize = 64;

fn orientation(a: [f64; 2], b: [f64; 2], c: [f64; 2]) -> f64 {
    let [a, b, c] = [a, b, c].map(|[x, y]| Coord { x, y });
    orient2d(a, b, c)
}

/// Triangulates a boundary that is counterclockwise.
pub(super) fn cut(boundary: &[u32], point: &impl Fn(u32) -> [f64; 2]) -> Vec<[u32; 3]> {
    let mut ring = boundary.to_vec();
    let mut triangles = Vec::with_capacity(ring.len().saturating_sub(2));
    let mut from = 0;
    while ring.len() > 3 {
        let n = ring.len();
        let mut best = (
            Worth {
                rank: 0,
                roundness: f64::NEG_INFINITY,
            },
            0,
        );
        for step in 0..n {
            let k = (from + step) % n;
            let worth = worth(&ring, k, point);
            if worth > best.0 {
                best = (worth, k);
            }
            if worth.rank == 3 && n > CHOOSY {
                break;
            }
        }
        let k = best.1;
        triangles.push([ring[(k + n - 1) % n], ring[k], ring[(k + 1) % n]]);
        ring.remove(k);
        // The next one far from this one, lest all triangles share a corner.
        from = (k + 1) % (n - 1);
    }
    if let [a, b, c] = ring[..] {
        triangles.push([a, b, c]);
    }
    triangles
}

fn worth(ring: &[u32], k: usize, point: &impl Fn(u32) -> [f64; 2]) -> Worth {
    let n = ring.len();
    let corners = [(k + n - 1) % n, k, (k + 1) % n];
    let [a, b, c] = corners.map(|i| point(ring[i]));
    let area = orientation(a, b, c);
    let squares: f64 = [(a, b), (b, c), (c, a)]
        .iter()
        .map(|(p, q)| (p[0] - q[0]) * (p[0] - q[0]) + (p[1] - q[1]) * (p[1] - q[1]))
        .sum();
    let roundness = if squares > 0.0 { area / squares } else { 0.0 };
    if area <= 0.0 {
        return Worth {
            rank: u8::from(area >= 0.0),
            roundness,
        };
    }
    let covers = |p: [f64; 2]| {
        [a, b, c]
            .iter()
            .all(|q| q.map(f64::to_bits) != p.map(f64::to_bits))
            && orientation(a, b, p) >= 0.0
            && orientation(b, c, p) >= 0.0
            && orientation(c, a, p) >= 0.0
    };
    let covered = (0..n)
        .filter(|i| !corners.contains(i))
        .any(|i| covers(point(ring[i])));
    Worth {
        rank: if covered { 2 } else { 3 },
        roundness,
    }
}
