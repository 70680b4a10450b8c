//! The wavefront at one moment, and how it settles after an event.

use std::cmp::Ordering;
use std::collections::HashMap;
use std::rc::Rc;

use hipline::skeleton::ArcKind;

use super::heading::{cross, dot, turn};
use super::model::{Model, Plane};
use super::motion::{Motion, Point};
use super::number::Field;
use super::ratio::Ratio;

/// A vertex of the wavefront.
#[derive(Debug)]
pub(super) struct Corner {
    /// A serial number.
    pub id: u32,
    pub motion: Motion,
    /// The node where its arc starts.
    pub origin: usize,
    /// The faces before and after it.
    pub faces: [usize; 2],
    /// `Greater` for convex, `Less` for reflex, `Equal` for the foot of a ghost arc.
    pub turn: Ordering,
    /// Whether the two edges go on as one: on one plane, now and in future.
    pub as_one: bool,
    /// The terminal that has not moved yet, at the end of an edge both sides of which stand still.
    pub terminal: Option<usize>,
}

/// An edge of the wavefront; its start is the corner of the one before.
#[derive(Debug)]
pub(super) struct Piece {
    pub face: usize,
    pub next: usize,
    pub prev: usize,
    /// Where it ends.
    pub corner: Rc<Corner>,
}

/// An edge of the wavefront while it is being rebuilt, between two numbered places.
#[derive(Debug, Clone)]
pub(super) struct Link {
    pub face: usize,
    pub from: usize,
    pub to: usize,
    pub next: usize,
    /// The vertex at its end, if that goes on as it was.
    pub corner: Option<Rc<Corner>>,
    pub alive: bool,
}

/// The places of one moment; those where something happens have nodes.
#[derive(Debug, Default)]
pub(super) struct Places {
    pub points: Vec<Point>,
    pub nodes: Vec<Option<usize>>,
}

/// A node of the result: where and when.
#[derive(Debug)]
pub(super) enum RawNode {
    /// At a finite place.
    Finite { place: [Ratio; 2], time: Ratio },
    /// At infinity: the node where its arc starts, and the arc's velocity.
    Infinite { from: usize, velocity: [Ratio; 2] },
}

/// An arc of the result; `faces` are those on its left and on its right.
#[derive(Debug)]
pub(super) struct RawArc {
    pub nodes: [usize; 2],
    pub faces: [usize; 2],
    pub kind: ArcKind,
}

/// The wavefront, and the result so far.
#[derive(Debug)]
pub(super) struct Wave<'a> {
    pub model: &'a Model,
    pub time: Ratio,
    /// The plane of each face; the first faces are those of phase 0, in the order of their planes.
    pub faces: Vec<usize>,
    pub pieces: Vec<Piece>,
    pub nodes: Vec<RawNode>,
    pub arcs: Vec<RawArc>,
    corners: u32,
    /// When a corner reaches a face's plane, or two corners join; by serial numbers.
    pub times: HashMap<(u32, u32, u32), Option<Rc<Ratio>>>,
    /// Whether a corner hits a piece (by the corners at its ends).
    pub hits: HashMap<(u32, u32, u32), bool>,
}

impl<'a> Wave<'a> {
    /// The wavefront at time 0, of all or part of the faces.
    pub(super) fn start(model: &'a Model, take: impl Fn(usize) -> bool) -> Self {
        let mut wave = Self {
            model,
            time: Ratio::zero(),
            faces: (0..model.courses).collect(),
            pieces: Vec::new(),
            nodes: Vec::new(),
            arcs: Vec::new(),
            corners: 0,
            times: HashMap::new(),
            hits: HashMap::new(),
        };
        let points: Vec<Point> = model.points.iter().map(Point::integer).collect();
        wave.nodes
            .extend(points.iter().map(|point| RawNode::Finite {
                place: point.coordinates.clone(),
                time: Ratio::zero(),
            }));
        let nodes = (0..points.len()).map(Some).collect();
        let first = model.planes[..model.courses].iter().enumerate();
        let links = first.map(|(f, plane)| Link {
            face: f,
            from: plane.ends[0],
            to: plane.ends[1],
            next: model.next[f],
            corner: None,
            // Terminals are put in where their edge ends in nothing.
            alive: take(f) && plane.ends[0] != plane.ends[1],
        });
        let mut links: Vec<Link> = links.collect();
        let places = &mut Places { points, nodes };
        wave.settle_before_facets(&mut links, places);
        wave.start_facets(&mut links, places);
        wave.settle(links, places);
        wave
    }

