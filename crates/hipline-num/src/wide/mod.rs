//! Floating point with some 400 binary digits and a proven error bound: the rung that tells
//! what double-double cannot, at a small part of the cost of exact numbers.
//!
//! A value is within `error` units of a mantissa of up to [`WORDS`] digits to the base 2^64, where the unit is
//! the one of its last digit: a power of 2^64, so that digits are never shifted by parts of a word. The leading
//! one may be as little as 1: 385 binary digits at least are kept. Sums and products are computed
//! exactly as far as they are kept, which costs at most one unit; quotients and roots are iterated from
//! double-doubles, and what is left of the dividend or the radicand bounds how wrong they are. The bound is an f64, every
//! step of which is rounded up by a factor of `1 + 2^-50` (each step has at most four
//! roundings of relative size 2^-53).

use dashu_int::{IBig, UBig};
use smallvec::SmallVec;
use std::cmp::Ordering;

use crate::dyadic::{magnitude_parts, power_of_two};
use crate::{BallDd, Number, Sign, limbs::near, perfect_root, words};

/// Digits to the base 2^64 kept.
const WORDS: usize = 7;

/// Covers the roundings of a few operations on bounds.
const UP: f64 = 1.0 + 1.0 / (1_u64 << 50) as f64;

/// From this power of two on, a bound makes the last digit meaningless.
const MEANINGLESS: i32 = 64 + 16;

/// Steps that take an approximation of about 100 binary digits to more than are kept, each of which adds
/// about 100.
const STEPS: usize = 3;

/// A number with some 400 binary digits and a proven error bound; with error 0 it is exact.
#[derive(Clone, Copy)]
pub struct Wide {
    /// Least first; those not in use are zero.
    digits: [u64; WORDS],
    /// So many are in use, the last of them not zero.
    len: u8,
    negative: bool,
    /// The unit is 2^(64 exponent).
    exponent: i32,
    /// In units.
    error: f64,
}

impl std::fmt::Debug for Wide {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let sign = if self.negative { "-" } else { "" };
        let (digits, exponent) = (self.used(), self.exponent);
        write!(f, "({sign}{digits:x?} ± {}) 2^(64·{exponent})", self.error)
    }
}

/// 2^(64 words), or what is above it where f64 has no such number.
fn power(words: i32) -> f64 {
    power_of_two(64 * words.clamp(-16, 16)).max(f64::MIN_POSITIVE)
}

/// A bound in units of another size.
fn scaled(error: f64, words: i32) -> f64 {
    if error > 0.0 && words != 0 {
        (error * power(words) * UP).max(f64::MIN_POSITIVE)
    } else {
        error
    }
}

/// The leading 53 binary digits of a number without leading zeros, and how many were left out.
fn leading(digits: &[u64]) -> (f64, u32) {
    let (head, left) = match *digits {
        [] => (0, 0),
        [only] => (u128::from(only), 0),
        [.., low, high] => (
            u128::from(high) << 64 | u128::from(low),
            digits.len() as u32 - 2,
        ),
    };
    let drop = (u128::BITS - head.leading_zeros()).saturating_sub(53);
    #[expect(clippy::cast_precision_loss, reason = "at most 53 digits are exact")]
    ((head >> drop) as f64, drop + 64 * left)
}

impl Wide {
    /// The value of an integer.
    #[must_use]
    pub fn from_int(i: &IBig) -> Self {
        let mut digits = SmallVec::<[u64; 2 * WORDS]>::from_elem(0, words::count(i));
        let negative = words::write(i, &mut digits);
        Self::kept(&digits, negative, 0, 0.0)
    }

    /// The value of a machine integer.
    #[must_use]
    pub fn from_i128(i: i128) -> Self {
        Self::kept(&words::of_u128(i.unsigned_abs()), i < 0, 0, 0.0)
    }

    /// The root of a natural number.
    #[must_use]
    pub fn sqrt_of(r: &UBig) -> Self {
        match perfect_root(r) {
            Some(root) => Self::from_int(&IBig::from(root)),
            None => Self::from_int(&IBig::from(r.clone())).sqrt(),
        }
    }

    /// A number of which nothing is known.
    pub const UNKNOWN: Self = Self {
        digits: [0; WORDS],
        len: 0,
        negative: false,
        exponent: 0,
        error: f64::INFINITY,
    };

    #[inline]
    fn used(&self) -> &[u64] {
        &self.digits[..usize::from(self.len)]
    }

    /// Whether it is zero for sure.
    fn is_zero(&self) -> bool {
        self.len == 0 && self.error <= 0.0
    }

    /// The middle, as if it were exact.
    fn middle(&self) -> Self {
        Self {
            error: 0.0,
            ..*self
        }
    }

