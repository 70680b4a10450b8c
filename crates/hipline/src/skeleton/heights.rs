//! Whether a figure with heights was reached at its own heights.

use super::{Side, Skeleton};
use crate::{
    input::{Figure, Source},
    topology::{EdgeId, FaceId, NodeId},
};

/// Edges that the wavefront reached, or passed, before their own heights.
///
/// "The only requirement needed for a proper definition of the skeleton is that speeds and
/// angles of wavefront edges are chosen such that each point in the plane is reached by wavefronts
/// at only one point in time" (Aichholzer and Aurenhammer 1996, section 4).
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ReachedEarly {
    /// The edges, each with the side on which it happened, in the order of faces.
    pub edges: Vec<(EdgeId, Side)>,
    /// The caller's names for the edges.
    pub sources: Vec<Source>,
}

impl std::error::Error for ReachedEarly {}

impl std::fmt::Display for ReachedEarly {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        const SHOWN: usize = 20;
        for (i, (source, (_, side))) in self.sources.iter().zip(&self.edges).enumerate() {
            if i == SHOWN {
                return write!(f, "\nand {} more", self.sources.len() - SHOWN);
            }
            let (part, ring, edge) = (source.part, source.ring, source.edge);
            let lead = if i == 0 { "" } else { "\n" };
            write!(
                f,
                "{lead}part {part}, ring {ring}, edge {edge} is lower on its {side:?} side than its heights: \
                 the surface of other edges passes below it; their slopes are too low, or its heights too great"
            )?;
        }
        Ok(())
    }
}

impl Skeleton {
    /// Checks that the surface passes through every edge at its own heights. Without
    /// heights ([`FigureBuilder::elevate`](crate::FigureBuilder::elevate)) there is nothing to check.
    ///
    /// What the surface is where this fails is defined nonetheless: up to its own time, an edge stands as a
    /// wall, against which the surfaces of others may rise.
    ///
    /// # Errors
    /// The edges that are covered, in full or in part.
    ///
    /// # Complexity
    /// O(n).
    pub fn check_heights(&self, figure: &Figure) -> Result<(), ReachedEarly> {
        let mut edges = Vec::new();
        for (i, face) in self.faces().iter().enumerate() {
            let is_wall = face.phase == 0 && matches!(face.side, Side::Left | Side::Right);
            if is_wall && figure.has_height(face.edge) && !self.is_whole(FaceId::new(i), figure) {
                edges.push((face.edge, face.side));
            }
        }
        if edges.is_empty() {
            return Ok(());
        }
        let sources = edges
            .iter()
            .map(|(edge, _)| figure.edges()[edge.index()].source)
            .collect();
        Err(ReachedEarly { edges, sources })
    }

    /// Whether a wall reaches from the ground to its edge's heights, from end to end.
    fn is_whole(&self, face: FaceId, figure: &Figure) -> bool {
        let edge = &figure.edges()[self.face(face).edge.index()];
        let ends = [edge.from, edge.to];
        let mut tops = [false; 2];
        let mut fits = |&id: &NodeId| {
            let node = self.node(id);
            let Some(k) = ends.iter().position(|&v| {
                let bits = figure.vertices()[v.index()].map(f64::to_bits);
                bits == [node.x, node.y].map(f64::to_bits)
            }) else {
                return false;
            };
            let height = figure.height(ends[k]);
            let is_top = node.time.to_bits() == height.to_bits();
            tops[k] |= is_top;
            is_top || node.time <= 0.0
        };
        self.holes(face).next().is_none()
            && self.boundary(face).iter().all(&mut fits)
            && tops == [true; 2]
    }
}
