//! Houses as meshes, in formats of 3D programs.
//!
//! Every format gets the same vertices, triangles or polygons, each feature an object of its own, so
//! what is closed in the library is closed in the file. OBJ, PLY and CityJSON have coordinates of
//! enough digits. STL and glTF have those of f32, seven digits, so they are moved to a local
//! origin, which the file names.

mod cityjson;
mod gltf;
mod obj;
mod ply;
mod stl;

pub use cityjson::mesh_cityjson;
pub use gltf::{mesh_glb, mesh_gltf};
pub use obj::mesh_obj;
pub use ply::{PlyEncoding, mesh_ply};
pub use stl::mesh_stl;

use hipline::roof::{Mesh, Surface};
use serde_json::{Map, Value};

use crate::FeatureName;

/// A mesh with its name and what the file it came from says about it.
#[derive(Debug, Clone, Copy)]
pub struct Building<'a> {
    /// Its name.
    pub name: &'a FeatureName,
    /// Its properties; written where a format has a place for them.
    pub properties: Option<&'a Map<String, Value>>,
    /// Its surface.
    pub mesh: &'a Mesh,
}

const SURFACES: [Surface; 4] = [
    Surface::Roof,
    Surface::Wall,
    Surface::Ground,
    Surface::Soffit,
];

const fn title(surface: Surface) -> &'static str {
    match surface {
        Surface::Roof => "roof",
        Surface::Wall => "wall",
        Surface::Ground => "ground",
        Surface::Soffit => "soffit",
    }
}

/// The name of an object: the feature's id, or its number.
fn object(name: &FeatureName) -> String {
    match &name.id {
        // A name with a line break would break files of lines.
        Some(id) => id.replace(['\n', '\r'], " "),
        None => format!("feature_{}", name.index),
    }
}

/// A corner of all buildings that f32 can hold, near the lowest one: coordinates relative to it
/// are as small as they can be.
fn origin(buildings: &[Building]) -> [f32; 3] {
    let vertices = || buildings.iter().flat_map(|b| b.mesh.vertices());
    [0, 1, 2].map(|k| {
        let low = vertices().map(|v| v[k]).fold(f64::INFINITY, f64::min);
        if low.is_finite() {
            low.floor() as f32
        } else {
            0.0
        }
    })
}

fn local(vertex: [f64; 3], origin: [f32; 3]) -> [f32; 3] {
    [0, 1, 2].map(|k| (vertex[k] - f64::from(origin[k])) as f32)
}
