//! From both skeletons and the merge chain to nodes, arcs and faces.
//!
//! Everything is linked already, so faces are read off in one pass, into flat lists; nodes are numbered as arcs
//! first meet them.

use super::{
    graph::{Graph, NONE},
    number::Number,
    ring::{Kind, Side},
    runs::{self, Piece, Step, Visits, Walls},
};
use crate::{
    skeleton::{Arc, ArcKind, Face, InputGraph, Node, NodeKind, Region, Skeleton, Stats},
    topology::{EdgeId, FaceId, NodeId, VertexId},
};

/// A node that no arc has met yet.
const UNNAMED: u32 = u32::MAX;
/// The name of a node is that of another one.
const ALIAS: u32 = 1 << 31;

/// The numbers of nodes in the result.
struct Names {
    vertices: u32,
    events: Vec<u32>,
    count: u32,
}

impl Names {
    fn of(&mut self, mut node: u32) -> u32 {
        loop {
            let Some(event) = node.checked_sub(self.vertices) else {
                return node;
            };
            let name = &mut self.events[event as usize];
            if *name == UNNAMED {
                *name = self.count;
                self.count += 1;
                return *name;
            }
            if *name & ALIAS == 0 {
                return *name;
            }
            node = *name & !ALIAS;
        }
    }

    fn id(&mut self, node: u32) -> NodeId {
        NodeId::raw(self.of(node))
    }
}

/// Builds the skeleton.
pub(super) fn skeleton<N: Number>(mut graph: Graph<'_, N>, input: InputGraph) -> Skeleton {
    let visits = visits(&graph);
    let walls = runs::cut(&mut graph, &visits);
    let mut names = Names {
        vertices: graph.ring.count(),
        events: vec![UNNAMED; graph.events.len()],
        count: graph.ring.count(),
    };
    for [event, node] in std::mem::take(&mut graph.same) {
        names.events[(event - names.vertices) as usize] = ALIAS | node;
    }
    let mut collector = Collector {
        arcs: Vec::with_capacity(2 * graph.ring.count() as usize),
        graph,
        walls,
        names,
    };
    collector.collect_arcs();
    let (faces, cycles, corners) = collector.collect_faces(&visits);
    let Collector {
        graph,
        arcs,
        names,
        walls,
    } = collector;
    let Graph {
        ring,
        links,
        events,
        right_first,
        right_last,
        left_last,
        seams,
        steps,
        ..
    } = graph;
    // The list of nodes is the largest of all; what is not needed any more goes before.
    drop((
        links,
        seams,
        visits,
        right_first,
        right_last,
        left_last,
        walls,
    ));
    let mut nodes = Vec::with_capacity(names.count as usize);
    let nowhere = Node {
        x: 0.0,
        y: 0.0,
        time: 0.0,
        kind: NodeKind::Event,
    };
    for (v, &[x, y]) in ring.points().iter().enumerate() {
        nodes.push(Node {
            x,
            y,
            kind: NodeKind::Input(VertexId::new(v)),
            ..nowhere
        });
    }
    nodes.resize(names.count as usize, nowhere);
    for (event, name) in events.into_iter().zip(names.events) {
        if name & ALIAS == 0 {
            let [x, y] = ring.round(event.place);
            let time = ring.round_time(event.time);
            nodes[name as usize] = Node {
                x,
                y,
                time,
                ..nowhere
            };
        }
    }
    Skeleton {
        nodes,
        arcs,
        faces,
        cycles,
        corners,
        input,
        region: Region::Interior,
        stats: Stats {
            steps,
            ..Stats::default()
        },
    }
}

/// The arcs of the merge chain beside each face.
fn visits<N: Number>(graph: &Graph<'_, N>) -> Visits {
    let mut visits = vec![[NONE; 2]; graph.ring.count() as usize];
    for (k, seam) in graph.seams.iter().enumerate() {
        for wave in [seam.lower, seam.upper] {
            let [first, last] = &mut visits[wave as usize];
            if *first == NONE {
                *first = k as u32;
            }
            *last = k as u32;
        }
    }
    visits
}

struct Collector<'a, N> {
    graph: Graph<'a, N>,
    walls: Walls,
    names: Names,
    arcs: Vec<Arc>,
}

