//! Random small figures on a small grid, against a slow and obvious oracle.

use hipline::{
    FigureBuilder, InvalidFigure,
    input::{Flaw, Source},
};

type Point = [i64; 2];

/// A fixed linear congruential generator, so that every run tests the same.
struct Random(u64);

impl Random {
    fn below(&mut self, limit: u64) -> u64 {
        self.0 = self
            .0
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 33) % limit
    }

    fn point(&mut self, grid: u64) -> Point {
        [self.below(grid) as i64, self.below(grid) as i64]
    }
}

fn float(point: Point) -> [f64; 2] {
    point.map(|x| x as f64)
}

fn orient([ax, ay]: Point, [bx, by]: Point, [cx, cy]: Point) -> i64 {
    ((bx - ax) * (cy - ay) - (by - ay) * (cx - ax)).signum()
}

/// Whether a point is on the segment and not one of its ends.
fn within(p: Point, [a, b]: [Point; 2]) -> bool {
    orient(a, b, p) == 0 && p != a && p != b && (a.min(b) < p && p < a.max(b))
}

#[derive(Debug, PartialEq, Eq, PartialOrd, Ord, Clone, Copy)]
enum Pair {
    Cross(usize, usize),
    Overlap(usize, usize),
}

/// All pairs of segments that cross where no vertex is, or share more than a point.
fn oracle(segments: &[[Point; 2]]) -> Vec<Pair> {
    let vertices: Vec<Point> = segments.iter().flatten().copied().collect();
    let mut pairs = Vec::new();
    for (i, &[a, b]) in segments.iter().enumerate() {
        for (j, &[c, d]) in segments.iter().enumerate().skip(i + 1) {
            if orient(a, b, c) == 0 && orient(a, b, d) == 0 {
                if a.min(b).max(c.min(d)) < a.max(b).min(c.max(d)) {
                    pairs.push(Pair::Overlap(i, j));
                }
            } else if orient(a, b, c) * orient(a, b, d) < 0
                && orient(c, d, a) * orient(c, d, b) < 0
                && !vertices
                    .iter()
                    .any(|&v| within(v, [a, b]) && within(v, [c, d]))
            {
                pairs.push(Pair::Cross(i, j));
            }
        }
    }
    pairs.sort_unstable();
    pairs
}

/// The pairs that the flaws name; panics at any other flaw.
fn pairs(invalid: &InvalidFigure) -> Vec<Pair> {
    let mut pairs: Vec<Pair> = invalid
        .flaws
        .iter()
        .map(|flaw| match flaw {
            Flaw::EdgesCross { first, second, .. } => Pair::Cross(first.index, second.index),
            Flaw::EdgesOverlap { first, second, .. } => Pair::Overlap(first.index, second.index),
            other => panic!("unexpected: {other}"),
        })
        .collect();
    pairs.sort_unstable();
    pairs
}

/// Distinct points and edges between them.
fn graph(segments: &[[Point; 2]]) -> (Vec<[f64; 2]>, Vec<[usize; 2]>) {
    let mut points: Vec<Point> = Vec::new();
    let edges = segments
        .iter()
        .map(|ends| {
            ends.map(|end| {
                points
                    .iter()
                    .position(|&point| point == end)
                    .unwrap_or_else(|| {
                        points.push(end);
                        points.len() - 1
                    })
            })
        })
        .collect();
    (points.into_iter().map(float).collect(), edges)
}

/// Each segment is there as a chain of edges from its start to its end, through exactly
/// the vertices on it. (Debug builds check the triangulation itself in `build`.)
fn check_split(segments: &[[Point; 2]], figure: &hipline::Figure) {
    let exact = |v: hipline::topology::VertexId| figure.vertices()[v.index()].map(|x| x as i64);
    let vertices: Vec<Point> = (0..figure.vertices().len())
        .map(|v| exact(hipline::topology::VertexId::new(v)))
        .collect();
    for (number, &segment) in segments.iter().enumerate() {
        let parts: Vec<_> = figure
            .edges()
            .iter()
            .filter(|edge| edge.source.edge as usize == number)
            .collect();
        let within = vertices.iter().filter(|&&v| within(v, segment)).count();
        assert_eq!(parts.len(), within + 1);
        let mut at = segment[0];
        for part in parts {
            assert_eq!(
                part.source,
                Source {
                    part: 0,
                    ring: 0,
                    edge: number as u32
                }
            );
            assert_eq!(exact(part.from), at);
            at = exact(part.to);
        }
        assert_eq!(at, segment[1]);
    }
}

#[test]
fn segments_are_accepted_exactly_if_none_cross_or_overlap() {
    let mut random = Random(7);
    let mut accepted = 0;
    for round in 0..20_000 {
        let grid = 2 + random.below(9);
        let count = 1 + random.below(if round % 4 == 0 { 14 } else { 6 });
        let segments: Vec<[Point; 2]> = (0..count)
            .map(|_| {
                [
                    random.point(grid),
                    random.point(if round % 7 == 0 { 1 + grid / 3 } else { grid }),
                ]
            })
            .filter(|[a, b]| a != b)
            .collect();
        if segments.is_empty() {
            continue;
        }
        let (vertices, edges) = graph(&segments);
        let mut builder = FigureBuilder::new();
        builder.graph(vertices, edges);
        let expected = oracle(&segments);
        match builder.build() {
            Ok(figure) => {
                assert_eq!(expected, [], "round {round}: {segments:?}");
                check_split(&segments, &figure);
                accepted += 1;
            }
            Err(invalid) => assert_eq!(expected, pairs(&invalid), "round {round}: {segments:?}"),
        }
    }
    assert!(
        (2_000..18_000).contains(&accepted),
        "{accepted} of 20,000 rounds were valid"
    );
}

