//! One test case as plain data, and its text: the format of the corpus.
//!
//! ```text
//! # where it comes from, and what is special
//! region both
//! polygon
//! ring 0 0, 8 0, 8 6, 0 6
//! speeds 1, 2, 1, 2
//! ring 2 2, 2 4, 4 4
//! line 9 0, 9 5, 12 5
//! speeds 1 1, 0.5 2
//! graph
//! vertices 20 0, 22 0, 21 3
//! edges 0 1, 1 2
//! speeds 1 1, 1 3
//! changes 0 both 2.5 0, 1 left 1 4
//! heights 0 0.5, 2 1
//! ```
//!
//! A line of speeds belongs to the ring, line or graph before it: one number per edge of a ring,
//! left and right per edge of the others. So does a line of changes of speed: edge, sides
//! (`left`, `right` or `both`), time and speed from then on; and one of heights: vertex and height. Numbers are exact: the shortest text that
//! reads back as the same f64.

use std::fmt::Write as _;

use hipline::input::{Change, InvalidFigure, Place, Sides};
use hipline::{Figure, FigureBuilder, Region};

/// A ring or line: its points.
pub type Points = Vec<[f64; 2]>;

/// One polygon, line or graph. Without weights, the speeds are empty.
#[derive(Debug, Clone, PartialEq)]
pub enum Part {
    /// A polygon.
    Polygon {
        /// Its shell, then its holes.
        rings: Vec<Points>,
        /// One speed per edge of each ring, or nothing at all.
        speeds: Vec<Vec<f64>>,
    },
    /// A polyline.
    Line {
        /// Its points.
        points: Points,
        /// The speeds on the left and right of each edge, or nothing at all.
        speeds: Vec<[f64; 2]>,
    },
    /// A graph.
    Graph {
        /// Its vertices.
        vertices: Points,
        /// Its edges, as pairs of vertex numbers.
        edges: Vec<[usize; 2]>,
        /// The speeds on the left and right of each edge, or nothing at all.
        speeds: Vec<[f64; 2]>,
    },
}

/// A test case.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Case {
    /// What to say about it, line by line.
    pub comments: Vec<String>,
    /// Which part of the plane.
    pub region: Region,
    /// The input.
    pub parts: Vec<Part>,
    /// How speeds change; places are numbered by `parts`.
    pub changes: Vec<Change>,
    /// Heights of vertices, by part, ring and number of the vertex.
    pub heights: Vec<(Place, f64)>,
}

/// Why a text is not a case.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ParseError {
    /// The number of the line, from 1.
    pub line: usize,
    /// What is wrong with it.
    pub reason: &'static str,
}

impl std::fmt::Display for ParseError {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "line {}: {}", self.line, self.reason)
    }
}

impl std::error::Error for ParseError {}

impl Part {
    /// A polygon without weights.
    #[must_use]
    pub const fn polygon(rings: Vec<Points>) -> Self {
        Self::Polygon {
            rings,
            speeds: Vec::new(),
        }
    }

    /// A line without weights.
    #[must_use]
    pub const fn line(points: Points) -> Self {
        Self::Line {
            points,
            speeds: Vec::new(),
        }
    }

    /// All points, with ring and number.
    #[must_use]
    pub fn numbered_points(&self) -> Vec<([usize; 2], [f64; 2])> {
        let (rings, points): (&[Points], &[[f64; 2]]) = match self {
            Self::Polygon { rings, .. } => (rings, &[]),
            Self::Line { points, .. } => (&[], points),
            Self::Graph { vertices, .. } => (&[], vertices),
        };
        let one = std::iter::once((0, points));
        let all = rings.iter().map(Vec::as_slice).enumerate().chain(one);
        all.flat_map(|(ring, points)| {
            let numbered = points.iter().enumerate();
            numbered.map(move |(index, &point)| ([ring, index], point))
        })
        .collect()
    }

    /// All points.
    pub fn points_mut(&mut self) -> impl Iterator<Item = &mut [f64; 2]> {
        let (rings, points): (&mut [Points], &mut [[f64; 2]]) = match self {
            Self::Polygon { rings, .. } => (rings, &mut []),
            Self::Line { points, .. } => (&mut [], points),
            Self::Graph { vertices, .. } => (&mut [], vertices),
        };
        rings.iter_mut().flatten().chain(points)
    }
}

