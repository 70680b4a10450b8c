//! Shaded relief: a surface from above, with the input as rivers.
//!
//! A PNG is coloured pixel by pixel, each from the face that its centre lies in; an SVG has a
//! polygon for each face.

use std::io::{self, Write};

use hipline::{
    Skeleton,
    observe::{Contour, Drop, Index, Terrain},
    topology::{EdgeId, FaceId},
};

use super::{
    number::Rounded,
    palette::{self, Colour},
    window::Window,
};

const RIVER: Colour = [38.0, 84.0, 124.0];
const CONTOUR: Colour = [122.0, 92.0, 66.0];
const DROP: Colour = [164.0, 44.0, 60.0];
/// What the skeleton does not cover.
const NOTHING: Colour = [251.0, 250.0, 246.0];

/// Tints from the lowest to the highest.
const TINTS: [Colour; 5] = [
    [148.0, 184.0, 138.0],
    [196.0, 208.0, 150.0],
    [232.0, 216.0, 164.0],
    [206.0, 172.0, 132.0],
    [240.0, 234.0, 226.0],
];

/// A picture of a surface.
#[derive(Debug, Clone, Copy)]
pub struct Relief<'a> {
    /// The surface, to be asked.
    pub index: &'a Index<'a>,
    /// The surface in the window that is seen.
    pub terrain: &'a Terrain,
    /// Numbers of groups for the faces, each of which gets a colour; without, colours go by height.
    pub groups: Option<&'a [usize]>,
    /// Contour lines to draw.
    pub contours: &'a [Contour],
    /// Paths of drops to draw.
    pub drops: &'a [Drop],
}

/// A colour for each number; neighbours in number differ.
fn of_group(group: usize) -> Colour {
    // Hues by the golden ratio, in turn lighter and darker.
    let hue = (group as f64 * 0.618_033_988_749_894_9 + 0.27).fract() * 6.0;
    let value = [214.0, 190.0, 232.0][group % 3];
    let saturation = [0.3, 0.36, 0.24][group / 3 % 3];
    std::array::from_fn(|k| {
        let at = (hue + [0.0, 4.0, 2.0][k]).rem_euclid(6.0);
        let part = ((at - 3.0).abs() - 1.0).clamp(0.0, 1.0);
        value * (1.0 - saturation * (1.0 - part))
    })
}

/// A colour for a height between 0 and 1.
fn of_height(height: f64) -> Colour {
    let at = height.clamp(0.0, 1.0) * (TINTS.len() - 1) as f64;
    let low = (at as usize).min(TINTS.len() - 2);
    let part = at - low as f64;
    std::array::from_fn(|k| TINTS[low][k] + (TINTS[low + 1][k] - TINTS[low][k]) * part)
}

impl Relief<'_> {
    const fn skeleton(&self) -> &Skeleton {
        self.index.skeleton()
    }

    fn window(&self) -> Window {
        let window = self.terrain.window();
        Window {
            min: window.min(),
            max: window.max(),
        }
    }

    /// The colour of a face, at a height between 0 and 1.
    fn colour(&self, face: FaceId, height: f64) -> Colour {
        let tint = match self.groups {
            Some(groups) => of_group(groups[face.index()]),
            None => of_height(height),
        };
        let downhill = palette::downhill(self.skeleton(), self.skeleton().face(face));
        let light = palette::hill_shade(downhill);
        let white = palette::mixed(0.8);
        std::array::from_fn(|k| (tint[k] * light[k] / white[k]).clamp(0.0, 255.0))
    }

    /// Draws the picture as SVG, with the groups `faces`, `contours`, `rivers` and `drops`.
    ///
    /// # Errors
    /// Those of `w`.
    pub fn svg(&self, mut w: impl Write) -> io::Result<()> {
        const CANVAS: f64 = 1000.0;
        let window = self.window();
        let scale = CANVAS / window.longest_side();
        let [width, height] = [window.width(), window.height()].map(|s| Rounded(s * scale));
        let path = |w: &mut dyn Write, points: &[[f64; 2]], close: bool| -> io::Result<()> {
            for (i, p) in points.iter().enumerate() {
                let (x, y) = (p[0] - window.min[0], window.max[1] - p[1]);
                let [x, y] = [x, y].map(|c| Rounded(c * scale));
                write!(w, "{}{x} {y}", if i == 0 { "M" } else { "L" })?;
            }
            w.write_all(if close { b"Z" } else { b"" })
        };
        writeln!(
            w,
            "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {width} {height}\" \
             width=\"{width}\" height=\"{height}\" stroke-linecap=\"round\" stroke-linejoin=\"round\">"
        )?;
        let ground = palette::hex(NOTHING);
        writeln!(
            w,
            "<rect width=\"100%\" height=\"100%\" fill=\"{ground}\"/>"
        )?;
        writeln!(w, "<g id=\"faces\" stroke-width=\"0.4\">")?;
        let middle = self.middles();
        for catchment in self.terrain.catchments(FaceId::index) {
            let face = FaceId::new(catchment.key);
            let colour = palette::hex(self.colour(face, middle[catchment.key]));
            write!(w, "<path fill=\"{colour}\" stroke=\"{colour}\" d=\"")?;
            for ring in catchment.polygons.iter().flatten() {
                path(&mut w, ring, true)?;
            }
            writeln!(w, "\"/>")?;
        }
        writeln!(w, "</g>")?;
        let mut layer = |id: &str, colour: Colour, pen: f64, lines: &[(Vec<[f64; 2]>, bool)]| {
            if lines.is_empty() {
                return Ok(());
            }
            writeln!(
                w,
                "<g id=\"{id}\" fill=\"none\" stroke=\"{}\" stroke-width=\"{}\">",
                palette::hex(colour),
                Rounded(pen)
            )?;
            for (points, close) in lines {
                w.write_all(b"<path d=\"")?;
                path(&mut w, points, *close)?;
                writeln!(w, "\"/>")?;
            }
            writeln!(w, "</g>")
        };
        let [contours, rivers, drops] = self.lines();
        layer("contours", CONTOUR, 0.5, &contours)?;
        layer("rivers", RIVER, 1.3, &rivers)?;
        layer("drops", DROP, 1.5, &drops)?;
        writeln!(w, "</svg>")
    }

    /// For each face, half of its largest height in the window, between 0 and 1.
    fn middles(&self) -> Vec<f64> {
        let highest = self.terrain.highest();
        let mut of_faces = vec![0.0_f64; self.skeleton().faces().len()];
        for triangle in self.terrain.triangles() {
            for v in triangle.corners {
                let [_, _, time] = self.terrain.vertices()[v as usize];
                let most = &mut of_faces[triangle.face.index()];
                *most = most.max(0.5 * time / highest);
            }
        }
        of_faces
    }

    /// Contour lines, rivers and paths, as far as they are seen, and whether they are closed.
    fn lines(&self) -> [Vec<(Vec<[f64; 2]>, bool)>; 3] {
        let window = self.window();
        let contours = self.contours.iter();
        let edges = 0..self.skeleton().input().edges.len();
        let rivers = edges.flat_map(|i| {
            let ends = palette::ends(self.skeleton(), EdgeId::new(i));
            window.clip_chain(&ends)
        });
        let drops = self.drops.iter().flat_map(|drop| {
            let points: Vec<[f64; 2]> = drop.points.iter().map(|p| [p[0], p[1]]).collect();
            window.clip_chain(&points)
        });
        [
            contours.map(|c| (c.points.clone(), c.is_closed)).collect(),
            rivers.map(|line| (line, false)).collect(),
            drops.map(|line| (line, false)).collect(),
        ]
    }
}

