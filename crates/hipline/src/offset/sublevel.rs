//! Which loops bound one part of what has been swept, together with the figure itself.
//!
//! What a face has swept until a moment is connected, within the face, with its edge: the wavefront
//! grows from there, and no piece of it ever starts anywhere else. So every corner of a face that has
//! been reached is connected with the ends of its edge; and edges are connected by their vertices.
//! Again no geometry is asked.

use super::{OffsetLoop, Part, level::Rank};
use crate::{
    input::Figure,
    lift::Lift,
    skeleton::Region,
    topology::{FaceId, NodeId, Sets},
};
use std::collections::BTreeMap;

/// The components of what is below a distance that goes up.
pub(super) struct Sublevel {
    /// Connections that come in when the distance number i is reached.
    waiting: Vec<Vec<[NodeId; 2]>>,
    sets: Sets,
}

impl Sublevel {
    /// Nothing for the inside of polygons.
    pub(super) fn new(
        lift: &Lift,
        figure: &Figure,
        ranks: &[Rank],
        distances: usize,
    ) -> Option<Self> {
        let skeleton = lift.skeleton;
        if skeleton.region() == Region::Interior {
            return None;
        }
        let mut this = Self {
            waiting: vec![Vec::new(); distances],
            sets: Sets::new(skeleton.nodes().len()),
        };
        // The inside of a polygon is connected.
        let mut polygons: BTreeMap<u32, NodeId> = BTreeMap::new();
        for edge in figure.edges() {
            let [from, to] = [edge.from, edge.to].map(|v| NodeId::new(v.index()));
            this.connect(from, to);
            if edge.on_ring && skeleton.region() == Region::Exterior {
                let first = *polygons.entry(edge.source.part).or_insert(from);
                this.connect(first, from);
            }
        }
        for face in (0..skeleton.faces().len()).map(FaceId::new) {
            let cycles = std::iter::once(skeleton.boundary(face)).chain(skeleton.holes(face));
            let base = skeleton.boundary(face)[0];
            for &corner in cycles.flatten() {
                if let Some(list) = this.waiting.get_mut(ranks[corner.index()].below) {
                    list.push([base, corner]);
                }
            }
        }
        Some(this)
    }

    /// Raises the distance to the one with this number.
    pub(super) fn raise_to(&mut self, distance: usize) {
        for [a, b] in std::mem::take(&mut self.waiting[distance]) {
            self.connect(a, b);
        }
    }

    fn connect(&mut self, a: NodeId, b: NodeId) {
        self.sets.join(a.index(), b.index());
    }

    /// Groups loops, given a node below each of them. The shell is the one around the others.
    pub(super) fn parts(&mut self, loops: &[OffsetLoop], seeds: &[NodeId]) -> Vec<Part> {
        let mut groups: BTreeMap<usize, Vec<usize>> = BTreeMap::new();
        for (i, &seed) in seeds.iter().enumerate() {
            let root = self.sets.root(seed.index());
            groups.entry(root).or_default().push(i);
        }
        let part = |mut holes: Vec<usize>| {
            let order = |&a: &usize, &b: &usize| {
                let [a, b] = [a, b].map(|k| loops[holes[k]].area());
                a.total_cmp(&b)
            };
            let shell = (0..holes.len()).min_by(order).map(|k| holes.remove(k));
            Part { shell, holes }
        };
        groups.into_values().map(part).collect()
    }
}
