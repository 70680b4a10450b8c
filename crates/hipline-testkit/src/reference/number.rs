//! Exact numbers: sums of integers times square roots of integers.
//!
//! All radicands of one input are written over a *coprime base*: pairwise coprime integers none
//! of which is a square. A product of a subset of the base is then never a square unless the
//! subset is empty, so the square roots of the subsets are linearly independent over the
//! rationals (Besicovitch 1940), and a sum is zero exactly when every coefficient is. A subset
//! is a bit mask, and a product of two roots is an exclusive or.
//!
//! Deliberately simple and without any floating point: this is what the fast numbers are
//! tested against.

use std::cell::RefCell;
use std::cmp::Ordering;
use std::collections::HashMap;

use dashu_int::IBig;
use dashu_int::ops::{Abs, Gcd, SquareRoot};

/// A subset of the base.
pub(super) type Mask = u128;

/// A sum of `coefficient * sqrt(product of the subset)`; no coefficient is zero, subsets ascend.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Num {
    terms: Vec<(Mask, IBig)>,
}

impl From<IBig> for Num {
    fn from(value: IBig) -> Self {
        Self::term(0, value)
    }
}

impl Num {
    /// One term.
    pub(super) fn term(mask: Mask, value: IBig) -> Self {
        if value == IBig::ZERO {
            Self::default()
        } else {
            Self {
                terms: vec![(mask, value)],
            }
        }
    }

    /// Exactly zero?
    #[must_use]
    pub fn is_zero(&self) -> bool {
        self.terms.is_empty()
    }

    fn combine(&self, other: &Self, negate: bool) -> Self {
        let mut terms = Vec::with_capacity(self.terms.len() + other.terms.len());
        let (mut i, mut j) = (0, 0);
        while i < self.terms.len() || j < other.terms.len() {
            let order = match (self.terms.get(i), other.terms.get(j)) {
                (Some(a), Some(b)) => a.0.cmp(&b.0),
                (Some(_), None) => Ordering::Less,
                _ => Ordering::Greater,
            };
            if order == Ordering::Less {
                terms.push(self.terms[i].clone());
                i += 1;
                continue;
            }
            let (mask, right) = &other.terms[j];
            j += 1;
            let right = if negate { -right } else { right.clone() };
            if order == Ordering::Greater {
                terms.push((*mask, right));
                continue;
            }
            let sum = &self.terms[i].1 + right;
            i += 1;
            if sum != IBig::ZERO {
                terms.push((*mask, sum));
            }
        }
        Self { terms }
    }

    /// The sum.
    pub(super) fn plus(&self, other: &Self) -> Self {
        self.combine(other, false)
    }

    /// The difference.
    pub(super) fn minus(&self, other: &Self) -> Self {
        self.combine(other, true)
    }

    /// The number times an integer.
    pub(super) fn times(&self, factor: &IBig) -> Self {
        if *factor == IBig::ZERO {
            return Self::default();
        }
        Self {
            terms: self
                .terms
                .iter()
                .map(|(mask, c)| (*mask, c * factor))
                .collect(),
        }
    }

    /// The opposite.
    pub(super) fn opposite(&self) -> Self {
        Self {
            terms: self.terms.iter().map(|(mask, c)| (*mask, -c)).collect(),
        }
    }

    /// The greatest common divisor of `start` and all coefficients; 0 stands for "none yet".
    pub(super) fn content(&self, start: IBig) -> IBig {
        let mut gcd = start;
        for (_, c) in &self.terms {
            if gcd == IBig::ONE {
                break;
            }
            gcd = if gcd == IBig::ZERO {
                c.clone().abs()
            } else {
                IBig::from(gcd.gcd(c))
            };
        }
        gcd
    }

    /// The number divided by an integer that divides every coefficient.
    pub(super) fn shrink(&mut self, divisor: &IBig) {
        for (_, c) in &mut self.terms {
            *c = &*c / divisor;
        }
    }

    /// The integers `(p, q)` with `self / other == p / q`, if the ratio is rational.
    pub(super) fn rational_ratio(&self, other: &Self) -> Option<(IBig, IBig)> {
        if self.is_zero() {
            return Some((IBig::ZERO, IBig::ONE));
        }
        let (p, q) = (&self.terms[0].1, &other.terms.first()?.1);
        let proportional = self.terms.len() == other.terms.len()
            && self
                .terms
                .iter()
                .zip(&other.terms)
                .all(|(a, b)| a.0 == b.0 && &a.1 * q == &b.1 * p);
        proportional.then(|| (p.clone(), q.clone()))
    }
}

/// The coprime base of one input, and its square roots to the precisions asked for so far.
#[derive(Debug, Clone, Default)]
pub struct Field {
    base: Vec<IBig>,
    roots: RefCell<HashMap<(Mask, usize), IBig>>,
}

