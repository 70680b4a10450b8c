//! Parts of a figure that do not touch: the edges cut the plane into components, whose wavefronts never meet.
//!
//! A vertex has, in each component around it, the edges on both sides of its sector; so it is a terminal in a part
//! exactly if it is one in the whole. Small components share a part, lest copying costs more
//! than is gained. What the parts are depends on the figure alone.

use super::{Edge, Figure, Mesh, MeshEdge, SpeedChange, mesh::HullEdge};
use crate::{
    skeleton::Region,
    topology::{EdgeId, VertexId},
};

/// Figures with fewer triangles are not worth it.
const LEAST_WHOLE: usize = 20_000;
/// Parts have as many triangles as this, if there are more components.
const LEAST_PART: usize = 4_000;
/// There are at most about so many parts.
const PARTS: usize = 64;
/// In no component that is asked for; not yet known.
const NONE: u32 = u32::MAX;

/// How a figure falls into parts.
pub(crate) struct Parts<'a> {
    figure: &'a Figure,
    /// The triangles of each part, ascending.
    triangles: Vec<Vec<u32>>,
    /// The part with the outside of the hull.
    outer: Option<usize>,
}

/// A part of a figure, as a figure of its own.
pub(crate) struct FigurePart {
    pub figure: Figure,
    pub region: Region,
    /// The numbers of its vertices and edges in the whole.
    pub vertices: Vec<u32>,
    pub edges: Vec<u32>,
}

impl Figure {
    /// The parts of a region, if there are several that are large enough.
    pub(crate) fn parts(&self, region: Region) -> Option<Parts<'_>> {
        self.parts_from(region, LEAST_WHOLE, LEAST_PART)
    }

    /// The same for another opinion on what is large enough, in triangles.
    pub(crate) fn parts_from(
        &self,
        region: Region,
        least_whole: usize,
        least_part: usize,
    ) -> Option<Parts<'_>> {
        let mesh = self.mesh();
        let kept = |t: usize| mesh.is_in(t, region);
        if mesh.corners.len() < least_whole {
            return None;
        }
        let count = (0..mesh.corners.len()).filter(|&t| kept(t)).count();
        if count < least_whole {
            return None;
        }
        let least = least_part.max(count / PARTS);
        let mut part_of = vec![NONE; mesh.corners.len()];
        let mut parts: Vec<usize> = vec![0];
        let mut outer = None;
        let mut work: Vec<u32> = Vec::new();
        for first in 0..mesh.corners.len() {
            if part_of[first] != NONE || !kept(first) {
                continue;
            }
            if parts[parts.len() - 1] >= least {
                parts.push(0);
            }
            let part = parts.len() - 1;
            part_of[first] = part as u32;
            work.push(first as u32);
            while let Some(t) = work.pop() {
                parts[part] += 1;
                let mut visit = |edge: &MeshEdge, work: &mut Vec<u32>| {
                    let t = edge.neighbour as usize;
                    if edge.edge.is_none() && part_of[t] == NONE {
                        part_of[t] = part as u32;
                        work.push(t as u32);
                    }
                };
                for edge in &mesh.across[t as usize] {
                    if edge.neighbour & MeshEdge::HULL == 0 {
                        visit(edge, &mut work);
                    } else if edge.edge.is_none() && outer.is_none() {
                        // All around the hull is one component.
                        outer = Some(part);
                        for hull in &mesh.hull {
                            if hull.across.neighbour & MeshEdge::HULL == 0 {
                                visit(&hull.across, &mut work);
                            }
                        }
                    }
                }
            }
        }
        if parts.len() < 2 {
            return None;
        }
        if outer.is_none() && region != Region::Interior {
            // The hull consists of edges.
            outer = Some(0);
        }
        let mut triangles: Vec<Vec<u32>> = parts.iter().map(|&n| Vec::with_capacity(n)).collect();
        for (t, &part) in part_of.iter().enumerate() {
            if part != NONE {
                triangles[part as usize].push(t as u32);
            }
        }
        Some(Parts {
            figure: self,
            triangles,
            outer,
        })
    }
}

