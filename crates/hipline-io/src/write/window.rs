//! A rectangle to look through, and what of a skeleton is seen in it.
//!
//! Unbounded arcs and faces have to end somewhere in a picture or a file of polygons. Here
//! they are cut off, in plain f64: the cut ends are no part of the exact result.

use hipline::{
    Skeleton,
    skeleton::{Arc, Node, NodeKind},
    topology::NodeId,
};

/// An axis-parallel rectangle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Window {
    /// The lower left corner.
    pub min: [f64; 2],
    /// The upper right corner.
    pub max: [f64; 2],
}

impl Window {
    /// The smallest window around points; none around none.
    pub fn around(points: impl IntoIterator<Item = [f64; 2]>) -> Option<Self> {
        points.into_iter().fold(None, |window, p| match window {
            None => Some(Self { min: p, max: p }),
            Some(Self { min, max }) => Some(Self {
                min: [min[0].min(p[0]), min[1].min(p[1])],
                max: [max[0].max(p[0]), max[1].max(p[1])],
            }),
        })
    }

    /// The window around all finite nodes, half as large again.
    #[must_use]
    pub fn of(skeleton: &Skeleton) -> Option<Self> {
        let finite = skeleton.nodes().iter().filter(|n| n.time.is_finite());
        Some(Self::around(finite.map(place))?.enlarged(0.25))
    }

    /// The window with a margin on each side: a fraction of its longer side, or 1 if it is
    /// a point.
    #[must_use]
    pub fn enlarged(self, fraction: f64) -> Self {
        let Self { min, max } = self;
        let longest = self.longest_side();
        let margin = if longest > 0.0 {
            longest * fraction
        } else {
            1.0
        };
        Self {
            min: min.map(|c| c - margin),
            max: max.map(|c| c + margin),
        }
    }

    /// The smallest window that holds both.
    #[must_use]
    pub fn union(self, other: Self) -> Self {
        Self {
            min: [self.min[0].min(other.min[0]), self.min[1].min(other.min[1])],
            max: [self.max[0].max(other.max[0]), self.max[1].max(other.max[1])],
        }
    }

    pub(super) fn width(&self) -> f64 {
        self.max[0] - self.min[0]
    }

    pub(super) fn height(&self) -> f64 {
        self.max[1] - self.min[1]
    }

    pub(super) fn longest_side(&self) -> f64 {
        self.width().max(self.height())
    }

    pub(super) fn contains(&self, p: [f64; 2]) -> bool {
        (0..2).all(|i| self.min[i] <= p[i] && p[i] <= self.max[i])
    }

    /// The parameters between which `p + s d`, s in `[0, end]`, is inside (Liang, Barsky).
    pub(super) fn inside(&self, p: [f64; 2], d: [f64; 2], end: f64) -> Option<[f64; 2]> {
        let [mut first, mut last] = [0.0_f64, end];
        for i in 0..2 {
            if d[i] == 0.0 {
                if p[i] < self.min[i] || p[i] > self.max[i] {
                    return None;
                }
            } else {
                let [s, t] = [(self.min[i] - p[i]) / d[i], (self.max[i] - p[i]) / d[i]];
                first = first.max(s.min(t));
                last = last.min(s.max(t));
            }
        }
        (first <= last).then_some([first, last])
    }

    /// What is seen of a chain of points: the pieces of its edges.
    pub(super) fn clip_chain(&self, points: &[[f64; 2]]) -> Vec<Vec<[f64; 2]>> {
        let mut pieces: Vec<Vec<[f64; 2]>> = Vec::new();
        let mut goes_on = false;
        for edge in points.windows(2) {
            let [p, q] = [edge[0], edge[1]];
            let d = [q[0] - p[0], q[1] - p[1]];
            let Some([s, t]) = self.inside(p, d, 1.0) else {
                goes_on = false;
                continue;
            };
            let end = if t < 1.0 { along(p, d, t) } else { q };
            match pieces.last_mut() {
                Some(piece) if goes_on && s <= 0.0 => piece.push(end),
                _ => pieces.push(vec![if s > 0.0 { along(p, d, s) } else { p }, end]),
            }
            goes_on = t >= 1.0;
        }
        pieces
    }

