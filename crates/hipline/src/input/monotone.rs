//! Monotone rings: found and checked in linear time, without a triangulation.
//!
//! A ring is monotone in a direction if every line across that direction (a *level*) meets it in at most two
//! points or segments. Seen along the direction, from west to east, it has a lower and
//! an upper chain, so that walking along both at once shows whether it is simple.
//!
//! The directions are found as by Preparata and Supowit (Testing a simple polygon for
//! monotonicity, 1981), from the edges' directions alone. Let the angle of the edge's direction go
//! continuously along the ring; it grows by 360 degrees in all. A level's direction is good if
//! the angle passes it once, going up, and passes its opposite once. What is passed once lies between the
//! largest angle so far and the smallest that is still to come, which a stack finds in one pass. Departures:
//!
//! * The paper asks for strict monotonicity; here a ring may have edges along the levels.
//! * Angles are quarter turns and an edge; within a quarter, the turn of two edges decides.
//! * The paper trusts that the polygon is simple; here that is checked, and where there is any doubt (a vertex
//!   touches an edge, edges overlap, the ring goes back along a level) the answer is no, because
//!   the general check knows what to make of that.

use std::cmp::Ordering;

use hipline_num::Sign;
use robust::orient2d;

use super::{range::Scale, triangulate::coord};
use crate::{predicates::turn, topology::VertexId};

/// A simple ring that is monotone in some direction; edge i goes from vertex i to the next one.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Monotone {
    /// Two points, the second one north of the first: the direction of the levels. East is to the
    /// right of it. (An axis, if the ring is monotone in the direction of one.)
    pub across: [[f64; 2]; 2],
    /// Whether the ring goes counterclockwise.
    pub counterclockwise: bool,
    /// The ends of the ring's stretch on the level furthest west, counterclockwise (so from north to south);
    /// often one vertex twice.
    pub west: [VertexId; 2],
    /// The ends of its stretch on the level furthest east, counterclockwise (so from south to north).
    pub east: [VertexId; 2],
}

/// Finds a direction in which a ring of distinct neighbours is monotone, and checks that the ring is
/// simple. The x axis is preferred, then the y axis.
///
/// # Complexity
/// O(n). A ring that is not monotone is left as soon as that is known of the axes, and after one pass over the
/// edges for all other directions.
pub(super) fn monotone(points: &[[f64; 2]], scale: Scale) -> Option<Monotone> {
    let ring = Ring { points, scale };
    if points.len() < 3 {
        return None;
    }
    if let Some(turns) = ring.turning_points(|[p, q]| q[0].total_cmp(&p[0])) {
        return ring.check(turns, [[0.0, 0.0], [0.0, 1.0]], Some(0));
    }
    if let Some(turns) = ring.turning_points(|[p, q]| q[1].total_cmp(&p[1])) {
        return ring.check(turns, [[0.0, 0.0], [-1.0, 0.0]], Some(1));
    }
    let across = super::directions::level(points, scale)?;
    let turns = ring.turning_points(|edge| turn(edge, across).cmp(&Sign::Zero))?;
    ring.check(turns, across, None)
}

#[derive(Clone, Copy)]
struct Ring<'a> {
    points: &'a [[f64; 2]],
    scale: Scale,
}

/// Which vertices of a ring are furthest west, and which are furthest east, in the ring's own order.
struct TurningPoints {
    west: [usize; 2],
    east: [usize; 2],
}

