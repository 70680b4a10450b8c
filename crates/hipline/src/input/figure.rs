//! The checked planar straight-line graph.

use std::sync::OnceLock;

use super::{Mesh, Monotone, Place, SpeedChange, single};
use crate::topology::{EdgeId, VertexId};

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
    pub(super) changes: Vec<SpeedChange>,
    /// By vertex; none if all are zero.
    pub(super) heights: Vec<f64>,
    /// Made when it is first asked for, if the ring was checked without it.
    pub(super) mesh: OnceLock<Mesh>,
    /// For one ring that was found to be monotone.
    pub(super) monotone: Option<Monotone>,
}

/// One edge of a [`Figure`], directed as the caller gave it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Edge {
    /// Where it starts.
    pub from: VertexId,
    /// Where it ends.
    pub to: VertexId,
    /// The speeds (multiplicative weights, >= 0) of the wavefront on its left and on its
    /// right, in input units per unit of time, at time zero. See [`Figure::changes`].
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

impl Source {
    /// The same as a place among the parts.
    #[must_use]
    pub const fn place(self) -> Place {
        Place {
            part: self.part as usize,
            ring: self.ring as usize,
            index: self.edge as usize,
        }
    }
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

    /// Replaces the changes of speed: by edge, then side, then time, each to another speed.
    pub(crate) fn set_changes(&mut self, changes: Vec<SpeedChange>) {
        self.changes = changes;
    }

    /// The number of terminals: vertices of degree one.
    #[must_use]
    pub const fn terminals(&self) -> usize {
        self.terminals
    }

    /// The changes of speed, by edge, then side (left first), then time.
    #[must_use]
    pub fn changes(&self) -> &[SpeedChange] {
        &self.changes
    }

    /// The changes of speed of one side of an edge, in the order of time.
    #[must_use]
    pub fn changes_of(&self, edge: EdgeId, right: bool) -> &[SpeedChange] {
        let side = |change: &SpeedChange| (change.edge, change.right);
        let from = self.changes.partition_point(|c| side(c) < (edge, right));
        let count = self.changes[from..].partition_point(|c| side(c) == (edge, right));
        &self.changes[from..from + count]
    }

    /// The height of a vertex: the time before which no wavefront edge starts there.
    #[must_use]
    pub fn height(&self, vertex: VertexId) -> f64 {
        self.heights
            .get(vertex.index())
            .map_or(0.0, |&height| height)
    }

    /// Whether a vertex has a height other than zero.
    pub(crate) const fn has_heights(&self) -> bool {
        !self.heights.is_empty()
    }

    /// Whether every speed is one for ever, and no vertex has a height.
    pub(crate) fn is_plain(&self) -> bool {
        #[expect(clippy::float_cmp, reason = "asks for the number one itself")]
        let ones = self.edges.iter().all(|edge| edge.speeds == [1.0, 1.0]);
        ones && self.changes.is_empty() && self.heights.is_empty()
    }

    /// Whether an end of an edge has a height other than zero.
    pub(crate) fn has_height(&self, edge: EdgeId) -> bool {
        let edge = &self.edges[edge.index()];
        [edge.from, edge.to].iter().any(|&v| self.height(v) > 0.0)
    }

    /// Whether there is a polygon in it, so that "interior" means something.
    #[must_use]
    pub const fn has_polygon(&self) -> bool {
        self.has_polygon
    }

    /// The triangulation of the vertices that has every edge of the figure in it.
    pub(crate) fn mesh(&self) -> &Mesh {
        self.mesh
            .get_or_init(|| single::mesh(&self.vertices, &self.edges))
    }

    /// How the figure is monotone, if it is one simple ring without heights that is monotone in some
    /// direction. Edge i goes from vertex i to the next one then.
    pub(crate) const fn monotone(&self) -> Option<&Monotone> {
        self.monotone.as_ref()
    }
}
