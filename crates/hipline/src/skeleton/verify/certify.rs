//! The certificate: the roof is the lower envelope of slabs, so it is that of the straight skeleton.
//!
//! Theorem 2 of Mencil (*A faster algorithm for computing straight skeletons*, 2014; Cheng & Vigneron 2007, and for
//! degenerate input Huber & Held 2011): above the inside of polygons, the terrain of the straight skeleton is the
//! lower envelope of the slabs of edges and of motorcycles. The laws of the other modules make any
//! terrain one that climbs with slope one and nowhere faster. What is asked here beyond them:
//!
//! * every valley lies on the track of a motorcycle of its two planes: so the terrain is nowhere below the envelope;
//! * the terrain lies nowhere above a track: so it is nowhere above the envelope.
//!
//! The proof is in `docs/certificate.md`. The motorcycle graph comes from
//! [`motorcycle`](crate::motorcycle), which knows no skeleton.

use rstar::{AABB, RTree, primitives::GeomWithData, primitives::Rectangle};

use super::{
    Checker, Violations,
    faces::{Chains, Piece},
};
use crate::{
    engine::NotApplicable,
    input::Figure,
    motorcycle::{
        self,
        tracks::{Origin, Track, Tracks},
    },
    predicates::{Place, PlaneId, Planes, Spot, Track as Border},
    skeleton::{ArcKind, Region, Skeleton},
    topology::{ArcId, FaceId, VertexId},
};
use hipline_num::Sign;
use std::collections::BTreeMap;

/// Why a skeleton is not certified.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum Uncertified {
    /// The theorem does not tell about such a figure, or about this part of the plane.
    #[error("the certificate does not apply: {0}")]
    NotApplicable(NotApplicable),
    /// The laws of [`Skeleton::verify`] do not hold.
    #[error("{0}")]
    Unlawful(Violations),
    /// A valley that no motorcycle rides along.
    #[error("{arc}: a valley that does not lie on the track of any motorcycle of its planes")]
    StrayValley {
        /// The valley.
        arc: ArcId,
    },
    /// The roof is above a track where an arc crosses that.
    #[error("{arc} is above the track of the motorcycle from {vertex}")]
    AboveTrack {
        /// The reflex vertex that the motorcycle starts from; of one that starts where others meet, the first
        /// vertex of those.
        vertex: VertexId,
        /// The arc.
        arc: ArcId,
    },
    /// The roof is above a place where motorcycles meet.
    #[error("{face} is above the place where the motorcycle from {vertex} meets others")]
    AboveMeeting {
        /// A reflex vertex that one of them starts from.
        vertex: VertexId,
        /// The face around the place.
        face: FaceId,
    },
}

/// Something with a box around it.
type Boxed = GeomWithData<Rectangle<[f64; 2]>, u32>;

/// A box around points that are correctly rounded; it holds the exact ones.
fn around(points: impl Iterator<Item = [f64; 2]>) -> AABB<[f64; 2]> {
    let (mut low, mut high) = ([f64::INFINITY; 2], [f64::NEG_INFINITY; 2]);
    for p in points {
        for k in 0..2 {
            low[k] = low[k].min(p[k].next_down());
            high[k] = high[k].max(p[k].next_up());
        }
    }
    AABB::from_corners(low, high)
}

/// In how many pieces a track is looked for: the box of a long slanted one holds much else.
const PIECES: usize = 16;

/// Boxes that cover the segment between two correctly rounded points.
fn along(p: [f64; 2], q: [f64; 2]) -> impl Iterator<Item = AABB<[f64; 2]>> {
    let size = [p, q].iter().flatten().fold(0.0_f64, |m, x| m.max(x.abs()));
    // Far more than the roundings of a point between two others.
    let slack = size / (1_u64 << 46) as f64;
    let at = move |i: usize| {
        let s = i as f64 / PIECES as f64;
        [0, 1].map(|k| p[k] + s * (q[k] - p[k]))
    };
    (0..PIECES).map(move |i| {
        let wide = [at(i), at(i + 1)]
            .into_iter()
            .flat_map(|[x, y]| [[x - slack, y - slack], [x + slack, y + slack]]);
        around(wide)
    })
}

