//! Motorcycle graphs: as JSON and GeoJSON, and as a picture.
//!
//! In JSON, places and times are exact: they are read back bit for bit. In GeoJSON and pictures, tracks that go
//! to infinity are cut off at a window around all that ends.

use std::io::{self, Write};

use hipline::motorcycle::{End, Motorcycle, MotorcycleGraph, Origin, Spot};

use super::{
    geojson::{Collection, chain},
    json::string,
    number::{Number, Rounded},
    palette,
    window::{Window, is_same},
};
use crate::FeatureName;

/// The longer side of the canvas, in SVG units.
const CANVAS: f64 = 1000.0;

/// A motorcycle graph and what belongs to it.
#[derive(Debug, Clone)]
pub struct Tracks<'a> {
    /// Of which feature it is.
    pub name: FeatureName,
    /// The graph.
    pub graph: &'a MotorcycleGraph,
    /// The edges of the polygons, or the walls.
    pub walls: Vec<[[f64; 2]; 2]>,
}

const fn place(spot: &Spot) -> [f64; 2] {
    [spot.x, spot.y]
}

impl Tracks<'_> {
    /// All that is finite.
    fn window(&self) -> Option<Window> {
        let tracks = self.graph.motorcycles().iter();
        let spots = tracks.flat_map(|m| [Some(m.start), m.stop]).flatten();
        let spots = spots.map(|spot| place(&spot));
        Window::around(spots.chain(self.walls.iter().flatten().copied()))
    }
}

/// The ends of a track; of one that goes to infinity, where it leaves the window.
fn ends(motorcycle: &Motorcycle, window: &Window) -> [[f64; 2]; 2] {
    let start = place(&motorcycle.start);
    if let Some(stop) = &motorcycle.stop {
        return [start, place(stop)];
    }
    let [v, w] = motorcycle.velocity;
    let longest = v.abs().max(w.abs());
    // In steps of the window's size, so that nothing overflows.
    let step = [v, w].map(|x| x / longest * window.longest_side());
    let out = window
        .inside(start, step, 4.0)
        .map_or(1.0, |[_, last]| last);
    [start, [0, 1].map(|k| start[k] + out * step[k])]
}

fn spot(w: &mut impl Write, spot: &Spot) -> io::Result<()> {
    let [x, y, time] = [spot.x, spot.y, spot.time].map(Number);
    write!(w, "{{\"x\":{x},\"y\":{y},\"time\":{time}}}")
}

/// What a motorcycle comes from and runs into, as members of a JSON object.
fn story(w: &mut impl Write, motorcycle: &Motorcycle) -> io::Result<()> {
    match motorcycle.origin {
        Origin::Vertex(vertex) => write!(w, "\"from\":\"vertex\",\"from_id\":{}", vertex.index())?,
        Origin::Meeting(meeting) => {
            write!(w, "\"from\":\"meeting\",\"from_id\":{}", meeting.index())?
        }
        Origin::Given => write!(w, "\"from\":\"given\"")?,
    }
    let (what, number) = match motorcycle.end {
        End::Escape => return write!(w, ",\"end\":\"escape\""),
        End::Edge(edge, _) => ("edge", edge.index()),
        End::Vertex(vertex) => ("vertex", vertex.index()),
        End::Wall(wall) => ("wall", wall.index()),
        End::Track(other) => ("track", other.index()),
        End::Meeting(meeting) => ("meeting", meeting.index()),
    };
    write!(w, ",\"end\":\"{what}\",\"end_id\":{number}")
}

fn name(w: &mut impl Write, [index, id]: [&str; 2], name: &FeatureName) -> io::Result<()> {
    write!(w, "\"{index}\":{}", name.index)?;
    if let Some(text) = &name.id {
        write!(w, ",\"{id}\":{}", string(text))?;
    }
    Ok(())
}

