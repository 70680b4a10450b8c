//! Large inputs of every character, for benchmarks: each is simple by construction.

use std::f64::consts::TAU;

use super::maze::{around_tree, without_runs};
use super::random::Random;
use crate::case::{Case, Part, Points};

/// A family of inputs that grow with n.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Family {
    /// A polygon around a random tree, every vertex shaken.
    Random,
    /// The same on the grid, so that everything is orthogonal and equally far apart.
    Orthogonal,
    /// Random radii at equal angles.
    Star,
    /// A circle with noise of all wavelengths.
    Coast,
    /// An orthogonal skyline on a straight base.
    Skyline,
    /// A polygon that is monotone in x.
    Monotone,
    /// Points of an ellipse at random angles.
    Convex,
    /// Points of a circle at equal angles.
    Regular,
    /// Koch's snowflake.
    Snowflake,
    /// Equal pointed teeth.
    Comb,
    /// A corridor wound up.
    Spiral,
    /// A square with random small holes.
    Holes,
    /// A square with a grid of equal square holes.
    SquareHoles,
    /// Segments that keep apart.
    Segments,
    /// A closed grid of lines.
    Windows,
    /// A half circle with a window, whose straight base has many vertices.
    Apse,
}

impl Family {
    /// All families.
    #[must_use]
    pub const fn all() -> [Self; 16] {
        [
            Self::Random,
            Self::Orthogonal,
            Self::Star,
            Self::Coast,
            Self::Skyline,
            Self::Monotone,
            Self::Convex,
            Self::Regular,
            Self::Snowflake,
            Self::Comb,
            Self::Spiral,
            Self::Holes,
            Self::SquareHoles,
            Self::Segments,
            Self::Windows,
            Self::Apse,
        ]
    }

    /// A short name.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Random => "random",
            Self::Orthogonal => "orthogonal",
            Self::Star => "star",
            Self::Coast => "coast",
            Self::Skyline => "skyline",
            Self::Monotone => "monotone",
            Self::Convex => "convex",
            Self::Regular => "regular",
            Self::Snowflake => "snowflake",
            Self::Comb => "comb",
            Self::Spiral => "spiral",
            Self::Holes => "holes",
            Self::SquareHoles => "square-holes",
            Self::Segments => "segments",
            Self::Windows => "windows",
            Self::Apse => "apse",
        }
    }

    /// The family of a name.
    #[must_use]
    pub fn named(name: &str) -> Option<Self> {
        Self::all().into_iter().find(|family| family.name() == name)
    }

    /// An input of about n vertices.
    #[must_use]
    pub fn generate(self, n: usize, seed: u64) -> Case {
        let random = &mut Random::new(seed);
        let n = n.max(8);
        let parts = match self {
            Self::Random => vec![ring(shaken(random, n))],
            Self::Orthogonal => vec![ring(orthogonal(random, n))],
            Self::Star => vec![ring(
                (0..n)
                    .map(|i| at_angle(i, n, 300.0 + 700.0 * random.unit()))
                    .collect(),
            )],
            Self::Coast => vec![ring(coast(random, n))],
            Self::Skyline => vec![ring(skyline(random, n))],
            Self::Monotone => vec![ring(monotone(random, n))],
            Self::Convex => vec![ring(convex(random, n))],
            Self::Regular => vec![ring((0..n).map(|i| at_angle(i, n, 1000.0)).collect())],
            Self::Snowflake => vec![ring(snowflake(n))],
            Self::Comb => vec![ring(comb(n))],
            Self::Spiral => vec![ring(spiral(n))],
            Self::Holes => vec![with_holes(n, |x, y| hole(random, x, y))],
            Self::SquareHoles => vec![with_holes(n, square)],
            Self::Segments => segments(random, n),
            Self::Windows => vec![windows(n)],
            Self::Apse => vec![apse(n)],
        };
        let comments = vec![format!("{}, n = {n}, seed {seed}", self.name())];
        Case {
            comments,
            ..Case::of(parts)
        }
    }
}

fn ring(points: Points) -> Part {
    Part::polygon(vec![points])
}

