//! Letters, combs and polyominoes.

use super::grid::{Point, edges, is_simple};
use super::random::Random;

/// A square with straight vertices on all its edges but one.
pub const STRAIGHT_VERTICES: [[f64; 2]; 8] = [
    [0.0, 0.0],
    [2.0, 0.0],
    [4.0, 0.0],
    [6.0, 0.0],
    [6.0, 4.0],
    [6.0, 6.0],
    [3.0, 6.0],
    [0.0, 6.0],
];

/// A letter, comb or the like with random proportions; sometimes with extra points on its edges
/// or sheared.
pub(super) fn shape(random: &mut Random) -> Vec<Point> {
    let mut ring = upright(random);
    while !is_simple(&ring) {
        ring = upright(random);
    }
    if random.one_in(3) {
        ring = with_runs(random, &ring);
    }
    if random.one_in(4) {
        let by = random.range(-1, 1);
        ring = ring.iter().map(|p| [p[0] + by * p[1], p[1]]).collect();
    }
    if random.one_in(4) {
        ring = ring.iter().map(|p| [p[0] + p[1], p[1] - p[0]]).collect();
    }
    if random.one_in(2) {
        ring.reverse();
    }
    ring
}

fn upright(random: &mut Random) -> Vec<Point> {
    let mut d = || random.range(1, 3);
    let (a, b, c, e, f, g) = (d(), d(), d(), d(), d(), d());
    match random.below(8) {
        0 => vec![[0, 0], [a, 0], [a, b], [0, b]],
        1 => vec![
            [0, 0],
            [a + b, 0],
            [a + b, c],
            [a, c],
            [a, c + e],
            [0, c + e],
        ],
        2 => vec![
            [0, 0],
            [a, 0],
            [a, b],
            [a + c, b],
            [a + c, b + e],
            [-f, b + e],
            [-f, b],
            [0, b],
        ],
        3 => {
            let (w, h) = (a + b + c, e + f);
            vec![
                [0, 0],
                [w, 0],
                [w, h],
                [a + b, h],
                [a + b, f],
                [a, f],
                [a, e + g],
                [0, e + g],
            ]
            .into_iter()
            .map(|[x, y]: Point| [x, if y > f { y.max(f + 1) } else { y }])
            .collect()
        }
        4 => {
            let (x, y) = (a + b, c + e);
            vec![
                [a, 0],
                [x, 0],
                [x, c],
                [x + f, c],
                [x + f, y],
                [x, y],
                [x, y + g],
                [a, y + g],
                [a, y],
                [0, y],
                [0, c],
                [a, c],
            ]
        }
        5 => comb(a + 1, b, c, e),
        6 => vec![
            [0, 0],
            [a + b, 0],
            [a + b, c],
            [a + b + e, c],
            [a + b + e, c + f],
            [a, c + f],
            [a, c],
            [0, c],
        ],
        _ => vec![
            [0, 0],
            [a + b, c],
            [2 * (a + b), 0],
            [2 * (a + b), e + c + f],
            [a + b, e + c],
            [0, e + c + f],
        ],
    }
}

/// Rectangular or pointed teeth on a bar.
fn comb(teeth: i64, width: i64, gap: i64, height: i64) -> Vec<Point> {
    let teeth = teeth.min(3);
    let length = teeth * width + (teeth - 1) * gap;
    let mut ring = vec![[0, -1], [length, -1]];
    for t in (0..teeth).rev() {
        let x = t * (width + gap);
        if height == 3 {
            ring.extend([[x + width, 0], [x, 2]]);
            if gap > 0 {
                ring.push([x, 0]);
            }
        } else {
            ring.extend([[x + width, 0], [x + width, height], [x, height], [x, 0]]);
        }
    }
    // The first and last tooth stand flush with the bar's ends: drop the corners in the edge.
    ring.dedup();
    ring
}

/// Points added on the inside of edges.
fn with_runs(random: &mut Random, ring: &[Point]) -> Vec<Point> {
    let mut found = Vec::new();
    for [p, q] in edges(ring) {
        found.push(p);
        let steps = (q[0] - p[0]).abs().max((q[1] - p[1]).abs());
        let middle = [0, 1].map(|k| p[k] + (q[k] - p[k]) / steps);
        if steps > 1 && random.one_in(2) && found.len() < 16 {
            found.push(middle);
        }
    }
    if is_simple(&found) {
        found
    } else {
        ring.to_vec()
    }
}

/// The outline of some cells, shell first; straight runs are joined or not.
pub(super) fn polyomino(random: &mut Random) -> Vec<Vec<Point>> {
    loop {
        let mut cells: Vec<Point> = vec![[0, 0]];
        for _ in 0..random.range(1, 14) {
            let [x, y] = *random.pick(&cells);
            let [dx, dy] = *random.pick(&[[1, 0], [-1, 0], [0, 1], [0, -1]]);
            if !cells.contains(&[x + dx, y + dy]) {
                cells.push([x + dx, y + dy]);
            }
        }
        let keep_runs = random.one_in(4);
        if let Some(rings) = outline(&cells, keep_runs)
            && rings.iter().map(Vec::len).sum::<usize>() <= 16
        {
            return rings;
        }
    }
}

/// The rings around cells; `None` if two of them touch in a point.
fn outline(cells: &[Point], keep_runs: bool) -> Option<Vec<Vec<Point>>> {
    let has = |x: i64, y: i64| cells.contains(&[x, y]);
    let mut sides: Vec<[Point; 2]> = Vec::new();
    for &[x, y] in cells {
        let around = [
            (has(x, y - 1), [[x, y], [x + 1, y]]),
            (has(x + 1, y), [[x + 1, y], [x + 1, y + 1]]),
            (has(x, y + 1), [[x + 1, y + 1], [x, y + 1]]),
            (has(x - 1, y), [[x, y + 1], [x, y]]),
        ];
        sides.extend(
            around
                .into_iter()
                .filter(|(covered, _)| !covered)
                .map(|(_, side)| side),
        );
    }
    if sides
        .iter()
        .enumerate()
        .any(|(i, side)| sides[..i].iter().any(|other| other[0] == side[0]))
    {
        return None;
    }
    let mut rings: Vec<Vec<Point>> = Vec::new();
    while let Some([start, mut at]) = sides.pop() {
        let mut ring = vec![start];
        while at != start {
            ring.push(at);
            let next = sides.iter().position(|side| side[0] == at)?;
            at = sides.swap_remove(next)[1];
        }
        if !keep_runs {
            let straight = |i: usize| {
                let (p, q) = (
                    ring[(i + ring.len() - 1) % ring.len()],
                    ring[(i + 1) % ring.len()],
                );
                p[0] == q[0] || p[1] == q[1]
            };
            ring = (0..ring.len())
                .filter(|&i| !straight(i))
                .map(|i| ring[i])
                .collect();
        }
        rings.push(ring);
    }
    // The shell is the one with the lowest, leftmost point.
    rings.sort_by_key(|ring| ring.iter().min().copied());
    Some(rings)
}
