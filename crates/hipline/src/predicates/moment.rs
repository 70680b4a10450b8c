//! Moments of the propagation and what holds at them.
//!
//! Events of the wavefront happen when three planes meet; flips of spokes among three
//! vertices happen at the root of a quadratic. Every question about a moment is the sign
//! of a polynomial in time, of degree two at most, at that moment.

use hipline_num::{Ball, BallDd, Number, Sign, Surd, Wide};
use std::cmp::Ordering;

use super::{
    expression::{Corner, Direction, Quadratic, area, difference, lead, meeting, minor},
    planes::{Plane, PlaneId, Planes, Question, Rung},
    root::{ball_root, dd_root, discriminant, double, exact_root, root_bounds, wide_root},
};

/// A moment, by its definition.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Moment {
    /// Time zero.
    Start,
    /// Three planes meet; ids ascending.
    Planes([PlaneId; 3]),
    /// The area of a triangle shrinks to zero: the root of its area polynomial at which
    /// the polynomial does not increase.
    Root([Corner; 3]),
}

impl Moment {
    /// The moment when three planes meet.
    pub(crate) fn of_planes(mut planes: [PlaneId; 3]) -> Self {
        planes.sort_unstable();
        Self::Planes(planes)
    }
}

/// Something that changes over time: a polynomial.
pub(crate) trait Curve {
    /// Whether the last coefficient is always zero.
    const LINEAR: bool;
    /// The coefficients; `None` where a rung abstains.
    fn coefficients<T: Rung>(&self, planes: &Planes) -> Option<Quadratic<T>>;
}

/// The area of a triangle, and what derives from it.
pub(crate) struct Area(pub [Corner; 3], pub Part);

/// Which part of a polynomial.
#[derive(Clone, Copy)]
pub(crate) enum Part {
    Value,
    Slope,
    Curvature,
    Discriminant,
}

impl Curve for Area {
    const LINEAR: bool = false;
    fn coefficients<T: Rung>(&self, planes: &Planes) -> Option<Quadratic<T>> {
        let g = area::<T>(planes, self.0);
        Some(match self.1 {
            Part::Value => g,
            Part::Slope => [g[1].clone(), double(&g[2]), T::zero()],
            Part::Curvature => [g[2].clone(), T::zero(), T::zero()],
            Part::Discriminant => [discriminant(&g), T::zero(), T::zero()],
        })
    }
}

/// How far a vertex is ahead of a plane.
pub(crate) struct Lead(pub [PlaneId; 2], pub PlaneId);

impl Curve for Lead {
    const LINEAR: bool = true;
    #[inline]
    fn coefficients<T: Rung>(&self, planes: &Planes) -> Option<Quadratic<T>> {
        let [f0, f1] = lead::<T>(planes, self.0, self.1);
        Some([f0, f1, T::zero()])
    }
}

/// The difference of two vertices in x (or, if the flag is set, y).
pub(crate) struct Difference(pub [PlaneId; 2], pub [PlaneId; 2], pub bool);

impl Curve for Difference {
    const LINEAR: bool = true;
    fn coefficients<T: Rung>(&self, planes: &Planes) -> Option<Quadratic<T>> {
        let [f0, f1] = difference::<T>(planes, self.0, self.1, self.2);
        Some([f0, f1, T::zero()])
    }
}

/// Time elapsed since three planes met.
struct Since([PlaneId; 3]);

impl Curve for Since {
    const LINEAR: bool = true;
    #[inline]
    fn coefficients<T: Rung>(&self, planes: &Planes) -> Option<Quadratic<T>> {
        let (n, d) = meeting::<T>(planes, self.0);
        match d.sign()? {
            Sign::Positive => Some([n, d, T::zero()]),
            Sign::Negative => Some([n.negated(), d.negated(), T::zero()]),
            Sign::Zero => unreachable!("{:?} never meet", self.0),
        }
    }
}

/// The sign of a curve at a moment.
struct SignAt<'a, C>(&'a Moment, &'a C);

