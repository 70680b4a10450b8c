//! Points that move as somebody wants them to, as vertices of planes.
//!
//! A point at (x, y) at the time t0 with the velocity (v, w) is on the planes `X = x + v (t - t0)` and
//! `Y = y + w (t - t0)`, upright lines that move along the axes. So it is a vertex of the wavefront
//! like any other, but for the roots, of which there are none; and every question about it has its
//! answer already.

use dashu_int::{
    IBig,
    ops::{BitTest, UnsignedAbs},
};
use hipline_num::{common_unit, in_units};
use std::cell::{Cell, OnceCell};

use super::{
    fixed::Lengths,
    lines::Known,
    phases::Phases,
    planes::{GRID, PlaneId, Planes, Speeds},
};

/// A point, its velocity, and when it is there.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Motion {
    pub place: [f64; 2],
    pub velocity: [f64; 2],
    pub time: f64,
}

/// Lines for each motion: its two planes, then two that stand still where it starts.
const LINES: usize = 4;
/// Lines for each wall: its own, and two across it through its ends.
const WALL_LINES: usize = 3;

/// The left side of a line.
fn left(line: usize) -> PlaneId {
    PlaneId(2 * u32::try_from(line).expect("fewer than 2^32 lines"))
}

/// The planes of the motion with a number.
pub(crate) fn pair_of_motion(motion: usize) -> [PlaneId; 2] {
    [0, 1].map(|k| left(LINES * motion + k))
}

/// The lines along x and y that stand still through the start of a motion.
pub(crate) fn start_of_motion(motion: usize) -> [PlaneId; 2] {
    [2, 3].map(|k| left(LINES * motion + k))
}

/// The line of a wall, and those across it through its ends.
pub(crate) fn lines_of_wall(motions: usize, wall: usize) -> [PlaneId; 3] {
    [0, 1, 2].map(|k| left(LINES * motions + WALL_LINES * wall + k))
}

/// The wall that a line belongs to.
pub(crate) fn wall_of_line(motions: usize, line: PlaneId) -> usize {
    ((line.0 >> 1) as usize - LINES * motions) / WALL_LINES
}

/// Units of coordinates and of times, such that all that moves is an integer, and so are speeds:
/// the first two, then the factor of velocities as an exponent.
fn units(motions: &[Motion], walls: &[[[f64; 2]; 2]]) -> [i32; 3] {
    let places = motions.iter().flat_map(|motion| motion.place);
    let (unit, _) = common_unit(places.chain(walls.iter().flatten().flatten().copied()));
    let (speed, _) = common_unit(motions.iter().flat_map(|motion| motion.velocity));
    let (time, digits) = common_unit(motions.iter().map(|motion| motion.time));
    if digits == 0 {
        return [unit, unit - speed, speed];
    }
    [unit.min(speed + time), time, unit.min(speed + time) - time]
}

impl Planes {
    /// The planes of points that move, and of walls.
    pub(crate) fn of_motions(motions: &[Motion], walls: &[[[f64; 2]; 2]]) -> Self {
        let [unit, time_unit, speed_unit] = units(motions, walls);
        let places =
            || (motions.iter().map(|motion| motion.place)).chain(walls.iter().flatten().copied());
        let origin = [0, 1].map(|k| {
            let nearest = places()
                .map(|place| place[k])
                .min_by(|p, q| p.abs().total_cmp(&q.abs()));
            nearest.unwrap_or_default()
        });
        let point =
            |place: [f64; 2]| [0, 1].map(|k| in_units(place[k], unit) - in_units(origin[k], unit));
        let mut points: Vec<([IBig; 2], [IBig; 2])> =
            Vec::with_capacity(LINES * motions.len() + WALL_LINES * walls.len());
        let mut exact = Vec::with_capacity(2 * points.capacity());
        let unit_vectors = || [[IBig::ONE, IBig::ZERO], [IBig::ZERO, IBig::ONE]];
        for motion in motions {
            let at = point(motion.place);
            let speed = motion.velocity.map(|v| in_units(v, speed_unit));
            let time = in_units(motion.time, time_unit);
            let first = [0, 1].map(|k| &at[k] - &speed[k] * &time);
            for (normal, speed) in unit_vectors().into_iter().zip(speed) {
                points.push((normal, first.clone()));
                exact.extend([speed, IBig::ZERO]);
            }
            for normal in unit_vectors() {
                points.push((normal, at.clone()));
                exact.extend([IBig::ZERO, IBig::ZERO]);
            }
        }
        for &wall in walls {
            let [p, q] = wall.map(point);
            let along = [0, 1].map(|k| &q[k] - &p[k]);
            let normal = [-&along[1], along[0].clone()];
            for (normal, point) in [(normal, p.clone()), (along.clone(), p), (along, q)] {
                points.push((normal, point));
                exact.extend([IBig::ZERO, IBig::ZERO]);
            }
        }
        let digits = |x: &IBig| x.clone().unsigned_abs().bit_len() as i32;
        let bits = points
            .iter()
            .flat_map(|line| &line.1)
            .map(digits)
            .max()
            .unwrap_or(0);
        let speed_bits = exact.iter().map(digits).max().unwrap_or(0);
        let shift = if bits > 53 { bits - 30 } else { 0 };
        let speed_shift = if speed_bits > 20 || shift > 0 {
            (speed_bits - 10).max(0)
        } else {
            0
        };
        let mut planes = Self {
            lines: Vec::with_capacity(points.len()),
            lengths: Lengths::default(),
            grid: bits <= GRID && speed_bits <= GRID,
            one_root: OnceCell::new(),
            roughs: Vec::with_capacity(points.len()),
            doubles: Vec::with_capacity(points.len()),
            speeds: Some(Speeds {
                exact,
                shift: speed_shift,
            }),
            phases: Phases::default(),
            first_later: points.len(),
            offsets: Vec::new(),
            shift,
            unit,
            origin,
            time_unit,
            rungs: Cell::default(),
            last_root: Cell::default(),
            last_meeting: Cell::default(),
            known: Known::default(),
        };
        for ([a, b], point) in points {
            planes.push_big(a, b, &point);
        }
        planes
    }
}
