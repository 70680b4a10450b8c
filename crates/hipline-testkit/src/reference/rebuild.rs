//! At the moment of an event: a new wavefront from the places of the old one.
//!
//! No kinds of events are told apart. The old edges, as segments between places, are split where
//! a vertex lies on them; what lies face to face cancels; around each place the rest is sorted by
//! angle and linked so that each pair of links bounds one unswept sector. A vertex whose sector is
//! bounded by the same two edges as before goes on; an edge that follows itself was not hit.
//!
//! The two sides of an edge that stands still lie back to back, and both are split where a vertex
//! lies on the one; that does no harm, since on the other side nothing changes.

use std::cmp::Ordering;
use std::collections::BTreeMap;
use std::ops::Range;

use hipline::skeleton::ArcKind;

use super::heading::{Heading, around, dot};
use super::motion::Point;
use super::number::Num;
use super::ratio::Ratio;
use super::wave::{Link, Places, Wave};

/// A part of a wavefront edge between neighbouring places.
#[derive(Debug, Clone, Copy)]
struct Part {
    piece: usize,
    face: usize,
    from: usize,
    to: usize,
}

impl Wave<'_> {
    /// Moves on to `time`: events first, with the speeds so far, then changes of speed, then
    /// neighbours on one line; where facets over tilted eaves start, these after that, and once more what lies on one line.
    pub(super) fn advance(&mut self, time: Ratio) {
        self.time = time;
        let (mut places, at) = self.places();
        let (parts, ranges) = self.parts(&places, &at);
        let kept = self.cancel(&mut places, &parts);
        let mut links: Vec<Link> = parts
            .iter()
            .zip(kept)
            .map(|(&Part { face, from, to, .. }, alive)| Link {
                face,
                from,
                to,
                next: usize::MAX,
                corner: None,
                alive,
            })
            .collect();
        for place in 0..places.points.len() {
            self.link(&mut links, place);
        }
        self.go_on(&mut links, &mut places, &at, &ranges);
        self.change(&mut links, &mut places);
        self.settle_before_facets(&mut links, &mut places);
        self.start_facets(&mut links, &mut places);
        self.settle(links, &mut places);
    }

    /// Corners with the same edges on both sides as before go on, others end; edges that were split
    /// but not hit are whole again.
    fn go_on(
        &mut self,
        links: &mut [Link],
        places: &mut Places,
        at: &[usize],
        ranges: &[Range<usize>],
    ) {
        for p in 0..self.pieces.len() {
            let corner = self.pieces[p].corner.clone();
            let (own, after) = (&ranges[p], &ranges[self.pieces[p].next]);
            let same = !own.is_empty() && !after.is_empty() && {
                let (last, first) = (own.end - 1, after.start);
                links[last].alive && links[first].alive && links[last].next == first
            };
            if same {
                links[own.end - 1].corner = Some(corner);
            } else {
                let node = self.node(places, at[p]);
                self.finish(&corner, node);
            }
        }
        for range in ranges.iter().filter(|range| !range.is_empty()) {
            for l in (range.start..range.end - 1).rev() {
                if links[l].alive && links[l + 1].alive && links[l].next == l + 1 {
                    absorb(links, l, l + 1);
                }
            }
        }
    }

    /// Edges whose speed changes now start new faces beyond a crease. Those that went on as one, with
    /// ghost arcs between them, start one face together, which belongs to the first of them.
    fn change(&mut self, links: &mut [Link], places: &mut Places) {
        let mut before = vec![usize::MAX; links.len()];
        for l in (0..links.len()).filter(|&l| links[l].alive) {
            before[links[l].next] = l;
        }
        let goes_on = |links: &[Link], l: usize| {
            let corner = links[l].corner.as_ref();
            corner.is_some_and(|corner| corner.as_one)
        };
        let heads: Vec<usize> = (0..links.len())
            .filter(|&l| links[l].alive && !goes_on(links, before[l]))
            .filter(|&l| self.later(links[l].face).is_some())
            .collect();
        for head in heads {
            let mut run = vec![head];
            while goes_on(links, run[run.len() - 1]) {
                run.push(links[run[run.len() - 1]].next);
            }
            let planes = run.iter().map(|&l| self.later(links[l].face));
            let planes = planes.map(|plane| plane.expect("what is one changes together"));
            let first = planes.min_by_key(|&plane| self.model.planes[plane].course);
            let face = self.face(first.expect("a run is not empty"));
            if let Some(corner) = links[before[head]].corner.take() {
                let node = self.node(places, links[head].from);
                self.finish(&corner, node);
            }
            for &l in &run {
                let Link { from, to, .. } = links[l];
                let faces = [face, links[l].face];
                self.level_arc(places, [from, to], faces, ArcKind::Crease);
                if let Some(corner) = links[l].corner.take() {
                    let node = self.node(places, to);
                    self.finish(&corner, node);
                }
            }
            for _ in 1..run.len() {
                absorb(links, head, links[head].next);
            }
            links[head].face = face;
            // What follows may be a head as well, and its corner is taken already.
            before[links[head].next] = head;
        }
    }

    /// The plane on which a face's wavefront edges go on, if their speed changes now.
    fn later(&self, face: usize) -> Option<usize> {
        let later = self.plane(face).later?;
        let start = &self.model.planes[later].start;
        (start.compare(&self.time, &self.model.field) == Ordering::Equal).then_some(later)
    }

    /// The distinct places of all vertices in order of x, then y; and for each piece, the number
    /// of the place where it ends.
    fn places(&self) -> (Places, Vec<usize>) {
        let field = &self.model.field;
        let all: Vec<Point> = self
            .pieces
            .iter()
            .map(|piece| piece.corner.motion.point(field, &self.time))
            .collect();
        let mut order: Vec<usize> = (0..all.len()).collect();
        order.sort_by(|&p, &q| all[p].compare(&all[q], field));
        let mut at = vec![0; all.len()];
        let mut points: Vec<Point> = Vec::new();
        for &p in &order {
            if points
                .last()
                .is_none_or(|last| last.compare(&all[p], field) != Ordering::Equal)
            {
                points.push(all[p].clone());
            }
            at[p] = points.len() - 1;
        }
        let nodes = vec![None; points.len()];
        (Places { points, nodes }, at)
    }

    /// The edges split at all places on them; and which parts are those of each piece.
    fn parts(&self, places: &Places, at: &[usize]) -> (Vec<Part>, Vec<Range<usize>>) {
        let mut ranges = Vec::new();
        let mut parts: Vec<Part> = Vec::new();
        for (p, piece) in self.pieces.iter().enumerate() {
            let start = parts.len();
            let (from, to) = (at[piece.prev], at[p]);
            // Places ascend by x, then y, so they ascend or descend along every line.
            let between = from.min(to) + 1..from.max(to);
            let mut stops: Vec<usize> = if from == to {
                Vec::new()
            } else {
                between
                    .filter(|&q| self.is_on_line(places, q, piece.face, [from, to]))
                    .collect()
            };
            if from > to {
                stops.reverse();
            }
            let mut last = from;
            if from != to {
                stops.push(to);
            }
            for stop in stops {
                parts.push(Part {
                    piece: p,
                    face: piece.face,
                    from: last,
                    to: stop,
                });
                last = stop;
            }
            ranges.push(start..parts.len());
        }
        (parts, ranges)
    }

    /// Is a place, known to be between two others in the order, on the line of a face?
    fn is_on_line(&self, places: &Places, place: usize, face: usize, ends: [usize; 2]) -> bool {
        let field = &self.model.field;
        let point = &places.points[place];
        let y = &point.coordinates[1];
        let [above, below] = ends.map(|end| places.points[end].coordinates[1].compare(y, field));
        if above == below && above != Ordering::Equal {
            return false;
        }
        let face = self.plane(face);
        let (tn, td) = self.time.parts();
        let right = field.mul(&face.rate, tn).plus(&field.mul(td, &face.level));
        let left = dot(field, &point.tops, &face.normal);
        field
            .mul(&left, td)
            .minus(&field.mul(&point.bottom, &right))
            .is_zero()
    }

    /// Which parts remain when what lies face to face is removed, leaving ridges.
    ///
    /// What lies on one segment is ordered across it as it was just before: edges that move towards
    /// it on either side, and the two sides of an edge that stands still, back to back.
    fn cancel(&mut self, places: &mut Places, parts: &[Part]) -> Vec<bool> {
        let mut seen: BTreeMap<(usize, usize), Vec<usize>> = BTreeMap::new();
        for (index, part) in parts.iter().enumerate() {
            seen.entry((part.from.min(part.to), part.from.max(part.to)))
                .or_default()
                .push(index);
        }
        let mut kept = vec![true; parts.len()];
        let mut opposite = BTreeMap::new();
        for mut stack in seen.into_values().filter(|stack| stack.len() > 1) {
            // Looking along ascending places: what faces left comes from the right, unless it stands.
            let faces_left = |index: usize| parts[index].from < parts[index].to;
            stack.sort_by_key(|&index| {
                let stands = self.plane(parts[index].face).stands();
                match (faces_left(index), stands) {
                    (true, false) => 0,
                    (false, true) => 1,
                    (true, true) => 2,
                    (false, false) => 3,
                }
            });
            let mut layers = stack.as_slice();
            while let [a, rest @ ..] = layers {
                layers = rest;
                let [b, beyond @ ..] = rest else { continue };
                assert_ne!(
                    faces_left(*a),
                    faces_left(*b),
                    "wavefront edges overlap: {stack:?}"
                );
                if faces_left(*a) {
                    opposite.insert(*a, *b);
                    (kept[*a], kept[*b]) = (false, false);
                    layers = beyond;
                }
            }
        }
        self.ridges(places, parts, &opposite);
        kept
    }

    /// Ridges between parts that lie face to face. Where the same two edges go on face to face, the place
    /// between is that of a vertex beyond an edge that stands still, and nothing happens there.
    fn ridges(&mut self, places: &mut Places, parts: &[Part], opposite: &BTreeMap<usize, usize>) {
        let pieces = |a: usize, b: usize| [parts[a].piece, parts[b].piece];
        let goes_on = |a: usize, b: usize| {
            let after = opposite.get(&(a + 1));
            after.is_some_and(|&after| after + 1 == b && pieces(a + 1, after) == pieces(a, b))
        };
        let mut from = None;
        for (&a, &b) in opposite {
            let start = *from.get_or_insert(parts[a].from);
            if !goes_on(a, b) {
                let ends = [start, parts[a].to];
                self.level_arc(places, ends, [parts[b].face, parts[a].face], ArcKind::Ridge);
                from = None;
            }
        }
    }

    /// Links what arrives at a place to what leaves it, sector by sector.
    fn link(&self, links: &mut [Link], place: usize) {
        let direction = |l: usize| &self.plane(links[l].face).direction;
        let mut rays: Vec<(Heading, usize, bool)> = Vec::new();
        for (l, link) in links.iter().enumerate().filter(|(_, link)| link.alive) {
            if link.from == place {
                rays.push((direction(l).clone(), l, true));
            }
            if link.to == place {
                rays.push((direction(l).each_ref().map(Num::opposite), l, false));
            }
        }
        // Of two that lie back to back, the one that arrives has its sector before the ray.
        let field = &self.model.field;
        rays.sort_by(|a, b| around(field, &a.0, &b.0).then(a.2.cmp(&b.2)));
        for i in 0..rays.len() {
            let (_, arriving, leaves) = rays[i];
            if leaves {
                continue;
            }
            // Its unswept sector is on the clockwise side of the ray that points back along it.
            let (before, leaving, leaves) = &rays[(i + rays.len() - 1) % rays.len()];
            assert!(
                *leaves,
                "unswept sectors overlap at place {place}: {rays:?}"
            );
            assert!(
                around(field, &rays[i].0, before) != Ordering::Equal || rays.len() == 2,
                "an unswept sector of no width at place {place}: {rays:?}"
            );
            links[arriving].next = *leaving;
        }
    }
}

/// A link takes over the one after it.
fn absorb(links: &mut [Link], link: usize, next: usize) {
    links[link].to = links[next].to;
    links[link].corner = links[next].corner.take();
    links[link].next = links[next].next;
    links[next].alive = false;
}
