//! From outlines of faces to traces: an arc is a pair of planes, so the two faces that it separates name the same stretch of
//! the same line, and a node is where one stretch follows another.

use super::{
    Envelope,
    faces::{Along, Outline, Side},
    profile::{Chart, Meet, Piece},
};
use crate::{
    motorcycle::tracks::{Crash, Origin},
    predicates::{Place, PlaneId},
    topology::{Sets, TraceId, WaveId},
    wavefront::{End, EventNode, Trace, Walk, Wave, Wavefront},
};
use hipline_num::Sign;
use std::collections::BTreeMap;

/// Faces on one plane that touch: from left to right.
struct Joint {
    members: Vec<u32>,
    upper: Vec<Piece<Place>>,
}

/// A stretch of a line, as a joint face names it.
struct Stretch {
    joint: u32,
    piece: u32,
    from: Place,
    to: Place,
}

/// An arc between two joint faces.
struct Arc {
    joints: [u32; 2],
    /// Along the edge of the first one.
    ends: [Place; 2],
}

/// An arc as part of the upper boundary of a joint face.
#[derive(Clone, Copy)]
struct Part {
    piece: u32,
    /// From left to right within the piece.
    rank: u32,
    arc: u32,
    /// Whether the arc's first end is on the right.
    reversed: bool,
}

/// Which things are one node.
struct Nodes {
    /// Of the numbers that one node has, the lowest stands for it: so vertices do.
    sets: Sets,
    /// Where the numbers of meetings, of tops of tracks and of ends of arcs start; those of vertices come first.
    first: [usize; 3],
}

impl Nodes {
    fn new(vertices: usize, meetings: usize, tracks: usize, arcs: usize) -> Self {
        let first = [vertices, vertices + meetings, vertices + meetings + tracks];
        Self {
            sets: Sets::new(first[2] + 2 * arcs),
            first,
        }
    }

    const fn meeting(&self, number: u32) -> usize {
        self.first[0] + number as usize
    }

    const fn top(&self, track: u32) -> usize {
        self.first[1] + track as usize
    }

    const fn end(&self, arc: u32, end: usize) -> usize {
        self.first[2] + 2 * arc as usize + end
    }
}

