//! Correct rounding: the f64 nearest to p/q·2^exponent + origin, ties to even.
//!
//! The quotient of two surds is enclosed ever more tightly until both ends of the enclosure
//! round to the same f64. That fails to end only if the quotient is itself halfway between
//! two neighbouring f64 numbers; so once the ends round to neighbours, the quotient is
//! compared with the number halfway between them, exactly, and the matter is settled.

use crate::dyadic::{f64_to_parts, ldexp, magnitude_parts, power_of_two};
use crate::surd::Surd;
use crate::surd_sign::{Interval, sign_of};
use crate::{BallDd, Number, Sign, Wide};
use dashu_int::ops::{BitTest, DivRem, UnsignedAbs};
use dashu_int::{IBig, UBig};
use std::cmp::Ordering;

/// The f64 nearest to p/q·2^exponent, ties to even.
///
/// Subnormal results are rounded once; a result from 2^1024 − 2^970 on is infinite, as IEEE 754
/// has it; and zero, or what rounds to it, is +0.0, never −0.0.
///
/// # Panics
///
/// If q is zero.
///
/// ```
/// use hipline_num::{Number, Surd, UBig, round_quotient};
/// let root = Surd::sqrt_of(&UBig::from(2u8));
/// assert_eq!(round_quotient(&root, &Surd::from_i64(1), -1), std::f64::consts::FRAC_1_SQRT_2);
/// ```
#[must_use]
pub fn round_quotient(p: &Surd, q: &Surd, exponent: i32) -> f64 {
    by_double_double(p, q, exponent, 0.0).unwrap_or_else(|| round(p, q, exponent))
}

/// The f64 nearest to p/q·2^exponent + origin, ties to even, as [`round_quotient`].
///
/// # Panics
///
/// If q is zero or `origin` is not finite.
#[must_use]
pub fn round_quotient_plus(p: &Surd, q: &Surd, exponent: i32, origin: f64) -> f64 {
    let (offset, t) = f64_to_parts(origin);
    if offset.is_zero() {
        return round_quotient(p, q, exponent);
    }
    by_double_double(p, q, exponent, origin).unwrap_or_else(|| {
        let (p, scale) = add_dyadic(p, q, exponent, &offset, t);
        round(&p, q, scale)
    })
}

/// The answer of the filter, if it has one and is worth asking: integers are divided as fast.
fn by_double_double(p: &Surd, q: &Surd, exponent: i32, origin: f64) -> Option<f64> {
    if p.radicals() == 0 && q.radicals() == 0 {
        return None;
    }
    round_ball_dd_plus(&p.to_ball_dd(), &q.to_ball_dd(), exponent, origin)
}

/// p' and s with p/q·2^e + m·2^t = p'/q·2^s.
fn add_dyadic(p: &Surd, q: &Surd, e: i32, m: &IBig, t: i32) -> (Surd, i32) {
    let scale = e.min(t);
    let p = p.shifted(e.abs_diff(scale) as usize);
    let m = m << t.abs_diff(scale) as usize;
    (p.plus(&q.times_int(&m)), scale)
}

/// How p/q·2^exponent + origin compares with `value`, exactly.
///
/// # Panics
///
/// If q is zero, or `origin` or `value` is not finite.
#[must_use]
pub fn compare_quotient_f64(
    p: &Surd,
    q: &Surd,
    exponent: i32,
    origin: f64,
    value: f64,
) -> Ordering {
    let ((o, s), (v, t)) = (f64_to_parts(origin), f64_to_parts(value));
    let least = s.min(t);
    let shift = (o << s.abs_diff(least) as usize) - (v << t.abs_diff(least) as usize);
    let difference = if shift.is_zero() {
        p.exact_sign()
    } else {
        add_dyadic(p, q, exponent, &shift, least).0.exact_sign()
    };
    let divisor = q.exact_sign();
    assert!(!divisor.is_zero(), "the quotient has divisor zero");
    (difference * divisor).ordering()
}

fn round(p: &Surd, q: &Surd, exponent: i32) -> f64 {
    let exponent = i64::from(exponent);
    let divisor = q.exact_sign();
    assert!(!divisor.is_zero(), "the quotient has divisor zero");
    let sign = p.exact_sign() * divisor;
    let size = match (p.as_int(), q.as_int()) {
        _ if sign.is_zero() => 0.0,
        (Some(p), Some(q)) => round_ratio(&p.unsigned_abs(), &q.unsigned_abs(), exponent),
        _ => round_size(p, q, exponent),
    };
    // Adding +0.0 turns −0.0 into +0.0.
    (if sign.is_negative() { -size } else { size }) + 0.0
}

/// |p/q|·2^exponent rounded, for p and q that are not zero.
fn round_size(p: &Surd, q: &Surd, exponent: i64) -> f64 {
    // The relative width is about 2^-bits if nothing cancels, and a double-double has tried;
    // if something does, the loop goes on until the enclosure is good enough.
    let mut bits = 128;
    loop {
        if let (Some((pl, ph)), Some((ql, qh))) =
            (size_range(p.enclose(bits)), size_range(q.enclose(bits)))
        {
            let low = round_ratio(&pl, &qh, exponent);
            let high = round_ratio(&ph, &ql, exponent);
            if low.to_bits() == high.to_bits() {
                return low;
            }
            if low.to_bits() + 1 == high.to_bits() {
                return nearer(p, q, exponent, low, high);
            }
        }
        bits *= 2;
    }
}

