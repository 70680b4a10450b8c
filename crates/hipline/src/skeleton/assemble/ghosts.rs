//! Ghost arcs: where neighbours on one plane were carried as one wavefront edge, their joint
//! face is cut along the perpendicular from each place where they met, up to its boundary.

use std::{
    cmp::Ordering,
    collections::{BTreeMap, BTreeSet},
};

use super::{Assembly, Step};
use crate::{
    predicates::{Bound, Place, PlaneId},
    topology::TraceId,
    wavefront::{End, Trace, Walk},
};
use hipline_num::Sign;

/// Where ghost arcs end.
#[derive(Default)]
pub(super) struct Landings {
    /// By trace of a ghost, ascending.
    ghosts: Vec<Landing>,
    /// Nodes inside of traces, in the order of the traces, from start to end.
    cuts: Vec<(TraceId, u32)>,
}

/// The end of one ghost arc.
struct Landing {
    ghost: TraceId,
    /// The node where it ends, unless it goes to infinity.
    end: Option<u32>,
    /// The walk of the joint face's boundary on which the end lies; the end may be the last
    /// node of the walk. For infinity: the walk after which the boundary jumps.
    on: Walk,
}

impl Landings {
    /// The nodes inside of a trace.
    pub(super) fn cuts(&self, x: TraceId) -> impl Iterator<Item = &u32> {
        let from = self.cuts.partition_point(|&(trace, _)| trace < x);
        self.cuts[from..]
            .iter()
            .take_while(move |&&(trace, _)| trace == x)
            .map(|(_, node)| node)
    }

    /// The node where a ghost arc ends.
    pub(super) fn end(&self, ghost: TraceId) -> Option<u32> {
        let at = self
            .ghosts
            .binary_search_by_key(&ghost, |landing| landing.ghost);
        self.ghosts[at.expect("every ghost lands")].end
    }
}

/// Where a ghost arc meets the boundary of the joint face.
#[derive(Clone)]
enum Hit {
    /// At a node.
    Node(u32),
    /// Inside of a trace.
    Inside(Place),
    /// Inside of a trace that passes through the ghost arc's very start: the arc has length
    /// zero, because its face was overrun at time zero.
    Start,
    /// Nowhere.
    Infinity,
}

/// A stretch of a joint face's boundary that bounds it from above.
struct Ceiling {
    walk: Walk,
    /// Where it starts and ends (walking counterclockwise, so against the edge's
    /// direction); `None` is infinity.
    ends: [Option<u32>; 2],
    /// Whether the stretches of the boundary before and after it bound the face from above, too.
    goes_on: [bool; 2],
    /// Approximate coordinates of the ends along the edge, enlarged: high, low.
    high: f64,
    low: f64,
}

