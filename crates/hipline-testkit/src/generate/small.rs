//! Small cases on integer grids, where nearly everything is degenerate.

use hipline::Region;

use super::grid::{Point, apart, area, contains, cross, edges, is_on, is_simple, overlap, touch};
use super::random::Random;
use super::shapes::{polyomino, shape};
use crate::case::{Case, Part, Points};

/// What a small case consists of.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Kind {
    /// Random points joined to a ring without crossings.
    Simple,
    /// Random points sorted around the middle.
    Star,
    /// Letters and combs, sometimes sheared.
    Shape,
    /// The outline of a polyomino, with holes if it has any.
    Polyomino,
    /// A ring with rings in it.
    Holes,
    /// A ring with rings in it, one of which touches another in a point.
    Touching,
    /// A ring or segments that a quarter turn maps onto themselves.
    Symmetric,
    /// Several polygons, beside and inside each other.
    Islands,
    /// A tree of segments.
    Tree,
    /// Segments that keep apart.
    Segments,
    /// Segments that may meet in their ends.
    Graph,
    /// Pieces of grid lines: crosses, windows.
    Windows,
    /// Lines whose ends may lie on other lines.
    Junctions,
    /// A polygon and lines.
    Mixed,
}

impl Kind {
    /// Those that consist of polygons alone, now and then.
    pub const POLYGONS: [Self; 8] = *Self::ALL.first_chunk().expect("they come first");

    /// All kinds, those of polygons first.
    pub const ALL: [Self; 14] = [
        Self::Simple,
        Self::Star,
        Self::Shape,
        Self::Polyomino,
        Self::Holes,
        Self::Touching,
        Self::Symmetric,
        Self::Islands,
        Self::Tree,
        Self::Segments,
        Self::Graph,
        Self::Windows,
        Self::Junctions,
        Self::Mixed,
    ];
}

/// The small case of a seed: any kind, one in three with weights.
#[must_use]
pub fn small(seed: u64) -> Case {
    let mut random = Random::new(seed);
    let kind = *random.pick(&Kind::ALL);
    let mut case = small_of(kind, random.next());
    case.comments = vec![format!("small({seed}): {kind:?}")];
    if random.one_in(3) {
        weigh(&mut case, &mut random);
    }
    case
}

/// As [`small`], with a triangle beside it whose lowest corner is not on the grid: seen in the common unit,
/// all coordinates have some 86 binary digits.
#[must_use]
pub fn small_fine(seed: u64) -> Case {
    let mut case = small(seed);
    case.comments = vec![format!("small_fine({seed})")];
    let low = if seed.is_multiple_of(2) { -1.0 } else { 1.0 } / (1_u128 << 80) as f64;
    case.parts.push(Part::polygon(vec![vec![
        [-40.0, low],
        [-37.0, 2.0],
        [-38.0, 4.0],
    ]]));
    case
}

/// A small case of one kind, without weights.
#[must_use]
pub fn small_of(kind: Kind, seed: u64) -> Case {
    let mut random = Random::new(seed);
    let random = &mut random;
    let size = random.range(3, 8);
    let parts = match kind {
        Kind::Simple => vec![polygon(vec![simple(random, size)])],
        Kind::Star => vec![polygon(vec![star(random, size)])],
        Kind::Shape => vec![polygon(vec![shape(random)])],
        Kind::Polyomino => vec![polygon(polyomino(random))],
        Kind::Holes => vec![polygon(holes(random, false))],
        Kind::Touching => vec![polygon(holes(random, true))],
        Kind::Symmetric => symmetric(random, size),
        Kind::Islands => islands(random),
        Kind::Tree => vec![graph(&tree(random, size))],
        Kind::Segments => lines(&segments(random, size, |a, b| !touch(a, b))),
        Kind::Graph => vec![graph(&segments(random, size, |a, b| {
            !cross(a, b) && !overlap(a, b)
        }))],
        Kind::Windows => vec![graph(&windows(random))],
        Kind::Junctions => lines(&segments(random, size, |a, b| {
            !cross(a, b) && !overlap(a, b)
        })),
        Kind::Mixed => mixed(random, size),
    };
    let all = [
        Region::Both,
        Region::Both,
        Region::Auto,
        Region::Interior,
        Region::Exterior,
    ];
    let has_polygon = parts
        .iter()
        .any(|part| matches!(part, Part::Polygon { .. }));
    let region = if has_polygon {
        *random.pick(&all)
    } else {
        Region::Both
    };
    Case {
        comments: vec![format!("{kind:?}, seed {seed}")],
        region,
        parts,
        ..Case::default()
    }
}

