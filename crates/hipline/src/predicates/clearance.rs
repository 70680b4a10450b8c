//! Two arcs that cross in plan: which one is higher there?
//!
//! The plan of an arc of planes f and g lies where their times agree, `T = (a x + b y - c) / s`. So the
//! crossing of two such lines is rational in the planes' coefficients, and the times of any two of the four planes
//! are compared there directly.

use hipline_num::Sign;

use super::{
    decide::Question,
    planes::{PlaneId, Planes, Rung},
};

/// `[u, v, z]` of the line `u x + v y = z` on which two planes have the same time.
fn agreement<T: Rung>(planes: &Planes, pair: [PlaneId; 2]) -> [T; 3] {
    let [f, g] = pair.map(|id| T::plane(planes, id));
    let mixed = |p: &T, q: &T| p.times(&g.s).minus(&q.times(&f.s));
    [mixed(&f.a, &g.a), mixed(&f.b, &g.b), mixed(&f.c, &g.c)]
}

/// The sign of the time on the first pair minus that on the second one, where they cross in plan.
struct Clearance([PlaneId; 2], [PlaneId; 2]);

impl Question for Clearance {
    fn ask<T: Rung>(&self, planes: &Planes) -> Option<Sign> {
        let [u, v, z] = agreement::<T>(planes, self.0);
        let [p, q, r] = agreement::<T>(planes, self.1);
        let x = z.times(&q).minus(&r.times(&v));
        let y = u.times(&r).minus(&p.times(&z));
        let w = u.times(&q).minus(&p.times(&v));
        let [f, g] = [self.0[0], self.1[0]].map(|id| T::plane(planes, id));
        let mixed = |a: &T, b: &T| a.times(&g.s).minus(&b.times(&f.s));
        let value = (mixed(&f.a, &g.a).times(&x))
            .plus(&mixed(&f.b, &g.b).times(&y))
            .minus(&mixed(&f.c, &g.c).times(&w));
        Some(value.sign()? * w.sign()?)
    }
}

impl Planes {
    /// Where the arcs of two pairs of planes cross in plan: the sign of the time on the first minus that on
    /// the second one. Their lines must not be parallel in plan.
    pub(crate) fn clearance(&self, over: [PlaneId; 2], under: [PlaneId; 2]) -> Sign {
        self.decide(&Clearance(over, under))
    }
}