impl<C: Curve> Question for SignAt<'_, C> {
    #[inline]
    fn ask<T: Rung>(&self, planes: &Planes) -> Option<Sign> {
        let f = self.1.coefficients::<T>(planes)?;
        match self.0 {
            Moment::Start => f[0].sign(),
            Moment::Planes(triple) => {
                let (n, d) = meeting::<T>(planes, *triple);
                let linear = f[0].times(&d).minus(&f[1].times(&n));
                if C::LINEAR {
                    Some(linear.sign()? * d.sign()?)
                } else {
                    linear.times(&d).plus(&f[2].times(&n.times(&n))).sign()
                }
            }
            Moment::Root(corners) => {
                let g = area::<T>(planes, *corners);
                let t = T::falling_root(&g)?;
                f[2].times(&t).plus(&f[1]).times(&t).plus(&f[0]).sign()
            }
        }
    }

    fn ask_exactly(&self, planes: &Planes) -> Sign {
        let Moment::Root(corners) = self.0 else {
            return self
                .ask::<Surd>(planes)
                .expect("exact numbers know their sign");
        };
        let f = self
            .1
            .coefficients::<Surd>(planes)
            .expect("exact numbers know their sign");
        let g = area::<Surd>(planes, *corners);
        if g[2].sign() == Some(Sign::Zero) {
            // A line: t = -g0 / g1.
            let linear = f[0].times(&g[1]).minus(&f[1].times(&g[0]));
            let value = linear.times(&g[1]).plus(&f[2].times(&g[0].times(&g[0])));
            return value.sign().expect("exact numbers know their sign");
        }
        // g2 f - f2 g = p1 t + p0; at t = (-g1 - sqrt(disc)) / 2 g2, times 2 g2 (and g2
        // twice in all, a square): 2 g2 p0 - p1 g1 - p1 sqrt(disc).
        let p1 = g[2].times(&f[1]).minus(&f[2].times(&g[1]));
        let p0 = g[2].times(&f[0]).minus(&f[2].times(&g[0]));
        let a = double(&g[2].times(&p0)).minus(&p1.times(&g[1]));
        Surd::sign_with_root(&a, &p1.negated(), &discriminant(&g))
    }
}

/// Bounds wider than this part of their value are worth a second attempt. Only a matter of
/// speed: bounds hold whatever their width.
const WIDE: f64 = 1.0 / (1u64 << 30) as f64;

/// Where a moment lies, as far as f64 can tell: `low <= t <= high`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Bounds {
    pub low: f64,
    pub high: f64,
}

impl Bounds {
    /// Time zero.
    pub(crate) const START: Self = Self {
        low: 0.0,
        high: 0.0,
    };

    /// The order of two moments, where the bounds decide it.
    #[inline]
    pub(crate) fn compare(self, other: Self) -> Option<Ordering> {
        if self.high < other.low {
            Some(Ordering::Less)
        } else if self.low > other.high {
            Some(Ordering::Greater)
        } else if self.low >= self.high && other.low >= other.high {
            Some(Ordering::Equal)
        } else {
            None
        }
    }
}

/// `-n / d` if it is a binary fraction that f64 holds exactly.
#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_precision_loss,
    reason = "integers below 2^53"
)]
fn exact_quotient(n: &Ball, d: &Ball) -> Option<f64> {
    if n.error() > 0.0 || d.error() > 0.0 {
        return None;
    }
    let (n, d) = (n.value() as i64, d.value() as i64);
    let odd = d >> d.trailing_zeros();
    (n % odd == 0).then(|| -(n as f64) / d as f64)
}

impl Planes {
    /// The sign of a curve at a moment.
    #[inline]
    pub(crate) fn sign_at<C: Curve>(&self, moment: &Moment, curve: &C) -> Sign {
        self.decide(&SignAt(moment, curve))
    }

    /// The sign of a curve that does not change.
    pub(crate) fn sign_of<C: Curve>(&self, curve: &C) -> Sign {
        self.decide(&SignAt(&Moment::Start, curve))
    }

    /// A moment that exists, in double-double.
    pub(crate) fn fine(&self, moment: &Moment) -> BallDd {
        match moment {
            Moment::Start => BallDd::zero(),
            Moment::Planes(triple) => {
                let (n, d) = meeting::<BallDd>(self, *triple);
                n.negated().div(&d)
            }
            Moment::Root(corners) => dd_root::falling_root(&area(self, *corners))
                .unwrap_or_else(|| BallDd::new(0.0, 0.0, f64::INFINITY)),
        }
    }

