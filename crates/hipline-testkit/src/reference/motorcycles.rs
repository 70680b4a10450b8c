//! Motorcycle graphs by their definition: at each step all motorcycles are asked for the first thing
//! that they will run into, and the earliest of these happens.
//!
//! There is no queue, no triangulation and no floating point. As nothing happens before the earliest
//! crash, every motorcycle that still moves gets as far as its path goes until then; so no question has
//! to be put off. Places are numbers here, not definitions.

use std::cmp::Ordering;

use dashu_int::IBig;
use hipline::motorcycle::{End, Launch};
use hipline::skeleton::Side;
use hipline::topology::{EdgeId, MeetingId, MotorcycleId, VertexId, WallId};

use super::graph::Graph;
use super::heading::{cross as cross_of, turn as turn_of};
use super::model::{Model, Plane};
use super::number::{Field, Num};
use super::ratio::Ratio;

/// A motorcycle: numbers correctly rounded.
#[derive(Debug, Clone, PartialEq)]
pub struct RefMotorcycle {
    /// Where it starts: x, y, time.
    pub start: [f64; 3],
    /// Where it ends.
    pub stop: Option<[f64; 3]>,
    /// What ended it.
    pub end: End,
}

type Vector = [Ratio; 2];

/// Quotients of sums of roots, with the four operations.
struct Numbers<'a>(&'a Field);

impl Numbers<'_> {
    fn quotient(&self, top: Num, bottom: Num) -> Ratio {
        Ratio::new(self.0, top, bottom).expect("not zero")
    }

    fn add(&self, a: &Ratio, b: &Ratio, subtract: bool) -> Ratio {
        let ((p, q), (r, s)) = (a.parts(), b.parts());
        let (left, right) = (self.0.mul(p, s), self.0.mul(r, q));
        let top = if subtract {
            left.minus(&right)
        } else {
            left.plus(&right)
        };
        self.quotient(top, self.0.mul(q, s))
    }

    fn plus(&self, a: &Ratio, b: &Ratio) -> Ratio {
        self.add(a, b, false)
    }

    fn minus(&self, a: &Ratio, b: &Ratio) -> Ratio {
        self.add(a, b, true)
    }

    fn times(&self, a: &Ratio, b: &Ratio) -> Ratio {
        let ((p, q), (r, s)) = (a.parts(), b.parts());
        self.quotient(self.0.mul(p, r), self.0.mul(q, s))
    }

    fn over(&self, a: &Ratio, b: &Ratio) -> Ratio {
        let ((p, q), (r, s)) = (a.parts(), b.parts());
        self.quotient(self.0.mul(p, s), self.0.mul(q, r))
    }

    fn sign(&self, a: &Ratio) -> Ordering {
        a.compare(&Ratio::zero(), self.0)
    }

    fn compare(&self, a: &Ratio, b: &Ratio) -> Ordering {
        a.compare(b, self.0)
    }

    fn between(&self, p: &Vector, q: &Vector) -> Vector {
        [0, 1].map(|k| self.minus(&q[k], &p[k]))
    }

    fn cross(&self, u: &Vector, v: &Vector) -> Ratio {
        self.minus(&self.times(&u[0], &v[1]), &self.times(&u[1], &v[0]))
    }

    fn dot(&self, u: &Vector, v: &Vector) -> Ratio {
        self.plus(&self.times(&u[0], &v[0]), &self.times(&u[1], &v[1]))
    }
}

/// A motorcycle.
struct Rider {
    at: Vector,
    time: Ratio,
    velocity: Vector,
    /// The planes that it moves on, that on its left first.
    planes: Option<[usize; 2]>,
    end: Option<(Ratio, End)>,
}

/// What stands still.
struct Wall {
    ends: [Vector; 2],
    name: End,
    /// What its ends are called.
    corners: [End; 2],
}

/// What a motorcycle may run into.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Thing {
    /// A wall, by its number.
    Wall(usize),
    /// An end of a wall.
    Corner(usize, usize),
    Track(usize),
    Rival(usize),
}

