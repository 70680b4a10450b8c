//! What to do where rounding has made facets overlap in the plan.
//!
//! Each node is rounded by itself, so a node beside an arc may come to lie on it or beyond it, and
//! two nodes may become one. Then the facets, as rounded, no longer tile the plan. Here they are
//! made to, again, as snap rounding does it (Hobby 1999): nodes at one place become one, an arc that
//! has come to lie beyond a node is led through it, and what no longer encloses an area vanishes.
//! Nothing moves by more than the rounding did. The rim, which is the input itself, stays.
//!
//! The triangles are those of one constrained Delaunay triangulation, so that each has a positive
//! area, and together they cover the plan of the roof once. Hence the roof above them is a surface
//! that meets itself nowhere.

use super::{
    half_edges::HalfEdges,
    mesh::{Mesh, Surface, edges},
    plane::orientation,
    region::{self, Cdt, flood, parts},
};
use crate::topology::EdgeId;
use spade::{
    Point2, PositionInTriangulation, Triangulation,
    handles::{FixedFaceHandle, FixedVertexHandle, InnerTag},
};
use std::collections::BTreeSet;

/// No facet.
const NONE: u32 = u32::MAX;

/// Of the facets of the roof in `mesh`, which have no triangles yet: facets that tile the plan.
/// None if the rim itself crosses itself.
pub(super) fn tile(mesh: &Mesh, sloped: &[usize]) -> Option<Vec<Tile>> {
    let cycles = || {
        sloped.iter().enumerate().flat_map(|(i, &f)| {
            mesh.rings(&mesh.facets[f])
                .map(move |ring| (i as u32, ring))
        })
    };
    let half_edges = HalfEdges::new(cycles());
    let mut rounded = Rounded::new(mesh, &half_edges)?;
    let mut corners: Vec<u32> = cycles().flat_map(|(_, ring)| ring).copied().collect();
    corners.sort_unstable();
    corners.dedup();
    rounded.insert_nodes(&corners)?;
    for (i, ring) in cycles() {
        for edge in edges(ring) {
            let other = half_edges
                .cycle([edge[1], edge[0]])
                .map_or(NONE, |c| c as u32);
            // Each arc once; those of the rim are there already.
            if edge[0] < edge[1] && other != NONE {
                rounded.arc(edge, [i, other]);
            }
        }
    }
    let labels = rounded.labels(&half_edges)?;
    let mut tiles = Vec::new();
    for (i, &f) in sloped.iter().enumerate() {
        let triangles: Vec<[u32; 3]> = labels
            .iter()
            .filter(|(_, label)| *label == i as u32)
            .map(|(triangle, _)| *triangle)
            .collect();
        let table = HalfEdges::new(
            triangles
                .iter()
                .enumerate()
                .map(|(k, t)| (k as u32, &t[..])),
        );
        for part in parts(triangles.len(), &table, |ring| {
            region::area(ring, &|v| mesh.plan(v))
        }) {
            tiles.push(Tile {
                edge: mesh.facets[f].edge,
                rings: part.rings,
                triangles: part.cycles.iter().map(|&k| triangles[k]).collect(),
            });
        }
    }
    Some(tiles)
}

/// A facet that has become what its rounded corners allow.
pub(super) struct Tile {
    pub edge: Option<EdgeId>,
    pub rings: Vec<Vec<u32>>,
    pub triangles: Vec<[u32; 3]>,
}

impl Tile {
    /// Adds it to a mesh.
    pub fn add_to(&self, mesh: &mut Mesh) {
        let rings = self.rings.iter().map(Vec::as_slice);
        mesh.push(Surface::Roof, self.edge, rings, &self.triangles);
    }
}

impl Mesh {
    /// A vertex in the plan.
    pub(super) fn plan(&self, v: u32) -> [f64; 2] {
        let [x, y, _] = self.vertices[v as usize];
        [x, y]
    }
}

