//! When a vertex passes a line that stands still, and in which order: what motorcycles ask.
//!
//! The path of the vertex of planes i and j, seen from above, is a line without time,
//! `s_j (a_i x + b_i y - c_i) = s_i (a_j x + b_j y - c_j)`. Another vertex, at
//! `(x0 + x1 t) / m`, `(y0 + y1 t) / m`, passes a line `u x + v y = z` when
//! `t (u x1 + v y1) = z m - u x0 - v y0`. So such a moment, too, is a quotient of sums of roots of
//! the input: of products of two at most.

use hipline_num::{Ball, BallDd, Number, Rough, Sign, Wide};
use std::cmp::Ordering;

use super::{
    decide::Question,
    expression::{Path, differences, meeting},
    moment::Bounds,
    place::{Place, Point, point},
    planes::{PlaneId, Planes, Rung},
    rough::known,
};

/// A line that stands still.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Rail {
    /// The path of the vertex of two planes.
    Path([PlaneId; 2]),
    /// The edge of a plane.
    Edge(PlaneId),
}

/// `[u, v, z]` of the line `u x + v y = z`; of a path, the right side is positive.
fn line<T: Rung>(planes: &Planes, rail: Rail) -> [T; 3] {
    match rail {
        Rail::Path(pair) => {
            let [i, j] = pair.map(|id| T::plane(planes, id));
            let mixed = |p: &T, q: &T| p.times(&j.s).minus(&q.times(&i.s));
            [mixed(&i.a, &j.a), mixed(&i.b, &j.b), mixed(&i.c, &j.c)]
        }
        Rail::Edge(plane) => {
            let plane = T::plane(planes, plane);
            [plane.a, plane.b, plane.c]
        }
    }
}

/// `p` and `q` with the moment `p / q` when a vertex passes a line.
fn moment<T: Rung>(path: &Path<T>, [u, v, z]: &[T; 3]) -> [T; 2] {
    let here = u.times(&path.x[0]).plus(&v.times(&path.y[0]));
    let speed = u.times(&path.x[1]).plus(&v.times(&path.y[1]));
    [z.times(&path.m).minus(&here), speed]
}

/// The place where a vertex passes a line.
pub(super) fn passage<T: Rung>(planes: &Planes, pair: [PlaneId; 2], rail: Rail) -> Point<T> {
    let path = Path::<T>::new(planes, pair);
    let [time, since] = moment(&path, &line(planes, rail));
    let at = |z: &[T; 2]| z[0].times(&since).plus(&z[1].times(&time));
    Point {
        x: at(&path.x),
        y: at(&path.y),
        w: path.m.times(&since),
        time,
        since,
    }
}

/// `p` and `q` with the time `p / q` of a place that is none of a ghost arc.
fn time<T: Rung>(planes: &Planes, place: &Place) -> [T; 2] {
    match *place {
        Place::Event { moment, .. } => {
            let (n, d) = meeting::<T>(planes, moment);
            [n.negated(), d]
        }
        Place::On { pair, rail } => moment(&Path::new(planes, pair), &line(planes, rail)),
        Place::At { time, .. } => T::time(planes, time),
        Place::Vertex(_) => [T::zero(), T::from_i64(1)],
        Place::Foot { .. } => unreachable!("no motorcycle is at the end of a ghost arc"),
    }
}

/// The order of the times of two places.
struct Earlier<'a>(&'a Place, &'a Place);

impl Question for Earlier<'_> {
    fn ask<T: Rung>(&self, planes: &Planes) -> Option<Sign> {
        let ([p, v], [q, w]) = (time::<T>(planes, self.0), time::<T>(planes, self.1));
        Some(p.times(&w).minus(&q.times(&v)).sign()? * v.sign()? * w.sign()?)
    }
}

/// The cross product of two velocities.
struct Across([PlaneId; 2], [PlaneId; 2]);

impl Question for Across {
    fn ask<T: Rung>(&self, planes: &Planes) -> Option<Sign> {
        let [p, q] = [self.0, self.1].map(|pair| Path::<T>::new(planes, pair));
        p.x[1].times(&q.y[1]).minus(&p.y[1].times(&q.x[1])).sign()
    }
}

/// The scalar product of two velocities.
struct Alike([PlaneId; 2], [PlaneId; 2]);

impl Question for Alike {
    fn ask<T: Rung>(&self, planes: &Planes) -> Option<Sign> {
        let [p, q] = [self.0, self.1].map(|pair| Path::<T>::new(planes, pair));
        p.x[1].times(&q.x[1]).plus(&p.y[1].times(&q.y[1])).sign()
    }
}

