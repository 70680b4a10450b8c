//! Places of nodes: their definitions, their order along an edge, their rounded coordinates.

use hipline_num::{
    BallDd, Number, Sign, Surd, Wide, compare_quotient_f64, in_units, power_of_two,
    round_ball_dd_plus, round_quotient_plus, round_wide_plus,
};
use std::cmp::Ordering;

use super::{
    decide::Question,
    expression::{Path, meeting},
    passage::{Rail, passage},
    planes::{Plane, PlaneId, Planes, Rung},
};

/// A place and a moment, by definition.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Place {
    /// An input vertex, at time zero.
    Vertex([f64; 2]),
    /// The intersection of two planes at the moment when three planes meet.
    Event {
        pair: [PlaneId; 2],
        moment: [PlaneId; 3],
    },
    /// The intersection of two planes at a given time.
    At { pair: [PlaneId; 2], time: f64 },
    /// Where the intersection of two planes passes a line that stands still.
    On { pair: [PlaneId; 2], rail: Rail },
    /// Where the perpendicular to `plane`'s edge through the start of a ghost arc, itself a
    /// vertex or an event, reaches the boundary of the face.
    Foot {
        start: Start,
        plane: PlaneId,
        bound: Bound,
    },
}

/// Where a ghost arc, or the side of a slab, starts.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Start {
    Vertex([f64; 2]),
    /// Where a motorcycle crashes.
    On {
        pair: [PlaneId; 2],
        rail: Rail,
    },
    Event {
        pair: [PlaneId; 2],
        moment: [PlaneId; 3],
    },
}

impl From<Start> for Place {
    fn from(start: Start) -> Self {
        match start {
            Start::Vertex(v) => Self::Vertex(v),
            Start::Event { pair, moment } => Self::Event { pair, moment },
            Start::On { pair, rail } => Self::On { pair, rail },
        }
    }
}

/// The arc on which a ghost arc ends.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Bound {
    /// The intersection of two planes.
    Pair([PlaneId; 2]),
    /// An arc of one height.
    Level([PlaneId; 3]),
    /// No arc: the place at a given time on the way.
    Time(f64),
}

/// `x / w`, `y / w` and `time / since`, in the numbers of one rung.
pub(super) struct Point<T> {
    pub x: T,
    pub y: T,
    pub w: T,
    pub time: T,
    pub since: T,
}

pub(super) fn input<T: Rung>(planes: &Planes, [x, y]: [f64; 2]) -> Point<T> {
    let coordinate = |x: f64, origin: f64| {
        // As a rule, a difference of two numbers on the grid is exact and small.
        let d = x - origin;
        let back = x - d;
        let is_exact = back.total_cmp(&origin).is_eq() && (d + back).total_cmp(&x).is_eq();
        if is_exact && planes.shift == 0 && planes.unit.abs() < 512 {
            let scaled = d * power_of_two(-planes.unit);
            if scaled.abs() < (1_i64 << 53) as f64 {
                return T::from_i64(scaled as i64);
            }
        }
        let difference = in_units(x, planes.unit) - in_units(origin, planes.unit);
        T::integer(&difference, planes.shift)
    };
    Point {
        x: coordinate(x, planes.origin[0]),
        y: coordinate(y, planes.origin[1]),
        w: T::from_i64(1),
        time: T::zero(),
        since: T::from_i64(1),
    }
}

