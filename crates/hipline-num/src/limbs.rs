//! Integers of a fixed width, for the rung of [`Fixed`](crate::Fixed): they never allocate, and
//! say so where a result does not fit.
//!
//! Three kinds: `i128`, which serves grids; [`Short`] with up to 448 binary digits, which serves most
//! questions about figures whose coordinates use all digits of an f64; and [`Limbs`] with up to 1024.
//! Libraries of fixed width
//! take the time of the full width for every operation; here only the digits in use are touched,
//! and most factors have two or three. What counts is moving them: a short one is 64 bytes.

use crate::fixed::Term;
use crate::{BallDd, Number, Sign, words};
use dashu_int::IBig;

/// An integer of bounded size: `None` means that a result may not fit.
pub trait Integer: Sized + Clone + std::fmt::Debug {
    /// Room for terms of a sum: what is moved at little cost.
    #[doc(hidden)]
    type Terms: smallvec::Array<Item = Term<Self>>;
    /// Zero.
    const ZERO: Self;
    /// The value of a machine integer.
    fn from_i128(i: i128) -> Option<Self>;
    /// The value of any integer.
    fn from_int(i: &IBig) -> Option<Self>;
    /// The sum.
    #[must_use]
    fn plus(&self, o: &Self) -> Option<Self>;
    /// The difference.
    #[must_use]
    fn minus(&self, o: &Self) -> Option<Self>;
    /// The product.
    #[must_use]
    fn times(&self, o: &Self) -> Option<Self>;
    /// The negation.
    #[must_use]
    fn negated(&self) -> Option<Self>;
    /// The sign.
    fn sign(&self) -> Sign;
    /// How many binary digits the absolute value has.
    fn bit_len(&self) -> u32;
    /// The value as a double-double with its error bound.
    fn to_ball_dd(&self) -> BallDd;
}

impl Integer for i128 {
    type Terms = [Term<Self>; 2];
    const ZERO: Self = 0;
    #[inline]
    fn from_i128(i: i128) -> Option<Self> {
        Some(i)
    }
    fn from_int(i: &IBig) -> Option<Self> {
        Self::try_from(i).ok()
    }
    #[inline]
    fn plus(&self, o: &Self) -> Option<Self> {
        self.checked_add(*o)
    }
    #[inline]
    fn minus(&self, o: &Self) -> Option<Self> {
        self.checked_sub(*o)
    }
    #[inline]
    fn times(&self, o: &Self) -> Option<Self> {
        // Most factors are short; their product needs no test.
        match (i64::try_from(*self), i64::try_from(*o)) {
            (Ok(a), Ok(b)) => Some(Self::from(a) * Self::from(b)),
            _ => self.checked_mul(*o),
        }
    }
    #[inline]
    fn negated(&self) -> Option<Self> {
        self.checked_neg()
    }
    #[inline]
    fn sign(&self) -> Sign {
        Sign::from(self.cmp(&0))
    }
    fn bit_len(&self) -> u32 {
        Self::BITS - self.unsigned_abs().leading_zeros()
    }
    fn to_ball_dd(&self) -> BallDd {
        let value = near(&words::of_u128(self.unsigned_abs()));
        if *self < 0 { value.negated() } else { value }
    }
}

/// The natural number with these digits to the base 2^64, least first.
pub(crate) fn near(digits: &[u64]) -> BallDd {
    let rest = digits.len().saturating_sub(3);
    let mut sum = BallDd::zero();
    for &digit in digits[rest..].iter().rev() {
        let digit = BallDd::new(
            (digit >> 32) as f64 * 4_294_967_296.0,
            (digit & 0xffff_ffff) as f64,
            0.0,
        );
        sum = sum.ldexp(64).plus(&digit);
    }
    if rest == 0 {
        return sum;
    }
    // The leading digit is not zero: three of them are at least 2^128, and what is left out is
    // below 1, which is less than 2^-104 of them.
    let lost = sum.value() * (f64::EPSILON * f64::EPSILON);
    BallDd::new(
        sum.value(),
        sum.low(),
        (sum.error() + lost) * (1.0 + f64::EPSILON),
    )
    .ldexp(64 * rest as i32)
}

/// An integer of up to so many digits to the base 2^64: sign and size. Digits not in use are zero.
#[derive(Clone, Copy, PartialEq, Eq)]
pub struct Digits<const WIDTH: usize> {
    digits: [u64; WIDTH],
    /// So many digits are in use, the last of them not zero.
    len: u8,
    negative: bool,
}

