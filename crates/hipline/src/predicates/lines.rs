//! The line of each plane: coprime integers, and approximations of them.

use dashu_int::{IBig, UBig, ops::Gcd, ops::UnsignedAbs};
use hipline_num::{BallDd, Limbs, Number, Short, Wide, in_units, ldexp, perfect_root};
use std::{borrow::Cow, cell::OnceCell};

use super::{
    eaves::Tilted,
    fixed::Bare,
    grid::{gcd, near, near_big, small_root},
    memo::Memo,
    planes::{Planes, Rung},
    rough,
};

/// A line with coprime integer normal.
#[derive(Debug, Clone)]
pub(super) enum Line {
    Small {
        a: i64,
        b: i64,
        c: i128,
    },
    Big(Box<[IBig; 3]>),
    /// The line through two points of the input, on the left of which the plane rises. Its integers are found when they are asked for,
    /// which is seldom.
    Between([[f64; 2]; 2]),
    /// No line: the plane of one height, `0 = c + s t`.
    Level(IBig),
    /// No line: the plane of a facet over a tilted eave. Its tables hold `[a, b, c, s]`.
    Tilted(Box<Tilted>),
}

/// What exact questions have found out about lines, for others that come.
#[derive(Debug, Default)]
pub(super) struct Known {
    /// The integers of lines between points.
    integers: OnceCell<Vec<OnceCell<Box<[IBig; 3]>>>>,
    pub(super) small: Memo<Option<Bare<i128>>>,
    pub(super) short: Memo<Option<Bare<Short>>>,
    pub(super) long: Memo<Option<Bare<Limbs>>>,
    /// Lengths of normals.
    pub(super) wide: Memo<Wide>,
}

/// With up to so many binary digits dropped, differences of coordinates and their products neither overflow nor underflow in
/// double-double.
const MIDDLING: i32 = 300;

/// An approximation of `c` has to be this much closer than the number is large, or it is rounded from the integer.
const CLOSE: f64 = 1.0 / (1_u64 << 60) as f64 / (1_u64 << 30) as f64;

impl Planes {
    /// `a`, `b`, `c` of a line.
    pub(super) fn integers(&self, line: usize) -> Cow<'_, [IBig; 3]> {
        match &self.lines[line] {
            Line::Small { a, b, c } => Cow::Owned([IBig::from(*a), IBig::from(*b), IBig::from(*c)]),
            Line::Big(abc) => Cow::Borrowed(&**abc),
            Line::Between(ends) => {
                let all = || vec![OnceCell::new(); self.lines.len()];
                let known = &self.known.integers.get_or_init(all)[line];
                let find = || {
                    let [p, q] = ends.map(|end| self.point(end));
                    Box::new(reduced(&p[1] - &q[1], &q[0] - &p[0], &p))
                };
                Cow::Borrowed(&**known.get_or_init(find))
            }
            Line::Level(c) => Cow::Owned([IBig::ZERO, IBig::ZERO, c.clone()]),
            Line::Tilted(_) => unreachable!("tilted planes have no line"),
        }
    }

    /// The same in other numbers; the small ones without big integers.
    pub(super) fn integers_as<T>(
        &self,
        line: usize,
        small: impl Fn(i128) -> T,
        any: impl Fn(&IBig) -> T,
    ) -> [T; 3] {
        match &self.lines[line] {
            Line::Small { a, b, c } => [(*a).into(), (*b).into(), *c].map(small),
            _ => self.integers(line).each_ref().map(any),
        }
    }

    /// The square of the length of the normal; one for a plane of one height.
    pub(super) fn square(&self, line: usize) -> UBig {
        if let Line::Level(_) = self.lines[line] {
            return UBig::ONE;
        }
        let [a, b, _] = &*self.integers(line);
        (a * a + b * b).unsigned_abs()
    }

    /// A point of the input in units, from the origin.
    pub(super) fn point(&self, point: [f64; 2]) -> [IBig; 2] {
        [0, 1].map(|k| in_units(point[k], self.unit) - in_units(self.origin[k], self.unit))
    }

    pub(super) fn push_small(&mut self, a: i64, b: i64, point: [i64; 2]) {
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
        self.push_near(doubles);
        self.lines.push(Line::Small { a, b, c });
    }

    pub(super) fn push_big(&mut self, a: IBig, b: IBig, point: &[IBig; 2]) {
        let [a, b, c] = reduced(a, b, point);
        let square = &a * &a + &b * &b;
        let length = match perfect_root(&square.clone().unsigned_abs()) {
            Some(root) => BallDd::integer(&IBig::from(root), self.shift),
            None => near_big(&square, 2 * self.shift).sqrt(),
        };
        let doubles = [
            near_big(&a, self.shift),
            near_big(&b, self.shift),
            near_big(&c, 2 * self.shift),
            length,
        ];
        self.push_near(doubles);
        self.lines.push(Line::Big(Box::new([a, b, c])));
    }

    /// The line through two points of the input.
    pub(super) fn push_between(&mut self, ends: [[f64; 2]; 2]) {
        match self.near_between(ends) {
            Some(doubles) => {
                self.push_near(doubles);
                self.lines.push(Line::Between(ends));
            }
            None => {
                let [p, q] = ends.map(|end| self.point(end));
                self.push_big(&p[1] - &q[1], &q[0] - &p[0], &p);
            }
        }
    }

    /// Approximations of `a`, `b`, `c` and of the length of the normal of the line through two points, all times one number.
    /// `None` if that is not certain to be so, or `c` is not close.
    fn near_between(&self, [p, q]: [[f64; 2]; 2]) -> Option<[BallDd; 4]> {
        // Without digits dropped, what is exactly an integer would have to be marked as one.
        if self.shift == 0 || self.shift > MIDDLING {
            return None;
        }
        // No digit is lost: the least one is the unit, the greatest about 2^30.
        let scaled = |x: f64| ldexp(x, -self.unit - self.shift);
        // Exactly; but an error of zero would say that it is an integer in every rung.
        let difference = |x: f64, y: f64| {
            let exact = BallDd::new(scaled(x), -scaled(y), f64::MIN_POSITIVE);
            if exact.value().abs() > 0.0 {
                exact
            } else {
                BallDd::zero()
            }
        };
        let (a, b) = (difference(p[1], q[1]), difference(q[0], p[0]));
        let [x, y] = [0, 1].map(|k| difference(p[k], self.origin[k]));
        let c = a.times(&x).plus(&b.times(&y));
        if c.error() > c.value().abs() * CLOSE {
            return None;
        }
        let length = a.times(&a).plus(&b.times(&b)).sqrt();
        Some([a, b, c, length])
    }

    pub(super) fn push_near(&mut self, doubles: [BallDd; 4]) {
        self.roughs.push(rough::line(&doubles, self.shift == 0));
        self.doubles.push(doubles);
    }
}

/// The line with a normal through a point, divided by what the numbers of the normal have in common.
fn reduced(a: IBig, b: IBig, point: &[IBig; 2]) -> [IBig; 3] {
    let g = IBig::from((&a).gcd(&b));
    let (a, b) = (a / &g, b / &g);
    let c = &a * &point[0] + &b * &point[1];
    [a, b, c]
}
