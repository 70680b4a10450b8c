//! Offsets: the wavefront at given distances, read off a skeleton.
//!
//! The wavefront at time d is where the roof is d high (Aichholzer & Aurenhammer 1996,
//! section 4): each arc that passes height d gives a vertex, each face it separates an edge.
//! So once there is a skeleton, any number of offsets costs no more than writing them down.
//!
//! # At the moment of an event
//! The loops bound the part of the plane that is reached *after* time d: they show the
//! wavefront as it is immediately after the events of that moment. What collapses at d is
//! absent; what is split at d are two loops that touch in a point; distance 0 gives the
//! figure itself. (The limit from the other side has the same area, but spikes where only
//! a part of the wavefront has collapsed.) A loop may touch itself in a point, where a
//! ring-shaped part is pinched at this very moment.
//!
//! # Exactness
//! Which arcs pass height d is decided exactly, and so is the order along a face. Points are
//! the f64 numbers nearest to the exact ones. Edges whose ends are rounded into one point are
//! left out, and so are loops all of whose points are rounded onto one line.

mod bridges;
mod by_face;
mod level;
mod parts;
mod simple;
mod sublevel;

use crate::{
    input::Figure,
    skeleton::Skeleton,
    topology::{EdgeId, FaceId},
};
use hipline_num::hypot;

/// Why there is no offset.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum InvalidOffset {
    /// A distance is negative, infinite or no number.
    #[error("an offset's distance must be finite and not below 0, unlike {0}")]
    Distance(f64),
    /// The skeleton is that of one side of a [`Chain`](crate::Chain): its wavefronts go on to infinity, so that
    /// they are no loops.
    #[error("the wavefronts of a chain are open: they have no loops")]
    Chain,
}

/// A closed piece of the wavefront.
///
/// The part of the plane not yet swept is on the left: of the inside of a polygon, outer
/// loops are counterclockwise and those around holes clockwise; around the outside of a
/// figure they are clockwise.
#[derive(Debug, Clone, PartialEq)]
pub struct OffsetLoop {
    points: Vec<[f64; 2]>,
    faces: Vec<FaceId>,
}

impl OffsetLoop {
    /// The points, the first one not repeated.
    #[must_use]
    pub fn points(&self) -> &[[f64; 2]] {
        &self.points
    }

    /// For each point, the face that the edge from it to the next point lies in.
    ///
    /// Neighbours on one line remain two edges with a point on the ghost arc between them,
    /// so that every edge has exactly one face and, through it, one input edge.
    #[must_use]
    pub fn faces(&self) -> &[FaceId] {
        &self.faces
    }

    /// For each point, the input edge that the edge from it to the next point comes from.
    pub fn edges<'a>(&'a self, skeleton: &'a Skeleton) -> impl Iterator<Item = EdgeId> + 'a {
        self.faces.iter().map(|&face| skeleton.face(face).edge)
    }

    /// The signed area, in square input units, up to rounding: positive if counterclockwise.
    #[must_use]
    pub fn area(&self) -> f64 {
        let Some(&[x0, y0]) = self.points.first() else {
            return 0.0;
        };
        let next = self.points.iter().skip(1).chain(self.points.first());
        let twice: f64 = self
            .points
            .iter()
            .zip(next)
            .map(|(p, q)| (p[0] - x0) * (q[1] - y0) - (q[0] - x0) * (p[1] - y0))
            .sum();
        twice / 2.0
    }

    /// The length, in input units, up to rounding; of the same bits on every platform.
    #[must_use]
    pub fn perimeter(&self) -> f64 {
        let next = self.points.iter().skip(1).chain(self.points.first());
        self.points
            .iter()
            .zip(next)
            .map(|(p, q)| hypot(q[0] - p[0], q[1] - p[1]))
            .sum()
    }
}

/// A connected part of the plane that the wavefront has not yet swept; numbers of loops.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Part {
    /// The loop around it, counterclockwise; `None` if it is unbounded.
    pub shell: Option<usize>,
    /// The loops around its holes, clockwise.
    pub holes: Vec<usize>,
}

/// The wavefront at one distance.
#[derive(Debug, Clone, PartialEq)]
pub struct Offset {
    distance: f64,
    loops: Vec<OffsetLoop>,
    parts: Vec<Part>,
    swept: Vec<Part>,
}

impl Offset {
    /// The distance that was asked for: the time of the wavefront.
    #[must_use]
    pub const fn distance(&self) -> f64 {
        self.distance
    }

