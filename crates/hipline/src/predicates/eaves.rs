//! Tilted eaves: edges whose ends have different heights.
//!
//! Such an edge stands still, as a wall, until the wavefront's time has reached the height of its lower end. From there
//! on its facet's wavefront edge sweeps the plane through the tilted eave, and one of its
//! ends runs up along the eave. With `d = q - p`, `L = |d|`, `n` its left normal,
//! `dh` the rise from p to q and w the speed across (the slope is 1/w), that plane is
//!
//! ```text
//! (w dh d + R n) (x - p) = w L^2 (t - h_p),     R = sqrt(L^2 - w^2 dh^2)
//! ```
//!
//! because its gradient has the component `dh / L` along the eave and the length `1 / w`.
//! So here too there is one root to an edge; but the normal holds it as well.

use dashu_int::{IBig, UBig, ops::UnsignedAbs};
use hipline_num::{BallDd, in_units};

use super::lines::Line;
use super::planes::{Plane, PlaneId, Planes, Rung};
use crate::{input::Figure, topology::EdgeId};

/// A side of an edge whose ends have different heights.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Eave {
    /// The edge.
    pub edge: EdgeId,
    /// Its plane until its own time: upright.
    pub wall: PlaneId,
    /// The plane of its facet.
    pub facet: PlaneId,
    /// Whether the lower end is the start of its wavefront edge.
    pub rises: bool,
    /// The height of the lower end.
    pub from: f64,
    /// The height of the other end.
    pub to: f64,
    /// Upright planes across the edge through the start and the end of its wavefront edge.
    pub posts: [PlaneId; 2],
}

impl Eave {
    /// The upright plane across the edge through its lower end.
    pub(crate) fn low_post(&self) -> PlaneId {
        self.posts[usize::from(!self.rises)]
    }
}

/// `a`, `b`, `c` as `plain + root * sqrt(radicand)`.
#[derive(Debug, Clone)]
pub(crate) struct Tilted {
    plain: [IBig; 3],
    root: [IBig; 3],
    radicand: UBig,
    s: IBig,
}

impl Tilted {
    /// The plane in the numbers of a rung, given the root.
    fn shifted<T: Rung>(&self, root: &T, shifts: [i32; 2]) -> Plane<T> {
        let [shift, speed_shift] = shifts;
        let part = |k: usize| {
            let digits = if k == 2 { 3 * shift } else { 2 * shift };
            T::integer(&self.plain[k], digits)
                .plus(&T::integer(&self.root[k], digits - shift).times(root))
        };
        Plane {
            a: part(0),
            b: part(1),
            c: part(2),
            s: T::integer(&self.s, 2 * shift + speed_shift),
        }
    }

    /// The plane in exact numbers or in many digits, whose root is given.
    pub(super) fn plane<T: Rung>(&self, root: &T) -> Plane<T> {
        self.shifted(root, [0, 0])
    }

    /// The radicand of its root.
    pub(super) const fn radicand(&self) -> &UBig {
        &self.radicand
    }
}

impl Planes {
    /// The planes of tilted eaves and of the posts at their ends. The speeds of facets come
    /// with them.
    pub(super) fn add_eaves(&mut self, figure: &Figure, speed_unit: i32, speed_shift: i32) {
        let eaves = self.phases.eaves().to_vec();
        let place = |v: usize| {
            [0, 1].map(|k| {
                in_units(figure.vertices()[v][k], self.unit) - in_units(self.origin[k], self.unit)
            })
        };
        let time_unit = self.unit - speed_unit;
        let ends: Vec<[[IBig; 2]; 2]> = eaves
            .iter()
            .map(|eave| {
                let edge = figure.edges()[eave.edge.index()];
                let mut ends = [edge.from, edge.to].map(|v| place(v.index()));
                if eave.wall.0 & 1 == 1 {
                    ends.reverse();
                }
                ends
            })
            .collect();
        for (eave, [p, q]) in eaves.iter().zip(&ends) {
            let speed = figure.edges()[eave.edge.index()].speeds[(eave.wall.0 & 1) as usize];
            let w = in_units(speed, speed_unit);
            let [mut h, mut k] = [eave.from, eave.to].map(|h| in_units(h, time_unit));
            if !eave.rises {
                std::mem::swap(&mut h, &mut k);
            }
            let rise = k - &h;
            let d = [&q[0] - &p[0], &q[1] - &p[1]];
            let square = &d[0] * &d[0] + &d[1] * &d[1];
            let steep = &w * &rise;
            let along = [&steep * &d[0], &steep * &d[1]];
            let across = [-&d[1], d[0].clone()];
            let dot = |v: &[IBig; 2]| &v[0] * &p[0] + &v[1] * &p[1];
            let s = &w * &square;
            let tilted = Tilted {
                plain: [along[0].clone(), along[1].clone(), dot(&along) - &s * &h],
                root: [across[0].clone(), across[1].clone(), dot(&across)],
                radicand: (square - &steep * &steep).unsigned_abs(),
                s,
            };
            let root = BallDd::integer(&IBig::from(tilted.radicand.clone()), 2 * self.shift).sqrt();
            let Plane { a, b, c, s } = tilted.shifted::<BallDd>(&root, [self.shift, speed_shift]);
            let doubles = [a, b, c, s];
            self.push_near(doubles);
            self.lines.push(Line::Tilted(Box::new(tilted)));
        }
        for ends in ends {
            let d = [0, 1].map(|k| &ends[1][k] - &ends[0][k]);
            for end in &ends {
                self.push_big(d[0].clone(), d[1].clone(), end);
            }
        }
    }
}

/// A tilted plane from the tables.
pub(super) fn tabled<T: Clone>([a, b, c, s]: &[T; 4]) -> Plane<T> {
    Plane {
        a: a.clone(),
        b: b.clone(),
        c: c.clone(),
        s: s.clone(),
    }
}
