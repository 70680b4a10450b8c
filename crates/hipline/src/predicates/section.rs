//! Cuts through the plan: what they meet, and in which order; corners of the cells between them.
//!
//! Every line here is `u x + v y = z` with numbers made of planes of the input and of points that somebody chose, so where two
//! lines cross, and on which side of a third one that is, are signs of polynomials. Nothing is computed from such a crossing.

use dashu_int::IBig;
use hipline_num::{Ball, Sign, ldexp};
use std::{cmp::Ordering, sync::Arc};

use super::{
    decide::Question,
    place::{self, Place},
    planes::{PlaneId, Planes, Rung},
    station::{Station, Track, line, side},
};

/// A line of the plan, directed: its left is positive.
#[derive(Debug, Clone)]
pub(crate) enum Line {
    /// A border of faces or of slabs.
    Border(Track),
    /// Straight down on a plane through a point; what is further along the plane's edge is positive.
    Down(PlaneId, Arc<Station>),
    /// Through a point, in a direction.
    Toward(Arc<Station>, [i32; 2]),
}

/// A corner of a cell.
#[derive(Debug, Clone)]
pub(crate) enum CellCorner {
    At(Arc<Station>),
    /// Where two lines cross.
    Of(Line, Line),
}

/// `[u, v, z]` of a line, such that `u x + v y - z` has the sign of its sides, but for the sign that comes second.
fn numbers<T: Rung>(planes: &Planes, of: &Line) -> ([T; 3], Option<Sign>) {
    match of {
        Line::Border(track) => line(planes, track),
        Line::Down(plane, at) => {
            let plane = T::plane(planes, *plane);
            let [x, y, w] = at.numbers::<T>(planes);
            let z = plane.along(&x, &y);
            (
                [plane.b.times(&w), plane.a.negated().times(&w), z],
                Some(Sign::Positive),
            )
        }
        Line::Toward(at, toward) => {
            let [x, y, w] = at.numbers::<T>(planes);
            let [dx, dy] = toward.map(|d| T::from_i64(d.into()));
            let z = dx.times(&y).minus(&dy.times(&x));
            (
                [dy.negated().times(&w), dx.times(&w), z],
                Some(Sign::Positive),
            )
        }
    }
}

/// `[x, y, w]` of a corner.
fn point<T: Rung>(planes: &Planes, corner: &CellCorner) -> [T; 3] {
    match corner {
        CellCorner::At(at) => at.numbers(planes),
        CellCorner::Of(k, l) => {
            let [k, l] = [k, l].map(|line| numbers::<T>(planes, line).0);
            let minor = |i: usize, j: usize| k[i].times(&l[j]).minus(&k[j].times(&l[i]));
            [minor(2, 1), minor(0, 2), minor(0, 1)]
        }
    }
}

/// On which side of a line a corner is.
struct Beside<'a>(&'a CellCorner, &'a Line);

impl Question for Beside<'_> {
    fn ask<T: Rung>(&self, planes: &Planes) -> Option<Sign> {
        side(&point::<T>(planes, self.0), &numbers::<T>(planes, self.1))
    }
}

/// On which side of a line a place is.
struct PlaceBeside<'a>(&'a Place, &'a Line);

impl Question for PlaceBeside<'_> {
    fn ask<T: Rung>(&self, planes: &Planes) -> Option<Sign> {
        let at = place::point::<T>(planes, self.0);
        side(&[at.x, at.y, at.w], &numbers::<T>(planes, self.1))
    }
}

/// The order in which a line crosses two others.
struct Order<'a>(&'a Line, &'a Line, &'a Line);

impl Question for Order<'_> {
    fn ask<T: Rung>(&self, planes: &Planes) -> Option<Sign> {
        let (c, sign) = numbers::<T>(planes, self.0);
        let [p, q] = [self.1, self.2].map(|line| numbers::<T>(planes, line).0);
        let minor = |i: usize, j: usize| c[i].times(&p[j]).minus(&c[j].times(&p[i]));
        let w = minor(0, 1);
        // Where the second one is, seen from the crossing with the first one.
        let value = (q[0].times(&minor(2, 1)))
            .plus(&q[1].times(&minor(0, 2)))
            .minus(&q[2].times(&w));
        let slope = q[0].times(&c[1]).minus(&q[1].times(&c[0]));
        Some(value.sign()? * w.sign()? * slope.sign()? * sign?)
    }
}

