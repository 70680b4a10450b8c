//! Where the nodes are: recomputed from the planes of the faces around them.

use super::{Checker, Violation};
use crate::{
    predicates::{Bound, Place, PlaneId, Start},
    skeleton::{ArcKind, NodeKind},
    topology::{ArcId, FaceId, NodeId},
};

/// The line that a ghost arc ends on.
#[derive(Clone, Copy)]
enum Line {
    /// The intersection of two planes.
    Pair([PlaneId; 2]),
    /// An arc of one height, at the moment when three planes meet.
    Level([PlaneId; 3]),
}

/// What the planes around a node have in common.
enum Common {
    /// A point.
    Point {
        pair: [PlaneId; 2],
        moment: [PlaneId; 3],
    },
    /// A line: the node must be where a ghost arc ends.
    Line(Line),
    /// Nothing definite.
    Unknown,
}

impl Checker<'_> {
    /// Places every node and checks its coordinates.
    pub(super) fn check_places(&mut self) {
        let nodes = &self.skeleton.nodes;
        self.places = vec![None; nodes.len()];
        let mut feet: Vec<(NodeId, Line)> = Vec::new();
        for (i, node) in nodes.iter().enumerate() {
            let id = NodeId::new(i);
            self.places[i] = match node.kind {
                NodeKind::Infinite { .. } => None,
                NodeKind::Input(v) => Some(Place::Vertex(self.figure.vertices()[v.index()])),
                NodeKind::Event => match self.common(id) {
                    Common::Point { pair, moment } => Some(Place::Event { pair, moment }),
                    Common::Line(line) => {
                        feet.push((id, line));
                        None
                    }
                    Common::Unknown => {
                        self.report.add(Violation::Undetermined { node: id });
                        None
                    }
                },
            };
        }
        for (node, line) in feet {
            let place = self.foot(node, line);
            if place.is_none() {
                self.report.add(Violation::Undetermined { node });
            }
            self.places[node.index()] = place;
        }
        for i in 0..self.skeleton.nodes.len() {
            self.check_node(NodeId::new(i));
        }
    }

    /// The faces around a node, each at least once.
    fn faces_at(&self, node: NodeId) -> impl Iterator<Item = FaceId> + '_ {
        self.incidence
            .arcs(node)
            .iter()
            .flat_map(|&a| self.skeleton.arc(ArcId::raw(a)).faces)
    }

    /// Finds three planes that meet in a point. Taking the first that is not parallel to the
    /// first, then the first that is independent of both, finds them if there are any.
    fn common(&self, node: NodeId) -> Common {
        let mut planes: Vec<PlaneId> = self
            .faces_at(node)
            .map(|face| self.plane_of(face))
            .collect();
        planes.extend(self.closed_terminals(node));
        planes.extend(self.posts(node));
        planes.sort_unstable();
        planes.dedup();
        let Some(&i) = planes.first() else {
            return Common::Unknown;
        };
        let Some(&j) = planes
            .iter()
            .find(|&&j| j != i && !self.planes.turn(i, j).is_zero())
        else {
            return self.level(i, &planes);
        };
        let pair = self.turning_left([i, j]);
        let third = planes
            .iter()
            .find(|&&k| k != i && k != j && self.planes.do_meet([i, j, k]));
        match third {
            Some(&k) => {
                let mut moment = [i, j, k];
                moment.sort_unstable();
                Common::Point { pair, moment }
            }
            None => Common::Line(Line::Pair(pair)),
        }
    }

    /// The planes of terminals that never emitted a wavefront edge, because their edges stood
    /// still, and where an arc from there ends at this node.
    fn closed_terminals(&self, node: NodeId) -> impl Iterator<Item = PlaneId> + '_ {
        self.incidence.arcs(node).iter().filter_map(|&a| {
            let arc = self.skeleton.arc(ArcId::raw(a));
            let NodeKind::Input(vertex) = self.skeleton.node(arc.nodes[0]).kind else {
                return None;
            };
            let [i, j] = arc.faces.map(|face| self.plane_of(face).0);
            let plane = self.terminal_plane(self.terminal_at(vertex)?);
            (i ^ j == 1 && self.planes.stands_still(plane)).then_some(plane)
        })
    }

    /// The posts across tilted eaves at the vertex below this node, if walls meet on the way up from there.
    fn posts(&self, node: NodeId) -> impl Iterator<Item = PlaneId> + '_ {
        let at = self.skeleton.node(node);
        let here = [at.x, at.y].map(f64::to_bits);
        let edges = &self.skeleton.input.edges;
        let vertices = self.figure.vertices();
        // An eave may start at a vertex too; its other end is elsewhere.
        let post = move |wall: PlaneId| {
            let mut ends = edges.get((wall.0 / 2) as usize)?.iter();
            let vertex = ends.find(|v| vertices[v.index()].map(f64::to_bits) == here)?;
            self.planes.post_at(edges, wall, *vertex)
        };
        self.incidence.arcs(node).iter().flat_map(move |&a| {
            let walls = self.skeleton.arc(ArcId::raw(a)).faces;
            let walls = walls.map(|face| self.plane_of(face));
            let stand = walls.iter().all(|&wall| self.planes.stands_still(wall));
            walls
                .map(|wall| post(wall).filter(|_| stand))
                .into_iter()
                .flatten()
        })
    }

    /// The arc of one height between parallel planes. When they meet is no matter of the
    /// third plane, as long as it is not parallel too.
    fn level(&self, i: PlaneId, planes: &[PlaneId]) -> Common {
        let Some(&j) = planes.iter().find(|&&j| !self.planes.coplanar(i, j)) else {
            return Common::Unknown;
        };
        let lines = self.figure.edges().len() + self.terminals.len();
        let third = (0..lines)
            .map(|l| PlaneId(2 * l as u32))
            .find(|&k| !self.planes.turn(i, k).is_zero());
        match third {
            Some(k) if self.planes.do_meet([i, j, k]) => {
                let mut moment = [i, j, k];
                moment.sort_unstable();
                Common::Line(Line::Level(moment))
            }
            _ => Common::Unknown,
        }
    }

    /// The end of an arc along which an edge overruns another one on the same plane, whose
    /// speed will be less: it has the time of the other end.
    fn end_of_level(&self, node: NodeId, line: &Line) -> Option<Place> {
        let &Line::Pair(pair) = line else {
            return None;
        };
        self.incidence.arcs(node).iter().find_map(|&a| {
            let arc = self.skeleton.arc(ArcId::raw(a));
            let [i, j] = arc.faces.map(|face| self.plane_of(face));
            if arc.kind == ArcKind::Ghost || !self.planes.coplanar(i, j) {
                return None;
            }
            let other = arc.nodes[usize::from(arc.nodes[0] == node)];
            match self.places[other.index()]? {
                Place::Event { moment, .. } => Some(Place::Event { pair, moment }),
                _ => None,
            }
        })
    }

    /// The place where a ghost arc ends on a line; nothing if none that starts at a vertex or an
    /// event, as all do, ever reaches it.
    fn foot(&self, node: NodeId, line: Line) -> Option<Place> {
        if let Some(place) = self.end_of_level(node, &line) {
            return Some(place);
        }
        self.incidence.arcs(node).iter().find_map(|&a| {
            let arc = self.skeleton.arc(ArcId::raw(a));
            if arc.kind != ArcKind::Ghost || arc.nodes[1] != node {
                return None;
            }
            let plane = self.plane_of(arc.faces[0]);
            let start = match self.places[arc.nodes[0].index()]? {
                Place::Vertex(v) => Start::Vertex(v),
                Place::Event { pair, moment } => Start::Event { pair, moment },
                Place::Foot { .. } | Place::At { .. } | Place::On { .. } => return None,
            };
            let bound = match line {
                Line::Pair(pair) if self.planes.drift(pair, plane).is_zero() => return None,
                Line::Pair(pair) => Bound::Pair(pair),
                Line::Level(moment) => Bound::Level(moment),
            };
            Some(Place::Foot {
                start,
                plane,
                bound,
            })
        })
    }

    /// Checks a node's coordinates, and that it is on all planes around it.
    fn check_node(&mut self, id: NodeId) {
        let node = *self.skeleton.node(id);
        let Some(place) = self.places[id.index()] else {
            return;
        };
        let expected = self.planes.round(&place);
        if expected.map(f64::to_bits) != [node.x, node.y, node.time].map(f64::to_bits) {
            self.report
                .add(Violation::NotRounded { node: id, expected });
        }
        let at_zero = expected[2] <= 0.0;
        if at_zero && node.kind == NodeKind::Event && self.unweighted {
            self.report.add(Violation::TooEarly { node: id });
        }
        let mut faces: Vec<FaceId> = self.faces_at(id).collect();
        faces.sort_unstable();
        faces.dedup();
        for face in faces {
            if !self.is_on(&place, id, face)
                && !self.planes.ahead(&place, self.plane_of(face)).is_zero()
            {
                self.report.add(Violation::OffPlane { node: id, face });
            }
        }
    }

    /// Whether a place is on the plane of a face by its definition.
    fn is_on(&self, place: &Place, node: NodeId, face: FaceId) -> bool {
        let plane = self.plane_of(face);
        match place {
            Place::Vertex(_) => {
                let edge = self.skeleton.input.edges[self.skeleton.face(face).edge.index()];
                let at = edge.map(|v| v.index() == node.index());
                match self.skeleton.face(face).side {
                    super::Side::Start => at[0],
                    super::Side::End => at[1],
                    _ => at[0] || at[1],
                }
            }
            Place::Event { moment, .. } => moment.contains(&plane),
            Place::At { pair, .. }
            | Place::On { pair, .. }
            | Place::Foot {
                bound: Bound::Pair(pair),
                ..
            } => pair.contains(&plane),
            // Of the planes of the moment, one only tells when; the others are asked.
            Place::Foot {
                plane: own,
                bound: Bound::Level(_) | Bound::Time(_),
                ..
            } => *own == plane,
        }
    }
}