/// A piece of an arc: an edge of the triangulation, and the facets on its two sides.
#[derive(Debug, Clone, Copy)]
struct Piece {
    ends: [FixedVertexHandle; 2],
    facets: [u32; 2],
}

struct Rounded<'a> {
    mesh: &'a Mesh,
    cdt: Cdt,
    /// The mesh's vertex for each of the triangulation.
    names: Vec<u32>,
    /// The triangulation's vertex for each of the mesh.
    handles: Vec<Option<FixedVertexHandle>>,
    rim: Vec<[FixedVertexHandle; 2]>,
    pieces: Vec<Piece>,
}

impl<'a> Rounded<'a> {
    /// With the rim.
    fn new(mesh: &'a Mesh, half_edges: &HalfEdges) -> Option<Self> {
        let mut rounded = Self {
            mesh,
            cdt: Cdt::new(),
            names: Vec::new(),
            handles: vec![None; mesh.vertices.len()],
            rim: Vec::new(),
            pieces: Vec::new(),
        };
        for ([a, b], _) in half_edges.open() {
            let ends = [rounded.insert(a)?, rounded.insert(b)?];
            // Two corners of the rim in one place would open it.
            if ends.map(|v| rounded.names[v.index()]) != [a, b] {
                return None;
            }
            rounded.rim.push(ends);
        }
        for i in 0..rounded.rim.len() {
            let [a, b] = rounded.rim[i];
            if a == b || rounded.cdt.try_add_constraint(a, b).len() != 1 {
                return None;
            }
        }
        Some(rounded)
    }

    fn insert(&mut self, v: u32) -> Option<FixedVertexHandle> {
        if let Some(handle) = self.handles[v as usize] {
            return Some(handle);
        }
        let [x, y] = self.mesh.plan(v);
        let handle = self.cdt.insert(Point2::new(x, y)).ok()?;
        if handle.index() == self.names.len() {
            self.names.push(v);
        }
        self.handles[v as usize] = Some(handle);
        Some(handle)
    }

    /// Inserts the nodes that, as rounded, lie inside of the rim.
    fn insert_nodes(&mut self, corners: &[u32]) -> Option<()> {
        let mut is_inside = vec![false; self.cdt.num_all_faces()];
        for face in flood(&self.cdt, self.rim.iter().copied())? {
            is_inside[face.index()] = true;
        }
        let mut inside = Vec::new();
        for &v in corners {
            if self.handles[v as usize].is_some() {
                continue;
            }
            let [x, y] = self.mesh.plan(v);
            match self.cdt.locate(Point2::new(x, y)) {
                PositionInTriangulation::OnVertex(handle) => {
                    self.handles[v as usize] = Some(handle);
                }
                PositionInTriangulation::OnFace(face) if is_inside[face.index()] => inside.push(v),
                PositionInTriangulation::OnEdge(edge) => {
                    let edge = self.cdt.directed_edge(edge);
                    let face = edge.face().as_inner().map(|face| face.fix().index());
                    if !edge.is_constraint_edge() && face.is_some_and(|f| is_inside[f]) {
                        inside.push(v);
                    }
                }
                _ => {}
            }
        }
        inside
            .into_iter()
            .try_for_each(|v| self.insert(v).map(|_| ()))
    }

    /// The corner of the rim that is nearest to a node outside of it, to stand for the node.
    fn stand_in(&mut self, v: u32) -> Option<FixedVertexHandle> {
        if self.handles[v as usize].is_none() {
            let p = self.mesh.plan(v);
            let square = |&[a, _]: &[FixedVertexHandle; 2]| {
                let q = self.mesh.plan(self.names[a.index()]);
                (p[0] - q[0]) * (p[0] - q[0]) + (p[1] - q[1]) * (p[1] - q[1])
            };
            let nearest = self
                .rim
                .iter()
                .min_by(|a, b| square(a).total_cmp(&square(b)));
            self.handles[v as usize] = nearest.map(|ends| ends[0]);
        }
        self.handles[v as usize]
    }

