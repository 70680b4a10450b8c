//! The determinants that every predicate is made of, written once for all rungs.
//!
//! Derivations: `docs/derivations.md`, section 2.

use super::planes::{Plane, PlaneId, Planes, Rung};

/// `a_i b_j - a_j b_i`: positive where the wavefront turns left from i to j.
#[inline]
pub(crate) fn minor<T: Rung>(i: &Plane<T>, j: &Plane<T>) -> T {
    i.a.times(&j.b).minus(&j.a.times(&i.b))
}

/// `(N, D)` with `t = -N / D` the moment when three planes meet:
/// `N = det [a b c]`, `D = det [a b s]`.
#[inline]
pub(crate) fn meeting<T: Rung>(planes: &Planes, triple: [PlaneId; 3]) -> (T, T) {
    T::meeting(planes, triple)
}

/// [`meeting`], of whatever planes there are.
#[inline]
pub(super) fn any_meeting<T: Rung>(planes: &Planes, [i, j, k]: [PlaneId; 3]) -> (T, T) {
    let [i, j, k] = [
        T::plane(planes, i),
        T::plane(planes, j),
        T::plane(planes, k),
    ];
    let (jk, ki, ij) = (minor(&j, &k), minor(&k, &i), minor(&i, &j));
    (
        jk.times(&i.c).plus(&ki.times(&j.c)).plus(&ij.times(&k.c)),
        jk.times(&i.s).plus(&ki.times(&j.s)).plus(&ij.times(&k.s)),
    )
}

/// The motion of a wavefront vertex in homogeneous coordinates:
/// `x = (x[0] + x[1] t) / m`, `y = (y[0] + y[1] t) / m`, `m > 0`; for a point at infinity
/// `m = 0`.
pub(crate) struct Path<T> {
    pub x: [T; 2],
    pub y: [T; 2],
    pub m: T,
}

impl<T: Rung> Path<T> {
    /// The intersection of two planes.
    #[inline]
    pub(crate) fn new(planes: &Planes, [i, j]: [PlaneId; 2]) -> Self {
        let (i, j) = (T::plane(planes, i), T::plane(planes, j));
        Self {
            x: [
                i.c.times(&j.b).minus(&j.c.times(&i.b)),
                i.s.times(&j.b).minus(&j.s.times(&i.b)),
            ],
            y: [
                i.a.times(&j.c).minus(&j.a.times(&i.c)),
                i.a.times(&j.s).minus(&j.a.times(&i.s)),
            ],
            m: minor(&i, &j),
        }
    }

    /// A corner of a triangle.
    #[inline]
    pub(crate) fn of(planes: &Planes, corner: Corner) -> Self {
        match corner {
            Corner::Finite(pair) => Self::new(planes, pair),
            Corner::Ideal(direction) => {
                let [x, y] = direction.vector();
                Self {
                    x: [T::from_i64(x), T::zero()],
                    y: [T::from_i64(y), T::zero()],
                    m: T::zero(),
                }
            }
        }
    }
}

/// A corner of a kinetic triangle, as predicates see it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Corner {
    /// The intersection of two planes, the first turning left into the second.
    Finite([PlaneId; 2]),
    /// A point at infinity.
    Ideal(Direction),
}

/// One of the four points at infinity that frame the triangulation of the exterior.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Direction {
    East,
    North,
    West,
    South,
}

impl Direction {
    pub(crate) const ALL: [Self; 4] = [Self::East, Self::North, Self::West, Self::South];

    pub(crate) const fn vector(self) -> [i64; 2] {
        match self {
            Self::East => [1, 0],
            Self::North => [0, 1],
            Self::West => [-1, 0],
            Self::South => [0, -1],
        }
    }
}

/// `f[0] + f[1] t + f[2] t^2`.
pub(crate) type Quadratic<T> = [T; 3];

