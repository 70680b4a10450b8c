//! The directions of arcs, and their order around a node.

use hipline_num::Sign;
use std::cmp::Ordering;

use super::{
    decide::Question,
    expression::Path,
    planes::{PlaneId, Planes, Rung},
};

/// A direction, by definition.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Course {
    /// That of the vertex between two planes, the first turning left into the second.
    Moving([PlaneId; 2]),
    /// That of a plane's wavefront edge.
    Along(PlaneId),
    /// That in which a plane's wavefront edge moves.
    Normal(PlaneId),
}

impl Course {
    /// A vector of this direction.
    fn vector<T: Rung>(self, planes: &Planes) -> [T; 2] {
        match self {
            Self::Moving(pair) => {
                let Path {
                    x: [_, x],
                    y: [_, y],
                    ..
                } = Path::<T>::new(planes, pair);
                [x, y]
            }
            Self::Along(plane) => {
                let plane = T::plane(planes, plane);
                [plane.b, plane.a.negated()]
            }
            Self::Normal(plane) => {
                let plane = T::plane(planes, plane);
                [plane.a, plane.b]
            }
        }
    }
}

/// A direction and what orders it among others.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Heading {
    course: Course,
    reversed: bool,
    /// Whether the angle to the x axis is below 180 degrees.
    upper: bool,
}

impl Heading {
    /// The opposite direction.
    pub(crate) const fn reversed(self) -> Self {
        Self {
            reversed: !self.reversed,
            upper: !self.upper,
            ..self
        }
    }
}

/// A coordinate of a direction.
struct Component(Course, usize);

impl Question for Component {
    fn ask<T: Rung>(&self, planes: &Planes) -> Option<Sign> {
        self.0.vector::<T>(planes)[self.1].sign()
    }
}

/// The cross product of two directions.
struct Cross(Course, Course);

impl Question for Cross {
    fn ask<T: Rung>(&self, planes: &Planes) -> Option<Sign> {
        let [x, y] = self.0.vector::<T>(planes);
        let [u, v] = self.1.vector::<T>(planes);
        x.times(&v).minus(&y.times(&u)).sign()
    }
}

impl Planes {
    /// A direction.
    pub(crate) fn heading(&self, course: Course) -> Heading {
        let sign = match self.decide(&Component(course, 1)) {
            Sign::Zero => self.decide(&Component(course, 0)),
            sign => sign,
        };
        Heading {
            course,
            reversed: false,
            upper: sign == Sign::Positive,
        }
    }

    /// Compares two directions by their angles to the x axis, from 0 to 360 degrees.
    pub(crate) fn compare_headings(&self, p: &Heading, q: &Heading) -> Ordering {
        if p.upper != q.upper {
            return q.upper.cmp(&p.upper);
        }
        if p.course == q.course && p.reversed == q.reversed {
            return Ordering::Equal;
        }
        let cross = self.decide(&Cross(p.course, q.course));
        let left = if p.reversed == q.reversed {
            cross
        } else {
            -cross
        };
        left.ordering().reverse()
    }
}
