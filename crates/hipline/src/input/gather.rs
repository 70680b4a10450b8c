//! Flattens the builder's parts into one list of distinct vertices and one of edges.
//!
//! Everything that can be judged without geometry is judged here: counts, indices, speeds,
//! equal points. What is flawed is left out, so that the rest can still be checked.

use std::collections::{HashMap, hash_map::Entry};

use super::{Edge, Flaw, Place, Source, builder::Part, change::Changes, height::Heights};
use crate::topology::VertexId;

/// Everything in one numbering.
#[derive(Debug, Default)]
pub(super) struct Gathered {
    /// Distinct points, in order of first appearance; no negative zeros.
    pub vertices: Vec<[f64; 2]>,
    /// Edges between distinct vertices; they may still cross and overlap.
    pub edges: Vec<Edge>,
    /// What was wrong so far.
    pub flaws: Vec<Flaw>,
    /// The heights of vertices.
    pub heights: Heights,
}

/// More than this and the 32-bit ids of the triangulation's edges would run out.
pub(super) const LIMIT: usize = 1 << 28;

/// Stands for a vertex that is not finite.
const NONE: u32 = u32::MAX;

/// Flattens the parts.
pub(super) fn gather(parts: &[Part], changes: &Changes, heights: Heights) -> Gathered {
    let mut gathered = Gathered {
        heights,
        ..Gathered::default()
    };
    let count = parts.iter().map(size).sum();
    if count > LIMIT {
        gathered.flaws.push(Flaw::TooLarge {
            count,
            limit: LIMIT,
        });
        return gathered;
    }
    gathered.vertices.reserve_exact(count);
    gathered.edges.reserve_exact(count);
    let lines = parts
        .iter()
        .filter(|part| !matches!(part, Part::Polygon { .. }))
        .count();
    let mut gatherer = Gatherer {
        distinct: Distinct::new(count),
        ids: Vec::new(),
        drawn: HashMap::new(),
        several_lines: lines > 1,
        changes,
        gathered,
    };
    for (part, content) in parts.iter().enumerate() {
        match content {
            Part::Polygon { rings, speeds } => gatherer.polygon(part, rings, speeds.as_deref()),
            Part::Line { points, speeds } => gatherer.line(part, points, speeds.as_deref()),
            Part::Graph {
                vertices,
                edges,
                speeds,
            } => gatherer.graph(part, vertices, edges, speeds.as_deref()),
        }
    }
    gatherer.gathered
}

/// An upper bound of the number of vertices and of the number of edges.
fn size(part: &Part) -> usize {
    match part {
        Part::Polygon { rings, .. } => rings.iter().map(Vec::len).sum(),
        Part::Line { points, .. } => points.len(),
        Part::Graph {
            vertices, edges, ..
        } => vertices.len().max(edges.len()),
    }
}

/// Visits every point of the parts, also closing ones and those that are not finite.
pub(super) fn each_point(parts: &[Part], mut visit: impl FnMut(Place, [f64; 2])) {
    let mut list = |part, ring, points: &[[f64; 2]]| {
        for (index, &point) in points.iter().enumerate() {
            visit(Place { part, ring, index }, point);
        }
    };
    for (part, content) in parts.iter().enumerate() {
        match content {
            Part::Polygon { rings, .. } => {
                for (ring, points) in rings.iter().enumerate() {
                    list(part, ring, without_closing_point(points));
                }
            }
            Part::Line {
                points: vertices, ..
            }
            | Part::Graph { vertices, .. } => list(part, 0, vertices),
        }
    }
}

struct Gatherer<'a> {
    gathered: Gathered,
    distinct: Distinct,
    /// The vertex of each point of the ring, line or graph at hand.
    ids: Vec<u32>,
    /// The edges of lines and graphs by their ends: the first one, and the last part in
    /// which it occurred. Left empty as long as there is one such part only.
    drawn: HashMap<[u32; 2], (usize, usize)>,
    /// Whether there are several lines or graphs.
    several_lines: bool,
    changes: &'a Changes,
}

