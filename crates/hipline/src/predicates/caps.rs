//! Caps: the wavefront edges that modified skeletons have at acute angles (Aichholzer & Aurenhammer
//! 1996, section 5).
//!
//! In the modified skeleton each edge is a figure of its own, and sends out a rectangle. At a vertex, two
//! sides of that rectangle are those of the edge's ordinary wavefront, and the third one,
//! perpendicular to it, is its *cap*, on the plane that a terminal would have there. Picture the
//! edges drawn back from the vertex by as good as nothing, and let the rectangles stop where they
//! meet. In a sector of more than 270 degrees, outside of an acute angle, the outer halves of two
//! caps are left over: the wavefront turns right into the cap of the edge that it came along, left into the
//! other one, and right again. Hence:
//!
//! * Four arcs start at an acute angle in place of two: one inside of it, three outside.
//! * A vertex has caps if all its edges lie within less than 90 degrees: then two, of the
//!   two outermost edges. The caps of those in between stay behind these.
//! * No reflex vertex of the wavefront has more than 270 degrees at the start, and so none is ever
//!   faster than the square root of two: where reflex vertices meet, what each has swept takes at least
//!   90 degrees, so that no more than 180 are left for a new one.
//!
//! # Departure
//! Taken at its word, "its own rectangular wavefront" would change obtuse angles, too: the corner of a
//! rectangle, at 135 degrees from its edge, reaches a little beyond the side of the other edge's, and at
//! vertices of several edges that of one may come out between two others. But the paper
//! says that both structures are identical without acute angles, that an acute one has four arcs, and that the
//! bound of the speed is what it is for. These three together are the definition
//! here: sectors of up to 270 degrees, where the bound holds anyway, are left as they are.

use super::{Terminal, orientation};
use crate::input::Figure;
use dashu_int::IBig;
use hipline_num::{Ball, Number, Sign, common_unit, in_units};

/// The caps of a figure's modified skeleton, in the order of their vertices: two at each vertex that has
/// any. The wide sector goes counterclockwise from the first one's edge to the second one's.
///
/// O(n).
pub(super) fn caps(figure: &Figure) -> Vec<Terminal> {
    let vertices = figure.vertices();
    let mut first = vec![0_usize; vertices.len() + 1];
    for v in figure.edges().iter().flat_map(|edge| [edge.from, edge.to]) {
        first[v.index() + 1] += 1;
    }
    for v in 0..vertices.len() {
        first[v + 1] += first[v];
    }
    let mut fill = first.clone();
    let mut ends = vec![[0_usize; 2]; 2 * figure.edges().len()];
    for (e, edge) in figure.edges().iter().enumerate() {
        for (tip, inner) in [(edge.from, edge.to), (edge.to, edge.from)] {
            let slot = &mut fill[tip.index()];
            ends[*slot] = [e, inner.index()];
            *slot += 1;
        }
    }
    let mut list = Vec::new();
    for tip in 0..vertices.len() {
        let around = &ends[first[tip]..first[tip + 1]];
        if let Some(outermost) = outermost(vertices, tip, around) {
            list.extend(outermost.map(|[edge, inner]| Terminal {
                tip,
                inner,
                edge,
                speed: 1.0,
            }));
        }
    }
    list
}

/// The two outermost of the edges at a vertex, each given with its other end, if all lie within less
/// than 90 degrees: the last one and the first one counterclockwise.
fn outermost(vertices: &[[f64; 2]], tip: usize, around: &[[usize; 2]]) -> Option<[[usize; 2]; 2]> {
    let (&start, others) = around.split_first()?;
    let is_acute = |a: [usize; 2], b: [usize; 2]| is_acute([tip, a[1], b[1]].map(|v| vertices[v]));
    // Edges less than 90 degrees from one are in a half-plane: a turn between two of them orders them.
    if others.is_empty() || !others.iter().all(|&end| is_acute(start, end)) {
        return None;
    }
    let is_left_of = |a: [usize; 2], b: [usize; 2]| {
        orientation([tip, b[1], a[1]].map(|v| Ok(vertices[v]))) == Sign::Positive
    };
    let [mut last, mut first] = [start; 2];
    for &end in others {
        if is_left_of(end, last) {
            last = end;
        }
        if is_left_of(first, end) {
            first = end;
        }
    }
    is_acute(last, first).then_some([last, first])
}

/// Whether the angle at the first of three points, between the others, is below 90 degrees. Exact.
fn is_acute([v, p, q]: [[f64; 2]; 3]) -> bool {
    let rough = |k: usize| {
        let [v, p, q] = [v[k], p[k], q[k]].map(Ball::from_f64);
        p.minus(&v).times(&q.minus(&v))
    };
    let sign = rough(0).plus(&rough(1)).sign();
    sign.unwrap_or_else(|| exact_dot(v, p, q)) == Sign::Positive
}

/// The sign of `(p - v) (q - v)`.
fn exact_dot(v: [f64; 2], p: [f64; 2], q: [f64; 2]) -> Sign {
    let (unit, _) = common_unit([v, p, q].into_iter().flatten());
    let [v, p, q] = [v, p, q].map(|point| point.map(|x| in_units(x, unit)));
    let product = |k: usize| (&p[k] - &v[k]) * (&q[k] - &v[k]);
    Sign::from((product(0) + product(1)).cmp(&IBig::ZERO))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn acute_is_decided_exactly() {
        let tiny = f64::MIN_POSITIVE;
        assert!(is_acute([[0.0, 0.0], [1.0, 0.0], [tiny, 1e300]]));
        assert!(!is_acute([[0.0, 0.0], [1.0, 0.0], [0.0, 1e300]]));
        assert!(!is_acute([[0.0, 0.0], [1.0, 0.0], [-tiny, 1e300]]));
        // What rounding the differences would hide.
        let next = 0.1_f64.next_up();
        assert!(is_acute([[0.1, 0.3], [1e17, 0.3], [next, 9e9]]));
        assert!(!is_acute([[0.1, 0.3], [1e17, 0.3], [0.1, 9e9]]));
    }
}