pub(super) fn point<T: Rung>(planes: &Planes, place: &Place) -> Point<T> {
    match *place {
        Place::Vertex(v) => input(planes, v),
        Place::Event { pair, moment } => {
            let path = Path::<T>::new(planes, pair);
            let (n, d) = meeting::<T>(planes, moment);
            let at = |z: &[T; 2]| z[0].times(&d).minus(&z[1].times(&n));
            Point {
                x: at(&path.x),
                y: at(&path.y),
                w: path.m.times(&d),
                time: n.negated(),
                since: d,
            }
        }
        Place::At { pair, time } => {
            let path = Path::<T>::new(planes, pair);
            let [time, since] = T::time(planes, time);
            let at = |z: &[T; 2]| z[0].times(&since).plus(&z[1].times(&time));
            Point {
                x: at(&path.x),
                y: at(&path.y),
                w: path.m.times(&since),
                time,
                since,
            }
        }
        Place::On { pair, rail } => passage(planes, pair, rail),
        Place::Foot {
            start,
            plane,
            bound,
        } => {
            let plane = T::plane(planes, plane);
            // The coordinate of the start along the edge is p / q.
            let start = point::<T>(planes, &start.into());
            let p = plane.along(&start.x, &start.y);
            let q = start.w;
            match bound {
                Bound::Pair(pair) => {
                    // On the arc that coordinate is (u0 + u1 t) / m.
                    let Path { x, y, m } = Path::<T>::new(planes, pair);
                    let [u0, u1] = [0, 1].map(|k| plane.along(&x[k], &y[k]));
                    let time = p.times(&m).minus(&u0.times(&q));
                    let since = u1.times(&q);
                    let at = |z: &[T; 2]| z[0].times(&since).plus(&z[1].times(&time));
                    Point {
                        x: at(&x),
                        y: at(&y),
                        w: m.times(&since),
                        time,
                        since,
                    }
                }
                Bound::Level(moment) => {
                    let (n, d) = meeting::<T>(planes, moment);
                    above(&plane, &p, &q, [n.negated(), d])
                }
                Bound::Time(time) => above(&plane, &p, &q, T::time(planes, time)),
            }
        }
    }
}

/// The point of a plane at a time, whose coordinate along the plane's edge is p / q.
fn above<T: Number>(plane: &Plane<T>, p: &T, q: &T, [time, since]: [T; 2]) -> Point<T> {
    let level = plane.c.times(&since).plus(&plane.s.times(&time)).times(q);
    let p = p.times(&since);
    let square = plane.a.times(&plane.a).plus(&plane.b.times(&plane.b));
    Point {
        x: plane.a.times(&level).plus(&plane.b.times(&p)),
        y: plane.b.times(&level).minus(&plane.a.times(&p)),
        w: square.times(&since).times(q),
        time,
        since,
    }
}

/// Which coordinate of places to compare.
#[derive(Clone, Copy)]
enum Key {
    /// Along the edge of a plane.
    Along(PlaneId),
    /// The time.
    Time,
    X,
    Y,
}

/// Compares two places.
struct Order<'a>(&'a Place, &'a Place, Key);

impl Question for Order<'_> {
    fn ask<T: Rung>(&self, planes: &Planes) -> Option<Sign> {
        let (p, q) = (point::<T>(planes, self.0), point::<T>(planes, self.1));
        let split = |p: Point<T>| match self.2 {
            Key::Along(plane) => {
                let plane = T::plane(planes, plane);
                (plane.along(&p.x, &p.y), p.w)
            }
            Key::Time => (p.time, p.since),
            Key::X => (p.x, p.w),
            Key::Y => (p.y, p.w),
        };
        let ((p, v), (q, w)) = (split(p), split(q));
        Some(p.times(&w).minus(&q.times(&v)).sign()? * v.sign()? * w.sign()?)
    }
}

/// How a vertex moves along an edge.
struct Drift([PlaneId; 2], PlaneId);

impl Question for Drift {
    fn ask<T: Rung>(&self, planes: &Planes) -> Option<Sign> {
        let path = Path::<T>::new(planes, self.0);
        let plane = T::plane(planes, self.1);
        plane.along(&path.x[1], &path.y[1]).sign()
    }
}

/// The order of the velocities of two vertices along an edge; `None` does not move.
struct Drifts([Option<[PlaneId; 2]>; 2], PlaneId);

impl Question for Drifts {
    fn ask<T: Rung>(&self, planes: &Planes) -> Option<Sign> {
        let plane = T::plane(planes, self.1);
        let [(u, m), (v, n)] = self.0.map(|pair| match pair {
            None => (T::zero(), T::from_i64(1)),
            Some(pair) => {
                let path = Path::<T>::new(planes, pair);
                (plane.along(&path.x[1], &path.y[1]), path.m)
            }
        });
        Some(u.times(&n).minus(&v.times(&m)).sign()? * m.sign()? * n.sign()?)
    }
}

