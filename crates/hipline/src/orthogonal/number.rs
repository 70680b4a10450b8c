//! Exact coordinates: multiples of one power of two, twice as many as the input needs.
//!
//! All that a skeleton of this kind consists of are sums of at most four coordinates of the input, halved.
//! So, counted in halves of the finest unit of the input, everything is an integer a few binary digits longer than
//! the input's. While that fits into the 53 digits of an f64, all sums of f64s are exact, and nothing needs to be converted
//! ([`Float`]); otherwise it is an `i64` for most figures, an `i128` for most others, and [`Wide`] for any.

use hipline_num::{common_unit, power_of_two};
use std::{
    cmp::Ordering,
    fmt::Debug,
    ops::{Add, Neg, Sub},
};

/// A type that holds all coordinates of a figure exactly.
pub(super) trait Number:
    Copy + Ord + Debug + Add<Output = Self> + Sub<Output = Self> + Neg<Output = Self>
{
    /// Binary digits that coordinates of the input may have, in the finest unit: sums of four,
    /// doubled, fit.
    const DIGITS: i32;
    const ZERO: Self;
    /// A coordinate of the figure. Exact.
    fn count(unit: &Unit, x: f64) -> Self;
    /// The f64 nearest to a coordinate; of two, the even one.
    fn value(self, unit: &Unit) -> f64;
    /// Half of an even number.
    fn half(self) -> Self;
}

/// A number of halves of a unit.
trait Integer: Copy {
    /// An integer that is not larger than announced.
    fn of(x: f64) -> Self;
    /// The nearest f64; of two, the even one.
    fn round(self) -> f64;
}

/// A coordinate as it is, where all of them have few digits.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Float(f64);

impl Eq for Float {}

impl Ord for Float {
    #[inline]
    fn cmp(&self, other: &Self) -> Ordering {
        // There is no other than finite numbers, and only one zero.
        if self.0 < other.0 {
            Ordering::Less
        } else if self.0 > other.0 {
            Ordering::Greater
        } else {
            Ordering::Equal
        }
    }
}

