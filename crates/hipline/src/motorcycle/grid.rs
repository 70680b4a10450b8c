//! A grid over motorcycles and walls.
//!
//! For what somebody placed there is no triangulation. A motorcycle walks through the columns of a grid
//! (or the rows, if it goes rather along y), and looks at who went, and what stands, in the
//! cells that it may go through. Which cells these are is found in f64, with a margin that is much wider
//! than all rounding; a cell too many costs time only. Outside of the grid all is one cell.

use super::{
    encounter::{Window, encounter},
    field::{Field, Ground},
    hits::{Found, Step},
    walls::Segment,
};
use crate::predicates::Motion;

/// The margin, in cells.
const MARGIN: f64 = 1.0 / 64.0;

/// The relative error of times, many times over.
const SLACK: f64 = 1.0 / (1_u64 << 48) as f64;

/// So many cells along a side at most.
const MOST: usize = 4096;

/// Who or what is in a cell.
#[derive(Debug, Clone, Default)]
struct Cell {
    walls: Vec<u32>,
    /// Motorcycles, from when on they may be there, and when they have left.
    riders: Vec<(u32, [f64; 2])>,
}

/// The path of a motorcycle in cells.
#[derive(Debug, Clone, Copy)]
struct Ride {
    at: [f64; 2],
    /// Cells per unit of time.
    velocity: [f64; 2],
    time: f64,
    /// The axis along which it is faster.
    axis: usize,
    /// Whether it has been noted outside.
    outside: bool,
}

/// The cells, and the walls and motorcycles in them.
pub(super) struct Grid<'a> {
    walls: &'a [Segment],
    low: [f64; 2],
    size: f64,
    count: usize,
    /// Row by row; the last one is the outside.
    cells: Vec<Cell>,
    rides: Vec<Ride>,
    /// From units of time to those of the planes.
    time_scale: f64,
}

impl<'a> Grid<'a> {
    pub(super) fn new(motions: &[Motion], walls: &'a [Segment], time_unit: i32) -> Self {
        let places = || {
            (motions.iter().map(|motion| motion.place))
                .chain(walls.iter().flat_map(|wall| wall.ends))
        };
        let fold = |k: usize, with: fn(f64, f64) -> f64| {
            places().map(|p| p[k]).reduce(with).unwrap_or(0.0)
        };
        let low = [0, 1].map(|k| fold(k, f64::min));
        let high = [0, 1].map(|k| fold(k, f64::max));
        let width = (high[0] - low[0]).max(high[1] - low[1]);
        let count = ((motions.len() + walls.len()).isqrt()).clamp(1, MOST);
        let size = if width > 0.0 {
            width / count as f64
        } else {
            1.0
        };
        let mut grid = Self {
            walls,
            low,
            size,
            count,
            cells: vec![Cell::default(); count * count + 1],
            rides: Vec::with_capacity(motions.len()),
            time_scale: power(-time_unit),
        };
        for motion in motions {
            let velocity = motion.velocity.map(|v| v / size);
            grid.rides.push(Ride {
                at: grid.local(motion.place),
                velocity,
                time: motion.time,
                axis: usize::from(velocity[1].abs() > velocity[0].abs()),
                outside: false,
            });
        }
        for (number, wall) in walls.iter().enumerate() {
            grid.add_wall(number as u32, wall.ends);
        }
        grid
    }

    /// A point in cells.
    fn local(&self, p: [f64; 2]) -> [f64; 2] {
        [0, 1].map(|k| (p[k] - self.low[k]) / self.size)
    }

    /// The numbers of the cells from one coordinate to another, and whether there are more outside.
    fn span(&self, p: f64, q: f64) -> (std::ops::Range<usize>, bool) {
        let (from, to) = ((p.min(q) - MARGIN).floor(), (p.max(q) + MARGIN).floor());
        let last = self.count as f64;
        let clamped = |x: f64| x.clamp(0.0, last) as usize;
        // What touches the far side of the last cell is in it.
        (clamped(from)..clamped(to + 1.0), from < 0.0 || to >= last)
    }

    fn index(&self, axis: usize, column: usize, row: usize) -> usize {
        if axis == 0 {
            row * self.count + column
        } else {
            column * self.count + row
        }
    }

