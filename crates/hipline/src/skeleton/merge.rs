//! One skeleton from those of the parts of a figure.

use super::{Arc, Face, InputGraph, Node, NodeKind, Region, Skeleton, Stats};
use crate::{
    input::{Figure, FigurePart},
    topology::{EdgeId, FaceId, NodeId, VertexId},
};

/// Puts the skeletons of the parts together: nodes and arcs in the order of the parts, after the vertices of the input;
/// faces by edge, side and phase.
pub(crate) fn merge(figure: &Figure, region: Region, parts: &[(FigurePart, Skeleton)]) -> Skeleton {
    let mut nodes: Vec<Node> = (figure.vertices().iter().enumerate())
        .map(|(v, &[x, y])| Node {
            x,
            y,
            time: 0.0,
            kind: NodeKind::Input(VertexId::new(v)),
        })
        .collect();
    let mut numbers: Vec<Vec<NodeId>> = Vec::with_capacity(parts.len());
    let mut order = Vec::new();
    let mut stats = Stats::default();
    for (p, (part, skeleton)) in parts.iter().enumerate() {
        let first = nodes.len();
        let own = part.vertices.len();
        let of_vertices = part.vertices.iter().map(|&v| v as usize);
        let others = first..first + skeleton.nodes.len() - own;
        numbers.push(of_vertices.chain(others).map(NodeId::new).collect());
        nodes.extend_from_slice(&skeleton.nodes[own..]);
        for (f, face) in skeleton.faces.iter().enumerate() {
            let edge = part.edges[face.edge.index()];
            order.push((edge, face.side, face.phase, p, f));
        }
        stats.add(&skeleton.stats);
    }
    // Faces of one phase keep their order, as a part is the first or the second to have them.
    order.sort_unstable();
    let mut names: Vec<Vec<FaceId>> = (parts.iter())
        .map(|(_, skeleton)| vec![FaceId::new(0); skeleton.faces.len()])
        .collect();
    let (mut faces, mut cycles, mut corners) =
        (Vec::with_capacity(order.len()), vec![0], Vec::new());
    for (i, &(edge, _, _, p, f)) in order.iter().enumerate() {
        names[p][f] = FaceId::new(i);
        let skeleton = &parts[p].1;
        let face = skeleton.faces[f];
        let first = cycles.len() as u32 - 1;
        for k in face.cycles[0]..face.cycles[1] {
            let [from, to] = [k, k + 1].map(|k| skeleton.cycles[k as usize] as usize);
            let own = skeleton.corners[from..to].iter();
            corners.extend(own.map(|node| numbers[p][node.index()]));
            cycles.push(corners.len() as u32);
        }
        faces.push(Face {
            edge: EdgeId::new(edge as usize),
            cycles: [first, cycles.len() as u32 - 1],
            ..face
        });
    }
    let arcs = parts.iter().enumerate().flat_map(|(p, (_, skeleton))| {
        let (numbers, names) = (&numbers[p], &names[p]);
        skeleton.arcs.iter().map(move |arc| Arc {
            nodes: arc.nodes.map(|node| numbers[node.index()]),
            faces: arc.faces.map(|face| names[face.index()]),
            kind: arc.kind,
        })
    });
    Skeleton {
        arcs: arcs.collect(),
        nodes,
        faces,
        cycles,
        corners,
        input: InputGraph {
            vertices: figure.vertices().len(),
            edges: (figure.edges().iter())
                .map(|edge| [edge.from, edge.to])
                .collect(),
            terminals: figure.terminals(),
        },
        region,
        stats,
    }
}
