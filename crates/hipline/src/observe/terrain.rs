//! The surface in a window, as triangles that share their corners.
//!
//! Each face of the skeleton, an unbounded one cut off at a time when the wavefront has left the window, is
//! cut into triangles, and each triangle by the window. Where the window's border cuts an edge
//! between two triangles, both get the same corner, so the surface has no cracks.

use super::{InvalidWindow, Window, standing::has_no_area};
use crate::{
    input::Figure,
    lift::Lift,
    roof::{Tiles, tiled},
    skeleton::Skeleton,
    topology::{ArcId, FaceId},
};
use std::collections::BTreeMap;

/// A triangle of a terrain.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Triangle {
    /// Its corners, numbers of vertices, counterclockwise from above.
    pub corners: [u32; 3],
    /// The face that it is a part of.
    pub face: FaceId,
}

/// The surface in a window.
#[derive(Debug, Clone, PartialEq)]
pub struct Terrain {
    window: Window,
    vertices: Vec<[f64; 3]>,
    triangles: Vec<Triangle>,
}

/// The distance of two points, for output.
pub(super) fn distance(p: [f64; 2], q: [f64; 2]) -> f64 {
    (q[0] - p[0]).hypot(q[1] - p[1])
}

/// Sums up with the error of each step carried along (Neumaier).
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Sum {
    value: f64,
    rest: f64,
}

impl Sum {
    pub(super) fn add(&mut self, x: f64) {
        let sum = self.value + x;
        self.rest += if self.value.abs() >= x.abs() {
            (self.value - sum) + x
        } else {
            (x - sum) + self.value
        };
        self.value = sum;
    }

    pub(super) fn total(self) -> f64 {
        self.value + self.rest
    }
}

impl Terrain {
    /// The surface over what of a window the skeleton covers.
    ///
    /// ```
    /// use hipline::{FigureBuilder, Options, observe::{Terrain, Window}};
    ///
    /// let mut builder = FigureBuilder::new();
    /// builder.polyline(vec![[0.0, 0.0], [6.0, 0.0]]);
    /// let figure = builder.build()?;
    /// let skeleton = figure.skeleton(Options::default());
    /// let window = Window::new([-1.0, -1.0], [7.0, 2.0])?;
    /// let terrain = Terrain::new(&skeleton, &figure, window)?;
    /// assert_eq!(terrain.area(), 24.0);
    /// assert_eq!(terrain.highest(), 2.0);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Complexity
    /// O(n log n).
    ///
    /// # Errors
    /// The window lies beside the figure, nothing in it is covered, or figure and window are too
    /// large for f64.
    ///
    /// # Panics
    /// If the figure is not the one that the skeleton was computed from.
    pub fn new(
        skeleton: &Skeleton,
        figure: &Figure,
        window: Window,
    ) -> Result<Self, InvalidWindow> {
        let (min, max) = (window.min(), window.max());
        let beside = |axis: usize| {
            let mut values = figure.vertices().iter().map(|v| v[axis]);
            values.clone().all(|x| x < min[axis]) || values.all(|x| x > max[axis])
        };
        if beside(0) || beside(1) {
            return Err(window.missed());
        }
        let late = late(skeleton, figure, window);
        if late > LAST {
            let ([x0, y0], [x1, y1]) = (min, max);
            return Err(InvalidWindow::NotFinite(x0, y0, x1, y1));
        }
        let (vertices, triangles) = whole(skeleton, figure, late).ok_or(InvalidWindow::Rounding)?;
        let mut cutter = Cutter {
            vertices: &vertices,
            window,
            names: vec![u32::MAX; vertices.len()],
            crossings: BTreeMap::new(),
            corners: [None; 4],
            terrain: Self {
                window,
                vertices: Vec::new(),
                triangles: Vec::new(),
            },
        };
        for (corners, face) in triangles {
            cutter.triangle(corners, face);
        }
        if cutter.terrain.triangles.is_empty() {
            Err(window.missed())
        } else {
            Ok(cutter.terrain)
        }
    }

    /// The window.
    #[must_use]
    pub const fn window(&self) -> Window {
        self.window
    }

    /// The vertices: x, y, and the time at which the wavefront arrives.
    #[must_use]
    pub fn vertices(&self) -> &[[f64; 3]] {
        &self.vertices
    }

    /// The triangles, those of one face in a row.
    #[must_use]
    pub fn triangles(&self) -> &[Triangle] {
        &self.triangles
    }

    /// The area of a triangle in the plan, in square input units, up to rounding.
    #[must_use]
    pub fn plan_area(&self, triangle: &Triangle) -> f64 {
        let [p, q, r] = triangle.corners.map(|v| self.vertices[v as usize]);
        ((q[0] - p[0]) * (r[1] - p[1]) - (r[0] - p[0]) * (q[1] - p[1])) / 2.0
    }

