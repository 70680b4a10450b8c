//! Brings coordinates of any size into the range in which the exact predicates neither
//! overflow nor underflow.
//!
//! Every predicate of the triangulation is homogeneous, so scaling all coordinates by one
//! power of two changes no answer. It is exact as long as nothing becomes subnormal.
//! Shewchuk's predicates are exact for exponents from -142 to 201; so all that is refused
//! is a figure whose largest and smallest nonzero coordinate differ by more than 2^342.

use super::{Flaw, builder::Part, gather::each_point};
use hipline_num::{exponent, power_of_two};

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
        let too_small = |x: &f64| *x != 0.0 && exponent(*x) + shift < LOWEST;
        if too_small(&smallest) {
            let mut flaws = Vec::new();
            each_point(parts, |at, point| {
                if point.iter().all(|x| x.is_finite()) && point.iter().any(too_small) {
                    flaws.push(Flaw::CoordinateRange { at, point, largest });
                }
            });
            return Err(flaws);
        }
        Ok(Self([
            power_of_two(shift / 2),
            power_of_two(shift - shift / 2),
        ]))
    }

    /// The point, scaled.
    pub(super) fn apply(self, [x, y]: [f64; 2]) -> [f64; 2] {
        [x * self.0[0] * self.0[1], y * self.0[0] * self.0[1]]
    }
}