impl Case {
    /// A case without weights, of polygons.
    #[must_use]
    pub fn of(parts: Vec<Part>) -> Self {
        Self {
            parts,
            ..Self::default()
        }
    }

    /// The number of points given.
    #[must_use]
    pub fn size(&self) -> usize {
        let sizes = self.parts.iter().map(|part| match part {
            Part::Polygon { rings, .. } => rings.iter().map(Vec::len).sum(),
            Part::Line { points, .. } => points.len(),
            Part::Graph { vertices, .. } => vertices.len(),
        });
        sizes.sum()
    }

    /// Whether any speed is given.
    #[must_use]
    pub fn is_weighted(&self) -> bool {
        let given = self.parts.iter().any(|part| match part {
            Part::Polygon { speeds, .. } => !speeds.is_empty(),
            Part::Line { speeds, .. } | Part::Graph { speeds, .. } => !speeds.is_empty(),
        });
        given || !self.changes.is_empty() || !self.heights.is_empty()
    }

    /// The number of edges of a ring of a part, or of a line or graph (as its ring 0).
    #[must_use]
    pub fn edges(&self, part: usize, ring: usize) -> usize {
        match &self.parts[part] {
            Part::Polygon { rings, .. } => rings[ring].len(),
            Part::Line { points, .. } => points.len() - 1,
            Part::Graph { edges, .. } => edges.len(),
        }
    }

    /// All edges, by part and ring.
    #[must_use]
    pub fn places(&self) -> Vec<Place> {
        let mut places = Vec::new();
        for (part, content) in self.parts.iter().enumerate() {
            let rings = if let Part::Polygon { rings, .. } = content {
                rings.len()
            } else {
                1
            };
            for ring in 0..rings {
                let count = self.edges(part, ring);
                places.extend((0..count).map(|index| Place { part, ring, index }));
            }
        }
        places
    }

    /// Renames the places of changes, not of heights; changes of edges that are no more are dropped.
    pub fn renumber(&mut self, place: impl Fn(Place) -> Option<Place>) {
        self.changes.retain_mut(|change| {
            let renamed = place(change.edge);
            change.edge = renamed.unwrap_or(change.edge);
            renamed.is_some()
        });
    }

    /// All that is in it, for the library to check.
    #[must_use]
    pub fn to_builder(&self) -> FigureBuilder {
        let mut builder = FigureBuilder::new();
        for part in &self.parts {
            match part.clone() {
                Part::Polygon { rings, speeds } if speeds.is_empty() => builder.polygon(rings),
                Part::Polygon { rings, speeds } => builder.weighted_polygon(rings, speeds),
                Part::Line { points, speeds } if speeds.is_empty() => builder.polyline(points),
                Part::Line { points, speeds } => builder.weighted_polyline(points, speeds),
                Part::Graph {
                    vertices,
                    edges,
                    speeds,
                } if speeds.is_empty() => builder.graph(vertices, edges),
                Part::Graph {
                    vertices,
                    edges,
                    speeds,
                } => builder.weighted_graph(vertices, edges, speeds),
            };
        }
        self.changes
            .iter()
            .for_each(|&change| builder.change(change));
        self.heights
            .iter()
            .for_each(|&(vertex, height)| builder.elevate(vertex, height));
        builder
    }

    /// The checked figure.
    ///
    /// # Errors
    /// Every flaw of the input.
    pub fn figure(&self) -> Result<Figure, InvalidFigure> {
        self.to_builder().build()
    }