impl Envelope<'_> {
    /// Makes a wavefront of what is visible.
    pub(super) fn glue(&self, outlines: Vec<Option<Outline>>) -> Wavefront {
        let joints = self.join(&outlines);
        let (arcs, parts) = self.match_stretches(&joints);
        let tracks = self.tracks.motorcycles.len();
        let vertices = self.figure.vertices().len();
        let mut nodes = Nodes::new(vertices, self.tracks.meetings.len(), tracks, arcs.len());
        for (joint, parts) in joints.iter().zip(&parts) {
            self.merge_nodes(joint, parts, &outlines, &mut nodes);
        }
        let mut builder = Builder {
            envelope: self,
            outlines: &outlines,
            nodes,
            numbers: BTreeMap::new(),
            front: Wavefront::new(vertices, self.sources.len()),
            of_arc: Vec::new(),
            of_track: vec![None; tracks],
        };
        builder.add_waves();
        builder.add_arcs(&arcs, &joints);
        for &face in &self.faces {
            builder.add_valleys(face);
        }
        for (joint, parts) in joints.iter().zip(&parts) {
            builder.link(joint, parts);
        }
        builder.front
    }

    /// Puts faces on one plane that touch together.
    fn join(&self, outlines: &[Option<Outline>]) -> Vec<Joint> {
        let outline = |face: u32| {
            outlines[face as usize]
                .as_ref()
                .expect("a face of the inside")
        };
        let mut met = BTreeMap::new();
        for &face in &self.faces {
            if let Side::Met(meeting) = outline(face).sides[0] {
                met.insert((meeting, self.class(PlaneId(face))), face);
            }
        }
        let mut joints = Vec::new();
        for &first in &self.faces {
            if outline(first).sides[0] != Side::Closed {
                continue;
            }
            let mut joint = Joint {
                members: vec![first],
                upper: outline(first).upper.clone(),
            };
            let mut face = first;
            loop {
                face = match outline(face).sides[1] {
                    Side::Closed => break,
                    Side::Straight => self.beside[face as usize][1],
                    Side::Met(meeting) => *met
                        .get(&(meeting, self.class(PlaneId(face))))
                        .unwrap_or_else(|| panic!("face {face} ends at meeting {meeting} alone")),
                };
                joint.members.push(face);
                for piece in &outline(face).upper {
                    match joint.upper.last_mut() {
                        Some(last) if last.of == piece.of => last.to = piece.to,
                        _ => joint.upper.push(piece.clone()),
                    }
                }
            }
            self.name_corners(&mut joint);
            joints.push(joint);
        }
        joints
    }

    /// Where one stretch of an upper boundary follows another, three planes meet; what a merge of envelopes left there may be
    /// the end of something hidden, straight above.
    fn name_corners(&self, joint: &mut Joint) {
        let chart = Along(self, PlaneId(joint.members[0]));
        for i in 1..joint.upper.len() {
            let [a, b] = [i - 1, i].map(|k| joint.upper[k].of);
            let Meet::At(place, _) = chart.meet(a, b) else {
                panic!("the boundary of face {} jumps", joint.members[0]);
            };
            joint.upper[i - 1].to = place;
            joint.upper[i].from = place;
        }
    }

    /// Finds the arcs: the stretches on which two joint faces agree that they border on each other.
    fn match_stretches(&self, joints: &[Joint]) -> (Vec<Arc>, Vec<Vec<Part>>) {
        // Of each line, the stretches of the faces of both planes.
        let mut lines = BTreeMap::<[PlaneId; 2], [Vec<Stretch>; 2]>::new();
        for (number, joint) in joints.iter().enumerate() {
            let own = self.class(PlaneId(joint.members[0]));
            for (i, piece) in joint.upper.iter().enumerate() {
                let other = PlaneId(piece.of);
                let key = [own.min(other), own.max(other)];
                let stretch = Stretch {
                    joint: number as u32,
                    piece: i as u32,
                    from: piece.from,
                    to: piece.to,
                };
                lines.entry(key).or_default()[usize::from(own > other)].push(stretch);
            }
        }
        let mut arcs: Vec<Arc> = Vec::new();
        let mut parts: Vec<Vec<Part>> = (0..joints.len()).map(|_| Vec::new()).collect();
        for (key, mut sides) in lines {
            let chart = Along(self, key[0]);
            let mut reversed = false;
            for stretches in &mut sides {
                for s in &mut *stretches {
                    if chart.order(&s.from, &s.to).is_gt() {
                        std::mem::swap(&mut s.from, &mut s.to);
                        reversed = true;
                    }
                }
                stretches.sort_by(|s, t| chart.order(&s.from, &t.from));
            }
            let first = arcs.len();
            let [own, other] = &sides;
            let (mut i, mut j) = (0, 0);
            while i < own.len() && j < other.len() {
                let (s, t) = (&own[i], &other[j]);
                let from = if chart.order(&s.from, &t.from).is_ge() {
                    s.from
                } else {
                    t.from
                };
                let ends = chart.order(&s.to, &t.to);
                let to = if ends.is_le() { s.to } else { t.to };
                if chart.order(&from, &to).is_lt() {
                    let arc = arcs.len() as u32;
                    let part = |piece: u32, reversed: bool| {
                        let rank = arc - first as u32;
                        let rank = if reversed { u32::MAX - rank } else { rank };
                        Part {
                            piece,
                            rank,
                            arc,
                            reversed,
                        }
                    };
                    parts[s.joint as usize].push(part(s.piece, false));
                    parts[t.joint as usize].push(part(t.piece, reversed));
                    arcs.push(Arc {
                        joints: [s.joint, t.joint],
                        ends: [from, to],
                    });
                }
                i += usize::from(ends.is_le());
                j += usize::from(ends.is_ge());
            }
        }
        for list in &mut parts {
            list.sort_by_key(|part| (part.piece, part.rank));
        }
        (arcs, parts)
    }

    /// The nodes at which the boundary of a joint face goes on from one thing to the next.
    fn merge_nodes(
        &self,
        joint: &Joint,
        parts: &[Part],
        outlines: &[Option<Outline>],
        nodes: &mut Nodes,
    ) {
        for pair in parts.windows(2) {
            let [p, q] = [0, 1].map(|k| &pair[k]);
            let right = nodes.end(p.arc, usize::from(!p.reversed));
            let left = nodes.end(q.arc, usize::from(q.reversed));
            nodes.sets.join(right, left);
        }
        let sides = [joint.members.first(), joint.members.last()];
        let parts = [parts.first(), parts.last()];
        for side in 0..2 {
            let (Some(&face), Some(part)) = (sides[side], parts[side]) else {
                panic!(
                    "the face of plane {:?} has no upper boundary",
                    joint.members
                );
            };
            let valleys = &outlines[face as usize].as_ref().expect("a face").valleys[side];
            let node = match valleys.last() {
                None => self.end_of(face, side),
                Some((track, Some(_))) => nodes.top(*track),
                Some((track, None)) => match self.tracks.motorcycles[*track as usize].crash {
                    Crash::Meeting(meeting) => nodes.meeting(meeting),
                    _ => unreachable!("only meetings are visible from end to end"),
                },
            };
            let end = nodes.end(part.arc, if part.reversed { 1 - side } else { side });
            nodes.sets.join(node, end);
        }
    }

    /// The definition of a meeting.
    fn event_of(&self, meeting: u32) -> EventNode {
        let members = &self.tracks.meetings[meeting as usize].members;
        let pair = |who: u32| self.tracks.motorcycles[who as usize].pair;
        let first = pair(members[0]);
        let third = (members.iter().flat_map(|&who| pair(who))).find(|&plane| {
            !first.contains(&plane) && self.planes.do_meet([first[0], first[1], plane])
        });
        let third = third.expect("different motorcycles meet in one point");
        EventNode {
            pair: first,
            moment: super::slabs::sorted([first[0], first[1], third]),
        }
    }
}

