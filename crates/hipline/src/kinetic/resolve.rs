//! All that happens at one moment.
//!
//! At the moment, the triangulation is a degenerate one: triangles may be flat, sides may
//! have length zero. As long as a triangle is flat:
//!
//! 1. A side of length zero is contracted. A wavefront edge: an edge event. A spoke: two
//!    wavefront vertices have met, and exchange their wavefront edges.
//! 2. Else one corner lies strictly inside the opposite, longest side. A wavefront edge
//!    there is split by the corner: a split event. A spoke is flipped, but not before a flat
//!    triangle on its other side that has a longer side.
//!
//! Contractions and splits remove triangles; each flip replaces a side between flat
//! triangles by a shorter one, or makes a flat triangle vanish into a positive one. So this
//! ends. No place moves while it goes on, so it is all a matter of what coincides and what
//! lies between what, and those are exact questions about the moment.

use std::cmp::Ordering;

use super::{
    Kinetic,
    schedule::{corner, meeting_moment},
    triangulation::{Across, Spokes, Tip, next, prev},
};
use crate::predicates::{Area, Corner, Direction, Moment, Part, PlaneId};
use crate::topology::{TraceId, TriangleId, WaveId};
use crate::wavefront::{End, EventNode, Trace, Walk, Wave};
use hipline_num::Sign;

/// What a triangle is at a moment.
enum Shape {
    /// It has positive area.
    Solid,
    /// The ends of this side coincide.
    Zero(usize),
    /// The corner opposite this side lies strictly inside it.
    Flat(usize),
}

/// Whether a moment is defined as that at which the triangle of these corners is flat.
fn is_root_of(moment: Option<Moment>, corners: [Corner; 3]) -> bool {
    matches!(moment, Some(Moment::Root(flat)) if flat.iter().all(|c| corners.contains(c)))
}

