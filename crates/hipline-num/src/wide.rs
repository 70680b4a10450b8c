//! Floating point with some 400 binary digits and a proven error bound: the rung that tells
//! what double-double cannot, at a small part of the cost of exact numbers.
//!
//! A value is within `error * 2^exponent` of `mantissa * 2^exponent`. Sums and products are
//! computed exactly and then cut to [`DIGITS`] digits, which costs at most one unit of the
//! last place; the bound is an f64, every step of which is rounded up by a factor of
//! `1 + 2^-50` (each step has at most four roundings of relative size 2^-53).

use dashu_int::{
    IBig, UBig, Word,
    ops::{SquareRoot, UnsignedAbs},
};

use crate::{BallDd, Number, Sign, ldexp};

/// Binary digits kept.
const DIGITS: usize = 400;

/// Covers the roundings of a few operations on bounds.
const UP: f64 = 1.0 + 1.0 / (1_u64 << 50) as f64;

/// A number with 400 binary digits and a proven error bound; with error 0 it is exact.
#[derive(Clone, Debug)]
pub struct Wide {
    mantissa: IBig,
    exponent: i64,
    error: f64,
}

/// Binary digits of the size of an integer.
fn bits(m: &IBig) -> usize {
    let (_, words) = m.as_sign_words();
    let top = words
        .last()
        .map_or(0, |word| Word::BITS - word.leading_zeros());
    words.len().saturating_sub(1) * Word::BITS as usize + top as usize
}

/// The leading digits of a mantissa, and how many were left out.
fn leading(m: &IBig) -> (f64, i32) {
    let (_, words) = m.as_sign_words();
    // As many words as 52 digits need, and a bit of one more.
    let (mut head, mut left) = (0_u128, words.len());
    while left > 0 && head >> 52 == 0 {
        left -= 1;
        head = head << Word::BITS | u128::from(words[left]);
    }
    let drop = (u128::BITS - head.leading_zeros()).saturating_sub(52);
    let cut = drop as usize + left * Word::BITS as usize;
    #[expect(clippy::cast_precision_loss, reason = "at most 52 digits are exact")]
    (
        (head >> drop) as f64,
        i32::try_from(cut).expect("mantissas are short"),
    )
}

/// An exponent of which `ldexp` makes nothing else than of the full one.
fn power(digits: impl TryInto<i32>) -> i32 {
    digits.try_into().unwrap_or(i32::MAX)
}

/// An upper bound of the size of a mantissa.
fn size(m: &IBig) -> f64 {
    let (top, cut) = leading(m);
    // Below 2^52, the sum is exact; so is the scaling.
    if cut == 0 { top } else { ldexp(top + 1.0, cut) }
}

/// A lower bound of the size of a mantissa.
fn least(m: &IBig) -> f64 {
    let (top, cut) = leading(m);
    ldexp(top, cut)
}

impl Wide {
    /// The value of an integer.
    #[must_use]
    pub fn from_int(i: &IBig) -> Self {
        Self {
            mantissa: i.clone(),
            exponent: 0,
            error: 0.0,
        }
        .cut()
    }

    /// The root of a natural number.
    #[must_use]
    pub fn sqrt_of(r: &UBig) -> Self {
        Self::from_int(&IBig::from(r.clone())).sqrt()
    }

    /// Keeps the leading digits.
    fn cut(mut self) -> Self {
        let length = bits(&self.mantissa);
        // A bound far larger than one unit makes the last digits meaningless.
        if length > DIGITS {
            let drop = length - DIGITS;
            // Shifting rounds down: at most one unit.
            self.mantissa >>= drop;
            self.exponent += i64::try_from(drop).expect("short");
            self.error = (ldexp(self.error, -power(drop)) + 1.0) * UP;
        }
        self
    }

    /// This value with the given, smaller exponent.
    fn lowered(&self, exponent: i64) -> (IBig, f64) {
        let by =
            usize::try_from(self.exponent - exponent).expect("an exponent not above this one's");
        (&self.mantissa << by, ldexp(self.error, power(by)) * UP)
    }

    fn sum(&self, o: &Self, negate: bool) -> Self {
        // Far apart, the smaller one is no more than an error.
        let exponent = self.exponent.min(o.exponent);
        let spread = (self.exponent - o.exponent).abs();
        if spread > 900 && self.mantissa != IBig::ZERO && o.mantissa != IBig::ZERO {
            let (large, small, sign) = if self.exponent > o.exponent {
                (self, o, false)
            } else {
                (o, self, negate)
            };
            let lost = ldexp(size(&small.mantissa) + small.error, -power(spread));
            return Self {
                mantissa: if sign {
                    -&large.mantissa
                } else {
                    large.mantissa.clone()
                },
                exponent: large.exponent,
                error: (large.error + lost + f64::MIN_POSITIVE) * UP,
            };
        }
        let (a, e) = if self.mantissa == IBig::ZERO && self.error <= 0.0 {
            (IBig::ZERO, 0.0)
        } else {
            self.lowered(exponent)
        };
        let (b, f) = if o.mantissa == IBig::ZERO && o.error <= 0.0 {
            (IBig::ZERO, 0.0)
        } else {
            o.lowered(exponent)
        };
        let mantissa = if negate { a - b } else { a + b };
        Self {
            mantissa,
            exponent,
            error: (e + f) * UP,
        }
        .cut()
    }

