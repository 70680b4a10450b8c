//! Lengths: sums of roots of sums of two squares, of f64 numbers, compared exactly.
//!
//! What is measured has rounded coordinates, which are dyadic numbers; so each distance is the root
//! of a dyadic number, and how two sums of them compare is the sign of a [`Surd`].

use crate::{Ball, BallDd, Number, Sign, Surd, common_unit, exponent, in_units, ldexp};
use dashu_int::{IBig, UBig, ops::UnsignedAbs};
use std::cmp::Ordering;

/// The ends of a segment.
pub type Segment = [[f64; 2]; 2];

/// The root of x² + y², of the same bits everywhere: a library's `hypot` is not. The relative
/// error is below 2^-52 if the result is normal.
///
/// ```
/// assert_eq!(hipline_num::hypot(3.0, 4.0), 5.0);
/// assert!(hipline_num::hypot(3e200, 4e200).is_finite());
/// ```
#[expect(clippy::disallowed_methods, reason = "measures, and decides nothing")]
#[must_use]
pub fn hypot(x: f64, y: f64) -> f64 {
    if x == 0.0 || y == 0.0 || !(x.is_finite() && y.is_finite()) {
        return x.abs() + y.abs();
    }
    // Neither square leaves the range of f64.
    let k = exponent_above([x, y]);
    let [x, y] = [ldexp(x, -k), ldexp(y, -k)];
    ldexp((x * x + y * y).sqrt(), k)
}

/// The length of a segment times 2^-shift, enclosed.
#[must_use]
pub fn distance([p, q]: Segment, shift: i32) -> Ball {
    let square = |axis: usize| {
        let d = Ball::from_f64(q[axis])
            .minus(&Ball::from_f64(p[axis]))
            .ldexp(-shift);
        d.times(&d)
    };
    square(0).plus(&square(1)).sqrt()
}

/// How the length of some segments, all in all, compares with that of others plus a number.
/// Exact; where double-double numbers do not tell, the cost is that of a [`Surd`]'s sign.
///
/// # Panics
///
/// If a number is not finite.
///
/// ```
/// use hipline_num::compare_lengths;
/// use std::cmp::Ordering;
/// let diagonal = |k: f64| [[0.0, 0.0], [k, k]];
/// let two = [diagonal(1.0), diagonal(2.0)];
/// assert_eq!(compare_lengths(&two, &[diagonal(3.0)], 0.0), Ordering::Equal);
/// assert_eq!(compare_lengths(&two, &[diagonal(3.0)], 1e-300), Ordering::Less);
/// ```
#[must_use]
pub fn compare_lengths(some: &[Segment], others: &[Segment], more: f64) -> Ordering {
    let sum = |list: &[Segment]| {
        let roots = list.iter().map(|[p, q]| {
            let square = |axis: usize| {
                let d = BallDd::from_f64(q[axis]).minus(&BallDd::from_f64(p[axis]));
                d.times(&d)
            };
            square(0).plus(&square(1)).sqrt()
        });
        roots.fold(BallDd::zero(), |sum, root| sum.plus(&root))
    };
    let near = sum(some).minus(&sum(others)).minus(&BallDd::from_f64(more));
    near.sign()
        .unwrap_or_else(|| exactly(some, others, more))
        .ordering()
}

fn exactly(some: &[Segment], others: &[Segment], more: f64) -> Sign {
    let all = || some.iter().chain(others).flatten().flatten().copied();
    let (unit, _) = common_unit(all().chain([more]));
    let integer = |x: f64| in_units(x, unit);
    let square = |[p, q]: &Segment| {
        let d = |axis: usize| {
            let d = integer(q[axis]) - integer(p[axis]);
            &d * &d
        };
        (d(0) + d(1)).unsigned_abs()
    };
    // Equal lengths cancel, and symmetric figures have many.
    let mut squares: Vec<(UBig, i64)> = some.iter().map(|s| (square(s), 1)).collect();
    squares.extend(others.iter().map(|s| (square(s), -1)));
    squares.sort_unstable();
    let mut sum = Surd::from_int(-integer(more));
    for equal in squares.chunk_by(|a, b| a.0 == b.0) {
        let count: i64 = equal.iter().map(|(_, one)| one).sum();
        sum = sum.plus(&Surd::scaled_sqrt(IBig::from(count), &equal[0].0));
    }
    sum.exact_sign()
}

