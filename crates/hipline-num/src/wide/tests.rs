//! Tests of floating point with 400 digits, against exact numbers.

use super::*;
use crate::{Surd, f64_to_parts, ldexp};
use dashu_int::ops::UnsignedAbs;

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
            let wide = Wide::from_int(&m);
            let (top, cut) = leading(wide.used());
            assert_eq!(cut as usize, length - 53.min(length), "{odd} << {shift}");
            assert_eq!(
                IBig::from(top as i64),
                -m >> cut as usize,
                "{odd} << {shift}"
            );
        }
    }
    assert_eq!(leading(&[]), (0.0, 0));
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

/// A random integer of up to so many binary digits, and a sum of two such times roots.
fn sums(state: &mut u64, bits: usize) -> (Wide, Surd) {
    let mut integer = || {
        let mut i = IBig::ZERO;
        for _ in 0..bits.div_ceil(60) {
            i = (i << 60) + random(state);
        }
        i >> (random(state).unsigned_abs() as usize % bits)
    };
    let [a, b, c] = [integer(), integer(), integer()];
    let [r, s] = [integer(), integer()].map(|i| i.unsigned_abs());
    let wide = Wide::from_int(&b).times(&Wide::sqrt_of(&r));
    let wide = wide.plus(&Wide::from_int(&c).times(&Wide::sqrt_of(&s)));
    let surd = Surd::from_int(b).times(&Surd::sqrt_of(&r));
    let surd = surd.plus(&Surd::from_int(c).times(&Surd::sqrt_of(&s)));
    let (wide, surd) = (
        wide.plus(&Wide::from_int(&a)),
        surd.plus(&Surd::from_int(a)),
    );
    (wide, surd)
}

#[test]
fn quotients_round_as_exact_ones_do() {
    let seed = 0x5eed_0000_0000_0007;
    println!("seed {seed:#x}");
    let mut state = seed;
    let (mut told, mut cancelled) = (0, 0);
    for round in 0..4000 {
        let bits = [20, 60, 130, 500][round % 4];
        let ((p, x), (q, y)) = (sums(&mut state, bits), sums(&mut state, bits));
        // Every other time most of the digits cancel: p q / q - p + 1 / p.
        let (n, m) = if round % 8 < 4 {
            (p, x)
        } else {
            cancelled += 1;
            let (p2, x2) = (p.times(&p).times(&q), x.times(&x).times(&y));
            let by = p.times(&q);
            (
                p2.minus(&by.times(&p)).plus(&q),
                x2.minus(&x.times(&y).times(&x)).plus(&y),
            )
        };
        if y.exact_sign().is_zero() {
            continue;
        }
        if let Some(found) = crate::round_wide_plus(&n, &q, -3, 0.5) {
            let expected = crate::round_quotient_plus(&m, &y, -3, 0.5);
            assert_eq!(found.to_bits(), expected.to_bits(), "round {round}");
            told += 1;
        }
    }
    assert!(
        told > 3000 && cancelled > 1500,
        "{told} of 4000 were told, {cancelled} cancelled"
    );
}

#[test]
fn bounds_hold_whatever_the_digits() {
    // With all digits one, every cut and every carry is the worst.
    let seed = 0xb0bd_5eed;
    println!("seed {seed:#x}");
    let mut state: u64 = seed;
    let mut narrow = 0;
    for round in 0..4000 {
        let mut number = || {
            let bits = 1 + random(&mut state).unsigned_abs() as usize % 900;
            let low = random(&mut state).unsigned_abs() as usize % bits;
            let i = (IBig::ONE << bits) - (IBig::ONE << low) + random(&mut state) % 3;
            if round % 2 == 0 { i } else { -i }
        };
        let [a, b, c] = [number(), number(), number()];
        let [x, y, z] = [&a, &b, &c].map(Wide::from_int);
        let near = x.times(&y).plus(&z.times(&z)).minus(&y.times(&z));
        let exact = &a * &b + &c * &c - &b * &c;
        assert!(holds(&near, &exact, &IBig::ONE), "round {round}");
        assert!(holds(&near.div(&x), &exact, &a), "round {round}");
        let square = Wide::from_int(&(&a * &a));
        let size = IBig::from(a.unsigned_abs());
        let root = square.sqrt();
        assert!(holds(&root, &size, &IBig::ONE), "round {round}");
        // Bounds that hold are to be of use, too: nothing has cancelled here.
        let all = [x.times(&y), x.div(&y), root];
        narrow += usize::from(all.iter().all(|z| z.error <= ldexp(z.least(), -370)));
    }
    assert!(narrow > 3900, "only {narrow} of 4000 bounds are narrow");
}

/// Whether a / b is within the bound of a number: (mantissa - error) b <= a / unit <= (mantissa + error) b.
fn holds(near: &Wide, a: &IBig, b: &IBig) -> bool {
    let mut mantissa = IBig::ZERO;
    for &digit in near.used().iter().rev() {
        mantissa = (mantissa << 64) + digit;
    }
    if near.negative {
        mantissa = -mantissa;
    }
    if near.error > 1e30 {
        return true;
    }
    // In units of 2^-1100, in which every f64 is an integer.
    let fine = 1100;
    let (error, exponent) = f64_to_parts(near.error);
    let error = error << (exponent + fine) as usize;
    let fine = fine as usize;
    let (a, b) = if *b < IBig::ZERO {
        (-a, -b)
    } else {
        (a.clone(), b.clone())
    };
    let (mut left, mut right) = ((mantissa << fine) * &b, a << fine);
    let shift = 64 * near.exponent.unsigned_abs() as usize;
    if near.exponent >= 0 {
        left <<= shift;
        let off = (left - right).unsigned_abs();
        IBig::from(off) <= (error * b) << shift
    } else {
        right <<= shift;
        let off = (left - right).unsigned_abs();
        IBig::from(off) <= error * b
    }
}
