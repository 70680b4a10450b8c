//! A surface of planar facets, each with its triangles.
//!
//! Facets are polygons with holes, as CityJSON has them; triangles are what everything else
//! wants. Both are over the same vertices. Lists are flat, so that a mesh of a small building is a
//! handful of allocations.

use super::half_edges::HalfEdges;
use crate::topology::EdgeId;

/// What a facet belongs to.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Surface {
    /// The roof; it looks upward.
    Roof,
    /// A wall or a gable; vertical.
    Wall,
    /// The floor; it looks downward.
    Ground,
    /// The underside of an overhang; it looks downward.
    Soffit,
}

/// A facet: a polygon of a [`Mesh`].
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Facet {
    /// What it belongs to.
    pub surface: Surface,
    /// The edge of the figure that it rises from; none of floors and soffits.
    pub edge: Option<EdgeId>,
    pub(super) rings: [u32; 2],
    pub(super) triangles: [u32; 2],
}

/// A surface of polygons, and the triangles that they are cut into.
#[derive(Debug, Clone, PartialEq)]
pub struct Mesh {
    pub(super) vertices: Vec<[f64; 3]>,
    pub(super) facets: Vec<Facet>,
    /// Ring k is `corners[ends[k]..ends[k + 1]]`.
    pub(super) ends: Vec<u32>,
    pub(super) corners: Vec<u32>,
    pub(super) triangles: Vec<[u32; 3]>,
}

impl Default for Mesh {
    fn default() -> Self {
        Self {
            vertices: Vec::new(),
            facets: Vec::new(),
            ends: vec![0],
            corners: Vec::new(),
            triangles: Vec::new(),
        }
    }
}

/// The directed edges of a ring.
pub(super) fn edges(ring: &[u32]) -> impl Iterator<Item = [u32; 2]> {
    let next = ring.iter().skip(1).chain(ring.first());
    ring.iter().zip(next).map(|(&a, &b)| [a, b])
}

impl Mesh {
    /// A mesh of triangles, for [`Mesh::check`]; each triangle is a facet of the roof.
    #[must_use]
    pub fn from_triangles(vertices: Vec<[f64; 3]>, triangles: &[[u32; 3]]) -> Self {
        let mut mesh = Self {
            vertices,
            ..Self::default()
        };
        for &triangle in triangles {
            mesh.push(Surface::Roof, None, [&triangle[..]], &[triangle]);
        }
        mesh
    }

    /// The vertices: x, y, and height, in input units.
    #[must_use]
    pub fn vertices(&self) -> &[[f64; 3]] {
        &self.vertices
    }

    /// The facets.
    #[must_use]
    pub fn facets(&self) -> &[Facet] {
        &self.facets
    }

    /// The boundaries of a facet, as numbers of vertices: the outer one first,
    /// counterclockwise as seen from outside of the solid, then those of holes, clockwise.
    pub fn rings(&self, facet: &Facet) -> impl Iterator<Item = &[u32]> + Clone {
        let [first, end] = facet.rings.map(|k| k as usize);
        let ends = self.ends[first..=end].windows(2);
        ends.map(|pair| &self.corners[pair[0] as usize..pair[1] as usize])
    }

    /// All triangles, facet by facet, counterclockwise as seen from outside of the solid.
    #[must_use]
    pub fn triangles(&self) -> &[[u32; 3]] {
        &self.triangles
    }

    /// The triangles of a facet: they cover it, without further vertices.
    #[must_use]
    pub fn triangles_of(&self, facet: &Facet) -> &[[u32; 3]] {
        let [first, end] = facet.triangles.map(|k| k as usize);
        &self.triangles[first..end]
    }

    /// Whether each directed edge of the facets has its reverse: nothing is missing, as the
    /// floor may be. For more, see [`Mesh::check`].
    #[must_use]
    pub fn is_closed(&self) -> bool {
        HalfEdges::new(self.cycles()).open().next().is_none()
    }

    /// The area of a facet in the plan, in square input units, up to rounding: positive if its
    /// boundary is counterclockwise from above. Holes are taken off.
    #[must_use]
    pub fn plan_area(&self, facet: &Facet) -> f64 {
        let [x0, y0, _] = self
            .rings(facet)
            .flatten()
            .next()
            .map_or([0.0; 3], |&v| self.vertices[v as usize]);
        let cross = |[a, b]: [u32; 2]| {
            let [p, q] = [a, b].map(|v| self.vertices[v as usize]);
            (p[0] - x0) * (q[1] - y0) - (q[0] - x0) * (p[1] - y0)
        };
        self.rings(facet).flat_map(edges).map(cross).sum::<f64>() / 2.0
    }

    /// Adds a facet with its triangles.
    pub(super) fn push<'a>(
        &mut self,
        surface: Surface,
        edge: Option<EdgeId>,
        rings: impl IntoIterator<Item = &'a [u32]>,
        triangles: &[[u32; 3]],
    ) {
        let first = [self.ends.len() as u32 - 1, self.triangles.len() as u32];
        for ring in rings {
            self.corners.extend_from_slice(ring);
            self.ends.push(self.corners.len() as u32);
        }
        self.triangles.extend_from_slice(triangles);
        self.facets.push(Facet {
            surface,
            edge,
            rings: [first[0], self.ends.len() as u32 - 1],
            triangles: [first[1], self.triangles.len() as u32],
        });
    }

    /// Adds a vertex and returns its number.
    pub(super) fn vertex(&mut self, vertex: [f64; 3]) -> u32 {
        self.vertices.push(vertex);
        self.vertices.len() as u32 - 1
    }
}
