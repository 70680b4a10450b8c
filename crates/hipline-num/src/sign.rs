//! The sign of a real number.

use std::cmp::Ordering;
use std::ops::{Mul, Neg};

/// Negative, zero or positive.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
#[repr(i8)]
pub enum Sign {
    /// Less than zero.
    Negative = -1,
    /// Zero as a real number, never "too small to tell".
    Zero = 0,
    /// Greater than zero.
    Positive = 1,
}

impl Sign {
    /// The sign of a small integer.
    #[inline]
    #[must_use]
    pub const fn of_i8(i: i8) -> Self {
        match i {
            0 => Self::Zero,
            i if i < 0 => Self::Negative,
            _ => Self::Positive,
        }
    }

    /// Whether the number is less than zero.
    #[inline]
    #[must_use]
    pub const fn is_negative(self) -> bool {
        matches!(self, Self::Negative)
    }

    /// Whether the number is zero.
    #[inline]
    #[must_use]
    pub const fn is_zero(self) -> bool {
        matches!(self, Self::Zero)
    }

    /// Whether the number is greater than zero.
    #[inline]
    #[must_use]
    pub const fn is_positive(self) -> bool {
        matches!(self, Self::Positive)
    }

    /// How the number compares with zero.
    #[inline]
    #[must_use]
    pub const fn ordering(self) -> Ordering {
        match self {
            Self::Negative => Ordering::Less,
            Self::Zero => Ordering::Equal,
            Self::Positive => Ordering::Greater,
        }
    }
}

impl From<Ordering> for Sign {
    /// The sign of `a - b` where `a.cmp(&b)` is given.
    #[inline]
    fn from(o: Ordering) -> Self {
        match o {
            Ordering::Less => Self::Negative,
            Ordering::Equal => Self::Zero,
            Ordering::Greater => Self::Positive,
        }
    }
}

impl From<Sign> for Ordering {
    #[inline]
    fn from(s: Sign) -> Self {
        s.ordering()
    }
}

impl Neg for Sign {
    type Output = Self;
    #[inline]
    fn neg(self) -> Self {
        Self::of_i8(-(self as i8))
    }
}

impl Mul for Sign {
    type Output = Self;
    #[inline]
    fn mul(self, o: Self) -> Self {
        Self::of_i8(self as i8 * o as i8)
    }
}
