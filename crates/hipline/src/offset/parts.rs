//! Which loops bound one part of the unswept plane: read off the skeleton above them.
//!
//! The part of the plane not yet swept is made of pieces of faces. A piece is bounded by
//! edges of the wavefront and by arcs above it, so two loops belong to one part exactly if
//! the arcs above them, and the edges of the loops themselves, connect them. No geometry is
//! asked, so touching loops are no difficulty.

use super::{OffsetLoop, Part, bridges::bridges, level::Rank};
use crate::{
    lift::Lift,
    skeleton::NodeKind,
    topology::{FaceId, NodeId, Sets},
};
use std::collections::BTreeMap;

/// The components of the skeleton above a distance that goes down.
pub(super) struct Superlevel {
    /// Connections that come in when the distance number i is reached.
    waiting: Vec<Vec<[NodeId; 2]>>,
    sets: Sets,
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
            sets: Sets::new(skeleton.nodes().len()),
            infinite: None,
        };
        // Far out everything is unswept at any finite time. (A vertex between edges that stand still goes nowhere.)
        for (i, node) in skeleton.nodes().iter().enumerate() {
            if let NodeKind::Infinite { direction } = node.kind
                && direction.iter().any(|d| d.abs() > 0.0)
            {
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
        self.sets.join(a.index(), b.index());
    }

    /// Groups loops, given a node above each of them.
    pub(super) fn parts(&mut self, loops: &[OffsetLoop], seeds: &[NodeId]) -> Vec<Part> {
        let infinite = self.infinite.map(|node| self.sets.root(node.index()));
        let mut order: Vec<usize> = Vec::new();
        let mut groups: BTreeMap<usize, Vec<usize>> = BTreeMap::new();
        for (i, &seed) in seeds.iter().enumerate() {
            let root = self.sets.root(seed.index());
            let group = groups.entry(root).or_default();
            if group.is_empty() {
                order.push(root);
            }
            group.push(i);
        }
        let mut found = Found::default();
        for root in order {
            let mut holes = groups.remove(&root).expect("each group once");
            if infinite == Some(root) {
                found.unbounded.append(&mut holes);
                continue;
            }
            // Of a bounded part, one loop is counterclockwise.
            let largest =
                |&a: &usize, &b: &usize| loops[holes[a]].area().total_cmp(&loops[holes[b]].area());
            let shell = (0..holes.len()).max_by(largest).expect("a part has a loop");
            if loops[holes[shell]].area() < 0.0 {
                found.loose.append(&mut holes);
                continue;
            }
            let shell = Some(holes.remove(shell));
            found.bounded.push(Part { shell, holes });
        }
        found.parts(loops)
    }
}

/// Parts as they are found.
#[derive(Default)]
struct Found {
    bounded: Vec<Part>,
    /// The loops that bound the part that has no end.
    unbounded: Vec<usize>,
    /// Loops around what stands still, for ever and on all sides: no arc leads from them to the others.
    loose: Vec<usize>,
}

impl Found {
    /// Finds out where loose loops lie.
    fn parts(mut self, loops: &[OffsetLoop]) -> Vec<Part> {
        for &hole in &self.loose {
            let around = self.bounded.iter_mut().filter(|part| {
                let shell = part.shell.expect("bounded parts have shells");
                lies_in(loops[hole].points(), loops[shell].points())
            });
            let area = |part: &Part| part.shell.map_or(0.0, |shell| loops[shell].area());
            match around.min_by(|p, q| area(p).total_cmp(&area(q))) {
                Some(part) => part.holes.push(hole),
                None => self.unbounded.push(hole),
            }
        }
        if !self.unbounded.is_empty() {
            self.bounded.push(Part {
                shell: None,
                holes: self.unbounded,
            });
        }
        self.bounded
    }
}

/// Whether a loop lies inside another one, which it does not cross.
fn lies_in(inner: &[[f64; 2]], outer: &[[f64; 2]]) -> bool {
    inner
        .iter()
        .find_map(|&point| {
            let mut around = 0;
            for (&p, &q) in outer.iter().zip(outer.iter().cycle().skip(1)) {
                let [a, b, c] = [p, q, point].map(|[x, y]| robust::Coord { x, y });
                let side = robust::orient2d(a, b, c);
                let rises = p[1] <= point[1] && point[1] < q[1];
                let falls = q[1] <= point[1] && point[1] < p[1];
                let within = |k: usize| {
                    (p[k] <= point[k] && point[k] <= q[k]) || (q[k] <= point[k] && point[k] <= p[k])
                };
                if side.abs() <= 0.0 && within(0) && within(1) {
                    return None;
                }
                around += i32::from(rises && side > 0.0);
                around -= i32::from(falls && side < 0.0);
            }
            Some(around != 0)
        })
        .unwrap_or(false)
}