impl Skeleton {
    /// Checks that this is the straight skeleton of the inside of a figure's polygons, whoever made it: beyond the
    /// laws of [`Skeleton::verify`], that the roof is the lower envelope of the slabs of edges and motorcycles (Theorem 2
    /// of Mencil 2014). The laws alone do not single out one roof where several wavefronts could go on from
    /// one node; this does. Exact, without tolerances; it takes the motorcycle graph, and no engine.
    ///
    /// # Errors
    /// What is wrong and where; or why the theorem does not apply: it does to the inside of polygons (with holes, touching
    /// or not) whose edges all have speed one and no heights.
    ///
    /// # Complexity
    /// That of the motorcycle graph; O(n log n) for the rest, as long as tracks cross few arcs.
    ///
    /// ```
    /// # use hipline::Polygon;
    /// let polygon = Polygon::new([vec![[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [2.0, 1.0], [0.0, 4.0]]])?;
    /// assert_eq!(polygon.skeleton().certify(polygon.figure()), Ok(()));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn certify(&self, figure: &Figure) -> Result<(), Uncertified> {
        if self.region != Region::Interior {
            return Err(Uncertified::NotApplicable(NotApplicable::NotInterior));
        }
        let (_, tracks) = motorcycle::induced(figure).map_err(Uncertified::NotApplicable)?;
        self.certify_by(figure, &tracks)
    }

    /// The same with given tracks.
    fn certify_by(&self, figure: &Figure, tracks: &Tracks) -> Result<(), Uncertified> {
        let mut checker = self.examine(figure);
        let report = std::mem::take(&mut checker.report);
        report.into_result().map_err(Uncertified::Unlawful)?;
        checker.check_valleys(tracks)?;
        checker.check_tracks(tracks)?;
        checker.check_meetings(tracks)
    }
}

/// A reflex vertex that led to a motorcycle.
fn vertex_of(tracks: &Tracks, mut number: u32) -> VertexId {
    loop {
        match tracks.motorcycles[number as usize].origin {
            Origin::Vertex(vertex) => return vertex,
            Origin::Meeting(meeting) => number = tracks.meetings[meeting as usize].members[0],
            Origin::Given => unreachable!("nobody places a motorcycle in a figure"),
        }
    }
}