/// The k for which every one of these numbers is below 2^k in size; 0 if all are 0.
#[must_use]
pub fn exponent_above(numbers: impl IntoIterator<Item = f64>) -> i32 {
    let largest = numbers.into_iter().map(f64::abs).fold(0.0, f64::max);
    if largest == 0.0 || !largest.is_finite() {
        return 0;
    }
    exponent(largest) + 1
}

#[cfg(test)]
#[allow(clippy::float_cmp, reason = "these results are exact")]
mod tests {
    use super::*;

    #[test]
    fn hypot_is_near_and_never_leaves_the_range() {
        for [x, y, r] in [
            [3.0, 4.0, 5.0],
            [-5e-324, 0.0, 5e-324],
            [3e-320, -4e-320, 5e-320],
            [0.0, -0.0, 0.0],
            [1.5e308, 0.0, 1.5e308],
            [f64::INFINITY, 1.0, f64::INFINITY],
        ] {
            assert_eq!(hypot(x, y), r, "{x} {y}");
        }
        assert!(hypot(f64::NAN, 1.0).is_nan(), "no number");
        let mut x = 1.0;
        for i in 0..1000_u32 {
            x = (x * 1.618_033_988 + f64::from(i)) % 1000.0;
            let y = 1000.0 - 1.7 * x;
            let exact = x.hypot(y);
            assert!(
                (hypot(x, y) - exact).abs() <= 2.0 * f64::EPSILON * exact,
                "{x} {y}"
            );
        }
    }

    #[test]
    fn lengths_compare_exactly() {
        let to = |x: f64, y: f64| [[0.1, 0.2], [0.1 + x, 0.2 + y]];
        let flat = |x: f64, y: f64| [[0.0, 0.0], [x, y]];
        // √2 + √8 = √18, and what is beside it by the least there is.
        let (some, other) = ([flat(1.0, 1.0), flat(2.0, 2.0)], [flat(3.0, 3.0)]);
        for (more, order) in [
            (0.0, Ordering::Equal),
            (5e-324, Ordering::Less),
            (-5e-324, Ordering::Greater),
        ] {
            assert_eq!(compare_lengths(&some, &other, more), order, "{more}");
        }
        // The same way forward and back, at coordinates that are not dyadic in decimals.
        let way = [to(1.0, 0.7), to(0.3, 0.9)];
        let back = way.map(|[p, q]| [q, p]);
        assert_eq!(compare_lengths(&way, &back, 0.0), Ordering::Equal);
        // 1/2^60 apart.
        let more = flat(1.0, 2.0_f64.powi(-60));
        assert_eq!(
            compare_lengths(&[more], &[flat(1.0, 0.0)], 0.0),
            Ordering::Greater
        );
        assert_eq!(compare_lengths(&[], &[], 0.0), Ordering::Equal);
    }

    #[test]
    fn distances_are_enclosed() {
        let ball = distance([[0.0, 0.0], [3e200, 4e200]], 600);
        let length = ldexp(5e200, -600);
        assert!(
            ball.lower() <= length && length <= ball.upper(),
            "{ball:?} and {length}"
        );
        assert!(ball.error() < 1e-14 * length, "{ball:?}");
    }

    #[test]
    fn exponents() {
        for (numbers, k) in [
            (vec![], 0),
            (vec![0.0], 0),
            (vec![1.0], 1),
            (vec![-3.9, 1.0], 2),
            (vec![5e-324], -1073),
            (vec![f64::MAX], 1024),
        ] {
            assert_eq!(exponent_above(numbers.iter().copied()), k, "{numbers:?}");
        }
    }
}