impl PartialOrd for Float {
    #[inline]
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Add for Float {
    type Output = Self;
    #[inline]
    fn add(self, other: Self) -> Self {
        Self(self.0 + other.0)
    }
}

impl Sub for Float {
    type Output = Self;
    #[inline]
    fn sub(self, other: Self) -> Self {
        Self(self.0 - other.0)
    }
}

impl Neg for Float {
    type Output = Self;
    #[inline]
    fn neg(self) -> Self {
        Self(-self.0)
    }
}

impl Number for Float {
    const DIGITS: i32 = 49;
    const ZERO: Self = Self(0.0);
    #[inline]
    fn count(_: &Unit, x: f64) -> Self {
        Self(x)
    }
    #[inline]
    fn value(self, _: &Unit) -> f64 {
        // There is only one zero.
        self.0 + 0.0
    }
    #[inline]
    fn half(self) -> Self {
        Self(0.5 * self.0)
    }
}

macro_rules! machine_integer {
    ($integer:ty, $digits:literal) => {
        impl Number for $integer {
            const DIGITS: i32 = $digits;
            const ZERO: Self = 0;
            #[inline]
            fn count(unit: &Unit, x: f64) -> Self {
                unit.count(x)
            }
            #[inline]
            fn value(self, unit: &Unit) -> f64 {
                unit.value(self)
            }
            #[inline]
            fn half(self) -> Self {
                self >> 1
            }
        }

        impl Integer for $integer {
            #[inline]
            fn of(x: f64) -> Self {
                x as Self
            }
            #[inline]
            fn round(self) -> f64 {
                self as f64
            }
        }
    };
}

machine_integer!(i64, 58);
machine_integer!(i128, 122);

/// Machine words in [`Wide`]: 512 binary digits, where the range of a figure's coordinates needs less than 400.
const WORDS: usize = 8;

/// An integer in two's complement, least word first.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Wide([u64; WORDS]);

impl Wide {
    const fn is_negative(self) -> bool {
        self.0[WORDS - 1] >> 63 == 1
    }
}

impl Ord for Wide {
    fn cmp(&self, other: &Self) -> Ordering {
        other
            .is_negative()
            .cmp(&self.is_negative())
            .then_with(|| self.0.iter().rev().cmp(other.0.iter().rev()))
    }
}

impl PartialOrd for Wide {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Add for Wide {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        let mut sum = [0; WORDS];
        let mut carry = 0;
        for (k, word) in sum.iter_mut().enumerate() {
            let total = u128::from(self.0[k]) + u128::from(other.0[k]) + carry;
            *word = total as u64;
            carry = total >> 64;
        }
        Self(sum)
    }
}

impl Neg for Wide {
    type Output = Self;
    fn neg(self) -> Self {
        let mut one = [0; WORDS];
        one[0] = 1;
        Self(self.0.map(|word| !word)) + Self(one)
    }
}

impl Sub for Wide {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Number for Wide {
    const DIGITS: i32 = 505;
    const ZERO: Self = Self([0; WORDS]);
    fn count(unit: &Unit, x: f64) -> Self {
        unit.count(x)
    }
    fn value(self, unit: &Unit) -> f64 {
        unit.value(self)
    }
    fn half(self) -> Self {
        let mut words = self.0;
        // The sign stays.
        let mut above = self.0[WORDS - 1] & 1 << 63;
        for word in words.iter_mut().rev() {
            let half = *word >> 1 | above;
            above = *word << 63;
            *word = half;
        }
        Self(words)
    }
}

impl Integer for Wide {
    fn of(x: f64) -> Self {
        let exponent = (x.to_bits() >> 52 & 0x7ff) as usize;
        if exponent < 1023 {
            return Self::ZERO;
        }
        let mantissa = x.to_bits() & ((1 << 52) - 1) | 1 << 52;
        let mut words = [0; WORDS];
        // x is mantissa * 2^(exponent - 1075), an integer.
        if exponent < 1075 {
            words[0] = mantissa >> (1075 - exponent);
        } else {
            let shift = exponent - 1075;
            let shifted = u128::from(mantissa) << (shift % 64);
            words[shift / 64] = shifted as u64;
            if shift / 64 + 1 < WORDS {
                words[shift / 64 + 1] = (shifted >> 64) as u64;
            }
        }
        if x < 0.0 { -Self(words) } else { Self(words) }
    }
    fn round(self) -> f64 {
        let size = if self.is_negative() { -self } else { self };
        let Some(top) = size.0.iter().rposition(|&word| word != 0) else {
            return 0.0;
        };
        // Two words, and whether anything is below them, in the last binary digit: as those two words
        // have at least 65 digits, that is below the half that rounding looks at.
        let low = top.saturating_sub(1);
        let mut head = u128::from(size.0[low]);
        if top > low {
            head |= u128::from(size.0[top]) << 64;
        }
        if size.0[..low].iter().any(|&word| word != 0) {
            head |= 1;
        }
        let mut rounded = head as f64;
        for _ in 0..low {
            rounded *= 18_446_744_073_709_551_616.0;
        }
        if self.is_negative() {
            -rounded
        } else {
            rounded
        }
    }
}

/// The unit in which a figure is computed: how its coordinates become integers and back.
#[derive(Debug, Clone, Copy)]
pub(super) struct Unit {
    /// Two factors each, because one might not be an f64.
    up: [f64; 2],
    down: [f64; 2],
    /// Binary digits of the largest coordinate, in the finest unit.
    pub digits: i32,
    /// Whether the digits are all that keeps coordinates from being an f64: none is too small, none too large.
    pub is_moderate: bool,
}

/// Whether all coordinates are integers of few digits, as [`Float`] takes them: asked first, because it costs next to nothing.
pub(super) fn are_small_integers(points: &[[f64; 2]]) -> bool {
    // A sum of this size has no digits behind the point, and ends in those of the integer.
    const SIZE: f64 = 1.5 * (1_u64 << 52) as f64;
    const LIMIT: u64 = 1 << Float::DIGITS;
    // Zero if it is one. No branches, so that several are asked at once.
    let fault = |x: f64| {
        let sum = x + SIZE;
        let integer = sum.to_bits().wrapping_sub(SIZE.to_bits());
        (integer.wrapping_add(LIMIT) / (2 * LIMIT)) | (sum - SIZE - x).to_bits()
    };
    points.chunks(1024).all(|some| {
        some.iter()
            .fold(0, |all, &[x, y]| all | fault(x) | fault(y))
            == 0
    })
}

impl Unit {
    /// The unit of integers.
    pub(super) const ONE: Self = Self {
        up: [2.0, 1.0],
        down: [0.5, 1.0],
        digits: Float::DIGITS,
        is_moderate: true,
    };

    /// The finest unit that a list of points needs.
    pub(super) fn of(points: &[[f64; 2]]) -> Self {
        let (finest, digits) = common_unit(points.iter().flatten().copied());
        let halves = |exponent: i32| [exponent / 2, exponent - exponent / 2].map(power_of_two);
        Self {
            up: halves(1 - finest),
            down: halves(finest - 1),
            digits,
            is_moderate: finest > -1000 && finest + digits < 1000,
        }
    }

