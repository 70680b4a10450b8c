//! The merge chain (section 4): where the roofs of the two chains meet, walked from west to east.
//!
//! A stretch of it lies between a face of the upper chain, on its left, and one of the lower chain.
//! Where these two turn left, time goes on along it: it is the western end of what is not swept
//! yet. Where they turn right, time goes back: it is an eastern end, walked against its course. Where
//! they are parallel and face each other, it is a ridge of one height. It ends where it first
//! reaches the eastern boundary of either face; of several at one place, one after the other.
//!
//! Where the two faces lie on one plane, there is no merge chain between them: their wavefront
//! edges are one for a while, and a ghost arc separates the faces.

use std::cmp::Ordering;

use super::{
    boundary::{Crossing, Cursor, Look, Time},
    chains::{Chains, Join, NONE, Side, Trouble},
};
use crate::{
    predicates::{Bounds, Moment, PlaneId},
    topology::{TraceId, WaveId},
    wavefront::{End, EventNode, Trace, Walk},
};
use hipline_num::Sign;

/// The walk along the merge chain.
pub(super) struct Merge<'c, 'a> {
    chains: &'c mut Chains<'a>,
    upper: Cursor,
    lower: Cursor,
    /// Where it is.
    node: u32,
    now: Time,
    /// The last walk of the boundary of the upper face, the one after which is to be named.
    last_upper: Option<Walk>,
    /// The walk of the boundary of the lower face before which the next one comes.
    first_lower: Option<Walk>,
    /// A plane of the lower chain that is not perpendicular to the direction of monotonicity.
    flat: PlaneId,
    /// By wavefront edge: whether its face was left.
    left: Vec<bool>,
    /// The trace that goes on as the next stretch: see [`Merge::leave`].
    glued: Option<TraceId>,
}

/// How the merge chain goes on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Course {
    Forward,
    Backward,
    /// At one height.
    Level,
    /// The faces lie on one plane, and their wavefront edges move in time as in walking.
    Joint {
        forward: bool,
    },
}

/// Which boundaries the merge chain reaches first.
struct Exit {
    upper: Option<Crossing>,
    lower: Option<Crossing>,
}

impl<'c, 'a> Merge<'c, 'a> {
    /// Merges the two chains, which end at the given vertices.
    pub(super) fn run(
        chains: &'c mut Chains<'a>,
        [lower, upper]: [u32; 2],
        west: u32,
        east: u32,
        flat: PlaneId,
    ) -> Result<(), Trouble> {
        let first_lower = Some(chains.waves[lower as usize].head);
        let last_upper = Some(chains.waves[upper as usize].tail);
        let mut merge = Merge {
            upper: chains.at_start_of(Side::Upper, upper),
            lower: chains.at_start_of(Side::Lower, lower),
            chains,
            node: west,
            now: Time {
                moment: Moment::Start,
                bounds: Bounds::START,
            },
            last_upper,
            first_lower,
            flat,
            glued: None,
            left: Vec::new(),
        };
        merge.left = vec![false; merge.chains.waves.len()];
        merge.walk(east)
    }

    fn trouble<T>(&self) -> Result<T, Trouble> {
        Err(Trouble(self.chains.plane(self.upper.wave)))
    }

    fn planes(&self) -> [PlaneId; 2] {
        [self.upper, self.lower].map(|cursor| self.chains.plane(cursor.wave))
    }

    fn walk(mut self, east: u32) -> Result<(), Trouble> {
        loop {
            self.chains.steps += 1;
            if self.left[self.upper.wave as usize] || self.left[self.lower.wave as usize] {
                return self.trouble();
            }
            let course = self.course()?;
            let exit = match course {
                Course::Forward | Course::Backward => self.next_exit(course == Course::Forward)?,
                Course::Level => Some(self.level_exit()?),
                Course::Joint { forward } => Some(self.joint_exit(forward)?),
            };
            let Some(exit) = exit else {
                if course != Course::Backward {
                    return self.trouble();
                }
                return self.finish(east);
            };
            self.reach(course, &exit)?;
        }
    }

    /// How the merge chain goes on between two faces.
    fn course(&self) -> Result<Course, Trouble> {
        let planes = self.chains.planes;
        let [i, k] = self.planes();
        Ok(match planes.turn(i, k) {
            Sign::Positive => Course::Forward,
            Sign::Negative => Course::Backward,
            Sign::Zero if !planes.same_direction(i, k) => Course::Level,
            Sign::Zero if planes.coplanar(i, k) => Course::Joint {
                forward: planes.turn(i, self.flat) == Sign::Positive,
            },
            // One would overrun the other, further than its own chain lets it.
            Sign::Zero => return self.trouble(),
        })
    }

