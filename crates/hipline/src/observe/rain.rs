//! The path of a drop: steepest descent on the surface.
//!
//! On a face a drop runs straight down, perpendicular to the face's edge, until it comes to a
//! border of the face. On the edge it has arrived. At an arc there are two cases: if going down on the face beyond leads away from
//! the arc, the drop crosses it; else the arc is a valley, and the drop runs along it to its lower
//! end. At a node it takes the steepest way there is.
//!
//! Without weights drops never cross an arc: with unit normals m and n, where going down on f leads to g, going down on
//! g leads back, because m n < 1. So a drop stays on the borders of its face, and ends on the
//! face's own edge or its ends: Lemma 6 of Aichholzer and Aurenhammer (1996).
//!
//! There are no pits as long as all speeds are positive: the wavefront comes to a point from a
//! neighbour that it reached before.
//!
//! Which way a drop goes is decided exactly, from the planes. A drop that crosses an arc, which takes
//! weights, goes on from the f64 numbers nearest to the crossing: its definition would grow with every crossing.

use super::{
    Index, NoAnswer,
    plan::{Border, Ground, Plan, Query},
};
use crate::{
    predicates::{Spot, Way},
    skeleton::{Arc, ArcKind, NodeKind},
    topology::{ArcId, EdgeId, FaceId, NodeId, VertexId},
};
use hipline_num::Sign;
use std::cmp::Ordering;

/// Where a drop ends.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum Ending {
    /// Inside an input edge.
    Edge(EdgeId),
    /// At an input vertex.
    Vertex(VertexId),
    /// At a node from which no way leads down. With positive speeds there is none.
    Pit(NodeId),
}

/// The path of a drop.
#[derive(Debug, Clone, PartialEq)]
pub struct Drop {
    /// The corners of the path from the start down to the end: x, y, and time. Each number is
    /// the nearest f64.
    pub points: Vec<[f64; 3]>,
    /// The face that it starts on. Where it starts at a node, one that borders on its way.
    pub face: FaceId,
    /// Where it ends.
    pub ending: Ending,
}

impl Drop {
    /// The length of the path in the plan, in input units, up to rounding.
    #[must_use]
    pub fn length(&self) -> f64 {
        self.points
            .windows(2)
            .map(|p| super::terrain::distance([p[0][0], p[0][1]], [p[1][0], p[1][1]]))
            .sum()
    }
}

/// Where a drop is.
enum Stage {
    /// In a face, having come over a segment.
    Face(FaceId, [f64; 2], Option<u32>),
    /// At a node, in a face that leads down from it.
    Leaving(FaceId, u32),
    Node(NodeId),
}

/// What a drop comes to.
enum Next {
    Stage(Stage),
    End(Ending),
}

