//! Names the pairs of edges that cross or overlap, once the triangulation has shown that
//! there are any.
//!
//! The triangulation contains every edge but the rejected ones, and each of those crosses
//! one that it contains. So walking along the rejected edges finds all crossings but those
//! of two rejected edges, and those are looked for directly. A figure with few crossings
//! costs little more than a valid one, however its edges lie.

use robust::{Coord, orient2d};
use spade::{Intersection, LineIntersectionIterator};

use super::{
    Edge, Flaw, InvalidFigure, Place,
    range::Scale,
    triangulate::{Conflicts, Crossed, NONE, coord},
};

/// Reports all pairs of edges that cross or overlap, up to a limit.
///
/// # Panics
/// If there is none: then the triangulation rejected an edge for no reason.
pub(super) fn report(
    vertices: &[[f64; 2]],
    edges: &[Edge],
    scale: Scale,
    conflicts: Conflicts,
    flaws: &mut Vec<Flaw>,
) {
    let segments = Segments {
        vertices,
        edges,
        scale,
    };
    let (mut pairs, more) = match conflicts {
        Conflicts::Collinear(overlaps) => (overlaps.pairs, overlaps.more),
        Conflicts::Crossed(crossed) => segments.pairs(&crossed),
    };
    pairs.sort_unstable();
    pairs.dedup();
    assert!(
        !pairs.is_empty(),
        "an edge was rejected that crosses no other"
    );
    flaws.extend(pairs.into_iter().map(|pair| segments.flaw(pair)));
    if more > 0 {
        flaws.push(Flaw::MorePairs { at_least: more });
    }
}

/// What two edges have in common besides vertices.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Meeting {
    Nothing,
    Crossing,
    Overlap,
}

/// The edges as the caller gave them.
struct Segments<'a> {
    vertices: &'a [[f64; 2]],
    edges: &'a [Edge],
    scale: Scale,
}

