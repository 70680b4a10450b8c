//! An incremental triangulation, Delaunay as far as rounding allows.
//!
//! Whether the triangulation is *valid* rests on exact orientation tests alone. Delaunay
//! is a matter of taste here (well-shaped triangles mean fewer flips later on), so an edge
//! is flipped only if rounded arithmetic proves that it should be: every flip is then a
//! true one, so flipping terminates and keeps the triangulation valid, and points on a
//! common circle, where an exact test is slow and its answer worthless, cost nothing.
//!
//! The outside is made of ghost triangles with a vertex at infinity, one on each edge of
//! the hull; with them a point outside of the hull is inserted like any other.
//!
//! Half-edge `3 t + k` runs from corner `k` of triangle `t` to the next one,
//! counterclockwise.

use robust::{Coord, orient2d};

use super::range::Scale;

/// The vertex at infinity.
pub(super) const INFINITE: u32 = u32::MAX;

/// No edge of the figure.
pub(super) const NONE: u32 = u32::MAX;

/// A triangulation of some vertices.
pub(super) struct Triangulation<'a> {
    vertices: &'a [[f64; 2]],
    scale: Scale,
    /// Where each half-edge starts.
    pub origin: Vec<u32>,
    /// The other side of each half-edge.
    pub twin: Vec<u32>,
    /// The edge of the figure on each half-edge, or [`NONE`]; empty during insertion.
    pub owner: Vec<u32>,
    /// A half-edge from each vertex; empty during insertion.
    pub spoke: Vec<u32>,
    /// Half-edges that may have to be flipped.
    suspects: Vec<u32>,
    /// A triangle (no ghost) at the vertex inserted last.
    last: u32,
    /// State of a generator: walks choose their way at random, so that they end also
    /// where the triangulation is not quite Delaunay.
    random: u32,
}

/// The next half-edge of the same triangle.
pub(super) const fn next(h: u32) -> u32 {
    if h % 3 == 2 { h - 2 } else { h + 1 }
}

/// The previous half-edge of the same triangle.
pub(super) const fn prev(h: u32) -> u32 {
    if h % 3 == 0 { h + 2 } else { h - 1 }
}

/// Where a new vertex lies.
enum Location {
    /// In a triangle, maybe a ghost.
    Triangle(u32),
    /// On the inside of an edge.
    Edge(u32),
}

impl<'a> Triangulation<'a> {
    /// Inserts the vertices in the order given; the first three must not be on one line.
    pub(super) fn new(vertices: &'a [[f64; 2]], scale: Scale, order: &[u32]) -> Self {
        let halfedges = 3 * 2 * vertices.len();
        let mut this = Self {
            vertices,
            scale,
            origin: Vec::with_capacity(halfedges),
            twin: Vec::with_capacity(halfedges),
            owner: Vec::new(),
            spoke: Vec::new(),
            suspects: Vec::new(),
            last: 0,
            random: 1,
        };
        this.first_triangle([order[0], order[1], order[2]]);
        for &vertex in &order[3..] {
            this.insert(vertex);
        }
        this.owner = vec![NONE; this.origin.len()];
        this.spoke = vec![NONE; vertices.len()];
        for (h, &origin) in this.origin.iter().enumerate() {
            if origin != INFINITE {
                this.spoke[origin as usize] = h as u32;
            }
        }
        this
    }

    pub(super) fn point(&self, vertex: u32) -> Coord<f64> {
        let [x, y] = self.scale.apply(self.vertices[vertex as usize]);
        Coord { x, y }
    }

    /// Where the half-edge starts.
    pub(super) fn from(&self, h: u32) -> u32 {
        self.origin[h as usize]
    }

    /// Where the half-edge ends.
    pub(super) fn to(&self, h: u32) -> u32 {
        self.origin[next(h) as usize]
    }

    pub(super) fn twin(&self, h: u32) -> u32 {
        self.twin[h as usize]
    }

