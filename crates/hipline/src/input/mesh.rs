//! A constrained triangulation of a figure's vertices, as plain arrays.

use crate::skeleton::Region;

/// A triangulation of the convex hull of a figure's vertices that contains every edge of
/// the figure.
///
/// Each hull edge is also listed, from the outside, in [`Mesh::hull`]; with all vertices
/// on one line there are no triangles and the hull goes along the line and back.
#[derive(Debug, Clone, Default)]
pub(crate) struct Mesh {
    /// Corners of each triangle, counterclockwise, as vertex indices.
    pub corners: Vec<[u32; 3]>,
    /// For each triangle, what lies across the edge opposite each corner.
    pub across: Vec<[MeshEdge; 3]>,
    /// For each triangle: whether it lies inside the figure's polygons (even-odd).
    pub inside: Vec<bool>,
    /// The directed hull edges `u -> v` with the OUTSIDE on their left, in order around
    /// the hull (each one starts where the one before ends; clockwise around the figure).
    pub hull: Vec<HullEdge>,
}

impl Mesh {
    /// Whether a triangle belongs to a part of the plane.
    pub(crate) fn is_in(&self, triangle: usize, region: Region) -> bool {
        match region {
            Region::Interior => self.inside[triangle],
            Region::Exterior => !self.inside[triangle],
            Region::Auto | Region::Both => true,
        }
    }
}

/// One edge of the hull, seen from the outside.
#[derive(Debug, Clone, Copy)]
pub(crate) struct HullEdge {
    /// Where it starts.
    pub from: u32,
    /// Where it ends; the outside is on the left of `from -> to`.
    pub to: u32,
    /// What lies across it (the inner triangle, or the other side of a lone line), and
    /// whether it is an edge of the figure.
    pub across: MeshEdge,
}

/// What lies across one edge of a triangle (or hull edge).
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct MeshEdge {
    /// The figure's edge that runs here, if it is one.
    pub edge: Option<u32>,
    /// The neighbour: a triangle index, or a hull edge index plus `HULL`.
    pub neighbour: u32,
}

impl MeshEdge {
    /// Added to the index of a hull edge in `neighbour`.
    pub const HULL: u32 = 1 << 31;
}
