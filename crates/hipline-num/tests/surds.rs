//! Signs of surds, and which rung it takes to find a sign.

mod common;

use common::{Random, Slow};
use hipline_num::{Ball, BallDd, IBig, Number, Sign, Surd, UBig};

const SEED: u64 = 0x5eed_5dd0;

/// Σ c·√r, where r = 1 is the rational part.
fn surd(terms: &[(IBig, UBig)]) -> Surd {
    terms.iter().fold(Surd::zero(), |sum, (c, r)| {
        sum.plus(&Surd::scaled_sqrt(c.clone(), r))
    })
}

fn slow(terms: &[(IBig, UBig)]) -> Slow {
    terms.iter().fold(Slow::zero(), |sum, (c, r)| {
        let root = Slow::of_int(r.as_ibig()).sqrt();
        // The root is rounded down to `lo`, up to `hi`; the oracle's product does the rest.
        sum.plus(&Slow::of_int(c).times(&root))
    })
}

fn small(terms: &[(i64, u64)]) -> Surd {
    let terms: Vec<_> = terms.iter().map(|&(c, r)| (c.into(), r.into())).collect();
    surd(&terms)
}

fn root(r: u64) -> Surd {
    Surd::sqrt_of(&UBig::from(r))
}

#[test]
fn sums_that_vanish_are_zero() {
    for terms in [
        &[(1, 2), (1, 8), (-1, 18)][..],
        &[(1, 1), (2, 4), (-1, 25)],
        &[(3, 12), (-6, 3), (5, 45), (-15, 5)],
        &[(2, 8), (1, 27), (-4, 2), (-3, 3)],
        &[(-4, 2), (2, 8), (0, 7)],
        &[],
    ] {
        let zero = small(terms);
        assert_eq!(zero.sign(), Some(Sign::Zero), "{zero}");
        // One more makes it positive, and so does a further root.
        assert_eq!(
            zero.plus(&Surd::from_i64(1)).sign(),
            Some(Sign::Positive),
            "{zero} + 1"
        );
        assert_eq!(
            zero.minus(&root(7)).sign(),
            Some(Sign::Negative),
            "{zero} - √7"
        );
    }
    let product = root(2).times(&root(3));
    assert_eq!(product.minus(&root(6)).sign(), Some(Sign::Zero));
    // (√2 + √3)² = 5 + 2√6
    let sum = root(2).plus(&root(3));
    let square = small(&[(5, 1), (2, 6)]);
    assert_eq!(sum.times(&sum).minus(&square).sign(), Some(Sign::Zero));
    // (√6 + √10 − √15)·√30 = 6√5 + 10√3 − 15√2
    let sum = small(&[(1, 6), (1, 10), (-1, 15)]).times(&root(30));
    assert_eq!(
        sum.minus(&small(&[(6, 5), (10, 3), (-15, 2)])).sign(),
        Some(Sign::Zero)
    );
}

#[test]
fn products_keep_their_radicands_small() {
    // √(2·3·5²)·√(2·3·7²) = 6·5·7
    assert_eq!(root(150).times(&root(294)).as_int(), Some(&IBig::from(210)));
    assert_eq!(root(150).times(&root(15)).to_string(), "15√10");
    assert_eq!(root(15).times(&root(15)).as_int(), Some(&IBig::from(15)));
    assert_eq!(root(49).as_int(), Some(&IBig::from(7)));
    assert_eq!(small(&[(1, 1), (-2, 3), (1, 2)]).to_string(), "1+1√2-2√3");
}

#[test]
fn close_calls_go_the_right_way() {
    // Convergents of √2: a² − 2b² = ±1, so a − b√2 = ±1/(a + b√2).
    let (mut a, mut b) = (IBig::ONE, IBig::ONE);
    let mut negative = true;
    for step in 0..600 {
        let x = Surd::from_int(a.clone());
        let y = Surd::scaled_sqrt(-&b, &UBig::from(2u8));
        let expected = if negative {
            Sign::Negative
        } else {
            Sign::Positive
        };
        assert_eq!(x.plus(&y).exact_sign(), expected, "step {step}");
        let delta = Surd::from_i64(2);
        let by_root = Surd::sign_with_root(&x, &Surd::from_int(-&b), &delta);
        assert_eq!(by_root, expected, "step {step}");
        (a, b) = (&a + &b * IBig::from(2), a + b);
        negative = !negative;
    }
}

