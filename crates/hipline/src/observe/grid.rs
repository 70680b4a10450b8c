//! The cells of a raster, and in which face the centre of each lies.
//!
//! Along a row, what a cell lies in changes where the row crosses a segment. Each crossing adds the
//! difference between what is to its right and what is to its left; the sum from the west, starting at
//! what the first cell lies in, is right whatever the order of crossings between two centres.

use super::{
    Index, Window,
    plan::{Ground, Query, Segment},
};
use crate::topology::FaceId;
use hipline_num::Sign;

/// The most cells of a grid.
const MOST: f64 = (1_u64 << 30) as f64;

/// Square cells over a rectangle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Grid {
    origin: [f64; 2],
    cell: f64,
    columns: usize,
    rows: usize,
}

/// Why there is no grid.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum InvalidGrid {
    /// The side of a cell is not a number above 0.
    #[error("the side of a cell must be finite and above 0, unlike {0}")]
    Cell(f64),
    /// More than 2^30 cells.
    #[error("{0} by {1} cells are too many; larger cells help")]
    TooMany(f64, f64),
    /// The cells are so small that their centres are the same f64.
    #[error("cells of {0} are too small for coordinates of this size")]
    TooSmall(f64),
}

impl Grid {
    /// Cells of the given side that cover a window, from its lower left corner; the last column
    /// and row may go beyond it.
    ///
    /// # Errors
    /// The side is not finite and above 0, or far too small.
    pub fn new(window: Window, cell: f64) -> Result<Self, InvalidGrid> {
        if !(cell.is_finite() && cell > 0.0) {
            return Err(InvalidGrid::Cell(cell));
        }
        let [columns, rows] = window.size().map(|side| (side / cell).ceil().max(1.0));
        if columns * rows > MOST {
            return Err(InvalidGrid::TooMany(columns, rows));
        }
        let grid = Self {
            origin: window.min(),
            cell,
            columns: columns as usize,
            rows: rows as usize,
        };
        let (last, before) = (grid.columns - 1, grid.columns.saturating_sub(2));
        let (top, below) = (grid.rows - 1, grid.rows.saturating_sub(2));
        let ([x1, y1], [x0, y0]) = (grid.centre(last, top), grid.centre(before, below));
        let apart = (last == 0 || x0 < x1) && (top == 0 || y0 < y1);
        let first = grid.centre(0, 0);
        if apart && first[0] > grid.origin[0] && first[1] > grid.origin[1] {
            Ok(grid)
        } else {
            Err(InvalidGrid::TooSmall(cell))
        }
    }

    /// The lower left corner.
    #[must_use]
    pub const fn origin(&self) -> [f64; 2] {
        self.origin
    }

    /// The side of a cell.
    #[must_use]
    pub const fn cell(&self) -> f64 {
        self.cell
    }

    /// The number of columns.
    #[must_use]
    pub const fn columns(&self) -> usize {
        self.columns
    }

    /// The number of rows.
    #[must_use]
    pub const fn rows(&self) -> usize {
        self.rows
    }

    /// The centre of a cell: columns are counted from the west, rows from the south.
    #[must_use]
    pub fn centre(&self, column: usize, row: usize) -> [f64; 2] {
        [
            (column as f64 + 0.5).mul_add(self.cell, self.origin[0]),
            (row as f64 + 0.5).mul_add(self.cell, self.origin[1]),
        ]
    }

    /// About which column or row a coordinate is in.
    fn near(&self, coordinate: f64, axis: usize, count: usize) -> usize {
        // The cast saturates, also for NaN.
        let cells = (coordinate - self.origin[axis]) / self.cell;
        ((cells - 0.5).ceil().max(0.0) as usize).min(count)
    }
}

/// The first of `count` numbers for which something holds that holds for all after it; near to
/// a guess it takes a constant number of questions.
fn first(count: usize, guess: usize, holds: impl Fn(usize) -> bool) -> usize {
    let guess = guess.min(count);
    let mut step = 1;
    // The answer is from `low` to `high`; gallop away from the guess.
    let (mut low, mut high);
    if guess < count && !holds(guess) {
        (low, high) = (guess + 1, count);
        while low < high {
            let next = low + step - 1;
            if next >= high {
                break;
            }
            if holds(next) {
                high = next;
                break;
            }
            low = next + 1;
            step *= 2;
        }
    } else {
        (low, high) = (0, guess);
        while low < high {
            let next = high.saturating_sub(step);
            if !holds(next) {
                low = next + 1;
                break;
            }
            high = next;
            step *= 2;
        }
    }
    while low < high {
        let middle = usize::midpoint(low, high);
        if holds(middle) {
            high = middle;
        } else {
            low = middle + 1;
        }
    }
    low
}