    /// Leads an arc through the triangulation, around nodes that are on the wrong side of it.
    fn arc(&mut self, [a, b]: [u32; 2], facets: [u32; 2]) {
        let (Some(a), Some(b)) = (self.stand_in(a), self.stand_in(b)) else {
            return;
        };
        let mut waiting = vec![Piece {
            ends: [a, b],
            facets,
        }];
        // Detours go through nodes nearer and nearer; should they ever not end, what is left out
        // costs the shape of a facet at most.
        let mut patience = 16 + 4 * self.names.len();
        while let Some(piece) = waiting.pop() {
            let [a, b] = piece.ends;
            if a == b || patience == 0 {
                continue;
            }
            patience -= 1;
            let crossed = self
                .cdt
                .get_conflicting_edges_between_vertices(a, b)
                .next()
                .map(|edge| edge.vertices().map(|v| v.fix()));
            let Some([c, d]) = crossed else {
                self.add(piece);
                continue;
            };
            let near = self.nearest([a, b], [c, d]);
            if near == c || near == d {
                waiting.extend(split(piece, near));
                continue;
            }
            // The arc's end is beyond an edge that is there already: that one makes way.
            let Some(k) = self.find([c, d]) else {
                // Of the rim: nothing can be moved there.
                let near = if self.distance([a, b], c) < self.distance([a, b], d) {
                    c
                } else {
                    d
                };
                waiting.extend(split(piece, near));
                continue;
            };
            self.remove([c, d]);
            let mut aside: Vec<Piece> = Vec::new();
            let mut at = k;
            while at < self.pieces.len() {
                let [e, f] = self.pieces[at].ends;
                if [e, f] == [c, d] || [f, e] == [c, d] {
                    aside.push(self.pieces.swap_remove(at));
                } else {
                    at += 1;
                }
            }
            waiting.push(piece);
            waiting.extend(aside.into_iter().flat_map(|p| split(p, near)));
        }
    }

    fn find(&self, [c, d]: [FixedVertexHandle; 2]) -> Option<usize> {
        let is_same = |p: &Piece| p.ends == [c, d] || p.ends == [d, c];
        let is_rim = self
            .rim
            .iter()
            .any(|&ends| ends == [c, d] || ends == [d, c]);
        self.pieces.iter().position(is_same).filter(|_| !is_rim)
    }

    fn remove(&mut self, [c, d]: [FixedVertexHandle; 2]) {
        if let Some(edge) = self.cdt.get_edge_from_neighbors(c, d) {
            let edge = edge.as_undirected().fix();
            self.cdt.remove_constraint_edge(edge);
        }
    }

    fn add(&mut self, piece: Piece) {
        let [a, b] = piece.ends;
        for edge in self.cdt.try_add_constraint(a, b) {
            let ends = self.cdt.directed_edge(edge).vertices().map(|v| v.fix());
            self.pieces.push(Piece { ends, ..piece });
        }
    }

    /// Of two crossing edges, the end that is nearest to the other one.
    fn nearest(&self, ab: [FixedVertexHandle; 2], cd: [FixedVertexHandle; 2]) -> FixedVertexHandle {
        let candidates = [(cd[0], ab), (cd[1], ab), (ab[0], cd), (ab[1], cd)];
        let by = |p: &(FixedVertexHandle, [FixedVertexHandle; 2])| self.distance(p.1, p.0);
        let nearest = candidates
            .into_iter()
            .min_by(|p, q| by(p).total_cmp(&by(q)));
        nearest.map_or(cd[0], |(v, _)| v)
    }

