//! The second rung: a double-double and a bound on its error.
//!
//! The value is hi + lo with |lo| ≤ ½ ulp(hi); u = 2^-53 below. The algorithms are those of
//! Joldes, Muller and Popescu, *Tight and rigorous error bounds for basic building blocks of
//! double-word arithmetic* (ACM TOMS 44, 2017), called JMP below: `AccurateDWPlusDW`,
//! `DWTimesDW1` and `DWDivDW2`. Products are split after Dekker, because the baseline targets
//! have no fused multiply-add and a library call for it would cost more than the rest;
//! where the target has one, it computes the same bits.
//!
//! The invariant is that of [`Ball`](crate::Ball): the true value lies within e of hi + lo,
//! e = 0 only if the true value is the integer hi + lo, and a positive e is at least 2^-500.

use crate::dyadic::{is_integer, ldexp, power_of_two};
use crate::{Number, Sign};
use dashu_int::{IBig, Word};

/// The unit roundoff, 2^-53.
const U: f64 = f64::EPSILON / 2.0;

/// The base of the digits of big integers, 2^64 or 2^32.
const BASE: f64 = power_of_two(Word::BITS as i32);

/// So many of its digits hold at least 129 bits of a larger integer.
const LEADING: usize = 128 / Word::BITS as usize + 1;

/// u² = 2^-106.
const UU: f64 = U * U;

/// Below this |hi|, 2^102, a rounded sum or product of integers is not rounded at all.
///
/// Every intermediate of the two algorithms is an integer if the operands are (a sum,
/// product or Dekker half of integers, rounded to f64, is an integer). The result differs
/// from the true value x by at most 7u²·|x| ≤ 7u²·2^102·(1 + 2u) < 1: two integers that
/// differ by less than 1 are equal.
const EXACT: f64 = 5_070_602_400_912_917_605_986_812_821_504.0;

/// Below this a rounded product of f64 integers is exact, as in `Ball`.
const EXACT_F64: f64 = 9_007_199_254_740_992.0;

/// 1 + 32u: pays for at most 24 roundings in a bound, and for |hi + lo| ≤ (1 + u)·|hi|.
const SAFETY: f64 = 1.0 + 32.0 * U;

/// 2^-500, the least positive error; it pays for underflow and prevents it in errors.
///
/// If a product of two words is at least 2^-960, its Dekker partial products are multiples
/// of 2^-1066 and nothing underflows. If it is smaller, the partial products are off by
/// 2^-1075 each and the sums of them by at most u·2^-960 = 2^-1013 each; there are fewer than ten.
/// The same holds for the cross products x_hi·y_lo, which are rounded once. And as in
/// `Ball`, a product of positive errors stays positive.
const TINY: f64 = power_of_two(-500);

/// A double-double with a proven error bound: about 32 decimal digits.
///
/// ```
/// use hipline_num::{BallDd, Number, Sign};
/// let x = BallDd::from_i64(2).sqrt();
/// // 2 - x² is not told from 0, but 1e-25 is.
/// let square = x.times(&x);
/// assert_eq!(square.minus(&BallDd::from_i64(2)).sign(), None);
/// let more = BallDd::from_i64(2).plus(&BallDd::from_f64(1e-25));
/// assert_eq!(more.minus(&square).sign(), Some(Sign::Positive));
/// ```
#[derive(Clone, Copy, Debug)]
pub struct BallDd {
    hi: f64,
    lo: f64,
    e: f64,
}

/// a + b = s + t exactly, s = fl(a + b) (Knuth, Møller).
#[inline(always)]
fn two_sum(a: f64, b: f64) -> (f64, f64) {
    let s = a + b;
    let bb = s - a;
    (s, (a - (s - bb)) + (b - bb))
}

/// The same if |a| ≥ |b| or a = 0 (Dekker).
#[inline(always)]
fn fast_two_sum(a: f64, b: f64) -> (f64, f64) {
    let s = a + b;
    (s, b - (s - a))
}

/// x as two halves of at most 26 bits each (Veltkamp); 2^27 + 1.
#[inline(always)]
fn split(x: f64) -> (f64, f64) {
    let c = 134_217_729.0 * x;
    let hi = c - (c - x);
    (hi, x - hi)
}

/// a·b = p + t exactly, p = fl(a·b), unless something over- or underflows (Dekker).
#[inline(always)]
fn two_product(a: f64, b: f64) -> (f64, f64) {
    let p = a * b;
    if cfg!(target_feature = "fma") {
        return (p, a.mul_add(b, -p));
    }
    let (ah, al) = split(a);
    let (bh, bl) = split(b);
    (p, al * bl - (((p - ah * bh) - al * bh) - ah * bl))
}