    /// The quotient; the bound is infinite if the divisor may be zero.
    #[must_use]
    pub fn div(&self, o: &Self) -> Self {
        let unknown = Self {
            mantissa: IBig::ZERO,
            exponent: 0,
            error: f64::INFINITY,
        };
        // A lower bound of the divisor's size less its error, rounded down.
        let least = (least(&o.mantissa) - o.error * UP) / UP;
        if o.mantissa == IBig::ZERO || least.is_nan() || least <= 0.0 {
            return unknown;
        }
        let up = (DIGITS + bits(&o.mantissa)).saturating_sub(bits(&self.mantissa));
        let mantissa = (&self.mantissa << up) / &o.mantissa;
        // |q'| = |(n + dn) / (m + dm)|, so |q' - q| <= (dn + |q| dm) / (|m| - dm), and the
        // integer division rounds by less than one.
        let error =
            (ldexp(self.error, power(up)) + size(&mantissa) * o.error) / least * UP * UP + 1.0;
        Self {
            mantissa,
            exponent: self.exponent - o.exponent - up as i64,
            error: error * UP,
        }
        .cut()
    }

    /// The root of a quantity that is not negative.
    #[must_use]
    pub fn sqrt(&self) -> Self {
        if self.mantissa <= IBig::ZERO {
            let high = (size(&self.mantissa) + self.error) * UP;
            if high <= 0.0 {
                return Self::zero();
            }
            // The root of something between 0 and high.
            let odd = self.exponent.rem_euclid(2);
            #[expect(clippy::disallowed_methods, reason = "rounded up")]
            let root = (high * if odd == 1 { 2.0 } else { 1.0 }).sqrt() * UP;
            return Self {
                mantissa: IBig::ZERO,
                exponent: (self.exponent - odd) / 2,
                error: root,
            };
        }
        let length = bits(&self.mantissa);
        let mut up = (2 * DIGITS).saturating_sub(length);
        if (self.exponent - up as i64).rem_euclid(2) != 0 {
            up += 1;
        }
        let radicand = (&self.mantissa << up).unsigned_abs();
        let root = radicand.sqrt();
        let exact = self.error <= 0.0 && &root * &root == radicand;
        let mantissa = IBig::from(root);
        let scaled = ldexp(self.error, power(up));
        // |sqrt(a + d) - sqrt(a)| <= |d| / sqrt(a) for a + d >= 0, and sqrt(a) >= root.
        let error = if exact {
            0.0
        } else {
            (scaled / least(&mantissa) * UP + 1.0) * UP
        };
        Self {
            mantissa,
            exponent: (self.exponent - up as i64) / 2,
            error,
        }
        .cut()
    }

