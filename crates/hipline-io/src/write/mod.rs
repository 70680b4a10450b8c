//! Results and pictures, written to any [`Write`](std::io::Write).
//!
//! Coordinates and times in [`json`] are exact: they are read back bit for bit. In the other
//! formats this holds for everything but the ends of unbounded arcs and faces, which are
//! cut off at a window.

mod atomic;
mod centreline;
mod geojson;
mod heights;
mod json;
mod mesh;
mod motorcycles;
mod number;
mod obj;
mod observed;
mod palette;
mod picture;
#[cfg(feature = "png")]
mod png;
#[cfg(feature = "png")]
mod raster;
mod relief;
#[cfg(feature = "png")]
mod roof;
mod svg;
mod window;
mod wkt;

pub use atomic::write_atomically;
pub use centreline::{Measure, centreline_geojson, centreline_wkt};
pub use geojson::{geojson, lines_geojson};
pub use heights::{Heights, HeightsError};
pub use json::{ResultsJson, json};
pub use mesh::{
    Building, PlyEncoding, mesh_cityjson, mesh_glb, mesh_gltf, mesh_obj, mesh_ply, mesh_stl,
};
#[cfg(feature = "png")]
pub use motorcycles::motorcycles_png;
pub use motorcycles::{Tracks, motorcycles_geojson, motorcycles_json, motorcycles_svg};
pub use obj::{ObjWriter, obj};
pub use observed::{catchments_geojson, contours_geojson, drops_geojson, terrain_obj};
pub use picture::{Layers, OffsetLine, Picture};
#[cfg(feature = "png")]
pub use png::{DEFAULT_SIZE, PictureError};
pub use relief::Relief;
#[cfg(feature = "png")]
pub use roof::{RoofView, roof_png};
pub use window::Window;
pub use wkt::{lines_wkt, wkt};
