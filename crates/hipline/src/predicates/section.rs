//! What a cut along an axis meets: borders of faces, and in which order.
//!
//! On the line x = c, the border `u x + v y = z` is at y = (z - u c) / v. So where borders cross a cut, and
//! on which part of it one is on their positive side, are signs of polynomials in the planes of the input and c.

use dashu_int::IBig;
use hipline_num::{Ball, Sign};
use std::cmp::Ordering;

use super::{
    decide::Question,
    planes::{Planes, Rung},
    station::{Station, Track, line},
};

/// A line parallel to an axis.
#[derive(Debug)]
pub(crate) struct Cut {
    /// A point of it, of which one coordinate matters.
    at: Station,
    /// Whether it is horizontal.
    horizontal: bool,
}

impl Cut {
    /// The line x = c, or y = c. The number must be finite.
    pub(crate) fn new(planes: &Planes, c: f64, horizontal: bool) -> Self {
        let at = Station::new(planes, [c, c]);
        Self { at, horizontal }
    }

    /// `[p, q]` with the place `p / q` on the cut where the border is, in units of the grid; and the sign of the side
    /// beyond it, along the cut.
    fn crossing<T: Rung>(&self, planes: &Planes, border: &Track) -> ([T; 2], Option<Sign>) {
        let ([u, v, z], sign) = line::<T>(planes, border);
        let integer = |x: &IBig, shift: i32| T::integer(x, shift);
        let [x, y, w] = self.at.parts();
        let w = integer(w, 0);
        let (across, along, c) = if self.horizontal {
            (v, u, y)
        } else {
            (u, v, x)
        };
        let p = z.times(&w).minus(&across.times(&integer(c, planes.shift)));
        ([p, along.times(&w)], sign)
    }
}

/// The order of two borders on a cut.
struct Order<'a>(&'a Cut, &'a Track, &'a Track);

impl Question for Order<'_> {
    fn ask<T: Rung>(&self, planes: &Planes) -> Option<Sign> {
        let ([p, v], _) = self.0.crossing::<T>(planes, self.1);
        let ([q, w], _) = self.0.crossing::<T>(planes, self.2);
        Some(p.times(&w).minus(&q.times(&v)).sign()? * v.sign()? * w.sign()?)
    }
}

/// Whether going along a cut one gets to the positive side of a border, or the negative one; zero if neither.
struct Slope<'a>(&'a Cut, &'a Track);

impl Question for Slope<'_> {
    fn ask<T: Rung>(&self, planes: &Planes) -> Option<Sign> {
        let ([_, q], sign) = self.0.crossing::<T>(planes, self.1);
        Some(q.sign()? * sign?)
    }
}

/// On which side of a border a cut is that never crosses it.
struct Constant<'a>(&'a Cut, &'a Track);

impl Question for Constant<'_> {
    fn ask<T: Rung>(&self, planes: &Planes) -> Option<Sign> {
        let ([p, _], sign) = self.0.crossing::<T>(planes, self.1);
        Some(-(p.sign()? * sign?))
    }
}

impl Planes {
    /// Compares where two borders cross a cut.
    pub(crate) fn compare_on_cut(&self, cut: &Cut, p: &Track, q: &Track) -> Ordering {
        self.decide(&Order(cut, p, q)).ordering()
    }

    /// Whether going along a cut one gets to the positive side of a border, or the negative one; zero if neither.
    pub(crate) fn slope_on_cut(&self, cut: &Cut, border: &Track) -> Sign {
        self.decide(&Slope(cut, border))
    }

    /// On which side of a border a cut is that never crosses it.
    pub(crate) fn side_of_cut(&self, cut: &Cut, border: &Track) -> Sign {
        self.decide(&Constant(cut, border))
    }

    /// Bounds of where a border crosses a cut, in the input's units.
    pub(crate) fn bounds_on_cut(&self, cut: &Cut, border: &Track) -> [f64; 2] {
        let ([p, q], _) = cut.crossing::<Ball>(self, border);
        let at = p.div(&q);
        let origin = self.origin[usize::from(!cut.horizontal)];
        let unit = 2.0_f64.powi(self.unit + self.shift);
        if !at.error().is_finite() {
            return [f64::NEG_INFINITY, f64::INFINITY];
        }
        let low = (at.lower() * unit).next_down() + origin;
        let high = (at.upper() * unit).next_up() + origin;
        if low.is_finite() && high.is_finite() {
            [low.next_down(), high.next_up()]
        } else {
            [f64::NEG_INFINITY, f64::INFINITY]
        }
    }
}
