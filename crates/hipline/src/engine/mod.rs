//! Which engine computes a skeleton.
//!
//! All engines give the same result, arc for arc and bit for bit; they differ in what they apply to and
//! in what they cost. Each one knows nothing of the others.

use crate::{
    envelope,
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
    /// polygons with positive speeds, if what one chain cuts off never comes back in the other.
    Monotone,
    /// Skeletons of two chains, merged (Eder, Held & Palfrader 2019), in linear time. Applies to the inside of one polygon without
    /// holes that is monotone and whose edges are parallel to the axes and of speed 1.
    Orthogonal,
    /// The lower envelope of the slabs of edges and motorcycles (Mencil 2014). Applies to the inside of polygons
    /// with unit speeds and without heights.
    Envelope,
}

/// Why an engine does not apply to a figure.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum NotApplicable {
    /// There are lines, several polygons, or holes.
    #[error("the figure is not one polygon without holes")]
    NotOneRing,
    /// There are no polygons, or lines beside them.
    #[error("the figure is not made of polygons alone")]
    NotPolygons,
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
    /// In one of a polygon's two chains alone, what the other one has cut off comes back, so that they cannot be merged.
    #[error("what the other chain has cut off comes back in the chain of edge {}", .edge.index())]
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
    /// Edges across the direction of monotonicity meet in a way that the engine does not resolve.
    #[error(
        "edges across the direction of monotonicity meet in a way that this engine cannot resolve"
    )]
    Levels,
    /// What the engine found does not obey the laws of skeletons ([`Skeleton::verify`]): a fault of the engine.
    #[error("what this engine found does not obey the laws of skeletons")]
    Unproved,
    /// The modified skeleton is asked for.
    #[error("modified skeletons are computed by the kinetic engine only")]
    Modified,
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
    /// O(n log n) time for [`Engine::Monotone`], O(n) for [`Engine::Orthogonal`].
    #[must_use]
    pub fn skeleton(&self, options: Options) -> Skeleton {
        let region = self.region(options);
        if options.modified && self.not_plain().is_none() {
            return kinetic::skeleton(self, region, true);
        }
        match orthogonal::applies(self, region) {
            Ok(monotone) => orthogonal::skeleton(self, monotone),
            Err(_) if self.is_plain() && monotone::is_strict(self) => {
                monotone::skeleton(self, region)
                    .unwrap_or_else(|_| kinetic::skeleton(self, region, false))
            }
            Err(_) => kinetic::skeleton(self, region, false),
        }
    }

    /// The straight skeleton by the engine of one's choice. It is the same, bit for bit up to the order of nodes and
    /// arcs, whichever computes it.
    ///
    /// # Errors
    /// If the engine or an option does not apply to this figure: why.
    pub fn skeleton_by(&self, engine: Engine, options: Options) -> Result<Skeleton, NotApplicable> {
        let region = self.region(options);
        if options.modified {
            if let Some(reason) = self.not_plain() {
                return Err(reason);
            }
            return match engine {
                Engine::Auto | Engine::Kinetic => Ok(kinetic::skeleton(self, region, true)),
                _ => Err(NotApplicable::Modified),
            };
        }
        match engine {
            Engine::Auto => Ok(self.skeleton(options)),
            Engine::Kinetic => Ok(kinetic::skeleton(self, region, false)),
            Engine::Monotone => self.monotone_skeleton(region),
            Engine::Orthogonal => {
                let monotone = orthogonal::applies(self, region)?;
                Ok(orthogonal::skeleton(self, monotone))
            }
            Engine::Envelope => {
                let skeleton = envelope::skeleton(self, region)?;
                if skeleton.verify(self).is_ok() {
                    Ok(skeleton)
                } else {
                    Err(NotApplicable::Unproved)
                }
            }
        }
    }

    /// The skeleton by the engine for monotone polygons. Where edges lie along the levels, which is where it has been
    /// seen to fail, it has to prove its result; with weights, which the paper's proof leaves out, it has to obey the laws.
    fn monotone_skeleton(&self, region: Region) -> Result<Skeleton, NotApplicable> {
        let skeleton = monotone::skeleton(self, region)?;
        let is_strict = monotone::is_strict(self);
        let is_right = if self.is_plain() {
            is_strict || skeleton.certify(self).is_ok()
        } else {
            skeleton.verify(self).is_ok()
        };
        match (is_right, is_strict) {
            (true, _) => Ok(skeleton),
            (false, true) => Err(NotApplicable::Unproved),
            (false, false) => Err(NotApplicable::Levels),
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