impl Gatherer<'_> {
    fn polygon(&mut self, part: usize, rings: &[Vec<[f64; 2]>], speeds: Option<&[Vec<f64>]>) {
        let lists = speeds.map_or(rings.len(), <[_]>::len);
        if lists != rings.len() {
            self.flaw(Flaw::SpeedLists {
                part,
                found: lists,
                needed: rings.len(),
            });
        }
        for (ring, points) in rings.iter().enumerate() {
            let points = without_closing_point(points);
            let at = Place {
                part,
                ring,
                index: 0,
            };
            let speeds = speeds.and_then(|lists| lists.get(ring)).map(Vec::as_slice);
            self.speed_count(at, speeds.map(<[_]>::len), points.len());
            self.points(at, points);
            let found = self.distinct_up_to_three();
            if found < 3 && !self.ids.contains(&NONE) {
                self.flaw(Flaw::TooFewVertices {
                    at,
                    found,
                    needed: 3,
                });
            }
            for index in 0..points.len() {
                let next = if index + 1 == points.len() {
                    0
                } else {
                    index + 1
                };
                let speed = speeds
                    .and_then(|speeds| speeds.get(index))
                    .map_or(1.0, |&speed| speed);
                let ends = [self.ids[index], self.ids[next]];
                // A ring of two points goes there and back; that it overlaps itself need
                // not be said as well.
                self.edge(
                    Place { index, ..at },
                    ends,
                    [speed, speed],
                    true,
                    found >= 3,
                );
            }
        }
    }

    fn line(&mut self, part: usize, points: &[[f64; 2]], speeds: Option<&[[f64; 2]]>) {
        let at = Place {
            part,
            ring: 0,
            index: 0,
        };
        self.speed_count(at, speeds.map(<[_]>::len), points.len().saturating_sub(1));
        self.points(at, points);
        let found = self.distinct_up_to_three();
        if found < 2 && !self.ids.contains(&NONE) {
            self.flaw(Flaw::TooFewVertices {
                at,
                found,
                needed: 2,
            });
        }
        for index in 1..points.len() {
            let speeds = speeds
                .and_then(|speeds| speeds.get(index - 1))
                .map_or([1.0; 2], |&speeds| speeds);
            let ends = [self.ids[index - 1], self.ids[index]];
            self.edge(
                Place {
                    index: index - 1,
                    ..at
                },
                ends,
                speeds,
                false,
                true,
            );
        }
    }

    fn graph(
        &mut self,
        part: usize,
        vertices: &[[f64; 2]],
        edges: &[[usize; 2]],
        speeds: Option<&[[f64; 2]]>,
    ) {
        let at = Place {
            part,
            ring: 0,
            index: 0,
        };
        self.speed_count(at, speeds.map(<[_]>::len), edges.len());
        let mut lone = vec![true; vertices.len()];
        for end in edges.iter().flatten() {
            if let Some(lone) = lone.get_mut(*end) {
                *lone = false;
            }
        }
        self.ids.clear();
        let mut seen = HashMap::with_capacity(vertices.len());
        for (index, &point) in vertices.iter().enumerate() {
            let place = Place { index, ..at };
            if lone[index] {
                self.flaw(Flaw::LonePoint { at: place, point });
                self.ids.push(NONE);
                continue;
            }
            let id = self.point(place, point);
            self.ids.push(id);
            let first = *seen.entry(id).or_insert(index);
            if id != NONE && first != index {
                self.flaw(Flaw::DuplicateVertex {
                    first: Place { index: first, ..at },
                    second: place,
                    point,
                });
            }
        }
        for (index, &[from, to]) in edges.iter().enumerate() {
            let place = Place { index, ..at };
            let speeds = speeds
                .and_then(|speeds| speeds.get(index))
                .map_or([1.0; 2], |&speeds| speeds);
            let mut ends = [NONE; 2];
            for (end, vertex) in ends.iter_mut().zip([from, to]) {
                match self.ids.get(vertex) {
                    Some(&id) => *end = id,
                    None => self.flaw(Flaw::EdgeIndexOutOfRange {
                        edge: place,
                        vertex,
                        count: vertices.len(),
                    }),
                }
            }
            self.edge(place, ends, speeds, false, true);
        }
    }

    /// Whether another line or graph has the same edge, of the same speeds: then it is one
    /// edge. (Polygons may not share edges, and no line may go along itself.)
    fn drawn_before(
        &mut self,
        place: Place,
        [from, to]: [u32; 2],
        speeds: [f64; 2],
        on_ring: bool,
    ) -> bool {
        if on_ring || !self.several_lines {
            return false;
        }
        let number = self.gathered.edges.len();
        let (first, last_part) = match self.drawn.entry([from.min(to), from.max(to)]) {
            Entry::Vacant(entry) => {
                entry.insert((number, place.part));
                return false;
            }
            Entry::Occupied(entry) => entry.into_mut(),
        };
        let edge = self.gathered.edges[*first];
        let [left, right] = edge.speeds.map(f64::to_bits);
        let same_way = edge.from.index() == from as usize;
        let same_speeds = speeds.map(f64::to_bits)
            == if same_way {
                [left, right]
            } else {
                [right, left]
            };
        let same_changes = self.changes.is_empty()
            || [false, true].into_iter().all(|right| {
                let first = self.changes.of(edge.source.place(), right);
                first == self.changes.of(place, right == same_way)
            });
        same_speeds && same_changes && std::mem::replace(last_part, place.part) != place.part
    }

    fn flaw(&mut self, flaw: Flaw) {
        self.gathered.flaws.push(flaw);
    }

    fn speed_count(&mut self, at: Place, found: Option<usize>, needed: usize) {
        if let Some(found) = found.filter(|&found| found != needed) {
            self.flaw(Flaw::SpeedCount { at, found, needed });
        }
    }

    fn points(&mut self, at: Place, points: &[[f64; 2]]) {
        self.ids.clear();
        self.ids.reserve(points.len());
        for (index, &point) in points.iter().enumerate() {
            let id = self.point(Place { index, ..at }, point);
            self.ids.push(id);
        }
    }

    fn point(&mut self, at: Place, point: [f64; 2]) -> u32 {
        if point.iter().all(|x| x.is_finite()) {
            // Adding 0.0 turns -0.0 into 0.0 and changes nothing else.
            let id = self
                .distinct
                .id(&mut self.gathered.vertices, point.map(|x| x + 0.0));
            if let Some(flaw) = self.gathered.heights.found(at, id as usize) {
                self.flaw(flaw);
            }
            id
        } else {
            self.flaw(Flaw::NotFinite { at, point });
            NONE
        }
    }

    fn distinct_up_to_three(&self) -> usize {
        let mut finite = self.ids.iter().filter(|&&id| id != NONE);
        let Some(first) = finite.next() else { return 0 };
        let Some(second) = finite.find(|&id| id != first) else {
            return 1;
        };
        2 + usize::from(finite.any(|id| id != first && id != second))
    }

    fn edge(
        &mut self,
        place: Place,
        [from, to]: [u32; 2],
        speeds: [f64; 2],
        on_ring: bool,
        wanted: bool,
    ) {
        for (side, &speed) in speeds.iter().enumerate() {
            let repeated = side == 1 && speeds[0].to_bits() == speeds[1].to_bits();
            if !(speed.is_finite() && speed >= 0.0 || repeated) {
                self.flaw(Flaw::BadSpeed { edge: place, speed });
            }
        }
        if from == NONE || to == NONE {
            return;
        }
        if from == to {
            let point = self.gathered.vertices[from as usize];
            self.flaw(Flaw::ZeroLengthEdge { edge: place, point });
        } else if wanted && !self.drawn_before(place, [from, to], speeds, on_ring) {
            self.gathered.edges.push(Edge {
                from: VertexId::new(from as usize),
                to: VertexId::new(to as usize),
                speeds: speeds.map(|speed| speed + 0.0),
                source: Source {
                    part: place.part as u32,
                    ring: place.ring as u32,
                    edge: place.index as u32,
                },
                on_ring,
            });
        }
    }
}