/// With P the places at time zero and v the velocities: of `(P - Q) x (v - w)`. Divided by
/// `v x w`, that is by how much the first one comes later to where the paths cross.
struct Lag([PlaneId; 2], [PlaneId; 2]);

impl Question for Lag {
    fn ask<T: Rung>(&self, planes: &Planes) -> Option<Sign> {
        let [[x0, x1], [y0, y1]] = differences::<T>(planes, self.0, self.1);
        x0.times(&y1).minus(&x1.times(&y0)).sign()
    }
}

/// The velocity of a vertex along the normal of a plane.
struct Away([PlaneId; 2], PlaneId);

impl Question for Away {
    fn ask<T: Rung>(&self, planes: &Planes) -> Option<Sign> {
        let path = Path::<T>::new(planes, self.0);
        let plane = T::plane(planes, self.1);
        plane.away(&path.x[1], &path.y[1]).sign()
    }
}

/// A component of the velocity of a vertex, times a number that is not zero.
struct Component([PlaneId; 2], usize);

impl Question for Component {
    fn ask<T: Rung>(&self, planes: &Planes) -> Option<Sign> {
        let path = Path::<T>::new(planes, self.0);
        [path.x, path.y][self.1][1].sign()
    }
}

/// On which side of the path of a vertex a place is: the left is positive.
struct Side<'a>(&'a Place, [PlaneId; 2]);

impl Question for Side<'_> {
    fn ask<T: Rung>(&self, planes: &Planes) -> Option<Sign> {
        let at = point::<T>(planes, self.0);
        let [u, v, z] = line::<T>(planes, Rail::Path(self.1));
        let value = z.times(&at.w).minus(&u.times(&at.x)).minus(&v.times(&at.y));
        Some(value.sign()? * at.w.sign()?)
    }
}

/// Of two velocities in one direction: the sign of the difference of their sizes.
struct Faster([PlaneId; 2], [PlaneId; 2]);

impl Question for Faster {
    fn ask<T: Rung>(&self, planes: &Planes) -> Option<Sign> {
        let [[_, x], [_, y]] = differences::<T>(planes, self.0, self.1);
        let path = Path::<T>::new(planes, self.0);
        x.times(&path.x[1]).plus(&y.times(&path.y[1])).sign()
    }
}

/// The path of a vertex, roughly, to ask many things of.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Lane {
    x: [Rough; 2],
    y: [Rough; 2],
    m: Rough,
    z: Rough,
}

/// Where two paths cross, as far as f64 can tell.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Crossing {
    /// The cross product of the velocities; `None` if it is not known.
    pub turn: Option<Sign>,
    /// When each of the two is there.
    pub times: [Bounds; 2],
}

/// All of time.
const EVER: Bounds = Bounds {
    low: f64::NEG_INFINITY,
    high: f64::INFINITY,
};

/// Bounds of a ball.
fn bounds(t: &Ball) -> Bounds {
    if t.error().is_finite() {
        Bounds {
            low: t.lower(),
            high: t.upper(),
        }
    } else {
        EVER
    }
}

impl Lane {
    /// On which side of the path a point is, if f64 can tell: the left is positive.
    #[inline]
    pub(crate) fn side(&self, [x, y]: &[Rough; 2]) -> Option<Sign> {
        let ahead = self.y[1].times(x).minus(&self.x[1].times(y));
        self.z.minus(&ahead).sign()
    }

    /// On which side of the path another vertex is at a time, if f64 can tell: the left is positive.
    pub(crate) fn side_at(&self, other: &Self, time: f64) -> Option<Sign> {
        if !time.is_finite() {
            return None;
        }
        let time = Rough::near(known(time, time == 0.0));
        let [x, y] = [&other.x, &other.y].map(|z| z[0].plus(&z[1].times(&time)));
        let ahead = self.y[1].times(&x).minus(&self.x[1].times(&y));
        self.z.times(&other.m).minus(&ahead).sign()
    }

    /// Where two paths cross.
    pub(crate) fn cross(&self, o: &Self) -> Crossing {
        // The line of a path is y1 x - x1 y = z.
        let turn = self.x[1].times(&o.y[1]).minus(&self.y[1].times(&o.x[1]));
        let when = |path: &Self, rail: &Self| {
            rail.z
                .times(&path.m)
                .minus(&rail.y[1].times(&path.x[0]))
                .plus(&rail.x[1].times(&path.y[0]))
                .ball()
        };
        let since = turn.ball();
        Crossing {
            turn: turn.sign(),
            times: [
                bounds(&when(self, o).div(&since)),
                bounds(&when(o, self).div(&since.negated())),
            ],
        }
    }
}

