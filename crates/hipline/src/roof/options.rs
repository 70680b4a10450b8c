//! What a roof can be asked to be, and why there may be none.

use crate::input::Source;
use std::fmt;

/// The shape of a roof.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub enum RoofShape {
    /// Every edge rises at its slope.
    #[default]
    Hip,
    /// Some edges carry gables: vertical walls up to the roof.
    Gable,
    /// Steep up to a break, flatter above it, on all edges.
    Mansard,
    /// Steep up to a break, flatter above it, between gables.
    Gambrel,
    /// Level.
    Flat,
}

/// How steep a roof is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Steepness {
    /// Rise over run: 1 is a pitch of 45 degrees.
    Slope(f64),
    /// The height of the highest point above the eaves, in input units.
    Height(f64),
}

/// Which edges carry gables.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub enum Gables {
    /// The short ends: see [`plan::short_ends`](super::plan::short_ends).
    #[default]
    Auto,
    /// These.
    Edges(Vec<Source>),
}

/// What a roof is to be. All lengths are in input units, all slopes are rise over run.
#[derive(Debug, Clone, PartialEq)]
pub struct RoofOptions {
    /// The shape.
    pub shape: RoofShape,
    /// How steep it is; of a mansard or gambrel roof, its upper part.
    pub steepness: Steepness,
    /// Slopes of single edges, in place of the common one.
    pub edge_slopes: Vec<(Source, f64)>,
    /// Which edges of a gable or gambrel roof carry gables.
    pub gables: Gables,
    /// The slope below the break of a mansard or gambrel roof.
    pub lower_slope: f64,
    /// How high the break of a mansard or gambrel roof is above the eaves. It is lowered in proportion if the roof is to be
    /// lower than that.
    pub break_height: f64,
    /// The height at which the roof meets the outer faces of the walls.
    pub eaves: f64,
    /// The height of the floor; not above the eaves.
    pub ground: f64,
    /// How far the roof reaches beyond the walls, measured in the plan. Its eaves are lower by
    /// that much times the slope. Edges of other slopes than the common one reach as far as they
    /// must for all eaves to be level.
    pub overhang: f64,
    /// Whether there are walls from the floor to the roof, where it is above the floor.
    pub walls: bool,
    /// Whether there is a floor.
    pub floor: bool,
}

impl Default for RoofOptions {
    /// A hip roof of 45 degrees on a floor at height 0.
    fn default() -> Self {
        Self {
            shape: RoofShape::Hip,
            steepness: Steepness::Slope(1.0),
            edge_slopes: Vec::new(),
            gables: Gables::Auto,
            lower_slope: 3.0,
            break_height: 2.0,
            eaves: 0.0,
            ground: 0.0,
            overhang: 0.0,
            walls: true,
            floor: true,
        }
    }
}

impl RoofOptions {
    /// A hip roof of a slope (rise over run) on a floor at height 0.
    #[must_use]
    pub fn hip(slope: f64) -> Self {
        Self {
            steepness: Steepness::Slope(slope),
            ..Self::default()
        }
    }

    /// Checks the numbers by themselves.
    pub(super) fn check(&self) -> Result<(), InvalidRoof> {
        let slope = match self.steepness {
            Steepness::Slope(slope) => slope,
            Steepness::Height(height) if height.is_finite() && height > 0.0 => 1.0,
            Steepness::Height(height) => return Err(InvalidRoof::Height(height)),
        };
        for slope in [slope, self.lower_slope] {
            if !(slope.is_finite() && slope > 0.0) {
                return Err(InvalidRoof::Slope(slope));
            }
        }
        let lengths = [
            ("eaves' height", self.eaves, f64::NEG_INFINITY),
            ("floor's height", self.ground, f64::NEG_INFINITY),
            ("overhang", self.overhang, 0.0),
            ("height of the break", self.break_height, 0.0),
        ];
        for (what, value, least) in lengths {
            if !(value.is_finite() && value >= least) {
                return Err(InvalidRoof::Length { what, value });
            }
        }
        if self.eaves < self.ground {
            return Err(InvalidRoof::BelowFloor {
                eaves: self.eaves,
                ground: self.ground,
            });
        }
        Ok(())
    }
}

/// Names an edge in messages.
struct Edge<'a>(&'a Source);

impl fmt::Display for Edge<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Source { part, ring, edge } = self.0;
        write!(f, "part {part}, ring {ring}, edge {edge}")
    }
}

/// Why there is no roof. Edges are in the caller's numbering.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum InvalidRoof {
    /// The slope is not a number above zero.
    #[error("a roof's slope must be finite and above 0, unlike {0}")]
    Slope(f64),
    /// The height of the roof is not a number above zero.
    #[error("a roof's height must be finite and above 0, unlike {0}")]
    Height(f64),
    /// The slope of an edge is not a number above zero.
    #[error("{} has the slope {slope}; a slope must be finite and above 0", Edge(.edge))]
    EdgeSlope {
        /// The edge.
        edge: Source,
        /// Its slope.
        slope: f64,
    },
    /// A slope or a gable for an edge that is not there.
    #[error("there is no {}", Edge(.0))]
    NoEdge(Source),
    /// A length that is no finite number, or negative where it must not be.
    #[error("the {what} cannot be {value}")]
    Length {
        /// Of what.
        what: &'static str,
        /// The number.
        value: f64,
    },
    /// The eaves are below the floor.
    #[error("the eaves at height {eaves} are below the floor at {ground}")]
    BelowFloor {
        /// The height of the eaves, lowered by the overhang.
        eaves: f64,
        /// The height of the floor.
        ground: f64,
    },
    /// No part of the skeleton is bounded.
    #[error("a roof needs a bounded part of the plane, as the inside of a polygon")]
    Unbounded,
    /// A height beyond the range of numbers.
    #[error("the roof at ({x}, {y}) is higher than any number")]
    TooHigh {
        /// Where, in the plan.
        x: f64,
        /// Where, in the plan.
        y: f64,
    },
    /// Too small for its coordinates: rounding leaves no area.
    #[error("the roof near ({x}, {y}) is too small for the digits of its coordinates")]
    Rounding {
        /// Where, in the plan.
        x: f64,
        /// Where, in the plan.
        y: f64,
    },
    /// The roof comes down to the floor inside of the footprint.
    #[error(
        "the roof comes down to the floor at ({x}, {y}), inside of the footprint; higher eaves help"
    )]
    TouchesFloor {
        /// Where, in the plan.
        x: f64,
        /// Where, in the plan.
        y: f64,
    },
    /// An overhang around something that is not made of polygons.
    #[error("only roofs over polygons alone can have an overhang, or be flat")]
    NotPolygons,
    /// The overhang is larger than a courtyard.
    #[error("the overhang closes the courtyard at ({x}, {y})")]
    CourtyardClosed {
        /// A corner of the courtyard.
        x: f64,
        /// A corner of the courtyard.
        y: f64,
    },
    /// The overhang is so small that rounding puts it onto the walls, or makes it cross itself.
    #[error("an overhang of {0} is too small or too large for the digits of the coordinates")]
    Overhang(f64),
}
