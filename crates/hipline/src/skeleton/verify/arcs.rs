//! Arcs: the order of their ends, kinds, directions, and where they may start.

use super::{Checker, Violation};
use crate::{
    predicates::{Course, Heading},
    skeleton::{Arc, ArcKind, NodeKind},
    topology::{ArcId, NodeId, VertexId},
};
use hipline_num::Sign;
use std::cmp::Ordering;

/// What the planes of an arc make of it.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Nature {
    /// The faces are on one plane.
    Ghost,
    /// The planes are parallel: an arc of one height.
    Level,
    /// The planes cross; the sign of the turn from the left one to the right one.
    Crossing(Sign),
    /// The faces are those of both sides of one edge, which stand back to back: an upright arc above a terminal.
    BackToBack,
}

impl Checker<'_> {
    /// Checks all arcs.
    pub(super) fn check_arcs(&mut self) {
        let arcs = self.skeleton.arcs.len();
        let mut level = vec![false; arcs];
        self.headings.reserve(arcs + self.figure.edges().len());
        for (a, is_level) in level.iter_mut().enumerate() {
            let arc = self.skeleton.arcs[a];
            let nature = self.nature(&arc);
            *is_level = nature == Nature::Level;
            self.check_kind(ArcId::new(a), nature);
            self.check_ends(ArcId::new(a), nature);
            let heading = self.heading(&arc, nature);
            self.headings.push(heading);
        }
        for e in 0..self.figure.edges().len() {
            let course = Course::Along(crate::predicates::PlaneId(2 * e as u32));
            self.headings.push(self.planes.heading(course));
        }
        self.check_lower_ends(&level);
    }

    fn nature(&self, arc: &Arc) -> Nature {
        let [i, j] = arc.faces.map(|face| self.plane_of(face));
        match self.planes.turn(i, j) {
            Sign::Zero if i.0 ^ j.0 == 1 => Nature::BackToBack,
            // On one plane for now: the edge that will be faster overruns the other; but walls
            // below tilted eaves stand side by side.
            Sign::Zero
                if self.planes.coplanar(i, j)
                    && (self.planes.compare_speeds(i, j).is_eq()
                        || self.planes.stands_still(i) && arc.kind == ArcKind::Ghost) =>
            {
                Nature::Ghost
            }
            Sign::Zero => Nature::Level,
            sign => Nature::Crossing(sign),
        }
    }

    /// The kind follows from the planes: walking up, with the wavefront edge of the left
    /// face coming in and that of the right face going out, a left turn is a ridge.
    fn check_kind(&mut self, id: ArcId, nature: Nature) {
        let arc = self.skeleton.arc(id);
        let [i, j] = arc.faces.map(|f| self.first_plane(self.skeleton.face(f)));
        let expected = match nature {
            Nature::Level | Nature::Crossing(_) if i == j => ArcKind::Crease,
            Nature::Ghost => ArcKind::Ghost,
            Nature::Crossing(Sign::Negative) | Nature::BackToBack => ArcKind::Valley,
            Nature::Level | Nature::Crossing(_) => ArcKind::Ridge,
        };
        let kind = arc.kind;
        if kind != expected
            && !(kind == ArcKind::Crease && nature == Nature::Level && self.is_crease(id))
        {
            self.report.add(Violation::WrongKind { arc: id });
        }
    }

    /// Whether the face on the right starts at the time of the arc, because its edge changes
    /// its speed then. (An arc along which one edge overruns another just then may seem so.)
    fn is_crease(&self, id: ArcId) -> bool {
        let arc = self.skeleton.arc(id);
        let above = self.plane_of(arc.faces[1]);
        let start = self.planes.phases.time_of(above);
        let place = self.places[arc.nodes[0].index()].expect("arcs start at finite nodes");
        start > 0.0 && self.planes.compare_time(&place, start).is_eq()
    }

    fn check_ends(&mut self, id: ArcId, nature: Nature) {
        let arc = *self.skeleton.arc(id);
        let plane = self.plane_of(arc.faces[0]);
        let [from, to] = arc.nodes.map(|n| self.places[n.index()]);
        let from = from.expect("arcs start at finite nodes");
        let Some(to) = to else {
            self.check_direction(id, nature);
            return;
        };
        match (self.planes.compare_times(&from, &to), nature) {
            (Ordering::Less, Nature::Ghost | Nature::Crossing(_) | Nature::BackToBack) => {}
            (Ordering::Equal, Nature::Level) => {
                if self.planes.compare_along(&from, &to, plane).is_eq() {
                    self.report.add(Violation::NoLength { arc: id });
                }
            }
            (Ordering::Equal, _) => self.report.add(Violation::NoLength { arc: id }),
            (Ordering::Less | Ordering::Greater, _) => {
                self.report.add(Violation::NotLater { arc: id })
            }
        }
        if nature == Nature::Ghost && self.planes.compare_along(&from, &to, plane).is_ne() {
            self.report.add(Violation::Slanted { arc: id });
        }
    }

    /// Checks the node at infinity of an unbounded arc.
    fn check_direction(&mut self, id: ArcId, nature: Nature) {
        let arc = *self.skeleton.arc(id);
        let node = arc.nodes[1];
        let [from, to] = arc.nodes.map(|n| *self.skeleton.node(n));
        let NodeKind::Infinite { direction } = to.kind else {
            unreachable!("it has no place")
        };
        let expected = match nature {
            Nature::Level => {
                self.report.add(Violation::NotLater { arc: id });
                return;
            }
            Nature::BackToBack => [0.0, 0.0],
            Nature::Ghost => self
                .planes
                .round_normal_velocity(self.plane_of(arc.faces[0])),
            Nature::Crossing(_) => {
                let pair = arc.faces.map(|face| self.plane_of(face));
                self.planes.round_velocity(self.turning_left(pair))
            }
        };
        if expected.map(f64::to_bits) != direction.map(f64::to_bits) {
            self.report
                .add(Violation::WrongDirection { node, expected });
        }
        let place = [from.x, from.y, f64::INFINITY];
        if place.map(f64::to_bits) != [to.x, to.y, to.time].map(f64::to_bits) {
            self.report.add(Violation::NotRounded {
                node,
                expected: place,
            });
        }
    }

    fn heading(&self, arc: &Arc, nature: Nature) -> Heading {
        let [i, j] = arc.faces.map(|face| self.plane_of(face));
        match nature {
            Nature::Ghost | Nature::BackToBack => self.planes.heading(Course::Normal(i)),
            Nature::Crossing(_) => self
                .planes
                .heading(Course::Moving(self.turning_left([i, j]))),
            Nature::Level => {
                let heading = self.planes.heading(Course::Along(i));
                let [from, to] = arc.nodes.map(|n| self.places[n.index()]);
                match (from, to) {
                    (Some(from), Some(to)) if self.planes.compare_along(&from, &to, i).is_gt() => {
                        heading.reversed()
                    }
                    _ => heading,
                }
            }
        }
    }

    /// The roof has no local minimum, and valleys start at vertices, or (without weights)
    /// where two or more of them end.
    fn check_lower_ends(&mut self, level: &[bool]) {
        for i in 0..self.skeleton.nodes.len() {
            let node = NodeId::new(i);
            let kind = self.skeleton.node(node).kind;
            if self.skeleton.node(node).is_at_infinity() {
                continue;
            }
            let arcs = || {
                self.incidence
                    .arcs(node)
                    .iter()
                    .map(|&a| (ArcId::raw(a), self.skeleton.arc(ArcId::raw(a))))
            };
            if kind == NodeKind::Event {
                let reached = arcs().any(|(id, arc)| arc.nodes[1] == node || level[id.index()]);
                if !reached {
                    self.report.add(Violation::LocalMinimum { node });
                }
            }
            if !self.unweighted {
                continue;
            }
            let ending = arcs()
                .filter(|(_, arc)| arc.kind == ArcKind::Valley && arc.nodes[1] == node)
                .count();
            let starting =
                arcs().find(|(_, arc)| arc.kind == ArcKind::Valley && arc.nodes[0] == node);
            if let (Some((arc, _)), NodeKind::Event) = (starting, kind)
                && ending < 2
            {
                self.report.add(Violation::ValleyFromNothing { arc, node });
            }
        }
    }

    /// The darts of edges that leave each vertex, of edges with a side in the region.
    pub(super) fn edges_at(&self) -> Vec<Vec<u32>> {
        let first = 2 * self.skeleton.arcs.len();
        let mut list = vec![Vec::new(); self.figure.vertices().len()];
        for (e, ends) in self.skeleton.input.edges.iter().enumerate() {
            if self.incidence.covered[2 * e] || self.incidence.covered[2 * e + 1] {
                let [from, to] = ends.map(VertexId::index);
                list[from].push((first + 2 * e) as u32);
                list[to].push((first + 2 * e + 1) as u32);
            }
        }
        list
    }
}