    /// The exit from either face that comes first.
    fn next_exit(&mut self, forward: bool) -> Result<Option<Exit>, Trouble> {
        let now = self.now;
        // From right before this moment on: what jumps at it, along a ridge of one height, may
        // jump over the merge chain.
        self.seek(false);
        loop {
            self.chains.steps += 1;
            let [i, k] = self.planes();
            let mut parts = [false; 2];
            let mut looks = [(self.upper, k), (self.lower, i)].map(|(cursor, plane)| {
                if forward {
                    self.chains.look_forward(&cursor, plane, &now)
                } else {
                    self.chains.look_backward(&cursor, plane, &now)
                }
            });
            let first = |a: &Time, b: &Time| {
                let order = self.chains.compare(a, b);
                if forward { order } else { order.reverse() }
            };
            for (side, cursor) in [self.upper, self.lower].iter().enumerate() {
                if forward || cursor.parts == NONE {
                    continue;
                }
                let join = self.chains.time_of_join(cursor.parts);
                let later = match &looks[side] {
                    Look::Crosses(Crossing { time, .. }) | Look::Until(time) => {
                        first(time, &join).is_gt()
                    }
                    Look::Never | Look::Lost => true,
                };
                if later {
                    looks[side] = Look::Until(join);
                    parts[side] = true;
                }
            }
            if looks.iter().any(|look| matches!(look, Look::Lost)) {
                return self.trouble();
            }
            let next = match looks {
                [Look::Crosses(p), Look::Crosses(q)] => {
                    let order = first(&p.time, &q.time);
                    return Ok(Some(Exit {
                        upper: order.is_le().then_some(p),
                        lower: order.is_ge().then_some(q),
                    }));
                }
                [Look::Crosses(p), Look::Until(t)] if first(&t, &p.time).is_lt() => Side::Lower,
                [Look::Until(t), Look::Crosses(q)] if first(&t, &q.time).is_lt() => Side::Upper,
                [Look::Crosses(p), _] => {
                    return Ok(Some(Exit {
                        upper: Some(p),
                        lower: None,
                    }));
                }
                [_, Look::Crosses(q)] => {
                    return Ok(Some(Exit {
                        upper: None,
                        lower: Some(q),
                    }));
                }
                [Look::Until(t), Look::Until(u)] if first(&t, &u).is_le() => Side::Upper,
                [Look::Until(_), Look::Never] => Side::Upper,
                [_, Look::Until(_)] => Side::Lower,
                _ => return Ok(None),
            };
            if parts[usize::from(next == Side::Lower)] {
                self.come_apart(next, if next == Side::Upper { k } else { i })?;
            } else {
                self.go_on(next, forward)?;
            }
        }
    }

    /// Going back in time, what was joined comes apart: the merge chain is in one of the parts.
    fn come_apart(&mut self, side: Side, plane: PlaneId) -> Result<(), Trouble> {
        let mut cursor = *self.cursor(side);
        let join = self.chains.joins[cursor.parts as usize];
        let node = self.chains.trace(join.ghost).born;
        if self.left[join.west as usize] || self.chains.ahead(node, plane) == Sign::Positive {
            cursor.parts = join.before;
            if !self.chains.planes.is_unweighted() {
                let now = self.chains.time_of(node);
                self.check_west(&mut cursor, plane, &now, false)?;
                cursor.west = self.chains.along_west(side, join.ghost, false);
            }
        } else {
            cursor = self.western_part(cursor, join);
        }
        *self.cursor(side) = cursor;
        Ok(())
    }

