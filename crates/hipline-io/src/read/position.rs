//! Points as files have them, with or without a third coordinate, and the shapes they make.

use crate::{
    document::{LineShape, PolygonShape, Shape},
    motion::Motion,
};

/// A point of a file.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Position {
    /// Its place in the plane.
    pub place: [f64; 2],
    /// Its third coordinate, if there is one.
    pub z: Option<f64>,
}

/// The points of a ring or line.
pub(super) type Chain = Vec<Position>;

/// Places, and third coordinates as a motion has them.
pub(super) fn split(chain: &[Position]) -> (Vec<[f64; 2]>, Motion) {
    let places = chain.iter().map(|p| p.place).collect();
    let mut motion = Motion::default();
    if chain.iter().any(|p| p.z.is_some()) {
        motion.z = chain.iter().map(|p| p.z).collect();
    }
    (places, motion)
}

/// A line of points.
pub(super) fn line(chain: &[Position]) -> LineShape {
    let (points, motion) = split(chain);
    LineShape {
        points,
        motion,
        ..LineShape::default()
    }
}

/// A polygon of rings.
pub(super) fn polygon(rings: &[Chain]) -> PolygonShape {
    let (rings, mut motions): (Vec<_>, Vec<_>) = rings.iter().map(|ring| split(ring)).unzip();
    if motions.iter().all(|motion| motion.z.is_empty()) {
        motions.clear();
    }
    PolygonShape {
        rings,
        motions,
        ..PolygonShape::default()
    }
}

/// All lines that have a point.
pub(super) fn lines(lines: &[Chain]) -> Shape {
    let lines = lines.iter().filter(|points| !points.is_empty());
    Shape::Lines(lines.map(|points| line(points)).collect())
}

/// All polygons that have a point.
pub(super) fn polygons(polygons: &[Vec<Chain>]) -> Shape {
    let polygons = polygons
        .iter()
        .filter(|rings| rings.iter().any(|ring| !ring.is_empty()));
    Shape::Polygons(polygons.map(|rings| polygon(rings)).collect())
}
