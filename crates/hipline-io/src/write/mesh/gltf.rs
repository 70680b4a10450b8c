//! glTF 2.0, by the crate gltf.

use std::{
    borrow::Cow,
    io::{self, Write},
};

use base64::{Engine, engine::general_purpose::STANDARD};
use gltf::{
    binary::{Glb, Header},
    json::{
        self, Accessor, Buffer, Index, Material, Node, Root, Scene,
        accessor::{ComponentType, GenericComponentType, Type},
        buffer::{Target, View},
        material::{PbrBaseColorFactor, PbrMetallicRoughness, StrengthFactor},
        mesh::{Mode, Primitive, Semantic},
        validation::{Checked, USize64},
    },
};
use hipline::roof::Surface;

use super::{Building, SURFACES, local, object, origin, title};

/// Writes buildings as binary glTF (GLB): a node with a mesh each, in it a primitive for each
/// kind of surface, over common vertices, with a material of that name.
///
/// glTF has its y axis upward and coordinates of f32, so a vertex x, y, z is at x, z, -y, relative
/// to an origin: the translation of every node.
///
/// # Errors
/// Those of `w`, and more than glTF can hold: 4 GiB.
pub fn mesh_glb(mut w: impl Write, buildings: &[Building]) -> io::Result<()> {
    let (root, mut bytes) = scene(buildings);
    bytes.resize(bytes.len().next_multiple_of(4), 0);
    let mut text = root.to_vec().map_err(io::Error::other)?;
    // Chunks end at multiples of four bytes.
    text.resize(text.len().next_multiple_of(4), b' ');
    let length = text.len() + bytes.len();
    u32::try_from(length + 64).map_err(|_| io::Error::other("GLB files end at 4 GiB"))?;
    let glb = Glb {
        header: Header {
            magic: *b"glTF",
            version: 2,
            // The crate computes it.
            length: 0,
        },
        json: Cow::Owned(text),
        bin: (!bytes.is_empty()).then_some(Cow::Owned(bytes)),
    };
    glb.to_writer(&mut w).map_err(io::Error::other)
}

/// The same as [`mesh_glb`] as JSON, with the numbers in it in base64.
///
/// # Errors
/// Those of `w`.
pub fn mesh_gltf(w: impl Write, buildings: &[Building]) -> io::Result<()> {
    let (mut root, bytes) = scene(buildings);
    for buffer in &mut root.buffers {
        let text = STANDARD.encode(&bytes);
        buffer.uri = Some(format!("data:application/octet-stream;base64,{text}"));
    }
    root.to_writer(w).map_err(io::Error::other)
}

fn scene(buildings: &[Building]) -> (Root, Vec<u8>) {
    let [x, y, z] = origin(buildings);
    let mut root = Root::default();
    root.asset.generator = Some("hipline".to_owned());
    for surface in SURFACES {
        root.push(material(surface));
    }
    let mut bytes = Vec::new();
    let mut nodes = Vec::new();
    for building in buildings {
        if building.mesh.triangles().is_empty() {
            continue;
        }
        let mesh = mesh(&mut root, &mut bytes, building, [x, y, z]);
        nodes.push(root.push(Node {
            name: Some(object(building.name)),
            mesh: Some(mesh),
            translation: Some([x, z, -y]),
            ..Node::default()
        }));
    }
    if !bytes.is_empty() {
        root.push(Buffer {
            byte_length: USize64::from(bytes.len()),
            name: None,
            uri: None,
            extensions: None,
            extras: Default::default(),
        });
    }
    // A scene of nothing is not allowed; no scene is.
    if !nodes.is_empty() {
        let scene = root.push(Scene {
            nodes,
            name: None,
            extensions: None,
            extras: Default::default(),
        });
        root.scene = Some(scene);
    }
    (root, bytes)
}