    /// The area of the whole terrain in the plan.
    #[must_use]
    pub fn area(&self) -> f64 {
        let mut sum = Sum::default();
        for triangle in &self.triangles {
            sum.add(self.plan_area(triangle));
        }
        sum.total()
    }

    /// The largest time of a vertex.
    #[must_use]
    pub fn highest(&self) -> f64 {
        self.vertices.iter().fold(0.0, |m, v| m.max(v[2]))
    }
}

/// Later times would take coordinates beyond f64.
const LAST: f64 = f64::from_bits((1023 + 900) << 52);

/// A time at which the wavefront has left a window. Time grows by 1 / w at most per unit of length,
/// w being the slowest speed, and is 0 on the figure.
fn late(skeleton: &Skeleton, figure: &Figure, window: Window) -> f64 {
    let speeds = figure.edges().iter().flat_map(|e| e.speeds);
    let slowest = speeds.filter(|&w| w > 0.0).fold(f64::INFINITY, f64::min);
    let (min, max) = (window.min(), window.max());
    let reach = |axis: usize| {
        let values = figure.vertices().iter().map(|v| v[axis]);
        let (low, high) = values.fold((min[axis], max[axis]), |(l, h), x| (l.min(x), h.max(x)));
        high - low
    };
    let times = skeleton.nodes().iter().map(|n| n.time);
    let last = times.filter(|t| t.is_finite()).fold(0.0, f64::max);
    2.0 * (last + 2.0 * (reach(0) + reach(1)) / slowest)
}

/// All faces, with time as height.
fn whole(skeleton: &Skeleton, figure: &Figure, late: f64) -> Option<Tiles> {
    let lift = Lift::new(skeleton, figure);
    let mut vertices: Vec<[f64; 3]> = skeleton
        .nodes()
        .iter()
        .map(|n| [n.x, n.y, n.time])
        .collect();
    for (i, arc) in skeleton.arcs().iter().enumerate() {
        let [_, end] = arc.nodes;
        if skeleton.node(end).time.is_infinite() {
            let place = lift.at(ArcId::new(i), late);
            vertices[end.index()] = lift.planes.round(&place);
        }
    }
    let faces = (0..skeleton.faces().len())
        .map(FaceId::new)
        .filter(|&face| !has_no_area(&lift, face))
        .map(|face| {
            let rings = std::iter::once(skeleton.boundary(face)).chain(skeleton.holes(face));
            (face, rings)
        });
    tiled(vertices, faces)
}

/// Cuts triangles by a window.
struct Cutter<'a> {
    vertices: &'a [[f64; 3]],
    window: Window,
    /// The numbers of the mesh's vertices in the terrain.
    names: Vec<u32>,
    /// Where the border cuts an edge: where it comes in (`false`) and goes out, from its
    /// smaller number.
    crossings: BTreeMap<(u32, u32, bool), u32>,
    corners: [Option<u32>; 4],
    terrain: Terrain,
}

