//! Houses in space, drawn from the side.

use std::io::Write;

use hipline::roof::{Mesh, Surface};

use super::{
    palette::{self, Colour},
    png::{LARGEST, PictureError, raster},
    raster::{Corner, Raster, newell},
};

/// How to look at a roof.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RoofView {
    /// The longer side of the picture, in pixels.
    pub size: u32,
    /// From where: 0 looks north from the south, 90 west from the east, in degrees.
    pub azimuth: f64,
    /// From how high: 0 is level, 90 from above, in degrees.
    pub elevation: f64,
}

impl Default for RoofView {
    fn default() -> Self {
        Self {
            size: super::DEFAULT_SIZE,
            azimuth: 28.0,
            elevation: 34.0,
        }
    }
}

/// Raster lines and columns per pixel, in pictures up to [`FINE_UP_TO`].
const FINE: usize = 2;
const FINE_UP_TO: u32 = 4096;

/// The free border, as a part of the longer side.
const MARGIN: f64 = 0.05;

const GROUND: Colour = [251.0, 250.0, 246.0];
const INK: Colour = [62.0, 66.0, 74.0];

/// Draws meshes as PNG, seen from the side without perspective, with shaded facets and hidden
/// parts hidden. Lines are drawn where facets of different planes meet.
///
/// # Errors
/// A size of 0 or beyond 16384, and the errors of `w`.
pub fn roof_png(mut w: impl Write, meshes: &[&Mesh], view: &RoofView) -> Result<(), PictureError> {
    if !(1..=LARGEST).contains(&view.size) {
        return Err(PictureError::Size(view.size));
    }
    let fine = if view.size <= FINE_UP_TO { FINE } else { 1 };
    let camera = Camera::fitted(meshes, view, fine);
    let mut picture = Raster::new(camera.pixels[0], camera.pixels[1], GROUND);
    for mesh in meshes {
        draw(&mut picture, &camera, mesh);
    }
    let picture = picture.reduced(fine).ok_or(PictureError::Size(view.size))?;
    w.write_all(&picture.encode_png().map_err(raster)?)?;
    Ok(())
}

/// An orthographic view: turned about the vertical, then tilted.
struct Camera {
    turn: [f64; 2],
    tilt: [f64; 2],
    /// Screen place of the upper left corner, before scaling.
    corner: [f64; 2],
    scale: f64,
    pixels: [usize; 2],
    /// The width of a usual line, in raster pixels.
    pen: f64,
}

impl Camera {
    fn fitted(meshes: &[&Mesh], view: &RoofView, fine: usize) -> Self {
        let angle = |degrees: f64| [degrees.to_radians().cos(), degrees.to_radians().sin()];
        let mut camera = Self {
            turn: angle(view.azimuth),
            tilt: angle(view.elevation),
            corner: [0.0; 2],
            scale: 1.0,
            pixels: [1; 2],
            pen: fine as f64,
        };
        let mut low = [f64::INFINITY; 2];
        let mut high = [f64::NEG_INFINITY; 2];
        for &vertex in meshes.iter().flat_map(|mesh| mesh.vertices()) {
            let [u, v, _] = camera.screen(vertex);
            low = [low[0].min(u), low[1].min(v)];
            high = [high[0].max(u), high[1].max(v)];
        }
        let mut sides = [high[0] - low[0], high[1] - low[1]];
        let longest = sides[0].max(sides[1]);
        if !(longest.is_finite() && longest > 0.0) {
            // Nothing to see, or nothing that fits into f64.
            low = [0.0; 2];
            sides = [1.0; 2];
        }
        let margin = sides[0].max(sides[1]) * MARGIN;
        camera.corner = low.map(|c| c - margin);
        let sides = sides.map(|s| s + 2.0 * margin);
        let longest = sides[0].max(sides[1]);
        camera.scale = f64::from(view.size) * fine as f64 / longest;
        camera.pixels =
            sides.map(|s| ((s / longest * f64::from(view.size)).round() as usize).max(1) * fine);
        camera.pen = (f64::from(view.size) / 1000.0).clamp(0.6, 4.0) * fine as f64;
        camera
    }

    /// Screen right, screen down, towards the eye; not yet scaled.
    fn screen(&self, [x, y, z]: Corner) -> Corner {
        let [cos, sin] = self.turn;
        let (u, v) = (x * cos + y * sin, y * cos - x * sin);
        let [cos, sin] = self.tilt;
        [u, -(v * sin + z * cos), z * sin - v * cos]
    }

    fn pixel(&self, p: Corner) -> Corner {
        let [u, v, depth] = self.screen(p);
        [
            (u - self.corner[0]) * self.scale,
            (v - self.corner[1]) * self.scale,
            depth * self.scale,
        ]
    }

    /// Lambert's law, for a polygon in space that is counterclockwise from outside. The
    /// light comes from the left, over the eye's shoulder.
    fn shade(&self, normal: Corner, surface: Surface) -> Colour {
        const LIGHT: Corner = [-0.62, -0.22, 0.753];
        let [nx, ny, nz] = normal;
        // The screen's y points down, so its Newell normal points away.
        let light = -(nx * LIGHT[0] + ny * LIGHT[1] + nz * LIGHT[2]);
        let colour = palette::mixed(if light.is_finite() {
            0.1 + 0.9 * light
        } else {
            0.5
        });
        let tint = match surface {
            Surface::Roof => [1.0; 3],
            Surface::Wall => [0.93; 3],
            Surface::Soffit => [0.80, 0.74, 0.68],
            Surface::Ground => [0.75; 3],
        };
        std::array::from_fn(|k| colour[k] * tint[k])
    }
}

/// The cosine of the angle between facets that count as one plane: one degree.
const ONE_PLANE: f64 = 0.999_85;

fn draw(picture: &mut Raster, camera: &Camera, mesh: &Mesh) {
    let at = |v: u32| mesh.vertices()[v as usize];
    let normals: Vec<Corner> = mesh
        .facets()
        .iter()
        .map(|facet| {
            let ring = mesh.rings(facet).next().unwrap_or_default();
            let seen: Vec<Corner> = ring.iter().map(|&v| camera.screen(at(v))).collect();
            let normal = newell(&seen);
            let length = normal[0].hypot(normal[1]).hypot(normal[2]);
            normal.map(|c| c / length)
        })
        .collect();
    let mut edges: Vec<([u32; 2], usize)> = Vec::new();
    for (i, facet) in mesh.facets().iter().enumerate() {
        let rings: Vec<Vec<Corner>> = mesh
            .rings(facet)
            .map(|ring| ring.iter().map(|&v| camera.pixel(at(v))).collect())
            .collect();
        picture.fill(&rings, camera.shade(normals[i], facet.surface));
        for ring in mesh.rings(facet) {
            for (k, &a) in ring.iter().enumerate() {
                let b = ring[(k + 1) % ring.len()];
                edges.push(([a.min(b), a.max(b)], i));
            }
        }
    }
    edges.sort_unstable();
    for same in edges.chunk_by(|a, b| a.0 == b.0) {
        if let [(_, i), (_, j)] = *same {
            let cosine: f64 = (0..3).map(|k| normals[i][k] * normals[j][k]).sum();
            let is_one_kind = mesh.facets()[i].surface == mesh.facets()[j].surface;
            // Not the line between a wall and the gable on it, either.
            if cosine > ONE_PLANE && is_one_kind {
                continue;
            }
        }
        let [p, q] = same[0].0.map(|v| camera.pixel(at(v)));
        picture.line(p, q, camera.pen, camera.pen, INK);
    }
}