/// The points of a ring without a last one that repeats the first.
pub(super) fn without_closing_point(points: &[[f64; 2]]) -> &[[f64; 2]] {
    match points {
        [first, inner @ .., last] if !inner.is_empty() && equal(*first, *last) => {
            &points[..points.len() - 1]
        }
        _ => points,
    }
}

/// Whether two points are the same; zero has one sign only.
fn equal(a: [f64; 2], b: [f64; 2]) -> bool {
    a.iter()
        .zip(b)
        .all(|(a, b)| (a + 0.0).to_bits() == (b + 0.0).to_bits())
}

/// Finds the vertex at a point: open addressing over the list of vertices itself, which
/// costs 8 to 16 bytes a vertex and one allocation.
struct Distinct {
    slots: Vec<u32>,
}

impl Distinct {
    fn new(count: usize) -> Self {
        Self {
            slots: vec![NONE; (2 * count).next_power_of_two()],
        }
    }

    fn id(&mut self, vertices: &mut Vec<[f64; 2]>, point: [f64; 2]) -> u32 {
        let mask = self.slots.len() - 1;
        let mut slot = hash(point) & mask;
        loop {
            let id = self.slots[slot];
            if id == NONE {
                let id = vertices.len() as u32;
                self.slots[slot] = id;
                vertices.push(point);
                return id;
            }
            if equal(vertices[id as usize], point) {
                return id;
            }
            slot = (slot + 1) & mask;
        }
    }
}

/// Mixes the bits of both coordinates by one wide multiplication (constants of wyhash).
fn hash([x, y]: [f64; 2]) -> usize {
    let product = u128::from(x.to_bits() ^ 0x2d35_8dcc_aa6c_78a5)
        * u128::from(y.to_bits().rotate_left(32) ^ 0x8bb8_4b93_962e_acc9);
    ((product >> 64) as u64 ^ product as u64) as usize
}
