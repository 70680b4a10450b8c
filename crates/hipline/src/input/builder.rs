//! From polygons, polylines and graphs to a checked figure.

use super::{Figure, InvalidFigure};

/// Collects polygons, polylines and graphs, then checks them all at once.
#[derive(Debug, Clone, Default)]
pub struct FigureBuilder {}

impl FigureBuilder {
    /// An empty builder.
    #[must_use]
    pub fn new() -> Self {
        Self::default()
    }

    /// Adds a polygon: its shell, then its holes, each a list of `[x, y]`; a last point equal to
    /// the first is dropped; either orientation. Returns the number of the part.
    pub fn polygon(&mut self, rings: Vec<Vec<[f64; 2]>>) -> usize {
        let _ = rings;
        0
    }

    /// Adds a polygon with a speed for each edge, ring by ring; an edge's speed holds on both sides.
    pub fn weighted_polygon(&mut self, rings: Vec<Vec<[f64; 2]>>, speeds: Vec<Vec<f64>>) -> usize {
        let _ = (rings, speeds);
        0
    }

    /// Adds a polyline (closed if its last point equals its first).
    pub fn polyline(&mut self, points: Vec<[f64; 2]>) -> usize {
        let _ = points;
        0
    }

    /// Adds a polyline with `[left, right]` speeds for each edge.
    pub fn weighted_polyline(&mut self, points: Vec<[f64; 2]>, speeds: Vec<[f64; 2]>) -> usize {
        let _ = (points, speeds);
        0
    }

    /// Adds a graph: vertices, and edges as pairs of vertex numbers.
    pub fn graph(&mut self, vertices: Vec<[f64; 2]>, edges: Vec<[usize; 2]>) -> usize {
        let _ = (vertices, edges);
        0
    }

    /// Adds a graph with `[left, right]` speeds for each edge.
    pub fn weighted_graph(&mut self, vertices: Vec<[f64; 2]>, edges: Vec<[usize; 2]>, speeds: Vec<[f64; 2]>) -> usize {
        let _ = (vertices, edges, speeds);
        0
    }

    /// Checks everything and builds the figure.
    ///
    /// # Errors
    /// Every [`Flaw`](super::Flaw) of the input, in the caller's own numbering.
    pub fn build(self) -> Result<Figure, InvalidFigure> {
        todo!()
    }
}