impl Planes {
    /// The path of a vertex, roughly.
    pub(crate) fn lane(&self, pair: [PlaneId; 2]) -> Lane {
        let Path { x, y, m } = Path::<Rough>::new(self, pair);
        let [_, _, z] = line::<Rough>(self, Rail::Path(pair));
        Lane { x, y, m, z }
    }

    /// A vertex of the input, roughly.
    pub(crate) fn rough_vertex(&self, vertex: [f64; 2]) -> [Rough; 2] {
        [0, 1].map(|k| {
            let from_origin = Ball::from_f64(vertex[k]).minus(&Ball::from_f64(self.origin[k]));
            let near = from_origin.ldexp(-(self.unit + self.shift)).value();
            Rough::near(known(near, from_origin.value() == 0.0))
        })
    }

    /// Bounds of the time of a place that is none of a ghost arc.
    pub(crate) fn time_bounds(&self, place: &Place) -> Bounds {
        if matches!(place, Place::Vertex(_)) {
            return Bounds::START;
        }
        let [p, q] = time::<Rough>(self, place);
        let near = p.ball().div(&q.ball());
        // One part in 2^30 tells nearly all moments apart; what is worse is worth another attempt.
        if near.error() <= near.value().abs() / f64::from(1 << 30) {
            return bounds(&near);
        }
        Bounds::of(&self.near_time(place)).unwrap_or(EVER)
    }

    /// The time of a place that is none of a ghost arc, in double-doubles; of 400 digits where paths are so nearly
    /// parallel that theirs are not enough.
    pub(crate) fn near_time(&self, place: &Place) -> BallDd {
        let [p, q] = time::<BallDd>(self, place);
        let near = p.div(&q);
        if near.error() <= near.value().abs() / (1_u64 << 50) as f64 {
            return near;
        }
        let [p, q] = time::<Wide>(self, place);
        // These have no shift.
        let unit = self.time_unit - self.rough_time_unit();
        p.div(&q).to_ball_dd().ldexp(unit)
    }

    /// Compares the times of two places that are none of a ghost arc. Exact.
    pub(crate) fn compare_instants(&self, p: &Place, q: &Place) -> Ordering {
        if p == q {
            Ordering::Equal
        } else {
            self.decide(&Earlier(p, q)).ordering()
        }
    }

    /// The turn from the velocity of one vertex to that of another.
    pub(crate) fn turn_of_paths(&self, u: [PlaneId; 2], v: [PlaneId; 2]) -> Sign {
        if u == v {
            return Sign::Zero;
        }
        self.decide(&Across(u, v))
    }

    /// Whether the angle between two velocities is acute.
    pub(crate) fn go_alike(&self, u: [PlaneId; 2], v: [PlaneId; 2]) -> bool {
        self.decide(&Alike(u, v)).is_positive()
    }

    /// Whether a vertex does not move along an axis.
    pub(crate) fn is_static(&self, pair: [PlaneId; 2], axis: usize) -> bool {
        self.decide(&Component(pair, axis)).is_zero()
    }

    /// Which of two vertices comes first to where their paths, which turn as told, cross?
    pub(crate) fn compare_at_crossing(
        &self,
        u: [PlaneId; 2],
        v: [PlaneId; 2],
        turn: Sign,
    ) -> Ordering {
        (self.decide(&Lag(u, v)) * turn).ordering()
    }

    /// On which side of the path of a vertex a vertex of the input is: the left is positive.
    pub(crate) fn side_of_path(&self, vertex: [f64; 2], pair: [PlaneId; 2]) -> Sign {
        self.decide(&Side(&Place::Vertex(vertex), pair))
    }

    /// Whether a place is on the line of the path of a vertex.
    pub(crate) fn is_on_path(&self, place: &Place, pair: [PlaneId; 2]) -> bool {
        self.decide(&Side(place, pair)).is_zero()
    }

    /// Whether the first one of two vertices that go in one direction is faster.
    pub(crate) fn is_faster(&self, u: [PlaneId; 2], v: [PlaneId; 2]) -> bool {
        self.decide(&Faster(u, v)).is_positive()
    }

    /// Whether a vertex moves along the normal of a plane (positive) or against it.
    pub(crate) fn moves_away(&self, pair: [PlaneId; 2], plane: PlaneId) -> Sign {
        self.decide(&Away(pair, plane))
    }
}
