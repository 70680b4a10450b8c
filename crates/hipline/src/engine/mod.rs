//! Which engine computes a skeleton.
//!
//! All engines give the same result, arc for arc and bit for bit; they differ in what they apply to and
//! in what they cost. Each one knows nothing of the others.

use crate::{
    input::Figure,
    kinetic, monotone, orthogonal,
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
    /// Two chains and their merge (Biedl and others, 2015). Applies to the inside of monotone
    /// polygons, with one positive speed for all edges.
    Monotone,
    /// Skeletons of two chains, merged (Eder, Held & Palfrader 2019), in linear time. Applies to the inside of one polygon without
    /// holes that is monotone and whose edges are parallel to the axes and of speed 1.
    Orthogonal,
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
    /// The ring is monotone in no direction, or touches itself.
    #[error("the polygon is not monotone in any direction")]
    NotMonotone,
    /// Speeds let one of a polygon's two chains run over what the other one has cut off.
    #[error("with these speeds, the chain of edge {} gets ahead of what the other chain cut off", .edge.index())]
    RunsAhead {
        /// An edge there, as the figure numbers them.
        edge: EdgeId,
    },
    /// An edge is not parallel to an axis.
    #[error("edge {} is not parallel to an axis", .edge.index())]
    NotOrthogonal {
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
    /// are correctly rounded. Total: every figure has a skeleton.
    ///
    /// # Complexity
    /// O(n) memory; about n log n time on ordinary input, O(n^3 log n) at worst (Lemma 5 of Aichholzer & Aurenhammer 1996).
    /// O(n log n) time for [`Engine::Monotone`], O(n) for [`Engine::Orthogonal`].
    #[must_use]
    pub fn skeleton(&self, options: Options) -> Skeleton {
        let region = self.region(options);
        match orthogonal::applies(self, region) {
            Ok(monotone) => orthogonal::skeleton(self, monotone),
            Err(_) if self.is_plain() && monotone::is_strict(self) => {
                monotone::skeleton(self, region).unwrap_or_else(|_| kinetic::skeleton(self, region))
            }
            Err(_) => kinetic::skeleton(self, region),
        }
    }

    /// The straight skeleton by the engine of one's choice. It is the same, bit for bit up to the order of nodes and
    /// arcs, whichever computes it.
    ///
    /// # Errors
    /// If the engine does not apply to this figure: why.
    pub fn skeleton_by(&self, engine: Engine, options: Options) -> Result<Skeleton, NotApplicable> {
        match engine {
            Engine::Auto => Ok(self.skeleton(options)),
            Engine::Kinetic => Ok(kinetic::skeleton(self, self.region(options))),
            Engine::Monotone => monotone::skeleton(self, self.region(options)),
            Engine::Orthogonal => {
                let monotone = orthogonal::applies(self, self.region(options))?;
                Ok(orthogonal::skeleton(self, monotone))
            }
        }
    }

    /// Whether all speeds are one. With others, the engine for monotone polygons finds only at the end whether it applies.
    #[expect(clippy::float_cmp, reason = "asks for the number one itself")]
    fn is_plain(&self) -> bool {
        self.edges().iter().all(|edge| edge.speeds == [1.0, 1.0])
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
