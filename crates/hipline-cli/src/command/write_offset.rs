//! Offsets as data and in pictures.

use std::io::{self, Write};

use hipline::{Region, offset::Offset};
use hipline_io::{
    FeatureName,
    write::{Layers, OffsetLine, Picture, Window},
};

use super::offset::Offsets;
use crate::{
    args::{OffsetArgs, OutputFormat},
    compute::Computed,
    failure::Failure,
    output::Target,
};

/// The free border of a picture, as a part of its longer side.
const MARGIN: f64 = 0.04;

pub fn write(
    target: &Target,
    computed: &[Computed<Offsets>],
    args: &OffsetArgs,
) -> Result<(), Failure> {
    match target.format {
        OutputFormat::Geojson => target.write(|w| geojson(w, computed)),
        OutputFormat::Wkt => target.write(|w| wkt(w, computed)),
        _ => target.picture(&picture(computed, args), args.size.size),
    }
}

fn successes(
    computed: &[Computed<Offsets>],
) -> impl Iterator<Item = (&FeatureName, &Offsets)> + Clone {
    computed
        .iter()
        .filter_map(|c| Some((&c.name, c.result.as_ref().ok()?)))
}

fn picture<'a>(computed: &'a [Computed<Offsets>], args: &OffsetArgs) -> Picture<'a> {
    let mut picture = Picture::new();
    for (_, Offsets { skeleton, offsets }) in successes(computed) {
        picture.skeleton(skeleton);
        for offset in offsets {
            for cycle in offset.loops() {
                picture.line(OffsetLine {
                    distance: offset.distance(),
                    points: cycle.points().to_vec(),
                    is_closed: true,
                });
            }
        }
    }
    if !args.skeleton
        && let Some(window) = Window::around(seen(computed))
    {
        picture.window(window.enlarged(MARGIN));
    }
    picture.layers(Layers {
        faces: args.skeleton,
        arcs: args.skeleton,
        ghosts: args.skeleton,
        nodes: false,
        ..Layers::default()
    });
    picture
}

/// What is drawn without the skeleton, whose nodes may be far away: the input and the offsets.
fn seen(computed: &[Computed<Offsets>]) -> impl Iterator<Item = [f64; 2]> {
    successes(computed).flat_map(|(_, Offsets { skeleton, offsets })| {
        let input = skeleton.nodes().iter().take(skeleton.input().vertices);
        let loops = offsets.iter().flat_map(Offset::loops);
        input
            .map(|node| [node.x, node.y])
            .chain(loops.flat_map(|cycle| cycle.points().iter().copied()))
    })
}

/// A piece of an offset.
enum Piece {
    /// A shell and its holes.
    Polygon(Vec<Vec<[f64; 2]>>),
    /// A closed line.
    Line(Vec<[f64; 2]>),
}

/// What remains of an interior, as polygons. Of the rest of the plane, what has been swept
/// is of interest, so its boundary is turned around: the swept part is on the left.
fn pieces(region: Region, offset: &Offset) -> Vec<Piece> {
    if region == Region::Interior {
        return offset.polygons().map(Piece::Polygon).collect();
    }
    let reversed = offset
        .loops()
        .iter()
        .map(|cycle| cycle.points().iter().rev().copied().collect());
    reversed.map(Piece::Line).collect()
}

fn geojson(w: &mut dyn Write, computed: &[Computed<Offsets>]) -> io::Result<()> {
    w.write_all(b"{\"type\":\"FeatureCollection\",\"features\":[")?;
    let mut lead = "\n";
    for (name, Offsets { skeleton, offsets }) in successes(computed) {
        let id = name.id.as_ref().map_or_else(String::new, |id| {
            format!(",\"source_id\":{}", serde_json::Value::from(id.as_str()))
        });
        for offset in offsets {
            for piece in pieces(skeleton.region(), offset) {
                write!(
                    w,
                    "{lead}{{\"type\":\"Feature\",\"properties\":{{\"distance\":{:?},\"source\":{}{id}}}",
                    offset.distance(),
                    name.index
                )?;
                lead = ",\n";
                match piece {
                    Piece::Polygon(rings) => {
                        w.write_all(b",\"geometry\":{\"type\":\"Polygon\",\"coordinates\":[")?;
                        for (i, ring) in rings.iter().enumerate() {
                            w.write_all(if i == 0 { b"" } else { b"," })?;
                            json_ring(w, ring)?;
                        }
                        w.write_all(b"]}}")?;
                    }
                    Piece::Line(ring) => {
                        w.write_all(b",\"geometry\":{\"type\":\"LineString\",\"coordinates\":")?;
                        json_ring(w, &ring)?;
                        w.write_all(b"}}")?;
                    }
                }
            }
        }
    }
    w.write_all(b"\n]}\n")
}

fn wkt(w: &mut dyn Write, computed: &[Computed<Offsets>]) -> io::Result<()> {
    for (_, Offsets { skeleton, offsets }) in successes(computed) {
        for offset in offsets {
            for piece in pieces(skeleton.region(), offset) {
                match piece {
                    Piece::Polygon(rings) => {
                        w.write_all(b"POLYGON Z (")?;
                        for (i, ring) in rings.iter().enumerate() {
                            w.write_all(if i == 0 { b"" } else { b", " })?;
                            wkt_ring(w, ring, offset.distance())?;
                        }
                        w.write_all(b")\n")?;
                    }
                    Piece::Line(ring) => {
                        w.write_all(b"LINESTRING Z ")?;
                        wkt_ring(w, &ring, offset.distance())?;
                        w.write_all(b"\n")?;
                    }
                }
            }
        }
    }
    Ok(())
}

/// A ring's points, the first again at the end. `{:?}` prints the fewest digits that are
/// read back as the same number.
fn json_ring(w: &mut dyn Write, ring: &[[f64; 2]]) -> io::Result<()> {
    w.write_all(b"[")?;
    for (i, [x, y]) in ring.iter().chain(ring.first()).enumerate() {
        write!(w, "{}[{x:?},{y:?}]", if i == 0 { "" } else { "," })?;
    }
    w.write_all(b"]")
}

fn wkt_ring(w: &mut dyn Write, ring: &[[f64; 2]], distance: f64) -> io::Result<()> {
    w.write_all(b"(")?;
    for (i, [x, y]) in ring.iter().chain(ring.first()).enumerate() {
        let comma = if i == 0 { "" } else { ", " };
        write!(w, "{comma}{x:?} {y:?} {distance:?}")?;
    }
    w.write_all(b")")
}
