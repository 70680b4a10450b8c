//! The stretches of the merge chain, and the boundaries of the faces that it cuts.

use super::{Course, Exit, Merge};
use crate::{
    monotone::{
        boundary::{Crossing, Time},
        chains::{NONE, Side, Trouble},
    },
    predicates::Moment,
    topology::{TraceId, WaveId},
    wavefront::{End, EventNode, Trace, Walk},
};
use hipline_num::Sign;

impl Merge<'_, '_> {
    /// With weights, whether the merge chain may go back in time along the boundary of a face that ends here: where
    /// three planes have a line in common.
    fn goes_back_along(&mut self, side: Side) -> bool {
        if self.chains.planes.is_unweighted() || !matches!(self.course(), Ok(Course::Backward)) {
            return false;
        }
        let (mut cursor, now) = (*self.cursor(side), self.now);
        self.chains.seek(&mut cursor, &now, false);
        let end = (cursor.east != NONE).then(|| self.chains.end_node(cursor.east));
        let node = self.chains.front.node(self.node);
        end.flatten()
            .is_some_and(|end| self.chains.front.node(end) == node)
    }

    /// Whether the merge chain leaves the face on the other side right here, too, for one on the same plane.
    fn joins_here(&mut self, side: Side) -> Option<(Side, Crossing)> {
        let [i, k] = self.planes();
        let (other, plane) = match side {
            Side::Upper => (Side::Lower, i),
            Side::Lower => (Side::Upper, k),
        };
        let (mut cursor, now) = (*self.cursor(other), self.now);
        self.chains.seek(&mut cursor, &now, false);
        if cursor.east == NONE {
            return None;
        }
        let trace = *self.chains.trace(cursor.east);
        if !self.chains.meets_coplanar(other, &trace, plane) {
            return None;
        }
        let place = self.chains.place_at(&cursor, &now)?;
        let here = self.chains.place_of(self.node);
        if !self.chains.planes.compare_points(&place, &here).is_eq() {
            return None;
        }
        let end = self.chains.end_node(cursor.east);
        let node = end.filter(|&n| self.chains.compare(&self.chains.time_of(n), &now).is_eq());
        Some((
            other,
            Crossing {
                trace: cursor.east,
                node,
                time: now,
            },
        ))
    }

    /// Leaves the faces of wavefront edges that vanish right here.
    pub(super) fn leave_dead(&mut self, side: Side) {
        loop {
            let wave = self.cursor(side).wave;
            let death = self.chains.waves[wave as usize].death;
            if death == NONE || self.chains.front.node(death) != self.chains.front.node(self.node) {
                return;
            }
            if matches!(self.course(), Ok(Course::Joint { forward: false })) {
                // It is there right before, and one with the other one.
                return;
            }
            if self.goes_back_along(side) {
                return;
            }
            if let Some((other, crossing)) = self.joins_here(side) {
                // One of the other chain on its plane starts right here: that first.
                self.leave(other, &crossing);
                continue;
            }
            let mut trace = self.chains.at_start_of(side, wave).east;
            loop {
                match self.chains.after(side, trace) {
                    NONE => break,
                    after => trace = after,
                }
            }
            let crossing = Crossing {
                trace,
                node: Some(death),
                time: self.now,
            };
            self.leave(side, &crossing);
        }
    }

    pub(super) fn new_node(&mut self, course: Course, crossing: &Crossing) -> u32 {
        let [i, k] = self.planes();
        let pair = match course {
            Course::Forward => [i, k],
            Course::Backward => [k, i],
            Course::Level | Course::Joint { .. } => self.chains.trace(crossing.trace).pair,
        };
        let Moment::Planes(moment) = crossing.time.moment else {
            unreachable!("the merge chain is at time zero at its ends only")
        };
        self.chains
            .new_node(EventNode { pair, moment }, crossing.time.bounds)
    }

    /// The stretch of the merge chain up to a node.
    pub(super) fn stretch(&mut self, course: Course, node: u32) {
        let [i, k] = self.planes();
        let [upper, lower] = [self.upper, self.lower].map(|c| WaveId::raw(c.wave));
        let mut trace = Trace {
            pair: [i, k],
            inn: upper,
            out: lower,
            born: self.node,
            end: End::At(node),
            turn: Sign::Positive,
            after_up: Walk::Open,
            after_down: Walk::Open,
        };
        match course {
            Course::Forward => {}
            Course::Backward => {
                (trace.inn, trace.out) = (lower, upper);
                (trace.born, trace.end) = (node, End::At(self.node));
                trace.pair = [k, i];
            }
            Course::Level => {
                trace.turn = Sign::Zero;
                if let Some(event) = self.node.checked_sub(self.chains.front.vertices) {
                    trace.pair = self.chains.front.events[event as usize].pair;
                }
            }
            Course::Joint { forward } => return self.ghost(forward, node),
        }
        if let Some(glued) = self.glued.take()
            && course != Course::Backward
        {
            // Nothing happened there.
            self.chains.front.trace_mut(glued).end = End::At(node);
            return;
        }
        let x = self.chains.front.push_trace(trace);
        let (up, down) = match course {
            Course::Backward => (Walk::Down(x), Walk::Up(x)),
            _ => (Walk::Up(x), Walk::Down(x)),
        };
        self.append_upper(up);
        self.prepend_lower(down);
    }

