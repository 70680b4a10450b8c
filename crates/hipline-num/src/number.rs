//! What every rung of the ladder can do.

use crate::Sign;
use std::fmt::Debug;

/// A commutative ring whose elements know their sign, or abstain.
///
/// Predicates are written once, for any `Number`, and asked of [`Ball`](crate::Ball), then
/// [`BallDd`](crate::BallDd), then [`Surd`](crate::Surd). The laws: the operations are those
/// of the real numbers, and a sign that is given is the sign of the real number.
pub trait Number: Clone + Debug {
    /// The exact integer zero.
    fn zero() -> Self;
    /// The integer `i`; exact for |i| ≤ 2^53 in every type.
    fn from_i64(i: i64) -> Self;
    /// The sum.
    #[must_use]
    fn plus(&self, o: &Self) -> Self;
    /// The difference.
    #[must_use]
    fn minus(&self, o: &Self) -> Self;
    /// The product.
    #[must_use]
    fn times(&self, o: &Self) -> Self;
    /// The negation.
    #[must_use]
    fn negated(&self) -> Self;
    /// The sign if it is proven, `None` if this type abstains; a `Surd` never abstains.
    fn sign(&self) -> Option<Sign>;
}

/// The sign of a + b·√delta, where delta is not negative, from signs of polynomials.
pub(crate) fn sign_with_root<T: Number>(a: &T, b: &T, delta: &T) -> Option<Sign> {
    let (p, q) = (a.sign()?, b.sign()? * delta.sign()?);
    if p == q || q.is_zero() {
        return Some(p);
    }
    if p.is_zero() {
        return Some(q);
    }
    let difference = a.times(a).minus(&b.times(b).times(delta)).sign()?;
    Some(difference * p)
}
