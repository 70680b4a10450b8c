//! The boundary of a cell with its extended valleys, triangulated, and the dual of that (section 4.1 of the thesis).
//!
//! Coordinates are rounded, and what is found is only a reason to choose one cut rather than another one. Where rounding has spoilt the
//! graph, there is none.

use super::{
    Envelope,
    boundary::{Cell, NONE},
    cells::middle,
};
use crate::motorcycle::tracks::Crash;
use hipline_num::{exponent, power_of_two};
use spade::{
    ConstrainedDelaunayTriangulation, Intersection, LastUsedVertexHintGenerator,
    LineIntersectionIterator, Point2, Triangulation, handles::FixedVertexHandle,
};

type Cdt = ConstrainedDelaunayTriangulation<Point2<f64>, (), (), (), LastUsedVertexHintGenerator>;

/// An extended valley.
pub(super) struct Chord {
    /// Its ends, numbered around the cell.
    pub ends: [usize; 2],
}

/// A valley whose motorcycle stops in the cell, and that would cross another one if it were extended.
pub(super) struct Stub {
    /// Where it starts.
    pub start: usize,
    /// Where its track ends.
    pub end: [f64; 2],
}

/// A side of a triangle that divides the cell.
pub(super) struct Side {
    /// Its ends, numbered around the cell.
    pub ends: [usize; 2],
    /// How many valleys there are on the side where there are more.
    pub most: usize,
    /// If it is a valley: whether a cut beside it is to be on its left.
    pub is_left: Option<bool>,
}

/// Corners and ends of extended valleys around a cell without holes, counterclockwise.
pub(super) struct Outerplanar {
    pub points: Vec<[f64; 2]>,
    pub chords: Vec<Chord>,
    pub stubs: Vec<Stub>,
    cdt: Cdt,
    handles: Vec<FixedVertexHandle>,
    /// The number of each of spade's vertices.
    numbers: Vec<usize>,
    scale: f64,
}

/// Where an extended valley ends.
struct Exit {
    /// The corner before.
    after: usize,
    /// Which part of the way to the next one.
    part: f64,
    /// The corner where the valley starts.
    from: usize,
    /// Where its track ends.
    end: [f64; 2],
    /// Valleys with lower ones come first.
    rank: u8,
}

impl Outerplanar {
    pub(super) fn new(envelope: &Envelope, cell: &Cell) -> Option<Self> {
        let mut around = Vec::with_capacity(cell.edges.len());
        let mut at = 0;
        loop {
            around.push(at);
            at = cell.edges[at].next as usize;
            if at == 0 {
                break;
            }
        }
        let frame = cell.frame();
        let size = (frame.iter()).fold(0.0_f64, |m, f| m.max(f[0].abs()).max(f[1].abs()));
        if around.len() < cell.edges.len() || !(size > 0.0 && size.is_finite()) {
            return None;
        }
        let mut graph = Self {
            points: around
                .iter()
                .map(|&i| middle(&cell.edges[i].from))
                .collect(),
            chords: Vec::new(),
            stubs: Vec::new(),
            cdt: Cdt::with_capacity(around.len(), 3 * around.len(), 2 * around.len()),
            handles: Vec::new(),
            numbers: Vec::new(),
            scale: power_of_two((-exponent(size)).min(1000)),
        };
        for number in 0..around.len() {
            let handle = graph.insert(graph.points[number], number)?;
            graph.handles.push(handle);
        }
        for number in 0..around.len() {
            graph.constrain(number, (number + 1) % around.len())?;
        }
        let mut exits = Vec::new();
        for (number, &i) in around.iter().enumerate() {
            let track = cell.edges[i].notch;
            if track == NONE {
                continue;
            }
            let start = (number + 1) % around.len();
            let crash = envelope.tracks.motorcycles[track as usize].crash;
            let stops = !matches!(crash, Crash::Wall(_) | Crash::Vertex(_));
            let end = envelope.ends[track as usize];
            let near = graph.exit(start, end, !stops, 0);
            match near.or_else(|| graph.exit(start, end, true, u8::from(stops))) {
                Some(exit) => exits.push(exit),
                None => graph.stubs.push(Stub { start, end }),
            }
        }
        graph.add_exits(exits)?;
        Some(graph)
    }

