//! The first rung: an f64 and a bound on its error.
//!
//! u = 2^-53 below. The invariant: the true value lies in [v − e, v + e], and *e = 0 only if
//! the true value is the integer v*. A positive e is never below 2^-500, so it cannot get
//! lost by underflow in a product.

use crate::dyadic::{is_integer, ldexp, power_of_two};
use crate::{BallDd, Number, Sign};
use dashu_int::IBig;

/// The unit roundoff, 2^-53: |fl(x) − x| ≤ U·|fl(x)| wherever fl(x) is normal.
const U: f64 = f64::EPSILON / 2.0;

/// Below this size a rounded sum or product of integers is not rounded at all.
///
/// If |fl(x)| < 2^53 for an integer x, then |x| < 2^53 since rounding is monotone and 2^53
/// is representable; hence x is representable and fl(x) = x.
const EXACT: f64 = 9_007_199_254_740_992.0;

/// 1 + 16u, the factor that pays for rounding in the computation of the bound itself.
///
/// Every bound below is a sum of products of nonnegative numbers; no term passes through
/// more than k ≤ 12 roundings, each of which may shrink it by a factor of at worst 1 − u, and
/// (1 − u)^12·(1 + 16u) ≥ (1 − 12u)(1 + 16u) > 1.
const SAFETY: f64 = 1.0 + 16.0 * U;

/// 2^-500, the least positive error.
///
/// It pays for underflow: an operation whose result is subnormal adds at most 2^-1075, and
/// a bound has fewer than ten. And it is so large that a product of two positive errors does not
/// underflow: a propagated error of 0 means that there is none. Quantities are polynomials
/// in integers and their roots; what is lost on numbers below 2^-500 is never missed.
const TINY: f64 = power_of_two(-500);

/// An f64 with a proven error bound.
///
/// Sums and products cost about ten flops. Overflow and NaN are harmless: they spread to the
/// error, which makes the ball abstain.
///
/// ```
/// use hipline_num::{Ball, Number, Sign};
/// let x = Ball::from_i64(2).sqrt();
/// assert_eq!(x.minus(&Ball::from_f64(1.414)).sign(), Some(Sign::Positive));
/// assert_eq!(x.times(&x).minus(&Ball::from_i64(2)).sign(), None);
/// assert_eq!(Ball::from_i64(9).sqrt().minus(&Ball::from_i64(3)).sign(), Some(Sign::Zero));
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Ball {
    v: f64,
    e: f64,
}

impl Ball {
    /// Some value within `err` of `value`. With `err` = 0 the value is exactly `value`,
    /// whether or not that is an integer.
    #[inline]
    #[must_use]
    pub fn new(value: f64, err: f64) -> Self {
        if !value.is_finite() {
            Self::ANY
        } else if err > 0.0 {
            Self {
                v: value,
                e: err.max(TINY),
            }
        } else if err == 0.0 {
            let e = if is_integer(value) { 0.0 } else { TINY };
            Self { v: value, e }
        } else {
            debug_assert!(err.is_nan(), "a negative error bound: {err}");
            Self::ANY
        }
    }

    /// The ball of which nothing is known.
    const ANY: Self = Self {
        v: 0.0,
        e: f64::INFINITY,
    };

    /// The value of an f64.
    #[inline]
    #[must_use]
    pub fn from_f64(x: f64) -> Self {
        Self::new(x, 0.0)
    }

    /// A ball near an integer; its error is 0 only if it is that integer.
    #[must_use]
    pub fn from_int(i: &IBig) -> Self {
        if let Ok(i) = i64::try_from(i) {
            return Self::from_i64(i);
        }
        let near = BallDd::from_int(i);
        let exact = near.error() == 0.0 && near.low() == 0.0;
        // The low word is at most u·|hi|, the error of the pair below u·|hi|/2.
        let e = if exact {
            0.0
        } else {
            near.value().abs() * (2.0 * U)
        };
        if near.error().is_finite() {
            Self { v: near.value(), e }
        } else {
            Self::ANY
        }
    }

    /// The middle of the ball.
    #[inline]
    #[must_use]
    pub const fn value(&self) -> f64 {
        self.v
    }

    /// How far the true value may be from [`value`](Self::value); 0 means that it is that integer.
    #[inline]
    #[must_use]
    pub const fn error(&self) -> f64 {
        self.e
    }

    /// A number that the true value is not below.
    #[inline]
    #[must_use]
    pub fn lower(&self) -> f64 {
        let x = self.v - self.e;
        if self.e == 0.0 {
            x
        } else if x.is_nan() {
            f64::NEG_INFINITY
        } else {
            x.next_down()
        }
    }

    /// A number that the true value is not above.
    #[inline]
    #[must_use]
    pub fn upper(&self) -> f64 {
        let x = self.v + self.e;
        if self.e == 0.0 {
            x
        } else if x.is_nan() {
            f64::INFINITY
        } else {
            x.next_up()
        }
    }

    /// The absolute value.
    ///
    /// The ball around |v| with the same error: | |x| − |v| | ≤ |x − v|.
    #[inline]
    #[must_use]
    pub fn abs(&self) -> Self {
        Self {
            v: self.v.abs(),
            e: self.e,
        }
    }

