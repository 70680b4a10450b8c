//! Exact straight skeletons of planar straight-line graphs, with weights.
//!
//! ```text
//! input/       checked figures, weights          the only way in
//! predicates/  every geometric decision
//! topology/    ids                               reads no coordinate
//! engine/      which engine applies
//! kinetic/     the kinetic triangulation engine (Aichholzer & Aurenhammer 1996)
//! monotone/    the engine for monotone polygons, and chains (Biedl and others 2015)
//! orthogonal/  the engine for orthogonal monotone polygons (Eder, Held & Palfrader 2019)
//! wavefront/   what an engine leaves behind
//! skeleton/    nodes, arcs, faces, verify        the only way out
//! lift/        from the result back to the planes
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
mod lift;
mod monotone;
pub mod motorcycle;
pub mod observe;
pub mod offset;
mod orthogonal;
mod predicates;
pub mod roof;
pub mod skeleton;
pub mod topology;
mod wavefront;

pub use engine::{Engine, NotApplicable};
pub use envelope::subdivision;
pub use input::{Figure, FigureBuilder, InvalidFigure, Polygon};
pub use monotone::{Chain, InvalidChain};
pub use skeleton::{Options, Region, Skeleton};
