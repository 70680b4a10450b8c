//! Nodes, arcs, faces: plain data with typed ids.

use super::Stats;
use crate::topology::{ArcId, EdgeId, FaceId, NodeId, VertexId};

/// Which part of the plane to cover.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub enum Region {
    /// The interior for figures with a polygon, the whole plane for others.
    #[default]
    Auto,
    /// The inside of the polygons.
    Interior,
    /// The plane without the inside of the polygons.
    Exterior,
    /// The whole plane.
    Both,
}

/// How to compute.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[non_exhaustive]
pub struct Options {
    /// Which part of the plane.
    pub region: Region,
    /// Whether each edge is a figure of its own: see [`Options::modified`].
    pub modified: bool,
}

impl Options {
    /// Covers the given part of the plane.
    #[must_use]
    pub const fn region(mut self, region: Region) -> Self {
        self.region = region;
        self
    }

    /// Asks for the *modified* straight skeleton (Aichholzer & Aurenhammer 1996, section 5): every
    /// edge is a figure of its own, and sends out a rectangle. Outside of acute angles the wavefront
    /// then has two edges more, perpendicular to those that form the angle, and so no reflex vertex of it
    /// is faster than the square root of two. Without acute angles it is the straight skeleton itself.
    ///
    /// At a vertex of more than two edges that is so if all of them lie within less than 90 degrees.
    /// Elsewhere nothing differs.
    ///
    /// Only for speeds of one that never change, and no heights: [`Figure::skeleton_by`] refuses
    /// others, [`Figure::skeleton`] leaves the option without effect.
    ///
    /// [`Figure::skeleton`]: crate::Figure::skeleton
    /// [`Figure::skeleton_by`]: crate::Figure::skeleton_by
    #[must_use]
    pub const fn modified(mut self, modified: bool) -> Self {
        self.modified = modified;
        self
    }
}

/// What a node is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum NodeKind {
    /// A vertex of the input; its time is 0.
    Input(VertexId),
    /// A place where wavefronts meet, or where a ghost arc ends.
    Event,
    /// The far end of an unbounded arc. `direction` is the velocity of the wavefront
    /// vertex there (input units per unit of time), correctly rounded; the node's place is
    /// that of the arc's other end, and its time is infinite.
    Infinite {
        /// The velocity with which the arc is traced.
        direction: [f64; 2],
    },
}

/// A node. Coordinates and time are correctly rounded: the f64 nearest to the exact value.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Node {
    /// Abscissa, in input units.
    pub x: f64,
    /// Ordinate, in input units.
    pub y: f64,
    /// The moment when the wavefront arrives: distance moved by an edge of unit speed.
    pub time: f64,
    /// What it is.
    pub kind: NodeKind,
}

/// What an arc is, as seen from the unswept side, on the roof.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum ArcKind {
    /// Traced by a convex wavefront vertex, or where parallel edges meet face to face.
    Ridge,
    /// Traced by a reflex wavefront vertex.
    Valley,
    /// Between two faces of one plane; perpendicular to their edges.
    Ghost,
    /// Of one height, where the speed of an edge changes: between two faces of one edge.
    Crease,
}

/// An arc: a straight segment between two nodes, with a face on either side.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Arc {
    /// Its ends, in the order in which the wavefront reaches them (of an arc of one
    /// height, the order is arbitrary but reproducible).
    pub nodes: [NodeId; 2],
    /// The faces on its left and on its right, walking from the first node to the second.
    pub faces: [FaceId; 2],
    /// What it is.
    pub kind: ArcKind,
}

/// Where a face starts, relative to its input edge.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Side {
    /// On the left of the edge.
    Left,
    /// On the right of the edge.
    Right,
    /// Beyond the edge's first vertex: a terminal, or in a modified skeleton an acute angle.
    Start,
    /// Beyond the edge's second vertex: a terminal, or in a modified skeleton an acute angle.
    End,
}

