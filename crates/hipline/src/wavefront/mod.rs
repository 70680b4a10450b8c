//! The wavefront and what it leaves behind: vertices, their traces, the faces' boundaries.
//! Every engine makes one, and [`assemble`](crate::skeleton) makes the skeleton of it.
//!
//! A wavefront vertex between the wavefront edges `inn` (which ends at it) and `out` (which
//! starts at it) traces an arc. The boundary of a face, counterclockwise, goes along the
//! face's base, then up the traces of its wavefront edge's end, then down the traces of its
//! start. So each trace is walked up in the face of `inn` and down in the face of `out`,
//! and each change of the wavefront links two such walks. The faces need no other record.

mod queue;

use crate::predicates::PlaneId;
use crate::topology::{Sets, TraceId, WaveId};
use hipline_num::Sign;
pub(crate) use queue::Queue;
use std::collections::BTreeMap;

/// A step of a face's boundary.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Walk {
    /// Not yet known.
    Open,
    /// Along a trace, forward in time; the face is that of the trace's `inn`.
    Up(TraceId),
    /// Along a trace, backward in time; the face is that of the trace's `out`.
    Down(TraceId),
    /// Along the base of the face with this number.
    Base(u32),
}

/// How a trace ends.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum End {
    /// It still moves; at the end of the propagation: it moves for ever.
    Moving,
    /// At a node (by its number; the input vertices come first).
    At(u32),
    /// Both its wavefront edges lie on one plane: they go on as one, and the ghost arc is
    /// found when the face is known.
    Ghost,
}

/// A wavefront vertex.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Trace {
    /// Two planes on which it lies, the first turning left into the second. Where its own
    /// two planes are parallel (it then lives for no time at all) they may be others that
    /// pass through its place.
    pub pair: [PlaneId; 2],
    /// The wavefront edge that ends here.
    pub inn: WaveId,
    /// The wavefront edge that starts here.
    pub out: WaveId,
    /// The node where it starts.
    pub born: u32,
    /// How it ends.
    pub end: End,
    /// The turn from `inn` to `out`: positive is convex, negative reflex, zero parallel.
    pub turn: Sign,
    /// The walk after `Up(self)`.
    pub after_up: Walk,
    /// The walk after `Down(self)`.
    pub after_down: Walk,
}

/// A wavefront edge: a piece of a face's plane.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Wave {
    /// The plane it moves on.
    pub plane: PlaneId,
    /// The number of the face it sweeps.
    pub face: u32,
}

/// A node with time above zero, by definition: the vertex of two planes at the moment when
/// three planes meet.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct EventNode {
    pub pair: [PlaneId; 2],
    pub moment: [PlaneId; 3],
}

/// How a face of a later phase starts.
#[derive(Clone, Copy, Debug)]
pub(crate) struct FaceStart {
    /// The first walk of its boundary; `Open` if the face is gone again.
    pub walk: Walk,
    /// Its plane.
    pub plane: PlaneId,
    /// The plane of the face before, if it starts at a crease of one height.
    pub before: Option<PlaneId>,
}

/// Everything that the propagation leaves behind.
#[derive(Debug, Default)]
pub(crate) struct Wavefront {
    pub traces: Vec<Trace>,
    pub waves: Vec<Wave>,
    /// Number of input vertices, which are the first nodes.
    pub vertices: u32,
    /// Nodes with time above zero.
    pub events: Vec<EventNode>,
    /// Event nodes that were found to be one.
    same: Sets,
    /// For each face, the walk after its base.
    pub after_base: Vec<Walk>,
    /// Faces that were found to share a plane.
    joint: Sets,
    /// The number of faces that start at edges and terminals. The others start at creases.
    pub bases: u32,
    /// Where the others start, in order.
    pub starts: Vec<FaceStart>,
    /// The planes of faces of terminals that started late.
    pub late: BTreeMap<u32, PlaneId>,
}

