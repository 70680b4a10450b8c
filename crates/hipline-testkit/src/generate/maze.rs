//! Simple polygons around random trees.
//!
//! A closed walk around a spanning tree of an s x s grid, at a quarter of a cell from the tree, visits
//! each point of a 2s x 2s grid exactly once. So it is a simple polygon of unit edges; edges without a
//! common end are at least 1 apart, and moving every vertex by less than 1/2 keeps it simple.

use super::random::Random;

/// Directions: right, up, left, down.
const STEPS: [[i64; 2]; 4] = [[1, 0], [0, 1], [-1, 0], [0, -1]];

/// The ring of 4 s^2 grid points around a random spanning tree, counterclockwise.
pub(super) fn around_tree(random: &mut Random, s: usize) -> Vec<[i64; 2]> {
    let joins = spanning_tree(random, s);
    let joined = |x: i64, y: i64, direction: usize| joins[y as usize * s + x as usize][direction];
    // Walk with the tree on the left, from the lower left corner of cell (0, 0).
    let mut at = [0_i64, 0_i64];
    let mut ring = Vec::with_capacity(4 * s * s);
    loop {
        ring.push(at);
        let [dx, dy] = STEPS[turn(at, &joined)];
        at = [at[0] + dx, at[1] + dy];
        if at == [0, 0] {
            return ring;
        }
    }
}

/// Which way the walk leaves a point.
///
/// The corners of a cell count from the lower left, counterclockwise. From corner k the walk goes
/// in direction k within the cell; but where the tree leaves the cell on the right of that, it
/// follows the tree in direction k - 1 to the next cell.
fn turn(at: [i64; 2], joined: &impl Fn(i64, i64, usize) -> bool) -> usize {
    let corner = match [at[0] % 2, at[1] % 2] {
        [0, 0] => 0,
        [1, 0] => 1,
        [1, 1] => 2,
        _ => 3,
    };
    let arm = (corner + 3) % 4;
    if joined(at[0] / 2, at[1] / 2, arm) {
        arm
    } else {
        corner
    }
}

/// For each cell, in which directions the tree goes on.
fn spanning_tree(random: &mut Random, s: usize) -> Vec<[bool; 4]> {
    let mut joins = vec![[false; 4]; s * s];
    let mut walls: Vec<(u32, bool)> = Vec::with_capacity(2 * s * s);
    for cell in 0..s * s {
        if cell % s + 1 < s {
            walls.push((cell as u32, false));
        }
        if cell + s < s * s {
            walls.push((cell as u32, true));
        }
    }
    random.shuffle(&mut walls);
    let mut parent: Vec<u32> = (0..(s * s) as u32).collect();
    for (cell, up) in walls {
        let cell = cell as usize;
        let other = if up { cell + s } else { cell + 1 };
        let (a, b) = (find(&mut parent, cell), find(&mut parent, other));
        if a != b {
            parent[a] = b as u32;
            let direction = usize::from(up);
            joins[cell][direction] = true;
            joins[other][direction + 2] = true;
        }
    }
    joins
}

fn find(parent: &mut [u32], mut x: usize) -> usize {
    while parent[x] as usize != x {
        parent[x] = parent[parent[x] as usize];
        x = parent[x] as usize;
    }
    x
}

/// A ring without its 180 degree corners.
pub(super) fn without_runs(ring: &[[i64; 2]]) -> Vec<[i64; 2]> {
    let n = ring.len();
    let straight = |i: usize| {
        let (p, q) = (ring[(i + n - 1) % n], ring[(i + 1) % n]);
        p[0] == q[0] || p[1] == q[1]
    };
    (0..n).filter(|&i| !straight(i)).map(|i| ring[i]).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_walk_visits_every_point_once() {
        for (s, seed) in [(1, 1), (2, 2), (5, 3), (9, 4)] {
            let ring = around_tree(&mut Random::new(seed), s);
            let mut sorted = ring.clone();
            sorted.sort_unstable();
            sorted.dedup();
            assert_eq!(
                (ring.len(), sorted.len()),
                (4 * s * s, 4 * s * s),
                "s = {s}, seed {seed}"
            );
        }
    }
}
