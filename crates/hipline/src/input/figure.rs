//! The checked planar straight-line graph.

use super::Mesh;
use crate::topology::VertexId;

/// A planar straight-line graph: distinct vertices, edges that meet in vertices only.
///
/// Made by [`FigureBuilder`](super::FigureBuilder) or [`Polygon`](super::Polygon); the
/// engines take nothing else. Every vertex has at least one edge.
#[derive(Debug, Clone)]
pub struct Figure {
    pub(super) vertices: Vec<[f64; 2]>,
    pub(super) edges: Vec<Edge>,
    pub(super) terminals: usize,
    pub(super) has_polygon: bool,
    pub(super) mesh: Mesh,
}

/// One edge of a [`Figure`], directed as the caller gave it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Edge {
    /// Where it starts.
    pub from: VertexId,
    /// Where it ends.
    pub to: VertexId,
    /// The speeds (multiplicative weights, > 0) of the wavefront on its left and on its
    /// right, in input units per unit of time.
    pub speeds: [f64; 2],
    /// The caller's name for it.
    pub source: Source,
    /// Whether it belongs to a polygon's ring (and not to a line).
    pub on_ring: bool,
}

/// The caller's name for an edge.
///
/// An edge on whose inside a vertex of another part lies is split there; both halves
/// have the same source.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Source {
    /// Which polygon, line or graph, in the order of the calls to the builder.
    pub part: u32,
    /// Which ring of a polygon (0 is the shell); 0 for lines and graphs.
    pub ring: u32,
    /// Which edge: of a ring or line, the one from its vertex of that number to the next;
    /// of a graph, the number in its list of edges.
    pub edge: u32,
}

impl Figure {
    /// The vertices, each an `[x, y]` exactly as given, distinct.
    #[must_use]
    pub fn vertices(&self) -> &[[f64; 2]] {
        &self.vertices
    }

    /// The edges.
    #[must_use]
    pub fn edges(&self) -> &[Edge] {
        &self.edges
    }

    /// The edges, to give them other speeds.
    pub(crate) fn edges_mut(&mut self) -> &mut [Edge] {
        &mut self.edges
    }

    /// The number of terminals: vertices of degree one.
    #[must_use]
    pub const fn terminals(&self) -> usize {
        self.terminals
    }

    /// Whether there is a polygon in it, so that "interior" means something.
    #[must_use]
    pub const fn has_polygon(&self) -> bool {
        self.has_polygon
    }

    /// The triangulation of the vertices that has every edge of the figure in it.
    pub(crate) const fn mesh(&self) -> &Mesh {
        &self.mesh
    }
}
