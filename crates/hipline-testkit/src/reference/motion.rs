//! How wavefront vertices move: exact linear functions of time.

use std::cmp::Ordering;

use dashu_int::IBig;

use super::heading::{cross, dot};
use super::model::Plane;
use super::number::{Field, Num};
use super::ratio::Ratio;

/// The place `(at + velocity * t) / over` at time t; `over` is positive.
#[derive(Debug, Clone)]
pub(super) struct Motion {
    pub at: [Num; 2],
    pub velocity: [Num; 2],
    pub over: Num,
}

/// A place, also with a common denominator.
#[derive(Debug, Clone)]
pub(super) struct Point {
    pub coordinates: [Ratio; 2],
    pub tops: [Num; 2],
    pub bottom: Num,
}

impl Motion {
    /// Where the planes of two faces that are not parallel intersect.
    pub(super) fn meet(field: &Field, i: &Plane, j: &Plane) -> Self {
        let ([ai, bi], [aj, bj]) = (&i.normal, &j.normal);
        let m = cross(field, &i.normal, &j.normal);
        let solve = |i: &Num, j: &Num| {
            let by = |p: &Num, b: &Num, q: &Num, a: &Num| field.mul(p, b).minus(&field.mul(q, a));
            [by(i, bj, j, bi), by(j, ai, i, aj)]
        };
        let levels = solve(&i.level, &j.level);
        let rates = solve(&i.rate, &j.rate);
        Self {
            at: levels,
            velocity: rates,
            over: m,
        }
        .reduced(field)
    }

    /// It leaves `point` at `time`, perpendicular to the face's edge, with its speed: the foot of a
    /// ghost arc, or the end of an edge both sides of which stand still.
    pub(super) fn ghost(field: &Field, face: &Plane, point: &Point, time: &Ratio) -> Self {
        let (tn, td) = time.parts();
        let scale = td.times(&face.square);
        let speed = field.mul(&face.rate, &point.bottom);
        let late = field.mul(&speed, tn);
        let fast = field.mul(&speed, td);
        let at = [0, 1].map(|k| {
            field
                .mul(&point.tops[k], &scale)
                .minus(&field.mul(&late, &face.normal[k]))
        });
        let velocity = [0, 1].map(|k| field.mul(&fast, &face.normal[k]));
        Self {
            at,
            velocity,
            over: field.mul(&point.bottom, &scale),
        }
        .reduced(field)
    }

    /// Positive denominator, no common factor.
    fn reduced(mut self, field: &Field) -> Self {
        let negative = field.sign(&self.over) == Ordering::Less;
        let [at_x, at_y] = &mut self.at;
        let [velocity_x, velocity_y] = &mut self.velocity;
        let mut parts = [at_x, at_y, velocity_x, velocity_y, &mut self.over];
        let mut gcd = parts
            .iter()
            .rev()
            .fold(IBig::ZERO, |gcd, part| part.content(gcd));
        if negative {
            gcd = -gcd;
        }
        if gcd != IBig::ONE {
            parts.iter_mut().for_each(|part| part.shrink(&gcd));
        }
        self
    }

    /// One coordinate at a time.
    pub(super) fn coordinate(&self, field: &Field, axis: usize, time: &Ratio) -> Ratio {
        let (tn, td) = time.parts();
        let top = field
            .mul(&self.at[axis], td)
            .plus(&field.mul(&self.velocity[axis], tn));
        Ratio::over_positive(field, top, field.mul(&self.over, td))
    }

    /// The place at a time.
    pub(super) fn point(&self, field: &Field, time: &Ratio) -> Point {
        let (tn, td) = time.parts();
        let tops = [0, 1].map(|k| {
            field
                .mul(&self.at[k], td)
                .plus(&field.mul(&self.velocity[k], tn))
        });
        let bottom = field.mul(&self.over, td);
        let coordinates = tops
            .clone()
            .map(|top| Ratio::over_positive(field, top, bottom.clone()));
        Point {
            coordinates,
            tops,
            bottom,
        }
    }

    /// When the place is on the plane of a face; `None` for never or always.
    pub(super) fn reaches(&self, field: &Field, face: &Plane) -> Option<Ratio> {
        let [a, b] = &face.normal;
        let gap = field
            .mul(&self.over, &face.level)
            .minus(&field.mul(&self.at[0], a))
            .minus(&field.mul(&self.at[1], b));
        let closing = dot(field, &self.velocity, &face.normal);
        Ratio::new(
            field,
            gap,
            closing.minus(&field.mul(&self.over, &face.rate)),
        )
    }

    /// When two places on the plane of one face coincide; `None` for never or always.
    pub(super) fn joins(&self, field: &Field, other: &Self, face: &Plane) -> Option<Ratio> {
        let axis = usize::from(face.direction[0].is_zero());
        let gap = field
            .mul(&other.at[axis], &self.over)
            .minus(&field.mul(&self.at[axis], &other.over));
        let closing = field
            .mul(&self.velocity[axis], &other.over)
            .minus(&field.mul(&other.velocity[axis], &self.over));
        Ratio::new(field, gap, closing)
    }

    /// The velocity along one axis.
    pub(super) fn speed(&self, field: &Field, axis: usize) -> Ratio {
        Ratio::over_positive(field, self.velocity[axis].clone(), self.over.clone())
    }
}

impl Point {
    /// An integer point.
    pub(super) fn integer(point: &[IBig; 2]) -> Self {
        Self {
            coordinates: [0, 1].map(|k| Ratio::integer(&point[k])),
            tops: point.clone().map(Num::from),
            bottom: IBig::ONE.into(),
        }
    }

    /// By x, then by y.
    pub(super) fn compare(&self, other: &Self, field: &Field) -> Ordering {
        let by = |k: usize| self.coordinates[k].compare(&other.coordinates[k], field);
        by(0).then_with(|| by(1))
    }
}
