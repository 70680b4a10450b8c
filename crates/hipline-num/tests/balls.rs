//! The enclosures of both balls, against the oracle.
#![allow(clippy::float_cmp, reason = "errors of exactly zero are the subject")]

mod common;

use common::{Random, Slow};
use hipline_num::{Ball, BallDd, IBig, Number, Sign};

const SEED: u64 = 0x5eed_ba11;

/// What the tests need of a ball.
trait Enclosure: Number {
    fn random(r: &mut Random) -> Self;
    fn parts(&self) -> [f64; 2];
    fn radius(&self) -> f64;
    fn ends(&self) -> (f64, f64);
    fn quotient(&self, o: &Self) -> Self;
    fn root(&self) -> Self;
    fn scaled(&self, k: i32) -> Self;

    fn holds(&self, x: &Slow) -> bool {
        x.may_be_within(&self.parts(), self.radius())
    }
}

/// Integers of all sizes, exact fractions, and balls of all shapes.
fn value_and_error(r: &mut Random, low: bool) -> (f64, f64, f64) {
    let (least, most) = match r.below(4) {
        0 => (-1060, 400),
        1 => (-40, 60),
        2 => (-440, 440),
        _ => (0, 110),
    };
    let mut v = match r.below(8) {
        0 => 0.0,
        1 | 2 => (r.below(1 << 20) as f64) - 524_288.0,
        3 => r.float(50, 55).round(),
        _ => r.float(least, most),
    };
    if r.below(3) == 0 {
        v = v.round();
    }
    let lo = if low && r.below(2) == 0 {
        v * r.float(-110, -54)
    } else {
        0.0
    };
    let lo = if r.below(3) == 0 { lo.round() } else { lo };
    let e = match r.below(5) {
        0 | 1 => 0.0,
        2 => v.abs() * r.float(-60, -40).abs(),
        3 => v.abs() * r.float(-110, 3).abs(),
        _ => r.float(-1000, 100).abs(),
    };
    (v, lo, e)
}

impl Enclosure for Ball {
    fn random(r: &mut Random) -> Self {
        let (v, _, e) = value_and_error(r, false);
        Self::new(v, e)
    }
    fn parts(&self) -> [f64; 2] {
        [self.value(), 0.0]
    }
    fn radius(&self) -> f64 {
        self.error()
    }
    fn ends(&self) -> (f64, f64) {
        (self.lower(), self.upper())
    }
    fn quotient(&self, o: &Self) -> Self {
        self.div(o)
    }
    fn root(&self) -> Self {
        self.sqrt()
    }
    fn scaled(&self, k: i32) -> Self {
        self.ldexp(k)
    }
}

impl Enclosure for BallDd {
    fn random(r: &mut Random) -> Self {
        let (v, lo, e) = value_and_error(r, true);
        Self::new(v, lo, e)
    }
    fn parts(&self) -> [f64; 2] {
        [self.value(), self.low()]
    }
    fn radius(&self) -> f64 {
        self.error()
    }
    fn ends(&self) -> (f64, f64) {
        (self.lower(), self.upper())
    }
    fn quotient(&self, o: &Self) -> Self {
        self.div(o)
    }
    fn root(&self) -> Self {
        self.sqrt()
    }
    fn scaled(&self, k: i32) -> Self {
        self.ldexp(k)
    }
}

/// A number that the ball holds: often an end, where bounds are tightest.
fn pick<T: Enclosure>(b: &T, r: &mut Random) -> Slow {
    let eighths = match r.below(4) {
        0 => -8.0,
        1 => 8.0,
        _ => r.below(17) as f64 - 8.0,
    };
    let [hi, lo] = b.parts();
    let center = Slow::of_f64(hi).plus(&Slow::of_f64(lo));
    let offset = Slow::of_f64(b.radius()).times(&Slow::of_f64(eighths / 8.0));
    center.plus(&offset)
}

/// An integer certified must be one, and the enclosure must hold the exact result.
fn check<T: Enclosure>(what: &str, case: u64, result: &T, exact: &Slow, operands: &[&T]) {
    let context = || format!("seed {SEED:#x}, case {case}: {what} of {operands:?} is {result:?}");
    assert!(result.holds(exact), "{}: not within", context());
    if result.radius() == 0.0 {
        let whole = (&exact.lo >> common::SCALE) << common::SCALE;
        assert!(
            whole == exact.lo && exact.lo == exact.hi,
            "{}: no integer",
            context()
        );
    }
    if let Some(sign) = result.sign() {
        let expected = if exact.lo == IBig::ZERO && exact.hi == IBig::ZERO {
            Some(Sign::Zero)
        } else {
            exact.sign()
        };
        // The oracle's own width leaves only numbers that no ball can tell from 0.
        assert_eq!(Some(sign), expected, "{}", context());
    }
    let (lower, upper) = result.ends();
    assert!(lower <= upper, "{}: [{lower}, {upper}]", context());
    for (end, wrong) in [
        (lower, std::cmp::Ordering::Less),
        (upper, std::cmp::Ordering::Greater),
    ] {
        if end.is_finite() {
            assert_ne!(
                exact.cmp_f64(end),
                Some(wrong),
                "{}: beyond {end}",
                context()
            );
        }
    }
}