/// Gives random speeds to a case.
pub fn weigh(case: &mut Case, random: &mut Random) {
    let choices = [1.0, 1.0, 1.0, 2.0, 3.0, 0.5];
    let both_sides = random.one_in(2);
    for part in &mut case.parts {
        match part {
            Part::Polygon { rings, speeds } => {
                let ring = |ring: &Points| ring.iter().map(|_| *random.pick(&choices)).collect();
                *speeds = rings.iter().map(ring).collect();
            }
            Part::Line { speeds, .. } | Part::Graph { speeds, .. } => speeds.clear(),
        }
        let count = match part {
            Part::Polygon { .. } => 0,
            Part::Line { points, .. } => points.len() - 1,
            Part::Graph { edges, .. } => edges.len(),
        };
        let pair = |random: &mut Random| {
            let left = *random.pick(&choices);
            [
                left,
                if both_sides {
                    left
                } else {
                    *random.pick(&choices)
                },
            ]
        };
        let pairs = (0..count).map(|_| pair(random)).collect();
        if let Part::Line { speeds, .. } | Part::Graph { speeds, .. } = part {
            *speeds = pairs;
        }
    }
}

fn to_f64(points: &[Point]) -> Points {
    points.iter().map(|p| p.map(|x| x as f64)).collect()
}

fn polygon(rings: Vec<Vec<Point>>) -> Part {
    Part::polygon(rings.iter().map(|ring| to_f64(ring)).collect())
}

fn lines(segments: &[[Point; 2]]) -> Vec<Part> {
    segments
        .iter()
        .map(|segment| Part::line(to_f64(segment)))
        .collect()
}

/// A graph of segments, split where ends lie on them.
fn graph(segments: &[[Point; 2]]) -> Part {
    let mut vertices: Vec<Point> = segments.iter().flatten().copied().collect();
    vertices.sort_unstable();
    vertices.dedup();
    let mut pairs = Vec::new();
    for &segment in segments {
        let on: Vec<usize> = (0..vertices.len())
            .filter(|&v| is_on(segment, vertices[v]))
            .collect();
        pairs.extend(on.windows(2).map(|pair| [pair[0], pair[1]]));
    }
    Part::Graph {
        vertices: to_f64(&vertices),
        edges: pairs,
        speeds: Vec::new(),
    }
}

fn grid_point(random: &mut Random, size: i64) -> Point {
    [random.range(0, size), random.range(0, size)]
}

/// Random points, uncrossed by exchanging pairs of edges.
fn simple(random: &mut Random, size: i64) -> Vec<Point> {
    loop {
        let count = random.range(3, 12).min(size * size / 2 + 2);
        let mut ring: Vec<Point> = Vec::new();
        while (ring.len() as i64) < count {
            let point = grid_point(random, size);
            if !ring.contains(&point) {
                ring.push(point);
            }
        }
        for _ in 0..200 {
            let all: Vec<[Point; 2]> = edges(&ring).collect();
            let crossing = (0..all.len())
                .find_map(|i| (0..i).find(|&j| cross(all[i], all[j])).map(|j| (j, i)));
            let Some((j, i)) = crossing else {
                break;
            };
            ring[j + 1..=i].reverse();
        }
        if is_simple(&ring) {
            return ring;
        }
    }
}

/// Random points by angle around the middle of the grid.
fn star(random: &mut Random, size: i64) -> Vec<Point> {
    loop {
        let middle = [size / 2, size / 2];
        let mut ring: Vec<Point> = (0..random.range(3, 14))
            .map(|_| grid_point(random, size))
            .collect();
        let half = |p: &Point| (p[1], p[0]) < (middle[1], middle[0]);
        ring.retain(|&p| p != middle);
        ring.sort_by(|p, q| half(p).cmp(&half(q)).then(0.cmp(&area(middle, *p, *q))));
        ring.dedup_by(|p, q| half(p) == half(q) && area(middle, *p, *q) == 0);
        if is_simple(&ring) {
            return ring;
        }
    }
}

