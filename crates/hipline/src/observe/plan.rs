//! The borders of the faces as segments of the plan: what a search structure is built over.
//!
//! Every question about a border is asked of the planes that define it, so the segments meet in
//! their ends only, whatever rounding has done to the coordinates of the nodes. Unbounded arcs are
//! cut off at a time so late that nobody asks for what comes after it, and the wavefront at that
//! time closes the faces.

use super::standing::{Standing, add_clusters, has_no_area};
use crate::{
    input::Figure,
    lift::Lift,
    predicates::{Place, Planes, Spot, Station, Track, rough_side},
    skeleton::{ArcKind, Region, Side, Skeleton},
    topology::{ArcId, EdgeId, FaceId, NodeId},
};
use hipline_num::Sign;
use std::{cell::OnceCell, cmp::Ordering};

/// What lies beside a segment.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Ground {
    /// A face.
    Face(FaceId),
    /// A part of the plane that the skeleton does not cover.
    Outside,
    /// What the wavefront reaches too late to be of interest.
    Beyond,
}

/// What a segment is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Border {
    Edge(EdgeId),
    Arc(ArcId),
    /// The wavefront at the end of time.
    Last,
    /// A wall of an edge, away from the edge itself.
    Wall(EdgeId),
}

/// A segment between two positions.
#[derive(Debug, Clone)]
pub(super) struct Segment {
    /// The numbers of its ends' positions, ascending.
    pub ends: [u32; 2],
    pub border: Border,
    /// What is on the left, walking from the first end to the second: above, or to the west.
    pub above: Ground,
    pub below: Ground,
    track: Track,
    /// Whether the left is the negative side of the track.
    flipped: bool,
}

impl Segment {
    /// A side of the segment (positive above) as a side of its track.
    pub(super) fn sense(&self, side: Sign) -> Sign {
        if self.flipped { -side } else { side }
    }
}

/// An end of a segment.
#[derive(Debug, Clone)]
pub(super) struct Position {
    /// The nearest f64 numbers.
    pub point: [f64; 2],
    pub place: Place,
    /// The node that is there; none at the end of time.
    pub node: Option<NodeId>,
}

/// A point that is asked about.
pub(super) struct Query {
    pub point: [f64; 2],
    station: OnceCell<Station>,
}

impl Query {
    pub(super) const fn new(point: [f64; 2]) -> Self {
        Self {
            point,
            station: OnceCell::new(),
        }
    }

    pub(super) fn station(&self, planes: &Planes) -> &Station {
        self.station
            .get_or_init(|| Station::new(planes, self.point))
    }
}

/// The segments of a skeleton. Positions are sorted by x, then y, and distinct.
pub(super) struct Plan<'a> {
    pub lift: Lift<'a>,
    pub positions: Vec<Position>,
    pub segments: Vec<Segment>,
    /// What lies where no segment is above or below.
    pub background: Ground,
    /// The number of each node's position.
    pub numbers: Vec<u32>,
}

/// A time at which the wavefront has long left everything that lies near the figure.
fn end_of_time(skeleton: &Skeleton, figure: &Figure) -> f64 {
    const FAR: f64 = f64::from_bits((1023 + 200) << 52);
    const LAST: f64 = f64::from_bits((1023 + 900) << 52);
    let slowest = figure.edges().iter().flat_map(|e| e.speeds);
    let slowest = slowest.filter(|&w| w > 0.0).fold(f64::INFINITY, f64::min);
    let size = |n: &crate::skeleton::Node| n.x.abs().max(n.y.abs());
    let finite = skeleton.nodes().iter().filter(|n| n.time.is_finite());
    let largest = finite.fold(0.0_f64, |m, n| m.max(size(n) / slowest).max(n.time));
    (largest * FAR).clamp(FAR.recip(), LAST)
}

impl<'a> Plan<'a> {
    pub(super) fn new(skeleton: &'a Skeleton, figure: &Figure) -> Self {
        let lift = Lift::new(skeleton, figure);
        let last = end_of_time(skeleton, figure);
        let mut plan = Self {
            lift,
            positions: Vec::new(),
            segments: Vec::new(),
            numbers: Vec::new(),
            background: if skeleton.region() == Region::Interior {
                Ground::Outside
            } else {
                Ground::Beyond
            },
        };
        let numbers = plan.find_positions(last);
        let mut standing = Vec::new();
        plan.add_edges(&numbers, &mut standing);
        plan.add_arcs(&numbers, &mut standing);
        plan.add_last(&numbers, last, &mut standing);
        add_clusters(&mut plan, &standing);
        plan.numbers = numbers;
        plan
    }

    pub(super) const fn planes(&self) -> &Planes {
        &self.lift.planes
    }

