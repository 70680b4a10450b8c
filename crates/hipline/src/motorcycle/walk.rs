//! Walks through the triangulation of a figure.
//!
//! A motorcycle goes from triangle to triangle, and looks at those that came through the same triangle
//! before. Two paths that cross inside of the figure cross in a triangle that both go through,
//! and the later one of the two gets there, at the latest, when it is where they cross. As the corners of triangles are
//! vertices of the figure, a motorcycle that gets into one of them has crashed; the only other special case is one that runs along a
//! side, and it is noted in both triangles.
//!
//! A walk stops when its motorcycle has crashed, so the memory is linear in the number of triangles
//! that the tracks go through; on ordinary input that is a few for each motorcycle.

use super::{
    encounter::{Window, encounter},
    field::{Field, Ground},
    hits::{Found, Step},
    start::{Sector, across, facing, next, prev},
    walls::Edges,
};
use crate::{
    predicates::{Bounds, Place, Spot, Track as Line},
    topology::VertexId,
};
use hipline_num::{Rough, Sign};

/// No further entry.
const NONE: u32 = u32::MAX;

/// A motorcycle that goes through a triangle.
#[derive(Clone, Copy, Debug)]
struct Entry {
    who: u32,
    /// The next entry of the triangle.
    next: u32,
    /// From when on it may be in the triangle, and by when it has left.
    stay: [f64; 2],
}

/// How a path leaves a triangle.
#[derive(Clone, Copy, Debug)]
enum Exit {
    /// Across the side with this number.
    Side(usize),
    /// At the corner with this number.
    Corner(usize),
    /// Along the side with the first number, to the corner with the second.
    Along(usize, usize),
}

/// The triangles of a figure, and who goes through them.
pub(super) struct Walks<'a> {
    edges: Edges<'a>,
    /// Triangle and corner where each sector begins.
    sectors: Vec<(u32, usize)>,
    /// The first entry of each triangle.
    first: Vec<u32>,
    entries: Vec<Entry>,
    /// The vertices, roughly.
    places: Vec<[Rough; 2]>,
}

impl<'a> Walks<'a> {
    pub(super) fn new(
        edges: Edges<'a>,
        sectors: &[Sector],
        planes: &crate::predicates::Planes,
    ) -> Self {
        let figure = edges.figure();
        Self {
            sectors: (sectors.iter())
                .map(|sector| (sector.triangle, sector.corner))
                .collect(),
            first: vec![NONE; figure.mesh().corners.len()],
            entries: Vec::with_capacity(2 * sectors.len()),
            places: (figure.vertices().iter())
                .map(|&vertex| planes.rough_vertex(vertex))
                .collect(),
            edges,
        }
    }

    fn corner(&self, triangle: usize, k: usize) -> usize {
        self.edges.figure().mesh().corners[triangle][k] as usize
    }

    /// On which side of a motorcycle's path a corner is: the left is positive.
    fn side(&self, field: &Field, who: u32, triangle: usize, k: usize) -> Sign {
        let vertex = self.corner(triangle, k);
        let lane = &field.lanes[who as usize];
        lane.side(&self.places[vertex]).unwrap_or_else(|| {
            let pair = field.tracks[who as usize].pair;
            field
                .planes
                .side_of_path(self.edges.figure().vertices()[vertex], pair)
        })
    }

    /// A motorcycle goes through a triangle, not before a time.
    fn enter(
        &mut self,
        field: &Field,
        (who, from): (u32, f64),
        triangle: usize,
        exit: Exit,
        found: &mut Found,
    ) {
        let cell = triangle as u32;
        let until = match exit {
            Exit::Corner(k) => self.reach(field, who, triangle, k, found),
            Exit::Along(side, k) => {
                let until = self.reach(field, who, triangle, k, found);
                let (other, _) = across(self.edges.figure().mesh(), triangle, side);
                self.note(field, who, other, [from, until], found);
                until
            }
            Exit::Side(k) => {
                if let Some(plane) = facing(self.edges.figure(), triangle, k) {
                    let hit = self.edges.hit_edge(field, who, plane.0 >> 1, cell);
                    let hit = hit.expect("the edge is ahead");
                    found.hits.push(hit);
                    hit.bounds.high
                } else {
                    let ends = [next(k), prev(k)].map(|k| &self.places[self.corner(triangle, k)]);
                    let Bounds { low, high } = field.lanes[who as usize].pass(ends[0], ends[1]);
                    let (other, side) = across(self.edges.figure().mesh(), triangle, k);
                    found.steps.push(Step {
                        low,
                        who,
                        cell: other as u32,
                        side: side as u32,
                    });
                    high
                }
            }
        };
        self.note(field, who, triangle, [from, until], found);
    }

