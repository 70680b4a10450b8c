//! Areas and windings, measured in the plainest way: what offsets are held against.

use hipline::Skeleton;
use hipline::skeleton::NodeKind;
use hipline::topology::{FaceId, NodeId};

/// The area of a ring, positive if it is counterclockwise. Rounded.
#[must_use]
pub fn area(ring: &[[f64; 2]]) -> f64 {
    let Some(&[x, y]) = ring.first() else {
        return 0.0;
    };
    let next = ring.iter().skip(1).chain(ring.first());
    let cross = ring
        .iter()
        .zip(next)
        .map(|(p, q)| (p[0] - x) * (q[1] - y) - (q[0] - x) * (p[1] - y));
    cross.sum::<f64>() / 2.0
}

/// How often a ring goes around a point that is not near it.
#[must_use]
pub fn winding(ring: &[[f64; 2]], [x, y]: [f64; 2]) -> i32 {
    let mut around = 0;
    for (i, p) in ring.iter().enumerate() {
        let q = ring[(i + 1) % ring.len()];
        let is_left = (q[0] - p[0]) * (y - p[1]) - (x - p[0]) * (q[1] - p[1]);
        if p[1] <= y && q[1] > y && is_left > 0.0 {
            around += 1;
        } else if p[1] > y && q[1] <= y && is_left < 0.0 {
            around -= 1;
        }
    }
    around
}

/// The area swept until a time, from the faces clipped at that height one by one.
#[must_use]
pub fn swept(skeleton: &Skeleton, distance: f64) -> f64 {
    // Where the boundary passes the height between two nodes.
    let cut = |a: NodeId, b: NodeId| -> [f64; 2] {
        let (a, b) = (skeleton.node(a), skeleton.node(b));
        let (low, high) = if a.time < b.time { (a, b) } else { (b, a) };
        if let NodeKind::Infinite { direction } = high.kind {
            let t = distance - low.time;
            return [low.x + t * direction[0], low.y + t * direction[1]];
        }
        let t = (distance - low.time) / (high.time - low.time);
        [low.x + t * (high.x - low.x), low.y + t * (high.y - low.y)]
    };
    let cycle_area = |cycle: &[NodeId]| {
        let mut ring = Vec::new();
        for (i, &a) in cycle.iter().enumerate() {
            let b = cycle[(i + 1) % cycle.len()];
            let (t, u) = (skeleton.node(a).time, skeleton.node(b).time);
            if t <= distance {
                ring.push([skeleton.node(a).x, skeleton.node(a).y]);
            }
            if (t <= distance) != (u <= distance) {
                ring.push(cut(a, b));
            }
        }
        area(&ring)
    };
    let faces = (0..skeleton.faces().len()).map(FaceId::new);
    faces
        .map(|f| cycle_area(skeleton.boundary(f)) + skeleton.holes(f).map(cycle_area).sum::<f64>())
        .sum()
}
