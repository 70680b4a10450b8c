//! Both ways to build a figure give the same figure and the same flaws, and a direction is found
//! whenever there is one.

use super::super::{Change, InvalidFigure, Sides};
use super::*;

struct Random(u64);

impl Random {
    fn below(&mut self, limit: u64) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        (z ^ (z >> 31)) % limit
    }

    fn coordinate(&mut self, grid: u64) -> i64 {
        self.below(grid) as i64
    }
}

/// A ring on a small grid that is monotone in the x direction or nearly so: two chains of points
/// sorted by x, some of them disturbed.
fn nearly_monotone(random: &mut Random) -> Vec<[i64; 2]> {
    let grid = 3 + random.below(10);
    let mut chain = |count: u64, low: i64| {
        let mut points: Vec<[i64; 2]> = (0..count)
            .map(|_| [random.coordinate(grid), low + random.coordinate(4)])
            .collect();
        points.sort_unstable_by_key(|point| point[0]);
        if random.below(2) == 0 {
            points.dedup_by_key(|point| point[0]);
        }
        points
    };
    let mut ring = chain(2 + grid / 2, 0);
    let mut upper = chain(1 + grid / 2, 4);
    upper.reverse();
    ring.append(&mut upper);
    if random.below(4) == 0 {
        let at = random.below(ring.len() as u64) as usize;
        ring[at] = [random.coordinate(grid), random.coordinate(8)];
    }
    if random.below(8) == 0 {
        ring.dedup();
    }
    ring
}

/// A ring of few points anywhere.
fn any(random: &mut Random) -> Vec<[i64; 2]> {
    let count = 3 + random.below(6);
    let grid = 2 + random.below(6);
    let points = (0..count).map(|_| [random.coordinate(grid), random.coordinate(grid)]);
    points.collect()
}

/// Turns, shears, mirrors and rotates a ring.
fn disturbed(mut ring: Vec<[i64; 2]>, random: &mut Random) -> Vec<[f64; 2]> {
    let maps = [
        [1, 0, 0, 1],
        [0, -1, 1, 0],
        [1, 1, -1, 2],
        [3, -2, 1, 1],
        [-1, 0, 0, 1],
        [2, 7, 1, 4],
    ];
    let [a, b, c, d] = maps[random.below(maps.len() as u64) as usize];
    if random.below(2) == 0 {
        ring.reverse();
    }
    let count = ring.len();
    ring.rotate_left(random.below(count as u64) as usize);
    if random.below(4) == 0 {
        ring.push(ring[0]);
    }
    let scales = [1.0, -0.1, 2e-60, 3e70];
    let scale = scales[random.below(scales.len() as u64) as usize];
    let point = |[x, y]: [i64; 2]| {
        [
            (a * x + b * y) as f64 * scale,
            (c * x + d * y) as f64 * scale,
        ]
    };
    ring.into_iter().map(point).collect()
}

fn both(builder: &FigureBuilder) -> [Result<Figure, InvalidFigure>; 2] {
    [builder.clone().build(), builder.clone().build_in_general()]
}

/// Compares everything but the way in which it was made. Returns whether the short way was taken.
fn compare(builder: &FigureBuilder, label: &str) -> bool {
    match both(builder) {
        [Err(short), Err(general)] => {
            assert_eq!(format!("{short:?}"), format!("{general:?}"), "{label}");
            false
        }
        [Ok(short), Ok(general)] => {
            let bits = |figure: &Figure| -> Vec<[u64; 2]> {
                let points = figure.vertices().iter();
                points.map(|point| point.map(f64::to_bits)).collect()
            };
            assert_eq!(bits(&short), bits(&general), "{label}");
            assert_eq!(short.edges(), general.edges(), "{label}");
            assert_eq!(short.terminals(), general.terminals(), "{label}");
            assert_eq!(short.has_polygon(), general.has_polygon(), "{label}");
            assert_eq!(short.changes(), general.changes(), "{label}");
            assert_eq!(short.has_heights(), general.has_heights(), "{label}");
            let [one, other] = [short.mesh(), general.mesh()];
            assert_eq!(one.corners, other.corners, "{label}");
            assert_eq!(one.across, other.across, "{label}");
            assert_eq!(one.inside, other.inside, "{label}");
            short.monotone().is_some()
        }
        [short, general] => panic!("{label}: {short:?}, but {general:?}"),
    }
}