    /// What is seen of a polygon (Sutherland, Hodgman): parts may hang together by edges
    /// on the border of the window.
    pub(super) fn clip_polygon(&self, polygon: &[[f64; 2]]) -> Vec<[f64; 2]> {
        if polygon.iter().all(|&p| self.contains(p)) {
            return polygon.to_vec();
        }
        let mut polygon = polygon.to_vec();
        for (axis, limit, sign) in [
            (0, self.min[0], 1.0),
            (0, self.max[0], -1.0),
            (1, self.min[1], 1.0),
            (1, self.max[1], -1.0),
        ] {
            let depth = |p: [f64; 2]| (p[axis] - limit) * sign;
            let mut clipped = Vec::with_capacity(polygon.len() + 4);
            for (i, &p) in polygon.iter().enumerate() {
                let q = polygon[(i + 1) % polygon.len()];
                let [a, b] = [depth(p), depth(q)];
                if a >= 0.0 {
                    clipped.push(p);
                }
                if (a >= 0.0) != (b >= 0.0) {
                    let mut cut = along(p, [q[0] - p[0], q[1] - p[1]], a / (a - b));
                    cut[axis] = limit;
                    clipped.push(cut);
                }
            }
            clipped.dedup();
            polygon = clipped;
        }
        // A corner of the window may have been cut twice, also across the seam.
        while polygon.len() > 1 && polygon.first() == polygon.last() {
            polygon.pop();
        }
        polygon
    }

    /// What is seen of an arc, as `[x, y, time]` of its two ends.
    pub(super) fn clip_arc(&self, skeleton: &Skeleton, arc: &Arc) -> Option<[[f64; 3]; 2]> {
        let [a, b] = arc.nodes.map(|n| skeleton.node(n));
        let ends = match (a.kind, b.kind) {
            (_, NodeKind::Infinite { direction }) => [lifted(a), beyond(self, a, direction)?],
            (NodeKind::Infinite { direction }, _) => [beyond(self, b, direction)?, lifted(b)],
            _ => [lifted(a), lifted(b)],
        };
        let [p, q] = ends;
        let d: [f64; 3] = std::array::from_fn(|i| q[i] - p[i]);
        let [s, t] = self.inside([p[0], p[1]], [d[0], d[1]], 1.0)?;
        let at = |s: f64| std::array::from_fn(|i| p[i] + s * d[i]);
        Some([
            if s > 0.0 { at(s) } else { p },
            if t < 1.0 { at(t) } else { q },
        ])
    }

    /// What is seen of a face: one boundary, counterclockwise as given.
    pub(super) fn clip_face(&self, skeleton: &Skeleton, boundary: &[NodeId]) -> Vec<[f64; 2]> {
        let mut outline = self.outline(skeleton, boundary);
        self.prolong(skeleton, boundary, &mut outline);
        self.clip_polygon(&outline)
    }

    /// The first and the last face of a chain have one node at infinity: the other way out is along the ray
    /// that their base is.
    fn prolong(&self, skeleton: &Skeleton, boundary: &[NodeId], outline: &mut Vec<[f64; 2]>) {
        let node = |i: usize| skeleton.node(boundary[i % boundary.len()]);
        let mut infinite = (0..boundary.len()).filter(|&i| node(i).time.is_infinite());
        let (Some(i), None) = (infinite.next(), infinite.next()) else {
            return;
        };
        let n = boundary.len();
        // An infinite node repeats the place of the other end of its arc. Between it and the other neighbour lies the ray.
        let bits = |k: usize| place(node(k)).map(f64::to_bits);
        let before = bits(i + n - 1) != bits(i);
        let (tip, inner, at) = if before {
            (i + n - 1, i + n - 2, i)
        } else {
            (i + 1, i + 2, i + 1)
        };
        let [tip, inner] = [tip, inner].map(|k| place(node(k)));
        let length = (tip[0] - inner[0]).abs() + (tip[1] - inner[1]).abs();
        if length <= 0.0 {
            return;
        }
        // Far enough for what lies beyond to be out of sight.
        const FAR: f64 = 64.0;
        let far = FAR * (self.width() + self.height()) / length;
        let far = [0, 1].map(|k| (tip[k] - inner[k]) * far);
        let moved = outline[i];
        let corner = [moved[0] + far[0], moved[1] + far[1]];
        let end = [tip[0] + far[0], tip[1] + far[1]];
        let points = if before { [end, corner] } else { [corner, end] };
        outline.splice(at..at, points);
    }

