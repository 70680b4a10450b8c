//! Exact straight skeletons of planar straight-line graphs, with weights.
//!
//! ```text
//! input/       checked figures, weights          the only way in
//! predicates/  every geometric decision
//! topology/    ids                               reads no coordinate
//! kinetic/     the kinetic triangulation engine (Aichholzer & Aurenhammer 1996)
//! skeleton/    nodes, arcs, faces, verify        the only way out
//! ```

pub mod input;
mod kinetic;
mod predicates;
pub mod skeleton;
pub mod topology;

pub use input::{Figure, FigureBuilder, InvalidFigure, Polygon};
pub use skeleton::{Options, Region, Skeleton};
