//! What a file holds, as plain data, and the way from there to a checked figure.
//!
//! Nothing here is checked beyond the shape of the data: whether rings cross, edges are too steep or
//! speeds are negative is for [`FigureBuilder`] to find out.

use hipline::{Figure, FigureBuilder};
use serde_json::{Map, Value};

use crate::{
    error::{FeatureName, FigureError, Reason},
    motion::Motion,
};

/// Everything in a file, in its order.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Document {
    /// The features.
    pub features: Vec<Feature>,
}

/// One thing in a file that a skeleton can be computed of.
#[derive(Debug, Clone, PartialEq)]
pub struct Feature {
    /// Its number in the file, from 0.
    pub index: usize,
    /// Its id, if the file gives one.
    pub id: Option<String>,
    /// Whatever else the file says about it.
    pub properties: Map<String, Value>,
    /// Its geometry.
    pub case: Shape,
}

/// A geometry.
#[derive(Debug, Clone, PartialEq)]
pub enum Shape {
    /// No geometry at all (null, or `EMPTY`).
    Empty,
    /// Polygons, one or more.
    Polygons(Vec<PolygonShape>),
    /// Polylines, one or more.
    Lines(Vec<LineShape>),
    /// A graph.
    Graph(GraphShape),
    /// Points, so many of them. No figure can be made of them.
    Points(usize),
    /// Several geometries.
    Collection(Vec<Self>),
}

/// A polygon: its shell, then its holes.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct PolygonShape {
    /// The rings, as the file has them (the last point may repeat the first).
    pub rings: Vec<Vec<[f64; 2]>>,
    /// A weight for each edge, ring by ring: its speed, if it has no profile.
    pub speeds: Option<Vec<Vec<f64>>>,
    /// What else there is to say of each ring, or none of any.
    pub motions: Vec<Motion>,
}

/// A polyline.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct LineShape {
    /// Its points; it is closed if the last equals the first.
    pub points: Vec<[f64; 2]>,
    /// `[left, right]` weights for each edge: its speeds, if it has no profile.
    pub speeds: Option<Vec<[f64; 2]>>,
    /// What else there is to say of it.
    pub motion: Motion,
}

/// A graph.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct GraphShape {
    /// Its vertices.
    pub vertices: Vec<[f64; 2]>,
    /// Its edges, as pairs of vertex numbers.
    pub edges: Vec<[usize; 2]>,
    /// `[left, right]` weights for each edge: its speeds, if it has no profile.
    pub speeds: Option<Vec<[f64; 2]>>,
    /// What else there is to say of it.
    pub motion: Motion,
}

impl PolygonShape {
    /// A polygon without weights.
    #[must_use]
    pub fn new(rings: Vec<Vec<[f64; 2]>>) -> Self {
        Self {
            rings,
            ..Self::default()
        }
    }

    fn add_to(&self, builder: &mut FigureBuilder) {
        let Self {
            rings,
            speeds,
            motions,
        } = self;
        if motions.is_empty() {
            match speeds {
                None => builder.polygon(rings.clone()),
                Some(speeds) => builder.weighted_polygon(rings.clone(), speeds.clone()),
            };
            return;
        }
        let ones = || rings.iter().map(|ring| vec![1.0; edges_of_ring(ring)]);
        let weights = speeds.clone().unwrap_or_else(|| ones().collect());
        let steady = Motion::default();
        let motion = |ring: usize| motions.get(ring).unwrap_or(&steady);
        let first = |(ring, list): (usize, &Vec<f64>)| {
            let speed = |(edge, &w)| motion(ring).first_speed(edge, 0, w);
            list.iter().enumerate().map(speed).collect()
        };
        let first = weights.iter().enumerate().map(first).collect();
        let part = builder.weighted_polygon(rings.clone(), first);
        for (ring, points) in rings.iter().enumerate() {
            let weight = |edge| weights.get(ring).and_then(|list: &Vec<f64>| list.get(edge));
            let pairs: Vec<_> = (0..edges_of_ring(points))
                .map(|edge| [weight(edge).map_or(1.0, |&w| w); 2])
                .collect();
            motion(ring).feed(builder, part, ring, &pairs);
        }
    }
}

impl LineShape {
    /// A line without weights.
    #[must_use]
    pub fn new(points: Vec<[f64; 2]>) -> Self {
        Self {
            points,
            ..Self::default()
        }
    }

    fn add_to(&self, builder: &mut FigureBuilder) {
        let edges = self.points.len().saturating_sub(1);
        let (weights, first) = speeds_of(self.speeds.as_deref(), &self.motion, edges);
        let points = self.points.clone();
        let part = match first {
            None => builder.polyline(points),
            Some(speeds) => builder.weighted_polyline(points, speeds),
        };
        self.motion.feed(builder, part, 0, &weights);
    }
}

impl GraphShape {
    fn add_to(&self, builder: &mut FigureBuilder) {
        let (weights, first) = speeds_of(self.speeds.as_deref(), &self.motion, self.edges.len());
        let (vertices, edges) = (self.vertices.clone(), self.edges.clone());
        let part = match first {
            None => builder.graph(vertices, edges),
            Some(speeds) => builder.weighted_graph(vertices, edges, speeds),
        };
        self.motion.feed(builder, part, 0, &weights);
    }
}

