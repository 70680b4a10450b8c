//! Well-known text, one geometry after the other.
//!
//! Hand-written, because an error must name its line and column, because numbers that are
//! no finite doubles must be refused, and because the depth of nesting must be limited.
//! Extensions: `#` starts a comment line, `SRID=...;` before a geometry is skipped (EWKT),
//! geometries may be separated by `;`. A third number is a height, unless it is said to be a
//! measure (`M`); a fourth one is dropped.

use serde_json::Map;

use super::{
    position::{Chain, Position, lines, polygons},
    text::{Text, short},
};
use crate::{Document, Feature, Format, ReadError, document::Shape};

/// Geometry collections inside geometry collections.
const DEEPEST: usize = 64;

const KEYWORDS: [&str; 10] = [
    "POINT",
    "MULTIPOINT",
    "LINESTRING",
    "LINEARRING",
    "MULTILINESTRING",
    "POLYGON",
    "TRIANGLE",
    "MULTIPOLYGON",
    "GEOMETRYCOLLECTION",
    "SRID",
];

/// Whether a file that starts with this word is WKT.
pub(crate) fn is_keyword(word: &[u8]) -> bool {
    KEYWORDS
        .iter()
        .any(|k| keyword_of(word).eq_ignore_ascii_case(k.as_bytes()))
}

/// The word without a `Z`, `M` or `ZM` stuck to its end.
fn keyword_of(word: &[u8]) -> &[u8] {
    let m = word
        .strip_suffix(b"M")
        .or_else(|| word.strip_suffix(b"m"))
        .unwrap_or(word);
    m.strip_suffix(b"Z")
        .or_else(|| m.strip_suffix(b"z"))
        .unwrap_or(m)
}

pub(super) fn read(bytes: &[u8]) -> Result<Document, ReadError> {
    let text = Text::new(Format::Wkt.name(), bytes)?;
    let mut parser = Parser {
        text,
        at: 0,
        is_measured: false,
    };
    let mut document = Document::default();
    loop {
        while parser.peek() == Some(";") {
            parser.take();
        }
        if parser.peek().is_none() {
            break;
        }
        let case = parser.geometry(0)?;
        let index = document.features.len();
        document.features.push(Feature {
            index,
            id: None,
            properties: Map::new(),
            case,
        });
    }
    if document.features.is_empty() {
        return Err(text.content("there is no geometry"));
    }
    Ok(document)
}

struct Parser<'a> {
    text: Text<'a>,
    at: usize,
    /// Whether a third number is a measure.
    is_measured: bool,
}

impl<'a> Parser<'a> {
    /// Passes over white space and comment lines.
    fn skip(&mut self) {
        let bytes = self.text.text.as_bytes();
        while let Some(b) = bytes.get(self.at) {
            if b.is_ascii_whitespace() {
                self.at += 1;
            } else if *b == b'#' {
                let rest = &bytes[self.at..];
                self.at += rest.iter().position(|&b| b == b'\n').unwrap_or(rest.len());
            } else {
                break;
            }
        }
    }

