//! One plane per wavefront edge (the derivation is in `docs/derivations.md`, section 1).
//!
//! A wavefront edge that starts at `p -> q` and sweeps to its left lies at time t on
//! `a x + b y = c + s t`, with `(a, b)` the left normal, `c = a px + b py`, and
//! `s = w sqrt(a^2 + b^2)`. After moving a point of the grid into the origin and scaling by a power of
//! two, `a`, `b`, `c` and `w` are integers; dividing `a`, `b`, `c` by `gcd(a, b)` keeps
//! them small on grids. The root is the only irrational number in the plane.

use dashu_int::{IBig, UBig, ops::Gcd, ops::UnsignedAbs};
use hipline_num::{Ball, BallDd, Number, Rungs, Sign, Surd, Wide, f64_to_parts, perfect_root};
use std::cell::Cell;

use super::grid::{common_unit, gcd, scaled, scaled_small};
use super::phases::{self, Phases};
use super::speeds;
use super::{
    Terminal,
    eaves::{Tilted, tabled},
    expression::Quadratic,
    root::{ball_root, dd_root, wide_root},
};
use crate::input::Figure;

/// A plane of the figure: the wavefront of one side of an edge, or of a terminal.
///
/// The last bit tells the side: 0 left, 1 right of the line that the other bits name.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub(crate) struct PlaneId(pub u32);

impl std::fmt::Debug for PlaneId {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(
            f,
            "p{}{}",
            self.0 >> 1,
            if self.0 & 1 == 0 { 'l' } else { 'r' }
        )
    }
}

/// `a x + b y = c + s t` in the numbers of one rung of the ladder.
#[derive(Clone, Debug)]
pub(crate) struct Plane<T> {
    pub a: T,
    pub b: T,
    pub c: T,
    pub s: T,
}

/// A line with coprime integer normal.
#[derive(Debug, Clone)]
pub(super) enum Line {
    Small {
        a: i64,
        b: i64,
        c: i128,
    },
    Big(Box<[IBig; 3]>),
    /// No line: the plane of one height, `0 = c + s t`.
    Level(IBig),
    /// No line: the plane of a facet over a tilted eave. Its tables hold `[a, b, c, s]`.
    Tilted(Box<Tilted>),
}

impl Line {
    fn integers(&self) -> [IBig; 3] {
        match self {
            Self::Small { a, b, c } => [IBig::from(*a), IBig::from(*b), IBig::from(*c)],
            Self::Big(abc) => (**abc).clone(),
            Self::Level(c) => [IBig::ZERO, IBig::ZERO, c.clone()],
            Self::Tilted(_) => unreachable!("tilted planes have no line"),
        }
    }

    /// The square of the length of the normal; one for a plane of one height.
    fn square(&self) -> UBig {
        match self {
            Self::Level(_) => UBig::ONE,
            _ => {
                let [a, b, _] = self.integers();
                (&a * &a + &b * &b).unsigned_abs()
            }
        }
    }
}

/// The speeds of the planes, as integers over a common power of two.
#[derive(Debug, Clone)]
pub(super) struct Speeds {
    pub(super) exact: Vec<IBig>,
    /// Binary digits dropped in the approximations, lest they overflow.
    pub(super) shift: i32,
}

/// All planes of a figure.
#[derive(Debug)]
pub(crate) struct Planes {
    pub(super) lines: Vec<Line>,
    pub(super) balls: Vec<[Ball; 4]>,
    pub(super) doubles: Vec<[BallDd; 4]>,
    /// `None`: every speed is one.
    pub(super) speeds: Option<Speeds>,
    /// What the planes of later phases are those of.
    pub phases: Phases,
    /// The number of the first line of a later phase.
    pub(super) first_later: usize,
    /// By how much the planes of later phases are ahead at time zero.
    pub(super) offsets: Vec<IBig>,
    /// Binary digits of the coordinates dropped in the approximations.
    pub shift: i32,
    /// Coordinates are `integer * 2^unit + origin`.
    pub unit: i32,
    /// The point that became the origin.
    pub origin: [f64; 2],
    /// Times are `value * 2^time_unit`.
    pub time_unit: i32,
    /// How often each rung answered.
    pub rungs: Cell<Rungs>,
}

