//! From polygons, polylines and graphs to a checked figure.

use super::{
    Change, Figure, Flaw, InvalidFigure, Place, change::Changes, crossing, gather,
    gather::without_closing_point, height, height::Heights, nesting, range::Scale, single,
    triangulate,
};

/// Collects polygons, polylines and graphs, then checks them all at once.
///
/// What is legal:
///
/// * Rings of either orientation; what is inside is decided by counting (even-odd), and
///   edges keep the direction in which they were given.
/// * Several polygons, also one inside the hole of another.
/// * Rings and lines that touch in points: equal vertices become one, and a vertex on the
///   inside of an edge splits that edge. Only a polygon whose inside falls into several
///   pieces that way is refused.
/// * Lines and graphs anywhere, inside and outside of polygons, as long as no two edges
///   cross or overlap. An edge that is the same in several lines, and of the same speeds,
///   is one edge; it has the name it was first given.
///
/// ```
/// use hipline::FigureBuilder;
///
/// let mut builder = FigureBuilder::new();
/// builder.polygon(vec![vec![[0., 0.], [8., 0.], [8., 6.], [0., 6.]]]);
/// builder.polyline(vec![[2., 3.], [6., 3.]]);
/// let figure = builder.build()?;
/// assert_eq!(figure.edges().len(), 5);
/// assert_eq!(figure.terminals(), 2);
/// # Ok::<(), hipline::InvalidFigure>(())
/// ```
#[derive(Debug, Clone, Default)]
pub struct FigureBuilder {
    pub(super) parts: Vec<Part>,
    pub(super) changes: Vec<Change>,
    pub(super) heights: Vec<(Place, f64)>,
}

/// What one call to the builder added.
#[derive(Debug, Clone)]
pub(super) enum Part {
    Polygon {
        rings: Vec<Vec<[f64; 2]>>,
        speeds: Option<Vec<Vec<f64>>>,
    },
    Line {
        points: Vec<[f64; 2]>,
        speeds: Option<Vec<[f64; 2]>>,
    },
    Graph {
        vertices: Vec<[f64; 2]>,
        edges: Vec<[usize; 2]>,
        speeds: Option<Vec<[f64; 2]>>,
    },
}

impl Part {
    /// How many vertices and edges a ring has; what is no polygon has one.
    pub(super) fn counts(&self, ring: usize) -> [usize; 2] {
        match self {
            Self::Polygon { rings, .. } => {
                let ring = rings.get(ring).map(|ring| without_closing_point(ring));
                [ring.map_or(0, <[_]>::len); 2]
            }
            _ if ring != 0 => [0; 2],
            Self::Line { points, .. } => [points.len(), points.len().saturating_sub(1)],
            Self::Graph {
                vertices, edges, ..
            } => [vertices.len(), edges.len()],
        }
    }
}

impl FigureBuilder {
    /// An empty builder.
    #[must_use]
    pub fn new() -> Self {
        Self::default()
    }

    fn push(&mut self, part: Part) -> usize {
        self.parts.push(part);
        self.parts.len() - 1
    }

    /// Adds a polygon: its shell, then its holes, each a list of `[x, y]`; a last point equal to
    /// the first is dropped; either orientation. Returns the number of the part.
    pub fn polygon(&mut self, rings: Vec<Vec<[f64; 2]>>) -> usize {
        self.push(Part::Polygon {
            rings,
            speeds: None,
        })
    }

    /// Adds a polygon with a speed for each edge, ring by ring; an edge's speed holds on both sides.
    pub fn weighted_polygon(&mut self, rings: Vec<Vec<[f64; 2]>>, speeds: Vec<Vec<f64>>) -> usize {
        self.push(Part::Polygon {
            rings,
            speeds: Some(speeds),
        })
    }

    /// Adds a polyline (closed if its last point equals its first).
    pub fn polyline(&mut self, points: Vec<[f64; 2]>) -> usize {
        self.push(Part::Line {
            points,
            speeds: None,
        })
    }

    /// Adds a polyline with `[left, right]` speeds for each edge.
    pub fn weighted_polyline(&mut self, points: Vec<[f64; 2]>, speeds: Vec<[f64; 2]>) -> usize {
        self.push(Part::Line {
            points,
            speeds: Some(speeds),
        })
    }

    /// Adds a graph: vertices, and edges as pairs of vertex numbers.
    pub fn graph(&mut self, vertices: Vec<[f64; 2]>, edges: Vec<[usize; 2]>) -> usize {
        self.push(Part::Graph {
            vertices,
            edges,
            speeds: None,
        })
    }

    /// Adds a graph with `[left, right]` speeds for each edge.
    pub fn weighted_graph(
        &mut self,
        vertices: Vec<[f64; 2]>,
        edges: Vec<[usize; 2]>,
        speeds: Vec<[f64; 2]>,
    ) -> usize {
        self.push(Part::Graph {
            vertices,
            edges,
            speeds: Some(speeds),
        })
    }

