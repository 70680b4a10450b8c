//! From the faces and nodes of a skeleton back to the planes that define them.
//!
//! A skeleton keeps rounded numbers only. Where they do not decide, the definition of a node
//! is found again from the faces around it.

use crate::{
    input::Figure,
    predicates::{Bound, Place, PlaneId, Planes, Start, Terminal},
    skeleton::{ArcKind, Face, NodeKind, Side, Skeleton},
    topology::{ArcId, EdgeId, FaceId, NodeId},
};
use hipline_num::Sign;
use std::cell::OnceCell;

/// A skeleton with the planes of its faces.
pub(crate) struct Lift<'a> {
    pub skeleton: &'a Skeleton,
    pub planes: Planes,
    /// The terminals, then the caps of a modified skeleton.
    terminals: Vec<Terminal>,
    /// How many of them are terminals.
    plain: usize,
    edges: usize,
    /// The arcs at each node: those of node i from `.0[i]` to `.0[i + 1]`.
    arcs: OnceCell<(Vec<u32>, Vec<ArcId>)>,
}

impl<'a> Lift<'a> {
    pub(crate) fn new(skeleton: &'a Skeleton, figure: &Figure) -> Self {
        let same = figure.vertices().len() == skeleton.input().vertices
            && figure.edges().len() == skeleton.input().edges.len()
            && figure
                .edges()
                .iter()
                .zip(&skeleton.input().edges)
                .all(|(e, f)| [e.from, e.to] == *f);
        assert!(same, "the skeleton is not that of this figure");
        let terminals = Terminal::with_caps(figure, skeleton.is_modified());
        Self {
            skeleton,
            planes: Planes::new(figure, &terminals),
            terminals,
            plain: figure.terminals(),
            edges: figure.edges().len(),
            arcs: OnceCell::new(),
        }
    }

    /// The plane of a face.
    pub(crate) fn plane(&self, face: FaceId) -> PlaneId {
        let face = self.skeleton.face(face);
        let first = self.first_plane(face);
        let plane = self.planes.phases.plane(first, face.phase);
        plane.expect("the skeleton is of this figure, and its edges have as many phases")
    }

    /// The number of the terminal or cap at an end of an edge.
    fn tip(&self, vertex: usize, edge: EdgeId) -> Option<usize> {
        Terminal::find(&self.terminals, self.plain, vertex, edge.index())
    }

    /// The plane of the first phase of a face's edge.
    fn first_plane(&self, face: &Face) -> PlaneId {
        let [from, to] = self.skeleton.input().edges[face.edge.index()];
        let terminal = |tip: usize| {
            let i = self.tip(tip, face.edge);
            2 * (self.edges + i.expect("the face of a terminal or a cap")) as u32
        };
        PlaneId(match face.side {
            Side::Left => 2 * face.edge.index() as u32,
            Side::Right => 2 * face.edge.index() as u32 + 1,
            Side::Start => terminal(from.index()),
            Side::End => terminal(to.index()),
        })
    }

    /// The planes of the two faces beside an arc that is no ghost and not of one height, the
    /// first turning left into the second.
    pub(crate) fn pair(&self, arc: ArcId) -> [PlaneId; 2] {
        self.oriented(self.skeleton.arc(arc).faces.map(|face| self.plane(face)))
    }

    fn oriented(&self, [i, j]: [PlaneId; 2]) -> [PlaneId; 2] {
        if self.planes.turn(i, j) == Sign::Negative {
            [j, i]
        } else {
            [i, j]
        }
    }

    /// Whether an arc goes straight up, above one point: both planes beside it stand still.
    pub(crate) fn is_upright(&self, arc: ArcId) -> bool {
        let arc = self.skeleton.arc(arc);
        self.planes.has_upright()
            && arc
                .faces
                .iter()
                .all(|&face| self.planes.stands_still(self.plane(face)))
    }

    /// Where an arc is at a time between those of its ends. (Only the place in plan, if it goes straight up.)
    pub(crate) fn at(&self, arc: ArcId, time: f64) -> Place {
        if self.skeleton.arc(arc).kind == ArcKind::Ghost {
            self.on_ghost(arc, Bound::Time(time))
        } else if self.is_upright(arc) {
            self.place(self.skeleton.arc(arc).nodes[0])
        } else {
            let pair = self.pair(arc);
            Place::At { pair, time }
        }
    }

    /// The arcs at a node, ascending.
    pub(crate) fn arcs_at(&self, node: NodeId) -> &[ArcId] {
        let (first, list) = self.arcs.get_or_init(|| {
            let mut first = vec![0_u32; self.skeleton.nodes().len() + 1];
            for arc in self.skeleton.arcs() {
                for end in arc.nodes {
                    first[end.index() + 1] += 1;
                }
            }
            for i in 1..first.len() {
                first[i] += first[i - 1];
            }
            let mut at = first.clone();
            let mut list = vec![ArcId::new(0); 2 * self.skeleton.arcs().len()];
            for (i, arc) in self.skeleton.arcs().iter().enumerate() {
                for end in arc.nodes {
                    let slot = &mut at[end.index()];
                    list[*slot as usize] = ArcId::new(i);
                    *slot += 1;
                }
            }
            (first, list)
        });
        &list[first[node.index()] as usize..first[node.index() + 1] as usize]
    }