struct World<'a> {
    numbers: Numbers<'a>,
    riders: Vec<Rider>,
    walls: Vec<Wall>,
    meetings: usize,
    model: Option<&'a Model>,
}

impl World<'_> {
    fn place(&self, i: usize, time: &Ratio) -> Vector {
        let n = &self.numbers;
        let rider = &self.riders[i];
        let passed = n.minus(time, &rider.time);
        [0, 1].map(|k| n.plus(&rider.at[k], &n.times(&rider.velocity[k], &passed)))
    }

    /// When a motorcycle is at a place that is on its line.
    fn when(&self, i: usize, place: &Vector) -> Ratio {
        let n = &self.numbers;
        let rider = &self.riders[i];
        let way = n.dot(&n.between(&rider.at, place), &rider.velocity);
        let passed = n.over(&way, &n.dot(&rider.velocity, &rider.velocity));
        n.plus(&rider.time, &passed)
    }

    fn starts_by(&self, i: usize, time: &Ratio) -> Ordering {
        self.numbers.compare(time, &self.riders[i].time)
    }

    /// When a motorcycle gets to a wall, and to which part of it.
    fn wall(&self, i: usize, number: usize) -> Option<(Ratio, Thing)> {
        let n = &self.numbers;
        let (rider, wall) = (&self.riders[i], &self.walls[number]);
        let sides = [0, 1].map(|k| {
            let to = n.between(&rider.at, &wall.ends[k]);
            n.sign(&n.cross(&rider.velocity, &to))
        });
        let ahead =
            |time: Ratio, thing| (self.starts_by(i, &time).is_gt()).then_some((time, thing));
        match sides {
            [Ordering::Equal, Ordering::Equal] => {
                let mut times =
                    [0, 1].map(|k| (self.when(i, &wall.ends[k]), Thing::Corner(number, k)));
                if n.compare(&times[0].0, &times[1].0).is_gt() {
                    times.swap(0, 1);
                }
                let [near, far] = times;
                if self.starts_by(i, &near.0).is_gt() {
                    return Some(near);
                }
                (self.starts_by(i, &far.0).is_gt())
                    .then(|| (rider.time.clone(), Thing::Wall(number)))
            }
            [Ordering::Equal, _] => ahead(self.when(i, &wall.ends[0]), Thing::Corner(number, 0)),
            [_, Ordering::Equal] => ahead(self.when(i, &wall.ends[1]), Thing::Corner(number, 1)),
            [a, b] if a == b => None,
            _ => {
                let along = n.between(&wall.ends[0], &wall.ends[1]);
                let to = n.between(&rider.at, &wall.ends[0]);
                let passed = n.over(&n.cross(&to, &along), &n.cross(&rider.velocity, &along));
                ahead(n.plus(&rider.time, &passed), Thing::Wall(number))
            }
        }
    }

    /// Whether a motorcycle is or was anywhere at that time.
    fn is_there(&self, j: usize, time: &Ratio) -> bool {
        let ended = self.riders[j].end.as_ref();
        self.starts_by(j, time).is_ge()
            && ended.is_none_or(|end| self.numbers.compare(time, &end.0).is_le())
    }

    /// When a motorcycle runs into the track of another one, or into itself.
    fn track(&self, i: usize, j: usize) -> Option<(Ratio, Thing)> {
        let n = &self.numbers;
        let (a, b) = (&self.riders[i], &self.riders[j]);
        let to = n.between(&a.at, &b.at);
        let turn = n.cross(&a.velocity, &b.velocity);
        if n.sign(&turn).is_eq() {
            return self.on_line(i, j, &to);
        }
        let own = n.plus(&a.time, &n.over(&n.cross(&to, &b.velocity), &turn));
        let other = n.plus(&b.time, &n.over(&n.cross(&to, &a.velocity), &turn));
        let start = self.starts_by(i, &own);
        if start.is_lt() || !self.is_there(j, &other) {
            return None;
        }
        match n.compare(&other, &own) {
            Ordering::Less => Some((own, Thing::Track(j))),
            Ordering::Greater => None,
            Ordering::Equal if start.is_eq() => None,
            Ordering::Equal if self.starts_by(j, &other).is_eq() => Some((own, Thing::Track(j))),
            Ordering::Equal => Some((own, Thing::Rival(j))),
        }
    }

    /// The same where their paths are parallel.
    fn on_line(&self, i: usize, j: usize, to: &Vector) -> Option<(Ratio, Thing)> {
        let n = &self.numbers;
        let (a, b) = (&self.riders[i], &self.riders[j]);
        if n.sign(&n.cross(to, &a.velocity)).is_ne() {
            return None;
        }
        let alike = n.dot(&a.velocity, &b.velocity);
        // Is its own start on the other's track?
        let passed = self.when(j, &a.at);
        if self.is_there(j, &passed) {
            let first = n.compare(&passed, &a.time);
            let together = first.is_eq() && self.starts_by(j, &passed).is_eq();
            let speeds = [a, b].map(|rider| n.dot(&rider.velocity, &rider.velocity));
            let slower = n.compare(&speeds[0], &speeds[1]).is_lt();
            let stops = if together {
                n.sign(&alike).is_gt() && slower
            } else {
                // From where the other one arrives at this moment, back along its track.
                first.is_eq() && n.sign(&alike).is_lt()
            };
            if first.is_lt() || stops {
                return Some((a.time.clone(), Thing::Track(j)));
            }
        }
        // Do they come towards each other? v . (a + v (t - s)) = v . (b + w (t - u)).
        if n.sign(&alike).is_lt() && b.end.is_none() {
            let square = n.dot(&a.velocity, &a.velocity);
            let rest = n.plus(
                &n.dot(to, &a.velocity),
                &n.minus(&n.times(&square, &a.time), &n.times(&alike, &b.time)),
            );
            let time = n.over(&rest, &n.minus(&square, &alike));
            if self.starts_by(i, &time).is_gt() && self.starts_by(j, &time).is_gt() {
                return Some((time, Thing::Rival(j)));
            }
        }
        // Does it come to the other's start?
        let there = self.when(i, &b.at);
        let is_there = self.starts_by(i, &there).is_gt() && n.compare(&b.time, &there).is_le();
        is_there.then_some((there, Thing::Track(j)))
    }

    /// All that a motorcycle may run into.
    fn ahead(&self, i: usize) -> Vec<(Ratio, Thing)> {
        let walls = (0..self.walls.len()).filter_map(|number| self.wall(i, number));
        let others = (0..self.riders.len()).filter(|&j| j != i);
        walls
            .chain(others.filter_map(|j| self.track(i, j)))
            .collect()
    }

    /// Lets the earliest crashes happen. False if there are none.
    fn advance(&mut self) -> bool {
        let n = &self.numbers;
        let moving = |i: &usize| self.riders[*i].end.is_none();
        let mut all: Vec<(usize, Ratio, Thing)> = (0..self.riders.len())
            .filter(moving)
            .flat_map(|i| {
                self.ahead(i)
                    .into_iter()
                    .map(move |(time, thing)| (i, time, thing))
            })
            .collect();
        let Some(now) = all
            .iter()
            .map(|x| &x.1)
            .min_by(|a, b| n.compare(a, b))
            .cloned()
        else {
            return false;
        };
        all.retain(|x| n.compare(&x.1, &now).is_eq());
        all.sort_by_key(|x| (x.0, x.2));
        let mut groups: Vec<Vec<usize>> = Vec::new();
        let mut ends: Vec<(usize, End)> = Vec::new();
        for things in all.chunk_by(|a, b| a.0 == b.0) {
            let i = things[0].0;
            let end = match self.name(things.iter().map(|x| x.2)) {
                Some(end) => end,
                None => {
                    let place = self.place(i, &now);
                    let here = |j: &usize| {
                        let other = self.place(*j, &now);
                        (0..2).all(|k| n.compare(&place[k], &other[k]).is_eq())
                    };
                    match groups.iter_mut().find(|group| here(&group[0])) {
                        Some(group) => group.push(i),
                        None => groups.push(vec![i]),
                    }
                    continue;
                }
            };
            ends.push((i, end));
        }
        for (i, end) in ends {
            self.riders[i].end = Some((now.clone(), end));
        }
        for group in groups {
            self.meet(&group, &now);
        }
        true
    }

    /// What counts of several things at one place; `None` is a meeting.
    fn name(&self, things: impl Iterator<Item = Thing>) -> Option<End> {
        let mut walls = Vec::new();
        let mut track = None;
        for thing in things {
            match thing {
                Thing::Wall(wall) => walls.push(self.walls[wall].name),
                Thing::Corner(wall, k) => walls.push(self.walls[wall].corners[k]),
                Thing::Track(j) => track = track.or(Some(End::Track(MotorcycleId::new(j)))),
                Thing::Rival(_) => {}
            }
        }
        // Edges meet in vertices only; of walls that cross, the first one counts.
        let key = |end: &End| match end {
            End::Wall(wall) => wall.index(),
            _ => 0,
        };
        walls.into_iter().min_by_key(key).or(track)
    }

    fn meet(&mut self, group: &[usize], now: &Ratio) {
        assert!(group.len() > 1, "{} meets nobody", group[0]);
        let meeting = MeetingId::new(self.meetings);
        self.meetings += 1;
        for &i in group {
            self.riders[i].end = Some((now.clone(), End::Meeting(meeting)));
        }
        let Some(model) = self.model else {
            return;
        };
        // The one whose track is the last before more than half a turn without tracks, and the first after.
        let n = &self.numbers;
        let turn = |i: usize, j: usize| {
            n.sign(&n.cross(&self.riders[i].velocity, &self.riders[j].velocity))
        };
        let pairs = group
            .iter()
            .flat_map(|&i| group.iter().map(move |&j| (i, j)));
        let wide = pairs
            .filter(|&(i, j)| i != j && turn(i, j).is_lt())
            .find(|&(i, j)| {
                let others = group.iter().filter(|&&k| k != i && k != j);
                // All others are between j and i.
                others
                    .copied()
                    .all(|k| turn(j, k).is_gt() && turn(k, i).is_gt())
            });
        let Some((i, j)) = wide else {
            return;
        };
        let planes = [self.riders[j].planes, self.riders[i].planes]
            .map(|planes| planes.expect("of a figure"));
        let planes = [planes[0][0], planes[1][1]];
        let [left, right] = planes.map(|plane| &model.planes[plane]);
        if turn_of(n.0, &right.normal, &left.normal).is_le() {
            return;
        }
        let rider = Rider {
            at: self.place(i, now),
            time: now.clone(),
            velocity: velocity(n, left, right),
            planes: Some(planes),
            end: None,
        };
        self.riders.push(rider);
    }

    fn result(self, place_exponent: i64, time_exponent: i64) -> Vec<RefMotorcycle> {
        let spot = |i: usize, time: &Ratio| {
            let [x, y] = self.place(i, time);
            let field = self.numbers.0;
            [
                x.round(field, place_exponent),
                y.round(field, place_exponent),
                time.round(field, time_exponent),
            ]
        };
        let all = self.riders.iter().enumerate();
        all.map(|(i, rider)| RefMotorcycle {
            start: spot(i, &rider.time),
            stop: rider.end.as_ref().map(|end| spot(i, &end.0)),
            end: rider.end.as_ref().map_or(End::Escape, |end| end.1),
        })
        .collect()
    }
}

