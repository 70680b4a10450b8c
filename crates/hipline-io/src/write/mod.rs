//! Results and pictures, written to any [`Write`](std::io::Write).
//!
//! Coordinates and times in [`json`] are exact: they are read back bit for bit. In the other
//! formats this holds for everything but the ends of unbounded arcs and faces, which are
//! cut off at a window.

mod atomic;
mod centreline;
mod geojson;
mod json;
mod number;
mod obj;
mod palette;
mod picture;
#[cfg(feature = "png")]
mod png;
#[cfg(feature = "png")]
mod raster;
#[cfg(feature = "png")]
mod roof;
mod svg;
mod window;
mod wkt;

pub use atomic::write_atomically;
pub use centreline::{Measure, centreline_geojson, centreline_wkt};
pub use geojson::{geojson, lines_geojson};
pub use json::{ResultsJson, json};
pub use obj::{ObjWriter, obj};
pub use picture::{Layers, OffsetLine, Picture};
#[cfg(feature = "png")]
pub use png::{DEFAULT_SIZE, PictureError};
#[cfg(feature = "png")]
pub use roof::{RoofView, roof_png};
pub use window::Window;
pub use wkt::{lines_wkt, wkt};
