//! What a file holds, as plain data, and the way from there to a checked figure.
//!
//! Nothing here is checked beyond the shape of the data: whether rings cross or speeds are
//! positive is for [`FigureBuilder`] to find out.

use hipline::{Figure, FigureBuilder};
use serde_json::{Map, Value};

use crate::error::{FeatureName, FigureError, Reason};

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
    /// A speed for each edge, ring by ring.
    pub speeds: Option<Vec<Vec<f64>>>,
}

/// A polyline.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct LineShape {
    /// Its points; it is closed if the last equals the first.
    pub points: Vec<[f64; 2]>,
    /// `[left, right]` speeds for each edge.
    pub speeds: Option<Vec<[f64; 2]>>,
}

/// A graph.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct GraphShape {
    /// Its vertices.
    pub vertices: Vec<[f64; 2]>,
    /// Its edges, as pairs of vertex numbers.
    pub edges: Vec<[usize; 2]>,
    /// `[left, right]` speeds for each edge.
    pub speeds: Option<Vec<[f64; 2]>>,
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
                for PolygonShape { rings, speeds } in polygons {
                    match speeds {
                        None => builder.polygon(rings.clone()),
                        Some(speeds) => builder.weighted_polygon(rings.clone(), speeds.clone()),
                    };
                }
                polygons.len()
            }
            Self::Lines(lines) => {
                for LineShape { points, speeds } in lines {
                    match speeds {
                        None => builder.polyline(points.clone()),
                        Some(speeds) => builder.weighted_polyline(points.clone(), speeds.clone()),
                    };
                }
                lines.len()
            }
            Self::Graph(GraphShape {
                vertices,
                edges,
                speeds,
            }) => {
                match speeds {
                    None => builder.graph(vertices.clone(), edges.clone()),
                    Some(speeds) => {
                        builder.weighted_graph(vertices.clone(), edges.clone(), speeds.clone())
                    }
                };
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