    /// From a time on, an edge moves at another speed. Speeds at time zero are given with the
    /// edges, so a late start is a speed of zero there and a change here.
    ///
    /// ```
    /// use hipline::input::{Change, Place, Sides};
    ///
    /// let mut builder = hipline::FigureBuilder::new();
    /// let part = builder.polygon(vec![vec![[0., 0.], [8., 0.], [8., 6.], [0., 6.]]]);
    /// // A mansard roof: from the height 1 on, all slopes are a quarter as steep.
    /// for index in 0..4 {
    ///     builder.change(Change {
    ///         edge: Place { part, ring: 0, index },
    ///         sides: Sides::Both,
    ///         time: 1.0,
    ///         speed: 4.0,
    ///     });
    /// }
    /// let skeleton = builder.build()?.skeleton(hipline::Options::default());
    /// let top = skeleton.nodes().iter().map(|node| node.time).fold(0.0, f64::max);
    /// assert_eq!(top, 1.5);
    /// # Ok::<(), hipline::InvalidFigure>(())
    /// ```
    pub fn change(&mut self, change: Change) {
        self.changes.push(change);
    }

    /// Gives a vertex a height: zero or more, in units of time. Vertices without one are at
    /// height zero.
    ///
    /// An edge whose ends are at one height starts to move at that time (and stands still before).
    /// An edge whose ends are at different heights has a tilted eave: its facet rises from
    /// there, with the slope 1 / speed, which must be steeper than the eave itself. `docs/weights.md`
    /// tells more; [`Skeleton::check_heights`](crate::Skeleton::check_heights) whether
    /// all of the figure was reached at its own heights.
    pub fn elevate(&mut self, vertex: Place, height: f64) {
        self.heights.push((vertex, height));
    }

    /// Checks everything and builds the figure.
    ///
    /// # Complexity
    /// O(n log n) expected for n vertices; an input with crossing edges costs more, by the
    /// number of crossings, of which at most [`InvalidFigure::MAX_PAIRS`] are looked for.
    /// O(n) for one polygon without holes that is monotone in some direction.
    ///
    /// # Errors
    /// Every [`Flaw`] of the input, in the caller's own numbering.
    pub fn build(mut self) -> Result<Figure, InvalidFigure> {
        match single::figure(&mut self) {
            Some(figure) => Ok(figure),
            None => self.build_in_general(),
        }
    }

    /// Builds whatever it is, by way of a triangulation.
    pub(super) fn build_in_general(self) -> Result<Figure, InvalidFigure> {
        let mut flaws = Vec::new();
        let changes = Changes::new(&self.changes, &self.parts, &mut flaws);
        let heights = Heights::new(&self.heights, &self.parts, &mut flaws);
        let mut gathered = gather::gather(&self.parts, &changes, heights);
        flaws.append(&mut gathered.flaws);
        if gathered.edges.is_empty() {
            if flaws.is_empty() {
                flaws.push(Flaw::Empty);
            }
            return Err(InvalidFigure { flaws });
        }
        let scale = match Scale::of(&gathered.vertices, &self.parts) {
            Ok(scale) => scale,
            Err(mut range) => {
                flaws.append(&mut range);
                return Err(InvalidFigure { flaws });
            }
        };
        drop(self.parts);
        let vertices = gathered.vertices;
        let heights = gathered.heights.finish(vertices.len());
        let mut edges = gathered.edges;
        let triangulation = triangulate::triangulate(&vertices, &mut edges, scale);
        let mut mesh = match triangulation {
            Ok(mesh) => mesh,
            Err(conflicts) => {
                crossing::report(&vertices, &edges, scale, conflicts, &mut flaws);
                return Err(InvalidFigure { flaws });
            }
        };
        nesting::fill(&vertices, &edges, &mut mesh, &mut flaws);
        let changes = changes.of_edges(&edges);
        height::check(&vertices, &edges, &heights, &changes, &mut flaws);
        if !flaws.is_empty() {
            return Err(InvalidFigure { flaws });
        }
        #[cfg(debug_assertions)]
        if let Err(broken) = mesh.check(&vertices, &edges, scale) {
            panic!("the triangulation is wrong: {broken}");
        }
        let mut degrees = vec![0_u8; vertices.len()];
        for edge in &edges {
            for end in [edge.from, edge.to] {
                degrees[end.index()] = degrees[end.index()].saturating_add(1);
            }
        }
        Ok(Figure {
            terminals: degrees.iter().filter(|&&degree| degree == 1).count(),
            has_polygon: edges.iter().any(|edge| edge.on_ring),
            changes,
            heights,
            vertices,
            edges,
            mesh: mesh.into(),
            monotone: None,
        })
    }
}