    /// With weights, what was cut off may come back in its own chain, over the western boundary of a face: then
    /// that chain is no longer what is true of the polygon. Goes along that boundary from where the
    /// cursor is up to a time; it must stay on its side.
    fn check_west(
        &self,
        cursor: &mut Cursor,
        plane: PlaneId,
        until: &Time,
        forward: bool,
    ) -> Result<(), Trouble> {
        let wrong = if forward {
            Sign::Positive
        } else {
            Sign::Negative
        };
        while cursor.west != NONE {
            let trace = *self.chains.trace(cursor.west);
            let stop = match (forward, trace.end) {
                (true, End::At(node)) => Some(node),
                (true, End::Moving) => None,
                (true, End::Ghost) | (false, _) => Some(trace.born),
            };
            if let Some(node) = stop {
                let order = self.chains.compare(&self.chains.time_of(node), until);
                if if forward {
                    order.is_le()
                } else {
                    order.is_ge()
                } {
                    if self.chains.ahead(node, plane) == wrong {
                        return self.trouble();
                    }
                    let next = if forward && trace.end == End::Ghost {
                        let parts = [trace.inn, trace.out].map(WaveId::index);
                        let west = parts[usize::from(cursor.side == Side::Upper)];
                        self.chains.joins[self.chains.waves[west].joined as usize].western
                    } else {
                        self.chains.along_west(cursor.side, cursor.west, forward)
                    };
                    if next == NONE {
                        return Ok(());
                    }
                    cursor.west = next;
                    continue;
                }
            }
            let proper = !trace.turn.is_zero() && until.moment != Moment::Start;
            if proper && self.chains.planes.lead(&until.moment, trace.pair, plane) == wrong {
                return self.trouble();
            }
            return Ok(());
        }
        Ok(())
    }

    /// The western part of a joint wavefront edge, right before it was joined.
    fn western_part(&self, cursor: Cursor, join: Join) -> Cursor {
        Cursor {
            wave: join.west,
            east: self.chains.before(cursor.side, join.ghost),
            parts: self.chains.waves[join.west as usize].last_join,
            ..cursor
        }
    }

    fn cursor(&mut self, side: Side) -> &mut Cursor {
        match side {
            Side::Upper => &mut self.upper,
            Side::Lower => &mut self.lower,
        }
    }

    /// Both cursors to this moment. A face that is there no more is left at once, where its
    /// boundary ended.
    fn seek(&mut self, forward: bool) {
        let now = self.now;
        for side in [Side::Upper, Side::Lower] {
            let mut cursor = *self.cursor(side);
            self.chains.seek(&mut cursor, &now, forward);
            cursor.parts = self.chains.last_join(cursor.wave, &now);
            *self.cursor(side) = cursor;
        }
    }

    /// One cursor to the next trace of its boundary.
    fn go_on(&mut self, side: Side, forward: bool) -> Result<(), Trouble> {
        let mut cursor = *self.cursor(side);
        let trace = *self.chains.trace(cursor.east);
        let next = match (forward, trace.end) {
            (true, End::Ghost) => {
                let join =
                    self.chains.joins[self.chains.waves[cursor.wave as usize].joined as usize];
                cursor.wave = join.east;
                join.boundary
            }
            (true, _) => match self.chains.after(side, cursor.east) {
                NONE => return self.trouble(),
                next => next,
            },
            (false, _) => match self.chains.before(side, cursor.east) {
                NONE => return self.trouble(),
                next => next,
            },
        };
        cursor.east = next;
        *self.cursor(side) = cursor;
        Ok(())
    }

    /// Where the ridge between two edges that face each other ends.
    fn level_exit(&mut self) -> Result<Exit, Trouble> {
        self.seek(false);
        let [i, _] = self.planes();
        self.level_parts();
        if self.is_overrun() {
            return self.trouble();
        }
        let at = |cursor: &Cursor| {
            (cursor.east != NONE)
                .then(|| self.chains.place_at(cursor, &self.now))
                .flatten()
        };
        let (upper, lower) = (at(&self.upper), at(&self.lower));
        if let Some(exit) = self.level_joint() {
            return Ok(exit);
        }
        let crossing = |cursor: &Cursor| {
            let end = self.chains.end_node(cursor.east);
            Crossing {
                trace: cursor.east,
                node: end.filter(|&n| {
                    self.chains
                        .compare(&self.chains.time_of(n), &self.now)
                        .is_eq()
                }),
                time: self.now,
            }
        };
        let order = match (&upper, &lower) {
            (Some(p), Some(q)) => self.chains.planes.compare_along(p, q, i),
            (Some(_), None) => Ordering::Greater,
            (None, Some(_)) => Ordering::Less,
            (None, None) => return self.trouble(),
        };
        Ok(Exit {
            upper: order.is_ge().then(|| crossing(&self.upper)),
            lower: order.is_le().then(|| crossing(&self.lower)),
        })
    }

