//! Walls of several edges: their joint face is cut by a horizontal ghost arc from each vertex inside of the wall.
//!
//! The paper leaves such vertices out. Ghost arcs of level edges are finished while the chain's
//! skeleton grows; those of walls, which are perpendicular to the direction of the growth, wait until
//! the joint faces are known. A face is monotone to its edge, so all ghost arcs of a wall end in one walk
//! along its boundary, from the bottom to the top.

use super::{
    graph::{Graph, NONE, Visits},
    number::Number,
    ring::{Kind, Side},
};

/// An arc of a chain's skeleton or of the merge chain.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Step {
    Link(u32),
    Seam(u32),
}

/// A piece of an arc: its ends, and the faces on both sides in the order of the arc.
#[derive(Debug, Clone, Copy)]
pub(super) struct Piece {
    pub ends: [u32; 2],
    pub faces: [u32; 2],
}

/// A ghost arc from a vertex inside of a wall.
#[derive(Debug, Clone, Copy)]
pub(super) struct WallGhost {
    pub vertex: u32,
    pub end: u32,
    /// The edges of the wall below and above the vertex, seen from their chain.
    pub below: u32,
    pub above: u32,
}

/// The edges of one side of an arc.
#[derive(Debug, Clone, Copy)]
struct Mark {
    /// The edge that the face at the arc's start belongs to.
    face: u32,
    /// Where the face changes, in the order of the arc.
    cuts: [u32; 2],
}

/// Where the face on one side of an arc changes: to which.
#[derive(Debug, Clone, Copy)]
struct Cut {
    node: u32,
    face: u32,
}

/// What the ghost arcs of walls cut.
#[derive(Debug, Default)]
pub(super) struct Walls {
    pub ghosts: Vec<WallGhost>,
    /// For each arc that borders such a wall: its pieces, from the first to the one after the last.
    of_link: Vec<[u32; 2]>,
    of_seam: Vec<[u32; 2]>,
    pieces: Vec<Piece>,
    /// For each wave of such a wall: the corners of its face, from the first to the one after the last.
    of_wave: Vec<[u32; 2]>,
    corners: Vec<u32>,
}

impl Walls {
    /// The pieces of an arc, if it borders a wall of several edges.
    pub(super) fn pieces(&self, step: Step) -> Option<&[Piece]> {
        let (list, at) = match step {
            Step::Link(at) => (&self.of_link, at),
            Step::Seam(at) => (&self.of_seam, at),
        };
        let [first, end] = *list.get(at as usize)?;
        (first < end).then(|| &self.pieces[first as usize..end as usize])
    }

    /// The corners of the face of a wave, seen from its chain, if it is one of several of its wall.
    pub(super) fn corners(&self, wave: u32) -> Option<&[u32]> {
        let [first, end] = *self.of_wave.get(wave as usize)?;
        (first < end).then(|| &self.corners[first as usize..end as usize])
    }
}

/// The walls of more than one edge, each from west to east as its chain goes.
fn walls<N: Number>(graph: &Graph<'_, N>) -> Vec<Vec<u32>> {
    let mut found = Vec::new();
    for side in [Side::Lower, Side::Upper] {
        let mut waves = graph.ring.chain(side).peekable();
        while let Some(wave) = waves.next() {
            let kind = graph.kind(wave);
            if kind == Kind::Level {
                continue;
            }
            let mut wall = Vec::new();
            while let Some(next) = waves.next_if(|&next| graph.kind(next) == kind) {
                if wall.is_empty() {
                    wall.push(wave);
                }
                wall.push(next);
            }
            if !wall.is_empty() {
                found.push(wall);
            }
        }
    }
    found
}

/// Cuts the faces of all walls of several edges.
pub(super) fn cut<N: Number>(graph: &mut Graph<'_, N>) -> Walls {
    let walls = walls(graph);
    if walls.is_empty() {
        return Walls::default();
    }
    let mut cutter = Cutter {
        marks: Vec::new(),
        cuts: Vec::new(),
        of_link: vec![[NONE; 2]; graph.links.len()],
        of_seam: vec![[NONE; 2]; graph.seams.len()],
        found: Walls::default(),
    };
    let visits = &mut Visits::default();
    for wall in &walls {
        cutter.land(graph, visits, wall);
    }
    cutter.join(graph);
    cutter.found.of_wave = vec![[0; 2]; graph.ring.count() as usize];
    for wall in &walls {
        cutter.collect(graph, visits, wall);
    }
    cutter.found
}