fn material(surface: Surface) -> Material {
    let base = match surface {
        Surface::Roof => [0.55, 0.22, 0.16, 1.0],
        Surface::Wall => [0.87, 0.82, 0.72, 1.0],
        Surface::Ground => [0.45, 0.45, 0.45, 1.0],
        Surface::Soffit => [0.62, 0.5, 0.38, 1.0],
    };
    Material {
        name: Some(title(surface).to_owned()),
        pbr_metallic_roughness: PbrMetallicRoughness {
            base_color_factor: PbrBaseColorFactor(base),
            metallic_factor: StrengthFactor(0.0),
            roughness_factor: StrengthFactor(0.9),
            ..PbrMetallicRoughness::default()
        },
        ..Material::default()
    }
}

/// Adds a building: its vertices, and for each kind of surface the corners of its triangles.
fn mesh(
    root: &mut Root,
    bytes: &mut Vec<u8>,
    building: &Building,
    origin: [f32; 3],
) -> Index<json::Mesh> {
    let points: Vec<[f32; 3]> = building
        .mesh
        .vertices()
        .iter()
        .map(|&vertex| {
            let [x, y, z] = local(vertex, origin);
            [x, z, -y]
        })
        .collect();
    let first = bytes.len();
    bytes.extend(points.iter().flatten().flat_map(|c| c.to_le_bytes()));
    let view = push_view(root, first, bytes.len(), Target::ArrayBuffer);
    let bound = |pick: fn(f32, f32) -> f32| {
        let axis = |k: usize| points.iter().map(|p| p[k]).reduce(pick).unwrap_or(0.0);
        Some(json::Value::from(vec![axis(0), axis(1), axis(2)]))
    };
    let positions = root.push(Accessor {
        min: bound(f32::min),
        max: bound(f32::max),
        ..accessor(view, points.len(), ComponentType::F32, Type::Vec3)
    });
    let mut primitives = Vec::new();
    for (k, surface) in SURFACES.into_iter().enumerate() {
        let facets = building
            .mesh
            .facets()
            .iter()
            .filter(|f| f.surface == surface);
        let corners: Vec<u32> = facets
            .flat_map(|facet| building.mesh.triangles_of(facet))
            .flatten()
            .copied()
            .collect();
        if corners.is_empty() {
            continue;
        }
        let first = bytes.len();
        bytes.extend(corners.iter().flat_map(|v| v.to_le_bytes()));
        let view = push_view(root, first, bytes.len(), Target::ElementArrayBuffer);
        let indices = root.push(accessor(
            view,
            corners.len(),
            ComponentType::U32,
            Type::Scalar,
        ));
        primitives.push(Primitive {
            attributes: [(Checked::Valid(Semantic::Positions), positions)]
                .into_iter()
                .collect(),
            indices: Some(indices),
            material: Some(Index::new(k as u32)),
            mode: Checked::Valid(Mode::Triangles),
            targets: None,
            extensions: None,
            extras: Default::default(),
        });
    }
    root.push(json::Mesh {
        name: Some(object(building.name)),
        primitives,
        weights: None,
        extensions: None,
        extras: Default::default(),
    })
}

fn push_view(root: &mut Root, first: usize, end: usize, target: Target) -> Index<View> {
    root.push(View {
        buffer: Index::new(0),
        byte_length: USize64::from(end - first),
        byte_offset: Some(USize64::from(first)),
        byte_stride: None,
        name: None,
        target: Some(Checked::Valid(target)),
        extensions: None,
        extras: Default::default(),
    })
}

fn accessor(view: Index<View>, count: usize, component: ComponentType, kind: Type) -> Accessor {
    Accessor {
        buffer_view: Some(view),
        byte_offset: Some(USize64(0)),
        count: USize64::from(count),
        component_type: Checked::Valid(GenericComponentType(component)),
        type_: Checked::Valid(kind),
        min: None,
        max: None,
        name: None,
        normalized: false,
        sparse: None,
        extensions: None,
        extras: Default::default(),
    }
}
