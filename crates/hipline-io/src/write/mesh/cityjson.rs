//! CityJSON 2.0.

use std::{
    collections::BTreeMap,
    io::{self, Write},
};

use hipline::roof::{Facet, Mesh, Surface};
use serde_json::{Map, Value, json};

use super::{Building, object};

/// How many digits of the extent of a file the coordinates keep.
const DIGITS: i32 = 12;

/// Writes buildings as CityJSON 2.0, each feature a `Building` with its properties as attributes
/// and one geometry: a `Solid` (a `MultiSolid` for several parts; a `MultiSurface` if floor or
/// walls were left out), whose surfaces are `RoofSurface`, `WallSurface`, `GroundSurface`, and
/// `OuterCeilingSurface` for soffits.
///
/// CityJSON has whole numbers for coordinates, with a scale and a translation; these keep
/// twelve digits of the extent of the whole file.
///
/// # Errors
/// Those of `w`.
pub fn mesh_cityjson(mut w: impl Write, buildings: &[Building]) -> io::Result<()> {
    let transform = Transform::of(buildings);
    let mut vertices = Vec::new();
    let mut objects = Map::new();
    for building in buildings {
        let mut id = object(building.name);
        if objects.contains_key(&id) {
            // Ids of features may be the same; those of objects may not.
            id = format!("{id}_{}", building.name.index);
            while objects.contains_key(&id) {
                id.push('_');
            }
        }
        let before = vertices.len();
        vertices.extend(building.mesh.vertices().iter().map(|&v| transform.apply(v)));
        objects.insert(
            id,
            json!({
                "type": "Building",
                "attributes": building.properties.cloned().unwrap_or_default(),
                "geometry": geometry(building.mesh, before).map_or_else(Vec::new, |g| vec![g]),
            }),
        );
    }
    let scale = [transform.scale; 3];
    let file = json!({
        "type": "CityJSON",
        "version": "2.0",
        "transform": { "scale": scale, "translate": transform.translate },
        "CityObjects": objects,
        "vertices": vertices,
    });
    serde_json::to_writer(&mut w, &file)?;
    w.write_all(b"\n")
}

struct Transform {
    scale: f64,
    translate: [f64; 3],
}

impl Transform {
    fn of(buildings: &[Building]) -> Self {
        let vertices = || buildings.iter().flat_map(|b| b.mesh.vertices());
        let bound = |k: usize| {
            let all = || vertices().map(|v| v[k]);
            let (low, high) = (
                all().fold(f64::INFINITY, f64::min),
                all().fold(f64::NEG_INFINITY, f64::max),
            );
            if low <= high {
                (low, high - low)
            } else {
                (0.0, 0.0)
            }
        };
        let bounds = [0, 1, 2].map(bound);
        let extent = bounds.iter().map(|b| b.1).fold(0.0, f64::max);
        let digits = if extent > 0.0 && extent.is_finite() {
            extent.log10().ceil() as i32 - DIGITS
        } else {
            0
        };
        Self {
            // Parsed, so that it is the number nearest to the power of ten.
            scale: format!("1e{digits}").parse().unwrap_or(1.0),
            translate: bounds.map(|b| b.0),
        }
    }

    fn apply(&self, vertex: [f64; 3]) -> [i64; 3] {
        [0, 1, 2].map(|k| ((vertex[k] - self.translate[k]) / self.scale).round() as i64)
    }
}

/// The geometry of a mesh whose vertices come after `before` others.
fn geometry(mesh: &Mesh, before: usize) -> Option<Value> {
    let boundary = |facet: &Facet| -> Vec<Vec<usize>> {
        let ring = |ring: &[u32]| ring.iter().map(|&v| before + v as usize).collect();
        mesh.rings(facet).map(ring).collect()
    };
    if mesh.facets().is_empty() {
        return None;
    }
    let kinds: Vec<Surface> = [
        Surface::Roof,
        Surface::Wall,
        Surface::Ground,
        Surface::Soffit,
    ]
    .into_iter()
    .filter(|kind| mesh.facets().iter().any(|f| f.surface == *kind))
    .collect();
    let surfaces: Vec<Value> = kinds
        .iter()
        .map(|kind| json!({ "type": semantics(*kind) }))
        .collect();
    let value = |facet: &Facet| kinds.iter().position(|kind| *kind == facet.surface);
    let semantics = |values: Value| json!({ "surfaces": surfaces, "values": values });
    if !mesh.is_closed() {
        return Some(json!({
            "type": "MultiSurface",
            "lod": "2.2",
            "boundaries": mesh.facets().iter().map(boundary).collect::<Vec<_>>(),
            "semantics": semantics(json!(mesh.facets().iter().map(value).collect::<Vec<_>>())),
        }));
    }
    let parts = parts(mesh);
    let shells: Vec<Vec<_>> = parts
        .iter()
        .map(|part| vec![part.iter().map(|f| boundary(f)).collect::<Vec<_>>()])
        .collect();
    let values: Vec<Vec<_>> = parts
        .iter()
        .map(|part| vec![part.iter().map(|f| value(f)).collect::<Vec<_>>()])
        .collect();
    Some(if parts.len() == 1 {
        json!({
            "type": "Solid",
            "lod": "2.2",
            "boundaries": shells[0],
            "semantics": semantics(json!(values[0])),
        })
    } else {
        json!({
            "type": "MultiSolid",
            "lod": "2.2",
            "boundaries": shells,
            "semantics": semantics(json!(values)),
        })
    })
}

const fn semantics(surface: Surface) -> &'static str {
    match surface {
        Surface::Roof => "RoofSurface",
        Surface::Wall => "WallSurface",
        Surface::Ground => "GroundSurface",
        Surface::Soffit => "OuterCeilingSurface",
    }
}

/// The facets of each connected part.
fn parts(mesh: &Mesh) -> Vec<Vec<&Facet>> {
    fn root(parents: &mut [u32], mut v: u32) -> u32 {
        while parents[v as usize] != v {
            parents[v as usize] = parents[parents[v as usize] as usize];
            v = parents[v as usize];
        }
        v
    }
    let mut parents: Vec<u32> = (0..mesh.vertices().len() as u32).collect();
    for facet in mesh.facets() {
        let mut corners = mesh.rings(facet).flatten();
        let Some(&first) = corners.next() else {
            continue;
        };
        for &corner in corners {
            let [a, b] = [first, corner].map(|v| root(&mut parents, v));
            parents[a.max(b) as usize] = a.min(b);
        }
    }
    let mut parts: BTreeMap<u32, Vec<&Facet>> = BTreeMap::new();
    for facet in mesh.facets() {
        if let Some(&corner) = mesh.rings(facet).flatten().next() {
            parts
                .entry(root(&mut parents, corner))
                .or_default()
                .push(facet);
        }
    }
    parts.into_values().collect()
}
