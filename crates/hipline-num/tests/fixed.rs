//! Exact numbers of a fixed width against those of any width.

mod common;

use common::Random;
use dashu_int::ops::BitTest as _;
use hipline_num::{Fixed, IBig, Integer, Limbs, Number, Radicals, Short, Sign, Surd, UBig, Wide};
use std::rc::Rc;

const SEED: u64 = 0x71e5_0001;

/// An integer with the given number of binary digits at most; sometimes of all ones, or a power of two.
fn integer(random: &mut Random, bits: usize) -> IBig {
    let top = IBig::ONE << bits;
    let size = match random.below(4) {
        0 => &top - IBig::from(random.below(3)),
        1 => &top / IBig::from(2) + IBig::from(random.below(2)),
        _ => {
            let mut size = IBig::ZERO;
            for _ in 0..=bits / 64 {
                size = (size << 64) + IBig::from(random.next());
            }
            size % &top
        }
    };
    if random.below(2) == 0 { size } else { -size }
}

/// Each operation agrees with dashu where it answers, and answers where the result is surely small enough.
fn operations_agree<I: Integer + PartialEq>(room: usize, most: usize) {
    println!("seed {SEED:#x}");
    let random = &mut Random(SEED);
    let mut refused = 0;
    for round in 0..20_000 {
        let mut operand = || {
            let bits = random.below(room as u64 + 2) as usize;
            integer(random, bits)
        };
        let (a, b) = (operand(), operand());
        let (Some(x), Some(y)) = (I::from_int(&a), I::from_int(&b)) else {
            assert!(a.bit_len().max(b.bit_len()) > most, "{a} {b} fit");
            continue;
        };
        let checks = [
            (x.plus(&y), &a + &b),
            (x.minus(&y), &a - &b),
            (x.times(&y), &a * &b),
            (x.negated(), -&a),
        ];
        for (k, (found, expected)) in checks.into_iter().enumerate() {
            match found {
                Some(found) => {
                    assert_eq!(
                        Some(&found),
                        I::from_int(&expected).as_ref(),
                        "round {round}, operation {k}: {a} and {b}"
                    );
                    assert_eq!(found.sign(), Sign::from(expected.cmp(&IBig::ZERO)));
                    assert_eq!(found.bit_len() as usize, expected.bit_len());
                }
                None => {
                    refused += 1;
                    // A product is refused if its factors have too many digits together.
                    let least = if k == 2 { most - 64 } else { most };
                    assert!(
                        expected.bit_len() > least,
                        "round {round}, operation {k}: {a} and {b} were refused"
                    );
                }
            }
        }
        let near = x.to_ball_dd();
        let exact = hipline_num::BallDd::from_int(&a);
        let gap = near.minus(&exact);
        assert!(
            gap.value().abs() <= gap.error(),
            "{a} is not within {near:?}"
        );
    }
    assert!(refused > 100, "only {refused} results were too large");
}

#[test]
fn operations_on_machine_integers_agree() {
    operations_agree::<i128>(128, 127);
}

#[test]
fn operations_on_limbs_agree() {
    operations_agree::<Limbs>(1024, 1024);
}

#[test]
fn operations_on_short_integers_agree() {
    operations_agree::<Short>(448, 448);
}

/// The same random expression in both kinds of exact numbers.
struct Pair<I: Integer>(Fixed<I>, Surd);

impl<I: Integer> Pair<I> {
    fn join(
        &self,
        o: &Self,
        fixed: impl Fn(&Fixed<I>, &Fixed<I>) -> Fixed<I>,
        surd: impl Fn(&Surd, &Surd) -> Surd,
    ) -> Self {
        Self(fixed(&self.0, &o.0), surd(&self.1, &o.1))
    }
}

