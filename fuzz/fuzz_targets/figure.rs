//! Small figures on a grid, where nearly everything coincides with something.

use arbitrary::Arbitrary;
use hipline::{Figure, FigureBuilder};

/// A point of a grid of 16 by 16.
#[derive(Debug, Clone, Copy, Arbitrary)]
pub struct Point(u8);

/// One of four speeds.
#[derive(Debug, Clone, Copy, Arbitrary)]
pub struct Speed(u8);

#[derive(Debug, Clone, Arbitrary)]
pub enum Part {
    Polygon(Vec<Vec<(Point, Speed)>>),
    Line(Vec<(Point, [Speed; 2])>),
}

/// What to make a figure of.
#[derive(Debug, Clone, Arbitrary)]
pub struct Shape {
    pub parts: Vec<Part>,
    pub is_weighted: bool,
}

impl Point {
    fn at(self) -> [f64; 2] {
        [f64::from(self.0 >> 4), f64::from(self.0 & 15)]
    }
}

impl Speed {
    fn value(self) -> f64 {
        [1.0, 0.5, 2.0, 3.0][usize::from(self.0 & 3)]
    }
}

impl Shape {
    /// The figure, if it is one, and not too large to be computed quickly.
    pub fn figure(&self) -> Option<Figure> {
        const MOST: usize = 40;
        let size: usize = self.parts.iter().map(Part::size).sum();
        if size > MOST {
            return None;
        }
        let mut builder = FigureBuilder::new();
        for part in &self.parts {
            part.add(&mut builder, self.is_weighted);
        }
        builder.build().ok()
    }
}

impl Part {
    fn size(&self) -> usize {
        match self {
            Self::Polygon(rings) => rings.iter().map(Vec::len).sum(),
            Self::Line(points) => points.len(),
        }
    }

    fn add(&self, builder: &mut FigureBuilder, is_weighted: bool) {
        match self {
            Self::Polygon(rings) => {
                let points = rings.iter().map(|ring| ring.iter().map(|p| p.0.at()).collect());
                let points: Vec<Vec<[f64; 2]>> = points.collect();
                if is_weighted {
                    let speeds = rings.iter().map(|ring| ring.iter().map(|p| p.1.value()).collect());
                    builder.weighted_polygon(points, speeds.collect());
                } else {
                    builder.polygon(points);
                }
            }
            Self::Line(points) => {
                let places: Vec<[f64; 2]> = points.iter().map(|p| p.0.at()).collect();
                if is_weighted {
                    let edges = points.iter().skip(1);
                    let speeds = edges.map(|p| p.1.map(Speed::value)).collect();
                    builder.weighted_polyline(places, speeds);
                } else {
                    builder.polyline(places);
                }
            }
        }
    }
}