    /// A boundary with its infinite nodes moved to where the wavefront is at a moment late
    /// enough for it to have left the window.
    fn outline(&self, skeleton: &Skeleton, boundary: &[NodeId]) -> Vec<[f64; 2]> {
        let node = |i: usize| skeleton.node(boundary[i % boundary.len()]);
        let infinite: Vec<usize> = (0..boundary.len())
            .filter(|&i| node(i).time.is_infinite())
            .collect();
        let mut points: Vec<[f64; 2]> = (0..boundary.len()).map(|i| place(node(i))).collect();
        if infinite.is_empty() {
            return points;
        }
        // Times are those of the arcs' finite ends; the speeds tell how long to wait.
        let start_of = |i: usize| {
            let before = node(i + boundary.len() - 1);
            if before.time.is_finite() {
                before.time
            } else {
                node(i + 1).time
            }
        };
        let latest = infinite
            .iter()
            .map(|&i| start_of(i))
            .filter(|t| t.is_finite())
            .fold(0.0, f64::max);
        let speed = infinite.iter().map(|&i| speed(node(i))).fold(0.0, f64::max);
        let mut wait = if speed > 0.0 {
            (self.width() + self.height()) / speed
        } else {
            1.0
        };
        // A wavefront that leaves at all leaves long before this many doublings.
        const DOUBLINGS: usize = 64;
        for _ in 0..DOUBLINGS {
            for &i in &infinite {
                if let Node {
                    kind: NodeKind::Infinite { direction },
                    ..
                } = *node(i)
                {
                    let start = start_of(i);
                    let since = latest + wait - if start.is_finite() { start } else { latest };
                    points[i] = along(place(node(i)), direction, since);
                }
            }
            let has_left = infinite.iter().all(|&i| {
                let [p, q] = [points[i], points[(i + 1) % points.len()]];
                let d = [q[0] - p[0], q[1] - p[1]];
                let is_far_side = node(i + 1).time.is_infinite();
                let is_seen = is_far_side && self.inside(p, d, 1.0).is_some();
                !(is_seen || self.contains(p))
            });
            if has_left {
                break;
            }
            wait *= 2.0;
        }
        points
    }
}

/// The line on which a polygon lies that has no area, such as a face that stands upright: from end
/// to end. None if it has an area.
///
/// The corners are rounded, and so they are never quite on one line. What counts as an area is
/// what the rounding of coordinates cannot have made.
pub(super) fn trace(polygon: &[[f64; 2]]) -> Option<[[f64; 2]; 2]> {
    let &a = polygon.first()?;
    let from = |a: [f64; 2], p: [f64; 2]| [p[0] - a[0], p[1] - a[1]];
    let length = |p: [f64; 2]| p[0].abs() + p[1].abs();
    let far = |a: [f64; 2]| {
        let farther =
            |p: &&[f64; 2], q: &&[f64; 2]| length(from(a, **p)).total_cmp(&length(from(a, **q)));
        polygon.iter().max_by(farther).copied()
    };
    let b = far(a)?;
    let a = far(b)?;
    let [dx, dy] = from(a, b);
    let largest = polygon.iter().map(|&p| length(p)).fold(0.0, f64::max);
    // Each coordinate is off by half a unit in the last place at most; four differences of them
    // are multiplied by at most the length, and the products rounded.
    let slack = 4.0 * f64::EPSILON * largest * length([dx, dy]);
    let is_on_line = |&p: &[f64; 2]| {
        let [px, py] = from(a, p);
        (dx * py - dy * px).abs() <= slack
    };
    polygon.iter().all(is_on_line).then_some([a, b])
}