impl Ring<'_> {
    fn point(&self, vertex: usize) -> [f64; 2] {
        // There is only one zero.
        self.scale.apply(self.points[vertex]).map(|x| x + 0.0)
    }

    fn next(&self, vertex: usize) -> usize {
        if vertex + 1 == self.points.len() {
            0
        } else {
            vertex + 1
        }
    }

    /// The vertices where the ring turns from westward to eastward and back, if that happens once each.
    /// Edges along the levels count as neither.
    fn turning_points(
        &self,
        eastward: impl Fn([[f64; 2]; 2]) -> Ordering,
    ) -> Option<TurningPoints> {
        let n = self.points.len();
        let heading = |i: usize| eastward([self.point(i), self.point(self.next(i))]);
        let first = (0..n).find(|&i| heading(i).is_ne())?;
        let mut west = None;
        let mut east = None;
        let mut last = first;
        let mut before = heading(first);
        for k in first + 1..=first + n {
            let i = if k < n { k } else { k - n };
            let now = heading(i);
            if now.is_eq() {
                continue;
            }
            if now != before {
                let run = [self.next(last), i];
                let place = if now.is_gt() { &mut west } else { &mut east };
                if place.replace(run).is_some() {
                    return None;
                }
            }
            before = now;
            last = i;
        }
        Some(TurningPoints {
            west: west?,
            east: east?,
        })
    }

    /// Checks that the ring is simple; it is monotone across the levels.
    fn check(
        self,
        turns: TurningPoints,
        across: [[f64; 2]; 2],
        axis: Option<usize>,
    ) -> Option<Monotone> {
        let TurningPoints { west, east } = turns;
        let n = self.points.len();
        let sweep = Sweep {
            ring: self,
            across,
            axis,
        };
        let counterclockwise = match sweep.north(west[0], west[1])? {
            Ordering::Equal => {
                let before = (west[0] + n - 1) % n;
                let [a, b, c] = [before, west[0], self.next(west[0])].map(|v| coord(self.point(v)));
                let side = orient2d(a, b, c);
                if side == 0.0 {
                    return None;
                }
                side > 0.0
            }
            order => order.is_gt(),
        };
        let (west, east) = if counterclockwise {
            (west, east)
        } else {
            ([west[1], west[0]], [east[1], east[0]])
        };
        sweep.chains_are_apart(Chains {
            lower: Chain::new(n, west[1], east[0], counterclockwise),
            upper: Chain::new(n, west[0], east[1], !counterclockwise),
            walls: [
                Chain::new(n, west[0], west[1], counterclockwise),
                Chain::new(n, east[0], east[1], counterclockwise),
            ],
        })?;
        Some(Monotone {
            across,
            counterclockwise,
            west: west.map(VertexId::new),
            east: east.map(VertexId::new),
        })
    }
}

/// A stretch of a ring, with vertices numbered from 0 to `len`.
struct Chain {
    n: usize,
    first: usize,
    len: usize,
    forward: bool,
}

impl Chain {
    const fn new(n: usize, first: usize, last: usize, forward: bool) -> Self {
        let len = if forward {
            (last + n - first) % n
        } else {
            (first + n - last) % n
        };
        Self {
            n,
            first,
            len,
            forward,
        }
    }

    /// The vertex of the ring.
    const fn vertex(&self, k: usize) -> usize {
        if self.forward {
            let v = self.first + k;
            if v < self.n { v } else { v - self.n }
        } else if k <= self.first {
            self.first - k
        } else {
            self.first + self.n - k
        }
    }
}

struct Chains {
    /// Both from west to east.
    lower: Chain,
    upper: Chain,
    /// The stretches on the outermost levels.
    walls: [Chain; 2],
}

/// Which of two chains.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Which {
    Lower,
    Upper,
}

struct Sweep<'a> {
    ring: Ring<'a>,
    across: [[f64; 2]; 2],
    /// The coordinate that grows towards east, if there is one.
    axis: Option<usize>,
}

