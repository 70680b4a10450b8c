//! The motorcycles that the inside of a figure's polygons sends.

use super::tracks::{Crash, Origin, Track};
use crate::{
    engine::NotApplicable,
    input::{Figure, Mesh},
    predicates::{Place, PlaneId, Planes},
    topology::{EdgeId, VertexId},
};

const fn next(k: usize) -> usize {
    (k + 1) % 3
}

const fn prev(k: usize) -> usize {
    (k + 2) % 3
}

/// Across the side with number `k` of a triangle: the plane of the side of the figure's edge
/// that faces the triangle, if there is an edge.
fn facing(figure: &Figure, triangle: usize, k: usize) -> Option<PlaneId> {
    let mesh = figure.mesh();
    let edge = mesh.across[triangle][k].edge?;
    let from = figure.edges()[edge as usize].from.index() as u32;
    let right = mesh.corners[triangle][next(k)] != from;
    Some(PlaneId(2 * edge + u32::from(right)))
}

/// The neighbour across the side with number `k` of a triangle and the number of that side there.
fn across(mesh: &Mesh, triangle: usize, k: usize) -> (usize, usize) {
    let other = mesh.across[triangle][k].neighbour as usize;
    let from = mesh.corners[triangle][next(k)];
    let corner = mesh.corners[other]
        .iter()
        .position(|&v| v == from)
        .expect("neighbours share a side");
    (other, next(corner))
}

/// Whether the inside of the figure induces motorcycles that move as its wavefront does.
///
/// # Errors
/// Why not.
pub(super) fn check(figure: &Figure) -> Result<(), NotApplicable> {
    if !figure.has_polygon() || figure.edges().iter().any(|edge| !edge.on_ring) {
        return Err(NotApplicable::NotPolygons);
    }
    if figure.has_heights() {
        return Err(NotApplicable::Heights);
    }
    if let Some(change) = figure.changes().first() {
        return Err(NotApplicable::Speed { edge: change.edge });
    }
    #[expect(clippy::float_cmp, reason = "asks for the number one itself")]
    let uneven = figure.edges().iter().position(|e| e.speeds != [1.0, 1.0]);
    match uneven {
        Some(edge) => Err(NotApplicable::Speed {
            edge: EdgeId::new(edge),
        }),
        None => Ok(()),
    }
}

/// The reflex vertices, one for each sector of more than 180 degrees, in the order of vertices.
pub(super) fn starters(figure: &Figure, planes: &Planes) -> Vec<Track> {
    let mesh = figure.mesh();
    let mut found = Vec::new();
    for (t, corners) in mesh.corners.iter().enumerate() {
        if !mesh.inside[t] {
            continue;
        }
        for (corner, &vertex) in corners.iter().enumerate() {
            // The side from this corner to the next one.
            let Some(out) = facing(figure, t, prev(corner)) else {
                continue;
            };
            let inn = last_of_fan(figure, t, corner);
            if !planes.turn(inn, out).is_negative() {
                continue;
            }
            let vertex = VertexId::new(vertex as usize);
            let pair = [out, inn];
            let track = Track {
                pair,
                origin: Origin::Vertex(vertex),
                start: Place::Vertex(figure.vertices()[vertex.index()]),
                crash: Crash::Escape,
                end: None,
            };
            found.push((vertex, pair, track));
        }
    }
    found.sort_unstable_by_key(|&(vertex, pair, _)| (vertex, pair));
    found.into_iter().map(|(_, _, track)| track).collect()
}

/// Counterclockwise around a corner of a triangle: the plane of the edge at which the sector ends.
fn last_of_fan(figure: &Figure, mut triangle: usize, mut corner: usize) -> PlaneId {
    loop {
        let side = next(corner);
        if let Some(plane) = facing(figure, triangle, side) {
            return plane;
        }
        let (other, back) = across(figure.mesh(), triangle, side);
        (triangle, corner) = (other, next(back));
    }
}