impl BallDd {
    /// The ball of which nothing is known.
    const ANY: Self = Self {
        hi: 0.0,
        lo: 0.0,
        e: f64::INFINITY,
    };

    /// Some value within `err` of `hi + lo`. With `err` = 0 the value is exactly `hi + lo`,
    /// whether or not that is an integer.
    #[inline]
    #[must_use]
    pub fn new(hi: f64, lo: f64, err: f64) -> Self {
        let (hi, lo) = two_sum(hi, lo);
        // An overflow shows in lo as NaN.
        if !lo.is_finite() {
            Self::ANY
        } else if err > 0.0 {
            Self {
                hi,
                lo,
                e: err.max(TINY),
            }
        } else if err == 0.0 {
            // hi is an integer if lo is: |lo| ≥ 1 makes ulp(hi) ≥ 2; lo = 0 needs the test.
            let e = if is_integer(hi) && is_integer(lo) {
                0.0
            } else {
                TINY
            };
            Self { hi, lo, e }
        } else {
            debug_assert!(err.is_nan(), "a negative error bound: {err}");
            Self::ANY
        }
    }

    /// The value of an f64.
    #[inline]
    #[must_use]
    pub fn from_f64(x: f64) -> Self {
        Self::new(x, 0.0, 0.0)
    }

    /// A double-double near an integer; the error is 0 only if it is that integer.
    #[must_use]
    pub fn from_int(i: &IBig) -> Self {
        let (sign, words) = i.as_sign_words();
        let size = Self::from_words(words);
        if sign == dashu_int::Sign::Negative {
            size.negated()
        } else {
            size
        }
    }

    /// The integer with these digits to the base 2^64 (or 2^32), least first.
    ///
    /// Horner's rule on the leading 129 bits or more; the sums bound or certify themselves,
    /// and what is left out is below 2^-128 < u² of the whole.
    pub(crate) fn from_words(words: &[Word]) -> Self {
        let rest = words.len().saturating_sub(LEADING);
        let mut sum = Self::zero();
        for &word in words[rest..].iter().rev() {
            #[allow(clippy::useless_conversion, reason = "the width depends on the target")]
            let word = u64::from(word);
            let (high, low) = ((word >> 32) as f64, (word & 0xffff_ffff) as f64);
            let (hi, lo) = fast_two_sum(high * 4_294_967_296.0, low);
            sum.hi *= BASE;
            sum.lo *= BASE;
            sum.e *= BASE;
            sum = sum.sum(hi, lo, 0.0);
        }
        if rest > 0 {
            sum.e += sum.hi * UU;
            sum = sum.ldexp(i32::try_from(rest * Word::BITS as usize).unwrap_or(i32::MAX));
        }
        sum
    }

    /// The middle of the ball, rounded to f64.
    #[inline]
    #[must_use]
    pub const fn value(&self) -> f64 {
        self.hi
    }

    /// What the middle of the ball has beyond [`value`](Self::value).
    #[inline]
    #[must_use]
    pub const fn low(&self) -> f64 {
        self.lo
    }

    /// How far the true value may be from the middle; 0 means that it is that integer.
    #[inline]
    #[must_use]
    pub const fn error(&self) -> f64 {
        self.e
    }

    /// A number that the true value is not below.
    #[inline]
    #[must_use]
    pub fn lower(&self) -> f64 {
        if self.e == 0.0 && self.lo == 0.0 {
            return self.hi;
        }
        // Monotone: hi + t rounds to within one step of a bound below.
        let x = self.hi + (self.lo - self.e).next_down();
        if x.is_nan() {
            f64::NEG_INFINITY
        } else {
            x.next_down()
        }
    }

    /// A number that the true value is not above.
    #[inline]
    #[must_use]
    pub fn upper(&self) -> f64 {
        if self.e == 0.0 && self.lo == 0.0 {
            return self.hi;
        }
        let x = self.hi + (self.lo + self.e).next_up();
        if x.is_nan() {
            f64::INFINITY
        } else {
            x.next_up()
        }
    }

    /// The absolute value: the ball around |hi + lo| with the same error.
    #[inline]
    #[must_use]
    pub fn abs(&self) -> Self {
        if self.hi < 0.0 { self.negated() } else { *self }
    }

