//! `.line` files (polylines) and `.poly` files (one polygon with holes).
//!
//! Both are blocks: a number of points, then that many `x y`. A `.poly` file starts with
//! the number of blocks, and a `.line` file may do so. A polyline is closed if it ends
//! where it starts. `#` starts a comment.

use serde_json::Map;

use super::text::{Text, short};
use crate::{
    Document, Feature, Format, ReadError,
    document::{LineShape, PolygonShape, Shape},
};

pub(super) fn read_line(bytes: &[u8]) -> Result<Document, ReadError> {
    let lines = blocks(Text::new(Format::Line.name(), bytes)?)?;
    let lines = lines.into_iter().filter(|points| !points.is_empty());
    Ok(document(Shape::Lines(lines.map(LineShape::new).collect())))
}

pub(super) fn read_poly(bytes: &[u8]) -> Result<Document, ReadError> {
    let rings = blocks(Text::new(Format::Poly.name(), bytes)?)?;
    if rings.iter().all(Vec::is_empty) {
        return Ok(document(Shape::Empty));
    }
    Ok(document(Shape::Polygons(vec![PolygonShape::new(rings)])))
}

fn document(shape: Shape) -> Document {
    let case = if shape.is_empty() {
        Shape::Empty
    } else {
        shape
    };
    Document {
        features: vec![Feature {
            index: 0,
            id: None,
            properties: Map::new(),
            case,
        }],
    }
}

#[derive(Clone, Copy)]
struct Token<'a> {
    text: &'a str,
    at: usize,
}

fn blocks(text: Text) -> Result<Vec<Vec<[f64; 2]>>, ReadError> {
    let mut tokens = Vec::new();
    // How many tokens the first two lines have that have any.
    let mut first_lines = Vec::new();
    let mut at = 0;
    for line in text.text.split_inclusive('\n') {
        let before = tokens.len();
        let code = line.split('#').next().unwrap_or_default();
        for token in code.split_ascii_whitespace() {
            // A token is a slice of the line, so the difference of addresses is its place.
            tokens.push(Token {
                text: token,
                at: at + (token.as_ptr() as usize - line.as_ptr() as usize),
            });
        }
        if tokens.len() > before && first_lines.len() < 2 {
            first_lines.push(tokens.len() - before);
        }
        at += line.len();
    }
    if tokens.is_empty() {
        return Err(text.content("there is no number of points"));
    }
    let has_count = first_lines == [1, 1] || first_lines == [1];
    let sizes = sizes(text, &tokens, has_count)
        .or_else(|e| self::sizes(text, &tokens, !has_count).map_err(|_| e))?;
    sizes
        .into_iter()
        .map(|(first, size)| {
            let tokens = &tokens[first..first + 2 * size];
            tokens
                .chunks_exact(2)
                .map(|p| {
                    Ok([
                        text.number(p[0].at, p[0].text)?,
                        text.number(p[1].at, p[1].text)?,
                    ])
                })
                .collect()
        })
        .collect()
}

/// First token and number of points of each block.
fn sizes(text: Text, tokens: &[Token], has_count: bool) -> Result<Vec<(usize, usize)>, ReadError> {
    let size = |i: usize| {
        let Token { text: token, at } = tokens[i];
        token
            .parse::<usize>()
            .map_err(|_| text.error(at, format!("{} is not a number of points", short(token))))
    };
    let mut at = usize::from(has_count);
    let mut blocks = Vec::new();
    while at < tokens.len() {
        let points = size(at)?;
        if points > (tokens.len() - at - 1) / 2 {
            let found = (tokens.len() - at - 1) / 2;
            return Err(text.error(
                tokens[at].at,
                format!("{points} points are announced, but only {found} follow"),
            ));
        }
        blocks.push((at + 1, points));
        at += 1 + 2 * points;
    }
    if has_count && size(0)? != blocks.len() {
        let message = format!(
            "{} blocks are announced, but {} follow",
            tokens[0].text,
            blocks.len()
        );
        return Err(text.error(tokens[0].at, message));
    }
    Ok(blocks)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn lines(text: &str) -> Result<Vec<Vec<[f64; 2]>>, String> {
        let mut document = read_line(text.as_bytes()).map_err(|e| e.to_string())?;
        match document.features.remove(0).case {
            Shape::Lines(lines) => Ok(lines.into_iter().map(|l| l.points).collect()),
            Shape::Empty => Ok(Vec::new()),
            other => panic!("{other:?}"),
        }
    }

    #[test]
    fn with_and_without_a_count() {
        let two = Ok(vec![vec![[0.0, 0.5], [1.0, -1e3]], vec![[2.0, 2.0]]]);
        assert_eq!(lines("2\n0 .5\n1 -1e3\n\n# note\n1 # one\n2 2\n"), two);
        assert_eq!(lines("2\n2\n0 .5\n1 -1e3\n1\n2 2"), two);
        assert_eq!(lines("2 0 .5 1 -1e3 1 2 2"), two);
        assert_eq!(lines("2 2 0 .5 1 -1e3 1 2 2"), two);
        assert_eq!(lines("0"), Ok(vec![]));
    }

    #[test]
    fn poly_is_one_polygon() {
        let document =
            read_poly(b"2\r\n3\r\n0 0\r\n9 0\r\n0 9\r\n3\r\n1 1\r\n1 2\r\n2 1\r\n").unwrap();
        let Shape::Polygons(polygons) = &document.features[0].case else {
            panic!("not a polygon")
        };
        assert_eq!(polygons.len(), 1);
        assert_eq!(
            polygons[0].rings,
            [
                [[0.0, 0.0], [9.0, 0.0], [0.0, 9.0]],
                [[1.0, 1.0], [1.0, 2.0], [2.0, 1.0]]
            ]
        );
        assert_eq!(read_poly(b"0\n").unwrap().features[0].case, Shape::Empty);
    }

    #[test]
    fn errors_name_the_place() {
        let err = |text| lines(text).unwrap_err();
        assert_eq!(err(" \n"), ".line: there is no number of points");
        assert_eq!(
            err("2\n0 0\n1"),
            ".line, line 1, column 1: 2 points are announced, but only 1 follow"
        );
        assert_eq!(
            err("99999999999\n0 0"),
            ".line, line 1, column 1: 99999999999 points are announced, but only 1 follow"
        );
        assert_eq!(
            err("1\n0 0\nx"),
            ".line, line 3, column 1: `x` is not a number of points"
        );
        assert_eq!(
            err("1\n0 NaN"),
            ".line, line 2, column 3: `NaN` is not a finite number"
        );
        assert_eq!(
            err("3\n1\n0 0\n"),
            ".line, line 1, column 1: 3 blocks are announced, but 1 follow"
        );
        assert_eq!(
            err("-1"),
            ".line, line 1, column 1: `-1` is not a number of points"
        );
    }
}
