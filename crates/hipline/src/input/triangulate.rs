//! A constrained Delaunay triangulation of the figure, by the crate spade.
//!
//! Spade's predicates are exact (Shewchuk's), so what comes out is a triangulation and not
//! nearly one. Vertices go in one by one in the order of [`insertion_order`]: spade's own
//! bulk load sorts by distance from the centre, which is slow for points on a circle.

use std::collections::HashMap;

use spade::{
    ConstrainedDelaunayTriangulation, LastUsedVertexHintGenerator, Point2, Triangulation,
    handles::FixedVertexHandle,
};

use super::{Edge, Mesh, collinear, convert::convert, order::insertion_order, range::Scale};
use crate::topology::VertexId;

/// Spade's triangulation with the least data on it.
pub(super) type Cdt =
    ConstrainedDelaunayTriangulation<Point2<f64>, (), (), (), LastUsedVertexHintGenerator>;

/// No edge of the figure.
pub(super) const NONE: u32 = u32::MAX;

/// Why there is no triangulation: some edges cross or overlap.
pub(super) enum Conflicts {
    /// All vertices are on one line; these pairs of edges overlap.
    Collinear(collinear::Overlaps),
    /// The triangulation with all edges but those in the way.
    Crossed(Box<Crossed>),
}

/// A triangulation that some edges did not fit into.
pub(super) struct Crossed {
    /// With the edges that fitted.
    pub cdt: Cdt,
    /// Spade's handle of each vertex.
    pub handles: Vec<FixedVertexHandle>,
    /// The edge of the figure on each undirected edge of spade's, or [`NONE`].
    pub owners: Vec<u32>,
    /// Further edges of the figure on spade's edges: they overlap the owner.
    pub extras: HashMap<usize, Vec<u32>>,
    /// Edges that cross an edge that came earlier.
    pub rejected: Vec<u32>,
}

/// Triangulates, and splits edges at vertices on their insides: the first part keeps the
/// number of the edge, further parts come at the end of the list.
///
/// # Errors
/// If any two edges cross or overlap; then no edge is split.
pub(super) fn triangulate(
    vertices: &[[f64; 2]],
    edges: &mut Vec<Edge>,
    scale: Scale,
) -> Result<Mesh, Conflicts> {
    let points = |vertex: u32| scale.apply(vertices[vertex as usize]);
    let mut order = insertion_order(vertices);
    // Spade is slow as long as all vertices are on one line, so begin with a triangle.
    let Some(apex) = first_off_line(&order, points) else {
        return collinear::mesh(vertices, edges).map_err(Conflicts::Collinear);
    };
    order[2..=apex].rotate_right(1);

    let count = vertices.len();
    let mut cdt = Cdt::with_capacity(count, 3 * count, 2 * count);
    let mut handles = vec![FixedVertexHandle::from_index(0); count];
    for &vertex in &order {
        let [x, y] = points(vertex);
        handles[vertex as usize] = cdt
            .insert(Point2::new(x, y))
            .expect("scaled coordinates are in spade's range");
    }
    debug_assert_eq!(cdt.num_vertices(), count, "vertices are distinct");

    let mut owners = vec![NONE; cdt.num_undirected_edges()];
    let mut extras = HashMap::<usize, Vec<u32>>::new();
    let mut rejected = Vec::new();
    let mut split = Vec::new();
    for (index, edge) in edges.iter().enumerate() {
        let pieces = cdt.try_add_constraint(handles[edge.from.index()], handles[edge.to.index()]);
        if pieces.is_empty() {
            rejected.push(index as u32);
            continue;
        }
        for piece in &pieces {
            let piece = piece.as_undirected().index();
            if owners[piece] == NONE {
                owners[piece] = index as u32;
            } else {
                extras.entry(piece).or_default().push(index as u32);
            }
        }
        if pieces.len() > 1 {
            split.push((index, pieces));
        }
    }
    if !(rejected.is_empty() && extras.is_empty()) {
        return Err(Conflicts::Crossed(Box::new(Crossed {
            cdt,
            handles,
            owners,
            extras,
            rejected,
        })));
    }
    drop(handles);

    for (index, pieces) in split {
        let whole = edges[index];
        for (k, piece) in pieces.into_iter().enumerate() {
            let ends = cdt
                .directed_edge(piece)
                .vertices()
                .map(|end| VertexId::new(order[end.index()] as usize));
            let part = Edge {
                from: ends[0],
                to: ends[1],
                ..whole
            };
            if k == 0 {
                edges[index] = part;
            } else {
                owners[piece.as_undirected().index()] = edges.len() as u32;
                edges.push(part);
            }
        }
    }
    Ok(convert(&cdt, &order, &owners))
}

/// The position in the order of the first vertex that is not on the line of the first two.
fn first_off_line(order: &[u32], points: impl Fn(u32) -> [f64; 2]) -> Option<usize> {
    let [first, second, ..] = *order else {
        return None;
    };
    let [first, second] = [first, second].map(|vertex| coord(points(vertex)));
    (2..order.len()).find(|&k| robust::orient2d(first, second, coord(points(order[k]))) != 0.0)
}

/// A point for the predicates.
pub(super) fn coord([x, y]: [f64; 2]) -> robust::Coord<f64> {
    robust::Coord { x, y }
}
