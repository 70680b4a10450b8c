//! The order in which vertices enter the triangulation.
//!
//! Biased randomised insertion order (Amenta, Choi & Rote 2003): rounds that double in
//! size, each round along a Hilbert curve. The rounds are random samples, so the expected
//! work is that of randomised incremental construction for every input, also for points
//! on a circle, where sweeping orders degenerate; the curve makes each vertex a neighbour
//! of the one before, so that finding its place costs a few steps and few cache misses.

/// With so few vertices any order will do.
const FEW: usize = 48;

/// The vertices, in the order in which they should be inserted. Nothing depends on the
/// order but time.
pub(super) fn insertion_order(vertices: &[[f64; 2]]) -> Vec<u32> {
    let count = vertices.len() as u32;
    if vertices.len() <= FEW {
        return (0..count).collect();
    }
    let mut low = vertices[0];
    let mut high = vertices[0];
    for point in vertices {
        for axis in 0..2 {
            low[axis] = low[axis].min(point[axis]);
            high[axis] = high[axis].max(point[axis]);
        }
    }
    // Halves, because the difference of two halves cannot overflow.
    let extent = (high[0] / 2.0 - low[0] / 2.0).max(high[1] / 2.0 - low[1] / 2.0);
    let cell = |x: f64, low: f64| ((x / 2.0 - low / 2.0) / extent * 65535.0) as u32;
    let mut keyed: Vec<(u64, u32)> = (0..count)
        .map(|vertex| {
            let [x, y] = vertices[vertex as usize];
            let curve = hilbert(cell(x, low[0]), cell(y, low[1]));
            let round = mix(vertex).trailing_zeros().min(31);
            (u64::from(31 - round) << 32 | u64::from(curve), vertex)
        })
        .collect();
    keyed.sort_unstable();
    keyed.into_iter().map(|(_, vertex)| vertex).collect()
}

/// The position of a cell of a 2^16 by 2^16 grid along the Hilbert curve.
fn hilbert(mut x: u32, mut y: u32) -> u32 {
    let mut position = 0;
    let mut side = 1 << 15;
    while side > 0 {
        let (right, up) = (u32::from(x & side != 0), u32::from(y & side != 0));
        position = position << 2 | (3 * right) ^ up;
        if up == 0 {
            if right == 1 {
                x = !x;
                y = !y;
            }
            std::mem::swap(&mut x, &mut y);
        }
        side >>= 1;
    }
    position
}

/// A fixed scrambling of 32 bits (the finaliser of MurmurHash3).
fn mix(mut x: u32) -> u32 {
    x = (x ^ x >> 16).wrapping_mul(0x85eb_ca6b);
    x = (x ^ x >> 13).wrapping_mul(0xc2b2_ae35);
    x ^ x >> 16
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_curve_visits_neighbouring_cells_in_turn() {
        let side = 1 << 5;
        let mut cells: Vec<(u32, [u32; 2])> = (0..side)
            .flat_map(|x| (0..side).map(move |y| [x, y]))
            .map(|[x, y]| (hilbert(x, y), [x, y]))
            .collect();
        cells.sort_unstable();
        for pair in cells.windows(2) {
            let ([a, b], [c, d]) = (pair[0].1, pair[1].1);
            assert_eq!(a.abs_diff(c) + b.abs_diff(d), 1, "{pair:?}");
        }
    }

    #[test]
    fn every_vertex_comes_once() {
        let points: Vec<[f64; 2]> = (0..1000)
            .map(|i| [f64::from(i % 37), f64::from(i / 37)])
            .collect();
        let mut order = insertion_order(&points);
        order.sort_unstable();
        assert!(order.iter().enumerate().all(|(i, &v)| i == v as usize));
    }
}
