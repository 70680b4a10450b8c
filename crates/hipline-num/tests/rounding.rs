//! Correct rounding, against a bisection over all f64 numbers.
#![allow(clippy::float_cmp, reason = "results are to be right to the last bit")]

mod common;

use common::{Random, Slow};
use hipline_num::{
    BallDd, IBig, Number, Surd, UBig, compare_quotient_f64, round_ball_dd, round_ball_dd_plus,
    round_quotient, round_quotient_plus,
};
use std::cmp::Ordering;

const SEED: u64 = 0x5eed_0f64;

/// The f64 nearest to x > 0: the last one not above it, by bisection on the bits, or the next.
fn nearest_to(x: &Slow) -> f64 {
    let (mut below, mut above) = (0u64, f64::INFINITY.to_bits());
    while above - below > 1 {
        let middle = (below + above) / 2;
        match x
            .cmp_f64(f64::from_bits(middle))
            .expect("the oracle is fine enough")
        {
            Ordering::Less => above = middle,
            _ => below = middle,
        }
    }
    let low = f64::from_bits(below);
    let step = if low == f64::MAX {
        Slow::of_f64(2f64.powi(970)).plus(&Slow::of_f64(2f64.powi(970)))
    } else {
        Slow::of_f64(f64::from_bits(above)).minus(&Slow::of_f64(low))
    };
    let twice = x
        .minus(&Slow::of_f64(low))
        .times(&Slow::from_i64(2))
        .minus(&step);
    let up = if twice.lo == IBig::ZERO && twice.hi == IBig::ZERO {
        below % 2 == 1
    } else {
        twice
            .sign()
            .expect("the oracle is fine enough")
            .is_positive()
    };
    f64::from_bits(if up { above } else { below })
}

fn nearest(x: &Slow) -> f64 {
    if x.lo == IBig::ZERO && x.hi == IBig::ZERO {
        0.0
    } else if x.lo < IBig::ZERO {
        // −0.0 is never given.
        -nearest_to(&x.negated()) + 0.0
    } else {
        nearest_to(x)
    }
}

fn random_pair(r: &mut Random, roots: u64) -> (Surd, Slow) {
    let (mut s, mut t) = (Surd::zero(), Slow::zero());
    for _ in 0..roots {
        let (c, d) = (r.int(60), r.positive(50));
        s = s.plus(&Surd::scaled_sqrt(c.clone(), &d));
        t = t.plus(&Slow::of_int(&c).times(&Slow::of_int(d.as_ibig()).sqrt()));
    }
    let c = r.int(60);
    (
        s.plus(&Surd::from_int(c.clone())),
        t.plus(&Slow::of_int(&c)),
    )
}

#[track_caller]
fn same_bits(found: f64, expected: f64, context: &str) {
    assert_eq!(
        found.to_bits(),
        expected.to_bits(),
        "{found:e}, not {expected:e}: {context}"
    );
}

#[test]
fn quotients_are_rounded_to_nearest() {
    let mut r = Random(SEED);
    let mut filtered = 0;
    for case in 0..1200 {
        let roots = r.below(4);
        let (p, x) = random_pair(&mut r, roots);
        let (q, y) = random_pair(&mut r, roots);
        if y.sign().is_none() {
            continue;
        }
        let exponent = match r.below(4) {
            0 => -1120 + r.below(80) as i32,
            1 => 950 + r.below(80) as i32,
            _ => r.below(400) as i32 - 200,
        };
        let origin = match r.below(3) {
            0 => 0.0,
            1 => r.float(
                exponent.clamp(-1000, 1000) - 20,
                exponent.clamp(-1000, 1000) + 20,
            ),
            _ => r.float(-30, 30),
        };
        let context = format!("seed {SEED:#x}, case {case}: ({p})/({q})·2^{exponent} + {origin}");
        let exact = x.div(&y).ldexp(exponent);
        let expected = nearest(&exact);
        same_bits(round_quotient(&p, &q, exponent), expected, &context);
        if let Some(f) = round_ball_dd(&p.to_ball_dd(), &q.to_ball_dd(), exponent) {
            same_bits(f, expected, &context);
            filtered += 1;
        }
        let exact = exact.plus(&Slow::of_f64(origin));
        let expected = nearest(&exact);
        same_bits(
            round_quotient_plus(&p, &q, exponent, origin),
            expected,
            &context,
        );
        let (pd, qd) = (p.to_ball_dd(), q.to_ball_dd());
        if let Some(f) = round_ball_dd_plus(&pd, &qd, exponent, origin) {
            same_bits(f, expected, &context);
            filtered += 1;
        }
        for value in [
            expected,
            expected.next_up(),
            expected.next_down(),
            origin,
            -origin,
        ] {
            if value.is_finite() {
                let found = compare_quotient_f64(&p, &q, exponent, origin, value);
                let told = exact.cmp_f64(value);
                assert!(told.is_none_or(|t| t == found), "{context} against {value}");
            }
        }
    }
    assert!(filtered > 600, "the filter rounded {filtered}");
}