    fn add_wall(&mut self, number: u32, ends: [[f64; 2]; 2]) {
        let [p, q] = ends.map(|end| self.local(end));
        let along = [q[0] - p[0], q[1] - p[1]];
        let axis = usize::from(along[1].abs() > along[0].abs());
        let across = 1 - axis;
        let (columns, _) = self.span(p[axis], q[axis]);
        for column in columns {
            // Where it is in this column, no further than its ends.
            let at = |x: f64| {
                let part = if along[axis] == 0.0 {
                    0.0
                } else {
                    (x - p[axis]) / along[axis]
                };
                p[across] + along[across] * part.clamp(0.0, 1.0)
            };
            let [from, to] = [column as f64 - MARGIN, column as f64 + 1.0 + MARGIN].map(at);
            let (rows, _) = self.span(from, to);
            for row in rows {
                let cell = self.index(axis, column, row);
                self.cells[cell].walls.push(number);
            }
        }
    }

    /// Looks around in a cell, and stays there from one time to another.
    fn enter(&mut self, field: &Field, who: u32, cell: usize, stay: [f64; 2], found: &mut Found) {
        for &wall in &self.cells[cell].walls {
            let hit = self.walls[wall as usize].hit(field, who, cell as u32);
            found
                .hits
                .extend(hit.filter(|hit| hit.bounds.low <= stay[1]));
        }
        for &(other, stays) in &self.cells[cell].riders {
            let window = Window {
                from: [stays[0], stay[0]],
                until: [stays[1], stay[1]],
                cell: cell as u32,
            };
            encounter(field, other, who, window, found);
        }
        self.cells[cell].riders.push((who, stay));
    }

    /// Goes through a column, given by its number along the axis of the ride (which may be outside).
    fn ride(&mut self, field: &Field, who: u32, column: usize, found: &mut Found) {
        let ride = self.rides[who as usize];
        let (axis, across) = (ride.axis, 1 - ride.axis);
        let speed = ride.velocity[axis];
        let when = |x: f64| (x - ride.at[axis]) / speed;
        let (near, far) = if speed > 0.0 {
            (column as f64, column as f64 + 1.0)
        } else {
            (column as f64 + 1.0, column as f64)
        };
        let lasts = [near, far].map(|x| when(x).max(0.0));
        let margin = MARGIN / speed.abs();
        let [from, to] = [lasts[0] - margin, lasts[1] + margin]
            .map(|t| ride.at[across] + ride.velocity[across] * t.max(0.0));
        let stay = [
            self.time(ride.time, lasts[0] - margin, -1.0),
            self.time(ride.time, lasts[1] + margin, 1.0),
        ];
        let (rows, leaves) = self.span(from, to);
        if leaves {
            self.leave(field, who, found);
        }
        if rows.is_empty() {
            return;
        }
        for row in rows {
            let cell = self.index(axis, column, row);
            self.enter(field, who, cell, stay, found);
        }
        let next = if speed > 0.0 {
            Some(column + 1)
        } else {
            column.checked_sub(1)
        };
        match next.filter(|&next| next < self.count) {
            Some(next) => found.steps.push(Step {
                low: self.time(ride.time, lasts[1] - margin, -1.0),
                who,
                cell: next as u32,
                side: 0,
            }),
            None => self.leave(field, who, found),
        }
    }

    /// A motorcycle may be outside of the grid: at any time, as nobody measures there.
    fn leave(&mut self, field: &Field, who: u32, found: &mut Found) {
        if !std::mem::replace(&mut self.rides[who as usize].outside, true) {
            let outside = self.cells.len() - 1;
            let always = [f64::NEG_INFINITY, f64::INFINITY];
            self.enter(field, who, outside, always, found);
        }
    }

    /// A time in the units of the planes, moved by more than its error.
    fn time(&self, start: f64, after: f64, way: f64) -> f64 {
        let slack = (start.abs() + after.abs()) * SLACK;
        let time = (start + after + way * slack) * self.time_scale;
        // Where f64 has no such number, the ground looks at everything.
        if time.is_finite() {
            time
        } else {
            way * f64::INFINITY
        }
    }
}

/// 2^exponent, or NaN where f64 has no such number.
fn power(exponent: i32) -> f64 {
    if (-1022..=1023).contains(&exponent) {
        f64::from_bits(((exponent + 1023) as u64) << 52)
    } else {
        f64::NAN
    }
}

impl Ground for Grid<'_> {
    fn start(&mut self, field: &Field, who: u32, _: &[u32], found: &mut Found) {
        let ride = self.rides[who as usize];
        let (columns, _) = self.span(ride.at[ride.axis], ride.at[ride.axis]);
        // With the margin it may start in two columns; the first one on its way leads to the other.
        let column = if ride.velocity[ride.axis] > 0.0 {
            columns.start
        } else {
            columns.end.saturating_sub(1)
        };
        self.ride(field, who, column.min(self.count - 1), found);
    }

    fn step(&mut self, field: &Field, step: Step, found: &mut Found) {
        self.ride(field, step.who, step.cell as usize, found);
    }
}
