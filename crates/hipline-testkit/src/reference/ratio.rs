//! Quotients of exact numbers: comparison, and rounding to the nearest f64.

use std::cmp::Ordering;

use dashu_int::IBig;
use dashu_int::ops::{Abs, BitTest};

use super::number::{Field, Num};

/// Bits after the point of the enclosure that each quotient carries.
const BITS: usize = 64;

/// An exact quotient with positive denominator, and an integer enclosure of it.
///
/// The enclosure decides most comparisons; whenever it does not, exact numbers do.
#[derive(Debug, Clone)]
pub struct Ratio {
    top: Num,
    bottom: Num,
    lo: IBig,
    hi: IBig,
}

impl Ratio {
    /// Zero.
    pub(super) fn zero() -> Self {
        Self {
            top: Num::default(),
            bottom: IBig::ONE.into(),
            lo: IBig::ZERO,
            hi: IBig::ZERO,
        }
    }

    /// An integer.
    pub(super) fn integer(value: &IBig) -> Self {
        let scaled = value << BITS;
        Self {
            top: value.clone().into(),
            bottom: IBig::ONE.into(),
            lo: scaled.clone(),
            hi: scaled,
        }
    }

    /// The quotient; `None` if the denominator is zero.
    pub(super) fn new(field: &Field, top: Num, bottom: Num) -> Option<Self> {
        match field.sign(&bottom) {
            Ordering::Equal => None,
            Ordering::Greater => Some(Self::over_positive(field, top, bottom)),
            Ordering::Less => Some(Self::over_positive(
                field,
                top.opposite(),
                bottom.opposite(),
            )),
        }
    }

    /// The quotient by a number known to be positive.
    pub(super) fn over_positive(field: &Field, mut top: Num, mut bottom: Num) -> Self {
        if top.is_zero() {
            return Self::zero();
        }
        let gcd = top.content(bottom.content(IBig::ZERO));
        if gcd != IBig::ONE {
            top.shrink(&gcd);
            bottom.shrink(&gcd);
        }
        let mut bits = 96;
        let (lo, hi) = loop {
            let (low, high) = field.enclose(&bottom, bits);
            if low > IBig::ZERO && (&high - &low).bit_len() + BITS <= low.bit_len() {
                let (top_low, top_high) = field.enclose(&top, bits);
                let lo = floor_div(
                    &(&top_low << BITS),
                    if top_low < IBig::ZERO { &low } else { &high },
                );
                let hi = floor_div(
                    &(&top_high << BITS),
                    if top_high < IBig::ZERO { &high } else { &low },
                );
                break (lo, hi + IBig::ONE);
            }
            bits *= 2;
        };
        Self {
            top,
            bottom,
            lo,
            hi,
        }
    }

    /// Numerator and (positive) denominator.
    pub(super) const fn parts(&self) -> (&Num, &Num) {
        (&self.top, &self.bottom)
    }

    /// Which one is greater, exactly.
    pub(super) fn compare(&self, other: &Self, field: &Field) -> Ordering {
        if self.hi < other.lo {
            return Ordering::Less;
        }
        if self.lo > other.hi {
            return Ordering::Greater;
        }
        let left = field.mul(&self.top, &other.bottom);
        field.sign(&left.minus(&field.mul(&other.top, &self.bottom)))
    }

    /// The f64 nearest to the quotient times `2^exponent`.
    pub(super) fn round(&self, field: &Field, exponent: i64) -> f64 {
        if let Some((p, q)) = self.top.rational_ratio(&self.bottom) {
            return round_rational(&p, &q, exponent);
        }
        // Irrational: neither an f64 nor half way between two, so this ends.
        let mut bits = 128;
        loop {
            let (low, high) = field.enclose(&self.bottom, bits);
            let (top_low, top_high) = field.enclose(&self.top, bits);
            let same_sign = (top_low > IBig::ZERO) == (top_high > IBig::ZERO);
            if low > IBig::ZERO && same_sign {
                let negative = top_low < IBig::ZERO;
                let (for_low, for_high) = if negative {
                    (&low, &high)
                } else {
                    (&high, &low)
                };
                let below = round_rational(&top_low, for_low, exponent);
                let above = round_rational(&top_high, for_high, exponent);
                if below.to_bits() == above.to_bits() {
                    return below;
                }
            }
            bits *= 2;
        }
    }
}

