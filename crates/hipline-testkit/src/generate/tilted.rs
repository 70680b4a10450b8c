//! Small cases with heights of vertices: level edges that start late, and tilted eaves.

use std::collections::BTreeMap;

use hipline::input::{Change, Sides};

use super::random::Random;
use super::small::{Kind, small_of, weigh};
use crate::case::{Case, Part};

/// How heights are distributed.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Heights {
    /// Each vertex has one of a few heights.
    Steps,
    /// Some vertices have heights, most have none.
    Few,
    /// All are in one plane that is not level.
    Plane,
    /// All are on one of two planes, the higher one.
    Crease,
    /// They rise with the distance from a point (in the maximum norm).
    Pyramid,
    /// Each part is level, or the rings of a polygon are.
    Levels,
}

impl Heights {
    /// All of them.
    pub const ALL: [Self; 6] = [
        Self::Steps,
        Self::Few,
        Self::Plane,
        Self::Crease,
        Self::Pyramid,
        Self::Levels,
    ];
}

/// The small case with heights of a seed: any kind of figure, one in two with speeds; heights are no
/// steeper than facets. Its seeds are apart from those of [`small`](super::small).
#[must_use]
pub fn small_tilted(seed: u64) -> Case {
    let mut random = Random::new(seed ^ 0x711_7ed0);
    let kind = *random.pick(&Kind::ALL);
    let heights = *random.pick(&Heights::ALL);
    let mut case = small_of(kind, random.next());
    case.comments = vec![format!("small_tilted({seed}): {kind:?}, {heights:?}")];
    let weighted = random.below(6);
    if weighted < 3 {
        weigh(&mut case, &mut random);
    }
    raise(&mut case, heights, &mut random);
    if weighted == 0 {
        still(&mut case, &mut random);
    }
    if random.one_in(4) {
        change_level(&mut case, &mut random);
    }
    case
}

/// Gives heights to a case that has none, halved until no edge is too steep.
pub fn raise(case: &mut Case, heights: Heights, random: &mut Random) {
    let slope = |random: &mut Random| *random.pick(&[0.0, 0.25, 0.5, -0.5, 0.125, -0.25, 0.75]);
    let planes = [(); 2].map(|()| [slope(random), slope(random)]);
    let at = [0, 1].map(|_| random.range(0, 8) as f64);
    let steep = *random.pick(&[0.25, 0.5, 0.125]);
    let points: Vec<Vec<([usize; 2], [f64; 2])>> =
        case.parts.iter().map(Part::numbered_points).collect();
    let of_plane = |[a, b]: [f64; 2], [x, y]: [f64; 2]| a * x + b * y;
    let mut known: BTreeMap<[u64; 2], f64> = BTreeMap::new();
    let mut levels: BTreeMap<[usize; 2], f64> = BTreeMap::new();
    let mut list = Vec::new();
    for (part, points) in points.iter().enumerate() {
        for &([ring, index], point) in points {
            let height = match heights {
                Heights::Steps => *random.pick(&[0.0, 0.0, 0.5, 0.5, 1.0, 0.25, 0.75, 1.5]),
                Heights::Few if random.one_in(4) => *random.pick(&[0.5, 1.0, 0.25, 2.0]),
                Heights::Few => 0.0,
                Heights::Plane => of_plane(planes[0], point),
                Heights::Crease => of_plane(planes[0], point).max(of_plane(planes[1], point)),
                Heights::Pyramid => steep * (point[0] - at[0]).abs().max((point[1] - at[1]).abs()),
                Heights::Levels => *levels
                    .entry([part, ring])
                    .or_insert_with(|| *random.pick(&[0.0, 0.5, 1.0, 0.25])),
            };
            // Points may be given twice.
            let height = *known.entry(point.map(f64::to_bits)).or_insert(height);
            let place = hipline::input::Place { part, ring, index };
            list.push((place, height));
        }
    }
    let low = list
        .iter()
        .map(|entry| entry.1)
        .fold(f64::INFINITY, f64::min);
    let base = if random.one_in(4) { 0.5 } else { 0.0 };
    for _ in 0..6 {
        let raised = list
            .iter()
            .map(|&(place, height)| (place, height - low + base));
        case.heights = raised.filter(|&(_, height)| height > 0.0).collect();
        if case.figure().is_ok() {
            return;
        }
        list.iter_mut().for_each(|entry| entry.1 *= 0.5);
    }
}

/// Some edges without heights stand still for ever; what has a height would never get there.
fn still(case: &mut Case, random: &mut Random) {
    let high: Vec<(usize, [usize; 2])> = case
        .heights
        .iter()
        .map(|(place, _)| (place.part, [place.ring, place.index]))
        .collect();
    for (p, part) in case.parts.iter_mut().enumerate() {
        let is_low = |ring: usize, ends: [usize; 2]| {
            let is_high = |end: &usize| high.contains(&(p, [ring, *end]));
            !ends.iter().any(is_high)
        };
        match part {
            Part::Polygon { speeds, .. } => {
                for (ring, speeds) in speeds.iter_mut().enumerate() {
                    let count = speeds.len();
                    for (e, speed) in speeds.iter_mut().enumerate() {
                        if is_low(ring, [e, (e + 1) % count]) && random.one_in(4) {
                            *speed = 0.0;
                        }
                    }
                }
            }
            Part::Line { speeds, .. } => {
                for (e, speeds) in speeds.iter_mut().enumerate() {
                    if is_low(0, [e, e + 1]) && random.one_in(4) {
                        speeds[random.below(2)] = 0.0;
                    }
                }
            }
            Part::Graph { speeds, edges, .. } => {
                for (&ends, speeds) in edges.iter().zip(speeds) {
                    if is_low(0, ends) && random.one_in(4) {
                        speeds[random.below(2)] = 0.0;
                    }
                }
            }
        }
    }
}

/// Some level edges change their speed after they have started.
fn change_level(case: &mut Case, random: &mut Random) {
    for edge in case.places() {
        if !random.one_in(3) {
            continue;
        }
        let kept = case.changes.len();
        case.changes.push(Change {
            edge,
            sides: *random.pick(&[Sides::Both, Sides::Both, Sides::Left, Sides::Right]),
            time: *random.pick(&[1.0, 1.5, 2.0, 0.75]),
            speed: *random.pick(&[1.0, 2.0, 0.5, 0.0]),
        });
        // Edges with tilted eaves must not change.
        if case.figure().is_err() {
            case.changes.truncate(kept);
        }
    }
}
