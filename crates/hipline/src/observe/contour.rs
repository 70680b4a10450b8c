//! Contour lines: the wavefronts at the times of given heights, cut by a window.

use super::Window;
use crate::{
    input::Figure,
    offset::{InvalidOffset, Offset},
    skeleton::Skeleton,
};

/// A piece of a contour line.
#[derive(Debug, Clone, PartialEq)]
pub struct Contour {
    /// The time of the wavefront.
    pub time: f64,
    /// Its points; of a closed line, the last does not repeat the first. What is higher is on
    /// the left.
    pub points: Vec<[f64; 2]>,
    /// Whether the last point is joined to the first.
    pub is_closed: bool,
}

/// Why there are no contour lines.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum InvalidStep {
    /// A time is negative, infinite or no number.
    #[error("a contour line has no time {0}")]
    Time(f64),
    /// The skeleton is that of a [`Chain`](crate::Chain).
    #[error("one side of a chain has no contour lines that close")]
    Chain,
}

/// The lines at given times, cut by a window: a line that leaves the window is in pieces.
///
/// # Complexity
/// That of [`Skeleton::offsets`].
///
/// # Errors
/// A time is negative, infinite or no number, or the skeleton is that of a chain.
///
/// # Panics
/// If the figure is not the one that the skeleton was computed from.
pub fn contours(
    skeleton: &Skeleton,
    figure: &Figure,
    window: Window,
    times: &[f64],
) -> Result<Vec<Contour>, InvalidStep> {
    let offsets = skeleton
        .offsets(figure, times)
        .map_err(|reason| match reason {
            InvalidOffset::Distance(time) => InvalidStep::Time(time),
            InvalidOffset::Chain => InvalidStep::Chain,
        })?;
    Ok(offsets.iter().flat_map(|o| cut(o, window)).collect())
}

fn cut(offset: &Offset, window: Window) -> Vec<Contour> {
    let time = offset.distance();
    let mut found = Vec::new();
    for cycle in offset.loops() {
        let points = cycle.points();
        if points.iter().all(|&p| window.contains(p)) {
            found.push(Contour {
                time,
                points: points.to_vec(),
                is_closed: true,
            });
            continue;
        }
        // From a point outside, no piece goes on over the end of the list.
        let start = points.iter().position(|&p| !window.contains(p));
        let mut chain = points.to_vec();
        chain.rotate_left(start.unwrap_or(0));
        chain.extend(chain.first().copied());
        for points in pieces(&chain, window) {
            found.push(Contour {
                time,
                points,
                is_closed: false,
            });
        }
    }
    found
}

/// What is visible of a chain.
fn pieces(chain: &[[f64; 2]], window: Window) -> Vec<Vec<[f64; 2]>> {
    let mut pieces: Vec<Vec<[f64; 2]>> = Vec::new();
    let mut goes_on = false;
    let bits = |p: [f64; 2]| p.map(f64::to_bits);
    for edge in chain.windows(2) {
        let (p, q) = (edge[0], edge[1]);
        let Some([s, t]) = window.inside(p, q) else {
            goes_on = false;
            continue;
        };
        let at = |s: f64| [0, 1].map(|k| (q[k] - p[k]).mul_add(s, p[k]));
        let start = if s > 0.0 { at(s) } else { p };
        let end = if t < 1.0 { at(t) } else { q };
        match pieces.last_mut() {
            Some(piece) if goes_on && s <= 0.0 => piece.push(end),
            _ if bits(start) != bits(end) => pieces.push(vec![start, end]),
            _ => {}
        }
        goes_on = t >= 1.0 && !pieces.is_empty();
    }
    pieces
}