    /// A moment that exists, in 400 digits.
    pub(crate) fn wide(&self, moment: &Moment) -> Option<Wide> {
        match moment {
            Moment::Start => Some(Wide::zero()),
            Moment::Planes(triple) => {
                let (n, d) = meeting::<Wide>(self, *triple);
                Some(n.negated().div(&d))
            }
            Moment::Root(corners) => wide_root::falling_root(&area(self, *corners)),
        }
    }

    /// Bounds of a moment that exists.
    pub(crate) fn bounds(&self, moment: &Moment) -> Bounds {
        match moment {
            Moment::Start => Bounds::START,
            Moment::Planes(triple) => {
                let (n, d) = meeting::<Ball>(self, *triple);
                self.bounds_of_meeting(*triple, &n, &d)
            }
            Moment::Root(corners) => {
                let g = area::<Ball>(self, *corners);
                if let Some(t) = exact_root(&g) {
                    return Bounds { low: t, high: t };
                }
                let ball = ball_root::falling_root(&g);
                if let Some(t) = ball
                    && t.error() <= t.value().abs() * WIDE
                {
                    return Bounds {
                        low: t.lower(),
                        high: t.upper(),
                    };
                }
                let g = area::<BallDd>(self, *corners);
                match dd_root::falling_root(&g) {
                    Some(t) => Bounds {
                        low: t.lower(),
                        high: t.upper(),
                    },
                    None => root_bounds(&g),
                }
            }
        }
    }

    fn bounds_of_meeting(&self, triple: [PlaneId; 3], n: &Ball, d: &Ball) -> Bounds {
        if let Some(t) = exact_quotient(n, d) {
            return Bounds { low: t, high: t };
        }
        let t = n.negated().div(d);
        if t.error() <= t.value().abs() * WIDE {
            return Bounds {
                low: t.lower(),
                high: t.upper(),
            };
        }
        let (n, d) = meeting::<BallDd>(self, triple);
        let t = n.negated().div(&d);
        if t.error().is_finite() {
            Bounds {
                low: t.lower(),
                high: t.upper(),
            }
        } else {
            Bounds {
                low: 0.0,
                high: f64::INFINITY,
            }
        }
    }

    /// Whether two moments are equal for a reason that is cheap to see.
    pub(crate) fn evidently_equal(&self, a: &Moment, b: &Moment) -> bool {
        match (a, b) {
            (Moment::Planes(s), Moment::Planes(t)) => self.meet_evidently_together(*s, *t),
            _ => a == b,
        }
    }

    /// Which of two moments comes first? Exact; `Equal` means equal as real numbers.
    ///
    /// Both must exist, and lie where neither root's triangle has been flipped yet.
    pub(crate) fn compare(&self, a: &Moment, b: &Moment) -> Ordering {
        match (a, b) {
            _ if a == b => Ordering::Equal,
            (_, Moment::Planes(triple)) => self.sign_at(a, &Since(*triple)).ordering(),
            (_, Moment::Root(corners)) => self.compare_with_root(a, *corners),
            (Moment::Planes(_) | Moment::Root(_), Moment::Start) => self.compare(b, a).reverse(),
            (Moment::Start, Moment::Start) => Ordering::Equal,
        }
    }

    /// The order of a moment and the falling root of a triangle's area g, from the signs of
    /// g and of its derivatives there.
    fn compare_with_root(&self, a: &Moment, corners: [Corner; 3]) -> Ordering {
        let value = self.sign_at(a, &Area(corners, Part::Value));
        let slope = self.sign_at(a, &Area(corners, Part::Slope));
        let concave = || self.sign_of(&Area(corners, Part::Curvature)).is_negative();
        match (value, slope) {
            // On the falling branch.
            (Sign::Positive, Sign::Negative) => Ordering::Less,
            (Sign::Zero, Sign::Negative | Sign::Zero) => Ordering::Equal,
            // Rising: a concave curve falls later, a convex one fell before.
            (_, Sign::Positive) | (Sign::Positive, Sign::Zero) => {
                if concave() {
                    Ordering::Less
                } else {
                    Ordering::Greater
                }
            }
            // Below zero and not rising: past the root.
            (Sign::Negative, Sign::Negative | Sign::Zero) => Ordering::Greater,
        }
    }