impl Assembly<'_> {
    /// Finds where every ghost arc ends.
    pub(super) fn find_landings(&mut self) -> Landings {
        let mut groups: Vec<(u32, TraceId)> = (0..self.front.traces.len())
            .map(TraceId::new)
            .filter(|&x| self.front.trace(x).end == End::Ghost)
            .map(|x| (self.front.wave(self.front.trace(x).inn).face, x))
            .collect();
        if groups.is_empty() {
            return Landings::default();
        }
        for (face, _) in &mut groups {
            *face = self.front.joint_face(*face);
        }
        groups.sort_unstable();
        let mut members: Vec<(u32, u32)> = (0..self.front.after_base.len() as u32)
            .map(|face| (self.front.joint_face(face), face))
            .filter(|&(joint, _)| groups.binary_search_by_key(&joint, |g| g.0).is_ok())
            .collect();
        members.sort_unstable();
        let mut orphans = self.orphans();
        let mut found = Vec::with_capacity(groups.len());
        for group in groups.chunk_by(|a, b| a.0 == b.0) {
            let from = members.partition_point(|m| m.0 < group[0].0);
            let faces: Vec<u32> = members[from..]
                .iter()
                .take_while(|m| m.0 == group[0].0)
                .map(|m| m.1)
                .collect();
            let ghosts: Vec<TraceId> = group.iter().map(|g| g.1).collect();
            let mut starts: Vec<Walk> = faces
                .into_iter()
                .filter_map(|face| self.front.first_walk(face))
                .collect();
            starts.extend(orphans.remove(&group[0].0).unwrap_or_default());
            self.land_group(&starts, ghosts, &mut found);
        }
        self.name_ends(found)
    }

    /// The walk after another one.
    fn after(&self, walk: Walk) -> Walk {
        match walk {
            Walk::Up(x) => self.front.trace(x).after_up,
            Walk::Down(x) => self.front.trace(x).after_down,
            Walk::Base(face) => self.front.after_base[face as usize],
            Walk::Open => unreachable!("every walk goes on"),
        }
    }

    /// Boundaries without a base, by joint face: a walk on each. They exist where a face with
    /// weights grew around an obstacle.
    fn orphans(&mut self) -> BTreeMap<u32, Vec<Walk>> {
        let mut orphans = BTreeMap::<u32, Vec<Walk>>::new();
        if self.planes.is_unweighted() {
            return orphans;
        }
        let mut seen = BTreeSet::new();
        let bases: Vec<Walk> = (0..self.front.after_base.len() as u32)
            .filter_map(|face| self.front.first_walk(face))
            .collect();
        let traces = (0..self.front.traces.len()).map(TraceId::new);
        let walks = traces.flat_map(|x| [Walk::Up(x), Walk::Down(x)]);
        let count = bases.len();
        for (i, first) in bases.into_iter().chain(walks).enumerate() {
            if seen.contains(&first) {
                continue;
            }
            let mut walk = first;
            while seen.insert(walk) {
                walk = self.after(walk);
            }
            if i >= count
                && let Walk::Up(x) | Walk::Down(x) = first
            {
                let Trace { inn, out, .. } = *self.front.trace(x);
                let wave = if first == Walk::Up(x) { inn } else { out };
                let face = self.front.wave(wave).face;
                orphans
                    .entry(self.front.joint_face(face))
                    .or_default()
                    .push(first);
            }
        }
        orphans
    }

    /// The walks around a joint face, traces of length zero left out; `starts` are walks on
    /// its boundary, at least one on each cycle.
    fn joint_boundary(&self, starts: &[Walk]) -> Vec<Vec<Walk>> {
        let mut done = BTreeSet::new();
        let mut cycles = Vec::new();
        for &first in starts {
            let mut cycle = Vec::new();
            let mut walk = first;
            while done.insert(walk) {
                if !matches!(walk, Walk::Up(x) | Walk::Down(x) if Self::is_void(self.front.trace(x)))
                {
                    cycle.push(walk);
                }
                walk = self.after(walk);
            }
            if !cycle.is_empty() {
                cycles.push(cycle);
            }
        }
        cycles
    }

    /// Finds the ends of all ghost arcs of one joint face.
    fn land_group(
        &self,
        starts: &[Walk],
        mut ghosts: Vec<TraceId>,
        found: &mut Vec<(TraceId, Hit, Walk)>,
    ) {
        let plane = self.front.wave(self.front.trace(ghosts[0]).inn).plane;
        // From the far end of the edge's direction to the near one.
        ghosts.sort_by(|&x, &y| {
            let [x, y] = [x, y].map(|g| self.finite_place(self.front.trace(g).born));
            self.planes.compare_along(&y, &x, plane)
        });
        let cycles = self.joint_boundary(starts);
        let (ceilings, mut jumps) = self.ceilings(&cycles, plane);
        let spikes = self.spikes(&cycles, plane);
        for ghost in ghosts {
            let born = self.front.trace(ghost).born;
            let at = self.approximate(born, plane);
            let mut best: Option<(Place, Hit, Walk)> = None;
            let mut best_touches = false;
            // A face without weights is monotone: its ceilings lie side by side, from high to
            // low, so one can stop a little after the last that comes into question.
            let monotone = self.planes.is_unweighted();
            let from = if monotone {
                ceilings.partition_point(|c| c.low > at.1)
            } else {
                0
            };
            let mut misses = 0;
            for ceiling in &ceilings[from..] {
                if ceiling.high < at.0 {
                    misses += 1;
                    if monotone && misses > 2 {
                        break;
                    }
                    continue;
                }
                if ceiling.low > at.1 {
                    continue;
                }
                let Some(hit) = self.meet_ceiling(born, ceiling, plane) else {
                    continue;
                };
                let (at, may_start) = match &hit {
                    Hit::Node(node) => (self.finite_place(*node), false),
                    Hit::Inside(place) => (*place, true),
                    Hit::Start | Hit::Infinity => (self.finite_place(born), true),
                };
                let after_start = self.planes.compare_times(&at, &self.finite_place(born));
                // A corner where the boundary turns back may be at one place with one on the other
                // side of a wall: there, the ghost arc would only touch the face.
                let touches = match &hit {
                    Hit::Node(node) => {
                        (0..2).any(|end| ceiling.ends[end] == Some(*node) && !ceiling.goes_on[end])
                    }
                    _ => false,
                };
                let nearer = best.as_ref().is_none_or(|(other, ..)| {
                    match self.planes.compare_times(&at, other) {
                        Ordering::Less => true,
                        Ordering::Equal => best_touches && !touches,
                        Ordering::Greater => false,
                    }
                });
                if nearer && (after_start.is_gt() || after_start.is_eq() && may_start) {
                    best_touches = touches;
                    best = Some((at, hit, ceiling.walk));
                }
            }
            for &(node, walk) in &spikes {
                let [at, start] = [node, born].map(|node| self.finite_place(node));
                let stops = self.planes.compare_along(&at, &start, plane).is_eq()
                    && self.planes.compare_times(&at, &start).is_gt()
                    && best.as_ref().is_none_or(|(other, ..)| {
                        self.planes.compare_times(&at, other) == Ordering::Less
                    });
                if stops {
                    best = Some((at, Hit::Node(node), walk));
                }
            }
            if let Some((_, hit, walk)) = best {
                found.push((ghost, hit, walk));
            } else {
                let jump = self.jump_over(&mut jumps, born, plane);
                let before = std::mem::replace(jump, Walk::Up(ghost));
                found.push((ghost, Hit::Infinity, before));
            }
        }
    }

    /// The stretches of a boundary with the face below them, and the walks after which it
    /// jumps at infinity.
    fn ceilings(&self, cycles: &[Vec<Walk>], plane: PlaneId) -> (Vec<Ceiling>, Vec<(Walk, Walk)>) {
        let mut list = Vec::new();
        let mut jumps = Vec::new();
        for cycle in cycles {
            let first = list.len();
            let mut above = vec![false; cycle.len()];
            let mut places = Vec::new();
            for (i, &walk) in cycle.iter().enumerate() {
                let after = cycle[(i + 1) % cycle.len()];
                let (x, up) = match walk {
                    Walk::Up(x) => (x, true),
                    Walk::Down(x) => (x, false),
                    Walk::Base(_) if self.is_far(after) => {
                        // Along the ray at the end of a chain.
                        jumps.push((walk, after));
                        continue;
                    }
                    _ => continue,
                };
                let trace = self.front.trace(x);
                let end = match trace.end {
                    End::At(node) => Some(node),
                    End::Moving => None,
                    End::Ghost => continue,
                };
                if up && end.is_none() {
                    debug_assert!(self.is_far(after), "a jump at infinity");
                    jumps.push((walk, after));
                }
                let ends = if up {
                    [Some(trace.born), end]
                } else {
                    [end, Some(trace.born)]
                };
                let mut ceiling = Ceiling {
                    walk,
                    ends,
                    goes_on: [false; 2],
                    high: f64::INFINITY,
                    low: f64::NEG_INFINITY,
                };
                if let Some(node) = ends[0] {
                    ceiling.high = self.approximate(node, plane).1;
                }
                if let Some(node) = ends[1] {
                    ceiling.low = self.approximate(node, plane).0;
                }
                if self.is_ceiling(&ceiling, x, up, plane) {
                    above[i] = true;
                    places.push(i);
                    list.push(ceiling);
                }
            }
            let n = cycle.len();
            for (ceiling, i) in list[first..].iter_mut().zip(places) {
                ceiling.goes_on = [above[(i + n - 1) % n], above[(i + 1) % n]];
            }
        }
        list.sort_by(|a, b| b.low.total_cmp(&a.low).then(b.high.total_cmp(&a.high)));
        (list, jumps)
    }

    /// Whether a stretch goes strictly against the edge's direction.
    fn is_ceiling(&self, ceiling: &Ceiling, x: TraceId, up: bool, plane: PlaneId) -> bool {
        match ceiling.ends {
            [Some(a), Some(b)] => self
                .planes
                .compare_along(&self.finite_place(a), &self.finite_place(b), plane)
                .is_gt(),
            _ => {
                let drift = self.planes.drift(self.front.trace(x).pair, plane);
                drift == if up { Sign::Negative } else { Sign::Positive }
            }
        }
    }

    /// Bounds of a node's coordinate along an edge: low, high.
    #[expect(clippy::cast_precision_loss, reason = "bounds, not decisions")]
    fn approximate(&self, node: u32, plane: PlaneId) -> (f64, f64) {
        let [x, y, _] = self.planes.round(&self.finite_place(node));
        let edges = self.figure.edges();
        let line = (plane.0 / 2) as usize;
        // A terminal's own line is perpendicular to its edge: no direction to be had here, so
        // no bounds.
        let Some(edge) = edges.get(line) else {
            return (f64::NEG_INFINITY, f64::INFINITY);
        };
        let vertices = self.figure.vertices();
        let (mut p, mut q) = (vertices[edge.from.index()], vertices[edge.to.index()]);
        if plane.0 % 2 == 1 {
            std::mem::swap(&mut p, &mut q);
        }
        let direction = [q[0] - p[0], q[1] - p[1]];
        let terms = [x * direction[0], y * direction[1]];
        let sum = terms[0] + terms[1];
        // Rounded coordinates, differences, products and one sum: a handful of roundings.
        let error = (terms[0].abs() + terms[1].abs()) * (16.0 / (1_u64 << 53) as f64);
        (sum - error, sum + error)
    }

    /// Where the perpendicular through a node meets a ceiling, if it does.
    fn meet_ceiling(&self, born: u32, ceiling: &Ceiling, plane: PlaneId) -> Option<Hit> {
        let against = |node: Option<u32>| {
            node.map(|node| {
                self.planes
                    .compare_along(&self.finite_place(node), &self.finite_place(born), plane)
            })
        };
        match against(ceiling.ends[1]) {
            Some(Ordering::Greater) => return None,
            Some(Ordering::Equal) => return ceiling.ends[1].map(Hit::Node),
            _ => {}
        }
        match against(ceiling.ends[0]) {
            Some(Ordering::Less) => return None,
            Some(Ordering::Equal) => return ceiling.ends[0].map(Hit::Node),
            _ => {}
        }
        let (Walk::Up(x) | Walk::Down(x)) = ceiling.walk else {
            unreachable!("a trace")
        };
        let trace = self.front.trace(x);
        let [a, b] = [trace.inn, trace.out].map(|w| self.front.wave(w).plane);
        let bound = if self.planes.turn(a, b).is_zero() {
            let [Some(node), _] = ceiling.ends else {
                unreachable!("level arcs are finite")
            };
            match self.finite_place(node) {
                Place::Event { moment, .. } => Bound::Level(moment),
                _ => return Some(Hit::Start),
            }
        } else {
            Bound::Pair(trace.pair)
        };
        Some(Hit::Inside(Place::Foot {
            start: self.start_of(born),
            plane,
            bound,
        }))
    }

    /// The walk after which the boundary jumps, at infinity, over the perpendicular through
    /// a node.
    fn jump_over<'j>(
        &self,
        jumps: &'j mut [(Walk, Walk)],
        born: u32,
        plane: PlaneId,
    ) -> &'j mut Walk {
        let start = self.finite_place(born);
        let far = |walk: Walk, sign: Ordering| {
            let (Walk::Up(x) | Walk::Down(x)) = walk else {
                return true; // a ray along the edge
            };
            let trace = self.front.trace(x);
            // Ghost arcs are handled in order, so one that is there lies beyond this one.
            trace.end == End::Ghost || self.planes.compare_far(trace.pair, &start, plane) == sign
        };
        let jump = jumps
            .iter_mut()
            .find(|(right, left)| far(*right, Ordering::Greater) && far(*left, Ordering::Less));
        &mut jump
            .unwrap_or_else(|| panic!("no way to infinity from node {born}"))
            .0
    }

    /// Makes nodes of the ends, one for each place.
    fn name_ends(&mut self, found: Vec<(TraceId, Hit, Walk)>) -> Landings {
        // Ends inside of traces, sorted along each trace.
        let mut inside: Vec<(TraceId, usize, Place)> = Vec::new();
        for (i, (ghost, hit, walk)) in found.iter().enumerate() {
            let (Walk::Up(x) | Walk::Down(x)) = *walk else {
                continue; // to infinity beside a ray
            };
            match hit {
                Hit::Inside(place) => inside.push((x, i, *place)),
                Hit::Start => {
                    let born = self.front.trace(*ghost).born;
                    inside.push((x, i, self.start_of(born).into()));
                }
                Hit::Node(_) | Hit::Infinity => {}
            }
        }
        let planes = self.planes;
        inside.sort_by(|(x, _, p), (y, _, q)| {
            x.cmp(y).then_with(|| {
                planes
                    .compare_times(p, q)
                    .then_with(|| self.along_level(*x, p, q))
            })
        });
        let mut ends = vec![None; found.len()];
        let mut cuts: Vec<(TraceId, u32)> = Vec::new();
        let mut last: Option<(TraceId, Place, u32)> = None;
        for &(x, i, place) in &inside {
            let node = match last {
                Some((y, other, node))
                    if x == y && planes.compare_points(&place, &other).is_eq() =>
                {
                    node
                }
                _ => {
                    // An arc of length zero: its face was overrun at the moment it started.
                    let born = self.front.trace(found[i].0).born;
                    let start = self.start_of(born).into();
                    let node = if planes.compare_times(&place, &start).is_eq() {
                        born
                    } else {
                        self.push_place(place)
                    };
                    cuts.push((x, node));
                    node
                }
            };
            ends[i] = Some(node);
            last = Some((x, place, node));
        }
        let mut ghosts: Vec<Landing> = Vec::with_capacity(found.len());
        for (i, (ghost, hit, walk)) in found.into_iter().enumerate() {
            let end = if let Hit::Node(node) = hit {
                Some(node)
            } else {
                ends[i]
            };
            ghosts.push(Landing {
                ghost,
                end,
                on: walk,
            });
        }
        ghosts.sort_by_key(|landing| landing.ghost);
        Landings { ghosts, cuts }
    }

    /// The order of two places on an arc of one height, along the arc.
    fn along_level(&self, x: TraceId, p: &Place, q: &Place) -> Ordering {
        let trace = self.front.trace(x);
        let End::At(end) = trace.end else {
            return Ordering::Equal;
        };
        let plane = self.front.wave(trace.inn).plane;
        let order = self.planes.compare_along(p, q, plane);
        let [from, to] = [trace.born, end].map(|node| self.finite_place(node));
        match self.planes.compare_along(&from, &to, plane) {
            Ordering::Greater => order.reverse(),
            _ => order,
        }
    }

    /// Cuts the joint faces' boundaries along the ghost arcs.
    pub(super) fn insert_ghosts(&mut self, landings: &Landings) {
        // Those to infinity come in the order in which each goes before the one after it,
        // so that the walk named by `on` is there already; finite ones do not interact but
        // where they end in one node.
        for landing in &landings.ghosts {
            let Some(end) = landing.end else { continue };
            let (Walk::Up(x) | Walk::Down(x)) = landing.on else {
                unreachable!("a trace")
            };
            let up = landing.on == Walk::Up(x);
            let [first, after] = self.of_trace[x.index()].map(|p| p as usize);
            // The step of this walk that ends at the node, or the one before the walk.
            let mut arriving = None;
            for p in first..after {
                let step: Step = if up { 2 * p } else { 2 * p + 1 };
                if self.ends(step)[1] == end {
                    arriving = Some(step);
                }
            }
            let arriving = arriving.unwrap_or_else(|| {
                let begin: Step = if up { 2 * first } else { 2 * after - 1 };
                let mut step = begin;
                while self.next[step] as usize != begin {
                    step = self.next[step] as usize;
                }
                step
            });
            self.insert(landing.ghost, arriving);
        }
        let mut infinite: Vec<&Landing> = landings
            .ghosts
            .iter()
            .filter(|landing| landing.end.is_none())
            .collect();
        let mut placed = BTreeSet::new();
        while !infinite.is_empty() {
            infinite.retain(|landing| {
                let arriving = match landing.on {
                    Walk::Base(face) => self.base_from + face as usize,
                    Walk::Up(x) | Walk::Down(x) => {
                        if self.front.trace(x).end == End::Ghost && !placed.contains(&x) {
                            return true;
                        }
                        2 * (self.of_trace[x.index()][1] as usize - 1)
                    }
                    Walk::Open => unreachable!("a walk"),
                };
                self.insert(landing.ghost, arriving);
                placed.insert(landing.ghost);
                false
            });
        }
    }

    /// Puts a ghost arc between the step that arrives at its end and the one after that.
    fn insert(&mut self, ghost: TraceId, arriving: Step) {
        let piece = self.of_trace[ghost.index()][0] as usize;
        let (up, down) = (2 * piece, 2 * piece + 1);
        let leaving = self.next[arriving];
        self.next[arriving] = down as u32;
        self.next[up] = leaving;
    }
}