/// Of an ascending list, the place of a number that is in it.
fn place(list: &[u32], number: u32) -> u32 {
    list.binary_search(&number).expect("it is in the part") as u32
}

impl Parts<'_> {
    pub(crate) const fn len(&self) -> usize {
        self.triangles.len()
    }

    /// The figure of one part. O(n log n) for n triangles, and for the hull.
    pub(crate) fn part(&self, number: usize) -> FigurePart {
        let whole = self.figure.mesh();
        let triangles = &self.triangles[number];
        let hull: &[HullEdge] = if self.outer == Some(number) {
            &whole.hull
        } else {
            &[]
        };
        let across = || {
            let inner = triangles.iter().flat_map(|&t| whole.across[t as usize]);
            inner.chain(hull.iter().map(|edge| edge.across))
        };
        let mut edges: Vec<u32> = across().filter_map(|edge| edge.edge).collect();
        edges.sort_unstable();
        edges.dedup();
        let ends = edges.iter().flat_map(|&e| {
            let edge = &self.figure.edges[e as usize];
            [edge.from, edge.to].map(|v| v.index() as u32)
        });
        let mut vertices: Vec<u32> = ends.collect();
        vertices.sort_unstable();
        vertices.dedup();
        let side = |edge: &MeshEdge, own: u32| MeshEdge {
            edge: edge.edge.map(|e| place(&edges, e)),
            neighbour: if edge.edge.is_some() {
                // Nobody looks beyond an edge.
                own
            } else if edge.neighbour & MeshEdge::HULL == 0 {
                place(triangles, edge.neighbour)
            } else {
                edge.neighbour
            },
        };
        let mesh = Mesh {
            corners: triangles
                .iter()
                .map(|&t| whole.corners[t as usize].map(|v| place(&vertices, v)))
                .collect(),
            across: (0_u32..)
                .zip(triangles)
                .map(|(own, &t)| whole.across[t as usize].map(|edge| side(&edge, own)))
                .collect(),
            inside: vec![true; triangles.len()],
            hull: (0_u32..)
                .zip(hull)
                .map(|(own, edge)| HullEdge {
                    from: place(&vertices, edge.from),
                    to: place(&vertices, edge.to),
                    across: side(&edge.across, own | MeshEdge::HULL),
                })
                .collect(),
        };
        FigurePart {
            figure: self.figure.restricted(&vertices, &edges, mesh),
            region: if self.outer == Some(number) {
                Region::Both
            } else {
                Region::Interior
            },
            vertices,
            edges,
        }
    }
}

impl Figure {
    /// The same figure with some of its vertices and edges only.
    fn restricted(&self, vertices: &[u32], edges: &[u32], mesh: Mesh) -> Self {
        let local = |v: VertexId| VertexId::new(place(vertices, v.index() as u32) as usize);
        let own: Vec<Edge> = edges
            .iter()
            .map(|&e| self.edges[e as usize])
            .map(|edge| Edge {
                from: local(edge.from),
                to: local(edge.to),
                ..edge
            })
            .collect();
        let mut degrees = vec![0_u8; vertices.len()];
        for end in own.iter().flat_map(|edge| [edge.from, edge.to]) {
            degrees[end.index()] = degrees[end.index()].saturating_add(1);
        }
        let changes = edges.iter().enumerate().flat_map(|(i, &e)| {
            let sides = [false, true];
            let of = move |right| self.changes_of(EdgeId::new(e as usize), right);
            sides
                .into_iter()
                .flat_map(of)
                .map(move |change| SpeedChange {
                    edge: EdgeId::new(i),
                    ..*change
                })
        });
        Self {
            terminals: degrees.iter().filter(|&&degree| degree == 1).count(),
            has_polygon: own.iter().any(|edge| edge.on_ring),
            changes: changes.collect(),
            heights: if self.heights.is_empty() {
                Vec::new()
            } else {
                vertices.iter().map(|&v| self.heights[v as usize]).collect()
            },
            vertices: vertices
                .iter()
                .map(|&v| self.vertices[v as usize])
                .collect(),
            edges: own,
            mesh: mesh.into(),
            monotone: None,
        }
    }
}