    /// Whether an edge is overrun in its own chain at the very moment when it meets another one face to face:
    /// edges that meet come first then, which the chain could not know.
    fn is_overrun(&self) -> bool {
        let chains = &*self.chains;
        let overruns = |x: u32| {
            x != NONE && {
                let trace = chains.trace(x);
                let [a, b] = [trace.inn, trace.out].map(|w| chains.front.wave(w).plane);
                trace.end != End::Ghost
                    && trace.turn.is_zero()
                    && chains.planes.same_direction(a, b)
                    && chains
                        .compare(&chains.time_of(trace.born), &self.now)
                        .is_eq()
            }
        };
        !chains.planes.is_unweighted()
            && [self.upper, self.lower].iter().any(|cursor| {
                let after = match cursor.east {
                    NONE => NONE,
                    east => chains.after(cursor.side, east),
                };
                [cursor.west, cursor.east, after].into_iter().any(overruns)
            })
    }

    /// Where edges of one chain meet face to face now, and one of them has been one with the edge on the other
    /// side for a while, the ridge between these two ends here.
    fn level_joint(&self) -> Option<Exit> {
        let [i, k] = self.planes();
        for (cursor, other, plane) in [(self.upper, self.lower, k), (self.lower, self.upper, i)] {
            if cursor.east == NONE || other.east == NONE {
                continue;
            }
            let x = self.chains.after(cursor.side, cursor.east);
            if x == NONE {
                continue;
            }
            let trace = *self.chains.trace(x);
            let starts = self.chains.time_of(trace.born);
            if !trace.turn.is_zero()
                || self.chains.compare(&starts, &self.now).is_ne()
                || !self.chains.meets_coplanar(cursor.side, &trace, plane)
            {
                continue;
            }
            let mut beyond = self
                .chains
                .at_start_of(cursor.side, self.chains.beyond(cursor.side, x));
            self.chains.look_up(&mut beyond, &self.now);
            let ends = [beyond, other].map(|cursor| {
                (cursor.east != NONE)
                    .then(|| self.chains.place_at(&cursor, &self.now))
                    .flatten()
            });
            let [Some(p), Some(q)] = ends else { continue };
            let order = self.chains.planes.compare_along(&p, &q, plane);
            let overlap = match cursor.side {
                Side::Upper => order.is_lt(),
                Side::Lower => order.is_gt(),
            };
            if overlap {
                let crossing = Crossing {
                    trace: x,
                    node: None,
                    time: self.now,
                };
                return Some(match cursor.side {
                    Side::Upper => Exit {
                        upper: Some(crossing),
                        lower: None,
                    },
                    Side::Lower => Exit {
                        upper: None,
                        lower: Some(crossing),
                    },
                });
            }
        }
        None
    }

    /// What is joined only now does not count yet, where edges meet face to face: goes to the part
    /// that the merge chain is in.
    fn level_parts(&mut self) {
        let here = self.chains.place_of(self.node);
        for side in [Side::Upper, Side::Lower] {
            let mut cursor = *self.cursor(side);
            while cursor.parts != NONE {
                let join = self.chains.joins[cursor.parts as usize];
                if self
                    .chains
                    .compare(&self.chains.time_of_join(cursor.parts), &self.now)
                    .is_lt()
                {
                    break;
                }
                let ghost = self.chains.place_of(self.chains.trace(join.ghost).born);
                let plane = self.chains.plane(cursor.wave);
                let order = self.chains.planes.compare_along(&ghost, &here, plane);
                let west = match side {
                    Side::Upper => order.is_le(),
                    Side::Lower => order.is_ge(),
                };
                if west && !self.left[join.west as usize] {
                    cursor = self.western_part(cursor, join);
                } else {
                    cursor.parts = join.before;
                }
            }
            *self.cursor(side) = cursor;
        }
    }