    /// The definition of a finite node.
    pub(crate) fn place(&self, id: NodeId) -> Place {
        let node = self.skeleton.node(id);
        if matches!(node.kind, NodeKind::Input(_)) {
            return Place::Vertex([node.x, node.y]);
        }
        let planes: Vec<PlaneId> = self
            .arcs_at(id)
            .iter()
            .flat_map(|&arc| self.skeleton.arc(arc).faces)
            .map(|face| self.plane(face))
            .chain(self.posts(id))
            .collect();
        let first = planes[0];
        let Some(&across) = planes
            .iter()
            .find(|&&p| !self.planes.turn(first, p).is_zero())
        else {
            return self.foot_on_level(id, &planes);
        };
        let pair = self.oriented([first, across]);
        match planes
            .iter()
            .find(|&&p| self.planes.do_meet([first, across, p]))
        {
            Some(&third) => {
                let mut moment = [first, across, third];
                moment.sort_unstable();
                Place::Event { pair, moment }
            }
            // All planes have a line in common: a ghost arc ends at another arc.
            None => self.foot(id, Bound::Pair(pair)),
        }
    }

    /// Upright planes through a node that is above a vertex where walls on one line meet, or both sides of
    /// a wall end: those of the walls alone have a line in common.
    fn posts(&self, id: NodeId) -> Vec<PlaneId> {
        if !self.planes.has_upright() {
            return Vec::new();
        }
        let mut list = Vec::new();
        for &arc in self.arcs_at(id) {
            let arc = self.skeleton.arc(arc);
            let NodeKind::Input(vertex) = self.skeleton.node(arc.nodes[0]).kind else {
                continue;
            };
            let planes = arc.faces.map(|face| self.plane(face));
            for plane in planes {
                list.extend(
                    self.planes
                        .post_at(&self.skeleton.input().edges, plane, vertex),
                );
            }
            if planes[0].0 ^ planes[1].0 == 1
                && let Some(i) = self.tip(vertex.index(), self.skeleton.face(arc.faces[0]).edge)
            {
                let cap = PlaneId(2 * (self.edges + i) as u32);
                list.extend(self.planes.stands_still(cap).then_some(cap));
            }
        }
        list
    }

    /// The end of a ghost arc at an arc of one height.
    fn foot_on_level(&self, id: NodeId, planes: &[PlaneId]) -> Place {
        let first = planes[0];
        let other = planes.iter().find(|&&p| !self.planes.coplanar(first, p));
        let &other = other.unwrap_or_else(|| panic!("{id} has one plane only"));
        self.foot(id, Bound::Level(self.level_moment(first, other)))
    }

    /// When two parallel planes meet: told by any third one that is not parallel, too.
    pub(crate) fn level_moment(&self, first: PlaneId, other: PlaneId) -> [PlaneId; 3] {
        let lines = (self.edges + self.terminals.len()) as u32;
        let third = (0..lines)
            .map(|line| PlaneId(2 * line))
            .find(|&p| !self.planes.turn(first, p).is_zero());
        let third = third.expect("an arc of one height is in a figure of more than one direction");
        let mut moment = [first, other, third];
        moment.sort_unstable();
        moment
    }

    fn foot(&self, id: NodeId, bound: Bound) -> Place {
        if let Bound::Pair(pair) = bound
            && let Some(moment) = self.overrun_at(id)
        {
            return Place::Event { pair, moment };
        }
        let ghost = self.arcs_at(id).iter().find(|&&arc| {
            let arc = self.skeleton.arc(arc);
            arc.kind == ArcKind::Ghost && arc.nodes[1] == id
        });
        let &ghost = ghost.unwrap_or_else(|| panic!("{id} has two planes and no ghost arc"));
        self.on_ghost(ghost, bound)
    }

    /// When an edge overruns another one on the same plane, whose speed will be less, along an arc
    /// that ends at a node: as its other end tells.
    fn overrun_at(&self, id: NodeId) -> Option<[PlaneId; 3]> {
        self.arcs_at(id).iter().find_map(|&arc| {
            let arc = self.skeleton.arc(arc);
            let [i, j] = arc.faces.map(|face| self.plane(face));
            if arc.kind == ArcKind::Ghost || !self.planes.coplanar(i, j) {
                return None;
            }
            let other = arc.nodes[usize::from(arc.nodes[0] == id)];
            let planes: Vec<PlaneId> = self
                .arcs_at(other)
                .iter()
                .flat_map(|&arc| self.skeleton.arc(arc).faces)
                .map(|face| self.plane(face))
                .collect();
            let meets = |triple: &[PlaneId; 3]| self.planes.do_meet(*triple);
            let mut triples = planes.iter().enumerate().flat_map(|(k, &p)| {
                let rest = &planes[k + 1..];
                rest.iter()
                    .enumerate()
                    .flat_map(move |(l, &q)| rest[l + 1..].iter().map(move |&r| [p, q, r]))
            });
            triples.find(meets).map(|mut triple| {
                triple.sort_unstable();
                triple
            })
        })
    }

    /// A place on a ghost arc.
    pub(crate) fn on_ghost(&self, ghost: ArcId, bound: Bound) -> Place {
        let arc = self.skeleton.arc(ghost);
        let start = match self.place(arc.nodes[0]) {
            Place::Vertex(v) => Start::Vertex(v),
            Place::Event { pair, moment } => Start::Event { pair, moment },
            place => unreachable!("{ghost} starts at {place:?}"),
        };
        Place::Foot {
            start,
            plane: self.plane(arc.faces[0]),
            bound,
        }
    }
}
