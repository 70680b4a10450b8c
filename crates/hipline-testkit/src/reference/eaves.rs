//! Edges whose ends have different heights: walls below tilted eaves, and the facets above them.
//!
//! Let the wavefront edge of a side run from p to q, `d = q - p`, `L = |d|`, with the unswept side on its left, and let
//! n be d turned left. The facet is the plane of times whose gradient g has the length `1 / w`,
//! leads to the unswept side, and takes the time from that of p to that of q along d:
//!
//! ```text
//! g . d = dh,   |g| = 1 / w   =>   g = (dh d + sqrt(L^2 / w^2 - dh^2) n) / L^2
//! ```
//!
//! Times `w L^2`, that is a normal of length `L^2` and a plane `w dh d + R n` with one root,
//! `R = sqrt(L^2 - w^2 dh^2)`. At each moment the facet's wavefront edge is perpendicular to g.

use std::cmp::Ordering;
use std::collections::BTreeMap;

use dashu_int::IBig;
use hipline::skeleton::Side;

use super::graph::Graph;
use super::heading::{Heading, cross, dot};
use super::model::{Plane, Vector, dot as dot_of, scaled};
use super::motion::{Motion, Point};
use super::number::{Field, Num};
use super::ratio::Ratio;
use super::wave::{Link, Places, Wave, same_direction};

/// What a wall knows of its facet.
#[derive(Debug)]
pub(super) struct Eave {
    /// Its plane.
    pub facet: usize,
    /// Whether the lower end is the start of the wavefront edge.
    pub rises: bool,
}

/// A facet before there is a field of numbers to write it in.
pub(super) struct Slant {
    /// The plane of the wall.
    pub course: usize,
    /// Whether the lower end is the start of the wavefront edge.
    pub rises: bool,
    along: Vector,
    start: Vector,
    /// Height of the start, of the lower end, and of the end above the start.
    heights: [IBig; 3],
    speed: IBig,
    radicand: IBig,
}

impl Slant {
    /// All of a graph; heights are times, scaled by so many bits.
    pub(super) fn all(graph: &Graph, points: &[Vector], planes: &[Plane], bits: i64) -> Vec<Self> {
        let of = |(course, plane): (usize, &Plane)| {
            let right = match plane.side {
                Side::Left => 0,
                Side::Right => 1,
                Side::Start | Side::End => return None,
            };
            let speed = graph.edges[plane.edge].speeds[right];
            let [from, to] = plane.ends.map(|end| scaled(graph.height(end), bits));
            if speed <= 0.0 || from == to {
                return None;
            }
            let [p, q] = plane.ends.map(|end| &points[end]);
            let along: Vector = [0, 1].map(|k| &q[k] - &p[k]);
            let speed = scaled(speed, graph.speed_bits());
            let rise = &to - &from;
            let steep = &speed * &rise;
            let radicand = dot_of(&along, &along) - &steep * &steep;
            assert!(radicand > IBig::ZERO, "the eave of {plane:?} is too steep");
            Some(Self {
                course,
                rises: from < to,
                along,
                start: p.clone(),
                heights: [from.clone(), from.min(to), rise],
                speed,
                radicand,
            })
        };
        planes.iter().enumerate().filter_map(of).collect()
    }

    /// The number under the root.
    pub(super) const fn radicand(&self) -> &IBig {
        &self.radicand
    }

    /// The facet's plane.
    pub(super) fn facet(&self, field: &Field, planes: &[Plane]) -> Plane {
        let wall = &planes[self.course];
        let [height, low, rise] = &self.heights;
        let root = field.root(&self.radicand);
        let steep = &self.speed * rise;
        let [dx, dy] = &self.along;
        let normal: Heading = [
            root.times(&-dy).plus(&Num::from(&steep * dx)),
            root.times(dx).plus(&Num::from(&steep * dy)),
        ];
        let square = dot_of(&self.along, &self.along);
        let rate = &self.speed * &square;
        let there = self.start.clone().map(Num::from);
        Plane {
            phase: 1,
            start: Ratio::integer(low),
            later: None,
            eave: None,
            direction: [normal[1].clone(), normal[0].opposite()],
            level: dot(field, &normal, &there).minus(&Num::from(&rate * height)),
            normal,
            square: &square * &square,
            rate: rate.into(),
            speed: self.speed.clone(),
            ..*wall
        }
    }
}