/// The velocity of the point on two planes.
fn velocity(n: &Numbers, left: &Plane, right: &Plane) -> Vector {
    let bottom = cross_of(n.0, &left.normal, &right.normal);
    let by = |p: &Plane, q: &Plane, k: usize| n.0.mul(&p.rate, &q.normal[k]);
    let x = by(left, right, 1).minus(&by(right, left, 1));
    let y = by(right, left, 0).minus(&by(left, right, 0));
    [x, y].map(|top| n.quotient(top, bottom.clone()))
}

/// The motorcycle graph that the inside of the polygons induces; all speeds have to be one.
#[must_use]
pub fn reference_motorcycles(graph: &Graph) -> Vec<RefMotorcycle> {
    let model = Model::new(graph);
    let numbers = Numbers(&model.field);
    let at = |vertex: usize| [0, 1].map(|k| Ratio::integer(&model.points[vertex][k]));
    // A vertex between an edge that arrives, on the left, and one that leaves.
    let mut starts: Vec<(usize, [usize; 2])> = (0..model.courses)
        .map(|arriving| [arriving, model.next[arriving]])
        .filter(|&[left, right]| {
            let [i, j] = [left, right].map(|plane| &model.planes[plane].direction);
            model.inside[left] && turn_of(&model.field, i, j).is_lt()
        })
        .map(|planes| (model.planes[planes[0]].ends[1], planes))
        .collect();
    starts.sort_unstable_by_key(|&(vertex, [_, right])| (vertex, right));
    let riders = starts.into_iter().map(|(vertex, planes)| {
        let [left, right] = planes.map(|plane| &model.planes[plane]);
        Rider {
            at: at(vertex),
            time: Ratio::zero(),
            velocity: velocity(&numbers, left, right),
            planes: Some(planes),
            end: None,
        }
    });
    let riders: Vec<Rider> = riders.collect();
    let walls = graph.edges.iter().enumerate().map(|(e, edge)| Wall {
        ends: edge.ends.map(at),
        // Which side is hit is told afterwards.
        name: End::Edge(EdgeId::new(e), Side::Left),
        corners: edge.ends.map(|v| End::Vertex(VertexId::new(v))),
    });
    let mut world = World {
        numbers: Numbers(&model.field),
        riders,
        walls: walls.collect(),
        meetings: 0,
        model: Some(&model),
    };
    while world.advance() {}
    for rider in &mut world.riders {
        if let Some((_, End::Edge(edge, side))) = &mut rider.end {
            let [p, q] = graph.edges[edge.index()].ends.map(at);
            let along = world.numbers.between(&p, &q);
            let turn = world.numbers.cross(&along, &rider.velocity);
            if world.numbers.sign(&turn).is_gt() {
                *side = Side::Right;
            }
        }
    }
    world.result(-model.place_bits, model.speed_bits - model.place_bits)
}