fn operations_hold<T: Enclosure>(cases: u64) {
    let mut r = Random(SEED);
    let (mut informative, mut exact) = (0u64, 0u64);
    for case in 0..cases {
        let (a, mut b) = (T::random(&mut r), T::random(&mut r));
        if r.below(8) == 0 {
            // Cancellation.
            b = a.plus(&b.times(&T::from_i64(0))).negated();
        }
        let (x, y) = (pick(&a, &mut r), pick(&b, &mut r));
        check("sum", case, &a.plus(&b), &x.plus(&y), &[&a, &b]);
        check("difference", case, &a.minus(&b), &x.minus(&y), &[&a, &b]);
        let product = a.times(&b);
        check("product", case, &product, &x.times(&y), &[&a, &b]);
        informative += u64::from(product.sign().is_some());
        exact += u64::from(product.radius() == 0.0);
        check("negation", case, &a.negated(), &x.negated(), &[&a]);
        let k = r.below(600) as i32 - 300;
        check("scaling", case, &a.scaled(k), &x.ldexp(k), &[&a]);
        if y.sign().is_some() {
            // A quotient beyond the oracle's reach is let pass by an infinite error.
            check("quotient", case, &a.quotient(&b), &x.div(&y), &[&a, &b]);
        }
        if x.lo >= IBig::ZERO && case % 8 == 0 {
            check("root", case, &a.root(), &x.sqrt_oracle(), &[&a]);
        }
    }
    assert!(
        informative * 2 > cases,
        "{informative} products of {cases} had a sign"
    );
    assert!(exact * 20 > cases, "{exact} products of {cases} were exact");
}

trait RootOracle {
    fn sqrt_oracle(&self) -> Self;
}

impl RootOracle for Slow {
    /// A root that is an integer is exact.
    fn sqrt_oracle(&self) -> Self {
        let root = self.sqrt();
        let whole = Self {
            lo: root.lo.clone(),
            hi: root.lo.clone(),
        };
        let square = whole.times(&whole);
        if square.lo == self.lo && square.hi == self.lo && self.lo == self.hi {
            whole
        } else {
            root
        }
    }
}

#[test]
fn ball_operations_hold_the_exact_result() {
    operations_hold::<Ball>(8_000);
}

#[test]
fn ball_dd_operations_hold_the_exact_result() {
    operations_hold::<BallDd>(8_000);
}

#[test]
fn long_expressions_stay_enclosed() {
    for case in 0..120 {
        let seed = SEED + case;
        let (a, b, s) = (walk::<Ball>(seed), walk::<BallDd>(seed), walk_slow(seed));
        assert!(a.holds(&s), "seed {seed:#x}: {a:?}");
        assert!(b.holds(&s), "seed {seed:#x}: {b:?}");
        assert!(
            b.error() <= a.error() || a.error().is_nan(),
            "seed {seed:#x}: the second rung {b:?} knows less than the first {a:?}"
        );
    }
}

/// Thirty operations on a pool of roots of integers; the same for the same seed.
fn walk_with<T: Number>(seed: u64, root: impl Fn(i64) -> T) -> T {
    let mut r = Random(seed);
    let mut pool: Vec<T> = (0..6).map(|_| root(r.below(2000) as i64)).collect();
    for _ in 0..30 {
        let (i, j) = (r.below(6) as usize, r.below(6) as usize);
        let k = r.below(6) as usize;
        pool[k] = match r.below(8) {
            0..3 => pool[i].plus(&pool[j]),
            3..6 => pool[i].minus(&pool[j]),
            _ => pool[i].times(&root(r.below(50) as i64)),
        };
    }
    pool.swap_remove(0)
}

fn walk<T: Enclosure>(seed: u64) -> T {
    walk_with(seed, |i| T::from_i64(i).root())
}

fn walk_slow(seed: u64) -> Slow {
    walk_with(seed, |i| Slow::from_i64(i).sqrt_oracle())
}

#[test]
fn integers_are_certified_up_to_their_limit() {
    let n = Ball::from_i64(1 << 52);
    assert_eq!(n.plus(&n.minus(&Ball::from_i64(1))).error(), 0.0);
    assert_ne!(n.plus(&n).error(), 0.0);
    let limit = Ball::from_i64(1 << 53);
    assert_ne!(
        limit.plus(&Ball::from_i64(1)).error(),
        0.0,
        "2^53 + 1 is no f64"
    );
    assert_eq!(limit.minus(&limit).sign(), Some(Sign::Zero));

    let n = BallDd::from_i64(1 << 50);
    assert_eq!(n.times(&n).plus(&n.times(&n)).error(), 0.0);
    let far = BallDd::from_i64(1 << 51).times(&n);
    assert_eq!(
        far.plus(&BallDd::from_i64(1)).minus(&far).sign(),
        Some(Sign::Positive)
    );
    let farther = n.times(&n).times(&BallDd::from_i64(4));
    assert_ne!(farther.error(), 0.0);
}

