//! Every geometric decision: signs of exact numbers, and orders that follow from them.
//!
//! Invariant: what leaves this module is a sign, an order or a correctly rounded number for
//! output; [`Bounds`] only ever saves asking.

mod caps;
mod clearance;
mod coplanar;
mod decide;
mod eaves;
mod expression;
mod fall;
mod fixed;
mod grid;
mod heading;
mod lines;
mod memo;
mod moment;
mod motions;
mod orientation;
mod passage;
mod phases;
mod place;
mod planes;
mod ramp;
mod relation;
mod root;
mod rough;
mod section;
mod speeds;
mod station;
mod terminal;
mod turn;

pub(crate) use eaves::Eave;
pub(crate) use expression::{Corner, Direction};
pub(crate) use heading::{Course, Heading};
pub(crate) use moment::{Area, Bounds, Moment, Part};
pub(crate) use motions::{Motion, lines_of_wall, pair_of_motion, start_of_motion, wall_of_line};
pub(crate) use orientation::orientation;
pub(crate) use passage::{Lane, Rail};
pub(crate) use place::{Bound, Place, Start};
pub(crate) use planes::{PlaneId, Planes};
pub(crate) use section::{CellCorner, Line};
pub(crate) use station::{Spot, Station, Track, Way, rough_side};
pub(crate) use terminal::Terminal;
pub(crate) use turn::turn;
