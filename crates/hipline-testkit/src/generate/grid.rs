//! Exact tests on points of a small integer grid.

/// A point of the grid.
pub(super) type Point = [i64; 2];

/// Twice the signed area of a triangle.
pub(super) const fn area(p: Point, q: Point, r: Point) -> i64 {
    (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0])
}

/// Is `r` on the closed segment?
pub(super) fn is_on(segment: [Point; 2], r: Point) -> bool {
    let [p, q] = segment;
    area(p, q, r) == 0 && (0..2).all(|k| p[k].min(q[k]) <= r[k] && r[k] <= p[k].max(q[k]))
}

/// Have two closed segments any point in common?
pub(super) fn touch(a: [Point; 2], b: [Point; 2]) -> bool {
    a.iter().any(|&p| is_on(b, p)) || b.iter().any(|&p| is_on(a, p)) || cross(a, b)
}

/// Does each segment properly cross the line of the other?
pub(super) fn cross(a: [Point; 2], b: [Point; 2]) -> bool {
    let sides = |s: [Point; 2], t: [Point; 2]| {
        area(s[0], s[1], t[0]).signum() * area(s[0], s[1], t[1]).signum() < 0
    };
    sides(a, b) && sides(b, a)
}

/// Do two segments overlap in more than a point?
pub(super) fn overlap(a: [Point; 2], b: [Point; 2]) -> bool {
    let mut common: Vec<Point> = a.into_iter().filter(|&p| is_on(b, p)).collect();
    common.extend(b.into_iter().filter(|&p| is_on(a, p)));
    common.iter().any(|p| p != &common[0])
}

/// The edges of a ring.
pub(super) fn edges(ring: &[Point]) -> impl Iterator<Item = [Point; 2]> {
    (0..ring.len()).map(|i| [ring[i], ring[(i + 1) % ring.len()]])
}

/// Is a ring simple? (180 degree corners are fine.)
pub(super) fn is_simple(ring: &[Point]) -> bool {
    let n = ring.len();
    let all: Vec<[Point; 2]> = edges(ring).collect();
    let fine = |i: usize, j: usize| {
        if (i + 1) % n == j || (j + 1) % n == i {
            !overlap(all[i], all[j])
        } else {
            !touch(all[i], all[j])
        }
    };
    n >= 3 && edges(ring).all(|[p, q]| p != q) && (0..n).all(|i| (0..i).all(|j| fine(i, j)))
}

/// Do the boundaries of two rings keep clear of each other?
pub(super) fn apart(ring: &[Point], other: &[Point]) -> bool {
    edges(ring).all(|a| edges(other).all(|b| !touch(a, b)))
}

/// Is a point that is not on the ring inside it?
pub(super) fn contains(ring: &[Point], r: Point) -> bool {
    let crosses = |[p, q]: [Point; 2]| {
        let (low, high) = if p[1] <= q[1] { (p, q) } else { (q, p) };
        low[1] <= r[1] && r[1] < high[1] && area(low, high, r) > 0
    };
    edges(ring).filter(|&edge| crosses(edge)).count() % 2 == 1
}
