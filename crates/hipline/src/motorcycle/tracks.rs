//! What a motorcycle graph is made of, by definition: no number in it is rounded.

use crate::predicates::{Place, PlaneId};
use crate::topology::VertexId;

/// Where a motorcycle comes from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Origin {
    /// A reflex vertex of the figure, at time zero.
    Vertex(VertexId),
    /// The meeting with this number, at its place and moment.
    Meeting(u32),
    /// Somebody put it where it starts.
    Given,
}

/// How a motorcycle ends.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Crash {
    /// It escapes to infinity.
    Escape,
    /// On the inside of an edge of a figure, coming from the side of this plane; or on a wall, whose line
    /// is that of the plane.
    Wall(PlaneId),
    /// In a vertex of the figure.
    Vertex(VertexId),
    /// In the track of the motorcycle with this number, which was there before.
    Track(u32),
    /// In the meeting with this number.
    Meeting(u32),
}

/// A motorcycle and its track.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Track {
    /// The planes on which it moves, the first turning left into the second. It is a reflex vertex of the
    /// wavefront, so the first is that of the wavefront edge which starts at it, on its right as it moves,
    /// the second that of the one which ends at it, on its left: like [`Trace::pair`](crate::wavefront::Trace::pair).
    pub pair: [PlaneId; 2],
    /// Where it comes from.
    pub origin: Origin,
    /// The place and moment where it starts.
    pub start: Place,
    /// How it ends.
    pub crash: Crash,
    /// The place and moment where it ends, unless it escapes.
    pub end: Option<Place>,
}

/// Two or more motorcycles at one place at one moment, where no track was before.
#[derive(Clone, Debug)]
pub(crate) struct Meeting {
    /// Where and when.
    pub place: Place,
    /// Who, ascending.
    pub members: Vec<u32>,
    /// The motorcycle that starts here, if the wavefront has a reflex vertex here afterwards.
    pub child: Option<u32>,
}

/// A motorcycle graph.
#[derive(Clone, Debug, Default)]
pub(crate) struct Tracks {
    /// First those that somebody placed or that start at vertices, in the order of these; then those
    /// of the meetings.
    pub motorcycles: Vec<Track>,
    /// In the order of their times, correctly rounded; of equal ones, in that of their first members.
    pub meetings: Vec<Meeting>,
}
