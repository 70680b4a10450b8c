//! Faces: what is visible of the slabs of one edge.
//!
//! Seen along its edge, a face is what lies between its sources, below, and the lower envelope of the stretches on which
//! its plane meets other slabs, above. The edge is visible from end to end. A track is visible from its start up to where
//! the envelope comes down to it: that is the end of the valley. Because the roof climbs nowhere faster than
//! a slab, whatever is straight below a visible place of a slab is visible, too; so a face has no holes.

use super::{
    Envelope,
    profile::{Chart, Meet, Piece, lower_envelope},
    slabs::sorted,
};
use crate::{
    motorcycle::tracks::Crash,
    predicates::{Place, PlaneId, Start},
};
use std::cmp::Ordering;

/// The plane of a face, seen along its edge: the curves are where other planes meet it.
pub(super) struct Along<'a, 'b>(pub &'a Envelope<'b>, pub PlaneId);

impl Along<'_, '_> {
    /// What a place is straight above of, if its definition tells.
    fn start_below(&self, place: &Place) -> Option<Start> {
        match *place {
            Place::Vertex(v) => Some(Start::Vertex(v)),
            Place::Event { pair, moment } => Some(Start::Event { pair, moment }),
            Place::On { pair, rail } => Some(Start::On { pair, rail }),
            Place::Foot { start, plane, .. } => (plane == self.1).then_some(start),
            Place::At { .. } => None,
        }
    }

    /// A place at which the plane meets another one.
    fn sample(&self, other: PlaneId) -> Place {
        let e = self.1;
        match self.0.planes.turning_left([e, other]) {
            Some(pair) => Place::At { pair, time: 0.0 },
            None => {
                let moment = self.0.level(e, other);
                let third = moment.into_iter().find(|&k| k != e && k != other);
                let third = third.expect("a third plane");
                let pair = self
                    .0
                    .planes
                    .turning_left([e, third])
                    .expect("it is across");
                Place::Event { pair, moment }
            }
        }
    }
}

/// Whether both are where the same three planes meet.
fn is_same_meeting(p: &Place, q: &Place) -> bool {
    let (
        Place::Event { pair, moment },
        Place::Event {
            pair: other,
            moment: same,
        },
    ) = (p, q)
    else {
        return false;
    };
    moment == same && pair.iter().chain(other).all(|plane| moment.contains(plane))
}

impl Chart for Along<'_, '_> {
    type Spot = Place;

    fn order(&self, p: &Place, q: &Place) -> Ordering {
        // The sides of slabs are perpendiculars: many places lie straight above one start, which is costly to find out.
        let [a, b] = [p, q].map(|place| self.start_below(place));
        if a.is_some() && a == b || is_same_meeting(p, q) {
            return Ordering::Equal;
        }
        self.0.planes.compare_along(p, q, self.1)
    }

    fn meet(&self, a: u32, b: u32) -> Meet<Place> {
        let (planes, e) = (&self.0.planes, self.1);
        let [a, b] = [PlaneId(a), PlaneId(b)];
        let pairs = [a, b].map(|other| planes.turning_left([e, other]));
        let (Some(pair), true) = (pairs[0].or(pairs[1]), planes.do_meet([e, a, b])) else {
            return Meet::Never(planes.ahead(&self.sample(a), b));
        };
        let place = Place::Event {
            pair,
            moment: sorted([e, a, b]),
        };
        // How far the curve of a is ahead of b, going right.
        let gain = match pairs[0] {
            Some(pair) => -planes.closing([b, pair[0], pair[1]]) * planes.drift(pair, e),
            None => -planes.turn(e, b),
        };
        Meet::At(place, gain)
    }
}

/// How a face ends on its left or right.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Side {
    /// At a node: the upper boundary comes down to the end of the edge or of a valley.
    Closed,
    /// The face of a wavefront edge on the same plane is beside it, from a vertex on.
    Straight,
    /// The same, from the meeting with this number on.
    Met(u32),
}

/// A face.
#[derive(Clone, Debug)]
pub(super) struct Outline {
    /// The visible tracks on its left and right, going away from the edge, with the visible tops of the last ones; where there is
    /// none, the track is visible from end to end.
    pub valleys: [Vec<(u32, Option<Place>)>; 2],
    pub sides: [Side; 2],
    /// Its upper boundary, from left to right: which planes are beyond it, by class.
    pub upper: Vec<Piece<Place>>,
}