/// A face: what the wavefront of one side of an edge, or of a terminal, sweeps on one plane.
///
/// Where the speed is zero, the plane stands upright, and so the face has no area in plan.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Face {
    /// The input edge.
    pub edge: EdgeId,
    /// Which side of it.
    pub side: Side,
    /// How often the speed of the edge has changed when the face starts. Faces of phase 0
    /// start at the input, others at a crease.
    pub phase: u32,
    pub(crate) cycles: [u32; 2],
}

/// The graph a skeleton belongs to, as computed (edges split where others touch them).
#[derive(Debug, Clone, PartialEq, Default)]
pub struct InputGraph {
    /// Number of vertices; node `i` is vertex `i` for `i` below it.
    pub vertices: usize,
    /// The edges, as pairs of vertices.
    pub edges: Vec<[VertexId; 2]>,
    /// Number of vertices of degree one.
    pub terminals: usize,
}

/// A straight skeleton.
///
/// The first nodes are the input vertices, in order. Everything is reached through typed
/// ids; lists never change.
#[derive(Debug, Clone, PartialEq)]
pub struct Skeleton {
    pub(crate) nodes: Vec<Node>,
    pub(crate) arcs: Vec<Arc>,
    pub(crate) faces: Vec<Face>,
    /// `cycles[k]..cycles[k + 1]` are the corners of boundary cycle k in `corners`.
    pub(crate) cycles: Vec<u32>,
    pub(crate) corners: Vec<NodeId>,
    pub(crate) input: InputGraph,
    pub(crate) region: Region,
    pub(crate) stats: Stats,
}

impl Skeleton {
    /// A skeleton from its parts, such as a file holds them; the counts of
    /// [`Skeleton::stats`] are zero. A face is its edge, its side, its phase and its boundary cycles,
    /// the outer one first.
    ///
    /// Only the references are checked; that the parts are the skeleton of anything is
    /// not.
    ///
    /// # Errors
    /// The first reference that leads nowhere, the first face without a boundary, fewer
    /// nodes than input vertices, or [`Region::Auto`].
    pub fn from_parts(
        nodes: Vec<Node>,
        arcs: Vec<Arc>,
        faces: Vec<(EdgeId, Side, u32, Vec<Vec<NodeId>>)>,
        input: InputGraph,
        region: Region,
    ) -> Result<Self, String> {
        if region == Region::Auto {
            return Err("the region of a skeleton is interior, exterior or both".to_owned());
        }
        if input.vertices > nodes.len() {
            return Err(format!(
                "{} nodes cannot hold {} input vertices",
                nodes.len(),
                input.vertices
            ));
        }
        for (i, node) in nodes.iter().enumerate() {
            if matches!(node.kind, NodeKind::Input(v) if v.index() >= input.vertices) {
                return Err(format!(
                    "node {i} is {:?}, but there is no such vertex",
                    node.kind
                ));
            }
        }
        for (i, edge) in input.edges.iter().enumerate() {
            if let Some(v) = edge.iter().find(|v| v.index() >= input.vertices) {
                return Err(format!(
                    "edge {i} ends at {v:?}, but there is no such vertex"
                ));
            }
        }
        for (i, arc) in arcs.iter().enumerate() {
            if let Some(n) = arc.nodes.iter().find(|n| n.index() >= nodes.len()) {
                return Err(format!("arc {i} ends at {n:?}, but there is no such node"));
            }
            if let Some(f) = arc.faces.iter().find(|f| f.index() >= faces.len()) {
                return Err(format!("arc {i} borders {f:?}, but there is no such face"));
            }
        }
        let mut skeleton = Self {
            nodes,
            arcs,
            faces: Vec::with_capacity(faces.len()),
            cycles: vec![0],
            corners: Vec::new(),
            input,
            region,
            stats: Stats::default(),
        };
        let index = |n: usize| u32::try_from(n).map_err(|_| "more than 2^32 corners".to_owned());
        for (i, (edge, side, phase, boundaries)) in faces.into_iter().enumerate() {
            if edge.index() >= skeleton.input.edges.len() {
                return Err(format!(
                    "face {i} starts at {edge:?}, but there is no such edge"
                ));
            }
            if boundaries.is_empty() {
                return Err(format!("face {i} has no boundary"));
            }
            let first = index(skeleton.cycles.len() - 1)?;
            for boundary in boundaries {
                if let Some(n) = boundary.iter().find(|n| n.index() >= skeleton.nodes.len()) {
                    return Err(format!(
                        "face {i} has the corner {n:?}, but there is no such node"
                    ));
                }
                skeleton.corners.extend(boundary);
                skeleton.cycles.push(index(skeleton.corners.len())?);
            }
            let end = index(skeleton.cycles.len() - 1)?;
            skeleton.faces.push(Face {
                edge,
                side,
                phase,
                cycles: [first, end],
            });
        }
        Ok(skeleton)
    }