    /// The f64 that every number of the ball rounds to, if there is just one.
    ///
    /// t₁ ≤ lo − e and lo + e ≤ t₂ (each rounded outward). Since fl(hi + t) is the correctly
    /// rounded sum and rounding is monotone, equal ends fix everything between them. Not for
    /// results in the subnormal range that are to be scaled afterwards.
    #[inline]
    pub(crate) fn rounded_once(&self) -> Option<f64> {
        if self.e == 0.0 {
            // |lo| ≤ ½ ulp(hi), and fl(hi + lo) = hi by construction of every pair.
            return Some(self.hi);
        }
        let low = self.hi + (self.lo - self.e).next_down();
        let high = self.hi + (self.lo + self.e).next_up();
        (low.to_bits() == high.to_bits() && low.is_finite()).then_some(low)
    }

    /// The quotient; nothing is known of it if the divisor may be 0.
    ///
    /// JMP's `DWDivDW2`: the quotient q of the middles is within 15u² + 56u³ ≤ 16u² of itself,
    /// provided that nothing over- or underflows, to which end the middles are kept within
    /// 2^±450 (a smaller dividend is taken for 0 and counted as error). The errors of the
    /// operands enter as in [`Ball::div`](crate::Ball::div).
    #[must_use]
    pub fn div(&self, o: &Self) -> Self {
        let b = o.hi.abs();
        let m = b * (1.0 - 4.0 * U) - o.e;
        if !(m > 0.0 && (LEAST..=MOST).contains(&b)) {
            return Self::ANY;
        }
        if self.hi == 0.0 && self.e == 0.0 {
            return Self::zero();
        }
        let a = self.hi.abs();
        if a < LEAST {
            let e = (self.e + a * SAFETY) / m * SAFETY + TINY;
            return Self {
                hi: 0.0,
                lo: 0.0,
                e,
            };
        }
        if a.is_nan() || a > MOST {
            return Self::ANY;
        }
        let t = self.hi / o.hi;
        let (ph, pl) = two_product(o.hi, t);
        let (rh, rl) = fast_two_sum(ph, o.lo * t + pl);
        let d = (self.hi - rh) + (self.lo - rl);
        let (hi, lo) = fast_two_sum(t, d / o.hi);
        let size = hi.abs();
        let e = (self.e / m + size * (o.e / m) + size * (16.0 * UU)) * SAFETY + TINY;
        Self { hi, lo, e }
    }

    /// The square root of a quantity that is known not to be negative.
    ///
    /// s = fl(√hi), then one step of Newton: s + (x − s²)/(2s) for the middle x. The residue
    /// ρ = x − s² is computed to within a factor 1 + u (hi − s² is an f64), and |ρ| ≤ 3.1u·x;
    /// dividing by 2s instead of √x + s errs by a factor 1 + 0.8u, and the division by 1 + u.
    /// So the result is within 1.6u·3u·√x < 5u²·√x; the bound takes 8u².
    /// The error of the operand enters as in [`Ball::sqrt`](crate::Ball::sqrt).
    #[expect(
        clippy::disallowed_methods,
        reason = "the error of the root is bounded here"
    )]
    #[must_use]
    pub fn sqrt(&self) -> Self {
        if self.hi == 0.0 && self.e == 0.0 {
            return Self::zero();
        }
        if self.hi * (1.0 - 4.0 * U) <= self.e || self.hi < LEAST {
            let top = self.upper();
            if !(0.0..f64::INFINITY).contains(&top) {
                return Self::ANY;
            }
            let hi = top.sqrt() * 0.5;
            return Self {
                hi,
                lo: 0.0,
                e: hi * SAFETY + TINY,
            };
        }
        if self.hi.is_nan() || self.hi > MOST {
            return Self::ANY;
        }
        let s = self.hi.sqrt();
        let (p, t) = two_product(s, s);
        let residue = ((self.hi - p) - t) + self.lo;
        // An integer root below 2^51 of an exact square: √hi is within u/2 of it, so s is it.
        if residue == 0.0 && self.e == 0.0 && self.hi < EXACT && is_integer(s) {
            return Self {
                hi: s,
                lo: 0.0,
                e: 0.0,
            };
        }
        let (hi, lo) = fast_two_sum(s, residue / (2.0 * s));
        // At least ½·(1 + 2^-21), as for Ball.
        let factor = if self.e <= self.hi * (1.0 / 4_194_304.0) {
            0.500_000_5
        } else {
            1.0
        };
        let e = (self.e / s * factor + hi * (8.0 * UU)) * SAFETY + TINY;
        Self { hi, lo, e }
    }

    /// The value times 2^k.
    #[must_use]
    pub fn ldexp(&self, k: i32) -> Self {
        let (hi, lo) = (ldexp(self.hi, k), ldexp(self.lo, k));
        if !hi.is_finite() {
            return Self::ANY;
        }
        let lost = (hi == 0.0) != (self.hi == 0.0) || (lo == 0.0) != (self.lo == 0.0);
        if self.e == 0.0 && !lost && is_integer(hi) && is_integer(lo) {
            return Self { hi, lo, e: 0.0 };
        }
        Self {
            hi,
            lo,
            e: ldexp(self.e, k) * SAFETY + TINY,
        }
    }

    /// `AccurateDWPlusDW` of JMP: within 3u² + 13u³ of the sum, so within 4u²·|hi|.
    #[inline(always)]
    fn sum(&self, yh: f64, yl: f64, ye: f64) -> Self {
        let (sh, sl) = two_sum(self.hi, yh);
        let (th, tl) = two_sum(self.lo, yl);
        let (vh, vl) = fast_two_sum(sh, sl + th);
        let (hi, lo) = fast_two_sum(vh, tl + vl);
        let s = self.e + ye;
        let e = s * SAFETY + (hi.abs() * (4.0 * UU * SAFETY) + TINY);
        let exact = (s == 0.0) & (hi.abs() < EXACT);
        Self {
            hi,
            lo,
            e: if exact { 0.0 } else { e },
        }
    }
}

