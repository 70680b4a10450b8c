//! Where something straight is in which cell, roughly: bounds in f64 that hold.
//!
//! A path, or a wall as the path from one of its ends to the other, is cut by lines along the axes. Let X, V and S be the place where
//! it starts and its velocity along an axis, and the moment; x, v and s what is computed of them; u = 2^-53, and e = 2^-1075, half of
//! the least number. What is known is this:
//!
//! * x is X correctly rounded: it is off by no more than u |x| + e. The ends of walls are exact.
//! * v is 0 if and only if V is, or a normal number off by no more than u |v|, or else NaN. A number that rounding made small
//!   is not known to be zero, nor to have any digits ([`known`]). The difference of two coordinates is zero only if they are
//!   equal, and an underflow of it is exact.
//! * s is 0 if and only if S is, or a normal number off by no more than u |s|, or else NaN.
//! * w = fl(1/v) is a normal number off by no more than 3u |w| from 1/V, or else NaN.
//!
//! An operation is off by a factor between 1 - u and 1 + u, and a product by e more. The line at L is passed T = (L - X) / V after
//! S. The computed a = (L - x) w is off by no more than 6u |a| for the operations and w, (1 + 8u) (u |x| + e) |w| for x, and
//! e for the underflow of the product; s + a by u |s| for s and by u (|s| + |a|) for the sum: together less than
//! 8u (|s| + |a| + |x w|) + 2e |w| + 2e. [`Way::passes`] allows for 16u (|s| + |a| + |x w|) + (1 + |w|) 2^-1022, and 2^-1022 is 2^53 e,
//! which pays for what the bound itself loses: factors above 1 - 8u, and e in each of two products. What is infinite or NaN
//! makes the bound so, and then it is on both sides at all times, which costs time only.
//!
//! If V is 0, it is always on one side: L - X and L - x have one sign if |L - x| > u |x| + e; the computed difference is off by a factor
//! only, and has to exceed 16u |x| + 2^-1022.
//!
//! For lines of any direction, see [`Way::above`].

use crate::predicates::Planes;
use hipline_num::power_of_two;

use super::tracks::{Origin, Track};

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
    /// The line across an axis.
    pub(super) const fn across(axis: usize, offset: f64) -> Self {
        let mut normal = [0.0; 2];
        normal[axis] = 1.0;
        Self { normal, offset }
    }

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
    let power = power_of_two(exponent);
    if power.is_normal() { power } else { f64::NAN }
}

/// A rounded number in another unit: exactly so many times as large, or NaN if digits of it may be lost.
fn known(rounded: f64, unit: i32) -> f64 {
    let scaled = rounded * power(unit);
    if rounded.is_normal() && scaled.is_normal() {
        scaled
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
        let rounded = planes.round_velocity(track.pair);
        let velocity = [0, 1].map(|axis| {
            if rounded[axis] == 0.0 && planes.is_static(track.pair, axis) {
                0.0
            } else {
                known(rounded[axis], unit)
            }
        });
        // Meetings come after time zero; other times are exact.
        let start = match track.origin {
            Origin::Vertex(_) | Origin::Given if time == 0.0 => 0.0,
            _ => known(time, -unit),
        };
        Self::new([x, y], velocity, start)
    }

    /// From one point to another, from 0 to 1. These may be correctly rounded: at the time t, that is off by less than
    /// (1 - t) (u |x| + e) + t (u |x + v| + e), which is less than u |x| + e + u |v| t; and v is 0, or has its sign, as rounding is
    /// monotone. So the bounds hold of the exact path, too.
    pub(super) fn between([p, q]: [[f64; 2]; 2]) -> Self {
        Self::new(p, [q[0] - p[0], q[1] - p[1]], 0.0)
    }

    /// From a point on, for ever from 0. A velocity of zero is just that: only those that are given escape, and their numbers do
    /// not underflow.
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
        let slack = (self.start.abs() + after.abs() + (x * w).abs()) * SLACK
            + (1.0 + w.abs()) * f64::MIN_POSITIVE;
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
            let ahead = line - self.at[axis];
            let slack = self.at[axis].abs() * SLACK + f64::MIN_POSITIVE;
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
    ///
    /// The time and the line are exact. A sum of products each of which is off by less than 4u of its size, where the size of what
    /// is multiplied by the time since the start is taken for that of the start, too, as this may cancel; the coordinates are off
    /// by e more, and so are four products, of which two are multiplied by that time: 2^-1022 for each.
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
        [
            value,
            size * SLACK + (1.0 + after.abs()) * f64::MIN_POSITIVE,
        ]
    }

    /// The same as [`Way::split`] for any line. Between two times it is as far above the line as a linear function tells, so
    /// that what holds at both holds between them.
    pub(super) fn split_by(&self, stay: Stay, line: &Line) -> [Option<Stay>; 2] {
        let [from, until] = stay;
        if until == f64::INFINITY {
            return self.split_ray_by(from, line);
        }
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
        let slack =
            2.0 * error + (time.abs() + from.abs() + until.abs()) * SLACK + f64::MIN_POSITIVE;
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

    /// The same for ever from a time on. It gets away from the line at a speed whose error g is known, too. With T the time from then
    /// on when it is on the line, and t the computed one, T is off by no more than (e + |t| g) / |speed|, where the speed is at
    /// least half the computed one.
    fn split_ray_by(&self, from: f64, line: &Line) -> [Option<Stay>; 2] {
        let stay = [from, f64::INFINITY];
        let [p, e] = self.above(line, from);
        let [v, w] = [0, 1].map(|k| line.normal[k] * self.velocity[k]);
        let (speed, g) = (v + w, (v.abs() + w.abs()) * SLACK + f64::MIN_POSITIVE);
        let time = -p / speed;
        let slack = 4.0 * ((e + time.abs() * g) / speed.abs())
            + (time.abs() + from.abs()) * SLACK
            + f64::MIN_POSITIVE;
        if !(speed.abs() > 2.0 * g && slack.is_finite()) {
            return [Some(stay); 2];
        }
        let pass = from + time;
        let first = (pass + slack >= from).then_some([from, pass + slack]);
        let second = Some([from.max(pass - slack), f64::INFINITY]);
        if speed > 0.0 {
            [first, second]
        } else {
            [second, first]
        }
    }

    /// A direction across its way, and about how long a step is along the way.
    pub(super) fn across(&self) -> [f64; 2] {
        let [v, w] = self.velocity;
        let size = v.abs().max(w.abs());
        // Opposite ways have one, and ways along an axis have that of `Line::across`.
        let size = if w > 0.0 || (w == 0.0 && v < 0.0) {
            -size
        } else {
            size
        };
        [-w / size + 0.0, v / size + 0.0]
    }

    /// About where it is along a direction at a time.
    pub(super) fn along(&self, normal: [f64; 2], time: f64) -> f64 {
        normal[0] * self.at(0, time) + normal[1] * self.at(1, time)
    }
}
