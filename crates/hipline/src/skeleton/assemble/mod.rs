//! From what the propagation leaves behind to nodes, arcs and faces.
//!
//! The traces are already linked into the boundaries of the faces ([`Walk`]). What is left:
//! traces of length zero are skipped; ghost arcs are drawn through the faces that were swept
//! jointly, which cuts other arcs where they end ([`ghosts`]); faces are read off, nodes are
//! numbered and their coordinates rounded.

mod ghosts;
mod names;
mod walls;

use super::{Arc, ArcKind, Face, InputGraph, Node, NodeKind, Region, Side, Skeleton, Stats};
use crate::{
    input::Figure,
    predicates::{Bound, Place, PlaneId, Planes, Start, Terminal},
    topology::{EdgeId, FaceId, NodeId, TraceId, VertexId},
    wavefront::{End, EventNode, Trace, Walk, Wavefront},
};
use hipline_num::Sign;
use names::Name;

/// One piece of a trace, between two nodes.
#[derive(Clone, Copy, Debug)]
struct Piece {
    trace: TraceId,
    from: u32,
    to: u32,
    kind: ArcKind,
    faces: [u32; 2],
}

const NO_FACE: u32 = u32::MAX;

/// A directed piece (`2 * piece` forward, `2 * piece + 1` backward), or the base of a face
/// (`2 * pieces + face`).
type Step = usize;

/// What is not on any boundary has no next step.
const NO_STEP: u32 = u32::MAX;

/// The half-way house between wavefront and skeleton.
struct Assembly<'a> {
    figure: &'a Figure,
    planes: &'a Planes,
    front: Wavefront,
    /// The number of nodes: input vertices, then events, then the ends of ghost arcs, then
    /// nodes at infinity (which have no place).
    nodes: usize,
    /// Where the ends of ghost arcs are that are no other nodes.
    ghost_ends: Vec<Place>,
    pieces: Vec<Piece>,
    /// For each trace, its first piece and the one after its last.
    of_trace: Vec<[u32; 2]>,
    /// For each step the one after it.
    next: Vec<u32>,
    base_from: usize,
}

/// Builds the skeleton.
pub(crate) fn assemble(
    figure: &Figure,
    planes: &Planes,
    terminals: &[Terminal],
    mut front: Wavefront,
    region: Region,
    stats: Stats,
) -> Skeleton {
    for i in 0..front.traces.len() {
        let born = front.node(front.traces[i].born);
        front.traces[i].born = born;
        if let End::At(node) = front.traces[i].end {
            front.traces[i].end = End::At(front.node(node));
        }
    }
    let mut assembly = Assembly {
        figure,
        planes,
        nodes: figure.vertices().len() + front.events.len(),
        front,
        ghost_ends: Vec::new(),
        pieces: Vec::new(),
        of_trace: Vec::new(),
        next: Vec::new(),
        base_from: 0,
    };
    while assembly.draw() {}
    assembly.finish(terminals, region, stats)
}