impl<N: Number> Collector<'_, N> {
    fn face(&self, wave: u32) -> FaceId {
        FaceId::raw(self.graph.ring.edge(wave))
    }

    /// The arcs that are left of both skeletons, then the merge chain, then ghost arcs of walls.
    fn collect_arcs(&mut self) {
        let walls = std::mem::take(&mut self.walls);
        for wave in 0..self.graph.ring.count() {
            let mut link = self.graph.right_first[wave as usize];
            while link != NONE {
                self.collect_link(link, &walls);
                if link == self.graph.right_last[wave as usize] {
                    break;
                }
                link = self.graph.link(link).after;
            }
        }
        for seam in 0..self.graph.seams.len() as u32 {
            self.collect_seam(seam, &walls);
        }
        for ghost in &walls.ghosts {
            // Going east in the lower chain, what is above is on the left.
            let turned = (self.graph.ring.side(ghost.below) == Side::Upper)
                != (self.graph.kind(ghost.below) == Kind::West);
            let faces = if turned {
                [ghost.below, ghost.above]
            } else {
                [ghost.above, ghost.below]
            };
            self.push([ghost.vertex, ghost.end], faces, ArcKind::Ghost);
        }
        self.walls = walls;
    }

    /// Adds an arc, unless it has no length.
    fn push(&mut self, ends: [u32; 2], faces: [u32; 2], kind: ArcKind) {
        let nodes = ends.map(|end| self.names.id(end));
        if nodes[0] != nodes[1] {
            let faces = faces.map(|wave| self.face(wave));
            self.arcs.push(Arc { nodes, faces, kind });
        }
    }

    fn collect_link(&mut self, at: u32, walls: &Walls) {
        let link = *self.graph.link(at);
        let kind = match (self.graph.kind(link.west), self.graph.kind(link.east)) {
            (Kind::Level, Kind::Level) => ArcKind::Ghost,
            (Kind::Level, Kind::East) | (Kind::West, Kind::Level) => ArcKind::Valley,
            _ => ArcKind::Ridge,
        };
        let upper = self.graph.ring.side(link.west) == Side::Upper;
        let turned = |[west, east]: [u32; 2]| if upper { [east, west] } else { [west, east] };
        if let Some(pieces) = walls.pieces(Step::Link(at)) {
            for &Piece { ends, faces } in pieces {
                self.push(ends, turned(faces), kind);
            }
        } else {
            self.push([link.from, link.to], turned([link.west, link.east]), kind);
        }
        let named = &mut self.graph.links[at as usize];
        named.from = self.names.of(link.from);
        named.to = self.names.of(link.to);
    }

    fn collect_seam(&mut self, at: u32, walls: &Walls) {
        let seam = self.graph.seams[at as usize];
        let kind = match (self.graph.kind(seam.lower), self.graph.kind(seam.upper)) {
            (Kind::East, Kind::East) | (Kind::West, Kind::West) => ArcKind::Ghost,
            _ => ArcKind::Ridge,
        };
        // In the order in which the wavefront reaches its ends, with the face on the left first.
        let [start, end] = [seam.from, seam.to].map(|node| self.time(node));
        let push = |this: &mut Self, [from, to]: [u32; 2], [lower, upper]: [u32; 2]| {
            if start <= end {
                this.push([from, to], [upper, lower], kind);
            } else {
                this.push([to, from], [lower, upper], kind);
            }
        };
        if let Some(pieces) = walls.pieces(Step::Seam(at)) {
            for &Piece { ends, faces } in pieces {
                push(self, ends, faces);
            }
        } else {
            push(self, [seam.from, seam.to], [seam.lower, seam.upper]);
        }
        let named = &mut self.graph.seams[at as usize];
        named.from = self.names.of(seam.from);
        named.to = self.names.of(seam.to);
    }

    fn time(&self, node: u32) -> N {
        match node.checked_sub(self.graph.ring.count()) {
            Some(event) => self.graph.events[event as usize].time,
            None => N::ZERO,
        }
    }

    /// The faces in the order of their edges, and the corners around them.
    fn collect_faces(&mut self, visits: &Visits) -> (Vec<Face>, Vec<u32>, Vec<NodeId>) {
        let n = self.graph.ring.count();
        let side = if self.graph.ring.is_forward() {
            crate::skeleton::Side::Left
        } else {
            crate::skeleton::Side::Right
        };
        let mut faces = Vec::with_capacity(n as usize);
        let mut cycles = Vec::with_capacity(n as usize + 1);
        let mut corners: Vec<NodeId> = Vec::with_capacity(2 * self.arcs.len() + n as usize);
        cycles.push(0);
        for edge in 0..n {
            let wave = self.graph.ring.wave(edge);
            let first = corners.len();
            let base = self.graph.ring.base(wave);
            corners.extend(base.map(NodeId::raw));
            if let Some(list) = self.walls.corners(wave) {
                for &node in list {
                    add(&mut corners, self.names.id(node));
                }
            } else {
                self.around(wave, visits[wave as usize], &mut corners);
            }
            while corners.len() > first + 2 && corners.last() == Some(&corners[first]) {
                corners.pop();
            }
            if self.graph.ring.side(wave) == Side::Upper {
                // So far seen from the upper chain, which is a mirror image.
                corners.swap(first, first + 1);
                corners[first + 2..].reverse();
            }
            cycles.push(corners.len() as u32);
            faces.push(Face {
                edge: EdgeId::new(edge as usize),
                side,
                phase: 0,
                cycles: [edge, edge + 1],
            });
        }
        (faces, cycles, corners)
    }

    /// The corners of a face, seen from its chain, from the east end of its edge to the west end. Ends of arcs
    /// have their final numbers already.
    fn around(&mut self, wave: u32, [first, last]: [u32; 2], corners: &mut Vec<NodeId>) {
        let at = wave as usize;
        let mut link = self.graph.right_first[at];
        while link != NONE {
            let arc = *self.graph.link(link);
            for piece in self.walls.pieces(Step::Link(link)).unwrap_or_default() {
                add(corners, self.names.id(piece.ends[1]));
            }
            add(corners, NodeId::raw(arc.to));
            if link == self.graph.right_last[at] {
                break;
            }
            link = arc.after;
        }
        if first != NONE {
            for seam in (first..=last).rev() {
                for piece in self
                    .walls
                    .pieces(Step::Seam(seam))
                    .unwrap_or_default()
                    .iter()
                    .rev()
                {
                    add(corners, self.names.id(piece.ends[1]));
                }
                add(corners, NodeId::raw(self.graph.seams[seam as usize].from));
            }
        }
        let mut link = self.graph.left_last[at];
        while link != NONE {
            let arc = *self.graph.link(link);
            for piece in self
                .walls
                .pieces(Step::Link(link))
                .unwrap_or_default()
                .iter()
                .rev()
            {
                add(corners, self.names.id(piece.ends[1]));
            }
            add(corners, NodeId::raw(arc.from));
            link = arc.below;
        }
    }
}

/// Adds a corner unless it is the last one already.
fn add(corners: &mut Vec<NodeId>, node: NodeId) {
    if corners.last() != Some(&node) {
        corners.push(node);
    }
}
