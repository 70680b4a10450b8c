//! The third rung: exact sums of square roots.
//!
//! A surd is c₀ + Σ c_k·√r_k with integers c_k ≠ 0 and different integers r_k > 1, sorted.
//! Sums and products of surds are surds. The radicands of a surd may share a square class
//! (√2 and √8): telling costs a root per pair, so only [`sign`](Number::sign) asks, and only
//! where a double-double cannot tell. How it does is in `surd_sign`.

use crate::square::perfect_root;
use crate::{Number, Sign};
use dashu_int::ops::Gcd;
use dashu_int::{IBig, UBig};
use std::cmp::Ordering;
use std::fmt;

/// One c·√r.
#[derive(Clone, Debug)]
pub(crate) struct Term {
    pub(crate) radicand: UBig,
    pub(crate) coefficient: IBig,
}

/// In a `Vec`, so that integers, the most frequent surds, are moved and dropped at little cost.
pub(crate) type Terms = Vec<Term>;

/// An exact number: a sum of integer multiples of square roots of positive integers.
///
/// A `Surd` without radicals is an integer and costs little more than one.
///
/// ```
/// use hipline_num::{Number, Sign, Surd, UBig};
/// let root = |r: u32| Surd::sqrt_of(&UBig::from(r));
/// assert_eq!(root(2).plus(&root(8)).minus(&root(18)).sign(), Some(Sign::Zero));
/// assert_eq!(root(2).times(&root(3)).minus(&root(6)).sign(), Some(Sign::Zero));
/// assert_eq!(root(2).plus(&root(3)).minus(&root(10)).sign(), Some(Sign::Negative));
/// ```
#[derive(Clone, Debug)]
pub struct Surd {
    pub(crate) rational: IBig,
    /// Sorted by radicand, which is above 1; no coefficient is 0.
    pub(crate) terms: Terms,
}

impl Surd {
    /// An integer.
    #[must_use]
    pub fn from_int(i: IBig) -> Self {
        Self {
            rational: i,
            terms: Terms::new(),
        }
    }

    /// √r; an integer if r is a perfect square.
    #[must_use]
    pub fn sqrt_of(r: &UBig) -> Self {
        Self::scaled_sqrt(IBig::ONE, r)
    }

    /// c·√r.
    #[must_use]
    pub fn scaled_sqrt(c: IBig, r: &UBig) -> Self {
        if c.is_zero() || r.is_zero() {
            return Self::zero();
        }
        if let Some(root) = perfect_root(r) {
            return Self::from_int(c * root);
        }
        let terms = vec![Term {
            radicand: r.clone(),
            coefficient: c,
        }];
        Self {
            rational: IBig::ZERO,
            terms,
        }
    }

    /// The value as an integer, if it is written without radicals.
    #[must_use]
    pub fn as_int(&self) -> Option<&IBig> {
        self.terms.is_empty().then_some(&self.rational)
    }

    /// How many radicals it is written with.
    #[must_use]
    pub fn radicals(&self) -> usize {
        self.terms.len()
    }

    /// The sign; this rung never abstains.
    #[must_use]
    pub fn exact_sign(&self) -> Sign {
        self.decide_sign()
    }

    /// The product with an integer.
    #[must_use]
    pub fn times_int(&self, i: &IBig) -> Self {
        if i.is_zero() {
            return Self::zero();
        }
        let times = |t: &Term| Term {
            radicand: t.radicand.clone(),
            coefficient: &t.coefficient * i,
        };
        Self {
            rational: &self.rational * i,
            terms: self.terms.iter().map(times).collect(),
        }
    }

    /// The product with 2^k.
    #[must_use]
    pub fn shifted(&self, k: usize) -> Self {
        if k == 0 {
            return self.clone();
        }
        let mut result = self.clone();
        result.rational <<= k;
        for term in &mut result.terms {
            term.coefficient <<= k;
        }
        result
    }

