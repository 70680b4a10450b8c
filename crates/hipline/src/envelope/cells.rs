//! Divide and conquer: which faces may border on each other?
//!
//! The plan is cut along an axis through the middle of the sources in a cell, and the roof above the cut is found as a lower
//! envelope of the slabs that appear in the cell. What appears in one half then has its source there, or appears on that half's
//! boundary: going straight down from any place of a face, along the valley where there is one, one gets to the face's
//! source or leaves the half. So each half gets a short list of its own, and the recursion ends where lists are
//! short: all pairs of a list are candidates. Arcs lie in some cell over a length, so no pair is missed; a pair too many does
//! no harm, as what is made of the candidates are valid parts of slabs (`docs/engines.md`).
//!
//! *Departures from the thesis.* It cuts along vertical lines through vertices of the motorcycle graph only, confines cells by descent paths from all crossings of
//! the cut with arcs, and cuts along chords between valleys afterwards. Descent paths keep a ridge out of all cells but O(log r);
//! here, a face is on the list of every cell that it reaches into, which makes the bound worse: a face that crosses m cells
//! is treated m times. Cells are rectangles instead, cut across their longer side, so that long cells do not collect
//! what crosses them. There is no second stage, as nothing needs convex cells. A cut has few binary digits, and where two planes agree all along it, another one is taken.
//!
//! Nothing here decides what the skeleton is: in doubt, lists are longer. Coordinates in f64 serve to choose cuts, and bounds of
//! them to shorten lists.

use super::{Envelope, section::Visible};
use crate::predicates::{Cut, PlaneId};

/// A list this short is not worth a cut.
const SHORT: usize = 12;
/// Cuts are tried this often before a cell is left as it is.
const TRIES: usize = 4;

/// A rectangle: the limits in x, then in y.
type Frame = [[f64; 2]; 2];

/// A part of the plan.
struct Cell {
    frame: Frame,
    /// The sources that may reach into it, by number.
    sources: Vec<u32>,
    /// What is on the roof above its sides: left, right, below, above.
    sides: [Vec<Visible>; 4],
    depth: u32,
}

/// The source of a face: a segment in plan, roughly.
struct Segment {
    face: u32,
    ends: [[f64; 2]; 2],
}

/// The part of a segment within a frame, roughly, if there may be any.
fn clip(ends: &[[f64; 2]; 2], frame: &Frame) -> Option<[[f64; 2]; 2]> {
    let [p, q] = *ends;
    let size = ends.iter().flatten().fold(0.0_f64, |m, x| m.max(x.abs()));
    // Far more than the roundings below.
    let slack = size / (1_u64 << 40) as f64;
    let (mut from, mut to) = (0.0_f64, 1.0_f64);
    for k in 0..2 {
        let [low, high] = [frame[k][0] - slack, frame[k][1] + slack];
        let (least, most) = (p[k].min(q[k]), p[k].max(q[k]));
        if most < low || least > high {
            return None;
        }
        let d = q[k] - p[k];
        if most - least <= 4.0 * slack {
            continue;
        }
        let [s, t] = [(low - p[k]) / d, (high - p[k]) / d];
        from = from.max(s.min(t));
        to = to.min(s.max(t));
    }
    let slip = 1.0 / (1_u64 << 30) as f64;
    if from > to + slip {
        return None;
    }
    let at = |s: f64| [0, 1].map(|k| p[k] + s * (q[k] - p[k]));
    Some([at(from), at(to)])
}

/// A number with few binary digits near another one, in an interval of the given width.
fn coarse(x: f64, width: f64, attempt: usize) -> f64 {
    let grain = 2.0_f64.powi(width.log2().floor() as i32 - 8);
    ((x / grain).floor() + 0.3125 + attempt as f64) * grain
}

