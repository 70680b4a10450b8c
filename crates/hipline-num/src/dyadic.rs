//! f64 numbers as an integer times a power of two.

use dashu_int::{IBig, UBig, ops::BitTest};

/// 2^k as an f64, for −1022 ≤ k ≤ 1023.
#[inline]
pub(crate) fn power_of_two(k: i32) -> f64 {
    debug_assert!((-1022..=1023).contains(&k), "2^{k} is not a normal f64");
    f64::from_bits(((k + 1023) as u64) << 52)
}

/// `x * 2^k`, rounded only if the result is subnormal or too large.
///
/// A result that is subnormal may be rounded more than once: the error is below 2^-1074.
#[inline]
pub(crate) fn scale(x: f64, k: i32) -> f64 {
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

/// Whether the finite number `x` is an integer.
#[inline]
pub(crate) fn is_integer(x: f64) -> bool {
    // From 2^52 on, neighbouring f64 numbers differ by at least 1.
    x.abs() >= 4_503_599_627_370_496.0 || (x as i64 as f64).to_bits() == (x + 0.0).to_bits()
}

/// The mantissa (with its leading bit) and exponent of |x|: |x| = m·2^t, where 2^t is also
/// the distance to the next larger f64. Infinity reads as 2^1024.
#[inline]
pub(crate) fn magnitude_parts(x: f64) -> (u64, i32) {
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
/// use hipline_num::{IBig, f64_to_parts};
/// assert_eq!(f64_to_parts(-0.75), (IBig::from(-3), -2));
/// ```
#[must_use]
pub fn f64_to_parts(x: f64) -> (IBig, i32) {
    assert!(x.is_finite(), "{x} is no dyadic rational");
    let (m, t) = magnitude_parts(x);
    if m == 0 {
        return (IBig::ZERO, 0);
    }
    let zeros = m.trailing_zeros();
    let odd = (m >> zeros) as i64;
    (
        IBig::from(if x < 0.0 { -odd } else { odd }),
        t + zeros as i32,
    )
}

/// The k with 2^k ≤ n < 2^(k+1), or `None` for zero.
#[must_use]
pub fn ilog2(n: &UBig) -> Option<usize> {
    n.bit_len().checked_sub(1)
}
