//! One step of the subdivision: a cut, the roof above it, and descent paths from where it crosses edges of the roof (section 3.3 of the thesis).
//!
//! *Where it departs from the thesis.* Descent paths come in pairs: below a stretch of a cut on which one slab is visible, and on the side to which the slab
//! sinks, lies a *strip* with nothing else above it, down to where the way leaves the cell. It is taken out. The thesis starts it exactly at
//! the ends of the stretch; here, it starts at points near these with coordinates in f64, so that the paths' equations stay short, and no two things coincide.
//! Where that is not possible, or where it is not clear how the way down leaves the cell, nothing is taken out:
//! cells are then larger than necessary, and never miss a face. Only ways down valleys start where the cut crosses the valley.

use super::{
    Envelope,
    boundary::{Cell, Crossing, Edge, Kind, NONE, Node},
    profile::{Chart, Piece},
    section::{Above, Cut, Mark, Spot},
    strips::Half,
};
use crate::predicates::{CellCorner, Station};
use hipline_num::{Sign, exponent, power_of_two};
use std::sync::Arc;

/// A stretch of a cut within a cell on which one slab is visible.
struct Seen {
    slab: u32,
    ends: [Arc<Node>; 2],
    /// Points within it, from which strips start.
    inner: Option<[Arc<Station>; 2]>,
}

