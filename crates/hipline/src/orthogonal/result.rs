//! From both skeletons and the merge chain to nodes, arcs and faces.
//!
//! Everything is linked already. One walk around all faces, in the order of their edges, writes the corners and numbers the
//! nodes as it first meets them. Nodes are then written in that order, arcs in the order in which they were drawn, in
//! the memory where they were. So all that is read or written goes along the polygon, and little of it is memory never used before: a
//! large polygon does not fit into any cache, and fresh memory costs more than what is done with it.

use super::{
    graph::{Event, Graph, Link, NONE, Seam, Visits},
    number::Number,
    ring::{Kind, Ring, Side},
    runs::{self, Piece, Step, WallGhost, Walls},
};
use crate::{
    skeleton::{Arc, ArcKind, Face, InputGraph, Node, NodeKind, Region, Skeleton, Stats},
    topology::{EdgeId, FaceId, NodeId, VertexId},
};

/// A node that the walk has not met yet.
const UNNAMED: u32 = u32::MAX;
/// The name of a node is that of another one.
const ALIAS: u32 = 1 << 31;

/// The numbers of nodes in the result.
struct Names {
    vertices: u32,
    of_event: Vec<u32>,
    /// The events in the order of their numbers.
    order: Vec<u32>,
}

impl Names {
    fn new<N: Number>(graph: &mut Graph<'_, N>) -> Self {
        let vertices = graph.ring.count();
        let mut of_event = vec![UNNAMED; graph.events.len()];
        for [event, node] in std::mem::take(&mut graph.same) {
            of_event[(event - vertices) as usize] = ALIAS | node;
        }
        Self {
            vertices,
            order: Vec::with_capacity(of_event.len()),
            of_event,
        }
    }

    #[inline]
    fn id(&mut self, mut node: u32) -> NodeId {
        loop {
            let Some(event) = node.checked_sub(self.vertices) else {
                return NodeId::raw(node);
            };
            let name = &mut self.of_event[event as usize];
            if *name == UNNAMED {
                *name = self.vertices + self.order.len() as u32;
                self.order.push(event);
                return NodeId::raw(*name);
            }
            if *name & ALIAS == 0 {
                return NodeId::raw(*name);
            }
            node = *name & !ALIAS;
        }
    }
}

/// Builds the skeleton.
pub(super) fn skeleton<N: Number>(mut graph: Graph<'_, N>) -> Skeleton {
    let walls = runs::cut(&mut graph);
    let names = Names::new(&mut graph);
    let n = graph.ring.count() as usize;
    let mut walk = Walk {
        walls: &walls,
        names,
        visits: Visits::default(),
        is_cut_off: vec![false; graph.links.len()],
        // What a tree with n leaves has at most.
        corners: Vec::with_capacity(5 * n),
        cycles: Vec::with_capacity(n + 1),
        graph: &graph,
    };
    walk.collect();
    let Walk {
        mut corners,
        cycles,
        mut names,
        is_cut_off,
        ..
    } = walk;
    corners.shrink_to_fit();
    let Graph {
        ring,
        events,
        links,
        borders,
        seams,
        steps,
        ..
    } = graph;
    drop(borders);
    let arcs = Arcs {
        ring: &ring,
        walls: &walls,
        names: &mut names,
    };
    let arcs = arcs.collect(links, &is_cut_off, &seams);
    let Names { order, .. } = names;
    // The list of nodes is the largest of all; what is not needed any more goes before.
    drop((seams, is_cut_off, walls));
    let nodes = nodes(&ring, &events, &order);
    drop((events, order));
    let ids = 0..n as u32;
    let side = if ring.is_forward() {
        crate::skeleton::Side::Left
    } else {
        crate::skeleton::Side::Right
    };
    let faces = ids.clone().map(|e| Face {
        edge: EdgeId::raw(e),
        side,
        phase: 0,
        cycles: [e, e + 1],
    });
    let next = |v: u32| if v as usize + 1 < n { v + 1 } else { 0 };
    Skeleton {
        nodes,
        arcs,
        faces: faces.collect(),
        cycles,
        corners,
        input: InputGraph {
            vertices: n,
            // Such a figure is one ring.
            edges: ids.map(|v| [v, next(v)].map(VertexId::raw)).collect(),
            terminals: 0,
        },
        region: Region::Interior,
        stats: Stats {
            steps,
            ..Stats::default()
        },
    }
}

