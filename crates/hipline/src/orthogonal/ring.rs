//! The ring as the engine walks along it: counterclockwise, from the corner furthest west and north.
//!
//! Edge (and face, and *wave*) c goes from corner c to corner c + 1. The first ones are the lower chain,
//! from the westernmost wall down and along to the top of the easternmost one; the others the upper
//! chain, from east to west.

use super::number::{Number, Unit};
use crate::input::{Figure, Monotone};

/// Which chain, and so which way is up for it: each chain is computed as if it were the lower one.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Side {
    Lower,
    Upper,
}

/// Where a wavefront edge moves to, seen from its chain.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Kind {
    /// Up: a horizontal edge.
    Level,
    /// East: the chain goes down here.
    East,
    /// West: the chain goes up here.
    West,
}

/// A place, seen from a chain.
pub(super) type Spot<N> = (N, N);

/// The ring, turned so that it is monotone in the direction of the x axis.
#[derive(Debug)]
pub(super) struct Ring<'a> {
    points: &'a [[f64; 2]],
    unit: Unit,
    /// The vertex at corner 0.
    first: usize,
    forward: bool,
    /// Whether x and y of the figure are y and -x here.
    turned: bool,
    /// The number of edges of the lower chain.
    pub lower: u32,
    pub kinds: Vec<Kind>,
}

impl<'a> Ring<'a> {
    pub(super) fn new(figure: &'a Figure, monotone: &Monotone, unit: Unit) -> Self {
        let points = figure.vertices();
        let n = points.len();
        let [first, last] = [monotone.west[0].index(), monotone.east[1].index()];
        let lower = if monotone.counterclockwise {
            (last + n - first) % n
        } else {
            (first + n - last) % n
        };
        let mut ring = Self {
            points,
            unit,
            first,
            forward: monotone.counterclockwise,
            turned: monotone.across[1][1] == 0.0,
            lower: lower as u32,
            kinds: Vec::new(),
        };
        ring.kinds = ring.find_kinds();
        ring
    }

    fn find_kinds(&self) -> Vec<Kind> {
        let mut kinds = Vec::with_capacity(self.points.len());
        let height = |c: u32| {
            let [x, y] = self.points[self.vertex(c) as usize];
            if self.turned { -x } else { y }
        };
        let mut here = height(0);
        for c in 0..self.count() {
            let there = height(c + 1);
            kinds.push(if there < here {
                Kind::East
            } else if there > here {
                Kind::West
            } else {
                Kind::Level
            });
            here = there;
        }
        kinds
    }

    /// The number of corners.
    #[inline]
    pub(super) fn count(&self) -> u32 {
        self.points.len() as u32
    }

    /// The vertex at a corner, which may also be the number of corners.
    #[inline]
    pub(super) fn vertex(&self, corner: u32) -> u32 {
        let n = self.points.len();
        let corner = corner as usize;
        let vertex = if self.forward {
            let v = self.first + corner;
            if v < n { v } else { v - n }
        } else if corner <= self.first {
            self.first - corner
        } else {
            self.first + n - corner
        };
        vertex as u32
    }

    /// The figure's edge of a wave.
    #[inline]
    pub(super) fn edge(&self, wave: u32) -> u32 {
        self.vertex(if self.forward { wave } else { wave + 1 })
    }

    /// The wave of a figure's edge.
    #[inline]
    pub(super) fn wave(&self, edge: u32) -> u32 {
        let n = self.points.len();
        let edge = edge as usize;
        let wave = if self.forward {
            edge + n - self.first
        } else {
            self.first + n - 1 - edge
        };
        (if wave < n { wave } else { wave - n }) as u32
    }

    #[inline]
    pub(super) fn kind(&self, wave: u32) -> Kind {
        self.kinds[wave as usize]
    }

    #[inline]
    pub(super) fn side(&self, wave: u32) -> Side {
        if wave < self.lower {
            Side::Lower
        } else {
            Side::Upper
        }
    }

    /// Where a vertex is, seen from the lower chain.
    #[inline]
    pub(super) fn place<N: Number>(&self, vertex: u32) -> Spot<N> {
        let [x, y] = self.points[vertex as usize];
        let (x, y) = (N::count(&self.unit, x), N::count(&self.unit, y));
        if self.turned { (y, -x) } else { (x, y) }
    }

    /// The vertex where a wave starts, going from west to east (up or down where that is no matter).
    #[inline]
    pub(super) fn west_end(&self, wave: u32) -> u32 {
        self.vertex(match self.side(wave) {
            Side::Lower => wave,
            Side::Upper => wave + 1,
        })
    }

    /// The ends of a wave, from west to east.
    #[inline]
    pub(super) fn base(&self, wave: u32) -> [u32; 2] {
        let ends = [self.vertex(wave), self.vertex(wave + 1)];
        match self.side(wave) {
            Side::Lower => ends,
            Side::Upper => [ends[1], ends[0]],
        }
    }

    /// The figure's vertices.
    pub(super) const fn points(&self) -> &'a [[f64; 2]] {
        self.points
    }

    /// The waves of a chain from west to east: the first, and the one after the last.
    pub(super) fn chain(&self, side: Side) -> Chain {
        match side {
            Side::Lower => Chain {
                wave: 0,
                left: self.lower,
                side,
            },
            Side::Upper => Chain {
                wave: self.count() - 1,
                left: self.count() - self.lower,
                side,
            },
        }
    }

    /// The coordinates of the figure at a place.
    pub(super) fn round<N: Number>(&self, (x, y): Spot<N>) -> [f64; 2] {
        let (x, y) = if self.turned { (-y, x) } else { (x, y) };
        [x.value(&self.unit), y.value(&self.unit)]
    }

    /// A time of the figure.
    pub(super) fn round_time<N: Number>(&self, time: N) -> f64 {
        time.value(&self.unit)
    }

    /// Whether edges go the way that corners are counted.
    pub(super) const fn is_forward(&self) -> bool {
        self.forward
    }
}

/// Goes along a chain from west to east.
#[derive(Debug, Clone)]
pub(super) struct Chain {
    wave: u32,
    left: u32,
    side: Side,
}

impl Iterator for Chain {
    type Item = u32;

    fn next(&mut self) -> Option<u32> {
        self.left = self.left.checked_sub(1)?;
        let wave = self.wave;
        self.wave = match self.side {
            Side::Lower => wave.wrapping_add(1),
            Side::Upper => wave.wrapping_sub(1),
        };
        Some(wave)
    }
}