    fn scaled(&self, p: [f64; 2]) -> Point2<f64> {
        // Spade takes no numbers that are close to zero.
        let [x, y] = p.map(|x| {
            let x = x * self.scale;
            if x.abs() < power_of_two(-100) { 0.0 } else { x }
        });
        Point2::new(x, y)
    }

    /// Adds a point; `None` if there is one already.
    fn insert(&mut self, point: [f64; 2], number: usize) -> Option<FixedVertexHandle> {
        let handle = self.cdt.insert(self.scaled(point)).ok()?;
        if handle.index() != self.numbers.len() {
            return None;
        }
        self.numbers.push(number);
        Some(handle)
    }

    /// Draws a line, if it crosses no other.
    fn constrain(&mut self, i: usize, j: usize) -> Option<()> {
        let pieces = self
            .cdt
            .try_add_constraint(self.handles[i], self.handles[j]);
        (pieces.len() == 1).then_some(())
    }

    /// Where the way from a corner to the end of a track leaves the cell; or the way on from there, if it `is_far`.
    fn exit(&self, from: usize, end: [f64; 2], is_far: bool, rank: u8) -> Option<Exit> {
        let start = self.points[from];
        let way = [0, 1].map(|k| end[k] - start[k]);
        let factor = if is_far {
            8.0 / self.scale / way[0].abs().max(way[1].abs())
        } else {
            1.0
        };
        let to = [0, 1].map(|k| start[k] + factor * way[k]);
        if !to.iter().all(|x| x.is_finite()) {
            return None;
        }
        let [p, q] = [start, to].map(|p| self.scaled(p));
        for met in LineIntersectionIterator::new(&self.cdt, p, q) {
            match met {
                Intersection::VertexIntersection(vertex) => {
                    let number = self.numbers[vertex.index()];
                    if number != from {
                        let (after, part) = (number, 0.0);
                        return Some(Exit {
                            after,
                            part,
                            from,
                            end,
                            rank,
                        });
                    }
                }
                Intersection::EdgeIntersection(edge) if edge.is_constraint_edge() => {
                    let ends = edge.vertices().map(|v| v.position());
                    let [a, b] =
                        ends.map(|v| (q.x - p.x) * (v.y - p.y) - (q.y - p.y) * (v.x - p.x));
                    let [mut i, j] = edge.vertices().map(|v| self.numbers[v.index()]);
                    let mut part = a / (a - b);
                    if (j + 1) % self.points.len() == i {
                        (i, part) = (j, 1.0 - part);
                    }
                    return (0.0..1.0).contains(&part).then_some(Exit {
                        after: i,
                        part,
                        from,
                        end,
                        rank,
                    });
                }
                _ => {}
            }
        }
        None
    }

    /// Adds ends of valleys to the boundary, and the valleys that cross no other.
    fn add_exits(&mut self, mut exits: Vec<Exit>) -> Option<()> {
        exits.sort_by(|p, q| p.after.cmp(&q.after).then(p.part.total_cmp(&q.part)));
        let count = self.points.len();
        let old = std::mem::take(&mut self.points);
        let corners = std::mem::take(&mut self.handles);
        // The new number of each corner.
        let mut renamed = Vec::with_capacity(count);
        let mut chords = Vec::with_capacity(exits.len());
        let mut exits = exits.into_iter().peekable();
        for corner in 0..count {
            let next = (corner + 1) % count;
            let first = self.points.len();
            renamed.push(first);
            self.numbers[corners[corner].index()] = first;
            self.points.push(old[corner]);
            self.handles.push(corners[corner]);
            while let Some(exit) = exits.next_if(|exit| exit.after == corner) {
                let point =
                    [0, 1].map(|k| old[corner][k] + exit.part * (old[next][k] - old[corner][k]));
                let last = self.points[self.points.len() - 1];
                let is_corner = [last, old[next]].map(|p| self.scaled(p) == self.scaled(point));
                if is_corner[1] {
                    let (start, end) = (exit.from, exit.end);
                    self.stubs.push(Stub { start, end });
                    continue;
                }
                if !is_corner[0] {
                    if self.points.len() == first + 1 {
                        let ends = [corners[corner], corners[next]];
                        let edge = self.cdt.get_edge_from_neighbors(ends[0], ends[1])?;
                        let edge = edge.as_undirected().fix();
                        self.cdt.remove_constraint_edge(edge);
                    }
                    let number = self.points.len();
                    let handle = self.insert(point, number)?;
                    self.points.push(point);
                    self.handles.push(handle);
                }
                chords.push((exit, self.points.len() - 1));
            }
        }
        let count = self.points.len();
        for number in 0..count {
            let next = (number + 1) % count;
            let edge = self
                .cdt
                .get_edge_from_neighbors(self.handles[number], self.handles[next]);
            if !edge.is_some_and(|edge| edge.is_constraint_edge()) {
                self.constrain(number, next)?;
            }
        }
        for stub in &mut self.stubs {
            stub.start = renamed[stub.start];
        }
        // Valleys whose motorcycles stop in the cell are extended where no other one is in the way.
        chords.sort_by_key(|(exit, _)| exit.rank);
        for (exit, to) in chords {
            let ends = [renamed[exit.from], to];
            let steps = (ends[0] + count - ends[1]) % count;
            if steps > 1 && steps < count - 1 && self.constrain(ends[0], ends[1]).is_some() {
                self.chords.push(Chord { ends });
            } else {
                let (start, end) = (ends[0], exit.end);
                self.stubs.push(Stub { start, end });
            }
        }
        Some(())
    }

