//! Skeletons made by hand.

use hipline::{
    Region, Skeleton,
    skeleton::{Arc, ArcKind, InputGraph, Node, NodeKind, Side},
    topology::{EdgeId, FaceId, NodeId, VertexId},
};

fn input(i: usize, x: f64, y: f64) -> Node {
    Node {
        x,
        y,
        time: 0.0,
        kind: NodeKind::Input(VertexId::new(i)),
    }
}

const fn event(x: f64, y: f64, time: f64) -> Node {
    Node {
        x,
        y,
        time,
        kind: NodeKind::Event,
    }
}

fn arc(nodes: [usize; 2], faces: [usize; 2], kind: ArcKind) -> Arc {
    Arc {
        nodes: nodes.map(NodeId::new),
        faces: faces.map(FaceId::new),
        kind,
    }
}

fn face(edge: usize, side: Side, nodes: &[usize]) -> (EdgeId, Side, u32, Vec<Vec<NodeId>>) {
    (
        EdgeId::new(edge),
        side,
        0,
        vec![nodes.iter().copied().map(NodeId::new).collect()],
    )
}

fn ring(n: usize) -> Vec<[VertexId; 2]> {
    (0..n)
        .map(|i| [VertexId::new(i), VertexId::new((i + 1) % n)])
        .collect()
}

/// The inside of the rectangle 0,0 to 8,4: a hip roof.
pub fn hip_roof() -> Skeleton {
    let corners = [[0.0, 0.0], [8.0, 0.0], [8.0, 4.0], [0.0, 4.0]];
    let mut nodes: Vec<_> = corners
        .iter()
        .enumerate()
        .map(|(i, p)| input(i, p[0], p[1]))
        .collect();
    nodes.extend([event(2.0, 2.0, 2.0), event(6.0, 2.0, 2.0)]);
    let arcs = vec![
        arc([0, 4], [3, 0], ArcKind::Ridge),
        arc([1, 5], [0, 1], ArcKind::Ridge),
        arc([2, 5], [1, 2], ArcKind::Ridge),
        arc([3, 4], [2, 3], ArcKind::Ridge),
        arc([4, 5], [2, 0], ArcKind::Ridge),
    ];
    let faces = vec![
        face(0, Side::Left, &[0, 1, 5, 4]),
        face(1, Side::Left, &[1, 2, 5]),
        face(2, Side::Left, &[2, 3, 4, 5]),
        face(3, Side::Left, &[3, 0, 4]),
    ];
    let input = InputGraph {
        vertices: 4,
        edges: ring(4),
        terminals: 0,
    };
    Skeleton::from_parts(nodes, arcs, faces, input, Region::Interior).unwrap()
}

/// The whole plane around the segment 0,0 to 3,0: four unbounded faces, four infinite nodes.
#[allow(dead_code)]
pub fn segment() -> Skeleton {
    let infinite = |x: f64, direction: [f64; 2]| Node {
        x,
        y: 0.0,
        time: f64::INFINITY,
        kind: NodeKind::Infinite { direction },
    };
    let nodes = vec![
        input(0, 0.0, 0.0),
        input(1, 3.0, 0.0),
        infinite(0.0, [-1.0, 1.0]),
        infinite(0.0, [-1.0, -1.0]),
        infinite(3.0, [1.0, 1.0]),
        infinite(3.0, [1.0, -1.0]),
    ];
    let arcs = vec![
        arc([0, 2], [2, 0], ArcKind::Valley),
        arc([0, 3], [1, 2], ArcKind::Valley),
        arc([1, 4], [0, 3], ArcKind::Valley),
        arc([1, 5], [3, 1], ArcKind::Valley),
    ];
    let faces = vec![
        face(0, Side::Left, &[0, 1, 4, 2]),
        face(0, Side::Right, &[1, 0, 3, 5]),
        face(0, Side::Start, &[0, 2, 3]),
        face(0, Side::End, &[1, 5, 4]),
    ];
    let edges = vec![[VertexId::new(0), VertexId::new(1)]];
    let input = InputGraph {
        vertices: 2,
        edges,
        terminals: 2,
    };
    Skeleton::from_parts(nodes, arcs, faces, input, Region::Both).unwrap()
}

/// One face with a hole in it, and awkward numbers. The skeleton of nothing.
#[allow(dead_code)]
pub fn with_hole() -> Skeleton {
    let corners = [
        [-0.0, 0.0],
        [9.0, 0.1 + 0.2],
        [9.0, 1e-300],
        [0.0, 9.0 + 2e-15],
    ];
    let mut nodes: Vec<_> = corners
        .iter()
        .enumerate()
        .map(|(i, p)| input(i, p[0], p[1]))
        .collect();
    nodes.extend([
        event(1.0, 1.0, 5e-324),
        event(2.0, 1.0, 1e22),
        event(1.0, 2.0, f64::MAX),
    ]);
    let hole = vec![
        [0, 1, 2, 3].map(NodeId::new).to_vec(),
        [4, 6, 5].map(NodeId::new).to_vec(),
    ];
    let faces = vec![(EdgeId::new(0), Side::Left, 0, hole)];
    let input = InputGraph {
        vertices: 4,
        edges: ring(4),
        terminals: 0,
    };
    Skeleton::from_parts(nodes, Vec::new(), faces, input, Region::Exterior).unwrap()
}
