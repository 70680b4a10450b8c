//! Divide and conquer: which faces may border on each other? The subdivision of chapters 3 and 4 of the thesis.
//!
//! The inside of the figure is cut again and again: first through the median of the motorcycle vertices in a cell, then between its
//! valleys, until there is one at most. The roof above a cut, a lower envelope of segments, tells the
//! faces on it; descent paths from there confine the cells on both sides ([`split`](super::split)). Over a cell without valleys the roof is convex, a
//! lower envelope of planes ([`convex`](super::convex)). An arc lies in some last cell over a length, and its faces are on that cell's list, so no pair is missed; a
//! pair too many does no harm, as what is made of the candidates are valid parts of slabs (`docs/engines.md`).
//!
//! Nothing here decides what the skeleton is: in doubt, lists are longer. Coordinates in f64 serve to choose cuts.

use super::{
    Envelope,
    boundary::{Cell, Edge, Kind, NONE, Node},
    section::{Cut, Mark},
};
use crate::predicates::{CellCorner, PlaneId, Station};
use hipline_num::{exponent, power_of_two};
use std::{collections::VecDeque, sync::Arc};

/// Of a list this short, all pairs are candidates.
const SHORT: usize = 8;
/// So many lines are tried in either stage before a cell is left as it is.
const TRIES: usize = 4;

/// So many cells are found before threads share them.
const MANY: usize = 64;

/// What a thread found.
#[derive(Default)]
pub(super) struct Found {
    /// Pairs of faces, the lower number first.
    pub pairs: Vec<[u32; 2]>,
    sorted_up_to: usize,
}

impl Found {
    fn add(&mut self, f: u32, g: u32) {
        if f != g {
            self.pairs.push([f.min(g), f.max(g)]);
        }
    }

    pub(super) fn tidy(&mut self) {
        self.pairs.sort_unstable();
        self.pairs.dedup();
        self.sorted_up_to = 2 * self.pairs.len().max(1 << 15);
    }
}

/// A number with few binary digits between two others.
fn between(low: f64, high: f64) -> Option<f64> {
    let grain = power_of_two((exponent(high - low) - 3).max(-1000));
    let c = (low.midpoint(high) / grain).floor() * grain + 0.3125 * grain;
    (low < c && c < high).then_some(c)
}

pub(super) fn middle(node: &Node) -> [f64; 2] {
    node.frame.map(|[low, high]| low.midpoint(high))
}