/// How a vertex that does not move along an edge lies to a place.
struct Beside<'a>([PlaneId; 2], &'a Place, PlaneId);

impl Question for Beside<'_> {
    fn ask<T: Rung>(&self, planes: &Planes) -> Option<Sign> {
        let path = Path::<T>::new(planes, self.0);
        let plane = T::plane(planes, self.2);
        let u = plane.along(&path.x[0], &path.y[0]);
        let place = point::<T>(planes, self.1);
        let p = plane.along(&place.x, &place.y);
        Some(u.times(&place.w).minus(&p.times(&path.m)).sign()? * place.w.sign()?)
    }
}

/// How far a place is ahead of a plane.
struct Ahead<'a>(&'a Place, PlaneId);

impl Question for Ahead<'_> {
    fn ask<T: Rung>(&self, planes: &Planes) -> Option<Sign> {
        let Point {
            x,
            y,
            w,
            time,
            since,
        } = point::<T>(planes, self.0);
        let plane = T::plane(planes, self.1);
        let reach = plane.reach([&x, &y, &w]);
        let value = reach.times(&since).minus(&plane.s.times(&time).times(&w));
        Some(value.sign()? * w.sign()? * since.sign()?)
    }
}

impl Planes {
    /// Whether a place is ahead of a plane at its time: positive where the plane's
    /// wavefront edge has not been yet, zero on it.
    pub(crate) fn ahead(&self, place: &Place, plane: PlaneId) -> Sign {
        self.decide(&Ahead(place, plane))
    }

