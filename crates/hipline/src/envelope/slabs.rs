//! Slabs: half-strips of slope one above an edge or above the track of a motorcycle (chapter 2 of the thesis).
//!
//! A slab of plane i is bounded below by its source, which starts and ends at known places of the plane, and on the sides by the
//! perpendiculars to i's edge through these. Above the track of planes i and j, the places of plane i are those that plane j has passed:
//! that is a question about signs. So a slab is cut with a plane k by asking for places on the line of i and k.

use super::{Envelope, Shared, SlabRef};
use crate::{
    motorcycle::tracks::{Crash, Origin},
    predicates::{Bound, Place, PlaneId, Start},
};
use hipline_num::Sign;
use smallvec::SmallVec;

/// A half-strip of a plane.
#[derive(Clone, Debug)]
pub(super) struct Slab {
    pub plane: PlaneId,
    /// The ends of its source, in the direction of the plane's edge.
    pub ends: [Start; 2],
    /// The other plane of the track, if its source is a track.
    pub beside: Option<PlaneId>,
    /// The number of the track.
    pub track: Option<u32>,
}

/// What belongs to the face of one side of an edge.
#[derive(Clone, Debug, Default)]
pub(super) struct Sources {
    /// The tracks that leave the start of the wavefront edge, and those that leave its end, going away from the edge.
    pub tracks: [Vec<u32>; 2],
    /// From left to right.
    pub slabs: Vec<Slab>,
}

/// Where a motorcycle is, as the start of a side of a slab.
fn start_of(place: &Place) -> Start {
    match *place {
        Place::Vertex(v) => Start::Vertex(v),
        Place::Event { pair, moment } => Start::Event { pair, moment },
        Place::On { pair, rail } => Start::On { pair, rail },
        Place::At { .. } | Place::Foot { .. } => unreachable!("no motorcycle starts or ends there"),
    }
}

impl Shared<'_> {
    /// Finds the slabs of all faces.
    pub(super) fn find_slabs(&mut self) {
        let vertices = self.figure.vertices().to_vec();
        let mut first: Vec<[Option<u32>; 2]> = vec![[None; 2]; self.sources.len()];
        for (number, track) in self.tracks.motorcycles.iter().enumerate() {
            if let Origin::Vertex(_) = track.origin {
                // The wavefront edge of the first plane starts at it, that of the second one ends at it.
                for side in 0..2 {
                    first[track.pair[side].0 as usize][side] = Some(number as u32);
                }
            }
        }
        for face in self.faces.clone() {
            let plane = PlaneId(face);
            let tracks = [0, 1].map(|side| self.chain(plane, side, first[face as usize][side]));
            let slab = |side: usize, number: u32| {
                let track = &self.tracks.motorcycles[number as usize];
                let end = track
                    .end
                    .as_ref()
                    .expect("inside of polygons nobody escapes");
                let mut ends = [&track.start, end].map(start_of);
                if side == 0 {
                    ends.reverse();
                }
                Slab {
                    plane,
                    ends,
                    beside: Some(track.pair[1 - side]),
                    track: Some(number),
                }
            };
            let edge = &self.figure.edges()[face as usize / 2];
            let mut ends = [edge.from, edge.to].map(|v| Start::Vertex(vertices[v.index()]));
            if face % 2 == 1 {
                ends.reverse();
            }
            let mut slabs: Vec<Slab> = tracks[0].iter().rev().map(|&t| slab(0, t)).collect();
            slabs.push(Slab {
                plane,
                ends,
                beside: None,
                track: None,
            });
            slabs.extend(tracks[1].iter().map(|&t| slab(1, t)));
            for (index, slab) in slabs.iter().enumerate() {
                let number = self.refs.len() as u32;
                let index = index as u32;
                self.refs.push(SlabRef { face, index });
                if let Some(track) = slab.track {
                    let pair = self.tracks.motorcycles[track as usize].pair;
                    let side = usize::from(pair[1] == plane);
                    self.slabs_of_track[track as usize][side] = number;
                }
            }
            self.sources[face as usize] = Sources { tracks, slabs };
        }
    }

    /// The tracks of one end of a wavefront edge: where a motorcycle meets others and the one that
    /// starts there has the plane, too, that goes on.
    fn chain(&self, plane: PlaneId, side: usize, first: Option<u32>) -> Vec<u32> {
        let mut chain = Vec::new();
        let mut next = first;
        while let Some(number) = next {
            chain.push(number);
            next = match self.tracks.motorcycles[number as usize].crash {
                Crash::Meeting(meeting) => self.tracks.meetings[meeting as usize].child,
                _ => None,
            };
            next = next.filter(|&c| self.tracks.motorcycles[c as usize].pair[side] == plane);
        }
        chain
    }
}

