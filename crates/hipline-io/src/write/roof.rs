//! The roof in space, drawn from the side.

use std::io::Write;

use hipline::{
    Skeleton,
    skeleton::ArcKind,
    topology::{FaceId, NodeId},
};

use super::{
    palette::{self, Colour},
    png::{LARGEST, PictureError, raster},
    raster::{Corner, Raster, newell},
    window::place,
};

/// How to look at a roof.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RoofView {
    /// The longer side of the picture, in pixels.
    pub size: u32,
    /// How much the roof rises in one unit of time.
    pub slope: f64,
    /// How high the walls are, in input units; by default a little lower than the roof.
    pub walls: Option<f64>,
    /// From where: 0 looks north from the south, 90 west from the east, in degrees.
    pub azimuth: f64,
    /// From how high: 0 is level, 90 from above, in degrees.
    pub elevation: f64,
}

impl Default for RoofView {
    fn default() -> Self {
        Self {
            size: super::DEFAULT_SIZE,
            slope: 1.0,
            walls: None,
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

/// Draws roofs as PNG, seen from the side without perspective, with shaded faces, walls
/// under the input edges, and hidden parts hidden. Unbounded faces are left out.
///
/// # Errors
/// A size of 0 or beyond 16384, and the errors of `w`.
pub fn roof_png(
    mut w: impl Write,
    skeletons: &[&Skeleton],
    view: &RoofView,
) -> Result<(), PictureError> {
    if !(1..=LARGEST).contains(&view.size) {
        return Err(PictureError::Size(view.size));
    }
    let fine = if view.size <= FINE_UP_TO { FINE } else { 1 };
    let walls = view
        .walls
        .unwrap_or_else(|| usual_walls(skeletons, view.slope));
    let camera = Camera::fitted(skeletons, view, walls, fine);
    let mut picture = Raster::new(camera.pixels[0], camera.pixels[1], GROUND);
    for skeleton in skeletons {
        draw(&mut picture, &camera, skeleton, walls);
    }
    let picture = picture.reduced(fine).ok_or(PictureError::Size(view.size))?;
    w.write_all(&picture.encode_png().map_err(raster)?)?;
    Ok(())
}

fn usual_walls(skeletons: &[&Skeleton], slope: f64) -> f64 {
    let nodes = skeletons
        .iter()
        .flat_map(|s| s.nodes())
        .filter(|n| n.time.is_finite());
    0.6 * slope.abs() * nodes.map(|n| n.time).fold(0.0, f64::max)
}

/// An orthographic view: turned about the vertical, then tilted.
struct Camera {
    slope: f64,
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
    fn fitted(skeletons: &[&Skeleton], view: &RoofView, walls: f64, fine: usize) -> Self {
        let angle = |degrees: f64| [degrees.to_radians().cos(), degrees.to_radians().sin()];
        let mut camera = Self {
            slope: view.slope,
            turn: angle(view.azimuth),
            tilt: angle(view.elevation),
            corner: [0.0; 2],
            scale: 1.0,
            pixels: [1; 2],
            pen: fine as f64,
        };
        let mut low = [f64::INFINITY; 2];
        let mut high = [f64::NEG_INFINITY; 2];
        for skeleton in skeletons {
            for (i, node) in skeleton
                .nodes()
                .iter()
                .enumerate()
                .filter(|(_, n)| n.time.is_finite())
            {
                let [x, y] = place(node);
                let foot = if i < skeleton.input().vertices {
                    -walls
                } else {
                    node.time * view.slope
                };
                for height in [foot, node.time * view.slope] {
                    let [u, v, _] = camera.screen([x, y, height]);
                    low = [low[0].min(u), low[1].min(v)];
                    high = [high[0].max(u), high[1].max(v)];
                }
            }
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

    fn node(&self, skeleton: &Skeleton, id: NodeId) -> Corner {
        let node = skeleton.node(id);
        [node.x, node.y, node.time * self.slope]
    }

    /// Lambert's law, for a polygon in space that is counterclockwise from outside. The
    /// light comes from the left, over the eye's shoulder.
    fn shade(&self, polygon: &[Corner]) -> Colour {
        const LIGHT: Corner = [-0.62, -0.22, 0.753];
        let screen: Vec<_> = polygon.iter().map(|&p| self.screen(p)).collect();
        let [nx, ny, nz] = newell(&screen);
        let length = nx.hypot(ny).hypot(nz);
        // The screen's y points down, so its Newell normal points away.
        let light = -(nx * LIGHT[0] + ny * LIGHT[1] + nz * LIGHT[2]) / length;
        palette::mixed(if light.is_finite() {
            0.1 + 0.9 * light
        } else {
            0.5
        })
        .map(|c| c * 0.97)
    }
}

fn draw(picture: &mut Raster, camera: &Camera, skeleton: &Skeleton, walls: f64) {
    let project = |ring: &[Corner]| ring.iter().map(|&p| camera.pixel(p)).collect::<Vec<_>>();
    for i in 0..skeleton.faces().len() {
        let id = FaceId::new(i);
        let boundary = skeleton.boundary(id);
        if boundary
            .iter()
            .any(|&n| skeleton.node(n).time.is_infinite())
        {
            continue;
        }
        let corners = |ring: &[NodeId]| {
            ring.iter()
                .map(|&n| camera.node(skeleton, n))
                .collect::<Vec<_>>()
        };
        let outer = corners(boundary);
        let mut rings = vec![project(&outer)];
        rings.extend(skeleton.holes(id).map(|hole| project(&corners(hole))));
        picture.fill(&rings, camera.shade(&outer));
    }
    let lift = camera.pen;
    for edge in &skeleton.input().edges {
        let [p, q] = edge.map(|v| place(&skeleton.nodes()[v.index()]));
        let mut wall = [
            [q[0], q[1], 0.0],
            [p[0], p[1], 0.0],
            [p[0], p[1], -walls],
            [q[0], q[1], -walls],
        ];
        if walls > 0.0 {
            // Which side of a wall is outside depends on the polygon; the eye sees one.
            let [_, _, nz] = newell(&project(&wall));
            if nz > 0.0 {
                wall.reverse();
            }
            picture.fill(&[project(&wall)], camera.shade(&wall).map(|c| c * 0.93));
        }
        picture.line(
            camera.pixel([p[0], p[1], 0.0]),
            camera.pixel([q[0], q[1], 0.0]),
            camera.pen * 1.2,
            lift,
            INK,
        );
    }
    for arc in skeleton.arcs().iter().filter(|a| a.kind != ArcKind::Ghost) {
        if arc.nodes.iter().all(|&n| skeleton.node(n).time.is_finite()) {
            let [p, q] = arc.nodes.map(|n| camera.pixel(camera.node(skeleton, n)));
            picture.line(p, q, camera.pen, lift, INK);
        }
    }
}
