//! Planes in the numbers that are asked before all others.

use dashu_int::IBig;
use hipline_num::{Ball, BallDd, Rough, exponent};

use super::{
    eaves::{Tilted, tabled},
    expression::{Quadratic, meeting},
    planes::{Plane, PlaneId, Planes, Rung},
};

/// `[a, b, c, length of the normal]` of a line, nearly; NaN where a number is too small.
///
/// If they are not the integers themselves, they are a multiple of them: where digits were
/// dropped, a line that was divided by a large gcd may be tiny, and a line is the same whatever
/// its equation is multiplied by. (If they are the integers, a number that `Ball` knows to be an
/// integer has to come out as the same one here; see [`Rough::may_be_exact`].)
pub(super) fn line(near: &[BallDd; 4], integers: bool) -> [f64; 4] {
    let scale = if integers {
        0
    } else {
        30 - exponent(near[3].value())
    };
    near.each_ref().map(|x| {
        let zero = x.value() == 0.0 && x.error() == 0.0;
        known(x.ldexp(scale).value(), zero)
    })
}

/// The number to make a [`Rough`] of, NaN if it is too small; whether it is zero is known apart.
pub(super) fn known(value: f64, zero: bool) -> f64 {
    if zero || value.abs() >= Rough::LEAST {
        value
    } else {
        f64::NAN
    }
}

impl Rung for Rough {
    const HAS_ROOTS: bool = false;

    #[inline]
    fn line(planes: &Planes, line: usize) -> [Self; 4] {
        // What is known of planes of later phases is deeper than the bounds allow for.
        if line >= planes.first_later {
            return [Self::unknown(); 4];
        }
        planes.roughs[line].map(Self::near)
    }

    fn tilted(_: &Planes, _: usize, _: &Tilted) -> Plane<Self> {
        tabled(&[Self::unknown(); 4])
    }

    fn time(_: &Planes, _: f64) -> [Self; 2] {
        [Self::unknown(); 2]
    }

    fn falling_root(_: &Quadratic<Self>) -> Option<Self> {
        None
    }

    #[inline]
    fn met(planes: &Planes, triple: [PlaneId; 3]) -> (Self, Self) {
        if let Some((of, met)) = planes.last_meeting.get()
            && of == triple
        {
            return met;
        }
        let met = meeting(planes, triple);
        planes.last_meeting.set(Some((triple, met)));
        met
    }

    fn integer(value: &IBig, shift: i32) -> Self {
        let near = Ball::from_int(value).ldexp(-shift).value();
        Self::near(known(near, *value == IBig::ZERO))
    }
}
