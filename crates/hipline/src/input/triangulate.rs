//! A constrained triangulation of the figure.

use std::collections::HashMap;

use super::{
    Edge, Mesh, collinear,
    convert::convert,
    delaunay::{NONE, Triangulation},
    order::insertion_order,
    range::Scale,
};
use crate::topology::VertexId;

/// Why there is no triangulation: some edges cross or overlap.
pub(super) enum Conflicts<'a> {
    /// All vertices are on one line; these pairs of edges overlap.
    Collinear(collinear::Overlaps),
    /// The triangulation with all edges but those in the way.
    Crossed(Box<Crossed<'a>>),
}

/// A triangulation that some edges did not fit into.
pub(super) struct Crossed<'a> {
    /// With the edges that fitted.
    pub triangulation: Triangulation<'a>,
    /// Further edges of the figure on an edge of the triangulation, named by its ends:
    /// they overlap its owner.
    pub extras: HashMap<[u32; 2], Vec<u32>>,
    /// Edges that cross an edge that came earlier.
    pub rejected: Vec<u32>,
}

/// Triangulates, and splits edges at vertices on their insides: the first part keeps the
/// number of the edge, further parts come at the end of the list.
///
/// # Errors
/// If any two edges cross or overlap; then no edge is split.
pub(super) fn triangulate<'a>(
    vertices: &'a [[f64; 2]],
    edges: &mut Vec<Edge>,
    scale: Scale,
) -> Result<Mesh, Conflicts<'a>> {
    let mut order = insertion_order(vertices);
    let Some(apex) = first_off_line(vertices, &order, scale) else {
        return collinear::mesh(vertices, edges).map_err(Conflicts::Collinear);
    };
    order[2..=apex].rotate_right(1);
    let mut triangulation = Triangulation::new(vertices, scale, &order);
    drop(order);

    let mut extras = HashMap::<_, Vec<u32>>::new();
    let mut rejected = Vec::new();
    let mut split = Vec::new();
    for (index, edge) in edges.iter().enumerate() {
        let [from, to] = [edge.from, edge.to].map(|end| end.index() as u32);
        let index = index as u32;
        let mut claim = |triangulation: &mut Triangulation<'_>, h: u32| {
            if triangulation.owner[h as usize] == NONE {
                triangulation.own(h, index);
            } else {
                extras.entry(ends(triangulation, h)).or_default().push(index);
            }
        };
        if let Some(h) = triangulation.find(from, to) {
            claim(&mut triangulation, h);
        } else if let Some(passed) = triangulation.constrain(from, to) {
            for pair in passed.windows(2) {
                let piece = triangulation.find(pair[0], pair[1]).expect("the edge is there now");
                claim(&mut triangulation, piece);
            }
            if passed.len() > 2 {
                split.push((index, passed));
            }
        } else {
            rejected.push(index);
        }
    }
    if !(rejected.is_empty() && extras.is_empty()) {
        return Err(Conflicts::Crossed(Box::new(Crossed { triangulation, extras, rejected })));
    }
    for (index, passed) in split {
        let whole = edges[index as usize];
        for (k, pair) in passed.windows(2).enumerate() {
            let [from, to] = [pair[0], pair[1]].map(|vertex| VertexId::new(vertex as usize));
            let part = Edge { from, to, ..whole };
            if k == 0 {
                edges[index as usize] = part;
            } else {
                let piece = triangulation.find(pair[0], pair[1]).expect("edges with an owner stay");
                triangulation.own(piece, edges.len() as u32);
                edges.push(part);
            }
        }
    }
    Ok(convert(&triangulation))
}

/// The ends of an edge of the triangulation, in order of their numbers.
pub(super) fn ends(triangulation: &Triangulation<'_>, h: u32) -> [u32; 2] {
    let (from, to) = (triangulation.from(h), triangulation.to(h));
    [from.min(to), from.max(to)]
}

/// The position in the order of the first vertex that is not on the line of the first two.
fn first_off_line(vertices: &[[f64; 2]], order: &[u32], scale: Scale) -> Option<usize> {
    let point = |&vertex: &u32| coord(scale.apply(vertices[vertex as usize]));
    let [first, second, ..] = order else { return None };
    let [first, second] = [first, second].map(point);
    (2..order.len()).find(|&k| robust::orient2d(first, second, point(&order[k])) != 0.0)
}

/// A point for the predicates.
pub(super) fn coord([x, y]: [f64; 2]) -> robust::Coord<f64> {
    robust::Coord { x, y }
}