#[test]
fn signs_agree_with_the_oracle() {
    let mut r = Random(SEED);
    let mut told = 0;
    for case in 0..1200 {
        let bits = 1 + r.below(200);
        let radicand_bits = 1 + r.below(120);
        let count = 1 + r.below(6);
        let mut terms: Vec<(IBig, UBig)> = (0..count)
            .map(|_| (r.int(bits), r.positive(radicand_bits)))
            .collect();
        if r.below(2) == 0 {
            // Almost cancel: subtract the sum, rounded, or a term written otherwise.
            let nearest = &slow(&terms).lo >> common::SCALE;
            terms.push((-nearest - IBig::from(r.below(2)), UBig::ONE));
        } else if r.below(2) == 0 {
            let (c, d) = terms[0].clone();
            terms[0].0 = &c * IBig::from(3);
            terms.push((-c, d * UBig::from(9u8)));
        }
        let (x, y) = (surd(&terms), slow(&terms));
        if let Some(sign) = y.sign() {
            told += 1;
            assert_eq!(x.exact_sign(), sign, "seed {SEED:#x}, case {case}: {x}");
        } else {
            assert_eq!(
                x.exact_sign(),
                Sign::Zero,
                "seed {SEED:#x}, case {case}: {x}"
            );
        }
    }
    assert!(told > 900, "the oracle told {told}");
}

#[test]
fn rings_agree_with_the_oracle() {
    let mut r = Random(SEED);
    for case in 0..150 {
        let mut make = || {
            let terms: Vec<_> = (0..3).map(|_| (r.int(30), r.positive(30))).collect();
            (surd(&terms), slow(&terms))
        };
        let ((a, x), (b, y), (c, z)) = (make(), make(), make());
        let pairs = [
            (a.times(&b).plus(&c), x.times(&y).plus(&z)),
            (a.minus(&b).times(&c), x.minus(&y).times(&z)),
            (
                a.times(&b).times(&c).negated(),
                x.times(&y).times(&z).negated(),
            ),
        ];
        for (s, t) in pairs {
            let context = || format!("seed {SEED:#x}, case {case}: {s}");
            // What the oracle cannot tell from 0 is 0 here.
            assert_eq!(
                s.exact_sign(),
                t.sign().unwrap_or(Sign::Zero),
                "{}",
                context()
            );
            let (f, g) = (s.to_ball(), s.to_ball_dd());
            assert!(t.may_be_within(&[f.value()], f.error()), "{}", context());
            assert!(
                t.may_be_within(&[g.value(), g.low()], g.error()),
                "{}",
                context()
            );
        }
        let distributed = a.times(&b).plus(&a.times(&c)).minus(&a.times(&b.plus(&c)));
        assert_eq!(
            distributed.exact_sign(),
            Sign::Zero,
            "seed {SEED:#x}, case {case}"
        );
    }
}

#[test]
fn signs_with_a_nested_root_agree_with_the_oracle() {
    let mut r = Random(SEED);
    for case in 0..250 {
        let mut make = |bits| {
            let terms: Vec<_> = (0..3).map(|_| (r.int(bits), r.positive(30))).collect();
            (surd(&terms), slow(&terms))
        };
        let ((a, x), (b, y)) = (make(60), make(30));
        let (d, z) = make(40);
        let (d, z) = (d.times(&d), z.times(&z));
        let sign = Surd::sign_with_root(&a, &b, &d);
        let expected = x.plus(&y.times(&z.sqrt())).sign();
        // z is a square here: a + b·|√z| can be compared, and equality forced.
        assert_eq!(Some(sign), expected, "seed {SEED:#x}, case {case}");
        // |d|·b − b·√(d²) = 0
        let size = if d.exact_sign().is_zero() {
            Surd::zero()
        } else {
            d.clone()
        };
        let zero = Surd::sign_with_root(&size.times(&b), &b.negated(), &size.times(&size));
        assert_eq!(zero, Sign::Zero, "seed {SEED:#x}, case {case}");
    }
    let (zero, one) = (Surd::zero(), Surd::from_i64(1));
    assert_eq!(Surd::sign_with_root(&zero, &one, &zero), Sign::Zero);
    assert_eq!(Surd::sign_with_root(&zero, &one, &one), Sign::Positive);
    assert_eq!(Surd::sign_with_root(&one.negated(), &one, &one), Sign::Zero);
    assert_eq!(
        Surd::sign_with_root(&one, &one.negated(), &root(2)),
        Sign::Negative
    );
    // √(3 + 2√2) = 1 + √2
    let nested = small(&[(3, 1), (2, 2)]);
    let outer = small(&[(-1, 1), (-1, 2)]);
    assert_eq!(Surd::sign_with_root(&outer, &one, &nested), Sign::Zero);
}

