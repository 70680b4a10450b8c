//! Where faces are parallel: ridges of one height, and faces on one plane.

use std::cmp::Ordering;

use super::{Exit, Merge};
use crate::{
    monotone::{
        boundary::{Crossing, Cursor},
        chains::{NONE, Side, Trouble},
    },
    predicates::PlaneId,
    wavefront::End,
};

impl Merge<'_, '_> {
    /// Where the ridge between two edges that face each other ends.
    pub(super) fn level_exit(&mut self) -> Result<Exit, Trouble> {
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
    pub(super) fn is_overrun(&self) -> bool {
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
    pub(super) fn level_joint(&self) -> Option<Exit> {
        let [i, k] = self.planes();
        for (cursor, other, plane) in [(self.upper, self.lower, k), (self.lower, self.upper, i)] {
            if cursor.east == NONE || other.east == NONE {
                continue;
            }
            let Some(x) = self.jump_to(&cursor, plane) else {
                continue;
            };
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

    /// The ridge of this moment over which the eastern boundary jumps, if beyond it is a plane of the other chain.
    fn jump_to(&self, cursor: &Cursor, plane: PlaneId) -> Option<u32> {
        let mut x = self.chains.after(cursor.side, cursor.east);
        while x != NONE {
            let trace = *self.chains.trace(x);
            let starts = self.chains.time_of(trace.born);
            if !trace.turn.is_zero() || self.chains.compare(&starts, &self.now).is_ne() {
                return None;
            }
            if self.chains.meets_coplanar(cursor.side, &trace, plane) {
                return Some(x);
            }
            x = self.chains.after(cursor.side, x);
        }
        None
    }

    /// What is joined only now does not count yet, where edges meet face to face: goes to the part
    /// that the merge chain is in.
    pub(super) fn level_parts(&mut self) {
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
    pub(super) fn joint_exit(&mut self, forward: bool) -> Result<Exit, Trouble> {
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
            // A trace of one height is at both of its ends then: the node tells which one counts.
            let place = |cursor: &Cursor| {
                if cursor.side == side {
                    Some(self.chains.place_of(node))
                } else {
                    self.chains.place_at(cursor, &then)
                }
            };
            let (p, q) = (place(&self.upper), place(&self.lower));
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
    pub(super) fn joint_crossing(&self, s: u32, e: u32) -> Result<Exit, Trouble> {
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
            let steep = if level[0] { e } else { s };
            let ends = |x: u32| {
                let nodes = [self.chains.end_node(x), Some(self.chains.trace(x).born)];
                nodes.into_iter().flatten()
            };
            let node =
                ends(steep).find(|&n| self.chains.compare(&self.chains.time_of(n), &time).is_eq());
            let crossing = |x: u32, level: bool| Crossing {
                trace: x,
                node: node.filter(|_| !level),
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

    /// Whether a ridge of one height has length zero.
    pub(super) fn is_at(&self, exit: &Exit) -> bool {
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
}
