//! The rings, lines and graphs of a shape in a row, in the order of the file: what weights and
//! heights are given to, whatever the shape is.

use crate::{
    document::{GraphShape, LineShape, PolygonShape, Shape, edges_of_ring},
    motion::Motion,
};

/// A ring, a line or a graph, with the places for its weights.
pub(crate) struct Chain<'a> {
    /// How many edges it has.
    pub edges: usize,
    /// How many vertices; a closing point is none.
    pub vertices: usize,
    weights: Weights<'a>,
    /// What else there is to say of it.
    pub motion: &'a mut Motion,
    /// First and last point, if the last one repeats the first.
    ends: Option<[usize; 2]>,
}

enum Weights<'a> {
    Ring(&'a mut Vec<f64>),
    Pairs(&'a mut Vec<[f64; 2]>),
}

impl Chain<'_> {
    /// Whether its edges have one weight for both sides.
    pub fn is_ring(&self) -> bool {
        matches!(self.weights, Weights::Ring(_))
    }

    /// The weights of an edge, left and right.
    pub fn weight(&self, edge: usize) -> [f64; 2] {
        match &self.weights {
            Weights::Ring(list) => [list[edge]; 2],
            Weights::Pairs(list) => list[edge],
        }
    }

    /// Gives an edge its weights; of a ring, the left one counts.
    pub fn set_weight(&mut self, edge: usize, pair: [f64; 2]) {
        match &mut self.weights {
            Weights::Ring(list) => list[edge] = pair[0],
            Weights::Pairs(list) => list[edge] = pair,
        }
    }

    /// Takes the third coordinates as heights of the vertices that have none yet.
    pub fn heights_from_z(&mut self) -> Result<(), String> {
        let z = std::mem::take(&mut self.motion.z);
        let at = |vertex: usize| z.get(vertex).copied().flatten();
        for vertex in 0..self.vertices {
            let height = at(vertex).ok_or_else(|| {
                format!("vertex {vertex} has no third coordinate to be its height")
            })?;
            self.motion.heights.entry(vertex).or_insert(height);
        }
        match self.ends.map(|ends| ends.map(at)) {
            Some([Some(first), Some(last)]) if first.to_bits() != last.to_bits() => Err(format!(
                "it starts at the height {first} and ends there at the height {last}"
            )),
            _ => Ok(()),
        }
    }
}

/// The chains of a shape. Where there are no weights yet, they become 1.
pub(crate) fn chains(shape: &mut Shape) -> Vec<Chain<'_>> {
    let mut list = Vec::new();
    collect(shape, &mut list);
    list
}

/// Takes the third coordinates of a shape as heights of the vertices that have none yet.
pub(crate) fn heights_from_z(shape: &mut Shape) -> Result<(), String> {
    let mut numbered = chains(shape).into_iter().enumerate();
    numbered.try_for_each(|(i, mut chain)| {
        let error = |e| format!("ring or line {i}: {e}");
        chain.heights_from_z().map_err(error)
    })
}

fn collect<'a>(shape: &'a mut Shape, list: &mut Vec<Chain<'a>>) {
    match shape {
        Shape::Empty | Shape::Points(_) => {}
        Shape::Polygons(polygons) => polygons.iter_mut().for_each(|p| of_polygon(p, list)),
        Shape::Lines(lines) => list.extend(lines.iter_mut().map(of_line)),
        Shape::Graph(graph) => list.push(of_graph(graph)),
        Shape::Collection(shapes) => shapes.iter_mut().for_each(|s| collect(s, list)),
    }
}

fn of_polygon<'a>(polygon: &'a mut PolygonShape, list: &mut Vec<Chain<'a>>) {
    let PolygonShape {
        rings,
        speeds,
        motions,
    } = polygon;
    let speeds = speeds.get_or_insert_with(Vec::new);
    speeds.resize(rings.len(), Vec::new());
    motions.resize(rings.len(), Motion::default());
    for ((ring, speeds), motion) in rings.iter().zip(speeds).zip(motions) {
        let edges = edges_of_ring(ring);
        speeds.resize(edges, 1.0);
        list.push(Chain {
            edges,
            vertices: edges,
            weights: Weights::Ring(speeds),
            motion,
            ends: (edges < ring.len()).then_some([0, edges]),
        });
    }
}

fn of_line(line: &mut LineShape) -> Chain<'_> {
    let edges = line.points.len().saturating_sub(1);
    let vertices = edges_of_ring(&line.points);
    Chain {
        edges,
        vertices,
        weights: Weights::Pairs(pairs(&mut line.speeds, edges)),
        motion: &mut line.motion,
        ends: (vertices < line.points.len()).then_some([0, vertices]),
    }
}

fn of_graph(graph: &mut GraphShape) -> Chain<'_> {
    let edges = graph.edges.len();
    Chain {
        edges,
        vertices: graph.vertices.len(),
        weights: Weights::Pairs(pairs(&mut graph.speeds, edges)),
        motion: &mut graph.motion,
        ends: None,
    }
}

fn pairs(speeds: &mut Option<Vec<[f64; 2]>>, edges: usize) -> &mut Vec<[f64; 2]> {
    let list = speeds.get_or_insert_with(Vec::new);
    list.resize(edges, [1.0; 2]);
    list
}
