//! The hip roof over the bounded part of a skeleton: height is time times slope
//! (Aichholzer & Aurenhammer 1996, section 4).
//!
//! Each face of the skeleton is a roof facet over its input edge, in one plane up to the
//! rounding of its corners. Facets share vertices by number, and the surface is closed along
//! every arc by construction: no coordinate is read to connect anything.

mod check;
mod ears;
mod floor;
mod triangulate;

pub use check::MeshFlaw;

use crate::{
    skeleton::{NodeKind, Skeleton},
    topology::FaceId,
};

/// Why there is no roof.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum InvalidRoof {
    /// The slope is not a number above zero.
    #[error("a roof's slope must be finite and above 0, unlike {0}")]
    Slope(f64),
    /// No part of the skeleton is bounded.
    #[error("a roof needs a bounded part of the plane, as the inside of a polygon")]
    Unbounded,
}

/// A face of a [`Mesh`]; its corners are numbers of vertices.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct MeshFace {
    /// The corners, counterclockwise as seen from outside the solid: for roof facets from
    /// above, for floors from below.
    pub boundary: Vec<u32>,
    /// Inner boundaries, in the opposite sense. Roof facets have none without weights.
    pub holes: Vec<Vec<u32>>,
    /// The face of the skeleton; `None` for floors.
    pub face: Option<FaceId>,
}

/// A surface of polygons.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Mesh {
    /// The vertices: x, y, and height, all in input units.
    pub vertices: Vec<[f64; 3]>,
    /// The faces.
    pub faces: Vec<MeshFace>,
}

impl MeshFace {
    /// All boundaries, the outer one first.
    pub fn cycles(&self) -> impl Iterator<Item = &[u32]> {
        std::iter::once(self.boundary.as_slice()).chain(self.holes.iter().map(Vec::as_slice))
    }

    /// The directed edges along all boundaries.
    pub fn edges(&self) -> impl Iterator<Item = [u32; 2]> {
        self.cycles().flat_map(|cycle| {
            let next = cycle.iter().skip(1).chain(cycle.first());
            cycle.iter().zip(next).map(|(&a, &b)| [a, b])
        })
    }
}

impl Mesh {
    /// The area of a face in the plan, in square input units, up to rounding: positive if its
    /// boundary is counterclockwise from above. Holes are taken off.
    #[must_use]
    pub fn plan_area(&self, face: &MeshFace) -> f64 {
        let Some(&origin) = face.boundary.first() else {
            return 0.0;
        };
        let [x0, y0, _] = self.vertices[origin as usize];
        let cross = |[a, b]: [u32; 2]| {
            let [p, q] = [a, b].map(|v| self.vertices[v as usize]);
            (p[0] - x0) * (q[1] - y0) - (q[0] - x0) * (p[1] - y0)
        };
        face.edges().map(cross).sum::<f64>() / 2.0
    }
}

/// For each face, whether its connected part of the plane is bounded.
fn bounded_faces(skeleton: &Skeleton) -> Vec<bool> {
    fn root(parents: &mut [usize], mut i: usize) -> usize {
        while parents[i] != i {
            parents[i] = parents[parents[i]];
            i = parents[i];
        }
        i
    }
    let count = skeleton.faces().len();
    let mut parents: Vec<usize> = (0..count).collect();
    for arc in skeleton.arcs() {
        let [a, b] = arc.faces.map(|face| root(&mut parents, face.index()));
        parents[a.max(b)] = a.min(b);
    }
    let mut bounded = vec![true; count];
    for arc in skeleton.arcs() {
        if matches!(skeleton.node(arc.nodes[1]).kind, NodeKind::Infinite { .. }) {
            bounded[root(&mut parents, arc.faces[0].index())] = false;
        }
    }
    (0..count)
        .map(|face| bounded[root(&mut parents, face)])
        .collect()
}

impl Skeleton {
    /// The hip roof over every bounded part of the plane that the skeleton covers: the inside
    /// of the polygons, and whatever else lines enclose. Unbounded parts are left out.
    ///
    /// A point that the wavefront reaches at time t is `slope * t` high; a slope of 1 is a
    /// pitch of 45 degrees for edges of unit speed.
    ///
    /// ```
    /// use hipline::Polygon;
    ///
    /// let square = vec![[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0]];
    /// let roof = Polygon::new([square])?.skeleton().roof(0.5)?;
    /// assert_eq!(roof.faces.len(), 4);
    /// assert!(roof.vertices.contains(&[2.0, 2.0, 1.0]));
    /// roof.with_base().check()?;
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Complexity
    /// Linear.
    ///
    /// # Errors
    /// If the slope is not finite and above zero, or nothing is bounded.
    pub fn roof(&self, slope: f64) -> Result<Mesh, InvalidRoof> {
        if !(slope.is_finite() && slope > 0.0) {
            return Err(InvalidRoof::Slope(slope));
        }
        let bounded = bounded_faces(self);
        let mut mesh = Mesh {
            vertices: Vec::with_capacity(self.nodes().len()),
            faces: Vec::with_capacity(self.faces().len()),
        };
        let mut number = vec![None; self.nodes().len()];
        for face in (0..self.faces().len())
            .map(FaceId::new)
            .filter(|face| bounded[face.index()])
        {
            // With weights, a face that was overrun at once has no area and two nodes.
            if self.boundary(face).len() < 3 {
                continue;
            }
            let mut name = |cycle: &[crate::topology::NodeId]| -> Vec<u32> {
                let corner = |&node: &crate::topology::NodeId| {
                    *number[node.index()].get_or_insert_with(|| {
                        let node = self.node(node);
                        mesh.vertices.push([node.x, node.y, node.time * slope]);
                        mesh.vertices.len() as u32 - 1
                    })
                };
                cycle.iter().map(corner).collect()
            };
            let boundary = name(self.boundary(face));
            let holes = self.holes(face).map(name).collect();
            mesh.faces.push(MeshFace {
                boundary,
                holes,
                face: Some(face),
            });
        }
        if mesh.faces.is_empty() {
            Err(InvalidRoof::Unbounded)
        } else {
            Ok(mesh)
        }
    }
}
