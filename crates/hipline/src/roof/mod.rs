//! Roofs: the skeleton lifted to a surface, and the house below it.
//!
//! A point that the wavefront reaches at time t is `slope * t` above the eaves (Aichholzer &
//! Aurenhammer 1996, section 4). Each face of the skeleton is a facet in one plane, up to the
//! rounding of its corners.
//!
//! ```text
//! options     what a roof can be asked to be
//! plan        which edges rise how steeply, which stand still: gables, mansards
//! house       plan, overhang, skeleton, surface, walls and floor: the way through
//! surface     facets from a skeleton, cut into triangles
//! mend        what rounding has spoilt is made to tile the plan again
//! solid       walls, floor and soffit
//! mesh        the result
//! check       is a mesh a closed surface that meets itself nowhere?
//! contact     do two triangles meet?
//! half_edges, region, ears, plane    what these are made with
//! ```
//!
//! # Why roofs do not meet themselves
//! Every triangle of the roof has a positive area in the plan, exactly, and together they have the
//! footprint's boundary, which is simple. So each point of the footprint is covered once
//! (the winding number of the boundary says how often), and the roof is the graph of a function.
//! Walls are vertical and stand on the boundary below it.

mod check;
mod contact;
mod ears;
mod half_edges;
mod house;
mod mend;
mod mesh;
mod options;
pub mod plan;
mod plane;
mod region;
mod solid;
mod surface;

pub use check::MeshFlaw;
pub use mesh::{Facet, Mesh, Surface};
pub use options::{Gables, InvalidRoof, RoofOptions, RoofShape, Steepness};
pub(crate) use surface::{Tiles, tiled};