/// Whether two points are one.
pub(super) fn is_same(p: [f64; 2], q: [f64; 2]) -> bool {
    (0..2).all(|i| p[i].total_cmp(&q[i]).is_eq())
}

pub(super) const fn place(node: &Node) -> [f64; 2] {
    [node.x, node.y]
}

const fn lifted(node: &Node) -> [f64; 3] {
    [node.x, node.y, node.time]
}

fn speed(node: &Node) -> f64 {
    match node.kind {
        NodeKind::Infinite { direction } => direction[0].hypot(direction[1]),
        _ => 0.0,
    }
}

fn along(p: [f64; 2], d: [f64; 2], s: f64) -> [f64; 2] {
    [p[0] + s * d[0], p[1] + s * d[1]]
}

/// Where an arc that goes to infinity leaves the window.
fn beyond(window: &Window, from: &Node, direction: [f64; 2]) -> Option<[f64; 3]> {
    if direction == [0.0, 0.0] {
        // It stands upright and goes nowhere in the plane.
        return None;
    }
    let [_, end] = window.inside(place(from), direction, f64::MAX)?;
    let [x, y] = along(place(from), direction, end);
    Some([x, y, from.time + end])
}

#[cfg(test)]
mod tests {
    use super::*;

    const UNIT: Window = Window {
        min: [0.0, 0.0],
        max: [1.0, 1.0],
    };

    #[test]
    fn chains_are_cut_into_pieces() {
        let points = [
            [-1.0, 0.5],
            [2.0, 0.5],
            [2.0, 0.25],
            [0.5, 0.25],
            [0.5, 0.75],
            [0.5, 9.0],
        ];
        let pieces = UNIT.clip_chain(&points);
        assert_eq!(
            pieces,
            [
                vec![[0.0, 0.5], [1.0, 0.5]],
                vec![[1.0, 0.25], [0.5, 0.25], [0.5, 0.75], [0.5, 1.0]],
            ]
        );
    }

    #[test]
    fn polygons_are_cut() {
        let square = [[0.5, 0.5], [2.0, 0.5], [2.0, 2.0], [0.5, 2.0]];
        assert_eq!(
            UNIT.clip_polygon(&square),
            [[0.5, 0.5], [1.0, 0.5], [1.0, 1.0], [0.5, 1.0]]
        );
        assert_eq!(
            UNIT.clip_polygon(&[[2.0, 2.0], [3.0, 2.0], [2.0, 3.0]]),
            [[0.0; 2]; 0]
        );
    }

    #[test]
    fn upright_faces_have_a_trace() {
        let third = 1.0 / 3.0;
        let wall = [[0.1, 0.1], [0.7, 0.7], [third, third], [0.3, 0.1 + 0.2]];
        assert_eq!(trace(&wall), Some([[0.1, 0.1], [0.7, 0.7]]));
        assert_eq!(trace(&[[2.0, 1.0]; 3]), Some([[2.0, 1.0]; 2]));
        assert_eq!(trace(&[[0.0, 0.0], [1.0, 0.0], [0.5, 1e-14]]), None);
        assert_eq!(trace(&[[0.0, 0.0], [8.0, 0.0], [8.0, 4.0]]), None);
        assert_eq!(trace(&[]), None);
    }

    #[test]
    fn points_have_windows() {
        assert_eq!(Window::around([]), None);
        let point = Window::around([[3.0, 4.0]]).unwrap();
        assert_eq!(
            point.enlarged(0.5),
            Window {
                min: [2.0, 3.0],
                max: [4.0, 5.0]
            }
        );
        let line = Window::around([[0.0, 4.0], [8.0, 4.0]]).unwrap();
        assert_eq!(
            line.enlarged(0.25),
            Window {
                min: [-2.0, 2.0],
                max: [10.0, 6.0]
            }
        );
    }
}