/// Makes traces.
struct Builder<'a, 'b> {
    envelope: &'a Envelope<'b>,
    outlines: &'a [Option<Outline>],
    nodes: Nodes,
    /// The numbers of nodes of the wavefront.
    numbers: BTreeMap<usize, u32>,
    front: Wavefront,
    of_arc: Vec<TraceId>,
    of_track: Vec<Option<TraceId>>,
}

impl Builder<'_, '_> {
    fn outline(&self, face: u32) -> &Outline {
        self.outlines[face as usize]
            .as_ref()
            .expect("a face of the inside")
    }

    fn add_waves(&mut self) {
        for face in 0..self.envelope.sources.len() as u32 {
            let plane = PlaneId(face);
            self.front.waves.push(Wave { plane, face });
        }
    }

    /// The number of a node, given a place that defines it if it is new.
    fn node(&mut self, key: usize, place: Option<&Place>) -> u32 {
        let root = self.nodes.sets.root(key);
        if root < self.nodes.first[0] {
            return root as u32;
        }
        if let Some(&number) = self.numbers.get(&root) {
            return number;
        }
        let node = match place {
            Some(&Place::Event { pair, moment }) => EventNode { pair, moment },
            _ if root < self.nodes.first[1] => {
                let meeting = (root - self.nodes.first[0]) as u32;
                self.envelope.event_of(meeting)
            }
            _ => panic!("node {root} is where {place:?}, which is no event"),
        };
        let number = self.front.push_node(node);
        self.numbers.insert(root, number);
        number
    }

    fn push(&mut self, pair: [PlaneId; 2], faces: [u32; 2], ends: [u32; 2], turn: Sign) -> TraceId {
        let [inn, out] = faces.map(|face| WaveId::new(face as usize));
        self.front.push_trace(Trace {
            pair,
            inn,
            out,
            born: ends[0],
            end: End::At(ends[1]),
            turn,
            after_up: Walk::Open,
            after_down: Walk::Open,
        })
    }