/// Whether going along one line one gets to the positive side of another one, or the negative one.
struct Slope<'a>(&'a Line, &'a Line);

impl Question for Slope<'_> {
    fn ask<T: Rung>(&self, planes: &Planes) -> Option<Sign> {
        let (c, sign) = numbers::<T>(planes, self.0);
        let (q, other) = numbers::<T>(planes, self.1);
        let slope = q[0].times(&c[1]).minus(&q[1].times(&c[0]));
        Some(slope.sign()? * sign? * other?)
    }
}

/// On which side of a line another one is that never crosses it.
struct Constant<'a>(&'a Line, &'a Line);

impl Question for Constant<'_> {
    fn ask<T: Rung>(&self, planes: &Planes) -> Option<Sign> {
        let (c, _) = numbers::<T>(planes, self.0);
        let (q, sign) = numbers::<T>(planes, self.1);
        // A point of the first one: z / (u² + v²) along its normal.
        let dot = q[0].times(&c[0]).plus(&q[1].times(&c[1])).times(&c[2]);
        let square = c[0].times(&c[0]).plus(&c[1].times(&c[1]));
        Some(dot.minus(&q[2].times(&square)).sign()? * sign?)
    }
}

/// Whether straight down on a plane leads to the positive side of a line.
struct Sinking<'a>(&'a Line, PlaneId);

impl Question for Sinking<'_> {
    fn ask<T: Rung>(&self, planes: &Planes) -> Option<Sign> {
        let ([u, v, _], sign) = numbers::<T>(planes, self.0);
        let plane = T::plane(planes, self.1);
        let dot = u.times(&plane.a).plus(&v.times(&plane.b));
        Some(-(dot.sign()? * sign?))
    }
}

impl Planes {
    /// On which side of a line a corner is.
    pub(crate) fn side_of_line(&self, corner: &CellCorner, line: &Line) -> Sign {
        self.decide(&Beside(corner, line))
    }

    /// On which side of a line a place is.
    pub(crate) fn place_beside(&self, place: &Place, line: &Line) -> Sign {
        self.decide(&PlaceBeside(place, line))
    }

    /// Compares where a cut crosses two lines.
    pub(crate) fn compare_on_cut(&self, cut: &Line, p: &Line, q: &Line) -> Ordering {
        self.decide(&Order(cut, p, q)).ordering()
    }

    /// Whether going along a cut one gets to the positive side of a line, or the negative one; zero if neither.
    pub(crate) fn slope_on_cut(&self, cut: &Line, line: &Line) -> Sign {
        self.decide(&Slope(cut, line))
    }

    /// On which side of a line a cut is that never crosses it.
    pub(crate) fn side_of_cut(&self, cut: &Line, line: &Line) -> Sign {
        self.decide(&Constant(cut, line))
    }

    /// On which side of a cut straight down on a plane is.
    pub(crate) fn sinks_to(&self, cut: &Line, plane: PlaneId) -> Sign {
        self.decide(&Sinking(cut, plane))
    }

    /// Bounds of the coordinates of a corner, in the input's units.
    pub(crate) fn bounds_of(&self, corner: &CellCorner) -> [[f64; 2]; 2] {
        let [x, y, w] = point::<Ball>(self, corner);
        let scaled = |x: f64| ldexp(x, self.unit + self.shift);
        [(x, 0), (y, 1)].map(|(p, axis)| {
            let at = p.div(&w);
            if !at.error().is_finite() {
                return [f64::NEG_INFINITY, f64::INFINITY];
            }
            let origin = self.origin[axis];
            let low = (scaled(at.lower()).next_down() + origin).next_down();
            let high = (scaled(at.upper()).next_up() + origin).next_up();
            if low.is_finite() && high.is_finite() {
                [low, high]
            } else {
                [f64::NEG_INFINITY, f64::INFINITY]
            }
        })
    }
}

/// `[x, y, w]` in machine integers that are f64 numbers, too, if they fit.
pub(super) fn small(parts: [&IBig; 3]) -> Option<[i64; 3]> {
    let small = |x: &IBig| i64::try_from(x).ok().filter(|x| x.abs() < 1 << 53);
    let [x, y, w] = parts;
    Some([small(x)?, small(y)?, small(w)?])
}
