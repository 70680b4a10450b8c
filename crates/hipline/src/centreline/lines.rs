//! From arcs to lines between nodes where the centreline ends or branches.

use super::{
    Line,
    graph::{Graph, Role},
};
use crate::topology::{ArcId, NodeId};

/// The lines: first those from ends and branchings, by number; then the cycles without one.
pub(super) fn trace(graph: &Graph) -> Vec<Line> {
    let mut is_done = vec![false; graph.roles.len()];
    let mut lines = Vec::new();
    let is_end = |node: NodeId| graph.degree(node) != 2;
    for only_cycles in [false, true] {
        for start in graph.nodes().filter(|&node| only_cycles || is_end(node)) {
            for arc in graph.with(start, Role::Kept) {
                if !is_done[arc.index()] {
                    lines.push(line(graph, start, arc, &mut is_done));
                }
            }
        }
    }
    lines
}

/// The line that starts at a node along an arc.
fn line(graph: &Graph, start: NodeId, first: ArcId, is_done: &mut [bool]) -> Line {
    let point = |node: NodeId| {
        let node = graph.skeleton().node(node);
        [node.x, node.y, node.time]
    };
    let (mut points, mut at) = (vec![point(start)], start);
    let mut next = Some(first);
    while let Some(arc) = next {
        is_done[arc.index()] = true;
        at = graph.across(arc, at);
        points.push(point(at));
        let open = |arc: &ArcId| !is_done[arc.index()];
        let goes_on = at != start && graph.degree(at) == 2;
        next = graph.with(at, Role::Kept).find(open).filter(|_| goes_on);
    }
    Line {
        points,
        ends: [start, at],
    }
}