/// A rung of the ladder: numbers that planes can be asked for in.
pub(crate) trait Rung: Number {
    /// `[a, b, c, length of the normal]` of a line.
    fn line(planes: &Planes, line: usize) -> [Self; 4];
    /// An integer, in the approximations without its last `shift` binary digits.
    fn integer(value: &IBig, shift: i32) -> Self;
    /// `p` and `q` with the given time = `p / q`, in the unit that meetings are in.
    fn time(planes: &Planes, time: f64) -> [Self; 2];
    /// Encloses the root of `g0 + g1 t + g2 t^2` at which it falls; only approximations can.
    fn falling_root(g: &Quadratic<Self>) -> Option<Self>;
    /// The plane of a facet over a tilted eave, which is line number `line`.
    fn tilted(planes: &Planes, line: usize, tilted: &Tilted) -> Plane<Self>;

    /// One plane.
    fn plane(planes: &Planes, id: PlaneId) -> Plane<Self> {
        let line = (id.0 >> 1) as usize;
        if line >= planes.first_later
            && let Line::Tilted(tilted) = &planes.lines[line]
        {
            return Self::tilted(planes, line, tilted);
        }
        let [a, b, c, length] = Self::line(planes, line);
        let s = match &planes.speeds {
            Some(speeds) => {
                length.times(&Self::integer(&speeds.exact[id.0 as usize], speeds.shift))
            }
            None => length.clone(),
        };
        let mut plane = if id.0 & 1 == 0 {
            Plane { a, b, c, s }
        } else {
            Plane {
                a: a.negated(),
                b: b.negated(),
                c: c.negated(),
                s,
            }
        };
        if line >= planes.first_later
            && let Some(offset) = planes.offsets.get(line - planes.first_later)
        {
            let ahead = length.times(&Self::integer(offset, planes.shift));
            plane.c = plane.c.plus(&ahead);
        }
        plane
    }
}

impl Rung for Ball {
    #[inline]
    fn line(planes: &Planes, line: usize) -> [Self; 4] {
        planes.balls[line]
    }
    fn tilted(planes: &Planes, line: usize, _: &Tilted) -> Plane<Self> {
        tabled(&planes.balls[line])
    }
    fn time(planes: &Planes, time: f64) -> [Self; 2] {
        [
            Self::from_f64(time).ldexp(-planes.rough_time_unit()),
            Self::from_i64(1),
        ]
    }
    fn falling_root(g: &Quadratic<Self>) -> Option<Self> {
        ball_root::falling_root(g)
    }
    fn integer(value: &IBig, shift: i32) -> Self {
        let ball = Self::from_int(value);
        if shift == 0 || *value == IBig::ZERO {
            return ball;
        }
        // After a shift the value need not be an integer, which error 0 would claim.
        let error = ball.error().max(ball.value().abs() * f64::EPSILON);
        Self::new(ball.value(), error).ldexp(-shift)
    }
}

impl Rung for BallDd {
    fn time(planes: &Planes, time: f64) -> [Self; 2] {
        [
            Self::from_f64(time).ldexp(-planes.rough_time_unit()),
            Self::from_i64(1),
        ]
    }
    fn falling_root(g: &Quadratic<Self>) -> Option<Self> {
        dd_root::falling_root(g)
    }
    fn line(planes: &Planes, line: usize) -> [Self; 4] {
        planes.doubles[line]
    }
    fn tilted(planes: &Planes, line: usize, _: &Tilted) -> Plane<Self> {
        tabled(&planes.doubles[line])
    }
    fn integer(value: &IBig, shift: i32) -> Self {
        let ball = Self::from_int(value);
        if shift == 0 || *value == IBig::ZERO {
            return ball;
        }
        let error = ball
            .error()
            .max(ball.value().abs() * f64::EPSILON * f64::EPSILON);
        let (hi, lo) = (ball.value(), ball.low());
        Self::new(hi, lo, error).ldexp(-shift)
    }
}

/// `p` and `q` with the given time = `p / q`, in the unit that meetings are in.
pub(super) fn exact_time(planes: &Planes, time: f64) -> [IBig; 2] {
    let (mantissa, exponent) = f64_to_parts(time);
    let shift = exponent - planes.time_unit;
    let power = |digits: i32| IBig::ONE << digits.max(0) as usize;
    [mantissa * power(shift), power(-shift)]
}

