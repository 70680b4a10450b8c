//! What touches what.

use super::{Checker, GraphViolation, Stage, Walls, ends::passing};
use crate::{
    motorcycle::{
        model::{End, Origin},
        tree::{self, Extent},
        way::Way,
    },
    predicates::{Place, PlaneId, Rail, lines_of_wall},
    skeleton::Side,
    topology::{EdgeId, MeetingId, MotorcycleId, VertexId, WallId},
};
use hipline_num::Sign;
use std::cmp::Ordering;

/// The rectangle around a track or wall as it is told. Rounding is monotone: where two of these are apart, so are the things
/// themselves.
fn are_apart(p: &Extent, q: &Extent) -> bool {
    (0..2).any(|k| p.high[k] < q.low[k] || q.high[k] < p.low[k])
}

impl Checker<'_> {
    /// The rectangle, the way, and how far that goes.
    fn told(&self, number: usize) -> (Extent, Way, [f64; 2]) {
        let motorcycles = self.graph.motorcycles();
        let around = |ends: [[f64; 2]; 2]| Extent {
            low: [0, 1].map(|k| ends[0][k].min(ends[1][k])),
            high: [0, 1].map(|k| ends[0][k].max(ends[1][k])),
        };
        let Some(motorcycle) = motorcycles.get(number) else {
            let ends = self.walls.ends(number - motorcycles.len());
            return (around(ends), Way::between(ends), [0.0, 1.0]);
        };
        let start = [motorcycle.start.x, motorcycle.start.y];
        if let Some(stop) = motorcycle.stop {
            let ends = [start, [stop.x, stop.y]];
            return (around(ends), Way::between(ends), [0.0, 1.0]);
        }
        let far = [0, 1].map(|k| match motorcycle.velocity[k] {
            v if v > 0.0 => f64::INFINITY,
            v if v < 0.0 => f64::NEG_INFINITY,
            _ => start[k],
        });
        let way = Way::escaping(start, motorcycle.velocity);
        (around([start, far]), way, [0.0, f64::INFINITY])
    }

    /// All that touches.
    pub(super) fn check_contacts(&mut self) {
        let count = self.graph.motorcycles().len();
        let all: Vec<_> = (0..count + self.walls.len())
            .map(|i| self.told(i))
            .collect();
        let bounds = Extent::around(
            all.iter()
                .flat_map(|(extent, ..)| [extent.low, extent.high]),
        );
        let stays = all.iter().map(|(_, _, stay)| *stay).collect();
        let built = tree::build(stays, |i| all[i].1, bounds);
        for [from, to] in built.cells {
            let cell = &built.walls[from as usize..to as usize];
            for (at, &(i, _)) in cell.iter().enumerate() {
                for &(j, _) in &cell[at + 1..] {
                    let [i, j] = [i.min(j), i.max(j)].map(|i| i as usize);
                    if i >= count || are_apart(&all[i].0, &all[j].0) {
                        continue;
                    }
                    match j.checked_sub(count) {
                        None => self.check_pair(i, j),
                        Some(wall) => self.check_wall(i, wall),
                    }
                }
            }
        }
    }

    /// A motorcycle has to stop at a moment of its way.
    fn stops(&mut self, who: usize, at: &Stage, by: End) {
        let goes_on =
            (self.riders[who].stop.as_ref()).is_none_or(|stop| self.compare(at, stop).is_lt());
        if goes_on {
            self.list.push(GraphViolation::GoesOn {
                motorcycle: MotorcycleId::new(who),
                at: by,
            });
        } else {
            self.add_cause(who, by);
        }
    }

    /// Two meet.
    fn meet(&mut self, who: [usize; 2], at: [Stage; 2]) {
        let ends = who.map(|k| self.graph.motorcycles()[k].end);
        if let [End::Meeting(one), End::Meeting(other)] = ends
            && one != other
        {
            self.list
                .push(GraphViolation::WrongMeeting { meeting: one });
        }
        let number = |end| match end {
            End::Meeting(number) => Some(number),
            _ => None,
        };
        let number = number(ends[0]).or_else(|| number(ends[1]));
        let number = number.unwrap_or_else(|| MeetingId::new(0));
        for k in 0..2 {
            self.stops(who[k], &at[k], End::Meeting(number));
        }
    }

    /// Whether one of two was born where the other one ended.
    fn are_related(&self, i: usize, j: usize) -> bool {
        let child = |child: usize, parent: usize| match self.graph.motorcycles()[child].origin {
            Origin::Meeting(number) => (self.graph.meeting(number).members)
                .binary_search(&MotorcycleId::new(parent))
                .is_ok(),
            _ => false,
        };
        child(i, j) || child(j, i)
    }

    fn check_pair(&mut self, i: usize, j: usize) {
        let who = [i, j];
        let [a, b] = who.map(|k| &self.riders[k]);
        let crossing = a.lane.cross(&b.lane);
        let turn = match crossing.turn {
            Some(turn) if !turn.is_zero() => {
                let misses = |k: usize| {
                    let (t, rider) = (crossing.times[k], &self.riders[who[k]]);
                    t.high < rider.start.bounds.low
                        || rider.stop.is_some_and(|stop| t.low > stop.bounds.high)
                };
                if misses(0) || misses(1) {
                    return;
                }
                turn
            }
            _ => self.planes.turn_of_paths(a.pair, b.pair),
        };
        if self.are_related(i, j) {
            return;
        }
        if turn.is_zero() {
            self.check_line(i, j);
            return;
        }
        let [p, q] = [a.pair, b.pair];
        let at = [(p, q), (q, p)].map(|(pair, other)| {
            let rail = Rail::Path(other);
            self.instant(Place::On { pair, rail })
        });
        if !(a.is_there(self, &at[0]) && b.is_there(self, &at[1])) {
            return;
        }
        let at_start = [0, 1].map(|k| self.compare(&at[k], &self.riders[who[k]].start).is_eq());
        let track = |k: usize| End::Track(MotorcycleId::new(k));
        match (self.compare(&at[0], &at[1]), at_start) {
            (Ordering::Equal, [true, true]) => {}
            (Ordering::Equal, [false, false]) => self.meet(who, at),
            (Ordering::Less, _) | (Ordering::Equal, [true, false]) => {
                self.stops(j, &at[1], track(i));
            }
            (Ordering::Greater, _) | (Ordering::Equal, [false, true]) => {
                self.stops(i, &at[0], track(j));
            }
        }
    }

    /// Two whose ways are parallel.
    fn check_line(&mut self, i: usize, j: usize) {
        let who = [i, j];
        let [p, q] = who.map(|k| self.riders[k].pair);
        if !self.planes.is_on_path(&self.riders[j].start.place, p) {
            return;
        }
        let alike = self.planes.go_alike(p, q);
        let track = |k: usize| End::Track(MotorcycleId::new(k));
        for [own, other] in [[i, j], [j, i]] {
            let Some(place) = passing(self.riders[own].pair, &self.riders[other]) else {
                continue;
            };
            let (at, start) = (self.instant(place), self.riders[other].start);
            if !self.riders[own].is_there(self, &at) {
                continue;
            }
            let from_start = self.compare(&at, &self.riders[own].start).is_eq();
            match self.compare(&at, &start) {
                Ordering::Less => self.stops(other, &start, track(own)),
                Ordering::Greater => self.stops(own, &at, track(other)),
                Ordering::Equal if from_start => {
                    if own == i && alike {
                        let faster = self.planes.is_faster(p, q);
                        let [slow, fast] = if faster { [j, i] } else { [i, j] };
                        let start = self.riders[slow].start;
                        self.stops(slow, &start, track(fast));
                    }
                }
                Ordering::Equal => {
                    self.stops(own, &at, track(other));
                    if !alike {
                        self.stops(other, &start, track(own));
                    }
                }
            }
        }
        if alike {
            return;
        }
        let ([Some(mine), Some(theirs)], [a, b]) = (
            [self.head_on(p, q), self.head_on(q, p)],
            who.map(|k| &self.riders[k]),
        ) else {
            return;
        };
        let at = [mine, theirs].map(|place| self.instant(place));
        let on_way = a.is_there(self, &at[0]) && b.is_there(self, &at[1]);
        let after_start = |k: usize| self.compare(&at[k], &self.riders[who[k]].start).is_gt();
        if on_way && after_start(0) && after_start(1) {
            self.meet(who, at);
        }
    }

    /// A motorcycle is at a wall at a moment, unless that is not on its way or where it starts.
    fn comes_to(&mut self, who: usize, place: Place, by: End) {
        let at = self.instant(place);
        let rider = &self.riders[who];
        if self.compare(&at, &rider.start).is_gt() && rider.is_there(self, &at) {
            self.stops(who, &at, by);
        }
    }

    fn check_wall(&mut self, who: usize, wall: usize) {
        let pair = self.riders[who].pair;
        let ends = self.walls.ends(wall);
        let on = |plane: PlaneId| Place::On {
            pair,
            rail: Rail::Edge(plane),
        };
        let Walls::Figure(figure) = self.walls else {
            let sides = ends.map(|end| self.planes.side_of_path(end, pair));
            self.check_given_wall(who, wall, sides);
            return;
        };
        let edge = figure.edges()[wall];
        let vertices = [edge.from, edge.to];
        let starts_at = |v: VertexId| self.graph.motorcycles()[who].origin == Origin::Vertex(v);
        if vertices.into_iter().any(starts_at) {
            return;
        }
        let sides = ends.map(|end| self.planes.side_of_path(end, pair));
        for k in 0..2 {
            if sides[k].is_zero()
                && let Some(place) = self.at_vertex(pair, vertices[k].index())
            {
                self.comes_to(who, place, End::Vertex(vertices[k]));
            }
        }
        if (sides[0] * sides[1]).is_negative() {
            let plane = PlaneId(2 * wall as u32);
            let side = if self.planes.moves_away(pair, plane).is_positive() {
                Side::Right
            } else {
                Side::Left
            };
            self.comes_to(who, on(plane), End::Edge(EdgeId::new(wall), side));
        }
    }

    fn check_given_wall(&mut self, who: usize, wall: usize, sides: [Sign; 2]) {
        let (pair, start) = (self.riders[who].pair, self.riders[who].start);
        let count = self.graph.motorcycles().len();
        let [line, posts @ ..] = lines_of_wall(count, wall);
        let by = End::Wall(WallId::new(wall));
        let on = |plane: PlaneId| Place::On {
            pair,
            rail: Rail::Edge(plane),
        };
        if sides != [Sign::Zero; 2] {
            if !(sides[0] * sides[1]).is_positive() {
                self.comes_to(who, on(line), by);
            }
            return;
        }
        // Along it: what comes first is its near end, or the start if that is on it.
        let [p, q] = posts.map(|post| self.instant(on(post)));
        let ahead = [p, q].map(|post| self.compare(&post, &start).is_gt());
        match ahead {
            [false, false] => {}
            [true, true] => {
                let near = if self.compare(&p, &q).is_le() { p } else { q };
                self.comes_to(who, near.place, by);
            }
            _ => self.stops(who, &start, by),
        }
    }
}
