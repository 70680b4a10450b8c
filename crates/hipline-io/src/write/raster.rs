//! A small z-buffer: planar polygons and lines, seen along the depth axis.
//!
//! Why not a painter's order: faces of a roof can overlap each other in a cycle when seen
//! from the side. Why not triangles: a scan line cuts any planar polygon, with holes or
//! not, into spans, and depth is linear along each.

use resvg::tiny_skia::{Pixmap, PremultipliedColorU8};

use super::{palette::Colour, window::Window};

/// A corner on the screen: x to the right, y down, in pixels; depth grows towards the eye.
pub(super) type Corner = [f64; 3];

pub(super) struct Raster {
    width: usize,
    height: usize,
    depth: Vec<f32>,
    colour: Vec<[u8; 3]>,
}

impl Raster {
    pub fn new(width: usize, height: usize, background: Colour) -> Self {
        let pixels = width * height;
        Self {
            width,
            height,
            depth: vec![f32::NEG_INFINITY; pixels],
            colour: vec![bytes(background); pixels],
        }
    }

    /// Fills a planar polygon, even-odd: its boundary, then its holes.
    pub fn fill(&mut self, rings: &[Vec<Corner>], colour: Colour) {
        let Some([a, b, c]) = plane(rings) else {
            return;
        };
        let edges: Vec<[Corner; 2]> = rings
            .iter()
            .flat_map(|ring| (0..ring.len()).map(|i| [ring[i], ring[(i + 1) % ring.len()]]))
            .filter(|[p, q]| p[1].total_cmp(&q[1]).is_ne())
            .collect();
        let [low, high] = edges
            .iter()
            .flatten()
            .fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], p| {
                [low.min(p[1]), high.max(p[1])]
            });
        if !(low.is_finite() && high.is_finite()) {
            return;
        }
        let colour = bytes(colour);
        let rows = first_centre(low, self.height)..first_centre(high, self.height);
        // Each edge waits at the first row that it crosses, so that a row sees only its own.
        let mut starts = vec![Vec::new(); rows.len()];
        for edge in &edges {
            let top = first_centre(edge[0][1].min(edge[1][1]), self.height);
            let bottom = first_centre(edge[0][1].max(edge[1][1]), self.height);
            if top < bottom {
                starts[top - rows.start].push((bottom, edge));
            }
        }
        let mut active: Vec<(usize, &[Corner; 2])> = Vec::new();
        let mut crossings = Vec::new();
        for row in rows.clone() {
            active.retain(|(bottom, _)| *bottom > row);
            active.append(&mut starts[row - rows.start]);
            let y = row as f64 + 0.5;
            crossings.clear();
            crossings.extend(
                active
                    .iter()
                    .map(|(_, [p, q])| p[0] + (y - p[1]) / (q[1] - p[1]) * (q[0] - p[0])),
            );
            crossings.sort_by(f64::total_cmp);
            for span in crossings.chunks_exact(2) {
                for column in first_centre(span[0], self.width)..first_centre(span[1], self.width) {
                    let x = column as f64 + 0.5;
                    self.set(column, row, a * x + b * y + c, colour);
                }
            }
        }
    }

    /// Draws a line of some breadth, lifted a little towards the eye.
    pub fn line(&mut self, p: Corner, q: Corner, breadth: f64, lift: f64, colour: Colour) {
        let colour = bytes(colour);
        let reach = breadth / 2.0;
        let sides = [self.width as f64 + reach, self.height as f64 + reach];
        let d: Corner = std::array::from_fn(|k| q[k] - p[k]);
        // Only what is seen, or a line that is long beyond all measure would take as long.
        let seen = Window {
            min: [-reach; 2],
            max: sides,
        }
        .inside([p[0], p[1]], [d[0], d[1]], 1.0);
        let Some([first, last]) = seen.filter(|_| d.iter().all(|c| c.is_finite())) else {
            return;
        };
        let length = d[0].hypot(d[1]) * (last - first);
        let steps = (length * 2.0).ceil().max(1.0) as usize;
        for i in 0..=steps {
            let s = first + (last - first) * (i as f64 / steps as f64);
            let [x, y, depth]: Corner = std::array::from_fn(|k| p[k] + s * d[k]);
            for row in first_centre(y - reach, self.height)..first_centre(y + reach, self.height) {
                for column in
                    first_centre(x - reach, self.width)..first_centre(x + reach, self.width)
                {
                    self.set(column, row, depth + lift, colour);
                }
            }
        }
    }

    /// Colours a pixel, unless something nearer to the eye is there.
    pub fn set(&mut self, column: usize, row: usize, depth: f64, colour: [u8; 3]) {
        let pixel = row * self.width + column;
        if depth as f32 > self.depth[pixel] {
            self.depth[pixel] = depth as f32;
            self.colour[pixel] = colour;
        }
    }

    /// The picture, each pixel the mean of `fine` by `fine` of the raster's.
    pub fn reduced(&self, fine: usize) -> Option<Pixmap> {
        let (width, height) = (self.width / fine, self.height / fine);
        let mut picture = Pixmap::new(u32::try_from(width).ok()?, u32::try_from(height).ok()?)?;
        let count = (fine * fine) as u32;
        for (i, pixel) in picture.pixels_mut().iter_mut().enumerate() {
            let (row, column) = (i / width * fine, i % width * fine);
            let mut sum = [count / 2; 3];
            for y in row..row + fine {
                for colour in &self.colour[y * self.width + column..y * self.width + column + fine]
                {
                    for (s, c) in sum.iter_mut().zip(colour) {
                        *s += u32::from(*c);
                    }
                }
            }
            let [r, g, b] = sum.map(|s| (s / count) as u8);
            *pixel = PremultipliedColorU8::from_rgba(r, g, b, 255)?;
        }
        Some(picture)
    }
}