    /// A coordinate in halves of the unit. Exact.
    #[inline]
    fn count<N: Integer>(&self, x: f64) -> N {
        N::of(x * self.up[0] * self.up[1])
    }

    /// The f64 nearest to a number of halves of the unit.
    ///
    /// It is rounded once: either the number has more digits than an f64 and the product is no smaller than the
    /// input, or it has not, so that only the last product may round.
    #[inline]
    fn value<N: Integer>(&self, x: N) -> f64 {
        x.round() * self.down[0] * self.down[1]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn numbers() -> Vec<i128> {
        let mut list = vec![0, 1, -1, 3, 5, 7];
        for shift in [30, 52, 53, 54, 62, 63, 64, 65, 90, 110, 118] {
            for low in [-3, -1, 0, 1, 2, 3, 1 << 10, (1 << 20) + 1] {
                list.push((1_i128 << shift) + low);
                list.push(-(1_i128 << shift) * 3 + low);
            }
        }
        list
    }

    /// The wide integer of a narrow one, by way of f64s.
    fn wide(mut x: i128) -> Wide {
        let mut sum = Wide::ZERO;
        while x != 0 {
            sum = sum + Wide::of(x as f64);
            x -= x as f64 as i128;
        }
        sum
    }

    #[test]
    fn wide_integers_are_like_narrow_ones() {
        for a in numbers() {
            assert_eq!(
                wide(a).round().to_bits(),
                Integer::round(a).to_bits(),
                "{a}"
            );
            assert_eq!((wide(a) + wide(a)).half(), wide(a), "{a}");
            for b in numbers() {
                assert_eq!(wide(a) + wide(b), wide(a + b), "{a} + {b}");
                assert_eq!(wide(a) - wide(b), wide(a - b), "{a} - {b}");
                assert_eq!(wide(a).cmp(&wide(b)), a.cmp(&b), "{a} and {b}");
            }
        }
    }

    #[test]
    fn small_integers_are_told_from_others() {
        let limit = (1_u64 << Float::DIGITS) as f64;
        let small = [0.0, 1.0, -1.0, 12_345.0, limit - 1.0, 1.0 - limit];
        let others = [
            0.5,
            -0.125,
            limit - 0.5,
            limit,
            -limit - 1.0,
            4.0 * limit,
            8.0 * limit,
            -3.0 * limit,
            64.0 * limit,
            1e-300,
            5e-324,
            1e300,
            -1e300,
        ];
        assert!(are_small_integers(&small.map(|x| [x, -x])));
        for other in others {
            assert!(!are_small_integers(&[[0.0, 1.0], [2.0, other]]), "{other}");
            assert!(!are_small_integers(&[[other, 1.0]]), "{other}");
        }
        let mut many = vec![[1.0, 2.0]; 3000];
        assert!(are_small_integers(&many));
        many[2500][1] = 0.5;
        assert!(!are_small_integers(&many));
    }

    #[test]
    fn sums_of_floats_are_those_of_integers() {
        let limit = (1_i64 << Float::DIGITS) - 1;
        let values = [0, 1, 2, 3, 1 << 40, limit - 1, limit, -1, -7, -limit];
        let float = |x: i64| Float::count(&Unit::ONE, x as f64);
        for a in values {
            for b in values {
                for c in values {
                    let sum = (float(a) + float(b) - (-float(c) + float(b))).half();
                    let due = Number::half(2 * (a + b - (b - c)));
                    let due: f64 = i64::value(due, &Unit::ONE);
                    assert_eq!(sum.value(&Unit::ONE).to_bits(), due.to_bits());
                    assert_eq!((float(a) + float(b)).cmp(&float(c)), (a + b).cmp(&c));
                }
            }
        }
    }

    #[test]
    fn coordinates_come_back() {
        let lists: [&[f64]; 5] = [
            &[0.0],
            &[1.0, -3.0, 1024.0],
            &[0.1, 0.3, 1000.7],
            &[5e-324, 3e-310, 1e-290],
            &[1e300, -7e290],
        ];
        for list in lists {
            let points: Vec<[f64; 2]> = list.iter().map(|&x| [x, -x]).collect();
            let unit = Unit::of(&points);
            for &x in list {
                assert!(unit.digits <= Wide::DIGITS, "{list:?}");
                let count: Wide = unit.count(x);
                assert_eq!(unit.value(count).to_bits(), x.to_bits(), "{x}");
                assert_eq!(Float::count(&unit, x).value(&unit).to_bits(), x.to_bits());
                if unit.digits <= i64::DIGITS {
                    let count: i64 = unit.count(x);
                    assert_eq!(unit.value(count).to_bits(), x.to_bits(), "{x}");
                }
            }
        }
    }
}