impl Field {
    /// The field that contains the square roots of the given positive integers.
    ///
    /// # Panics
    /// If the base has more than 128 elements.
    pub(super) fn new<'a>(radicands: impl IntoIterator<Item = &'a IBig>) -> Self {
        let mut base: Vec<IBig> = Vec::new();
        for radicand in radicands {
            let mut queue = vec![radicand.clone()];
            while let Some(new) = queue.pop() {
                if new == IBig::ONE {
                    continue;
                }
                if let Some(root) = exact_root(&new) {
                    queue.push(root);
                    continue;
                }
                let clash = base.iter().enumerate().find_map(|(i, old)| {
                    let gcd = IBig::from(old.gcd(&new));
                    (gcd != IBig::ONE).then_some((i, gcd))
                });
                let Some((i, gcd)) = clash else {
                    base.push(new);
                    continue;
                };
                let old = base.swap_remove(i);
                let rest = without(&new, &gcd);
                if old == gcd {
                    // What is left of the new number has lost a factor; the old one stays.
                    base.push(old);
                    queue.push(rest);
                } else {
                    queue.extend([without(&old, &gcd), gcd, rest]);
                }
            }
        }
        assert!(
            base.len() <= Mask::BITS as usize,
            "{} square classes are too many",
            base.len()
        );
        Self {
            base,
            roots: RefCell::default(),
        }
    }

    /// The square root of one of the integers the field was made for (or a product of such).
    ///
    /// # Panics
    /// If it is not in the field.
    pub(super) fn root(&self, radicand: &IBig) -> Num {
        let (mut rest, mut outside, mut mask) = (radicand.clone(), IBig::ONE, 0);
        for (i, b) in self.base.iter().enumerate() {
            while &rest % b == IBig::ZERO {
                rest /= b;
                if mask & (1 << i) != 0 {
                    outside *= b;
                }
                mask ^= 1 << i;
            }
        }
        outside *= exact_root(&rest).expect("the square root lies in the field");
        Num::term(mask, outside)
    }

    /// The product.
    pub(super) fn mul(&self, a: &Num, b: &Num) -> Num {
        if let [(0, factor)] = b.terms.as_slice() {
            return a.times(factor);
        }
        if let [(0, factor)] = a.terms.as_slice() {
            return b.times(factor);
        }
        let mut terms: Vec<(Mask, IBig)> = Vec::with_capacity(a.terms.len() * b.terms.len());
        for (m, c) in &a.terms {
            for (k, d) in &b.terms {
                let mut product = c * d;
                let mut common = m & k;
                while common != 0 {
                    product *= &self.base[common.trailing_zeros() as usize];
                    common &= common - 1;
                }
                match terms.iter_mut().find(|term| term.0 == m ^ k) {
                    Some(term) => term.1 += product,
                    None => terms.push((m ^ k, product)),
                }
            }
        }
        terms.retain(|(_, c)| *c != IBig::ZERO);
        terms.sort_unstable_by_key(|term| term.0);
        Num { terms }
    }

    /// `floor(sqrt(product of the subset) * 2^bits)`.
    fn scaled_root(&self, mask: Mask, bits: usize) -> IBig {
        let mut roots = self.roots.borrow_mut();
        let root = roots.entry((mask, bits)).or_insert_with(|| {
            let chosen = self
                .base
                .iter()
                .enumerate()
                .filter(|(i, _)| mask >> i & 1 == 1);
            let product = chosen.fold(IBig::ONE, |product, (_, b)| product * b);
            IBig::from((product << (2 * bits)).sqrt())
        });
        root.clone()
    }

    /// Integers `lo <= x * 2^bits <= hi`.
    pub(super) fn enclose(&self, x: &Num, bits: usize) -> (IBig, IBig) {
        let (mut lo, mut hi) = (IBig::ZERO, IBig::ZERO);
        for (mask, c) in &x.terms {
            if *mask == 0 {
                let exact = c << bits;
                lo += &exact;
                hi += exact;
                continue;
            }
            let product = c * self.scaled_root(*mask, bits);
            if *c > IBig::ZERO {
                lo += &product;
                hi += product + c;
            } else {
                hi += &product;
                lo += product + c;
            }
        }
        (lo, hi)
    }

    /// The sign.
    pub(super) fn sign(&self, x: &Num) -> Ordering {
        let positive = x.terms.iter().filter(|(_, c)| *c > IBig::ZERO).count();
        match (positive, x.terms.len()) {
            (0, 0) => return Ordering::Equal,
            (0, _) => return Ordering::Less,
            (p, n) if p == n => return Ordering::Greater,
            _ => {}
        }
        let mut bits = 64;
        loop {
            let (lo, hi) = self.enclose(x, bits);
            if lo > IBig::ZERO {
                return Ordering::Greater;
            }
            if hi < IBig::ZERO {
                return Ordering::Less;
            }
            bits *= 2;
        }
    }
}

/// The square root, if the number is a square.
fn exact_root(x: &IBig) -> Option<IBig> {
    let root = IBig::from(x.sqrt());
    (&root * &root == *x).then_some(root)
}

/// `x / gcd` for a divisor of `x`.
fn without(x: &IBig, divisor: &IBig) -> IBig {
    x / divisor
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn roots_of_one_class_share_a_term() {
        let numbers = [2, 8, 18, 5, 10, 12, 27, 3].map(IBig::from);
        let field = Field::new(&numbers);
        let [two, eight, eighteen, five, ten, ..] = numbers.clone().map(|n| field.root(&n));
        assert!(
            two.plus(&eight).minus(&eighteen).is_zero(),
            "1 + 2 = 3 roots of two"
        );
        assert!(
            field.mul(&two, &five).minus(&ten).is_zero(),
            "product of roots"
        );
        let square = field.mul(&ten, &ten);
        assert_eq!(square, Num::from(IBig::from(10)), "root squared");
        let sum = two.plus(&five).minus(&ten);
        assert_eq!(field.sign(&sum), Ordering::Greater, "1.41 + 2.24 > 3.16");
        for n in &numbers {
            let root = field.root(n);
            assert_eq!(field.mul(&root, &root), Num::from(n.clone()), "root of {n}");
        }
    }
}
