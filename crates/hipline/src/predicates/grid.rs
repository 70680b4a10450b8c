//! From f64 coordinates to integers on a common grid, and from those to double-double.

use dashu_int::IBig;
use hipline_num::{BallDd, odd_parts};

use super::planes::Rung;

/// As [`in_units`](hipline_num::in_units), in a machine integer, which has to hold it.
pub(super) fn small_in_units(x: f64, unit: i32) -> i64 {
    let (mantissa, exponent) = odd_parts(x);
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

/// The root of a perfect square.
pub(super) fn small_root(square: u128) -> Option<u128> {
    // Squares end in one of twelve patterns of six bits.
    const RESIDUES: u64 = 0x0202_0212_0203_0213;
    if RESIDUES >> (square & 63) & 1 == 0 {
        return None;
    }
    let root = square.isqrt();
    (root * root == square).then_some(root)
}

/// An integer in double-double, without its last `shift` binary digits.
#[expect(
    clippy::cast_precision_loss,
    clippy::cast_possible_truncation,
    reason = "the rest is kept"
)]
pub(super) fn near(value: i128, shift: i32) -> BallDd {
    // Machine words do for most.
    if let Ok(word) = i64::try_from(value)
        && word.unsigned_abs() < 1 << 62
    {
        let high = word as f64;
        let low = (word - high as i64) as f64;
        let error = if shift == 0 || word == 0 {
            0.0
        } else {
            high.abs() * (2.0 * TINY)
        };
        return BallDd::new(high, low, error).ldexp(-shift);
    }
    let high = value as f64;
    let rest = value - high as i128;
    let low = rest as f64;
    let lost = (rest - low as i128).unsigned_abs() as f64;
    // After a shift the value need not be an integer, which error 0 would claim.
    let error = if shift == 0 || value == 0 {
        lost
    } else {
        lost.max(high.abs() * TINY)
    };
    BallDd::new(high, low, error * 2.0).ldexp(-shift)
}

/// The same of any integer.
pub(super) fn near_big(value: &IBig, shift: i32) -> BallDd {
    match i128::try_from(value) {
        Ok(value) if value.unsigned_abs() < 1 << 126 => near(value, shift),
        _ => <BallDd as Rung>::integer(value, shift),
    }
}

/// One part in 2^104.
const TINY: f64 = 1.0 / (1_u128 << 104) as f64;
