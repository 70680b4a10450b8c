//! Exact straight skeletons of planar straight-line graphs, with weights.
//!
//! ```text
//! input/       checked figures, weights          the only way in
//! predicates/  every geometric decision
//! topology/    ids                               reads no coordinate
//! engine/      which engine applies
//! kinetic/     the kinetic triangulation engine (Aichholzer & Aurenhammer 1996)
//! wavefront/   what an engine leaves behind
//! skeleton/    nodes, arcs, faces, verify        the only way out
//! motorcycle/  motorcycle graphs
//! offset/      the wavefront at given distances
//! centreline/  the approximate medial axis
//! roof/        the skeleton lifted to a surface
//! observe/     queries, rain, terrain
//! ```

pub mod centreline;
pub mod engine;
mod envelope;
pub mod input;
mod kinetic;
pub mod motorcycle;
pub mod observe;
pub mod offset;
mod predicates;
pub mod roof;
pub mod skeleton;
pub mod topology;
mod wavefront;

pub use engine::{Engine, NotApplicable};
pub use input::{Figure, FigureBuilder, InvalidFigure, Polygon};
pub use skeleton::{Options, Region, Skeleton};
