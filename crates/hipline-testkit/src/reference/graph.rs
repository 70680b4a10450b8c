//! What the reference engine takes: vertices and edges as plain data.

use hipline::Figure;

/// A planar straight-line graph as plain data; the caller vouches for its being one.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Graph {
    /// Distinct points.
    pub vertices: Vec<[f64; 2]>,
    /// Edges that meet in vertices only.
    pub edges: Vec<GraphEdge>,
}

/// One edge of a [`Graph`].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct GraphEdge {
    /// The vertices at its start and its end.
    pub ends: [usize; 2],
    /// The speeds on its left and on its right.
    pub speeds: [f64; 2],
    /// Whether it belongs to a polygon's ring.
    pub on_ring: bool,
}

impl From<&Figure> for Graph {
    fn from(figure: &Figure) -> Self {
        let edges = figure.edges().iter().map(|edge| GraphEdge {
            ends: [edge.from.index(), edge.to.index()],
            speeds: edge.speeds,
            on_ring: edge.on_ring,
        });
        Self {
            vertices: figure.vertices().to_vec(),
            edges: edges.collect(),
        }
    }
}

impl Graph {
    /// Adds a point, or finds it.
    fn vertex(&mut self, point: [f64; 2]) -> usize {
        let same = |p: &[f64; 2]| (0..2).all(|k| p[k].total_cmp(&(point[k] + 0.0)).is_eq());
        if let Some(found) = self.vertices.iter().position(same) {
            return found;
        }
        self.vertices.push(point.map(|x| x + 0.0));
        self.vertices.len() - 1
    }

    /// Adds an edge between two points; equal points become one vertex.
    pub fn edge(&mut self, from: [f64; 2], to: [f64; 2], speeds: [f64; 2], on_ring: bool) {
        let ends = [self.vertex(from), self.vertex(to)];
        self.edges.push(GraphEdge {
            ends,
            speeds,
            on_ring,
        });
    }

    /// Adds a ring of a polygon; missing speeds are 1.
    pub fn ring(&mut self, points: &[[f64; 2]], speeds: &[f64]) {
        for (i, &from) in points.iter().enumerate() {
            let speed = speeds.get(i).copied().unwrap_or(1.0);
            self.edge(from, points[(i + 1) % points.len()], [speed; 2], true);
        }
    }

    /// Adds an open polyline; missing speeds are 1.
    pub fn line(&mut self, points: &[[f64; 2]], speeds: &[[f64; 2]]) {
        for (i, pair) in points.windows(2).enumerate() {
            self.edge(
                pair[0],
                pair[1],
                speeds.get(i).copied().unwrap_or([1.0; 2]),
                false,
            );
        }
    }
}