/// Writes motorcycle graphs as one JSON object; `docs/motorcycles.md` describes it.
///
/// # Errors
/// Those of `w`.
pub fn motorcycles_json<'a>(
    mut w: impl Write,
    all: impl IntoIterator<Item = Tracks<'a>>,
) -> io::Result<()> {
    let w = &mut w;
    w.write_all(b"{\"format\":\"hipline-motorcycles\",\"version\":1,\"results\":[")?;
    for (i, tracks) in all.into_iter().enumerate() {
        w.write_all(if i == 0 { b"\n{" } else { b",\n{" })?;
        name(w, ["index", "id"], &tracks.name)?;
        w.write_all(b",\"motorcycles\":[")?;
        for (i, motorcycle) in tracks.graph.motorcycles().iter().enumerate() {
            w.write_all(if i == 0 {
                b"\n{\"start\":"
            } else {
                b",\n{\"start\":"
            })?;
            spot(w, &motorcycle.start)?;
            w.write_all(b",\"stop\":")?;
            match &motorcycle.stop {
                Some(stop) => spot(w, stop)?,
                None => w.write_all(b"null")?,
            }
            let [x, y] = motorcycle.velocity.map(Number);
            write!(w, ",\"velocity\":[{x},{y}],")?;
            story(w, motorcycle)?;
            w.write_all(b"}")?;
        }
        w.write_all(b"],\"meetings\":[")?;
        for (i, meeting) in tracks.graph.meetings().iter().enumerate() {
            w.write_all(if i == 0 {
                b"\n{\"spot\":"
            } else {
                b",\n{\"spot\":"
            })?;
            spot(w, &meeting.spot)?;
            let members: Vec<String> = (meeting.members.iter())
                .map(|member| member.index().to_string())
                .collect();
            write!(w, ",\"members\":[{}],\"child\":", members.join(","))?;
            match meeting.child {
                Some(child) => write!(w, "{}}}", child.index())?,
                None => w.write_all(b"null}")?,
            }
        }
        w.write_all(b"]}")?;
    }
    w.write_all(b"\n]}\n")
}

/// Writes the tracks as a FeatureCollection of LineStrings, one a motorcycle (a Point if it ends where it
/// starts), with the properties
///
/// * `source` and `source_id`: the feature that it belongs to; `motorcycle`: its number;
/// * `from` and `from_id`: the vertex or the meeting that it comes from;
/// * `end` and `end_id`: the edge, vertex, wall, track or meeting that it ends in, or `escape`;
/// * `start_time` and `end_time` (null if it escapes; then the line is cut off at a window).
///
/// # Errors
/// Those of `w`.
pub fn motorcycles_geojson<'a>(
    mut w: impl Write,
    all: impl IntoIterator<Item = Tracks<'a>>,
) -> io::Result<()> {
    let mut collection = Collection::new(&mut w)?;
    for tracks in all {
        let Some(window) = tracks.window().map(|window| window.enlarged(0.25)) else {
            continue;
        };
        for (i, motorcycle) in tracks.graph.motorcycles().iter().enumerate() {
            let w = collection.next()?;
            w.write_all(b"{")?;
            name(w, ["source", "source_id"], &tracks.name)?;
            write!(w, ",\"motorcycle\":{i},")?;
            story(w, motorcycle)?;
            let end = motorcycle.stop.map_or(f64::INFINITY, |stop| stop.time);
            let [start, end] = [motorcycle.start.time, end].map(Number);
            write!(
                w,
                ",\"start_time\":{start},\"end_time\":{end}}},\"geometry\":{{"
            )?;
            let [p, q] = ends(motorcycle, &window);
            if is_same(p, q) {
                let [x, y] = p.map(Number);
                write!(w, "\"type\":\"Point\",\"coordinates\":[{x},{y}]")?;
            } else {
                w.write_all(b"\"type\":\"LineString\",\"coordinates\":")?;
                chain(w, &[p, q], false)?;
            }
            w.write_all(b"}}")?;
        }
    }
    collection.finish()
}

/// Draws motorcycle graphs as SVG: polygons or walls, tracks (those that start in meetings in another
/// colour), starts as dots, ends in tracks as rings, meetings as larger dots.
///
/// # Errors
/// Those of `w`.
pub fn motorcycles_svg(mut w: impl Write, all: &[Tracks]) -> io::Result<()> {
    let window = (all.iter().filter_map(Tracks::window)).reduce(Window::union);
    let window = match window.map(|window| window.enlarged(0.04)) {
        Some(w) if w.longest_side().is_finite() && w.longest_side() > 0.0 => w,
        _ => Window {
            min: [0.0, 0.0],
            max: [1.0, 1.0],
        },
    };
    let count: usize = all
        .iter()
        .map(|tracks| tracks.walls.len() + tracks.graph.motorcycles().len())
        .sum();
    let sketch = Sketch {
        window,
        scale: CANVAS / window.longest_side(),
        pen: (8.5 / (count.max(1) as f64).powf(0.25)).clamp(0.3, 2.4),
    };
    sketch.draw(&mut w, all)
}