#[test]
fn huge_numbers_do_not_hang() {
    let huge = Surd::scaled_sqrt(IBig::ONE << 3000usize, &((UBig::ONE << 4001usize) + 1u8));
    let same = Surd::scaled_sqrt(IBig::ONE << 2999usize, &((UBig::ONE << 4003usize) + 4u8));
    assert_eq!(huge.minus(&same).exact_sign(), Sign::Zero);
    let more = huge.minus(&same).plus(&Surd::from_i64(1));
    assert_eq!(more.exact_sign(), Sign::Positive);
}

/// The first rung that gives the sign of Σ c·√r.
fn rung(terms: &[(i64, i64)]) -> (&'static str, Sign) {
    fn sum<T: Number>(terms: &[(i64, i64)], root: impl Fn(i64) -> T) -> Option<Sign> {
        let term = |&(c, r): &(i64, i64)| T::from_i64(c).times(&root(r));
        terms.iter().fold(T::zero(), |s, t| s.plus(&term(t))).sign()
    }
    if let Some(sign) = sum(terms, |r| Ball::from_i64(r).sqrt()) {
        return ("f64", sign);
    }
    if let Some(sign) = sum(terms, |r| BallDd::from_i64(r).sqrt()) {
        return ("double-double", sign);
    }
    let sign = sum(terms, |r| root(r as u64));
    ("exact", sign.expect("a surd never abstains"))
}

#[test]
fn each_sign_is_found_on_its_rung() {
    use Sign::{Negative, Positive, Zero};
    for (terms, expected) in [
        (&[(1, 2), (1, 3), (-1, 9)][..], ("f64", Positive)),
        // Integers and roots of squares are certified by the first rung, zero included.
        (&[(3, 16), (-4, 9)], ("f64", Zero)),
        (&[(1 << 50, 1), (-(1 << 50), 1), (-1, 1)], ("f64", Negative)),
        // Past 2^53 the integers are for the second.
        (
            &[
                (94_906_267 * 94_906_267, 1),
                (-94_906_267, 94_906_267 * 94_906_267),
            ],
            ("double-double", Zero),
        ),
        // 7.5e-7 beside 7e5 is told by f64; less beside more is not.
        (&[(665_857, 1), (-470_832, 2)], ("f64", Positive)),
        (
            &[(768_398_401, 1), (-543_339_720, 2)],
            ("double-double", Positive),
        ),
        (
            &[(1_855_077_841, 1), (-1_311_738_121, 2)],
            ("double-double", Negative),
        ),
        // Of numbers this small only zero needs the last rung.
        (&[(1, 2), (1, 8), (-1, 18)], ("exact", Zero)),
        (&[(1, 2), (1, 8), (-1, 18), (1, 1)], ("f64", Positive)),
    ] {
        assert_eq!(rung(terms), expected, "{terms:?}");
    }
    // a² − 2b² = −1 with a of 152 bits: nearer to zero than a double-double can tell.
    let (mut a, mut b) = (IBig::ONE, IBig::ONE);
    for _ in 0..120 {
        (a, b) = (&a + &b * IBig::from(2), a + b);
    }
    let two = BallDd::from_i64(2).sqrt();
    let filtered = BallDd::from_int(&a).minus(&BallDd::from_int(&b).times(&two));
    assert_eq!(filtered.sign(), None);
    let exact = Surd::from_int(a).minus(&Surd::scaled_sqrt(b, &UBig::from(2u8)));
    assert_eq!(exact.exact_sign(), Negative);
}