impl Sweep<'_> {
    /// Compares two vertices from west to east.
    fn east(&self, v: usize, w: usize) -> Ordering {
        let [p, q] = [v, w].map(|v| self.ring.point(v));
        match self.axis {
            Some(axis) => p[axis].total_cmp(&q[axis]),
            None => turn([q, p], self.across).cmp(&Sign::Zero),
        }
    }

    /// Compares two vertices on one level from south to north; nothing if they are equal, but
    /// not the same.
    fn north(&self, v: usize, w: usize) -> Option<Ordering> {
        if v == w {
            return Some(Ordering::Equal);
        }
        let [p, q] = [v, w].map(|v| self.ring.point(v));
        let [from, to] = self.across;
        // On one level, one coordinate tells.
        let axis = usize::from(from[1].total_cmp(&to[1]).is_ne());
        let order = p[axis].total_cmp(&q[axis]);
        let order = if from[axis] < to[axis] {
            order
        } else {
            order.reverse()
        };
        order.is_ne().then_some(order)
    }

    /// Walks along both chains at once, level by level.
    fn chains_are_apart(&self, chains: Chains) -> Option<()> {
        for wall in &chains.walls {
            self.stretch(wall, 0, wall.len)?;
        }
        let Chains { lower, upper, .. } = chains;
        let (mut l, mut u) = (0, 0);
        loop {
            let [low, high] = [lower.vertex(l + 1), upper.vertex(u + 1)];
            match self.east(low, high) {
                Ordering::Less => {
                    let last = self.end_of_level(&lower, l + 1);
                    let line = [upper.vertex(u), high];
                    self.beside(&lower, [l + 1, last], line, Which::Lower)?;
                    l = last;
                }
                Ordering::Greater => {
                    let last = self.end_of_level(&upper, u + 1);
                    let line = [lower.vertex(l), low];
                    self.beside(&upper, [u + 1, last], line, Which::Upper)?;
                    u = last;
                }
                Ordering::Equal if l + 1 == lower.len || u + 1 == upper.len => {
                    // The level furthest east.
                    let both = l + 1 == lower.len && u + 1 == upper.len;
                    let apart = low == high || self.north(low, high)?.is_lt();
                    return (both && apart).then_some(());
                }
                Ordering::Equal => {
                    let last = [
                        self.end_of_level(&lower, l + 1),
                        self.end_of_level(&upper, u + 1),
                    ];
                    self.stretch(&lower, l + 1, last[0])?;
                    self.stretch(&upper, u + 1, last[1])?;
                    for low in [l + 1, last[0]] {
                        for high in [u + 1, last[1]] {
                            let order = self.north(lower.vertex(low), upper.vertex(high))?;
                            order.is_lt().then_some(())?;
                        }
                    }
                    [l, u] = last;
                }
            }
        }
    }

    /// The last vertex of a chain on the level of another one.
    fn end_of_level(&self, chain: &Chain, first: usize) -> usize {
        let mut last = first;
        while last < chain.len
            && self
                .east(chain.vertex(last), chain.vertex(last + 1))
                .is_eq()
        {
            last += 1;
        }
        last
    }

    /// Checks that a stretch along a level does not go back.
    fn stretch(&self, chain: &Chain, first: usize, last: usize) -> Option<()> {
        let mut course = None;
        for k in first..last {
            let step = self.north(chain.vertex(k), chain.vertex(k + 1))?;
            (*course.get_or_insert(step) == step).then_some(())?;
        }
        Some(())
    }

    /// Checks that the vertices of one level lie strictly on their side of an edge of the other chain that
    /// passes them, from west to east.
    fn beside(
        &self,
        chain: &Chain,
        [first, last]: [usize; 2],
        line: [usize; 2],
        which: Which,
    ) -> Option<()> {
        self.stretch(chain, first, last)?;
        let [a, b] = line.map(|v| coord(self.ring.point(v)));
        let check = |k: usize| {
            let side = orient2d(a, b, coord(self.ring.point(chain.vertex(k))));
            let apart = match which {
                Which::Lower => side < 0.0,
                Which::Upper => side > 0.0,
            };
            apart.then_some(())
        };
        check(first)?;
        if last > first {
            check(last)?;
        }
        Some(())
    }
}
