//! f64 numbers as integers times powers of two.

use dashu_int::{IBig, UBig, ops::BitTest};

/// The f64 nearest to 2^k: itself for −1074 ≤ k ≤ 1023, subnormal or not; 0 below that, infinite above.
///
/// `2.0_f64.powi(k)` is another number for some k, and need not be the same one on every platform.
///
/// ```
/// use hipline_num::power_of_two;
/// assert_eq!(power_of_two(-1), 0.5);
/// assert_eq!(power_of_two(-1074), f64::from_bits(1));
/// assert_eq!(power_of_two(1024), f64::INFINITY);
/// ```
#[inline]
#[must_use]
pub const fn power_of_two(k: i32) -> f64 {
    match k {
        ..-1074 => 0.0,
        -1074..-1022 => f64::from_bits(1 << (k + 1074)),
        -1022..1024 => f64::from_bits(((k + 1023) as u64) << 52),
        1024.. => f64::INFINITY,
    }
}

/// `x * 2^k` for any k, rounded only if the result is subnormal or too large.
///
/// A result that is subnormal may be rounded more than once: the error is below 2^-1074.
///
/// ```
/// use hipline_num::ldexp;
/// assert_eq!(ldexp(0.75, 3), 6.0);
/// assert_eq!(ldexp(5e-324, 2097), 2.0_f64.powi(1023));
/// ```
#[inline]
#[must_use]
pub fn ldexp(x: f64, k: i32) -> f64 {
    if (-1022..=1023).contains(&k) {
        return x * power_of_two(k);
    }
    let mut x = x;
    let mut k = k.clamp(-2200, 2200);
    while k > 1023 {
        x *= power_of_two(1023);
        k -= 1023;
    }
    while k < -1022 {
        x *= power_of_two(-1022);
        k += 1022;
    }
    x * power_of_two(k)
}

/// The k with 2^k ≤ |x| < 2^(k+1), subnormal or not; −1075 for zero, and 1024 for what is not finite.
///
/// Unlike the logarithm of a library, it is the same on every platform.
///
/// ```
/// use hipline_num::exponent;
/// assert_eq!([8.0, 7.9, -0.5, 5e-324].map(exponent), [3, 2, -1, -1074]);
/// ```
#[inline]
#[must_use]
pub const fn exponent(x: f64) -> i32 {
    let (m, t) = magnitude_parts(x);
    t + 63 - m.leading_zeros() as i32
}

/// Whether the finite number `x` is an integer.
#[inline]
pub(crate) fn is_integer(x: f64) -> bool {
    // From 2^52 on, neighbouring f64 numbers differ by at least 1.
    x.abs() >= 4_503_599_627_370_496.0 || (x as i64 as f64).to_bits() == (x + 0.0).to_bits()
}

/// The mantissa (with its leading bit) and exponent of |x|: |x| = m·2^t, where 2^t is also
/// the distance to the next larger f64. Infinity reads as 2^1024.
#[inline]
pub(crate) const fn magnitude_parts(x: f64) -> (u64, i32) {
    let bits = x.to_bits();
    let biased = ((bits >> 52) & 0x7ff) as i32;
    let fraction = bits & ((1 << 52) - 1);
    if biased == 0 {
        (fraction, -1074)
    } else {
        (fraction | 1 << 52, biased - 1075)
    }
}

/// The finite number `x` as `m * 2^t` with m odd, or (0, 0).
///
/// # Panics
///
/// If `x` is infinite or not a number.
///
/// ```
/// assert_eq!(hipline_num::odd_parts(-0.75), (-3, -2));
/// ```
#[inline]
#[must_use]
pub fn odd_parts(x: f64) -> (i64, i32) {
    assert!(x.is_finite(), "{x} is no dyadic rational");
    let (m, t) = magnitude_parts(x);
    if m == 0 {
        return (0, 0);
    }
    let zeros = m.trailing_zeros();
    let odd = (m >> zeros) as i64;
    (if x < 0.0 { -odd } else { odd }, t + zeros as i32)
}

/// The same with an integer of any size.
///
/// # Panics
///
/// If `x` is infinite or not a number.
///
/// ```
/// use hipline_num::{IBig, f64_to_parts};
/// assert_eq!(f64_to_parts(-0.75), (IBig::from(-3), -2));
/// ```
#[must_use]
pub fn f64_to_parts(x: f64) -> (IBig, i32) {
    let (m, t) = odd_parts(x);
    (IBig::from(m), t)
}