impl Wave<'_> {
    /// Starts the facets whose lower end is reached now, as wavefront edges of length zero, and with them
    /// the terminals at ends of tilted eaves. What its neighbours cover at once does not start.
    pub(super) fn start_facets(&mut self, links: &mut Vec<Link>, places: &mut Places) {
        let model = self.model;
        let field = &model.field;
        // By the link before: a facet over that, a terminal, a facet over the link after.
        let mut starting: BTreeMap<usize, [Option<usize>; 3]> = BTreeMap::new();
        let at = |places: &Places, vertex: usize| {
            let vertex = Point::integer(&model.points[vertex]);
            let mut points = places.points.iter();
            points.position(|point| point.compare(&vertex, field) == Ordering::Equal)
        };
        let is_now = |plane: usize| {
            let start = &model.planes[plane].start;
            start.compare(&self.time, field) == Ordering::Equal
        };
        for (course, wall) in model.planes[..model.courses].iter().enumerate() {
            let Some(Eave { facet, rises }) = wall.eave else {
                continue;
            };
            let Some(place) = at(places, wall.ends[usize::from(!rises)]).filter(|_| is_now(facet))
            else {
                continue;
            };
            let find = |fits: &dyn Fn(&Link) -> bool| {
                (0..links.len()).find(|&l| links[l].alive && fits(&links[l]))
            };
            let own = |link: &Link| link.face == course;
            let before = if rises {
                let link = find(&|link| own(link) && link.from == place);
                link.and_then(|link| find(&|before| before.next == link))
            } else {
                find(&|link| own(link) && link.to == place)
            };
            if let Some(before) = before {
                starting.entry(before).or_default()[if rises { 2 } else { 0 }] = Some(facet);
            }
        }
        for vertex in 0..model.points.len() {
            let Some(course) = model.terminals[vertex] else {
                continue;
            };
            let plane = model.plane_at(course, &self.time);
            let edge = model.planes[course].edge;
            // On both sides of the edge; beside its own wall, a facet only passes by.
            let are_sides = |faces: [usize; 2]| {
                let [i, j] = faces.map(|face| self.plane(face));
                let is_side = |side| matches!(side, Side::Left | Side::Right);
                let both = is_side(i.side) && is_side(j.side) && i.side != j.side;
                both && i.edge == edge && j.edge == edge
            };
            let is_tilted = |plane: &Plane| plane.edge == edge && plane.eave.is_some();
            if !is_now(plane) || !model.planes.iter().any(is_tilted) {
                continue;
            }
            let before = at(places, vertex).and_then(|place| {
                (0..links.len()).find(|&l| {
                    let (link, next) = (&links[l], links[l].next);
                    link.alive && link.to == place && are_sides([link.face, links[next].face])
                })
            });
            if let Some(before) = before {
                starting.entry(before).or_default()[1] = Some(plane);
            }
        }
        for (before, planes) in starting {
            let mut planes: Vec<usize> = planes.into_iter().flatten().collect();
            let ends = [before, links[before].next].map(|link| self.faces[links[link].face]);
            self.drop_covered(ends, &mut planes);
            if planes.is_empty() {
                continue;
            }
            let place = links[before].to;
            if let Some(corner) = links[before].corner.take() {
                let node = self.node(places, place);
                self.finish(&corner, node);
            }
            let after = links[before].next;
            let mut last = before;
            for plane in planes {
                links[last].next = links.len();
                last = links.len();
                links.push(Link {
                    face: self.face(plane),
                    from: place,
                    to: place,
                    next: after,
                    corner: None,
                    alive: true,
                });
            }
        }
    }

    /// Whether a facet starts now between a link and the one after it, which lie on one line: over the one or the other.
    pub(super) fn awaits_facet(&self, links: &[Link], places: &Places, link: usize) -> bool {
        let model = self.model;
        let place = &places.points[links[link].to];
        let starts = |face: usize, rises: bool| {
            let wall = self.plane(face);
            wall.eave.as_ref().is_some_and(|eave| {
                let low = Point::integer(&model.points[wall.ends[usize::from(!rises)]]);
                let start = &model.planes[eave.facet].start;
                eave.rises == rises
                    && start.compare(&self.time, &model.field) == Ordering::Equal
                    && low.compare(place, &model.field) == Ordering::Equal
            })
        };
        starts(links[link].face, false) || starts(links[links[link].next].face, true)
    }

    /// Of wavefront edges of length zero between two others, only those stay that grow.
    fn drop_covered(&self, [before, after]: [usize; 2], planes: &mut Vec<usize>) {
        loop {
            let mut chain = vec![before];
            chain.extend_from_slice(planes);
            chain.push(after);
            let covered = chain
                .windows(3)
                .position(|three| !self.grows([three[0], three[1], three[2]]));
            let Some(covered) = covered else { return };
            planes.remove(covered);
        }
    }

    /// Removes a facet of length zero that no longer grows, because an edge beside it was overrun; was there one?
    pub(super) fn drop_overtaken(&self, links: &mut [Link]) -> bool {
        for before in 0..links.len() {
            let own = links[before].next;
            let is_facet = || {
                let plane = self.plane(links[own].face);
                plane.phase > 0 && self.model.planes[plane.course].eave.is_some()
            };
            if !links[before].alive || links[own].from != links[own].to || !is_facet() {
                continue;
            }
            let three = [before, own, links[own].next].map(|link| self.faces[links[link].face]);
            if !self.grows(three) {
                links[own].alive = false;
                links[before].next = links[own].next;
                return true;
            }
        }
        false
    }

    /// Does a wavefront edge of length zero grow between its neighbours? On one line with one of them, it is overrun
    /// by a faster one, and overruns a slower one.
    fn grows(&self, three: [usize; 3]) -> bool {
        let field = &self.model.field;
        let [before, own, after] = three.map(|plane| &self.model.planes[plane]);
        let mut speeds = Vec::new();
        for (other, number) in [(before, three[0]), (after, three[2])] {
            if cross(field, &other.direction, &own.direction).is_zero() {
                if !same_direction(field, other, own)
                    || self.model.faster(number, three[1]) == Ordering::Greater
                {
                    return false;
                }
                speeds.push(Ratio::zero());
            } else {
                let motion = Motion::meet(field, other, own);
                let along = dot(field, &motion.velocity, &own.direction);
                speeds.push(Ratio::over_positive(field, along, motion.over));
            }
        }
        speeds[0].compare(&speeds[1], field) == Ordering::Less
    }
}
