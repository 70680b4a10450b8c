//! What can be wrong with an input, in the caller's own numbering.

use std::fmt;

/// A vertex or an edge in the caller's numbering.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Place {
    /// Which polygon, line or graph, in the order of the calls to the builder.
    pub part: usize,
    /// Which ring of a polygon (0 is the shell), 0 otherwise.
    pub ring: usize,
    /// Which vertex of the ring, line or graph; an edge is named by its first vertex (in a
    /// graph, by its number in the list of edges).
    pub index: usize,
}

/// One reason why an input is not a figure.
///
/// Every variant names the place in the caller's numbering; its message adds the
/// coordinates.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum Flaw {
    /// Nothing to compute a skeleton of.
    #[error("there is no edge")]
    Empty,
    /// More vertices or edges than the 32-bit ids can name.
    #[error("there are {count} vertices and edges; at most {limit} can be handled")]
    TooLarge {
        /// How many there are.
        count: usize,
        /// How many there may be.
        limit: usize,
    },
    /// A coordinate is NaN or infinite.
    #[error("{} is not finite: ({}, {})", Vertex(.at), .point[0], .point[1])]
    NotFinite {
        /// The vertex.
        at: Place,
        /// Its coordinates.
        point: [f64; 2],
    },
    /// A coordinate is so much smaller than the largest one that exact decisions would
    /// leave the range of `f64`.
    #[error(
        "{} at ({:e}, {:e}): a coordinate is too small beside the largest of the figure, {largest:e}",
        Vertex(.at), .point[0], .point[1]
    )]
    CoordinateRange {
        /// The vertex.
        at: Place,
        /// Its coordinates.
        point: [f64; 2],
        /// The largest size of a coordinate in the figure.
        largest: f64,
    },
    /// A ring with fewer than three distinct vertices, or a line with fewer than two.
    #[error("{} has {found} distinct vertices and needs {needed}", Ring(.at))]
    TooFewVertices {
        /// The ring or line (its first vertex).
        at: Place,
        /// How many distinct vertices it has.
        found: usize,
        /// How many it needs.
        needed: usize,
    },
    /// Both ends of an edge are the same point.
    #[error("{} has length zero, at ({}, {})", Edge(.edge), .point[0], .point[1])]
    ZeroLengthEdge {
        /// The edge.
        edge: Place,
        /// Where it is.
        point: [f64; 2],
    },
    /// Two vertices of one graph are the same point.
    #[error("{} is the same point as {}: ({}, {})", Vertex(.second), Vertex(.first), .point[0], .point[1])]
    DuplicateVertex {
        /// The first of them.
        first: Place,
        /// A later one.
        second: Place,
        /// Where they are.
        point: [f64; 2],
    },
    /// A vertex of a graph that no edge has as an end.
    #[error("{} at ({}, {}) has no edge; points alone have no skeleton", Vertex(.at), .point[0], .point[1])]
    LonePoint {
        /// The vertex.
        at: Place,
        /// Where it is.
        point: [f64; 2],
    },
    /// An edge of a graph names a vertex that does not exist.
    #[error("{} names vertex {vertex} of a graph of {count} vertices", Edge(.edge))]
    EdgeIndexOutOfRange {
        /// The edge.
        edge: Place,
        /// The number that it has for a vertex.
        vertex: usize,
        /// How many vertices the graph has.
        count: usize,
    },
    /// A speed that is negative or not finite.
    #[error("{} has the speed {speed}; a speed must be finite and not negative", Edge(.edge))]
    BadSpeed {
        /// The edge.
        edge: Place,
        /// Its speed.
        speed: f64,
    },
    /// A change of speed names an edge that is not there.
    #[error("a change of speed names {}, which is not there", Edge(.edge))]
    NoSuchEdge {
        /// The name it has for an edge.
        edge: Place,
    },
    /// The time of a change of speed is not a positive finite number.
    #[error("{} changes its speed at the time {time}; a time must be positive and finite", Edge(.edge))]
    BadTime {
        /// The edge.
        edge: Place,
        /// The time.
        time: f64,
    },
    /// An edge changes its speed twice at one time.
    #[error("{} changes its speed twice at the time {time}", Edge(.edge))]
    TwoChanges {
        /// The edge.
        edge: Place,
        /// The time.
        time: f64,
    },
    /// A height names a vertex that is not there.
    #[error("a height names {}, which is not there", Vertex(.at))]
    NoSuchVertex {
        /// The name it has for a vertex.
        at: Place,
    },
    /// A height that is negative or not finite.
    #[error("{} has the height {height}; a height must be finite and not negative", Vertex(.at))]
    BadHeight {
        /// The vertex.
        at: Place,
        /// Its height.
        height: f64,
    },
    /// One point has two heights.
    #[error("{} has the height {}, {} at the same point has {}", Vertex(.first), .heights[0], Vertex(.second), .heights[1])]
    TwoHeights {
        /// A vertex there.
        first: Place,
        /// Another one there, or the same again.
        second: Place,
        /// Their heights.
        heights: [f64; 2],
    },
    /// An edge rises as steeply as its facets, or more.
    #[error(
        "{} goes from height {} to {}: that is not less steep than its facets, which rise by one in {speed}",
        Edge(.edge), .heights[0], .heights[1]
    )]
    TooSteep {
        /// The edge.
        edge: Place,
        /// The heights of its ends.
        heights: [f64; 2],
        /// The larger one of its speeds.
        speed: f64,
    },
    /// An edge changes its speed before it starts to move, or it has a tilted eave and changes its speed
    /// at all.
    #[error(
        "{} changes its speed at the time {time}; with ends at the heights {} and {} {}",
        Edge(.edge), .heights[0], .heights[1],
        if .heights[0].to_bits() == .heights[1].to_bits() { "it must start first" } else { "it cannot" }
    )]
    ChangeBeforeStart {
        /// The edge.
        edge: Place,
        /// The time.
        time: f64,
        /// The heights of its ends.
        heights: [f64; 2],
    },
    /// Not one speed for each edge.
    #[error("{} has {needed} edges and {found} speeds", Ring(.at))]
    SpeedCount {
        /// The ring, line or graph (its first edge).
        at: Place,
        /// How many speeds were given.
        found: usize,
        /// How many edges there are.
        needed: usize,
    },
    /// Not one list of speeds for each ring.
    #[error("part {part} has {needed} rings and {found} lists of speeds")]
    SpeedLists {
        /// The polygon.
        part: usize,
        /// How many lists of speeds were given.
        found: usize,
        /// How many rings there are.
        needed: usize,
    },
    /// Two edges cross where neither has a vertex.
    #[error("{} and {} cross near ({}, {})", Edge(.first), Edge(.second), .near[0], .near[1])]
    EdgesCross {
        /// An edge.
        first: Place,
        /// The edge that it crosses.
        second: Place,
        /// The crossing, rounded.
        near: [f64; 2],
    },
    /// Two edges share more than a point.
    #[error(
        "{} and {} overlap from ({}, {}) to ({}, {})",
        Edge(.first), Edge(.second), .from[0], .from[1], .to[0], .to[1]
    )]
    EdgesOverlap {
        /// An edge.
        first: Place,
        /// The edge that lies on it.
        second: Place,
        /// One end of what they share.
        from: [f64; 2],
        /// The other end.
        to: [f64; 2],
    },
    /// A hole that is not inside its polygon's shell, or not wholly.
    #[error("{} is not inside its shell, at {} ({}, {})", Ring(.hole), Edge(.hole), .point[0], .point[1])]
    HoleOutsideShell {
        /// An edge of the hole that shows it.
        hole: Place,
        /// Where that edge starts.
        point: [f64; 2],
    },
    /// A hole inside another hole of the same polygon.
    #[error("{} is inside {}, at {} ({}, {})", Ring(.inner), Ring(.outer), Edge(.inner), .point[0], .point[1])]
    HoleInHole {
        /// An edge of the inner hole that shows it.
        inner: Place,
        /// The hole around it (its first vertex).
        outer: Place,
        /// Where the edge starts.
        point: [f64; 2],
    },
    /// The insides of two polygons overlap.
    #[error("{} lies on the inside of part {other}, at {} ({}, {})", Ring(.ring), Edge(.ring), .point[0], .point[1])]
    ShellsOverlap {
        /// An edge of a ring that lies on the inside of another polygon.
        ring: Place,
        /// That polygon.
        other: usize,
        /// Where the edge starts.
        point: [f64; 2],
    },
    /// The inside of one polygon is in several pieces that touch in points at most.
    #[error("the inside of part {part} is in {pieces} pieces{}", Touching(.places))]
    InteriorDisconnected {
        /// The polygon.
        part: usize,
        /// How many pieces there are.
        pieces: usize,
        /// The points where two pieces touch (at most [`InvalidFigure::MAX_PLACES`]), each
        /// with an edge that starts there; or, if only other parts have a vertex there, one
        /// that passes there.
        places: Vec<(Place, [f64; 2])>,
    },
    /// Flaws of pairs of edges beyond the first [`InvalidFigure::MAX_PAIRS`].
    #[error("at least {at_least} more pairs of edges cross or overlap")]
    MorePairs {
        /// How many there are at the least.
        at_least: usize,
    },
}