impl Envelope<'_> {
    /// Pairs of faces that may border on each other, the lower number first, ascending.
    ///
    /// # Complexity
    /// With s the sum of the lengths of the lists of one level: O(s log s) for each of O(log n) levels, and the squares of the lengths
    /// of the last lists.
    pub(super) fn candidates(&mut self) -> Vec<[u32; 2]> {
        let segments = self.segments();
        let mut frame = [[f64::INFINITY, f64::NEG_INFINITY]; 2];
        for p in self.figure.vertices() {
            for k in 0..2 {
                frame[k] = [frame[k][0].min(p[k]), frame[k][1].max(p[k])];
            }
        }
        let deepest = 16 + 3 * (self.faces.len().ilog2());
        let mut cells = vec![Cell {
            frame,
            sources: (0..segments.len() as u32).collect(),
            sides: Default::default(),
            depth: 0,
        }];
        let members = self.members_of_classes();
        let mut pairs: Vec<[u32; 2]> = Vec::new();
        let mut sorted_up_to = 1 << 16;
        while let Some(cell) = cells.pop() {
            self.count.cells += 1;
            self.count.depth = self.count.depth.max(cell.depth);
            let list = self.list(&cell, &segments, &members);
            self.count.listed += list.len() as u64;
            let halves = if list.len() <= SHORT || cell.depth >= deepest {
                None
            } else {
                self.halve(&cell, &list, &segments, &members)
            };
            match halves {
                Some(halves) => cells.extend(halves),
                None => {
                    for (i, &f) in list.iter().enumerate() {
                        pairs.extend(list[i + 1..].iter().map(|&g| [f, g]));
                    }
                    if pairs.len() > sorted_up_to {
                        pairs.sort_unstable();
                        pairs.dedup();
                        sorted_up_to = 2 * pairs.len().max(1 << 15);
                    }
                }
            }
        }
        pairs.sort_unstable();
        pairs.dedup();
        pairs
    }

    /// The sources of all slabs, roughly.
    fn segments(&self) -> Vec<Segment> {
        let mut segments = Vec::new();
        for &face in &self.faces {
            for slab in &self.sources[face as usize].slabs {
                let ends = slab.ends.map(|end| {
                    let [x, y, _] = self.planes.round(&end.into());
                    [x, y]
                });
                segments.push(Segment { face, ends });
            }
        }
        segments
    }

    /// The faces of each class of planes, ascending by class.
    fn members_of_classes(&self) -> Vec<(PlaneId, u32)> {
        let mut members: Vec<(PlaneId, u32)> = (self.faces.iter())
            .map(|&face| (self.class(PlaneId(face)), face))
            .collect();
        members.sort_unstable();
        members
    }

    /// The faces that may appear in a cell.
    fn list(&self, cell: &Cell, segments: &[Segment], members: &[(PlaneId, u32)]) -> Vec<u32> {
        let mut list: Vec<u32> = (cell.sources.iter())
            .map(|&s| segments[s as usize].face)
            .collect();
        for visible in cell.sides.iter().flatten() {
            let first = members.partition_point(|m| m.0 < visible.plane);
            let same = members[first..].iter().take_while(|m| m.0 == visible.plane);
            list.extend(same.map(|m| m.1));
        }
        list.sort_unstable();
        list.dedup();
        list
    }

    /// Cuts a cell in two, if that makes lists shorter.
    fn halve(
        &mut self,
        cell: &Cell,
        list: &[u32],
        segments: &[Segment],
        members: &[(PlaneId, u32)],
    ) -> Option<[Cell; 2]> {
        let widths = cell.frame.map(|[low, high]| high - low);
        let axis = usize::from(widths[1] > widths[0]);
        let [low, high] = cell.frame[axis];
        let mut middles: Vec<f64> = (cell.sources.iter())
            .filter_map(|&s| clip(&segments[s as usize].ends, &cell.frame))
            .map(|[p, q]| p[axis].midpoint(q[axis]))
            .collect();
        let middle = if middles.len() < 2 {
            low.midpoint(high)
        } else {
            let half = middles.len() / 2;
            *middles.select_nth_unstable_by(half, f64::total_cmp).1
        };
        for attempt in 0..TRIES {
            let c = coarse(middle, high - low, attempt);
            if !(low < c && c < high) {
                continue;
            }
            let cut = Cut::new(&self.planes, c, axis == 1);
            let Some(mut roof) = self.section(&cut, list) else {
                continue;
            };
            let [from, to] = cell.frame[1 - axis];
            roof.retain(|v| v.from <= to && v.to >= from);
            let halves = [0, 1].map(|half| self.half(cell, axis, c, half, &roof, segments));
            let longest = (halves.iter())
                .map(|half| self.list(half, segments, members).len())
                .max()
                .unwrap_or_default();
            let is_shorter =
                longest * 16 <= list.len() * 15 || !cell.sources.is_empty() && longest < list.len();
            return is_shorter.then_some(halves);
        }
        None
    }

    /// One half of a cell.
    fn half(
        &self,
        cell: &Cell,
        axis: usize,
        c: f64,
        half: usize,
        roof: &[Visible],
        segments: &[Segment],
    ) -> Cell {
        let mut frame = cell.frame;
        frame[axis][1 - half] = c;
        let sources = cell.sources.iter().copied();
        let sources = sources.filter(|&s| clip(&segments[s as usize].ends, &frame).is_some());
        let mut sides = cell.sides.clone();
        sides[2 * axis + 1 - half] = roof.to_vec();
        let [from, to] = frame[axis];
        // The sides across the cut are cut, too.
        for side in &mut sides[2 * (1 - axis)..2 * (1 - axis) + 2] {
            side.retain(|v| v.from <= to && v.to >= from);
        }
        Cell {
            frame,
            sources: sources.collect(),
            sides,
            depth: cell.depth + 1,
        }
    }
}
