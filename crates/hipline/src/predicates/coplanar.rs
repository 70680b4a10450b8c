//! Which planes are one, for all planes at once.

use dashu_int::IBig;

use super::planes::{PlaneId, Planes};

impl Planes {
    /// For each plane, by its number, the lowest number of a plane that is the same one.
    /// All speeds must be one.
    ///
    /// # Complexity
    /// O(n log n).
    pub(crate) fn classes(&self) -> Vec<u32> {
        debug_assert!(self.is_unweighted());
        let mut keys: Vec<([IBig; 3], u32)> = Vec::with_capacity(2 * self.lines.len());
        for number in 0..self.lines.len() as u32 {
            let left = self.integers(number as usize).into_owned();
            let right = left.each_ref().map(|x| -x);
            keys.push((left, 2 * number));
            keys.push((right, 2 * number + 1));
        }
        keys.sort_unstable();
        let mut class = vec![0; keys.len()];
        for same in keys.chunk_by(|a, b| a.0 == b.0) {
            for (_, plane) in same {
                class[*plane as usize] = same[0].1;
            }
        }
        class
    }

    /// The classes of a pair of planes.
    pub(crate) fn classes_of(classes: &[u32], pair: [PlaneId; 2]) -> [u32; 2] {
        pair.map(|plane| classes[plane.0 as usize])
    }
}
