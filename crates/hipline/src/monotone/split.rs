//! A ring as two chains: where it is split.

use super::chains::{Side, Start};
use crate::{
    input::Figure,
    predicates::{PlaneId, orientation},
};
use hipline_num::Sign;

/// A polygon's ring counterclockwise: for each edge the plane on its left, and the vertex where it
/// starts.
pub(super) struct Ring {
    pub planes: Vec<PlaneId>,
    pub vertices: Vec<u32>,
}

impl Ring {
    /// The ring of a figure that is one.
    pub(super) fn new(figure: &Figure) -> Self {
        let edges = figure.edges();
        // Edges may have been split where vertices lie inside of them, so they may be in any order.
        let mut at = vec![[u32::MAX; 2]; figure.vertices().len()];
        for (e, edge) in edges.iter().enumerate() {
            at[edge.from.index()][0] = e as u32;
            at[edge.to.index()][1] = e as u32;
        }
        let mut ring = Self {
            planes: Vec::with_capacity(edges.len()),
            vertices: Vec::with_capacity(edges.len()),
        };
        let mut edge = 0_u32;
        for _ in 0..edges.len() {
            ring.planes.push(PlaneId(2 * edge));
            let ends = &edges[edge as usize];
            ring.vertices.push(ends.from.index() as u32);
            edge = at[ends.to.index()][0];
        }
        if ring.turns_right(figure) {
            ring.planes.reverse();
            ring.planes.iter_mut().for_each(|plane| plane.0 ^= 1);
            ring.vertices.reverse();
            // Each edge now starts where it ended.
            ring.vertices.rotate_right(1);
        }
        ring
    }

    fn turns_right(&self, figure: &Figure) -> bool {
        let place = |i: usize| figure.vertices()[self.vertices[i] as usize];
        let n = self.vertices.len();
        let order = |i: usize, j: usize| {
            let ([x, y], [u, v]) = (place(i), place(j));
            x.total_cmp(&u).then(y.total_cmp(&v))
        };
        let low = (0..n).min_by(|&i, &j| order(i, j)).expect("a vertex");
        let around = [(low + n - 1) % n, low, (low + 1) % n];
        orientation(around.map(|i| Ok(place(i)))) == Sign::Negative
    }

    /// The chains from one vertex to another, lower and upper.
    pub(super) fn split(&self, west: usize, east: usize) -> [Start; 2] {
        [
            (Side::Lower, west, east),
            (Side::Upper, east, west),
        ]
        .map(|(side, from, to)| {
            let n = self.planes.len();
            let count = (to + n - from) % n;
            let at = |i: usize| (from + i) % n;
            Start {
                side,
                planes: (0..count).map(|i| self.planes[at(i)]).collect(),
                vertices: (1..count).map(|i| self.vertices[at(i)]).collect(),
                ends: [Some(self.vertices[from]), Some(self.vertices[to])],
            }
        })
    }

    /// Where to split it so that both parts are monotone: by x or by y.
    pub(super) fn extremes(&self, figure: &Figure) -> Option<[usize; 2]> {
        (0..2).find_map(|axis| self.extremes_along(figure, axis))
    }

    fn extremes_along(&self, figure: &Figure, axis: usize) -> Option<[usize; 2]> {
        let n = self.vertices.len();
        let x = |i: usize| {
            let [x, y] = figure.vertices()[self.vertices[i % n] as usize];
            [x, y][axis]
        };
        // The ends, counterclockwise, of the runs of vertices that are further west or east than
        // what is around them.
        let mut ends = [Vec::new(), Vec::new()];
        let rise = |i: usize| x(i + 1).total_cmp(&x(i));
        let mut last = (0..n).rev().map(rise).find(|r| r.is_ne())?;
        for i in 0..n {
            let r = rise(i);
            if r.is_ne() {
                if r != last {
                    ends[usize::from(r.is_lt())].push(i);
                }
                last = r;
            }
        }
        match &ends[..] {
            [west, east] if west.len() == 1 && east.len() == 1 => Some([west[0], east[0]]),
            _ => None,
        }
    }
}