#[inline]
fn cross<T: Rung>(p: &Path<T>, q: &Path<T>) -> Quadratic<T> {
    [
        p.x[0].times(&q.y[0]).minus(&q.x[0].times(&p.y[0])),
        p.x[0]
            .times(&q.y[1])
            .plus(&p.x[1].times(&q.y[0]))
            .minus(&q.x[0].times(&p.y[1]).plus(&q.x[1].times(&p.y[0]))),
        p.x[1].times(&q.y[1]).minus(&q.x[1].times(&p.y[1])),
    ]
}

/// The area of a triangle over time, times a positive number.
pub(crate) fn area<T: Rung>(planes: &Planes, corners: [Corner; 3]) -> Quadratic<T> {
    let [u, v, w] = corners.map(|c| Path::<T>::of(planes, c));
    let [vw, wu, uv] = [cross(&v, &w), cross(&w, &u), cross(&u, &v)];
    [0, 1, 2].map(|k| {
        vw[k]
            .times(&u.m)
            .plus(&wu[k].times(&v.m))
            .plus(&uv[k].times(&w.m))
    })
}

/// A number with the sign of a triangle's area when three planes meet: at t = -n / d a corner is at
/// `(X / d, Y / d, m)` in homogeneous coordinates, with `X = x0 d - x1 n`. It has a
/// smaller degree than the value of [`area`], of which most factors cancel.
pub(crate) fn area_at<T: Rung>(planes: &Planes, corners: [Corner; 3], triple: [PlaneId; 3]) -> T {
    let (n, d) = meeting::<T>(planes, triple);
    let [u, v, w] = corners.map(|corner| {
        let Path { x, y, m } = Path::<T>::of(planes, corner);
        let at = |z: &[T; 2]| z[0].times(&d).minus(&z[1].times(&n));
        (at(&x), at(&y), m)
    });
    determinant([&u, &v, &w])
}

fn determinant<T: Rung>([u, v, w]: [&(T, T, T); 3]) -> T {
    let cross = |p: &(T, T, T), q: &(T, T, T)| p.0.times(&q.1).minus(&q.0.times(&p.1));
    cross(v, w)
        .times(&u.2)
        .plus(&cross(w, u).times(&v.2))
        .plus(&cross(u, v).times(&w.2))
}

/// The last coefficient of [`area`].
pub(crate) fn curvature<T: Rung>(planes: &Planes, corners: [Corner; 3]) -> T {
    let [u, v, w] = corners.map(|corner| {
        let Path { x, y, m } = Path::<T>::of(planes, corner);
        let ([_, x], [_, y]) = (x, y);
        (x, y, m)
    });
    determinant([&u, &v, &w])
}

/// How far a vertex is ahead of a plane over time, times a positive number: linear.
#[inline]
pub(crate) fn lead<T: Rung>(planes: &Planes, [i, j]: [PlaneId; 2], plane: PlaneId) -> [T; 2] {
    let (n, d) = meeting::<T>(planes, [plane, i, j]);
    [n.negated(), d.negated()]
}

/// `x_u - x_v` (or y) over time, times a positive number: linear.
pub(crate) fn difference<T: Rung>(
    planes: &Planes,
    u: [PlaneId; 2],
    v: [PlaneId; 2],
    ordinate: bool,
) -> [T; 2] {
    let (u, v) = (Path::<T>::new(planes, u), Path::<T>::new(planes, v));
    if ordinate {
        apart(&u.y, &u.m, &v.y, &v.m)
    } else {
        apart(&u.x, &u.m, &v.x, &v.m)
    }
}

/// Both differences, times the same positive number.
pub(crate) fn differences<T: Rung>(
    planes: &Planes,
    u: [PlaneId; 2],
    v: [PlaneId; 2],
) -> [[T; 2]; 2] {
    let (u, v) = (Path::<T>::new(planes, u), Path::<T>::new(planes, v));
    [apart(&u.x, &u.m, &v.x, &v.m), apart(&u.y, &u.m, &v.y, &v.m)]
}

#[inline]
fn apart<T: Rung>(p: &[T; 2], m: &T, q: &[T; 2], n: &T) -> [T; 2] {
    [0, 1].map(|k| p[k].times(n).minus(&q[k].times(m)))
}
