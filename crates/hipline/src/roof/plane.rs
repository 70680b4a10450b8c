//! Exact signs of points that are f64 numbers (Shewchuk 1997, by the crate robust).

use robust::{Coord, Coord3D};

/// Positive if three points of the plan turn left; the sign is exact.
pub(super) fn orientation(a: [f64; 2], b: [f64; 2], c: [f64; 2]) -> f64 {
    let [a, b, c] = [a, b, c].map(|[x, y]| Coord { x, y });
    robust::orient2d(a, b, c)
}

/// Positive if the fourth point lies on the side of the first three from which they are seen
/// counterclockwise; the sign is exact.
pub(super) fn side(a: [f64; 3], b: [f64; 3], c: [f64; 3], d: [f64; 3]) -> f64 {
    let [a, b, c, d] = [a, b, c, d].map(|[x, y, z]| Coord3D { x, y, z });
    // Shewchuk's sign is that of a point below.
    -robust::orient3d(a, b, c, d)
}
