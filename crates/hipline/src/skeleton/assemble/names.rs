//! The names of faces: edge, side, phase.

use super::{Assembly, Side};
use crate::{
    predicates::{PlaneId, Terminal},
    wavefront::{Trace, Walk},
};

/// The name of a face, in the order of faces.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct Name {
    pub edge: u32,
    pub side: Side,
    pub phase: u32,
    /// The number of the face in the wavefront.
    pub face: u32,
}

impl Assembly<'_> {
    /// The names of all faces that are there, in order.
    pub(super) fn names(&self, terminals: &[Terminal]) -> Vec<Name> {
        let planes = self.face_planes(terminals);
        let mut names: Vec<Name> = (0..self.front.after_base.len() as u32)
            .filter(|&face| self.front.first_walk(face).is_some())
            .map(|face| self.name(face, planes[face as usize], terminals))
            .collect();
        names.sort_unstable();
        names
    }

    fn name(&self, face: u32, plane: PlaneId, terminals: &[Terminal]) -> Name {
        let (edge, side) = self.edge_and_side(plane, terminals);
        let (_, phase) = self.planes.phases.origin(plane);
        Name {
            edge,
            side,
            phase,
            face,
        }
    }

    /// The edge that a plane belongs to, and its side there.
    fn edge_and_side(&self, plane: PlaneId, terminals: &[Terminal]) -> (u32, Side) {
        let edges = self.figure.edges();
        let (first, _) = self.planes.phases.origin(plane);
        let line = (first.0 / 2) as usize;
        match terminals.get(line.wrapping_sub(edges.len())) {
            Some(terminal) => {
                let at_start = edges[terminal.edge].from.index() == terminal.tip;
                let side = if at_start { Side::Start } else { Side::End };
                (terminal.edge as u32, side)
            }
            None => (
                line as u32,
                if first.0.is_multiple_of(2) {
                    Side::Left
                } else {
                    Side::Right
                },
            ),
        }
    }

    /// The plane of each face, in the numbering of the wavefront.
    ///
    /// A face that starts at a crease may have several faces of one plane below it, whose
    /// wavefront edges went on as one; it gets its name from the first of them.
    fn face_planes(&self, terminals: &[Terminal]) -> Vec<PlaneId> {
        let front = &self.front;
        let sides = 2 * self.figure.edges().len() as u32;
        let mut planes: Vec<PlaneId> = (0..front.bases)
            .map(|face| match front.late.get(&face) {
                Some(&plane) => plane,
                None if face < sides => PlaneId(face),
                None => PlaneId(sides + 2 * (face - sides)),
            })
            .collect();
        if front.starts.is_empty() {
            return planes;
        }
        let mut face_of = vec![u32::MAX; self.next.len()];
        for face in 0..front.after_base.len() as u32 {
            if let Some(walk) = front.first_walk(face) {
                for step in self.around(self.step(walk)) {
                    face_of[step] = face;
                }
            }
        }
        for start in &front.starts {
            let (Some(old), Walk::Down(crease)) = (start.before, start.walk) else {
                planes.push(start.plane);
                continue;
            };
            let [first, end] = self.of_trace[crease.index()];
            let time = self.planes.phases.time_of(start.plane);
            let plane = (first..end)
                .map(|piece| face_of[2 * piece as usize])
                .map(|face| planes.get(face as usize).map_or(old, |&plane| plane))
                .filter_map(|plane| self.planes.phases.after(plane, time))
                .min_by_key(|&plane| self.edge_and_side(plane, terminals));
            planes.push(plane.unwrap_or(start.plane));
        }
        planes
    }

    /// Whether a trace lies between two phases of one edge.
    pub(super) fn is_crease(&self, trace: &Trace) -> bool {
        let phases = &self.planes.phases;
        let origin = |wave| phases.origin(self.front.wave(wave).plane).0;
        !phases.is_empty() && origin(trace.inn) == origin(trace.out)
    }

    /// The walk along which a face starts.
    pub(super) fn start_walk(&self, face: u32) -> Walk {
        self.front.first_walk(face).expect("the face is there")
    }
}