impl Assembly<'_> {
    /// Where a node is; nothing of one at infinity.
    fn place(&self, node: u32) -> Option<Place> {
        let vertices = self.figure.vertices();
        let i = node as usize;
        if let Some(&v) = vertices.get(i) {
            return Some(Place::Vertex(v));
        }
        let i = i - vertices.len();
        if let Some(&EventNode { pair, moment }) = self.front.events.get(i) {
            return Some(Place::Event { pair, moment });
        }
        self.ghost_ends.get(i - self.front.events.len()).copied()
    }

    fn finite_place(&self, node: u32) -> Place {
        self.place(node).expect("a finite node")
    }

    /// Adds the end of a ghost arc.
    fn push_place(&mut self, place: Place) -> u32 {
        self.ghost_ends.push(place);
        self.nodes += 1;
        debug_assert_eq!(
            self.nodes,
            self.figure.vertices().len() + self.front.events.len() + self.ghost_ends.len(),
            "nodes at infinity come last"
        );
        self.nodes as u32 - 1
    }

    /// Whether a trace has length zero.
    fn is_void(trace: &Trace) -> bool {
        trace.end == End::At(trace.born)
    }

    /// Makes pieces of the traces and links them into the boundaries of the faces. Returns
    /// whether it has to be done again, without ghost arcs that separated nothing.
    fn draw(&mut self) -> bool {
        let nodes = self.nodes;
        let ghost_ends = self.ghost_ends.len();
        let landings = self.find_landings();
        self.cut_traces(&landings);
        self.link();
        self.insert_ghosts(&landings);
        let idle = if self.planes.is_unweighted() {
            Vec::new()
        } else {
            self.idle_ghosts()
        };
        if idle.is_empty() {
            return false;
        }
        for x in idle {
            let trace = self.front.trace_mut(x);
            trace.end = End::At(trace.born);
        }
        self.nodes = nodes;
        self.ghost_ends.truncate(ghost_ends);
        self.pieces.clear();
        self.of_trace.clear();
        true
    }

    /// Ghost arcs with one face on both sides. Without weights there are none; with weights
    /// a face may grow around an obstacle and meet itself.
    fn idle_ghosts(&self) -> Vec<TraceId> {
        let mut cycle = vec![0_u32; self.next.len()];
        let mut count = 0;
        for first in 0..self.next.len() {
            if cycle[first] == 0 && self.next[first] != NO_STEP {
                count += 1;
                for step in self.around(first) {
                    cycle[step] = count;
                }
            }
        }
        let ghosts = self
            .pieces
            .iter()
            .enumerate()
            .filter(|(_, piece)| piece.kind == ArcKind::Ghost);
        ghosts
            .filter(|&(p, _)| cycle[2 * p] == cycle[2 * p + 1])
            .map(|(_, piece)| piece.trace)
            .collect()
    }

    fn start_of(&self, node: u32) -> Start {
        match self.place(node) {
            Some(Place::Vertex(v)) => Start::Vertex(v),
            Some(Place::Event { pair, moment }) => Start::Event { pair, moment },
            _ => unreachable!("ghost arcs start at vertices and events"),
        }
    }

    /// Makes the pieces of all traces.
    fn cut_traces(&mut self, landings: &ghosts::Landings) {
        let mut infinite = Vec::new();
        self.pieces.reserve(self.front.traces.len());
        self.of_trace.reserve(self.front.traces.len());
        for i in 0..self.front.traces.len() {
            let id = TraceId::new(i);
            let trace = self.front.traces[i];
            let first = self.pieces.len() as u32;
            let kind = match trace.end {
                End::Ghost => ArcKind::Ghost,
                _ if self.is_crease(&trace) => ArcKind::Crease,
                _ if trace.turn == Sign::Negative && self.planes.phases.is_post(trace.pair[0]) => {
                    ArcKind::Ghost
                }
                _ if trace.turn == Sign::Negative => ArcKind::Valley,
                _ => ArcKind::Ridge,
            };
            if !Self::is_void(&trace) {
                let mut from = trace.born;
                for &to in landings.cuts(id) {
                    self.pieces.push(Piece {
                        trace: id,
                        from,
                        to,
                        kind,
                        faces: [NO_FACE; 2],
                    });
                    from = to;
                }
                let to = match trace.end {
                    End::At(node) => Some(node),
                    End::Ghost => landings.end(id),
                    End::Moving => None,
                };
                let to = to.unwrap_or_else(|| {
                    infinite.push(id);
                    (self.nodes + infinite.len() - 1) as u32
                });
                self.pieces.push(Piece {
                    trace: id,
                    from,
                    to,
                    kind,
                    faces: [NO_FACE; 2],
                });
            }
            self.of_trace.push([first, self.pieces.len() as u32]);
        }
        self.nodes += infinite.len();
    }

    /// The first step of a walk, skipping traces of length zero.
    fn step(&self, mut walk: Walk) -> Step {
        loop {
            let x = match walk {
                Walk::Base(face) => return self.base_from + face as usize,
                Walk::Open => unreachable!("every walk goes on"),
                Walk::Up(x) | Walk::Down(x) => x,
            };
            let [first, end] = self.of_trace[x.index()];
            let up = walk == Walk::Up(x);
            if first < end {
                return if up {
                    2 * first as usize
                } else {
                    2 * end as usize - 1
                };
            }
            let trace = self.front.trace(x);
            walk = if up { trace.after_up } else { trace.after_down };
        }
    }

    /// Links all steps into the boundaries of the (joint) faces.
    fn link(&mut self) {
        self.base_from = 2 * self.pieces.len();
        let faces = self.front.after_base.len();
        self.next = vec![NO_STEP; self.base_from + faces];
        for i in 0..self.front.traces.len() {
            let [first, end] = self.of_trace[i].map(|p| p as usize);
            if first == end {
                continue;
            }
            for p in first..end - 1 {
                self.next[2 * p] = 2 * p as u32 + 2;
                self.next[2 * p + 3] = 2 * p as u32 + 1;
            }
            let trace = self.front.traces[i];
            self.next[2 * end - 2] = self.step(trace.after_up) as u32;
            self.next[2 * first + 1] = self.step(trace.after_down) as u32;
        }
        for face in 0..faces {
            if self.front.after_base[face] != Walk::Open {
                self.next[self.base_from + face] = self.step(self.front.after_base[face]) as u32;
            }
        }
    }

    /// The nodes where a step starts and ends; of a base, the ends of the edge.
    fn ends(&self, step: Step) -> [u32; 2] {
        if step >= self.base_from {
            let face = step - self.base_from;
            let edges = self.figure.edges();
            return match edges.get(face / 2) {
                Some(edge) => {
                    let ends = [edge.from.index() as u32, edge.to.index() as u32];
                    if face.is_multiple_of(2) {
                        ends
                    } else {
                        [ends[1], ends[0]]
                    }
                }
                None => {
                    // A terminal: its base is the node before which the next step starts.
                    let [node, _] = self.ends(self.next[step] as usize);
                    [node, node]
                }
            };
        }
        let piece = &self.pieces[step / 2];
        if step.is_multiple_of(2) {
            [piece.from, piece.to]
        } else {
            [piece.to, piece.from]
        }
    }

    /// Walks around the boundary that a step is on.
    fn around(&self, first: Step) -> impl Iterator<Item = Step> + '_ {
        let mut at = Some(first);
        std::iter::from_fn(move || {
            let step = at?;
            let after = self.next[step] as usize;
            at = (after != first).then_some(after);
            Some(step)
        })
    }

    /// Reads off the faces, numbers the nodes, rounds the coordinates.
    fn finish(mut self, terminals: &[Terminal], region: Region, stats: Stats) -> Skeleton {
        let edges = self.figure.edges();
        // Faces by edge, then side: left, right, start, end; then phase.
        let order = self.names(terminals);
        let mut number = vec![NO_FACE; self.front.after_base.len()];
        for (i, name) in order.iter().enumerate() {
            number[name.face as usize] = i as u32;
        }
        let mut seen = vec![false; self.next.len()];
        let mut faces = Vec::with_capacity(order.len());
        let mut cycles = Vec::with_capacity(order.len() + 1);
        cycles.push(0_u32);
        let mut corners: Vec<u32> = Vec::with_capacity(3 * self.pieces.len());
        let mut inner = self.inner_cycles(&order, &mut seen);
        for &Name {
            edge,
            side,
            phase,
            face,
        } in &order
        {
            let first = cycles.len() as u32 - 1;
            self.read_cycle(
                self.step(self.start_walk(face)),
                number[face as usize],
                &mut corners,
            );
            cycles.push(corners.len() as u32);
            for start in inner.remove(&face).unwrap_or_default() {
                self.read_cycle(start, number[face as usize], &mut corners);
                cycles.push(corners.len() as u32);
            }
            faces.push(Face {
                edge: EdgeId::new(edge as usize),
                side,
                phase,
                cycles: [first, cycles.len() as u32 - 1],
            });
        }
        let (nodes, number) = self.number_nodes();
        let name = |node: u32| NodeId::new(number[node as usize] as usize);
        let is_eave = |piece: &Piece| {
            let [i, j] = piece.faces.map(|face| &faces[face as usize]);
            i.phase != j.phase && i.edge == j.edge && i.side == j.side
        };
        let mut arcs = Vec::with_capacity(self.pieces.len());
        arcs.extend(
            self.pieces
                .iter()
                .filter(|piece| piece.from != piece.to)
                .map(|piece| Arc {
                    nodes: [name(piece.from), name(piece.to)],
                    faces: piece.faces.map(|face| FaceId::new(face as usize)),
                    kind: match piece.kind {
                        // The facet went on as one with another, whose plane the trace had.
                        ArcKind::Ridge | ArcKind::Valley if is_eave(piece) => ArcKind::Crease,
                        kind => kind,
                    },
                }),
        );
        Skeleton {
            nodes,
            arcs,
            faces,
            cycles,
            corners: corners.into_iter().map(name).collect(),
            input: InputGraph {
                vertices: self.figure.vertices().len(),
                edges: edges.iter().map(|edge| [edge.from, edge.to]).collect(),
                terminals: self.figure.terminals(),
            },
            region,
            stats,
        }
    }

    /// Boundaries that no base is on, by the face they belong to.
    fn inner_cycles(
        &mut self,
        order: &[Name],
        seen: &mut [bool],
    ) -> std::collections::BTreeMap<u32, Vec<Step>> {
        for name in order {
            for step in self.around(self.step(self.start_walk(name.face))) {
                seen[step] = true;
            }
        }
        let mut inner = std::collections::BTreeMap::<u32, Vec<Step>>::new();
        for step in 0..self.base_from {
            if seen[step] {
                continue;
            }
            for other in self.around(step) {
                seen[other] = true;
            }
            let face = self.home(step, order);
            inner.entry(face).or_default().push(step);
        }
        inner
    }

    /// The face that a boundary without a base lies in.
    fn home(&mut self, orphan: Step, order: &[Name]) -> u32 {
        let trace = *self.front.trace(self.pieces[orphan / 2].trace);
        let wave = *self.front.wave(if orphan.is_multiple_of(2) {
            trace.inn
        } else {
            trace.out
        });
        let joint = self.front.joint_face(wave.face);
        let mut members: Vec<u32> = order.iter().map(|name| name.face).collect();
        members.retain(|&face| self.front.joint_face(face) == joint);
        if members.len() == 1 {
            return members[0];
        }
        let node = self
            .around(orphan)
            .map(|step| self.ends(step)[0])
            .find(|&node| {
                matches!(
                    self.place(node),
                    Some(Place::Event { .. } | Place::Vertex(_))
                )
            })
            .expect("a boundary has an event on it");
        let home = members
            .iter()
            .copied()
            .find(|&face| self.contains(face, node, wave.plane));
        home.unwrap_or_else(|| panic!("node {node} lies in no face of its plane"))
    }

    /// Whether a node lies inside the outer boundary of a face: seen along the perpendicular
    /// to the edge, one more stretch of it goes along the edge's direction below than against.
    fn contains(&self, face: u32, node: u32, plane: PlaneId) -> bool {
        let here = self.finite_place(node);
        let side = |end: u32, step: Step| match self.place(end) {
            Some(place) => self.planes.compare_along(&place, &here, plane),
            None => {
                let piece = &self.pieces[step / 2];
                match self.place(piece.from) {
                    Some(start) if piece.kind == ArcKind::Ghost => {
                        self.planes.compare_along(&start, &here, plane)
                    }
                    _ => self
                        .planes
                        .compare_far(self.front.trace(piece.trace).pair, &here, plane),
                }
            }
        };
        let mut below = 0;
        for step in self.around(self.step(self.start_walk(face))) {
            let [from, to] = self.ends(step).map(|end| side(end, step).is_gt());
            if from == to {
                continue;
            }
            let is_below = step >= self.base_from || {
                let trace = self.front.trace(self.pieces[step / 2].trace);
                let [a, b] = [trace.inn, trace.out].map(|w| self.front.wave(w).plane);
                let bound = if self.planes.turn(a, b).is_zero() {
                    match self.place(trace.born) {
                        Some(Place::Event { moment, .. }) => Some(Bound::Level(moment)),
                        _ => None,
                    }
                } else {
                    Some(Bound::Pair(trace.pair))
                };
                bound.is_none_or(|bound| {
                    let foot = Place::Foot {
                        start: self.start_of(node),
                        plane,
                        bound,
                    };
                    self.planes.compare_times(&foot, &here).is_lt()
                })
            };
            if is_below {
                below += if to { 1 } else { -1 };
            }
        }
        below == 1
    }

    /// Appends the corners along a boundary, and tells its arcs their face.
    fn read_cycle(&mut self, first: Step, face: u32, corners: &mut Vec<u32>) {
        let begin = corners.len();
        let mut step = first;
        loop {
            for node in self.ends(step) {
                if corners.len() == begin || corners.last() != Some(&node) {
                    corners.push(node);
                }
            }
            if step < self.base_from {
                self.pieces[step / 2].faces[step % 2] = face;
            }
            step = self.next[step] as usize;
            if step == first {
                break;
            }
        }
        while corners.len() > begin + 1 && corners.last() == Some(&corners[begin]) {
            corners.pop();
        }
    }

    /// Numbers the nodes that arcs end at (and all input vertices), and rounds them.
    fn number_nodes(&self) -> (Vec<Node>, Vec<u32>) {
        const UNUSED: u32 = u32::MAX;
        let vertices = self.figure.vertices().len();
        let mut number = vec![UNUSED; self.nodes];
        let mut nodes: Vec<Node> = Vec::with_capacity(self.nodes);
        for (v, &[x, y]) in self.figure.vertices().iter().enumerate() {
            number[v] = v as u32;
            nodes.push(Node {
                x,
                y,
                time: 0.0,
                kind: NodeKind::Input(VertexId::new(v)),
            });
        }
        for piece in &self.pieces {
            for node in [piece.from, piece.to] {
                if number[node as usize] != UNUSED {
                    continue;
                }
                number[node as usize] = nodes.len() as u32;
                nodes.push(match self.place(node) {
                    Some(place) => {
                        let [x, y, time] = self.planes.round(&place);
                        Node {
                            x,
                            y,
                            time,
                            kind: NodeKind::Event,
                        }
                    }
                    None => {
                        let from = nodes[number[piece.from as usize] as usize];
                        let direction = self.velocity(piece.trace);
                        Node {
                            time: f64::INFINITY,
                            kind: NodeKind::Infinite { direction },
                            ..from
                        }
                    }
                });
            }
        }
        debug_assert!(
            number[..vertices].iter().all(|&n| n != UNUSED),
            "vertices come first"
        );
        (nodes, number)
    }

    /// The velocity of a trace.
    fn velocity(&self, x: TraceId) -> [f64; 2] {
        let trace = self.front.trace(x);
        if trace.end == End::Ghost {
            self.planes
                .round_normal_velocity(self.front.wave(trace.inn).plane)
        } else {
            self.planes.round_velocity(trace.pair)
        }
    }
}
