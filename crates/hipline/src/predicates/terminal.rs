//! Ends of edges that emit a wavefront edge of their own: vertices of degree one, and in modified
//! skeletons [`caps`] at acute angles.

use super::caps;
use crate::{
    input::Figure,
    topology::{EdgeId, VertexId},
};

/// A vertex of degree one, or a cap.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Terminal {
    /// The vertex.
    pub tip: usize,
    /// The other end of its edge.
    pub inner: usize,
    /// The edge.
    pub edge: usize,
    /// The speed of its wavefront edge: the larger of the two of its edge.
    pub speed: f64,
}

impl Terminal {
    /// All terminals of a figure; after them, if its skeleton is a modified one, its caps.
    pub(crate) fn with_caps(figure: &Figure, modified: bool) -> Vec<Self> {
        let mut list = Self::all(figure);
        if modified && figure.is_plain() {
            list.append(&mut caps::caps(figure));
        }
        list
    }

    /// The number of the terminal or cap at an end of an edge, in a list of [`Self::with_caps`] that starts
    /// with so many terminals.
    pub(crate) fn find(list: &[Self], terminals: usize, tip: usize, edge: usize) -> Option<usize> {
        let (plain, caps) = list.split_at(terminals);
        if let Ok(i) = plain.binary_search_by_key(&tip, |terminal| terminal.tip) {
            return Some(i);
        }
        let first = caps.partition_point(|cap| cap.tip < tip);
        let two = &caps[first..caps.len().min(first + 2)];
        let is_it = |cap: &Self| cap.tip == tip && cap.edge == edge;
        two.iter().position(is_it).map(|i| terminals + first + i)
    }

    /// All terminals of a figure, in the order of their vertices: the order of their planes.
    pub(crate) fn all(figure: &Figure) -> Vec<Self> {
        if figure.terminals() == 0 {
            return Vec::new();
        }
        let mut degree = vec![0_u8; figure.vertices().len()];
        for edge in figure.edges() {
            for v in [edge.from, edge.to] {
                degree[v.index()] = (degree[v.index()] + 1).min(2);
            }
        }
        let mut list = Vec::with_capacity(figure.terminals());
        for (e, edge) in figure.edges().iter().enumerate() {
            for (tip, inner) in [(edge.from, edge.to), (edge.to, edge.from)] {
                if degree[tip.index()] == 1 {
                    let speed = edge.speeds[0].max(edge.speeds[1]);
                    list.push(Self {
                        tip: tip.index(),
                        inner: inner.index(),
                        edge: e,
                        speed,
                    });
                }
            }
        }
        list.sort_unstable_by_key(|terminal| terminal.tip);
        list
    }

    /// Its speeds over time, each with the time from which on it holds: always the larger one of
    /// the two of its edge.
    pub(super) fn speeds(&self, figure: &Figure) -> Vec<[f64; 2]> {
        let edge = EdgeId::new(self.edge);
        let mut now = figure.edges()[self.edge].speeds;
        let mut changes = [false, true]
            .map(|right| figure.changes_of(edge, right))
            .concat();
        changes.sort_by(|a, b| a.time.total_cmp(&b.time));
        let height = figure.height(VertexId::new(self.tip));
        let mut list = vec![[0.0, self.speed]];
        if height > 0.0 && self.speed > 0.0 {
            list = vec![[0.0, 0.0], [height, self.speed]];
        }
        for together in changes.chunk_by(|a, b| a.time.to_bits() == b.time.to_bits()) {
            for change in together {
                now[usize::from(change.right)] = change.speed;
            }
            let speed = now[0].max(now[1]);
            if speed.to_bits() != list[list.len() - 1][1].to_bits() {
                list.push([together[0].time, speed]);
            }
        }
        list
    }
}
