//! Which loops bound one part of the unswept plane: read off the skeleton above them.
//!
//! The part of the plane not yet swept is made of pieces of faces. A piece is bounded by
//! edges of the wavefront and by arcs above it, so two loops belong to one part exactly if
//! the arcs above them, and the edges of the loops themselves, connect them. No geometry is
//! asked, so touching loops are no difficulty.

use super::{OffsetLoop, Part, bridges::bridges, level::Rank, lift::Lift};
use crate::{
    skeleton::NodeKind,
    topology::{FaceId, NodeId},
};
use std::collections::BTreeMap;

/// The components of the skeleton above a distance that goes down.
pub(super) struct Superlevel {
    /// Connections that come in when the distance number i is reached.
    waiting: Vec<Vec<[NodeId; 2]>>,
    parents: Vec<u32>,
    /// A node at infinity.
    infinite: Option<NodeId>,
}

impl Superlevel {
    pub(super) fn new(lift: &Lift, ranks: &[Rank], distances: usize) -> Self {
        let skeleton = lift.skeleton;
        let mut waiting = vec![Vec::new(); distances];
        let bridges = (0..skeleton.faces().len())
            .map(FaceId::new)
            .flat_map(|f| bridges(lift, f));
        for [from, to] in skeleton.arcs().iter().map(|arc| arc.nodes).chain(bridges) {
            // Above all distances below the time of its start.
            if let Some(last) = ranks[from.index()].below.checked_sub(1) {
                waiting[last].push([from, to]);
            }
        }
        let mut this = Self {
            waiting,
            parents: (0..skeleton.nodes().len() as u32).collect(),
            infinite: None,
        };
        // Far out everything is unswept at any finite time.
        for (i, node) in skeleton.nodes().iter().enumerate() {
            if matches!(node.kind, NodeKind::Infinite { .. }) {
                let node = NodeId::new(i);
                let first = *this.infinite.get_or_insert(node);
                this.connect(first, node);
            }
        }
        this
    }

    /// Lowers the distance to the one with this number.
    pub(super) fn lower_to(&mut self, distance: usize) {
        for [from, to] in std::mem::take(&mut self.waiting[distance]) {
            self.connect(from, to);
        }
    }

    /// Two nodes are found to be in one part.
    pub(super) fn connect(&mut self, a: NodeId, b: NodeId) {
        let (a, b) = (self.root(a), self.root(b));
        self.parents[a.max(b) as usize] = a.min(b);
    }

    fn root(&mut self, node: NodeId) -> u32 {
        let mut i = node.index() as u32;
        while self.parents[i as usize] != i {
            let grandparent = self.parents[self.parents[i as usize] as usize];
            self.parents[i as usize] = grandparent;
            i = grandparent;
        }
        i
    }

    /// Groups loops, given a node above each of them.
    pub(super) fn parts(&mut self, loops: &[OffsetLoop], seeds: &[NodeId]) -> Vec<Part> {
        let infinite = self.infinite.map(|node| self.root(node));
        let mut order: Vec<u32> = Vec::new();
        let mut groups: BTreeMap<u32, Vec<usize>> = BTreeMap::new();
        for (i, &seed) in seeds.iter().enumerate() {
            let root = self.root(seed);
            let group = groups.entry(root).or_default();
            if group.is_empty() {
                order.push(root);
            }
            group.push(i);
        }
        let part = |root: u32| {
            let mut holes = groups.remove(&root).expect("each group once");
            if infinite == Some(root) {
                return Part { shell: None, holes };
            }
            // Of a bounded part, one loop is counterclockwise.
            let largest =
                |&a: &usize, &b: &usize| loops[holes[a]].area().total_cmp(&loops[holes[b]].area());
            let shell = (0..holes.len()).max_by(largest).expect("a part has a loop");
            Part {
                shell: Some(holes.remove(shell)),
                holes,
            }
        };
        order.into_iter().map(part).collect()
    }
}
