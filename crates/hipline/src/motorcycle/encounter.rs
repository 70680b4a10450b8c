//! What two motorcycles, or a motorcycle and an edge, may do to each other: the rules.
//!
//! Let the paths of two motorcycles cross. Who comes there later runs into the track of the other,
//! if that still was on its way. Who comes at the same moment meets the other, except that a start
//! counts as being there before: a motorcycle that comes to where another one starts at that very moment
//! has run into its track, and two that start together do not see each other. One that starts on a track
//! that was there before ends at once.
//!
//! On one line: two that come towards each other meet half-way, unless one of them passes the place
//! where the other one starts before it does; one that follows the other runs into the place where that
//! one started. One that starts where the other arrives at that moment, and runs back along its
//! track, ends at once, and so does the slower one of two that start together in one direction.

use super::{
    field::Field,
    hits::{Found, Hit, Obstacle},
    tracks::Origin,
};
use crate::predicates::{Bounds, Lane, Place, Rail};
use std::cmp::Ordering;

/// When two motorcycles are in a cell, at most: what comes before or after is found elsewhere.
#[derive(Clone, Copy, Debug)]
pub(super) struct Window {
    /// From when on each of the two is there.
    pub from: [f64; 2],
    /// Until when.
    pub until: [f64; 2],
}

impl Window {
    /// Everything.
    pub(super) const ALL: Self = Self {
        from: [f64::NEG_INFINITY; 2],
        until: [f64::INFINITY; 2],
    };
}

/// Whether one of two motorcycles ended where the other one started.
fn are_related(field: &Field, i: u32, j: u32) -> bool {
    let child = |child: u32, parent: u32| match field.tracks[child as usize].origin {
        Origin::Meeting(number) => field
            .meetings
            .get(number as usize)
            .is_some_and(|meeting| meeting.members.binary_search(&parent).is_ok()),
        _ => false,
    };
    child(i, j) || child(j, i)
}

/// Whether f64 can tell that, as long as they are in a cell, one of two is on one side of the path of the
/// other: so most that go the same way, of which there are many in regular figures, need no exact numbers.
fn are_apart(lanes: [&Lane; 2], window: Window) -> bool {
    (0..2).any(|k| {
        let (lane, other) = (lanes[k], lanes[1 - k]);
        let side = |time: f64| lane.side_at(other, time);
        match (side(window.from[1 - k]), side(window.until[1 - k])) {
            (Some(first), Some(last)) => first == last && !first.is_zero(),
            _ => false,
        }
    })
}

/// Finds what two motorcycles may do to each other.
pub(super) fn encounter(field: &Field, i: u32, j: u32, window: Window, found: &mut Found) {
    let who = [i, j];
    let [a, b] = who.map(|k| &field.lanes[k as usize]);
    let crossing = a.cross(b);
    let starts = who.map(|k| field.starts[k as usize]);
    let [p, q] = who.map(|k| field.tracks[k as usize].pair);
    let turn = match crossing.turn {
        Some(turn) if !turn.is_zero() => {
            // Most are seen not to cross at little cost.
            let misses = |k: usize| {
                let t = crossing.times[k];
                t.high < window.from[k].max(starts[k].low) || t.low > window.until[k]
            };
            if misses(0) || misses(1) {
                return;
            }
            turn
        }
        _ if are_apart([a, b], window) => return,
        _ => field.planes.turn_of_paths(p, q),
    };
    if are_related(field, i, j) {
        return;
    }
    if turn.is_zero() {
        aligned(field, who, found);
        return;
    }
    let places = [
        Place::On {
            pair: p,
            rail: Rail::Path(q),
        },
        Place::On {
            pair: q,
            rail: Rail::Path(p),
        },
    ];
    let mut times = crossing.times;
    let mut at_start = [false; 2];
    for k in 0..2 {
        if !is_narrow(times[k]) {
            times[k] = field.planes.time_bounds(&places[k]);
        }
        if times[k].high < window.from[k] || times[k].low > window.until[k] {
            return;
        }
        let start = (&field.tracks[who[k] as usize].start, starts[k]);
        match field.compare((&places[k], times[k]), start) {
            Ordering::Less => return,
            Ordering::Equal => at_start[k] = true,
            Ordering::Greater => {}
        }
    }
    let first = (times[0].compare(times[1]))
        .unwrap_or_else(|| field.planes.compare_at_crossing(p, q, turn));
    let mut add = |k: usize, tie: bool| {
        let other = who[1 - k];
        found.hits.push(Hit {
            who: who[k],
            on: if tie {
                Obstacle::Rival(other)
            } else {
                Obstacle::Track(other)
            },
            place: places[k],
            bounds: times[k],
            there: Some(times[1 - k]),
        });
    };
    match (first, at_start) {
        (Ordering::Less, _) => add(1, false),
        (Ordering::Greater, _) => add(0, false),
        (Ordering::Equal, [true, true]) => {}
        (Ordering::Equal, [true, false]) => add(1, false),
        (Ordering::Equal, [false, true]) => add(0, false),
        (Ordering::Equal, [false, false]) => {
            add(0, true);
            add(1, true);
        }
    }
}

