//! The faces around each node, Euler's formula, and the counts that follow from it.

use super::{Checker, Violation, dart};
use crate::{
    predicates::Heading,
    skeleton::{Face, NodeKind, Region, Side},
    topology::{NodeId, Sets, VertexId},
};
use std::cmp::Ordering;

/// What one turn around a node finds.
#[derive(Default)]
struct Turn {
    /// Darts passed.
    darts: usize,
    /// How often the angle fell.
    falls: usize,
    /// How often it stayed.
    equals: usize,
}

impl Checker<'_> {
    /// Checks the order around all nodes, and what follows from it.
    pub(super) fn check_rotation(&mut self) {
        let edges_at = self.edges_at();
        self.bridge_gaps(&edges_at);
        self.check_nodes(&edges_at);
        self.check_infinity();
        let parts = self.check_euler();
        self.check_counts(parts, &edges_at);
    }

    fn heading_of(&self, dart: u32) -> Heading {
        let heading = self.headings[dart as usize / 2];
        if dart.is_multiple_of(2) {
            heading
        } else {
            heading.reversed()
        }
    }

    /// Where a side of an edge is not in the region, the next edge comes next.
    fn bridge_gaps(&mut self, edges_at: &[Vec<u32>]) {
        let first = 2 * self.skeleton.arcs.len();
        for darts in edges_at {
            let is_gap = |d: &u32| !self.incidence.covered[*d as usize - first];
            if !darts.iter().any(is_gap) {
                continue;
            }
            let mut darts = darts.clone();
            if darts.len() > 2 {
                darts.sort_by(|&d, &e| {
                    self.planes
                        .compare_headings(&self.heading_of(d), &self.heading_of(e))
                });
            }
            let gaps: Vec<usize> = (0..darts.len()).filter(|&i| is_gap(&darts[i])).collect();
            for i in gaps {
                self.incidence.after[darts[i] as usize] = darts[(i + 1) % darts.len()];
            }
        }
    }

    /// Goes once around the node that a dart leaves.
    fn turn_around(&self, start: u32, most: usize) -> Turn {
        let mut turn = Turn::default();
        let mut dart = start;
        loop {
            let next = self.incidence.after[dart as usize];
            turn.darts += 1;
            if next == dart::NONE || turn.darts > most {
                return Turn::default();
            }
            match self
                .planes
                .compare_headings(&self.heading_of(dart), &self.heading_of(next))
            {
                Ordering::Less => {}
                Ordering::Equal => turn.equals += usize::from(!self.covers_base(dart, next)),
                Ordering::Greater => turn.falls += 1,
            }
            if next == start {
                return turn;
            }
            dart = next;
        }
    }

    /// Whether one of two darts is an edge and the other the arc over its whole length along which the edge was
    /// overrun at time zero. The face between them has no area.
    fn covers_base(&self, d: u32, e: u32) -> bool {
        let arcs = self.skeleton.arcs.len();
        let [arc, edge] = [d.min(e), d.max(e)].map(|dart| dart as usize / 2);
        arc < arcs && edge >= arcs && {
            let mut ends = self.skeleton.arcs[arc].nodes.map(NodeId::index);
            let mut base = self.skeleton.input.edges[edge - arcs].map(VertexId::index);
            ends.sort_unstable();
            base.sort_unstable();
            ends == base
        }
    }

    fn check_nodes(&mut self, edges_at: &[Vec<u32>]) {
        for i in 0..self.skeleton.nodes.len() {
            let node = NodeId::new(i);
            if self.skeleton.node(node).is_at_infinity() {
                continue;
            }
            let edges = edges_at.get(i).map_or(&[][..], |list| &list[..]);
            let arcs = self.incidence.arcs(node);
            let count = edges.len() + arcs.len();
            let Some(start) = edges.first().copied().or_else(|| {
                let &a = arcs.first()?;
                Some(2 * a + u32::from(self.skeleton.arcs[a as usize].nodes[0] != node))
            }) else {
                continue;
            };
            let turn = self.turn_around(start, count);
            if turn.darts != count || turn.falls != 1 || turn.equals != 0 {
                self.report.add(Violation::Unordered { node });
            }
        }
    }

    /// All of infinity is one node, seen from its other side; directions may be equal there.
    fn check_infinity(&mut self) {
        let arcs = &self.skeleton.arcs;
        let outgoing = |a: usize| self.places[arcs[a].nodes[1].index()].is_none();
        let unbounded: Vec<usize> = (0..arcs.len()).filter(|&a| outgoing(a)).collect();
        let Some(&first) = unbounded.first() else {
            return;
        };
        let (mut count, mut falls, mut dart) = (0, 0, (2 * first + 1) as u32);
        loop {
            let next = self.incidence.after[dart as usize];
            count += 1;
            if next == dart::NONE || count > unbounded.len() {
                count = 0;
                break;
            }
            let [this, before] = [dart, next].map(|d| self.headings[d as usize / 2]);
            falls += usize::from(self.planes.compare_headings(&before, &this).is_gt());
            if next as usize == 2 * first + 1 {
                break;
            }
            dart = next;
        }
        if count != unbounded.len() || falls != 1 {
            self.report.add(Violation::UnorderedAtInfinity);
        }
    }

    /// Euler's formula for each connected part, with every boundary as a disc: both for the
    /// faces and for what is not in the region. Returns the number of parts.
    fn check_euler(&mut self) -> usize {
        let s = self.skeleton;
        let after = &self.incidence.after;
        let mut inverse = vec![dart::NONE; after.len()];
        for (d, &next) in after.iter().enumerate() {
            if next != dart::NONE {
                inverse[next as usize] = d as u32;
            }
        }
        // The dart that follows on the same boundary leaves the node where this one arrives.
        let mut seen = vec![false; after.len()];
        let mut faces = 0;
        for start in 0..after.len() as u32 {
            if after[start as usize] == dart::NONE || seen[start as usize] {
                continue;
            }
            faces += 1;
            let mut dart = start;
            while dart != dart::NONE && !std::mem::replace(&mut seen[dart as usize], true) {
                dart = inverse[dart::twin(dart) as usize];
            }
        }
        let infinity = s.nodes.len();
        let number = |n: NodeId| {
            if s.node(n).is_at_infinity() {
                infinity
            } else {
                n.index()
            }
        };
        let mut sets = Sets::new(s.nodes.len() + 1);
        let mut used = vec![false; s.nodes.len() + 1];
        let mut lines = 0;
        let ends = s.arcs.iter().map(|arc| arc.nodes.map(number));
        let bases =
            s.input.edges.iter().enumerate().filter(|(e, _)| {
                self.incidence.covered[2 * e] || self.incidence.covered[2 * e + 1]
            });
        for [i, j] in ends.chain(bases.map(|(_, ends)| ends.map(VertexId::index))) {
            lines += 1;
            (used[i], used[j]) = (true, true);
            sets.join(i, j);
        }
        let nodes = used.iter().filter(|&&is| is).count();
        let parts = (0..=infinity)
            .filter(|&i| used[i] && sets.root(i) == i)
            .count();
        if nodes + faces != lines + 2 * parts {
            self.report.add(Violation::Euler {
                nodes,
                arcs: lines,
                faces,
                parts,
            });
        }
        parts
    }

    /// Lemma 2 of the paper for the whole plane; for the interior of polygons whose rings
    /// do not touch, n + 2 h - 2 for each part with h holes. Each cap adds one, as a terminal does.
    fn check_counts(&mut self, parts: usize, edges_at: &[Vec<u32>]) {
        if !self.unweighted {
            return;
        }
        let s = self.skeleton;
        let degree = |i: usize| self.incidence.arcs(NodeId::new(i)).len() as i64;
        let found: i64 = s
            .nodes
            .iter()
            .enumerate()
            .map(|(i, node)| match node.kind {
                NodeKind::Input(_) => 0,
                NodeKind::Event => degree(i) - 2,
                NodeKind::Infinite { .. } => 1,
            })
            .sum();
        let n = s.input.vertices as i64;
        let ends = |face: &&Face| matches!(face.side, Side::Start | Side::End);
        let tips = s.faces.iter().filter(ends).count() as i64;
        let expected = match s.region {
            Region::Both => 2 * n + tips - 2,
            Region::Interior if edges_at.iter().all(|list| list.len() == 2) => {
                let mut rings = Sets::new(s.input.vertices);
                for ends in &s.input.edges {
                    rings.join(ends[0].index(), ends[1].index());
                }
                let rings = (0..s.input.vertices)
                    .filter(|&i| rings.root(i) == i)
                    .count();
                n + tips + 2 * rings as i64 - 4 * parts as i64
            }
            _ => return,
        };
        if found != expected {
            self.report.add(Violation::Count {
                what: "nodes, with multiplicity",
                found,
                expected,
            });
        }
    }
}