    /// The sides of triangles in the cell, and how they divide its valleys; `None` if the triangles are no tree.
    pub(super) fn sides(&self) -> Option<Vec<Side>> {
        let count = self.points.len();
        let mut is_valley = vec![false; self.cdt.num_undirected_edges()];
        for chord in &self.chords {
            let [a, b] = chord.ends.map(|i| self.handles[i]);
            let edge = self.cdt.get_edge_from_neighbors(a, b)?;
            is_valley[edge.as_undirected().index()] = true;
        }
        // Triangles, each after the one from which it was reached, across an edge.
        struct Reached {
            face: usize,
            from: usize,
            /// The triangle is on its left.
            ends: [usize; 2],
            weight: usize,
            below: usize,
        }
        let first = self
            .cdt
            .get_edge_from_neighbors(self.handles[0], self.handles[1])?;
        let mut is_seen = vec![false; self.cdt.num_all_faces()];
        let mut reached: Vec<Reached> = Vec::with_capacity(count);
        let mut stack = vec![(first, usize::MAX)];
        while let Some((edge, from)) = stack.pop() {
            let face = edge.face().as_inner()?;
            if std::mem::replace(&mut is_seen[face.index()], true) {
                return None;
            }
            let number = reached.len();
            let weight = usize::from(is_valley[edge.as_undirected().index()]);
            reached.push(Reached {
                face: face.index(),
                from,
                ends: edge.vertices().map(|v| self.numbers[v.index()]),
                weight,
                below: 0,
            });
            for other in [edge.next(), edge.prev()] {
                if !other.is_constraint_edge() || is_valley[other.as_undirected().index()] {
                    stack.push((other.rev(), number));
                }
            }
        }
        if reached.len() + 2 != count {
            return None;
        }
        let mut stubs = vec![0; self.cdt.num_all_faces()];
        for stub in &self.stubs {
            let ends = [stub.start, (stub.start + 1) % count].map(|i| self.handles[i]);
            let edge = self.cdt.get_edge_from_neighbors(ends[0], ends[1])?;
            stubs[edge.face().index()] += 1;
        }
        for triangle in &mut reached {
            triangle.below = stubs[triangle.face];
        }
        for number in (1..reached.len()).rev() {
            let Reached {
                from,
                weight,
                below,
                ..
            } = reached[number];
            reached[from].below += below + weight;
        }
        let all = self.chords.len() + self.stubs.len();
        let side = |r: &Reached| {
            // On its left, and on its right.
            let counts = [r.below, all - r.below - r.weight];
            let is_left = (r.weight > 0).then_some(counts[0] > counts[1]);
            let most = match is_left {
                None => counts[0].max(counts[1]),
                Some(true) => counts[0].max(counts[1] + 1),
                Some(false) => counts[1].max(counts[0] + 1),
            };
            Side {
                ends: r.ends,
                most,
                is_left,
            }
        };
        Some(reached[1..].iter().map(side).collect())
    }
}