#[cfg(feature = "png")]
mod pixels {
    use super::*;
    use crate::write::{
        PictureError,
        png::{LARGEST, raster},
        raster::{Raster, bytes},
    };
    use hipline::observe::Grid;

    /// How many points across each pixel are coloured.
    const FINE: u32 = 2;
    /// Larger pictures are coloured point by point.
    const FINE_UP_TO: u32 = 4096;

    impl Relief<'_> {
        /// Draws the picture as PNG whose longer side has `size` pixels.
        ///
        /// # Errors
        /// A size of 0 or beyond 16384, a window that is too small for f64, and the errors of `w`.
        pub fn png(&self, mut w: impl Write, size: u32) -> Result<(), PictureError> {
            if !(1..=LARGEST).contains(&size) {
                return Err(PictureError::Size(size));
            }
            let fine = if size <= FINE_UP_TO { FINE } else { 1 };
            let window = self.window();
            let cell = window.longest_side() / f64::from(size * fine);
            let grid = Grid::new(self.terrain.window(), cell).map_err(raster)?;
            // A row or column more may have come in by rounding, and pixels must be whole.
            let whole = |cells: usize| (cells / fine as usize).max(1) * fine as usize;
            let (columns, rows) = (whole(grid.columns()), whole(grid.rows()));
            let mut picture = Raster::new(columns, rows, NOTHING);
            let highest = self.terrain.highest();
            for (i, answer) in self.index.locate_grid(&grid).iter().enumerate() {
                let (column, row) = (i % grid.columns(), i / grid.columns());
                let row = grid.rows() - 1 - row;
                if let Ok(answer) = answer
                    && column < columns
                    && row < rows
                {
                    let colour = self.colour(answer.face, answer.time / highest);
                    picture.set(column, row, 0.0, bytes(colour));
                }
            }
            let pen = f64::from(fine) * (f64::from(size) / 1000.0).clamp(0.6, 4.0);
            let at = |p: [f64; 2], depth: f64| {
                let x = (p[0] - grid.origin()[0]) / cell;
                let y = grid.rows() as f64 - (p[1] - grid.origin()[1]) / cell;
                [x, y, depth]
            };
            let layers = [(CONTOUR, 0.7), (RIVER, 1.6), (DROP, 2.0)];
            for (k, (lines, (colour, breadth))) in self.lines().iter().zip(layers).enumerate() {
                let depth = k as f64 + 1.0;
                for (points, close) in lines {
                    let ends = points
                        .iter()
                        .skip(1)
                        .chain(points.first().filter(|_| *close));
                    for (p, q) in points.iter().zip(ends) {
                        picture.line(at(*p, depth), at(*q, depth), pen * breadth, 0.0, colour);
                    }
                }
            }
            let picture = picture
                .reduced(fine as usize)
                .ok_or(PictureError::Size(size))?;
            w.write_all(&picture.encode_png().map_err(raster)?)?;
            Ok(())
        }
    }
}