    /// Whether the vertex is ahead of the plane at the moment (zero: on it).
    #[inline]
    pub(crate) fn lead(&self, moment: &Moment, vertex: [PlaneId; 2], plane: PlaneId) -> Sign {
        if vertex.contains(&plane) || *moment == Moment::of_planes([vertex[0], vertex[1], plane]) {
            return Sign::Zero;
        }
        self.sign_at(moment, &Lead(vertex, plane))
    }

    /// Whether two vertices are at one place: each plane of one passes through the other.
    fn coincide(&self, moment: &Moment, u: [PlaneId; 2], v: [PlaneId; 2]) -> bool {
        u.iter().all(|&plane| self.lead(moment, v, plane).is_zero())
    }

    /// Compares the places of two vertices at a moment by x, then y.
    pub(crate) fn compare_places(
        &self,
        moment: &Moment,
        u: [PlaneId; 2],
        v: [PlaneId; 2],
    ) -> Ordering {
        if self.coincide(moment, u, v) {
            return Ordering::Equal;
        }
        self.compare_coordinate(moment, u, v, false)
            .then_with(|| self.compare_coordinate(moment, u, v, true))
    }

    /// Compares one coordinate of two vertices at a moment.
    pub(crate) fn compare_coordinate(
        &self,
        moment: &Moment,
        u: [PlaneId; 2],
        v: [PlaneId; 2],
        ordinate: bool,
    ) -> Ordering {
        self.sign_at(moment, &Difference(u, v, ordinate)).ordering()
    }
}

/// The D of a meeting: constant.
struct Closing([PlaneId; 3]);

impl Curve for Closing {
    const LINEAR: bool = true;
    fn coefficients<T: Rung>(&self, planes: &Planes) -> Option<Quadratic<T>> {
        Some([meeting::<T>(planes, self.0).1, T::zero(), T::zero()])
    }
}

/// Zero if and only if the paths of two vertices are such that they meet, or never move
/// relative to each other: constant.
struct Crossing([PlaneId; 2], [PlaneId; 2]);

impl Curve for Crossing {
    const LINEAR: bool = true;
    fn coefficients<T: Rung>(&self, planes: &Planes) -> Option<Quadratic<T>> {
        let [x0, x1] = difference::<T>(planes, self.0, self.1, false);
        let [y0, y1] = difference::<T>(planes, self.0, self.1, true);
        Some([x0.times(&y1).minus(&x1.times(&y0)), T::zero(), T::zero()])
    }
}

impl Planes {
    /// Whether three planes have exactly one point in common.
    pub(crate) fn do_meet(&self, triple: [PlaneId; 3]) -> bool {
        !self.sign_of(&Closing(triple)).is_zero()
    }

    /// Bounds of the moment when three planes meet, if their D has the given sign.
    #[inline]
    pub(crate) fn meeting_if(&self, triple: [PlaneId; 3], sign: Sign) -> Option<Bounds> {
        let (n, d) = meeting::<Ball>(self, triple);
        match d.sign() {
            Some(found) if found != sign => None,
            Some(_) => Some(self.bounds_of_meeting(triple, &n, &d)),
            None => (self.sign_of(&Closing(triple)) == sign)
                .then(|| self.bounds_of_meeting(triple, &n, &d)),
        }
    }

    /// Whether two vertices meet at some time (or have one velocity).
    pub(crate) fn paths_cross(&self, u: [PlaneId; 2], v: [PlaneId; 2]) -> bool {
        u.iter().any(|i| v.contains(i)) || self.sign_of(&Crossing(u, v)).is_zero()
    }