/// The vertices, then events as numbered, correctly rounded.
fn nodes<N: Number>(ring: &Ring<'_>, events: &[Event<N>], order: &[u32]) -> Vec<Node> {
    let mut nodes = Vec::with_capacity(ring.points().len() + order.len());
    nodes.extend(ring.points().iter().enumerate().map(|(v, &[x, y])| Node {
        x,
        y,
        time: 0.0,
        kind: NodeKind::Input(VertexId::new(v)),
    }));
    nodes.extend(order.iter().map(|&event| {
        let Event { place, time } = events[event as usize];
        let [x, y] = ring.round(place);
        Node {
            x,
            y,
            time: ring.round_time(time),
            kind: NodeKind::Event,
        }
    }));
    nodes
}

/// The walk around all faces.
struct Walk<'g, 'a, N> {
    graph: &'g Graph<'a, N>,
    walls: &'g Walls,
    names: Names,
    visits: Visits,
    /// The links beyond the merge chain.
    is_cut_off: Vec<bool>,
    corners: Vec<NodeId>,
    cycles: Vec<u32>,
}

impl<N: Number> Walk<'_, '_, N> {
    fn collect(&mut self) {
        let ring = &self.graph.ring;
        self.cycles.push(0);
        for edge in 0..ring.count() {
            let wave = ring.wave(edge);
            let first = self.corners.len();
            let [west, east] = ring.base(wave);
            self.corners.push(NodeId::raw(west));
            self.corners.push(NodeId::raw(east));
            self.around(wave);
            if let Some(corners) = self.walls.corners(wave) {
                // One of several edges of a wall: the corners of its own piece of the joint face.
                self.corners.truncate(first + 2);
                for &node in corners {
                    self.add(node);
                }
            }
            while self.corners.len() > first + 2
                && self.corners.last() == Some(&self.corners[first])
            {
                self.corners.pop();
            }
            if ring.side(wave) == Side::Upper {
                // So far seen from the upper chain, which is a mirror image.
                self.corners.swap(first, first + 1);
                self.corners[first + 2..].reverse();
            }
            self.cycles.push(self.corners.len() as u32);
        }
    }

    /// Adds a corner unless it is the last one already.
    #[inline]
    fn add(&mut self, node: u32) {
        let corner = self.names.id(node);
        if self.corners.last() != Some(&corner) {
            self.corners.push(corner);
        }
    }

    /// The corners of a face, seen from its chain, from the east end of its edge to the west end.
    fn around(&mut self, wave: u32) {
        let graph = self.graph;
        let border = graph.borders[wave as usize];
        let mut link = border.right_first;
        while link != NONE {
            let arc = graph.link(link);
            for piece in pieces(self.walls, Step::Link(link)) {
                self.add(piece.ends[1]);
            }
            self.add(arc.to);
            let is_last = link == border.right_last;
            link = arc.after;
            if is_last {
                break;
            }
        }
        while link != NONE {
            self.is_cut_off[link as usize] = true;
            link = graph.link(link).after;
        }
        for seam in graph.visits(&mut self.visits, wave).rev() {
            for piece in pieces(self.walls, Step::Seam(seam)).iter().rev() {
                self.add(piece.ends[1]);
            }
            self.add(graph.seams[seam as usize].from);
        }
        let mut link = border.left_last;
        while link != NONE {
            let arc = graph.link(link);
            for piece in pieces(self.walls, Step::Link(link)).iter().rev() {
                self.add(piece.ends[1]);
            }
            self.add(arc.from);
            link = arc.below;
        }
    }
}

/// What makes arcs.
struct Arcs<'g, 'a> {
    ring: &'g Ring<'a>,
    walls: &'g Walls,
    names: &'g mut Names,
}