    /// All nodes; the first [`InputGraph::vertices`] are the input's.
    #[must_use]
    pub fn nodes(&self) -> &[Node] {
        &self.nodes
    }

    /// All arcs.
    #[must_use]
    pub fn arcs(&self) -> &[Arc] {
        &self.arcs
    }

    /// All faces, ordered by edge, then side, then phase.
    #[must_use]
    pub fn faces(&self) -> &[Face] {
        &self.faces
    }

    /// One node.
    #[must_use]
    pub fn node(&self, id: NodeId) -> &Node {
        &self.nodes[id.index()]
    }

    /// One arc.
    #[must_use]
    pub fn arc(&self, id: ArcId) -> &Arc {
        &self.arcs[id.index()]
    }

    /// One face.
    #[must_use]
    pub fn face(&self, id: FaceId) -> &Face {
        &self.faces[id.index()]
    }

    /// The nodes around a face, counterclockwise: the outer boundary. It starts with the
    /// two ends of the input edge (one node for a terminal), or of the crease where it starts,
    /// the face on their left. An
    /// unbounded face has a pair of infinite nodes in a row; or two such pairs, where its
    /// wavefront was split and both pieces go on for ever.
    #[must_use]
    pub fn boundary(&self, face: FaceId) -> &[NodeId] {
        self.cycle(self.faces[face.index()].cycles[0])
    }

    /// Inner boundaries of a face, clockwise. Without weights there are none.
    pub fn holes(&self, face: FaceId) -> impl Iterator<Item = &[NodeId]> {
        let [first, end] = self.faces[face.index()].cycles;
        (first + 1..end).map(|k| self.cycle(k))
    }

    fn cycle(&self, k: u32) -> &[NodeId] {
        let k = k as usize;
        &self.corners[self.cycles[k] as usize..self.cycles[k + 1] as usize]
    }

    /// The input graph as computed.
    #[must_use]
    pub const fn input(&self) -> &InputGraph {
        &self.input
    }

    /// Which part of the plane is covered (never [`Region::Auto`]).
    #[must_use]
    pub const fn region(&self) -> Region {
        self.region
    }

    /// Whether it is a modified skeleton that differs from the unmodified one: some face starts
    /// beyond the end of an edge where other edges start, too. See [`Options::modified`].
    ///
    /// # Complexity
    /// O(n).
    #[must_use]
    pub fn is_modified(&self) -> bool {
        let mut degree = vec![0_u8; self.input.vertices];
        for v in self.input.edges.iter().flatten() {
            degree[v.index()] = (degree[v.index()] + 1).min(2);
        }
        self.faces.iter().any(|face| {
            let [from, to] = self.input.edges[face.edge.index()];
            match face.side {
                Side::Left | Side::Right => false,
                Side::Start => degree[from.index()] > 1,
                Side::End => degree[to.index()] > 1,
            }
        })
    }

    /// Whether it is that of one side of a [`Chain`](crate::Chain): it covers neither side of the plane.
    #[must_use]
    pub fn is_of_chain(&self) -> bool {
        let mut sides = self.faces.iter().map(|face| face.side);
        self.region == Region::Both
            && sides
                .next()
                .is_some_and(|first| sides.all(|side| side == first))
    }

    /// What the computation did.
    #[must_use]
    pub const fn stats(&self) -> &Stats {
        &self.stats
    }
}
