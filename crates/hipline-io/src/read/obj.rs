//! Wavefront OBJ: `v x y z` (z is a height), `l` (polylines), `f` (polygons).
//!
//! Vertices are numbered from 1, or from the last one with negative numbers; what follows
//! a slash is dropped. Everything up to the next `o` is one feature. Other statements are
//! ignored. A backslash at the end continues a line, `#` starts a comment.

use serde_json::Map;

use super::{
    position::{Position, line, polygon},
    text::{Text, number, short},
};
use crate::{
    Document, Feature, Format, ReadError,
    document::{LineShape, PolygonShape, Shape},
};

pub(super) fn read(bytes: &[u8]) -> Result<Document, ReadError> {
    let text = Text::new(Format::Obj.name(), bytes)?;
    let mut state = State::default();
    let mut statement: Vec<(usize, &str)> = Vec::new();
    let mut at = 0;
    for line in text.text.split_inclusive('\n') {
        let code = line.split('#').next().unwrap_or_default().trim_end();
        let (code, goes_on) = code
            .strip_suffix('\\')
            .map_or((code, false), |code| (code, true));
        for token in code.split_ascii_whitespace() {
            statement.push((
                at + (token.as_ptr() as usize - line.as_ptr() as usize),
                token,
            ));
        }
        at += line.len();
        if !goes_on {
            state.statement(text, &statement)?;
            statement.clear();
        }
    }
    state.statement(text, &statement)?;
    state.finish();
    if !state.known {
        return Err(text.content("there is no vertex, line or face"));
    }
    if state.features.is_empty() {
        state.push(Shape::Empty);
    }
    Ok(Document {
        features: state.features,
    })
}

#[derive(Default)]
struct State {
    vertices: Vec<Position>,
    name: Option<String>,
    lines: Vec<LineShape>,
    polygons: Vec<PolygonShape>,
    features: Vec<Feature>,
    /// Whether there was anything that belongs into an OBJ file.
    known: bool,
}

impl State {
    fn statement(&mut self, text: Text, tokens: &[(usize, &str)]) -> Result<(), ReadError> {
        let Some(((at, keyword), arguments)) = tokens.split_first() else {
            return Ok(());
        };
        match *keyword {
            "v" => {
                let [(x_at, x), (y_at, y), rest @ ..] = arguments else {
                    return Err(text.error(*at, "a vertex needs two numbers"));
                };
                // Few look at it, so what is no number there is no error until it is needed.
                let z = rest.first().and_then(|(_, z)| number(z).ok());
                let place = [text.number(*x_at, x)?, text.number(*y_at, y)?];
                self.vertices.push(Position { place, z });
                self.known = true;
            }
            "l" => {
                let points = self.chain(text, arguments)?;
                self.lines.push(line(&points));
            }
            "f" => {
                let ring = self.chain(text, arguments)?;
                self.polygons.push(polygon(&[ring]));
            }
            "o" => {
                self.finish();
                let name: Vec<_> = arguments.iter().map(|(_, token)| *token).collect();
                self.name = (!name.is_empty()).then(|| name.join(" "));
            }
            _ => {}
        }
        Ok(())
    }

    fn chain(
        &mut self,
        text: Text,
        arguments: &[(usize, &str)],
    ) -> Result<Vec<Position>, ReadError> {
        self.known = true;
        arguments
            .iter()
            .map(|&(at, token)| {
                self.vertex(token)
                    .map_err(|message| text.error(at, message))
            })
            .collect()
    }

    fn vertex(&self, token: &str) -> Result<Position, String> {
        let number = token.split('/').next().unwrap_or_default();
        let count = self.vertices.len();
        let number: i64 = number
            .parse()
            .map_err(|_| format!("{} is not a number of a vertex", short(token)))?;
        let magnitude = usize::try_from(number.unsigned_abs()).unwrap_or(usize::MAX);
        let index = if number > 0 {
            magnitude.checked_sub(1)
        } else {
            count.checked_sub(magnitude)
        };
        index
            .and_then(|i| self.vertices.get(i).copied())
            .ok_or_else(|| format!("there is no vertex {number}, only {count} so far"))
    }

