//! Roofs as Wavefront OBJ: meshes, each an object of its own.

use std::io::{self, Write};

use hipline::roof::Mesh;
use hipline_io::FeatureName;

/// Writes meshes as objects that share no vertex. OBJ knows no holes: faces that have some
/// (a floor around a courtyard) are cut into triangles.
pub fn obj<'a>(
    w: &mut dyn Write,
    meshes: impl IntoIterator<Item = (&'a FeatureName, &'a Mesh)>,
) -> io::Result<()> {
    let mut before = 0;
    for (name, mesh) in meshes {
        match &name.id {
            // A name with a line break would break the file.
            Some(id) => writeln!(w, "o {}", id.replace(['\n', '\r'], " "))?,
            None => writeln!(w, "o feature_{}", name.index)?,
        }
        for [x, y, z] in &mesh.vertices {
            // `{:?}` prints the fewest digits that are read back as the same number.
            writeln!(w, "v {x:?} {y:?} {z:?}")?;
        }
        let mut holed = Mesh {
            vertices: mesh.vertices.clone(),
            faces: Vec::new(),
        };
        for face in &mesh.faces {
            if face.holes.is_empty() {
                corners(w, &face.boundary, before)?;
            } else {
                holed.faces.push(face.clone());
            }
        }
        for face in holed.triangulate().faces {
            corners(w, &face.boundary, before)?;
        }
        before += mesh.vertices.len();
    }
    Ok(())
}

fn corners(w: &mut dyn Write, boundary: &[u32], before: usize) -> io::Result<()> {
    w.write_all(b"f")?;
    for &corner in boundary {
        write!(w, " {}", before + corner as usize + 1)?;
    }
    w.write_all(b"\n")
}
