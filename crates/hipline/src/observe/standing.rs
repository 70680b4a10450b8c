//! Faces without area: walls, and what was overrun as soon as it started.
//!
//! In plan such a face is a part of a line. Where several of them share a border they make a cluster, on one line;
//! around it, cut at all positions on it, each piece of the line has one ground above and one
//! below. These pieces take the place of the borders of the cluster's faces.

use std::collections::{BTreeMap, BTreeSet};

use super::plan::{Border, Ground, Plan};
use crate::{
    lift::Lift,
    predicates::{Spot, Track},
    topology::FaceId,
};

/// A border of a face without area.
#[derive(Debug, Clone, Copy)]
pub(super) struct Standing {
    /// The numbers of its ends' positions, as it is walked.
    pub ends: [u32; 2],
    pub border: Border,
    /// What is on the left and on the right of the walk.
    pub grounds: [Ground; 2],
}

/// Whether a face has no area.
pub(super) fn has_no_area(lift: &Lift, face: FaceId) -> bool {
    let skeleton = lift.skeleton;
    skeleton.boundary(face).len() < 3
        || (lift.planes.has_upright() && lift.planes.stands_still(lift.plane(face)))
}

/// One piece of a cluster's line.
#[derive(Default)]
struct Piece {
    above: Option<Ground>,
    below: Option<Ground>,
    border: Option<Border>,
}

/// The clusters, each with its borders: those with only one side in it, and edges.
fn clusters(plan: &Plan, list: &[Standing]) -> BTreeMap<FaceId, Vec<Standing>> {
    let inside = |ground: Ground| match ground {
        Ground::Face(face) if has_no_area(&plan.lift, face) => Some(face),
        _ => None,
    };
    let is_edge = |standing: &Standing| matches!(standing.border, Border::Edge(_));
    // Walls at a corner share an arc that is a point in plan: they are on two lines.
    let list: Vec<&Standing> = list.iter().filter(|s| s.ends[0] != s.ends[1]).collect();
    let mut first: BTreeMap<FaceId, FaceId> = BTreeMap::new();
    let root = |first: &BTreeMap<FaceId, FaceId>, mut face: FaceId| {
        while let Some(&before) = first.get(&face).filter(|&&before| before != face) {
            face = before;
        }
        face
    };
    for standing in &list {
        if let [Some(f), Some(g)] = standing.grounds.map(inside) {
            let (f, g) = (root(&first, f), root(&first, g));
            first.insert(f.max(g), f.min(g));
        }
    }
    let mut found: BTreeMap<FaceId, Vec<Standing>> = BTreeMap::new();
    for standing in list {
        let [left, right] = standing.grounds.map(inside);
        if let Some(face) = left.or(right)
            && (left.is_none() || right.is_none() || is_edge(standing))
        {
            found.entry(root(&first, face)).or_default().push(*standing);
        }
    }
    found
}

/// Adds the pieces of all clusters to the plan.
pub(super) fn add_clusters(plan: &mut Plan, list: &[Standing]) {
    for (face, borders) in clusters(plan, list) {
        let ends: BTreeSet<u32> = borders.iter().flat_map(|b| b.ends).collect();
        let ends: Vec<u32> = ends.into_iter().collect();
        let mut pieces: Vec<Piece> = Vec::new();
        pieces.resize_with(ends.len().saturating_sub(1), Piece::default);
        for border in &borders {
            let [from, to] = border.ends;
            let [left, right] = border.grounds;
            let (above, below) = if from < to {
                (left, right)
            } else {
                (right, left)
            };
            let at = |end: u32| ends.binary_search(&end).expect("all ends are there");
            for piece in &mut pieces[at(from.min(to))..at(from.max(to))] {
                for (ground, slot) in [(above, &mut piece.above), (below, &mut piece.below)] {
                    let is_inside = matches!(ground, Ground::Face(f) if has_no_area(&plan.lift, f));
                    if !is_inside {
                        *slot = Some(ground);
                    }
                }
                if matches!(border.border, Border::Edge(_)) || piece.border.is_none() {
                    piece.border = Some(match border.border {
                        Border::Edge(edge) => Border::Edge(edge),
                        _ => Border::Wall(plan.skeleton().face(face).edge),
                    });
                }
            }
        }
        let plane = plan.lift.plane(face);
        let track = Track::Level(plane, plan.planes().phases.time_of(plane));
        for (k, piece) in pieces.into_iter().enumerate() {
            let (Some(above), Some(below), Some(border)) = (piece.above, piece.below, piece.border)
            else {
                unreachable!("{face} has a border with one side only");
            };
            let pair = [ends[k], ends[k + 1]];
            let spots = pair.map(|end| Spot::Place(&plan.positions[end as usize].place));
            let forward = plan
                .planes()
                .compare_spots_along(spots[0], spots[1], plane)
                .is_lt();
            // What comes later is on the left of the edge, and positive.
            plan.add(pair, border, [above, below], track, !forward);
        }
    }
}