impl Envelope<'_> {
    /// The cells that a cut divides a cell into, and the stretches of the cut between; `None` if another cut is needed.
    pub(super) fn split(&mut self, cell: &Cell, cut: &Cut) -> Option<Vec<Cell>> {
        let mut sides = self.sides(cut, cell)?;
        let mut crossings = self.crossings(cut, cell, &sides)?;
        if cut.is_chord {
            crossings = chord(cut, cell, crossings, &mut sides)?;
        }
        if crossings.is_empty() || self.meets_on(cut, cell) {
            return None;
        }
        let slabs = self.slabs_in(cell);
        self.count.listed += slabs.len() as u64;
        let roof = self.section(cut, &slabs)?;
        let mut seen = Vec::with_capacity(crossings.len() / 2);
        for pair in crossings.chunks_exact(2) {
            seen.push(self.seen(cut, cell, &roof, pair)?);
        }
        let mut cells = Vec::new();
        for side in [Sign::Positive, Sign::Negative] {
            let mut half = self.half(cell, cut, side, &sides, &crossings, &seen)?;
            self.descend_valleys(&mut half);
            self.take_strips(&mut half);
            cells.extend(self.components(half, cell)?);
        }
        Some(cells)
    }

    /// Whether motorcycles of a cell meet on a cut.
    fn meets_on(&self, cut: &Cut, cell: &Cell) -> bool {
        let mut found = false;
        for (_, mut track) in cell.notches() {
            while self.child_of(track) != NONE {
                let end = self.tracks.motorcycles[track as usize].end;
                let end = end.expect("it meets others");
                found |= self.side_of_place(cut, end).is_zero();
                track = self.child_of(track);
            }
        }
        found
    }

    /// What is seen between two crossings.
    fn seen(
        &self,
        cut: &Cut,
        cell: &Cell,
        roof: &[Piece<Spot>],
        pair: &[Crossing],
    ) -> Option<Vec<Seen>> {
        let chart = Above::new(self, cut);
        let order = |spot: &Spot, crossing: &Crossing| {
            let bounds = cut.along(&crossing.node);
            match spot.mark {
                Mark::First => std::cmp::Ordering::Less,
                Mark::Last => std::cmp::Ordering::Greater,
                _ if spot.bounds[1] < bounds[0] => std::cmp::Ordering::Less,
                _ if spot.bounds[0] > bounds[1] => std::cmp::Ordering::Greater,
                mark => {
                    let line = &cell.edges[crossing.edge as usize].line;
                    (self.planes).compare_on_cut(&cut.line, &self.line_of(mark), line)
                }
            }
        };
        let [enter, leave] = [&pair[0], &pair[1]];
        let first = roof.partition_point(|piece| order(&piece.to, enter).is_le());
        if order(&roof.get(first)?.from, enter).is_gt() {
            return None;
        }
        let mut seen: Vec<Seen> = Vec::new();
        let mut from = enter.node.clone();
        for (i, piece) in roof.iter().enumerate().skip(first) {
            let is_last = order(&piece.to, leave).is_ge();
            let to = if is_last {
                leave.node.clone()
            } else {
                let next = roof.get(i + 1)?;
                if chart.order(&piece.to, &next.from).is_lt() {
                    return None;
                }
                self.node_on(cut, &next.from)
            };
            let inner = self.inner(cut, &from, &to);
            seen.push(Seen {
                slab: piece.of,
                ends: [from, to.clone()],
                inner,
            });
            if is_last {
                return Some(seen);
            }
            from = to;
        }
        None
    }

    /// Two points between places on a cut, near these.
    fn inner(&self, cut: &Cut, from: &Node, to: &Node) -> Option<[Arc<Station>; 2]> {
        let (point, toward) = cut.toward?;
        let low = cut.along(from)[1];
        let high = cut.along(to)[0];
        let speed = f64::from(toward[cut.axis].abs());
        let [first, last] = [low, high].map(|x| (x - cut.at(point)) / speed);
        let width = last - first;
        if !(width > 0.0 && width.is_finite()) {
            return None;
        }
        let grain = power_of_two((exponent(width) - 6).max(-900));
        let first = (first / grain).floor() + 1.3125;
        let last = (last / grain).ceil() - 1.3125;
        let [p, q] = [cut.point(first * grain)?, cut.point(last * grain)?];
        let [first, last] = [cut.at(p), cut.at(q)];
        (low < first && first < last && last < high)
            .then(|| [p, q].map(|point| Arc::new(Station::new(&self.planes, point))))
    }

    /// The part of a cell on one side of a cut, before anything is taken out.
    fn half(
        &self,
        cell: &Cell,
        cut: &Cut,
        side: Sign,
        sides: &[Sign],
        crossings: &[Crossing],
        seen: &[Vec<Seen>],
    ) -> Option<Half> {
        let is_left = side.is_positive();
        let mut half = Half::default();
        let mut number = vec![NONE; cell.edges.len()];
        let mut crossed = vec![None; cell.edges.len()];
        for crossing in crossings {
            crossed[crossing.edge as usize] = Some(&crossing.node);
        }
        for (i, edge) in cell.edges.iter().enumerate() {
            let [from, to] = [sides[i], sides[edge.next as usize]];
            if from != side && to != side {
                continue;
            }
            let mut part = edge.clone();
            if from != side {
                part.from = crossed[i]?.clone();
            }
            if to != side {
                part.to = crossed[i]?.clone();
                part.notch = NONE;
                part.passes = NONE;
            }
            number[i] = half.edges.len() as u32;
            half.edges.push(part);
        }
        for (i, edge) in cell.edges.iter().enumerate() {
            if number[i] != NONE && sides[edge.next as usize] == side {
                half.edges[number[i] as usize].next = number[edge.next as usize];
            }
        }
        for (pair, seen) in crossings.chunks_exact(2).zip(seen) {
            // Going along the half's boundary, its inside on the left.
            let [before, after] = if is_left { [0, 1] } else { [1, 0] };
            let mut last = number[pair[before].edge as usize];
            let walk: Vec<&Seen> = if is_left {
                seen.iter().collect()
            } else {
                seen.iter().rev().collect()
            };
            for (i, stretch) in walk.iter().enumerate() {
                let [from, to] = [before, after].map(|k| stretch.ends[k].clone());
                let piece = |from: &Arc<Node>, to: &Arc<Node>| Edge {
                    from: from.clone(),
                    to: to.clone(),
                    line: cut.line.clone(),
                    kind: Kind::Cut,
                    slab: stretch.slab,
                    notch: NONE,
                    passes: NONE,
                    next: NONE,
                };
                let sinks = self
                    .planes
                    .sinks_to(&cut.line, self.slab(stretch.slab).plane)
                    == side;
                match &stretch.inner {
                    Some(inner) if sinks => {
                        let stations = [before, after].map(|k| inner[k].clone());
                        let nodes =
                            (stations.each_ref()).map(|at| self.node(CellCorner::At(at.clone())));
                        let first = half.push(piece(&from, &nodes[0]), last);
                        let middle = half.push(piece(&nodes[0], &nodes[1]), first);
                        last = half.push(piece(&nodes[1], &to), middle);
                        half.strips.push([first, middle, last]);
                        half.stations.push(stations);
                        half.new.extend([first, middle, last]);
                    }
                    _ => {
                        last = half.push(piece(&from, &to), last);
                        half.new.push(last);
                    }
                }
                let Some(next) = walk.get(i + 1) else {
                    continue;
                };
                let track = self.valley_between(stretch.slab, next.slab);
                if track == NONE {
                    continue;
                }
                let start = self.tracks.motorcycles[track as usize].start;
                if self.side_of_place(cut, start) == side {
                    half.edges[last as usize].passes = track;
                    half.valleys.push(last);
                } else {
                    half.edges[last as usize].notch = track;
                }
            }
            half.edges[last as usize].next = number[pair[after].edge as usize];
        }
        half.index();
        Some(half)
    }
}

/// Of the stretches of a cut within a cell without holes, the one around the cut's point. What it divides the cell into are the sides
/// from now on.
fn chord(
    cut: &Cut,
    cell: &Cell,
    crossings: Vec<Crossing>,
    sides: &mut [Sign],
) -> Option<Vec<Crossing>> {
    let at = cut.at(cut.toward?.0);
    let number = crossings.partition_point(|c| cut.along(&c.node)[1] < at);
    let pair: Vec<Crossing> = crossings
        .into_iter()
        .skip(number.checked_sub(1)?)
        .take(2)
        .collect();
    let [enter, leave] = &pair[..] else {
        return None;
    };
    if !enter.enters || cut.along(&leave.node)[0] <= at || cell.holes > 0 {
        return None;
    }
    sides.fill(Sign::Negative);
    let mut edge = leave.edge;
    while edge != enter.edge {
        edge = cell.edges[edge as usize].next;
        sides[edge as usize] = Sign::Positive;
    }
    Some(pair)
}