    /// Where the wavefront edges on one plane, which are one, start or end to be so.
    fn joint_exit(&mut self, forward: bool) -> Result<Exit, Trouble> {
        self.seek(forward);
        let [i, _] = self.planes();
        loop {
            self.chains.steps += 1;
            let (s, e) = (self.upper.east, self.lower.east);
            if s == NONE || e == NONE {
                return self.trouble();
            }
            // The end of the one that ends first, and what is there.
            let stop = |x: u32| {
                let trace = self.chains.trace(x);
                match (forward, trace.end) {
                    (false, _) | (true, End::Ghost) => Some(trace.born),
                    (true, End::At(node)) => Some(node),
                    (true, End::Moving) => None,
                }
            };
            let (s_stop, e_stop) = (stop(s), stop(e));
            let side = match (s_stop, e_stop) {
                (Some(p), Some(q)) => {
                    let order = self
                        .chains
                        .compare(&self.chains.time_of(p), &self.chains.time_of(q));
                    if (if forward { order } else { order.reverse() }).is_le() {
                        Side::Upper
                    } else {
                        Side::Lower
                    }
                }
                (Some(_), None) => Side::Upper,
                (None, Some(_)) => Side::Lower,
                (None, None) => return self.joint_crossing(s, e),
            };
            let node = if side == Side::Upper { s_stop } else { e_stop };
            let node = node.expect("just chosen");
            let then = self.chains.time_of(node);
            let [p, q] =
                [self.upper, self.lower].map(|cursor| self.chains.place_at(&cursor, &then));
            let (Some(p), Some(q)) = (p, q) else {
                return self.trouble();
            };
            // As long as they are one, the upper one's vertex is before the lower one's.
            if self.chains.planes.compare_along(&p, &q, i).is_ge() {
                return self.joint_crossing(s, e);
            }
            if forward
                && self
                    .chains
                    .trace(if side == Side::Upper { s } else { e })
                    .end
                    != End::Ghost
                && self
                    .chains
                    .after(side, if side == Side::Upper { s } else { e })
                    == NONE
            {
                // One of them vanishes, in its own chain; the other goes on.
                let crossing = Crossing {
                    trace: if side == Side::Upper { s } else { e },
                    node: Some(node),
                    time: then,
                };
                return Ok(match side {
                    Side::Upper => Exit {
                        upper: Some(crossing),
                        lower: None,
                    },
                    Side::Lower => Exit {
                        upper: None,
                        lower: Some(crossing),
                    },
                });
            }
            self.go_on(side, forward)?;
        }
    }

    /// The traces at both ends of a joint wavefront edge meet.
    fn joint_crossing(&self, s: u32, e: u32) -> Result<Exit, Trouble> {
        let [i, _] = self.planes();
        let beyond = [
            self.chains.trace(s).inn.index(),
            self.chains.trace(e).out.index(),
        ]
        .map(|w| self.chains.plane(w as u32));
        let triple = [beyond[0], i, beyond[1]];
        let level = [s, e].map(|x| self.chains.trace(x).turn.is_zero());
        let time = match level {
            [true, true] => return self.trouble(),
            [true, false] => self.chains.time_of(self.chains.trace(s).born),
            [false, true] => self.chains.time_of(self.chains.trace(e).born),
            _ if !self.chains.planes.do_meet(triple) => return self.trouble(),
            _ => self.chains.meeting(triple),
        };
        if level != [false; 2] {
            // The level one is cut where the other one is then.
            let crossing = |x: u32, level: bool| Crossing {
                trace: x,
                node: self.chains.end_node(x).filter(|&n| {
                    !level && self.chains.compare(&self.chains.time_of(n), &time).is_eq()
                }),
                time,
            };
            return Ok(Exit {
                upper: Some(crossing(s, level[0])),
                lower: Some(crossing(e, level[1])),
            });
        }
        let crossing = |x: u32| {
            let nodes = [self.chains.end_node(x), Some(self.chains.trace(x).born)];
            Crossing {
                trace: x,
                node: nodes
                    .into_iter()
                    .flatten()
                    .find(|&n| self.chains.compare(&self.chains.time_of(n), &time).is_eq()),
                time,
            }
        };
        Ok(Exit {
            upper: Some(crossing(s)),
            lower: Some(crossing(e)),
        })
    }

