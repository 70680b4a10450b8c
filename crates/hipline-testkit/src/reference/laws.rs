//! What any straight skeleton must obey, checked on the reference engine's own results.

use std::collections::HashMap;

use hipline::skeleton::Side;

use super::graph::Graph;
use super::result::{RefKind, RefNode, Reference};

/// Checks a result against the laws of straight skeletons.
///
/// Faces close up, go around their area counterclockwise, and have one height per place; every
/// node has at least three arcs; with the whole plane covered, the node count is exact.
///
/// # Errors
/// The first law that is broken.
pub fn check_laws(graph: &Graph, result: &Reference) -> Result<(), String> {
    heights(graph, result)?;
    for face in (0..result.faces.len()).filter(|&face| result.covered[face]) {
        closes(graph, result, face)?;
    }
    let degrees = result.degrees();
    let events = || (0..degrees.len()).filter(|&n| result.nodes[n].kind == RefKind::Event);
    if let Some(node) = events().find(|&n| degrees[n] < 3) {
        return Err(format!(
            "node {node} has only {} arcs: {:?}",
            degrees[node], result.nodes[node]
        ));
    }
    counts(graph, result, events().map(|n| degrees[n] - 2).sum())
}

/// 2m + t faces of phase 0, and 2n + t - 2 nodes (Lemma 2 of the 1996 paper), for the whole plane. With
/// weights, an overrun splits no face but adds an arc; equality is only sure without.
fn counts(graph: &Graph, result: &Reference, events: usize) -> Result<(), String> {
    let caps = result
        .faces
        .iter()
        .filter(|(_, side, phase)| *phase == 0 && matches!(side, Side::Start | Side::End))
        .count();
    let first = result
        .faces
        .iter()
        .filter(|(.., phase)| *phase == 0)
        .count();
    if first != 2 * graph.edges.len() + caps {
        return Err(format!(
            "{first} faces, {} edges, {caps} caps",
            graph.edges.len()
        ));
    }
    let speeds = || graph.edges.iter().flat_map(|edge| edge.speeds);
    let first_speed = graph.edges[0].speeds[0];
    let equal = speeds().all(|speed| speed > 0.0 && speed.total_cmp(&first_speed).is_eq());
    if !equal || !graph.changes.is_empty() || graph.has_heights() || result.covered.contains(&false)
    {
        return Ok(());
    }
    let infinite = result
        .nodes
        .iter()
        .filter(|node| matches!(node.kind, RefKind::Infinite(_)))
        .count();
    let (found, due) = (events + infinite, 2 * graph.vertices.len() + caps - 2);
    if found == due {
        Ok(())
    } else {
        Err(format!("{found} nodes instead of {due}"))
    }
}

/// At both ends of each arc, both faces are as high as the node.
#[expect(
    clippy::disallowed_methods,
    reason = "a law of rounded results, checked with a tolerance"
)]
fn heights(graph: &Graph, result: &Reference) -> Result<(), String> {
    let size = graph
        .vertices
        .iter()
        .flatten()
        .fold(0.0_f64, |size, x| size.max(x.abs()));
    for (a, arc) in result.arcs.iter().enumerate() {
        for face in arc.faces {
            let (edge, side, phase) = result.faces[face];
            let speeds = graph.speeds(edge, side);
            let edge = &graph.edges[edge];
            let [p, q] = edge.ends.map(|end| graph.vertices[end]);
            let along = [q[0] - p[0], q[1] - p[1]];
            let (mut normal, from) = match side {
                Side::Left => ([-along[1], along[0]], p),
                Side::Right => ([along[1], -along[0]], p),
                Side::Start => ([-along[0], -along[1]], p),
                Side::End => (along, q),
            };
            let mut phase = phase as usize;
            let ends = edge.ends.map(|end| graph.height(end));
            let is_facet = phase > 0
                && matches!(side, Side::Left | Side::Right)
                && ends[0].total_cmp(&ends[1]).is_ne();
            let speeds = if is_facet {
                // From the height of its start on, its plane moves on as a turned one through that point.
                phase = 0;
                let speed = edge.speeds[usize::from(side == Side::Right)];
                let steep = speed * (ends[1] - ends[0]) / along[0].hypot(along[1]);
                let across = (1.0 - steep * steep).sqrt();
                normal = [0, 1].map(|k| steep * along[k] + across * normal[k]);
                vec![[ends[0], speed]]
            } else {
                speeds
            };
            let earlier: f64 = (0..phase)
                .map(|k| (speeds[k + 1][0] - speeds[k][0]) * speeds[k][1])
                .sum();
            let [since, speed] = speeds[phase];
            let until = speeds.get(phase + 1).map_or(f64::INFINITY, |next| next[0]);
            let length = along[0].hypot(along[1]);
            for RefNode {
                place: [x, y],
                time,
                ..
            } in arc.nodes.map(|node| result.nodes[node])
            {
                let distance = (normal[0] * (x - from[0]) + normal[1] * (y - from[1])) / length;
                if !is_facet && time < since || (time.is_finite() && time > until) {
                    return Err(format!("arc {a} is not of the time of face {face}"));
                }
                let due = earlier + speed * (time - since);
                let error = (distance - due).abs();
                if time.is_finite() && error > 1e-12 * (size + x.abs() + y.abs() + due) {
                    return Err(format!(
                        "arc {a} leaves the plane of face {face} by {error:e}"
                    ));
                }
            }
        }
    }
    Ok(())
}

/// The boundary of a face returns to where it came from, and goes around a positive area.
fn closes(graph: &Graph, result: &Reference, face: usize) -> Result<(), String> {
    let (edge, side, phase) = result.faces[face];
    let [p, q] = graph.edges[edge].ends;
    let mut steps = match side {
        Side::Left if phase == 0 => vec![[p, q]],
        Side::Right if phase == 0 => vec![[q, p]],
        _ => Vec::new(),
    };
    for arc in &result.arcs {
        let [a, b] = arc.nodes;
        if arc.faces[0] == face {
            steps.push([a, b]);
        }
        if arc.faces[1] == face {
            steps.push([b, a]);
        }
    }
    let mut balance: HashMap<usize, i32> = HashMap::new();
    let mut area = 0.0;
    let mut size = 0.0_f64;
    let origin = result.nodes[p].place;
    for [a, b] in steps {
        *balance.entry(a).or_default() += 1;
        *balance.entry(b).or_default() -= 1;
        let [[ax, ay], [bx, by]] =
            [a, b].map(|n| [0, 1].map(|k| result.nodes[n].place[k] - origin[k]));
        area += ax * by - ay * bx;
        size = size.max((ax * ax + ay * ay).max(bx * bx + by * by));
    }
    let is_finite = |n: usize| result.nodes[n].time.is_finite();
    if let Some((node, _)) = balance
        .iter()
        .find(|&(&node, &by)| is_finite(node) && by != 0)
    {
        return Err(format!("face {face} does not close at node {node}"));
    }
    if balance.keys().all(|&node| is_finite(node)) && area < -1e-12 * size {
        return Err(format!("face {face} has the area {area}"));
    }
    Ok(())
}
