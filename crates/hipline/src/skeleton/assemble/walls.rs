//! Ghost arcs that meet walls without thickness, edges that stand still; and rays.

use super::Assembly;
use crate::{
    predicates::PlaneId,
    topology::TraceId,
    wavefront::{End, Walk},
};

impl Assembly<'_> {
    /// Whether a walk that comes after the last one of a base, or of a vertex that moves for ever, comes from infinity.
    pub(super) fn is_far(&self, walk: Walk) -> bool {
        match walk {
            Walk::Up(_) | Walk::Open => false,
            Walk::Down(x) => self.front.trace(x).end == End::Moving,
            // The ray at the start of a chain.
            Walk::Base(_) => true,
        }
    }

    /// The nodes at the lower ends of walls without thickness that stand in the way of ghost arcs,
    /// perpendicular to the edge, each with the walk that comes down to it.
    pub(super) fn spikes(&self, cycles: &[Vec<Walk>], plane: PlaneId) -> Vec<(u32, Walk)> {
        if !self.planes.has_upright() {
            return Vec::new();
        }
        let goes_straight = |x: TraceId| {
            let trace = self.front.trace(x);
            match trace.end {
                End::At(end) => self
                    .planes
                    .compare_along(
                        &self.finite_place(trace.born),
                        &self.finite_place(end),
                        plane,
                    )
                    .is_eq(),
                End::Moving => self.planes.drift(trace.pair, plane).is_zero(),
                End::Ghost => false,
            }
        };
        let mut list = Vec::new();
        for cycle in cycles {
            for (i, &walk) in cycle.iter().enumerate() {
                let after = cycle[(i + 1) % cycle.len()];
                if let (Walk::Down(x), Walk::Up(y)) = (walk, after)
                    && goes_straight(x)
                    && goes_straight(y)
                {
                    list.push((self.front.trace(x).born, walk));
                }
            }
        }
        list
    }
}
