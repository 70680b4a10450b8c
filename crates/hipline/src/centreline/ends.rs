//! How ends are carried on to the boundary.

use super::{
    Line,
    graph::{Graph, Role},
};
use crate::{
    predicates::{Bound, Place, Start},
    skeleton::{Face, NodeKind, Side},
    topology::{ArcId, FaceId, NodeId},
};

/// Carries both ends of a line on, if they are free.
pub(super) fn extend(graph: &Graph, line: &mut Line) {
    let [first, last] = line.ends;
    if first == last {
        return;
    }
    for (node, is_first) in [(first, true), (last, false)] {
        if graph.degree(node) != 1 {
            continue;
        }
        let more = way_out(graph, node);
        if is_first {
            line.points.splice(0..0, more.into_iter().rev());
        } else {
            line.points.extend(more);
        }
    }
}

/// The points from an end to the boundary; none where there is no way but to infinity.
fn way_out(graph: &Graph, node: NodeId) -> Vec<[f64; 3]> {
    let spokes = spokes(graph, node);
    let count = spokes.len();
    if count == 0 {
        return Vec::new();
    }
    if count.is_multiple_of(2) {
        let (_, face) = spokes[count / 2 - 1];
        if let Some(foot) = foot(graph, node, face) {
            return vec![foot];
        }
    }
    // The one in the middle, else the next that does not go to infinity.
    let middle = (count - 1) / 2;
    let mut order: Vec<usize> = (0..count).collect();
    order.sort_by_key(|&i| (i.abs_diff(middle), i));
    let mut ways = order.iter().map(|&i| down(graph, node, spokes[i].0));
    ways.find_map(|way| way).unwrap_or_default()
}

/// The spokes at an end, counterclockwise, beginning at the arc that arrives there; each with
/// the face on its left, looking away from the node. What follows what is told by the faces
/// between; where those are no help, because a face of a weighted edge is at a node twice, by
/// numbers.
fn spokes(graph: &Graph, node: NodeId) -> Vec<(ArcId, FaceId)> {
    let sides = |id: ArcId| {
        let arc = graph.skeleton().arc(id);
        let [left, right] = arc.faces;
        if arc.nodes[0] == node {
            [left, right]
        } else {
            [right, left]
        }
    };
    let Some(arrival) = graph.with(node, Role::Kept).next() else {
        return Vec::new();
    };
    let mut rest: Vec<ArcId> = graph.lift.arcs_at(node).to_vec();
    rest.retain(|&arc| arc != arrival);
    let (mut at, mut found) = (arrival, Vec::new());
    while !rest.is_empty() {
        let [left, _] = sides(at);
        let next = rest.iter().position(|&arc| sides(arc)[1] == left);
        at = rest.remove(next.unwrap_or(0));
        if graph.roles[at.index()] == Role::Spoke {
            found.push((at, sides(at)[0]));
        }
    }
    found
}

/// The points along a spoke to the boundary, unless it goes to infinity.
fn down(graph: &Graph, from: NodeId, spoke: ArcId) -> Option<Vec<[f64; 3]>> {
    let (mut at, mut arc, mut points) = (from, spoke, Vec::new());
    loop {
        at = graph.across(arc, at);
        let node = graph.skeleton().node(at);
        match node.kind {
            NodeKind::Infinite { .. } => return None,
            NodeKind::Input(_) => {
                points.push([node.x, node.y, node.time]);
                return Some(points);
            }
            NodeKind::Event => points.push([node.x, node.y, node.time]),
        }
        arc = graph.with(at, Role::Spoke).find(|&next| next != arc)?;
    }
}

/// The foot of the perpendicular from a node on the edge of a face, if it is on the edge.
fn foot(graph: &Graph, node: NodeId, face: FaceId) -> Option<[f64; 3]> {
    let start = match graph.lift.place(node) {
        Place::Vertex(v) => Start::Vertex(v),
        Place::Event { pair, moment } => Start::Event { pair, moment },
        Place::Foot { .. } | Place::At { .. } | Place::On { .. } => return None,
    };
    let skeleton = graph.skeleton();
    let Face { edge, side, .. } = *skeleton.face(face);
    if matches!(side, Side::Start | Side::End) {
        return None;
    }
    let plane = graph.lift.plane(face);
    let planes = &graph.lift.planes;
    let place = Place::Foot {
        start,
        plane,
        bound: Bound::Time(0.0),
    };
    let [before, after] = skeleton.input().edges[edge.index()].map(|v| {
        let vertex = &skeleton.nodes()[v.index()];
        planes.compare_along(&place, &Place::Vertex([vertex.x, vertex.y]), plane)
    });
    // On the edge if it is not beyond both ends.
    (before != after || before.is_eq()).then(|| planes.round(&place))
}