    /// Keeps the leading digits, as far as they mean something.
    #[inline]
    fn kept(digits: &[u64], negative: bool, exponent: i32, error: f64) -> Self {
        let len = words::used(digits);
        let mut drop = len.saturating_sub(WORDS);
        // A NaN is as good as infinity.
        if error.is_nan() || error >= power_of_two(MEANINGLESS) {
            if !error.is_finite() {
                return Self::UNKNOWN;
            }
            let binary = (error.to_bits() >> 52) as u32 - 1023;
            drop = drop.max((binary - 16) as usize / 64).min(len);
        }
        let mut result = Self {
            digits: [0; WORDS],
            len: (len - drop) as u8,
            negative: negative && len > drop,
            exponent: exponent + drop as i32,
            error,
        };
        result.digits[..len - drop].copy_from_slice(&digits[drop..len]);
        if drop > 0 && (error > 0.0 || digits[..drop].iter().any(|&digit| digit != 0)) {
            result.error = (scaled(error, -(drop as i32)) + 1.0) * UP;
        }
        result
    }

    /// An upper bound of the size of the mantissa.
    fn size(&self) -> f64 {
        let (top, cut) = leading(self.used());
        if cut == 0 {
            top
        } else {
            // The sum is at most 2^53: exact, and so is the product.
            (top + 1.0) * power_of_two(cut as i32)
        }
    }

    /// A lower bound of the size of the mantissa.
    fn least(&self) -> f64 {
        let (top, cut) = leading(self.used());
        top * power_of_two(cut as i32)
    }

    /// Adds the digits of a number to zeros that begin at a unit; returns the error of this in such units.
    #[inline]
    fn lay(&self, window: &mut [u64], unit: i32) -> f64 {
        let error = scaled(self.error, self.exponent - unit);
        let below = usize::try_from(unit - self.exponent).unwrap_or(0);
        let above = usize::try_from(self.exponent - unit).unwrap_or(0);
        let kept = self.used().get(below..).unwrap_or_default();
        if !kept.is_empty() {
            window[above..above + kept.len()].copy_from_slice(kept);
        }
        let lost = &self.used()[..below.min(self.used().len())];
        if lost.iter().any(|&digit| digit != 0) {
            (error + 1.0) * UP
        } else {
            error
        }
    }

    #[inline]
    fn sum(&self, o: &Self, negate: bool) -> Self {
        if o.is_zero() {
            return *self;
        }
        if self.is_zero() {
            return if negate { o.negated() } else { *o };
        }
        // Room for all digits that can be kept, and one that is carried.
        let top = (self.exponent + i32::from(self.len)).max(o.exponent + i32::from(o.len));
        let unit = self.exponent.min(o.exponent).max(top - WORDS as i32);
        let (mut a, mut b) = ([0; WORDS + 1], [0; WORDS + 1]);
        let error = (self.lay(&mut a, unit) + o.lay(&mut b, unit)) * UP;
        let minus = o.negative != negate;
        if self.negative == minus {
            words::add(&mut a, &b);
            return Self::kept(&a, minus, unit, error);
        }
        let (m, n) = (words::used(&a), words::used(&b));
        match words::compare(&a[..m], &b[..n]) {
            Ordering::Equal => Self::kept(&[], false, unit, error),
            Ordering::Greater => {
                words::subtract(&mut a[..m], &b[..n]);
                Self::kept(&a[..m], self.negative, unit, error)
            }
            Ordering::Less => {
                words::subtract(&mut b[..n], &a[..m]);
                Self::kept(&b[..n], minus, unit, error)
            }
        }
    }

    /// The value of an f64.
    fn from_f64(x: f64) -> Self {
        if x == 0.0 || !x.is_finite() {
            return Self::zero();
        }
        let (mantissa, exponent) = magnitude_parts(x);
        let digits = words::of_u128(u128::from(mantissa) << exponent.rem_euclid(64));
        Self::kept(&digits, x < 0.0, exponent.div_euclid(64), 0.0)
    }

    /// About the same as a double-double times 2^(64 k), as if it were exact.
    fn from_near(near: &BallDd, k: i32) -> Self {
        let sum = Self::from_f64(near.value()).plus(&Self::from_f64(near.low()));
        Self {
            exponent: sum.exponent + k,
            ..sum.middle()
        }
    }

    /// A double-double and k such that the mantissa's middle is the former times 2^(64 k), nearly.
    fn near(&self) -> (BallDd, i32) {
        let rest = usize::from(self.len).saturating_sub(3);
        let near = near(&self.used()[rest..]);
        let k = self.exponent + rest as i32;
        (if self.negative { near.negated() } else { near }, k)
    }

    /// Approximations, each better by what is left of something times an approximate inverse of how that changes, as if they
    /// were exact; the last one, and what is left.
    fn refined(self, inverse: &Self, rest: impl Fn(&Self) -> Self) -> (Self, Self) {
        let (mut near, mut left) = (self, rest(&self));
        for _ in 0..STEPS {
            if left.is_zero() {
                break;
            }
            near = near.plus(&left.times(inverse)).middle();
            left = rest(&near);
        }
        (near, left)
    }

