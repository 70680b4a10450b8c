//! Motorcycle graphs: points that move at constant velocities, and stop where they reach the track of
//! another one, or a wall.
//!
//! Eppstein and Erickson (1999) invented them to hold what is hard about straight skeletons. Each reflex
//! vertex of a polygon sends a motorcycle with the velocity of its wavefront vertex. Then each valley of the roof lies
//! on a track, and the roof is the lower envelope of slabs on edges and tracks (Cheng & Vigneron
//! 2007; Theorem 2 of Mencil's thesis, 2014).
//!
//! In degenerate figures motorcycles meet: two or more are at one place at one moment. Then a new one starts
//! there if the wavefront has a reflex vertex there afterwards: the *generalized* motorcycle graph of Held
//! and Huber (2012; Mencil 2014, section 5.1). `births` has the rule. `encounter` has those for all
//! that two motorcycles can do to each other, so that every case has exactly one answer:
//!
//! * A motorcycle stops at the first point where it reaches a wall or the closed track of another one that
//!   was there strictly before.
//! * Those who come to one place at one moment, where nothing was before, stop there: they meet.
//! * A start counts as being there before: who comes there at that moment stops, who starts there does
//!   not. Those who start together do not see each other, unless one follows the other on one line.
//! * Walls and vertices count before tracks, tracks before meetings, low numbers before high ones.
//! * Straight vertices of a figure send none.
//!
//! No coordinate takes part in a decision: a track is a pair of planes (`tracks`), a crash a definition
//! (`Place::On`). `race` settles the crashes in the exact order of time. It is told of
//! what may happen by a *ground*: `pairs`, the definition in quadratic time; `cells`, a tree of cells with few walls and few
//! motorcycles. A ground may tell too much, and never too little, so grounds need no exact numbers of their own.

mod agenda;
mod births;
mod cells;
mod encounter;
mod field;
mod given;
mod hits;
mod model;
mod pairs;
mod race;
mod start;
#[cfg(test)]
mod tests;
pub(crate) mod tracks;
mod tree;
mod verify;
mod walls;
mod way;

use cells::Cells;
pub use given::{InvalidLaunch, Launch, LaunchFlaw};
pub use model::{End, Meeting, Motorcycle, MotorcycleGraph, Origin, Spot};
use pairs::AllPairs;
use tracks::Tracks;
pub use verify::{GraphViolation, GraphViolations};
use walls::{Edges, Standing};

use crate::{
    engine::NotApplicable,
    input::Figure,
    predicates::{PlaneId, Planes},
    skeleton::Side,
    topology::EdgeId,
};

/// The motorcycle graph that the inside of the figure's polygons induces, and the planes that it
/// is told in: those of the figure's edges, as [`Planes::new`] numbers them.
///
/// # Errors
/// If the figure is not made of polygons alone, or not all speeds are one.
pub(crate) fn induced(figure: &Figure) -> Result<(Planes, Tracks), NotApplicable> {
    start::check(figure)?;
    let planes = Planes::new(figure, &[]);
    let starters = start::starters(figure, &planes);
    if starters.is_empty() {
        return Ok((planes, Tracks::default()));
    }
    let edges = Standing::Edges(Edges::new(figure, &planes));
    let cells = Cells::new(edges, std::iter::empty());
    let tracks = race::run(&planes, starters, cells, true);
    Ok((planes, tracks))
}

/// The same by a look at all pairs.
fn induced_by_pairs(figure: &Figure) -> Result<(Planes, Tracks), NotApplicable> {
    start::check(figure)?;
    let planes = Planes::new(figure, &[]);
    let starters = start::starters(figure, &planes);
    let edges = Standing::Edges(Edges::new(figure, &planes));
    let tracks = race::run(&planes, starters, AllPairs(edges), true);
    Ok((planes, tracks))
}

fn rounded((planes, tracks): &(Planes, Tracks)) -> MotorcycleGraph {
    let side = |PlaneId(plane): PlaneId| {
        let side = if plane % 2 == 1 {
            Side::Right
        } else {
            Side::Left
        };
        (EdgeId::new((plane / 2) as usize), side)
    };
    let wall = |plane| {
        let (edge, side) = side(plane);
        End::Edge(edge, side)
    };
    MotorcycleGraph::of_tracks(planes, tracks, wall, |[right, left]| {
        Some([side(left), side(right)])
    })
}

impl Figure {
    /// The motorcycle graph that the inside of the polygons induces: each reflex vertex sends a motorcycle with the
    /// velocity of its wavefront vertex; it stops at the boundary, or where it reaches the track of
    /// another one that was there before. Where several meet and the wavefront has a reflex vertex
    /// afterwards, a new one starts.
    ///
    /// Every valley of the roof lies on a track.
    ///
    /// Exact: every crash is decided by the signs of exact numbers, and what is told is rounded
    /// correctly.
    ///
    /// ```
    /// use hipline::{Polygon, motorcycle::End};
    ///
    /// let polygon = Polygon::new([vec![[0., 0.], [8., 0.], [8., 6.], [4., 2.], [0., 6.]]])?;
    /// let graph = polygon.figure().motorcycles()?;
    /// let motorcycle = &graph.motorcycles()[0];
    /// assert_eq!((motorcycle.start.x, motorcycle.start.y), (4.0, 2.0));
    /// let stop = motorcycle.stop.expect("there is a boundary");
    /// assert_eq!((stop.x, stop.y), (4.0, 0.0));
    /// assert!(matches!(motorcycle.end, End::Edge(edge, _) if edge.index() == 0));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Complexity
    /// Near n log n on ordinary input, with memory linear in the number of cells that the tracks go through; quadratic
    /// at worst, where many long tracks go through many cells.
    ///
    /// # Errors
    /// If the figure is not made of polygons alone, or not all speeds are one.
    pub fn motorcycles(&self) -> Result<MotorcycleGraph, NotApplicable> {
        Ok(rounded(&induced(self)?))
    }

    /// The same by a look at all pairs of motorcycles and all edges: the definition itself, to check
    /// [`Figure::motorcycles`] with.
    ///
    /// # Complexity
    /// O(n^2 log n), always.
    ///
    /// # Errors
    /// As for [`Figure::motorcycles`].
    pub fn motorcycles_by_pairs(&self) -> Result<MotorcycleGraph, NotApplicable> {
        Ok(rounded(&induced_by_pairs(self)?))
    }
}
