//! Machine integers that say so where a result does not fit: the rung of figures on a grid whose lengths are
//! integers, too.

use crate::{Number, Sign};

/// An integer, or nothing if it did not fit.
#[derive(Clone, Copy, Debug)]
pub struct Whole(pub Option<i128>);

impl Whole {
    /// The sign of a + b·√delta, where delta is not negative, if it can be told.
    #[must_use]
    pub fn sign_with_root(a: &Self, b: &Self, delta: &Self) -> Option<Sign> {
        let (p, q) = (a.sign()?, b.sign()? * delta.sign()?);
        if p == q || p.is_zero() {
            return Some(q);
        }
        if q.is_zero() {
            return Some(p);
        }
        let difference = a.times(a).minus(&b.times(b).times(delta)).sign()?;
        Some(difference * p)
    }
}

impl Number for Whole {
    #[inline]
    fn zero() -> Self {
        Self(Some(0))
    }
    #[inline]
    fn from_i64(i: i64) -> Self {
        Self(Some(i.into()))
    }
    #[inline]
    fn plus(&self, o: &Self) -> Self {
        Self(self.0.zip(o.0).and_then(|(a, b)| a.checked_add(b)))
    }
    #[inline]
    fn minus(&self, o: &Self) -> Self {
        Self(self.0.zip(o.0).and_then(|(a, b)| a.checked_sub(b)))
    }
    #[inline]
    fn times(&self, o: &Self) -> Self {
        let product = |(a, b): (i128, i128)| match (i64::try_from(a), i64::try_from(b)) {
            // Most factors are short; their product needs no test.
            (Ok(a), Ok(b)) => Some(i128::from(a) * i128::from(b)),
            _ => a.checked_mul(b),
        };
        Self(self.0.zip(o.0).and_then(product))
    }
    #[inline]
    fn negated(&self) -> Self {
        Self(self.0.and_then(i128::checked_neg))
    }
    #[inline]
    fn sign(&self) -> Option<Sign> {
        self.0.map(|i| Sign::from(i.cmp(&0)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_does_not_fit_abstains() {
        let large = Whole(Some(i128::MAX));
        assert_eq!(large.plus(&Whole::from_i64(1)).sign(), None);
        assert_eq!(large.times(&Whole::from_i64(2)).sign(), None);
        assert_eq!(Whole(Some(i128::MIN)).negated().sign(), None);
        // Nothing comes of what is not known, not even times zero.
        let unknown = large.times(&large);
        assert_eq!(unknown.times(&Whole::zero()).sign(), None);
        assert_eq!(Whole::sign_with_root(&unknown, &large, &large), None);
    }

    #[test]
    fn signs_with_roots_are_right() {
        #[expect(clippy::disallowed_methods, reason = "far from zero, or a square")]
        let near = |a: i64, b: i64, delta: i64| a as f64 + b as f64 * (delta as f64).sqrt();
        for a in -12..=12 {
            for b in -5..=5 {
                for delta in 0..=10 {
                    let value = near(a, b, delta);
                    let expected = if value.abs() < 1e-9 { 0.0 } else { value };
                    let [a, b, delta] = [a, b, delta].map(Whole::from_i64);
                    let sign = Whole::sign_with_root(&a, &b, &delta);
                    assert_eq!(sign, expected.partial_cmp(&0.0).map(Sign::from));
                }
            }
        }
    }
}
