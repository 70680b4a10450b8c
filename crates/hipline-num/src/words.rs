//! Natural numbers as slices of digits to the base 2^64, the least first: what the integers of a fixed
//! width and the floating point of 400 digits are made of.

use dashu_int::{IBig, Word};
use std::cmp::Ordering;

/// How many digits an integer has, and perhaps a zero before them.
#[inline]
pub(crate) fn count(i: &IBig) -> usize {
    (i.as_sign_words().1.len() * Word::BITS as usize).div_ceil(64)
}

/// Writes the size of an integer to zeros, as many as it has digits; true if it is negative.
#[inline]
pub(crate) fn write(i: &IBig, digits: &mut [u64]) -> bool {
    let (sign, words) = i.as_sign_words();
    let step = Word::BITS as usize;
    for (k, &word) in words.iter().enumerate() {
        #[allow(clippy::useless_conversion, reason = "the width depends on the target")]
        let word = u64::from(word);
        digits[k * step / 64] |= word << (k * step % 64);
    }
    sign == dashu_int::Sign::Negative
}

/// The digits of a machine integer.
#[inline]
pub(crate) const fn of_u128(size: u128) -> [u64; 2] {
    [size as u64, (size >> 64) as u64]
}

/// How many digits are left without leading zeros.
#[inline]
pub(crate) fn used(digits: &[u64]) -> usize {
    digits
        .iter()
        .rposition(|&digit| digit != 0)
        .map_or(0, |top| top + 1)
}

/// Compares two numbers without leading zeros.
#[inline]
pub(crate) fn compare(a: &[u64], b: &[u64]) -> Ordering {
    (a.len().cmp(&b.len())).then_with(|| a.iter().rev().cmp(b.iter().rev()))
}

/// Adds a number that is not longer; true if one has to be carried beyond the last digit.
#[inline]
pub(crate) fn add(sum: &mut [u64], o: &[u64]) -> bool {
    carried(sum, o, u64::overflowing_add)
}

/// Subtracts a number that is neither longer nor larger.
#[inline]
pub(crate) fn subtract(difference: &mut [u64], o: &[u64]) {
    carried(difference, o, u64::overflowing_sub);
}

/// Joins digits with those of a number that is not longer, and carries what overflows; true if that is one in the end.
#[inline]
fn carried(digits: &mut [u64], o: &[u64], join: impl Fn(u64, u64) -> (u64, bool)) -> bool {
    let mut carry = false;
    for (i, digit) in digits.iter_mut().enumerate() {
        if i >= o.len() && !carry {
            break;
        }
        let (x, a) = join(*digit, o.get(i).copied().unwrap_or(0));
        let (x, b) = join(x, u64::from(carry));
        *digit = x;
        carry = a | b;
    }
    carry
}

/// Adds a product to zeros, as many as both factors have digits.
#[inline]
pub(crate) fn multiply(product: &mut [u64], a: &[u64], b: &[u64]) {
    for (i, &x) in a.iter().enumerate() {
        let mut carry = 0;
        for (digit, &y) in product[i..].iter_mut().zip(b) {
            // (2^64 - 1)^2 + 2 (2^64 - 1) = 2^128 - 1.
            let wide = u128::from(x) * u128::from(y) + u128::from(*digit) + u128::from(carry);
            *digit = wide as u64;
            carry = (wide >> 64) as u64;
        }
        product[i + b.len()] = carry;
    }
}
