//! Faces: simple, counterclockwise, monotone to their edges.
//!
//! Without weights, time within a face is the distance from its edge. Where the face of
//! plane i borders on that of plane j, the places on plane i that are nearer to i's edge than
//! the arc are ahead of j, those beyond it are behind j: on plane i, with u along the edge
//! and h away from it, the distance from j grows by cos - 1 < 0 per unit of h, where cos is
//! between the normals. So walking counterclockwise, a ridge goes against the edge's direction (it
//! bounds the face from above), a valley with it (from below), and a ghost arc goes up on
//! the right or down on the left. That gives the boundary two monotone chains; the face is simple
//! if each corner of either is on the proper side of the piece of the other above or below it.

use super::{Checker, Violation, dart};
use crate::{
    predicates::PlaneId,
    skeleton::ArcKind,
    topology::{ArcId, FaceId, NodeId},
};
use hipline_num::Sign;

/// A piece of a boundary; its ends in the order of the edge's direction.
#[derive(Clone, Copy, Debug)]
pub(super) struct Piece {
    /// `None` at infinity.
    pub ends: [Option<NodeId>; 2],
    /// The plane on the other side; `None` for the base.
    pub other: Option<PlaneId>,
}

/// The chains of a boundary, each in the order of the edge's direction.
#[derive(Default)]
pub(super) struct Chains {
    pub lower: Vec<Piece>,
    pub upper: Vec<Piece>,
    /// The start of the lower one, beyond the base.
    left: Vec<Piece>,
}

impl Chains {
    fn clear(&mut self) {
        self.lower.clear();
        self.upper.clear();
        self.left.clear();
    }
}

/// Where a walk around a face is.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Stage {
    LowerRight,
    Right,
    Upper,
    Left,
    LowerLeft,
}

