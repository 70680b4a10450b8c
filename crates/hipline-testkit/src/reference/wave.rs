//! The wavefront at one moment, and how it settles after an event.

use std::cmp::Ordering;
use std::collections::HashMap;
use std::rc::Rc;

use dashu_int::IBig;
use hipline::skeleton::ArcKind;

use super::model::{Face, Model, cross, dot};
use super::motion::{Motion, Point};
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
        let links = model.faces.iter().enumerate().map(|(f, face)| Link {
            face: f,
            from: face.ends[0],
            to: face.ends[1],
            next: model.next[f],
            corner: None,
            alive: take(f),
        });
        wave.settle(links.collect(), &mut Places { points, nodes });
        wave
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
        let kind = match corner.turn {
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
    pub(super) fn level_arc(&mut self, places: &mut Places, ends: [usize; 2], faces: [usize; 2]) {
        let nodes = ends.map(|place| self.node(places, place));
        self.arcs.push(RawArc {
            nodes,
            faces,
            kind: ArcKind::Ridge,
        });
    }

    /// Joins what is one, lets the faster of parallel neighbours win, makes the new corners.
    pub(super) fn settle(&mut self, mut links: Vec<Link>, places: &mut Places) {
        join_equals(&mut links);
        while let Some((link, fast)) = self.next_overrun(&links) {
            self.overrun(&mut links, places, link, fast);
            join_equals(&mut links);
        }
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
                self.corner(
                    origin,
                    &places.points[link.to],
                    [link.face, links[link.next].face],
                )
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

    fn corner(&mut self, origin: usize, point: &Point, faces: [usize; 2]) -> Rc<Corner> {
        let [i, j] = faces.map(|f| &self.model.faces[f]);
        let turn = cross(&i.direction, &j.direction).cmp(&IBig::ZERO);
        let motion = if turn == Ordering::Equal {
            assert!(
                same_direction(i, j),
                "wavefront edges of faces {faces:?} lie on each other"
            );
            Motion::ghost(&self.model.field, i, point, &self.time)
        } else {
            Motion::meet(&self.model.field, i, j)
        };
        self.corners += 1;
        Rc::new(Corner {
            id: self.corners,
            motion,
            origin,
            faces,
            turn,
        })
    }

    /// Of all pairs of parallel neighbours of different speed, the one with the fastest edge:
    /// the link before the corner, and the faster link. Of equally fast edges, those go first
    /// that overrun the edge after them (the unswept side on their left). A slow edge between
    /// two equally fast ones thus falls to the one before it.
    fn next_overrun(&self, links: &[Link]) -> Option<(usize, usize)> {
        let faces = &self.model.faces;
        let mut best: Option<(usize, usize)> = None;
        for (l, link) in links.iter().enumerate().filter(|(_, link)| link.alive) {
            let (i, j) = (&faces[link.face], &faces[links[link.next].face]);
            if !same_direction(i, j) || i.speed == j.speed {
                continue;
            }
            let fast = if i.speed > j.speed { l } else { link.next };
            let key = |(before, fast): (usize, usize)| {
                let face = links[fast].face;
                (&faces[face].speed, before == fast, std::cmp::Reverse(face))
            };
            if best.is_none_or(|best| key((l, fast)) > key(best)) {
                best = Some((l, fast));
            }
        }
        best
    }

    /// Removes the slower of two parallel neighbours at once, along its whole length.
    fn overrun(&mut self, links: &mut [Link], places: &mut Places, link: usize, fast: usize) {
        let slow = if fast == link { links[link].next } else { link };
        let Link { from, to, next, .. } = links[slow];
        self.level_arc(places, [from, to], [links[fast].face, links[slow].face]);
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
fn same_direction(i: &Face, j: &Face) -> bool {
    cross(&i.direction, &j.direction) == IBig::ZERO && dot(&i.direction, &j.direction) > IBig::ZERO
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
