//! From f64 coordinates to integers on a common grid.

use dashu_int::IBig;

/// Mantissa and exponent, the mantissa odd or zero.
fn parts(x: f64) -> (i64, i32) {
    let bits = x.to_bits();
    let exponent = ((bits >> 52) & 0x7ff) as i32;
    let fraction = (bits & ((1 << 52) - 1)) as i64;
    let (mantissa, exponent) = if exponent == 0 {
        (fraction, -1074)
    } else {
        (fraction | 1 << 52, exponent - 1075)
    };
    if mantissa == 0 {
        return (0, 0);
    }
    let zeros = mantissa.trailing_zeros();
    let mantissa = mantissa >> zeros;
    (
        if x < 0.0 { -mantissa } else { mantissa },
        exponent + zeros as i32,
    )
}

/// The smallest exponent of the numbers, and the bit length of the largest over it.
pub(super) fn common_unit(numbers: impl Iterator<Item = f64>) -> (i32, i32) {
    let (mut low, mut high) = (i32::MAX, i32::MIN);
    for x in numbers {
        let (mantissa, exponent) = parts(x);
        if mantissa != 0 {
            low = low.min(exponent);
            high = high.max(exponent + 64 - mantissa.unsigned_abs().leading_zeros() as i32);
        }
    }
    if low == i32::MAX {
        (0, 0)
    } else {
        (low, high - low)
    }
}

pub(super) fn scaled(x: f64, unit: i32) -> IBig {
    let (mantissa, exponent) = parts(x);
    if mantissa == 0 {
        IBig::ZERO
    } else {
        IBig::from(mantissa) << (exponent - unit) as usize
    }
}

pub(super) fn scaled_small(x: f64, unit: i32) -> i64 {
    let (mantissa, exponent) = parts(x);
    if mantissa == 0 {
        0
    } else {
        mantissa << (exponent - unit)
    }
}

pub(super) fn gcd(mut a: u64, mut b: u64) -> u64 {
    if a == 0 || b == 0 {
        return a | b;
    }
    let shift = (a | b).trailing_zeros();
    a >>= a.trailing_zeros();
    while b != 0 {
        b >>= b.trailing_zeros();
        if a > b {
            std::mem::swap(&mut a, &mut b);
        }
        b -= a;
    }
    a << shift
}