impl Flaw {
    /// The parts that it concerns, ascending: which of the calls to the builder.
    #[must_use]
    pub fn parts(&self) -> Vec<usize> {
        let mut parts = match self {
            Self::Empty | Self::TooLarge { .. } | Self::MorePairs { .. } => Vec::new(),
            Self::NotFinite { at, .. }
            | Self::CoordinateRange { at, .. }
            | Self::TooFewVertices { at, .. }
            | Self::LonePoint { at, .. }
            | Self::NoSuchVertex { at }
            | Self::BadHeight { at, .. }
            | Self::SpeedCount { at, .. } => vec![at.part],
            Self::ZeroLengthEdge { edge, .. }
            | Self::EdgeIndexOutOfRange { edge, .. }
            | Self::NoSuchEdge { edge }
            | Self::BadTime { edge, .. }
            | Self::TwoChanges { edge, .. }
            | Self::TooSteep { edge, .. }
            | Self::ChangeBeforeStart { edge, .. }
            | Self::BadSpeed { edge, .. } => vec![edge.part],
            Self::DuplicateVertex { first, second, .. }
            | Self::TwoHeights { first, second, .. }
            | Self::EdgesCross { first, second, .. }
            | Self::EdgesOverlap { first, second, .. } => vec![first.part, second.part],
            Self::HoleOutsideShell { hole, .. } => vec![hole.part],
            Self::HoleInHole { inner, outer, .. } => vec![inner.part, outer.part],
            Self::ShellsOverlap { ring, other, .. } => vec![ring.part, *other],
            Self::SpeedLists { part, .. } => vec![*part],
            Self::InteriorDisconnected { part, places, .. } => {
                let touching = places.iter().map(|(place, _)| place.part);
                std::iter::once(*part).chain(touching).collect()
            }
        };
        parts.sort_unstable();
        parts.dedup();
        parts
    }
}

