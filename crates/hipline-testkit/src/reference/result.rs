//! The result of the reference engine, rounded once, at the very end.

use hipline::skeleton::{ArcKind, Region, Side};

use super::graph::Graph;
use super::model::{Model, Plane};
use super::wave::{RawArc, RawNode, Wave};

/// What a node is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum RefKind {
    /// A vertex of the input.
    Input,
    /// A place where something happens.
    Event,
    /// The far end of an unbounded arc, with the velocity of the vertex that traces it.
    Infinite([f64; 2]),
}

/// A node; all numbers correctly rounded. One at infinity is at the place of its arc's other
/// end, and its time is infinite.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RefNode {
    /// Where it is.
    pub place: [f64; 2],
    /// When the wavefront gets there.
    pub time: f64,
    /// What it is.
    pub kind: RefKind,
}

/// An arc.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RefArc {
    /// Numbers of its nodes; the wavefront reaches the first one first.
    pub nodes: [usize; 2],
    /// The faces on its left and on its right (numbers in [`Reference::faces`]).
    pub faces: [usize; 2],
    /// What it is.
    pub kind: ArcKind,
}

/// A straight skeleton, as the reference engine has it.
#[derive(Debug, Clone, PartialEq)]
pub struct Reference {
    /// First the vertices of the input, in order.
    pub nodes: Vec<RefNode>,
    /// The arcs.
    pub arcs: Vec<RefArc>,
    /// The faces: edge, side and phase. First those of phase 0, by edge, then side.
    pub faces: Vec<(usize, Side, u32)>,
    /// Which faces are in the region asked for.
    pub covered: Vec<bool>,
    /// At how many different moments something happened.
    pub moments: usize,
}

/// The straight skeleton of a small graph.
///
/// # Complexity
/// About O(n^3) exact comparisons.
///
/// # Panics
/// If the graph is not a planar straight-line graph.
#[must_use]
pub fn reference(graph: &Graph, region: Region) -> Reference {
    let model = Model::new(graph);
    let region = match region {
        Region::Auto if graph.edges.iter().any(|edge| edge.on_ring) => Region::Interior,
        Region::Auto => Region::Both,
        other => other,
    };
    let halves: &[bool] = match region {
        Region::Interior => &[true],
        Region::Exterior => &[false],
        _ => &[true, false],
    };
    let mut result = Reference {
        nodes: Vec::new(),
        arcs: Vec::new(),
        faces: model.planes[..model.courses].iter().map(name).collect(),
        covered: model
            .inside
            .iter()
            .map(|inside| halves.contains(inside))
            .collect(),
        moments: 0,
    };
    // The two halves of the plane never touch, so each has a simulation of its own.
    for &half in halves {
        let mut wave = Wave::start(&model, |face| model.inside[face] == half);
        while let Some(time) = wave.next_moment() {
            wave.advance(time);
            result.moments += 1;
            assert!(
                result.moments <= 100 * (model.planes.len() + 1),
                "the wavefront never comes to rest"
            );
        }
        wave.escape();
        result.add(&model, &wave);
    }
    result
}

/// How the faces on a plane are called.
const fn name(plane: &Plane) -> (usize, Side, u32) {
    (plane.edge, plane.side, plane.phase)
}

impl Wave<'_> {
    /// What is left goes on for ever.
    fn escape(&mut self) {
        for piece in 0..self.pieces.len() {
            let corner = self.pieces[piece].corner.clone();
            let velocity = [0, 1].map(|axis| corner.motion.speed(&self.model.field, axis));
            self.nodes.push(RawNode::Infinite {
                from: corner.origin,
                velocity,
            });
            self.finish(&corner, self.nodes.len() - 1);
        }
    }
}

impl Reference {
    /// Adds one half of the plane; the vertices of the input are shared.
    fn add(&mut self, model: &Model, wave: &Wave) {
        let field = &model.field;
        let vertices = model.points.len();
        let skip = if self.nodes.is_empty() { 0 } else { vertices };
        let offset = self.nodes.len() - skip;
        for (index, node) in wave.nodes.iter().enumerate().skip(skip) {
            let rounded = match node {
                RawNode::Finite { place, time } => RefNode {
                    place: [0, 1].map(|k| place[k].round(field, -model.place_bits)),
                    time: time.round(field, model.speed_bits - model.place_bits),
                    kind: if index < vertices {
                        RefKind::Input
                    } else {
                        RefKind::Event
                    },
                },
                RawNode::Infinite { from, velocity } => RefNode {
                    place: self.nodes[if *from < vertices {
                        *from
                    } else {
                        from + offset
                    }]
                    .place,
                    time: f64::INFINITY,
                    kind: RefKind::Infinite(
                        [0, 1].map(|k| velocity[k].round(field, -model.speed_bits)),
                    ),
                },
            };
            self.nodes.push(rounded);
        }
        let number = |node: usize| if node < vertices { node } else { node + offset };
        let later = self.faces.len() - model.courses;
        for &plane in &wave.faces[model.courses..] {
            self.faces.push(name(&model.planes[plane]));
            self.covered.push(true);
        }
        let face = |face: usize| {
            if face < model.courses {
                face
            } else {
                face + later
            }
        };
        self.arcs.extend(
            wave.arcs
                .iter()
                .map(|&RawArc { nodes, faces, kind }| RefArc {
                    nodes: nodes.map(number),
                    faces: faces.map(face),
                    kind,
                }),
        );
    }

    /// Whether the surface passes through every edge at its heights: each wall goes from the ground to its
    /// eave, from end to end.
    #[must_use]
    pub fn reaches_heights(&self, graph: &Graph) -> bool {
        let walls = self
            .faces
            .iter()
            .enumerate()
            .filter(|&(face, &(edge, side, phase))| {
                let high = graph.edges[edge]
                    .ends
                    .iter()
                    .any(|&end| graph.height(end) > 0.0);
                let is_wall = phase == 0 && matches!(side, Side::Left | Side::Right);
                self.covered[face] && is_wall && high
            });
        walls
            .map(|(face, &(edge, ..))| (face, edge))
            .all(|(face, edge)| {
                let ends = graph.edges[edge].ends;
                let is_top = |node: &RefNode, end: usize| {
                    let at = |k: usize| node.place[k].total_cmp(&graph.vertices[end][k]).is_eq();
                    (0..2).all(at) && node.time.total_cmp(&graph.height(end)).is_eq()
                };
                let beside = self.arcs.iter().filter(|arc| arc.faces.contains(&face));
                let nodes = || {
                    beside
                        .clone()
                        .flat_map(|arc| arc.nodes)
                        .map(|node| &self.nodes[node])
                };
                let fits =
                    |node: &RefNode| node.time <= 0.0 || ends.iter().any(|&end| is_top(node, end));
                nodes().all(fits)
                    && ends.iter().all(|&end| {
                        graph.height(end) <= 0.0 || nodes().any(|node| is_top(node, end))
                    })
            })
    }

    /// The number of arcs at each node.
    #[must_use]
    pub fn degrees(&self) -> Vec<usize> {
        let mut degrees = vec![0; self.nodes.len()];
        for node in self.arcs.iter().flat_map(|arc| arc.nodes) {
            degrees[node] += 1;
        }
        degrees
    }
}
