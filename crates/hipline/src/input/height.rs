//! Heights of vertices: where the wavefront starts later than at time zero.

use std::collections::BTreeMap;

use dashu_int::{IBig, ops::UnsignedAbs};
use hipline_num::{common_unit, in_units};

use super::{Edge, Flaw, Place, SpeedChange, builder::Part};
use crate::topology::VertexId;

/// The heights that the caller gave.
#[derive(Debug, Default)]
pub(super) struct Heights {
    given: BTreeMap<Place, f64>,
    /// By vertex, with the place that gave it first; as long as needed.
    by_vertex: Vec<Option<(Place, f64)>>,
}

impl Heights {
    /// Checks the heights by themselves.
    pub(super) fn new(list: &[(Place, f64)], parts: &[Part], flaws: &mut Vec<Flaw>) -> Self {
        let mut heights = Self::default();
        for &(at, height) in list {
            let height = height + 0.0;
            if !is_vertex(parts, at) {
                flaws.push(Flaw::NoSuchVertex { at });
            } else if !(height.is_finite() && height >= 0.0) {
                flaws.push(Flaw::BadHeight { at, height });
            } else if let Some(first) = heights.given.insert(at, height)
                && first.to_bits() != height.to_bits()
            {
                flaws.push(Flaw::TwoHeights {
                    first: at,
                    second: at,
                    heights: [first, height],
                });
            }
        }
        heights
    }

    /// A vertex was found to be at a place of the caller's.
    pub(super) fn found(&mut self, at: Place, vertex: usize) -> Option<Flaw> {
        let &height = self.given.get(&at)?;
        if self.by_vertex.len() <= vertex {
            self.by_vertex.resize(vertex + 1, None);
        }
        let (first, before) = *self.by_vertex[vertex].get_or_insert((at, height));
        (before.to_bits() != height.to_bits()).then_some(Flaw::TwoHeights {
            first,
            second: at,
            heights: [before, height],
        })
    }

    /// The height of each vertex, or nothing if all are zero.
    pub(super) fn finish(self, vertices: usize) -> Vec<f64> {
        let high = |entry: &Option<(Place, f64)>| entry.is_some_and(|(_, height)| height > 0.0);
        if !self.by_vertex.iter().any(high) {
            return Vec::new();
        }
        let mut list: Vec<f64> = self
            .by_vertex
            .into_iter()
            .map(|entry| entry.map_or(0.0, |(_, height)| height))
            .collect();
        list.resize(vertices, 0.0);
        list
    }
}

/// Whether the caller gave a vertex of this name.
fn is_vertex(parts: &[Part], at: Place) -> bool {
    let count = match parts.get(at.part) {
        None => 0,
        Some(Part::Polygon { rings, .. }) => rings
            .get(at.ring)
            .map_or(0, |ring| super::gather::without_closing_point(ring).len()),
        Some(_) if at.ring != 0 => 0,
        Some(Part::Line { points, .. }) => points.len(),
        Some(Part::Graph { vertices, .. }) => vertices.len(),
    };
    at.index < count
}

/// Checks the edges whose ends have heights: their facets must be steeper than they, and
/// may change their speeds only after the start, if at all.
pub(super) fn check(
    vertices: &[[f64; 2]],
    edges: &[Edge],
    heights: &[f64],
    changes: &[SpeedChange],
    flaws: &mut Vec<Flaw>,
) {
    if heights.is_empty() {
        return;
    }
    let height = |v: VertexId| heights[v.index()];
    for edge in edges {
        let ends = [height(edge.from), height(edge.to)];
        let places = [edge.from, edge.to].map(|v| vertices[v.index()]);
        let fastest = edge.speeds[0].max(edge.speeds[1]);
        if is_too_steep(places, ends, fastest) {
            flaws.push(Flaw::TooSteep {
                edge: edge.source.place(),
                heights: ends,
                speed: fastest,
            });
        }
    }
    for change in changes {
        let edge = &edges[change.edge.index()];
        let ends = [height(edge.from), height(edge.to)];
        let is_level = ends[0].to_bits() == ends[1].to_bits();
        if !is_level || change.time <= ends[0] {
            flaws.push(Flaw::ChangeBeforeStart {
                edge: edge.source.place(),
                time: change.time,
                heights: ends,
            });
        }
    }
}

/// Numbers as integers over a common power of two, and its exponent.
fn integers<const N: usize>(numbers: [f64; N]) -> ([IBig; N], i32) {
    let (unit, _) = common_unit(numbers);
    (numbers.map(|x| in_units(x, unit)), unit)
}

/// Whether an edge rises as steeply as a facet of its speed would, or more.
fn is_too_steep([p, q]: [[f64; 2]; 2], heights: [f64; 2], speed: f64) -> bool {
    let ([h, k], height_unit) = integers(heights);
    let ([w], speed_unit) = integers([speed]);
    let rise = w * (k - h);
    if rise == IBig::ZERO {
        return false;
    }
    let ([px, py, qx, qy], unit) = integers([p[0], p[1], q[0], q[1]]);
    let (dx, dy) = (qx - px, qy - py);
    let square = &dx * &dx + &dy * &dy;
    let steep = (&rise * &rise).unsigned_abs();
    let shift = 2 * (height_unit + speed_unit - unit);
    let [left, right] = [steep, square.unsigned_abs()];
    let power = |digits: i32| digits.max(0) as usize;
    (left << power(shift)) >= (right << power(-shift))
}