    /// The sign of the area enclosed by cycles of places, unless it is too small to tell
    /// in double-double.
    pub(crate) fn area_sign<'a>(
        &self,
        cycles: impl Iterator<Item = Vec<&'a Place>>,
    ) -> Option<Sign> {
        let mut sum = BallDd::zero();
        for cycle in cycles {
            let points: Vec<[BallDd; 2]> = cycle
                .iter()
                .map(|place| {
                    let Point { x, y, w, .. } = point::<BallDd>(self, place);
                    [x.div(&w), y.div(&w)]
                })
                .collect();
            let Some(origin) = points.first() else {
                continue;
            };
            for pair in points.windows(2) {
                let [p, q] = [0, 1].map(|k| [0, 1].map(|z| pair[k][z].minus(&origin[z])));
                sum = sum.plus(&p[0].times(&q[1]).minus(&p[1].times(&q[0])));
            }
        }
        sum.sign()
    }

    /// Compares where a vertex will be in the end with a place, along the direction of a
    /// plane's wavefront edge.
    pub(crate) fn compare_far(
        &self,
        pair: [PlaneId; 2],
        place: &Place,
        plane: PlaneId,
    ) -> Ordering {
        match self.drift(pair, plane) {
            Sign::Zero => self.decide(&Beside(pair, place, plane)).ordering(),
            drift => drift.ordering(),
        }
    }

    /// Compares two places along the direction of a plane's wavefront edge.
    pub(crate) fn compare_along(&self, p: &Place, q: &Place, plane: PlaneId) -> Ordering {
        if p == q {
            Ordering::Equal
        } else {
            self.decide(&Order(p, q, Key::Along(plane))).ordering()
        }
    }

    /// Compares the velocities of two vertices (`None`: at rest) along the direction of a
    /// plane's wavefront edge.
    pub(crate) fn compare_drifts(
        &self,
        pairs: [Option<[PlaneId; 2]>; 2],
        plane: PlaneId,
    ) -> Ordering {
        self.decide(&Drifts(pairs, plane)).ordering()
    }

    /// Compares the time of a place with a number, exactly.
    pub(crate) fn compare_time(&self, place: &Place, time: f64) -> Ordering {
        let exact = point::<Surd>(self, place);
        compare_quotient_f64(&exact.time, &exact.since, self.time_unit, 0.0, time)
    }

    /// Compares the times of two places.
    pub(crate) fn compare_times(&self, p: &Place, q: &Place) -> Ordering {
        if p == q {
            Ordering::Equal
        } else {
            self.decide(&Order(p, q, Key::Time)).ordering()
        }
    }

    /// Compares two places by x, then y.
    pub(crate) fn compare_points(&self, p: &Place, q: &Place) -> Ordering {
        if p == q {
            return Ordering::Equal;
        }
        let by = |key| self.decide(&Order(p, q, key)).ordering();
        by(Key::X).then_with(|| by(Key::Y))
    }

    /// Whether a vertex moves forward or backward along a plane's wavefront edge.
    pub(crate) fn drift(&self, pair: [PlaneId; 2], plane: PlaneId) -> Sign {
        self.decide(&Drift(pair, plane))
    }

    /// `x`, `y` and time of a place, each the nearest f64.
    pub(crate) fn round(&self, place: &Place) -> [f64; 3] {
        if let Place::Vertex([x, y]) = *place {
            return [x, y, 0.0];
        }
        let near = point::<BallDd>(self, place);
        let (x_unit, t_unit) = (self.unit + self.shift, self.rough_time_unit());
        let fast = [
            round_ball_dd_plus(&near.x, &near.w, x_unit, self.origin[0]),
            round_ball_dd_plus(&near.y, &near.w, x_unit, self.origin[1]),
            round_ball_dd_plus(&near.time, &near.since, t_unit, 0.0),
        ];
        if let [Some(x), Some(y), Some(t)] = fast {
            return [x, y, t];
        }
        let wide = point::<Wide>(self, place);
        let fast = [
            fast[0].or_else(|| round_wide_plus(&wide.x, &wide.w, self.unit, self.origin[0])),
            fast[1].or_else(|| round_wide_plus(&wide.y, &wide.w, self.unit, self.origin[1])),
            fast[2].or_else(|| round_wide_plus(&wide.time, &wide.since, self.time_unit, 0.0)),
        ];
        if let [Some(x), Some(y), Some(t)] = fast {
            return [x, y, t];
        }
        let exact = point::<Surd>(self, place);
        [
            fast[0].unwrap_or_else(|| {
                round_quotient_plus(&exact.x, &exact.w, self.unit, self.origin[0])
            }),
            fast[1].unwrap_or_else(|| {
                round_quotient_plus(&exact.y, &exact.w, self.unit, self.origin[1])
            }),
            fast[2].unwrap_or_else(|| {
                round_quotient_plus(&exact.time, &exact.since, self.time_unit, 0.0)
            }),
        ]
    }

    /// The velocity of a vertex, each component the nearest f64.
    pub(crate) fn round_velocity(&self, pair: [PlaneId; 2]) -> [f64; 2] {
        let velocity = |x: &dyn Fn() -> (Surd, Surd), near: (BallDd, BallDd)| {
            let unit = self.unit - self.time_unit;
            round_ball_dd_plus(&near.0, &near.1, unit + self.speed_shift(), 0.0).unwrap_or_else(
                || {
                    let (p, q) = x();
                    round_quotient_plus(&p, &q, unit, 0.0)
                },
            )
        };
        let near = Path::<BallDd>::new(self, pair);
        let exact = || Path::<Surd>::new(self, pair);
        [
            velocity(&|| (exact().x[1].clone(), exact().m), (near.x[1], near.m)),
            velocity(&|| (exact().y[1].clone(), exact().m), (near.y[1], near.m)),
        ]
    }

    /// The velocity of a plane along its normal, each component the nearest f64.
    pub(crate) fn round_normal_velocity(&self, plane: PlaneId) -> [f64; 2] {
        fn parts<T: Rung>(planes: &Planes, plane: PlaneId) -> [T; 3] {
            let plane = T::plane(planes, plane);
            let square = plane.a.times(&plane.a).plus(&plane.b.times(&plane.b));
            [plane.a.times(&plane.s), plane.b.times(&plane.s), square]
        }
        let unit = self.unit - self.time_unit;
        let near = parts::<BallDd>(self, plane);
        [0, 1].map(|k| {
            round_ball_dd_plus(&near[k], &near[2], unit + self.speed_shift(), 0.0).unwrap_or_else(
                || {
                    let exact = parts::<Surd>(self, plane);
                    round_quotient_plus(&exact[k], &exact[2], unit, 0.0)
                },
            )
        })
    }
}