impl Index<'_> {
    /// The path of a drop that falls on a point.
    ///
    /// ```
    /// use hipline::{Polygon, observe::{Ending, Index}};
    ///
    /// let polygon = Polygon::new([vec![[0.0, 0.0], [8.0, 0.0], [8.0, 4.0], [0.0, 4.0]]])?;
    /// let skeleton = polygon.skeleton();
    /// let drop = Index::new(&skeleton, polygon.figure()).path([3.0, 1.5])?;
    /// assert_eq!(drop.points, [[3.0, 1.5, 1.5], [3.0, 0.0, 0.0]]);
    /// assert!(matches!(drop.ending, Ending::Edge(_)));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Complexity
    /// O(log n) expected, and the size of the faces on the way.
    ///
    /// # Errors
    /// As [`locate`](Self::locate), and with weights, rounding that leads in a circle.
    pub fn path(&self, point: [f64; 2]) -> Result<Drop, NoAnswer> {
        let answer = self.locate(point)?;
        let mut points = vec![[point[0], point[1], answer.time]];
        let mut face = answer.face;
        let mut stage = Stage::Face(face, point, None);
        // Each step goes down, but for the rounding of crossings; so there is a limit.
        let most = 4 * (self.plan.segments.len() + 4);
        let mut ending = None;
        for _ in 0..most {
            let (next, at) = match stage {
                Stage::Face(face, from, barred) => {
                    self.down(face, &Origin::Point(Query::new(from)), barred)
                }
                Stage::Leaving(face, position) => {
                    self.down(face, &Origin::Position(position), None)
                }
                Stage::Node(node) => {
                    let (next, on) = self.at_node(node, face);
                    if points.len() == 1 {
                        face = on;
                    }
                    (next, None)
                }
            };
            let node = match next {
                Next::Stage(Stage::Node(node)) => Some(node),
                _ => None,
            };
            if let Some(node) = node.map(|n| self.skeleton().node(n)) {
                push(&mut points, at);
                push(&mut points, Some([node.x, node.y, node.time]));
            } else {
                push(&mut points, at);
            }
            match next {
                Next::End(end) => {
                    ending = Some(end);
                    break;
                }
                Next::Stage(next) => stage = next,
            }
        }
        let ending = ending.ok_or(NoAnswer::Lost(point[0], point[1]))?;
        Ok(Drop {
            points,
            face,
            ending,
        })
    }

    /// Straight down in a face, and where that leads to.
    fn down(&self, face: FaceId, from: &Origin, barred: Option<u32>) -> (Next, Option<[f64; 3]>) {
        let plane = self.plan.lift.plane(face);
        let planes = self.plan.planes();
        let Some((segment, node)) = self.exit(face, from, barred) else {
            // Rounding has put a crossing beside the face: the nearest corner is below it.
            let node = self.nearest_corner(face, from);
            return (Next::Stage(Stage::Node(node)), None);
        };
        if let Some(node) = node {
            return (Next::Stage(Stage::Node(node)), None);
        }
        let line = &self.plan.segments[segment as usize];
        let spot = from.spot(self);
        let landing = planes.round_landing(spot, plane, Plan::track(line));
        let next = match (line.border, self.beyond(segment, face)) {
            (Border::Edge(edge) | Border::Wall(edge), _) => Next::End(Ending::Edge(edge)),
            (Border::Arc(arc), Ground::Face(other)) => {
                if self.crosses(arc, face, other, segment) {
                    let [x, y, _] = landing;
                    Next::Stage(Stage::Face(other, [x, y], Some(segment)))
                } else {
                    Next::Stage(Stage::Node(self.skeleton().arc(arc).nodes[0]))
                }
            }
            (border, beyond) => unreachable!("{face} has {border:?} and {beyond:?} below it"),
        };
        (next, Some(landing))
    }

    /// Whether a drop that comes from a face to an arc goes on in the face beyond.
    fn crosses(&self, arc: ArcId, from: FaceId, to: FaceId, segment: u32) -> bool {
        let [f, _] = self.skeleton().arc(arc).faces;
        let [p, q] = [from, to].map(|face| self.plan.lift.plane(face));
        // Of T_f - T_g, the time on the arc's first face less that on its second one.
        let gain = self.plan.planes().downhill_gain(p, q);
        let gain = if from == f { gain } else { -gain };
        // The side of the face beyond, in the sense of the arc's track.
        let line = &self.plan.segments[segment as usize];
        let there = line.sense(self.side_of_face(segment, to));
        gain == there
    }

    /// The segment below a point of a face, straight down: through its inside, or through the node
    /// that comes second.
    fn exit(
        &self,
        face: FaceId,
        from: &Origin,
        barred: Option<u32>,
    ) -> Option<(u32, Option<NodeId>)> {
        let plane = self.plan.lift.plane(face);
        let spot = from.spot(self);
        let along = |position: u32| {
            self.plan
                .planes()
                .compare_spots_along(self.spot(position), spot, plane)
        };
        let mut best: Option<(u32, Option<u32>)> = None;
        for &segment in self.around(face) {
            let line = &self.plan.segments[segment as usize];
            if Some(segment) == barred || from.is_end_of(line.ends) || line.border == Border::Last {
                continue;
            }
            // The face is above the segment in the sense of its edge if the segment goes forward
            // with the face on its left.
            let upward = self.side_of_face(segment, face).is_positive();
            let [start, end] = if upward {
                line.ends
            } else {
                [line.ends[1], line.ends[0]]
            };
            let [a, b] = [start, end].map(along);
            if a.is_gt() || b.is_lt() || a == b {
                continue;
            }
            let side = from.side(self, segment);
            if side == -self.side_of_face(segment, face) {
                continue;
            }
            let through = if a.is_eq() {
                Some(start)
            } else {
                b.is_eq().then_some(end)
            };
            if best.is_none_or(|(other, _)| self.is_higher(segment, other, face)) {
                best = Some((segment, through));
            }
        }
        let (segment, through) = best?;
        let node = through.and_then(|p| self.plan.positions[p as usize].node);
        Some((segment, node))
    }

    /// Of two segments below a point of a face, whether the first is nearer to it: they do not
    /// cross, so where both are, the end of one tells.
    fn is_higher(&self, segment: u32, other: u32, face: FaceId) -> bool {
        let plane = self.plan.lift.plane(face);
        let line = |s: u32| &self.plan.segments[s as usize];
        let inside = |position: u32, s: u32| {
            let [a, b] = line(s).ends.map(|end| {
                let (p, q) = (self.spot(position), self.spot(end));
                self.plan.planes().compare_spots_along(p, q, plane)
            });
            a != b || a.is_eq()
        };
        for end in line(segment).ends {
            let side = self.plan.side_of(line(other), end);
            if inside(end, other) && !side.is_zero() {
                return side == self.side_of_face(other, face);
            }
        }
        for end in line(other).ends {
            let side = self.plan.side_of(line(segment), end);
            if inside(end, segment) && !side.is_zero() {
                return side != self.side_of_face(segment, face);
            }
        }
        false
    }

    fn nearest_corner(&self, face: FaceId, from: &Origin) -> NodeId {
        let [x, y] = from.point(self);
        let distance = |&n: &NodeId| {
            let node = self.skeleton().node(n);
            super::terrain::distance([x, y], [node.x, node.y])
        };
        let cycles =
            std::iter::once(self.skeleton().boundary(face)).chain(self.skeleton().holes(face));
        let corners = cycles.flatten().copied();
        let finite = corners.filter(|&n| self.skeleton().node(n).time.is_finite());
        let nearest = finite.min_by(|a, b| distance(a).total_cmp(&distance(b)));
        nearest.unwrap_or_else(|| panic!("{face} has no corner"))
    }

    /// The steepest way down from a node, and a face that it is on or borders on: of equally
    /// steep ones, that of a given face.
    fn at_node(&self, node: NodeId, own: FaceId) -> (Next, FaceId) {
        let skeleton = self.skeleton();
        if let NodeKind::Input(vertex) = skeleton.node(node).kind {
            let at = self.faces_at(node);
            let on = at.iter().copied().find(|&face| face == own);
            return (
                Next::End(Ending::Vertex(vertex)),
                on.or(at.first().copied()).unwrap_or(own),
            );
        }
        let lift = &self.plan.lift;
        let mut best: Option<(Way, Stage, FaceId)> = None;
        let mut offer = |way: Way, stage: Stage, on: FaceId| {
            let is_better = best.as_ref().is_none_or(|&(other, _, before)| {
                match self.plan.planes().compare_slopes(way, other) {
                    Ordering::Greater => true,
                    Ordering::Equal => on == own && before != own,
                    Ordering::Less => false,
                }
            });
            if is_better {
                best = Some((way, stage, on));
            }
        };
        for face in self.faces_at(node) {
            let position = self.number_of(node);
            if self.leads_down(face, node, position) {
                let way = Way::Plane(lift.plane(face));
                offer(way, Stage::Leaving(face, position), face);
            }
        }
        for arc in self.arcs_down(node) {
            let Arc { nodes, faces, .. } = *skeleton.arc(arc);
            let on = if faces.contains(&own) { own } else { faces[0] };
            offer(Way::Along(lift.pair(arc)), Stage::Node(nodes[0]), on);
        }
        match best {
            Some((_, stage, on)) => (Next::Stage(stage), on),
            None => (Next::End(Ending::Pit(node)), own),
        }
    }

    fn segments_at(&self, node: NodeId) -> &[u32] {
        self.at(self.number_of(node))
    }

    fn faces_at(&self, node: NodeId) -> Vec<FaceId> {
        let segments = self.segments_at(node).iter();
        let grounds = segments.flat_map(|&s| {
            let segment = &self.plan.segments[s as usize];
            [segment.above, segment.below]
        });
        let mut faces: Vec<FaceId> = grounds
            .filter_map(|ground| match ground {
                Ground::Face(face) => Some(face),
                _ => None,
            })
            .collect();
        faces.sort_unstable();
        faces.dedup();
        faces
    }

    /// The arcs that come up to a node between planes that are not parallel.
    fn arcs_down(&self, node: NodeId) -> Vec<ArcId> {
        let arcs = self.segments_at(node).iter().filter_map(|&s| self.arc(s));
        arcs.filter(|&id| {
            let arc = self.skeleton().arc(id);
            let [f, g] = arc.faces.map(|face| self.plan.lift.plane(face));
            arc.kind != ArcKind::Ghost
                && arc.nodes[1] == node
                && !self.plan.planes().turn(f, g).is_zero()
        })
        .collect()
    }

    /// Whether straight down from a node of a face is inside of the face, or on its border.
    fn leads_down(&self, face: FaceId, node: NodeId, position: u32) -> bool {
        let skeleton = self.skeleton();
        let cycles = std::iter::once(skeleton.boundary(face)).chain(skeleton.holes(face));
        for cycle in cycles {
            for (i, &at) in cycle.iter().enumerate() {
                if at != node {
                    continue;
                }
                let before = cycle[(i + cycle.len() - 1) % cycle.len()];
                let after = cycle[(i + 1) % cycle.len()];
                if self.is_down_between(face, position, after, before) {
                    return true;
                }
            }
        }
        false
    }

    /// Whether, turning counterclockwise at a position from the next corner of a face to the one
    /// before, one passes straight down. Angles are counted from there: the direction of the
    /// edge is left of it.
    fn is_down_between(&self, face: FaceId, position: u32, after: NodeId, before: NodeId) -> bool {
        let plane = self.plan.lift.plane(face);
        let planes = self.plan.planes();
        let [after, before] = [after, before].map(|n| self.number_of(n));
        let quarter = |corner: u32| {
            let (p, q) = (self.spot(corner), self.spot(position));
            match planes.compare_spots_along(p, q, plane) {
                Ordering::Greater => 1,
                Ordering::Less => 3,
                Ordering::Equal if self.is_lower(corner, position) => 0,
                Ordering::Equal => 2,
            }
        };
        let [first, last] = [after, before].map(quarter);
        if first == 0 || last == 0 {
            return true;
        }
        if first != last {
            return last < first;
        }
        // Both on one side: is the next corner further round than the one before?
        let side = self.at(position).iter().find_map(|&s| {
            let segment = &self.plan.segments[s as usize];
            let [a, b] = segment.ends;
            let side = self.plan.side_of(segment, after);
            match (a == position, b == position) {
                (true, _) if b == before => Some(side),
                (_, true) if a == before => Some(-side),
                _ => None,
            }
        });
        side.is_some_and(Sign::is_positive)
    }

    fn is_lower(&self, p: u32, q: u32) -> bool {
        let [p, q] = [p, q].map(|k| &self.plan.positions[k as usize]);
        // What is at the end of time is the higher one.
        match (p.node, q.node) {
            (Some(_), Some(_)) => self.plan.planes().compare_times(&p.place, &q.place).is_lt(),
            (first, _) => first.is_some(),
        }
    }
}

