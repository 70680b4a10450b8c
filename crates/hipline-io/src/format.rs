//! The file formats that can be read.

use std::{fmt, path::Path};

use crate::ReadError;

/// A file format that [`read`](crate::read) understands.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Format {
    /// GeoJSON (RFC 7946), also one object per line or GeoJSON text sequences (RFC 8142).
    GeoJson,
    /// Well-known text, one geometry after the other.
    Wkt,
    /// GraphML with coordinates and weights under the keys that surfer2 and monos use.
    GraphMl,
    /// Polylines: a number of points, then that many `x y`; again and again.
    Line,
    /// A polygon: a number of rings, then for each its number of points and the points.
    Poly,
    /// Wavefront OBJ: `v`, `l` and `f`; heights are ignored.
    Obj,
}

impl Format {
    /// Every format.
    pub const ALL: [Self; 6] = [
        Self::GeoJson,
        Self::Wkt,
        Self::GraphMl,
        Self::Line,
        Self::Poly,
        Self::Obj,
    ];

    /// The file name extensions of the format, in lower case, the usual one first.
    #[must_use]
    pub const fn extensions(self) -> &'static [&'static str] {
        match self {
            Self::GeoJson => &[
                "geojson",
                "json",
                "geojsonl",
                "geojsons",
                "ndjson",
                "jsonl",
                "geojsonseq",
            ],
            Self::Wkt => &["wkt"],
            Self::GraphMl => &["graphml", "xml"],
            Self::Line => &["line", "lines"],
            Self::Poly => &["poly"],
            Self::Obj => &["obj"],
        }
    }

    /// The format by a file's extension.
    ///
    /// # Errors
    /// [`ReadError::UnknownFormat`] if no format has that extension.
    ///
    /// ```
    /// use hipline_io::Format;
    /// assert_eq!(Format::from_path("roofs/House.GeoJSON"), Ok(Format::GeoJson));
    /// assert!(Format::from_path("house.dwg").is_err());
    /// ```
    pub fn from_path(path: impl AsRef<Path>) -> Result<Self, ReadError> {
        let path = path.as_ref();
        let extension = path
            .extension()
            .map(|e| e.to_string_lossy().to_ascii_lowercase());
        Self::ALL
            .into_iter()
            .find(|format| {
                extension
                    .as_deref()
                    .is_some_and(|e| format.extensions().contains(&e))
            })
            .ok_or_else(|| ReadError::UnknownFormat {
                what: format!("`{}`", path.display()),
            })
    }

    /// The format by a look at the first characters. Bare numbers are taken as
    /// [`Format::Line`], because `.poly` files cannot be told from it with certainty.
    ///
    /// # Errors
    /// [`ReadError::UnknownFormat`] if the content starts like none of the formats.
    pub fn from_content(bytes: &[u8]) -> Result<Self, ReadError> {
        let bytes = bytes.strip_prefix(b"\xEF\xBB\xBF").unwrap_or(bytes);
        let mut rest = bytes.trim_ascii_start();
        while rest.first() == Some(&b'#') {
            let end = rest.iter().position(|&b| b == b'\n').unwrap_or(rest.len());
            rest = rest[end..].trim_ascii_start();
        }
        let word: &[u8] = rest
            .split(|b| !b.is_ascii_alphabetic())
            .next()
            .unwrap_or_default();
        match rest.first() {
            Some(b'{' | 0x1E) => Ok(Self::GeoJson),
            Some(b'<') => Ok(Self::GraphMl),
            Some(b'0'..=b'9') => Ok(Self::Line),
            _ if [&b"v"[..], b"o", b"g", b"mtllib", b"vn", b"vt"].contains(&word) => Ok(Self::Obj),
            _ if crate::read::is_wkt_keyword(word) => Ok(Self::Wkt),
            _ => Err(ReadError::UnknownFormat {
                what: "the content".to_owned(),
            }),
        }
    }
}

impl fmt::Display for Format {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

impl std::str::FromStr for Format {
    type Err = ReadError;

    /// The format by its usual extension, in any case: `geojson`, `wkt`, `graphml`,
    /// `line`, `poly`, `obj`.
    fn from_str(s: &str) -> Result<Self, ReadError> {
        Self::ALL
            .into_iter()
            .find(|format| format.extensions()[0].eq_ignore_ascii_case(s))
            .ok_or_else(|| ReadError::UnknownFormat {
                what: format!("`{s}`"),
            })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn content_tells_the_format() {
        for (content, format) in [
            ("\u{feff} {\"type\"", Format::GeoJson),
            ("\u{1e}{}", Format::GeoJson),
            ("<?xml", Format::GraphMl),
            ("# note\nPolygon((", Format::Wkt),
            ("SRID=4326;POINT(", Format::Wkt),
            ("# note\nv 0 0 0", Format::Obj),
            ("5\n0 0", Format::Line),
        ] {
            assert_eq!(
                Format::from_content(content.as_bytes()),
                Ok(format),
                "{content}"
            );
        }
        for content in ["", "# only", "hello", "\u{0}\u{1}", "-1 2"] {
            assert!(
                Format::from_content(content.as_bytes()).is_err(),
                "{content}"
            );
        }
    }

    #[test]
    fn names_and_extensions_lead_back() {
        for format in Format::ALL {
            for extension in format.extensions() {
                assert_eq!(Format::from_path(format!("a.b/c.{extension}")), Ok(format));
            }
            assert_eq!(format.extensions()[0].to_uppercase().parse(), Ok(format));
        }
        assert_eq!(
            Format::from_path("a/b").unwrap_err().to_string(),
            "`a/b` is in no known format; known are .geojson, .wkt, .graphml, .line, .poly and .obj"
        );
    }
}
