//! The first five lines of use: one polygon.

use super::{Figure, InvalidFigure};
use crate::skeleton::Skeleton;

/// One polygon with holes: a [`Figure`] with the usual defaults.
#[derive(Debug, Clone)]
pub struct Polygon(Figure);

impl Polygon {
    /// Checks the rings: shell first, then holes; each a list of `[x, y]`.
    ///
    /// # Errors
    /// Every flaw of the rings.
    pub fn new<R, P>(rings: R) -> Result<Self, InvalidFigure>
    where
        R: IntoIterator<Item = P>,
        P: Into<Vec<[f64; 2]>>,
    {
        let mut builder = super::FigureBuilder::new();
        builder.polygon(rings.into_iter().map(Into::into).collect());
        builder.build().map(Self)
    }

    /// The straight skeleton of the inside.
    #[must_use]
    pub fn skeleton(&self) -> Skeleton {
        self.0.skeleton(crate::skeleton::Options::default())
    }

    /// The figure.
    #[must_use]
    pub const fn figure(&self) -> &Figure {
        &self.0
    }
}
