//! How two planes lie to each other, whatever the moment.

use hipline_num::{Rough, Sign};

use super::{
    decide::Question,
    expression::{Direction, Quadratic, minor},
    moment::{Closing, Curve, Moment, SignAt},
    planes::{Plane, PlaneId, Planes, Rung},
};

/// The sine (up to a positive factor) or cosine between the normals of two planes.
struct Between(PlaneId, PlaneId, bool);

impl Curve for Between {
    const LINEAR: bool = true;
    #[inline]
    fn coefficients<T: Rung>(&self, planes: &Planes) -> Option<Quadratic<T>> {
        let (i, j) = (T::plane(planes, self.0), T::plane(planes, self.1));
        let value = if self.2 {
            i.a.times(&j.a).plus(&i.b.times(&j.b))
        } else {
            minor(&i, &j)
        };
        Some([value, T::zero(), T::zero()])
    }
}

/// The component of a plane's normal in a direction.
struct Heading(PlaneId, Direction);

impl Curve for Heading {
    const LINEAR: bool = true;
    fn coefficients<T: Rung>(&self, planes: &Planes) -> Option<Quadratic<T>> {
        let plane = T::plane(planes, self.0);
        let [dx, dy] = self.1.vector().map(T::from_i64);
        Some([plane.away(&dx, &dy), T::zero(), T::zero()])
    }
}

/// A minor of the coefficients of two planes, of two columns of `a b c s`; zero for all
/// columns if and only if the planes are one.
struct Minor(PlaneId, PlaneId, [usize; 2]);

impl Curve for Minor {
    const LINEAR: bool = true;
    fn coefficients<T: Rung>(&self, planes: &Planes) -> Option<Quadratic<T>> {
        let [i, j] = [self.0, self.1].map(|id| {
            let Plane { a, b, c, s } = T::plane(planes, id);
            [a, b, c, s]
        });
        let [p, q] = self.2;
        let value = i[p].times(&j[q]).minus(&j[p].times(&i[q]));
        Some([value, T::zero(), T::zero()])
    }
}

impl Planes {
    /// Whether two planes, one of them of a later phase, are the same.
    pub(super) fn are_one(&self, i: PlaneId, j: PlaneId) -> bool {
        let vanishes = |columns| self.sign_of(&Minor(i, j, columns)).is_zero();
        [[0, 1], [0, 2], [1, 2], [0, 3], [1, 3]]
            .into_iter()
            .all(vanishes)
            && self.same_direction(i, j)
    }

    /// Whether a wavefront edge of length zero, between two others, starts to grow.
    pub(crate) fn grows(&self, [before, plane, after]: [PlaneId; 3]) -> bool {
        let turns = [self.turn(before, plane), self.turn(plane, after)];
        // On one plane with its neighbour, it goes on as one with it; a slower one it overruns.
        for (turn, other) in turns.into_iter().zip([before, after]) {
            if turn.is_zero() {
                return self.same_direction(plane, other)
                    && self.compare_speeds(plane, other).is_ge();
            }
        }
        self.sign_of(&Closing([before, plane, after])) == -(turns[0] * turns[1])
    }

    /// Whether a wavefront edge moves in a direction (zero: across it).
    pub(crate) fn heads(&self, plane: PlaneId, direction: Direction) -> Sign {
        self.sign_of(&Heading(plane, direction))
    }

    /// The turn from one wavefront edge to the next: positive to the left (convex),
    /// negative to the right (reflex), zero if they are parallel.
    #[inline]
    pub(crate) fn turn(&self, i: PlaneId, j: PlaneId) -> Sign {
        let between = Between(i, j, false);
        if let Some(sign) = SignAt(&Moment::Start, &between).ask::<Rough>(self) {
            self.count(|rungs| rungs.by_f64 += 1);
            return sign;
        }
        // Parallel, as a rule.
        match self.small_turn(i, j) {
            Some(sign) => {
                self.count(|rungs| rungs.by_exact += 1);
                sign
            }
            None => self.sign_of(&between),
        }
    }

    /// Whether two parallel planes move the same way.
    pub(crate) fn same_direction(&self, i: PlaneId, j: PlaneId) -> bool {
        self.sign_of(&Between(i, j, true)) == Sign::Positive
    }
}