/// `floor(a / b)` for positive `b`.
fn floor_div(a: &IBig, b: &IBig) -> IBig {
    let quotient = a / b;
    if *a < IBig::ZERO && &quotient * b != *a {
        quotient - IBig::ONE
    } else {
        quotient
    }
}

/// The f64 nearest to `p / q * 2^exponent`, ties to even. (Results below 2^-1022 may be off.)
fn round_rational(p: &IBig, q: &IBig, exponent: i64) -> f64 {
    if *p == IBig::ZERO {
        return 0.0;
    }
    let negative = (*p < IBig::ZERO) != (*q < IBig::ZERO);
    let (p, q) = (p.clone().abs(), q.clone().abs());
    let shift = 66 + q.bit_len() as i64 - p.bit_len() as i64;
    let (p, q) = if shift >= 0 {
        (p << shift as usize, q)
    } else {
        (p, q << (-shift) as usize)
    };
    let mut quotient = &p / &q;
    let exact = &quotient * &q == p;
    quotient <<= 1;
    if !exact {
        quotient += IBig::ONE;
    }
    let rounded = quotient.to_f64().value();
    let power = exponent - shift - 1;
    let half = power / 2;
    let value = rounded * power_of_two(half) * power_of_two(power - half);
    if negative { -value } else { value }
}

/// `2^exponent`, exactly.
fn power_of_two(exponent: i64) -> f64 {
    assert!(
        (-1022..=1023).contains(&exponent),
        "2^{exponent} is out of range"
    );
    f64::from_bits(((exponent + 1023) as u64) << 52)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn quotients_round_to_nearest() {
        let field = Field::new(&[IBig::from(2), IBig::from(3)]);
        let (one, two) = (Num::from(IBig::ONE), field.root(&IBig::from(2)));
        let root = Ratio::new(&field, two.clone(), one.clone()).expect("not zero");
        assert_eq!(
            root.round(&field, 0).to_bits(),
            std::f64::consts::SQRT_2.to_bits(),
            "root of 2"
        );
        let third = Ratio::new(&field, one.opposite(), IBig::from(3).into()).expect("not zero");
        assert_eq!(
            third.round(&field, 0).to_bits(),
            (-1.0_f64 / 3.0).to_bits(),
            "-1/3"
        );
        assert_eq!(
            third.round(&field, 4).to_bits(),
            (-16.0_f64 / 3.0).to_bits(),
            "-16/3"
        );
        let same = Ratio::new(
            &field,
            two.times(&IBig::from(-5)),
            two.times(&IBig::from(15)),
        )
        .expect("not zero");
        assert_eq!(
            same.compare(&third, &field),
            Ordering::Equal,
            "equal as reals"
        );
        assert_eq!(
            root.compare(&third, &field),
            Ordering::Greater,
            "1.41 > -0.33"
        );
        assert!(
            Ratio::new(&field, two, Num::default()).is_none(),
            "nothing over zero"
        );
    }

    /// Against the fast numbers, which share no code with these.
    #[test]
    fn rounding_agrees_with_the_fast_numbers() {
        use hipline_num::{Number, Surd, UBig, round_quotient};
        let radicands = [1_u32, 2, 5, 10, 13, 29, 4];
        let field = Field::new(&radicands.map(IBig::from));
        let mut random = crate::generate::Random::new(1);
        for round in 0..2000 {
            let mut sum = || {
                let (mut ours, mut theirs) = (Num::default(), Surd::from_int(IBig::ZERO));
                for _ in 0..=random.below(4) {
                    let radicand = *random.pick(&radicands);
                    let size = if random.one_in(3) { 1 << 60 } else { 20 };
                    let factor = IBig::from(random.range(-size, size));
                    ours = ours.plus(&field.root(&radicand.into()).times(&factor));
                    theirs = theirs.plus(&Surd::scaled_sqrt(factor, &UBig::from(radicand)));
                }
                (ours, theirs)
            };
            let ((p, p_theirs), (q, q_theirs)) = (sum(), sum());
            let Some(ratio) = Ratio::new(&field, p, q) else {
                continue;
            };
            let theirs = round_quotient(&p_theirs, &q_theirs, -3);
            let ours = ratio.round(&field, -3);
            assert_eq!(
                ours.to_bits(),
                (theirs + 0.0).to_bits(),
                "round {round}: {ours} {theirs}"
            );
        }
    }
}