    /// The loops, in an order that is reproducible.
    #[must_use]
    pub fn loops(&self) -> &[OffsetLoop] {
        &self.loops
    }

    /// The parts of the plane not yet swept, with their holes: each loop belongs to one.
    #[must_use]
    pub fn parts(&self) -> &[Part] {
        &self.parts
    }

    /// The connected parts of the figure together with what has been swept, with their holes:
    /// shells are clockwise here, and holes counterclockwise, because what is not swept is on
    /// the left. Nothing for the inside of polygons, where nothing grows.
    #[must_use]
    pub fn swept_parts(&self) -> &[Part] {
        &self.swept
    }

    /// The same as polygons: the figure grown. Each is a list of rings with the faces
    /// that their edges lie in, the shell first and counterclockwise.
    pub fn swept_rings(&self) -> impl Iterator<Item = Vec<OffsetLoop>> {
        let parts = self.swept.iter();
        parts.flat_map(|part| simple::swept_polygons(part, &self.loops))
    }

    /// The bounded parts as polygons: lists of rings, the shell first, then the holes. They are
    /// valid in the sense of OGC Simple Features, but for what the rounding of coordinates does:
    /// a loop that touches itself in a point is cut into rings there.
    pub fn polygons(&self) -> impl Iterator<Item = Vec<Vec<[f64; 2]>>> {
        let points = |ring: OffsetLoop| ring.points;
        self.rings()
            .map(move |rings| rings.into_iter().map(points).collect())
    }

    /// The same, each ring with the faces that its edges lie in.
    pub fn rings(&self) -> impl Iterator<Item = Vec<OffsetLoop>> {
        let parts = self.parts.iter();
        parts.flat_map(|part| simple::polygons(part, &self.loops))
    }

    /// All loops as rings that do not touch themselves.
    pub fn simple_loops(&self) -> impl Iterator<Item = OffsetLoop> {
        self.loops.iter().flat_map(simple::cut)
    }
}

impl Skeleton {
    /// The wavefront at a distance: the time that an edge of unit speed takes to move so far.
    ///
    /// ```
    /// use hipline::{Options, Polygon};
    ///
    /// let square = vec![[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0]];
    /// let polygon = Polygon::new([square])?;
    /// let offset = polygon.skeleton().offset(polygon.figure(), 1.0)?;
    /// assert_eq!(offset.loops().len(), 1);
    /// assert_eq!(offset.loops()[0].area(), 4.0);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Complexity
    /// Linear in the size of the skeleton, but for the order of several edges in one face.
    /// [`Skeleton::offsets`] takes as long for one more distance as its points take.
    ///
    /// # Errors
    /// If the distance is negative, infinite or no number, or the skeleton that of a chain.
    ///
    /// # Panics
    /// If the figure is not the one that the skeleton was computed from.
    pub fn offset(&self, figure: &Figure, distance: f64) -> Result<Offset, InvalidOffset> {
        let mut list = self.offsets(figure, &[distance])?;
        Ok(list.swap_remove(0))
    }

    /// The wavefront at several distances, in any order; the results are in the same order.
    ///
    /// # Complexity
    /// O(n log k + m) for k distances, a skeleton of size n and m points in all, but for the order of
    /// several edges in one face: no distance looks at arcs or faces that it does not cross.
    ///
    /// # Errors
    /// If a distance is negative, infinite or no number, or the skeleton that of a chain.
    ///
    /// # Panics
    /// If the figure is not the one that the skeleton was computed from.
    pub fn offsets(
        &self,
        figure: &Figure,
        distances: &[f64],
    ) -> Result<Vec<Offset>, InvalidOffset> {
        if self.is_of_chain() {
            return Err(InvalidOffset::Chain);
        }
        if let Some(&wrong) = distances.iter().find(|d| !(d.is_finite() && **d >= 0.0)) {
            return Err(InvalidOffset::Distance(wrong));
        }
        // Adding 0 turns -0 into 0.
        let mut sorted: Vec<f64> = distances.iter().map(|d| d + 0.0).collect();
        sorted.sort_unstable_by(f64::total_cmp);
        sorted.dedup_by(|a, b| a.total_cmp(b).is_eq());
        let found = level::wavefronts(self, figure, &sorted);
        let of = |d: &f64| {
            let i = sorted.partition_point(|s| s < d);
            found[i].clone()
        };
        Ok(distances.iter().map(of).collect())
    }
}
