//! Is a mesh a closed surface? Independent of how it was built.

use super::Mesh;
use std::collections::BTreeMap;

/// One reason why a mesh is not a closed surface. Faces are numbers in [`Mesh::faces`],
/// ends of edges numbers in [`Mesh::vertices`].
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum MeshFlaw {
    /// A boundary with fewer than three corners, or one that goes nowhere for an edge.
    #[error("face {face} has a boundary with fewer than three corners")]
    FewCorners {
        /// The face.
        face: usize,
    },
    /// A corner that is no vertex of the mesh.
    #[error("face {face} has corner {vertex}, but there is no such vertex")]
    NoVertex {
        /// The face.
        face: usize,
        /// The corner.
        vertex: u32,
    },
    /// Two faces, or one face twice, run along an edge in one direction.
    #[error("faces {first} and {second} both run from vertex {from} to vertex {to}")]
    SameDirection {
        /// A face.
        first: usize,
        /// The other one.
        second: usize,
        /// Where the edge starts.
        from: u32,
        /// Where the edge ends.
        to: u32,
    },
    /// No face on the other side of an edge.
    #[error("the edge from vertex {from} to vertex {to} of face {face} has nothing beyond it")]
    Open {
        /// The face on this side.
        face: usize,
        /// Where the edge starts.
        from: u32,
        /// Where the edge ends.
        to: u32,
    },
    /// All corners of a face in one point.
    #[error("face {face} is a point")]
    Point {
        /// The face.
        face: usize,
    },
}

impl Mesh {
    /// Checks that the mesh is closed and consistently oriented: every directed edge is there
    /// once, and so is its reverse; no face is degenerate.
    ///
    /// A roof is closed only [with its base](Self::with_base).
    ///
    /// # Complexity
    /// O(n log n).
    ///
    /// # Errors
    /// The first flaw found.
    pub fn check(&self) -> Result<(), MeshFlaw> {
        let mut faces: BTreeMap<[u32; 2], usize> = BTreeMap::new();
        for (i, face) in self.faces.iter().enumerate() {
            if face.cycles().any(|cycle| cycle.len() < 3) || face.edges().any(|[a, b]| a == b) {
                return Err(MeshFlaw::FewCorners { face: i });
            }
            for [from, to] in face.edges() {
                if from as usize >= self.vertices.len() {
                    return Err(MeshFlaw::NoVertex {
                        face: i,
                        vertex: from,
                    });
                }
                if let Some(first) = faces.insert([from, to], i) {
                    return Err(MeshFlaw::SameDirection {
                        first,
                        second: i,
                        from,
                        to,
                    });
                }
            }
            let bits = |v: u32| self.vertices[v as usize].map(f64::to_bits);
            let first = bits(face.boundary[0]);
            if face.boundary.iter().all(|&v| bits(v) == first) {
                return Err(MeshFlaw::Point { face: i });
            }
        }
        for (&[from, to], &face) in &faces {
            if !faces.contains_key(&[to, from]) {
                return Err(MeshFlaw::Open { face, from, to });
            }
        }
        Ok(())
    }
}
