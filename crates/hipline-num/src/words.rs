//! Natural numbers as slices of digits to the base 2^64, the least first: what the integers of a fixed
//! width and the floating point of 400 digits are made of.

use std::cmp::Ordering;

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
    let mut carry = false;
    for (i, digit) in sum.iter_mut().enumerate() {
        if i >= o.len() && !carry {
            break;
        }
        let (x, a) = digit.overflowing_add(o.get(i).copied().unwrap_or(0));
        let (x, b) = x.overflowing_add(u64::from(carry));
        *digit = x;
        carry = a | b;
    }
    carry
}

/// Subtracts a number that is neither longer nor larger.
#[inline]
pub(crate) fn subtract(difference: &mut [u64], o: &[u64]) {
    let mut borrow = false;
    for (i, digit) in difference.iter_mut().enumerate() {
        if i >= o.len() && !borrow {
            break;
        }
        let (x, a) = digit.overflowing_sub(o.get(i).copied().unwrap_or(0));
        let (x, b) = x.overflowing_sub(u64::from(borrow));
        *digit = x;
        borrow = a | b;
    }
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
