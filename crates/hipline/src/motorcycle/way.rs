//! Where something straight is in which cell, roughly: bounds in f64 that hold.
//!
//! A path, or a wall as the path from one of its ends to the other, is cut by lines along the axes. Let x be a
//! coordinate where it starts, v the velocity along that axis, both correctly rounded, and w = fl(1/v). It passes the line at
//! s after t = (s - x)/v. The computed (s - x) w is off by less than 5u t + 2u |x w|, the sum with the moment of the start
//! by u of each of the two more: 16u of all sizes together is more than enough. What f64 does not hold
//! is on both sides at all times, which costs time only.
//!
//! For lines of any direction, see [`Way::above`]: a sum of products, each off by less than 4u of its size.

use crate::predicates::Planes;

use super::tracks::Track;

/// From when on something may be in a cell, and by when it has left.
pub(super) type Stay = [f64; 2];

/// All of time.
pub(super) const ALWAYS: Stay = [f64::NEG_INFINITY, f64::INFINITY];

/// 16 units of rounding.
const SLACK: f64 = 8.0 * f64::EPSILON;

/// The line of all p with `normal * p = offset`.
#[derive(Clone, Copy, Debug)]
pub(super) struct Line {
    pub normal: [f64; 2],
    pub offset: f64,
}

impl Line {
    /// The axis that it is across, if it is.
    pub(super) fn axis(&self) -> Option<u8> {
        let [x, y] = self.normal.map(f64::to_bits);
        let (zero, one) = (0.0_f64.to_bits(), 1.0_f64.to_bits());
        match (x == one && y == zero, x == zero && y == one) {
            (true, _) => Some(0),
            (_, true) => Some(1),
            _ => None,
        }
    }

    /// When a path may be below the line, and when above, of the time that is told.
    pub(super) fn split(&self, way: &Way, stay: Stay) -> [Option<Stay>; 2] {
        match self.axis() {
            Some(axis) => way.split(stay, usize::from(axis), self.offset),
            None => way.split_by(stay, self),
        }
    }
}

/// A straight path.
#[derive(Clone, Copy, Debug)]
pub(super) struct Way {
    at: [f64; 2],
    velocity: [f64; 2],
    /// 1 / velocity; NaN where that is not a number.
    inverse: [f64; 2],
    start: f64,
}

/// 2^exponent, or NaN where f64 has no such number.
fn power(exponent: i32) -> f64 {
    if (-1022..=1023).contains(&exponent) {
        f64::from_bits(((exponent + 1023) as u64) << 52)
    } else {
        f64::NAN
    }
}

impl Way {
    fn new(at: [f64; 2], velocity: [f64; 2], start: f64) -> Self {
        let inverse = velocity.map(|v| {
            let w = 1.0 / v;
            if v.is_normal() && w.is_normal() {
                w
            } else {
                f64::NAN
            }
        });
        Self {
            at,
            velocity,
            inverse,
            start,
        }
    }

    /// The path of a motorcycle, in the planes' units of time.
    pub(super) fn of_track(planes: &Planes, track: &Track) -> Self {
        let unit = planes.rough_time_unit();
        let [x, y, time] = planes.round(&track.start);
        let velocity = planes.round_velocity(track.pair).map(|v| v * power(unit));
        Self::new([x, y], velocity, time * power(-unit))
    }

    /// From one point to another, from 0 to 1.
    pub(super) fn between([p, q]: [[f64; 2]; 2]) -> Self {
        Self::new(p, [q[0] - p[0], q[1] - p[1]], 0.0)
    }

    /// From a point on, for ever from 0.
    pub(super) fn escaping(start: [f64; 2], velocity: [f64; 2]) -> Self {
        Self::new(start, velocity, 0.0)
    }

    /// When it starts.
    pub(super) const fn start(&self) -> f64 {
        self.start
    }

