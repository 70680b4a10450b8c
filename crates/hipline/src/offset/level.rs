//! The loops of the wavefront at each of several distances.

use super::{Offset, OffsetLoop, by_face::ByFace, parts::Superlevel, sublevel::Sublevel};
use crate::{
    input::Figure,
    lift::Lift,
    predicates::Place,
    skeleton::{ArcKind, NodeKind, Skeleton},
    topology::{ArcId, FaceId, NodeId},
};
use std::cmp::Ordering;

/// How the time of a node lies to the distances.
#[derive(Clone, Copy)]
pub(super) struct Rank {
    /// The number of distances below the node's time.
    pub below: usize,
    /// Whether the next distance is exactly the node's time.
    at: bool,
}

/// A place where the wavefront crosses an arc.
struct Crossing {
    arc: ArcId,
    /// The arc's place in exact terms; `None` where the arc starts at this moment.
    place: Option<Place>,
    point: [f64; 2],
}

/// The wavefronts at distances that are sorted and distinct.
pub(super) fn wavefronts(skeleton: &Skeleton, figure: &Figure, distances: &[f64]) -> Vec<Offset> {
    let lift = Lift::new(skeleton, figure);
    let ranks: Vec<Rank> = (0..skeleton.nodes().len())
        .map(|i| rank(&lift, NodeId::new(i), distances))
        .collect();
    let mut crossed: Vec<Vec<ArcId>> = vec![Vec::new(); distances.len()];
    for (i, arc) in skeleton.arcs().iter().enumerate() {
        let [from, to] = arc.nodes.map(|node| ranks[node.index()].below);
        for list in crossed.iter_mut().take(to).skip(from) {
            list.push(ArcId::new(i));
        }
    }
    let mut superlevel = Superlevel::new(&lift, &ranks, distances.len());
    let mut by_face = ByFace::new(skeleton.faces().len());
    let mut offsets = Vec::with_capacity(distances.len());
    for (i, arcs) in crossed.iter().enumerate().rev() {
        superlevel.lower_to(i);
        let level = Level {
            lift: &lift,
            ranks: &ranks,
            distance: distances[i],
        };
        let rings = level.rings(arcs, &mut by_face);
        offsets.push(level.offset(&rings, &mut superlevel));
    }
    offsets.reverse();
    if let Some(mut sublevel) = Sublevel::new(&lift, figure, &ranks, distances.len()) {
        for (i, (offset, seeds)) in offsets.iter_mut().enumerate() {
            sublevel.raise_to(i);
            offset.swept = sublevel.parts(&offset.loops, seeds);
        }
    }
    offsets.into_iter().map(|(offset, _)| offset).collect()
}

fn rank(lift: &Lift, id: NodeId, distances: &[f64]) -> Rank {
    let node = lift.skeleton.node(id);
    let below = distances.partition_point(|&d| d < node.time);
    match distances.get(below) {
        // The rounded numbers agree: ask for the exact ones.
        Some(d) if d.total_cmp(&node.time).is_eq() => {
            if matches!(node.kind, NodeKind::Input(_)) {
                return Rank { below, at: true };
            }
            match lift.planes.compare_time(&lift.place(id), *d) {
                Ordering::Less => Rank { below, at: false },
                Ordering::Equal => Rank { below, at: true },
                Ordering::Greater => Rank {
                    below: below + 1,
                    at: false,
                },
            }
        }
        _ => Rank { below, at: false },
    }
}

/// One wavefront.
struct Level<'a> {
    lift: &'a Lift<'a>,
    ranks: &'a [Rank],
    distance: f64,
}

