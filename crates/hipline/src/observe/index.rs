//! Point location: which face is it, and when does the wavefront arrive?

use super::{
    Grid,
    plan::{Border, Ground, Plan, Query},
    trapezoids::Trapezoids,
};
use crate::{
    input::{Figure, Source},
    predicates::Spot,
    skeleton::{Side, Skeleton},
    topology::{ArcId, EdgeId, FaceId, NodeId},
};
use hipline_num::Sign;

/// What a point is answered with.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Answer {
    /// The face around the point.
    pub face: FaceId,
    /// The input edge from which the wavefront arrives there.
    pub edge: EdgeId,
    /// From which side of the edge.
    pub side: Side,
    /// The caller's name for the edge.
    pub source: Source,
    /// When the wavefront arrives: the f64 nearest to the exact time, from the plane of the
    /// face. On the input it is 0.
    pub time: f64,
}

/// Why a point has no answer.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum NoAnswer {
    /// A coordinate is infinite or no number.
    #[error("the point ({0}, {1}) is not finite")]
    NotFinite(f64, f64),
    /// The skeleton does not cover this part of the plane.
    #[error("the point ({0}, {1}) is outside of what the skeleton covers")]
    Outside(f64, f64),
    /// The wavefront never arrives there, because edges stand still; or the point is 2^200 times as far away as the
    /// figure is large, or more.
    #[error("the wavefront never arrives at ({0}, {1}), or the point is too far away")]
    TooFar(f64, f64),
    /// A drop that crosses arcs, which takes weights, comes back to where it was: the places of
    /// crossings are rounded.
    #[error("the drop from ({0}, {1}) cannot be followed: rounding leads it in a circle")]
    Lost(f64, f64),
}

/// A search structure over the faces of a skeleton.
///
/// ```
/// use hipline::{Polygon, observe::Index};
///
/// let polygon = Polygon::new([vec![[0.0, 0.0], [8.0, 0.0], [8.0, 4.0], [0.0, 4.0]]])?;
/// let skeleton = polygon.skeleton();
/// let index = Index::new(&skeleton, polygon.figure());
/// let answer = index.locate([3.0, 1.5])?;
/// assert_eq!((answer.source.edge, answer.time), (0, 1.5));
/// assert!(index.locate([9.0, 1.0]).is_err());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// Which face a point is in is decided exactly, by the planes that define the arcs. A point on
/// a border belongs to the face around a point a little to the east of it (and still less to the
/// north); if the skeleton does not cover that, to a face that the border belongs to.
pub struct Index<'a> {
    pub(super) plan: Plan<'a>,
    trapezoids: Trapezoids,
    pub(super) figure: &'a Figure,
    /// The segments around each face, those of face i from `.0[i]` to `.0[i + 1]`.
    around: (Vec<u32>, Vec<u32>),
    /// The segments at each position, in the same way.
    at: (Vec<u32>, Vec<u32>),
}

impl std::fmt::Debug for Index<'_> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Index")
            .field("segments", &self.plan.segments.len())
            .field("trapezoids", &self.trapezoids.list.len())
            .finish_non_exhaustive()
    }
}

/// Lists of values by key, all in one: those of key k from `.0[k]` to `.0[k + 1]`.
fn grouped(pairs: &[(u32, u32)], keys: usize) -> (Vec<u32>, Vec<u32>) {
    let mut first = vec![0_u32; keys + 1];
    for &(key, _) in pairs {
        first[key as usize + 1] += 1;
    }
    for i in 1..first.len() {
        first[i] += first[i - 1];
    }
    let mut at = first.clone();
    let mut list = vec![0; pairs.len()];
    for &(key, value) in pairs {
        let slot = &mut at[key as usize];
        list[*slot as usize] = value;
        *slot += 1;
    }
    (first, list)
}

impl<'a> Index<'a> {
    /// Builds the structure.
    ///
    /// # Complexity
    /// O(n log n) expected time and O(n) space, for a skeleton of size n.
    ///
    /// # Panics
    /// If the figure is not the one that the skeleton was computed from.
    #[must_use]
    pub fn new(skeleton: &'a Skeleton, figure: &'a Figure) -> Self {
        let plan = Plan::new(skeleton, figure);
        let trapezoids = Trapezoids::new(&plan);
        let (mut by_face, mut by_position) = (Vec::new(), Vec::new());
        for (i, segment) in plan.segments.iter().enumerate() {
            for ground in [segment.above, segment.below] {
                if let Ground::Face(face) = ground {
                    by_face.push((face.index() as u32, i as u32));
                }
            }
            by_position.extend(segment.ends.map(|end| (end, i as u32)));
        }
        by_face.dedup();
        Self {
            around: grouped(&by_face, skeleton.faces().len()),
            at: grouped(&by_position, plan.positions.len()),
            plan,
            trapezoids,
            figure,
        }
    }

    /// The segments around a face.
    pub(super) fn around(&self, face: FaceId) -> &[u32] {
        let (first, list) = &self.around;
        &list[first[face.index()] as usize..first[face.index() + 1] as usize]
    }

    /// The segments that end at a position.
    pub(super) fn at(&self, position: u32) -> &[u32] {
        let (first, list) = &self.at;
        &list[first[position as usize] as usize..first[position as usize + 1] as usize]
    }