struct Vertex<'a>(&'a Place);
struct Edge<'a>(&'a Place);
struct Ring<'a>(&'a Place);
struct Touching<'a>(&'a [(Place, [f64; 2])]);

impl fmt::Display for Vertex<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(
            f,
            "part {}, ring {}, vertex {}",
            self.0.part, self.0.ring, self.0.index
        )
    }
}

impl fmt::Display for Edge<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(
            f,
            "part {}, ring {}, edge {}",
            self.0.part, self.0.ring, self.0.index
        )
    }
}

impl fmt::Display for Ring<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "part {}, ring {}", self.0.part, self.0.ring)
    }
}

impl fmt::Display for Touching<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (i, (place, [x, y])) in self.0.iter().enumerate() {
            let lead = if i == 0 { ", which touch at" } else { ";" };
            write!(f, "{lead} {} ({x}, {y})", Edge(place))?;
        }
        Ok(())
    }
}

/// Everything that is wrong with an input.
///
/// Its message lists the flaws, one a line, the first 20 of them; `{:#}` lists them all.
#[derive(Debug, Clone, PartialEq)]
pub struct InvalidFigure {
    /// Every flaw, at least one.
    pub flaws: Vec<Flaw>,
}

impl InvalidFigure {
    /// At most this many crossing and overlapping pairs of edges are listed.
    pub const MAX_PAIRS: usize = 10_000;

    /// At most this many touching places of one polygon are listed.
    pub const MAX_PLACES: usize = 100;
}

impl std::error::Error for InvalidFigure {}

impl fmt::Display for InvalidFigure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        const SHOWN: usize = 20;
        if let [flaw] = self.flaws.as_slice() {
            return write!(f, "{flaw}");
        }
        let shown = if f.alternate() {
            self.flaws.len()
        } else {
            SHOWN
        };
        write!(f, "{} flaws:", self.flaws.len())?;
        for flaw in self.flaws.iter().take(shown) {
            write!(f, "\n- {flaw}")?;
        }
        if self.flaws.len() > shown {
            write!(f, "\n- and {} more", self.flaws.len() - shown)?;
        }
        Ok(())
    }
}
