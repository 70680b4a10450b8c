//! The last cut, along the only valley of a cell: extended to the boundary of the cell it leaves a convex part on each side (section 4.1 of the thesis).

use super::{
    Envelope,
    boundary::{Cell, Kind, NONE},
    profile::Chart,
    section::{Above, Cut, Mark, Spot},
};
use crate::predicates::CellCorner;
use hipline_num::Sign;

impl Envelope<'_> {
    /// The slabs that are visible on the right and on the left of the only valley of a cell, if that is all there is: `None` if the cell has
    /// other valleys, or holes, or if it cannot be told.
    pub(super) fn beside_valley(&mut self, cell: &Cell) -> Option<[Vec<u32>; 2]> {
        let mut notches = (0..cell.edges.len()).filter(|&i| cell.edges[i].notch != NONE);
        let (notch, other) = (notches.next()?, notches.next());
        let passes = cell.edges.iter().any(|edge| edge.passes != NONE);
        let track = cell.edges[notch].notch;
        if other.is_some() || passes || cell.holes > 0 || self.child_of(track) != NONE {
            return None;
        }
        let [right, left] = self.slabs_of_track[track as usize];
        let start = &cell.edges[notch].to;
        let cut = self.along_track(start.frame, self.ends[track as usize], left)?;
        // From the notch along the right side, across the extended valley, and back along the left side.
        let mut sides = [vec![right], vec![left]];
        let mut at = cell.edges[notch].next as usize;
        let (mut far, mut stage) = (None, 0);
        loop {
            let edge = &cell.edges[at];
            sides[usize::from(stage > 1)].push(edge.slab);
            if at == notch {
                break;
            }
            let is_valley = |i: usize| {
                let edge = &cell.edges[i];
                edge.kind == Kind::Valley && [right, left].contains(&edge.slab)
            };
            let next = edge.next as usize;
            let side = if is_valley(at) || is_valley(next) {
                Sign::Zero
            } else {
                self.planes.side_of_line(&edge.to.what, &cut.line)
            };
            // On the valley, on its right, on its left, on the valley again.
            stage = match (stage, side) {
                (0 | 1, Sign::Negative) => 1,
                (1, Sign::Positive) => {
                    far = Some(at);
                    sides[1].push(edge.slab);
                    2
                }
                (2, Sign::Positive) => 2,
                (0, Sign::Zero) if is_valley(at) => 0,
                (2 | 3, Sign::Zero) if is_valley(next) || is_valley(at) => 3,
                _ => return None,
            };
            at = next;
        }
        let far = &cell.edges[far?].line;
        let end = self.node(CellCorner::Of(cut.line.clone(), far.clone()));
        let planes = [right, left].map(|slab| self.class(self.slab(slab).plane));
        let slabs = self.slabs_in(cell);
        // On the cut these planes agree.
        let (alike, others): (Vec<u32>, Vec<u32>) =
            (slabs.into_iter()).partition(|&s| planes.contains(&self.class(self.slab(s).plane)));
        let near = cut.along(start)[1];
        let chart = Above::new(self, &cut);
        for &slab in alike.iter().filter(|slab| ![right, left].contains(slab)) {
            if let Some([_, to]) = chart.restrict(slab)
                && to.bounds[1] >= near.min(cut.along(start)[0])
            {
                return None;
            }
        }
        let mut list = others;
        list.push(right);
        let roof = self.section(&cut, &list)?;
        let chart = Above::new(self, &cut);
        let is_before = |spot: &Spot| match spot.mark {
            Mark::First => true,
            Mark::Last => false,
            mark => {
                let line = self.line_of(mark);
                (spot.bounds[1] < cut.along(&end)[0])
                    || spot.bounds[0] <= cut.along(&end)[1]
                        && (self.planes).compare_on_cut(&cut.line, &line, far).is_lt()
            }
        };
        // The track is visible from the notch on.
        let first = roof.iter().position(|piece| piece.of == right)?;
        for (i, piece) in roof.iter().enumerate().skip(first) {
            if !is_before(&piece.from) {
                break;
            }
            if i > first && chart.order(&roof[i - 1].to, &piece.from).is_lt() {
                return None;
            }
            // The valley itself has one of its planes on either side.
            if piece.of != right {
                for side in &mut sides {
                    side.push(piece.of);
                }
            }
        }
        Some(sides)
    }

    /// The cut from a place near a track's start along it; `None` if it is too short to tell where it goes.
    fn along_track(&self, from: [[f64; 2]; 2], to: [f64; 2], left: u32) -> Option<Cut> {
        let width = |k: usize| (to[k] - from[k][0]).abs();
        let axis = usize::from(width(1) > width(0));
        let slack = width(axis) / 1024.0;
        let is_down = if to[axis] < from[axis][0] - slack {
            true
        } else if to[axis] > from[axis][1] + slack {
            false
        } else {
            return None;
        };
        Some(Cut {
            line: self.line_of(Mark::Source(left)),
            axis,
            is_down,
            toward: None,
            is_chord: false,
        })
    }
}