impl Segments<'_> {
    fn points(&self, edge: u32) -> [[f64; 2]; 2] {
        let Edge { from, to, .. } = self.edges[edge as usize];
        [from, to].map(|end| self.vertices[end.index()])
    }

    fn ends(&self, edge: u32) -> [Coord<f64>; 2] {
        self.points(edge)
            .map(|point| coord(self.scale.apply(point)))
    }

    /// All pairs, and how many more there are at the least.
    fn pairs(&self, crossed: &Crossed) -> (Vec<[u32; 2]>, usize) {
        let limit = InvalidFigure::MAX_PAIRS;
        let mut pairs = Vec::new();
        let mut more = 0;
        let mut shared: Vec<_> = crossed.extras.iter().collect();
        shared.sort_unstable();
        for (&piece, extras) in shared {
            for (k, &edge) in extras.iter().enumerate() {
                if pairs.len() < limit {
                    let others = extras[..k].iter().chain([&crossed.owners[piece]]);
                    pairs.extend(others.map(|&other| ordered(edge, other)));
                } else {
                    more += 1;
                }
            }
        }
        // The vertices on the inside of each rejected edge.
        let mut passed = Vec::with_capacity(crossed.rejected.len());
        for (k, &edge) in crossed.rejected.iter().enumerate() {
            if pairs.len() >= limit {
                more += crossed.rejected.len() - k;
                break;
            }
            passed.push(self.walk(crossed, edge, &mut pairs));
        }
        if passed.len() == crossed.rejected.len() {
            self.rejected_pairs(&crossed.rejected, &passed, &mut pairs);
        }
        pairs.sort_unstable();
        pairs.dedup();
        more += pairs.len().saturating_sub(limit);
        pairs.truncate(limit);
        (pairs, more)
    }

    /// Walks along a rejected edge, collects what it crosses and overlaps, and returns the
    /// vertices (spade's numbers, sorted) that it passes through.
    fn walk(&self, crossed: &Crossed, edge: u32, pairs: &mut Vec<[u32; 2]>) -> Vec<usize> {
        let Edge { from, to, .. } = self.edges[edge as usize];
        let [from, to] = [from, to].map(|end| crossed.handles[end.index()]);
        let mut passed = Vec::new();
        for met in LineIntersectionIterator::new_from_handles(&crossed.cdt, from, to) {
            let piece = match met {
                Intersection::VertexIntersection(vertex) => {
                    if vertex.fix() != from && vertex.fix() != to {
                        passed.push(vertex.index());
                    }
                    continue;
                }
                Intersection::EdgeIntersection(piece) | Intersection::EdgeOverlap(piece) => piece,
            };
            let piece = piece.as_undirected().index();
            let owner = crossed.owners[piece];
            if owner != NONE {
                let extras = crossed.extras.get(&piece).into_iter().flatten();
                pairs.extend(extras.chain([&owner]).map(|&other| ordered(edge, other)));
            }
        }
        passed.sort_unstable();
        passed
    }

    /// The pairs of two rejected edges, by a sweep over their extents in x.
    fn rejected_pairs(&self, rejected: &[u32], passed: &[Vec<usize>], pairs: &mut Vec<[u32; 2]>) {
        let limit = pairs.len() + 2 * InvalidFigure::MAX_PAIRS;
        let mut boxes: Vec<([f64; 4], usize)> = rejected
            .iter()
            .enumerate()
            .map(|(k, &edge)| {
                let [a, b] = self.ends(edge);
                ([a.x.min(b.x), a.x.max(b.x), a.y.min(b.y), a.y.max(b.y)], k)
            })
            .collect();
        boxes.sort_unstable_by(|a, b| a.0[0].total_cmp(&b.0[0]).then(a.1.cmp(&b.1)));
        for (i, &([_, right, bottom, top], k)) in boxes.iter().enumerate() {
            let beside = boxes[i + 1..]
                .iter()
                .take_while(|other| other.0[0] <= right);
            for &([_, _, low, high], l) in beside {
                if low > top || high < bottom || pairs.len() >= limit {
                    continue;
                }
                let meeting = match self.meeting(rejected[k], rejected[l]) {
                    // Where a vertex is, edges may meet.
                    Meeting::Crossing if share(&passed[k], &passed[l]) => Meeting::Nothing,
                    meeting => meeting,
                };
                if meeting != Meeting::Nothing {
                    pairs.push(ordered(rejected[k], rejected[l]));
                }
            }
        }
    }

    /// Exact.
    fn meeting(&self, one: u32, other: u32) -> Meeting {
        let [a, b] = self.ends(one);
        let [c, d] = self.ends(other);
        let [c_side, d_side] = [orient2d(a, b, c), orient2d(a, b, d)];
        if c_side == 0.0 && d_side == 0.0 {
            let [from, to] = self.shared(one, other);
            return if from < to {
                Meeting::Overlap
            } else {
                Meeting::Nothing
            };
        }
        let apart = |s: f64, t: f64| s > 0.0 && t < 0.0 || s < 0.0 && t > 0.0;
        if apart(c_side, d_side) && apart(orient2d(c, d, a), orient2d(c, d, b)) {
            Meeting::Crossing
        } else {
            Meeting::Nothing
        }
    }

    /// The ends of what two edges on one line share, in lexicographic order if they share
    /// anything.
    fn shared(&self, one: u32, other: u32) -> [[f64; 2]; 2] {
        let sorted = |[a, b]: [[f64; 2]; 2]| if a < b { [a, b] } else { [b, a] };
        let [[a, b], [c, d]] = [one, other].map(|edge| sorted(self.points(edge)));
        [if a < c { c } else { a }, if b < d { b } else { d }]
    }

    fn flaw(&self, [one, other]: [u32; 2]) -> Flaw {
        let [first, second] = [one, other].map(|edge| {
            let source = self.edges[edge as usize].source;
            Place {
                part: source.part as usize,
                ring: source.ring as usize,
                index: source.edge as usize,
            }
        });
        if self.meeting(one, other) == Meeting::Overlap {
            let [from, to] = self.shared(one, other);
            return Flaw::EdgesOverlap {
                first,
                second,
                from,
                to,
            };
        }
        let [a, b] = self.ends(one);
        let [c, d] = self.ends(other);
        let [before, after] = [orient2d(c, d, a), orient2d(c, d, b)];
        let share = before / (before - after);
        let [[ax, ay], [bx, by]] = self.points(one);
        let near = [
            ax * (1.0 - share) + bx * share,
            ay * (1.0 - share) + by * share,
        ];
        Flaw::EdgesCross {
            first,
            second,
            near,
        }
    }
}

fn ordered(a: u32, b: u32) -> [u32; 2] {
    [a.min(b), a.max(b)]
}

/// Whether two sorted lists have an element in common.
fn share(a: &[usize], b: &[usize]) -> bool {
    a.iter().any(|x| b.binary_search(x).is_ok())
}