impl Cutter<'_> {
    fn point(&self, v: u32) -> [f64; 2] {
        let [x, y, _] = self.vertices[v as usize];
        [x, y]
    }

    fn create(&mut self, vertex: [f64; 3]) -> u32 {
        self.terrain.vertices.push(vertex);
        self.terrain.vertices.len() as u32 - 1
    }

    fn keep(&mut self, v: u32) -> u32 {
        if self.names[v as usize] == u32::MAX {
            self.names[v as usize] = self.create(self.vertices[v as usize]);
        }
        self.names[v as usize]
    }

    fn triangle(&mut self, corners: [u32; 3], id: FaceId) {
        let points = corners.map(|v| self.point(v));
        let (min, max) = (self.window.min(), self.window.max());
        let is_beside = (0..2)
            .any(|i| points.iter().all(|p| p[i] < min[i]) || points.iter().all(|p| p[i] > max[i]));
        if is_beside {
            return;
        }
        if points.iter().all(|&p| self.window.contains(p)) {
            let corners = corners.map(|v| self.keep(v));
            self.terrain.triangles.push(Triangle { corners, face: id });
            return;
        }
        let mut ring: Vec<u32> = Vec::with_capacity(7);
        for i in 0..3 {
            let (p, q) = (corners[i], corners[(i + 1) % 3]);
            if let Some([first, last]) = self.visible(p, q) {
                self.turn(&mut ring, first, corners);
                push(&mut ring, first);
                push(&mut ring, last);
            }
        }
        match ring.first().copied() {
            Some(first) => self.turn(&mut ring, first, corners),
            // The window lies inside of the triangle, or beside it.
            None => {
                for k in 0..4 {
                    if self.is_inside(k, corners) {
                        let corner = self.corner(k, corners);
                        ring.push(corner);
                    }
                }
            }
        }
        while ring.len() > 1 && ring.first() == ring.last() {
            ring.pop();
        }
        // Some may have no area, where a face has corners on one line; without them there would be
        // cracks.
        for k in 2..ring.len() {
            self.terrain.triangles.push(Triangle {
                corners: [ring[0], ring[k - 1], ring[k]],
                face: id,
            });
        }
    }

    /// The visible part of an edge, as vertices of the terrain.
    fn visible(&mut self, p: u32, q: u32) -> Option<[u32; 2]> {
        let (a, b) = (p.min(q), p.max(q));
        let [from, to] = [a, b].map(|v| self.point(v));
        let [s, t] = self.window.inside(from, to)?;
        let mut end = |parameter: f64, goes_out: bool| {
            if parameter <= 0.0 {
                return self.keep(a);
            }
            if parameter >= 1.0 {
                return self.keep(b);
            }
            if let Some(&known) = self.crossings.get(&(a, b, goes_out)) {
                return known;
            }
            let [u, v] = [a, b].map(|v| self.vertices[v as usize]);
            let at = |k: usize| (v[k] - u[k]).mul_add(parameter, u[k]);
            let vertex = [at(0), at(1), at(2)];
            let (min, max) = (self.window.min(), self.window.max());
            let [x, y] = [0, 1].map(|k| {
                // On the side that was met the coordinate is that of the side.
                let limit = |side: f64| {
                    let met = (side - u[k]) / (v[k] - u[k]);
                    met.to_bits() == parameter.to_bits()
                };
                if limit(min[k]) {
                    min[k]
                } else if limit(max[k]) {
                    max[k]
                } else {
                    vertex[k].clamp(min[k], max[k])
                }
            });
            let id = self.create([x, y, vertex[2]]);
            self.crossings.insert((a, b, goes_out), id);
            id
        };
        let first = end(s, false);
        let last = end(t, true);
        Some(if p == a { [first, last] } else { [last, first] })
    }

    /// Goes counterclockwise along the border from the end of a ring to a vertex, around the corners
    /// that lie in the triangle.
    fn turn(&mut self, ring: &mut Vec<u32>, to: u32, triangle: [u32; 3]) {
        let Some(&from) = ring.last() else { return };
        if from == to {
            return;
        }
        let [Some(start), Some(end)] = [from, to].map(|v| self.along_border(v)) else {
            return;
        };
        let mut on_way: Vec<(f64, usize)> = (0..4)
            .map(|k| {
                let at = k as f64;
                (if at > start { at } else { at + 4.0 }, k)
            })
            .filter(|&(at, _)| at < if end > start { end } else { end + 4.0 })
            .collect();
        on_way.sort_by(|a, b| a.0.total_cmp(&b.0));
        for (_, k) in on_way {
            if self.is_inside(k, triangle) {
                let corner = self.corner(k, triangle);
                push(ring, corner);
            }
        }
    }

    /// How far along the border a vertex is: corner k is at k.
    fn along_border(&self, v: u32) -> Option<f64> {
        let [x, y, _] = self.terrain.vertices[v as usize];
        let ([x0, y0], [x1, y1]) = (self.window.min(), self.window.max());
        let same = |a: f64, b: f64| a.total_cmp(&b).is_eq();
        if same(y, y0) && !same(x, x1) {
            Some((x - x0) / (x1 - x0))
        } else if same(x, x1) && !same(y, y1) {
            Some(1.0 + (y - y0) / (y1 - y0))
        } else if same(y, y1) && !same(x, x0) {
            Some(2.0 + (x1 - x) / (x1 - x0))
        } else {
            same(x, x0).then(|| 3.0 + (y1 - y) / (y1 - y0))
        }
    }

    fn is_inside(&self, corner: usize, triangle: [u32; 3]) -> bool {
        let coord = |[x, y]: [f64; 2]| robust::Coord { x, y };
        let at = coord(self.window.corners()[corner]);
        let points = triangle.map(|v| coord(self.point(v)));
        (0..3).all(|i| robust::orient2d(points[i], points[(i + 1) % 3], at) >= 0.0)
    }

    /// A corner of the window, as high as the triangle is there.
    fn corner(&mut self, corner: usize, triangle: [u32; 3]) -> u32 {
        if let Some(known) = self.corners[corner] {
            return known;
        }
        let [x, y] = self.window.corners()[corner];
        let [p, q, r] = triangle.map(|v| self.vertices[v as usize]);
        let cross = |a: [f64; 3], b: [f64; 3]| (a[0] - x) * (b[1] - y) - (b[0] - x) * (a[1] - y);
        let [u, v, w] = [cross(q, r), cross(r, p), cross(p, q)];
        let time = (u * p[2] + v * q[2] + w * r[2]) / (u + v + w);
        let id = self.create([x, y, time]);
        self.corners[corner] = Some(id);
        id
    }
}

fn push(ring: &mut Vec<u32>, vertex: u32) {
    if ring.last() != Some(&vertex) {
        ring.push(vertex);
    }
}
