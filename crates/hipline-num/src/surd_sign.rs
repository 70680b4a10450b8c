//! The sign of a surd, and its enclosures.
//!
//! Zero is decided in integers. Square roots of integers in different square classes are
//! linearly independent over the rationals (Besicovitch 1940), so a surd is zero exactly when
//! the terms of each class add up to zero; d and e are in one class exactly when d·e is a
//! perfect square. Of a surd that is not zero, the sign is found by raising the precision
//! until the enclosure excludes zero: that ends, and no root separation bound is needed.

use crate::square::{Residues, joint_root};
use crate::surd::Surd;
use crate::{Ball, BallDd, Number, Sign};
use dashu_int::IBig;
use dashu_int::ops::{SquareRoot, UnsignedAbs};
use smallvec::SmallVec;

/// Integers lo ≤ hi with lo ≤ x·2^bits ≤ hi.
#[derive(Clone, Debug)]
pub(crate) struct Interval {
    pub(crate) lo: IBig,
    pub(crate) hi: IBig,
}

pub(crate) fn sign_of(i: &IBig) -> Sign {
    Sign::from(i.cmp(&IBig::ZERO))
}

impl Interval {
    pub(crate) fn sign(&self) -> Option<Sign> {
        let (lo, hi) = (sign_of(&self.lo), sign_of(&self.hi));
        (lo == hi).then_some(lo)
    }

    fn plus(&self, o: &Self) -> Self {
        Self {
            lo: &self.lo + &o.lo,
            hi: &self.hi + &o.hi,
        }
    }

    /// The product, at the sum of both scales.
    fn times(&self, o: &Self) -> Self {
        let products = [
            &self.lo * &o.lo,
            &self.lo * &o.hi,
            &self.hi * &o.lo,
            &self.hi * &o.hi,
        ];
        let lo = products.iter().min().cloned().unwrap_or_default();
        let hi = products.into_iter().max().unwrap_or_default();
        Self { lo, hi }
    }

    /// The root of a quantity that is not negative, at the same scale of 2^bits.
    fn sqrt(&self, bits: usize) -> Self {
        let root = |x: &IBig| {
            if x.sign() == dashu_int::Sign::Negative {
                return IBig::ZERO;
            }
            IBig::from((x.unsigned_abs() << bits).sqrt())
        };
        Self {
            lo: root(&self.lo),
            hi: root(&self.hi) + IBig::ONE,
        }
    }
}

impl Surd {
    /// An enclosure at the scale 2^bits; it is no wider than the sum of the |c_k|.
    pub(crate) fn enclose(&self, bits: usize) -> Interval {
        let mut lo = &self.rational << bits;
        let mut slack = IBig::ZERO;
        for t in &self.terms {
            let root = (&t.radicand << (2 * bits)).sqrt();
            // root ≤ √r·2^bits < root + 1
            lo += &t.coefficient * root;
            if t.coefficient.sign() == dashu_int::Sign::Negative {
                lo += &t.coefficient;
                slack -= &t.coefficient;
            } else {
                slack += &t.coefficient;
            }
        }
        Interval {
            hi: &lo + slack,
            lo,
        }
    }

    /// The nearest that a double-double comes to it.
    #[must_use]
    pub fn to_ball_dd(&self) -> BallDd {
        let mut sum = BallDd::from_int(&self.rational);
        for t in &self.terms {
            let root = BallDd::from_words(t.radicand.as_words()).sqrt();
            sum = sum.plus(&BallDd::from_int(&t.coefficient).times(&root));
        }
        sum
    }

    /// The nearest that an f64 comes to it.
    #[must_use]
    pub fn to_ball(&self) -> Ball {
        let mut sum = Ball::from_int(&self.rational);
        for t in &self.terms {
            let root = Ball::from_int(t.radicand.as_ibig()).sqrt();
            sum = sum.plus(&Ball::from_int(&t.coefficient).times(&root));
        }
        sum
    }

    pub(crate) fn decide_sign(&self) -> Sign {
        let rational = sign_of(&self.rational);
        let Some(first) = self.terms.first() else {
            return rational;
        };
        let leading = sign_of(&first.coefficient);
        let agree = |s: Sign| s == leading;
        if self.terms.iter().all(|t| agree(sign_of(&t.coefficient)))
            && (rational.is_zero() || agree(rational))
        {
            return leading;
        }
        if let Some(sign) = self.to_ball_dd().sign() {
            return sign;
        }
        if self.is_zero_by_classes() {
            return Sign::Zero;
        }
        // What the double-double left is below 2^-95 times the largest term: start beyond.
        let mut bits = 64;
        loop {
            if let Some(sign) = self.enclose(bits).sign() {
                return sign;
            }
            bits *= 2;
        }
    }

    /// Whether the terms of every square class add up to zero.
    ///
    /// With d the first radicand of a class, √e = √(d·e)/d·√d for every e in it; so the class
    /// adds up to (c_d·d + Σ c_e·√(d·e))/d·√d.
    pub(crate) fn is_zero_by_classes(&self) -> bool {
        // A rational number is a class of its own: no radicand is a perfect square.
        if !self.rational.is_zero() {
            return false;
        }
        let residues: SmallVec<[Residues; 8]> = self
            .terms
            .iter()
            .map(|t| Residues::of(&t.radicand))
            .collect();
        let mut done: SmallVec<[bool; 8]> = SmallVec::from_elem(false, self.terms.len());
        for (i, first) in self.terms.iter().enumerate() {
            if done[i] {
                continue;
            }
            let mut sum = &first.coefficient * &first.radicand;
            for (j, t) in self.terms.iter().enumerate().skip(i + 1) {
                if done[j] {
                    continue;
                }
                let (d, e) = ((&first.radicand, residues[i]), (&t.radicand, residues[j]));
                if let Some(root) = joint_root(d, e) {
                    sum += &t.coefficient * root;
                    done[j] = true;
                }
            }
            if !sum.is_zero() {
                return false;
            }
        }
        true
    }

    /// The exact sign of a + b·√delta.
    ///
    /// If a and b differ in sign, the larger of |a| and |b|·√delta decides: the sign of
    /// a² − b²·delta, a surd again. That surd has many terms, so enclosures of 128 to 1024 bits
    /// are tried first.
    ///
    /// # Panics
    ///
    /// If `delta` is negative.
    #[must_use]
    pub fn sign_with_root(a: &Self, b: &Self, delta: &Self) -> Sign {
        let radical = delta.decide_sign();
        assert!(
            !radical.is_negative(),
            "the root of a negative number: {delta}"
        );
        let (sa, sb) = (a.decide_sign(), b.decide_sign() * radical);
        if sb.is_zero() || sa == sb {
            return sa;
        }
        if sa.is_zero() {
            return sb;
        }
        let root = delta.to_ball_dd().sqrt();
        if let Some(sign) = a.to_ball_dd().plus(&b.to_ball_dd().times(&root)).sign() {
            return sign;
        }
        for bits in [128, 256, 512, 1024] {
            let root = delta.enclose(bits).sqrt(bits);
            let product = b.enclose(bits).times(&root);
            let (a, scale) = (a.enclose(bits), &(IBig::ONE << bits));
            let a = Interval {
                lo: a.lo * scale,
                hi: a.hi * scale,
            };
            if let Some(sign) = a.plus(&product).sign() {
                return sign;
            }
        }
        let difference = a.times(a).minus(&b.times(b).times(delta));
        difference.decide_sign() * sa
    }
}
