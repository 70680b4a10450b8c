//! Which arcs of a skeleton belong to the centreline.

use crate::{
    lift::Lift,
    skeleton::{ArcKind, NodeKind, Skeleton},
    topology::{ArcId, NodeId},
};

/// What an arc is to the centreline.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Role {
    /// It belongs to it.
    Kept,
    /// It belonged to it.
    Pruned,
    /// It leads to the boundary, or to infinity.
    Spoke,
    /// It is a ghost arc that starts at an input vertex.
    Ghost,
}

/// A skeleton's arcs with their roles.
pub(super) struct Graph<'a> {
    pub lift: &'a Lift<'a>,
    pub roles: Vec<Role>,
}

impl<'a> Graph<'a> {
    pub(super) fn new(lift: &'a Lift<'a>) -> Self {
        let skeleton = lift.skeleton;
        let role = |arc: &crate::skeleton::Arc| {
            let is_ghost = arc.kind == ArcKind::Ghost;
            if is_ghost && matches!(skeleton.node(arc.nodes[0]).kind, NodeKind::Input(_)) {
                Role::Ghost
            } else {
                Role::Kept
            }
        };
        let mut graph = Self {
            lift,
            roles: skeleton.arcs().iter().map(role).collect(),
        };
        // Spokes go on through the nodes that are there only because a ghost arc ended.
        let degrees: Vec<usize> = (0..skeleton.nodes().len())
            .map(|i| graph.with(NodeId::new(i), Role::Kept).count())
            .collect();
        for (i, node) in skeleton.nodes().iter().enumerate() {
            if matches!(node.kind, NodeKind::Event) {
                continue;
            }
            let rim = NodeId::new(i);
            while let Some(mut arc) = graph.first(rim, Role::Kept) {
                let mut at = rim;
                loop {
                    graph.roles[arc.index()] = Role::Spoke;
                    at = graph.across(arc, at);
                    let goes_on = degrees[at.index()] == 2
                        && matches!(skeleton.node(at).kind, NodeKind::Event);
                    let next = graph.first(at, Role::Kept);
                    match next.filter(|_| goes_on) {
                        Some(next) => arc = next,
                        None => break,
                    }
                }
            }
        }
        graph
    }

    pub(super) fn skeleton(&self) -> &'a Skeleton {
        self.lift.skeleton
    }

    /// The arcs at a node that have a role, ascending.
    pub(super) fn with(&self, node: NodeId, role: Role) -> impl Iterator<Item = ArcId> + '_ {
        let arcs = self.lift.arcs_at(node).iter().copied();
        arcs.filter(move |arc| self.roles[arc.index()] == role)
    }

    /// The first of them.
    pub(super) fn first(&self, node: NodeId, role: Role) -> Option<ArcId> {
        self.with(node, role).next()
    }

    /// The other end of an arc.
    pub(super) fn across(&self, arc: ArcId, node: NodeId) -> NodeId {
        let [from, to] = self.skeleton().arc(arc).nodes;
        if from == node { to } else { from }
    }

    /// How many arcs of the centreline meet at a node.
    pub(super) fn degree(&self, node: NodeId) -> usize {
        self.with(node, Role::Kept).count()
    }

    /// All nodes.
    pub(super) fn nodes(&self) -> impl Iterator<Item = NodeId> + use<> {
        (0..self.skeleton().nodes().len()).map(NodeId::new)
    }
}