/// Draws motorcycle graphs as PNG whose longer side has `size` pixels.
///
/// # Errors
/// A size of 0 or beyond 16384, and the errors of `w`.
#[cfg(feature = "png")]
pub fn motorcycles_png(
    w: impl Write,
    all: &[Tracks],
    size: u32,
) -> Result<(), super::PictureError> {
    let mut svg = Vec::new();
    motorcycles_svg(&mut svg, all)?;
    super::png::rasterise(&svg, w, size)
}

/// Where things come to lie, and how wide a usual stroke is.
struct Sketch {
    window: Window,
    scale: f64,
    pen: f64,
}

impl Sketch {
    fn at(&self, p: [f64; 2]) -> [Rounded; 2] {
        [
            Rounded((p[0] - self.window.min[0]) * self.scale),
            Rounded((self.window.max[1] - p[1]) * self.scale),
        ]
    }

    fn draw(&self, w: &mut impl Write, all: &[Tracks]) -> io::Result<()> {
        let sides = [0, 1].map(|k| self.window.max[k] - self.window.min[k]);
        let [width, height] = sides.map(|side| Rounded((side * self.scale).max(1.0)));
        writeln!(
            w,
            "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {width} {height}\" width=\"{width}\" \
             height=\"{height}\" stroke-linecap=\"round\" stroke-linejoin=\"round\">"
        )?;
        writeln!(
            w,
            "<rect width=\"100%\" height=\"100%\" fill=\"{}\"/>",
            palette::BACKGROUND
        )?;
        for (id, colour, is_born) in [
            ("tracks", palette::TRACK, false),
            ("born", palette::BORN, true),
        ] {
            let lines = all.iter().flat_map(|tracks| {
                let motorcycles = tracks.graph.motorcycles().iter();
                motorcycles.filter(move |m| matches!(m.origin, Origin::Meeting(_)) == is_born)
            });
            self.lines(w, id, colour, 0.9, lines.map(|m| ends(m, &self.window)))?;
        }
        let walls = all.iter().flat_map(|tracks| tracks.walls.iter().copied());
        self.lines(w, "walls", palette::INPUT, 1.5, walls)?;
        let motorcycles = || all.iter().flat_map(|tracks| tracks.graph.motorcycles());
        writeln!(w, "<g id=\"starts\" fill=\"{}\">", palette::TRACK)?;
        for motorcycle in motorcycles().filter(|m| !matches!(m.origin, Origin::Meeting(_))) {
            self.dot(w, place(&motorcycle.start), 1.7)?;
        }
        let line = Rounded(self.pen * 0.7);
        writeln!(
            w,
            "</g>\n<g id=\"ends\" fill=\"{}\" stroke=\"{}\" stroke-width=\"{line}\">",
            palette::BACKGROUND,
            palette::TRACK
        )?;
        for motorcycle in motorcycles().filter(|m| matches!(m.end, End::Track(_))) {
            if let Some(stop) = &motorcycle.stop {
                self.dot(w, place(stop), 1.5)?;
            }
        }
        writeln!(w, "</g>\n<g id=\"meetings\" fill=\"{}\">", palette::BORN)?;
        for meeting in all.iter().flat_map(|tracks| tracks.graph.meetings()) {
            self.dot(w, place(&meeting.spot), 2.2)?;
        }
        writeln!(w, "</g>\n</svg>")
    }

    fn lines(
        &self,
        w: &mut impl Write,
        id: &str,
        colour: &str,
        width: f64,
        lines: impl Iterator<Item = [[f64; 2]; 2]>,
    ) -> io::Result<()> {
        let width = Rounded(self.pen * width);
        write!(
            w,
            "<g id=\"{id}\" fill=\"none\" stroke=\"{colour}\" stroke-width=\"{width}\">"
        )?;
        let mut is_open = false;
        for line in lines {
            w.write_all(if is_open { b"" } else { b"\n<path d=\"" })?;
            is_open = true;
            let [[x, y], [u, v]] = line.map(|p| self.at(p));
            write!(w, "M{x} {y}L{u} {v}")?;
        }
        writeln!(w, "{}</g>", if is_open { "\"/>\n" } else { "" })
    }

    fn dot(&self, w: &mut impl Write, p: [f64; 2], size: f64) -> io::Result<()> {
        let [x, y] = self.at(p);
        writeln!(
            w,
            "<circle cx=\"{x}\" cy=\"{y}\" r=\"{}\"/>",
            Rounded(self.pen * size)
        )
    }
}