/// The first pixel whose centre is not before `x`.
fn first_centre(x: f64, end: usize) -> usize {
    // The cast saturates, also for NaN.
    ((x - 0.5).ceil().max(0.0) as usize).min(end)
}

/// Depth as `a x + b y + c` on the plane of a polygon (Newell's normal); none if it is seen
/// from its edge.
fn plane(rings: &[Vec<Corner>]) -> Option<[f64; 3]> {
    let outer = rings.first()?;
    let [nx, ny, nz] = newell(outer);
    let count = outer.len() as f64;
    let centre: Corner = std::array::from_fn(|k| outer.iter().map(|p| p[k]).sum::<f64>() / count);
    let (a, b) = (-nx / nz, -ny / nz);
    let c = centre[2] - a * centre[0] - b * centre[1];
    (a.is_finite() && b.is_finite() && c.is_finite()).then_some([a, b, c])
}

/// A normal of a polygon in space; its length is twice the area.
pub(super) fn newell(ring: &[Corner]) -> Corner {
    let mut normal = [0.0; 3];
    for (i, p) in ring.iter().enumerate() {
        let q = ring[(i + 1) % ring.len()];
        normal[0] += (p[1] - q[1]) * (p[2] + q[2]);
        normal[1] += (p[2] - q[2]) * (p[0] + q[0]);
        normal[2] += (p[0] - q[0]) * (p[1] + q[1]);
    }
    normal
}

pub(super) fn bytes(colour: Colour) -> [u8; 3] {
    colour.map(|c| c.round().clamp(0.0, 255.0) as u8)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nearer_things_hide_farther_ones() {
        let square = |low: f64, high: f64, depth: f64| {
            vec![
                [low, low, depth],
                [high, low, depth],
                [high, high, depth],
                [low, high, depth],
            ]
        };
        let mut raster = Raster::new(8, 8, [255.0; 3]);
        raster.fill(
            &[square(2.0, 6.0, 1.0), square(3.0, 5.0, 1.0)],
            [200.0, 0.0, 0.0],
        );
        raster.fill(&[square(0.0, 4.0, 0.0)], [0.0, 0.0, 200.0]);
        let at = |x: usize, y: usize| raster.colour[y * 8 + x];
        assert_eq!(at(0, 0), [0, 0, 200]);
        assert_eq!(at(2, 2), [200, 0, 0], "the nearer one");
        assert_eq!(at(3, 3), [0, 0, 200], "through its hole");
        assert_eq!(
            at(4, 4),
            [255; 3],
            "through its hole, beside the farther one"
        );
        assert_eq!(at(5, 5), [200, 0, 0]);
        assert_eq!(at(6, 6), [255; 3]);
        let picture = raster.reduced(4).unwrap();
        let blue = u32::from(picture.pixels()[0].blue());
        assert_eq!((picture.width(), picture.height()), (2, 2));
        // Of 16 pixels 13 are blue (200), 3 red (0), none white.
        assert_eq!(blue, (13 * 200 + 8) / 16);
    }

    #[test]
    fn wild_corners_are_harmless() {
        let mut raster = Raster::new(4, 4, [255.0; 3]);
        for wild in [f64::NAN, f64::INFINITY, f64::MAX, -1e300] {
            raster.fill(
                &[vec![[0.0, 0.0, 0.0], [wild, 0.0, 0.0], [0.0, wild, 1.0]]],
                [0.0; 3],
            );
            raster.fill(
                &[vec![[0.0, 0.0, wild], [3.0, 0.0, 0.0], [0.0, 3.0, 1.0]]],
                [0.0; 3],
            );
        }
        for wild in [f64::NAN, f64::INFINITY, 1e300] {
            raster.line([0.0; 3], [wild; 3], 1.0, 0.0, [0.0; 3]);
            raster.line([wild, 1.0, 2.0], [-wild; 3], 1.0, 0.0, [0.0; 3]);
        }
        raster.fill(&[], [0.0; 3]);
        raster.fill(&[vec![]], [0.0; 3]);
    }
}
