use super::{Edge, Flaw, Mesh};
pub(super) fn fill(_v: &[[f64; 2]], edges: &[Edge], mesh: &mut Mesh, _flaws: &mut Vec<Flaw>) {
    let parity = |e: Option<u32>| e.is_some_and(|e| edges[e as usize].on_ring);
    let mut seen = vec![false; mesh.corners.len()];
    let mut stack = Vec::new();
    for h in &mesh.hull {
        if h.across.neighbour < super::MeshEdge::HULL { stack.push((h.across.neighbour as usize, parity(h.across.edge))); }
    }
    while let Some((t, inside)) = stack.pop() {
        if std::mem::replace(&mut seen[t], true) { continue; }
        mesh.inside[t] = inside;
        for a in mesh.across[t] {
            if a.neighbour < super::MeshEdge::HULL { stack.push((a.neighbour as usize, inside ^ parity(a.edge))); }
        }
    }
}