/// The largest k such that all of these numbers are multiples of 2^k, and how many digits the largest
/// of them has over it; (0, 0) if all are zero.
///
/// # Panics
///
/// If a number is infinite or not a number.
///
/// ```
/// assert_eq!(hipline_num::common_unit([3.0, 0.0, -0.75]), (-2, 4));
/// ```
#[must_use]
pub fn common_unit(numbers: impl IntoIterator<Item = f64>) -> (i32, i32) {
    let used = numbers.into_iter().filter(|&x| x != 0.0);
    let (low, high) = used.fold((i32::MAX, i32::MIN), |(low, high), x| {
        (low.min(odd_parts(x).1), high.max(exponent(x) + 1))
    });
    if low == i32::MAX {
        (0, 0)
    } else {
        (low, high - low)
    }
}

/// The number `x / 2^unit`, which has to be an integer: as it is if `unit` is not above the
/// [`common_unit`] of some numbers among which `x` is.
///
/// # Panics
///
/// If `x` is infinite or not a number; or if it is no multiple of 2^unit.
///
/// ```
/// use hipline_num::{IBig, in_units};
/// assert_eq!(in_units(-0.75, -3), IBig::from(-6));
/// ```
#[must_use]
pub fn in_units(x: f64, unit: i32) -> IBig {
    let (m, t) = odd_parts(x);
    if m == 0 {
        return IBig::ZERO;
    }
    let digits = usize::try_from(t - unit).expect("a multiple of the unit");
    IBig::from(m) << digits
}

/// The k with 2^k ≤ n < 2^(k+1), or `None` for zero.
#[must_use]
pub fn ilog2(n: &UBig) -> Option<usize> {
    n.bit_len().checked_sub(1)
}

#[cfg(test)]
#[allow(clippy::float_cmp, reason = "these results are exact")]
mod tests {
    use super::*;

    #[test]
    fn powers_of_two_are_the_nearest_ones() {
        let mut power = 1.0_f64;
        for k in 0..1024 {
            assert_eq!(power_of_two(k), power, "2^{k}");
            power *= 2.0;
        }
        assert_eq!(power, f64::INFINITY);
        assert_eq!([1024, i32::MAX].map(power_of_two), [power; 2]);
        let mut power = 1.0_f64;
        for k in 0..1075 {
            assert_eq!(power_of_two(-k), power, "2^-{k}");
            power /= 2.0;
        }
        assert_eq!(power, 0.0);
        assert_eq!([-1075, i32::MIN].map(power_of_two), [power; 2]);
    }

    #[test]
    fn exponents_are_those_of_the_leading_bit() {
        for k in -1074..1024 {
            let power = power_of_two(k);
            assert_eq!([power, -power].map(exponent), [k; 2], "2^{k}");
            let below = if k == -1074 { -1075 } else { k - 1 };
            assert_eq!(exponent(power.next_down()), below, "below 2^{k}");
        }
        assert_eq!([0.0, -0.0].map(exponent), [-1075; 2]);
        assert_eq!(exponent(f64::MAX), 1023);
        assert_eq!([f64::INFINITY, f64::NAN].map(exponent), [1024; 2]);
        let below = f64::MIN_POSITIVE.next_down();
        assert_eq!([f64::MIN_POSITIVE, below].map(exponent), [-1022, -1023]);
    }

    #[test]
    fn scaling_reaches_everything() {
        for (x, k, y) in [
            (3.0, -2, 0.75),
            (power_of_two(1023), -2097, 5e-324),
            (5e-324, 2097, power_of_two(1023)),
            (-5e-324, 2098, f64::NEG_INFINITY),
            (1.0, i32::MAX, f64::INFINITY),
            (f64::MAX, i32::MIN, 0.0),
            (0.0, i32::MAX, 0.0),
            (1.5, -1074, 1e-323),
            (power_of_two(400), -1100, power_of_two(-700)),
        ] {
            assert_eq!(ldexp(x, k), y, "{x} {k}");
        }
    }

    #[test]
    fn parts_and_units() {
        assert_eq!(odd_parts(5e-324), (1, -1074));
        assert_eq!(odd_parts(f64::MAX), ((1 << 53) - 1, 971));
        assert_eq!([0.0, -0.0].map(odd_parts), [(0, 0); 2]);
        assert_eq!(common_unit([]), (0, 0));
        assert_eq!(common_unit([0.0, -0.0]), (0, 0));
        assert_eq!(common_unit([-12.0]), (2, 2));
        assert_eq!(common_unit([5e-324, f64::MAX]), (-1074, 2098));
        assert_eq!(in_units(-0.0, 5), IBig::ZERO);
        assert_eq!(in_units(12.0, 2), IBig::from(3));
        let most = in_units(f64::MAX, -1074);
        assert_eq!(most, IBig::from((1_i64 << 53) - 1) << 2045);
    }

    #[test]
    #[should_panic(expected = "a multiple of the unit")]
    fn what_is_no_multiple_of_the_unit_is_refused() {
        let _ = in_units(0.5, 0);
    }
}
