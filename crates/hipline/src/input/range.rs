//! Brings coordinates of any size into the range in which the exact predicates neither
//! overflow nor underflow.
//!
//! Every predicate of the triangulation is homogeneous, so scaling all coordinates by one
//! power of two changes no answer. It is exact as long as nothing becomes subnormal.
//! Shewchuk's predicates are exact for exponents from -142 to 201; so all that is refused
//! is a figure whose largest and smallest nonzero coordinate differ by more than 2^342.

use super::{Flaw, builder::Part, gather::each_point};

/// Exponents from which the predicates are exact.
const LOWEST: i32 = -142;
/// Exponents up to which the predicates are exact.
const HIGHEST: i32 = 200;

/// A power of two, as two factors because one might not be an `f64`.
#[derive(Debug, Clone, Copy)]
pub(super) struct Scale([f64; 2]);

impl Scale {
    /// The scale that brings all points into range.
    ///
    /// # Errors
    /// [`Flaw::CoordinateRange`] for each vertex of the parts that is too small beside the
    /// largest.
    pub(super) fn of(vertices: &[[f64; 2]], parts: &[Part]) -> Result<Self, Vec<Flaw>> {
        let sizes = || vertices.iter().flatten().map(|x| x.abs());
        let largest = sizes().fold(0.0, f64::max);
        let smallest = sizes().filter(|&size| size > 0.0).fold(largest, f64::min);
        if largest == 0.0 || exponent(smallest) >= LOWEST && exponent(largest) <= HIGHEST {
            return Ok(Self([1.0, 1.0]));
        }
        let shift = HIGHEST - exponent(largest);
        let too_small = |x: &f64| *x != 0.0 && exponent(x.abs()) + shift < LOWEST;
        if too_small(&smallest) {
            let mut flaws = Vec::new();
            each_point(parts, |at, point| {
                if point.iter().all(|x| x.is_finite()) && point.iter().any(too_small) {
                    flaws.push(Flaw::CoordinateRange { at, point, largest });
                }
            });
            return Err(flaws);
        }
        Ok(Self([power(shift / 2), power(shift - shift / 2)]))
    }

    /// The point, scaled.
    pub(super) fn apply(self, [x, y]: [f64; 2]) -> [f64; 2] {
        [x * self.0[0] * self.0[1], y * self.0[0] * self.0[1]]
    }
}

/// The exponent of the leading bit of a positive finite number, subnormal or not.
fn exponent(x: f64) -> i32 {
    let biased = (x.to_bits() >> 52) as i32;
    if biased > 0 {
        biased - 1023
    } else {
        -1011 - x.to_bits().leading_zeros() as i32
    }
}

/// 2^exponent, for an exponent of a normal number.
fn power(exponent: i32) -> f64 {
    f64::from_bits(((exponent + 1023) as u64) << 52)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn exponents_are_those_of_the_leading_bit() {
        assert_eq!(exponent(1.0), 0);
        assert_eq!(exponent(1.99), 0);
        assert_eq!(exponent(0.75), -1);
        assert_eq!(exponent(f64::MIN_POSITIVE), -1022);
        assert_eq!(exponent(f64::MIN_POSITIVE / 2.0), -1023);
        assert_eq!(exponent(5e-324), -1074);
        assert_eq!(exponent(f64::MAX), 1023);
        assert_eq!(power(-1022).to_bits(), f64::MIN_POSITIVE.to_bits());
    }
}