/// A ring with up to three smaller ones in it; if asked for, one contact in a single point.
fn holes(random: &mut Random, touching: bool) -> Vec<Vec<Point>> {
    let size = random.range(7, 12);
    let shell = match random.below(3) {
        0 => vec![[0, 0], [size, 0], [size, size], [0, size]],
        1 => star(random, size),
        _ => shape(random),
    };
    let mut rings = vec![shell];
    let mut contacts_left = usize::from(touching);
    for _ in 0..random.range(4, 12) + if touching { 20 } else { 0 } {
        let hole = small_ring(random, size);
        let Some(contacts) = rings
            .iter()
            .map(|ring| contacts(ring, &hole))
            .sum::<Option<usize>>()
        else {
            continue;
        };
        let fits = lies_in(&rings[0], &hole)
            && rings[1..]
                .iter()
                .all(|ring| !lies_in(ring, &hole) && !lies_in(&hole, ring));
        let small = rings.len() < 4 && rings.iter().map(Vec::len).sum::<usize>() < 14;
        if fits && small && contacts <= contacts_left {
            contacts_left -= contacts;
            rings.push(hole);
        }
    }
    rings
}

/// In how many points two rings touch; `None` if they cross or overlap.
fn contacts(ring: &[Point], other: &[Point]) -> Option<usize> {
    let clash = |a: [Point; 2]| edges(other).any(|b| cross(a, b) || overlap(a, b));
    if edges(ring).any(clash) {
        return None;
    }
    let on = |ring: &[Point], p: Point| edges(ring).any(|edge| is_on(edge, p));
    let mut points: Vec<Point> = other.iter().copied().filter(|&p| on(ring, p)).collect();
    points.extend(ring.iter().copied().filter(|&p| on(other, p)));
    points.sort_unstable();
    points.dedup();
    Some(points.len())
}

/// Is a ring, known not to cross another one, inside it? (Up to one point of contact.)
fn lies_in(outer: &[Point], inner: &[Point]) -> bool {
    let free = |p: &&Point| !edges(outer).any(|edge| is_on(edge, **p));
    inner.iter().find(free).is_some_and(|&p| contains(outer, p))
}

/// A triangle, square, diamond or other little ring somewhere on the grid.
fn small_ring(random: &mut Random, size: i64) -> Vec<Point> {
    let [x, y] = grid_point(random, size);
    let (w, h) = (random.range(1, 3), random.range(1, 3));
    match random.below(4) {
        0 => vec![[x, y], [x + w, y], [x + w, y + h], [x, y + h]],
        1 => vec![[x, y], [x + w, y], [x, y + h]],
        2 => vec![[x, y - h], [x + w, y], [x, y + h], [x - w, y]],
        _ => simple(random, 2)
            .iter()
            .map(|p| [p[0] + x, p[1] + y])
            .collect(),
    }
}

/// Rings beside and inside each other, each a polygon of its own; a ring may have a hole.
fn islands(random: &mut Random) -> Vec<Part> {
    let size = random.range(5, 10);
    let mut rings: Vec<Vec<Point>> = Vec::new();
    let outer = random.one_in(2);
    if outer {
        rings.push(vec![
            [-2, -2],
            [size + 2, -2],
            [size + 2, size + 2],
            [-2, size + 2],
        ]);
        rings.push(vec![
            [-1, -1],
            [-1, size + 1],
            [size + 1, size + 1],
            [size + 1, -1],
        ]);
    }
    for _ in 0..random.range(3, 10) {
        let ring = small_ring(random, size);
        let clear = rings.iter().enumerate().all(|(r, other)| {
            let inside = outer && r < 2;
            apart(other, &ring) && contains(other, ring[0]) == inside && !contains(&ring, other[0])
        });
        if clear && rings.iter().map(Vec::len).sum::<usize>() < 13 {
            rings.push(ring);
        }
    }
    if rings.is_empty() {
        rings.push(small_ring(random, size));
    }
    let mut parts = Vec::new();
    if outer {
        parts.push(polygon(rings.drain(..2).collect()));
    }
    parts.extend(rings.into_iter().map(|ring| polygon(vec![ring])));
    parts
}

/// Segments each of which starts at the end of an earlier one.
fn tree(random: &mut Random, size: i64) -> Vec<[Point; 2]> {
    let mut points = vec![grid_point(random, size)];
    let mut found: Vec<[Point; 2]> = Vec::new();
    for _ in 0..random.range(2, 30) {
        let from = *random.pick(&points);
        let to = grid_point(random, size);
        let meets = |other: &[Point; 2]| {
            let joined = other.contains(&from);
            (!joined && touch(*other, [from, to])) || overlap(*other, [from, to])
        };
        if points.contains(&to) || found.iter().any(meets) || found.len() > 7 {
            continue;
        }
        found.push([from, to]);
        points.push(to);
    }
    if found.is_empty() {
        found.push([[0, 0], [1 + random.range(0, 3), random.range(-2, 2)]]);
    }
    found
}

