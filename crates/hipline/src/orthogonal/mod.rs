//! Orthogonal monotone polygons in linear time (Eder, Held & Palfrader 2019).
//!
//! All edges are parallel to the axes, so all arcs have one of four directions and all
//! coordinates are sums of the input's, halved: integers in the right unit ([`number`]), without a logarithm and
//! without a root. The skeletons of the lower and of the upper chain grow by inserting
//! edges from west to east ([`chain`], section 2 of the paper); then a merge chain is drawn from west to east where they
//! meet ([`merge`], section 3), and what lies beyond it is forgotten. Polygons that are monotone in the direction of
//! the y axis are turned. Departures from the paper:
//!
//! * R and G are as there, but a wall that moves west is inserted together with the height of its top, instead of looking at
//!   slabs: in an orthogonal chain nothing else about what follows matters. The edge after it then finds where the wall's face was closed.
//! * Vertices of 180 degrees, which the paper leaves out. Between level edges they begin ghost arcs on G like those of
//!   two level edges whose wavefronts meet. Edges of one wall are inserted as one; their joint
//!   face is cut in the end ([`runs`]).
//! * A ghost arc that ends on an arc cuts it in two at once, so that every arc has one face on
//!   either side; the merge then needs to know nothing about joint faces.
//! * The paper treats one case in which the merge chain lies on an arc: between walls of both chains on one line. Here, the
//!   merge chain may run along arcs on the way to and from the ghost arc between the two faces, whose height is known from the edges
//!   at the mouth of the corridor (half way between them). So all cases with several nodes at one place come out of the same steps,
//!   even if a face is visited at one point only.
//! * The right chain of a face has three arcs at most, but for walls that move east. Only those are
//!   walked along by the x coordinate; that keeps the merge linear.
//! * A face that the merge chain touches in a node keeps its whole boundary, and nodes at one place become one
//!   ([`graph::Graph::same`]).

mod chain;
mod graph;
mod merge;
mod number;
mod result;
mod ring;
mod runs;

use crate::{
    engine::NotApplicable,
    input::{Figure, Monotone},
    skeleton::{Region, Skeleton},
    topology::EdgeId,
};
use graph::Graph;
use number::{Float, Number, Unit, Wide};
use ring::{Ring, Side};

/// Whether this engine applies to a figure: all edges parallel to the axes, all of speed 1, one ring that is monotone in the
/// direction of an axis, and only the inside asked for.
///
/// # Errors
/// The first reason why not.
pub(crate) fn applies(figure: &Figure, region: Region) -> Result<&Monotone, NotApplicable> {
    if let Some(monotone) = figure.monotone()
        && region == Region::Interior
        && figure.is_plain()
        && is_orthogonal(figure.vertices())
    {
        return Ok(monotone);
    }
    if region != Region::Interior {
        return Err(NotApplicable::NotInterior);
    }
    if figure.has_heights() {
        return Err(NotApplicable::Heights);
    }
    let one_ring = |source: crate::input::Source| source.part == 0 && source.ring == 0;
    let edges = figure.edges();
    if !(figure.has_polygon()
        && edges
            .iter()
            .all(|edge| edge.on_ring && one_ring(edge.source)))
    {
        return Err(NotApplicable::NotOneRing);
    }
    if let Some(change) = figure.changes().first() {
        return Err(NotApplicable::Speed { edge: change.edge });
    }
    for (e, edge) in edges.iter().enumerate() {
        let edge_id = EdgeId::new(e);
        let [p, q] = [edge.from, edge.to].map(|v| figure.vertices()[v.index()]);
        if p[0].to_bits() != q[0].to_bits() && p[1].to_bits() != q[1].to_bits() {
            return Err(NotApplicable::NotOrthogonal { edge: edge_id });
        }
        if edge.speeds.map(f64::to_bits) != [1.0_f64.to_bits(); 2] {
            return Err(NotApplicable::Speed { edge: edge_id });
        }
    }
    figure.monotone().ok_or(NotApplicable::NotMonotone)
}

/// Whether all edges of a ring are parallel to the axes.
fn is_orthogonal(ring: &[[f64; 2]]) -> bool {
    let parallel = |p: [f64; 2], q: [f64; 2]| (0..2).any(|k| p[k].to_bits() == q[k].to_bits());
    ring.windows(2).all(|pair| parallel(pair[0], pair[1]))
        && ring
            .first()
            .zip(ring.last())
            .is_some_and(|(&p, &q)| parallel(p, q))
}

/// The straight skeleton of the inside.
///
/// # Complexity
/// O(n) time and memory; [`Stats::steps`](crate::skeleton::Stats::steps) counts.
pub(crate) fn skeleton(figure: &Figure, monotone: &Monotone) -> Skeleton {
    if number::are_small_integers(figure.vertices()) {
        return compute::<Float>(figure, monotone, Unit::ONE);
    }
    let unit = Unit::of(figure.vertices());
    if unit.digits <= Float::DIGITS && unit.is_moderate {
        compute::<Float>(figure, monotone, unit)
    } else if unit.digits <= i64::DIGITS {
        compute::<i64>(figure, monotone, unit)
    } else if unit.digits <= i128::DIGITS {
        compute::<i128>(figure, monotone, unit)
    } else {
        assert!(
            unit.digits <= Wide::DIGITS,
            "the range of coordinates is checked"
        );
        compute::<Wide>(figure, monotone, unit)
    }
}

fn compute<N: Number>(figure: &Figure, monotone: &Monotone, unit: Unit) -> Skeleton {
    let mut graph = Graph::<N>::new(Ring::new(figure, monotone, unit));
    chain::grow(&mut graph, Side::Lower);
    chain::grow(&mut graph, Side::Upper);
    merge::merge(&mut graph);
    graph.shrink();
    result::skeleton(graph)
}

#[cfg(test)]
mod tests;
