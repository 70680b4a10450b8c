//! Moments of the propagation and what holds at them.
//!
//! Events of the wavefront happen when three planes meet; flips of spokes among three
//! vertices happen at the root of a quadratic. Every question about a moment is the sign
//! of a polynomial in time, of degree two at most, at that moment.

use hipline_num::{Ball, BallDd, Number, Rough, Sign, Wide};
use std::cmp::Ordering;

use super::{
    decide::{Exact, Question},
    expression::{
        Corner, Path, Quadratic, area, area_at, curvature, difference, differences, lead, meeting,
    },
    planes::{PlaneId, Planes, Rung},
    root::{
        AtRoot, at_root, ball_root, dd_root, discriminant, double, exact_root, root_bounds,
        wide_root,
    },
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
    /// A number with the sign at a moment, where there is one that takes less than the
    /// polynomial.
    fn shortly<T: Rung>(&self, _planes: &Planes, _moment: &Moment) -> Option<T> {
        None
    }
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

    fn shortly<T: Rung>(&self, planes: &Planes, moment: &Moment) -> Option<T> {
        match (self.1, moment) {
            (Part::Value, Moment::Planes(triple)) => Some(area_at(planes, self.0, *triple)),
            (Part::Curvature, Moment::Start) => Some(curvature(planes, self.0)),
            _ => None,
        }
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
pub(super) struct SignAt<'a, C>(pub &'a Moment, pub &'a C);

impl<C: Curve> Question for SignAt<'_, C> {
    #[inline]
    fn ask<T: Rung>(&self, planes: &Planes) -> Option<Sign> {
        if !T::HAS_ROOTS && matches!(self.0, Moment::Root(_)) {
            return None;
        }
        let f = self.1.coefficients::<T>(planes)?;
        match self.0 {
            Moment::Start => f[0].sign(),
            Moment::Planes(triple) => {
                let (n, d) = T::met(planes, *triple);
                let linear = f[0].times(&d).minus(&f[1].times(&n));
                if C::LINEAR {
                    let sign = linear.sign()?;
                    // What is zero is often so at little cost, unlike the sign of d.
                    Some(if sign.is_zero() {
                        sign
                    } else {
                        sign * d.sign()?
                    })
                } else {
                    linear.times(&d).plus(&f[2].times(&n.times(&n))).sign()
                }
            }
            Moment::Root(corners) => {
                let t = T::flat_at(planes, *corners)?;
                f[2].times(&t).plus(&f[1]).times(&t).plus(&f[0]).sign()
            }
        }
    }

    fn ask_exactly<T: Exact>(&self, planes: &Planes) -> Option<Sign> {
        let Moment::Root(corners) = self.0 else {
            return match self.1.shortly::<T>(planes, self.0) {
                Some(value) => value.sign(),
                None => self.ask::<T>(planes),
            };
        };
        let f = self.1.coefficients::<T>(planes)?;
        let g = area::<T>(planes, *corners);
        match at_root(&f, &g)? {
            AtRoot::Value(value) => value.sign(),
            AtRoot::Sum(a, b, delta) => T::sign_with_root(&a, &b, &delta),
        }
    }
}

/// Whether two moments are the same function of equal numbers, which is seen at little cost: so are those of parts that
/// are mirror images of each other.
struct Alike<'a>(&'a Moment, &'a Moment);

impl Question for Alike<'_> {
    fn ask<T: Rung>(&self, _: &Planes) -> Option<Sign> {
        None
    }

    fn ask_exactly<T: Exact>(&self, planes: &Planes) -> Option<Sign> {
        let alike = match (self.0, self.1) {
            (Moment::Planes(a), Moment::Planes(b)) => {
                let [(n, d), (p, q)] = [a, b].map(|triple| meeting::<T>(planes, *triple));
                n.is_same(&p) && d.is_same(&q) || n.is_same(&p.negated()) && d.is_same(&q.negated())
            }
            (Moment::Root(a), Moment::Root(b)) => {
                let [f, g] = [a, b].map(|corners| area::<T>(planes, *corners));
                f.iter().zip(&g).all(|(x, y)| x.is_same(y))
            }
            _ => false,
        };
        alike.then_some(Sign::Zero)
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

    /// Those of a double-double, if it has any.
    pub(super) fn of(t: &BallDd) -> Option<Self> {
        t.error().is_finite().then(|| Self {
            low: t.lower(),
            high: t.upper(),
        })
    }

    /// Those of a ball, if they are close.
    #[inline]
    fn narrow(t: &Ball) -> Option<Self> {
        (t.error() <= t.value().abs() * WIDE).then(|| Self {
            low: t.lower(),
            high: t.upper(),
        })
    }

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
    pub(crate) fn wide(&self, moment: &Moment) -> Wide {
        match moment {
            Moment::Start => Wide::zero(),
            Moment::Planes(triple) => {
                let (n, d) = meeting::<Wide>(self, *triple);
                n.negated().div(&d)
            }
            Moment::Root(corners) => {
                wide_root::falling_root(&area(self, *corners)).unwrap_or(Wide::UNKNOWN)
            }
        }
    }

    /// Bounds of a moment that exists.
    pub(crate) fn bounds(&self, moment: &Moment) -> Bounds {
        match moment {
            Moment::Start => Bounds::START,
            Moment::Planes(triple) => {
                let (n, d) = meeting::<Rough>(self, *triple);
                self.bounds_of_meeting(*triple, &n, &d)
            }
            Moment::Root(corners) => self.bounds_of_root(*corners, &area(self, *corners)),
        }
    }

    /// Bounds of a root that exists, of an area that is known roughly.
    fn bounds_of_root(&self, corners: [Corner; 3], g: &Quadratic<Rough>) -> Bounds {
        if !g.iter().all(Rough::may_be_exact) {
            let near = ball_root::falling_root(&g.each_ref().map(Rough::ball));
            if let Some(bounds) = near.and_then(|t| Bounds::narrow(&t)) {
                return bounds;
            }
        }
        let g = area::<Ball>(self, corners);
        if let Some(t) = exact_root(&g) {
            return Bounds { low: t, high: t };
        }
        let near = ball_root::falling_root(&g);
        if let Some(bounds) = near.and_then(|t| Bounds::narrow(&t)) {
            return bounds;
        }
        let g = area::<BallDd>(self, corners);
        let near = dd_root::falling_root(&g);
        let bounds = near.and_then(|t| Bounds::of(&t));
        bounds.unwrap_or_else(|| root_bounds(&g))
    }

    /// Bounds of a meeting whose N and D are known roughly.
    fn bounds_of_meeting(&self, triple: [PlaneId; 3], n: &Rough, d: &Rough) -> Bounds {
        if !(n.may_be_exact() && d.may_be_exact())
            && let Some(bounds) = Bounds::narrow(&n.ball().negated().div(&d.ball()))
        {
            return bounds;
        }
        self.closer_bounds_of_meeting(triple)
    }

    fn closer_bounds_of_meeting(&self, triple: [PlaneId; 3]) -> Bounds {
        let (n, d) = meeting::<Ball>(self, triple);
        if let Some(t) = exact_quotient(&n, &d) {
            return Bounds { low: t, high: t };
        }
        if let Some(bounds) = Bounds::narrow(&n.negated().div(&d)) {
            return bounds;
        }
        let (n, d) = meeting::<BallDd>(self, triple);
        Bounds::of(&n.negated().div(&d)).unwrap_or(Bounds {
            low: 0.0,
            high: f64::INFINITY,
        })
    }

    /// Which of two moments comes first, if exact numbers of a fixed width can tell?
    ///
    /// Both must exist, and lie where neither root's triangle has been flipped yet.
    pub(crate) fn compare_fixed(&self, a: &Moment, b: &Moment) -> Option<Ordering> {
        if self.ask_shortly(&Alike(a, b)).is_some() {
            self.count(|rungs| rungs.by_exact += 1);
            return Some(Ordering::Equal);
        }
        match (a, b) {
            (Moment::Root(_), Moment::Planes(_)) => self.compare_fixed(b, a).map(Ordering::reverse),
            (_, Moment::Planes(triple)) => self
                .decide_fixed(&SignAt(a, &Since(*triple)))
                .map(Sign::ordering),
            (_, Moment::Root(corners)) => order_by_signs(|part| {
                let area = Area(*corners, part);
                match part {
                    Part::Value => self.decide_fixed(&SignAt(a, &area)),
                    Part::Curvature => Some(self.sign_of(&area)),
                    _ => Some(self.sign_at(a, &area)),
                }
            }),
            (_, Moment::Start) => None,
        }
    }

    /// Which of two moments comes first? Exact; `Equal` means equal as real numbers.
    ///
    /// Both must exist, and lie where neither root's triangle has been flipped yet.
    pub(crate) fn compare(&self, a: &Moment, b: &Moment) -> Ordering {
        match (a, b) {
            _ if a == b => Ordering::Equal,
            // The sign of an area when planes meet is of a smaller degree than that of the time
            // of a meeting at a root.
            (Moment::Root(_), Moment::Planes(_)) => self.compare(b, a).reverse(),
            (_, Moment::Planes(triple)) => self.sign_at(a, &Since(*triple)).ordering(),
            (_, Moment::Root(corners)) => self.compare_with_root(a, *corners),
            (Moment::Planes(_) | Moment::Root(_), Moment::Start) => self.compare(b, a).reverse(),
            (Moment::Start, Moment::Start) => Ordering::Equal,
        }
    }

    /// The order of a moment and the falling root of a triangle's area g, from the signs of
    /// g and of its derivatives there.
    fn compare_with_root(&self, a: &Moment, corners: [Corner; 3]) -> Ordering {
        order_by_signs(|part| {
            let area = Area(corners, part);
            Some(match part {
                Part::Curvature => self.sign_of(&area),
                _ => self.sign_at(a, &area),
            })
        })
        .expect("every sign is known")
    }

    /// Whether the vertex is ahead of the plane at the moment (zero: on it).
    #[inline]
    pub(crate) fn lead(&self, moment: &Moment, vertex: [PlaneId; 2], plane: PlaneId) -> Sign {
        if vertex.contains(&plane) || *moment == Moment::of_planes([vertex[0], vertex[1], plane]) {
            return Sign::Zero;
        }
        // Where parallel planes meet a third one, they have one line.
        if let Moment::Planes(triple) = moment
            && triple.contains(&plane)
            && (vertex.iter()).any(|&i| triple.contains(&i) && self.turn(i, plane).is_zero())
        {
            return Sign::Zero;
        }
        self.sign_at(moment, &Lead(vertex, plane))
    }

    /// Whether two vertices are at one place: each plane of one passes through the other.
    pub(crate) fn coincide(&self, moment: &Moment, u: [PlaneId; 2], v: [PlaneId; 2]) -> bool {
        // That a vertex is off any of the planes may be easier to see than that it is on another.
        let off = |vertex: [PlaneId; 2], plane: PlaneId| {
            !vertex.contains(&plane)
                && SignAt(moment, &Lead(vertex, plane))
                    .ask::<Rough>(self)
                    .is_some_and(|sign| !sign.is_zero())
        };
        if u.iter().any(|&plane| off(v, plane)) || v.iter().any(|&plane| off(u, plane)) {
            self.count(|rungs| rungs.by_f64 += 1);
            return false;
        }
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

    /// Which of three vertices on one line is strictly between the others at a moment, if f64
    /// tells.
    pub(crate) fn middle(&self, now: Bounds, vertices: [[PlaneId; 2]; 3]) -> Option<usize> {
        let half = (now.high - now.low) / 2.0;
        // Twice the half covers the roundings of it and of the mean, but for those of a ball.
        let ulp = now.high.next_up() - now.high;
        let t = Ball::new(now.low + half, 2.0 * half + ulp);
        let paths = vertices.map(|pair| Path::<Ball>::new(self, pair));
        let between = |z: [Ball; 3]| {
            let [below, above] = [0, 1].map(|side| {
                [0, 1, 2].map(|k| {
                    if side == 0 {
                        z[k].lower()
                    } else {
                        z[k].upper()
                    }
                })
            });
            (0..3).find(|&k| {
                let [i, j] = [(k + 1) % 3, (k + 2) % 3];
                (above[i] < below[k] && above[k] < below[j])
                    || (above[j] < below[k] && above[k] < below[i])
            })
        };
        let at = |z: &[Ball; 2], m: &Ball| z[0].plus(&z[1].times(&t)).div(m);
        between(paths.each_ref().map(|path| at(&path.x, &path.m)))
            .or_else(|| between(paths.each_ref().map(|path| at(&path.y, &path.m))))
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

/// The order of a moment and the falling root of a polynomial, from the signs of its parts at the
/// moment.
fn order_by_signs(sign: impl Fn(Part) -> Option<Sign>) -> Option<Ordering> {
    Some(match (sign(Part::Value)?, sign(Part::Slope)?) {
        // On the falling branch.
        (Sign::Positive, Sign::Negative) => Ordering::Less,
        (Sign::Zero, Sign::Negative | Sign::Zero) => Ordering::Equal,
        // Rising: a concave curve falls later, a convex one fell before.
        (_, Sign::Positive) | (Sign::Positive, Sign::Zero) => {
            if sign(Part::Curvature)?.is_negative() {
                Ordering::Less
            } else {
                Ordering::Greater
            }
        }
        // Below zero and not rising: past the root.
        (Sign::Negative, Sign::Negative | Sign::Zero) => Ordering::Greater,
    })
}

/// The D of a meeting: constant.
pub(super) struct Closing(pub [PlaneId; 3]);

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
        let [[x0, x1], [y0, y1]] = differences::<T>(planes, self.0, self.1);
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
        let (n, d) = meeting::<Rough>(self, triple);
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
    /// flat, if it does. Two of its corners may be known to meet at some time.
    pub(crate) fn falling_root(
        &self,
        now: &Moment,
        corners: [Corner; 3],
        do_meet: impl FnOnce() -> bool,
    ) -> Option<Bounds> {
        let g = area::<Rough>(self, corners);
        let curvature = || self.sign_of(&Area(corners, Part::Curvature));
        let falls = || self.sign_at(now, &Area(corners, Part::Slope)).is_negative();
        // Where two corners meet there is a root.
        let has_roots = || match discriminant(&g).sign() {
            Some(sign) => !sign.is_negative(),
            None => do_meet() || !(self.sign_of(&Area(corners, Part::Discriminant))).is_negative(),
        };
        let exists = match g[2].sign().unwrap_or_else(curvature) {
            Sign::Negative => true,
            Sign::Zero => falls(),
            Sign::Positive => has_roots() && falls(),
        };
        exists.then(|| self.bounds_of_root(corners, &g))
    }
}