impl Wavefront {
    pub(crate) fn new(vertices: usize, faces: usize) -> Self {
        Self {
            // About as many nodes as vertices.
            events: Vec::with_capacity(vertices),
            same: Sets::with_capacity(vertices),
            vertices: vertices as u32,
            after_base: vec![Walk::Open; faces],
            joint: Sets::new(faces),
            bases: faces as u32,
            ..Self::default()
        }
    }

    pub(crate) fn trace(&self, x: TraceId) -> &Trace {
        &self.traces[x.index()]
    }

    pub(crate) fn trace_mut(&mut self, x: TraceId) -> &mut Trace {
        &mut self.traces[x.index()]
    }

    pub(crate) fn wave(&self, w: WaveId) -> &Wave {
        &self.waves[w.index()]
    }

    pub(crate) fn push_trace(&mut self, trace: Trace) -> TraceId {
        self.traces.push(trace);
        TraceId::new(self.traces.len() - 1)
    }

    /// Adds a face that does not start at an edge or terminal.
    pub(crate) fn push_face(&mut self, start: FaceStart) -> u32 {
        let face = self.after_base.len() as u32;
        self.starts.push(start);
        self.after_base.push(Walk::Open);
        self.joint.push();
        face
    }

    /// Names the first walk of a face.
    pub(crate) fn start_face_with(&mut self, face: u32, walk: Walk) {
        self.starts[(face - self.bases) as usize].walk = walk;
    }

    /// The walk along which a face starts, if it is there.
    pub(crate) fn first_walk(&self, face: u32) -> Option<Walk> {
        match face.checked_sub(self.bases) {
            Some(i) => Some(self.starts[i as usize].walk).filter(|&walk| walk != Walk::Open),
            None if self.after_base[face as usize] == Walk::Open => None,
            None => Some(Walk::Base(face)),
        }
    }

    /// Adds an event node.
    pub(crate) fn push_node(&mut self, node: EventNode) -> u32 {
        self.events.push(node);
        self.same.push();
        self.vertices + self.events.len() as u32 - 1
    }

    /// The representative of a node.
    pub(crate) fn node(&mut self, node: u32) -> u32 {
        if node < self.vertices {
            node
        } else {
            self.vertices + self.same.root((node - self.vertices) as usize) as u32
        }
    }

    /// Two nodes are found to be one.
    pub(crate) fn same_node(&mut self, a: u32, b: u32) -> u32 {
        let (a, b) = (self.node(a), self.node(b));
        let (low, high) = (a.min(b), a.max(b));
        if low != high {
            assert!(
                low >= self.vertices,
                "nodes {low} and {high} are not at one time"
            );
            let [low, high] = [low, high].map(|node| (node - self.vertices) as usize);
            self.same.join(low, high);
        }
        low
    }

    /// The representative of the faces that share a plane with this one and touch it.
    pub(crate) fn joint_face(&mut self, face: u32) -> u32 {
        self.joint.root(face as usize) as u32
    }

    /// Two faces on one plane have met.
    pub(crate) fn join_faces(&mut self, a: u32, b: u32) {
        self.joint.join(a as usize, b as usize);
    }

    /// A wavefront edge ends at `new` instead of `old`, at one place.
    pub(crate) fn end_moves(&mut self, old: TraceId, new: TraceId) {
        self.trace_mut(old).after_up = Walk::Up(new);
    }

    /// A wavefront edge starts at `new` instead of `old`, at one place.
    pub(crate) fn start_moves(&mut self, old: TraceId, new: TraceId) {
        self.trace_mut(new).after_down = Walk::Down(old);
    }

    /// A wavefront edge from `start` to `end` has vanished.
    pub(crate) fn vanishes(&mut self, start: TraceId, end: TraceId) {
        self.trace_mut(end).after_up = Walk::Down(start);
    }

    /// A wavefront edge was cut in two: the first part ends at `end`, the second starts at
    /// `start`, both new.
    pub(crate) fn is_cut(&mut self, end: TraceId, start: TraceId) {
        self.trace_mut(start).after_down = Walk::Up(end);
    }
}
