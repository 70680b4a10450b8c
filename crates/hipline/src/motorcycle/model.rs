//! The result: plain data with typed ids.

use super::tracks::{self, Tracks};
use crate::{
    predicates::{Place, PlaneId, Planes},
    skeleton::Side,
    topology::{EdgeId, MeetingId, MotorcycleId, VertexId, WallId},
};

/// A place and a moment. Each number is the f64 nearest to the exact value.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Spot {
    /// Abscissa, in input units.
    pub x: f64,
    /// Ordinate, in input units.
    pub y: f64,
    /// The time; in the graph of a figure, the distance that an edge of unit speed has moved.
    pub time: f64,
}

/// Where a motorcycle comes from.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Origin {
    /// A reflex vertex of the figure. A vertex where several parts touch may send several.
    Vertex(VertexId),
    /// A meeting of others, after which the wavefront has a reflex vertex there.
    Meeting(MeetingId),
    /// The list of [`Launch`](super::Launch)es.
    Given,
}

/// What ended the track of a motorcycle.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum End {
    /// Nothing: it escapes to infinity.
    Escape,
    /// The inside of an edge of the figure, on the side told.
    Edge(EdgeId, Side),
    /// A vertex of the figure.
    Vertex(VertexId),
    /// A wall.
    Wall(WallId),
    /// The track of another one that was there before. Of several, the one with the lowest number.
    Track(MotorcycleId),
    /// Others that came to the same place at the same moment.
    Meeting(MeetingId),
}

/// A motorcycle and its track.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Motorcycle {
    /// Where and when it starts.
    pub start: Spot,
    /// Where and when its track ends, unless it escapes.
    pub stop: Option<Spot>,
    /// Its velocity, in input units per unit of time, correctly rounded.
    pub velocity: [f64; 2],
    /// In the graph of a figure: the sides of edges between whose wavefronts it runs, first that on its
    /// left as it moves. (Of edges on one line, whose wavefronts are one, it is one of them.)
    pub between: Option<[(EdgeId, Side); 2]>,
    /// Where it comes from.
    pub origin: Origin,
    /// What ended its track.
    pub end: End,
}

/// Two or more motorcycles at one place at one moment, where neither a track nor a wall was before.
#[derive(Debug, Clone, PartialEq)]
pub struct Meeting {
    /// Where and when.
    pub spot: Spot,
    /// Those that met, ascending.
    pub members: Vec<MotorcycleId>,
    /// The one that starts there, if any does.
    pub child: Option<MotorcycleId>,
}

/// A motorcycle graph: who goes where, and what stops whom.
///
/// Made by [`Figure::motorcycles`](crate::Figure::motorcycles) or [`MotorcycleGraph::new`].
#[derive(Debug, Clone, PartialEq, Default)]
pub struct MotorcycleGraph {
    pub(super) motorcycles: Vec<Motorcycle>,
    pub(super) meetings: Vec<Meeting>,
}

impl MotorcycleGraph {
    /// The motorcycles: those that start on their own first, in the order of vertices or as given; then those that
    /// start where others meet, in the order of time.
    #[must_use]
    pub fn motorcycles(&self) -> &[Motorcycle] {
        &self.motorcycles
    }

    /// One motorcycle.
    ///
    /// # Panics
    /// If the id is not of this graph.
    #[must_use]
    pub fn motorcycle(&self, id: MotorcycleId) -> &Motorcycle {
        &self.motorcycles[id.index()]
    }

    /// The ids of the motorcycles.
    pub fn ids(&self) -> impl Iterator<Item = MotorcycleId> + use<> {
        (0..self.motorcycles.len()).map(MotorcycleId::new)
    }

    /// The meetings, in the order of time; at one time in that of their first members.
    #[must_use]
    pub fn meetings(&self) -> &[Meeting] {
        &self.meetings
    }

    /// One meeting.
    ///
    /// # Panics
    /// If the id is not of this graph.
    #[must_use]
    pub fn meeting(&self, id: MeetingId) -> &Meeting {
        &self.meetings[id.index()]
    }

    /// Rounds what was computed.
    pub(super) fn of_tracks(
        planes: &Planes,
        tracks: &Tracks,
        wall: impl Fn(PlaneId) -> End,
        between: impl Fn([PlaneId; 2]) -> Option<[(EdgeId, Side); 2]>,
    ) -> Self {
        let spot = |place: &Place| {
            let [x, y, time] = planes.round(place);
            Spot { x, y, time }
        };
        let id = |who: u32| MotorcycleId::new(who as usize);
        let meeting = |number: u32| MeetingId::new(number as usize);
        let motorcycles = tracks.motorcycles.iter().map(|track| Motorcycle {
            start: spot(&track.start),
            stop: track.end.as_ref().map(spot),
            velocity: planes.round_velocity(track.pair),
            between: between(track.pair),
            origin: match track.origin {
                tracks::Origin::Vertex(vertex) => Origin::Vertex(vertex),
                tracks::Origin::Meeting(number) => Origin::Meeting(meeting(number)),
                tracks::Origin::Given => Origin::Given,
            },
            end: match track.crash {
                tracks::Crash::Escape => End::Escape,
                tracks::Crash::Wall(plane) => wall(plane),
                tracks::Crash::Vertex(vertex) => End::Vertex(vertex),
                tracks::Crash::Track(who) => End::Track(id(who)),
                tracks::Crash::Meeting(number) => End::Meeting(meeting(number)),
            },
        });
        let meetings = tracks.meetings.iter().map(|meeting| Meeting {
            spot: spot(&meeting.place),
            members: meeting.members.iter().copied().map(id).collect(),
            child: meeting.child.map(id),
        });
        Self {
            motorcycles: motorcycles.collect(),
            meetings: meetings.collect(),
        }
    }
}