impl Rung for Wide {
    fn tilted(_: &Planes, _: usize, tilted: &Tilted) -> Plane<Self> {
        tilted.wide(Self::sqrt_of)
    }
    fn falling_root(g: &Quadratic<Self>) -> Option<Self> {
        wide_root::falling_root(g)
    }
    fn line(planes: &Planes, line: usize) -> [Self; 4] {
        let [a, b, c] = planes.lines[line].integers();
        let square = planes.lines[line].square();
        [
            Self::from_int(&a),
            Self::from_int(&b),
            Self::from_int(&c),
            Self::sqrt_of(&square),
        ]
    }
    fn integer(value: &IBig, _shift: i32) -> Self {
        Self::from_int(value)
    }
    fn time(planes: &Planes, time: f64) -> [Self; 2] {
        let [p, q] = exact_time(planes, time);
        [Self::from_int(&p), Self::from_int(&q)]
    }
}

impl Rung for Surd {
    fn tilted(_: &Planes, _: usize, tilted: &Tilted) -> Plane<Self> {
        tilted.wide(Self::sqrt_of)
    }
    fn time(planes: &Planes, time: f64) -> [Self; 2] {
        exact_time(planes, time).map(Self::from_int)
    }
    fn falling_root(_: &Quadratic<Self>) -> Option<Self> {
        None
    }
    fn line(planes: &Planes, line: usize) -> [Self; 4] {
        let [a, b, c] = planes.lines[line].integers();
        let square = planes.lines[line].square();
        [
            Self::from_int(a),
            Self::from_int(b),
            Self::from_int(c),
            Self::sqrt_of(&square),
        ]
    }
    fn integer(value: &IBig, _shift: i32) -> Self {
        Self::from_int(value.clone())
    }
}

/// The root of a perfect square.
fn small_root(square: u128) -> Option<u128> {
    // Squares end in one of twelve patterns of six bits.
    const RESIDUES: u64 = 0x0202_0212_0203_0213;
    if RESIDUES >> (square & 63) & 1 == 0 {
        return None;
    }
    let root = square.isqrt();
    (root * root == square).then_some(root)
}

/// An integer in double-double, without its last `shift` binary digits.
#[expect(
    clippy::cast_precision_loss,
    clippy::cast_possible_truncation,
    reason = "the rest is kept"
)]
fn near(value: i128, shift: i32) -> BallDd {
    let high = value as f64;
    let rest = value - high as i128;
    let low = rest as f64;
    let lost = (rest - low as i128).unsigned_abs() as f64;
    // After a shift the value need not be an integer, which error 0 would claim.
    let error = if shift == 0 || value == 0 {
        lost
    } else {
        lost.max(high.abs() * TINY)
    };
    BallDd::new(high, low, error * 2.0).ldexp(-shift)
}

/// One part in 2^104.
const TINY: f64 = f64::EPSILON * f64::EPSILON;

/// The enclosure in f64 of one in double-double.
pub(super) fn nearest(value: &BallDd) -> Ball {
    Ball::new(
        value.value(),
        (value.low().abs() + value.error()) * (1.0 + 4.0 * f64::EPSILON),
    )
}

/// Coordinates with up to this many binary digits take the path of machine integers.
const SMALL: i32 = 60;