/// An integer with up to 448 binary digits.
pub type Short = Digits<7>;

/// An integer with up to 1024 binary digits.
pub type Limbs = Digits<16>;

impl<const WIDTH: usize> std::fmt::Debug for Digits<WIDTH> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(
            f,
            "{}{:x?}",
            if self.negative { "-" } else { "" },
            self.used()
        )
    }
}

impl<const WIDTH: usize> Digits<WIDTH> {
    fn of_i128(i: i128) -> Self {
        let mut result = Self::ZERO;
        result.digits[..2].copy_from_slice(&words::of_u128(i.unsigned_abs()));
        result.len = 2;
        result.negative = i < 0;
        result.trimmed()
    }

    #[inline]
    fn used(&self) -> &[u64] {
        &self.digits[..usize::from(self.len)]
    }

    /// Drops leading zeros.
    fn trimmed(mut self) -> Self {
        self.len = words::used(self.used()) as u8;
        self.negative &= self.len > 0;
        self
    }

    /// |self| + |o|, with the sign of `self`.
    fn add_size(&self, o: &Self) -> Option<Self> {
        let (long, short) = if self.len >= o.len {
            (self, o)
        } else {
            (o, self)
        };
        let mut sum = *long;
        sum.negative = self.negative;
        let length = usize::from(long.len);
        if words::add(&mut sum.digits[..length], short.used()) {
            *sum.digits.get_mut(length)? = 1;
            sum.len = long.len + 1;
        }
        Some(sum)
    }

    /// |self| - |o| where that is positive, with the given sign.
    fn sub_size(&self, o: &Self, negative: bool) -> Self {
        let mut difference = *self;
        difference.negative = negative;
        words::subtract(&mut difference.digits[..usize::from(self.len)], o.used());
        difference.trimmed()
    }

    fn sum(&self, o: &Self, negate: bool) -> Option<Self> {
        if self.negative == (o.negative != negate) {
            return self.add_size(o);
        }
        Some(match words::compare(self.used(), o.used()) {
            std::cmp::Ordering::Equal => Self::ZERO,
            std::cmp::Ordering::Greater => self.sub_size(o, self.negative),
            std::cmp::Ordering::Less => o.sub_size(self, !self.negative),
        })
    }
}

impl<const WIDTH: usize> Integer for Digits<WIDTH> {
    type Terms = [Term<Self>; 3];
    const ZERO: Self = Self {
        digits: [0; WIDTH],
        len: 0,
        negative: false,
    };
    fn from_i128(i: i128) -> Option<Self> {
        Some(Self::of_i128(i))
    }
    fn from_int(i: &IBig) -> Option<Self> {
        if words::count(i) > WIDTH {
            return None;
        }
        let mut result = Self::ZERO;
        result.negative = words::write(i, &mut result.digits);
        result.len = WIDTH as u8;
        Some(result.trimmed())
    }
    fn plus(&self, o: &Self) -> Option<Self> {
        if o.len == 0 {
            return Some(*self);
        }
        if self.len == 0 {
            return Some(*o);
        }
        self.sum(o, false)
    }
    fn minus(&self, o: &Self) -> Option<Self> {
        if o.len == 0 {
            return Some(*self);
        }
        if self.len == 0 {
            return o.negated();
        }
        self.sum(o, true)
    }
    /// Does not fit if the factors have more digits together than there is room for: then the
    /// product fills all of them but one at least.
    fn times(&self, o: &Self) -> Option<Self> {
        if usize::from(self.len) + usize::from(o.len) > WIDTH {
            return None;
        }
        let mut product = Self::ZERO;
        product.len = self.len + o.len;
        product.negative = self.negative != o.negative;
        words::multiply(&mut product.digits, self.used(), o.used());
        Some(product.trimmed())
    }
    fn negated(&self) -> Option<Self> {
        Some(Self {
            negative: !self.negative && self.len > 0,
            ..*self
        })
    }
    fn sign(&self) -> Sign {
        match (self.len, self.negative) {
            (0, _) => Sign::Zero,
            (_, true) => Sign::Negative,
            (_, false) => Sign::Positive,
        }
    }
    fn bit_len(&self) -> u32 {
        self.used()
            .last()
            .map_or(0, |top| 64 * u32::from(self.len) - top.leading_zeros())
    }
    fn to_ball_dd(&self) -> BallDd {
        let value = near(self.used());
        if self.negative {
            value.negated()
        } else {
            value
        }
    }
}
