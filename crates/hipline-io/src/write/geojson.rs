//! A skeleton as GeoJSON: nodes as points, arcs as lines, faces as polygons.

use std::io::{self, Write};

use hipline::{
    Skeleton,
    skeleton::NodeKind,
    topology::{FaceId, NodeId},
};

use super::{
    json::{arc_kind, side, string},
    number::Number,
    picture::OffsetLine,
    window::{Window, is_same, place, trace},
};
use crate::FeatureName;

/// Writes skeletons as one FeatureCollection, one feature a line. Properties say what each
/// feature is (`element`: node, arc or face) and name its neighbours; `source` and
/// `source_id` name the feature it was computed from. Unbounded arcs and faces are cut off
/// at the window around the skeleton's finite nodes, half as large again.
///
/// # Errors
/// Those of `w`.
pub fn geojson<'a>(
    mut w: impl Write,
    skeletons: impl IntoIterator<Item = (FeatureName, &'a Skeleton)>,
) -> io::Result<()> {
    let mut collection = Collection::new(&mut w)?;
    for (name, skeleton) in skeletons {
        one(&mut collection, &name, skeleton)?;
    }
    collection.finish()
}

/// Writes offset lines as one FeatureCollection of LineStrings with the property
/// `distance`; a closed line ends where it starts.
///
/// # Errors
/// Those of `w`.
pub fn lines_geojson<'a>(
    mut w: impl Write,
    lines: impl IntoIterator<Item = &'a OffsetLine>,
) -> io::Result<()> {
    let mut collection = Collection::new(&mut w)?;
    for line in lines {
        let w = collection.next()?;
        write!(
            w,
            "{{\"distance\":{}}},\"geometry\":{{\"type\":\"LineString\",\"coordinates\":",
            Number(line.distance)
        )?;
        chain(w, &line.points, line.is_closed)?;
        w.write_all(b"}}")?;
    }
    collection.finish()
}

pub(super) struct Collection<'w, W> {
    w: &'w mut W,
    is_first: bool,
}

impl<'w, W: Write> Collection<'w, W> {
    pub(super) fn new(w: &'w mut W) -> io::Result<Self> {
        w.write_all(b"{\"type\":\"FeatureCollection\",\"features\":[")?;
        Ok(Self { w, is_first: true })
    }

    /// Starts a feature; its properties are next.
    pub(super) fn next(&mut self) -> io::Result<&mut W> {
        self.w
            .write_all(if self.is_first { b"\n" } else { b",\n" })?;
        self.is_first = false;
        self.w.write_all(b"{\"type\":\"Feature\",\"properties\":")?;
        Ok(self.w)
    }

    pub(super) fn finish(self) -> io::Result<()> {
        self.w.write_all(b"\n]}\n")
    }
}

fn one<W: Write>(
    collection: &mut Collection<W>,
    name: &FeatureName,
    skeleton: &Skeleton,
) -> io::Result<()> {
    let Some(window) = Window::of(skeleton) else {
        return Ok(());
    };
    let id = name
        .id
        .as_ref()
        .map_or_else(String::new, |id| format!(",\"source_id\":{}", string(id)));
    let source = format!("\"source\":{}{id}", name.index);
    for (i, node) in skeleton.nodes().iter().enumerate() {
        let kind = match node.kind {
            NodeKind::Input(_) => "input",
            NodeKind::Event => "event",
            NodeKind::Infinite { .. } => continue,
        };
        let w = collection.next()?;
        write!(
            w,
            "{{\"element\":\"node\",{source},\"node\":{i},\"kind\":\"{kind}\",\"time\":{}}}",
            Number(node.time)
        )?;
        write!(
            w,
            ",\"geometry\":{{\"type\":\"Point\",\"coordinates\":[{},{}]}}}}",
            Number(node.x),
            Number(node.y)
        )?;
    }
    for (i, arc) in skeleton.arcs().iter().enumerate() {
        let Some([p, q]) = window.clip_arc(skeleton, arc) else {
            continue;
        };
        let ([a, b], [f, g]) = (arc.nodes.map(NodeId::index), arc.faces.map(FaceId::index));
        let [s, t] = arc.nodes.map(|n| Number(skeleton.node(n).time));
        let w = collection.next()?;
        write!(
            w,
            "{{\"element\":\"arc\",{source},\"arc\":{i},\"kind\":\"{}\",",
            arc_kind(arc.kind)
        )?;
        write!(
            w,
            "\"nodes\":[{a},{b}],\"faces\":[{f},{g}],\"times\":[{s},{t}]}}"
        )?;
        let [p, q] = [[p[0], p[1]], [q[0], q[1]]];
        if is_same(p, q) {
            // An arc that stands upright is a point of the map.
            write!(
                w,
                ",\"geometry\":{{\"type\":\"Point\",\"coordinates\":[{},{}]}}}}",
                Number(p[0]),
                Number(p[1])
            )?;
        } else {
            w.write_all(b",\"geometry\":{\"type\":\"LineString\",\"coordinates\":")?;
            chain(w, &[p, q], false)?;
            w.write_all(b"}}")?;
        }
    }
    for (i, face) in skeleton.faces().iter().enumerate() {
        let boundary = skeleton.boundary(FaceId::new(i));
        let is_bounded = boundary.iter().all(|&n| skeleton.node(n).time.is_finite());
        let outline = window.clip_face(skeleton, boundary);
        if outline.len() < 3 {
            continue;
        }
        let (edge, side) = (face.edge.index(), side(face.side));
        let w = collection.next()?;
        write!(
            w,
            "{{\"element\":\"face\",{source},\"face\":{i},\"edge\":{edge},\"side\":\"{side}\","
        )?;
        if face.phase > 0 {
            write!(w, "\"phase\":{},", face.phase)?;
        }
        write!(w, "\"bounded\":{is_bounded}}},\"geometry\":{{")?;
        if let Some([p, q]) = trace(&outline) {
            // A face that stands upright has no area on a map: it is the line below it.
            w.write_all(b"\"type\":\"LineString\",\"coordinates\":")?;
            chain(w, &[p, q], false)?;
            w.write_all(b"}}")?;
            continue;
        }
        w.write_all(b"\"type\":\"Polygon\",\"coordinates\":[")?;
        chain(w, &outline, true)?;
        for hole in skeleton.holes(FaceId::new(i)) {
            w.write_all(b",")?;
            chain(
                w,
                &hole
                    .iter()
                    .map(|&n| place(skeleton.node(n)))
                    .collect::<Vec<_>>(),
                true,
            )?;
        }
        w.write_all(b"]}}")?;
    }
    Ok(())
}

pub(super) fn chain(w: &mut impl Write, points: &[[f64; 2]], close: bool) -> io::Result<()> {
    w.write_all(b"[")?;
    for (i, [x, y]) in points
        .iter()
        .chain(points.first().filter(|_| close))
        .enumerate()
    {
        write!(
            w,
            "{}[{},{}]",
            if i == 0 { "" } else { "," },
            Number(*x),
            Number(*y)
        )?;
    }
    w.write_all(b"]")
}