const OUTSIDE: i64 = -1;
const BEYOND: i64 = -2;

fn code(ground: Ground) -> i64 {
    match ground {
        Ground::Face(face) => face.index() as i64,
        Ground::Outside => OUTSIDE,
        Ground::Beyond => BEYOND,
    }
}

impl Index<'_> {
    /// What the centres of a grid's cells lie in, row by row from the south.
    pub(super) fn grounds(&self, grid: &Grid) -> Vec<Ground> {
        let (columns, rows) = (grid.columns, grid.rows);
        let mut change = vec![0_i64; columns * rows];
        // The first row whose centres are not below a position.
        let row_of: Vec<u32> = (0..self.plan.positions.len() as u32)
            .map(|p| {
                let y = self.plan.positions[p as usize].point[1];
                let holds =
                    |row: usize| self.plan.compare_height(grid.centre(0, row)[1], p).is_ge();
                first(rows, grid.near(y, 1, rows), holds) as u32
            })
            .collect();
        for segment in &self.plan.segments {
            let [p, q] = segment.ends.map(|end| row_of[end as usize] as usize);
            if p == q {
                continue;
            }
            let rises = p < q;
            let difference = code(segment.below) - code(segment.above);
            let difference = if rises { difference } else { -difference };
            for row in p.min(q)..p.max(q) {
                let column = self.crossing(grid, segment, row, rises);
                // Column 0 is asked for by itself.
                if (1..columns).contains(&column) {
                    change[row * columns + column] += difference;
                }
            }
        }
        let mut grounds = Vec::with_capacity(change.len());
        for (row, change) in change.chunks(columns).enumerate() {
            let mut now = code(self.ground_to_the_east(&Query::new(grid.centre(0, row))));
            for step in change {
                now += step;
                grounds.push(match now {
                    OUTSIDE => Ground::Outside,
                    BEYOND => Ground::Beyond,
                    face => Ground::Face(FaceId::new(face as usize)),
                });
            }
        }
        self.settle_borders(grid, &mut grounds);
        grounds
    }

    /// The first column of a row whose centre is not to the left of a segment.
    fn crossing(&self, grid: &Grid, segment: &Segment, row: usize, rises: bool) -> usize {
        let y = grid.centre(0, row)[1];
        let left = if rises {
            Sign::Positive
        } else {
            Sign::Negative
        };
        let is_right = |column: usize| {
            let query = Query::new(grid.centre(column, row));
            self.plan.side(segment, &query) != left
        };
        first(
            grid.columns,
            grid.near(self.abscissa(segment, y), 0, grid.columns),
            is_right,
        )
    }

    /// About where a segment has an ordinate.
    fn abscissa(&self, segment: &Segment, y: f64) -> f64 {
        let [p, q] = segment
            .ends
            .map(|end| self.plan.positions[end as usize].point);
        // From the end that is nearer, since one can be extremely far.
        let (p, q) = if (p[1] - y).abs() <= (q[1] - y).abs() {
            (p, q)
        } else {
            (q, p)
        };
        p[0] + (y - p[1]) * ((q[0] - p[0]) / (q[1] - p[1]))
    }

    /// Centres exactly on a border of the covered part belong to it.
    fn settle_borders(&self, grid: &Grid, grounds: &mut [Ground]) {
        let (columns, rows) = (grid.columns, grid.rows);
        for segment in &self.plan.segments {
            if segment.above != Ground::Outside && segment.below != Ground::Outside {
                continue;
            }
            let [p, q] = segment
                .ends
                .map(|end| self.plan.positions[end as usize].point);
            let low = grid.near(p[1].min(q[1]), 1, rows).saturating_sub(1);
            let high = (grid.near(p[1].max(q[1]), 1, rows) + 2).min(rows);
            for row in low..high {
                let y = grid.centre(0, row)[1];
                let range = if p[1].total_cmp(&q[1]).is_eq() {
                    [p[0].min(q[0]), p[0].max(q[0])]
                } else {
                    [self.abscissa(segment, y); 2]
                };
                let from = grid.near(range[0], 0, columns).saturating_sub(1);
                let to = (grid.near(range[1], 0, columns) + 2).min(columns);
                for column in from..to {
                    let ground = &mut grounds[row * columns + column];
                    if *ground == Ground::Outside {
                        let query = Query::new(grid.centre(column, row));
                        if self.plan.side(segment, &query).is_zero() {
                            *ground = self.ground(&query);
                        }
                    }
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_first_is_found_from_any_guess() {
        for count in 0..20 {
            for answer in 0..=count {
                for guess in 0..=count + 1 {
                    assert_eq!(
                        first(count, guess, |i| i >= answer),
                        answer,
                        "{count} {guess}"
                    );
                }
            }
        }
    }
}
