//! Which engine computes a skeleton.
//!
//! All engines give the same result, arc for arc and bit for bit; they differ in what they apply to and
//! in what they cost. Each one hands a [`Wavefront`](crate::wavefront) to the assembly of the
//! result, and knows nothing of the others.

use crate::{
    input::Figure,
    kinetic,
    skeleton::{Options, Region, Skeleton},
    topology::EdgeId,
};

/// An algorithm.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
#[non_exhaustive]
pub enum Engine {
    /// The fastest one that applies.
    #[default]
    Auto,
    /// The kinetic triangulation (Aichholzer & Aurenhammer 1996). Applies to everything.
    Kinetic,
}

/// Why an engine does not apply to a figure.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum NotApplicable {
    /// There are lines, several polygons, or holes.
    #[error("the figure is not one polygon without holes")]
    NotOneRing,
    /// More than the inside is asked for.
    #[error("only the inside of a polygon can be computed this way")]
    NotInterior,
    /// A speed that is zero, or changes, or is not one.
    #[error("the speed of edge {} does not allow for it", .edge.index())]
    Speed {
        /// The edge, as the figure numbers them.
        edge: EdgeId,
    },
    /// A vertex has a height.
    #[error("the figure has heights")]
    Heights,
}

impl Figure {
    /// The straight skeleton, by the fastest engine that applies.
    ///
    /// Exact: all decisions are signs of exact numbers; coordinates and times of the result
    /// are correctly rounded. Total: every figure has a skeleton. Where [`Options::modified`] does not
    /// apply, because of speeds or heights, it is without effect.
    ///
    /// # Complexity
    /// O(n) memory; about n log n time on ordinary input, O(n^3 log n) at worst (Lemma 5 of Aichholzer & Aurenhammer 1996).
    #[must_use]
    pub fn skeleton(&self, options: Options) -> Skeleton {
        let modified = options.modified && self.not_plain().is_none();
        kinetic::skeleton(self, self.region(options), modified)
    }

    /// The straight skeleton by the engine of one's choice. It is the same, bit for bit up to the order of nodes and
    /// arcs, whichever computes it.
    ///
    /// # Errors
    /// If the engine or an option does not apply to this figure: why.
    pub fn skeleton_by(&self, engine: Engine, options: Options) -> Result<Skeleton, NotApplicable> {
        if options.modified
            && let Some(reason) = self.not_plain()
        {
            return Err(reason);
        }
        match engine {
            Engine::Auto | Engine::Kinetic => Ok(kinetic::skeleton(
                self,
                self.region(options),
                options.modified,
            )),
        }
    }

    /// What keeps the modified skeleton from being defined: a speed or a height.
    fn not_plain(&self) -> Option<NotApplicable> {
        if self.is_plain() {
            return None;
        }
        #[expect(clippy::float_cmp, reason = "asks for the number one itself")]
        let fast = self.edges().iter().position(|e| e.speeds != [1.0, 1.0]);
        let edge = fast.map(EdgeId::new);
        let edge = edge.or_else(|| self.changes().first().map(|change| change.edge));
        Some(edge.map_or(NotApplicable::Heights, |edge| NotApplicable::Speed { edge }))
    }

    /// The part of the plane to cover, never [`Region::Auto`].
    const fn region(&self, options: Options) -> Region {
        match options.region {
            Region::Auto if self.has_polygon() => Region::Interior,
            Region::Auto => Region::Both,
            region => region,
        }
    }
}
