//! STL, by the crate stl_io.

use std::io::{self, Write};

use stl_io::{Normal, Triangle, Vertex};

use super::{Building, local, origin};

/// The length of the header of a binary STL file.
const HEADER: usize = 80;

/// Writes buildings as binary STL: triangles with their normals, one after the other. Coordinates
/// are f32, relative to an origin that the header names: `hipline origin X Y Z`.
///
/// # Errors
/// Those of `w`.
pub fn mesh_stl(mut w: impl Write, buildings: &[Building]) -> io::Result<()> {
    let origin = origin(buildings);
    let triangles: Vec<Triangle> = buildings
        .iter()
        .flat_map(|building| {
            let vertices = building.mesh.vertices();
            building.mesh.triangles().iter().map(move |triangle| {
                let corners = triangle.map(|v| vertices[v as usize]);
                Triangle {
                    normal: Normal::new(normal(corners)),
                    vertices: corners.map(|p| Vertex::new(local(p, origin))),
                }
            })
        })
        .collect();
    let mut bytes = Vec::new();
    stl_io::write_stl(&mut bytes, triangles.iter())?;
    let [x, y, z] = origin;
    let text = format!("hipline origin {x} {y} {z}");
    // A header that begins with "solid" would be taken for text; this one does not.
    for (slot, byte) in bytes[..HEADER]
        .iter_mut()
        .zip(text.bytes().chain([b' '; HEADER]))
    {
        *slot = byte;
    }
    w.write_all(&bytes)
}

/// Of length 1, or 0 for what is too small for numbers.
fn normal([a, b, c]: [[f64; 3]; 3]) -> [f32; 3] {
    let [u, v] = [b, c].map(|p| [0, 1, 2].map(|k| p[k] - a[k]));
    let n = [0, 1, 2].map(|k| {
        let (i, j) = ((k + 1) % 3, (k + 2) % 3);
        u[i] * v[j] - u[j] * v[i]
    });
    let length = n[0].hypot(n[1]).hypot(n[2]);
    n.map(|c| {
        if length > 0.0 {
            (c / length) as f32
        } else {
            0.0
        }
    })
}