    /// On what the wavefront edges of a face move.
    pub(super) fn plane(&self, face: usize) -> &'a Plane {
        &self.model.planes[self.faces[face]]
    }

    /// The node at a place, made when first asked for.
    pub(super) fn node(&mut self, places: &mut Places, place: usize) -> usize {
        if let Some(node) = places.nodes[place] {
            return node;
        }
        let place_at = places.points[place].coordinates.clone();
        self.nodes.push(RawNode::Finite {
            place: place_at,
            time: self.time.clone(),
        });
        places.nodes[place] = Some(self.nodes.len() - 1);
        self.nodes.len() - 1
    }

    /// Ends the arc of a corner at a node. It moves to the left of the wavefront's direction, so
    /// the face before it is on its left.
    pub(super) fn finish(&mut self, corner: &Corner, node: usize) {
        assert_ne!(
            corner.origin, node,
            "an arc of length zero between {:?}",
            corner.faces
        );
        let [i, j] = corner.faces.map(|face| self.plane(face));
        let kind = match corner.turn {
            // Between a wall and the facet above it.
            Ordering::Greater | Ordering::Less if i.course == j.course => ArcKind::Crease,
            Ordering::Greater => ArcKind::Ridge,
            Ordering::Less => ArcKind::Valley,
            Ordering::Equal => ArcKind::Ghost,
        };
        self.arcs.push(RawArc {
            nodes: [corner.origin, node],
            faces: corner.faces,
            kind,
        });
    }

    /// An arc of one height between two places; the faces on its left and right.
    pub(super) fn level_arc(
        &mut self,
        places: &mut Places,
        ends: [usize; 2],
        faces: [usize; 2],
        kind: ArcKind,
    ) {
        let nodes = ends.map(|place| self.node(places, place));
        self.arcs.push(RawArc { nodes, faces, kind });
    }

    /// Joins what is one, lets the faster of parallel neighbours win, but for those between which a facet starts:
    /// so facets start between edges that stay.
    pub(super) fn settle_before_facets(&mut self, links: &mut [Link], places: &mut Places) {
        self.settle_lines(links, places, true);
    }

    fn settle_lines(&mut self, links: &mut [Link], places: &mut Places, facets_start: bool) {
        join_equals(links);
        loop {
            let waits = |l: usize| facets_start && self.awaits_facet(links, places, l);
            let Some((link, fast)) = self.next_overrun(links, places, waits) else {
                return;
            };
            self.overrun(links, places, link, fast);
            while self.drop_overtaken(links) {}
            join_equals(links);
        }
    }

    /// Joins what is one, lets the faster of parallel neighbours win, makes the new corners.
    pub(super) fn settle(&mut self, mut links: Vec<Link>, places: &mut Places) {
        self.settle_lines(&mut links, places, false);
        self.emit_terminals(&mut links, places);
        let alive: Vec<usize> = (0..links.len()).filter(|&l| links[l].alive).collect();
        let mut rank = vec![usize::MAX; links.len()];
        for (new, &old) in alive.iter().enumerate() {
            rank[old] = new;
        }
        let mut pieces = Vec::with_capacity(alive.len());
        for &l in &alive {
            let link = links[l].clone();
            let corner = link.corner.unwrap_or_else(|| {
                let origin = self.node(places, link.to);
                let faces = [link.face, links[link.next].face];
                self.corner(origin, &places.points[link.to], faces)
            });
            pieces.push(Piece {
                face: link.face,
                next: rank[link.next],
                prev: usize::MAX,
                corner,
            });
        }
        for p in 0..pieces.len() {
            let next = pieces[p].next;
            pieces[next].prev = p;
        }
        self.pieces = pieces;
    }

    /// Where the wavefront turns back at the end of an edge: the terminal there emits its wavefront
    /// edge as soon as anything moves.
    fn emit_terminals(&mut self, links: &mut Vec<Link>, places: &mut Places) {
        for l in 0..links.len() {
            let next = links[l].next;
            if !links[l].alive {
                continue;
            }
            let sides = [links[l].face, links[next].face].map(|face| self.plane(face));
            if !turns_back(&self.model.field, sides[0], sides[1]) {
                continue;
            }
            let place = links[l].to;
            let Some(course) = self.terminal_at(&places.points[place]) else {
                continue;
            };
            let plane = self.model.plane_at(course, &self.time);
            if sides.iter().all(|side| side.stands()) {
                continue;
            }
            if let Some(corner) = links[l].corner.take() {
                let node = self.node(places, place);
                self.finish(&corner, node);
            }
            let face = self.face(plane);
            links[l].next = links.len();
            links.push(Link {
                face,
                from: place,
                to: place,
                next,
                corner: None,
                alive: true,
            });
        }
    }

    /// The terminal at a place where a wavefront turns back. There is none where both sides of a wall have grown
    /// beyond its end, because others passed below its eave.
    fn terminal_at(&self, point: &Point) -> Option<usize> {
        let Model {
            points,
            field,
            terminals,
            ..
        } = self.model;
        let vertex = points
            .iter()
            .position(|vertex| Point::integer(vertex).compare(point, field) == Ordering::Equal);
        vertex.and_then(|vertex| terminals[vertex])
    }

    /// The face on a plane of phase 0, or a new face on one of a later phase.
    pub(super) fn face(&mut self, plane: usize) -> usize {
        if plane < self.model.courses {
            return plane;
        }
        self.faces.push(plane);
        self.faces.len() - 1
    }

    fn corner(&mut self, origin: usize, point: &Point, faces: [usize; 2]) -> Rc<Corner> {
        let [i, j] = faces.map(|face| self.plane(face));
        let mut turn = turn(&self.model.field, &i.direction, &j.direction);
        let mut terminal = None;
        let motion = if turn != Ordering::Equal {
            Motion::meet(&self.model.field, i, j)
        } else {
            if turns_back(&self.model.field, i, j) {
                assert!(
                    i.stands() && j.stands(),
                    "wavefront edges of faces {faces:?} lie on each other"
                );
                terminal = self.terminal_at(point);
                turn = Ordering::Less;
            }
            Motion::ghost(&self.model.field, i, point, &self.time)
        };
        self.corners += 1;
        Rc::new(Corner {
            id: self.corners,
            motion,
            origin,
            faces,
            turn,
            as_one: turn == Ordering::Equal && !self.stand_apart([i, j], point),
            terminal,
        })
    }

    /// Do two neighbours on one line both stand still, and does the wall below a tilted eave end between them, where the
    /// eave does? Then they stay side by side.
    fn stand_apart(&self, [i, j]: [&Plane; 2], point: &Point) -> bool {
        let ends_here = |wall: &Plane, end: usize| {
            let end = Point::integer(&self.model.points[wall.ends[end]]);
            wall.eave.is_some() && end.compare(point, &self.model.field) == Ordering::Equal
        };
        i.stands() && j.stands() && (ends_here(i, 1) || ends_here(j, 0))
    }

    /// Of all pairs of parallel neighbours of different speed, the one with the fastest edge:
    /// the link before the corner, and the faster link. Of equally fast edges, those go first
    /// that overrun the edge after them (the unswept side on their left). A slow edge between
    /// two equally fast ones thus falls to the one before it.
    ///
    /// Of edges that are equally fast now, the faster one is the one that will be, as soon as they differ.
    fn next_overrun(
        &self,
        links: &[Link],
        places: &Places,
        waits: impl Fn(usize) -> bool,
    ) -> Option<(usize, usize)> {
        let mut best: Option<(usize, usize)> = None;
        for (l, link) in links.iter().enumerate().filter(|(_, link)| link.alive) {
            let [i, j] = [link.face, links[link.next].face];
            let planes = [i, j].map(|face| self.plane(face));
            if !same_direction(&self.model.field, planes[0], planes[1])
                || self.stand_apart(planes, &places.points[link.to])
                || waits(l)
            {
                continue;
            }
            let fast = match self.model.faster(self.faces[i], self.faces[j]) {
                Ordering::Greater => l,
                Ordering::Equal => continue,
                Ordering::Less => link.next,
            };
            if best.is_none_or(|best| self.is_before_overrun(links, (l, fast), best)) {
                best = Some((l, fast));
            }
        }
        best
    }

    /// Does the first of two overruns come before the second?
    fn is_before_overrun(
        &self,
        links: &[Link],
        (l, fast): (usize, usize),
        (k, other): (usize, usize),
    ) -> bool {
        let [i, j] = [fast, other].map(|link| self.faces[links[link].face]);
        let order = self.model.faster(i, j);
        let order = order.then((l == fast).cmp(&(k == other)));
        let course = |plane: usize| self.model.planes[plane].course;
        order.then(course(j).cmp(&course(i))) == Ordering::Greater
    }

    /// Removes the slower of two parallel neighbours at once, along its whole length.
    fn overrun(&mut self, links: &mut [Link], places: &mut Places, link: usize, fast: usize) {
        let slow = if fast == link { links[link].next } else { link };
        let Link { from, to, next, .. } = links[slow];
        let faces = [links[fast].face, links[slow].face];
        self.level_arc(places, [from, to], faces, ArcKind::Ridge);
        links[slow].alive = false;
        if fast == link {
            if let Some(corner) = links[slow].corner.take() {
                let node = self.node(places, to);
                self.finish(&corner, node);
            }
            links[fast].to = to;
            links[fast].next = next;
        } else {
            let before = (0..links.len())
                .find(|&l| links[l].alive && links[l].next == slow)
                .expect("chains are closed");
            if let Some(corner) = links[before].corner.take() {
                let node = self.node(places, from);
                self.finish(&corner, node);
            }
            links[fast].from = from;
            links[before].next = fast;
        }
    }
}

/// Do the two wavefront edges run in one direction?
pub(super) fn same_direction(field: &Field, i: &Plane, j: &Plane) -> bool {
    cross(field, &i.direction, &j.direction).is_zero()
        && field.sign(&dot(field, &i.direction, &j.direction)) == Ordering::Greater
}

/// Do they run in opposite directions?
fn turns_back(field: &Field, i: &Plane, j: &Plane) -> bool {
    cross(field, &i.direction, &j.direction).is_zero()
        && field.sign(&dot(field, &i.direction, &j.direction)) == Ordering::Less
}

/// Neighbours that belong to one face are one edge.
fn join_equals(links: &mut [Link]) {
    for l in 0..links.len() {
        while links[l].alive {
            let next = links[l].next;
            if links[next].face != links[l].face || next == l {
                break;
            }
            let Link {
                to,
                next: after,
                ref corner,
                ..
            } = links[next];
            links[l].corner = corner.clone();
            links[l].to = to;
            links[l].next = after;
            links[next].alive = false;
        }
    }
}