impl Envelope<'_> {
    /// A moment when two parallel planes meet: that of a third plane is no matter.
    pub(super) fn level(&self, e: PlaneId, g: PlaneId) -> [PlaneId; 3] {
        let across = if self.planes.turn(e, self.across[0]).is_zero() {
            self.across[1]
        } else {
            self.across[0]
        };
        sorted([e, g, across])
    }

    /// The stretch on which the plane of one slab meets that of another within both, in the direction of the
    /// first one's edge.
    pub(super) fn cut(&self, own: &Slab, other: &Slab) -> Option<[Place; 2]> {
        let (e, g) = (own.plane, other.plane);
        match self.planes.turning_left([e, g]) {
            Some(pair) => self.cut_slanted(pair, own, other),
            None if self.planes.same_direction(e, g) => None,
            None => self.cut_level(own, other),
        }
    }

    fn cut_slanted(&self, pair: [PlaneId; 2], own: &Slab, other: &Slab) -> Option<[Place; 2]> {
        let planes = &self.planes;
        let mut low = Place::At { pair, time: 0.0 };
        let mut high: Option<Place> = None;
        let mut later = |place: Place, is_low: bool| {
            if is_low {
                if planes.compare_times(&low, &place).is_lt() {
                    low = place;
                }
            } else if high
                .as_ref()
                .is_none_or(|high| planes.compare_times(&place, high).is_lt())
            {
                high = Some(place);
            }
            high.as_ref()
                .is_none_or(|high| planes.compare_times(&low, high).is_lt())
        };
        let shared: SmallVec<[Start; 2]> = (own.ends.iter().copied())
            .filter(|end| other.ends.contains(end))
            .collect();
        for (slab, beyond) in [(own, other.plane), (other, own.plane)] {
            if let Some(x) = slab.beside {
                if self.class(x) == self.class(beyond) {
                    return None;
                }
                let place = || Place::Event {
                    pair,
                    moment: sorted([pair[0], pair[1], x]),
                };
                match planes.closing([x, pair[0], pair[1]]) {
                    Sign::Zero if planes.lead_always(pair, x).is_positive() => return None,
                    Sign::Zero => {}
                    sign if !later(place(), sign.is_positive()) => return None,
                    _ => {}
                }
            }
            let forward = planes.drift(pair, slab.plane).is_positive();
            for side in 0..2 {
                let start = slab.ends[side];
                // Both planes pass through a vertex that both slabs have, at time zero.
                let foot = if matches!(start, Start::Vertex(_)) && shared.contains(&start) {
                    Place::At { pair, time: 0.0 }
                } else {
                    Place::Foot {
                        start,
                        plane: slab.plane,
                        bound: Bound::Pair(pair),
                    }
                };
                if !later(foot, forward == (side == 0)) {
                    return None;
                }
            }
        }
        let mut ends = [low, high?];
        if planes.drift(pair, own.plane).is_negative() {
            ends.reverse();
        }
        Some(ends)
    }

    fn cut_level(&self, own: &Slab, other: &Slab) -> Option<[Place; 2]> {
        let (planes, e) = (&self.planes, own.plane);
        let moment = self.level(e, other.plane);
        let mut ends: [Option<Place>; 2] = [None; 2];
        let mut narrow = |place: Place, side: usize| {
            let order = |p: &Place| {
                let order = planes.compare_along(&place, p, e);
                if side == 0 { order } else { order.reverse() }
            };
            if ends[side].as_ref().is_none_or(|p| order(p).is_gt()) {
                ends[side] = Some(place);
            }
        };
        for slab in [own, other] {
            if let Some(x) = slab.beside {
                let pair = planes
                    .turning_left([e, x])
                    .expect("a track has slanted planes");
                let place = Place::Event {
                    pair,
                    moment: sorted([e, other.plane, x]),
                };
                narrow(place, usize::from(planes.turn(e, x).is_negative()));
            }
            for side in 0..2 {
                let foot = Place::Foot {
                    start: slab.ends[side],
                    plane: slab.plane,
                    bound: Bound::Level(moment),
                };
                narrow(foot, if slab.plane == e { side } else { 1 - side });
            }
        }
        let [Some(from), Some(to)] = ends else {
            return None;
        };
        let zero = Place::Vertex(self.figure.vertices()[0]);
        let is_later = planes.compare_times(&from, &zero).is_gt();
        (is_later && planes.compare_along(&from, &to, e).is_lt()).then_some([from, to])
    }
}

/// Planes in ascending order, as moments have them.
pub(super) fn sorted(mut planes: [PlaneId; 3]) -> [PlaneId; 3] {
    planes.sort_unstable();
    planes
}
