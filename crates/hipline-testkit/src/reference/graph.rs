//! What the reference engine takes: vertices and edges as plain data.

use hipline::Figure;
use hipline::skeleton::Side;
use hipline::topology::VertexId;

/// A planar straight-line graph as plain data; the caller vouches for its being one.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Graph {
    /// Distinct points.
    pub vertices: Vec<[f64; 2]>,
    /// Edges that meet in vertices only.
    pub edges: Vec<GraphEdge>,
    /// Changes of speed; those of one side in the order of time.
    pub changes: Vec<GraphChange>,
    /// The height of each vertex; none stands for zero.
    pub heights: Vec<f64>,
}

/// From a time on, one side of an edge moves at another speed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct GraphChange {
    /// The edge.
    pub edge: usize,
    /// Its right side, not its left one?
    pub right: bool,
    /// From when on.
    pub time: f64,
    /// The speed from then on.
    pub speed: f64,
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
            changes: figure
                .changes()
                .iter()
                .map(|change| GraphChange {
                    edge: change.edge.index(),
                    right: change.right,
                    time: change.time,
                    speed: change.speed,
                })
                .collect(),
            heights: (0..figure.vertices().len())
                .map(|vertex| figure.height(VertexId::new(vertex)))
                .collect(),
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

    /// The height of a vertex.
    #[must_use]
    pub fn height(&self, vertex: usize) -> f64 {
        self.heights.get(vertex).copied().unwrap_or(0.0)
    }

    /// Whether a vertex has a height other than zero.
    #[must_use]
    pub fn has_heights(&self) -> bool {
        self.heights.iter().any(|&height| height > 0.0)
    }

    /// The speeds of one side of an edge, or of a terminal of it: each with the time from which on it
    /// holds, the first one 0. A terminal has the larger one of the speeds of the two sides.
    ///
    /// What has a height stands still before it; the wall below a tilted eave, for ever.
    #[must_use]
    pub fn speeds(&self, edge: usize, side: Side) -> Vec<[f64; 2]> {
        let of = |right: bool| {
            let mut list = vec![[0.0, self.edges[edge].speeds[usize::from(right)]]];
            let changes = self
                .changes
                .iter()
                .filter(|change| change.edge == edge && change.right == right);
            list.extend(changes.map(|change| [change.time, change.speed]));
            list
        };
        let at = |list: &[[f64; 2]], time: f64| {
            let now = list.iter().rev().find(|entry| entry[0] <= time);
            now.expect("lists start at 0")[1]
        };
        let mut list = match side {
            Side::Left => of(false),
            Side::Right => of(true),
            Side::Start | Side::End => {
                let sides = [of(false), of(true)];
                let mut times: Vec<f64> = sides.iter().flatten().map(|entry| entry[0]).collect();
                times.sort_by(f64::total_cmp);
                let fastest = |time: f64| at(&sides[0], time).max(at(&sides[1], time));
                times
                    .into_iter()
                    .map(|time| [time, fastest(time)])
                    .collect()
            }
        };
        let [from, to] = self.edges[edge].ends.map(|end| self.height(end));
        let height = match side {
            Side::Start => from,
            Side::End => to,
            Side::Left | Side::Right if from.total_cmp(&to).is_ne() => {
                list.truncate(1);
                list[0][1] = 0.0;
                0.0
            }
            Side::Left | Side::Right => from,
        };
        if height > 0.0 {
            list[0][0] = height;
            list.insert(0, [0.0; 2]);
        }
        // What stays the same is no change.
        list.dedup_by(|later, earlier| later[1].total_cmp(&earlier[1]).is_eq());
        list
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