impl Planes {
    /// The planes of a figure: line `e` is edge `e`; the lines after those are the
    /// terminals', in order of their vertices.
    pub(crate) fn new(figure: &Figure, terminals: &[Terminal]) -> Self {
        let vertices = figure.vertices();
        let lines = figure.edges().len() + terminals.len();
        let phases = Phases::new(figure, terminals, lines);
        let (mut unit, mut bits) = common_unit(vertices.iter().flatten().copied());
        let speed_unit = speeds::unit(figure, terminals, &phases);
        for (low, high) in [
            phases::range(phases.later()),
            phases.height_range(speed_unit.0),
        ]
        .into_iter()
        .flatten()
        {
            let high = high.max(unit + bits);
            unit = unit.min(low);
            bits = high - unit;
        }
        // Where zero is among the coordinates, they may be fine around it, and so may the
        // skeleton's; elsewhere what is closest to zero serves.
        let origin = [0, 1].map(|axis| {
            let values = || vertices.iter().map(|v| v[axis]);
            let low = values().min_by(f64::total_cmp).unwrap_or_default();
            let high = values().max_by(f64::total_cmp).unwrap_or_default();
            if low > 0.0 {
                low
            } else if high < 0.0 {
                high
            } else {
                0.0
            }
        });
        let shift = if bits > 53 { bits - 30 } else { 0 };
        let mut planes = Self {
            lines: Vec::with_capacity(lines),
            balls: Vec::with_capacity(lines),
            doubles: Vec::with_capacity(lines),
            speeds: None,
            phases,
            first_later: lines,
            offsets: Vec::new(),
            shift,
            unit,
            origin,
            time_unit: unit,
            rungs: Cell::default(),
        };
        // With bits <= SMALL the differences have one more digit, c has 2 SMALL + 3.
        if bits <= SMALL {
            let origin = origin.map(|x| scaled_small(x, unit));
            let points: Vec<[i64; 2]> = vertices
                .iter()
                .map(|v| {
                    [
                        scaled_small(v[0], unit) - origin[0],
                        scaled_small(v[1], unit) - origin[1],
                    ]
                })
                .collect();
            for edge in figure.edges() {
                let [p, q] = [points[edge.from.index()], points[edge.to.index()]];
                planes.push_small(p[1] - q[1], q[0] - p[0], p);
            }
            for terminal in terminals {
                let [p, q] = [points[terminal.inner], points[terminal.tip]];
                planes.push_small(q[0] - p[0], q[1] - p[1], q);
            }
        } else {
            let origin = origin.map(|x| scaled(x, unit));
            let points: Vec<[IBig; 2]> = vertices
                .iter()
                .map(|v| {
                    [
                        scaled(v[0], unit) - &origin[0],
                        scaled(v[1], unit) - &origin[1],
                    ]
                })
                .collect();
            for edge in figure.edges() {
                let [p, q] = [&points[edge.from.index()], &points[edge.to.index()]];
                planes.push_big(&p[1] - &q[1], &q[0] - &p[0], p);
            }
            for terminal in terminals {
                let [p, q] = [&points[terminal.inner], &points[terminal.tip]];
                planes.push_big(&q[0] - &p[0], &q[1] - &p[1], q);
            }
        }
        planes.set_speeds(figure, terminals, speed_unit);
        planes
    }

    fn push_small(&mut self, a: i64, b: i64, point: [i64; 2]) {
        let g = gcd(a.unsigned_abs(), b.unsigned_abs()) as i64;
        let (a, b) = (a / g, b / g);
        let c = i128::from(a) * i128::from(point[0]) + i128::from(b) * i128::from(point[1]);
        let square = u128::from(a.unsigned_abs()).pow(2) + u128::from(b.unsigned_abs()).pow(2);
        // The normal of an edge parallel to an axis has length one.
        let root = if a == 0 || b == 0 {
            Some(1)
        } else {
            small_root(square)
        };
        let length = match root {
            Some(root) => near(root as i128, self.shift),
            None => near(square as i128, 2 * self.shift).sqrt(),
        };
        let doubles = [
            near(a.into(), self.shift),
            near(b.into(), self.shift),
            near(c, 2 * self.shift),
            length,
        ];
        self.balls.push(doubles.each_ref().map(nearest));
        self.doubles.push(doubles);
        self.lines.push(Line::Small { a, b, c });
    }

    pub(super) fn push_big(&mut self, a: IBig, b: IBig, point: &[IBig; 2]) {
        let g = IBig::from((&a).gcd(&b));
        let (a, b) = (a / &g, b / &g);
        let c = &a * &point[0] + &b * &point[1];
        let square = &a * &a + &b * &b;
        let length = match perfect_root(&square.clone().unsigned_abs()) {
            Some(root) => BallDd::integer(&IBig::from(root), self.shift),
            None => BallDd::integer(&square, 2 * self.shift).sqrt(),
        };
        let doubles = [
            BallDd::integer(&a, self.shift),
            BallDd::integer(&b, self.shift),
            BallDd::integer(&c, 2 * self.shift),
            length,
        ];
        self.balls.push(doubles.each_ref().map(nearest));
        self.doubles.push(doubles);
        self.lines.push(Line::Big(Box::new([a, b, c])));
    }

    /// The same plane.
    pub(crate) fn coplanar(&self, i: PlaneId, j: PlaneId) -> bool {
        if i == j {
            return true;
        }
        let later = |plane: PlaneId| (plane.0 >> 1) as usize >= self.first_later;
        if later(i) || later(j) {
            return self.are_one(i, j);
        }
        if !self.are_equally_fast(i, j) {
            return false;
        }
        let [a, b, c] = self.lines[(i.0 >> 1) as usize].integers();
        let [d, e, f] = self.lines[(j.0 >> 1) as usize].integers();
        if i.0 & 1 == j.0 & 1 {
            a == d && b == e && c == f
        } else {
            a == -d && b == -e && c == -f
        }
    }