    pub(super) const fn skeleton(&self) -> &'a Skeleton {
        self.lift.skeleton
    }

    /// Places all nodes in order; returns the number of each node's position.
    fn find_positions(&mut self, last: f64) -> Vec<u32> {
        let skeleton = self.skeleton();
        let mut far = vec![None; skeleton.nodes().len()];
        for (i, arc) in skeleton.arcs().iter().enumerate() {
            far[arc.nodes[1].index()] = Some(ArcId::new(i));
        }
        let mut list: Vec<(NodeId, Position)> = Vec::with_capacity(far.len());
        for (i, node) in skeleton.nodes().iter().enumerate() {
            let id = NodeId::new(i);
            let position = if node.time.is_finite() {
                Position {
                    point: [node.x, node.y],
                    place: self.lift.place(id),
                    node: Some(id),
                }
            } else {
                let arc = far[i].unwrap_or_else(|| panic!("{id} has no arc"));
                let place = self.lift.at(arc, last);
                let [x, y, _] = self.planes().round(&place);
                Position {
                    point: [x, y],
                    place,
                    node: None,
                }
            };
            list.push((id, position));
        }
        list.sort_by(|a, b| self.compare(&a.1, &b.1));
        let mut numbers = vec![0; far.len()];
        for (id, position) in list {
            let is_new = self
                .positions
                .last()
                .is_none_or(|before| self.compare(before, &position).is_ne());
            if is_new {
                self.positions.push(position);
            }
            numbers[id.index()] = self.positions.len() as u32 - 1;
        }
        numbers
    }

    /// By x, then y. Rounding is monotone, so where rounded numbers differ they tell.
    fn compare(&self, p: &Position, q: &Position) -> Ordering {
        match p.point[0].total_cmp(&q.point[0]) {
            Ordering::Equal
                if matches!([&p.place, &q.place], [Place::Vertex(_), Place::Vertex(_)]) =>
            {
                (p.point[1] + 0.0).total_cmp(&(q.point[1] + 0.0))
            }
            Ordering::Equal => self.planes().compare_points(&p.place, &q.place),
            order => order,
        }
    }

    /// Whether something beside a border is a face without area.
    fn is_beside_standing(&self, grounds: [Ground; 2]) -> bool {
        grounds
            .iter()
            .any(|ground| matches!(ground, Ground::Face(face) if has_no_area(&self.lift, *face)))
    }

    /// Adds a segment, or leaves it to what is made of faces without area.
    fn add_unless_standing(
        &mut self,
        ends: [u32; 2],
        border: Border,
        grounds: [Ground; 2],
        (track, flipped): (Track, bool),
        standing: &mut Vec<Standing>,
    ) {
        if self.is_beside_standing(grounds) {
            standing.push(Standing {
                ends,
                border,
                grounds,
            });
        } else {
            self.add(ends, border, grounds, track, flipped);
        }
    }

    /// Adds a segment, walking from one node to another with the given grounds.
    pub(super) fn add(
        &mut self,
        ends: [u32; 2],
        border: Border,
        [left, right]: [Ground; 2],
        track: Track,
        flipped: bool,
    ) {
        let [a, b] = ends;
        if a == b {
            return;
        }
        self.segments.push(if a < b {
            Segment {
                ends,
                border,
                above: left,
                below: right,
                track,
                flipped,
            }
        } else {
            Segment {
                ends: [b, a],
                border,
                above: right,
                below: left,
                track,
                flipped: !flipped,
            }
        });
    }

    /// The edges of the input, each with what starts on its two sides.
    fn add_edges(&mut self, numbers: &[u32], standing: &mut Vec<Standing>) {
        let skeleton = self.skeleton();
        let edges = &skeleton.input().edges;
        let mut grounds = vec![[Ground::Outside; 2]; edges.len()];
        for (i, face) in skeleton.faces().iter().enumerate() {
            let ground = Ground::Face(FaceId::new(i));
            match face.side {
                Side::Left if face.phase == 0 => grounds[face.edge.index()][0] = ground,
                Side::Right if face.phase == 0 => grounds[face.edge.index()][1] = ground,
                _ => {}
            }
        }
        for (e, nodes) in edges.iter().enumerate() {
            let [p, q] = nodes.map(|v| &skeleton.nodes()[v.index()]);
            let track = Track::Through([[p.x, p.y], [q.x, q.y]]);
            let ends = nodes.map(|v| numbers[v.index()]);
            let (border, grounds) = (Border::Edge(EdgeId::new(e)), grounds[e]);
            self.add_unless_standing(ends, border, grounds, (track, false), standing);
        }
    }

    fn add_arcs(&mut self, numbers: &[u32], standing: &mut Vec<Standing>) {
        let skeleton = self.skeleton();
        for (i, arc) in skeleton.arcs().iter().enumerate() {
            let id = ArcId::new(i);
            let [from, to] = arc.nodes.map(|n| numbers[n.index()]);
            let (border, grounds) = (Border::Arc(id), arc.faces.map(Ground::Face));
            if self.is_beside_standing(grounds) {
                standing.push(Standing {
                    ends: [from, to],
                    border,
                    grounds,
                });
                continue;
            }
            let [f, g] = arc.faces.map(|face| self.lift.plane(face));
            let (track, flipped) = if arc.kind == ArcKind::Ghost {
                // It goes up, so that its left is nearer to the start of the edge.
                let start = self.lift.place(arc.nodes[0]);
                (Track::Across(f, start), true)
            } else if self.planes().coplanar(f, g) {
                // One of them has overrun the other: they part their ways later.
                let [p, q] = [from, to].map(|k| &self.positions[k as usize].place);
                let forward = (self.planes())
                    .compare_spots_along(Spot::Place(p), Spot::Place(q), f)
                    .is_lt();
                (Track::Along(f, *p), !forward)
            } else {
                let left = match self.planes().turn(f, g) {
                    Sign::Zero => {
                        let [p, q] =
                            [from, to].map(|k| Spot::Place(&self.positions[k as usize].place));
                        let forward = Sign::from(self.planes().compare_spots_along(q, p, f));
                        forward * self.planes().falling_behind(f, g)
                    }
                    // The arc runs uphill, with f on its left: see `docs/derivations.md`, section 1.
                    turn => -turn,
                };
                (Track::Equal([f, g]), left.is_negative())
            };
            self.add([from, to], border, grounds, track, flipped);
        }
    }

    /// The wavefront at the end of time.
    fn add_last(&mut self, numbers: &[u32], last: f64, standing: &mut Vec<Standing>) {
        let skeleton = self.skeleton();
        let infinite = |n: NodeId| skeleton.node(n).time.is_infinite();
        for face in (0..skeleton.faces().len()).map(FaceId::new) {
            for cycle in std::iter::once(skeleton.boundary(face)).chain(skeleton.holes(face)) {
                for (i, &a) in cycle.iter().enumerate() {
                    let b = cycle[(i + 1) % cycle.len()];
                    if a != b && infinite(a) && infinite(b) {
                        let track = Track::Level(self.lift.plane(face), last);
                        let ends = [a, b].map(|n| numbers[n.index()]);
                        // The face is on the left, and what comes later is positive.
                        let grounds = [Ground::Face(face), Ground::Beyond];
                        let border = Border::Last;
                        self.add_unless_standing(ends, border, grounds, (track, true), standing);
                    }
                }
            }
        }
    }

    /// On which side of a segment's line a point is: positive above.
    pub(super) fn side(&self, segment: &Segment, query: &Query) -> Sign {
        let [p, q] = segment.ends.map(|k| self.positions[k as usize].point);
        rough_side(p, q, query.point).unwrap_or_else(|| {
            let station = query.station(self.planes());
            segment.sense(self.planes().beside(Spot::Station(station), &segment.track))
        })
    }

    /// On which side of a segment's line a position is: positive above.
    pub(super) fn side_of(&self, segment: &Segment, position: u32) -> Sign {
        if segment.ends.contains(&position) {
            return Sign::Zero;
        }
        let [p, q] = segment.ends.map(|k| self.positions[k as usize].point);
        let position = &self.positions[position as usize];
        rough_side(p, q, position.point).unwrap_or_else(|| {
            let spot = Spot::Place(&position.place);
            segment.sense(self.planes().beside(spot, &segment.track))
        })
    }

    /// The line of a segment.
    pub(super) const fn track(segment: &Segment) -> &Track {
        &segment.track
    }

    /// Compares a point with a position, by x, then y.
    pub(super) fn compare_query(&self, query: &Query, position: u32) -> Ordering {
        let position = &self.positions[position as usize];
        let spot = Spot::Place(&position.place);
        let station = || Spot::Station(query.station(self.planes()));
        let exactly = matches!(position.place, Place::Vertex(_));
        let by = |axis: usize, ask: &dyn Fn() -> Ordering| {
            let [p, q] = [query.point[axis] + 0.0, position.point[axis] + 0.0];
            match p.total_cmp(&q) {
                Ordering::Equal if !exactly => ask(),
                order => order,
            }
        };
        by(0, &|| self.planes().compare_abscissas(station(), spot))
            .then_with(|| by(1, &|| self.planes().compare_ordinates(station(), spot)))
    }

    /// Compares the ordinates of a point and a position.
    pub(super) fn compare_height(&self, y: f64, position: u32) -> Ordering {
        let position = &self.positions[position as usize];
        match (y + 0.0).total_cmp(&(position.point[1] + 0.0)) {
            Ordering::Equal if !matches!(position.place, Place::Vertex(_)) => {
                let station = Station::new(self.planes(), [0.0, y]);
                let (p, q) = (Spot::Station(&station), Spot::Place(&position.place));
                self.planes().compare_ordinates(p, q)
            }
            order => order,
        }
    }

    /// Whether a segment goes down or is level, walking from its first end to its second.
    pub(super) fn falls(&self, segment: &Segment) -> bool {
        let [p, q] = segment.ends.map(|k| &self.positions[k as usize]);
        match p.point[1].total_cmp(&q.point[1]) {
            Ordering::Equal => {
                let [p, q] = [p, q].map(|p| Spot::Place(&p.place));
                self.planes().compare_ordinates(p, q).is_ge()
            }
            order => order.is_gt(),
        }
    }
}