    /// The ghost arc between two faces on one plane, whose wavefront edges are one: it starts
    /// where they came together.
    pub(super) fn ghost(&mut self, forward: bool, node: u32) {
        let [upper, lower] = [self.upper, self.lower].map(|c| WaveId::raw(c.wave));
        let [i, k] = self.planes();
        let (inn, out, born) = if forward {
            (upper, lower, self.node)
        } else {
            (lower, upper, node)
        };
        self.chains.ghosts = true;
        let x = self.chains.front.push_trace(Trace {
            pair: [i, k],
            inn,
            out,
            born,
            end: End::Ghost,
            turn: Sign::Zero,
            after_up: Walk::Open,
            after_down: Walk::Open,
        });
        self.chains.front.trace_mut(x).after_up = Walk::Down(x);
        if forward {
            self.append_upper(Walk::Up(x));
            self.prepend_lower(Walk::Down(x));
            (self.last_upper, self.first_lower) = (None, None);
        } else {
            let (last, first) = (self.last_upper.take(), self.first_lower.take());
            if let (Some(last), Some(first)) = (last, first) {
                self.set_after(last, first);
            }
            (self.last_upper, self.first_lower) = (Some(Walk::Down(x)), Some(Walk::Up(x)));
        }
    }

    pub(super) fn set_after(&mut self, walk: Walk, after: Walk) {
        let front = &mut self.chains.front;
        match walk {
            Walk::Up(x) => front.trace_mut(x).after_up = after,
            Walk::Down(x) => front.trace_mut(x).after_down = after,
            Walk::Base(face) => front.after_base[face as usize] = after,
            Walk::Open => unreachable!("a walk"),
        }
    }

    /// The boundary of the upper face goes on along a walk.
    pub(super) fn append_upper(&mut self, walk: Walk) {
        match self.last_upper.replace(walk) {
            Some(last) => self.set_after(last, walk),
            // After a joint face that only the lower one was left of.
            None => self.first_lower = Some(walk),
        }
    }

    /// Before the boundary of the lower face goes on, it goes along a walk.
    pub(super) fn prepend_lower(&mut self, walk: Walk) {
        match self.first_lower.replace(walk) {
            Some(first) => self.set_after(walk, first),
            None => self.last_upper = Some(walk),
        }
    }

    /// Leaves a face over a trace of its eastern boundary: cuts it there, and forgets what
    /// comes later.
    pub(super) fn leave(&mut self, side: Side, crossing: &Crossing) {
        let x = TraceId::raw(crossing.trace);
        // Where one of two faces on one plane vanishes in its own chain, nothing happens in truth:
        // the trace at its end goes on beside the other one.
        let alone = self.last_upper.is_none() && self.first_lower.is_none();
        self.glued = alone.then_some(x);
        match side {
            Side::Upper => {
                self.append_upper(Walk::Down(x));
                self.last_upper = Some(Walk::Up(x));
            }
            Side::Lower => {
                self.prepend_lower(Walk::Up(x));
                self.first_lower = Some(Walk::Down(x));
            }
        }
        self.pass(side, crossing, self.now);
    }

    /// To the face beyond a trace, which ends here; what comes later was never there.
    pub(super) fn pass(&mut self, side: Side, crossing: &Crossing, now: Time) {
        let wave = self.cursor(side).wave;
        self.left[wave as usize] = true;
        let mut cursor = self.chains.enter(side, crossing.trace, &now);
        cursor.west = crossing.trace;
        let mut later = self.chains.after(side, crossing.trace);
        self.chains
            .front
            .trace_mut(TraceId::raw(crossing.trace))
            .end = End::At(self.node);
        while later != NONE {
            self.chains.steps += 1;
            self.void(later);
            later = self.chains.after(side, later);
        }
        *self.cursor(side) = cursor;
    }

    /// The same, going back in time: where one of two faces on one plane starts to be there, in its
    /// own chain, the stretch so far is part of the trace at its end.
    pub(super) fn glues(&mut self, course: Course, exit: &Exit) -> bool {
        let (side, crossing) = match (course, exit.upper, exit.lower) {
            (Course::Backward, Some(p), None) => (Side::Upper, p),
            (Course::Backward, None, Some(q)) => (Side::Lower, q),
            _ => return false,
        };
        let [i, k] = self.planes();
        let other = if side == Side::Upper { k } else { i };
        let trace = *self.chains.trace(crossing.trace);
        if crossing.node.is_none() || !self.chains.meets_coplanar(side, &trace, other) {
            return false;
        }
        let x = TraceId::raw(crossing.trace);
        self.append_upper(Walk::Down(x));
        self.prepend_lower(Walk::Up(x));
        (self.last_upper, self.first_lower) = (None, None);
        self.pass(side, &crossing, crossing.time);
        true
    }

    /// A trace that was never there has length zero.
    pub(super) fn void(&mut self, x: u32) {
        let id = TraceId::raw(x);
        let trace = self.chains.front.trace_mut(id);
        trace.end = End::At(trace.born);
        trace.after_up = Walk::Up(id);
        trace.after_down = Walk::Down(id);
    }

    /// The last stretch, to the eastern end.
    pub(super) fn finish(mut self, east: u32) -> Result<(), Trouble> {
        let rays = [self.upper, self.lower].map(|cursor| self.chains.waves[cursor.wave as usize]);
        if rays[0].start != NONE || rays[1].end != NONE {
            return self.trouble();
        }
        if !self.chains.planes.is_unweighted() {
            let [i, k] = self.planes();
            let (mut upper, mut lower) = (self.upper, self.lower);
            let end = self.chains.time_of(east);
            self.check_west(&mut upper, k, &end, false)?;
            self.check_west(&mut lower, i, &end, false)?;
        }
        self.stretch(Course::Backward, east);
        self.append_upper(rays[0].head);
        self.prepend_lower(rays[1].tail);
        Ok(())
    }
}
