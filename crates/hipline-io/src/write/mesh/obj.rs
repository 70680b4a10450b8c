//! Wavefront OBJ.

use std::io::{self, Write};

use super::{Building, SURFACES, object, title};
use crate::write::number::Number;

/// Writes buildings as OBJ: objects that share no vertex, with a group and a material for each
/// kind of surface, named `roof`, `wall`, `ground` and `soffit`. Facets are polygons, or
/// triangles if so asked; those with holes, which OBJ does not know, are always triangles.
/// Numbers are read back as they were.
///
/// # Errors
/// Those of `w`.
pub fn mesh_obj(mut w: impl Write, buildings: &[Building], triangles: bool) -> io::Result<()> {
    let mut before = 1;
    for building in buildings {
        let mesh = building.mesh;
        writeln!(w, "o {}", object(building.name))?;
        for [x, y, z] in mesh.vertices() {
            writeln!(w, "v {} {} {}", Number(*x), Number(*y), Number(*z))?;
        }
        for surface in SURFACES {
            let facets = || mesh.facets().iter().filter(|f| f.surface == surface);
            if facets().next().is_some() {
                writeln!(w, "g {0}\nusemtl {0}", title(surface))?;
            }
            for facet in facets() {
                if triangles || mesh.rings(facet).nth(1).is_some() {
                    for triangle in mesh.triangles_of(facet) {
                        corners(&mut w, triangle, before)?;
                    }
                } else {
                    for ring in mesh.rings(facet) {
                        corners(&mut w, ring, before)?;
                    }
                }
            }
        }
        before += mesh.vertices().len();
    }
    Ok(())
}

fn corners(w: &mut impl Write, ring: &[u32], before: usize) -> io::Result<()> {
    w.write_all(b"f")?;
    for &corner in ring {
        write!(w, " {}", before + corner as usize)?;
    }
    w.write_all(b"\n")
}
