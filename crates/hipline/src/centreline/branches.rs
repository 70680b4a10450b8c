//! Branches: from an end inwards until a longer one is met.

use super::{
    CentrelineOptions,
    graph::{Graph, Role},
};
use crate::topology::{ArcId, NodeId};
use hipline_num::{Ball, Number, Segment, compare_lengths, distance, exponent_above};
use std::cmp::Ordering;

/// Drops branches.
pub(super) fn prune(graph: &mut Graph, options: CentrelineOptions) {
    let mut tree = Tree::new(graph);
    let order = tree.peel();
    let dropped = tree.dropped(&order, options);
    for arc in dropped {
        graph.roles[arc.index()] = Role::Pruned;
    }
}

/// A way from a node along arcs, and the node it leads to.
#[derive(Clone, Copy)]
struct Way {
    /// The first arc.
    arc: ArcId,
    /// The length, in a unit that keeps it far from the ends of the range of f64.
    near: Ball,
    end: NodeId,
}

/// The centreline as trees, each hanging from the end of a longest path, or from a cycle.
struct Tree<'g, 'a> {
    graph: &'g Graph<'a>,
    shift: i32,
    /// From each node, the longest way down.
    down: Vec<Option<Way>>,
    /// From each node, the arc up.
    up: Vec<Option<ArcId>>,
    /// Ends of longest paths.
    is_root: Vec<bool>,
}

impl<'g, 'a> Tree<'g, 'a> {
    fn new(graph: &'g Graph<'a>) -> Self {
        let nodes = graph.skeleton().nodes();
        let finite = nodes.iter().filter(|node| node.time.is_finite());
        let mut tree = Self {
            graph,
            shift: exponent_above(finite.flat_map(|node| [node.x, node.y])),
            down: vec![None; nodes.len()],
            up: vec![None; nodes.len()],
            is_root: vec![false; nodes.len()],
        };
        tree.find_roots();
        tree
    }

    fn segment(&self, arc: ArcId) -> Segment {
        let ends = self.graph.skeleton().arc(arc).nodes;
        ends.map(|node| {
            let node = self.graph.skeleton().node(node);
            [node.x, node.y]
        })
    }

    fn length(&self, arc: ArcId) -> Ball {
        distance(self.segment(arc), self.shift)
    }

    /// The arcs of a way to the end of a chain of arcs, each given by the node before.
    fn arcs(&self, from: NodeId, first: ArcId, next: &[Option<Way>]) -> Vec<ArcId> {
        let (mut list, mut at) = (vec![first], self.graph.across(first, from));
        while let Some(way) = next[at.index()] {
            list.push(way.arc);
            at = self.graph.across(way.arc, at);
        }
        list
    }

    /// The order of two ways by length; of equally long ones, the one whose end has the smaller
    /// number comes after the other.
    fn compare(&self, [a, b]: [&Way; 2], arcs: impl Fn(&Way) -> Vec<ArcId>) -> Ordering {
        let by_length = if let Some(sign) = a.near.minus(&b.near).sign() {
            sign.ordering()
        } else {
            // What both have in common makes no difference.
            let [mut some, mut others] = [arcs(a), arcs(b)];
            some.sort_unstable();
            others.sort_unstable();
            let without = |list: &[ArcId], common: &[ArcId]| -> Vec<Segment> {
                let own = list.iter().filter(|arc| common.binary_search(arc).is_err());
                own.map(|&arc| self.segment(arc)).collect()
            };
            compare_lengths(&without(&some, &others), &without(&others, &some), 0.0)
        };
        by_length.then(b.end.cmp(&a.end))
    }