    /// The square of the distance of a vertex from the line of an edge, up to rounding. It chooses
    /// between detours, all of which are right.
    fn distance(&self, [a, b]: [FixedVertexHandle; 2], v: FixedVertexHandle) -> f64 {
        let [p, q, r] = [a, b, v].map(|v| self.mesh.plan(self.names[v.index()]));
        let d = [q[0] - p[0], q[1] - p[1]];
        let twice = orientation(p, q, r);
        twice * twice / (d[0] * d[0] + d[1] * d[1])
    }

    /// Every triangle inside of the rim with the number of its facet.
    fn labels(&self, half_edges: &HalfEdges) -> Option<Vec<([u32; 3], u32)>> {
        let rim: BTreeSet<[FixedVertexHandle; 2]> = self.rim.iter().copied().collect();
        let mut labels = vec![NONE; self.cdt.num_all_faces()];
        let mut found: Vec<FixedFaceHandle<InnerTag>> = Vec::new();
        for (ends, facet) in self.seeds(half_edges)? {
            if rim.contains(&[ends[1], ends[0]]) && !rim.contains(&ends) {
                continue;
            }
            let face = self.cdt.get_edge_from_neighbors(ends[0], ends[1])?.face();
            if let Some(face) = face.as_inner().filter(|f| labels[f.fix().index()] == NONE) {
                labels[face.fix().index()] = facet;
                found.push(face.fix());
            }
        }
        // First up to the arcs, then to whatever is left.
        for is_bold in [false, true] {
            let mut at = 0;
            while at < found.len() {
                let label = labels[found[at].index()];
                for edge in self.cdt.face(found[at]).adjacent_edges() {
                    let ends = edge.vertices().map(|v| v.fix());
                    let is_rim = rim.contains(&ends) || rim.contains(&[ends[1], ends[0]]);
                    if is_rim || (edge.is_constraint_edge() && !is_bold) {
                        continue;
                    }
                    let beyond = edge.rev().face().as_inner();
                    if let Some(face) = beyond.filter(|f| labels[f.fix().index()] == NONE) {
                        labels[face.fix().index()] = label;
                        found.push(face.fix());
                    }
                }
                at += 1;
            }
        }
        let triangle = |face: FixedFaceHandle<InnerTag>| {
            let corners = self.cdt.face(face).vertices();
            corners.map(|v| self.names[v.fix().index()])
        };
        Some(
            found
                .iter()
                .map(|&face| (triangle(face), labels[face.index()]))
                .collect(),
        )
    }

    /// Directed edges, each with the facet on its left. Where an arc came to lie on another one,
    /// facets that are on both sides of it have no area there, and fall out.
    fn seeds(&self, half_edges: &HalfEdges) -> Option<Vec<([FixedVertexHandle; 2], u32)>> {
        let mut sides: Vec<([FixedVertexHandle; 2], u32, i32)> = Vec::new();
        let mut add = |[a, b]: [FixedVertexHandle; 2], facet: u32, sign: i32| {
            let (ends, sign) = if a < b {
                ([a, b], sign)
            } else {
                ([b, a], -sign)
            };
            sides.push((ends, facet, sign));
        };
        for piece in &self.pieces {
            add(piece.ends, piece.facets[0], 1);
            add(piece.ends, piece.facets[1], -1);
        }
        for (edge, facet) in half_edges.open() {
            let [a, b] = edge.map(|v| self.handles[v as usize]);
            add([a?, b?], facet as u32, 1);
        }
        sides.sort_unstable();
        let mut seeds = Vec::new();
        for same in sides.chunk_by(|s, t| (s.0, s.1) == (t.0, t.1)) {
            let (ends, facet, _) = same[0];
            match same.iter().map(|s| s.2).sum::<i32>() {
                1.. => seeds.push((ends, facet)),
                0 => {}
                _ => seeds.push(([ends[1], ends[0]], facet)),
            }
        }
        Some(seeds)
    }
}

fn split(piece: Piece, at: FixedVertexHandle) -> [Piece; 2] {
    let [a, b] = piece.ends;
    [[a, at], [at, b]].map(|ends| Piece { ends, ..piece })
}
