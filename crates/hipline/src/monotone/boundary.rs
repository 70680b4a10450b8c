//! Where the merge chain leaves a face: the eastern boundaries of faces, asked in the order of time.
//!
//! A wavefront edge of a chain is in one piece as long as it lives. So, over time, its face lies
//! between two boundaries, each a list of traces in the order of time, whatever the face looks
//! like in plan: also with weights no trapezoidation is needed. The merge chain visits the faces
//! of either chain from west to east, and leaves each one over its eastern boundary, for good.

use std::cmp::Ordering;

use super::chains::{Chains, NONE, Side};
use crate::{
    predicates::{Bounds, Moment, Place, PlaneId},
    wavefront::{End, EventNode, Trace},
};
use hipline_num::Sign;

/// A moment and its bounds.
#[derive(Clone, Copy, Debug)]
pub(super) struct Time {
    pub moment: Moment,
    pub bounds: Bounds,
}

/// Where the merge chain is on one side: in the face of a wavefront edge, beside a trace of its
/// eastern boundary (none: it is the eastern ray).
#[derive(Clone, Copy, Debug)]
pub(super) struct Cursor {
    pub side: Side,
    pub wave: u32,
    pub east: u32,
    /// The last join of the wavefront edge that going back in time has not passed yet.
    pub parts: u32,
    /// The trace of the western boundary there (none: it is the western ray). Only with weights.
    pub west: u32,
}

/// The merge chain reaches an eastern boundary.
#[derive(Clone, Copy, Debug)]
pub(super) struct Crossing {
    pub trace: u32,
    /// The node of the chain where it does, if it is at one.
    pub node: Option<u32>,
    pub time: Time,
}

/// What a stretch of boundary has to say.
pub(super) enum Look {
    /// The merge chain crosses it.
    Crosses(Crossing),
    /// It does not; go on with what comes next, at this time.
    Until(Time),
    /// It does not, and nothing comes next.
    Never,
    /// The merge chain is beyond it already. With weights, what was cut off may come back in its own chain.
    Lost,
}

