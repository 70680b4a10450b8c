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

mod level;
mod links;

use super::{
    boundary::{Crossing, Cursor, Look, Time},
    chains::{Chains, Join, NONE, Side, Trouble},
};
use crate::{
    predicates::{Bounds, Moment, PlaneId},
    topology::{TraceId, WaveId},
    wavefront::{End, Walk},
};
use hipline_num::Sign;
use std::cmp::Ordering;

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
            // A ridge of one height that follows at the same moment may cross it, too.
            let earlier = |cursor: &Cursor, stop: &Time, other: &Time| match first(stop, other) {
                Ordering::Less => true,
                Ordering::Equal => {
                    !parts[usize::from(cursor.side == Side::Lower)]
                        && self.jumps_next(cursor, forward)
                }
                Ordering::Greater => false,
            };
            let next = match looks {
                [Look::Crosses(p), Look::Crosses(q)] => {
                    let order = first(&p.time, &q.time);
                    return Ok(Some(Exit {
                        upper: order.is_le().then_some(p),
                        lower: order.is_ge().then_some(q),
                    }));
                }
                [Look::Crosses(p), Look::Until(t)] if earlier(&self.lower, &t, &p.time) => {
                    Side::Lower
                }
                [Look::Until(t), Look::Crosses(q)] if earlier(&self.upper, &t, &q.time) => {
                    Side::Upper
                }
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

    /// Whether what comes next along a boundary is a ridge of one height.
    fn jumps_next(&self, cursor: &Cursor, forward: bool) -> bool {
        let next = if forward {
            self.chains.after(cursor.side, cursor.east)
        } else {
            self.chains.before(cursor.side, cursor.east)
        };
        next != NONE && self.chains.trace(next).turn.is_zero()
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
    ///
    /// Where the merge chain goes back in time, the part of the face beside it is there until it is cut off; so the
    /// boundary must not even touch it before, nor run along it: where it does, the wavefront edge has length zero in the
    /// polygon, and is gone, though it goes on in its chain. Where the merge chain goes on in time, what touches it was
    /// cut off before.
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
                    let side = self.chains.ahead(node, plane);
                    let time = self.chains.time_of(node);
                    let is_later = order.is_ne() || until.moment != Moment::Start;
                    let inside = is_later && self.chains.compare(&time, &self.now).is_ne();
                    if side == wrong || side.is_zero() && !forward && inside {
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
            if proper {
                let side = self.chains.planes.lead(&until.moment, trace.pair, plane);
                if side == wrong || side.is_zero() && !forward {
                    return self.trouble();
                }
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
}