/// The boundary of the face of a wall without the wall itself, from its bottom to its top, seen from its
/// chain, and whether arcs are passed in their own direction.
fn far_side<N: Number>(graph: &Graph<'_, N>, visits: &mut Visits, wave: u32) -> Vec<(Step, bool)> {
    let at = wave as usize;
    let mut right = Vec::new();
    let mut link = graph.borders[at].right_first;
    while link != NONE {
        right.push(Step::Link(link));
        if link == graph.borders[at].right_last {
            break;
        }
        link = graph.link(link).after;
    }
    let mut left = Vec::new();
    let mut link = graph.borders[at].left_last;
    while link != NONE {
        left.push(Step::Link(link));
        link = graph.link(link).below;
    }
    let seams = graph.visits(visits, wave).map(Step::Seam);
    if graph.kind(wave) == Kind::East {
        let rest = seams.rev().chain(left).map(|step| (step, false));
        right
            .into_iter()
            .map(|step| (step, true))
            .chain(rest)
            .collect()
    } else {
        let rest = right.into_iter().rev().map(|step| (step, false));
        let rising = left.into_iter().rev().chain(seams);
        rising.map(|step| (step, true)).chain(rest).collect()
    }
}

struct Cutter {
    marks: Vec<Mark>,
    cuts: Vec<Cut>,
    /// For each arc, the marks of its two sides.
    of_link: Vec<[u32; 2]>,
    of_seam: Vec<[u32; 2]>,
    found: Walls,
}

impl Cutter {
    /// The ends of an arc and the faces beside it.
    fn arc<N: Number>(graph: &Graph<'_, N>, step: Step) -> ([u32; 2], [u32; 2]) {
        match step {
            Step::Link(link) => {
                let link = graph.link(link);
                ([link.from, link.to], [link.west, link.east])
            }
            Step::Seam(seam) => {
                let seam = graph.seams[seam as usize];
                ([seam.from, seam.to], [seam.lower, seam.upper])
            }
        }
    }

