//! What can go wrong on the way from bytes to a figure.

use std::fmt;

use hipline::InvalidFigure;

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
            Reason::Invalid(InvalidFigure { flaws }) => {
                for (i, flaw) in flaws.iter().enumerate() {
                    write!(f, "{}{flaw}", if i == 0 { "" } else { "; " })?;
                }
                self.legend(f)
            }
        }
    }
}

impl FigureError {
    /// Which part of the figure is which feature, where that is not obvious.
    fn legend(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        const LONGEST: usize = 16;
        if self.features.len() < 2 {
            return Ok(());
        }
        f.write_str(" (")?;
        for (part, &feature) in self.parts.iter().take(LONGEST).enumerate() {
            let comma = if part == 0 { "" } else { ", " };
            write!(f, "{comma}part {part} is {}", self.features[feature])?;
        }
        f.write_str(if self.parts.len() > LONGEST {
            ", ...)"
        } else {
            ")"
        })
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
