//! Which arcs are crossed in a face: lists by face, made and forgotten in time linear in what is
//! in them, so that no distance costs anything for faces that it does not touch.

use crate::topology::FaceId;

const NONE: u32 = u32::MAX;

/// Where the wavefront starts in each face, and where it ends.
pub(super) struct ByFace {
    /// The last that was entered in each face: where it ends, where it starts.
    last: Vec<[u32; 2]>,
    /// What was entered before in the same face.
    before: Vec<[u32; 2]>,
    /// Faces in which something was entered.
    faces: Vec<FaceId>,
}

impl ByFace {
    pub(super) fn new(faces: usize) -> Self {
        Self {
            last: vec![[NONE; 2]; faces],
            before: Vec::new(),
            faces: Vec::new(),
        }
    }

    /// Forgets everything, and enters crossings given by the faces on the left and right of
    /// their arcs: in the left one the wavefront ends at the arc, in the right one it goes on.
    pub(super) fn enter(&mut self, crossings: impl Iterator<Item = [FaceId; 2]>) {
        for face in self.faces.drain(..) {
            self.last[face.index()] = [NONE; 2];
        }
        self.before.clear();
        for (k, sides) in crossings.enumerate() {
            let mut before = [NONE; 2];
            for (side, face) in sides.into_iter().enumerate() {
                let last = &mut self.last[face.index()];
                if *last == [NONE; 2] {
                    self.faces.push(face);
                }
                before[side] = std::mem::replace(&mut last[side], k as u32);
            }
            self.before.push(before);
        }
    }

    /// The faces in which something was entered.
    pub(super) fn faces(&self) -> &[FaceId] {
        &self.faces
    }

    /// The crossing where the wavefront ends in a face, and the one where it starts, if there
    /// is one of each.
    pub(super) fn only(&self, face: FaceId) -> Option<[usize; 2]> {
        let [end, start] = self.last[face.index()].map(|k| k as usize);
        let before = |k: usize, side: usize| self.before.get(k).map(|b| b[side]);
        (before(end, 0) == Some(NONE) && before(start, 1) == Some(NONE)).then_some([end, start])
    }

    /// The crossings where the wavefront ends in a face, and those where it starts.
    pub(super) fn all(&self, face: FaceId) -> [Vec<usize>; 2] {
        [0, 1].map(|side| {
            let mut list = Vec::new();
            let mut k = self.last[face.index()][side];
            while k != NONE {
                list.push(k as usize);
                k = self.before[k as usize][side];
            }
            list.reverse();
            list
        })
    }
}