    /// A motorcycle will crash in a corner. Returns by when.
    fn reach(&self, field: &Field, who: u32, triangle: usize, k: usize, found: &mut Found) -> f64 {
        let vertex = VertexId::new(self.corner(triangle, k));
        let hit = self.edges.hit_vertex(field, who, vertex, triangle as u32);
        let hit = hit.expect("the vertex is ahead");
        found.hits.push(hit);
        hit.bounds.high
    }

    /// Notes who goes through a triangle, after a look at those who do.
    fn note(
        &mut self,
        field: &Field,
        who: u32,
        triangle: usize,
        stay: [f64; 2],
        found: &mut Found,
    ) {
        let mut at = self.first[triangle];
        while at != NONE {
            let entry = self.entries[at as usize];
            let window = Window {
                from: [entry.stay[0], stay[0]],
                until: [entry.stay[1], stay[1]],
                cell: triangle as u32,
            };
            encounter(field, entry.who, who, window, found);
            at = entry.next;
        }
        let entry = Entry {
            who,
            next: self.first[triangle],
            stay,
        };
        self.first[triangle] = self.entries.len() as u32;
        self.entries.push(entry);
    }

    /// Starts in a sector, between its first side and its last.
    fn leave_vertex(&mut self, field: &Field, who: u32, found: &mut Found) {
        let (triangle, mut corner) = self.sectors[who as usize];
        let mut triangle = triangle as usize;
        loop {
            let last = prev(corner);
            let exit = match self.side(field, who, triangle, last) {
                Sign::Negative => {
                    let (other, back) = across(self.edges.figure().mesh(), triangle, next(corner));
                    (triangle, corner) = (other, next(back));
                    continue;
                }
                Sign::Zero => Exit::Along(next(corner), last),
                Sign::Positive => Exit::Side(corner),
            };
            self.enter(field, (who, 0.0), triangle, exit, found);
            return;
        }
    }

    /// How a path leaves a triangle that it goes through.
    fn exit(&self, field: &Field, who: u32, triangle: usize) -> Exit {
        let sides = [0, 1, 2].map(|k| self.side(field, who, triangle, k));
        // Counterclockwise, from its right to its left.
        let turns = |from: usize, to: usize| sides[from].is_negative() && sides[to].is_positive();
        let zeros = |from: usize, to: usize| sides[from].is_zero() && sides[to].is_zero();
        let exit = |k: usize| {
            if turns(next(k), prev(k)) {
                Some(Exit::Side(k))
            } else if sides[k].is_zero() && turns(prev(k), next(k)) {
                Some(Exit::Corner(k))
            } else if zeros(next(k), prev(k)) {
                let is_left = sides[k].is_positive();
                Some(Exit::Along(k, if is_left { prev(k) } else { next(k) }))
            } else {
                None
            }
        };
        (0..3).find_map(exit).unwrap_or_else(|| {
            unreachable!("motorcycle {who} does not go through triangle {triangle}")
        })
    }

    /// Whether a place is in a triangle or on its boundary.
    fn contains(&self, field: &Field, triangle: usize, place: &Place) -> bool {
        let vertices = self.edges.figure().vertices();
        (0..3).all(|k| {
            let ends = [next(k), prev(k)].map(|k| vertices[self.corner(triangle, k)]);
            let side = field
                .planes
                .beside(Spot::Place(place), &Line::Through(ends));
            !side.is_negative()
        })
    }
}

impl Ground for Walks<'_> {
    fn start(&mut self, field: &Field, who: u32, cells: &[u32], found: &mut Found) {
        if cells.is_empty() {
            self.leave_vertex(field, who, found);
            return;
        }
        let place = &field.tracks[who as usize].start;
        let triangle = (cells.iter().map(|&cell| cell as usize))
            .find(|&cell| self.contains(field, cell, place))
            .expect("those who meet go through one triangle");
        let exit = self.exit(field, who, triangle);
        let from = field.starts[who as usize].low;
        self.enter(field, (who, from), triangle, exit, found);
    }

    fn step(&mut self, field: &Field, step: Step, found: &mut Found) {
        let (triangle, back) = (step.cell as usize, step.side as usize);
        // It comes in with the next corner on its left and the previous one on its right.
        let exit = match self.side(field, step.who, triangle, back) {
            Sign::Positive => Exit::Side(next(back)),
            Sign::Negative => Exit::Side(prev(back)),
            Sign::Zero => Exit::Corner(back),
        };
        self.enter(field, (step.who, step.low), triangle, exit, found);
    }
}