    /// self + o, or self − o if `subtract`.
    fn merged(&self, o: &Self, subtract: bool) -> Self {
        let rational = if subtract {
            &self.rational - &o.rational
        } else {
            &self.rational + &o.rational
        };
        if o.terms.is_empty() {
            return Self {
                rational,
                terms: self.terms.clone(),
            };
        }
        let signed = |t: &Term| Term {
            radicand: t.radicand.clone(),
            coefficient: if subtract {
                -&t.coefficient
            } else {
                t.coefficient.clone()
            },
        };
        let mut terms = Terms::with_capacity(self.terms.len() + o.terms.len());
        let (mut a, mut b) = (self.terms.iter().peekable(), o.terms.iter().peekable());
        loop {
            let order = match (a.peek(), b.peek()) {
                (None, None) => break,
                (Some(_), None) => Ordering::Less,
                (None, Some(_)) => Ordering::Greater,
                (Some(x), Some(y)) => x.radicand.cmp(&y.radicand),
            };
            match order {
                Ordering::Less => terms.extend(a.next().cloned()),
                Ordering::Greater => terms.extend(b.next().map(signed)),
                Ordering::Equal => {
                    if let (Some(x), Some(y)) = (a.next(), b.next()) {
                        let coefficient = if subtract {
                            &x.coefficient - &y.coefficient
                        } else {
                            &x.coefficient + &y.coefficient
                        };
                        if !coefficient.is_zero() {
                            terms.push(Term {
                                radicand: x.radicand.clone(),
                                coefficient,
                            });
                        }
                    }
                }
            }
        }
        Self { rational, terms }
    }

    /// Adds c·√r·√s, in a form with the smallest radicand that a gcd finds.
    ///
    /// With g = gcd(r, s), √r·√s = g·√(r/g · s/g); a perfect square among the two cofactors
    /// comes out of the root, and if both are, nothing of the root remains.
    fn add_product(&mut self, c: IBig, r: &UBig, s: &UBig) {
        let g = r.gcd(s);
        if g.is_one() {
            // Neither is a perfect square, and coprime as they are, nor is their product.
            self.terms.push(Term {
                radicand: r * s,
                coefficient: c,
            });
            return;
        }
        let (r, s) = (r / &g, s / &g);
        let mut c = c * g;
        let mut radicand = UBig::ONE;
        for cofactor in [r, s] {
            match perfect_root(&cofactor) {
                Some(root) => c *= root,
                None => radicand *= cofactor,
            }
        }
        if radicand.is_one() {
            self.rational += c;
        } else {
            self.terms.push(Term {
                radicand,
                coefficient: c,
            });
        }
    }

    /// Restores the order of terms and joins those of equal radicand.
    fn tidy(&mut self) {
        self.terms.sort_by(|a, b| a.radicand.cmp(&b.radicand));
        self.terms.dedup_by(|later, kept| {
            let same = later.radicand == kept.radicand;
            if same {
                kept.coefficient += &later.coefficient;
            }
            same
        });
        self.terms.retain(|t| !t.coefficient.is_zero());
    }
}

impl Number for Surd {
    fn zero() -> Self {
        Self::from_int(IBig::ZERO)
    }

    fn from_i64(i: i64) -> Self {
        Self::from_int(IBig::from(i))
    }

    fn plus(&self, o: &Self) -> Self {
        self.merged(o, false)
    }

    fn minus(&self, o: &Self) -> Self {
        self.merged(o, true)
    }

    fn times(&self, o: &Self) -> Self {
        if let Some(i) = o.as_int() {
            return self.times_int(i);
        }
        if let Some(i) = self.as_int() {
            return o.times_int(i);
        }
        let mut product = Self::from_int(&self.rational * &o.rational);
        let pairs = (self.terms.len() + 1) * (o.terms.len() + 1);
        product.terms.reserve(pairs - 1);
        for (a, b) in [(self, o), (o, self)] {
            if !a.rational.is_zero() {
                product.terms.extend(b.terms.iter().map(|t| Term {
                    radicand: t.radicand.clone(),
                    coefficient: &t.coefficient * &a.rational,
                }));
            }
        }
        for x in &self.terms {
            for y in &o.terms {
                let c = &x.coefficient * &y.coefficient;
                if x.radicand == y.radicand {
                    product.rational += c * &x.radicand;
                } else {
                    product.add_product(c, &x.radicand, &y.radicand);
                }
            }
        }
        product.tidy();
        product
    }

    fn negated(&self) -> Self {
        let mut result = self.clone();
        result.rational = -result.rational;
        for term in &mut result.terms {
            term.coefficient = -std::mem::take(&mut term.coefficient);
        }
        result
    }

    fn sign(&self) -> Option<Sign> {
        Some(self.decide_sign())
    }
}

impl fmt::Display for Surd {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.terms.is_empty() || !self.rational.is_zero() {
            write!(f, "{}", self.rational)?;
        }
        for (i, t) in self.terms.iter().enumerate() {
            if i == 0 && self.rational.is_zero() {
                write!(f, "{}√{}", t.coefficient, t.radicand)?;
            } else {
                write!(f, "{:+}√{}", t.coefficient, t.radicand)?;
            }
        }
        Ok(())
    }
}
