//! The directions in which a ring is monotone (Preparata & Supowit 1981): see [`monotone`](super::monotone).

use std::cmp::Ordering;

use hipline_num::Sign;

use super::{range::Scale, triangulate::coord};
use crate::predicates::turn;

/// The angle of an edge's direction, or of its opposite: in this quarter turn (0 goes from 0 to 90 degrees), where the edge tells.
#[derive(Debug, Clone, Copy)]
struct Angle {
    quarter: i64,
    edge: u32,
}

impl Angle {
    const fn plus_quarters(self, quarters: i64) -> Self {
        Self {
            quarter: self.quarter + quarters,
            ..self
        }
    }
}

/// Angles from the first to the second, if there is a second.
type Range = (Angle, Option<Angle>);

/// The edges of a ring, counterclockwise.
struct Edges<'a> {
    points: &'a [[f64; 2]],
    scale: Scale,
    counterclockwise: bool,
}

/// The direction of the levels across which a simple ring is monotone, if there is one: towards north.
/// What it says of a ring that is not simple means nothing.
pub(super) fn level(points: &[[f64; 2]], scale: Scale) -> Option<[[f64; 2]; 2]> {
    let edges = Edges {
        points,
        scale,
        counterclockwise: is_counterclockwise(points, scale)?,
    };
    let ranges = edges.passed_once()?;
    // Angles that are passed once and whose opposites are, too; a range is better than one angle.
    let (mut i, mut j) = (0, 0);
    let mut found = None;
    while i < ranges.len() && j < ranges.len() {
        let here = ranges[i].map(|angle| angle.plus_quarters(2));
        let low = edges.later(here[0], ranges[j][0]);
        let high = edges.earlier(here[1], ranges[j][1]);
        match edges.compare(low, high) {
            Ordering::Less => {
                found = Some([low, high]);
                break;
            }
            Ordering::Equal => found = found.or(Some([low, high])),
            Ordering::Greater => {}
        }
        if edges.compare(here[1], ranges[j][1]).is_lt() {
            i += 1;
        } else {
            j += 1;
        }
    }
    found.map(|range| edges.between(range))
}

/// Which way round a simple ring goes, seen at its lowest vertex furthest to the left.
fn is_counterclockwise(points: &[[f64; 2]], scale: Scale) -> Option<bool> {
    let n = points.len();
    let order = |a: [f64; 2], b: [f64; 2]| a[0].total_cmp(&b[0]).then(a[1].total_cmp(&b[1]));
    let corner = (0..n).min_by(|&i, &j| order(points[i], points[j]))?;
    let [a, b, c] = [(corner + n - 1) % n, corner, (corner + 1) % n]
        .map(|vertex| coord(scale.apply(points[vertex])));
    let side = robust::orient2d(a, b, c);
    (side != 0.0).then_some(side > 0.0)
}

impl Edges<'_> {
    /// An edge, counterclockwise.
    fn edge(&self, k: usize) -> [[f64; 2]; 2] {
        let n = self.points.len();
        let ends = if self.counterclockwise {
            [k, (k + 1) % n]
        } else {
            [n - 1 - k, (2 * n - 2 - k) % n]
        };
        ends.map(|vertex| self.scale.apply(self.points[vertex]))
    }

    /// The quarter turn in which an edge's direction lies, 0 to 3.
    fn quarter(&self, k: usize) -> Option<i64> {
        let [p, q] = self.edge(k);
        let [x, y] = [0, 1].map(|axis| (q[axis] + 0.0).total_cmp(&(p[axis] + 0.0)));
        use Ordering::{Equal, Greater, Less};
        match (x, y) {
            (Greater, Greater | Equal) => Some(0),
            (Less | Equal, Greater) => Some(1),
            (Less, Less | Equal) => Some(2),
            (Greater | Equal, Less) => Some(3),
            (Equal, Equal) => None,
        }
    }

    fn compare(&self, a: Angle, b: Angle) -> Ordering {
        a.quarter.cmp(&b.quarter).then_with(|| {
            if a.edge == b.edge {
                return Ordering::Equal;
            }
            // The edges point the same way or opposite ways; in the latter case both turns are reversed.
            let [one, other] = [self.direction(a), self.direction(b)];
            Sign::Zero.cmp(&turn(one, other))
        })
    }

    /// Two points in the direction of an angle.
    fn direction(&self, angle: Angle) -> [[f64; 2]; 2] {
        let edge = angle.edge as usize;
        let [p, q] = self.edge(edge);
        let same = self
            .quarter(edge)
            .is_some_and(|k| (angle.quarter - k).rem_euclid(4) == 0);
        if same { [p, q] } else { [q, p] }
    }

    fn later(&self, a: Angle, b: Angle) -> Angle {
        if self.compare(a, b).is_lt() { b } else { a }
    }

    fn earlier(&self, a: Angle, b: Angle) -> Angle {
        if self.compare(a, b).is_lt() { a } else { b }
    }

    /// The ranges of angles that are passed once, in order.
    fn passed_once(&self) -> Option<Vec<[Angle; 2]>> {
        let n = self.points.len();
        let mut open: Vec<Range> = Vec::new();
        let first = Angle {
            quarter: self.quarter(0)?,
            edge: 0,
        };
        let (mut angle, mut largest, mut smallest) = (first, first, first);
        for k in 0..n {
            while let Some((low, high)) = open.last_mut() {
                if self.compare(*low, angle).is_gt() {
                    open.pop();
                    continue;
                }
                if high.is_none_or(|high| self.compare(angle, high).is_lt()) {
                    *high = Some(angle);
                }
                break;
            }
            largest = self.later(largest, angle);
            smallest = self.earlier(smallest, angle);
            open.push((largest, None));
            angle = self.turned(angle, (k + 1) % n)?;
        }
        if angle.quarter != first.quarter + 4 {
            return None;
        }
        let [before, after] = [largest.plus_quarters(-4), smallest.plus_quarters(4)];
        let ranges = open.into_iter().map(|(low, high)| {
            let high = high.map_or(after, |high| self.earlier(high, after));
            [self.later(low, before), high]
        });
        Some(
            ranges
                .filter(|&[low, high]| self.compare(low, high).is_le())
                .collect(),
        )
    }

    /// The angle of the next edge; none if it goes back where this one came from.
    fn turned(&self, angle: Angle, next: usize) -> Option<Angle> {
        let turns = match (self.quarter(next)? - angle.quarter).rem_euclid(4) {
            0 => 0,
            1 => 1,
            3 => -1,
            _ => match turn(self.edge(angle.edge as usize), self.edge(next)) {
                Sign::Positive => 2,
                Sign::Negative => -2,
                Sign::Zero => return None,
            },
        };
        Some(Angle {
            quarter: angle.quarter + turns,
            edge: next as u32,
        })
    }

    /// A direction in a range: a plain vector strictly inside if there is one to be had, else that of
    /// the range's first angle.
    fn between(&self, [low, high]: [Angle; 2]) -> [[f64; 2]; 2] {
        let [from, to] = [low, high].map(|angle| self.direction(angle));
        let unit = |[p, q]: [[f64; 2]; 2]| {
            let [x, y] = [q[0] - p[0], q[1] - p[1]];
            let size = x.abs().max(y.abs());
            [x / size, y / size]
        };
        let [a, b] = [unit(from), unit(to)];
        let middle = [[0.0, 0.0], [a[0] + b[0], a[1] + b[1]]];
        let inside = turn(from, middle) == Sign::Positive && turn(middle, to) == Sign::Positive;
        if inside { middle } else { from }
    }
}