/// The motorcycle graph of motorcycles and walls that are given, of numbers that are multiples of 2^-10.
///
/// # Panics
/// If they are not.
#[must_use]
pub fn reference_launches(launches: &[Launch], walls: &[[[f64; 2]; 2]]) -> Vec<RefMotorcycle> {
    let field = Field::new(&[]);
    let numbers = Numbers(&field);
    let exact = |x: f64| {
        let scaled = x * 1024.0;
        assert!(
            scaled.fract() == 0.0 && scaled.abs() < 1e15,
            "{x} is too fine"
        );
        numbers.quotient(IBig::from(scaled as i64).into(), IBig::from(1024).into())
    };
    let riders = launches.iter().map(|launch| Rider {
        at: launch.place.map(exact),
        time: exact(launch.time),
        velocity: launch.velocity.map(exact),
        planes: None,
        end: None,
    });
    let riders: Vec<Rider> = riders.collect();
    let walls = walls.iter().enumerate().map(|(i, wall)| Wall {
        ends: wall.map(|end| end.map(exact)),
        name: End::Wall(WallId::new(i)),
        corners: [End::Wall(WallId::new(i)); 2],
    });
    let walls = walls.collect();
    let mut world = World {
        numbers: Numbers(&field),
        riders,
        walls,
        meetings: 0,
        model: None,
    };
    while world.advance() {}
    world.result(0, 0)
}