    /// Positive if `c` is to the left of `a -> b`. Exact.
    pub(super) fn side(&self, a: u32, b: u32, c: u32) -> f64 {
        orient2d(self.point(a), self.point(b), self.point(c))
    }

    /// Whether the triangle of the half-edge has the vertex at infinity.
    pub(super) fn is_ghost(&self, h: u32) -> bool {
        self.origin[(h - h % 3) as usize..][..3].contains(&INFINITE)
    }

    pub(super) fn link(&mut self, h: u32, g: u32) {
        self.twin[h as usize] = g;
        self.twin[g as usize] = h;
    }

    fn push_triangle(&mut self, corners: [u32; 3]) -> u32 {
        let triangle = self.origin.len() as u32 / 3;
        self.origin.extend(corners);
        self.twin.extend([NONE; 3]);
        triangle
    }

    fn first_triangle(&mut self, [a, b, c]: [u32; 3]) {
        let corners = if self.side(a, b, c) > 0.0 { [a, b, c] } else { [a, c, b] };
        self.push_triangle(corners);
        for k in 0..3 {
            let ghost = self.push_triangle([corners[(k + 1) % 3], corners[k], INFINITE]);
            self.link(3 * ghost, k as u32);
        }
        // Ghost k is triangle k + 1; its half-edge to infinity leaves corner k, that of the
        // ghost before arrives there.
        for k in 0..3 {
            let before = (k + 2) % 3;
            self.link(3 * (k + 1) + 1, 3 * (before + 1) + 2);
        }
    }

    fn insert(&mut self, vertex: u32) {
        let location = self.locate(vertex);
        let slots = match location {
            Location::Triangle(t) => {
                let sides = [3 * t, 3 * t + 1, 3 * t + 2];
                let slots = [t, self.push_triangle([NONE; 3]), self.push_triangle([NONE; 3])];
                self.fan(vertex, sides, slots);
                slots
            }
            Location::Edge(h) => {
                let g = self.twin(h);
                let sides = [next(h), prev(h), next(g), prev(g)];
                let slots = [h / 3, self.push_triangle([NONE; 3]), g / 3, self.push_triangle([NONE; 3])];
                self.fan(vertex, sides, slots);
                [slots[0], slots[1], slots[2]]
            }
        };
        self.last = slots.into_iter().find(|&slot| !self.is_ghost(3 * slot)).unwrap_or(self.last);
        self.legalize_around(vertex);
    }

