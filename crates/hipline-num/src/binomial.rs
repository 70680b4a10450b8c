//! Machine integers with one root: the rung of figures on a grid all of whose lengths are multiples of one
//! root, as where edges are parallel to the axes and to their bisectors, or lie alike.

use crate::{Integer, Number, Sign, number::sign_with_root};

/// `a + b √r` in integers with a sign of their own, or nothing if something did not fit.
#[derive(Clone, Copy, Debug)]
pub struct Binomial {
    parts: Option<[i128; 2]>,
    /// Not a square; zero if there is no root.
    radicand: u64,
}

impl Binomial {
    /// A number of which nothing is known.
    pub const UNKNOWN: Self = Self {
        parts: None,
        radicand: 0,
    };

    /// An integer.
    #[inline]
    #[must_use]
    pub const fn whole(i: i128) -> Self {
        Self {
            parts: Some([i, 0]),
            radicand: 0,
        }
    }

    /// The root of an integer that is not a square. Numbers with different roots must not meet.
    #[inline]
    #[must_use]
    pub const fn root_of(radicand: u64) -> Self {
        Self {
            parts: Some([0, 1]),
            radicand,
        }
    }

    #[inline]
    fn join(
        &self,
        o: &Self,
        join: impl FnOnce([i128; 2], [i128; 2], i128) -> Option<[i128; 2]>,
    ) -> Self {
        debug_assert!(self.radicand == 0 || o.radicand == 0 || self.radicand == o.radicand);
        let radicand = self.radicand | o.radicand;
        let parts = match (self.parts, o.parts) {
            (Some(p), Some(q)) => join(p, q, radicand.into()),
            _ => None,
        };
        Self { parts, radicand }
    }

    /// The sign of a + b·√delta, where delta is not negative, if it can be told.
    #[must_use]
    pub fn sign_with_root(a: &Self, b: &Self, delta: &Self) -> Option<Sign> {
        sign_with_root(a, b, delta)
    }
}

impl Number for Binomial {
    #[inline]
    fn zero() -> Self {
        Self::whole(0)
    }
    #[inline]
    fn from_i64(i: i64) -> Self {
        Self::whole(i.into())
    }
    #[inline]
    fn plus(&self, o: &Self) -> Self {
        self.join(o, |[a, b], [c, d], _| {
            Some([Integer::plus(&a, &c)?, Integer::plus(&b, &d)?])
        })
    }
    #[inline]
    fn minus(&self, o: &Self) -> Self {
        self.join(o, |[a, b], [c, d], _| {
            Some([Integer::minus(&a, &c)?, Integer::minus(&b, &d)?])
        })
    }
    #[inline]
    fn times(&self, o: &Self) -> Self {
        self.join(o, |[a, b], [c, d], radicand| {
            let whole = Integer::times(&a, &c)?;
            if b == 0 && d == 0 {
                return Some([whole, 0]);
            }
            let part = Integer::plus(&Integer::times(&a, &d)?, &Integer::times(&b, &c)?)?;
            if b == 0 || d == 0 {
                return Some([whole, part]);
            }
            let square = Integer::times(&Integer::times(&b, &d)?, &radicand)?;
            Some([Integer::plus(&whole, &square)?, part])
        })
    }
    #[inline]
    fn negated(&self) -> Self {
        Self::zero().minus(self)
    }
    fn sign(&self) -> Option<Sign> {
        let [a, b] = self.parts?;
        let (p, q) = (Integer::sign(&a), Integer::sign(&b));
        if p == q || q.is_zero() {
            return Some(p);
        }
        if p.is_zero() {
            return Some(q);
        }
        let radicand = i128::from(self.radicand);
        let root = radicand.to_ball_dd().sqrt();
        let near = a.to_ball_dd().plus(&b.to_ball_dd().times(&root));
        near.sign().or_else(|| {
            let [a, b] = [Integer::times(&a, &a)?, Integer::times(&b, &b)?];
            let difference = Integer::minus(&a, &Integer::times(&b, &radicand)?)?;
            Some(p * Integer::sign(&difference))
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{IBig, Surd, UBig};

    #[test]
    fn what_does_not_fit_abstains() {
        let large = Binomial::whole(i128::MAX);
        assert_eq!(large.plus(&Binomial::from_i64(1)).sign(), None);
        assert_eq!(large.times(&Binomial::from_i64(2)).sign(), None);
        assert_eq!(Binomial::whole(i128::MIN).negated().sign(), None);
        // Nothing comes of what is not known, not even times zero.
        let unknown = large.times(&large);
        assert_eq!(unknown.times(&Binomial::zero()).sign(), None);
        assert_eq!(Binomial::sign_with_root(&unknown, &large, &large), None);
    }

    #[test]
    fn signs_are_those_of_exact_numbers() {
        let seed: u64 = 0x0b1e_5eed;
        println!("seed {seed:#x}");
        let mut state = seed;
        let mut random = |size: i64| {
            state ^= state << 13;
            state ^= state >> 7;
            state ^= state << 17;
            (state >> 2) as i64 % size - size / 2
        };
        let (mut zeros, mut unknown) = (0, 0);
        for round in 0..20_000 {
            let size = [5, 9, 1 << 20, 1 << 40][round % 4];
            let radicand = [2, 5, 37][round % 3];
            let mut number = || {
                let [a, b] = [random(size), random(size)];
                let root = Binomial::root_of(radicand).times(&Binomial::from_i64(b));
                let surd = Surd::sqrt_of(&UBig::from(radicand)).times(&Surd::from_i64(b));
                (
                    Binomial::from_i64(a).plus(&root),
                    Surd::from_int(IBig::from(a)).plus(&surd),
                )
            };
            let [(p, x), (q, y), (r, z)] = [number(), number(), number()];
            // p q - r² + r: nothing, if all are small, now and then.
            let value = p.times(&q).minus(&r.times(&r)).plus(&r);
            let exact = x.times(&y).minus(&z.times(&z)).plus(&z);
            match value.sign() {
                Some(sign) => {
                    assert_eq!(sign, exact.exact_sign(), "{exact}");
                    zeros += usize::from(sign.is_zero());
                }
                None => unknown += 1,
            }
            // p + q |r| as p + q √(r²).
            let square = r.times(&r);
            if let Some(sign) = Binomial::sign_with_root(&p, &q, &square) {
                let expected = Surd::sign_with_root(&x, &y, &z.times(&z));
                assert_eq!(sign, expected, "with a root");
            } else {
                unknown += 1;
            }
        }
        assert!(
            zeros > 50 && unknown < 12_000,
            "{zeros} zeros, {unknown} not told"
        );
    }
}
