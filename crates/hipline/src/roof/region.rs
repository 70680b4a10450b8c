//! Regions of the plan: from rings to triangles, and back.

use super::{ears, half_edges::HalfEdges, mesh::edges};
use crate::topology::Sets;
use spade::{
    ConstrainedDelaunayTriangulation, Point2, Triangulation, handles::FixedFaceHandle,
    handles::FixedVertexHandle, handles::InnerTag,
};

/// Single rings with fewer corners are cut ear by ear, others by a Delaunay triangulation.
const SMALL: usize = 24;

pub(super) type Cdt = ConstrainedDelaunayTriangulation<Point2<f64>>;

/// Cuts the region on the left of some rings into triangles of positive area, which it appends. If
/// the rings, as rounded, bound no such region, nothing is appended.
pub(super) fn fill(
    rings: &[&[u32]],
    point: &impl Fn(u32) -> [f64; 2],
    triangles: &mut Vec<[u32; 3]>,
) -> bool {
    if let &[ring] = rings
        && ring.len() <= SMALL
        && ears::cut(ring, point, triangles)
    {
        return true;
    }
    let before = triangles.len();
    let is_filled =
        delaunay(rings, point, triangles).is_some() && is_boundary(rings, &triangles[before..]);
    if !is_filled {
        triangles.truncate(before);
    }
    is_filled
}

/// The triangles on the left of constrained edges, up to other constrained edges.
pub(super) fn flood(
    cdt: &Cdt,
    seeds: impl IntoIterator<Item = [FixedVertexHandle; 2]>,
) -> Option<Vec<FixedFaceHandle<InnerTag>>> {
    let mut is_seen = vec![false; cdt.num_all_faces()];
    let mut stack = Vec::new();
    for [a, b] in seeds {
        stack.push(cdt.get_edge_from_neighbors(a, b)?.face().fix());
    }
    let mut found = Vec::new();
    while let Some(at) = stack.pop() {
        let at = cdt.face(at).as_inner()?;
        if std::mem::replace(&mut is_seen[at.fix().index()], true) {
            continue;
        }
        found.push(at.fix());
        for edge in at.adjacent_edges() {
            if !edge.is_constraint_edge() {
                stack.push(edge.rev().face().fix());
            }
        }
    }
    Some(found)
}

fn delaunay(
    rings: &[&[u32]],
    point: &impl Fn(u32) -> [f64; 2],
    triangles: &mut Vec<[u32; 3]>,
) -> Option<()> {
    let mut names: Vec<u32> = rings.iter().copied().flatten().copied().collect();
    names.sort_unstable();
    names.dedup();
    let mut cdt = Cdt::new();
    let mut handles = vec![FixedVertexHandle::from_index(0); names.len()];
    // In the order of the rings neighbours come after each other, which is fast.
    let mut inserted: Vec<u32> = Vec::with_capacity(names.len());
    let mut is_in = vec![false; names.len()];
    let place = |v: u32| names.binary_search(&v).expect("a corner of the rings");
    for &v in rings.iter().copied().flatten() {
        if std::mem::replace(&mut is_in[place(v)], true) {
            continue;
        }
        let [x, y] = point(v);
        let handle = cdt.insert(Point2::new(x, y)).ok()?;
        if handle.index() != inserted.len() {
            return None; // two corners rounded into one point
        }
        inserted.push(v);
        handles[place(v)] = handle;
    }
    let ends = |[a, b]: [u32; 2]| [handles[place(a)], handles[place(b)]];
    for edge in rings.iter().copied().flat_map(edges) {
        let [a, b] = ends(edge);
        if a == b || !cdt.can_add_constraint(a, b) {
            return None;
        }
        cdt.add_constraint(a, b);
    }
    let seeds = rings.iter().copied().flat_map(edges).map(ends);
    for face in flood(&cdt, seeds)? {
        let corners = cdt.face(face).vertices();
        triangles.push(corners.map(|v| inserted[v.fix().index()]));
    }
    Some(())
}

/// Whether the boundary of the triangles, together, is that of the rings.
fn is_boundary(rings: &[&[u32]], triangles: &[[u32; 3]]) -> bool {
    let mut list: Vec<([u32; 2], i32)> = Vec::new();
    let mut count = |[a, b]: [u32; 2], by: i32| {
        list.push(if a < b { ([a, b], by) } else { ([b, a], -by) });
    };
    for triangle in triangles {
        edges(triangle).for_each(|edge| count(edge, 1));
    }
    for edge in rings.iter().copied().flat_map(edges) {
        count(edge, -1);
    }
    list.sort_unstable();
    list.chunk_by(|a, b| a.0 == b.0)
        .all(|same| same.iter().map(|(_, by)| by).sum::<i32>() == 0)
}

/// A connected part of a surface.
pub(super) struct Part {
    /// Its boundaries, the outer one first.
    pub rings: Vec<Vec<u32>>,
    /// The numbers of its cycles.
    pub cycles: Vec<usize>,
}

/// The parts of a surface that hang together by edges, in the order of their first cycles.
/// `area` is that of a ring in the plan, positive for outer ones.
pub(super) fn parts(
    count: usize,
    half_edges: &HalfEdges,
    area: impl Fn(&[u32]) -> f64,
) -> Vec<Part> {
    let mut sets = Sets::new(count);
    for [a, b] in half_edges.neighbours() {
        sets.join(a, b);
    }
    let mut numbers = vec![usize::MAX; count];
    let mut parts: Vec<Part> = Vec::new();
    for cycle in 0..count {
        let root = sets.root(cycle);
        if root == cycle {
            numbers[root] = parts.len();
            parts.push(Part {
                rings: Vec::new(),
                cycles: Vec::new(),
            });
        }
        parts[numbers[root]].cycles.push(cycle);
    }
    for rim in half_edges.rims() {
        let root = sets.root(rim.cycle);
        parts[numbers[root]].rings.push(rim.ring);
    }
    for part in &mut parts {
        if part.rings.len() > 1 {
            part.rings.sort_by(|a, b| area(b).total_cmp(&area(a)));
        }
    }
    parts
}

/// Twice the area of a ring, up to rounding.
pub(super) fn area(ring: &[u32], point: &impl Fn(u32) -> [f64; 2]) -> f64 {
    let Some(&first) = ring.first() else {
        return 0.0;
    };
    let [x, y] = point(first);
    edges(ring)
        .map(|[a, b]| {
            let (p, q) = (point(a), point(b));
            (p[0] - x) * (q[1] - y) - (q[0] - x) * (p[1] - y)
        })
        .sum()
}
