//! Where a point of the plan is: beside which arc, on which side, how late.
//!
//! A station is a point that somebody asks about: any two f64 numbers, finer than the grid of
//! the input or beyond it. The plane of a face gives the time at which the wavefront arrives
//! there, T = (a x + b y - c) / s. The line of an arc is where the times of its two faces
//! agree, so that a point is on the side of the sign of `T_f - T_g`: a polynomial of the planes
//! of the input, whatever events made the arc.

use dashu_int::IBig;
use hipline_num::{
    BallDd, Sign, Surd, common_unit, in_units, power_of_two, round_ball_dd_plus,
    round_quotient_plus,
};
use std::cmp::Ordering;

use super::{
    decide::Question,
    expression::Path,
    place::{Place, input, point},
    planes::{Plane, PlaneId, Planes, Rung},
    section::small,
};

/// A point in question: `x / w`, `y / w` on the grid of the planes, w a power of two.
#[derive(Debug)]
pub(crate) struct Station {
    x: IBig,
    y: IBig,
    w: IBig,
    /// The same, if these are small.
    small: Option<[i64; 3]>,
}

impl Station {
    /// The point with finite coordinates.
    pub(crate) fn new(planes: &Planes, [x, y]: [f64; 2]) -> Self {
        let parts = [x, y, planes.origin[0], planes.origin[1]];
        let unit = match common_unit(parts) {
            (unit, digits) if digits > 0 => unit.min(planes.unit),
            _ => planes.unit,
        };
        let [x, y, u, v] = parts.map(|x| in_units(x, unit));
        let (x, y) = (x - u, y - v);
        let w = IBig::ONE << (planes.unit - unit) as usize;
        let small = small([&x, &y, &w]);
        Self { x, y, w, small }
    }

    /// `[x, y, w]` in the numbers of one rung.
    pub(super) fn numbers<T: Rung>(&self, planes: &Planes) -> [T; 3] {
        match self.small {
            Some(small) if planes.shift == 0 => small.map(T::from_i64),
            _ => [
                T::integer(&self.x, planes.shift),
                T::integer(&self.y, planes.shift),
                T::integer(&self.w, 0),
            ],
        }
    }
}

/// A point of the plan.
#[derive(Debug, Clone, Copy)]
pub(crate) enum Spot<'a> {
    /// One that is asked about.
    Station(&'a Station),
    /// A node.
    Place(&'a Place),
}

/// `[x, y, w]` of a point at `x / w`, `y / w`.
fn spot<T: Rung>(planes: &Planes, spot: Spot) -> [T; 3] {
    match spot {
        Spot::Station(station) => station.numbers(planes),
        Spot::Place(place) => {
            let point = point::<T>(planes, place);
            [point.x, point.y, point.w]
        }
    }
}

/// A line that a border of faces lies on, directed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Track {
    /// Where two planes have the same time; points with a later time on the first one are
    /// positive.
    Equal([PlaneId; 2]),
    /// From one vertex of the input through another; its left is positive.
    Through([[f64; 2]; 2]),
    /// The perpendicular to a plane's edge through a place; what is further along the edge is
    /// positive.
    Across(PlaneId, Place),
    /// The parallel to a plane's edge through a place; what the wavefront reaches later is positive.
    Along(PlaneId, Place),
    /// Where a plane's wavefront edge is at a time; what comes later is positive.
    Level(PlaneId, f64),
}

/// `a x + b y - c w`: how far a point is ahead of a plane's edge, times its length and w.
fn reach<T: Rung>(plane: &Plane<T>, [x, y, w]: &[T; 3]) -> T {
    plane
        .a
        .times(x)
        .plus(&plane.b.times(y))
        .minus(&plane.c.times(w))
}