    /// The text.
    #[must_use]
    pub fn to_text(&self) -> String {
        let mut text = String::new();
        let mut line = |word: &str, items: Vec<String>| {
            let space = if items.is_empty() { "" } else { " " };
            writeln!(text, "{word}{space}{}", items.join(", ")).expect("memory");
        };
        self.comments
            .iter()
            .for_each(|comment| line("#", vec![comment.clone()]));
        match self.region {
            Region::Auto => {}
            Region::Interior => line("region interior", Vec::new()),
            Region::Exterior => line("region exterior", Vec::new()),
            Region::Both => line("region both", Vec::new()),
        }
        for (p, part) in self.parts.iter().enumerate() {
            let changes = |ring: usize| {
                let of = self.changes.iter().filter(|change| {
                    let Place { part, ring: r, .. } = change.edge;
                    (part, r) == (p, ring)
                });
                of.map(change_text).collect::<Vec<_>>()
            };
            let heights = |ring: usize| {
                let of = self
                    .heights
                    .iter()
                    .filter(|(at, _)| (at.part, at.ring) == (p, ring));
                of.map(|(at, height)| format!("{} {height}", at.index))
                    .collect::<Vec<_>>()
            };
            match part {
                Part::Polygon { rings, speeds } => {
                    line("polygon", Vec::new());
                    for (r, ring) in rings.iter().enumerate() {
                        line("ring", pairs(ring));
                        if let Some(speeds) = speeds.get(r) {
                            line("speeds", speeds.iter().map(ToString::to_string).collect());
                        }
                        if !changes(r).is_empty() {
                            line("changes", changes(r));
                        }
                        if !heights(r).is_empty() {
                            line("heights", heights(r));
                        }
                    }
                }
                Part::Line { points, .. } => line("line", pairs(points)),
                Part::Graph {
                    vertices, edges, ..
                } => {
                    line("graph", Vec::new());
                    line("vertices", pairs(vertices));
                    line("edges", pairs(edges));
                }
            }
            if let Part::Line { speeds, .. } | Part::Graph { speeds, .. } = part {
                if !speeds.is_empty() {
                    line("speeds", pairs(speeds));
                }
                if !changes(0).is_empty() {
                    line("changes", changes(0));
                }
                if !heights(0).is_empty() {
                    line("heights", heights(0));
                }
            }
        }
        text
    }

    /// Reads a text.
    ///
    /// # Errors
    /// The first line that cannot be understood.
    pub fn parse(text: &str) -> Result<Self, ParseError> {
        let mut case = Self::default();
        for (index, content) in text.lines().enumerate() {
            case.read_line(content.trim())
                .map_err(|reason| ParseError {
                    line: index + 1,
                    reason,
                })?;
        }
        Ok(case)
    }

    fn read_line(&mut self, content: &str) -> Result<(), &'static str> {
        let (word, rest) = content
            .split_once(char::is_whitespace)
            .unwrap_or((content, ""));
        match (word, self.parts.last_mut()) {
            ("", _) => {}
            (word, _) if word.starts_with('#') => {
                self.comments
                    .push(content.trim_start_matches('#').trim().to_owned());
            }
            ("region", _) => {
                self.region = match rest.trim() {
                    "auto" => Region::Auto,
                    "interior" => Region::Interior,
                    "exterior" => Region::Exterior,
                    "both" => Region::Both,
                    _ => return Err("unknown region"),
                };
            }
            ("polygon", _) => self.parts.push(Part::polygon(Vec::new())),
            ("line", _) => self.parts.push(Part::line(read_pairs(rest)?)),
            ("graph", _) => {
                self.parts.push(Part::Graph {
                    vertices: Vec::new(),
                    edges: Vec::new(),
                    speeds: Vec::new(),
                });
            }
            ("ring", Some(Part::Polygon { rings, .. })) => rings.push(read_pairs(rest)?),
            ("speeds", Some(Part::Polygon { rings, speeds })) => {
                while speeds.len() + 1 < rings.len() {
                    speeds.push(vec![1.0; rings[speeds.len()].len()]);
                }
                let read = rest.split(',').map(|speed| speed.trim().parse());
                speeds.push(read.collect::<Result<_, _>>().map_err(|_| "not a number")?);
            }
            ("speeds", Some(Part::Line { speeds, .. } | Part::Graph { speeds, .. })) => {
                *speeds = read_pairs(rest)?
            }
            ("changes", Some(part)) => {
                let ring = last_ring(part).ok_or("changes of no ring")?;
                let part = self.parts.len() - 1;
                let read = rest.split(',').map(|item| read_change(item, part, ring));
                self.changes.extend(read.collect::<Result<Vec<_>, _>>()?);
            }
            ("heights", Some(part)) => {
                let ring = last_ring(part).ok_or("heights of no ring")?;
                let part = self.parts.len() - 1;
                let read = rest.split(',').map(|item| read_height(item, part, ring));
                self.heights.extend(read.collect::<Result<Vec<_>, _>>()?);
            }
            ("vertices", Some(Part::Graph { vertices, .. })) => *vertices = read_pairs(rest)?,
            ("edges", Some(Part::Graph { edges, .. })) => *edges = read_pairs(rest)?,
            _ => return Err("unknown word, or in the wrong place"),
        }
        Ok(())
    }
}