    /// Bounds of the moment after `now` at which a triangle, of positive area now, becomes
    /// flat, if it does.
    pub(crate) fn falling_root(&self, now: &Moment, corners: [Corner; 3]) -> Option<Bounds> {
        let g = area::<Ball>(self, corners);
        let part = |part, ball: &Ball| {
            ball.sign()
                .unwrap_or_else(|| self.sign_of(&Area(corners, part)))
        };
        let falls = || self.sign_at(now, &Area(corners, Part::Slope)).is_negative();
        let exists = match part(Part::Curvature, &g[2]) {
            Sign::Negative => true,
            Sign::Zero => falls(),
            Sign::Positive => !part(Part::Discriminant, &discriminant(&g)).is_negative() && falls(),
        };
        exists.then(|| self.bounds(&Moment::Root(corners)))
    }
}

/// The sine (up to a positive factor) or cosine between the normals of two planes.
struct Between(PlaneId, PlaneId, bool);

impl Curve for Between {
    const LINEAR: bool = true;
    #[inline]
    fn coefficients<T: Rung>(&self, planes: &Planes) -> Option<Quadratic<T>> {
        let (i, j) = (T::plane(planes, self.0), T::plane(planes, self.1));
        let value = if self.2 {
            i.a.times(&j.a).plus(&i.b.times(&j.b))
        } else {
            minor(&i, &j)
        };
        Some([value, T::zero(), T::zero()])
    }
}

/// The component of a plane's normal in a direction.
struct Heading(PlaneId, Direction);

impl Curve for Heading {
    const LINEAR: bool = true;
    fn coefficients<T: Rung>(&self, planes: &Planes) -> Option<Quadratic<T>> {
        let plane = T::plane(planes, self.0);
        let [dx, dy] = self.1.vector().map(T::from_i64);
        Some([
            plane.a.times(&dx).plus(&plane.b.times(&dy)),
            T::zero(),
            T::zero(),
        ])
    }
}

/// A minor of the coefficients of two planes, of two columns of `a b c s`; zero for all
/// columns if and only if the planes are one.
struct Minor(PlaneId, PlaneId, [usize; 2]);

impl Curve for Minor {
    const LINEAR: bool = true;
    fn coefficients<T: Rung>(&self, planes: &Planes) -> Option<Quadratic<T>> {
        let [i, j] = [self.0, self.1].map(|id| {
            let Plane { a, b, c, s } = T::plane(planes, id);
            [a, b, c, s]
        });
        let [p, q] = self.2;
        let value = i[p].times(&j[q]).minus(&j[p].times(&i[q]));
        Some([value, T::zero(), T::zero()])
    }
}

impl Planes {
    /// Whether two planes, one of them of a later phase, are the same.
    pub(super) fn are_one(&self, i: PlaneId, j: PlaneId) -> bool {
        let vanishes = |columns| self.sign_of(&Minor(i, j, columns)).is_zero();
        [[0, 1], [0, 2], [1, 2], [0, 3], [1, 3]]
            .into_iter()
            .all(vanishes)
            && self.same_direction(i, j)
    }

    /// Whether a wavefront edge of length zero, between two others, starts to grow.
    pub(crate) fn grows(&self, [before, plane, after]: [PlaneId; 3]) -> bool {
        let turns = [self.turn(before, plane), self.turn(plane, after)];
        // On one plane with its neighbour, it goes on as one with it.
        for (turn, other) in turns.into_iter().zip([before, after]) {
            if turn.is_zero() {
                return self.same_direction(plane, other)
                    && self.compare_speeds(plane, other).is_eq();
            }
        }
        self.sign_of(&Closing([before, plane, after])) == -(turns[0] * turns[1])
    }

    /// Whether a wavefront edge moves in a direction (zero: across it).
    pub(crate) fn heads(&self, plane: PlaneId, direction: Direction) -> Sign {
        self.sign_of(&Heading(plane, direction))
    }

    /// The turn from one wavefront edge to the next: positive to the left (convex),
    /// negative to the right (reflex), zero if they are parallel.
    #[inline]
    pub(crate) fn turn(&self, i: PlaneId, j: PlaneId) -> Sign {
        self.sign_of(&Between(i, j, false))
    }

    /// Whether two parallel planes move the same way.
    pub(crate) fn same_direction(&self, i: PlaneId, j: PlaneId) -> bool {
        self.sign_of(&Between(i, j, true)) == Sign::Positive
    }
}