impl Arcs<'_, '_> {
    /// The arcs that are left of both skeletons, then the merge chain, then those that ghost arcs of walls cut, and these.
    fn collect(mut self, links: Vec<Link>, is_cut_off: &[bool], seams: &[Seam]) -> Vec<Arc> {
        let mut rest = Vec::new();
        let walls = self.walls;
        if !walls.ghosts.is_empty() {
            for (at, link) in links.iter().enumerate() {
                for piece in pieces(walls, Step::Link(at as u32)) {
                    rest.extend(self.of_link(link, *piece));
                }
            }
            for (at, seam) in seams.iter().enumerate() {
                for piece in pieces(walls, Step::Seam(at as u32)) {
                    rest.extend(self.of_seam(seam, *piece));
                }
            }
            for ghost in &walls.ghosts {
                rest.extend(self.of_ghost(ghost));
            }
        }
        // Takes over the memory of the links.
        let whole = links.into_iter().zip(is_cut_off).enumerate();
        let arcs = whole.filter_map(|(at, (link, &is_cut_off))| {
            let is_whole = !is_cut_off && pieces(walls, Step::Link(at as u32)).is_empty();
            let piece = Piece {
                ends: [link.from, link.to],
                faces: [link.west, link.east],
            };
            is_whole.then(|| self.of_link(&link, piece)).flatten()
        });
        let mut arcs: Vec<Arc> = arcs.collect();
        for (at, seam) in seams.iter().enumerate() {
            if pieces(walls, Step::Seam(at as u32)).is_empty() {
                let piece = Piece {
                    ends: [seam.from, seam.to],
                    faces: [seam.lower, seam.upper],
                };
                arcs.extend(self.of_seam(seam, piece));
            }
        }
        arcs.append(&mut rest);
        arcs.shrink_to_fit();
        arcs
    }

    /// An arc, unless it has no length.
    #[inline]
    fn arc(&mut self, ends: [u32; 2], faces: [u32; 2], kind: ArcKind) -> Option<Arc> {
        let nodes = [self.names.id(ends[0]), self.names.id(ends[1])];
        let faces = [self.ring.edge(faces[0]), self.ring.edge(faces[1])];
        let faces = [FaceId::raw(faces[0]), FaceId::raw(faces[1])];
        (nodes[0] != nodes[1]).then_some(Arc { nodes, faces, kind })
    }

    #[inline]
    fn of_link(&mut self, link: &Link, Piece { ends, faces }: Piece) -> Option<Arc> {
        let kind = match [self.ring.kind(link.west), self.ring.kind(link.east)] {
            [Kind::Level, Kind::Level] => ArcKind::Ghost,
            [Kind::Level, Kind::East] | [Kind::West, Kind::Level] => ArcKind::Valley,
            _ => ArcKind::Ridge,
        };
        let [west, east] = faces;
        let faces = match self.ring.side(link.west) {
            Side::Lower => [west, east],
            Side::Upper => [east, west],
        };
        self.arc(ends, faces, kind)
    }

    #[inline]
    fn of_seam(&mut self, seam: &Seam, Piece { ends, faces }: Piece) -> Option<Arc> {
        let kinds = [self.ring.kind(seam.lower), self.ring.kind(seam.upper)];
        let kind = match kinds {
            [Kind::East, Kind::East] | [Kind::West, Kind::West] => ArcKind::Ghost,
            _ => ArcKind::Ridge,
        };
        let [[from, to], [lower, upper]] = [ends, faces];
        // In the order in which the wavefront reaches its ends, with the face on the left first. A wall that moves
        // west is further west later.
        if kinds.contains(&Kind::West) && !kinds.contains(&Kind::East) {
            self.arc([to, from], [lower, upper], kind)
        } else {
            self.arc([from, to], [upper, lower], kind)
        }
    }

    fn of_ghost(&mut self, ghost: &WallGhost) -> Option<Arc> {
        // Going east in the lower chain, what is above is on the left.
        let turned = (self.ring.side(ghost.below) == Side::Upper)
            != (self.ring.kind(ghost.below) == Kind::West);
        let faces = if turned {
            [ghost.below, ghost.above]
        } else {
            [ghost.above, ghost.below]
        };
        self.arc([ghost.vertex, ghost.end], faces, ArcKind::Ghost)
    }
}

/// The pieces of an arc that borders a wall of several edges; of others, none.
#[inline]
fn pieces(walls: &Walls, step: Step) -> &[Piece] {
    walls.pieces(step).unwrap_or_default()
}
