//! Neighbours on one line: join, or the faster wins. The rules and their order are those of the
//! kinetic engine (`docs/weights.md`).

use std::cmp::Ordering;

use super::chains::{Chains, Join, NONE, Side, Trouble};
use crate::{
    predicates::PlaneId,
    topology::{TraceId, WaveId},
    wavefront::{End, Walk},
};
use hipline_num::Sign;

impl Chains<'_> {
    /// Neighbours on one line at time zero; the rays end at the given vertices, if they do.
    pub(super) fn start_straight(&mut self, ends: [Option<u32>; 2]) -> Result<(), Trouble> {
        // What is on one line stays there: each run of straight vertices is on its own.
        let mut list = std::mem::take(&mut self.straight);
        list.reverse();
        while let Some(x) = list.pop() {
            let mut run = vec![x];
            while let Some(&y) = list.last()
                && self.front.trace(y).inn == self.front.trace(run[run.len() - 1]).out
            {
                run.push(y);
                list.pop();
            }
            while !run.is_empty() {
                run.retain(|&x| self.front.trace(x).end == End::Moving);
                let Some(i) = self.most_urgent(&run) else {
                    break;
                };
                let x = run.swap_remove(i);
                if self.speeds_at(x).is_eq() {
                    self.join(x);
                } else {
                    self.overrun_at_start(x, ends)?;
                }
            }
        }
        Ok(())
    }

    /// Removes the straight vertices of this moment.
    pub(super) fn remove_straight(&mut self) -> Result<(), Trouble> {
        while !self.straight.is_empty() {
            let mut list = std::mem::take(&mut self.straight);
            list.retain(|&x| self.front.trace(x).end == End::Moving);
            // All that join may do so in any order.
            let (joint, mut rest): (Vec<TraceId>, Vec<TraceId>) =
                list.into_iter().partition(|&x| self.speeds_at(x).is_eq());
            if !joint.is_empty() {
                joint.into_iter().for_each(|x| self.join(x));
            } else if let Some(i) = self.most_urgent(&rest) {
                let x = rest.swap_remove(i);
                self.overrun(x)?;
            }
            self.straight.append(&mut rest);
        }
        Ok(())
    }

    fn plane_of(&self, wave: WaveId) -> PlaneId {
        self.front.wave(wave).plane
    }

    /// Compares the speeds before and after a straight vertex.
    fn speeds_at(&self, x: TraceId) -> Ordering {
        let trace = self.front.trace(x);
        self.planes
            .compare_speeds(self.plane_of(trace.inn), self.plane_of(trace.out))
    }

    /// The straight vertex to be removed first: one between equally fast ones; else the one with
    /// the fastest, of equally fast ones one that overruns what is after it.
    fn most_urgent(&self, list: &[TraceId]) -> Option<usize> {
        let fastest = |x: TraceId| {
            let trace = self.front.trace(x);
            let [a, b] = [trace.inn, trace.out].map(|w| self.plane_of(w));
            if self.planes.compare_speeds(a, b).is_ge() {
                a
            } else {
                b
            }
        };
        let urgency = |x: TraceId, y: TraceId| {
            let [p, q] = [x, y].map(|x| self.speeds_at(x));
            p.is_eq()
                .cmp(&q.is_eq())
                .then_with(|| self.planes.compare_speeds(fastest(x), fastest(y)))
                .then_with(|| p.cmp(&q))
                .then_with(|| y.cmp(&x))
        };
        (0..list.len()).max_by(|&i, &j| urgency(list[i], list[j]))
    }

    /// Two wavefront edges on one plane become one: the eastern one takes the other over.
    fn join(&mut self, x: TraceId) {
        let [a, b] = self.beside(x).map(|w| w as usize);
        let side = self.waves[a].side;
        let (west, east) = match side {
            Side::Lower => (a, b),
            Side::Upper => (b, a),
        };
        self.ghosts = true;
        self.front.trace_mut(x).end = End::Ghost;
        self.front.trace_mut(x).after_up = Walk::Down(x);
        let (first, last) = (self.waves[a], self.waves[b]);
        let (boundary, western) = match side {
            Side::Lower => (last.end, first.start),
            Side::Upper => (first.start, last.end),
        };
        let join = self.joins.len() as u32;
        self.joins.push(Join {
            ghost: x.index() as u32,
            west: west as u32,
            east: east as u32,
            boundary,
            western,
            before: self.waves[east].last_join,
        });
        self.waves[west].joined = join;
        let kept = &mut self.waves[east];
        kept.last_join = join;
        (kept.prev, kept.start, kept.head) = (first.prev, first.start, first.head);
        (kept.next, kept.end, kept.tail) = (last.next, last.end, last.tail);
        kept.bases = [first.bases[0], last.bases[1]];
        self.dequeue(west as u32);
        self.takes_place(east as u32);
    }

    /// The neighbours of a wavefront edge know it, and may collapse at another moment. (The vertices at
    /// its ends do not: where the joint face is cut apart afterwards, or never was one, they belong to
    /// the part that they had.)
    fn takes_place(&mut self, w: u32) {
        let wave = self.waves[w as usize];
        if wave.start != NONE {
            self.waves[wave.prev as usize].next = w;
            self.fresh_again(TraceId::raw(wave.start));
        }
        if wave.end != NONE {
            self.waves[wave.next as usize].prev = w;
            self.fresh_again(TraceId::raw(wave.end));
        }
    }

    /// The wavefront edges beside a vertex, as they are now.
    pub(super) fn beside(&self, x: TraceId) -> [u32; 2] {
        let trace = self.front.trace(x);
        [trace.inn, trace.out].map(|wave| {
            let mut w = wave.index() as u32;
            while self.waves[w as usize].joined != NONE {
                w = self.joins[self.waves[w as usize].joined as usize].east;
            }
            w
        })
    }

    /// At time zero, a vertex lies between other wavefront edges than it seemed.
    fn rename(&mut self, x: TraceId, inn: Option<u32>, out: Option<u32>) {
        let plane = |w: WaveId| self.front.wave(w).plane;
        let mut trace = *self.front.trace(x);
        trace.inn = inn.map_or(trace.inn, WaveId::raw);
        trace.out = out.map_or(trace.out, WaveId::raw);
        let [i, j] = [trace.inn, trace.out].map(plane);
        trace.pair = if trace.turn == Sign::Negative {
            [j, i]
        } else {
            [i, j]
        };
        *self.front.trace_mut(x) = trace;
    }

    /// At time zero the faster one of two wavefront edges on one line overruns the slower one,
    /// along its base.
    fn overrun_at_start(&mut self, x: TraceId, ends: [Option<u32>; 2]) -> Result<(), Trouble> {
        let [a, b] = self.beside(x).map(|w| w as usize);
        if self.speeds_at(x).is_lt() {
            let slow = self.waves[a];
            let far = match slow.start {
                NONE => ends[0].ok_or(Trouble(slow.plane))?,
                start => self.trace(start).born,
            };
            let trace = self.front.trace_mut(x);
            trace.end = End::At(far);
            trace.after_up = Walk::Base(slow.bases[0]);
            self.waves[a].death = far;
            let kept = &mut self.waves[b];
            (kept.prev, kept.start) = (slow.prev, slow.start);
            if slow.start == NONE {
                kept.head = Walk::Down(x);
            } else {
                let start = TraceId::raw(slow.start);
                self.rename(start, None, Some(b as u32));
                self.start_goes_on(x, start);
            }
            self.takes_place(b as u32);
        } else {
            let slow = self.waves[b];
            let far = match slow.end {
                NONE => ends[1].ok_or(Trouble(slow.plane))?,
                end => self.trace(end).born,
            };
            self.front.trace_mut(x).end = End::At(far);
            self.front.after_base[slow.bases[1] as usize] = Walk::Down(x);
            self.waves[b].death = far;
            let kept = &mut self.waves[a];
            (kept.next, kept.end) = (slow.next, slow.end);
            if slow.end == NONE {
                kept.tail = Walk::Up(x);
            } else {
                let end = TraceId::raw(slow.end);
                self.rename(end, Some(a as u32), None);
                self.end_goes_on(x, end);
            }
            self.takes_place(a as u32);
        }
        Ok(())
    }

    /// The faster one of two wavefront edges on one line overruns the slower one, to its far end.
    fn overrun(&mut self, x: TraceId) -> Result<(), Trouble> {
        let [a, b] = self.beside(x).map(|w| w as usize);
        if self.speeds_at(x).is_lt() {
            let slow = self.waves[a];
            if slow.start == NONE {
                return Err(Trouble(slow.plane));
            }
            let far = TraceId::raw(slow.start);
            let node = self.node_now(far);
            self.dequeue(a as u32);
            self.waves[a].death = node;
            self.front.trace_mut(x).end = End::At(node);
            self.front.trace_mut(far).end = End::At(node);
            self.front.vanishes(far, x);
            let new = self.spawn(slow.prev, b as u32, node, Some(far));
            self.end_goes_on(far, new);
            self.start_goes_on(x, new);
        } else {
            let slow = self.waves[b];
            if slow.end == NONE {
                return Err(Trouble(slow.plane));
            }
            let far = TraceId::raw(slow.end);
            let node = self.node_now(far);
            self.dequeue(b as u32);
            self.waves[b].death = node;
            self.front.trace_mut(x).end = End::At(node);
            self.front.trace_mut(far).end = End::At(node);
            self.front.vanishes(x, far);
            let new = self.spawn(a as u32, slow.next, node, Some(far));
            self.end_goes_on(x, new);
            self.start_goes_on(far, new);
        }
        Ok(())
    }
}
