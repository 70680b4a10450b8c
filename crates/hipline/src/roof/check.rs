//! Is a mesh the boundary of a solid? Independent of how it was built.

use super::{
    contact,
    half_edges::HalfEdges,
    mesh::{Mesh, edges},
    plane::orientation,
};
use crate::topology::Sets;
use dashu_int::IBig;
use hipline_num::{common_unit, in_units};

/// One reason why a mesh is not the boundary of a solid. Triangles are numbers in
/// [`Mesh::triangles`], vertices in [`Mesh::vertices`], facets in [`Mesh::facets`].
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum MeshFlaw {
    /// No triangle at all.
    #[error("there is no triangle")]
    Empty,
    /// A coordinate is NaN or infinite.
    #[error("vertex {vertex} is not finite")]
    NotFinite {
        /// The vertex.
        vertex: u32,
    },
    /// A corner that is no vertex of the mesh.
    #[error("triangle {triangle} has corner {vertex}, but there is no such vertex")]
    NoVertex {
        /// The triangle.
        triangle: usize,
        /// The corner.
        vertex: u32,
    },
    /// All corners of a triangle are on one line.
    #[error("triangle {triangle} has no area")]
    NoArea {
        /// The triangle.
        triangle: usize,
    },
    /// Two triangles run along an edge in one direction: they are oriented differently, or
    /// more than two meet.
    #[error("triangles {} and {} both run from vertex {} to vertex {}", .triangles[0], .triangles[1], .edge[0], .edge[1])]
    SameDirection {
        /// The triangles.
        triangles: [usize; 2],
        /// The edge.
        edge: [u32; 2],
    },
    /// No triangle on the other side of an edge.
    #[error("the edge from vertex {} to vertex {} of triangle {triangle} has nothing beyond it", .edge[0], .edge[1])]
    Open {
        /// The triangle on this side.
        triangle: usize,
        /// The edge.
        edge: [u32; 2],
    },
    /// The triangles around a vertex are several fans: parts of the surface touch there.
    #[error("{fans} fans of triangles meet in vertex {vertex}")]
    Fans {
        /// The vertex.
        vertex: u32,
        /// How many fans.
        fans: usize,
    },
    /// The boundary of a facet is not that of its triangles.
    #[error("facet {facet} and its triangles have different boundaries, at the edge from vertex {} to vertex {}", .edge[0], .edge[1])]
    FacetBoundary {
        /// The facet.
        facet: usize,
        /// An edge that one of them has.
        edge: [u32; 2],
    },
    /// Two triangles have more in common than a corner or an edge.
    #[error("triangles {} and {} intersect", .triangles[0], .triangles[1])]
    Intersection {
        /// The triangles.
        triangles: [usize; 2],
    },
    /// A connected part of the surface looks inward: its volume is not above 0.
    #[error("the surface with triangle {triangle} looks inward")]
    Inward {
        /// A triangle of that part.
        triangle: usize,
    },
}

impl Mesh {
    /// Checks that the mesh is the boundary of a solid:
    ///
    /// * closed and consistently oriented: each directed edge is there once, and so is its
    ///   reverse, among the triangles and among the boundaries of facets;
    /// * a manifold: the triangles around each vertex are one fan;
    /// * without triangles that have no area;
    /// * without self-intersection: two triangles have nothing in common but a corner or
    ///   an edge;
    /// * looking outward: each connected part has a positive volume.
    ///
    /// All decisions are exact, for the coordinates as they are. Where a footprint touches
    /// itself in a point, so does the solid, along a vertical line; it is a manifold nevertheless,
    /// with several vertices and edges in one place. So *touching* in a common corner or along a
    /// common edge is no flaw, be it one in number or in coordinates only.
    ///
    /// # Complexity
    /// O(n log n) and, for intersections, O(n m) where m triangles, as usual not many, overlap in
    /// one coordinate.
    ///
    /// # Errors
    /// The first flaw found, in the order of [`MeshFlaw`].
    pub fn check(&self) -> Result<(), MeshFlaw> {
        self.check_numbers()?;
        let all = self.triangles.iter().enumerate();
        let table = HalfEdges::new(all.map(|(t, triangle)| (t as u32, &triangle[..])));
        if let Some((edge, triangles)) = table.conflict() {
            return Err(MeshFlaw::SameDirection { triangles, edge });
        }
        if let Some((edge, triangle)) = table.open().next() {
            return Err(MeshFlaw::Open { triangle, edge });
        }
        self.check_fans(&table)?;
        self.check_facets()?;
        if let Some(triangles) = contact::first(&self.vertices, &self.triangles) {
            return Err(MeshFlaw::Intersection { triangles });
        }
        self.check_volumes(&table)
    }