    /// `N` and `D` of a meeting in integers: `D` as coefficients of square roots, by radicand.
    fn formal_meeting(&self, triple: [PlaneId; 3]) -> (IBig, Vec<(IBig, IBig)>) {
        let [i, j, k] = triple.map(|id| {
            let [a, b, c] = self.lines[(id.0 >> 1) as usize].integers();
            if id.0 & 1 == 0 {
                [a, b, c]
            } else {
                [-a, -b, -c]
            }
        });
        let minor = |p: &[IBig; 3], q: &[IBig; 3]| &p[0] * &q[1] - &q[0] * &p[1];
        let minors = [minor(&j, &k), minor(&k, &i), minor(&i, &j)];
        let n = &minors[0] * &i[2] + &minors[1] * &j[2] + &minors[2] * &k[2];
        let mut d: Vec<(IBig, IBig)> = Vec::with_capacity(3);
        for ((m, line), id) in minors.into_iter().zip([i, j, k]).zip(triple) {
            let radicand = &line[0] * &line[0] + &line[1] * &line[1];
            let m = match &self.speeds {
                Some(speeds) => m * &speeds.exact[id.0 as usize],
                None => m,
            };
            match d.iter_mut().find(|(r, _)| *r == radicand) {
                Some((_, sum)) => *sum += m,
                None => d.push((radicand, m)),
            }
        }
        d.retain(|(_, m)| *m != IBig::ZERO);
        d.sort_unstable();
        (n, d)
    }

    /// Whether two meetings are at one time for the simple reason that `N1 D2` and `N2 D1`
    /// are the same coefficients of the same roots. Exact where it says yes; `N` and `D` do not
    /// change when a figure is moved, so it says yes for copies of one shape.
    pub(crate) fn meet_evidently_together(&self, s: [PlaneId; 3], t: [PlaneId; 3]) -> bool {
        let later = |plane: &PlaneId| (plane.0 >> 1) as usize >= self.first_later;
        if s.iter().chain(&t).any(later) {
            return false;
        }
        let ((n1, d1), (n2, d2)) = (self.formal_meeting(s), self.formal_meeting(t));
        d1.len() == d2.len()
            && d1
                .iter()
                .zip(&d2)
                .all(|((r1, c1), (r2, c2))| r1 == r2 && &n1 * c2 == &n2 * c1)
    }

    /// Binary digits of the speeds dropped in the approximations.
    pub(crate) fn speed_shift(&self) -> i32 {
        self.speeds.as_ref().map_or(0, |speeds| speeds.shift)
    }

    /// The exponent of the unit of time of the approximations.
    pub(crate) fn rough_time_unit(&self) -> i32 {
        self.time_unit + self.shift - self.speed_shift()
    }

    /// Whether all speeds are one, so that faces are monotone.
    pub(crate) const fn is_unweighted(&self) -> bool {
        self.speeds.is_none()
    }

    /// Asks one rung after the other until one answers.
    #[inline]
    pub(crate) fn decide<Q: Question>(&self, question: &Q) -> Sign {
        let mut rungs = self.rungs.get();
        if let Some(sign) = question.ask::<Ball>(self) {
            rungs.by_f64 += 1;
            self.rungs.set(rungs);
            return sign;
        }
        self.decide_slowly(question)
    }

    #[cold]
    fn decide_slowly<Q: Question>(&self, question: &Q) -> Sign {
        let mut rungs = self.rungs.get();
        let sign = if let Some(sign) = question.ask::<BallDd>(self) {
            rungs.by_double_double += 1;
            sign
        } else if let Some(sign) = question.ask::<Wide>(self) {
            rungs.by_wide += 1;
            sign
        } else {
            rungs.by_exact += 1;
            question.ask_exactly(self)
        };
        self.rungs.set(rungs);
        sign
    }
}

/// A question whose answer is a sign, to be asked of each rung in turn.
pub(crate) trait Question {
    /// The answer in the numbers of one rung, or `None` where it abstains.
    fn ask<T: Rung>(&self, planes: &Planes) -> Option<Sign>;

    /// The answer in exact numbers, which never abstain.
    fn ask_exactly(&self, planes: &Planes) -> Sign {
        self.ask::<Surd>(planes)
            .expect("exact numbers know their sign")
    }
}
