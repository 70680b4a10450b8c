//! The short way from one ring to a figure: most polygons that are monotone need no triangulation.
//!
//! One polygon of one ring that is monotone in some direction is checked in linear time
//! ([`monotone`](super::monotone)); its vertices are distinct then, so that nothing needs to be looked up either.
//! Everything else, and above all every flaw, is left to the general way, whose figures are the same.

use super::{
    Edge, Figure, FigureBuilder, Mesh, Source,
    builder::Part,
    change::Changes,
    gather::{self, without_closing_point},
    monotone::monotone,
    nesting,
    range::Scale,
    triangulate,
};
use crate::topology::VertexId;

/// The figure of a builder that holds one monotone ring and no heights. Nothing is taken out
/// of the builder otherwise.
pub(super) fn figure(builder: &mut FigureBuilder) -> Option<Figure> {
    let [Part::Polygon { rings, speeds }] = builder.parts.as_mut_slice() else {
        return None;
    };
    let [ring] = rings.as_mut_slice() else {
        return None;
    };
    if !builder.heights.is_empty() {
        return None;
    }
    let points = without_closing_point(ring);
    let count = points.len();
    if count > gather::LIMIT || !points.iter().flatten().all(|x| x.is_finite()) {
        return None;
    }
    let speeds = match speeds.as_deref() {
        None => None,
        Some([speeds]) if speeds.len() == count => Some(speeds.as_slice()),
        Some(_) => return None,
    };
    let is_speed = |&speed: &f64| speed.is_finite() && speed >= 0.0;
    if !speeds.is_none_or(|speeds| speeds.iter().all(is_speed)) {
        return None;
    }
    let scale = Scale::of(points, &[]).ok()?;
    let monotone = monotone(points, scale)?;
    let edges: Vec<Edge> = (0..count).map(|i| edge(i, count, speeds)).collect();
    let mut vertices = std::mem::take(ring);
    vertices.truncate(count);
    for coordinate in vertices.iter_mut().flatten() {
        // Negative zeros become zeros.
        *coordinate += 0.0;
    }
    let changes = if builder.changes.is_empty() {
        Vec::new()
    } else {
        let part = Part::Polygon {
            rings: vec![vertices],
            speeds: None,
        };
        let parts = [part];
        let mut flaws = Vec::new();
        let changes = Changes::new(&builder.changes, &parts, &mut flaws).of_edges(&edges);
        let [Part::Polygon { mut rings, .. }] = parts else {
            unreachable!("made above")
        };
        vertices = rings.pop().expect("one ring");
        if !flaws.is_empty() {
            if let [Part::Polygon { rings, .. }] = builder.parts.as_mut_slice() {
                rings[0] = vertices;
            }
            return None;
        }
        changes
    };
    Some(Figure {
        terminals: 0,
        has_polygon: true,
        changes,
        heights: Vec::new(),
        vertices,
        edges,
        mesh: std::sync::OnceLock::new(),
        monotone: Some(monotone),
    })
}

fn edge(index: usize, count: usize, speeds: Option<&[f64]>) -> Edge {
    let next = if index + 1 == count { 0 } else { index + 1 };
    let speed = speeds.map_or(1.0, |speeds| speeds[index] + 0.0);
    Edge {
        from: VertexId::new(index),
        to: VertexId::new(next),
        speeds: [speed; 2],
        source: Source {
            part: 0,
            ring: 0,
            edge: index as u32,
        },
        on_ring: true,
    }
}

/// The triangulation of a figure that was made without one.
///
/// # Panics
/// If the ring was not simple after all.
pub(super) fn mesh(vertices: &[[f64; 2]], edges: &[Edge]) -> Mesh {
    let flawless = "the ring was found to be simple";
    let Ok(scale) = Scale::of(vertices, &[]) else {
        panic!("{flawless}")
    };
    let mut list = edges.to_vec();
    let Ok(mut mesh) = triangulate::triangulate(vertices, &mut list, scale) else {
        panic!("{flawless}: edges cross")
    };
    assert!(list.len() == edges.len(), "{flawless}: an edge is split");
    let mut flaws = Vec::new();
    nesting::fill(vertices, edges, &mut mesh, &mut flaws);
    assert!(flaws.is_empty(), "{flawless}: {flaws:?}");
    #[cfg(debug_assertions)]
    if let Err(broken) = mesh.check(vertices, edges, scale) {
        panic!("the triangulation is wrong: {broken}");
    }
    mesh
}

#[cfg(test)]
mod tests;