    /// The quotient; nothing is known of it if the divisor may be 0.
    ///
    /// With q = a/b: |x/y − q| = |(x − a) − q·(y − b)| / |y| ≤ (ea + |q|·eb) / (|b| − eb).
    /// |q| is taken up by 2^-500 in case it underflowed, and eb is divided first, so that
    /// an underflow there (at most 2^-1075) is multiplied by |q| only and vanishes in u·|q|.
    #[inline]
    #[must_use]
    pub fn div(&self, o: &Self) -> Self {
        let m = o.v.abs() - o.e;
        // Also catches NaN; m is rounded, but a positive rounded difference is positive.
        if !(m > 0.0 && m < f64::INFINITY) {
            return Self::ANY;
        }
        if self.v == 0.0 && self.e == 0.0 {
            return Self::zero();
        }
        let v = self.v / o.v;
        let size = v.abs() + TINY;
        let e = (self.e / m + size * (o.e / m) + size * U) * SAFETY + TINY;
        Self { v, e }
    }

    /// The square root of a quantity that is known not to be negative.
    ///
    /// If the ball excludes 0: |√x − √v| = |x − v| / (√x + √v) ≤ e/√v; and if moreover
    /// e ≤ v·2^-21, then √x ≥ √v·(1 − 2^-21), so that it is at most e/√v·½·(1 + 2^-21).
    /// If not, the root lies in [0, √(v + e)].
    #[expect(
        clippy::disallowed_methods,
        reason = "the error of the root is bounded here"
    )]
    #[inline]
    #[must_use]
    pub fn sqrt(&self) -> Self {
        if self.e == 0.0 && self.v >= 0.0 {
            let v = self.v.sqrt();
            // The root of a square of integers below 2^53 is below 2^27: nothing is rounded.
            let k = v as i64;
            if self.v < EXACT && k * k == self.v as i64 {
                return Self { v, e: 0.0 };
            }
            return Self {
                v,
                e: v * U * SAFETY,
            };
        }
        if self.v > self.e {
            let v = self.v.sqrt();
            // At least ½·(1 + 2^-21).
            let factor = if self.e <= self.v * (1.0 / 2_097_152.0) {
                0.500_000_5
            } else {
                1.0
            };
            let e = (self.e / v * factor + v * U) * SAFETY + TINY;
            return Self { v, e };
        }
        let top = self.upper();
        if !(0.0..f64::INFINITY).contains(&top) {
            return Self::ANY;
        }
        // The ball around √top/2; the factor pays for the root's own rounding.
        let v = top.sqrt() * 0.5;
        Self {
            v,
            e: v * SAFETY + TINY,
        }
    }

    /// The value times 2^k.
    #[inline]
    #[must_use]
    pub fn ldexp(&self, k: i32) -> Self {
        let v = ldexp(self.v, k);
        if self.e == 0.0 && (v == 0.0) == (self.v == 0.0) && v.is_finite() && is_integer(v) {
            return Self { v, e: 0.0 };
        }
        if !v.is_finite() {
            return Self::ANY;
        }
        Self {
            v,
            e: ldexp(self.e, k) * SAFETY + TINY,
        }
    }

    /// The ball from a rounded result and the propagated error, unless certified exact.
    ///
    /// The error of rounding is bounded apart, while the propagated error is still in the
    /// making: the chain of dependent flops is what the time goes into.
    #[inline(always)]
    fn rounded(v: f64, propagated: f64) -> Self {
        let e = propagated * SAFETY + (v.abs() * (U * SAFETY) + TINY);
        Self {
            v,
            e: if (propagated == 0.0) & (v.abs() < EXACT) {
                0.0
            } else {
                e
            },
        }
    }
}

impl Number for Ball {
    #[inline]
    fn zero() -> Self {
        Self { v: 0.0, e: 0.0 }
    }

    #[inline]
    fn from_i64(i: i64) -> Self {
        let v = i as f64;
        if i.unsigned_abs() <= 1 << 53 || v as i128 == i128::from(i) {
            Self { v, e: 0.0 }
        } else {
            Self { v, e: v.abs() * U }
        }
    }

    /// |x + y − fl(a + b)| ≤ ea + eb + u·|fl(a + b)|; a sum is exact where it is subnormal.
    #[inline]
    fn plus(&self, o: &Self) -> Self {
        let s = self.e + o.e;
        Self::rounded(self.v + o.v, s)
    }

    #[inline]
    fn minus(&self, o: &Self) -> Self {
        let s = self.e + o.e;
        Self::rounded(self.v - o.v, s)
    }

    /// |x·y − fl(a·b)| ≤ |a|·eb + (|b| + eb)·ea + u·|fl(a·b)|.
    ///
    /// Exact are integer times integer, and the integer 0 times anything. The propagated error
    /// is 0 in just these cases: if ea and eb are positive, ea·eb ≥ 2^-1000; and if ea = 0,
    /// then |a| is 0 or at least 1.
    #[inline]
    fn times(&self, o: &Self) -> Self {
        let s = self.v.abs() * o.e + (o.v.abs() + o.e) * self.e;
        Self::rounded(self.v * o.v, s)
    }

    #[inline]
    fn negated(&self) -> Self {
        Self {
            v: -self.v,
            e: self.e,
        }
    }

    #[inline]
    fn sign(&self) -> Option<Sign> {
        if self.v > self.e {
            Some(Sign::Positive)
        } else if -self.v > self.e {
            Some(Sign::Negative)
        } else if self.v == 0.0 && self.e == 0.0 {
            Some(Sign::Zero)
        } else {
            None
        }
    }
}
