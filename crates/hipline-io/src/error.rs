//! What can go wrong on the way from bytes to a figure.

use std::fmt;

use hipline::{InvalidFigure, input::Flaw};

use crate::Format;

/// Names a feature of a document: its place in the file, and its id if it has one.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub struct FeatureName {
    /// Its number in the file, from 0.
    pub index: usize,
    /// Its id, if the file gives one.
    pub id: Option<String>,
}

impl fmt::Display for FeatureName {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match &self.id {
            Some(id) => write!(f, "feature {} (\"{id}\")", self.index),
            None => write!(f, "feature {}", self.index),
        }
    }
}

/// Why bytes are not a document.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum ReadError {
    /// The file breaks the rules of its format at one place.
    #[error("{format}, line {line}, column {column}: {message}")]
    Syntax {
        /// What it was read as.
        format: &'static str,
        /// The line, from 1.
        line: usize,
        /// The column, from 1.
        column: usize,
        /// What is wrong there.
        message: String,
    },
    /// A feature does not make sense.
    #[error("{format}, {feature}: {message}")]
    Feature {
        /// What it was read as.
        format: &'static str,
        /// Which one.
        feature: FeatureName,
        /// What is wrong with it.
        message: String,
    },
    /// The file is well formed, but it is not what it should be.
    #[error("{format}: {message}")]
    Content {
        /// What it was read as.
        format: &'static str,
        /// What is wrong with it.
        message: String,
    },
    /// Neither name nor content tells the format.
    #[error(
        "{what} is in no known format; known are .geojson, .wkt, .graphml, .line, .poly and .obj"
    )]
    UnknownFormat {
        /// The name, or "the content".
        what: String,
    },
}

impl Format {
    pub(crate) const fn name(self) -> &'static str {
        match self {
            Self::GeoJson => "GeoJSON",
            Self::Wkt => "WKT",
            Self::GraphMl => "GraphML",
            Self::Line => ".line",
            Self::Poly => ".poly",
            Self::Obj => "OBJ",
        }
    }
}

/// Why features are not a figure.
#[derive(Debug, Clone, PartialEq)]
pub struct FigureError {
    /// The features that the figure was to be made of.
    pub features: Vec<FeatureName>,
    /// For each part of the figure, in the order of the calls to the builder, which of
    /// `features` it comes from.
    pub parts: Vec<usize>,
    /// What is wrong.
    pub reason: Reason,
}

/// What is wrong with the features of a [`FigureError`].
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum Reason {
    /// The geometry is empty or null: there is nothing to compute. Callers may treat this
    /// as an empty result.
    Empty,
    /// There is a point that belongs to no line and no polygon.
    Points {
        /// Which of the features has it.
        feature: usize,
    },
    /// It is not a planar straight-line graph.
    Invalid(InvalidFigure),
}

impl FigureError {
    /// Whether the only thing wrong is that there is nothing.
    #[must_use]
    pub fn is_empty_geometry(&self) -> bool {
        self.reason == Reason::Empty
    }
}

impl fmt::Display for FigureError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.features.as_slice() {
            [one] => write!(f, "{one}: ")?,
            many => write!(f, "{} features together: ", many.len())?,
        }
        match &self.reason {
            Reason::Empty => f.write_str("the geometry is empty"),
            Reason::Points { feature } => {
                if self.features.len() > 1 {
                    write!(f, "{}: ", self.features[*feature])?;
                }
                f.write_str("a point has no edge, so no wavefront starts from it")
            }
            Reason::Invalid(InvalidFigure { flaws, .. }) => {
                let messages: Vec<_> = flaws.iter().map(ToString::to_string).collect();
                f.write_str(&messages.join("; "))?;
                if self.features.len() > 1 {
                    self.legend(f, flaws)?;
                }
                Ok(())
            }
        }
    }
}

impl FigureError {
    /// Which feature each part is that the flaws concern.
    fn legend(&self, f: &mut fmt::Formatter<'_>, flaws: &[Flaw]) -> fmt::Result {
        let mut parts: Vec<usize> = flaws.iter().flat_map(Flaw::parts).collect();
        parts.sort_unstable();
        parts.dedup();
        let mut lead = " (";
        for part in parts {
            if let Some(&feature) = self.parts.get(part) {
                write!(f, "{lead}part {part} is of {}", self.features[feature])?;
                lead = ", ";
            }
        }
        f.write_str(if lead == ", " { ")" } else { "" })
    }
}

impl std::error::Error for FigureError {
    fn source(&self) -> Option<&(dyn std::error::Error + 'static)> {
        match &self.reason {
            Reason::Invalid(flaws) => Some(flaws),
            _ => None,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use hipline::input::Place;

    #[test]
    fn flaws_of_several_features_come_with_a_legend() {
        let name = |index, id: Option<&str>| FeatureName {
            index,
            id: id.map(str::to_owned),
        };
        let at = |part| Place {
            part,
            ring: 0,
            index: 3,
        };
        let cross = Flaw::EdgesCross {
            first: at(2),
            second: at(0),
            near: [0.0; 2],
        };
        let few = Flaw::TooFewVertices {
            at: at(1),
            found: 1,
            needed: 3,
        };
        let beyond = Flaw::BadSpeed {
            edge: at(7),
            speed: -1.0,
        };
        for (flaws, legend) in [
            (
                vec![cross],
                " (part 0 is of feature 0, part 2 is of feature 1 (\"b\"))",
            ),
            (vec![few.clone(), few], " (part 1 is of feature 1 (\"b\"))"),
            (vec![Flaw::Empty, beyond], ""),
        ] {
            let messages: Vec<_> = flaws.iter().map(ToString::to_string).collect();
            let error = FigureError {
                features: vec![name(0, None), name(1, Some("b"))],
                parts: vec![0, 1, 1],
                reason: Reason::Invalid(InvalidFigure { flaws }),
            };
            let expected = format!("2 features together: {}{legend}", messages.join("; "));
            assert_eq!(error.to_string(), expected);
        }
    }
}