    /// The ridges.
    fn add_arcs(&mut self, arcs: &[Arc], joints: &[Joint]) {
        let planes = &self.envelope.planes;
        for (number, arc) in arcs.iter().enumerate() {
            let mut ends = [0, 1].map(|k| {
                let key = self.nodes.end(number as u32, k);
                self.node(key, Some(&arc.ends[k]))
            });
            // Along the first one's edge, the second one is on the left; walking up, `inn` is.
            let mut faces = arc.joints.map(|j| joints[j as usize].members[0]);
            faces.reverse();
            let order = planes.compare_times(&arc.ends[0], &arc.ends[1]);
            if order.is_gt() {
                ends.reverse();
                faces.reverse();
            }
            let own = faces.map(PlaneId);
            let (pair, turn) = match planes.turning_left(own) {
                Some(pair) => (pair, Sign::Positive),
                None => match arc.ends[0] {
                    Place::Event { pair, .. } => (pair, Sign::Zero),
                    _ => (own, Sign::Zero),
                },
            };
            let trace = self.push(pair, faces, ends, turn);
            self.of_arc.push(trace);
        }
    }

    /// The valleys on the right of a face.
    fn add_valleys(&mut self, face: u32) {
        let valleys = self.outline(face).valleys[1].clone();
        for (track, top) in valleys {
            let motorcycle = self.envelope.tracks.motorcycles[track as usize];
            let from = match motorcycle.origin {
                Origin::Vertex(vertex) => vertex.index(),
                Origin::Meeting(meeting) => self.nodes.meeting(meeting),
                Origin::Given => unreachable!("nobody places a motorcycle in a figure"),
            };
            let to = match (top, motorcycle.crash) {
                (None, Crash::Meeting(meeting)) => self.nodes.meeting(meeting),
                _ => self.nodes.top(track),
            };
            let ends = [self.node(from, None), self.node(to, top.as_ref())];
            let faces = [motorcycle.pair[1].0, motorcycle.pair[0].0];
            let trace = self.push(motorcycle.pair, faces, ends, Sign::Negative);
            self.of_track[track as usize] = Some(trace);
        }
    }

    fn walk_of(&self, track: u32, up: bool) -> Walk {
        let trace = self.of_track[track as usize]
            .unwrap_or_else(|| panic!("track {track} is visible from one side"));
        if up {
            Walk::Up(trace)
        } else {
            Walk::Down(trace)
        }
    }

    /// Links the boundary of a joint face, counterclockwise.
    fn link(&mut self, joint: &Joint, parts: &[Part]) {
        let mut walks = Vec::new();
        for (i, &face) in joint.members.iter().enumerate() {
            if i > 0 {
                let before = joint.members[i - 1];
                let ghost = self.ghost(before, face);
                walks.extend([Walk::Up(ghost), Walk::Down(ghost)]);
                let left = self.outline(face).valleys[0].iter().rev();
                walks.extend(left.map(|&(track, _)| self.walk_of(track, false)));
            }
            walks.push(Walk::Base(face));
            let right = self.outline(face).valleys[1].iter();
            walks.extend(right.map(|&(track, _)| self.walk_of(track, true)));
        }
        for part in parts.iter().rev() {
            let trace = self.of_arc[part.arc as usize];
            // It is walked up if the joint face is that of `inn`, on the left.
            let inn = self.front.wave(self.front.trace(trace).inn).face;
            let up = joint.members[0] == inn;
            walks.push(if up {
                Walk::Up(trace)
            } else {
                Walk::Down(trace)
            });
        }
        let left = self.outline(joint.members[0]).valleys[0].iter().rev();
        let left: Vec<Walk> = left.map(|&(track, _)| self.walk_of(track, false)).collect();
        walks.extend(left);
        for (i, &walk) in walks.iter().enumerate() {
            let after = walks[(i + 1) % walks.len()];
            match walk {
                Walk::Base(face) => self.front.after_base[face as usize] = after,
                Walk::Up(x) => self.front.trace_mut(x).after_up = after,
                Walk::Down(x) => self.front.trace_mut(x).after_down = after,
                Walk::Open => unreachable!("every walk is known"),
            }
        }
    }

    /// The start of a ghost arc between two faces on one plane.
    fn ghost(&mut self, left: u32, right: u32) -> TraceId {
        let key = match self.outline(left).sides[1] {
            Side::Met(meeting) => self.nodes.meeting(meeting),
            _ => self.envelope.end_of(left, 1),
        };
        let born = self.node(key, None);
        let planes = [left, right].map(PlaneId);
        let ghost = self.push(planes, [left, right], [born; 2], Sign::Zero);
        self.front.trace_mut(ghost).end = End::Ghost;
        self.front.join_faces(left, right);
        ghost
    }
}
