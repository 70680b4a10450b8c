//! Figures whose vertices are all on one line: there is nothing to triangulate.

use super::{Edge, Mesh, MeshEdge, mesh::HullEdge, triangulate::NONE};
use crate::topology::VertexId;

/// Pairs of overlapping edges, and how many more there are at the least.
#[derive(Debug, Default)]
pub(super) struct Overlaps {
    pub pairs: Vec<[u32; 2]>,
    pub more: usize,
}

/// The hull along the line and back; splits edges as
/// [`triangulate`](super::triangulate::triangulate) does.
///
/// # Errors
/// If any two edges overlap.
pub(super) fn mesh(vertices: &[[f64; 2]], edges: &mut Vec<Edge>) -> Result<Mesh, Overlaps> {
    // On a line the lexicographic order is the order along the line.
    let mut order: Vec<u32> = (0..vertices.len() as u32).collect();
    order.sort_unstable_by(|&a, &b| {
        let ([a, b], [c, d]) = (vertices[a as usize], vertices[b as usize]);
        a.total_cmp(&c).then(b.total_cmp(&d))
    });
    let mut rank = vec![0; order.len()];
    for (position, &vertex) in order.iter().enumerate() {
        rank[vertex as usize] = position;
    }
    // The gap between positions g and g + 1 belongs to one edge at most.
    let mut owners = vec![NONE; order.len() - 1];
    let spans: Vec<[usize; 2]> = edges
        .iter()
        .map(|edge| [edge.from, edge.to].map(|end| rank[end.index()]))
        .collect();
    for (index, &[a, b]) in spans.iter().enumerate() {
        for owner in &mut owners[a.min(b)..a.max(b)] {
            if *owner != NONE {
                return Err(overlaps(&spans));
            }
            *owner = index as u32;
        }
    }
    for (index, [a, b]) in spans.into_iter().enumerate() {
        let whole = edges[index];
        for k in 0..a.abs_diff(b) {
            let (gap, from, to) = if a < b {
                (a + k, a + k, a + k + 1)
            } else {
                (a - k - 1, a - k, a - k - 1)
            };
            let [from, to] = [from, to].map(|position| VertexId::new(order[position] as usize));
            let part = Edge { from, to, ..whole };
            if k == 0 {
                edges[index] = part;
            } else {
                owners[gap] = edges.len() as u32;
                edges.push(part);
            }
        }
    }
    let gaps = owners.len();
    let hull = (0..2 * gaps)
        .map(|i| {
            let (gap, from, to) = if i < gaps {
                (i, i, i + 1)
            } else {
                (2 * gaps - 1 - i, 2 * gaps - i, 2 * gaps - 1 - i)
            };
            let edge = (owners[gap] != NONE).then_some(owners[gap]);
            let neighbour = MeshEdge::HULL + (2 * gaps - 1 - i) as u32;
            HullEdge {
                from: order[from],
                to: order[to],
                across: MeshEdge { edge, neighbour },
            }
        })
        .collect();
    Ok(Mesh {
        hull,
        ..Mesh::default()
    })
}

/// All pairs of spans that share more than a point, by a sweep along the line.
fn overlaps(spans: &[[usize; 2]]) -> Overlaps {
    let mut starts: Vec<(usize, usize, u32)> = spans
        .iter()
        .enumerate()
        .map(|(index, &[a, b])| (a.min(b), a.max(b), index as u32))
        .collect();
    starts.sort_unstable();
    let mut found = Overlaps::default();
    let mut open: Vec<(usize, u32)> = Vec::new();
    for (start, end, index) in starts {
        open.retain(|&(end, _)| end > start);
        let room = super::InvalidFigure::MAX_PAIRS - found.pairs.len();
        found.pairs.extend(
            open.iter()
                .take(room)
                .map(|&(_, other)| [other.min(index), other.max(index)]),
        );
        found.more += open.len().saturating_sub(room);
        open.push((end, index));
        if found.more > 0 && open.len() > super::InvalidFigure::MAX_PAIRS {
            break;
        }
    }
    found.pairs.sort_unstable();
    found
}
