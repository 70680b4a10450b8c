//! Wavefront vertices with an angle of 180 degrees: two wavefront edges on one line.
//!
//! With equal speeds they lie on one plane for good and become one wavefront edge; a ghost
//! arc will separate their faces. With unequal speeds the faster one wins (Biedl et al.
//! 2015): it overruns the slower one at once, to its far end, along an arc of one height.
//! Where several of them apply at once, the fastest wavefront edge goes first; of equally
//! fast ones, one that overruns the wavefront edge after it (the unswept side on the left)
//! goes before one that overruns the wavefront edge before it.

use super::{
    Kinetic,
    schedule::corner,
    triangulation::{Spokes, Tip, next, prev},
};
use crate::predicates::{Area, Moment, Part};
use crate::topology::{TraceId, WaveId};
use crate::wavefront::{End, Trace, Walk};
use hipline_num::Sign;
use std::{cmp::Ordering, collections::BTreeSet};

/// A straight vertex, between the wavefront edges that it had when it was entered.
#[derive(Clone, Copy)]
struct Straight {
    x: TraceId,
    inn: WaveId,
    out: WaveId,
}

/// A heap whose order the caller knows: the most urgent entry comes first.
#[derive(Default)]
struct Agenda(Vec<Straight>);

impl Agenda {
    fn push(&mut self, entry: Straight, before: impl Fn(&Straight, &Straight) -> bool) {
        let mut at = self.0.len();
        self.0.push(entry);
        while at > 0 && before(&self.0[at], &self.0[(at - 1) / 2]) {
            self.0.swap(at, (at - 1) / 2);
            at = (at - 1) / 2;
        }
    }

    fn pop(&mut self, before: impl Fn(&Straight, &Straight) -> bool) -> Option<Straight> {
        let last = self.0.len().checked_sub(1)?;
        self.0.swap(0, last);
        let top = self.0.pop();
        let mut at = 0;
        loop {
            let first = |p: usize, q: usize| {
                let better = q < self.0.len() && before(&self.0[q], &self.0[p]);
                if better { q } else { p }
            };
            let next = first(first(at, 2 * at + 1), 2 * at + 2);
            if next == at {
                return top;
            }
            self.0.swap(at, next);
            at = next;
        }
    }
}