    /// The same as a double-double.
    #[must_use]
    pub fn to_ball_dd(&self) -> BallDd {
        let drop = bits(&self.mantissa).saturating_sub(100);
        let mut error = ldexp(self.error, -power(drop));
        // Shifting rounds down: at most one unit.
        if drop > 0 {
            error = (error + 1.0) * UP;
        }
        let exponent = i32::try_from(self.exponent + drop as i64).unwrap_or(i32::MAX);
        BallDd::from_int(&(&self.mantissa >> drop))
            .plus(&BallDd::new(0.0, 0.0, error))
            .ldexp(exponent)
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
            mantissa: IBig::ZERO,
            exponent: 0,
            error: 0.0,
        }
    }
    fn from_i64(i: i64) -> Self {
        Self {
            mantissa: IBig::from(i),
            exponent: 0,
            error: 0.0,
        }
    }
    fn plus(&self, o: &Self) -> Self {
        self.sum(o, false)
    }
    fn minus(&self, o: &Self) -> Self {
        self.sum(o, true)
    }
    fn times(&self, o: &Self) -> Self {
        let error = if self.error <= 0.0 && o.error <= 0.0 {
            0.0
        } else {
            let (a, b) = (size(&self.mantissa), size(&o.mantissa));
            (a * o.error + b * self.error + self.error * o.error) * UP
        };
        Self {
            mantissa: &self.mantissa * &o.mantissa,
            exponent: self.exponent + o.exponent,
            error: if error.is_nan() { f64::INFINITY } else { error },
        }
        .cut()
    }
    fn negated(&self) -> Self {
        Self {
            mantissa: -&self.mantissa,
            exponent: self.exponent,
            error: self.error,
        }
    }
    fn sign(&self) -> Option<Sign> {
        if self.error <= 0.0 {
            return Some(Sign::from(self.mantissa.cmp(&IBig::ZERO)));
        }
        (least(&self.mantissa) > self.error).then(|| Sign::from(self.mantissa.cmp(&IBig::ZERO)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Surd;

    fn random(state: &mut u64) -> i64 {
        *state ^= *state << 13;
        *state ^= *state >> 7;
        *state ^= *state << 17;
        (*state >> 3) as i64 - (1 << 60)
    }

    #[test]
    fn signs_are_those_of_exact_numbers() {
        let seed = 0x1234_5678_9abc_def1;
        println!("seed {seed:#x}");
        let mut state = seed;
        let mut abstained = 0;
        for round in 0..3000 {
            let size = 1 << (round % 61);
            let mut next = || random(&mut state) % size;
            let [a, b, c, d] = [next(), next(), next(), next()];
            let [r, s] = [next().unsigned_abs() + 1, next().unsigned_abs() + 1];
            let wide = |i: i64| Wide::from_int(&IBig::from(i));
            let surd = |i: i64| Surd::from_int(IBig::from(i));
            let (u, v) = (Wide::sqrt_of(&UBig::from(r)), Wide::sqrt_of(&UBig::from(s)));
            let (x, y) = (Surd::sqrt_of(&UBig::from(r)), Surd::sqrt_of(&UBig::from(s)));
            // (a + b sqrt r)(c + d sqrt s) - (its rounded value), many times over
            let p = wide(a)
                .plus(&wide(b).times(&u))
                .times(&wide(c).plus(&wide(d).times(&v)));
            let q = surd(a)
                .plus(&surd(b).times(&x))
                .times(&surd(c).plus(&surd(d).times(&y)));
            let (p, q) = (p.times(&p).minus(&wide(c)), q.times(&q).minus(&surd(c)));
            match p.sign() {
                Some(sign) => assert_eq!(Some(sign), q.sign(), "{a} {b} {c} {d} {r} {s}"),
                None => abstained += 1,
            }
        }
        assert!(abstained < 30, "{abstained} of 3000 undecided");
    }

    #[test]
    fn leading_digits_are_those_of_the_integer() {
        for shift in [0, 1, 10, 11, 12, 51, 52, 63, 64, 65, 75, 76, 127, 128, 300] {
            for odd in [1, 3, (1_i64 << 52) - 1, (1 << 52) + 1, i64::MAX] {
                let m = IBig::from(-odd) << shift;
                let length = 64 - odd.leading_zeros() as usize + shift;
                assert_eq!(bits(&m), length, "{odd} << {shift}");
                let (top, cut) = leading(&m);
                assert_eq!(cut, length as i32 - 52.min(length as i32));
                assert_eq!(
                    IBig::from(top as i64),
                    -m >> cut as usize,
                    "{odd} << {shift}"
                );
            }
        }
        assert_eq!((bits(&IBig::ZERO), leading(&IBig::ZERO)), (0, (0.0, 0)));
    }

    #[test]
    fn what_is_lost_far_below_is_remembered() {
        // 2^-760 is a mantissa of 400 digits times 2^-1160. Beside one it is an error, and 2^-1160 no f64.
        let one = Wide::from_i64(1);
        let power = |k: usize| Wide::from_int(&(IBig::ONE << k));
        let tiny = one.div(&power(380)).div(&power(380));
        // The root of 2^-760 is above 2^-390.
        let root = one.plus(&tiny).minus(&one).sqrt();
        assert_eq!(root.minus(&one.div(&power(390))).sign(), None);
    }

    #[test]
    fn quotients_and_roots_enclose() {
        let mut state = 99;
        for _ in 0..2000 {
            let [a, b] = [random(&mut state), random(&mut state) | 1];
            let (p, q) = (
                Wide::from_int(&IBig::from(a)),
                Wide::from_int(&IBig::from(b)),
            );
            // (a / b) b - a is zero, so its sign must not be claimed to be anything else.
            let back = p.div(&q).times(&q).minus(&p);
            assert!(matches!(back.sign(), None | Some(Sign::Zero)), "{a} / {b}");
            let root = Wide::sqrt_of(&UBig::from(a.unsigned_abs()));
            let back = root
                .times(&root)
                .minus(&Wide::from_int(&IBig::from(a).unsigned_abs().into()));
            assert!(matches!(back.sign(), None | Some(Sign::Zero)), "sqrt {a}");
            let near = p.div(&q).to_ball_dd();
            assert!(near.error() <= ldexp(near.value().abs(), -90));
            let back = near
                .times(&BallDd::from_int(&IBig::from(b)))
                .minus(&BallDd::from_int(&IBig::from(a)));
            assert!(matches!(back.sign(), None | Some(Sign::Zero)), "{a} / {b}");
            let near = p.plus(&Wide::from_i64(1)).div(&q).minus(&p.div(&q));
            assert_eq!(
                near.sign(),
                Some(if b > 0 {
                    Sign::Positive
                } else {
                    Sign::Negative
                })
            );
        }
        assert!(!Wide::from_i64(1).div(&Wide::zero()).is_bounded());
    }
}