/// Sums of integers and roots, their products, and differences of things that are equal.
fn signs_agree<I: Integer>(bits: usize, least_zeros: usize) {
    println!("seed {SEED:#x}");
    let random = &mut Random(SEED);
    let (mut zeros, mut told) = (0, 0);
    const ROUNDS: usize = 1500;
    for round in 0..ROUNDS {
        let radicals = Rc::new(Radicals::default());
        let radicands = [2_u64, 3, 7, 10, 1_000_003].map(UBig::from);
        let mut linear = || {
            let mut sum = {
                let i = integer(random, bits);
                Pair(Fixed::from_integer(I::from_int(&i)), Surd::from_int(i))
            };
            for _ in 0..random.below(4) {
                let r = &radicands[random.below(5) as usize];
                let c = integer(random, bits);
                let number = radicals.number(r.clone()).unwrap();
                let root: Fixed<I> = Fixed::scaled_root(I::from_i128(1), number, &radicals);
                let term = Pair(
                    root.times(&Fixed::from_integer(I::from_int(&c))),
                    Surd::scaled_sqrt(c, r),
                );
                sum = sum.join(&term, Number::plus, Number::plus);
            }
            sum
        };
        let [p, q, r] = [linear(), linear(), linear()];
        let product = p.join(&q, Number::times, Number::times);
        let value = match round % 3 {
            // (p + r) q - p q - r q = 0.
            0 => {
                let sum = p.join(&r, Number::plus, Number::plus);
                let left = sum.join(&q, Number::times, Number::times);
                let rest = left.join(&product, Number::minus, Number::minus);
                let right = r.join(&q, Number::times, Number::times);
                rest.join(&right, Number::minus, Number::minus)
            }
            1 => product.join(&r, Number::minus, Number::minus),
            _ => p.join(&q, Number::minus, Number::minus),
        };
        let exact = value.1.exact_sign();
        if let Some(sign) = value.0.sign() {
            assert_eq!(sign, exact, "round {round}: {}", value.1);
            told += 1;
            zeros += usize::from(sign.is_zero());
        }
        assert!(!value.0.is_zero() || exact.is_zero(), "round {round}");
        // p + q sqrt(r^2) is p + q |r|.
        let square = r.join(&r, Number::times, Number::times);
        if let Some(sign) = Fixed::sign_with_root(&p.0, &q.0, &square.0) {
            let expected = Surd::sign_with_root(&p.1, &q.1, &square.1);
            assert_eq!(sign, expected, "round {round}, with a root");
        }
    }
    assert!(zeros >= least_zeros, "only {zeros} zeros were seen");
    assert!(told >= ROUNDS / 2, "only {told} signs were told");
}

#[test]
fn signs_in_machine_integers_are_right() {
    signs_agree::<i128>(30, 400);
}

#[test]
fn signs_in_limbs_are_right() {
    for bits in [10, 60, 110, 300] {
        signs_agree::<Limbs>(bits, 400);
    }
}

#[test]
fn signs_in_short_integers_are_right() {
    for bits in [10, 60] {
        signs_agree::<Short>(bits, 400);
    }
}

/// A sum of roots is the sum of its parts, and unknown if one of them is.
#[test]
fn sums_of_roots_are_sums() {
    println!("seed {SEED:#x}");
    let random = &mut Random(SEED);
    let radicals = Rc::new(Radicals::default());
    let numbers: Vec<u32> = [2_u32, 3, 5, 7]
        .map(|root| radicals.number(UBig::from(root)).unwrap())
        .to_vec();
    for _ in 0..2_000 {
        let mut part = || {
            let root = random.below(5) as usize;
            let root = if root == 4 { 0 } else { numbers[root] };
            (Short::from_int(&integer(random, 8)), root)
        };
        let parts = [part(), part(), part()];
        let one_by_one = parts.iter().fold(Fixed::zero(), |sum, &(i, root)| {
            let part = if root == 0 {
                Fixed::from_integer(i)
            } else {
                Fixed::from_integer(i).times(&Fixed::scaled_root(
                    Short::from_i128(1),
                    root,
                    &radicals,
                ))
            };
            sum.plus(&part)
        });
        let sum = Fixed::sum_of_roots(parts, &radicals);
        assert!(sum.minus(&one_by_one).is_zero(), "{parts:?}");
        assert_eq!(sum.sign(), one_by_one.sign());
    }
    let unknown = Fixed::sum_of_roots([(Some(Short::ZERO), 0), (None, numbers[0])], &radicals);
    assert_eq!(unknown.sign(), None);
}

#[test]
fn what_does_not_fit_abstains() {
    let large: Fixed<i128> = Fixed::from_i64(i64::MAX);
    let square = large.times(&large);
    assert_eq!(square.sign(), Some(Sign::Positive));
    assert_eq!(square.times(&large).sign(), None);
    // Nothing comes of what is not known, not even times zero.
    assert_eq!(square.times(&large).times(&Fixed::zero()).sign(), None);
    assert!(square.times(&large).to_ball_dd().is_none());
}

#[test]
fn roots_that_nearly_cancel_are_left_to_digits() {
    // sqrt(n^2 + 1) - n is about 1 / 2n, here a part of 2^-119 of either.
    let n = IBig::ONE << 59;
    let square = UBig::try_from(&n * &n + IBig::ONE).expect("positive");
    let radicals = Rc::new(Radicals::default());
    let root: Fixed<Limbs> = Fixed::scaled_root(
        Limbs::from_i128(1),
        radicals.number(square.clone()).unwrap(),
        &radicals,
    );
    let difference = root.minus(&Fixed::from_integer(Limbs::from_int(&n)));
    assert_eq!(difference.sign(), None);
    let difference = Wide::sqrt_of(&square).minus(&Wide::from_int(&n));
    assert_eq!(difference.sign(), Some(Sign::Positive));
}