/// The weights of so many edges, and their speeds at the time 0 (none if all are 1).
fn speeds_of(
    given: Option<&[[f64; 2]]>,
    motion: &Motion,
    edges: usize,
) -> (Vec<[f64; 2]>, Option<Vec<[f64; 2]>>) {
    let mut weights = given.map_or_else(|| vec![[1.0; 2]; edges], <[_]>::to_vec);
    let first = (given.is_some() || !motion.is_steady()).then(|| {
        let pair = |(edge, w): (usize, &[f64; 2])| {
            [0, 1].map(|side| motion.first_speed(edge, side, w[side]))
        };
        weights.iter().enumerate().map(pair).collect()
    });
    // That there are too few or too many is for the builder to find.
    weights.resize(edges, [1.0; 2]);
    (weights, first)
}

/// How many edges, and vertices, a ring has, whether its last point repeats the first or not.
pub(crate) fn edges_of_ring(points: &[[f64; 2]]) -> usize {
    points.len() - usize::from(points.len() > 2 && points.first() == points.last())
}

impl Document {
    /// One figure of all features. They share one plane: their wavefronts meet.
    ///
    /// # Errors
    /// See [`Feature::figure`]; the error tells which part of the figure is which feature.
    pub fn together(&self) -> Result<Figure, FigureError> {
        figure(&self.features)
    }
}

impl Feature {
    /// How errors name the feature.
    #[must_use]
    pub fn name(&self) -> FeatureName {
        FeatureName {
            index: self.index,
            id: self.id.clone(),
        }
    }

    /// The figure of this feature alone.
    ///
    /// # Errors
    /// The geometry is empty, has points, or is not a planar straight-line graph; the
    /// error names the feature and every flaw.
    pub fn figure(&self) -> Result<Figure, FigureError> {
        figure(std::slice::from_ref(self))
    }
}

impl Shape {
    /// Whether there is nothing in it.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        match self {
            Self::Empty => true,
            Self::Polygons(polygons) => polygons.is_empty(),
            Self::Lines(lines) => lines.is_empty(),
            Self::Graph(graph) => graph.vertices.is_empty() && graph.edges.is_empty(),
            Self::Points(count) => *count == 0,
            Self::Collection(shapes) => shapes.iter().all(Self::is_empty),
        }
    }

    /// Whether there is a point in it that belongs to no line and no polygon.
    #[must_use]
    pub fn has_points(&self) -> bool {
        match self {
            Self::Points(count) => *count > 0,
            Self::Collection(shapes) => shapes.iter().any(Self::has_points),
            _ => false,
        }
    }

    /// How many points the file gives for it; a ring's closing point counts too.
    #[must_use]
    pub fn points(&self) -> usize {
        match self {
            Self::Empty => 0,
            Self::Polygons(polygons) => polygons.iter().flat_map(|p| &p.rings).map(Vec::len).sum(),
            Self::Lines(lines) => lines.iter().map(|l| l.points.len()).sum(),
            Self::Graph(graph) => graph.vertices.len(),
            Self::Points(count) => *count,
            Self::Collection(shapes) => shapes.iter().map(Self::points).sum(),
        }
    }

    /// Adds the geometry to a builder; returns the number of calls, that is, of parts.
    pub fn add_to(&self, builder: &mut FigureBuilder) -> usize {
        match self {
            Self::Empty | Self::Points(_) => 0,
            Self::Polygons(polygons) => {
                polygons.iter().for_each(|polygon| polygon.add_to(builder));
                polygons.len()
            }
            Self::Lines(lines) => {
                lines.iter().for_each(|line| line.add_to(builder));
                lines.len()
            }
            Self::Graph(graph) => {
                graph.add_to(builder);
                1
            }
            Self::Collection(shapes) => shapes.iter().map(|shape| shape.add_to(builder)).sum(),
        }
    }
}

fn figure(features: &[Feature]) -> Result<Figure, FigureError> {
    let mut builder = FigureBuilder::new();
    let mut parts = Vec::new();
    for (i, feature) in features.iter().enumerate() {
        let count = feature.case.add_to(&mut builder);
        parts.extend(std::iter::repeat_n(i, count));
    }
    let reason = if let Some(feature) = features.iter().position(|f| f.case.has_points()) {
        Reason::Points { feature }
    } else if features.iter().all(|f| f.case.is_empty()) {
        Reason::Empty
    } else {
        match builder.build() {
            Ok(figure) => return Ok(figure),
            Err(flaws) => Reason::Invalid(flaws),
        }
    };
    Err(FigureError {
        features: features.iter().map(Feature::name).collect(),
        parts,
        reason,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn feature(index: usize, id: Option<&str>, case: Shape) -> Feature {
        Feature {
            index,
            id: id.map(str::to_owned),
            properties: Map::new(),
            case,
        }
    }

    #[test]
    fn errors_name_the_feature() {
        let empty = feature(3, Some("lake"), Shape::Collection(vec![Shape::Empty]));
        let error = empty.figure().unwrap_err();
        assert!(error.is_empty_geometry());
        assert_eq!(
            error.to_string(),
            "feature 3 (\"lake\"): the geometry is empty"
        );

        let points = feature(4, None, Shape::Points(2));
        let error = points.figure().unwrap_err();
        assert_eq!(
            error.to_string(),
            "feature 4: a point has no edge, so no wavefront starts from it"
        );

        let document = Document {
            features: vec![empty, points],
        };
        let error = document.together().unwrap_err();
        assert_eq!(
            error.to_string(),
            "2 features together: feature 4: a point has no edge, so no wavefront starts from it"
        );
    }
}