    /// The skeleton that is asked.
    #[must_use]
    pub const fn skeleton(&self) -> &'a Skeleton {
        self.plan.skeleton()
    }

    /// The face around a point, its edge, and the time at which the wavefront arrives.
    ///
    /// # Complexity
    /// O(log n) expected.
    ///
    /// # Errors
    /// The point is not finite, outside of the skeleton, or extremely far away.
    pub fn locate(&self, point: [f64; 2]) -> Result<Answer, NoAnswer> {
        let [x, y] = point;
        if !(x.is_finite() && y.is_finite()) {
            return Err(NoAnswer::NotFinite(x, y));
        }
        let query = Query::new(point);
        match self.ground(&query) {
            Ground::Face(face) => Ok(self.answer(face, &query)),
            Ground::Outside => Err(NoAnswer::Outside(x, y)),
            Ground::Beyond => Err(NoAnswer::TooFar(x, y)),
        }
    }

    /// The answers for many points, in their order.
    ///
    /// # Complexity
    /// O(m log n) for m points.
    #[must_use]
    pub fn locate_all(&self, points: &[[f64; 2]]) -> Vec<Result<Answer, NoAnswer>> {
        points.iter().map(|&p| self.locate(p)).collect()
    }

    /// The answers for the centres of a grid's cells, row by row from the south, each row from
    /// the west; the same as [`locate`](Self::locate) gives.
    ///
    /// # Complexity
    /// O(c + n + k + r log n), for c cells in r rows and k places where a row crosses an arc.
    #[must_use]
    pub fn locate_grid(&self, grid: &Grid) -> Vec<Result<Answer, NoAnswer>> {
        let grounds = self.grounds(grid);
        let answer = |(i, ground): (usize, &Ground)| {
            let point = grid.centre(i % grid.columns(), i / grid.columns());
            match *ground {
                Ground::Face(face) => Ok(self.answer(face, &Query::new(point))),
                Ground::Outside => Err(NoAnswer::Outside(point[0], point[1])),
                Ground::Beyond => Err(NoAnswer::TooFar(point[0], point[1])),
            }
        };
        grounds.iter().enumerate().map(answer).collect()
    }

    /// When the wavefront of a face's plane arrives at a point, whether in the face or not: the
    /// nearest f64.
    ///
    /// # Errors
    /// A coordinate is infinite or no number.
    pub fn time_of(&self, face: FaceId, point: [f64; 2]) -> Result<f64, NoAnswer> {
        let [x, y] = point;
        if !(x.is_finite() && y.is_finite()) {
            return Err(NoAnswer::NotFinite(x, y));
        }
        Ok(self.arrival(face, &Query::new(point)))
    }

    fn arrival(&self, face: FaceId, query: &Query) -> f64 {
        let planes = self.plan.planes();
        planes.arrival(query.station(planes), self.plan.lift.plane(face))
    }

    fn answer(&self, face: FaceId, query: &Query) -> Answer {
        let of = self.skeleton().face(face);
        Answer {
            face,
            edge: of.edge,
            side: of.side,
            source: self.figure.edges()[of.edge.index()].source,
            time: self.arrival(face, query),
        }
    }

    /// What a point lies in that is moved a little to the east, and still less to the north.
    pub(super) fn ground_to_the_east(&self, query: &Query) -> Ground {
        let found = self.trapezoids.find(&self.plan, query);
        self.trapezoids.ground(&self.plan, found)
    }

    /// What a point lies in.
    pub(super) fn ground(&self, query: &Query) -> Ground {
        let found = self.trapezoids.find(&self.plan, query);
        match self.trapezoids.ground(&self.plan, found) {
            Ground::Outside => self.on_border(found, query).unwrap_or(Ground::Outside),
            ground => ground,
        }
    }

    /// The face of a border that a point is on, where the trapezoid to the east of it belongs to none.
    fn on_border(&self, trapezoid: usize, query: &Query) -> Option<Ground> {
        let trapezoid = self.trapezoids.list[trapezoid];
        let beside = |segment: u32| {
            let segment = &self.plan.segments[segment as usize];
            let faces = [segment.above, segment.below];
            faces.into_iter().find(|g| matches!(g, Ground::Face(_)))
        };
        let exists = |&k: &u32| k != u32::MAX;
        for segment in trapezoid.sides.into_iter().filter(exists) {
            let line = &self.plan.segments[segment as usize];
            let [from, to] = line.ends;
            if self.plan.side(line, query).is_zero()
                && self.plan.compare_query(query, from).is_ge()
                && self.plan.compare_query(query, to).is_le()
                && let Some(ground) = beside(segment)
            {
                return Some(ground);
            }
        }
        let mut ends = trapezoid.ends.into_iter().filter(exists);
        let end = ends.find(|&end| self.plan.compare_query(query, end).is_eq())?;
        self.at(end).iter().find_map(|&segment| beside(segment))
    }
}

/// What rain needs to know about the segments.
impl Index<'_> {
    /// The arc that a segment is, if it is one.
    pub(super) fn arc(&self, segment: u32) -> Option<ArcId> {
        match self.plan.segments[segment as usize].border {
            Border::Arc(arc) => Some(arc),
            _ => None,
        }
    }

    /// What lies on the other side of a face's segment.
    pub(super) fn beyond(&self, segment: u32, face: FaceId) -> Ground {
        let segment = &self.plan.segments[segment as usize];
        if segment.above == Ground::Face(face) {
            segment.below
        } else {
            segment.above
        }
    }

    /// Where the points of a segment's face are: positive above it.
    pub(super) fn side_of_face(&self, segment: u32, face: FaceId) -> Sign {
        if self.plan.segments[segment as usize].above == Ground::Face(face) {
            Sign::Positive
        } else {
            Sign::Negative
        }
    }

    /// A position as a point of the plan.
    pub(super) fn spot(&self, position: u32) -> Spot<'_> {
        Spot::Place(&self.plan.positions[position as usize].place)
    }

    /// The number of a node's position.
    pub(super) fn number_of(&self, node: NodeId) -> u32 {
        self.plan.numbers[node.index()]
    }
}
