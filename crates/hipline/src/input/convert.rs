//! From spade's half-edges to the plain arrays of a [`Mesh`].

use spade::{
    Triangulation,
    handles::{DirectedEdgeHandle, FixedDirectedEdgeHandle, VertexHandle},
};

use super::{
    Mesh, MeshEdge,
    mesh::HullEdge,
    triangulate::{Cdt, NONE},
};

type Handle<'a> = DirectedEdgeHandle<'a, spade::Point2<f64>, (), spade::CdtEdge<()>, ()>;

/// Copies a triangulation that has at least one triangle; `order` gives our number of each
/// vertex of spade's, `owners` the edge of the figure on each undirected edge of spade's.
pub(super) fn convert(cdt: &Cdt, order: &[u32], owners: &[u32]) -> Mesh {
    let name = |vertex: VertexHandle<'_, _, _, _, _>| order[vertex.index()];
    let owner = |edge: FixedDirectedEdgeHandle| {
        let owner = owners[edge.as_undirected().index()];
        (owner != NONE).then_some(owner)
    };
    // Spade's face 0 is the outer one.
    let triangle = |edge: Handle<'_>| (edge.face().index() as u32).wrapping_sub(1);
    let count = cdt.num_inner_faces();
    let mut mesh = Mesh {
        corners: Vec::with_capacity(count),
        across: Vec::with_capacity(count),
        inside: vec![false; count],
        hull: Vec::new(),
    };
    for face in cdt.inner_faces() {
        let edges: [Handle<'_>; 3] = face.adjacent_edges();
        mesh.corners.push(edges.map(|edge| name(edge.from())));
        let [a, b, c] = edges.map(|edge| MeshEdge {
            edge: owner(edge.fix()),
            neighbour: triangle(edge.rev()),
        });
        // Edge a runs from corner 0 to corner 1: it is opposite corner 2.
        mesh.across.push([b, c, a]);
    }
    let start = cdt
        .outer_face()
        .adjacent_edge()
        .expect("a triangulation has a hull");
    let mut edge = start;
    loop {
        let inner = triangle(edge.rev());
        let from = name(edge.from());
        let to = name(edge.to());
        let corners = mesh.corners[inner as usize];
        // Seen from the inside the edge runs to -> from; the corner opposite comes next.
        let opposite = (0..3).find(|&k| corners[k] != from && corners[k] != to);
        let opposite = opposite.expect("a triangle has a third corner");
        mesh.across[inner as usize][opposite].neighbour = MeshEdge::HULL + mesh.hull.len() as u32;
        mesh.hull.push(HullEdge {
            from,
            to,
            across: MeshEdge {
                edge: owner(edge.fix()),
                neighbour: inner,
            },
        });
        edge = edge.next();
        if edge == start {
            break;
        }
    }
    mesh
}
