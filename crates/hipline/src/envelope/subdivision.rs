//! The subdivision, for pictures of it.

use super::{
    Envelope,
    boundary::{Cell, Kind},
};
use crate::{engine::NotApplicable, input::Figure, motorcycle};

/// What an edge of a cell is a piece of.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Border {
    /// An edge of the figure.
    Edge,
    /// A cut.
    Cut,
    /// A descent path straight down a face.
    Descent,
    /// A descent path along a valley.
    Valley,
}

/// A cell.
#[derive(Debug, Clone)]
#[non_exhaustive]
pub struct SubdivisionCell {
    /// Its boundary, the cell on the left: where each edge starts and ends (rounded), and what it is. Those of one cycle follow one another.
    pub edges: Vec<([[f64; 2]; 2], Border)>,
    /// How many faces of slabs it may have.
    pub slabs: usize,
    /// How many valleys enter it.
    pub valleys: usize,
}

/// The cells into which [`Engine::Envelope`](crate::Engine::Envelope) divides the inside of a figure (Mencil 2014, figures 3.4 and 4.2). Between them are empty
/// cells, over each of which there is one face alone.
#[derive(Debug, Clone)]
#[non_exhaustive]
pub struct Subdivision {
    /// After the cuts through the medians of motorcycle vertices.
    pub first: Vec<SubdivisionCell>,
    /// After the cuts between valleys.
    pub last: Vec<SubdivisionCell>,
}

impl Figure {
    /// The cells into which [`Engine::Envelope`](crate::Engine::Envelope) divides the inside.
    ///
    /// # Errors
    /// If the figure is not made of polygons alone, or not all speeds are one.
    pub fn subdivision(&self) -> Result<Subdivision, NotApplicable> {
        let (planes, tracks) = motorcycle::induced(self)?;
        let mut envelope = Envelope::new(self, planes, tracks);
        envelope.seen = Some(Default::default());
        envelope.candidates();
        let [first, last] = envelope.seen.take().unwrap_or_default();
        let [first, last] = [first, last].map(|cells| {
            let cells = cells.iter().map(|cell| envelope.drawn(cell));
            cells.collect()
        });
        Ok(Subdivision { first, last })
    }
}

impl Envelope<'_> {
    fn drawn(&self, cell: &Cell) -> SubdivisionCell {
        let edges = cell.edges.iter().map(|edge| {
            let ends =
                [&edge.from, &edge.to].map(|node| node.frame.map(|[low, high]| low.midpoint(high)));
            let border = match edge.kind {
                Kind::Source => Border::Edge,
                Kind::Cut => Border::Cut,
                Kind::Down => Border::Descent,
                Kind::Valley => Border::Valley,
            };
            (ends, border)
        });
        SubdivisionCell {
            edges: edges.collect(),
            slabs: self.slabs_in(cell).len(),
            valleys: cell.notches().count(),
        }
    }
}
