//! Perfect squares, and the square classes of positive integers.
//!
//! d and e are in one class if d·e is a perfect square, that is if √d/√e is rational.

use dashu_int::UBig;
use dashu_int::ops::SquareRootRem;

/// 63·65·11 = 45045, coprime to 64: one division serves three filters.
const MODULUS: u64 = 63 * 65 * 11;

/// The residues modulo `n` ≤ 65 that squares leave, as a bit set.
const fn squares_modulo(n: u128) -> u128 {
    let mut set = 0;
    let mut i = 0;
    while i < n {
        set |= 1 << (i * i % n);
        i += 1;
    }
    set
}

const SQUARES_64: u128 = squares_modulo(64);
const SQUARES_63: u128 = squares_modulo(63);
const SQUARES_65: u128 = squares_modulo(65);
const SQUARES_11: u128 = squares_modulo(11);

/// What the filters need to know of an integer. Residues of a product are products of residues.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Residues {
    low: u64,
    rest: u64,
}

impl Residues {
    pub(crate) fn of(n: &UBig) -> Self {
        Self {
            low: u64::from(n & 63u8),
            rest: n % MODULUS,
        }
    }

    fn times(self, o: Self) -> Self {
        Self {
            low: (self.low * o.low) & 63,
            rest: self.rest * o.rest % MODULUS,
        }
    }

    /// False for 99.2 % of the integers that are not squares, true for all squares.
    fn may_be_square(self) -> bool {
        let in_set = |set: u128, residue: u64| (set >> residue) & 1 == 1;
        in_set(SQUARES_64, self.low)
            && in_set(SQUARES_63, self.rest % 63)
            && in_set(SQUARES_65, self.rest % 65)
            && in_set(SQUARES_11, self.rest % 11)
    }
}

/// The square root of `n` if `n` is a perfect square.
///
/// Residues modulo 64, 63, 65 and 11 reject most other integers before a root is taken.
///
/// ```
/// use hipline_num::{UBig, perfect_root};
/// assert_eq!(perfect_root(&UBig::from(49u8)), Some(UBig::from(7u8)));
/// assert_eq!(perfect_root(&UBig::from(50u8)), None);
/// ```
#[must_use]
pub fn perfect_root(n: &UBig) -> Option<UBig> {
    if !Residues::of(n).may_be_square() {
        return None;
    }
    exact_root(n)
}

fn exact_root(n: &UBig) -> Option<UBig> {
    let (root, rest) = n.sqrt_rem();
    rest.is_zero().then_some(root)
}

/// √(d·e) if d and e are in the same square class.
pub(crate) fn joint_root(d: (&UBig, Residues), e: (&UBig, Residues)) -> Option<UBig> {
    if !d.1.times(e.1).may_be_square() {
        return None;
    }
    exact_root(&(d.0 * e.0))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn perfect_roots_are_found_and_nothing_else() {
        let mut next = 0u32;
        for n in 0u32..100_000 {
            let expected = (n == next * next).then(|| UBig::from(next));
            assert_eq!(perfect_root(&UBig::from(n)), expected, "{n}");
            next += u32::from(expected.is_some());
        }
    }

    #[test]
    fn classes_are_told_apart() {
        let root = |d: u32, e: u32| {
            let (d, e) = (UBig::from(d), UBig::from(e));
            joint_root((&d, Residues::of(&d)), (&e, Residues::of(&e)))
        };
        assert_eq!(root(2, 8), Some(UBig::from(4u8)));
        assert_eq!(root(18, 50), Some(UBig::from(30u8)));
        assert_eq!(root(2, 3), None);
        assert_eq!(root(6, 8), None);
    }
}
