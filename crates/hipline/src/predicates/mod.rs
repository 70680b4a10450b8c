//! Every geometric decision: signs of exact numbers, and orders that follow from them.
//!
//! Invariant: what leaves this module is a sign, an order or a correctly rounded number for
//! output; [`Bounds`] only ever saves asking.

mod caps;
mod decide;
mod eaves;
mod expression;
mod fixed;
mod grid;
mod heading;
mod moment;
mod orientation;
mod phases;
mod place;
mod planes;
mod relation;
mod root;
mod rough;
mod speeds;
mod station;
mod terminal;

pub(crate) use eaves::Eave;
pub(crate) use expression::{Corner, Direction};
pub(crate) use heading::{Course, Heading};
pub(crate) use moment::{Area, Bounds, Moment, Part};
pub(crate) use orientation::orientation;
pub(crate) use place::{Bound, Place, Start};
pub(crate) use planes::{PlaneId, Planes};
pub(crate) use station::{Spot, Station, Track, Way, rough_side};
pub(crate) use terminal::Terminal;
