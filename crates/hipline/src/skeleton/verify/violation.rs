//! What can be wrong with a skeleton.

use crate::{
    skeleton::Side,
    topology::{ArcId, EdgeId, FaceId, NodeId},
};

/// One way in which a skeleton breaks its laws.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum Violation {
    /// The skeleton's input graph is not that of the figure.
    #[error("the input graph is not the figure's")]
    OtherFigure,
    /// The region is still to be chosen.
    #[error("the region is not a definite one")]
    IndefiniteRegion,
    /// The lists of faces, boundaries and corners do not fit together.
    #[error("{face}: its boundaries are not a stretch of the list of boundaries")]
    BrokenLists {
        /// The first such face.
        face: FaceId,
    },
    /// Something names a node that does not exist.
    #[error("{face}: a corner is {node}, which does not exist")]
    NoSuchCorner {
        /// The face.
        face: FaceId,
        /// The name.
        node: NodeId,
    },
    /// An arc names a node or a face that does not exist.
    #[error("{arc}: one of its nodes or faces does not exist")]
    NoSuchEnd {
        /// The arc.
        arc: ArcId,
    },
    /// An input vertex has not got its own node, or a node claims to be another vertex.
    #[error("{node} is not the vertex that it should be, or should be none")]
    WrongVertex {
        /// The node.
        node: NodeId,
    },
    /// A side of an edge in the region has no face.
    #[error("{edge}, {side:?}: no face, or not where it belongs")]
    MissingFace {
        /// The edge.
        edge: EdgeId,
        /// Its side.
        side: Side,
    },
    /// A face too many.
    #[error("{face} belongs to no side of an edge in the region, or is there twice")]
    ExtraFace {
        /// The face.
        face: FaceId,
    },
    /// A face's boundary does not start with its base.
    #[error("{face}: its boundary does not start with its edge or terminal")]
    NoBase {
        /// The face.
        face: FaceId,
    },
    /// No arc joins two consecutive corners.
    #[error("{face}: no arc joins {from} and {to}")]
    NoArc {
        /// The face.
        face: FaceId,
        /// A corner.
        from: NodeId,
        /// The corner after it.
        to: NodeId,
    },
    /// A face is beside an arc that does not know it on that side.
    #[error("{face} passes {arc} on a side where that has another face")]
    WrongSide {
        /// The face.
        face: FaceId,
        /// The arc.
        arc: ArcId,
    },
    /// An arc is not exactly once in the boundary of each of its faces.
    #[error("{arc} is not once in the boundary of {face}")]
    NotOnce {
        /// The arc.
        arc: ArcId,
        /// The face that misses it or has it repeatedly.
        face: FaceId,
    },
    /// One face on both sides of an arc.
    #[error("{arc} has one face on both sides")]
    OneFace {
        /// The arc.
        arc: ArcId,
    },
    /// Two arcs join the same nodes.
    #[error("{first} and {second} join the same two nodes")]
    DoubleArc {
        /// An arc.
        first: ArcId,
        /// The other one.
        second: ArcId,
    },
    /// An arc ends in an input vertex or starts at infinity.
    #[error("{arc} goes the wrong way: it ends in a vertex or starts at infinity")]
    WrongWay {
        /// The arc.
        arc: ArcId,
    },
    /// An event node with fewer than three arcs, or a node at infinity with any number but one.
    #[error("{node} has {degree} arcs")]
    Degree {
        /// The node.
        node: NodeId,
        /// The number of its arcs.
        degree: usize,
    },
    /// A node whose faces' planes do not meet in a point.
    #[error("{node}: the planes of its faces do not determine it")]
    Undetermined {
        /// The node.
        node: NodeId,
    },
    /// A node that is not on the plane of one of its faces.
    #[error("{node} is not on the plane of {face}")]
    OffPlane {
        /// The node.
        node: NodeId,
        /// The face.
        face: FaceId,
    },
    /// A coordinate or time is not the f64 nearest to the exact value.
    #[error("{node}: x, y, time must be {expected:?}")]
    NotRounded {
        /// The node.
        node: NodeId,
        /// The correctly rounded values.
        expected: [f64; 3],
    },
    /// An event node at time zero or before.
    #[error("{node}: an event before the start")]
    TooEarly {
        /// The node.
        node: NodeId,
    },
    /// The second end of an arc is not later than the first.
    #[error("{arc}: its ends are not in the order of time")]
    NotLater {
        /// The arc.
        arc: ArcId,
    },
    /// An arc of one height without length, or of non-parallel planes.
    #[error("{arc} has no length")]
    NoLength {
        /// The arc.
        arc: ArcId,
    },
    /// An arc is not of the kind that its planes make it.
    #[error("{arc} is of the wrong kind")]
    WrongKind {
        /// The arc.
        arc: ArcId,
    },
    /// A ghost arc is not perpendicular to its edge.
    #[error("{arc}: a ghost arc that is not perpendicular to its edge")]
    Slanted {
        /// The arc.
        arc: ArcId,
    },
    /// The direction of a node at infinity is not the correctly rounded velocity.
    #[error("{node}: its direction must be {expected:?}")]
    WrongDirection {
        /// The node.
        node: NodeId,
        /// The correctly rounded velocity.
        expected: [f64; 2],
    },
    /// A valley starts where neither a vertex is nor two valleys end.
    #[error("{arc}: a valley starts at {node} out of nothing")]
    ValleyFromNothing {
        /// The arc.
        arc: ArcId,
        /// Its lower end.
        node: NodeId,
    },
    /// No arc comes up to a node: a local minimum of the roof.
    #[error("{node}: no arc leads up to it")]
    LocalMinimum {
        /// The node.
        node: NodeId,
    },
    /// An arc goes the wrong way along the edge of one of its faces.
    #[error("{face}: {arc} goes the wrong way along its edge")]
    WrongProgress {
        /// The face.
        face: FaceId,
        /// The arc.
        arc: ArcId,
    },
    /// A face is not monotone to its edge.
    #[error("{face} is not monotone to its edge")]
    NotMonotone {
        /// The face.
        face: FaceId,
    },
    /// The upper and the lower boundary of a face touch or cross.
    #[error("{face}: its boundary meets itself at {node}")]
    MeetsItself {
        /// The face.
        face: FaceId,
        /// A corner on the wrong side of a piece of the boundary.
        node: NodeId,
    },
    /// A face whose boundary runs clockwise.
    #[error("{face}: its boundary is clockwise")]
    Clockwise {
        /// The face.
        face: FaceId,
    },
    /// The faces around a node are not one cycle, in the order of their arcs' directions.
    #[error("{node}: the faces around it do not follow one another once around")]
    Unordered {
        /// The node.
        node: NodeId,
    },
    /// The faces are not one cycle at infinity.
    #[error("the unbounded faces do not follow one another once around")]
    UnorderedAtInfinity,
    /// Euler's formula does not hold.
    #[error(
        "{nodes} nodes - {arcs} arcs and edges + {faces} faces, in {parts} parts: not a plane graph"
    )]
    Euler {
        /// Nodes, infinity as one.
        nodes: usize,
        /// Arcs and edges.
        arcs: usize,
        /// Boundaries.
        faces: usize,
        /// Connected parts.
        parts: usize,
    },
    /// The number of faces or of nodes breaks Lemma 2 of the 1996 paper.
    #[error("{found} {what}, but {expected} expected")]
    Count {
        /// What was counted.
        what: &'static str,
        /// How many there are.
        found: i64,
        /// How many there must be.
        expected: i64,
    },
}

/// All violations found, at least one.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[error("{total} violations; the first: {}", .list[0])]
pub struct Violations {
    /// The first [`Violations::CAP`] of them.
    pub list: Vec<Violation>,
    /// How many there are.
    pub total: usize,
}

impl Violations {
    /// How many violations are kept.
    pub const CAP: usize = 1000;
}

/// Collects violations.
#[derive(Debug, Default)]
pub(super) struct Report {
    list: Vec<Violation>,
    total: usize,
}

impl Report {
    pub(super) fn add(&mut self, violation: Violation) {
        if self.list.len() < Violations::CAP {
            self.list.push(violation);
        }
        self.total += 1;
    }

    pub(super) const fn is_empty(&self) -> bool {
        self.total == 0
    }

    pub(super) fn into_result(self) -> Result<(), Violations> {
        if self.is_empty() {
            Ok(())
        } else {
            Err(Violations {
                list: self.list,
                total: self.total,
            })
        }
    }
}
