//! The planes of faces and the definitions of nodes, for others who read a skeleton exactly.

use super::lift::Lift;
use crate::{
    input::Figure,
    predicates::{Bound, Place, PlaneId, Planes},
    skeleton::{ArcKind, Skeleton},
    topology::{ArcId, FaceId, NodeId},
};

/// What the rounded numbers of a skeleton stand for.
pub(crate) struct Definitions<'a>(Lift<'a>);

impl<'a> Definitions<'a> {
    /// # Panics
    /// If the figure is not the one that the skeleton was computed from.
    pub(crate) fn new(skeleton: &'a Skeleton, figure: &Figure) -> Self {
        Self(Lift::new(skeleton, figure))
    }

    pub(crate) const fn skeleton(&self) -> &'a Skeleton {
        self.0.skeleton
    }

    pub(crate) const fn planes(&self) -> &Planes {
        &self.0.planes
    }

    /// The plane that a face lies on.
    pub(crate) fn plane(&self, face: FaceId) -> PlaneId {
        self.0.plane(face)
    }

    /// The definition of a finite node.
    pub(crate) fn place(&self, node: NodeId) -> Place {
        self.0.place(node)
    }

    /// The planes beside an arc that is no ghost and not of one height, the first turning left
    /// into the second.
    pub(crate) fn pair(&self, arc: ArcId) -> [PlaneId; 2] {
        self.0.pair(arc)
    }

    /// Where an unbounded arc is at a time.
    pub(crate) fn at(&self, arc: ArcId, time: f64) -> Place {
        if self.0.skeleton.arc(arc).kind == ArcKind::Ghost {
            self.0.on_ghost(arc, Bound::Time(time))
        } else {
            let pair = self.0.pair(arc);
            Place::At { pair, time }
        }
    }
}
