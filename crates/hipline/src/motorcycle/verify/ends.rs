//! Where each ends, by definition; that it gets there, and that the numbers are rounded correctly.

use super::{Checker, GraphViolation, Rider, Stage, Walls};
use crate::{
    motorcycle::{
        births,
        model::{End, Spot},
    },
    predicates::{Place, PlaneId, Rail, lines_of_wall},
    topology::{MeetingId, MotorcycleId},
};

impl Checker<'_> {
    pub(super) fn check_ends(&mut self) {
        for (i, motorcycle) in self.graph.motorcycles().iter().enumerate() {
            let id = MotorcycleId::new(i);
            let rider = &self.riders[i];
            let stop = match motorcycle.end {
                End::Escape => None,
                end => {
                    let stop = self.end_of(rider, end, motorcycle.stop);
                    let stop = stop.map(|place| self.instant(place));
                    let Some(stop) = stop.filter(|t| self.compare(t, &rider.start).is_ge()) else {
                        self.list.push(GraphViolation::NoWay { motorcycle: id });
                        continue;
                    };
                    Some(stop)
                }
            };
            let told = motorcycle.velocity.map(|x| (x + 0.0).to_bits());
            let velocity = self.planes.round_velocity(rider.pair);
            let is_rounded = told == velocity.map(|x| (x + 0.0).to_bits())
                && self.is_rounded(motorcycle.start, &rider.start.place)
                && (motorcycle.stop.iter().zip(&stop))
                    .all(|(spot, stop)| self.is_rounded(*spot, &stop.place));
            if !is_rounded {
                self.list
                    .push(GraphViolation::NotRounded { motorcycle: id });
            }
            self.riders[i].stop = stop;
        }
        if self.list.is_empty() {
            self.check_meetings();
        }
    }

    /// Where a motorcycle with an end like this one ends, if its way leads there.
    fn end_of(&self, rider: &Rider, end: End, stop: Option<Spot>) -> Option<Place> {
        let pair = rider.pair;
        let crosses = |plane: PlaneId| !self.planes.moves_away(pair, plane).is_zero();
        let on = |plane: PlaneId| Place::On {
            pair,
            rail: Rail::Edge(plane),
        };
        match end {
            End::Escape => None,
            End::Edge(edge, _) => {
                let plane = PlaneId(2 * edge.index() as u32);
                crosses(plane).then(|| on(plane))
            }
            End::Vertex(vertex) => self.at_vertex(pair, vertex.index()),
            End::Wall(wall) => {
                let Walls::Given(count, _) = self.walls else {
                    return None;
                };
                let [line, posts @ ..] = lines_of_wall(count, wall.index());
                if crosses(line) {
                    return Some(on(line));
                }
                let [p, q] = posts.map(|post| self.instant(on(post)));
                let near = if self.compare(&p, &q).is_le() { p } else { q };
                let is_ahead = self.compare(&near, &rider.start).is_gt();
                Some(if is_ahead {
                    near.place
                } else {
                    rider.start.place
                })
            }
            End::Track(other) => {
                let other = &self.riders[other.index()];
                if !self.planes.turn_of_paths(pair, other.pair).is_zero() {
                    let rail = Rail::Path(other.pair);
                    return Some(Place::On { pair, rail });
                }
                // It stops at its own start, if the other one came through it before, or at that one's.
                let there = passing(pair, other)?;
                let at_once = stop.is_some_and(|stop| self.is_rounded(stop, &rider.start.place));
                Some(if at_once { rider.start.place } else { there })
            }
            End::Meeting(meeting) => {
                let members = &self.graph.meeting(meeting).members;
                let others = || {
                    let pairs = members.iter().map(|who| self.riders[who.index()].pair);
                    pairs.filter(|other| *other != pair)
                };
                let crossed =
                    others().find(|other| !self.planes.turn_of_paths(pair, *other).is_zero());
                match crossed {
                    Some(other) => Some(Place::On {
                        pair,
                        rail: Rail::Path(other),
                    }),
                    None => self.head_on(pair, others().next()?),
                }
            }
        }
    }

    /// Where a motorcycle passes a vertex that lies on its way.
    pub(super) fn at_vertex(&self, pair: [PlaneId; 2], vertex: usize) -> Option<Place> {
        let posts = self.posts[vertex].iter().flatten();
        let plane =
            (posts.copied()).find(|&plane| !self.planes.moves_away(pair, plane).is_zero())?;
        Some(Place::On {
            pair,
            rail: Rail::Edge(plane),
        })
    }

    /// Where two on one line meet.
    pub(super) fn head_on(&self, pair: [PlaneId; 2], other: [PlaneId; 2]) -> Option<Place> {
        let [p, q] = pair;
        let third = (other.into_iter()).find(|&third| self.planes.do_meet([p, q, third]))?;
        let mut moment = [p, q, third];
        moment.sort_unstable();
        Some(Place::Event { pair, moment })
    }

    /// All members are there, and a child is if one has to be.
    fn check_meetings(&mut self) {
        let meetings = self.graph.meetings();
        for (meeting, id) in meetings.iter().zip((0..).map(MeetingId::new)) {
            let riders: Vec<&Rider> = (meeting.members.iter())
                .map(|who| &self.riders[who.index()])
                .collect();
            let first = riders[0].stop.expect("its end is a meeting");
            let agree = riders[1..].iter().all(|rider| {
                let stop = rider.stop.expect("its end is a meeting");
                self.planes.is_on_path(&first.place, rider.pair)
                    && self.planes.is_on_path(&stop.place, riders[0].pair)
                    && self.compare(&first, &stop).is_eq()
            });
            let has_child = matches!(self.walls, Walls::Figure(_)) && {
                let pairs: Vec<_> = riders.iter().map(|rider| rider.pair).collect();
                births::born(self.planes, &pairs).is_some()
            };
            let in_order = id.index().checked_sub(1).is_none_or(|last| {
                let key = |at: usize| (meetings[at].spot.time, meetings[at].members[0]);
                key(last) < key(id.index())
            });
            let is_sound = agree
                && in_order
                && has_child == meeting.child.is_some()
                && self.is_rounded(meeting.spot, &first.place);
            if !is_sound {
                self.list.push(GraphViolation::WrongMeeting { meeting: id });
            }
        }
    }
}

/// Where a motorcycle passes the start of another one on its line, which somebody placed.
pub(super) fn passing(pair: [PlaneId; 2], other: &Rider) -> Option<Place> {
    match other.start.place {
        Place::On {
            rail: rail @ Rail::Edge(_),
            ..
        } => Some(Place::On { pair, rail }),
        _ => None,
    }
}

impl Rider {
    /// Whether a moment is not before it starts.
    pub(super) fn has_started(&self, checker: &Checker, at: &Stage) -> bool {
        checker.compare(at, &self.start).is_ge()
    }

    /// Whether it is on its way at a moment.
    pub(super) fn is_there(&self, checker: &Checker, at: &Stage) -> bool {
        self.has_started(checker, at)
            && (self.stop.as_ref()).is_none_or(|stop| checker.compare(at, stop).is_le())
    }
}
