//! A ring as two chains.

use super::chains::{Side, Start};
use crate::{input::Monotone, predicates::PlaneId};

/// A monotone polygon as its lower and its upper chain. Edges along the levels at its western and at its eastern
/// end go with the chain that comes after them and before them, counterclockwise: where a chain
/// ends, it turns by less than 180 degrees into the other one, even if several edges lie on one
/// line there. Their planes are those on the inner sides.
pub(super) fn split(monotone: &Monotone, n: usize) -> [Start; 2] {
    let (west, east) = (monotone.west[1].index(), monotone.east[1].index());
    [(Side::Lower, west, east), (Side::Upper, east, west)].map(|(side, from, to)| {
        // Counterclockwise.
        let at = |i: usize| {
            if monotone.counterclockwise {
                (from + i) % n
            } else {
                (from + n - i) % n
            }
        };
        let plane = |i: usize| {
            if monotone.counterclockwise {
                PlaneId(2 * at(i) as u32)
            } else {
                // From a vertex back along the edge before it.
                PlaneId(2 * ((at(i) + n - 1) % n) as u32 + 1)
            }
        };
        let count = if monotone.counterclockwise {
            (to + n - from) % n
        } else {
            (from + n - to) % n
        };
        Start {
            side,
            planes: (0..count).map(plane).collect(),
            vertices: (1..count).map(|i| at(i) as u32).collect(),
            ends: [Some(from as u32), Some(to as u32)],
        }
    })
}
