//! One plane per wavefront edge (the derivation is in `docs/derivations.md`, section 1).
//!
//! A wavefront edge that starts at `p -> q` and sweeps to its left lies at time t on
//! `a x + b y = c + s t`, with `(a, b)` the left normal, `c = a px + b py`, and
//! `s = w sqrt(a^2 + b^2)`. After moving a point of the grid into the origin and scaling by a power of
//! two, `a`, `b`, `c` and `w` are integers; dividing `a`, `b`, `c` by `gcd(a, b)` keeps
//! them small on grids. The root is the only irrational number in the plane.

use dashu_int::IBig;
use hipline_num::{
    Ball, BallDd, Binomial, Number, Rough, Rungs, Sign, Surd, Wide, common_unit, f64_to_parts,
};
use std::cell::{Cell, OnceCell};

use super::grid::small_in_units;
use super::lines::{Known, Line};
use super::phases::{self, Phases};
use super::speeds;
use super::{
    Terminal,
    eaves::{Tilted, tabled},
    expression::{Corner, Quadratic, any_meeting, area, meeting},
    fixed::Lengths,
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

impl<T: Number> Plane<T> {
    /// `b x - a y`: how far a vector goes along the edge, times its length.
    #[inline]
    pub(super) fn along(&self, x: &T, y: &T) -> T {
        self.b.times(x).minus(&self.a.times(y))
    }

    /// `a x + b y`: how far a vector goes away from the edge, times its length.
    #[inline]
    pub(super) fn away(&self, x: &T, y: &T) -> T {
        self.a.times(x).plus(&self.b.times(y))
    }

    /// `a x + b y - c w`: how far a point at `x / w`, `y / w` is ahead of the edge, times its length and w.
    #[inline]
    pub(super) fn reach(&self, [x, y, w]: [&T; 3]) -> T {
        self.away(x, y).minus(&self.c.times(w))
    }
}

/// The speeds of the planes, as integers over a common power of two.
#[derive(Debug, Clone)]
pub(super) struct Speeds {
    pub(super) exact: Vec<IBig>,
    /// Binary digits dropped in the approximations, lest they overflow.
    pub(super) shift: i32,
}

/// The question asked last, and its answer.
type Last<Q, A> = Cell<Option<(Q, A)>>;

/// All planes of a figure.
#[derive(Debug)]
pub(crate) struct Planes {
    pub(super) lines: Vec<Line>,
    pub(super) lengths: Lengths,
    /// Whether coordinates are so small that many polynomials in them fit machine integers.
    pub(super) grid: bool,
    /// See [`Planes::has_one_root`].
    pub(super) one_root: OnceCell<bool>,
    /// See [`rough::line`].
    pub(super) roughs: Vec<[f64; 4]>,
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
    /// The root asked for last: several questions are asked of one moment.
    pub(super) last_root: Last<[Corner; 3], Ball>,
    /// The same of the meeting.
    pub(super) last_meeting: Last<[PlaneId; 3], (Rough, Rough)>,
    /// What exact questions have found out about lines.
    pub(super) known: Known,
}

/// A rung of the ladder: numbers that planes can be asked for in.
pub(crate) trait Rung: Number {
    /// Whether [`Rung::falling_root`] ever answers.
    const HAS_ROOTS: bool = true;
    /// `[a, b, c, length of the normal]` of a line.
    fn line(planes: &Planes, line: usize) -> [Self; 4];
    /// An integer, in the approximations without its last `shift` binary digits.
    fn integer(value: &IBig, shift: i32) -> Self;
    /// `p` and `q` with the given time = `p / q`, in the unit that meetings are in.
    fn time(planes: &Planes, time: f64) -> [Self; 2];
    /// Encloses the root of `g0 + g1 t + g2 t^2` at which it falls; only approximations can.
    fn falling_root(g: &Quadratic<Self>) -> Option<Self>;
    /// The same of a triangle's area.
    fn flat_at(planes: &Planes, corners: [Corner; 3]) -> Option<Self> {
        Self::falling_root(&area(planes, corners))
    }

    /// `(N, D)` with `t = -N / D` the moment when three planes meet.
    #[inline]
    fn meeting(planes: &Planes, triple: [PlaneId; 3]) -> (Self, Self) {
        any_meeting(planes, triple)
    }

    /// [`meeting`], of a moment of which several things are asked.
    #[inline]
    fn met(planes: &Planes, triple: [PlaneId; 3]) -> (Self, Self) {
        meeting(planes, triple)
    }
    /// The plane of a facet over a tilted eave, which is line number `line`.
    fn tilted(planes: &Planes, line: usize, tilted: &Tilted) -> Plane<Self>;

    /// One plane.
    #[inline]
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
        planes.doubles[line].each_ref().map(nearest)
    }
    fn tilted(planes: &Planes, line: usize, _: &Tilted) -> Plane<Self> {
        tabled(&planes.doubles[line].each_ref().map(nearest))
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
    fn flat_at(planes: &Planes, corners: [Corner; 3]) -> Option<Self> {
        if let Some((of, root)) = planes.last_root.get()
            && of == corners
        {
            return Some(root);
        }
        let root = Self::falling_root(&area(planes, corners))?;
        planes.last_root.set(Some((corners, root)));
        Some(root)
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

/// The square of the length of a normal, if it is small.
fn small_square(a: i64, b: i64) -> Option<u64> {
    let square = |x: i64| x.unsigned_abs().checked_mul(x.unsigned_abs());
    square(a)?.checked_add(square(b)?)
}

impl Rung for Binomial {
    const HAS_ROOTS: bool = false;

    fn line(planes: &Planes, line: usize) -> [Self; 4] {
        let Line::Small { a, b, c } = &planes.lines[line] else {
            return [Self::UNKNOWN; 4];
        };
        // Without an error it is this integer; coordinates on a grid have no shift.
        let near = &planes.doubles[line][3];
        #[expect(clippy::cast_possible_truncation, reason = "an integer below 2^53")]
        let length = if near.error() <= 0.0 {
            Self::whole(near.value() as i128)
        } else {
            match small_square(*a, *b) {
                Some(square) => Self::root_of(square),
                None => Self::UNKNOWN,
            }
        };
        let [a, b, c] = [(*a).into(), (*b).into(), *c].map(Self::whole);
        [a, b, c, length]
    }
    fn tilted(_: &Planes, _: usize, _: &Tilted) -> Plane<Self> {
        tabled(&[Self::UNKNOWN; 4])
    }
    fn integer(value: &IBig, _shift: i32) -> Self {
        i128::try_from(value).map_or(Self::UNKNOWN, Self::whole)
    }
    fn time(planes: &Planes, time: f64) -> [Self; 2] {
        exact_time(planes, time).map(|i| Self::integer(&i, 0))
    }
    fn falling_root(_: &Quadratic<Self>) -> Option<Self> {
        None
    }
}

/// The root that a plane has in it, which is kept for a while.
fn kept_root(planes: &Planes, line: usize, find: impl FnOnce() -> Wide) -> Wide {
    let count = [planes.lines.len(), 4];
    planes.known.wide.get(line as u32, count, find)
}

impl Rung for Wide {
    fn tilted(planes: &Planes, line: usize, tilted: &Tilted) -> Plane<Self> {
        tilted.plane(&kept_root(planes, line, || {
            Self::sqrt_of(tilted.radicand())
        }))
    }
    fn falling_root(g: &Quadratic<Self>) -> Option<Self> {
        wide_root::falling_root(g)
    }
    fn line(planes: &Planes, line: usize) -> [Self; 4] {
        let length = kept_root(planes, line, || Self::sqrt_of(&planes.square(line)));
        let [a, b, c] = planes.integers_as(line, Self::from_i128, Self::from_int);
        [a, b, c, length]
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
        tilted.plane(&Self::sqrt_of(tilted.radicand()))
    }
    fn time(planes: &Planes, time: f64) -> [Self; 2] {
        exact_time(planes, time).map(Self::from_int)
    }
    fn falling_root(_: &Quadratic<Self>) -> Option<Self> {
        None
    }
    fn line(planes: &Planes, line: usize) -> [Self; 4] {
        let [a, b, c] = planes.integers(line).into_owned();
        let square = planes.square(line);
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

/// The enclosure in f64 of one in double-double.
pub(super) fn nearest(value: &BallDd) -> Ball {
    Ball::new(
        value.value(),
        (value.low().abs() + value.error()) * (1.0 + 4.0 * f64::EPSILON),
    )
}

/// Coordinates with up to this many binary digits are asked for in i128 before double-double.
pub(super) const GRID: i32 = 32;

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
            lengths: Lengths::default(),
            grid: bits <= GRID,
            one_root: OnceCell::new(),
            roughs: Vec::with_capacity(lines),
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
            last_root: Cell::default(),
            last_meeting: Cell::default(),
            known: Known::default(),
        };
        // With bits <= SMALL the differences have one more digit, c has 2 SMALL + 3.
        if bits <= SMALL {
            let origin = origin.map(|x| small_in_units(x, unit));
            let points: Vec<[i64; 2]> = vertices
                .iter()
                .map(|v| {
                    [
                        small_in_units(v[0], unit) - origin[0],
                        small_in_units(v[1], unit) - origin[1],
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
            for edge in figure.edges() {
                planes.push_between([edge.from, edge.to].map(|v| vertices[v.index()]));
            }
            for terminal in terminals {
                let [p, q] = [terminal.inner, terminal.tip].map(|v| planes.point(vertices[v]));
                planes.push_big(&q[0] - &p[0], &q[1] - &p[1], &q);
            }
        }
        planes.set_speeds(figure, terminals, speed_unit);
        planes
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
        if !self.turn(i, j).is_zero() {
            return false;
        }
        let [a, b, c] = self.integers((i.0 >> 1) as usize).into_owned();
        let [d, e, f] = self.integers((j.0 >> 1) as usize).into_owned();
        if i.0 & 1 == j.0 & 1 {
            a == d && b == e && c == f
        } else {
            a == -d && b == -e && c == -f
        }
    }

    /// Whether coordinates are small and the lengths of all normals are integers, or the root of the same integer.
    pub(super) fn has_one_root(&self) -> bool {
        let has_one = || {
            let mut one = None;
            (self.lines.iter().zip(&self.doubles)).all(|(line, near)| match line {
                _ if near[3].error() <= 0.0 => true,
                Line::Small { a, b, .. } => {
                    let square = small_square(*a, *b);
                    square.is_some() && *one.get_or_insert(square) == square
                }
                _ => false,
            })
        };
        self.grid && *self.one_root.get_or_init(has_one)
    }

    /// The sign of the turn from one plane to another, where the numbers of both lines are small.
    pub(super) fn small_turn(&self, i: PlaneId, j: PlaneId) -> Option<Sign> {
        let [Line::Small { a, b, .. }, Line::Small { a: p, b: q, .. }] =
            [i, j].map(|id| &self.lines[(id.0 >> 1) as usize])
        else {
            return None;
        };
        let wide = |x: &i64, y: &i64| i128::from(*x) * i128::from(*y);
        let sign = Sign::from(wide(a, q).cmp(&wide(p, b)));
        Some(if (i.0 ^ j.0) & 1 == 0 { sign } else { -sign })
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
}
