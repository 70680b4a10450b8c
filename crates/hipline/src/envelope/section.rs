//! The roof above a cut: slabs restricted to an upright plane are segments in it, and the roof is their lower envelope
//! (section 3.3 of the thesis).

use super::{
    Envelope,
    profile::{Chart, Meet, Piece, lower_envelope},
    slabs::Slab,
};
use crate::predicates::{Cut, PlaneId, Track as Border};
use hipline_num::Sign;
use std::{cell::Cell, cmp::Ordering};

/// A place on a cut.
#[derive(Clone, Debug)]
pub(super) enum Spot {
    /// Before all others.
    First,
    /// Where a border crosses it.
    On(Border),
    /// After all others.
    Last,
}

/// A cut: the curves over it are the times of planes.
struct Above<'a, 'b> {
    envelope: &'a Envelope<'b>,
    cut: &'a Cut,
    /// Whether two planes were found to agree all along the cut.
    tied: Cell<bool>,
}

impl Chart for Above<'_, '_> {
    type Spot = Spot;

    fn order(&self, p: &Spot, q: &Spot) -> Ordering {
        match (p, q) {
            (Spot::On(p), Spot::On(q)) if p == q => Ordering::Equal,
            (Spot::On(p), Spot::On(q)) => self.envelope.planes.compare_on_cut(self.cut, p, q),
            (Spot::First, Spot::First) | (Spot::Last, Spot::Last) => Ordering::Equal,
            (Spot::First, _) | (_, Spot::Last) => Ordering::Less,
            (Spot::Last, _) | (_, Spot::First) => Ordering::Greater,
        }
    }

    fn meet(&self, a: u32, b: u32) -> Meet<Spot> {
        // Positive where a is later, so higher.
        let border = Border::Equal([a, b].map(PlaneId));
        let planes = &self.envelope.planes;
        match planes.slope_on_cut(self.cut, &border) {
            Sign::Zero => {
                let side = planes.side_of_cut(self.cut, &border);
                if side.is_zero() {
                    self.tied.set(true);
                }
                Meet::Never(-side)
            }
            slope => Meet::At(Spot::On(border), -slope),
        }
    }
}

impl Above<'_, '_> {
    /// The part of the cut below a slab.
    fn restrict(&self, slab: &Slab) -> Option<[Spot; 2]> {
        let planes = &self.envelope.planes;
        let source = match slab.beside {
            None => Border::Level(slab.plane, 0.0),
            Some(x) => Border::Equal([slab.plane, x]),
        };
        let [from, to] = slab.ends.map(|end| Border::Across(slab.plane, end.into()));
        let mut ends = [Spot::First, Spot::Last];
        let wanted = [
            (source, Sign::Positive),
            (from, Sign::Positive),
            (to, Sign::Negative),
        ];
        for (border, side) in wanted {
            match planes.slope_on_cut(self.cut, &border) * side {
                Sign::Zero => {
                    if (planes.side_of_cut(self.cut, &border) * side).is_negative() {
                        return None;
                    }
                    continue;
                }
                Sign::Positive => {
                    let spot = Spot::On(border);
                    if self.order(&spot, &ends[0]).is_gt() {
                        ends[0] = spot;
                    }
                }
                Sign::Negative => {
                    let spot = Spot::On(border);
                    if self.order(&spot, &ends[1]).is_lt() {
                        ends[1] = spot;
                    }
                }
            }
            if self.order(&ends[0], &ends[1]).is_ge() {
                return None;
            }
        }
        Some(ends)
    }
}

/// A plane on the roof above a cut, between bounds of where it is.
#[derive(Clone, Copy, Debug)]
pub(super) struct Visible {
    /// By class.
    pub plane: PlaneId,
    pub from: f64,
    pub to: f64,
}

impl Envelope<'_> {
    /// The roof of some faces above a cut; `None` if two of them agree all along it, so that each may
    /// be visible on one side only.
    ///
    /// # Complexity
    /// O(k α(k) log k) questions for k slabs.
    pub(super) fn section(&mut self, cut: &Cut, faces: &[u32]) -> Option<Vec<Visible>> {
        let mut count = self.count;
        let chart = Above {
            envelope: self,
            cut,
            tied: Cell::new(false),
        };
        let mut pieces = Vec::new();
        for &face in faces {
            for slab in &self.sources[face as usize].slabs {
                if let Some([from, to]) = chart.restrict(slab) {
                    let of = self.class(slab.plane).0;
                    pieces.push(Piece { from, to, of });
                }
            }
        }
        count.sections += pieces.len() as u64;
        let roof = lower_envelope(&chart, pieces, &mut count.merging);
        let tied = chart.tied.get();
        let bounds = |spot: &Spot| match spot {
            Spot::First => [f64::NEG_INFINITY; 2],
            Spot::On(border) => self.planes.bounds_on_cut(cut, border),
            Spot::Last => [f64::INFINITY; 2],
        };
        let visible = roof.iter().map(|piece| Visible {
            plane: PlaneId(piece.of),
            from: bounds(&piece.from)[0],
            to: bounds(&piece.to)[1],
        });
        let visible = visible.collect();
        self.count = count;
        (!tied).then_some(visible)
    }
}
