//! Houses in every format are read back, by others' readers where there are any, and compared with
//! the mesh: counts, coordinates, and that each is closed.

use std::collections::BTreeMap;

use hipline::{
    FigureBuilder,
    roof::{Mesh, RoofOptions, Surface},
};
use hipline_io::{
    FeatureName,
    write::{self, Building, PlyEncoding},
};
use ply_rs_bw::{parser::Parser, ply::DefaultElement, ply::Property};
use serde_json::{Map, Value, json};

/// A house with a courtyard and an overhang, far from the origin, and two that touch in a point.
fn houses() -> [Mesh; 2] {
    let rectangle = |x: f64, y: f64, w: f64, h: f64| {
        let (x, y) = (x + 5_000_000.25, y + 400_000.5);
        vec![[x, y], [x + w, y], [x + w, y + h], [x, y + h]]
    };
    let options = |overhang| RoofOptions {
        eaves: 3.0,
        overhang,
        ..RoofOptions::hip(0.5)
    };
    let mut builder = FigureBuilder::new();
    builder.polygon(vec![
        rectangle(0.0, 0.0, 12.0, 10.0),
        rectangle(4.0, 4.0, 4.0, 3.0),
    ]);
    let yard = builder.build().unwrap().roof(&options(0.5)).unwrap();
    let mut builder = FigureBuilder::new();
    builder.polygon(vec![rectangle(20.0, 0.0, 6.0, 4.0)]);
    builder.polygon(vec![rectangle(26.0, 4.0, 6.0, 4.0)]);
    let two = builder.build().unwrap().roof(&options(0.0)).unwrap();
    for mesh in [&yard, &two] {
        mesh.check().unwrap();
    }
    [yard, two]
}

fn written(
    write: impl FnOnce(&mut Vec<u8>, &[Building]) -> std::io::Result<()>,
) -> ([Mesh; 2], Vec<u8>) {
    let meshes = houses();
    let names = [Some("yard"), None]
        .into_iter()
        .enumerate()
        .map(|(index, id)| FeatureName {
            index,
            id: id.map(str::to_owned),
        });
    let names: Vec<FeatureName> = names.collect();
    let mut properties = Map::new();
    properties.insert("roof:angle".to_owned(), json!(26.5));
    let buildings: Vec<Building> = names
        .iter()
        .zip(&meshes)
        .map(|(name, mesh)| Building {
            name,
            properties: Some(&properties),
            mesh,
        })
        .collect();
    let mut bytes = Vec::new();
    write(&mut bytes, &buildings).unwrap();
    (meshes, bytes)
}

/// Fails unless each directed edge is there once, and so is its reverse.
fn assert_closed<V: Ord + Copy + std::fmt::Debug>(rings: impl IntoIterator<Item = Vec<V>>) {
    let mut edges: BTreeMap<(V, V), i32> = BTreeMap::new();
    for ring in rings {
        for (k, &a) in ring.iter().enumerate() {
            *edges.entry((a, ring[(k + 1) % ring.len()])).or_default() += 1;
        }
    }
    assert!(!edges.is_empty());
    for (&(a, b), count) in &edges {
        assert_eq!((*count, edges.get(&(b, a))), (1, Some(&1)), "{a:?} {b:?}");
    }
}

fn all_vertices(meshes: &[Mesh]) -> Vec<[f64; 3]> {
    meshes.iter().flat_map(|m| m.vertices()).copied().collect()
}

fn triangle_count(meshes: &[Mesh]) -> usize {
    meshes.iter().map(|m| m.triangles().len()).sum()
}

#[test]
fn obj() {
    for triangles in [false, true] {
        let (meshes, bytes) = written(|w, list| write::mesh_obj(w, list, triangles));
        let text = String::from_utf8(bytes).unwrap();
        let lines = |key: &'static str| {
            text.lines()
                .filter_map(move |l| l.strip_prefix(key)?.strip_prefix(' '))
        };
        assert_eq!(lines("o").collect::<Vec<_>>(), ["yard", "feature_1"]);
        assert_eq!(
            lines("usemtl").collect::<Vec<_>>(),
            ["roof", "wall", "ground", "soffit", "roof", "wall", "ground"]
        );
        let vertices: Vec<[f64; 3]> = lines("v")
            .map(|l| {
                let numbers: Vec<f64> = l.split(' ').map(|n| n.parse().unwrap()).collect();
                numbers.try_into().unwrap()
            })
            .collect();
        assert_eq!(vertices, all_vertices(&meshes));
        let faces: Vec<Vec<usize>> = lines("f")
            .map(|l| l.split(' ').map(|n| n.parse().unwrap()).collect())
            .collect();
        if triangles {
            assert_eq!(faces.len(), triangle_count(&meshes));
        }
        assert_closed(faces);
    }
}