    /// The merge chain gets to where it leaves a face, or both.
    fn reach(&mut self, course: Course, exit: &Exit) -> Result<(), Trouble> {
        let any = exit.upper.or(exit.lower).expect("there is an exit");
        let here = match course {
            Course::Level => self.is_at(exit),
            _ => self.chains.compare(&any.time, &self.now).is_eq(),
        };
        let mut node = if here { Some(self.node) } else { None };
        for crossing in [exit.upper, exit.lower].into_iter().flatten() {
            if let Some(n) = crossing.node {
                node = Some(match node {
                    Some(m) if m < self.chains.front.vertices => m,
                    Some(m) => self.chains.front.same_node(m, n),
                    None => n,
                });
            }
        }
        let steep = [exit.lower, exit.upper]
            .into_iter()
            .flatten()
            .find(|crossing| !self.chains.trace(crossing.trace).turn.is_zero());
        let node = node.unwrap_or_else(|| self.new_node(course, &steep.unwrap_or(any)));
        if here && course == (Course::Joint { forward: false }) && self.last_upper.is_none() {
            return self.trouble();
        }
        if !here {
            if self.glues(course, exit) {
                (self.node, self.now) = (node, any.time);
                return match self.course()? {
                    Course::Joint { forward: false } => Ok(()),
                    _ => self.trouble(),
                };
            }
            if !self.chains.planes.is_unweighted()
                && matches!(course, Course::Forward | Course::Backward)
            {
                let [i, k] = self.planes();
                let (mut upper, mut lower) = (self.upper, self.lower);
                let forward = course == Course::Forward;
                self.check_west(&mut upper, k, &any.time, forward)?;
                self.check_west(&mut lower, i, &any.time, forward)?;
                (self.upper, self.lower) = (upper, lower);
            }
            self.stretch(course, node);
            self.node = node;
            self.now = any.time;
        }
        if let Some(crossing) = exit.lower {
            self.leave(Side::Lower, &crossing);
        }
        if let Some(crossing) = exit.upper {
            self.leave(Side::Upper, &crossing);
        }
        self.leave_dead(Side::Lower);
        self.leave_dead(Side::Upper);
        Ok(())
    }

    /// Leaves the faces of wavefront edges that vanish right here.
    fn leave_dead(&mut self, side: Side) {
        loop {
            let wave = self.cursor(side).wave;
            let death = self.chains.waves[wave as usize].death;
            if death == NONE || self.chains.front.node(death) != self.chains.front.node(self.node) {
                return;
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

    /// Whether a ridge of one height has length zero.
    fn is_at(&self, exit: &Exit) -> bool {
        let fresh = |crossing: &Option<Crossing>, cursor: &Cursor| {
            crossing.is_some_and(|crossing| crossing.trace != cursor.east)
        };
        if fresh(&exit.upper, &self.upper) || fresh(&exit.lower, &self.lower) {
            return true;
        }
        let here = self.chains.place_of(self.node);
        let [i, _] = self.planes();
        let at = |cursor: &Cursor| {
            self.chains
                .place_at(cursor, &self.now)
                .is_some_and(|place| self.chains.planes.compare_along(&place, &here, i).is_eq())
        };
        exit.upper.is_some() && at(&self.upper) || exit.lower.is_some() && at(&self.lower)
    }

    fn new_node(&mut self, course: Course, crossing: &Crossing) -> u32 {
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
    fn stretch(&mut self, course: Course, node: u32) {
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
    fn ghost(&mut self, forward: bool, node: u32) {
        let [upper, lower] = [self.upper, self.lower].map(|c| WaveId::raw(c.wave));
        let [i, k] = self.planes();
        let (inn, out, born) = if forward {
            (upper, lower, self.node)
        } else {
            (lower, upper, node)
        };
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

    fn set_after(&mut self, walk: Walk, after: Walk) {
        let front = &mut self.chains.front;
        match walk {
            Walk::Up(x) => front.trace_mut(x).after_up = after,
            Walk::Down(x) => front.trace_mut(x).after_down = after,
            Walk::Base(face) => front.after_base[face as usize] = after,
            Walk::Open => unreachable!("a walk"),
        }
    }

    /// The boundary of the upper face goes on along a walk.
    fn append_upper(&mut self, walk: Walk) {
        match self.last_upper.replace(walk) {
            Some(last) => self.set_after(last, walk),
            // After a joint face that only the lower one was left of.
            None => self.first_lower = Some(walk),
        }
    }

    /// Before the boundary of the lower face goes on, it goes along a walk.
    fn prepend_lower(&mut self, walk: Walk) {
        match self.first_lower.replace(walk) {
            Some(first) => self.set_after(walk, first),
            None => self.last_upper = Some(walk),
        }
    }

    /// Leaves a face over a trace of its eastern boundary: cuts it there, and forgets what
    /// comes later.
    fn leave(&mut self, side: Side, crossing: &Crossing) {
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
    fn pass(&mut self, side: Side, crossing: &Crossing, now: Time) {
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
    fn glues(&mut self, course: Course, exit: &Exit) -> bool {
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
    fn void(&mut self, x: u32) {
        let id = TraceId::raw(x);
        let trace = self.chains.front.trace_mut(id);
        trace.end = End::At(trace.born);
        trace.after_up = Walk::Up(id);
        trace.after_down = Walk::Down(id);
    }

    /// The last stretch, to the eastern end.
    fn finish(mut self, east: u32) -> Result<(), Trouble> {
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