/// Random segments, as far as they go with the earlier ones.
fn segments(
    random: &mut Random,
    size: i64,
    fits: fn([Point; 2], [Point; 2]) -> bool,
) -> Vec<[Point; 2]> {
    let mut found: Vec<[Point; 2]> = Vec::new();
    let most = random.range(1, 7) as usize;
    for _ in 0..random.range(1, 30) {
        let segment = [grid_point(random, size), grid_point(random, size)];
        if segment[0] != segment[1]
            && found.len() < most
            && found.iter().all(|&other| fits(other, segment))
        {
            found.push(segment);
        }
    }
    if found.is_empty() {
        found.push([[0, 0], [2, 1]]);
    }
    found
}

/// Some of the unit pieces of a few grid lines with random spacing.
fn windows(random: &mut Random) -> Vec<[Point; 2]> {
    let (columns, rows) = (random.range(1, 3), random.range(1, 2));
    let steps = |random: &mut Random, count: i64| -> Vec<i64> {
        let same = random.one_in(2);
        let width = random.range(1, 3);
        let mut x = 0;
        let mut list = vec![0];
        for _ in 0..count {
            x += if same { width } else { random.range(1, 3) };
            list.push(x);
        }
        list
    };
    let (xs, ys) = (steps(random, columns), steps(random, rows));
    let drop = random.below(4);
    let mut found = Vec::new();
    for (i, &x) in xs.iter().enumerate() {
        for (j, &y) in ys.iter().enumerate() {
            let mut add = |other: Option<Point>| {
                if let Some(other) = other
                    && (drop == 0 || !random.one_in(drop + 2))
                {
                    found.push([[x, y], other]);
                }
            };
            add(xs.get(i + 1).map(|&next| [next, y]));
            add(ys.get(j + 1).map(|&next| [x, next]));
        }
    }
    if found.is_empty() {
        found.push([[0, 0], [1, 0]]);
    }
    found
}

/// A few points or segments of one quadrant, turned by 90, 180 and 270 degrees.
fn symmetric(random: &mut Random, size: i64) -> Vec<Part> {
    let turns = |p: Point| {
        let [x, y] = p;
        [[x, y], [-y, x], [-x, -y], [y, -x]]
    };
    loop {
        if random.one_in(2) {
            let mut quarter: Vec<Point> = (0..random.range(1, 4))
                .map(|_| [random.range(1, size), random.range(0, size)])
                .collect();
            quarter.sort_by(|&p, &q| 0.cmp(&area([0, 0], p, q)));
            quarter.dedup_by(|p, q| area([0, 0], *p, *q) == 0);
            let ring: Vec<Point> = (0..4)
                .flat_map(|k| quarter.iter().map(move |&p| turns(p)[k]))
                .collect();
            if is_simple(&ring) {
                return vec![polygon(vec![ring])];
            }
        } else {
            let segment = [grid_point(random, size), grid_point(random, size)];
            let [starts, ends] = segment.map(turns);
            let found: Vec<[Point; 2]> = (0..4).map(|k| [starts[k], ends[k]]).collect();
            let fits = |a: [Point; 2], b: [Point; 2]| !cross(a, b) && !overlap(a, b);
            let clear = (0..4).all(|i| (0..i).all(|j| fits(found[i], found[j])));
            if segment[0] != segment[1] && clear {
                return lines(&found);
            }
        }
    }
}

/// A polygon and segments that do not cross it; one in two times they may touch it.
fn mixed(random: &mut Random, size: i64) -> Vec<Part> {
    let ring = if random.one_in(2) {
        star(random, size + 2)
    } else {
        small_ring(random, size)
    };
    let may_touch = random.one_in(2);
    let clear = |segment: &[Point; 2]| {
        edges(&ring).all(|edge| {
            if may_touch {
                !cross(edge, *segment) && !overlap(edge, *segment)
            } else {
                !touch(edge, *segment)
            }
        })
    };
    let mut found = segments(random, size + 2, |a, b| !touch(a, b));
    found.retain(clear);
    found.truncate(4);
    let mut parts = vec![polygon(vec![ring.clone()])];
    parts.extend(lines(&found));
    parts
}
