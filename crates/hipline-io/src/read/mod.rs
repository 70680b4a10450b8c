//! From bytes to a [`Document`].

mod geojson;
mod graphml;
mod launches;
mod line;
mod obj;
mod position;
mod skeleton;
mod table;
mod text;
mod weights;
mod wkt;

pub use launches::read_launches;
pub use skeleton::{SkeletonRecord, read_skeleton, read_skeletons};
pub use table::read_settings;
pub(crate) use text::short;
pub(crate) use wkt::is_keyword as is_wkt_keyword;

use crate::{Document, Format, ReadError};

/// Reads a whole file.
///
/// # Complexity
/// Linear in the number of bytes, in time and memory; no number in a file is believed
/// about how much memory to take.
///
/// # Errors
/// What breaks the rules of the format, with its line and column, or the feature that
/// makes no sense, with its number and id.
pub fn read(bytes: &[u8], format: Format) -> Result<Document, ReadError> {
    match format {
        Format::GeoJson => geojson::read(bytes),
        Format::Wkt => wkt::read(bytes),
        Format::GraphMl => graphml::read(bytes),
        Format::Line => line::read_line(bytes),
        Format::Poly => line::read_poly(bytes),
        Format::Obj => obj::read(bytes),
    }
}

/// A syntax error of `serde_json`, in our words.
fn json_error(format: &'static str, e: &serde_json::Error) -> ReadError {
    let (line, column) = (e.line(), e.column());
    let mut message = e.to_string();
    if let Some(end) = message.rfind(" at line ") {
        message.truncate(end);
    }
    ReadError::Syntax {
        format,
        line,
        column,
        message,
    }
}
