//! Ids, lists and incidences: everything that can be checked without a coordinate.

use super::{Checker, Violation, dart};
use crate::{
    skeleton::{Face, NodeKind, Region, Side},
    topology::{ArcId, EdgeId, FaceId, NodeId, VertexId},
};

/// What the walk around all faces finds.
#[derive(Default)]
pub(super) struct Incidence {
    /// The darts between the corners of the boundaries: `steps[i]` leads from `corners[i]`
    /// to the corner after it. [`dart::JUMP`] leads from infinity to infinity.
    pub steps: Vec<u32>,
    /// For each dart, the next one counterclockwise around the node it leaves.
    pub after: Vec<u32>,
    /// The arcs at node `i` are `arcs_at[first_at[i]..first_at[i + 1]]`.
    pub first_at: Vec<u32>,
    pub arcs_at: Vec<u32>,
    /// For each side of each edge, left then right: whether it is in the region.
    pub covered: Vec<bool>,
}

impl Incidence {
    pub(super) fn arcs(&self, node: NodeId) -> &[u32] {
        let [from, to] = [0, 1].map(|k| self.first_at[node.index() + k] as usize);
        &self.arcs_at[from..to]
    }
}

impl Checker<'_> {
    /// Checks the structure. Nothing else can be asked before this finds nothing wrong.
    pub(super) fn check_structure(&mut self) {
        self.check_input();
        self.check_lists();
        if !self.report.is_empty() {
            return;
        }
        self.check_faces();
        self.check_arcs_at_nodes();
        if self.report.is_empty() {
            self.check_boundaries();
        }
    }

    fn check_input(&mut self) {
        let (input, figure) = (&self.skeleton.input, self.figure);
        let same = input.vertices == figure.vertices().len()
            && input.terminals == figure.terminals()
            && input.edges.len() == figure.edges().len()
            && input
                .edges
                .iter()
                .zip(figure.edges())
                .all(|(a, b)| *a == [b.from, b.to]);
        if !same || self.skeleton.nodes.len() < input.vertices {
            self.report.add(Violation::OtherFigure);
            return;
        }
        if self.skeleton.region == Region::Auto {
            self.report.add(Violation::IndefiniteRegion);
        }
        for (i, node) in self.skeleton.nodes.iter().enumerate() {
            let should = (i < input.vertices).then(|| VertexId::new(i));
            let is = if let NodeKind::Input(v) = node.kind {
                Some(v)
            } else {
                None
            };
            if should != is {
                self.report.add(Violation::WrongVertex {
                    node: NodeId::new(i),
                });
            }
        }
    }

    fn check_lists(&mut self) {
        let s = self.skeleton;
        let mut cycle = 0;
        for (i, face) in s.faces.iter().enumerate() {
            let [first, end] = face.cycles;
            let face = FaceId::new(i);
            if first != cycle || end <= first || end as usize >= s.cycles.len() {
                self.report.add(Violation::BrokenLists { face });
                return;
            }
            for k in first as usize..end as usize {
                let [from, to] = [s.cycles[k] as usize, s.cycles[k + 1] as usize];
                if from >= to || to > s.corners.len() || (k == 0 && from != 0) {
                    self.report.add(Violation::BrokenLists { face });
                    return;
                }
                for &node in &s.corners[from..to] {
                    if node.index() >= s.nodes.len() {
                        self.report.add(Violation::NoSuchCorner { face, node });
                    }
                }
            }
            cycle = end;
        }
        let ends_well = s.cycles.len() == cycle as usize + 1
            && s.cycles
                .last()
                .is_some_and(|&end| end as usize == s.corners.len());
        if !ends_well {
            self.report.add(Violation::BrokenLists {
                face: FaceId::new(s.faces.len()),
            });
        }
        for (i, arc) in s.arcs.iter().enumerate() {
            let known = arc.nodes.iter().all(|n| n.index() < s.nodes.len())
                && arc.faces.iter().all(|f| f.index() < s.faces.len());
            if !known {
                self.report.add(Violation::NoSuchEnd { arc: ArcId::new(i) });
            }
        }
    }

    /// The sides of the edges that are in the region, in the figure's triangulation.
    fn find_covered(&mut self) {
        let mesh = self.figure.mesh();
        let edges = self.figure.edges();
        let region = self.skeleton.region;
        let mut covered = vec![region == Region::Both; 2 * edges.len()];
        let mut mark = |edge: u32, from: u32, inside: bool| {
            let right = edges[edge as usize].from.index() != from as usize;
            let kept = match region {
                Region::Interior => inside,
                Region::Exterior => !inside,
                Region::Auto | Region::Both => true,
            };
            covered[2 * edge as usize + usize::from(right)] = kept;
        };
        for (t, across) in mesh.across.iter().enumerate() {
            for (k, side) in across.iter().enumerate() {
                if let Some(edge) = side.edge {
                    mark(edge, mesh.corners[t][(k + 1) % 3], mesh.inside[t]);
                }
            }
        }
        for hull in &mesh.hull {
            if let Some(edge) = hull.across.edge {
                mark(edge, hull.from, false);
            }
        }
        self.incidence.covered = covered;
    }

    /// For each end of each edge, whether a modified skeleton has a cap there that is in the region.
    fn shown_caps(&self) -> Vec<bool> {
        let mut shown = vec![false; 2 * self.figure.edges().len()];
        for pair in self.caps() {
            // The sector is on the left of the first edge, seen from the vertex.
            let (edge, at_end) = pair[0];
            if self.incidence.covered[2 * edge + usize::from(at_end)] {
                for (edge, at_end) in pair {
                    shown[2 * edge + usize::from(at_end)] = true;
                }
            }
        }
        shown
    }

    /// One face for each side of each edge and each terminal or cap in the region, in order.
    fn check_faces(&mut self) {
        self.find_covered();
        let caps = self.shown_caps();
        let mut expected = Vec::with_capacity(self.skeleton.faces.len());
        for (e, edge) in self.figure.edges().iter().enumerate() {
            let id = EdgeId::new(e);
            let [left, right] = [0, 1].map(|side| self.incidence.covered[2 * e + side]);
            let mut add = |is_there: bool, side: Side| {
                if is_there {
                    expected.push((id, side));
                }
            };
            add(left, Side::Left);
            add(right, Side::Right);
            // Both sides of an edge meet at a terminal, so both are covered or none is. One
            // that stands still emits a wavefront edge later, or never.
            let emits = |vertex| {
                self.terminal_at(vertex)
                    .is_some_and(|i| !self.planes.stands_still(self.terminal_plane(i)))
            };
            add(left && emits(edge.from) || caps[2 * e], Side::Start);
            add(left && emits(edge.to) || caps[2 * e + 1], Side::End);
        }
        let (mut i, mut j) = (0, 0);
        let faces = &self.skeleton.faces;
        while i < faces.len() || j < expected.len() {
            // Faces of later phases may be there or not, in several pieces, or none; and a
            // terminal that stands still emits a wavefront edge if its edge was overrun.
            if let Some(face) = faces.get(i)
                && (face.phase > 0 || self.is_still_terminal(face))
                && self.has_phase(face)
            {
                i += 1;
                continue;
            }
            let found = faces.get(i).map(|face| (face.edge, face.side));
            let wanted = expected.get(j).copied();
            if found == wanted {
                (i, j) = (i + 1, j + 1);
            } else if let (Some((edge, side)), true) =
                (wanted, found.is_none_or(|f| wanted < Some(f)))
            {
                self.report.add(Violation::MissingFace { edge, side });
                j += 1;
            } else {
                self.report.add(Violation::ExtraFace {
                    face: FaceId::new(i),
                });
                i += 1;
            }
        }
    }

    /// Whether a face is that of a terminal that stands still at first.
    fn is_still_terminal(&self, face: &Face) -> bool {
        let edge = &self.figure.edges()[face.edge.index()];
        let tip = match face.side {
            Side::Start => edge.from,
            Side::End => edge.to,
            Side::Left | Side::Right => return false,
        };
        self.terminal_at(tip)
            .is_some_and(|i| self.planes.stands_still(self.terminal_plane(i)))
    }

    /// Whether a face of a later phase belongs to a side of an edge in the region whose speed
    /// changes as often.
    fn has_phase(&self, face: &Face) -> bool {
        let edge = &self.figure.edges()[face.edge.index()];
        let covered = |side: usize| self.incidence.covered[2 * face.edge.index() + side];
        let is_there = match face.side {
            Side::Left => covered(0),
            Side::Right => covered(1),
            Side::Start => covered(0) && self.terminal_at(edge.from).is_some(),
            Side::End => covered(0) && self.terminal_at(edge.to).is_some(),
        };
        is_there && self.plane(face).is_some()
    }

    /// Which arcs are at which nodes, and how many.
    fn check_arcs_at_nodes(&mut self) {
        let s = self.skeleton;
        let mut first = vec![0_u32; s.nodes.len() + 1];
        for arc in &s.arcs {
            for node in arc.nodes {
                first[node.index() + 1] += 1;
            }
        }
        for i in 0..s.nodes.len() {
            first[i + 1] += first[i];
        }
        let mut fill = first.clone();
        let mut list = vec![0; 2 * s.arcs.len()];
        for (a, arc) in s.arcs.iter().enumerate() {
            for node in arc.nodes {
                list[fill[node.index()] as usize] = a as u32;
                fill[node.index()] += 1;
            }
            let id = ArcId::new(a);
            let [from, to] = arc.nodes.map(|n| s.node(n).kind);
            // With weights, an edge may be overrun at time zero, along an arc between vertices.
            let overrun = !self.unweighted && matches!(from, NodeKind::Input(_));
            if matches!(from, NodeKind::Infinite { .. })
                || matches!(to, NodeKind::Input(_)) && !overrun
            {
                self.report.add(Violation::WrongWay { arc: id });
            }
            if arc.faces[0] == arc.faces[1] && self.unweighted {
                self.report.add(Violation::OneFace { arc: id });
            }
        }
        for (i, node) in s.nodes.iter().enumerate() {
            let degree = (first[i + 1] - first[i]) as usize;
            let fits = match node.kind {
                NodeKind::Input(_) => true,
                NodeKind::Event => degree >= 3,
                NodeKind::Infinite { .. } => degree == 1,
            };
            if !fits {
                self.report.add(Violation::Degree {
                    node: NodeId::new(i),
                    degree,
                });
            }
        }
        (self.incidence.first_at, self.incidence.arcs_at) = (first, list);
    }

    /// The arcs by their ends.
    fn arcs_by_ends(&mut self) -> Vec<([u32; 2], u32)> {
        let mut list: Vec<([u32; 2], u32)> = self
            .skeleton
            .arcs
            .iter()
            .enumerate()
            .map(|(a, arc)| {
                let mut ends = arc.nodes.map(|n| n.index() as u32);
                ends.sort_unstable();
                (ends, a as u32)
            })
            .collect();
        list.sort_unstable();
        // Where edges stand still, upright faces may lie back to back.
        let may_repeat = self.planes.has_upright();
        for pair in list.windows(2) {
            if pair[0].0 == pair[1].0 && !may_repeat {
                let [first, second] = [0, 1].map(|k| ArcId::raw(pair[k].1));
                self.report.add(Violation::DoubleArc { first, second });
            }
        }
        list
    }

    /// Walks around all faces.
    fn check_boundaries(&mut self) {
        let s = self.skeleton;
        let by_ends = self.arcs_by_ends();
        let arcs = s.arcs.len();
        let edges = s.input.edges.len();
        let mut uses = vec![0_u8; 2 * arcs];
        self.incidence.steps = vec![dart::JUMP; s.corners.len()];
        self.incidence.after = vec![dart::NONE; 2 * (arcs + edges)];
        for f in 0..s.faces.len() {
            let id = FaceId::new(f);
            let [first, end] = s.faces[f].cycles;
            for cycle in first..end {
                let base = (cycle == first).then(|| self.base(id)).flatten();
                self.walk(id, cycle as usize, base, &by_ends, &mut uses);
            }
            self.check_base(id);
        }
        for (d, &count) in uses.iter().enumerate() {
            if count != 1 {
                let face = s.arcs[d / 2].faces[d % 2];
                self.report.add(Violation::NotOnce {
                    arc: ArcId::new(d / 2),
                    face,
                });
            }
        }
    }

    /// The base edge's dart; terminals have none.
    fn base(&self, face: FaceId) -> Option<u32> {
        let face = self.skeleton.face(face);
        if face.phase > 0 {
            return None;
        }
        let dart = (2 * (self.skeleton.arcs.len() + face.edge.index())) as u32;
        match face.side {
            Side::Left => Some(dart),
            Side::Right => Some(dart + 1),
            Side::Start | Side::End => None,
        }
    }

    /// Whether the boundary starts with the ends of the edge, or the terminal.
    fn check_base(&mut self, face: FaceId) {
        let (Side::Start | Side::End) = self.skeleton.face(face).side else {
            return;
        };
        let record = self.skeleton.face(face);
        if record.phase > 0 || self.is_still_terminal(record) {
            return;
        }
        let edge = self.skeleton.input.edges[self.skeleton.face(face).edge.index()];
        let tip = edge[usize::from(self.skeleton.face(face).side == Side::End)];
        if self.skeleton.boundary(face)[0].index() != tip.index() {
            self.report.add(Violation::NoBase { face });
        }
    }

    /// Walks around one boundary.
    fn walk(
        &mut self,
        face: FaceId,
        cycle: usize,
        base: Option<u32>,
        by_ends: &[([u32; 2], u32)],
        uses: &mut [u8],
    ) {
        let s = self.skeleton;
        let range = s.cycles[cycle] as usize..s.cycles[cycle + 1] as usize;
        let corners = &s.corners[range.clone()];
        let at_infinity = |n: NodeId| s.node(n).is_at_infinity();
        for (i, &from) in corners.iter().enumerate() {
            let to = corners[(i + 1) % corners.len()];
            let step = &mut self.incidence.steps[range.start + i];
            if let (0, Some(base)) = (i, base) {
                let mut ends = s.input.edges[(base as usize - 2 * s.arcs.len()) / 2];
                if base % 2 == 1 {
                    ends.swap(0, 1);
                }
                if ends.map(VertexId::index) != [from, to].map(NodeId::index) {
                    self.report.add(Violation::NoBase { face });
                }
                *step = base;
                continue;
            }
            if at_infinity(from) && at_infinity(to) && from != to {
                continue;
            }
            let mut ends = [from, to].map(|n| n.index() as u32);
            ends.sort_unstable();
            let at = by_ends.partition_point(|entry| entry.0 < ends);
            let same = by_ends[at..].iter().take_while(|entry| entry.0 == ends);
            let mut same = same.map(|entry| ArcId::raw(entry.1));
            let Some(first) = same.clone().next() else {
                self.report.add(Violation::NoArc { face, from, to });
                continue;
            };
            let is_ours = |arc: &ArcId| {
                let arc = s.arc(*arc);
                arc.faces[usize::from(arc.nodes[0] != from)] == face
            };
            let arc = same.find(is_ours).unwrap_or(first);
            let backward = usize::from(s.arc(arc).nodes[0] != from);
            let dart = 2 * arc.index() + backward;
            *step = dart as u32;
            uses[dart] = uses[dart].saturating_add(1);
            if s.arc(arc).faces[backward] != face {
                self.report.add(Violation::WrongSide { face, arc });
            }
        }
        self.link(range);
    }

    /// Around the node at each corner, the dart that arrives there comes, reversed, after the
    /// one that leaves: the face lies between them. All of infinity is one node.
    fn link(&mut self, range: std::ops::Range<usize>) {
        let steps = &self.incidence.steps[range];
        let mut last = steps.iter().rev().copied().find(|&step| step != dart::JUMP);
        for &step in steps {
            if step == dart::JUMP {
                continue;
            }
            if let Some(arriving) = last {
                self.incidence.after[step as usize] = dart::twin(arriving);
            }
            last = Some(step);
        }
    }
}
