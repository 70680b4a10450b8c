//! What lies above the inner boundaries of faces, which only weights can make.
//!
//! A boundary all of whose nodes are above a distance is connected with the rest of its piece of
//! the face by nothing but the face itself. So from its highest node one goes straight up in the
//! face's plane, to the first arc above. (An inner boundary that is partly below the distance is
//! joined to the outer one by the wavefront: below the distance there is no piece of the face to
//! keep them apart.)

use crate::lift::Lift;
use crate::{
    predicates::{Bound, Place, PlaneId, Start},
    skeleton::{ArcKind, NodeKind},
    topology::{ArcId, FaceId, NodeId},
};
use std::cmp::Ordering;

/// For each inner boundary of a face its highest node and a node that is connected with it above
/// that one's time. Exact.
pub(super) fn bridges(lift: &Lift, face: FaceId) -> Vec<[NodeId; 2]> {
    let skeleton = lift.skeleton;
    let bridge = |hole: &[NodeId]| {
        let (top, start) = top(lift, hole);
        let above = first_above(lift, face, start);
        // Nothing above: the face goes on for ever there.
        let infinite = || {
            let cycles = std::iter::once(skeleton.boundary(face)).chain(skeleton.holes(face));
            let is_infinite = |n: &NodeId| skeleton.node(*n).time.is_infinite();
            cycles.flatten().copied().find(is_infinite)
        };
        let above = above.map(|arc| skeleton.arc(arc).nodes[1]);
        let above = above.or_else(infinite);
        [
            top,
            above.unwrap_or_else(|| panic!("{face} ends above {top}")),
        ]
    };
    skeleton.holes(face).map(bridge).collect()
}

/// The highest of some nodes that is defined by three planes. One of the highest is: a node
/// defined as the end of a ghost arc lies inside of an arc whose ends are not both lower.
fn top(lift: &Lift, nodes: &[NodeId]) -> (NodeId, Start) {
    let start = |&node: &NodeId| match lift.place(node) {
        Place::Vertex(v) => Some((node, Start::Vertex(v))),
        Place::Event { pair, moment } => Some((node, Start::Event { pair, moment })),
        Place::Foot { .. } | Place::At { .. } | Place::On { .. } => None,
    };
    let time = |node: NodeId| lift.skeleton.node(node).time;
    let highest = nodes.iter().filter_map(start).max_by(|a, b| {
        // What is rounded correctly is never rounded into the wrong order.
        let rounded = time(a.0).total_cmp(&time(b.0));
        let exact = || lift.planes.compare_times(&a.1.into(), &b.1.into());
        rounded.then_with(exact)
    });
    highest.expect("an inner boundary has an event on it")
}

/// The first arc straight above a place in a face's plane.
fn first_above(lift: &Lift, face: FaceId, start: Start) -> Option<ArcId> {
    let skeleton = lift.skeleton;
    let (plane, here) = (lift.plane(face), Place::from(start));
    let mut best: Option<(Place, ArcId)> = None;
    let cycles = std::iter::once(skeleton.boundary(face)).chain(skeleton.holes(face));
    for cycle in cycles {
        for (i, &a) in cycle.iter().enumerate() {
            let b = cycle[(i + 1) % cycle.len()];
            let Some(arc) = arc_between(lift, face, [a, b]) else {
                continue;
            };
            let [from, to] = [a, b].map(|node| is_beyond(lift, node, arc, &here, plane));
            if from == to {
                continue;
            }
            let bound = bound(lift, arc);
            let foot = Place::Foot {
                start,
                plane,
                bound,
            };
            let lower = |place: &Place, than: &Place| {
                lift.planes.compare_times(place, than) == Ordering::Less
            };
            if lower(&here, &foot) && best.is_none_or(|(other, _)| lower(&foot, &other)) {
                best = Some((foot, arc));
            }
        }
    }
    best.map(|(_, arc)| arc)
}

/// The arc of a face between two nodes; there is none at its base and at infinity.
fn arc_between(lift: &Lift, face: FaceId, [a, b]: [NodeId; 2]) -> Option<ArcId> {
    let mut arcs = lift.arcs_at(a).iter().copied();
    arcs.find(|&arc| {
        let arc = lift.skeleton.arc(arc);
        arc.nodes.contains(&b) && arc.faces.contains(&face)
    })
}

/// Whether a node, the end of an arc, is further along a plane's edge than a place.
fn is_beyond(lift: &Lift, node: NodeId, arc: ArcId, here: &Place, plane: PlaneId) -> bool {
    if matches!(lift.skeleton.node(node).kind, NodeKind::Infinite { .. }) {
        if lift.skeleton.arc(arc).kind == ArcKind::Ghost {
            // It is as far along as its start.
            let start = lift.place(lift.skeleton.arc(arc).nodes[0]);
            return lift.planes.compare_along(&start, here, plane).is_gt();
        }
        return lift.planes.compare_far(lift.pair(arc), here, plane).is_gt();
    }
    let place = lift.place(node);
    lift.planes.compare_along(&place, here, plane).is_gt()
}

/// The line that an arc lies on that is no ghost arc.
fn bound(lift: &Lift, arc: ArcId) -> Bound {
    let [i, j] = lift.skeleton.arc(arc).faces.map(|face| lift.plane(face));
    if lift.planes.turn(i, j).is_zero() {
        Bound::Level(lift.level_moment(i, j))
    } else {
        Bound::Pair(lift.pair(arc))
    }
}