    /// An upper bound of the size in other units.
    fn most(&self, unit: i32) -> f64 {
        scaled(self.size() + self.error, self.exponent - unit)
    }

    /// The same middle with a bound.
    fn within(self, error: f64) -> Self {
        let error = if error.is_nan() { f64::INFINITY } else { error };
        Self { error, ..self }
    }

    /// The quotient; the bound is infinite if the divisor may be zero.
    #[must_use]
    pub fn div(&self, o: &Self) -> Self {
        // A lower bound of the divisor's size less its error, rounded down.
        let least = (o.least() - o.error * UP) / UP;
        if o.len == 0 || least.is_nan() || least <= 0.0 {
            return Self::UNKNOWN;
        }
        let (near, k) = o.near();
        let inverse = Self::from_near(&BallDd::from_f64(1.0).div(&near), -k);
        let (n, d) = (self.middle(), o.middle());
        let first = n.times(&inverse).middle();
        let (quotient, rest) = first.refined(&inverse, |q| n.minus(&q.times(&d)));
        // (n + dn) / (d + dd) - q = (n - q d + dn - q dd) / (d + dd)
        let unit = o.exponent + quotient.exponent;
        let own = scaled(self.error, self.exponent - unit);
        let error = rest.most(unit) + own + quotient.size() * o.error;
        quotient.within(error * UP / least * UP)
    }

    /// The root of a quantity that is not negative.
    #[must_use]
    pub fn sqrt(&self) -> Self {
        if self.negative || self.len == 0 {
            let high = (self.size() + self.error) * UP;
            if high <= 0.0 {
                return Self::zero();
            }
            // The root of something between 0 and high; an odd exponent has another 2^32.
            let odd = self.exponent.rem_euclid(2);
            #[expect(clippy::disallowed_methods, reason = "rounded up")]
            let root = high.sqrt() * UP * if odd == 1 { power_of_two(32) } else { 1.0 };
            let exponent = (self.exponent - odd) / 2;
            return Self::kept(&[], false, exponent, root);
        }
        let (near, k) = self.near();
        let odd = k.rem_euclid(2);
        let near = near.ldexp(64 * odd).sqrt();
        let half = (k - odd) / 2;
        let inverse = Self::from_near(&BallDd::from_f64(0.5).div(&near), -half);
        let square = self.middle();
        let first = Self::from_near(&near, half);
        let (root, rest) = first.refined(&inverse, |root| square.minus(&root.times(root)));
        // |sqrt(s + ds) - r| <= |s - r r + ds| / r, for r > 0 and s + ds >= 0.
        let unit = 2 * root.exponent;
        let own = scaled(self.error, self.exponent - unit);
        root.within((rest.most(unit) + own) * UP / root.least() * UP)
    }

    /// The same as a double-double.
    #[must_use]
    pub fn to_ball_dd(&self) -> BallDd {
        let (near, k) = self.near();
        let error = scaled(self.error, self.exponent - k);
        // `near` has its own error; of what it leaves out the last digit is less than one unit of its own.
        let lost = if k > self.exponent { 1.0 } else { 0.0 };
        near.plus(&BallDd::new(0.0, 0.0, (error + lost) * UP))
            .ldexp(k.saturating_mul(64))
    }

    /// Whether the bound is finite.
    #[must_use]
    pub fn is_bounded(&self) -> bool {
        self.error.is_finite()
    }
}

impl Number for Wide {
    fn zero() -> Self {
        Self {
            error: 0.0,
            ..Self::UNKNOWN
        }
    }
    fn from_i64(i: i64) -> Self {
        Self::kept(&[i.unsigned_abs()], i < 0, 0, 0.0)
    }
    #[inline]
    fn plus(&self, o: &Self) -> Self {
        self.sum(o, false)
    }
    #[inline]
    fn minus(&self, o: &Self) -> Self {
        self.sum(o, true)
    }
    #[inline]
    fn times(&self, o: &Self) -> Self {
        let exponent = self.exponent + o.exponent;
        let error = if self.error <= 0.0 && o.error <= 0.0 {
            0.0
        } else {
            let (a, b) = (self.size(), o.size());
            (a * o.error + b * self.error + self.error * o.error) * UP
        };
        let mut product = [0; 2 * WORDS];
        let len = usize::from(self.len + o.len);
        if self.len > 0 && o.len > 0 {
            words::multiply(&mut product, self.used(), o.used());
        }
        let negative = self.negative != o.negative;
        Self::kept(&product[..len], negative, exponent, error)
    }
    fn negated(&self) -> Self {
        Self {
            negative: !self.negative && self.len > 0,
            ..*self
        }
    }
    #[inline]
    fn sign(&self) -> Option<Sign> {
        let sign = match (self.len, self.negative) {
            (0, _) => Sign::Zero,
            (_, true) => Sign::Negative,
            (_, false) => Sign::Positive,
        };
        (self.error <= 0.0 || self.least() > self.error).then_some(sign)
    }
}

#[cfg(test)]
mod tests;