/// `[u, v, z]` of the line `u x + v y = z`, such that `u x + v y - z` has the sign of the
/// track's sides, but for the sign that comes second.
pub(super) fn line<T: Rung>(planes: &Planes, track: &Track) -> ([T; 3], Option<Sign>) {
    match track {
        Track::Equal(pair) => {
            let [f, g] = pair.map(|id| T::plane(planes, id));
            let mixed = |p: &T, q: &T| p.times(&g.s).minus(&q.times(&f.s));
            (
                [mixed(&f.a, &g.a), mixed(&f.b, &g.b), mixed(&f.c, &g.c)],
                Some(Sign::Positive),
            )
        }
        Track::Through(ends) => {
            let [p, q] = ends.map(|end| input::<T>(planes, end));
            let (u, v) = (p.y.minus(&q.y), q.x.minus(&p.x));
            let z = u.times(&p.x).plus(&v.times(&p.y));
            ([u, v, z], Some(Sign::Positive))
        }
        Track::Across(plane, start) => {
            let plane = T::plane(planes, *plane);
            let start = point::<T>(planes, start);
            let (u, v) = (plane.b.times(&start.w), plane.a.negated().times(&start.w));
            let z = plane.b.times(&start.x).minus(&plane.a.times(&start.y));
            ([u, v, z], start.w.sign())
        }
        Track::Along(plane, start) => {
            let plane = T::plane(planes, *plane);
            let start = point::<T>(planes, start);
            let (u, v) = (plane.a.times(&start.w), plane.b.times(&start.w));
            let z = plane.a.times(&start.x).plus(&plane.b.times(&start.y));
            ([u, v, z], start.w.sign())
        }
        Track::Level(plane, time) => {
            let plane = T::plane(planes, *plane);
            let [time, since] = T::time(planes, *time);
            let z = plane.c.times(&since).plus(&plane.s.times(&time));
            (
                [plane.a.times(&since), plane.b.times(&since), z],
                since.sign(),
            )
        }
    }
}

/// On which side of a track a point is.
struct Beside<'a>(Spot<'a>, &'a Track);

impl Question for Beside<'_> {
    fn ask<T: Rung>(&self, planes: &Planes) -> Option<Sign> {
        let [x, y, w] = spot::<T>(planes, self.0);
        let ([u, v, z], sign) = line::<T>(planes, self.1);
        let value = u.times(&x).plus(&v.times(&y)).minus(&z.times(&w));
        Some(value.sign()? * w.sign()? * sign?)
    }
}

/// How two points compare in x, in y, or along the edge of a plane.
struct Apart<'a>(Spot<'a>, Spot<'a>, Axis);

#[derive(Clone, Copy)]
enum Axis {
    X,
    Y,
    Along(PlaneId),
}

impl Question for Apart<'_> {
    fn ask<T: Rung>(&self, planes: &Planes) -> Option<Sign> {
        let [p, q] = [self.0, self.1].map(|s| spot::<T>(planes, s));
        let d = |k: usize| p[k].times(&q[2]).minus(&q[k].times(&p[2]));
        let value = match self.2 {
            Axis::X => d(0),
            Axis::Y => d(1),
            Axis::Along(plane) => {
                let plane = T::plane(planes, plane);
                plane.b.times(&d(0)).minus(&plane.a.times(&d(1)))
            }
        };
        Some(value.sign()? * p[2].sign()? * q[2].sign()?)
    }
}

/// The sign of `n_f * grad(T_f - T_g)`: whether f gets later than g, going away from f's edge.
struct Falling(PlaneId, PlaneId);

impl Question for Falling {
    fn ask<T: Rung>(&self, planes: &Planes) -> Option<Sign> {
        let [f, g] = [self.0, self.1].map(|id| T::plane(planes, id));
        let u = f.a.times(&g.s).minus(&g.a.times(&f.s));
        let v = f.b.times(&g.s).minus(&g.b.times(&f.s));
        Some(u.times(&f.a).plus(&v.times(&f.b)).sign()? * f.s.sign()? * g.s.sign()?)
    }
}