impl Level<'_> {
    /// Where the wavefront crosses an arc.
    fn crossing(&self, id: ArcId) -> Crossing {
        let arc = self.lift.skeleton.arc(id);
        let [start, _] = arc.nodes;
        let node = self.lift.skeleton.node(start);
        // Among the distances not below the arc's start only the first can equal it, and
        // then the distance is its time, as f64 too.
        if self.ranks[start.index()].at && node.time.total_cmp(&self.distance).is_eq() {
            return Crossing {
                arc: id,
                place: None,
                point: [node.x, node.y],
            };
        }
        let place = self.lift.at(id, self.distance);
        let [x, y, _] = self.lift.planes.round(&place);
        Crossing {
            arc: id,
            place: Some(place),
            point: [x, y],
        }
    }

    /// The rings of crossings, each with the face after it.
    fn rings(&self, arcs: &[ArcId], by_face: &mut ByFace) -> Vec<Vec<(Crossing, FaceId)>> {
        let crossings: Vec<Crossing> = arcs.iter().map(|&arc| self.crossing(arc)).collect();
        let faces = |k: usize| self.lift.skeleton.arc(crossings[k].arc).faces;
        by_face.enter((0..crossings.len()).map(faces));
        let mut next = vec![usize::MAX; crossings.len()];
        for &face in by_face.faces() {
            if let Some([end, start]) = by_face.only(face) {
                next[start] = end;
                continue;
            }
            let [mut ends, mut starts] = by_face.all(face);
            assert!(
                ends.len() == starts.len(),
                "the wavefront does not close in {face} at {}",
                self.distance
            );
            for list in [&mut ends, &mut starts] {
                list.sort_by(|&a, &b| self.compare(&crossings[a], &crossings[b], face));
            }
            for (start, end) in starts.into_iter().zip(ends) {
                next[start] = end;
            }
        }
        let after: Vec<FaceId> = (0..crossings.len()).map(|k| faces(k)[1]).collect();
        let mut crossings: Vec<Option<Crossing>> = crossings.into_iter().map(Some).collect();
        let mut rings = Vec::new();
        for first in 0..crossings.len() {
            let (mut ring, mut at) = (Vec::new(), first);
            while let Some(crossing) = crossings[at].take() {
                ring.push((crossing, after[at]));
                at = next[at];
            }
            // An arc with one face on both sides is no corner.
            ring.retain(|(crossing, after)| {
                self.lift.skeleton.arc(crossing.arc).faces[0] != *after
            });
            if !ring.is_empty() {
                rings.push(ring);
            }
        }
        rings
    }

    /// The order of two crossings along the edge of a face, immediately after this moment.
    fn compare(&self, p: &Crossing, q: &Crossing, face: FaceId) -> Ordering {
        let plane = self.lift.plane(face);
        let planes = &self.lift.planes;
        let place = |c: &Crossing| {
            c.place
                .unwrap_or_else(|| self.lift.place(self.lift.skeleton.arc(c.arc).nodes[0]))
        };
        planes
            .compare_along(&place(p), &place(q), plane)
            .then_with(|| {
                let pair = |c: &Crossing| {
                    let ghost = self.lift.skeleton.arc(c.arc).kind == ArcKind::Ghost;
                    let stays = ghost || self.lift.is_upright(c.arc);
                    (!stays).then(|| self.lift.pair(c.arc))
                };
                planes.compare_drifts([pair(p), pair(q)], plane)
            })
    }

    /// Loops and parts from rings, with a node below each loop.
    fn offset(
        &self,
        rings: &[Vec<(Crossing, FaceId)>],
        superlevel: &mut Superlevel,
    ) -> (Offset, Vec<NodeId>) {
        let mut loops = Vec::with_capacity(rings.len());
        let mut seeds = Vec::with_capacity(rings.len());
        let mut below = Vec::with_capacity(rings.len());
        for ring in rings {
            let upper = |k: usize| {
                let (crossing, _) = &ring[k];
                self.lift.skeleton.arc(crossing.arc).nodes[1]
            };
            for k in 1..ring.len() {
                superlevel.connect(upper(0), upper(k));
            }
            let bits = |crossing: &Crossing| crossing.point.map(f64::to_bits);
            let next = ring.iter().skip(1).chain(ring.first());
            let kept = ring
                .iter()
                .zip(next)
                .filter(|(a, b)| bits(&a.0) != bits(&b.0));
            let (points, faces): (Vec<_>, Vec<_>) = kept.map(|(a, _)| (a.0.point, a.1)).unzip();
            // Points on one line are left of a loop too small for f64 to tell, and at the
            // start of the wavefront of lines.
            if !is_flat(&points) || (points.len() > 1 && self.distance <= 0.0) {
                loops.push(OffsetLoop { points, faces });
                seeds.push(upper(0));
                below.push(self.lift.skeleton.arc(ring[0].0.arc).nodes[0]);
            }
        }
        let parts = superlevel.parts(&loops, &seeds);
        let offset = Offset {
            distance: self.distance,
            loops,
            parts,
            swept: Vec::new(),
        };
        (offset, below)
    }
}

/// Whether all points lie on one line.
pub(super) fn is_flat(points: &[[f64; 2]]) -> bool {
    let coord = |[x, y]: [f64; 2]| robust::Coord { x, y };
    let [p, q, rest @ ..] = points else {
        return true;
    };
    rest.iter()
        .all(|&r| robust::orient2d(coord(*p), coord(*q), coord(r)).abs() <= 0.0)
}