impl Checker<'_> {
    /// Checks the shapes of all faces.
    pub(super) fn check_face_shapes(&mut self) {
        let mut chains = Chains::default();
        for f in 0..self.skeleton.faces.len() {
            let face = FaceId::new(f);
            if self.unweighted {
                if self.skeleton.holes(face).next().is_some() {
                    self.report.add(Violation::NotMonotone { face });
                } else if self.find_chains(face, &mut chains) {
                    self.check_sides(face, &chains.lower, &chains.upper, Sign::Positive);
                    self.check_sides(face, &chains.upper, &chains.lower, Sign::Negative);
                } else {
                    self.report.add(Violation::NotMonotone { face });
                }
            } else {
                self.check_area(face);
            }
        }
    }

    /// How a step goes along the edge of its face.
    fn progress(&self, step: u32, plane: PlaneId) -> Sign {
        let arc = self.skeleton.arcs[step as usize / 2];
        let [from, to] = arc.nodes.map(|n| self.places[n.index()]);
        let from = from.expect("arcs start at finite nodes");
        let forward = if let Some(to) = to {
            Sign::from(self.planes.compare_along(&to, &from, plane))
        } else {
            let pair = arc.faces.map(|face| self.plane_of(face));
            match self.planes.turn(pair[0], pair[1]) {
                Sign::Zero => Sign::Zero,
                _ => self.planes.drift(self.turning_left(pair), plane),
            }
        };
        if step.is_multiple_of(2) {
            forward
        } else {
            -forward
        }
    }

    /// Walks around a face and sorts its pieces into chains. False if it is not monotone.
    pub(super) fn find_chains(&mut self, face: FaceId, chains: &mut Chains) -> bool {
        let plane = self.plane_of(face);
        let arcs = self.skeleton.arcs.len();
        let first = self.skeleton.cycles[self.skeleton.face(face).cycles[0] as usize] as usize;
        let corners = self.skeleton.boundary(face);
        let finite = |n: NodeId| (!self.skeleton.node(n).is_at_infinity()).then_some(n);
        let mut stage = Stage::LowerRight;
        let mut jumped = false;
        chains.clear();
        for (i, &from) in corners.iter().enumerate() {
            let step = self.incidence.steps[first + i];
            let ends = [from, corners[(i + 1) % corners.len()]].map(finite);
            if step == dart::JUMP {
                // A face can be unbounded on its right, on its left, or on both sides of
                // an upper chain: one jump each.
                if stage > Stage::Upper {
                    return false;
                }
                jumped = true;
                continue;
            }
            if step as usize >= 2 * arcs {
                chains.lower.push(Piece { ends, other: None });
                continue;
            }
            let arc = self.skeleton.arcs[step as usize / 2];
            let progress = self.progress(step, plane);
            let expected = match arc.kind {
                ArcKind::Ridge => Sign::Negative,
                ArcKind::Valley => Sign::Positive,
                ArcKind::Ghost | ArcKind::Crease => Sign::Zero,
            };
            if progress != expected {
                self.report.add(Violation::WrongProgress {
                    face,
                    arc: ArcId::raw(step / 2),
                });
            }
            let other = Some(self.plane_of(arc.faces[usize::from(step.is_multiple_of(2))]));
            let next = match progress {
                Sign::Positive if stage == Stage::LowerRight && !jumped => Stage::LowerRight,
                Sign::Positive => Stage::LowerLeft,
                Sign::Negative => Stage::Upper,
                Sign::Zero if step.is_multiple_of(2) => Stage::Right,
                Sign::Zero => Stage::Left,
            };
            if next < stage || (next == Stage::Right && jumped) {
                return false;
            }
            stage = next;
            match stage {
                Stage::LowerRight => chains.lower.push(Piece { ends, other }),
                Stage::Upper => chains.upper.push(Piece {
                    ends: [ends[1], ends[0]],
                    other,
                }),
                Stage::LowerLeft => chains.left.push(Piece { ends, other }),
                Stage::Right | Stage::Left => {}
            }
        }
        chains.left.append(&mut chains.lower);
        std::mem::swap(&mut chains.left, &mut chains.lower);
        chains.upper.reverse();
        true
    }

    /// Checks that the corners of one chain are on the proper side of the pieces of the other:
    /// positive, if they must be ahead of the planes beyond these.
    fn check_sides(&mut self, face: FaceId, chain: &[Piece], pieces: &[Piece], side: Sign) {
        let (Some(first), Some(last)) = (chain.first(), chain.last()) else {
            return;
        };
        let plane = self.plane_of(face);
        let order = |p: NodeId, q: NodeId| {
            let [p, q] = [p, q].map(|n| self.places[n.index()].expect("a finite node"));
            self.planes.compare_along(&p, &q, plane)
        };
        let mut wrong = Vec::new();
        let mut k = 0;
        let corners = chain
            .iter()
            .filter_map(|piece| piece.ends[0])
            .chain(last.ends[1]);
        for node in corners {
            while let Some(Piece {
                ends: [_, Some(end)],
                ..
            }) = pieces.get(k)
                && *end != node
                && order(*end, node).is_lt()
            {
                k += 1;
            }
            let Some(piece) = pieces.get(k) else { break };
            if piece.ends[0] == Some(node) || piece.ends[1] == Some(node) {
                let joint_start =
                    k == 0 && piece.ends[0] == Some(node) && first.ends[0] == Some(node);
                let joint_end = k + 1 == pieces.len()
                    && piece.ends[1] == Some(node)
                    && last.ends[1] == Some(node);
                if !joint_start && !joint_end {
                    wrong.push(node);
                }
                continue;
            }
            if piece.ends[0].is_some_and(|start| order(start, node).is_gt()) {
                continue;
            }
            // What lies above the base does so because its time is positive.
            let Some(other) = piece.other else { continue };
            let place = self.places[node.index()].expect("a finite node");
            if self.planes.ahead(&place, other) != side {
                wrong.push(node);
            }
        }
        for node in wrong {
            self.report.add(Violation::MeetsItself { face, node });
        }
    }

    /// With weights: whether the area, without that of the holes, is provably negative.
    fn check_area(&mut self, face: FaceId) {
        let outer = std::iter::once(self.skeleton.boundary(face));
        let cycles: Vec<&[NodeId]> = outer.chain(self.skeleton.holes(face)).collect();
        let infinite = |n: &NodeId| self.skeleton.node(*n).is_at_infinity();
        if cycles.iter().any(|cycle| cycle.iter().any(infinite)) {
            return;
        }
        let places = cycles.iter().map(|cycle| {
            cycle
                .iter()
                .map(|n| self.places[n.index()].as_ref().expect("a finite node"))
                .collect()
        });
        if self.planes.area_sign(places) == Some(Sign::Negative) {
            self.report.add(Violation::Clockwise { face });
        }
    }
}
