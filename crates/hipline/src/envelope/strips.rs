//! Ways down: what is taken out of a half of a cell, and the cells that remain.

use super::{
    Envelope,
    boundary::{Cell, Edge, Kind, NONE, Node, frame},
    section::{Cut, Mark},
};
use crate::predicates::{CellCorner, Line, Place, Station};
use hipline_num::Sign;
use std::{collections::BTreeMap, sync::Arc};

/// The part of a cell on one side of a cut.
#[derive(Default)]
pub(super) struct Half {
    pub edges: Vec<Edge>,
    /// Those that were taken out.
    dead: Vec<bool>,
    /// Where strips start: the edges before, along and after each, going along the boundary.
    pub strips: Vec<[u32; 3]>,
    /// The ends of the middle ones.
    pub stations: Vec<[Arc<Station>; 2]>,
    /// The edges at whose ends a valley goes down into the half.
    pub valleys: Vec<u32>,
    /// The edges along the cut.
    pub new: Vec<u32>,
    /// The edges that bound each slab.
    of_slab: BTreeMap<u32, Vec<u32>>,
    /// The edges with the notches of tracks.
    notch_of: BTreeMap<u32, u32>,
}

/// Where a way straight down gets to.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Landing {
    /// An edge.
    On(u32),
    /// The valley that starts at the end of this edge.
    Valley(u32),
}

impl Half {
    /// Adds an edge after another one.
    pub(super) fn push(&mut self, edge: Edge, before: u32) -> u32 {
        let number = self.edges.len() as u32;
        self.edges.push(edge);
        if before != NONE {
            self.edges[before as usize].next = number;
        }
        number
    }

    /// Finds which edges bound which slab.
    pub(super) fn index(&mut self) {
        self.dead = vec![false; self.edges.len()];
        for (i, edge) in self.edges.iter().enumerate() {
            if edge.kind != Kind::Down {
                self.of_slab.entry(edge.slab).or_default().push(i as u32);
            }
            if edge.notch != NONE {
                self.notch_of.insert(edge.notch, i as u32);
            }
        }
    }

    /// Adds an edge that is not along the cut.
    fn add(&mut self, edge: Edge) -> u32 {
        let number = self.edges.len() as u32;
        if edge.kind != Kind::Down {
            self.of_slab.entry(edge.slab).or_default().push(number);
        }
        if edge.notch != NONE {
            self.notch_of.insert(edge.notch, number);
        }
        self.edges.push(edge);
        self.dead.push(false);
        number
    }

    /// The edges strictly between two that bound one slab, with nothing else between; `None` if there is something else.
    fn between(&self, from: Landing, to: Landing, slab: u32) -> Option<Vec<u32>> {
        let (Landing::On(first) | Landing::Valley(first)) = from;
        let (Landing::On(last) | Landing::Valley(last)) = to;
        let mut found = Vec::new();
        if first == last {
            // From a valley back to the edge before it leads once around.
            let is_whole = matches!((from, to), (Landing::Valley(_), Landing::On(_)));
            return (!is_whole).then_some(found);
        }
        let mut at = first;
        if let Landing::On(_) = from
            && (self.edges[at as usize].notch != NONE || self.edges[at as usize].passes != NONE)
        {
            return None;
        }
        for _ in 0..self.edges.len() {
            at = self.edges[at as usize].next;
            let edge = &self.edges[at as usize];
            if edge.slab != slab || edge.passes != NONE && at != last {
                return None;
            }
            if at == last {
                if let Landing::Valley(_) = to {
                    found.push(at);
                }
                return Some(found);
            }
            if edge.notch != NONE {
                return None;
            }
            found.push(at);
        }
        None
    }

    fn kill(&mut self, edges: &[u32]) {
        for &edge in edges {
            self.dead[edge as usize] = true;
        }
    }
}