/// 2^-450 and 2^450: the range of operands of `div` and `sqrt`.
///
/// With operands in it, the first quotient is within 2^±900, all products are near the
/// dividend, and an underflow (2^-1075) of the correction terms is below 2^-625 relative to the
/// dividend or 2^-175 relative to the quotient: covered by the u² between 15u² and 16u².
const LEAST: f64 = power_of_two(-450);
const MOST: f64 = power_of_two(450);

impl Number for BallDd {
    #[inline]
    fn zero() -> Self {
        Self {
            hi: 0.0,
            lo: 0.0,
            e: 0.0,
        }
    }

    #[inline]
    fn from_i64(i: i64) -> Self {
        // Both halves are f64 numbers, and their exact sum is the pair.
        let (hi, lo) = fast_two_sum((i >> 32) as f64 * 4_294_967_296.0, (i & 0xffff_ffff) as f64);
        Self { hi, lo, e: 0.0 }
    }

    #[inline]
    fn plus(&self, o: &Self) -> Self {
        self.sum(o.hi, o.lo, o.e)
    }

    #[inline]
    fn minus(&self, o: &Self) -> Self {
        self.sum(-o.hi, -o.lo, o.e)
    }

    /// `DWTimesDW1` of JMP: within 7u² of the product, so within 8u²·|hi|.
    ///
    /// Integers whose product is below 2^53 take one multiplication: then either factor has
    /// no low word, or it is at least 2^53 in size and the other one is 0.
    #[inline]
    fn times(&self, o: &Self) -> Self {
        let p = self.hi * o.hi;
        if (self.e + o.e == 0.0) & (p.abs() < EXACT_F64) {
            return Self {
                hi: p,
                lo: 0.0,
                e: 0.0,
            };
        }
        let (ch, cl) = two_product(self.hi, o.hi);
        let cross = self.hi * o.lo + self.lo * o.hi;
        let (hi, lo) = fast_two_sum(ch, cl + cross);
        // As in Ball::times.
        let s = self.hi.abs() * o.e + (o.hi.abs() + o.e) * self.e;
        let e = s * SAFETY + (hi.abs() * (8.0 * UU * SAFETY) + TINY);
        let exact = (s == 0.0) & (hi.abs() < EXACT);
        Self {
            hi,
            lo,
            e: if exact { 0.0 } else { e },
        }
    }

    #[inline]
    fn negated(&self) -> Self {
        Self {
            hi: -self.hi,
            lo: -self.lo,
            e: self.e,
        }
    }

    /// |hi + lo| ≥ |hi|·(1 − u) > fl(|hi|·(1 − 4u)); so if that exceeds e, hi has the sign.
    /// (Where |hi| is subnormal, lo is 0, and the rounded product is at most |hi|.)
    #[inline]
    fn sign(&self) -> Option<Sign> {
        let size = self.hi.abs() * (1.0 - 4.0 * U);
        if size > self.e {
            Some(if self.hi > 0.0 {
                Sign::Positive
            } else {
                Sign::Negative
            })
        } else if self.e == 0.0 && self.hi == 0.0 {
            Some(Sign::Zero)
        } else {
            None
        }
    }
}