    /// The triangle or edge that a vertex lies in, walking from the last triangle.
    fn locate(&mut self, vertex: u32) -> Location {
        let mut triangle = self.last;
        let mut entered = NONE;
        'walk: loop {
            self.random = self.random.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            let first = (self.random >> 16) % 3;
            let mut on = None;
            for k in 0..3 {
                let h = 3 * triangle + (first + k) % 3;
                if h == entered {
                    continue;
                }
                let side = self.side(self.from(h), self.to(h), vertex);
                if side < 0.0 {
                    entered = self.twin(h);
                    triangle = entered / 3;
                    if self.is_ghost(entered) {
                        return Location::Triangle(triangle);
                    }
                    continue 'walk;
                }
                if side == 0.0 {
                    on = Some(h);
                }
            }
            return on.map_or(Location::Triangle(triangle), Location::Edge);
        }
    }

    /// Puts triangles from the vertex to the sides of the cavity (in order around it) into
    /// the slots; the sides are half-edges of triangles that cease to exist.
    fn fan<const N: usize>(&mut self, vertex: u32, sides: [u32; N], slots: [u32; N]) {
        let border = sides.map(|h| (self.from(h), self.twin(h)));
        for k in 0..N {
            let (from, outside) = border[k];
            let h = 3 * slots[k];
            self.origin[h as usize..][..3].copy_from_slice(&[from, border[(k + 1) % N].0, vertex]);
            self.link(h, outside);
            self.suspects.push(h);
        }
        for k in 0..N {
            self.link(3 * slots[k] + 1, 3 * slots[(k + 1) % N] + 2);
        }
    }

    /// Flips edges opposite the vertex until all are (provably enough) Delaunay.
    fn legalize_around(&mut self, vertex: u32) {
        while let Some(h) = self.suspects.pop() {
            let g = self.twin(h);
            let (x, y, apex) = (self.from(h), self.from(g), self.from(prev(g)));
            let illegal = if apex == INFINITE {
                false
            } else if y == INFINITE {
                self.side(x, apex, vertex) > 0.0
            } else if x == INFINITE {
                self.side(apex, y, vertex) > 0.0
            } else {
                self.surely_in_circle([x, y, vertex], apex)
            };
            if illegal {
                self.flip(h);
                self.suspects.extend([h, g]);
            }
        }
    }

    /// Replaces the edge `x -> y` between the triangles (x, y, p) and (y, x, q) by
    /// `q -> p`. Afterwards the half-edge itself is `x -> q` and its former twin `q -> y`,
    /// both with p opposite.
    fn flip(&mut self, h: u32) {
        let g = self.twin(h);
        let (hn, hp, gn, gp) = (next(h), prev(h), next(g), prev(g));
        let (y, p, q) = (self.from(g), self.from(hp), self.from(gp));
        let [yp, xq, qy] = [hn, gn, gp].map(|side| self.twin(side));
        self.link(h, xq);
        self.link(g, qy);
        self.link(gn, yp);
        self.link(hn, gp);
        self.origin[hn as usize] = q;
        self.origin[g as usize] = q;
        self.origin[gn as usize] = y;
        self.origin[gp as usize] = p;
        if !self.owner.is_empty() {
            let [yp, xq, qy] = [hn, gn, gp].map(|side| self.owner[side as usize]);
            for (side, owner) in [(h, xq), (g, qy), (gn, yp), (hn, NONE), (gp, NONE)] {
                self.owner[side as usize] = owner;
            }
            for side in [h, hn, hp, gn] {
                let from = self.from(side);
                self.spoke[from as usize] = side;
            }
        }
    }

    /// Flips edges that are no constraints and surely not Delaunay, beginning with some.
    pub(super) fn legalize(&mut self, suspects: &mut Vec<u32>) {
        while let Some(h) = suspects.pop() {
            let g = self.twin(h);
            if self.owner[h as usize] != NONE || self.is_ghost(h) || self.is_ghost(g) {
                continue;
            }
            let [x, y, p] = [h, next(h), prev(h)].map(|side| self.from(side));
            if self.surely_in_circle([x, y, p], self.from(prev(g))) {
                self.flip(h);
                suspects.extend([h, prev(h), g, next(g)]);
            }
        }
    }

    /// Whether the point is inside the circle through three points (counterclockwise);
    /// false if that is too close to tell.
    ///
    /// The bound is that of the first stage of Shewchuk's incircle test (1997, section
    /// 4.4): (10 + 96 u) u times the sum of the sizes of all products, u = 2^-53.
    fn surely_in_circle(&self, corners: [u32; 3], point: u32) -> bool {
        const BOUND: f64 = (10.0 + 96.0 * (f64::EPSILON / 2.0)) * (f64::EPSILON / 2.0);
        let d = self.point(point);
        let [(ax, ay), (bx, by), (cx, cy)] = corners.map(|corner| {
            let corner = self.point(corner);
            (corner.x - d.x, corner.y - d.y)
        });
        let (bxcy, cxby) = (bx * cy, cx * by);
        let (cxay, axcy) = (cx * ay, ax * cy);
        let (axby, bxay) = (ax * by, bx * ay);
        let [a, b, c] = [ax * ax + ay * ay, bx * bx + by * by, cx * cx + cy * cy];
        let determinant = a * (bxcy - cxby) + b * (cxay - axcy) + c * (axby - bxay);
        let sizes = a * (bxcy.abs() + cxby.abs()) + b * (cxay.abs() + axcy.abs()) + c * (axby.abs() + bxay.abs());
        determinant > BOUND * sizes
    }
}