impl Envelope<'_> {
    pub(super) fn side_of_place(&self, cut: &Cut, place: Place) -> Sign {
        self.planes.place_beside(&place, &cut.line)
    }

    /// Where straight down from a point on a slab one leaves the half, or gets to a valley.
    fn land(&self, half: &Half, down: &Line, slab: u32) -> Option<Landing> {
        let side = |node: &Node| self.planes.side_of_line(&node.what, down);
        for &i in half
            .of_slab
            .get(&slab)?
            .iter()
            .filter(|&&i| !half.dead[i as usize])
        {
            let edge = &half.edges[i as usize];
            let from = side(&edge.from);
            if from.is_positive() {
                continue;
            }
            let to = side(&edge.to);
            if to.is_negative() {
                continue;
            }
            if from.is_negative() && to.is_positive() {
                return Some(Landing::On(i));
            }
        }
        self.land_in_valley(half, down, slab)
    }

    fn land_in_valley(&self, half: &Half, down: &Line, slab: u32) -> Option<Landing> {
        let track = self.slab(slab).track?;
        let notch = *half.notch_of.get(&track)?;
        let edge = &half.edges[notch as usize];
        if half.dead[notch as usize] || edge.notch != track {
            return None;
        }
        let side = self.planes.side_of_line(&edge.to.what, down);
        let is_first = self.slabs_of_track[track as usize][0] == slab;
        let wanted = if is_first {
            Sign::Positive
        } else {
            Sign::Negative
        };
        (side == wanted).then_some(Landing::Valley(notch))
    }

    /// Draws the ways down valleys that a cut crosses.
    pub(super) fn descend_valleys(&self, half: &mut Half) {
        for k in 0..half.valleys.len() {
            let a = half.valleys[k] as usize;
            let track = half.edges[a].passes;
            let b = half.edges[a].next;
            let Some(&notch) = half.notch_of.get(&track) else {
                continue;
            };
            let notch = notch as usize;
            if half.edges[notch].notch != track || half.dead[notch] {
                continue;
            }
            let [top, foot] = [a, notch].map(|i| half.edges[i].to.clone());
            let line = self.line_of(Mark::Source(self.slabs_of_track[track as usize][0]));
            let [down, up] = [
                (0, &top, &foot, half.edges[notch].next),
                (1, &foot, &top, b),
            ]
            .map(|(side, from, to, next)| Edge {
                from: from.clone(),
                to: to.clone(),
                line: line.clone(),
                kind: Kind::Valley,
                slab: self.slabs_of_track[track as usize][side],
                notch: NONE,
                passes: NONE,
                next,
            });
            half.edges[a].passes = NONE;
            half.edges[notch].notch = NONE;
            half.notch_of.remove(&track);
            let down = half.add(down);
            half.edges[a].next = down;
            let up = half.add(up);
            half.edges[notch].next = up;
        }
    }

    /// Takes strips out of a half.
    pub(super) fn take_strips(&self, half: &mut Half) {
        let strips = std::mem::take(&mut half.strips);
        let stations = std::mem::take(&mut half.stations);
        for (strip, ends) in strips.into_iter().zip(&stations) {
            self.take_strip(half, strip, ends);
        }
    }

    fn take_strip(
        &self,
        half: &mut Half,
        [a, middle, b]: [u32; 3],
        ends: &[Arc<Station>; 2],
    ) -> Option<()> {
        let slab = half.edges[middle as usize].slab;
        let plane = self.slab(slab).plane;
        // The first one is further along the slab.
        let downs = ends.each_ref().map(|at| Line::Down(plane, at.clone()));
        let high = self.land(half, &downs[0], slab)?;
        let low = self.land(half, &downs[1], slab)?;
        let gone = half.between(low, high, slab)?;
        let tops = [0, 1].map(|k| {
            let edge = &half.edges[middle as usize];
            [edge.from.clone(), edge.to.clone()][k].clone()
        });
        let (first, last) = (half.edges[a as usize].clone(), b);
        let down = |from: &Arc<Node>, to: &Arc<Node>, line: &Line, next: u32| Edge {
            from: from.clone(),
            to: to.clone(),
            line: line.clone(),
            kind: Kind::Down,
            slab,
            notch: NONE,
            passes: NONE,
            next,
        };
        let corner =
            |line: &Line, other: &Line| self.node(CellCorner::Of(line.clone(), other.clone()));
        // What is needed of the higher end, before the lower one changes it.
        let track = self.slab(slab).track;
        let sides = track.map(|track| self.slabs_of_track[track as usize]);
        let valley = |side: usize, from: Arc<Node>, to: Arc<Node>, next: u32| {
            let slab = sides.expect("a slab of a track")[side];
            Edge {
                from,
                to,
                line: self.line_of(Mark::Source(slab)),
                kind: Kind::Valley,
                slab,
                notch: NONE,
                passes: NONE,
                next,
            }
        };
        let is_second = sides.is_some_and(|sides| sides[1] == slab);
        match (low, high) {
            (Landing::On(_), Landing::Valley(_)) if !is_second => return None,
            (Landing::Valley(_), Landing::On(_)) if is_second => return None,
            _ => {}
        }
        debug_assert!(first.next == middle);
        let rest = match high {
            Landing::On(i) => {
                let edge = half.edges[i as usize].clone();
                let from = corner(&downs[0], &edge.line);
                Edge { from, ..edge }
            }
            Landing::Valley(i) => {
                let edge = &half.edges[i as usize];
                let (foot, next) = (edge.to.clone(), edge.next);
                let border = self.line_of(Mark::Source(slab));
                valley(0, corner(&downs[0], &border), foot, next)
            }
        };
        let landing = match low {
            Landing::On(i) => corner(&downs[1], &half.edges[i as usize].line),
            Landing::Valley(_) => corner(&downs[1], &self.line_of(Mark::Source(slab))),
        };
        half.kill(&gone);
        half.dead[middle as usize] = true;
        if let (Landing::On(i), Landing::On(j)) = (high, low)
            && i != j
        {
            half.dead[i as usize] = true;
        }
        if let (Landing::On(i), Landing::Valley(_)) = (high, low) {
            half.dead[i as usize] = true;
        }
        // The way down from the first end.
        let is_valley = matches!(high, Landing::Valley(_));
        let foot = rest.from.clone();
        let rest = half.add(rest);
        let mut way = down(&tops[0], &foot, &downs[0], rest);
        if is_valley && is_second {
            way.notch = track.unwrap_or(NONE);
        }
        let way = half.add(way);
        half.edges[a as usize].next = way;
        // The way up to the second end.
        let up = half.add(down(&landing, &tops[1], &downs[1], last));
        match low {
            Landing::On(i) => {
                let edge = &mut half.edges[i as usize];
                edge.to = landing;
                edge.notch = NONE;
                edge.passes = NONE;
                edge.next = up;
            }
            Landing::Valley(i) => {
                let mut along = valley(1, half.edges[i as usize].to.clone(), landing, up);
                if !is_second {
                    along.notch = track.unwrap_or(NONE);
                }
                half.edges[i as usize].notch = NONE;
                let along = half.add(along);
                half.edges[i as usize].next = along;
            }
        }
        Some(())
    }

    /// The cells that a half falls into; `None` if it cannot be told.
    pub(super) fn components(&self, half: Half, cell: &Cell) -> Option<Vec<Cell>> {
        let mut of = vec![NONE; half.edges.len()];
        let mut cycles: Vec<Vec<u32>> = Vec::new();
        for start in 0..half.edges.len() {
            if half.dead[start] || of[start] != NONE {
                continue;
            }
            let mut cycle = Vec::new();
            let mut at = start;
            loop {
                if half.dead[at] || of[at] != NONE {
                    return None;
                }
                of[at] = cycles.len() as u32;
                cycle.push(at as u32);
                at = half.edges[at].next as usize;
                if at == start {
                    break;
                }
            }
            cycles.push(cycle);
        }
        let mut is_outer = vec![false; cycles.len()];
        for &i in half.new.iter().filter(|&&i| !half.dead[i as usize]) {
            is_outer[of[i as usize] as usize] = true;
        }
        let outer: Vec<usize> = (0..cycles.len()).filter(|&c| is_outer[c]).collect();
        let mut groups: Vec<Vec<usize>> = outer.iter().map(|&c| vec![c]).collect();
        for hole in (0..cycles.len()).filter(|&c| !is_outer[c]) {
            let node = half.edges[cycles[hole][0] as usize].from.clone();
            let around = self.around(&half, &cycles, &outer, &node)?;
            groups[around].push(hole);
        }
        let mut cells = Vec::with_capacity(groups.len());
        let mut number = vec![NONE; half.edges.len()];
        for group in groups {
            let members: Vec<u32> = group
                .iter()
                .flat_map(|&c| cycles[c].iter().copied())
                .collect();
            for (k, &i) in members.iter().enumerate() {
                number[i as usize] = k as u32;
            }
            let edges = members.iter().map(|&i| {
                let edge = half.edges[i as usize].clone();
                let next = number[edge.next as usize];
                Edge { next, ..edge }
            });
            let part = Cell {
                edges: edges.collect(),
                holes: group.len() - 1,
                depth: cell.depth + 1,
                is_late: cell.is_late,
            };
            // Over an empty cell there is one slab alone.
            let slab = part.edges[0].slab;
            let is_empty = part.is_convex() && part.edges.iter().all(|edge| edge.slab == slab);
            if !is_empty {
                cells.push(part);
            }
        }
        Some(cells)
    }

    /// Which one of some outer cycles goes around a corner.
    fn around(
        &self,
        half: &Half,
        cycles: &[Vec<u32>],
        outer: &[usize],
        node: &Node,
    ) -> Option<usize> {
        let frames = outer.iter().map(|&c| {
            let frame = frame(cycles[c].iter().map(|&i| &half.edges[i as usize]));
            (0..2).all(|k| frame[k][0] <= node.frame[k][1] && node.frame[k][0] <= frame[k][1])
        });
        let near: Vec<usize> = (frames.enumerate().filter(|(_, is)| *is))
            .map(|(i, _)| i)
            .collect();
        if let [only] = near[..] {
            return Some(only);
        }
        let CellCorner::At(at) = &node.what else {
            return None;
        };
        // Up from there.
        let ray = Line::Toward(at.clone(), [0, 1]);
        let mut found = None;
        for i in near {
            let mut count = 0;
            for &e in &cycles[outer[i]] {
                let edge = &half.edges[e as usize];
                let is_left =
                    |node: &Node| self.planes.side_of_line(&node.what, &ray).is_positive();
                if is_left(&edge.from) == is_left(&edge.to) {
                    continue;
                }
                let slope = self.planes.slope_on_cut(&ray, &edge.line);
                match self.planes.side_of_line(&node.what, &edge.line) * slope {
                    Sign::Negative => count += 1,
                    Sign::Zero => return None,
                    Sign::Positive => {}
                }
            }
            if count % 2 == 1 {
                if found.is_some() {
                    return None;
                }
                found = Some(i);
            }
        }
        found
    }
}