/// The sign of `grad T_g * grad(T_f - T_g)`: going down on g, whether T_g gains on T_f.
struct Gaining(PlaneId, PlaneId);

impl Question for Gaining {
    fn ask<T: Rung>(&self, planes: &Planes) -> Option<Sign> {
        let [f, g] = [self.0, self.1].map(|id| T::plane(planes, id));
        let dot = f.a.times(&g.a).plus(&f.b.times(&g.b)).times(&g.s);
        let square = g.a.times(&g.a).plus(&g.b.times(&g.b)).times(&f.s);
        Some(dot.minus(&square).sign()? * f.s.sign()?)
    }
}

/// A way down from a node.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Way {
    /// Straight down on a plane.
    Plane(PlaneId),
    /// Along the intersection of two planes.
    Along([PlaneId; 2]),
}

/// Which of two ways is steeper.
struct Steeper(Way, Way);

impl Question for Steeper {
    fn ask<T: Rung>(&self, planes: &Planes) -> Option<Sign> {
        // The square of the slope, as a quotient.
        let slope = |way: Way| match way {
            Way::Plane(id) => {
                let Plane { a, b, s, .. } = T::plane(planes, id);
                (a.times(&a).plus(&b.times(&b)), s.times(&s))
            }
            Way::Along(pair) => {
                let Path { x, y, m } = Path::<T>::new(planes, pair);
                let square = x[1].times(&x[1]).plus(&y[1].times(&y[1]));
                (m.times(&m), square)
            }
        };
        let ((p, q), (r, s)) = (slope(self.0), slope(self.1));
        p.times(&s).minus(&r.times(&q)).sign()
    }
}

/// `x / w`, `y / w` and `time / since` where the way straight down on a plane meets a track.
fn landing<T: Rung>(planes: &Planes, from: Spot, plane: PlaneId, track: &Track) -> [T; 5] {
    let plane = T::plane(planes, plane);
    let [x, y, w] = spot::<T>(planes, from);
    let ([u, v, z], _) = line::<T>(planes, track);
    // On it, b x - a y = p / w.
    let p = plane.b.times(&x).minus(&plane.a.times(&y));
    let det = u.times(&plane.a).plus(&v.times(&plane.b));
    let at = [
        z.times(&plane.a).times(&w).plus(&v.times(&p)),
        z.times(&plane.b).times(&w).minus(&u.times(&p)),
        det.times(&w),
    ];
    let time = reach(&plane, &at);
    let since = plane.s.times(&at[2]);
    let [x, y, w] = at;
    [x, y, w, time, since]
}

impl Planes {
    /// On which side of a track a point is. Exact.
    pub(crate) fn beside(&self, spot: Spot, track: &Track) -> Sign {
        self.decide(&Beside(spot, track))
    }

    /// Compares two points by x.
    pub(crate) fn compare_abscissas(&self, p: Spot, q: Spot) -> Ordering {
        self.decide(&Apart(p, q, Axis::X)).ordering()
    }

    /// Compares two points by y.
    pub(crate) fn compare_ordinates(&self, p: Spot, q: Spot) -> Ordering {
        self.decide(&Apart(p, q, Axis::Y)).ordering()
    }

    /// Compares two points along the direction of a plane's edge.
    pub(crate) fn compare_spots_along(&self, p: Spot, q: Spot, plane: PlaneId) -> Ordering {
        self.decide(&Apart(p, q, Axis::Along(plane))).ordering()
    }

    /// Whether, away from the edge of f, the wavefront of f gets later than that of g.
    pub(crate) fn falling_behind(&self, f: PlaneId, g: PlaneId) -> Sign {
        self.decide(&Falling(f, g))
    }

    /// How `T_f - T_g` changes, going straight down on g.
    pub(crate) fn downhill_gain(&self, f: PlaneId, g: PlaneId) -> Sign {
        -self.decide(&Gaining(f, g))
    }

