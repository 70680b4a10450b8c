//! What may happen to motorcycles, and what the queues hold.

use crate::{
    predicates::{Bounds, Place, PlaneId},
    topology::VertexId,
};
use std::cmp::Ordering;

/// What a motorcycle may run into.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Obstacle {
    /// The inside of an edge, seen from the side of a plane; or a wall.
    Wall(PlaneId),
    /// A vertex.
    Vertex(VertexId),
    /// The track of another one that was there before, if it was there at all.
    Track(u32),
    /// Another one that arrives at the same moment.
    Rival(u32),
}

impl Obstacle {
    /// The other motorcycle, if it is one.
    pub(super) const fn other(self) -> Option<u32> {
        match self {
            Self::Track(who) | Self::Rival(who) => Some(who),
            Self::Wall(_) | Self::Vertex(_) => None,
        }
    }

    /// Of all that is at one place, what counts: a wall before a track before a meeting, and of
    /// several the one with the lowest number.
    pub(super) const fn rank(self) -> (u8, u32) {
        match self {
            Self::Wall(plane) => (0, plane.0),
            Self::Vertex(vertex) => (1, vertex.index() as u32),
            Self::Track(who) => (2, who),
            Self::Rival(who) => (3, who),
        }
    }
}

/// A motorcycle gets to an obstacle.
#[derive(Clone, Copy, Debug)]
pub(super) struct Hit {
    pub who: u32,
    pub on: Obstacle,
    pub place: Place,
    pub bounds: Bounds,
    /// When another one is there, if it hits that one's track.
    pub there: Option<Bounds>,
}

/// A step that the ground wants to take not later than when a motorcycle gets somewhere.
#[derive(Clone, Copy, Debug)]
pub(super) struct Step {
    /// At most the time when it gets there.
    pub low: f64,
    pub who: u32,
}

impl PartialEq for Step {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other).is_eq()
    }
}

impl Eq for Step {}

impl PartialOrd for Step {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Step {
    fn cmp(&self, other: &Self) -> Ordering {
        self.low
            .total_cmp(&other.low)
            .then_with(|| self.who.cmp(&other.who))
    }
}

/// What a ground found.
#[derive(Debug, Default)]
pub(super) struct Found {
    pub hits: Vec<Hit>,
    pub steps: Vec<Step>,
}

/// A hit in the queue, ordered by its lower bound.
pub(super) struct Queued(pub Hit);

impl PartialEq for Queued {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other).is_eq()
    }
}

impl Eq for Queued {}

impl PartialOrd for Queued {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Queued {
    fn cmp(&self, other: &Self) -> Ordering {
        self.0.bounds.low.total_cmp(&other.0.bounds.low)
    }
}