    fn check_numbers(&self) -> Result<(), MeshFlaw> {
        if self.triangles.is_empty() {
            return Err(MeshFlaw::Empty);
        }
        let is_finite = |p: &[f64; 3]| p.iter().all(|c| c.is_finite());
        if let Some(vertex) = self.vertices.iter().position(|p| !is_finite(p)) {
            let vertex = vertex as u32;
            return Err(MeshFlaw::NotFinite { vertex });
        }
        for (triangle, corners) in self.triangles.iter().enumerate() {
            if let Some(&vertex) = corners.iter().find(|&&v| v as usize >= self.vertices.len()) {
                return Err(MeshFlaw::NoVertex { triangle, vertex });
            }
            let [a, b, c] = corners.map(|v| self.vertices[v as usize]);
            let is_flat =
                |[i, j]: [usize; 2]| orientation([a[i], a[j]], [b[i], b[j]], [c[i], c[j]]) == 0.0;
            if [[0, 1], [1, 2], [2, 0]].into_iter().all(is_flat) {
                return Err(MeshFlaw::NoArea { triangle });
            }
        }
        Ok(())
    }

    fn check_fans(&self, table: &HalfEdges) -> Result<(), MeshFlaw> {
        let mut sets = table.fans(&self.triangles);
        let mut fans = vec![0_usize; self.vertices.len()];
        for i in 0..3 * self.triangles.len() {
            if sets.root(i) == i {
                fans[self.triangles[i / 3][i % 3] as usize] += 1;
            }
        }
        match fans.iter().position(|&fans| fans > 1) {
            Some(v) => Err(MeshFlaw::Fans {
                vertex: v as u32,
                fans: fans[v],
            }),
            None => Ok(()),
        }
    }

    fn check_facets(&self) -> Result<(), MeshFlaw> {
        for (number, facet) in self.facets.iter().enumerate() {
            let mut list: Vec<([u32; 2], i32)> = Vec::new();
            let mut count = |[a, b]: [u32; 2], by: i32| {
                list.push(if a < b { ([a, b], by) } else { ([b, a], -by) });
            };
            let triangles = self.triangles_of(facet);
            triangles
                .iter()
                .flat_map(|t| edges(t))
                .for_each(|e| count(e, 1));
            self.rings(facet).flat_map(edges).for_each(|e| count(e, -1));
            list.sort_unstable();
            for same in list.chunk_by(|a, b| a.0 == b.0) {
                if same.iter().map(|(_, by)| by).sum::<i32>() != 0 {
                    return Err(MeshFlaw::FacetBoundary {
                        facet: number,
                        edge: same[0].0,
                    });
                }
            }
        }
        Ok(())
    }

    fn check_volumes(&self, table: &HalfEdges) -> Result<(), MeshFlaw> {
        let mut sets = Sets::new(self.triangles.len());
        for [a, b] in table.neighbours() {
            sets.join(a, b);
        }
        let mut members: Vec<(usize, usize)> = (0..self.triangles.len())
            .map(|t| (sets.root(t), t))
            .collect();
        members.sort_unstable();
        for part in members.chunk_by(|a, b| a.0 == b.0) {
            if !self.has_positive_volume(part.iter().map(|&(_, t)| t)) {
                return Err(MeshFlaw::Inward {
                    triangle: part[0].0,
                });
            }
        }
        Ok(())
    }

    /// The volume under the triangles: a sum of determinants, by integers.
    fn has_positive_volume(&self, triangles: impl Iterator<Item = usize> + Clone) -> bool {
        let corners = || triangles.clone().flat_map(|t| self.triangles[t]);
        let (unit, _) = common_unit(corners().flat_map(|v| self.vertices[v as usize]));
        let whole = |v: u32| self.vertices[v as usize].map(|x| in_units(x, unit));
        let Some(origin) = corners().next().map(whole) else {
            return false;
        };
        let mut volume = IBig::ZERO;
        for t in triangles {
            let [p, q, r] = self.triangles[t].map(|v| {
                let [x, y, z] = whole(v);
                [x - &origin[0], y - &origin[1], z - &origin[2]]
            });
            let minor = |i: usize, j: usize| &q[i] * &r[j] - &q[j] * &r[i];
            volume += &p[0] * minor(1, 2) + &p[1] * minor(2, 0) + &p[2] * minor(0, 1);
        }
        volume > IBig::ZERO
    }
}
