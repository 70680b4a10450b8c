//! What a skeleton tells about the plane: which face a point lies in and how high the surface is
//! there, where rain runs, and the surface as a terrain.
//!
//! ```text
//! plan         the borders of the faces, as segments with exact sides
//! standing     faces without area, in plan
//! trapezoids   a search structure over them
//! index        point location and heights, one by one or over a grid
//! grid         raster cells by scan lines
//! rain         the path of a drop
//! window       a rectangle
//! terrain      the surface in a window, as triangles
//! catchment    areas and outlines of what drains into an edge or a river system
//! contour      lines of one height in a window
//! ```
//!
//! The surface is that of Aichholzer and Aurenhammer 1996, section 4: over each point the time at
//! which the wavefront arrives. Height is time times a slope, over the elevation of the graph.

mod catchment;
mod contour;
mod grid;
mod index;
mod plan;
mod rain;
mod standing;
mod terrain;
mod trapezoids;
mod window;

pub use catchment::{Catchment, Systems};
pub use contour::{Contour, InvalidStep, contours};
pub use grid::{Grid, InvalidGrid};
pub use index::{Answer, Index, NoAnswer};
pub use rain::{Drop, Ending};
pub use terrain::{Terrain, Triangle};
pub use window::{InvalidWindow, Window};
