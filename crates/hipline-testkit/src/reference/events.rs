//! When the next thing happens: every vertex against every edge.

use std::cmp::Ordering;
use std::rc::Rc;

use super::model::Plane;
use super::ratio::Ratio;
use super::wave::{Corner, Piece, Wave};

impl Wave<'_> {
    /// The earliest moment after now at which an edge has shrunk to a point or a reflex vertex
    /// is on another edge; `None` if nothing will ever happen again.
    ///
    /// Every event shows up as one of these two: convex vertices are only ever met by the
    /// shrinking of edges, or by reflex vertices.
    fn next_event(&mut self) -> Option<Ratio> {
        let mut best: Option<Rc<Ratio>> = None;
        for p in 0..self.pieces.len() {
            let (start, end) = self.ends(p);
            let plane = self.plane(self.pieces[p].face);
            let key = (start.id, end.id, u32::MAX);
            let model = self.model;
            let time = self.time_of(key, || start.motion.joins(&model.field, &end.motion, plane));
            if let Some(time) = time.filter(|time| self.is_before(time, best.as_ref())) {
                best = Some(time);
            }
        }
        for v in 0..self.pieces.len() {
            if self.pieces[v].corner.turn != Ordering::Less {
                continue;
            }
            let corner = self.pieces[v].corner.clone();
            for p in 0..self.pieces.len() {
                let face = self.pieces[p].face;
                let plane = self.plane(face);
                if p == v || p == self.pieces[v].next || corner.faces.contains(&face) {
                    continue;
                }
                let key = (corner.id, face as u32, 0);
                let model = self.model;
                let time = self.time_of(key, || corner.motion.reaches(&model.field, plane));
                if let Some(time) = time.filter(|time| self.is_before(time, best.as_ref()))
                    && self.hits(&corner, p, &time)
                {
                    best = Some(time);
                }
            }
        }
        best.map(|time| (*time).clone())
    }

    /// The next moment at which anything happens: an event, or a change of speed of what is there.
    pub(super) fn next_moment(&mut self) -> Option<Ratio> {
        let event = self.next_event();
        let field = &self.model.field;
        let mut best = event;
        let planes = self.pieces.iter().flat_map(|piece| {
            let terminal = piece.corner.terminal;
            let terminal = terminal.map(|course| self.model.plane_at(course, &self.time));
            [Some(self.faces[piece.face]), terminal]
        });
        let starting = |p: usize| {
            let Plane { later, eave, .. } = &self.model.planes[p];
            later.or_else(|| eave.as_ref().map(|eave| eave.facet))
        };
        for later in planes.flatten().filter_map(starting) {
            let time = &self.model.planes[later].start;
            // The lower end of an eave is behind, as its facet has started.
            if time.compare(&self.time, field) != Ordering::Greater {
                continue;
            }
            if best
                .as_ref()
                .is_none_or(|best| time.compare(best, field) == Ordering::Less)
            {
                best = Some(time.clone());
            }
        }
        best
    }

    /// The corners at the start and the end of a piece.
    pub(super) fn ends(&self, piece: usize) -> (Rc<Corner>, Rc<Corner>) {
        let Piece {
            prev, ref corner, ..
        } = self.pieces[piece];
        (self.pieces[prev].corner.clone(), corner.clone())
    }

    /// A remembered time, if it is still to come.
    fn time_of(
        &mut self,
        key: (u32, u32, u32),
        time: impl FnOnce() -> Option<Ratio>,
    ) -> Option<Rc<Ratio>> {
        let entry = self.times.entry(key).or_insert_with(|| time().map(Rc::new));
        if entry
            .as_ref()
            .is_some_and(|time| time.compare(&self.time, &self.model.field) != Ordering::Greater)
        {
            *entry = None;
        }
        entry.clone()
    }

    fn is_before(&self, time: &Ratio, best: Option<&Rc<Ratio>>) -> bool {
        best.is_none_or(|best| time.compare(best, &self.model.field) == Ordering::Less)
    }

    /// Is a corner that is on a piece's plane then also within the (closed) piece?
    fn hits(&mut self, corner: &Corner, piece: usize, time: &Ratio) -> bool {
        let (start, end) = self.ends(piece);
        let key = (corner.id, start.id, end.id);
        if let Some(&known) = self.hits.get(&key) {
            return known;
        }
        let field = &self.model.field;
        let direction = &self.plane(self.pieces[piece].face).direction;
        let axis = usize::from(direction[0].is_zero());
        let place = corner.motion.coordinate(field, axis, time);
        let wrong = if field.sign(&direction[axis]) == Ordering::Greater {
            Ordering::Less
        } else {
            Ordering::Greater
        };
        let outside = |a: &Ratio, b: &Ratio| a.compare(b, field) == wrong;
        let hit = !outside(&place, &start.motion.coordinate(field, axis, time))
            && !outside(&end.motion.coordinate(field, axis, time), &place);
        self.hits.insert(key, hit);
        hit
    }
}
