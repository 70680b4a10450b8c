//! From half-edges to the plain arrays of a [`Mesh`].

use super::{
    Mesh, MeshEdge,
    delaunay::{INFINITE, NONE, Triangulation, next, prev},
    mesh::HullEdge,
};

/// Copies a triangulation; its ghost triangles become the hull.
pub(super) fn convert(triangulation: &Triangulation<'_>) -> Mesh {
    let slots = triangulation.origin.len() as u32 / 3;
    let edge = |h: u32| Some(triangulation.owner[h as usize]).filter(|&owner| owner != NONE);
    // What the mesh calls each slot: a triangle, or a hull edge plus `HULL`.
    let mut names = vec![NONE; slots as usize];
    let mut count = 0;
    let mut infinite = None;
    for slot in 0..slots {
        if let Some(h) = (3 * slot..3 * slot + 3).find(|&h| triangulation.from(h) == INFINITE) {
            infinite = Some(h);
        } else {
            names[slot as usize] = count;
            count += 1;
        }
    }
    let mut hull = Vec::new();
    let start = infinite.expect("a triangulation has an outside");
    let mut from_infinity = start;
    loop {
        // A ghost (u, v, infinite), counterclockwise, lies on the left of u -> v; its
        // neighbour at v is the next one.
        let h = next(from_infinity);
        names[(h / 3) as usize] = MeshEdge::HULL + hull.len() as u32;
        let neighbour = names[(triangulation.twin(h) / 3) as usize];
        let across = MeshEdge { edge: edge(h), neighbour };
        hull.push(HullEdge { from: triangulation.from(h), to: triangulation.to(h), across });
        from_infinity = triangulation.twin(next(h));
        if from_infinity == start {
            break;
        }
    }
    let mut mesh = Mesh {
        corners: Vec::with_capacity(count as usize),
        across: Vec::with_capacity(count as usize),
        inside: vec![false; count as usize],
        hull,
    };
    for slot in (0..slots).filter(|&slot| names[slot as usize] < MeshEdge::HULL) {
        let h = 3 * slot;
        mesh.corners.push([h, next(h), prev(h)].map(|h| triangulation.from(h)));
        // The half-edge from corner 0 to corner 1 is opposite corner 2.
        mesh.across.push([next(h), prev(h), h].map(|h| MeshEdge {
            edge: edge(h),
            neighbour: names[(triangulation.twin(h) / 3) as usize],
        }));
    }
    mesh
}