    /// Ends the feature that is being read.
    fn finish(&mut self) {
        let lines = Shape::Lines(std::mem::take(&mut self.lines));
        let polygons = Shape::Polygons(std::mem::take(&mut self.polygons));
        match (lines.is_empty(), polygons.is_empty()) {
            (true, true) => {}
            (false, true) => self.push(lines),
            (true, false) => self.push(polygons),
            (false, false) => self.push(Shape::Collection(vec![polygons, lines])),
        }
        self.name = None;
    }

    fn push(&mut self, case: Shape) {
        let index = self.features.len();
        self.features.push(Feature {
            index,
            id: self.name.take(),
            properties: Map::new(),
            case,
        });
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Motion;

    fn err(text: &str) -> String {
        read(text.as_bytes())
            .map(|d| panic!("{text}: {d:?}"))
            .unwrap_err()
            .to_string()
    }

    #[test]
    fn lines_faces_and_objects() {
        let text = "# corners\nmtllib a.mtl\nv 0 0 7\nv 1 0 7 1\nv 1 \\\n 1\nl 1 2 -1\n\
                    o my house\nf 1/5/6 2//3 3\nl 3 1\no empty\n";
        let features = read(text.as_bytes()).unwrap().features;
        let points = vec![[0.0, 0.0], [1.0, 0.0], [1.0, 1.0]];
        let at = |z: &[Option<f64>]| Motion {
            z: z.to_vec(),
            ..Motion::default()
        };
        let corners = at(&[Some(7.0), Some(7.0), None]);
        let line = LineShape {
            motion: corners.clone(),
            ..LineShape::new(points.clone())
        };
        let diagonal = LineShape {
            motion: at(&[None, Some(7.0)]),
            ..LineShape::new(vec![[1.0, 1.0], [0.0, 0.0]])
        };
        let polygon = PolygonShape {
            motions: vec![corners],
            ..PolygonShape::new(vec![points])
        };
        assert_eq!(features.len(), 2);
        assert_eq!(
            (features[0].id.as_deref(), &features[0].case),
            (None, &Shape::Lines(vec![line]))
        );
        assert_eq!(features[1].id.as_deref(), Some("my house"));
        let both = Shape::Collection(vec![
            Shape::Polygons(vec![polygon]),
            Shape::Lines(vec![diagonal]),
        ]);
        assert_eq!(features[1].case, both);
        assert_eq!(read(b"v 1 2").unwrap().features[0].case, Shape::Empty);
    }

    #[test]
    fn errors_name_the_place() {
        assert_eq!(err("# nothing"), "OBJ: there is no vertex, line or face");
        assert_eq!(
            err("v 1"),
            "OBJ, line 1, column 1: a vertex needs two numbers"
        );
        assert_eq!(
            err("v 0 nan"),
            "OBJ, line 1, column 5: `nan` is not a finite number"
        );
        assert_eq!(
            err("v 0 0\nl 1 2"),
            "OBJ, line 2, column 5: there is no vertex 2, only 1 so far"
        );
        assert_eq!(
            err("v 0 0\nl 1 0"),
            "OBJ, line 2, column 5: there is no vertex 0, only 1 so far"
        );
        assert_eq!(
            err("v 0 0\nf 1 -2"),
            "OBJ, line 2, column 5: there is no vertex -2, only 1 so far"
        );
        assert_eq!(
            err("v 0 0\nf -9223372036854775808"),
            "OBJ, line 2, column 3: there is no vertex -9223372036854775808, only 1 so far"
        );
        assert_eq!(
            err("v 0 0\nf 1 /2"),
            "OBJ, line 2, column 5: `/2` is not a number of a vertex"
        );
    }
}