impl Chains<'_> {
    pub(super) fn compare(&self, a: &Time, b: &Time) -> Ordering {
        if a.moment == b.moment {
            return Ordering::Equal;
        }
        a.bounds
            .compare(b.bounds)
            .unwrap_or_else(|| self.planes.compare(&a.moment, &b.moment))
    }

    pub(super) fn time_of(&self, node: u32) -> Time {
        Time {
            moment: self.moment(node),
            bounds: self.bounds_of(node),
        }
    }

    /// The moment when three planes meet.
    pub(super) fn meeting(&self, planes: [PlaneId; 3]) -> Time {
        let moment = Moment::of_planes(planes);
        Time {
            moment,
            bounds: self.planes.bounds(&moment),
        }
    }

    pub(super) fn plane(&self, wave: u32) -> PlaneId {
        self.waves[wave as usize].plane
    }

    /// The trace after another one along the eastern boundary.
    pub(super) fn after(&self, side: Side, x: u32) -> u32 {
        let links = &self.links[x as usize];
        match side {
            Side::Lower => links.next_in,
            Side::Upper => links.next_out,
        }
    }

    /// The trace before another one along the eastern boundary.
    pub(super) fn before(&self, side: Side, x: u32) -> u32 {
        let links = &self.links[x as usize];
        match side {
            Side::Lower => links.prev_in,
            Side::Upper => links.prev_out,
        }
    }

    /// The trace after or before another one along the western boundary.
    pub(super) fn along_west(&self, side: Side, x: u32, forward: bool) -> u32 {
        let links = &self.links[x as usize];
        match (side, forward) {
            (Side::Lower, true) => links.next_out,
            (Side::Lower, false) => links.prev_out,
            (Side::Upper, true) => links.next_in,
            (Side::Upper, false) => links.prev_in,
        }
    }

    /// The wavefront edge beyond a trace of an eastern boundary, when it started.
    pub(super) fn beyond(&self, side: Side, x: u32) -> u32 {
        let trace = self.trace(x);
        match side {
            Side::Lower => trace.out.index() as u32,
            Side::Upper => trace.inn.index() as u32,
        }
    }

    /// The first trace of an eastern boundary.
    fn first_east(&self, side: Side, wave: u32) -> u32 {
        match side {
            Side::Lower => self.waves[wave as usize].first_end,
            Side::Upper => self.waves[wave as usize].first_start,
        }
    }

    /// On which side of a plane a node is: positive where that plane comes later.
    pub(super) fn ahead(&self, node: u32, plane: PlaneId) -> Sign {
        match node.checked_sub(self.front.vertices) {
            Some(event) => {
                let EventNode { pair, moment } = self.front.events[event as usize];
                self.planes.lead(&Moment::Planes(moment), pair, plane)
            }
            None => {
                let place = Place::Vertex(self.vertices[node as usize]);
                self.planes.ahead(&place, plane)
            }
        }
    }

    /// A cursor beyond a trace of an eastern boundary, at the given time.
    pub(super) fn enter(&self, side: Side, x: u32, now: &Time) -> Cursor {
        let mut wave = self.beyond(side, x);
        // It may have become part of another since.
        while self.waves[wave as usize].joined != NONE {
            let join = self.waves[wave as usize].joined;
            if self.compare(&self.time_of_join(join), now).is_ge() {
                break;
            }
            wave = self.joins[join as usize].east;
        }
        self.at_start_of(side, wave)
    }

    /// A cursor at the start of an eastern boundary.
    pub(super) fn at_start_of(&self, side: Side, wave: u32) -> Cursor {
        Cursor {
            side,
            wave,
            east: self.first_east(side, wave),
            parts: NONE,
            west: NONE,
        }
    }

    /// The last join of a wavefront edge until now, after time zero.
    pub(super) fn last_join(&self, wave: u32, now: &Time) -> u32 {
        let mut join = self.waves[wave as usize].last_join;
        while join != NONE && self.compare(&self.time_of_join(join), now).is_gt() {
            join = self.joins[join as usize].before;
        }
        if join != NONE && self.time_of_join(join).moment == Moment::Start {
            return NONE;
        }
        join
    }

    /// When two wavefront edges were joined.
    pub(super) fn time_of_join(&self, join: u32) -> Time {
        self.time_of(self.trace(self.joins[join as usize].ghost).born)
    }

    /// Moves a cursor along the boundary to the given time: to what is there right after it, or
    /// right before it. Returns whether the face is there at all.
    pub(super) fn seek(&mut self, cursor: &mut Cursor, now: &Time, forward: bool) -> bool {
        loop {
            self.steps += 1;
            if cursor.east == NONE {
                return true;
            }
            let trace = *self.trace(cursor.east);
            let starts = self.compare(&self.time_of(trace.born), now);
            // A ghost is no boundary: there, the wavefront edge becomes part of the one beyond.
            if trace.end == End::Ghost && (starts.is_lt() || starts.is_eq() && forward) {
                let wave = cursor.wave as usize;
                let join = self.joins[self.waves[wave].joined as usize];
                cursor.wave = join.east;
                cursor.east = join.boundary;
                continue;
            }
            if starts.is_gt() || starts.is_eq() && !forward {
                let before = self.before(cursor.side, cursor.east);
                if before == NONE {
                    return true;
                }
                cursor.east = before;
                continue;
            }
            if let End::At(end) = trace.end {
                let ends = self.compare(&self.time_of(end), now);
                if ends.is_lt() || ends.is_eq() && forward {
                    let after = self.after(cursor.side, cursor.east);
                    if after == NONE {
                        return false;
                    }
                    cursor.east = after;
                    continue;
                }
            }
            return true;
        }
    }

    /// Moves a cursor from the start of a boundary to what is there right before a time.
    pub(super) fn look_up(&self, cursor: &mut Cursor, now: &Time) {
        while cursor.east != NONE
            && let End::At(end) = self.trace(cursor.east).end
            && self.compare(&self.time_of(end), now).is_lt()
        {
            match self.after(cursor.side, cursor.east) {
                NONE => break,
                after => cursor.east = after,
            }
        }
    }

    /// The moment when a trace meets a plane.
    fn crossing(&self, x: u32, plane: PlaneId) -> Time {
        let trace = self.trace(x);
        if trace.turn.is_zero() {
            self.time_of(trace.born)
        } else {
            self.meeting([trace.pair[0], trace.pair[1], plane])
        }
    }

    /// Whether the wavefront edge beyond a trace lies on a plane of the other chain.
    pub(super) fn meets_coplanar(&self, side: Side, trace: &Trace, plane: PlaneId) -> bool {
        let wave = match side {
            Side::Lower => trace.out,
            Side::Upper => trace.inn,
        };
        let beyond = self.front.wave(wave).plane;
        self.planes.turn(beyond, plane).is_zero() && self.planes.coplanar(beyond, plane)
    }

    /// Whether the merge chain, with the given plane on its other side, crosses the trace at the
    /// cursor, going on in time.
    pub(super) fn look_forward(&self, cursor: &Cursor, plane: PlaneId, now: &Time) -> Look {
        if cursor.east == NONE {
            return Look::Never;
        }
        let trace = *self.trace(cursor.east);
        let crosses = |node, time| {
            Look::Crosses(Crossing {
                trace: cursor.east,
                node,
                time,
            })
        };
        if self.meets_coplanar(cursor.side, &trace, plane) {
            return crosses(None, *now);
        }
        if !self.planes.is_unweighted() && !trace.turn.is_zero() && now.moment != Moment::Start {
            // What has length zero vanishes, even if its ends would move apart again.
            match self.planes.lead(&now.moment, trace.pair, plane) {
                Sign::Positive => {}
                Sign::Zero => return crosses(None, *now),
                Sign::Negative => return Look::Lost,
            }
        }
        match trace.end {
            End::At(node) => match self.ahead(node, plane) {
                Sign::Positive => Look::Until(self.time_of(node)),
                Sign::Zero => crosses(Some(node), self.time_of(node)),
                Sign::Negative => crosses(None, self.crossing(cursor.east, plane)),
            },
            End::Ghost => Look::Until(self.time_of(trace.born)),
            End::Moving => {
                let [i, j] = trace.pair;
                match self.planes.meeting_if([plane, i, j], Sign::Positive) {
                    Some(bounds) => crosses(
                        None,
                        Time {
                            moment: Moment::of_planes([plane, i, j]),
                            bounds,
                        },
                    ),
                    None => Look::Never,
                }
            }
        }
    }

    /// The same, going back in time.
    pub(super) fn look_backward(&self, cursor: &Cursor, plane: PlaneId, now: &Time) -> Look {
        if cursor.east == NONE {
            return Look::Never;
        }
        let trace = *self.trace(cursor.east);
        let end = match trace.end {
            // Along the base of an edge that was overrun at once.
            End::At(node) if node < self.front.vertices => return Look::Never,
            End::At(node) => Some(node),
            _ => None,
        };
        let crosses = |node, time| {
            Look::Crosses(Crossing {
                trace: cursor.east,
                node,
                time,
            })
        };
        if self.meets_coplanar(cursor.side, &trace, plane) {
            return match end {
                Some(node) if self.compare(&self.time_of(node), now).is_le() => {
                    crosses(Some(node), self.time_of(node))
                }
                _ => crosses(None, *now),
            };
        }
        if self.ahead(trace.born, plane) != Sign::Positive {
            return if trace.born < self.front.vertices {
                Look::Never
            } else {
                Look::Until(self.time_of(trace.born))
            };
        }
        match end {
            Some(node) if self.ahead(node, plane).is_zero() => {
                crosses(Some(node), self.time_of(node))
            }
            _ => crosses(None, self.crossing(cursor.east, plane)),
        }
    }

    /// The place of the vertex at the cursor at a given time of its trace.
    pub(super) fn place_at(&self, cursor: &Cursor, now: &Time) -> Option<Place> {
        let trace = self.trace(cursor.east);
        for node in [Some(trace.born), self.end_node(cursor.east)]
            .into_iter()
            .flatten()
        {
            if self.compare(&self.time_of(node), now).is_eq() {
                return Some(self.place_of(node));
            }
        }
        match now.moment {
            Moment::Planes(moment) if !trace.turn.is_zero() => Some(Place::Event {
                pair: trace.pair,
                moment,
            }),
            _ => None,
        }
    }

    pub(super) fn end_node(&self, x: u32) -> Option<u32> {
        match self.trace(x).end {
            End::At(node) => Some(node),
            _ => None,
        }
    }
}