impl Envelope<'_> {
    /// Pairs of faces that may border on each other, the lower number first, ascending.
    pub(super) fn candidates(&mut self) -> Vec<[u32; 2]> {
        let mut found = Found::default();
        for &face in &self.faces {
            found.add(face, self.beside[face as usize][1]);
        }
        for track in &self.tracks.motorcycles {
            found.add(track.pair[0].0, track.pair[1].0);
        }
        // The largest cells first; then what is in each of many, by any number of threads.
        let mut cells = VecDeque::from(self.first_cells());
        while let Some(cell) = cells.pop_front() {
            cells.extend(self.divide(&cell, &mut found));
            if cells.len() >= MANY {
                break;
            }
        }
        let all = self.spread(cells.make_contiguous(), |envelope, cell| {
            let mut found = Found::default();
            let mut cells = vec![cell.clone()];
            while let Some(cell) = cells.pop() {
                cells.extend(envelope.divide(&cell, &mut found));
            }
            found.tidy();
            found.pairs
        });
        found.pairs.extend(all.into_iter().flatten());
        self.add_twins(&mut found);
        found.tidy();
        found.pairs
    }

    /// Where a face's slab lies on that of another one, on one plane, either may have been taken for the other.
    fn add_twins(&self, found: &mut Found) {
        let mut twins = self.twins.clone();
        twins.extend(self.twins.iter().map(|&[f, g]| [g, f]));
        twins.sort_unstable();
        twins.dedup();
        if twins.is_empty() {
            return;
        }
        for pair in found.pairs.clone() {
            for [f, g] in [pair, [pair[1], pair[0]]] {
                let first = twins.partition_point(|twin| twin[0] < f);
                for twin in twins[first..].iter().take_while(|twin| twin[0] == f) {
                    found.add(twin[1], g);
                }
            }
        }
    }

    /// The components of the inside.
    fn first_cells(&self) -> Vec<Cell> {
        let mesh = self.figure.mesh();
        // The component of each triangle.
        let mut of = vec![NONE; mesh.corners.len()];
        let mut count = 0;
        for start in 0..of.len() {
            if !mesh.inside[start] || of[start] != NONE {
                continue;
            }
            let mut stack = vec![start];
            of[start] = count;
            while let Some(t) = stack.pop() {
                for side in mesh.across[t].iter().filter(|side| side.edge.is_none()) {
                    let next = side.neighbour as usize;
                    if of[next] == NONE {
                        of[next] = count;
                        stack.push(next);
                    }
                }
            }
            count += 1;
        }
        let nodes: Vec<Arc<Node>> = (self.figure.vertices().iter())
            .map(|&v| self.node(CellCorner::At(Arc::new(Station::new(&self.planes, v)))))
            .collect();
        let mut cells: Vec<Cell> = (0..count)
            .map(|_| Cell {
                edges: Vec::new(),
                holes: 0,
                depth: 0,
                is_late: false,
            })
            .collect();
        let mut slab = vec![NONE; self.sources.len()];
        for (number, of) in self.refs.iter().enumerate() {
            if self.sources[of.face as usize].slabs[of.index as usize]
                .beside
                .is_none()
            {
                slab[of.face as usize] = number as u32;
            }
        }
        let mut is_done = vec![false; self.sources.len()];
        for &first in &self.faces {
            if is_done[first as usize] {
                continue;
            }
            let cell = &mut cells[of[self.triangles[first as usize] as usize] as usize];
            cell.holes += usize::from(!cell.edges.is_empty());
            let start = cell.edges.len() as u32;
            let mut face = first;
            while !is_done[face as usize] {
                is_done[face as usize] = true;
                let number = slab[face as usize];
                let notch = self.sources[face as usize].tracks[1].first();
                cell.edges.push(Edge {
                    from: nodes[self.end_of(face, 0)].clone(),
                    to: nodes[self.end_of(face, 1)].clone(),
                    line: self.line_of(Mark::Source(number)),
                    kind: Kind::Source,
                    slab: number,
                    notch: notch.copied().unwrap_or(NONE),
                    passes: NONE,
                    next: cell.edges.len() as u32 + 1,
                });
                face = self.beside[face as usize][1];
            }
            cell.edges.last_mut().expect("an edge").next = start;
        }
        cells
    }

    /// Divides a cell, or finds what borders on each other in it.
    fn divide(&mut self, cell: &Cell, found: &mut Found) -> Vec<Cell> {
        self.count.cells += 1;
        self.count.depth = self.count.depth.max(cell.depth);
        let deepest = 32 + 4 * self.faces.len().ilog2();
        let slabs = self.slabs_in(cell);
        let is_short = slabs.len() <= SHORT;
        let sides = if is_short {
            None
        } else if cell.is_convex() {
            Some(vec![slabs.clone()])
        } else {
            self.beside_valley(cell).map(Vec::from)
        };
        if !is_short
            && sides.is_none()
            && cell.depth < deepest
            && let Some(parts) = self.cut_up(cell)
        {
            return parts;
        }
        if !cell.is_late {
            self.show(0, cell);
        }
        self.show(1, cell);
        self.finish(slabs, sides, found);
        Vec::new()
    }

    /// What is left by the first cut that divides a cell well: through the median of its motorcycle vertices, or else between its valleys.
    fn cut_up(&mut self, cell: &Cell) -> Option<Vec<Cell>> {
        let whole = self.weight(cell);
        let is_first = !cell.is_late && whole[2] >= 3;
        for is_late in [false, true] {
            if is_late {
                for cut in self.chords(cell) {
                    if let Some(parts) = self.cut_by(cell, &cut, whole, true) {
                        return Some(parts);
                    }
                }
            } else if !is_first {
                continue;
            }
            for attempt in 0..TRIES {
                if let Some(cut) = self.line_for(cell, attempt, is_late)
                    && let Some(parts) = self.cut_by(cell, &cut, whole, is_late)
                {
                    return Some(parts);
                }
            }
        }
        None
    }

    /// What a cut leaves of a cell of known weight, if it divides it well.
    fn cut_by(
        &mut self,
        cell: &Cell,
        cut: &Cut,
        whole: [usize; 3],
        is_late: bool,
    ) -> Option<Vec<Cell>> {
        let mut parts = self.split(cell, cut)?;
        let is_progress = parts.iter().all(|part| {
            let part = self.weight(part);
            part[0] < whole[0] || 8 * part[1] < 7 * whole[1] || 8 * part[2] < 7 * whole[2]
        });
        if !is_progress {
            return None;
        }
        for part in &mut parts {
            part.is_late = is_late;
        }
        if is_late && !cell.is_late {
            self.show(0, cell);
        }
        Some(parts)
    }

    /// Remembers a cell, if somebody wants to see it.
    fn show(&mut self, stage: usize, cell: &Cell) {
        if let Some(seen) = &mut self.seen {
            seen[stage].push(cell.clone());
        }
    }

    /// The numbers of its valleys, its slabs, and its motorcycle vertices.
    fn weight(&self, cell: &Cell) -> [usize; 3] {
        let (points, valleys) = self.points_in(cell);
        [valleys.len(), self.slabs_in(cell).len(), points.len()]
    }

    /// Lists the pairs of faces of a cell that is not divided any further: of all its slabs, unless it consists of parts without valleys.
    fn finish(&mut self, slabs: Vec<u32>, sides: Option<Vec<Vec<u32>>>, found: &mut Found) {
        self.count.last += slabs.len() as u64;
        if let Some(sides) = sides {
            for side in sides {
                self.list_convex(&side, found);
            }
        } else {
            let faces = self.faces_of(&slabs);
            self.count.pairs += (faces.len() * faces.len() / 2) as u64;
            for (i, &f) in faces.iter().enumerate() {
                for &g in &faces[i + 1..] {
                    found.add(f, g);
                }
            }
        }
        if found.pairs.len() > found.sorted_up_to.max(1 << 16) {
            found.tidy();
        }
    }

    /// The faces of slabs, ascending.
    fn faces_of(&self, slabs: &[u32]) -> Vec<u32> {
        let faces = slabs.iter().map(|&s| self.refs[s as usize].face);
        let mut faces: Vec<u32> = faces.collect();
        faces.sort_unstable();
        faces.dedup();
        faces
    }

    /// Lists the pairs of faces that border on each other on the lower envelope of their planes.
    fn list_convex(&mut self, slabs: &[u32], found: &mut Found) {
        let mut members: Vec<(PlaneId, u32)> = (self.faces_of(slabs).into_iter())
            .map(|face| (self.class(PlaneId(face)), face))
            .collect();
        members.sort_unstable();
        let planes = members.iter().map(|m| m.0).collect();
        for pair in self.convex_pairs(planes) {
            let [of, with] = pair.map(|plane| {
                let first = members.partition_point(|m| m.0 < plane);
                members[first..].iter().take_while(move |m| m.0 == plane)
            });
            for f in of {
                for g in with.clone() {
                    found.add(f.1, g.1);
                }
            }
        }
    }

    /// What can be known of where things are in a cell: the motorcycle vertices in it, and its valleys, from their notches to where their tracks leave
    /// the cell's frame.
    fn points_in(&self, cell: &Cell) -> (Vec<[f64; 2]>, Vec<[[f64; 2]; 2]>) {
        let frame = cell.frame();
        let inside = |p: [f64; 2]| (0..2).all(|k| frame[k][0] < p[k] && p[k] < frame[k][1]);
        let (mut points, mut valleys) = (Vec::new(), Vec::new());
        for (node, track) in cell.notches() {
            let start = middle(node);
            let end = self.ends[track as usize];
            if let CellCorner::At(_) = node.what {
                points.push(start);
            }
            if inside(end) {
                points.push(end);
            }
            valleys.push(clip([start, end], &frame));
        }
        (points, valleys)
    }

    /// A line up or to the right through a cell: through the median of the motorcycle vertices in it, or else, where there is no chord, between its valleys.
    fn line_for(&self, cell: &Cell, attempt: usize, is_late: bool) -> Option<Cut> {
        let frame = cell.frame();
        let (mut points, valleys) = self.points_in(cell);
        if is_late {
            points = valleys
                .iter()
                .map(|[p, q]| [0, 1].map(|k| p[k].midpoint(q[k])))
                .collect();
        }
        if points.is_empty() {
            // A hole, or a valley that only passes.
            points.push(frame.map(|[low, high]| low.midpoint(high)));
        }
        let mut cuts = [0, 1].map(|axis| {
            let [low, high] = frame[axis];
            let mut values: Vec<f64> = points.iter().map(|p| p[axis].clamp(low, high)).collect();
            values.extend([low, high]);
            values.sort_by(f64::total_cmp);
            let count = values.len() - 1;
            // The gap next to the median, or one further away.
            let mut gaps: Vec<usize> = (0..count).filter(|&i| values[i] < values[i + 1]).collect();
            gaps.sort_by_key(|&i| ((2 * i + 1).abs_diff(count), i));
            let gap = *gaps.get(attempt / 2)?;
            let c = between(values[gap], values[gap + 1])?;
            // How many are certainly on either side.
            let least = |sides: &mut dyn Iterator<Item = [f64; 2]>| {
                let mut counts = [0; 2];
                for [p, q] in sides {
                    counts[0] += usize::from(p.max(q) < c);
                    counts[1] += usize::from(p.min(q) > c);
                }
                counts[0].min(counts[1])
            };
            let by_points = least(&mut points.iter().map(|p| [p[axis]; 2]));
            let by_valleys = least(&mut valleys.iter().map(|[p, q]| [p[axis], q[axis]]));
            Some((c, [by_points, by_valleys], high - low))
        });
        let value = |cut: &Option<(f64, [usize; 2], f64)>| {
            cut.map_or((0, 0.0), |(_, [points, valleys], width)| {
                let value = if is_late {
                    3 * valleys + points
                } else {
                    points + valleys
                };
                (value + 1, width)
            })
        };
        let [x, y] = cuts.each_ref().map(value);
        let swap = y.0 > x.0 || y.0 == x.0 && y.1 > x.1;
        let axis = usize::from(swap) ^ (attempt % 2);
        let (c, _, _) = cuts[axis].take()?;
        Some(Cut::across(&self.planes, axis, c))
    }
}

/// The part of a segment within a frame, roughly, from its start.
fn clip([p, q]: [[f64; 2]; 2], frame: &[[f64; 2]; 2]) -> [[f64; 2]; 2] {
    let mut to = 1.0_f64;
    for k in 0..2 {
        let d = q[k] - p[k];
        let bound = if d > 0.0 { frame[k][1] } else { frame[k][0] };
        if d != 0.0 {
            to = to.min(((bound - p[k]) / d).max(0.0));
        }
    }
    [p, [0, 1].map(|k| p[k] + to * (q[k] - p[k]))]
}