#[test]
fn big_integers_are_read_exactly_or_bounded() {
    let mut r = Random(SEED);
    for case in 0..8_000 {
        let i = if case % 2 == 0 {
            r.int(1100)
        } else {
            r.int(130)
        };
        let exact = Slow::of_int(&i);
        check("reading", case, &Ball::from_int(&i), &exact, &[]);
        check("reading", case, &BallDd::from_int(&i), &exact, &[]);
    }
    for i in [
        i64::MAX,
        i64::MIN,
        (1 << 53) + 1,
        -(1 << 53) - 1,
        i64::MAX - 1,
    ] {
        let exact = Slow::from_i64(i);
        check("reading", 0, &Ball::from_i64(i), &exact, &[]);
        check("reading", 0, &BallDd::from_i64(i), &exact, &[]);
        assert_eq!(BallDd::from_i64(i).error(), 0.0);
    }
    assert_eq!(BallDd::from_int(&(IBig::ONE << 100usize)).error(), 0.0);
}

#[test]
fn perfect_squares_have_exact_roots() {
    let mut r = Random(SEED);
    for _ in 0..20_000 {
        let k = r.below(1 << 26) as i64;
        let root = Ball::from_i64(k * k).sqrt();
        assert_eq!((root.value(), root.error()), (k as f64, 0.0));
        let next = Ball::from_i64(k * k + 1).sqrt();
        assert!(k == 0 || next.error() > 0.0);
        let k = r.below(1 << 51) as i64;
        let big = BallDd::from_i64(k).times(&BallDd::from_i64(k));
        let root = big.sqrt();
        assert_eq!((root.value(), root.error()), (k as f64, 0.0));
        assert!(k == 0 || big.plus(&BallDd::from_i64(1)).sqrt().error() > 0.0);
    }
}

#[test]
fn overflow_and_nonsense_abstain() {
    let big = Ball::from_f64(1e300);
    let huge = big.times(&big);
    for x in [
        huge,
        huge.minus(&huge),
        huge.negated(),
        Ball::new(f64::NAN, 0.0),
        Ball::new(f64::INFINITY, 1.0),
        Ball::new(1.0, f64::NAN),
        Ball::new(1.0, f64::INFINITY),
        Ball::from_i64(1).div(&Ball::zero()),
        Ball::from_i64(1).div(&Ball::new(1e-3, 1e-3)),
        Ball::from_i64(-1).sqrt(),
        big.ldexp(1000),
    ] {
        assert_eq!(x.sign(), None, "{x:?}");
        assert_eq!(x.plus(&Ball::from_i64(1)).sign(), None, "{x:?}");
        assert_eq!(x.times(&Ball::from_i64(2)).sign(), None, "{x:?}");
        assert_eq!(Ball::from_i64(1).div(&x).sign(), None, "{x:?}");
    }
    let big = BallDd::from_f64(1e300);
    let huge = big.times(&big);
    for x in [
        huge,
        huge.minus(&huge),
        big.plus(&BallDd::from_i64(1))
            .times(&BallDd::from_i64(3))
            .sqrt(),
        BallDd::new(f64::NAN, 0.0, 0.0),
        BallDd::new(f64::INFINITY, 0.0, 1.0),
        BallDd::new(f64::MAX, f64::MAX, 1.0),
        BallDd::new(1.0, 0.0, f64::NAN),
        BallDd::from_i64(1).div(&BallDd::zero()),
        BallDd::from_i64(1).div(&BallDd::new(1e-3, 0.0, 1e-3)),
        BallDd::from_i64(-1).sqrt(),
        big.ldexp(1000),
    ] {
        assert_eq!(x.sign(), None, "{x:?}");
        assert_eq!(x.plus(&BallDd::from_i64(1)).sign(), None, "{x:?}");
        assert_eq!(x.times(&BallDd::from_i64(2)).sign(), None, "{x:?}");
        assert_eq!(BallDd::from_i64(1).div(&x).sign(), None, "{x:?}");
    }
}

#[test]
fn straddling_roots_start_at_zero() {
    let x = Ball::new(1e-10, 1e-8).sqrt();
    assert!(
        x.lower() <= 0.0 && x.upper() >= 1.004e-4 && x.upper() < 1.006e-4,
        "{x:?}"
    );
    let x = BallDd::new(-1e-10, 0.0, 1e-8).sqrt();
    assert!(
        x.lower() <= 0.0 && x.upper() >= 0.99e-4 && x.upper() < 1e-4,
        "{x:?}"
    );
}