/// The number of the ring that was read last.
const fn last_ring(part: &Part) -> Option<usize> {
    match part {
        Part::Polygon { rings, .. } => rings.len().checked_sub(1),
        _ => Some(0),
    }
}

fn read_height(text: &str, part: usize, ring: usize) -> Result<(Place, f64), &'static str> {
    let mut words = text.split_whitespace();
    let [index, height] = [(); 2].map(|()| words.next().ok_or("a height is vertex and height"));
    let (Ok(index), Ok(height)) = (index?.parse(), height?.parse()) else {
        return Err("not a number");
    };
    Ok((Place { part, ring, index }, height))
}

fn pairs<T: std::fmt::Display>(list: &[[T; 2]]) -> Vec<String> {
    list.iter().map(|[a, b]| format!("{a} {b}")).collect()
}

fn change_text(change: &Change) -> String {
    let sides = match change.sides {
        Sides::Left => "left",
        Sides::Right => "right",
        Sides::Both => "both",
    };
    let Change {
        edge, time, speed, ..
    } = change;
    format!("{} {sides} {time} {speed}", edge.index)
}

fn read_change(text: &str, part: usize, ring: usize) -> Result<Change, &'static str> {
    let words: Vec<&str> = text.split_whitespace().collect();
    let &[index, sides, time, speed] = words.as_slice() else {
        return Err("a change is edge, sides, time and speed");
    };
    let sides = match sides {
        "left" => Sides::Left,
        "right" => Sides::Right,
        "both" => Sides::Both,
        _ => return Err("sides are left, right or both"),
    };
    let (Ok(index), Ok(time), Ok(speed)) = (index.parse(), time.parse(), speed.parse()) else {
        return Err("not a number");
    };
    Ok(Change {
        edge: Place { part, ring, index },
        sides,
        time,
        speed,
    })
}

fn read_pairs<T: std::str::FromStr>(text: &str) -> Result<Vec<[T; 2]>, &'static str> {
    let pair = |item: &str| {
        let mut words = item.split_whitespace().map(str::parse);
        match (words.next(), words.next(), words.next()) {
            (Some(Ok(a)), Some(Ok(b)), None) => Ok([a, b]),
            _ => Err("not a pair of numbers"),
        }
    };
    text.split(',').map(pair).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn text_reads_back() {
        let text = "# odd numbers\nregion both\npolygon\nring 0 0, 8.1 0, 8 1e-30\nspeeds 1, 2, 0.5\n\
                    changes 2 left 0.1 0, 0 both 3 2\nheights 0 0.5, 2 1\nline 9 0, 9 5, 12 -5\nspeeds 1 1, 0.5 2\n\
                    changes 1 right 1 7\nheights 1 2\ngraph\nvertices 20 0, 22 0, 21 3\nedges 0 1, 1 2\n";
        let case = Case::parse(text).expect("it is well-formed");
        assert_eq!(
            Case::parse(&case.to_text()),
            Ok(case.clone()),
            "text of {case:?}"
        );
        assert_eq!(
            (case.size(), case.is_weighted(), case.parts.len()),
            (9, true, 3),
            "{case:?}"
        );
        let [first, _, last] = case.changes[..] else {
            panic!("three changes: {case:?}");
        };
        assert_eq!(
            (
                first.edge.part,
                first.edge.index,
                first.sides,
                first.time.to_bits()
            ),
            (0, 2, Sides::Left, 0.1_f64.to_bits()),
            "{first:?}"
        );
        assert_eq!((last.edge.part, last.edge.index), (1, 1), "{last:?}");
        let [(_, low), _, (last, _)] = case.heights[..] else {
            panic!("three heights: {case:?}");
        };
        assert_eq!(
            (last.part, last.index, low.to_bits()),
            (1, 1, 0.5_f64.to_bits()),
            "{case:?}"
        );
        let error = ParseError {
            line: 2,
            reason: "not a pair of numbers",
        };
        assert_eq!(
            Case::parse("polygon\nring 0 0, 1\n"),
            Err(error),
            "half a point"
        );
    }
}