    /// Finds where the ghost arcs of a wall end.
    fn land<N: Number>(&mut self, graph: &mut Graph<'_, N>, visits: &mut Visits, wall: &[u32]) {
        let name = wall[0];
        let side = graph.ring.side(name);
        // From the bottom to the top, the vertex below each edge but the first.
        let east = graph.kind(name) == Kind::East;
        let count = wall.len();
        let member = |k: usize| if east { wall[count - 1 - k] } else { wall[k] };
        let vertex = |graph: &Graph<'_, N>, k: usize| {
            graph
                .ring
                .west_end(if east { member(k - 1) } else { member(k) })
        };
        let mut k = 0;
        for (step, forward) in far_side(graph, visits, name) {
            let (ends, faces) = Self::arc(graph, step);
            let [a, b] = ends.map(|node| graph.spot(node, side));
            let [low, high] = if forward { [a, b] } else { [b, a] };
            let at = usize::from(faces[0] != name);
            let before = member(k);
            let first = self.cuts.len();
            let mut changes = Vec::new();
            while k + 1 < count {
                let start = vertex(graph, k + 1);
                let (_, height) = graph.spot(start, side);
                if height > high.1 {
                    break;
                }
                let end = if height == high.1 {
                    ends[usize::from(forward)]
                } else {
                    let x = match low.0.cmp(&high.0) {
                        std::cmp::Ordering::Less => low.0 + (height - low.1),
                        std::cmp::Ordering::Equal => low.0,
                        std::cmp::Ordering::Greater => low.0 - (height - low.1),
                    };
                    let node = graph.event((x, height), name);
                    changes.push((node, member(k + 1)));
                    node
                };
                self.found.ghosts.push(WallGhost {
                    vertex: start,
                    end,
                    below: member(k),
                    above: member(k + 1),
                });
                graph.steps += 1;
                k += 1;
            }
            // In the order of the arc.
            let mut face = before;
            if forward {
                self.cuts
                    .extend(changes.iter().map(|&(node, face)| Cut { node, face }));
            } else {
                let mut faces: Vec<u32> = changes.iter().map(|change| change.1).collect();
                faces.insert(0, before);
                face = faces.pop().expect("one face at least");
                for (node, _) in changes.into_iter().rev() {
                    let face = faces.pop().expect("one face more than cuts");
                    self.cuts.push(Cut { node, face });
                }
            }
            let mark = self.marks.len() as u32;
            self.marks.push(Mark {
                face,
                cuts: [first as u32, self.cuts.len() as u32],
            });
            match step {
                Step::Link(link) => self.of_link[link as usize][at] = mark,
                Step::Seam(seam) => self.of_seam[seam as usize][at] = mark,
            }
        }
    }

    /// Makes pieces of all arcs that have marks.
    fn join<N: Number>(&mut self, graph: &mut Graph<'_, N>) {
        let links = (0..self.of_link.len() as u32).map(Step::Link);
        let seams = (0..self.of_seam.len() as u32).map(Step::Seam);
        for step in links.chain(seams) {
            let marks = match step {
                Step::Link(link) => self.of_link[link as usize],
                Step::Seam(seam) => self.of_seam[seam as usize],
            };
            let first = self.found.pieces.len() as u32;
            if marks != [NONE; 2] {
                self.join_one(graph, step, marks);
            }
            let range = [first, self.found.pieces.len() as u32];
            match step {
                Step::Link(_) => self.found.of_link.push(range),
                Step::Seam(_) => self.found.of_seam.push(range),
            }
        }
    }

    fn join_one<N: Number>(&mut self, graph: &mut Graph<'_, N>, step: Step, marks: [u32; 2]) {
        let (ends, mut faces) = Self::arc(graph, step);
        let mut lists: [&[Cut]; 2] = [&[], &[]];
        for at in 0..2 {
            if marks[at] != NONE {
                let mark = self.marks[marks[at] as usize];
                faces[at] = mark.face;
                lists[at] = &self.cuts[mark.cuts[0] as usize..mark.cuts[1] as usize];
            }
        }
        let [start, end] = ends.map(|node| graph.spot(node, Side::Lower).1);
        let height = |graph: &Graph<'_, N>, cut: &Cut| {
            let y = graph.spot(cut.node, Side::Lower).1;
            if end > start { y } else { -y }
        };
        let mut from = ends[0];
        loop {
            let [one, other] = lists.map(<[Cut]>::first);
            let order = match (one, other) {
                (None, None) => break,
                (Some(_), None) => std::cmp::Ordering::Less,
                (None, Some(_)) => std::cmp::Ordering::Greater,
                (Some(a), Some(b)) => height(graph, a).cmp(&height(graph, b)),
            };
            let passed = [order.is_le(), order.is_ge()];
            let mut node = NONE;
            let before = faces;
            for at in 0..2 {
                if let (true, [cut, rest @ ..]) = (passed[at], lists[at]) {
                    faces[at] = cut.face;
                    lists[at] = rest;
                    if node == NONE {
                        node = cut.node;
                    } else {
                        graph.same.push([cut.node, node]);
                    }
                }
            }
            self.found.pieces.push(Piece {
                ends: [from, node],
                faces: before,
            });
            from = node;
        }
        self.found.pieces.push(Piece {
            ends: [from, ends[1]],
            faces,
        });
    }

    /// Collects the corners of the faces of a wall.
    fn collect<N: Number>(&mut self, graph: &Graph<'_, N>, visits: &mut Visits, wall: &[u32]) {
        let name = wall[0];
        let east = graph.kind(name) == Kind::East;
        // All pieces from the bottom to the top, with the edges that they belong to.
        let mut list: Vec<(u32, [u32; 2])> = Vec::new();
        for (step, forward) in far_side(graph, visits, name) {
            let (_, faces) = Self::arc(graph, step);
            let at = usize::from(faces[0] != name);
            let pieces = self.found.pieces(step).expect("it borders the wall");
            let entry = |piece: &Piece| (piece.faces[at], piece.ends);
            if forward {
                list.extend(pieces.iter().map(entry));
            } else {
                let turned = |(face, [a, b]): (u32, [u32; 2])| (face, [b, a]);
                list.extend(pieces.iter().rev().map(entry).map(turned));
            }
        }
        for group in list.chunk_by(|a, b| a.0 == b.0) {
            let first = self.found.corners.len() as u32;
            let nodes = group.iter().flat_map(|(_, ends)| *ends);
            if east {
                self.found.corners.extend(nodes);
            } else {
                self.found.corners.extend(nodes.rev());
            }
            self.found.of_wave[group[0].0 as usize] = [first, self.found.corners.len() as u32];
        }
    }
}