/// Where straight down starts.
enum Origin {
    Point(Query),
    Position(u32),
}

impl Origin {
    fn spot<'a>(&'a self, index: &'a Index) -> Spot<'a> {
        match self {
            Self::Point(query) => Spot::Station(query.station(index.plan.planes())),
            Self::Position(position) => index.spot(*position),
        }
    }

    fn point(&self, index: &Index) -> [f64; 2] {
        match self {
            Self::Point(query) => query.point,
            Self::Position(position) => index.plan.positions[*position as usize].point,
        }
    }

    fn side(&self, index: &Index, segment: u32) -> Sign {
        let segment = &index.plan.segments[segment as usize];
        match self {
            Self::Point(query) => index.plan.side(segment, query),
            Self::Position(position) => index.plan.side_of(segment, *position),
        }
    }

    fn is_end_of(&self, ends: [u32; 2]) -> bool {
        matches!(self, Self::Position(position) if ends.contains(position))
    }
}

/// Adds a corner, unless it is the last one again.
fn push(points: &mut Vec<[f64; 3]>, point: Option<[f64; 3]>) {
    let Some(point) = point else { return };
    let bits = |p: &[f64; 3]| [p[0].to_bits(), p[1].to_bits()];
    if points.last().is_none_or(|last| bits(last) != bits(&point)) {
        points.push(point);
    }
}