/// The enclosure of the absolute value, if the enclosure excludes 0.
fn size_range(i: Interval) -> Option<(UBig, UBig)> {
    let (lo, hi) = match (sign_of(&i.lo), sign_of(&i.hi)) {
        (Sign::Positive, Sign::Positive) => (i.lo, i.hi),
        (Sign::Negative, Sign::Negative) => (i.hi, i.lo),
        _ => return None,
    };
    Some((lo.unsigned_abs(), hi.unsigned_abs()))
}

/// Of the neighbours low < high the one nearer to |p/q|·2^exponent, or the even one.
fn nearer(p: &Surd, q: &Surd, exponent: i64, low: f64, high: f64) -> f64 {
    let (mantissa, t) = magnitude_parts(low);
    // Halfway to the next f64: (2m + 1)·2^(t−1).
    let (half, t) = (IBig::from(2 * mantissa + 1), i64::from(t) - 1);
    let scale = exponent.min(t);
    let positive = |x: &Surd| {
        if x.exact_sign().is_negative() {
            x.negated()
        } else {
            x.clone()
        }
    };
    let p = positive(p).shifted((exponent - scale) as usize);
    let q = positive(q).times_int(&(half << (t - scale) as usize));
    match p.minus(&q).exact_sign() {
        Sign::Negative => low,
        Sign::Positive => high,
        Sign::Zero if mantissa % 2 == 0 => low,
        Sign::Zero => high,
    }
}

/// n/d·2^exponent rounded to nearest, ties to even, for n and d that are not zero.
fn round_ratio(n: &UBig, d: &UBig, exponent: i64) -> f64 {
    // A quotient of 66 or 67 bits, and whether anything is left of it.
    let shift = 66 + d.bit_len() as i64 - n.bit_len() as i64;
    let up = shift.unsigned_abs() as usize;
    let (quotient, rest) = if shift >= 0 {
        (n << up).div_rem(d)
    } else {
        n.div_rem(d << up)
    };
    let quotient = u128::try_from(&quotient).expect("a quotient of 67 bits");
    assemble(quotient, !rest.is_zero(), exponent - shift)
}

/// (m + δ)·2^e rounded, where 0 < δ < 1 if `sticky`, else δ = 0; m has at least 66 bits.
fn assemble(m: u128, sticky: bool, e: i64) -> f64 {
    let len = i64::from(128 - m.leading_zeros());
    // The exponent of the last place: 53 bits, fewer where the result is subnormal.
    let t = (e + len - 53).max(-1074);
    let drop = t - e;
    if drop > 127 {
        // Below a quarter of the least subnormal.
        return 0.0;
    }
    let kept = (m >> drop) as u64;
    let rest = m & ((1 << drop) - 1);
    let half = 1u128 << (drop - 1);
    let up = rest > half || (rest == half && (sticky || kept % 2 == 1));
    let kept = kept + u64::from(up);
    if t > 971 {
        return f64::INFINITY;
    }
    // kept ≤ 2^53. A subnormal that is rounded up to 2^52 becomes normal by itself.
    if kept < 1 << 52 {
        return f64::from_bits(kept);
    }
    // Adding, not joining: 2^53 carries into the exponent, and from the largest into infinity.
    let biased = (t + 1074) as u64;
    f64::from_bits((biased << 52) + kept)
}

/// The f64 that p/q·2^exponent rounds to, if double-doubles can prove it.
#[must_use]
pub fn round_ball_dd(p: &BallDd, q: &BallDd, exponent: i32) -> Option<f64> {
    round_ball_dd_plus(p, q, exponent, 0.0)
}

/// The f64 that p/q·2^exponent + origin rounds to, if double-doubles can prove it.
///
/// `None` also if the result is not well inside the normal range: exact zero apart.
#[must_use]
pub fn round_ball_dd_plus(p: &BallDd, q: &BallDd, exponent: i32, origin: f64) -> Option<f64> {
    round_near(&p.div(q), exponent, origin)
}

/// The f64 that p/q·2^exponent + origin rounds to, if 400 digits can prove it, of which double-doubles keep those
/// that are left where others cancel.
///
/// `None` also if the result is not well inside the normal range: exact zero apart.
#[must_use]
pub fn round_wide_plus(p: &Wide, q: &Wide, exponent: i32, origin: f64) -> Option<f64> {
    round_near(&p.div(q).to_ball_dd(), exponent, origin)
}

fn round_near(quotient: &BallDd, exponent: i32, origin: f64) -> Option<f64> {
    if quotient.value() == 0.0 && quotient.error() == 0.0 {
        return Some(origin + 0.0);
    }
    let result = if origin == 0.0 {
        // Scaling by a power of two commutes with rounding in the normal range.
        ldexp(quotient.rounded_once()?, exponent)
    } else {
        quotient
            .ldexp(exponent)
            .plus(&BallDd::from_f64(origin))
            .rounded_once()?
    };
    let normal = (power_of_two(-1000)..=power_of_two(1000)).contains(&result.abs());
    (normal || result == 0.0 && origin != 0.0).then_some(result + 0.0)
}