/// Whether a ring is monotone across the levels of some direction, by trying all that matter: those of
/// edges, and one between each two.
fn is_monotone(ring: &[[i64; 2]]) -> bool {
    let n = ring.len();
    let edges: Vec<[i64; 2]> = (0..n)
        .map(|i| [0, 1].map(|axis| ring[(i + 1) % n][axis] - ring[i][axis]))
        .collect();
    let cross = |a: [i64; 2], b: [i64; 2]| a[0] * b[1] - a[1] * b[0];
    let mut levels: Vec<[i64; 2]> = edges
        .iter()
        .map(|&[x, y]| if (y, x) < (0, 0) { [-x, -y] } else { [x, y] })
        .collect();
    levels.sort_by(|&a, &b| 0.cmp(&cross(a, b)));
    let count = levels.len();
    for k in 0..count {
        let [a, b] = [levels[k], levels[(k + 1) % count]];
        let b = if k + 1 == count { [-b[0], -b[1]] } else { b };
        levels.push([a[0] + b[0], a[1] + b[1]]);
    }
    levels.into_iter().any(|level| {
        let signs = edges.iter().map(|&edge| cross(edge, level).signum());
        let signs: Vec<i64> = signs.filter(|&sign| sign != 0).collect();
        let count = signs.len();
        (0..count)
            .filter(|&i| signs[i] != signs[(i + 1) % count])
            .count()
            == 2
    })
}

#[test]
fn both_ways_build_the_same_figure() {
    let mut random = Random(4);
    let (mut short, mut valid) = (0, 0);
    for seed in 0..20_000 {
        let ring = if random.below(3) > 0 {
            nearly_monotone(&mut random)
        } else {
            any(&mut random)
        };
        if ring.is_empty() {
            continue;
        }
        let mut builder = FigureBuilder::new();
        let points = disturbed(ring, &mut random);
        let label = format!("seed {seed}: {points:?}");
        if random.below(4) == 0 {
            let speeds = points.iter().map(|_| random.below(3) as f64).collect();
            builder.weighted_polygon(vec![points], vec![speeds]);
        } else {
            builder.polygon(vec![points]);
        }
        if random.below(8) == 0 {
            builder.change(Change {
                edge: super::super::Place {
                    part: 0,
                    ring: 0,
                    index: random.below(6) as usize,
                },
                sides: Sides::Both,
                time: random.below(4) as f64,
                speed: 2.0,
            });
        }
        short += usize::from(compare(&builder, &label));
        valid += usize::from(builder.build().is_ok());
    }
    assert!(short > 3000, "only {short} of {valid} went the short way");
}

#[test]
fn every_direction_is_found() {
    let mut random = Random(5);
    let (mut monotone, mut other) = (0, 0);
    for seed in 0..40_000 {
        let mut ring = if random.below(4) == 0 {
            nearly_monotone(&mut random)
        } else {
            any(&mut random)
        };
        let [a, b, c, d] = [[1, 0, 0, 1], [1, 1, -1, 2], [3, -2, 1, 1], [2, 7, 1, 4]][seed % 4];
        for [x, y] in &mut ring {
            [*x, *y] = [a * *x + b * *y, c * *x + d * *y];
        }
        let mut builder = FigureBuilder::new();
        let points = ring.iter().map(|point| point.map(|x| x as f64)).collect();
        builder.polygon(vec![points]);
        let Ok(general) = builder.clone().build_in_general() else {
            continue;
        };
        if general.edges().len() != ring.len() || general.vertices().len() != ring.len() {
            continue;
        }
        let figure = builder.build().expect("as before");
        let due = is_monotone(&ring);
        assert_eq!(figure.monotone().is_some(), due, "seed {seed}: {ring:?}");
        if due {
            monotone += 1;
        } else {
            other += 1;
        }
    }
    assert!(
        monotone > 1000 && other > 20,
        "{monotone} monotone, {other} not"
    );
}

#[test]
fn a_spiral_is_monotone_in_no_direction_and_a_slanted_comb_in_one() {
    let figure = |points: &[[f64; 2]]| {
        let mut builder = FigureBuilder::new();
        builder.polygon(vec![points.to_vec()]);
        builder.build().expect("valid")
    };
    let spiral = [
        [0., 0.],
        [9., 0.],
        [9., 9.],
        [2., 9.],
        [2., 4.],
        [5., 4.],
        [5., 6.],
        [4., 6.],
        [4., 5.],
        [3., 5.],
        [3., 8.],
        [8., 8.],
        [8., 1.],
        [0., 1.],
    ];
    assert!(figure(&spiral).monotone().is_none(), "a spiral");
    // Teeth along the diagonal, which neither axis allows for; levels are along the teeth only.
    let comb = [
        [0., 0.],
        [10., 10.],
        [9., 11.],
        [8., 10.],
        [7., 11.],
        [6., 10.],
        [4., 8.],
        [3., 9.],
        [1., 7.],
        [2., 6.],
        [-1., 3.],
        [-2., 4.],
        [-3., 3.],
    ];
    let monotone = *figure(&comb).monotone().expect("a direction");
    assert!(monotone.counterclockwise, "as given");
}