fn at_angle(i: usize, n: usize, radius: f64) -> [f64; 2] {
    let (sin, cos) = (TAU * i as f64 / n as f64).sin_cos();
    [radius * cos, radius * sin]
}

/// The least s with `s * s >= x`.
fn root(x: usize) -> usize {
    x.isqrt() + usize::from(x.isqrt().pow(2) < x)
}

fn shaken(random: &mut Random, n: usize) -> Points {
    let grid = around_tree(random, root(n.div_ceil(4)));
    let mut shake = || 0.6 * (random.unit() - 0.5);
    grid.iter().map(|p| p.map(|x| x as f64 + shake())).collect()
}

fn orthogonal(random: &mut Random, n: usize) -> Points {
    // A bit more than half of the points on the walk are corners.
    let grid = around_tree(random, root((n * 9 / 20).max(4)));
    without_runs(&grid)
        .iter()
        .map(|p| p.map(|x| x as f64))
        .collect()
}

fn coast(random: &mut Random, n: usize) -> Points {
    let waves: Vec<[f64; 2]> = (0..40)
        .map(|k| [TAU * random.unit(), 0.35 * 0.8_f64.powi(k) * random.unit()])
        .collect();
    let radius = |i: usize, random: &mut Random| {
        let mut frequency = 1.0;
        let mut noise = 0.0;
        for [phase, height] in &waves {
            noise += height * (frequency * TAU * i as f64 / n as f64 + phase).sin();
            frequency = (frequency * 1.5_f64).ceil();
            if frequency > n as f64 / 4.0 {
                break;
            }
        }
        1000.0 * (1.0 + 0.1 * random.unit() / n as f64 + 0.5 * noise.clamp(-1.5, 1.5))
    };
    (0..n).map(|i| at_angle(i, n, radius(i, random))).collect()
}

fn skyline(random: &mut Random, n: usize) -> Points {
    let towers = n / 2 - 1;
    let mut points = vec![[0.0, 0.0], [towers as f64 * 4.0, 0.0]];
    let mut last = 0;
    for tower in (0..towers).rev() {
        let mut height = random.range(1, 40);
        if height == last {
            height += 1;
        }
        last = height;
        let left = if tower == 0 {
            0.0
        } else {
            (4 * tower) as f64 + (random.below(8) as f64 - 4.0) / 4.0
        };
        let right = points[points.len() - 1][0];
        points.extend([[right, height as f64], [left, height as f64]]);
    }
    points
}

fn monotone(random: &mut Random, n: usize) -> Points {
    let below = n / 2;
    let width = |i: usize, count: usize| 1000.0 * i as f64 / count as f64;
    let lower = (0..below).map(|i| (i, -1.0));
    let upper = (1..=n - below).rev().map(|i| (i, 1.0));
    let point = |(i, sign): (usize, f64)| {
        let count = if sign < 0.0 { below } else { n - below + 1 };
        let x = if sign < 0.0 {
            width(i, count)
        } else {
            width(i, count) + 0.25 * 1000.0 / count as f64
        };
        [x, sign * (1.0 + 50.0 * random.unit())]
    };
    lower.chain(upper).map(point).collect()
}

fn convex(random: &mut Random, n: usize) -> Points {
    (0..n)
        .map(|i| {
            let (sin, cos) = (TAU * (i as f64 + 0.8 * random.unit()) / n as f64).sin_cos();
            [1000.0 * cos, 700.0 * sin]
        })
        .collect()
}

fn snowflake(n: usize) -> Points {
    let mut points: Points = (0..3).map(|i| at_angle(2 * i, 6, 1000.0)).collect();
    // sin and cos of 60 degrees.
    let (sin, cos) = (TAU / 6.0).sin_cos();
    while points.len() < n {
        let mut finer = Vec::with_capacity(4 * points.len());
        for (i, &[x, y]) in points.iter().enumerate() {
            let [u, v] = points[(i + 1) % points.len()];
            let [dx, dy] = [(u - x) / 3.0, (v - y) / 3.0];
            let tip = [x + dx + cos * dx + sin * dy, y + dy - sin * dx + cos * dy];
            finer.extend([[x, y], [x + dx, y + dy], tip, [x + 2.0 * dx, y + 2.0 * dy]]);
        }
        points = finer;
    }
    points
}