impl Envelope<'_> {
    /// Finds what is visible of a face, given the faces that may border on it.
    pub(super) fn outline(&mut self, face: u32, others: &[u32]) -> Outline {
        let shared = self.shared.clone();
        let own = &shared.sources[face as usize];
        let mut pieces = Vec::new();
        for &other in others {
            for slab in &own.slabs {
                for beyond in &shared.sources[other as usize].slabs {
                    self.count.cuts += 1;
                    if let Some([from, to]) = self.cut(slab, beyond) {
                        let of = self.class(PlaneId(other)).0;
                        pieces.push(Piece { from, to, of });
                    }
                }
            }
        }
        let mut count = self.count;
        let chart = Along(self, PlaneId(face));
        let upper = lower_envelope(&chart, pieces, &mut count.merging);
        let [left, right] = [0, 1].map(|side| self.descend(face, side, &upper));
        let upper = self.between(face, upper, [left.2, right.2]);
        self.count = count;
        Outline {
            valleys: [left.0, right.0],
            sides: [left.1, right.1],
            upper,
        }
    }

    /// Goes along the tracks on one side of a face until the upper boundary comes down to them. Returns the valleys, how the face
    /// ends there, and where.
    fn descend(
        &self,
        face: u32,
        side: usize,
        upper: &[Piece<Place>],
    ) -> (Vec<(u32, Option<Place>)>, Side, Place) {
        let plane = PlaneId(face);
        let chart = Along(self, plane);
        let mut valleys = Vec::new();
        let vertex = self.figure.vertices()[self.end_of(face, side)];
        let mut last = (Side::Closed, Place::Vertex(vertex));
        if self.sources[face as usize].tracks[side].is_empty() {
            let beside = self.beside[face as usize][side];
            if self.class(PlaneId(beside)) == self.class(plane) {
                last.0 = Side::Straight;
            }
        }
        for &number in &self.sources[face as usize].tracks[side] {
            let track = &self.tracks.motorcycles[number as usize];
            let end = track
                .end
                .as_ref()
                .expect("inside of polygons nobody escapes");
            let x = self.class(track.pair[1 - side]);
            if let Some(top) = self.top(&chart, side, upper, [&track.start, end], x) {
                let is_end = chart.order(&top, end).is_eq();
                if is_end && let Crash::Meeting(_) = track.crash {
                    // Visible from end to end, but nothing beyond.
                    valleys.push((number, None));
                } else {
                    valleys.push((number, Some(top)));
                }
                return (valleys, Side::Closed, top);
            }
            valleys.push((number, None));
            let Crash::Meeting(meeting) = track.crash else {
                panic!("the track of motorcycle {number} is visible from end to end");
            };
            last = (Side::Met(meeting), *end);
        }
        (valleys, last.0, last.1)
    }

    /// Where the upper boundary comes down to a track, beyond its start.
    fn top(
        &self,
        chart: &Along,
        side: usize,
        upper: &[Piece<Place>],
        [start, end]: [&Place; 2],
        x: PlaneId,
    ) -> Option<Place> {
        let outward = |p: &Place, q: &Place| {
            let order = chart.order(p, q);
            if side == 0 { order.reverse() } else { order }
        };
        let count = upper.len();
        for i in 0..count {
            let piece = &upper[if side == 0 { count - 1 - i } else { i }];
            let (near, far) = if side == 0 {
                (&piece.to, &piece.from)
            } else {
                (&piece.from, &piece.to)
            };
            if outward(far, start).is_le() {
                continue;
            }
            if outward(near, end).is_gt() {
                break;
            }
            if piece.of == x.0 {
                continue;
            }
            // Positive if the piece is below the track on the right of where they cross.
            let Meet::At(cross, below) = chart.meet(piece.of, x.0) else {
                continue;
            };
            let sinks = if side == 0 { -below } else { below };
            let inside = outward(&cross, near).is_ge() && outward(&cross, far).is_le();
            let on_track = outward(&cross, start).is_gt() && outward(&cross, end).is_le();
            if sinks.is_positive() && inside && on_track {
                return Some(cross);
            }
        }
        None
    }

    /// The part of an envelope between two places.
    fn between(
        &self,
        face: u32,
        list: Vec<Piece<Place>>,
        [left, right]: [Place; 2],
    ) -> Vec<Piece<Place>> {
        let chart = Along(self, PlaneId(face));
        let mut part = Vec::with_capacity(list.len());
        for mut piece in list {
            if chart.order(&piece.from, &left).is_le() {
                piece.from = left;
            }
            if chart.order(&piece.to, &right).is_ge() {
                piece.to = right;
            }
            if chart.order(&piece.from, &piece.to).is_lt() {
                part.push(piece);
            }
        }
        part
    }
}
