//! Checked figures: the only way into the engines.
//!
//! A [`Figure`] is a planar straight-line graph whose vertices are distinct and
//! whose edges meet in vertices only. [`FigureBuilder`] makes one from polygons,
//! polylines and graphs; it finds every [`Flaw`] and names it in the caller's own
//! numbering. Whatever takes a `&Figure` can trust it.

mod builder;
mod change;
#[cfg(any(test, debug_assertions))]
mod check;
mod collinear;
mod convert;
mod crossing;
mod directions;
mod figure;
mod flaw;
mod gather;
mod height;
mod mesh;
mod monotone;
mod nesting;
mod order;
mod part;
mod polygon;
mod range;
mod single;
mod triangulate;

pub use builder::FigureBuilder;
pub use change::{Change, Sides, SpeedChange};
pub use figure::{Edge, Figure, Source};
pub use flaw::{Flaw, InvalidFigure, Place};
pub(crate) use mesh::{Mesh, MeshEdge};
pub(crate) use monotone::Monotone;
pub(crate) use part::{FigurePart, Parts};
pub use polygon::Polygon;
