//! File formats and pictures for hipline.
//!
//! ```text
//! format       which file format, by name or by a look at the content
//! document     what a file holds: features, as plain data, on the way to a figure
//! motion       how edges move over time, and how high vertices are
//! setting      weights and heights that are given apart from a file
//! chain        the rings, lines and graphs of a shape in a row, to give them to
//! read/        GeoJSON, WKT, GraphML, .line, .poly, OBJ; a skeleton from its JSON, weights from a table
//! write/       JSON, GeoJSON, WKT, OBJ; SVG and PNG pictures; whole files or none
//! ```
//!
//! A reader gives every number as the f64 nearest to its decimals; a writer prints the
//! shortest decimals that are read back as the same f64. No content of a file makes a
//! reader panic.
//!
//! The formats, with examples, are described in `docs/formats.md`, the JSON of a result in
//! `docs/skeleton-json.md`.
//!
//! # Example
//!
//! ```
//! use hipline_io::{Format, Shape, read};
//!
//! let document = read(b"POLYGON ((0 0, 4 0, 4 3, 0 0))", Format::Wkt)?;
//! let Shape::Polygons(polygons) = &document.features[0].case else { unreachable!() };
//! assert_eq!(polygons[0].rings[0][2], [4.0, 3.0]);
//! # Ok::<(), hipline_io::ReadError>(())
//! ```

mod chain;
mod document;
mod error;
mod format;
mod motion;
mod read;
mod setting;
pub mod write;

pub use document::{Document, Feature, GraphShape, LineShape, PolygonShape, Shape};
pub use error::{FeatureName, FigureError, ReadError, Reason};
pub use format::Format;
pub use motion::{Motion, Profile};
pub use read::{SkeletonRecord, read, read_launches, read_settings, read_skeleton, read_skeletons};
pub use setting::{Setting, SettingError, SettingErrors, Target, Value};
