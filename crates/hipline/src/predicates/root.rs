//! The root at which the area of a triangle falls to zero, in the numbers of each rung.

use super::{expression::Quadratic, moment::Bounds};
use hipline_num::{Ball, BallDd, Number, Sign, Wide};

pub(super) fn double<T: Number>(x: &T) -> T {
    x.plus(x)
}

pub(super) fn discriminant<T: Number>(g: &Quadratic<T>) -> T {
    let product = g[0].times(&g[2]);
    g[1].times(&g[1]).minus(&double(&double(&product)))
}

/// The roots that the approximate rungs can enclose.
macro_rules! falling_root {
    ($type:ty) => {
        /// An enclosure of `(-g1 - sqrt(g1^2 - 4 g2 g0)) / 2 g2`, the root where g falls.
        pub(in super::super) fn falling_root(g: &Quadratic<$type>) -> Option<$type> {
            let disc = discriminant(g);
            if disc.sign() == Some(Sign::Negative) {
                return None;
            }
            let root = disc.sqrt();
            let value = if g[1].value() <= 0.0 {
                double(&g[0]).div(&root.minus(&g[1]))
            } else {
                g[1].negated().minus(&root).div(&double(&g[2]))
            };
            value.error().is_finite().then_some(value)
        }
    };
}

pub(super) mod ball_root {
    use super::*;
    falling_root!(Ball);
}
pub(super) mod dd_root {
    use super::*;
    falling_root!(BallDd);
}

/// The same in 400 digits.
pub(super) mod wide_root {
    use super::*;

    /// An enclosure of `(-g1 - sqrt(g1^2 - 4 g2 g0)) / 2 g2`, the root where g falls.
    pub(in super::super) fn falling_root(g: &Quadratic<Wide>) -> Option<Wide> {
        let disc = discriminant(g);
        if disc.sign() == Some(Sign::Negative) {
            return None;
        }
        let root = disc.sqrt();
        let value = if g[1].sign() == Some(Sign::Positive) {
            g[1].negated().minus(&root).div(&double(&g[2]))
        } else {
            double(&g[0]).div(&root.minus(&g[1]))
        };
        value.is_bounded().then_some(value)
    }
}

/// A number of the sign that a polynomial has at the falling root of another.
pub(super) enum AtRoot<T> {
    /// The number itself.
    Value(T),
    /// a + b sqrt(delta).
    Sum(T, T, T),
}

/// The sign of f at the falling root of g, as far as it takes no root; `None` if the degree
/// of g cannot be told.
pub(super) fn at_root<T: Number>(f: &Quadratic<T>, g: &Quadratic<T>) -> Option<AtRoot<T>> {
    if g[2].sign()?.is_zero() {
        // A line: t = -g0 / g1.
        let linear = f[0].times(&g[1]).minus(&f[1].times(&g[0]));
        let value = linear.times(&g[1]);
        if f[2].sign()?.is_zero() {
            return Some(AtRoot::Value(value));
        }
        let value = value.plus(&f[2].times(&g[0].times(&g[0])));
        return Some(AtRoot::Value(value));
    }
    // g2 f - f2 g = p1 t + p0; at t = (-g1 - sqrt(disc)) / 2 g2, times 2 g2 (and g2
    // twice in all, a square): 2 g2 p0 - p1 g1 - p1 sqrt(disc).
    let p1 = g[2].times(&f[1]).minus(&f[2].times(&g[1]));
    let p0 = g[2].times(&f[0]).minus(&f[2].times(&g[0]));
    let a = double(&g[2].times(&p0)).minus(&p1.times(&g[1]));
    Some(AtRoot::Sum(a, p1.negated(), discriminant(g)))
}

/// Bounds of a falling root that is not negative, where its denominator may be zero: such a
/// root is far away, and that is worth knowing.
pub(super) fn root_bounds(g: &Quadratic<BallDd>) -> Bounds {
    let disc = discriminant(g);
    let root = if disc.upper() > 0.0 {
        disc.sqrt()
    } else {
        BallDd::zero()
    };
    let (n, d) = if g[1].value() <= 0.0 {
        (double(&g[0]), root.minus(&g[1]))
    } else {
        (g[1].plus(&root), double(&g[2]).negated())
    };
    // One rounding each, covered by one part in 2^50.
    let slack = 1.0 / (1_u64 << 50) as f64;
    let low = n.lower().max(0.0) / d.upper() * (1.0 - slack);
    let high = if d.lower() > 0.0 {
        n.upper() / d.lower() * (1.0 + slack)
    } else {
        f64::INFINITY
    };
    Bounds {
        low: if low.is_finite() { low } else { 0.0 },
        high: if high.is_nan() { f64::INFINITY } else { high },
    }
}

/// The falling root of a polynomial if it is a binary fraction that f64 holds exactly.
#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_precision_loss,
    reason = "integers below 2^53"
)]
pub(super) fn exact_root(g: &Quadratic<Ball>) -> Option<f64> {
    if g.iter().any(|c| c.error() > 0.0) {
        return None;
    }
    let [g0, g1, g2] = g.each_ref().map(|c| c.value() as i128);
    let square = g1 * g1 - 4 * g2 * g0;
    let root = square.isqrt();
    if root * root != square {
        return None;
    }
    // 2 g0 / (root - g1), or where that is 0 / 0: (-root - g1) / 2 g2.
    let (n, d) = if root == g1 {
        (-root - g1, 2 * g2)
    } else {
        (2 * g0, root - g1)
    };
    if d == 0 || n.unsigned_abs() >= 1 << 53 || d.unsigned_abs() >= 1 << 53 {
        return None;
    }
    let odd = d >> d.trailing_zeros();
    (n % odd == 0).then(|| n as f64 / d as f64)
}
