//! Directions of wavefront edges. Those over tilted eaves are no integers.

use std::cmp::Ordering;

use super::number::{Field, Num};

/// A direction, of any length.
pub(super) type Heading = [Num; 2];

/// `u x v`.
pub(super) fn cross(field: &Field, u: &Heading, v: &Heading) -> Num {
    field.mul(&u[0], &v[1]).minus(&field.mul(&u[1], &v[0]))
}

/// `u . v`.
pub(super) fn dot(field: &Field, u: &Heading, v: &Heading) -> Num {
    field.mul(&u[0], &v[0]).plus(&field.mul(&u[1], &v[1]))
}

/// `Greater` for a turn to the left, `Less` for one to the right, `Equal` for neither.
pub(super) fn turn(field: &Field, u: &Heading, v: &Heading) -> Ordering {
    field.sign(&cross(field, u, v))
}

/// Counterclockwise order of directions around a point, from the positive x axis.
pub(super) fn around(field: &Field, u: &Heading, v: &Heading) -> Ordering {
    let lower = |w: &Heading| {
        let [x, y] = [0, 1].map(|k| field.sign(&w[k]));
        y.then(x) == Ordering::Less
    };
    lower(u).cmp(&lower(v)).then_with(|| turn(field, v, u))
}
