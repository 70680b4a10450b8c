//! Cells of the plan and their boundaries: the face lists and vertex conflict lists of sections 3.1 and 3.2 of the thesis.
//!
//! A cell is a part of the inside of the figure. Its boundary is made of cycles of directed edges, the cell on their left: an outer one,
//! and those of holes. Each edge is a piece of an edge of the figure, of a cut, or of a descent path, and bounds the face of one slab within the cell.
//! Where the valley of a motorcycle enters the cell, the end of an edge has a *notch*.
//!
//! *Lemma.* A slab that is visible over an area within a cell is that of an edge of its boundary, or of a motorcycle whose notch the
//! cell has. *Proof.* Go straight down from there. Either one leaves the cell through an edge that bounds the slab, or one gets to the track within
//! the cell, and follows the valley down, until one leaves the cell across a cut, on which the slab is seen, or gets to the notch. ∎

use super::{
    Envelope,
    section::{Cut, Mark, Spot},
};
use crate::predicates::{CellCorner, Line};
use hipline_num::Sign;
use std::sync::Arc;

/// Nothing.
pub(super) const NONE: u32 = u32::MAX;

/// A corner of cells.
#[derive(Debug)]
pub(super) struct Node {
    pub what: CellCorner,
    /// Bounds of its coordinates.
    pub frame: [[f64; 2]; 2],
}

/// What an edge of a boundary is a piece of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    Source,
    Cut,
    /// A way straight down.
    Down,
    /// A way down a valley.
    Valley,
}

/// A directed edge of the boundary of a cell, which is on its left.
#[derive(Clone, Debug)]
pub(super) struct Edge {
    pub from: Arc<Node>,
    pub to: Arc<Node>,
    pub line: Line,
    pub kind: Kind,
    /// The slab that it bounds in the cell.
    pub slab: u32,
    /// The track whose valley enters the cell where the edge ends.
    pub notch: u32,
    /// The track whose valley leaves the cell there, if the way down it is not known.
    pub passes: u32,
    pub next: u32,
}

/// A part of the plan.
#[derive(Clone, Debug)]
pub(super) struct Cell {
    pub edges: Vec<Edge>,
    /// How many cycles there are beside the outer one.
    pub holes: usize,
    pub depth: u32,
    /// Whether it comes from a cut between valleys.
    pub is_late: bool,
}

/// Bounds of where edges start.
pub(super) fn frame<'a>(edges: impl IntoIterator<Item = &'a Edge>) -> [[f64; 2]; 2] {
    let mut frame = [[f64::INFINITY, f64::NEG_INFINITY]; 2];
    for edge in edges {
        for (own, other) in frame.iter_mut().zip(edge.from.frame) {
            *own = [own[0].min(other[0]), own[1].max(other[1])];
        }
    }
    frame
}

impl Cell {
    /// Bounds of the cell.
    pub(super) fn frame(&self) -> [[f64; 2]; 2] {
        frame(&self.edges)
    }

    /// Where the valleys of which motorcycles enter it.
    pub(super) fn notches(&self) -> impl Iterator<Item = (&Node, u32)> {
        (self.edges.iter())
            .filter(|edge| edge.notch != NONE)
            .map(|edge| (&*edge.to, edge.notch))
    }

    /// Whether the roof above it is convex: no valley, and no hole.
    pub(super) fn is_convex(&self) -> bool {
        (self.edges.iter()).all(|edge| edge.notch == NONE && edge.passes == NONE) && self.holes == 0
    }
}

/// Where a cut crosses an edge of a cell.
pub(super) struct Crossing {
    pub edge: u32,
    pub node: Arc<Node>,
    /// Whether the cut enters the cell.
    pub enters: bool,
}

impl Envelope<'_> {
    pub(super) fn node(&self, what: CellCorner) -> Arc<Node> {
        let frame = self.planes.bounds_of(&what);
        Arc::new(Node { what, frame })
    }

    /// The side of a cut that a corner is on: positive on the left.
    fn side(&self, cut: &Cut, node: &Node) -> Sign {
        if let Some(sign) = cut.side_of_box(&node.frame) {
            return sign;
        }
        self.planes.side_of_line(&node.what, &cut.line)
    }

    /// On which side of a cut each edge of a cell starts; `None` if one does on it.
    pub(super) fn sides(&self, cut: &Cut, cell: &Cell) -> Option<Vec<Sign>> {
        let sides = cell.edges.iter().map(|edge| self.side(cut, &edge.from));
        sides
            .map(|sign| (!sign.is_zero()).then_some(sign))
            .collect()
    }

    /// Where a cut crosses the boundary of a cell, in this order: it enters, leaves, enters, ... `None` if it touches it only.
    pub(super) fn crossings(
        &self,
        cut: &Cut,
        cell: &Cell,
        sides: &[Sign],
    ) -> Option<Vec<Crossing>> {
        let mut found: Vec<(Crossing, [f64; 2])> = Vec::new();
        for (i, edge) in cell.edges.iter().enumerate() {
            let [from, to] = [sides[i], sides[edge.next as usize]];
            if from != to {
                let node = self.node(CellCorner::Of(cut.line.clone(), edge.line.clone()));
                let bounds = cut.along(&node);
                let crossing = Crossing {
                    edge: i as u32,
                    node,
                    enters: from.is_positive(),
                };
                found.push((crossing, bounds));
            }
        }
        let line = |c: &Crossing| &cell.edges[c.edge as usize].line;
        found.sort_by(|(p, a), (q, b)| {
            let order = if a[1] < b[0] {
                std::cmp::Ordering::Less
            } else if a[0] > b[1] {
                std::cmp::Ordering::Greater
            } else {
                (self.planes).compare_on_cut(&cut.line, line(p), line(q))
            };
            order.then(p.enters.cmp(&q.enters))
        });
        let alternate = (found.iter().enumerate()).all(|(i, (c, _))| c.enters == (i % 2 == 0));
        (alternate && found.len().is_multiple_of(2))
            .then(|| found.into_iter().map(|(c, _)| c).collect())
    }

    /// The slabs that may be visible over a cell, ascending.
    pub(super) fn slabs_in(&self, cell: &Cell) -> Vec<u32> {
        let mut list = Vec::with_capacity(cell.edges.len());
        for edge in &cell.edges {
            list.push(edge.slab);
            for mut track in [edge.notch, edge.passes] {
                // The valleys that go on from its meetings, too.
                while track != NONE {
                    list.extend(self.slabs_of_track[track as usize]);
                    track = self.child_of(track);
                }
            }
        }
        list.sort_unstable();
        list.dedup();
        list
    }

    /// The motorcycle that goes on where one ends.
    pub(super) fn child_of(&self, track: u32) -> u32 {
        match self.tracks.motorcycles[track as usize].crash {
            crate::motorcycle::tracks::Crash::Meeting(meeting) => {
                (self.tracks.meetings[meeting as usize].child).unwrap_or(NONE)
            }
            _ => NONE,
        }
    }

    /// The track whose valley a cut crosses between two neighbouring slabs on it.
    pub(super) fn valley_between(&self, a: u32, b: u32) -> u32 {
        match [a, b].map(|slab| self.slab(slab).track) {
            [Some(s), Some(t)] if s == t => s,
            _ => NONE,
        }
    }

    /// Where a place on a cut is.
    pub(super) fn node_on(&self, cut: &Cut, spot: &Spot) -> Arc<Node> {
        debug_assert!(!matches!(spot.mark, Mark::First | Mark::Last));
        self.node(CellCorner::Of(cut.line.clone(), self.line_of(spot.mark)))
    }
}