fn comb(n: usize) -> Points {
    let teeth = (n - 2) / 2;
    let mut points = vec![[0.0, -4.0], [2.0 * teeth as f64, -4.0]];
    for tooth in (0..teeth).rev() {
        points.extend([
            [2.0 * tooth as f64 + 2.0, 0.0],
            [2.0 * tooth as f64 + 1.0, 6.0],
        ]);
    }
    points.push([0.0, 0.0]);
    points
}

fn spiral(n: usize) -> Points {
    let half = n / 2;
    let arm = |i: usize, shift: f64| {
        let turns = i as f64 / 24.0 + 1.0;
        let (sin, cos) = (TAU * i as f64 / 24.0).sin_cos();
        [(turns + shift) * cos, (turns + shift) * sin]
    };
    let outward = (0..half).map(|i| arm(i, 0.5));
    let inward = (0..half).rev().map(|i| arm(i, 0.0));
    outward.chain(inward).collect()
}

/// A square with about n / 6 cells of size 4, each with a ring that stays within [0.5, 3.5]^2.
fn with_holes(n: usize, mut hole: impl FnMut(f64, f64) -> Points) -> Part {
    let count = root(n / 6);
    let side = 4.0 * count as f64;
    let mut rings = vec![vec![[0.0, 0.0], [side, 0.0], [side, side], [0.0, side]]];
    for row in 0..count {
        for column in 0..count {
            rings.push(hole(4.0 * column as f64, 4.0 * row as f64));
        }
    }
    Part::polygon(rings)
}

fn square(x: f64, y: f64) -> Points {
    vec![
        [x + 1.0, y + 1.0],
        [x + 1.0, y + 3.0],
        [x + 3.0, y + 3.0],
        [x + 3.0, y + 1.0],
    ]
}

fn hole(random: &mut Random, x: f64, y: f64) -> Points {
    let corners = 3 + random.below(7);
    let point = |i: usize, random: &mut Random| {
        let radius = 0.4 + 1.1 * random.unit();
        let [u, v] = at_angle(i, corners, radius);
        [x + 2.0 + u, y + 2.0 + v]
    };
    (0..corners).map(|i| point(i, random)).collect()
}

fn segments(random: &mut Random, n: usize) -> Vec<Part> {
    let count = n / 2;
    let side = root(count);
    let mut parts = Vec::with_capacity(count);
    for cell in 0..count {
        let mut point = || {
            let (x, y) = ((cell % side) as f64, (cell / side) as f64);
            [x + 0.9 * random.unit(), y + 0.9 * random.unit()]
        };
        parts.push(Part::line(vec![point(), point()]));
    }
    parts
}

fn windows(n: usize) -> Part {
    let side = root(n);
    let vertices = (0..side * side)
        .map(|i| [(i % side) as f64, (i / side) as f64])
        .collect();
    let across = (0..side * side)
        .filter(|i| i % side + 1 < side)
        .map(|i| [i, i + 1]);
    let up = (0..side * (side - 1)).map(|i| [i, i + side]);
    Part::Graph {
        vertices,
        edges: across.chain(up).collect(),
        speeds: Vec::new(),
    }
}

fn apse(n: usize) -> Part {
    let base = n / 2;
    let radius = base as f64 / 2.0;
    let mut points: Points = (0..=base).map(|i| [i as f64, 0.0]).collect();
    let arc = n - base;
    points.extend((0..=arc).map(|i| {
        let [x, y] = at_angle(i, 2 * arc, radius);
        [radius + x, 1.0 + y.max(0.0)]
    }));
    let [low, high] = [0.5, 0.75].map(|share| share * radius);
    let window = vec![
        [radius, low],
        [radius, high],
        [1.25 * radius, high],
        [1.25 * radius, low],
    ];
    Part::polygon(vec![points, window])
}
