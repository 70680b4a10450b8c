//! Offsets as data and in pictures.

use std::io::{self, Write};

use hipline::{
    Figure, Region, Skeleton,
    input::Source,
    offset::{Offset, OffsetLoop},
};
use hipline_io::{
    FeatureName,
    write::{OffsetLine, Picture, Window},
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
        OutputFormat::Geojson => target.write(|w| geojson(w, computed, args.edges)),
        OutputFormat::Wkt => target.write(|w| wkt(w, computed)),
        _ => target.picture(&picture(computed, args), args.look.size.size),
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
    if !args.look.skeleton
        && let Some(window) = Window::around(seen(computed))
    {
        picture.window(window.enlarged(MARGIN));
    }
    picture.layers(args.look.layers());
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

/// The polygons of an offset: what remains of an interior; elsewhere the figure grown. Rings with the
/// faces that their edges lie in, shells first.
fn polygons(region: Region, offset: &Offset) -> Vec<Vec<OffsetLoop>> {
    if region == Region::Interior {
        offset.rings().collect()
    } else {
        offset.swept_rings().collect()
    }
}

/// One feature a distance.
fn geojson(w: &mut dyn Write, computed: &[Computed<Offsets>], with_edges: bool) -> io::Result<()> {
    w.write_all(b"{\"type\":\"FeatureCollection\",\"features\":[")?;
    let mut lead = "\n";
    for one in computed {
        let Ok(Offsets { skeleton, offsets }) = &one.result else {
            continue;
        };
        let id = one.name.id.as_ref().map_or_else(String::new, |id| {
            format!(",\"source_id\":{}", serde_json::Value::from(id.as_str()))
        });
        for offset in offsets {
            let polygons = polygons(skeleton.region(), offset);
            if polygons.is_empty() {
                continue;
            }
            write!(
                w,
                "{lead}{{\"type\":\"Feature\",\"properties\":{{\"distance\":{:?},\"source\":{}{id}",
                offset.distance(),
                one.name.index
            )?;
            lead = ",\n";
            if let Some(figure) = one.figure.as_ref().filter(|_| with_edges) {
                w.write_all(b",\"edges\":")?;
                nested(w, &polygons, |w, ring| edges(w, ring, skeleton, figure))?;
            }
            w.write_all(b"},\"geometry\":{\"type\":\"MultiPolygon\",\"coordinates\":")?;
            nested(w, &polygons, |w, ring| json_ring(w, ring.points()))?;
            w.write_all(b"}}")?;
        }
    }
    w.write_all(b"\n]}\n")
}

/// Lists of lists, as the rings of the polygons are.
fn nested(
    w: &mut dyn Write,
    polygons: &[Vec<OffsetLoop>],
    mut write: impl FnMut(&mut dyn Write, &OffsetLoop) -> io::Result<()>,
) -> io::Result<()> {
    w.write_all(b"[")?;
    for (i, rings) in polygons.iter().enumerate() {
        w.write_all(if i == 0 { b"[" } else { b",[" })?;
        for (k, ring) in rings.iter().enumerate() {
            w.write_all(if k == 0 { b"" } else { b"," })?;
            write(w, ring)?;
        }
        w.write_all(b"]")?;
    }
    w.write_all(b"]")
}

/// The input edge of each of a ring's edges: the part, ring and edge of the caller's numbering.
fn edges(
    w: &mut dyn Write,
    ring: &OffsetLoop,
    skeleton: &Skeleton,
    figure: &Figure,
) -> io::Result<()> {
    w.write_all(b"[")?;
    for (i, edge) in ring.edges(skeleton).enumerate() {
        let Source { part, ring, edge } = figure.edges()[edge.index()].source;
        let comma = if i == 0 { "" } else { "," };
        write!(w, "{comma}[{part},{ring},{edge}]")?;
    }
    w.write_all(b"]")
}

fn wkt(w: &mut dyn Write, computed: &[Computed<Offsets>]) -> io::Result<()> {
    for (_, Offsets { skeleton, offsets }) in successes(computed) {
        for offset in offsets {
            for rings in polygons(skeleton.region(), offset) {
                w.write_all(b"POLYGON Z (")?;
                for (i, ring) in rings.iter().enumerate() {
                    w.write_all(if i == 0 { b"" } else { b", " })?;
                    wkt_ring(w, ring.points(), offset.distance())?;
                }
                w.write_all(b")\n")?;
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
