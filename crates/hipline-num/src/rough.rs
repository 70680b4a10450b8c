//! Before the first rung: an f64 and the size of what went into it.
//!
//! A polynomial is evaluated twice: on the numbers, and on their absolute values with every
//! minus made a plus. The second result m bounds all that rounding can have done to the first,
//! v, up to a factor that depends on the depth of the expression only: a semi-static filter, as
//! in Shewchuk's *Adaptive Precision Floating-Point Arithmetic* (1997). An operation costs two
//! flops, a [`Ball`]'s about ten.
//!
//! *The bound.* u = 2^-53. Let |v̂ᵢ − vᵢ| ≤ εᵢ·m̂ᵢ for the operands. As rounding is monotone,
//! |v̂ᵢ| ≤ m̂ᵢ. Then
//!
//! * a sum has ε ≤ max(ε₁, ε₂)·(1 + u) + u,
//! * a product has ε ≤ (ε₁ + ε₂ + ε₁·ε₂)·(1 + u) + u.
//!
//! A number that comes from outside has ε ≤ 4u. The deepest expressions of the predicates reach
//! 144u; [`Rough::sign`] allows for 160u, and [`Rough::ball`], for areas of triangles at most, for
//! 64u. In debug builds each number carries its ε, and it is checked where a sign is given.
//!
//! *Underflow.* Numbers from outside are 0 or at least 2^-15 in size, and a monomial of ε below
//! 160u has at most 40 of them. So no m underflows: if it is 0, so is each monomial, and v is
//! exactly 0. Otherwise m is at least 2^-600. A product that underflows is off by 2^-1075; whatever
//! it is multiplied by afterwards, m has been multiplied by as much, so that is at most 2^-475 of
//! m, and vanishes in the allowance.
//!
//! *Overflow* makes m infinite, which withholds the sign.

use crate::{Ball, Number, Sign};

/// The unit roundoff, 2^-53.
const U: f64 = f64::EPSILON / 2.0;

/// What the sign of any expression allows for, in units of u.
const ANY: f64 = 160.0;

/// What a ball allows for, in units of u: for short expressions.
const SHORT: f64 = 64.0;

/// From this size on a [`Ball`] is never known to be an integer.
const EXACT: f64 = 9_007_199_254_740_992.0;

/// An f64 and the size of what went into it.
///
/// ```
/// use hipline_num::{Number, Rough, Sign};
/// let (x, y) = (Rough::near(3.0), Rough::near(2.0_f64));
/// assert_eq!(x.minus(&y).sign(), Some(Sign::Positive));
/// assert_eq!(x.minus(&x).sign(), None);
/// assert_eq!(Rough::zero().times(&x).sign(), Some(Sign::Zero));
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Rough {
    v: f64,
    m: f64,
    /// ε in units of u.
    #[cfg(debug_assertions)]
    depth: f64,
}

/// Both lanes of a number; the third is there in debug builds only.
macro_rules! rough {
    ($v:expr, $m:expr, $depth:expr) => {
        Rough {
            v: $v,
            m: $m,
            #[cfg(debug_assertions)]
            depth: $depth,
        }
    };
}

impl Rough {
    /// The least size of a number from outside, unless it is 0.
    pub const LEAST: f64 = 1.0 / 32_768.0;

    /// A number that differs from this one by at most one part in 2^51; NaN if nothing is known
    /// of it.
    ///
    /// The size must be 0, and the number too, or at least [`Rough::LEAST`].
    #[inline]
    #[must_use]
    pub fn near(value: f64) -> Self {
        debug_assert!(
            value == 0.0 || value.abs() >= Self::LEAST || value.is_nan(),
            "{value} is too small"
        );
        rough!(value, value.abs(), 4.0)
    }

    /// A number of which nothing is known.
    #[inline]
    #[must_use]
    pub const fn unknown() -> Self {
        rough!(0.0, f64::INFINITY, 4.0)
    }

    /// The same as a ball, whose error is 0 only if nothing but zeros went into it; for
    /// expressions no deeper than the area of a triangle.
    #[inline]
    #[must_use]
    pub fn ball(&self) -> Ball {
        self.check(SHORT);
        if self.m == 0.0 {
            Ball::zero()
        } else {
            Ball::new(self.v, self.m * (SHORT * U))
        }
    }

