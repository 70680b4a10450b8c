//! Triangles two of whose corners meet.
//!
//! With u and v at one place at the time T, the area over time is `(v - u) x (w - u)`, whose factor `v - u` is zero
//! at T, so its slope there is `(v' - u') x (w(T) - u(T))`: much less than the slope of a polynomial that is
//! known by its coefficients.

use hipline_num::Sign;

use super::{
    decide::Question,
    expression::{Corner, Path, meeting},
    moment::Moment,
    planes::{PlaneId, Planes, Rung},
};

/// The slope of the area of u, v, w when u and v meet, which is when three planes do.
struct Slope {
    meeting: [PlaneId; 3],
    u: [PlaneId; 2],
    v: [PlaneId; 2],
    w: Corner,
}

/// The velocity of v as u sees it, times a positive number.
fn drift<T: Rung>(u: &Path<T>, v: &Path<T>) -> [T; 2] {
    let along = |x: &[T; 2], y: &[T; 2]| y[1].times(&u.m).minus(&x[1].times(&v.m));
    [along(&u.x, &v.x), along(&u.y, &v.y)]
}

impl Question for Slope {
    fn ask<T: Rung>(&self, planes: &Planes) -> Option<Sign> {
        let [u, v] = [self.u, self.v].map(|pair| Path::<T>::new(planes, pair));
        let w = Path::<T>::of(planes, self.w);
        let (n, d) = meeting::<T>(planes, self.meeting);
        // Places at the time -n / d, times d.
        let at = |z: &[T; 2]| z[0].times(&d).minus(&z[1].times(&n));
        let beyond = |x: &[T; 2], z: &[T; 2]| at(z).times(&u.m).minus(&at(x).times(&w.m));
        let (x, y) = (beyond(&u.x, &w.x), beyond(&u.y, &w.y));
        let [dx, dy] = drift(&u, &v);
        let slope = dx.times(&y).minus(&dy.times(&x)).sign()?;
        Some(if slope.is_zero() {
            slope
        } else {
            slope * d.sign()?
        })
    }
}

/// How the distance from u to v, both on a plane, changes along the wavefront edge's direction.
struct Growth {
    u: [PlaneId; 2],
    v: [PlaneId; 2],
    plane: PlaneId,
}

impl Question for Growth {
    fn ask<T: Rung>(&self, planes: &Planes) -> Option<Sign> {
        let [u, v] = [self.u, self.v].map(|pair| Path::<T>::new(planes, pair));
        let [dx, dy] = drift(&u, &v);
        let plane = T::plane(planes, self.plane);
        // Its left normal is (a, b).
        dx.times(&plane.b).minus(&dy.times(&plane.a)).sign()
    }
}

impl Planes {
    /// The sign of the slope of the area of three corners at the moment when the first two of
    /// them meet: three planes that have exactly one point in common then.
    pub(crate) fn slope_at_meeting(
        &self,
        meeting: [PlaneId; 3],
        u: [PlaneId; 2],
        v: [PlaneId; 2],
        w: Corner,
    ) -> Sign {
        if let Corner::Finite(pair) = w
            && let Some(&plane) = u.iter().find(|plane| v.contains(plane))
        {
            // They meet along a wavefront edge, and w is on one side of it.
            let lead = self.lead(&Moment::of_planes(meeting), pair, plane);
            return if lead.is_zero() {
                lead
            } else {
                lead * self.decide(&Growth { u, v, plane })
            };
        }
        self.decide(&Slope { meeting, u, v, w })
    }
}