impl Kinetic<'_> {
    /// Removes the straight vertices of this batch, when no flat triangle is left: those on one plane first; then
    /// by the speed of the faster wavefront edge.
    pub(super) fn remove_straight_vertices(&mut self) {
        let mut list = Agenda::default();
        let mut waiting = BTreeSet::new();
        loop {
            let mut fresh = std::mem::take(&mut self.batch.straight);
            waiting.extend(fresh.iter().copied());
            while let Some(x) = fresh.pop() {
                let Trace { inn, out, .. } = *self.front.trace(x);
                list.push(Straight { x, inn, out }, |p, q| self.is_more_urgent(p, q));
            }
            let Some(Straight { x, inn, out }) = list.pop(|p, q| self.is_more_urgent(p, q)) else {
                return;
            };
            let trace = *self.front.trace(x);
            if trace.end != End::Moving || [trace.inn, trace.out] != [inn, out] {
                continue;
            }
            waiting.remove(&x);
            let [u, _] = self.triangulation.ends(inn);
            let [_, v] = self.triangulation.ends(out);
            if self.speeds_between(inn, out).is_eq() {
                self.join(x);
            } else {
                self.overrun(x);
            }
            // Their neighbours are others now.
            let changed = [u, v].into_iter().filter(|x| waiting.contains(x));
            self.batch.straight.extend(changed);
        }
    }

    /// Compares the speeds of two wavefront edges.
    fn speeds_between(&self, inn: WaveId, out: WaveId) -> Ordering {
        let [i, j] = [inn, out].map(|wave| self.front.wave(wave).plane);
        self.planes.compare_speeds(i, j)
    }

    /// Whether one straight vertex is to be removed before another.
    fn is_more_urgent(&self, p: &Straight, q: &Straight) -> bool {
        let order = |s: &Straight| self.speeds_between(s.inn, s.out);
        let fastest = |s: &Straight| if order(s).is_ge() { s.inn } else { s.out };
        let joint = |s: &Straight| order(s).is_eq();
        joint(p)
            .cmp(&joint(q))
            .then_with(|| self.speeds_between(fastest(p), fastest(q)))
            .then_with(|| order(p).cmp(&order(q)))
            .then_with(|| q.x.cmp(&p.x))
            .is_gt()
    }

    /// Takes a straight vertex out of the triangulation: its two wavefront edges become one,
    /// which is `keep`.
    fn take_out(&mut self, p: TraceId, keep: WaveId) {
        let trace = *self.front.trace(p);
        // Flip its spokes away until one is left. The fan, seen from p, is a polygon over
        // the base from `inn`'s start to `out`'s end, with an ear at some spoke's far end. Ears beside
        // the end of the base that is kept go first: the other end may be the next to be taken
        // out, and must not collect the spokes of all before it.
        let mut fan: Spokes = self.triangulation.fan(trace.out).collect();
        let is_from_end = keep == trace.inn;
        let first = |len: usize| if is_from_end { len - 2 } else { 0 };
        let (mut i, mut failed) = (first(fan.len().max(2)), 0);
        while fan.len() > 2 {
            let [(t, corner), (other, _)] = [fan[i], fan[i + 1]];
            let rim = self.triangulation.rim([fan[i], fan[i + 1]]);
            // Beside wavefront edges of length zero no triangle has an area yet; there, that decides which will
            // have one.
            let is_ear = match self.orientation(rim) {
                Sign::Positive => true,
                Sign::Zero => failed > fan.len() && self.area_grows(rim),
                Sign::Negative => false,
            };
            if !is_ear {
                failed += 1;
                assert!(
                    failed <= 3 * fan.len() + 3,
                    "{p} is straight and has no ear"
                );
                i = match i.checked_add_signed(if is_from_end { -1 } else { 1 }) {
                    Some(i) if i + 1 < fan.len() => i,
                    _ => first(fan.len()),
                };
                continue;
            }
            failed = 0;
            // The spoke p-b lies on the side of `t` after the corner.
            self.triangulation.flip(t, next(corner));
            self.stats.flips += 1;
            self.batch.dirty.extend([t, other]);
            let kept = if self.triangulation.get(t).tips.contains(&p.into()) {
                t
            } else {
                other
            };
            fan[i] = (kept, self.triangulation.corner_of(kept, p.into()));
            fan.remove(i + 1);
            i = if is_from_end {
                i.min(fan.len() - 2)
            } else {
                i.saturating_sub(1)
            };
        }
        let [(t, k), (gone, j)] = fan[..] else {
            panic!("{p} is straight and has one triangle")
        };
        let start = self.triangulation.get(gone).tips[prev(j)];
        let far = self.triangulation.get(gone).across[j];
        self.triangulation.kill(gone);
        self.triangulation.triangles[t.index()].tips[k] = start;
        self.triangulation.attach(t, next(k), far);
        if let Some(beyond) = far.triangle() {
            let side = self.triangulation.side_to(beyond, gone.into());
            self.triangulation.attach(beyond, side, t.into());
        }
        self.triangulation.attach(t, prev(k), keep.into());
        self.batch.dirty.extend([t, gone]);
        let [u, v] = self.triangulation.ends(keep);
        self.front.trace_mut(u).out = keep;
        self.front.trace_mut(v).inn = keep;
    }

    /// The sign of a triangle's area at this moment; at the start, of input vertices.
    fn orientation(&self, tips: [Tip; 3]) -> Sign {
        if self.now != Moment::Start {
            return self.area_now(tips);
        }
        let places = tips.map(|tip| match tip.trace() {
            Some(x) => Ok(self.figure.vertices()[self.front.trace(x).born as usize]),
            None => Err(tip.direction().expect("a vertex or a direction")),
        });
        crate::predicates::orientation(places)
    }

    /// Whether a triangle without area has one just after this moment.
    fn area_grows(&self, tips: [Tip; 3]) -> bool {
        let corners = tips.map(|tip| corner(&self.front, tip));
        let sign = |part| self.planes.sign_at(&self.now, &Area(corners, part));
        match sign(Part::Slope) {
            Sign::Zero => sign(Part::Curvature).is_positive(),
            slope => slope.is_positive(),
        }
    }

    /// Two wavefront edges on one plane become one.
    fn join(&mut self, p: TraceId) {
        let trace = *self.front.trace(p);
        let faces = [trace.inn, trace.out].map(|w| self.front.wave(w).face);
        self.take_out(p, trace.inn);
        let at_p = self.front.trace_mut(p);
        at_p.end = End::Ghost;
        at_p.after_up = Walk::Down(p);
        self.front.join_faces(faces[0], faces[1]);
    }

    /// The faster one of two wavefront edges on one line overruns the slower one.
    fn overrun(&mut self, p: TraceId) {
        let trace = *self.front.trace(p);
        let starting = self.now == Moment::Start;
        if self.speeds_between(trace.inn, trace.out).is_lt() {
            // `inn` is overrun, back to its start u.
            let [u, _] = self.triangulation.ends(trace.inn);
            let slow = self.front.wave(trace.inn).face;
            self.take_out(p, trace.out);
            if starting {
                self.front.trace_mut(p).end = End::At(self.front.trace(u).born);
                self.front.trace_mut(p).after_up = Walk::Base(slow);
                self.front.start_moves(p, u);
                return;
            }
            let node = self.node_now(u);
            let at_u = *self.front.trace(u);
            let new = self.replace(u, at_u.inn, trace.out, node);
            self.front.trace_mut(p).end = End::At(node);
            self.front.vanishes(u, p);
            self.front.end_moves(u, new);
            self.front.start_moves(p, new);
        } else {
            // `out` is overrun, on to its end v.
            let [_, v] = self.triangulation.ends(trace.out);
            let slow = self.front.wave(trace.out).face;
            self.take_out(p, trace.inn);
            if starting {
                self.front.trace_mut(p).end = End::At(self.front.trace(v).born);
                // Of several bases on one plane, the last one ends at v.
                let mut last = slow;
                // (A facet that started at v has given the place to a new vertex.)
                while let Walk::Up(ghost) = self.front.after_base[last as usize]
                    && self.front.trace(ghost).end == End::Ghost
                {
                    let Walk::Base(after) = self.front.trace(ghost).after_down else {
                        unreachable!("bases on one line are linked through their ghosts")
                    };
                    last = after;
                }
                self.front.after_base[last as usize] = Walk::Down(p);
                self.front.end_moves(p, v);
                return;
            }
            let node = self.node_now(v);
            let at_v = *self.front.trace(v);
            let new = self.replace(v, trace.inn, at_v.out, node);
            self.front.trace_mut(p).end = End::At(node);
            self.front.vanishes(p, v);
            self.front.end_moves(p, new);
            self.front.start_moves(v, new);
        }
    }

    /// A new vertex takes the place of another.
    pub(super) fn replace(&mut self, old: TraceId, inn: WaveId, out: WaveId, node: u32) -> TraceId {
        self.front.trace_mut(old).end = End::At(node);
        let fan: Spokes = self.triangulation.fan(out).collect();
        let new = self.spawn(inn, out, node, old);
        for &(t, corner) in &fan {
            self.triangulation.triangles[t.index()].tips[corner] = new.into();
        }
        new
    }
}
