//! At the moment of an event: a new wavefront from the places of the old one.
//!
//! No kinds of events are told apart. The old edges, as segments between places, are split where
//! a vertex lies on them; what lies face to face cancels; around each place the rest is sorted by
//! angle and linked so that each pair of links bounds one unswept sector.

use std::cmp::Ordering;
use std::collections::BTreeMap;
use std::rc::Rc;

use super::model::{Vector, around};
use super::motion::Point;
use super::ratio::Ratio;
use super::wave::{Corner, Link, Places, Wave};

/// A part of a wavefront edge between neighbouring places.
#[derive(Debug, Clone, Copy)]
struct Part {
    face: usize,
    from: usize,
    to: usize,
}

impl Wave<'_> {
    /// Moves on to `time`, the moment of the next event.
    pub(super) fn advance(&mut self, time: Ratio) {
        self.time = time;
        let (mut places, at) = self.places();
        let (parts, split) = self.parts(&places, &at);
        let mut corners: Vec<Vec<Rc<Corner>>> = vec![Vec::new(); places.points.len()];
        for (piece, &place) in self.pieces.iter().zip(&at) {
            corners[place].push(piece.corner.clone());
        }
        let happens: Vec<bool> = (0..corners.len())
            .map(|p| corners[p].len() > 1 || split[p])
            .collect();
        assert!(happens.contains(&true), "nothing happens at an event");
        for place in (0..corners.len()).filter(|&place| happens[place]) {
            let node = self.node(&mut places, place);
            for corner in &corners[place] {
                self.finish(corner, node);
            }
        }
        let parts = self.cancel(&mut places, &parts);
        let mut links: Vec<Link> = parts
            .iter()
            .map(|&Part { face, from, to }| Link {
                face,
                from,
                to,
                next: usize::MAX,
                corner: None,
                alive: true,
            })
            .collect();
        for place in 0..corners.len() {
            self.link(&mut links, place);
            if !happens[place] {
                let arriving = links.iter_mut().find(|link| link.to == place);
                arriving
                    .expect("one edge arrives at an undisturbed vertex")
                    .corner = corners[place].pop();
            }
        }
        self.settle(links, &mut places);
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

    /// The edges split at all places on them; and which places are inside an edge.
    fn parts(&self, places: &Places, at: &[usize]) -> (Vec<Part>, Vec<bool>) {
        let mut split = vec![false; places.points.len()];
        let mut parts = Vec::new();
        for (p, piece) in self.pieces.iter().enumerate() {
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
            for &stop in &stops {
                split[stop] = true;
                parts.push(Part {
                    face: piece.face,
                    from: last,
                    to: stop,
                });
                last = stop;
            }
            if from != to {
                parts.push(Part {
                    face: piece.face,
                    from: last,
                    to,
                });
            }
        }
        (parts, split)
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
        let face = &self.model.faces[face];
        let (tn, td) = self.time.parts();
        let right = field.mul(&face.rate, tn).plus(&td.times(&face.level));
        let left = point.tops[0]
            .times(&face.normal[0])
            .plus(&point.tops[1].times(&face.normal[1]));
        field
            .mul(&left, td)
            .minus(&field.mul(&point.bottom, &right))
            .is_zero()
    }

    /// Removes what lies face to face, leaving ridges.
    fn cancel(&mut self, places: &mut Places, parts: &[Part]) -> Vec<Part> {
        let mut seen: BTreeMap<(usize, usize), Vec<Part>> = BTreeMap::new();
        for part in parts {
            seen.entry((part.from.min(part.to), part.from.max(part.to)))
                .or_default()
                .push(*part);
        }
        for pair in seen.values() {
            match pair.as_slice() {
                [_] => {}
                [a, b] if a.from == b.to => {
                    self.level_arc(places, [a.from, a.to], [b.face, a.face])
                }
                _ => panic!("wavefront edges overlap: {pair:?}"),
            }
        }
        parts
            .iter()
            .filter(|part| seen[&(part.from.min(part.to), part.from.max(part.to))].len() == 1)
            .copied()
            .collect()
    }

    /// Links what arrives at a place to what leaves it, sector by sector.
    fn link(&self, links: &mut [Link], place: usize) {
        let direction = |l: usize| &self.model.faces[links[l].face].direction;
        let mut rays: Vec<(Vector, usize, bool)> = Vec::new();
        for (l, link) in links.iter().enumerate() {
            if link.from == place {
                rays.push((direction(l).clone(), l, true));
            }
            if link.to == place {
                rays.push((direction(l).clone().map(|x| -x), l, false));
            }
        }
        rays.sort_by(|a, b| around(&a.0, &b.0));
        for i in 0..rays.len() {
            let (_, arriving, leaves) = rays[i];
            if leaves {
                continue;
            }
            // Its unswept sector is on the clockwise side of the ray that points back along it.
            let (_, leaving, leaves) = &rays[(i + rays.len() - 1) % rays.len()];
            assert!(
                *leaves,
                "unswept sectors overlap at place {place}: {rays:?}"
            );
            let parallel =
                around(&rays[i].0, &rays[(i + rays.len() - 1) % rays.len()].0) == Ordering::Equal;
            assert!(!parallel, "an unswept sector of no width");
            links[arriving].next = *leaving;
        }
    }
}
