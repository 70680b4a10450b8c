//! PLY, by the crate ply-rs-bw.

use std::io::{self, Write};

use ply_rs_bw::{
    ply::{
        Addable, DefaultElement, ElementDef, Encoding, Ply, Property, PropertyDef, PropertyType,
        ScalarType,
    },
    writer::Writer,
};

use super::{Building, SURFACES, object, title};

/// How PLY writes numbers.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum PlyEncoding {
    /// As text.
    Ascii,
    /// As bytes, little-endian.
    Binary,
}

/// Writes buildings as PLY: one mesh of triangles, with coordinates of type double. Each triangle
/// has the number of its building (`object`) and of its surface (`surface`: 0 roof, 1 wall, 2
/// ground, 3 soffit); comments name them.
///
/// # Errors
/// Those of `w`, and more vertices than 32 bits can count.
pub fn mesh_ply(
    mut w: impl Write,
    buildings: &[Building],
    encoding: PlyEncoding,
) -> io::Result<()> {
    let mut ply = Ply::<DefaultElement>::new();
    ply.header.encoding = match encoding {
        PlyEncoding::Ascii => Encoding::Ascii,
        PlyEncoding::Binary => Encoding::BinaryLittleEndian,
    };
    let comments = &mut ply.header.comments;
    for (i, surface) in SURFACES.into_iter().enumerate() {
        comments.push(format!("surface {i} {}", title(surface)));
    }
    for (i, building) in buildings.iter().enumerate() {
        comments.push(format!("object {i} {}", object(building.name)));
    }
    let mut vertex = ElementDef::new("vertex".to_owned());
    for axis in ["x", "y", "z"] {
        let double = PropertyType::Scalar(ScalarType::Double);
        vertex
            .properties
            .add(PropertyDef::new(axis.to_owned(), double));
    }
    let mut face = ElementDef::new("face".to_owned());
    for (name, kind) in [
        (
            "vertex_indices",
            PropertyType::List(ScalarType::UChar, ScalarType::UInt),
        ),
        ("object", PropertyType::Scalar(ScalarType::UInt)),
        ("surface", PropertyType::Scalar(ScalarType::UChar)),
    ] {
        face.properties.add(PropertyDef::new(name.to_owned(), kind));
    }
    ply.header.elements.add(vertex);
    ply.header.elements.add(face);
    let (mut vertices, mut faces) = (Vec::new(), Vec::new());
    for (number, building) in buildings.iter().enumerate() {
        let before = index(vertices.len())?;
        for vertex in building.mesh.vertices() {
            let mut element = DefaultElement::new();
            for (axis, value) in ["x", "y", "z"].into_iter().zip(vertex) {
                element.insert(axis.to_owned(), Property::Double(*value));
            }
            vertices.push(element);
        }
        index(vertices.len())?;
        for facet in building.mesh.facets() {
            let surface = SURFACES
                .iter()
                .position(|s| *s == facet.surface)
                .unwrap_or(0) as u8;
            for triangle in building.mesh.triangles_of(facet) {
                let corners = triangle.map(|v| before + v).to_vec();
                let mut element = DefaultElement::new();
                element.insert("vertex_indices".to_owned(), Property::ListUInt(corners));
                element.insert("object".to_owned(), Property::UInt(index(number)?));
                element.insert("surface".to_owned(), Property::UChar(surface));
                faces.push(element);
            }
        }
    }
    ply.payload.insert("vertex".to_owned(), vertices);
    ply.payload.insert("face".to_owned(), faces);
    let written = Writer::new().write_ply(&mut w, &mut ply);
    written.map(|_| ()).map_err(io::Error::other)
}

fn index(count: usize) -> io::Result<u32> {
    u32::try_from(count).map_err(|_| io::Error::other("PLY can count 2^32 vertices only"))
}