#[test]
fn ties_go_to_even_and_their_neighbours_do_not() {
    let mut r = Random(SEED);
    let d = UBig::from(7u8);
    for case in 0..2000 {
        let m = (1 << 52) + r.below(1 << 52) as i64;
        let exponent = match case % 3 {
            0 => 0,
            1 => r.below(1800) as i32 - 1000,
            _ => -1075,
        };
        let context = format!("seed {SEED:#x}, case {case}: 2·{m} + 1, 2^{exponent}");
        // (2m + 1)·√7 / √7: halfway, and known to be only exactly.
        let c = IBig::from(2 * m + 1);
        let p = Surd::scaled_sqrt(c.clone(), &d);
        let q = Surd::sqrt_of(&d);
        let even = if m % 2 == 0 { m } else { m + 1 };
        let value = |m: i64| {
            let power = exponent + 1;
            (m as f64) * 2f64.powi(power / 2) * 2f64.powi(power - power / 2)
        };
        same_bits(round_quotient(&p, &q, exponent), value(even), &context);
        same_bits(
            round_quotient(&p, &q.negated(), exponent),
            -value(even),
            &context,
        );
        assert_eq!(
            round_ball_dd(&p.to_ball_dd(), &q.to_ball_dd(), exponent),
            None,
            "{context}"
        );
        // A hair beyond, on either side.
        let hair = Surd::scaled_sqrt(IBig::ONE, &UBig::from(3u8));
        let big = 300usize;
        let (above, below) = (p.shifted(big).plus(&hair), p.shifted(big).minus(&hair));
        let least = q.shifted(big);
        same_bits(
            round_quotient(&above, &least, exponent),
            value(m + 1),
            &context,
        );
        same_bits(round_quotient(&below, &least, exponent), value(m), &context);
        // An origin brings a tie about, too.
        if exponent == 0 {
            let p = Surd::scaled_sqrt(c - IBig::from(2 * m), &d);
            let found = round_quotient_plus(&p, &q, exponent, (2 * m) as f64);
            same_bits(found, value(even), &context);
        }
    }
}

#[test]
fn the_ends_of_the_range() {
    let int = |i: i64| Surd::from_i64(i);
    let (one, three) = (int(1), int(3));
    assert_eq!(round_quotient(&one, &one, -1074), f64::from_bits(1));
    same_bits(
        round_quotient(&one, &one, -1075),
        0.0,
        "half the least goes to even",
    );
    same_bits(
        round_quotient(&int(-1), &one, -1075),
        0.0,
        "and is not −0.0",
    );
    assert_eq!(round_quotient(&three, &one, -1076), f64::from_bits(1));
    assert_eq!(round_quotient(&three, &one, -1075), f64::from_bits(2));
    same_bits(round_quotient(&one, &one, i32::MIN), 0.0, "far below");
    assert_eq!(round_quotient(&one, &one, i32::MAX), f64::INFINITY);
    assert_eq!(round_quotient(&int(-1), &one, 1024), f64::NEG_INFINITY);
    assert_eq!(round_quotient(&one, &one, 1023), 2f64.powi(1023));
    // The largest f64 is (2^53 − 1)·2^971; half a step more rounds to infinity.
    let most = int((1 << 53) - 1);
    assert_eq!(round_quotient(&most, &one, 971), f64::MAX);
    let tie = int((1 << 54) - 1);
    assert_eq!(round_quotient(&tie, &one, 970), f64::INFINITY);
    let less = int((1 << 54) - 1).shifted(60).minus(&one);
    assert_eq!(round_quotient(&less, &one, 910), f64::MAX);
    let root = Surd::sqrt_of(&UBig::from(2u8));
    assert_eq!(round_quotient(&tie.times(&root), &root, 970), f64::INFINITY);
    assert_eq!(round_quotient(&less.times(&root), &root, 910), f64::MAX);
    // From the largest subnormal up to the least normal number.
    let n = int((1 << 53) - 1);
    assert_eq!(round_quotient(&n, &one, -1075), f64::MIN_POSITIVE);
    same_bits(round_quotient(&Surd::zero(), &int(-7), 5), 0.0, "zero");
    same_bits(
        round_quotient_plus(&int(-5), &one, 0, 5.0),
        0.0,
        "zero by an origin",
    );
    same_bits(
        round_quotient_plus(&Surd::zero(), &one, 0, -0.0),
        0.0,
        "a negative zero",
    );
    let zero = BallDd::zero();
    assert_eq!(
        round_ball_dd(&zero, &BallDd::from_i64(-3), 0).map(f64::to_bits),
        Some(0)
    );
    let origin = round_ball_dd_plus(&zero, &BallDd::from_i64(3), 0, 1e-310);
    assert_eq!(origin, Some(1e-310));
    assert_eq!(
        round_ball_dd(&BallDd::from_i64(1), &BallDd::from_i64(1), -1074),
        None
    );
    assert_eq!(
        round_ball_dd(&BallDd::from_i64(1), &BallDd::from_i64(3), 0),
        Some(1.0 / 3.0)
    );
}

#[test]
fn quotients_compare_exactly() {
    let root = Surd::sqrt_of(&UBig::from(2u8));
    let one = Surd::from_i64(1);
    let nearest = std::f64::consts::SQRT_2;
    assert_eq!(
        compare_quotient_f64(&root, &one, 0, 0.0, nearest),
        Ordering::Less
    );
    assert_eq!(
        compare_quotient_f64(&root, &one.negated(), 0, 0.0, -nearest),
        Ordering::Greater
    );
    let third = Surd::from_i64(3);
    assert_eq!(
        compare_quotient_f64(&third, &third, -1, 0.25, 0.75),
        Ordering::Equal
    );
    let tripled = root.times_int(&IBig::from(3));
    assert_eq!(
        compare_quotient_f64(&tripled, &root, 0, 1e300, 1e300),
        Ordering::Greater
    );
}
