//! The turn from one difference of input points to another.
//!
//! Differences of `f64` are not exact in general, so this is no determinant of three points; where
//! the filter abstains, integers decide.

use hipline_num::{Sign, common_unit, in_units};

/// Relative error of the determinant: each difference is off by a half unit in the last place, so each
/// product by three halves and a little, and the difference of the products by one more half.
/// Eight units are more than enough.
const SHARE: f64 = 8.0 / (1_u64 << 53) as f64;

/// The sign of the turn from the vector of two points to another: positive if it is to the
/// left, by less than a half turn; zero if they are parallel. Exact for points whose coordinates are neither so
/// large nor so small that products of them overflow or underflow.
///
/// Cost: six flops where the filter decides, else a few multiplications of big integers.
pub(crate) fn turn(one: [[f64; 2]; 2], other: [[f64; 2]; 2]) -> Sign {
    let [dx, dy] = [one[1][0] - one[0][0], one[1][1] - one[0][1]];
    let [ex, ey] = [other[1][0] - other[0][0], other[1][1] - other[0][1]];
    let (p, q) = (dx * ey, dy * ex);
    let difference = p - q;
    let error = (p.abs() + q.abs()) * SHARE;
    if difference > error {
        Sign::Positive
    } else if difference < -error {
        Sign::Negative
    } else if error == 0.0 {
        // A difference of f64 is zero only if it is exactly zero.
        Sign::Zero
    } else {
        by_integers([one[0], one[1], other[0], other[1]])
    }
}

fn by_integers(points: [[f64; 2]; 4]) -> Sign {
    let (unit, _) = common_unit(points.into_iter().flatten());
    let [a, b, c, d] = points.map(|point| point.map(|x| in_units(x, unit)));
    let [dx, dy] = [&b[0] - &a[0], &b[1] - &a[1]];
    let [ex, ey] = [&d[0] - &c[0], &d[1] - &c[1]];
    Sign::from((dx * ey).cmp(&(dy * ex)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_rounding_hides_is_seen() {
        let tiny = 2_f64.powi(-60);
        let level = [[tiny, 0.0], [1.0, 0.0]];
        let steep = [[0.0, 0.0], [1.0, tiny]];
        assert_eq!(turn(level, steep), Sign::Positive, "to the left");
        assert_eq!(turn(steep, level), Sign::Negative, "to the right");
        assert_eq!(
            turn(steep, [[0.0, 0.0], [3.0, 3.0 * tiny]]),
            Sign::Zero,
            "parallel"
        );
        // The rounded differences are parallel, the exact ones are not.
        let one = [[tiny, 0.0], [1.0, 1.0]];
        let other = [[0.0, 0.0], [1.0, 1.0]];
        assert_eq!(turn(other, one), Sign::Positive, "a little steeper");
        assert_eq!(turn(one, other), Sign::Negative, "a little less steep");
    }
}