#[test]
fn segments_on_one_line_are_accepted_exactly_if_none_overlap() {
    let mut random = Random(11);
    let mut accepted = 0;
    for round in 0..5_000 {
        let direction = [[1, 0], [0, -1], [2, 3], [-5, 7]][round % 4];
        let count = 1 + random.below(5);
        let mut on_line = || {
            let at = random.below(16) as i64 - 5;
            direction.map(|x: i64| x * at + 1)
        };
        let segments: Vec<[Point; 2]> = (0..count)
            .map(|_| [on_line(), on_line()])
            .filter(|[a, b]| a != b)
            .collect();
        if segments.is_empty() {
            continue;
        }
        let (vertices, edges) = graph(&segments);
        let mut builder = FigureBuilder::new();
        builder.graph(vertices, edges);
        let expected = oracle(&segments);
        match builder.build() {
            Ok(figure) => {
                assert_eq!(expected, [], "round {round}: {segments:?}");
                check_split(&segments, &figure);
                accepted += 1;
            }
            Err(invalid) => assert_eq!(expected, pairs(&invalid), "round {round}: {segments:?}"),
        }
    }
    assert!(accepted > 500, "{accepted} of 5,000 rounds were valid");
}

/// How many times the ring goes around the point, counted by a ray; doubled coordinates,
/// the point with odd ones, so that it is on no vertex's level.
fn parity(ring: &[Point], [x, y]: Point) -> bool {
    let mut inside = false;
    for (i, &a) in ring.iter().enumerate() {
        let b = ring[(i + 1) % ring.len()];
        let ([ax, ay], [bx, by]) = (a.map(|x| 2 * K * x), b.map(|x| 2 * K * x));
        if (ay > y) != (by > y) && ((bx - ax) * (y - ay) - (x - ax) * (by - ay) > 0) == (by > ay) {
            inside = !inside;
        }
    }
    inside
}

/// Sample points lie on a grid this much finer than that of the vertices.
const K: i64 = 13;

/// Small rings (a shell and a hole, or two shells) without crossing edges: whether every
/// ring lies where it should is judged by sampling. (What a disconnected inside is, the
/// tests of single flaws show.)
#[test]
fn rings_are_nested_as_sampling_says() {
    let mut random = Random(3);
    let (mut accepted, mut refused) = (0, 0);
    for round in 0..60_000 {
        let grid = 3 + random.below(3);
        let two_polygons = round % 2 == 0;
        let rings: Vec<Vec<Point>> = (0..1 + usize::from(round % 5 != 0))
            .map(|_| {
                (0..3 + random.below(if round % 3 == 0 { 5 } else { 2 }))
                    .map(|_| random.point(grid))
                    .collect()
            })
            .collect();
        let sides = |ring: &Vec<Point>| -> Vec<[Point; 2]> {
            (0..ring.len())
                .map(|i| [ring[i], ring[(i + 1) % ring.len()]])
                .collect()
        };
        let segments: Vec<[Point; 2]> = rings.iter().flat_map(sides).collect();
        if segments.iter().any(|[a, b]| a == b) || !oracle(&segments).is_empty() {
            continue;
        }
        let mut builder = FigureBuilder::new();
        let floats = rings
            .iter()
            .map(|ring| ring.iter().copied().map(float).collect());
        if two_polygons {
            floats.for_each(|ring: Vec<[f64; 2]>| {
                builder.polygon(vec![ring]);
            });
        } else {
            builder.polygon(floats.collect());
        }
        let mut combinations = [0; 4];
        let size = 2 * K * grid as i64;
        let samples: Vec<usize> = (0..size * size)
            .map(|i| [i % size - K, i / size - K].map(|x| x | 1))
            .map(|at| {
                rings
                    .iter()
                    .enumerate()
                    .map(|(r, ring)| usize::from(parity(ring, at)) << r)
                    .sum()
            })
            .collect();
        samples.iter().for_each(|&rings| combinations[rings] += 1);
        let nested = if rings.len() == 1 {
            true
        } else if two_polygons {
            combinations[3] == 0
        } else {
            combinations[2] == 0
        };
        match builder.build() {
            Ok(_) => {
                assert!(nested, "round {round}: {rings:?}");
                accepted += 1;
            }
            Err(invalid) => {
                let split = invalid
                    .flaws
                    .iter()
                    .all(|flaw| matches!(flaw, Flaw::InteriorDisconnected { .. }));
                assert_eq!(nested, split, "round {round}: {rings:?} {invalid}");
                if !split {
                    assert!(
                        invalid.flaws.len() <= rings.len(),
                        "round {round}: {rings:?} {invalid}"
                    );
                }
                refused += 1;
            }
        }
    }
    assert!(
        accepted > 500 && refused > 500,
        "{accepted} accepted, {refused} refused"
    );
}