    /// About where it is at a time.
    pub(super) fn at(&self, axis: usize, time: f64) -> f64 {
        self.at[axis] + self.velocity[axis] * (time - self.start)
    }

    /// When it passes a line across an axis.
    fn passes(&self, axis: usize, line: f64) -> Stay {
        let (x, w) = (self.at[axis], self.inverse[axis]);
        let after = (line - x) * w;
        let time = self.start + after;
        let slack = (self.start.abs() + after.abs() + (x * w).abs()) * SLACK + f64::MIN_POSITIVE;
        if slack.is_finite() {
            [time - slack, time + slack]
        } else {
            ALWAYS
        }
    }

    /// When it may be below a line across an axis, and when above, of the time that is told.
    #[inline]
    pub(super) fn split(&self, stay: Stay, axis: usize, line: f64) -> [Option<Stay>; 2] {
        if self.velocity[axis] == 0.0 {
            let (ahead, slack) = (line - self.at[axis], self.at[axis].abs() * SLACK);
            let some = |is: bool| is.then_some(stay);
            // Not a number: both.
            let [is_above, is_below] = [ahead < -slack, ahead > slack];
            return [some(!is_above), some(!is_below)];
        }
        let [low, high] = self.passes(axis, line);
        let first = (stay[0] <= high).then(|| [stay[0], stay[1].min(high)]);
        let second = (stay[1] >= low).then(|| [stay[0].max(low), stay[1]]);
        if self.velocity[axis] < 0.0 {
            [second, first]
        } else {
            [first, second]
        }
    }

    /// How far it is above a line at a time, and a bound of the error.
    fn above(&self, line: &Line, time: f64) -> [f64; 2] {
        let [n, m] = line.normal;
        let (x, y) = (n * self.at[0], m * self.at[1]);
        let (v, w) = (n * self.velocity[0], m * self.velocity[1]);
        let after = time - self.start;
        let value = (x + y - line.offset) + (v + w) * after;
        let size = x.abs()
            + y.abs()
            + line.offset.abs()
            + (v.abs() + w.abs()) * (after.abs() + self.start.abs());
        [value, size * SLACK + f64::MIN_POSITIVE]
    }

    /// The same as [`Way::split`] for any line. Between two times it is as far above the line as a linear function tells, so
    /// that what holds at both holds between them.
    pub(super) fn split_by(&self, stay: Stay, line: &Line) -> [Option<Stay>; 2] {
        let [from, until] = stay;
        let [[p, e], [q, f]] = stay.map(|time| self.above(line, time));
        let [below, above] = [[Some(stay), None], [None, Some(stay)]];
        if p > e && q > f {
            return above;
        }
        if -p > e && -q > f {
            return below;
        }
        let part = (until - from) / (p - q);
        let [time, error] = [p * part, e.max(f) * part.abs()];
        let slack = 2.0 * error + (time.abs() + from.abs() + until.abs()) * SLACK;
        let crosses = (p > e && -q > f) || (-p > e && q > f);
        if !crosses || !slack.is_finite() {
            return [Some(stay); 2];
        }
        let pass = from + time;
        let first = [from, until.min(pass + slack)];
        let second = [from.max(pass - slack), until];
        if p > 0.0 {
            [Some(second), Some(first)]
        } else {
            [Some(first), Some(second)]
        }
    }

    /// A direction across its way, and about how long a step is along the way.
    pub(super) fn across(&self) -> [f64; 2] {
        let [v, w] = self.velocity;
        let size = v.abs().max(w.abs());
        // Opposite ways have one.
        let size = if w < 0.0 || (w == 0.0 && v < 0.0) {
            -size
        } else {
            size
        };
        [-w / size, v / size]
    }

    /// About where it is along a direction at a time.
    pub(super) fn along(&self, normal: [f64; 2], time: f64) -> f64 {
        normal[0] * self.at(0, time) + normal[1] * self.at(1, time)
    }
}