    /// The next token: one of `( ) , ; =`, or the characters up to the next of them or to
    /// white space.
    fn peek(&mut self) -> Option<&'a str> {
        self.skip();
        let rest = &self.text.text[self.at..];
        let end = match rest.chars().next()? {
            '(' | ')' | ',' | ';' | '=' => 1,
            _ => rest
                .find(|c: char| {
                    c.is_ascii_whitespace() || matches!(c, '(' | ')' | ',' | ';' | '=' | '#')
                })
                .unwrap_or(rest.len()),
        };
        Some(&rest[..end])
    }

    fn take(&mut self) -> Option<&'a str> {
        let token = self.peek()?;
        self.at += token.len();
        Some(token)
    }

    fn expected(&mut self, what: &str) -> ReadError {
        let found = self.peek().map_or_else(|| "the end".to_owned(), short);
        self.text
            .error(self.at, format!("expected {what}, found {found}"))
    }

    fn eat(&mut self, token: &str) -> bool {
        let found = self.peek() == Some(token);
        if found {
            self.take();
        }
        found
    }

    fn eat_word(&mut self, word: &str) -> bool {
        let found = self.peek().is_some_and(|t| t.eq_ignore_ascii_case(word));
        if found {
            self.take();
        }
        found
    }

    fn geometry(&mut self, depth: usize) -> Result<Shape, ReadError> {
        if self.eat_word("SRID") {
            while self.peek().is_some_and(|t| t != ";") {
                self.take();
            }
            self.eat(";");
        }
        let Some(token) = self.peek() else {
            return Err(self.expected("a geometry"));
        };
        let word = String::from_utf8_lossy(keyword_of(token.as_bytes())).to_ascii_uppercase();
        if !KEYWORDS[..9].contains(&word.as_str()) {
            return Err(self.expected("POLYGON, LINESTRING or another geometry"));
        }
        self.take();
        let suffix = &token.as_bytes()[word.len()..];
        self.is_measured = suffix.eq_ignore_ascii_case(b"M") || self.eat_word("M");
        if !self.is_measured && !self.eat_word("Z") {
            self.eat_word("ZM");
        }
        if self.eat_word("EMPTY") {
            return Ok(Shape::Empty);
        }
        let shape = match word.as_str() {
            "POINT" => Shape::Points(self.chain()?.len()),
            "MULTIPOINT" => Shape::Points(self.multipoint()?),
            "LINESTRING" | "LINEARRING" => lines(&[self.chain()?]),
            "MULTILINESTRING" => lines(&self.list(Self::chain)?),
            "POLYGON" | "TRIANGLE" => polygons(&[self.list(Self::chain)?]),
            "MULTIPOLYGON" => polygons(&self.list(|p| p.list(Self::chain))?),
            _ if depth == DEEPEST => {
                return Err(self
                    .text
                    .error(self.at, "geometry collections are nested too deeply"));
            }
            _ => Shape::Collection(
                self.list(|p| p.geometry(depth + 1).map(|shape| vec![shape]))?
                    .concat(),
            ),
        };
        Ok(if shape.is_empty() {
            Shape::Empty
        } else {
            shape
        })
    }

    /// `( item , item ... )`; an item may be `EMPTY`.
    fn list<T>(
        &mut self,
        mut item: impl FnMut(&mut Self) -> Result<Vec<T>, ReadError>,
    ) -> Result<Vec<Vec<T>>, ReadError> {
        if !self.eat("(") {
            return Err(self.expected("`(`"));
        }
        let mut items = Vec::new();
        loop {
            items.push(if self.eat_word("EMPTY") {
                Vec::new()
            } else {
                item(self)?
            });
            if self.eat(")") {
                return Ok(items);
            }
            if !self.eat(",") {
                return Err(self.expected("`,` or `)`"));
            }
        }
    }

    /// `( x y, x y ... )`
    fn chain(&mut self) -> Result<Chain, ReadError> {
        self.list(|p| p.position().map(|p| vec![p]))
            .map(|list| list.concat())
    }

    /// `( x y, (x y), ... )`
    fn multipoint(&mut self) -> Result<usize, ReadError> {
        let points = self.list(|p| {
            if p.peek() == Some("(") {
                p.chain()
            } else {
                p.position().map(|p| vec![p])
            }
        })?;
        Ok(points.iter().map(Vec::len).sum())
    }

    /// Two numbers, and up to two more.
    fn position(&mut self) -> Result<Position, ReadError> {
        let place = [self.number()?, self.number()?];
        let mut more = [None; 2];
        for slot in &mut more {
            if self.peek().is_some_and(|t| !matches!(t, "," | ")")) {
                *slot = Some(self.number()?);
            }
        }
        let z = more[0].filter(|_| !self.is_measured);
        Ok(Position { place, z })
    }

    fn number(&mut self) -> Result<f64, ReadError> {
        match self.peek() {
            None | Some("(" | ")" | "," | ";" | "=") => Err(self.expected("a number")),
            Some(token) => {
                let value = self.text.number(self.at, token)?;
                self.take();
                Ok(value)
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{LineShape, Motion, PolygonShape};

    fn ok(text: &str) -> Vec<Shape> {
        let document = read(text.as_bytes()).unwrap_or_else(|e| panic!("{text}: {e}"));
        document.features.into_iter().map(|f| f.case).collect()
    }

    fn err(text: &str) -> String {
        read(text.as_bytes())
            .map(|d| panic!("{text}: {d:?}"))
            .unwrap_err()
            .to_string()
    }

    #[test]
    fn every_geometry() {
        let points = vec![[0.0, 0.0], [1.0, 0.0], [0.0, 1.0], [0.0, 0.0]];
        let polygon = PolygonShape::new(vec![points.clone()]);
        let line = LineShape::new(points);
        let at = |z| Motion {
            z: vec![Some(z); 4],
            ..Motion::default()
        };
        let ring = "(0 0, 1 0, 0 1, 0 0)";
        assert_eq!(
            ok(&format!("POLYGON({ring})")),
            [Shape::Polygons(vec![polygon.clone()])]
        );
        assert_eq!(
            ok("triangle z ((0 0 5, 1 0 5,0 1 5,0 0 5))"),
            [Shape::Polygons(vec![PolygonShape {
                motions: vec![at(5.0)],
                ..polygon.clone()
            }])]
        );
        assert_eq!(
            ok(&format!("multipolygon ZM (({ring}), EMPTY, ({ring}))")),
            [Shape::Polygons(vec![polygon.clone(), polygon.clone()])]
        );
        assert_eq!(
            ok("LINESTRINGZ(0 0 1,1 0 1,0 1 1,0 0 1)"),
            [Shape::Lines(vec![LineShape {
                motion: at(1.0),
                ..line.clone()
            }])]
        );
        assert_eq!(
            ok(&format!("LINEARRING{ring}")),
            [Shape::Lines(vec![line.clone()])]
        );
        assert_eq!(
            ok(&format!("MultiLineString ({ring},{ring})")),
            [Shape::Lines(vec![line.clone(), line.clone()])]
        );
        assert_eq!(ok("POINT(1 2)"), [Shape::Points(1)]);
        assert_eq!(ok("MULTIPOINT(1 2, (3 4), EMPTY)"), [Shape::Points(2)]);
        assert_eq!(
            ok(&format!(
                "GEOMETRYCOLLECTION(LINESTRING{ring}, POLYGON({ring}), POINT EMPTY)"
            )),
            [Shape::Collection(vec![
                Shape::Lines(vec![line]),
                Shape::Polygons(vec![polygon]),
                Shape::Empty
            ])]
        );
        for empty in [
            "POLYGON EMPTY",
            "POLYGON Z EMPTY",
            "multipolygon empty",
            "GEOMETRYCOLLECTION(POINT EMPTY)",
        ] {
            assert_eq!(ok(empty), [Shape::Empty]);
        }
    }

    #[test]
    fn several_geometries_follow_each_other() {
        let text = "\u{feff}# two lines\nSRID=4326;LINESTRING(0 0,\n 1 1)\n\nLINESTRING(0 0, 2 2);LINESTRING EMPTY;\n";
        assert_eq!(ok(text).len(), 3);
    }

    #[test]
    fn errors_name_the_place() {
        assert_eq!(err(""), "WKT: there is no geometry");
        assert_eq!(
            err("POLYGON((0 0, NaN 0, 1 1))"),
            "WKT, line 1, column 15: `NaN` is not a finite number"
        );
        assert_eq!(
            err("POLYGON((0 0,\n1 -inf))"),
            "WKT, line 2, column 3: `-inf` is not a finite number"
        );
        assert_eq!(
            err("LINESTRING(0 0, 1 1e400)"),
            "WKT, line 1, column 19: `1e400` is too large for a double"
        );
        assert_eq!(
            err("LINESTRING(0 0, 1 1x)"),
            "WKT, line 1, column 19: `1x` is not a number"
        );
        assert_eq!(
            err("LINESTRING(0 0, 1)"),
            "WKT, line 1, column 18: expected a number, found `)`"
        );
        assert_eq!(
            err("LINESTRING(0 0 1 2 3)"),
            "WKT, line 1, column 20: expected `,` or `)`, found `3`"
        );
        assert_eq!(
            err("LINESTRING(0 0, 1 1"),
            "WKT, line 1, column 20: expected `,` or `)`, found the end"
        );
        assert_eq!(
            err("LINESTRING 0 0"),
            "WKT, line 1, column 12: expected `(`, found `0`"
        );
        assert_eq!(
            err("LINESTRING EMPTY\nCIRCLE(0 0, 1)"),
            "WKT, line 2, column 1: expected POLYGON, LINESTRING or another geometry, found `CIRCLE`"
        );
        assert_eq!(
            err(&"GEOMETRYCOLLECTION(".repeat(100_000)),
            "WKT, line 1, column 1235: geometry collections are nested too deeply"
        );
        assert_eq!(
            read(b"POLYGON((\n\xff").unwrap_err().to_string(),
            "WKT, line 2, column 1: not UTF-8 text"
        );
    }
}