#[test]
fn ply() {
    for encoding in [PlyEncoding::Ascii, PlyEncoding::Binary] {
        let (meshes, bytes) = written(|w, list| write::mesh_ply(w, list, encoding));
        let parser = Parser::<DefaultElement>::new();
        let ply = parser.read_ply(&mut bytes.as_slice()).unwrap();
        assert!(ply.header.comments.iter().any(|c| c == "object 0 yard"));
        let vertices: Vec<[f64; 3]> = ply.payload["vertex"]
            .iter()
            .map(|v| {
                ["x", "y", "z"].map(|axis| match v[axis] {
                    Property::Double(number) => number,
                    ref other => panic!("{other:?}"),
                })
            })
            .collect();
        assert_eq!(vertices, all_vertices(&meshes));
        let faces = ply.payload["face"]
            .iter()
            .map(|f| match &f["vertex_indices"] {
                Property::ListUInt(corners) => corners.clone(),
                other => panic!("{other:?}"),
            });
        let faces: Vec<Vec<u32>> = faces.collect();
        assert_eq!(faces.len(), triangle_count(&meshes));
        assert_closed(faces);
    }
}

#[test]
fn stl() {
    let (meshes, bytes) = written(|w, list| write::mesh_stl(w, list));
    assert!(
        bytes.starts_with(b"hipline origin 4999999 400000 0 "),
        "{:?}",
        &bytes[..80]
    );
    let read = stl_io::create_stl_reader(&mut std::io::Cursor::new(&bytes))
        .unwrap()
        .count();
    assert_eq!(read, triangle_count(&meshes));
    let stl = stl_io::read_stl(&mut std::io::Cursor::new(&bytes)).unwrap();
    let mut expected = meshes.iter().flat_map(|m| {
        m.triangles()
            .iter()
            .flatten()
            .map(|&v| m.vertices()[v as usize])
    });
    for face in &stl.faces {
        for &v in &face.vertices {
            let found = stl.vertices[v].0;
            let [x, y, z] = expected.next().unwrap();
            let near = [
                found[0] as f64 + 4_999_999.0,
                found[1] as f64 + 400_000.0,
                found[2] as f64,
            ];
            for (a, b) in near.iter().zip([x, y, z]) {
                assert!((a - b).abs() < 1e-5, "{near:?} {x} {y} {z}");
            }
        }
    }
    assert_eq!(expected.next(), None);
}

#[test]
fn gltf() {
    let (meshes, glb) = written(|w, list| write::mesh_glb(w, list));
    let (_, text) = written(|w, list| write::mesh_gltf(w, list));
    let length = u32::from_le_bytes(glb[8..12].try_into().unwrap());
    assert_eq!(length as usize, glb.len(), "the header's length");
    let file = gltf::Gltf::from_slice(&glb).unwrap();
    let blob = file.blob.clone().unwrap();
    let embedded = gltf::Gltf::from_slice(&text).unwrap();
    let gltf::buffer::Source::Uri(uri) = embedded.buffers().next().unwrap().source() else {
        panic!("the numbers are in the file");
    };
    use base64::Engine;
    let encoded = uri
        .strip_prefix("data:application/octet-stream;base64,")
        .unwrap();
    let decoded = base64::engine::general_purpose::STANDARD
        .decode(encoded)
        .unwrap();
    assert_eq!(decoded, blob[..decoded.len()]);
    for document in [&file.document, &embedded.document] {
        let nodes: Vec<gltf::Node> = document.nodes().collect();
        let names: Vec<&str> = nodes.iter().filter_map(gltf::Node::name).collect();
        assert_eq!(names, ["yard", "feature_1"]);
        for (node, mesh) in nodes.iter().zip(&meshes) {
            let ([tx, ty, tz], _, _) = node.transform().decomposed();
            let bits = [tx, ty, tz].map(f32::to_bits);
            assert_eq!(bits, [4_999_999.0_f32, 0.0, -400_000.0].map(f32::to_bits));
            let mut triangles: Vec<Vec<u32>> = Vec::new();
            for primitive in node.mesh().unwrap().primitives() {
                assert!(primitive.material().name().is_some());
                let reader = primitive.reader(|_| Some(&blob[..]));
                let points: Vec<[f32; 3]> = reader.read_positions().unwrap().collect();
                assert_eq!(points.len(), mesh.vertices().len());
                for (p, &[x, y, z]) in points.iter().zip(mesh.vertices()) {
                    let near = [
                        f64::from(p[0]) + 4_999_999.0 - x,
                        -f64::from(p[2]) + 400_000.0 - y,
                        f64::from(p[1]) - z,
                    ];
                    assert!(near.iter().all(|d| d.abs() < 1e-5), "{near:?}");
                }
                let corners: Vec<u32> = reader.read_indices().unwrap().into_u32().collect();
                triangles.extend(corners.chunks_exact(3).map(<[u32]>::to_vec));
            }
            assert_eq!(triangles.len(), mesh.triangles().len());
            assert_closed(triangles);
        }
    }
}