    /// Whether a [`Ball`] made by the same operations might be known to be an integer.
    #[expect(clippy::float_cmp, reason = "asks for integers themselves")]
    #[inline]
    #[must_use]
    pub fn may_be_exact(&self) -> bool {
        self.v.abs() < EXACT && (self.v as i64) as f64 == self.v
    }

    #[inline(always)]
    fn check(&self, _allowance: f64) {
        // What is left of the allowance pays for the factors 1 + u and for the roundings of m.
        #[cfg(debug_assertions)]
        assert!(
            self.depth + 4.0 <= _allowance,
            "an expression is too deep: {}",
            self.depth
        );
    }
}

impl Number for Rough {
    #[inline]
    fn zero() -> Self {
        rough!(0.0, 0.0, 0.0)
    }

    #[inline]
    fn from_i64(i: i64) -> Self {
        Self::near(i as f64)
    }

    #[inline(always)]
    fn plus(&self, o: &Self) -> Self {
        rough!(self.v + o.v, self.m + o.m, self.depth.max(o.depth) + 1.0)
    }

    #[inline(always)]
    fn minus(&self, o: &Self) -> Self {
        rough!(self.v - o.v, self.m + o.m, self.depth.max(o.depth) + 1.0)
    }

    #[inline(always)]
    fn times(&self, o: &Self) -> Self {
        rough!(self.v * o.v, self.m * o.m, self.depth + o.depth + 1.0)
    }

    #[inline(always)]
    fn negated(&self) -> Self {
        rough!(-self.v, self.m, self.depth)
    }

    #[inline]
    fn sign(&self) -> Option<Sign> {
        self.check(ANY);
        let error = self.m * (ANY * U);
        if self.v > error {
            Some(Sign::Positive)
        } else if -self.v > error {
            Some(Sign::Negative)
        } else if self.m == 0.0 {
            Some(Sign::Zero)
        } else {
            None
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Determinants of small integers scaled far up and down: never a wrong sign, and nearly
    /// always one.
    #[test]
    fn signs_are_those_of_the_integers() {
        let mut state = 1_u64;
        let mut draw = || {
            state = state
                .wrapping_mul(6_364_136_223_846_793_005)
                .wrapping_add(1);
            (state >> 40) as i64 - (1 << 23)
        };
        let (mut told, mut asked) = (0, 0);
        for _ in 0..10_000 {
            let [a, b, c, d] = [draw(), draw(), draw(), draw()];
            // Nearly dependent rows.
            let k = draw() >> 12;
            for [p, q, r, s] in [[a, b, c, d], [a, b, k * a, k * b + 1], [a, b, k * a, k * b]] {
                let exact = i128::from(p) * i128::from(s) - i128::from(q) * i128::from(r);
                let [x, y, z, w] = [p, q, r, s].map(Rough::from_i64);
                asked += 1;
                if let Some(sign) = x.times(&w).minus(&y.times(&z)).sign() {
                    told += 1;
                    assert_eq!(sign, Sign::from(exact.cmp(&0)), "{p} {q} {r} {s}");
                }
            }
        }
        assert!(told * 3 > asked, "{told} of {asked}");
    }

    #[test]
    fn overflow_withholds_the_sign() {
        let big = Rough::near(1e300);
        assert_eq!(big.times(&big).sign(), None);
        assert_eq!(big.times(&big).minus(&Rough::near(1.0)).sign(), None);
        assert_eq!(Rough::unknown().sign(), None);
    }

    #[test]
    fn zeros_are_known() {
        let zero = Rough::zero().times(&Rough::near(7.0));
        assert_eq!(zero.negated().plus(&Rough::zero()).sign(), Some(Sign::Zero));
        assert_eq!(zero.ball().sign(), Some(Sign::Zero));
    }

    #[test]
    fn balls_hold_the_value() {
        let third = Rough::near(1.0e10 / 3.0);
        let ball = third.times(&third).minus(&Rough::near(5.0)).ball();
        assert!(ball.error() > 0.0 && ball.error() < 1e8);
        assert!(!third.may_be_exact() && Rough::near(4.0).may_be_exact());
    }
}
