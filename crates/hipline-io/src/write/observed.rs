//! What is read off a surface, as data: contour lines, catchments, paths of drops, a mesh.

use std::io::{self, Write};

use hipline::observe::{Catchment, Contour, Drop, Terrain};

use super::{
    geojson::{Collection, chain},
    number::Number,
};

/// Writes contour lines as a FeatureCollection of LineStrings with the property `elevation`;
/// a closed line ends where it starts. What is higher is on the left.
///
/// # Errors
/// Those of `w`.
pub fn contours_geojson(
    mut w: impl Write,
    contours: &[Contour],
    elevation: impl Fn(f64) -> f64,
) -> io::Result<()> {
    let mut collection = Collection::new(&mut w)?;
    for contour in contours {
        let w = collection.next()?;
        write!(
            w,
            "{{\"elevation\":{}}},\"geometry\":{{\"type\":\"LineString\",\"coordinates\":",
            Number(elevation(contour.time))
        )?;
        chain(w, &contour.points, contour.is_closed)?;
        w.write_all(b"}}")?;
    }
    collection.finish()
}

/// Writes catchments as a FeatureCollection of Polygons and MultiPolygons with the properties
/// `area`, `cut` (whether it goes on beyond the window), and those that are given for each: members
/// of a JSON object, without braces.
///
/// # Errors
/// Those of `w`.
pub fn catchments_geojson<'a>(
    mut w: impl Write,
    catchments: impl IntoIterator<Item = (&'a Catchment, String)>,
) -> io::Result<()> {
    let mut collection = Collection::new(&mut w)?;
    for (catchment, properties) in catchments {
        let w = collection.next()?;
        let kind = if catchment.polygons.len() == 1 {
            "Polygon"
        } else {
            "MultiPolygon"
        };
        write!(
            w,
            "{{{properties},\"area\":{},\"cut\":{}}},\"geometry\":{{\"type\":\"{kind}\",\"coordinates\":",
            Number(catchment.area),
            catchment.is_cut
        )?;
        let many = catchment.polygons.len() != 1;
        w.write_all(if many { b"[" } else { b"" })?;
        for (i, polygon) in catchment.polygons.iter().enumerate() {
            w.write_all(if i == 0 { b"[" } else { b",[" })?;
            for (k, ring) in polygon.iter().enumerate() {
                w.write_all(if k == 0 { b"" } else { b"," })?;
                chain(w, ring, true)?;
            }
            w.write_all(b"]")?;
        }
        w.write_all(if many { b"]}}" } else { b"}}" })?;
    }
    collection.finish()
}

/// Writes the paths of drops as a FeatureCollection of LineStrings whose third coordinate is the
/// elevation, with the properties that are given for each: members of a JSON object, without
/// braces. A drop that falls on the input has a Point.
///
/// # Errors
/// Those of `w`.
pub fn drops_geojson<'a>(
    mut w: impl Write,
    drops: impl IntoIterator<Item = (&'a Drop, String)>,
    elevation: impl Fn(f64) -> f64,
) -> io::Result<()> {
    let mut collection = Collection::new(&mut w)?;
    for (drop, properties) in drops {
        let w = collection.next()?;
        let is_point = drop.points.len() == 1;
        let kind = if is_point { "Point" } else { "LineString" };
        write!(
            w,
            "{{{properties}}},\"geometry\":{{\"type\":\"{kind}\",\"coordinates\":"
        )?;
        w.write_all(if is_point { b"" } else { b"[" })?;
        for (i, &[x, y, time]) in drop.points.iter().enumerate() {
            write!(
                w,
                "{}[{},{},{}]",
                if i == 0 { "" } else { "," },
                Number(x),
                Number(y),
                Number(elevation(time))
            )?;
        }
        w.write_all(if is_point { b"}}" } else { b"]}}" })?;
    }
    collection.finish()
}

/// Writes a terrain as Wavefront OBJ: one object, triangles that are counterclockwise from above.
///
/// # Errors
/// Those of `w`.
pub fn terrain_obj(
    mut w: impl Write,
    terrain: &Terrain,
    elevation: impl Fn(f64) -> f64,
) -> io::Result<()> {
    writeln!(w, "o terrain")?;
    for &[x, y, time] in terrain.vertices() {
        let [x, y, z] = [x, y, elevation(time)].map(Number);
        writeln!(w, "v {x} {y} {z}")?;
    }
    for triangle in terrain.triangles() {
        let [a, b, c] = triangle.corners.map(|v| v + 1);
        writeln!(w, "f {a} {b} {c}")?;
    }
    Ok(())
}
