//! The centreline: the approximate medial axis, read off a skeleton.
//!
//! It is the straight skeleton without the arcs that lead to the boundary: each arc at an input
//! vertex goes, up to the first node where it meets others; so does each arc to infinity. Ghost
//! arcs that start at a vertex go, too; those that start at an event remain, because they join
//! what would be one line if two edges were not on one line by chance. What is left has, without
//! weights, the shape of the figure: one connected part for each part of the inside, and one
//! cycle for each hole that touches no other ring (faces without holes can be pushed from their
//! edges onto their arcs). Ridges between parallel walls belong to it.
//!
//! The medial axis itself has pieces of parabolas around reflex vertices, which a straight
//! skeleton replaces by straight lines; elsewhere they agree.
//!
//! # Branches
//! A branch runs from an end inwards until it meets a longer one, or a cycle, or what joins
//! cycles. (Of two that are equally long, the one whose end has the smaller number goes on.) In a
//! part without cycles, the longest branch is the longest of all paths. Branches can be dropped by
//! length ([`CentrelineOptions::prune`]); one that carries another that is kept stays. Neither the
//! longest path nor any cycle is ever dropped. The same comes of dropping the shortest branch
//! again and again, until none is too short.
//!
//! # Exactness
//! Lengths are those of the line as it is written, whose points are rounded. But they
//! are compared exactly, so that no symmetry is broken by rounding.
//!
//! ```
//! use hipline::{Polygon, centreline::CentrelineOptions};
//!
//! let street = vec![[0.0, 0.0], [8.0, 0.0], [8.0, 4.0], [0.0, 4.0]];
//! let polygon = Polygon::new([street])?;
//! let skeleton = polygon.skeleton();
//! let lines = skeleton.centreline(polygon.figure(), CentrelineOptions::default())?;
//! assert_eq!(lines.lines()[0].points(), [[6.0, 2.0, 2.0], [2.0, 2.0, 2.0]]);
//!
//! let whole = CentrelineOptions::default().extend(true);
//! let lines = skeleton.centreline(polygon.figure(), whole)?;
//! let ends = [[8.0, 2.0, 0.0], [6.0, 2.0, 2.0], [2.0, 2.0, 2.0], [0.0, 2.0, 0.0]];
//! assert_eq!(lines.lines()[0].points(), ends);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod branches;
mod ends;
mod graph;
mod lines;

use crate::{input::Figure, lift::Lift, skeleton::Skeleton, topology::NodeId};
use graph::Graph;
use hipline_num::hypot;

/// What to leave out of a centreline, and whether to carry it on.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
#[non_exhaustive]
pub struct CentrelineOptions {
    /// Branches shorter than this are dropped, in input units.
    pub prune: f64,
    /// Branches shorter than this many times the local width where they end are dropped. The
    /// width is twice the time.
    pub prune_ratio: f64,
    /// Only the longest branch of each part is kept; of a part with cycles, the cycles and what
    /// joins them.
    pub longest: bool,
    /// Ends are carried on to the boundary.
    pub extend: bool,
}

impl CentrelineOptions {
    /// Drops branches shorter than a length, in input units.
    #[must_use]
    pub const fn prune(mut self, length: f64) -> Self {
        self.prune = length;
        self
    }

    /// Drops branches shorter than so many times the width where they end.
    #[must_use]
    pub const fn prune_ratio(mut self, ratio: f64) -> Self {
        self.prune_ratio = ratio;
        self
    }

    /// Keeps the longest branch of each part only.
    #[must_use]
    pub const fn longest(mut self, longest: bool) -> Self {
        self.longest = longest;
        self
    }

    /// Carries ends on to the boundary.
    #[must_use]
    pub const fn extend(mut self, extend: bool) -> Self {
        self.extend = extend;
        self
    }
}

/// A length or ratio that is negative, infinite or no number.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
#[error("branches can be pruned by a finite number that is not below 0, unlike {0}")]
pub struct InvalidPruning(pub f64);

/// A line between two nodes where the centreline ends or branches.
#[derive(Debug, Clone, PartialEq)]
pub struct Line {
    points: Vec<[f64; 3]>,
    ends: [NodeId; 2],
}

impl Line {
    /// The points: x, y and time, which is half the local width (without weights, the distance
    /// to the nearest edges' lines). The last point of a cycle is the first one again.
    #[must_use]
    pub fn points(&self) -> &[[f64; 3]] {
        &self.points
    }

    /// The nodes where it ends, before ends were carried on; lines that meet have one in common.
    #[must_use]
    pub const fn ends(&self) -> [NodeId; 2] {
        self.ends
    }

    /// Whether it ends where it starts.
    #[must_use]
    pub fn is_closed(&self) -> bool {
        self.ends[0] == self.ends[1]
    }

    /// Its length, in input units, up to rounding; of the same bits on every platform.
    #[must_use]
    pub fn length(&self) -> f64 {
        let steps = self.points.windows(2);
        steps
            .map(|s| hypot(s[1][0] - s[0][0], s[1][1] - s[0][1]))
            .sum()
    }
}

/// A centreline.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Centreline {
    lines: Vec<Line>,
}

impl Centreline {
    /// The lines, in an order that is reproducible.
    #[must_use]
    pub fn lines(&self) -> &[Line] {
        &self.lines
    }
}

impl Skeleton {
    /// The centreline of what the skeleton covers: of the inside of polygons, by default.
    ///
    /// Figures whose skeleton is nothing but arcs to the boundary, as those of triangles and
    /// squares are, have none. Points that are rounded to one place are one.
    ///
    /// Ends are carried on to the boundary halfway between the arcs that were left out there: if
    /// their number is odd, along the one in the middle, down to its input vertex; if it is even,
    /// straight down the face in the middle, to the foot of the perpendicular on its edge. (Where
    /// weights put that foot beside the edge, along the next arc.)
    ///
    /// # Complexity
    /// O(n), plus the comparisons of lengths that f64 does not decide.
    ///
    /// # Errors
    /// If a number to prune by is negative, infinite or no number.
    ///
    /// # Panics
    /// If the figure is not the one that the skeleton was computed from.
    pub fn centreline(
        &self,
        figure: &Figure,
        options: CentrelineOptions,
    ) -> Result<Centreline, InvalidPruning> {
        for value in [options.prune, options.prune_ratio] {
            if !(value.is_finite() && value >= 0.0) {
                return Err(InvalidPruning(value));
            }
        }
        let lift = Lift::new(self, figure);
        let mut graph = Graph::new(&lift);
        if options.longest || options.prune > 0.0 || options.prune_ratio > 0.0 {
            branches::prune(&mut graph, options);
        }
        let mut lines = lines::trace(&graph);
        if options.extend {
            for line in &mut lines {
                ends::extend(&graph, line);
            }
        }
        lines.retain_mut(|line| {
            line.points.dedup_by(|a, b| {
                let bits = |p: &[f64; 3]| [p[0].to_bits(), p[1].to_bits()];
                bits(a) == bits(b)
            });
            line.points.len() > 1
        });
        Ok(Centreline { lines })
    }
}