impl Kinetic<'_> {
    /// Resolves what was collected for this moment.
    pub(super) fn resolve_batch(&mut self) {
        // Whatever the order in which the queue gave them.
        self.batch.work.sort_unstable();
        while let Some(t) = self.batch.work.pop() {
            if !self.triangulation.is_alive(t) {
                continue;
            }
            match self.shape(t) {
                Shape::Solid => self.batch.dirty.push(t),
                Shape::Zero(k) => self.contract(t, k),
                Shape::Flat(k) => {
                    let across = self.triangulation.get(t).across[k];
                    if let Some(wave) = across.wave() {
                        self.split(t, k, wave);
                    } else {
                        let other = across.triangle().expect("no side at infinity is passed");
                        self.pass(t, k, other);
                    }
                }
            }
        }
    }

    /// A corner of `t` lies on the spoke to `other`.
    fn pass(&mut self, t: TriangleId, k: usize, other: TriangleId) {
        let flat = match self.shape(other) {
            Shape::Solid => false,
            Shape::Flat(j) if self.triangulation.get(other).across[j] == t.into() => true,
            Shape::Zero(_) | Shape::Flat(_) => {
                self.batch.work.extend([t, other]);
                return;
            }
        };
        self.stats.flips += 1;
        self.triangulation.flip(t, k);
        self.batch.dirty.extend([t, other]);
        if flat {
            self.batch.work.extend([t, other]);
        }
    }

    /// What a triangle is now.
    fn shape(&self, t: TriangleId) -> Shape {
        let triangle = self.triangulation.get(t);
        let waves = [0, 1, 2].map(|k| triangle.across[k].wave());
        let due = self.due(t);
        let corner = |tip| corner(&self.front, tip);
        // Sides that are wavefront edges are asked first: they share a plane with both of
        // their ends, which makes it cheap.
        for k in (0..3).filter(|&k| waves[k].is_some()) {
            let ends = [triangle.tips[next(k)], triangle.tips[prev(k)]];
            let vanishes = waves[k].is_some_and(|wave| self.vanishes_at(due, wave, ends));
            if vanishes || self.same_place(ends) {
                return Shape::Zero(k);
            }
        }
        let height = |k: usize, wave: WaveId| self.height_now(triangle.tips[k], wave, due);
        let sign = match waves {
            [None, None, None] if is_root_of(due, triangle.tips.map(corner)) => Sign::Zero,
            [None, None, None] => self.area_now(triangle.tips),
            [Some(wave), None, None] => height(0, wave),
            [None, Some(wave), None] => height(1, wave),
            [None, None, Some(wave)] => height(2, wave),
            // Between two wavefront edges of positive length the angle decides.
            [None, _, _] => self.angle_at(triangle.tips[0]),
            [_, None, _] => self.angle_at(triangle.tips[1]),
            [_, _, _] => self.angle_at(triangle.tips[2]),
        };
        match sign {
            Sign::Positive => Shape::Solid,
            Sign::Zero => self.flat_shape(t),
            Sign::Negative => panic!("{t} {triangle:?} is inside out at {:?}", self.now),
        }
    }

    fn turn_at(&self, tip: Tip) -> Sign {
        self.front
            .trace(tip.trace().expect("wavefront edges are finite"))
            .turn
    }

    /// The turn from one wavefront edge to the next at the vertex between them; zero between walls on one line.
    fn angle_at(&self, tip: Tip) -> Sign {
        let trace = (self.front).trace(tip.trace().expect("wavefront edges are finite"));
        let [i, j] = [trace.inn, trace.out].map(|wave| self.front.wave(wave).plane);
        if self.planes.phases.is_post(trace.pair[0]) && self.planes.same_direction(i, j) {
            return self.planes.turn(i, j);
        }
        trace.turn
    }

    /// Whether a wavefront edge has length zero at a moment for the simple reason that
    /// it is the moment at which its plane meets those before and after it.
    fn vanishes_at(&self, moment: Option<Moment>, wave: WaveId, ends: [Tip; 2]) -> bool {
        let Some(moment @ Moment::Planes(_)) = moment else {
            return false;
        };
        // Between parallel planes, a vertex is not where its planes meet.
        let proper = |tip: &Tip| !self.turn_at(*tip).is_zero();
        ends.iter().all(proper) && moment == Moment::of_planes(self.collapse_planes(wave))
    }

    /// How far a corner is ahead of the wavefront edge opposite it, if `due` is now.
    fn height_now(&self, tip: Tip, wave: WaveId, due: Option<Moment>) -> Sign {
        let plane = self.front.wave(wave).plane;
        match tip.trace() {
            Some(x) => {
                let pair = self.front.trace(x).pair;
                let [i, j] = pair;
                if due.is_some_and(|due| due == Moment::of_planes([plane, i, j])) {
                    return Sign::Zero;
                }
                self.planes.lead(&self.now, pair, plane)
            }
            None => self
                .planes
                .heads(plane, tip.direction().expect("a direction")),
        }
    }

    /// What a triangle is, known to be flat.
    fn flat_shape(&self, t: TriangleId) -> Shape {
        let tips = self.triangulation.get(t).tips;
        if let Some(k) = tips.iter().position(|tip| tip.direction().is_some()) {
            let direction = tips[k].direction().expect("just found");
            let (u, v) = (tips[next(k)], tips[prev(k)]);
            return match self.compare_along(direction, u, v) {
                Ordering::Equal => Shape::Zero(k),
                // The one ahead lies on the ray of the other.
                Ordering::Greater => Shape::Flat(next(k)),
                Ordering::Less => Shape::Flat(prev(k)),
            };
        }
        let pairs = tips.map(|tip| self.front.trace(tip.trace().expect("a finite corner")).pair);
        if let Some(k) = self.planes.middle(self.bounds, pairs) {
            return Shape::Flat(k);
        }
        let side = [0, 1, 2].map(|k| self.compare_tips(tips[next(k)], tips[prev(k)]));
        let across = self.triangulation.get(t).across;
        let zero = |k: &usize| side[*k].is_eq();
        if let Some(k) = (0..3)
            .filter(zero)
            .min_by_key(|&k| across[k].wave().is_none())
        {
            return Shape::Zero(k);
        }
        // Corner k is the middle one if its neighbours lie on different sides of it.
        let middle = (0..3).find(|&k| side[next(k)] == side[prev(k)]);
        Shape::Flat(middle.expect("one of three places on a line is the middle one"))
    }

    /// The sign of a triangle's area now.
    pub(super) fn area_now(&self, tips: [Tip; 3]) -> Sign {
        let corners = tips.map(|tip| corner(&self.front, tip));
        if is_root_of(Some(self.now), corners) {
            return Sign::Zero;
        }
        self.planes.sign_at(&self.now, &Area(corners, Part::Value))
    }

    /// Whether two places are one now.
    fn same_place(&self, tips: [Tip; 2]) -> bool {
        let [u, v] = tips.map(|tip| tip.trace().expect("a finite corner"));
        self.known_same(u, v) || {
            let [u, v] = [u, v].map(|x| self.front.trace(x).pair);
            self.planes.coincide(&self.now, u, v)
        }
    }

    /// Compares two places now, by x, then y.
    fn compare_tips(&self, u: Tip, v: Tip) -> Ordering {
        let [u, v] = [u, v].map(|tip| tip.trace().expect("a finite corner"));
        if self.known_same(u, v) {
            return Ordering::Equal;
        }
        self.planes.compare_places(
            &self.now,
            self.front.trace(u).pair,
            self.front.trace(v).pair,
        )
    }

    /// Whether both were born at one node of this batch.
    fn known_same(&self, u: TraceId, v: TraceId) -> bool {
        let (u, v) = (self.front.trace(u), self.front.trace(v));
        u.born == v.born && u.born >= self.batch.first_node
    }

    /// Compares two places now along a direction.
    fn compare_along(&self, direction: Direction, u: Tip, v: Tip) -> Ordering {
        let [u, v] = [u, v].map(|tip| self.front.trace(tip.trace().expect("a finite corner")).pair);
        let [dx, dy] = direction.vector();
        let order = self.planes.compare_coordinate(&self.now, u, v, dx == 0);
        if dx + dy > 0 { order } else { order.reverse() }
    }

    /// The node at the place of a vertex now, if it has one already.
    fn known_node(&mut self, x: TraceId) -> Option<u32> {
        let born = self.front.trace(x).born;
        (born >= self.batch.first_node).then(|| self.front.node(born))
    }

    /// The node at the place of a vertex now.
    pub(super) fn node_now(&mut self, x: TraceId) -> u32 {
        self.known_node(x).unwrap_or_else(|| {
            let pair = self.front.trace(x).pair;
            let Moment::Planes(moment) = self.now else {
                panic!(
                    "{x} has an event at a moment that is not one of planes: {:?}",
                    self.now
                )
            };
            self.front.push_node(EventNode { pair, moment })
        })
    }

    /// The one node at the place of two vertices that coincide now.
    fn common_node(&mut self, u: TraceId, v: TraceId) -> u32 {
        match (self.known_node(u), self.known_node(v)) {
            (Some(a), Some(b)) => self.front.same_node(a, b),
            (Some(a), None) | (None, Some(a)) => a,
            (None, None) => self.node_now(u),
        }
    }

    /// A new vertex at a node, between two wavefront edges; at the place of `here`.
    pub(super) fn spawn(&mut self, inn: WaveId, out: WaveId, born: u32, here: TraceId) -> TraceId {
        let (i, j) = (self.front.wave(inn).plane, self.front.wave(out).plane);
        let mut turn = self.planes.turn(i, j);
        let mut pair = match turn {
            Sign::Positive => [i, j],
            Sign::Negative => [j, i],
            Sign::Zero => self.front.trace(here).pair,
        };
        if turn.is_zero()
            && let Some(post) = self.post_between(inn, out, Some(pair))
        {
            (turn, pair) = (Sign::Negative, post);
        }
        let x = self.front.push_trace(Trace {
            pair,
            inn,
            out,
            born,
            end: End::Moving,
            turn,
            after_up: Walk::Open,
            after_down: Walk::Open,
        });
        if turn.is_zero() && self.planes.same_direction(i, j) {
            if self.awaits_facet(x) {
                self.changes.below.push(x);
            } else {
                self.batch.straight.push(x);
            }
        }
        self.batch.fresh.push(x);
        x
    }

    /// Gives all the triangles' corners at `old` to `new`.
    pub(super) fn relabel(&mut self, fan: &[(TriangleId, usize)], new: TraceId) {
        for &(t, corner) in fan {
            self.triangulation.triangles[t.index()].tips[corner] = new.into();
        }
        // Where the new vertex may be the middle one of a flat triangle, look at them all.
        if self.front.trace(new).turn != Sign::Positive {
            self.batch.work.extend(fan.iter().map(|&(t, _)| t));
        }
    }

    /// An event of the wavefront is found at a moment that so far was known as the root of a
    /// quadratic only: names it by three planes. (Two vertices may meet that had no spoke
    /// between them until a flip at this very moment.)
    fn name_moment(&mut self, triple: impl FnOnce(&Self) -> Option<[PlaneId; 3]>) {
        if let Moment::Root(_) = self.now {
            let triple = triple(self).expect("events happen when three planes meet");
            self.now = Moment::of_planes(triple);
        }
    }

    /// Side k of `t` has length zero.
    pub(super) fn contract(&mut self, t: TriangleId, k: usize) {
        let triangle = *self.triangulation.get(t);
        let [u, v] = [triangle.tips[next(k)], triangle.tips[prev(k)]]
            .map(|tip| tip.trace().expect("a finite corner"));
        assert_ne!(u, v, "{t} has a side from {u} to itself");
        self.name_moment(|this| {
            meeting_moment(&this.planes, this.front.trace(u), this.front.trace(v))
        });
        let node = self.common_node(u, v);
        let (at_u, at_v) = (*self.front.trace(u), *self.front.trace(v));
        let fan_u: Spokes = self.triangulation.fan(at_u.out).collect();
        let fan_v: Spokes = self.triangulation.fan(at_v.out).collect();
        self.front.trace_mut(u).end = End::At(node);
        self.front.trace_mut(v).end = End::At(node);
        if let Some(wave) = triangle.across[k].wave() {
            debug_assert!(at_u.out == wave && at_v.inn == wave);
            self.stats.edge_events += 1;
            self.front.vanishes(u, v);
            let x = self.spawn(at_u.inn, at_v.out, node, u);
            self.front.end_moves(u, x);
            self.front.start_moves(v, x);
            self.relabel(&fan_u, x);
            self.relabel(&fan_v, x);
            self.seal(t, k, x);
            return;
        }
        let other = triangle.across[k].triangle().expect("a spoke");
        let j = self.triangulation.side_to(other, t.into());
        self.stats.split_events += 1;
        // On the side of `t`: from u's inn to v's out. On the other side: from v's inn to u's out.
        let near = self.spawn(at_u.inn, at_v.out, node, u);
        let far = self.spawn(at_v.inn, at_u.out, node, v);
        self.front.end_moves(u, near);
        self.front.start_moves(v, near);
        self.front.end_moves(v, far);
        self.front.start_moves(u, far);
        let cut = |fan: &[(TriangleId, usize)], at: TriangleId| {
            fan.iter()
                .position(|&(f, _)| f == at)
                .expect("a triangle at both ends of the spoke")
        };
        // Around u: first the triangles up to `other`, then those from `t` on; around v the
        // other way round.
        let (low, high) = fan_u.split_at(cut(&fan_u, t));
        self.relabel(low, far);
        self.relabel(high, near);
        let (low, high) = fan_v.split_at(cut(&fan_v, other));
        self.relabel(low, near);
        self.relabel(high, far);
        self.seal(t, k, near);
        self.seal(other, j, far);
    }

    /// Removes a triangle whose side k has become the vertex `x`.
    fn seal(&mut self, t: TriangleId, k: usize, x: TraceId) {
        let triangle = *self.triangulation.get(t);
        let (a, b) = (triangle.across[next(k)], triangle.across[prev(k)]);
        self.triangulation.kill(t);
        self.batch.dirty.push(t);
        if let (Some(a), Some(b)) = (a.wave(), b.wave()) {
            let w = triangle.tips[k]
                .trace()
                .expect("wavefront edges are finite");
            self.close(x, w, a, b);
        } else if let Some(touched) = self.triangulation.glue(t, a, b) {
            self.batch.work.push(touched);
        }
    }

    /// Two wavefront edges, `a` from x to w and `b` from w to x, cover each other: the
    /// wavefront vanishes there, at one height, and leaves a ridge (or nothing but a node).
    fn close(&mut self, x: TraceId, w: TraceId, a: WaveId, b: WaveId) {
        debug_assert!(self.front.trace(x).inn == b && self.front.trace(x).out == a);
        debug_assert!(self.front.trace(w).inn == a && self.front.trace(w).out == b);
        let node = if self.same_place([x.into(), w.into()]) {
            self.common_node(x, w)
        } else {
            self.node_now(w)
        };
        self.front.vanishes(x, w);
        self.front.vanishes(w, x);
        self.front.trace_mut(x).end = End::At(node);
        self.front.trace_mut(w).end = End::At(node);
    }

    /// The corner opposite side k of `t` lies strictly inside the wavefront edge there.
    fn split(&mut self, t: TriangleId, k: usize, wave: WaveId) {
        let triangle = *self.triangulation.get(t);
        let [w, u, v] = [k, next(k), prev(k)].map(|i| {
            triangle.tips[i]
                .trace()
                .expect("wavefront edges are finite")
        });
        self.stats.split_events += 1;
        self.name_moment(|this| {
            let [i, j] = this.front.trace(w).pair;
            Some([this.front.wave(wave).plane, i, j])
        });
        let node = self.node_now(w);
        let at_w = *self.front.trace(w);
        let fan: Spokes = self.triangulation.fan(at_w.out).collect();
        self.front.trace_mut(w).end = End::At(node);
        // `wave` keeps the part from u to the new vertex `end`; the new wavefront edge goes
        // from the new vertex `start` to v.
        let Wave { plane, face } = *self.front.wave(wave);
        let second = self.triangulation.push_wave(t);
        self.front.waves.push(Wave { plane, face });
        self.register(second);
        let end = self.spawn(wave, at_w.out, node, w);
        let start = self.spawn(at_w.inn, second, node, w);
        self.front.start_moves(w, end);
        self.front.end_moves(w, start);
        self.front.is_cut(end, start);
        self.front.trace_mut(v).inn = second;
        let cut = fan
            .iter()
            .position(|&(f, _)| f == t)
            .expect("a triangle at its own corner");
        self.relabel(&fan[..cut], end);
        self.relabel(&fan[cut + 1..], start);
        let (a, b) = (triangle.across[next(k)], triangle.across[prev(k)]);
        self.triangulation.kill(t);
        self.batch.dirty.push(t);
        self.take_over(t, b, wave);
        self.take_over(t, a, second);
        if let Some(b) = b.wave() {
            self.close(end, u, b, wave);
        }
        if let Some(a) = a.wave() {
            self.close(start, v, second, a);
        }
    }

    /// A wavefront edge comes to lie where `old` was, beside the triangle across.
    fn take_over(&mut self, old: TriangleId, across: Across, wave: WaveId) {
        if let Some(t) = across.triangle() {
            let side = self.triangulation.side_to(t, old.into());
            self.triangulation.attach(t, side, wave.into());
            self.batch.work.push(t);
        }
    }
}