/// Whether bounds are as close as those that f64 gives as a rule. Infinite ones are not: who gets somewhere at any time at
/// all would have to be settled together with all others.
fn is_narrow(t: Bounds) -> bool {
    let width = t.high - t.low;
    width.is_finite() && width <= t.high.max(-t.low) / f64::from(1 << 30)
}

/// Two motorcycles whose paths are parallel.
fn aligned(field: &Field, who: [u32; 2], found: &mut Found) {
    let planes = field.planes;
    let tracks = who.map(|k| &field.tracks[k as usize]);
    let [p, q] = tracks.map(|track| track.pair);
    if !planes.is_on_path(&tracks[1].start, p) {
        return;
    }
    // Where one comes to the start of the other. A start at a vertex is not passed by anybody, as there
    // are edges; one at a meeting only by somebody who runs into those who met before.
    for k in 0..2 {
        let (own, other) = (tracks[k], tracks[1 - k]);
        let Place::On {
            rail: rail @ Rail::Edge(_),
            ..
        } = other.start
        else {
            continue;
        };
        let place = Place::On {
            pair: own.pair,
            rail,
        };
        let bounds = planes.time_bounds(&place);
        let at = (&place, bounds);
        if field
            .compare(at, (&own.start, field.starts[who[k] as usize]))
            .is_lt()
        {
            continue;
        }
        let mut add = |k: usize, place: Place, bounds: Bounds| {
            found.hits.push(Hit {
                who: who[k],
                on: Obstacle::Track(who[1 - k]),
                place,
                bounds,
                there: None,
            });
        };
        let starts = (&other.start, field.starts[who[1 - k] as usize]);
        match field.compare(at, starts) {
            Ordering::Less => add(1 - k, other.start, starts.1),
            Ordering::Greater => add(k, place, bounds),
            Ordering::Equal if place_is_start(field, who[k], at) => {
                // They start together: if they go the same way, the slower one follows.
                if k == 0 && planes.go_alike(p, q) {
                    let slower = usize::from(planes.is_faster(p, q));
                    add(
                        slower,
                        tracks[slower].start,
                        field.starts[who[slower] as usize],
                    );
                }
            }
            Ordering::Equal => {
                add(k, place, bounds);
                if !planes.go_alike(p, q) {
                    // The other one starts on the track, and runs back along it.
                    add(1 - k, other.start, starts.1);
                }
            }
        }
    }
    if planes.go_alike(p, q) {
        return;
    }
    // Head on: some plane of one is not parallel to the path of the other in space and time.
    let meeting = |pair: [_; 2], other: [_; 2]| {
        let third = (other.into_iter()).find(|&plane| planes.do_meet([pair[0], pair[1], plane]))?;
        let mut moment = [pair[0], pair[1], third];
        moment.sort_unstable();
        Some(Place::Event { pair, moment })
    };
    let [Some(mine), Some(theirs)] = [meeting(p, q), meeting(q, p)] else {
        return;
    };
    let places = [mine, theirs];
    let bounds = planes.time_bounds(&mine);
    let after_start = |k: usize| {
        let start = (&tracks[k].start, field.starts[who[k] as usize]);
        field.compare((&mine, bounds), start).is_gt()
    };
    if after_start(0) && after_start(1) {
        for k in 0..2 {
            found.hits.push(Hit {
                who: who[k],
                on: Obstacle::Rival(who[1 - k]),
                place: places[k],
                bounds,
                there: None,
            });
        }
    }
}

/// Whether a motorcycle is at its own start at a moment.
fn place_is_start(field: &Field, who: u32, at: (&Place, Bounds)) -> bool {
    let start = &field.tracks[who as usize].start;
    field
        .compare(at, (start, field.starts[who as usize]))
        .is_eq()
}

#[cfg(test)]
mod tests {
    use super::{Bounds, is_narrow};
    use hipline_num::power_of_two;

    #[test]
    fn bounds_without_end_are_not_narrow() {
        let (all, none) = (f64::INFINITY, f64::NEG_INFINITY);
        for (low, high) in [(none, all), (1.0, all), (none, 1.0), (1.0, 1.1)] {
            assert!(!is_narrow(Bounds { low, high }), "{low} {high}");
        }
        for (low, high) in [(1.0, 1.0), (0.0, 0.0), (1.0, 1.0 + power_of_two(-40))] {
            assert!(is_narrow(Bounds { low, high }), "{low} {high}");
        }
    }
}
