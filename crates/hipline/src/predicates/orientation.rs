//! The orientation of input points and directions.

use super::Direction;
use dashu_int::IBig;
use hipline_num::{Sign, common_unit, in_units};

/// The orientation of three places, each a point of the input or a direction at infinity:
/// positive if counterclockwise. Exact.
pub(crate) fn orientation(places: [Result<[f64; 2], Direction>; 3]) -> Sign {
    let (unit, _) = common_unit(places.iter().flatten().flatten().copied());
    let scaled = |x: f64| in_units(x, unit);
    let [p, q, r] = places.map(|place| match place {
        Ok([x, y]) => [scaled(x), scaled(y), IBig::ONE],
        Err(direction) => {
            let [x, y] = direction.vector();
            [IBig::from(x), IBig::from(y), IBig::ZERO]
        }
    });
    let minor = |a: &[IBig; 3], b: &[IBig; 3]| &a[0] * &b[1] - &a[1] * &b[0];
    let det = minor(&q, &r) * &p[2] + minor(&r, &p) * &q[2] + minor(&p, &q) * &r[2];
    Sign::from(det.cmp(&IBig::ZERO))
}