    /// Finds an end of a longest path in each part without cycles: the place that is farthest
    /// from any other.
    fn find_roots(&mut self) {
        let mut seen = vec![false; self.up.len()];
        // From each node, the way back to the start.
        let mut back: Vec<Option<Way>> = vec![None; self.up.len()];
        for start in self.graph.nodes() {
            if seen[start.index()] || self.graph.degree(start) == 0 {
                continue;
            }
            seen[start.index()] = true;
            let (mut found, mut ends, mut i) = (vec![start], 0, 0);
            while let Some(&node) = found.get(i) {
                i += 1;
                let so_far = back[node.index()].map_or_else(Ball::zero, |way| way.near);
                for arc in self.graph.with(node, Role::Kept) {
                    ends += 1;
                    let next = self.graph.across(arc, node);
                    if !std::mem::replace(&mut seen[next.index()], true) {
                        let near = so_far.plus(&self.length(arc));
                        let end = next;
                        back[next.index()] = Some(Way { arc, near, end });
                        found.push(next);
                    }
                }
            }
            if ends != 2 * (found.len() - 1) {
                continue;
            }
            let arcs = |way: &Way| self.arcs(way.end, way.arc, &back);
            let ways = found.iter().filter_map(|node| back[node.index()]);
            let farthest = ways.max_by(|a, b| self.compare([a, b], arcs));
            let root = farthest.map_or(start, |way| way.end);
            self.is_root[root.index()] = true;
        }
    }

    /// Takes away ends, one after the other, until roots and cycles are left. Returns them in
    /// this order.
    fn peel(&mut self) -> Vec<NodeId> {
        let graph = self.graph;
        let mut degree: Vec<usize> = graph.nodes().map(|node| graph.degree(node)).collect();
        let is_end = |node: &NodeId| graph.degree(*node) == 1 && !self.is_root[node.index()];
        let mut order: Vec<NodeId> = graph.nodes().filter(is_end).collect();
        let mut is_gone = vec![false; graph.roles.len()];
        let mut i = 0;
        while let Some(&node) = order.get(i) {
            i += 1;
            let mut arcs = graph.with(node, Role::Kept);
            let arc = arcs.find(|arc| !is_gone[arc.index()]);
            let arc = arc.expect("what is peeled hangs on something");
            is_gone[arc.index()] = true;
            let above = graph.across(arc, node);
            self.up[node.index()] = Some(arc);
            let way = self.way_down(node, arc);
            let best = self.down[above.index()];
            let is_longer = best.is_none_or(|best| {
                let arcs = |way: &Way| self.arcs(above, way.arc, &self.down);
                self.compare([&way, &best], arcs).is_gt()
            });
            if is_longer {
                self.down[above.index()] = Some(way);
            }
            degree[above.index()] -= 1;
            if degree[above.index()] == 1 && !self.is_root[above.index()] {
                order.push(above);
            }
        }
        order
    }

    /// The way over an arc and on down from the node below it.
    fn way_down(&self, below: NodeId, arc: ArcId) -> Way {
        let length = self.length(arc);
        match self.down[below.index()] {
            Some(way) => Way {
                arc,
                near: way.near.plus(&length),
                end: way.end,
            },
            None => Way {
                arc,
                near: length,
                end: below,
            },
        }
    }

    /// The arcs of the branches to be dropped, given the nodes from the ends inwards.
    fn dropped(&self, order: &[NodeId], options: CentrelineOptions) -> Vec<ArcId> {
        let mut dropped = Vec::new();
        let mut carries = vec![false; self.up.len()];
        for &node in order {
            let arc = self.up[node.index()].expect("it was peeled");
            let above = self.graph.across(arc, node);
            let goes_on = (self.is_root[above.index()] || self.up[above.index()].is_some())
                && self.down[above.index()].is_some_and(|way| way.arc == arc);
            if goes_on {
                continue;
            }
            let branch = self.arcs(above, arc, &self.down);
            let mut at = above;
            let mut is_carrier = false;
            for &arc in &branch {
                at = self.graph.across(arc, at);
                is_carrier |= carries[at.index()];
            }
            let near = self.way_down(node, arc).near;
            if is_carrier || !(options.longest || self.is_short(above, near, &branch, options)) {
                carries[above.index()] = true;
            } else {
                dropped.extend(branch);
            }
        }
        dropped
    }

    /// Whether a branch is too short.
    fn is_short(
        &self,
        top: NodeId,
        near: Ball,
        branch: &[ArcId],
        options: CentrelineOptions,
    ) -> bool {
        let width = 2.0 * self.graph.skeleton().node(top).time;
        let least = options
            .prune
            .max((options.prune_ratio * width).min(f64::MAX));
        let bound = Ball::from_f64(least).ldexp(-self.shift);
        if let Some(sign) = near.minus(&bound).sign() {
            return sign.is_negative();
        }
        let segments: Vec<Segment> = branch.iter().map(|&arc| self.segment(arc)).collect();
        compare_lengths(&segments, &[], least).is_lt()
    }
}
