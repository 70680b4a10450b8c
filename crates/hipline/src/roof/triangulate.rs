//! Faces into triangles, without new vertices.

use super::{Mesh, MeshFace, ears};
use spade::{ConstrainedDelaunayTriangulation, Point2, Triangulation, handles::FixedVertexHandle};
use std::collections::BTreeMap;

/// Small faces without holes are cut ear by ear, larger ones by a Delaunay triangulation.
const SMALL: usize = 24;

impl Mesh {
    /// The same surface as triangles, over the same vertices: closed wherever this mesh is,
    /// each triangle oriented as its face.
    ///
    /// Triangles are made in the plan. They cover their face, and none is folded over, unless
    /// rounding has made the face's boundary cross itself in the plan.
    ///
    /// # Complexity
    /// O(n log n); quadratic in the number of corners of a face whose rounded boundary crosses
    /// itself.
    #[must_use]
    pub fn triangulate(&self) -> Self {
        let mut faces = Vec::with_capacity(2 * self.faces.len());
        for face in &self.faces {
            let triangles = self.triangles(face);
            faces.extend(triangles.into_iter().map(|triangle| MeshFace {
                boundary: triangle.to_vec(),
                holes: Vec::new(),
                face: face.face,
            }));
        }
        Self {
            vertices: self.vertices.clone(),
            faces,
        }
    }

    fn triangles(&self, face: &MeshFace) -> Vec<[u32; 3]> {
        // What looks downward is seen in a mirror.
        let down = face.face.is_none();
        let point = |v: u32| {
            let [x, y, _] = self.vertices[v as usize];
            if down { [y, x] } else { [x, y] }
        };
        let large = face.boundary.len() > SMALL || !face.holes.is_empty();
        if large && let Some(triangles) = delaunay(face, &point) {
            return triangles;
        }
        ears::cut(&joined(face, &point), &point)
    }
}

/// The constrained Delaunay triangulation of a face, unless rounding has spoilt the boundary.
fn delaunay(face: &MeshFace, point: &impl Fn(u32) -> [f64; 2]) -> Option<Vec<[u32; 3]>> {
    let mut triangulation = ConstrainedDelaunayTriangulation::<Point2<f64>>::new();
    let mut handles: BTreeMap<u32, FixedVertexHandle> = BTreeMap::new();
    let mut names: Vec<u32> = Vec::new();
    for &v in face.cycles().flatten() {
        if handles.contains_key(&v) {
            continue;
        }
        let [x, y] = point(v);
        let handle = triangulation.insert(Point2::new(x, y)).ok()?;
        if handle.index() != names.len() {
            return None; // two corners rounded into one point
        }
        names.push(v);
        handles.insert(v, handle);
    }
    for [a, b] in face.edges() {
        let [a, b] = [handles[&a], handles[&b]];
        if !triangulation.can_add_constraint(a, b) {
            return None;
        }
        triangulation.add_constraint(a, b);
    }
    // Everything that is reached from the left of the boundary without crossing it.
    let mut inside = vec![false; triangulation.num_all_faces()];
    let mut stack = Vec::new();
    for [a, b] in face.edges() {
        let edge = triangulation.get_edge_from_neighbors(handles[&a], handles[&b])?;
        stack.push(edge.face().fix());
    }
    let mut triangles = Vec::new();
    while let Some(at) = stack.pop() {
        let at = triangulation.face(at).as_inner()?;
        if std::mem::replace(&mut inside[at.fix().index()], true) {
            continue;
        }
        triangles.push(at.vertices().map(|v| names[v.fix().index()]));
        for edge in at.adjacent_edges() {
            if !edge.is_constraint_edge() {
                stack.push(edge.rev().face().fix());
            }
        }
    }
    fills(face, &triangles).then_some(triangles)
}

/// Whether the boundary of the triangles, together, is that of the face.
fn fills(face: &MeshFace, triangles: &[[u32; 3]]) -> bool {
    let mut open: BTreeMap<[u32; 2], i32> = BTreeMap::new();
    let mut count = |[a, b]: [u32; 2], by: i32| {
        let (key, by) = if a < b { ([a, b], by) } else { ([b, a], -by) };
        *open.entry(key).or_default() += by;
    };
    for &[a, b, c] in triangles {
        for edge in [[a, b], [b, c], [c, a]] {
            count(edge, 1);
        }
    }
    for edge in face.edges() {
        count(edge, -1);
    }
    let corners: usize = face.cycles().map(<[u32]>::len).sum();
    triangles.len() + 2 == corners + 2 * face.holes.len() && open.values().all(|&n| n == 0)
}

/// The boundary with its holes linked in, each by an edge there and back to the nearest corner.
fn joined(face: &MeshFace, point: &impl Fn(u32) -> [f64; 2]) -> Vec<u32> {
    let mut ring = face.boundary.clone();
    for hole in &face.holes {
        let distance = |i: usize, j: usize| {
            let (p, q) = (point(ring[i]), point(hole[j]));
            (p[0] - q[0]).hypot(p[1] - q[1])
        };
        let pairs = (0..ring.len()).flat_map(|i| (0..hole.len()).map(move |j| (i, j)));
        let nearest = pairs.min_by(|&(i, j), &(k, l)| distance(i, j).total_cmp(&distance(k, l)));
        let Some((i, j)) = nearest else { continue };
        let link: Vec<u32> = hole[j..]
            .iter()
            .chain(&hole[..=j])
            .chain([&ring[i]])
            .copied()
            .collect();
        ring.splice(i + 1..i + 1, link);
    }
    ring
}