impl Checker<'_> {
    fn planes_of(&self, arc: ArcId) -> [PlaneId; 2] {
        self.skeleton.arc(arc).faces.map(|face| self.plane_of(face))
    }

    fn ends_of(&self, arc: ArcId) -> [Place; 2] {
        let nodes = self.skeleton.arc(arc).nodes;
        nodes.map(|n| self.places[n.index()].expect("inside of polygons all nodes are finite"))
    }

    /// Every valley lies on a track of its planes.
    fn check_valleys(&self, tracks: &Tracks) -> Result<(), Uncertified> {
        let classes = self.planes.classes();
        let mut by_planes = BTreeMap::<[u32; 2], Vec<&Track>>::new();
        for track in &tracks.motorcycles {
            let key = Planes::classes_of(&classes, track.pair);
            by_planes.entry(key).or_default().push(track);
        }
        for (a, arc) in self.skeleton.arcs.iter().enumerate() {
            if arc.kind != ArcKind::Valley {
                continue;
            }
            let id = ArcId::new(a);
            let pair = self.turning_left(self.planes_of(id));
            let [from, to] = self.ends_of(id);
            let holds = |track: &&Track| {
                self.planes.compare_times(&track.start, &from).is_le()
                    && (track.end.as_ref())
                        .is_none_or(|end| self.planes.compare_times(&to, end).is_le())
            };
            let candidates = by_planes.get(&Planes::classes_of(&classes, pair));
            if !candidates.is_some_and(|list| list.iter().any(holds)) {
                return Err(Uncertified::StrayValley { arc: id });
            }
        }
        Ok(())
    }

    /// A node's rounded place.
    fn point(&self, node: crate::topology::NodeId) -> [f64; 2] {
        let node = self.skeleton.node(node);
        [node.x, node.y]
    }

    /// The roof lies nowhere above a track, as far as arcs cross that.
    fn check_tracks(&self, tracks: &Tracks) -> Result<(), Uncertified> {
        let boxed = self.skeleton.arcs.iter().zip(0_u32..).map(|(arc, i)| {
            let own = around(arc.nodes.iter().map(|&n| self.point(n)));
            Boxed::new(Rectangle::from_aabb(own), i)
        });
        let index = RTree::bulk_load(boxed.collect());
        let mut found: Vec<u32> = Vec::new();
        for (number, track) in tracks.motorcycles.iter().enumerate() {
            let end = track.end.expect("inside of polygons nobody escapes");
            let [p, q] = [&track.start, &end].map(|place| {
                let [x, y, _] = self.planes.round(place);
                [x, y]
            });
            found.clear();
            for piece in along(p, q) {
                found.extend(index.locate_in_envelope_intersecting(piece).map(|b| b.data));
            }
            found.sort_unstable();
            found.dedup();
            let over = |&&a: &&u32| self.is_over(ArcId::raw(a), track.pair, [&track.start, &end]);
            if let Some(&a) = found.iter().find(over) {
                return Err(Uncertified::AboveTrack {
                    vertex: vertex_of(tracks, number as u32),
                    arc: ArcId::raw(a),
                });
            }
        }
        Ok(())
    }

    /// Whether a track passes below an arc.
    fn is_over(&self, id: ArcId, pair: [PlaneId; 2], track: [&Place; 2]) -> bool {
        if self.skeleton.arc(id).kind == ArcKind::Ghost {
            return false;
        }
        let (border, planes) = (Border::Equal(pair), self.planes_of(id));
        let ends = self.ends_of(id);
        let sides = ends
            .each_ref()
            .map(|n| self.planes.beside(Spot::Place(n), &border));
        match sides {
            [Sign::Zero, Sign::Zero] => ends.iter().any(|n| {
                let after = track.map(|p| {
                    let [p, n] = [p, n].map(Spot::Place);
                    self.planes.compare_spots_along(n, p, pair[0])
                });
                after[0] != after[1] && self.planes.ahead(n, pair[0]).is_negative()
            }),
            _ if (sides[0] * sides[1]).is_positive() => false,
            _ => {
                let own = Border::Equal(planes);
                let [s, e] = track.map(|p| self.planes.beside(Spot::Place(p), &own));
                !(s * e).is_positive() && self.planes.clearance(planes, pair).is_positive()
            }
        }
    }

    /// The roof lies nowhere above a place where motorcycles meet.
    fn check_meetings(&mut self, tracks: &Tracks) -> Result<(), Uncertified> {
        if tracks.meetings.is_empty() {
            return Ok(());
        }
        let boxed = (0..self.skeleton.faces.len()).map(|f| {
            let boundary = self.skeleton.boundary(FaceId::new(f));
            let own = around(boundary.iter().map(|&n| self.point(n)));
            Boxed::new(Rectangle::from_aabb(own), f as u32)
        });
        let index = RTree::bulk_load(boxed.collect());
        let mut chains = Chains::default();
        for meeting in &tracks.meetings {
            let [x, y, _] = self.planes.round(&meeting.place);
            let here = around(std::iter::once([x, y]));
            let mut faces: Vec<u32> =
                (index.locate_in_envelope_intersecting(here).map(|b| b.data)).collect();
            faces.sort_unstable();
            for face in faces.into_iter().map(FaceId::raw) {
                if self.find_chains(face, &mut chains)
                    && self.is_in(&meeting.place, face, &chains)
                    && self
                        .planes
                        .ahead(&meeting.place, self.plane_of(face))
                        .is_positive()
                {
                    return Err(Uncertified::AboveMeeting {
                        vertex: vertex_of(tracks, meeting.members[0]),
                        face,
                    });
                }
            }
        }
        Ok(())
    }

    /// Whether the plan of a place lies in a face, its boundary included.
    fn is_in(&self, place: &Place, face: FaceId, chains: &Chains) -> bool {
        let plane = self.plane_of(face);
        let spot = Spot::Place(place);
        let spans = |piece: &&Piece| {
            let [from, to] = piece.ends.map(|n| {
                let n = n.expect("inside of polygons all nodes are finite");
                let node = self.places[n.index()].as_ref().expect("a finite node");
                self.planes
                    .compare_spots_along(spot, Spot::Place(node), plane)
            });
            from.is_ge() && to.is_le()
        };
        let later = |piece: &Piece| match piece.other {
            Some(other) => self.planes.beside(spot, &Border::Equal([plane, other])),
            None => self.planes.beside(spot, &Border::Level(plane, 0.0)),
        };
        let above = chains
            .lower
            .iter()
            .filter(spans)
            .any(|p| !later(p).is_negative());
        let below = chains
            .upper
            .iter()
            .filter(spans)
            .any(|p| !later(p).is_positive());
        above && below
    }
}

#[cfg(test)]
mod tests;
