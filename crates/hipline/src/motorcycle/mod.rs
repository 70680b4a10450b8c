//! Motorcycle graphs.

mod births;
mod encounter;
mod pairs;
mod race;
mod start;
mod tracks;
mod walls;

pub(crate) use tracks::{Crash, Meeting, Origin, Track, Tracks};

use crate::{engine::NotApplicable, input::Figure, predicates::Planes};

/// The motorcycle graph that the inside of the figure's polygons induces, and the planes that it
/// is told in: those of the figure's edges, as [`Planes::new`] numbers them.
///
/// # Errors
/// If the figure is not made of polygons alone, or not all speeds are one.
pub(crate) fn induced(figure: &Figure) -> Result<(Planes, Tracks), NotApplicable> {
    start::check(figure)?;
    let planes = Planes::new(figure, &[]);
    let sectors = start::sectors(figure, &planes);
    let starters = sectors.iter().map(|sector| sector.track).collect();
    let ground = pairs::AllPairs(walls::Edges::new(figure));
    let tracks = race::run(&planes, starters, ground, true);
    Ok((planes, tracks))
}