#[test]
fn cityjson() {
    let (meshes, bytes) = written(|w, list| write::mesh_cityjson(w, list));
    let file: Value = serde_json::from_slice(&bytes).unwrap();
    assert_eq!(
        (&file["type"], &file["version"]),
        (&json!("CityJSON"), &json!("2.0"))
    );
    let number = |value: &Value| value.as_f64().unwrap();
    let vertices: Vec<[f64; 3]> = file["vertices"]
        .as_array()
        .unwrap()
        .iter()
        .map(|v| {
            [0, 1, 2].map(|k| {
                assert!(v[k].is_i64(), "{v}");
                let transform = &file["transform"];
                number(&v[k]) * number(&transform["scale"][k]) + number(&transform["translate"][k])
            })
        })
        .collect();
    for (found, expected) in vertices.iter().zip(all_vertices(&meshes)) {
        for k in 0..3 {
            assert!(
                (found[k] - expected[k]).abs() < 1e-8,
                "{found:?} {expected:?}"
            );
        }
    }
    let ring = |ring: &Value| -> Vec<u64> {
        ring.as_array()
            .unwrap()
            .iter()
            .map(|v| v.as_u64().unwrap())
            .collect()
    };
    let shell = |shell: &Value| -> Vec<Vec<u64>> {
        let surfaces = shell.as_array().unwrap().iter();
        surfaces
            .flat_map(|s| s.as_array().unwrap().iter().map(ring))
            .collect()
    };
    let kinds = |geometry: &Value, values: &Value| -> Vec<String> {
        let name = |v: &Value| {
            let surface = &geometry["semantics"]["surfaces"][v.as_u64().unwrap() as usize];
            surface["type"].as_str().unwrap().to_owned()
        };
        values.as_array().unwrap().iter().map(name).collect()
    };
    let expected = |mesh: &Mesh, surface: Surface| {
        mesh.facets()
            .iter()
            .filter(|f| f.surface == surface)
            .count()
    };
    let yard = &file["CityObjects"]["yard"];
    assert_eq!(yard["type"], "Building");
    assert_eq!(yard["attributes"]["roof:angle"], 26.5);
    let geometry = &yard["geometry"][0];
    assert_eq!(geometry["type"], "Solid");
    assert_closed(shell(&geometry["boundaries"][0]));
    let found = kinds(geometry, &geometry["semantics"]["values"][0]);
    assert_eq!(found.len(), meshes[0].facets().len());
    for (surface, name) in [
        (Surface::Roof, "RoofSurface"),
        (Surface::Wall, "WallSurface"),
        (Surface::Ground, "GroundSurface"),
        (Surface::Soffit, "OuterCeilingSurface"),
    ] {
        let count = found.iter().filter(|f| *f == name).count();
        assert_eq!(count, expected(&meshes[0], surface), "{name}");
        assert!(count > 0, "{name}");
    }
    let geometry = &file["CityObjects"]["feature_1"]["geometry"][0];
    assert_eq!(geometry["type"], "MultiSolid", "two that touch in a point");
    for k in 0..2 {
        assert_closed(shell(&geometry["boundaries"][k][0]));
        assert_eq!(
            kinds(geometry, &geometry["semantics"]["values"][k][0]).len(),
            9
        );
    }
}

#[test]
fn nothing_is_written_as_nothing() {
    let mut bytes = Vec::new();
    write::mesh_glb(&mut bytes, &[]).unwrap();
    assert_eq!(gltf::Gltf::from_slice(&bytes).unwrap().nodes().count(), 0);
    bytes.clear();
    write::mesh_stl(&mut bytes, &[]).unwrap();
    assert_eq!(bytes.len(), 84);
    bytes.clear();
    write::mesh_cityjson(&mut bytes, &[]).unwrap();
    let file: Value = serde_json::from_slice(&bytes).unwrap();
    assert_eq!(file["vertices"], json!([]));
}
