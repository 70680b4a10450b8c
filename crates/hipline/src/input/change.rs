//! Speeds that change: from a given time on, a side of an edge moves at another speed.
//!
//! Changes are given apart from the edges, because few inputs have any. A speed of zero
//! until some time is an additive weight: the edge starts late.

use std::collections::BTreeMap;

use super::{Edge, Flaw, Place, builder::Part};
use crate::topology::EdgeId;

/// Which sides of an edge are meant.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Default)]
pub enum Sides {
    /// The left one, seen along the edge as given.
    Left,
    /// The right one.
    Right,
    /// Both.
    #[default]
    Both,
}

/// From a time on, an edge moves at another speed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Change {
    /// The edge, in the caller's numbering.
    pub edge: Place,
    /// On which of its sides.
    pub sides: Sides,
    /// From when on: a positive time.
    pub time: f64,
    /// The speed from then on: zero or more.
    pub speed: f64,
}

/// One change of one side of an edge of a figure.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SpeedChange {
    /// The edge.
    pub edge: EdgeId,
    /// Whether its right side is meant, not its left one.
    pub right: bool,
    /// From when on.
    pub time: f64,
    /// The speed from then on, another one than before.
    pub speed: f64,
}

/// The changes of all edges as the caller gave them, by edge and side, in the order of time.
#[derive(Debug, Default)]
pub(super) struct Changes(BTreeMap<(Place, bool), Vec<[f64; 2]>>);

impl Changes {
    /// Checks and sorts the changes.
    pub(super) fn new(list: &[Change], parts: &[Part], flaws: &mut Vec<Flaw>) -> Self {
        let mut changes = Self::default();
        for change in list {
            let Change {
                edge,
                sides,
                time,
                speed,
            } = *change;
            let time = time + 0.0;
            let speed = speed + 0.0;
            if !is_edge(parts, edge) {
                flaws.push(Flaw::NoSuchEdge { edge });
            } else if !(time.is_finite() && time > 0.0) {
                flaws.push(Flaw::BadTime { edge, time });
            } else if !(speed.is_finite() && speed >= 0.0) {
                flaws.push(Flaw::BadSpeed { edge, speed });
            } else {
                for right in [false, true] {
                    if sides == (if right { Sides::Left } else { Sides::Right }) {
                        continue;
                    }
                    changes
                        .0
                        .entry((edge, right))
                        .or_default()
                        .push([time, speed]);
                }
            }
        }
        for (&(edge, _), list) in &mut changes.0 {
            list.sort_by(|a, b| a[0].total_cmp(&b[0]));
            for pair in list.windows(2) {
                if pair[0][0].to_bits() == pair[1][0].to_bits() {
                    let flaw = Flaw::TwoChanges {
                        edge,
                        time: pair[0][0],
                    };
                    if flaws.last() != Some(&flaw) {
                        flaws.push(flaw);
                    }
                }
            }
        }
        changes
    }

    /// Whether there is none.
    pub(super) fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// The changes of one side of an edge: pairs of time and speed.
    pub(super) fn of(&self, edge: Place, right: bool) -> &[[f64; 2]] {
        self.0.get(&(edge, right)).map_or(&[], Vec::as_slice)
    }

    /// The changes of the edges of a figure that really are changes.
    pub(super) fn of_edges(&self, edges: &[Edge]) -> Vec<SpeedChange> {
        let mut list = Vec::new();
        if self.is_empty() {
            return list;
        }
        for (e, edge) in edges.iter().enumerate() {
            let place = edge.source.place();
            for (right, mut before) in [false, true].into_iter().zip(edge.speeds) {
                for &[time, speed] in self.of(place, right) {
                    if speed.to_bits() != before.to_bits() {
                        list.push(SpeedChange {
                            edge: EdgeId::new(e),
                            right,
                            time,
                            speed,
                        });
                    }
                    before = speed;
                }
            }
        }
        list
    }
}

/// Whether the caller gave an edge of this name.
fn is_edge(parts: &[Part], place: Place) -> bool {
    let counts = parts.get(place.part).map(|part| part.counts(place.ring));
    counts.is_some_and(|[_, edges]| place.index < edges)
}