    /// Compares the slopes of two ways down.
    pub(crate) fn compare_slopes(&self, v: Way, w: Way) -> Ordering {
        if v == w {
            Ordering::Equal
        } else {
            self.decide(&Steeper(v, w)).ordering()
        }
    }

    /// When the wavefront on a plane arrives at a point: the nearest f64.
    pub(crate) fn arrival(&self, at: &Station, plane: PlaneId) -> f64 {
        fn parts<T: Rung>(planes: &Planes, at: &Station, plane: PlaneId) -> [T; 2] {
            let plane = T::plane(planes, plane);
            let at = spot::<T>(planes, Spot::Station(at));
            [reach(&plane, &at), plane.s.times(&at[2])]
        }
        let [p, q] = parts::<BallDd>(self, at, plane);
        round_ball_dd_plus(&p, &q, self.rough_time_unit(), 0.0).unwrap_or_else(|| {
            let [p, q] = parts::<Surd>(self, at, plane);
            round_quotient_plus(&p, &q, self.time_unit, 0.0)
        })
    }

    /// Where the way straight down on a plane meets a track, `[x, y, time]`: each the nearest
    /// f64.
    pub(crate) fn round_landing(&self, from: Spot, plane: PlaneId, track: &Track) -> [f64; 3] {
        let near = landing::<BallDd>(self, from, plane, track);
        let unit = self.unit + self.shift;
        let fast = |p: usize, q: usize, unit: i32, origin: f64| {
            round_ball_dd_plus(&near[p], &near[q], unit, origin)
        };
        let fast = [
            fast(0, 2, unit, self.origin[0]),
            fast(1, 2, unit, self.origin[1]),
            fast(3, 4, self.rough_time_unit(), 0.0),
        ];
        if let [Some(x), Some(y), Some(t)] = fast {
            return [x, y, t];
        }
        let exact = landing::<Surd>(self, from, plane, track);
        let slow = |p: usize, q: usize, unit: i32, origin: f64| {
            round_quotient_plus(&exact[p], &exact[q], unit, origin)
        };
        [
            slow(0, 2, self.unit, self.origin[0]),
            slow(1, 2, self.unit, self.origin[1]),
            slow(3, 4, self.time_unit, 0.0),
        ]
    }
}

/// On which side of the line from p to q the point r is, where each is known to the nearest f64;
/// `None` where that does not tell.
///
/// Let M bound the coordinates, D their differences, u = 2^-53. A coordinate is off by u M at
/// most, a difference of two by 5 u M with its own rounding. So the determinant is off by
/// 2 (2 D 5 u M + 25 u^2 M^2) + 6 u D^2, and D is at most 2 M: less than 32 u M D + 50 u^2 M^2. The
/// bound below is four times that. Between the limits of M nothing overflows, and what
/// underflows is far below the bound.
pub(crate) fn rough_side(p: [f64; 2], q: [f64; 2], r: [f64; 2]) -> Option<Sign> {
    const SLACK: f64 = 1.0 / (1_u64 << 46) as f64;
    const LARGE: f64 = power_of_two(400);
    const SMALL: f64 = power_of_two(-400);
    let size = [p, q, r]
        .iter()
        .flatten()
        .fold(0.0_f64, |m, x| m.max(x.abs()));
    if !(SMALL..=LARGE).contains(&size) {
        return None;
    }
    let [qx, qy, rx, ry] = [q[0] - p[0], q[1] - p[1], r[0] - p[0], r[1] - p[1]];
    let reach = qx.abs().max(qy.abs()).max(rx.abs()).max(ry.abs());
    let bound = SLACK * size * (reach + SLACK * size);
    let value = qx * ry - qy * rx;
    if value > bound {
        Some(Sign::Positive)
    } else if value < -bound {
        Some(Sign::Negative)
    } else {
        None
    }
}
