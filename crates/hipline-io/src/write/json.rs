//! The full result as JSON, in the form that `docs/skeleton-json.md` describes. Written
//! element by element; no tree of the whole is ever in memory.

use std::io::{self, Write};

use hipline::{
    Region, Skeleton,
    skeleton::{ArcKind, NodeKind, Side, Stats},
    topology::{FaceId, NodeId},
};

use super::number::Number;
use crate::FeatureName;

/// Writes one skeleton; [`read_skeleton`](crate::read_skeleton) reads it back.
///
/// # Complexity
/// Linear; the memory does not depend on the size. `w` should be buffered.
///
/// # Errors
/// Those of `w`.
pub fn json(mut w: impl Write, skeleton: &Skeleton) -> io::Result<()> {
    object(&mut w, skeleton)?;
    w.write_all(b"\n")
}

/// Writes the results of several features, one after the other, as they come.
///
/// ```
/// use hipline_io::{FeatureName, write::ResultsJson};
///
/// let mut results = ResultsJson::new(Vec::new())?;
/// let name = FeatureName { index: 0, id: Some("yard".to_owned()) };
/// results.push(&name, Err("edges 1 and 3 cross"))?;
/// let text = String::from_utf8(results.finish()?)?;
/// assert!(text.contains(r#"{"index":0,"id":"yard","error":"edges 1 and 3 cross"}"#));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug)]
pub struct ResultsJson<W: Write> {
    w: W,
    is_first: bool,
}

impl<W: Write> ResultsJson<W> {
    /// Starts the file.
    ///
    /// # Errors
    /// Those of `w`.
    pub fn new(mut w: W) -> io::Result<Self> {
        w.write_all(b"{\"format\":\"hipline-skeletons\",\"version\":1,\"results\":[")?;
        Ok(Self { w, is_first: true })
    }

    /// Adds a feature's skeleton, or the text of the error that stands in its place.
    ///
    /// # Errors
    /// Those of `w`.
    pub fn push(
        &mut self,
        feature: &FeatureName,
        result: Result<&Skeleton, &str>,
    ) -> io::Result<()> {
        let w = &mut self.w;
        w.write_all(if self.is_first { b"\n" } else { b",\n" })?;
        self.is_first = false;
        write!(w, "{{\"index\":{}", feature.index)?;
        if let Some(id) = &feature.id {
            write!(w, ",\"id\":{}", string(id))?;
        }
        match result {
            Ok(skeleton) => {
                w.write_all(b",\"skeleton\":")?;
                object(w, skeleton)?;
            }
            Err(error) => write!(w, ",\"error\":{}", string(error))?,
        }
        w.write_all(b"}")
    }

    /// Ends the file.
    ///
    /// # Errors
    /// Those of the writer, which is given back.
    pub fn finish(mut self) -> io::Result<W> {
        self.w.write_all(b"\n]}\n")?;
        self.w.flush()?;
        Ok(self.w)
    }
}

/// A string with the quotes and escapes of JSON.
pub(super) fn string(text: &str) -> serde_json::Value {
    serde_json::Value::from(text)
}

fn object(w: &mut impl Write, skeleton: &Skeleton) -> io::Result<()> {
    let region = match skeleton.region() {
        Region::Interior => "interior",
        Region::Exterior => "exterior",
        Region::Both | Region::Auto => "both",
    };
    write!(
        w,
        "{{\"format\":\"hipline-skeleton\",\"version\":1,\"region\":\"{region}\",\n\"nodes\":["
    )?;
    list(w, skeleton.nodes(), |w, _, node| {
        write!(
            w,
            "{{\"x\":{},\"y\":{},\"time\":{}",
            Number(node.x),
            Number(node.y),
            Number(node.time)
        )?;
        match node.kind {
            NodeKind::Input(_) => w.write_all(b",\"kind\":\"input\"}"),
            NodeKind::Event => w.write_all(b",\"kind\":\"event\"}"),
            NodeKind::Infinite { direction: [x, y] } => {
                write!(
                    w,
                    ",\"kind\":\"infinite\",\"direction\":[{},{}]}}",
                    Number(x),
                    Number(y)
                )
            }
        }
    })?;
    w.write_all(b",\n\"arcs\":[")?;
    list(w, skeleton.arcs(), |w, _, arc| {
        let ([i, j], [f, g]) = (arc.nodes.map(NodeId::index), arc.faces.map(FaceId::index));
        write!(
            w,
            "{{\"nodes\":[{i},{j}],\"faces\":[{f},{g}],\"kind\":\"{}\"}}",
            arc_kind(arc.kind)
        )
    })?;
    w.write_all(b",\n\"faces\":[")?;
    list(w, skeleton.faces(), |w, i, face| {
        let id = FaceId::new(i);
        write!(
            w,
            "{{\"edge\":{},\"side\":\"{}\",",
            face.edge.index(),
            side(face.side)
        )?;
        if face.phase > 0 {
            write!(w, "\"phase\":{},", face.phase)?;
        }
        w.write_all(b"\"nodes\":")?;
        cycle(w, skeleton.boundary(id))?;
        for (k, hole) in skeleton.holes(id).enumerate() {
            w.write_all(if k == 0 { b",\"holes\":[" } else { b"," })?;
            cycle(w, hole)?;
        }
        w.write_all(if skeleton.holes(id).next().is_some() {
            b"]}"
        } else {
            b"}"
        })
    })?;
    let input = skeleton.input();
    write!(
        w,
        ",\n\"input\":{{\"vertices\":{},\"terminals\":{},\"edges\":[",
        input.vertices, input.terminals
    )?;
    list(w, &input.edges, |w, _, [i, j]| {
        write!(w, "[{},{}]", i.index(), j.index())
    })?;
    w.write_all(b"},\n")?;
    let Stats {
        edge_events,
        split_events,
        flips,
        steps,
        by_f64,
        by_double_double,
        by_wide,
        by_exact,
    } = skeleton.stats();
    write!(
        w,
        "\"stats\":{{\"edge_events\":{edge_events},\"split_events\":{split_events},\"flips\":{flips},\"steps\":{steps},\
         \"by_f64\":{by_f64},\"by_double_double\":{by_double_double},\"by_wide\":{by_wide},\"by_exact\":{by_exact}}}}}"
    )
}

/// The elements of a list, one a line, and the closing bracket.
fn list<W: Write, T>(
    w: &mut W,
    items: &[T],
    write: impl Fn(&mut W, usize, &T) -> io::Result<()>,
) -> io::Result<()> {
    for (i, item) in items.iter().enumerate() {
        w.write_all(if i == 0 { b"\n" } else { b",\n" })?;
        write(w, i, item)?;
    }
    w.write_all(b"]")
}

fn cycle(w: &mut impl Write, nodes: &[NodeId]) -> io::Result<()> {
    for (i, node) in nodes.iter().enumerate() {
        write!(w, "{}{}", if i == 0 { "[" } else { "," }, node.index())?;
    }
    w.write_all(if nodes.is_empty() { b"[]" } else { b"]" })
}

pub(super) const fn arc_kind(kind: ArcKind) -> &'static str {
    match kind {
        ArcKind::Ridge => "ridge",
        ArcKind::Valley => "valley",
        ArcKind::Ghost => "ghost",
        ArcKind::Crease => "crease",
    }
}

pub(super) const fn side(side: Side) -> &'static str {
    match side {
        Side::Left => "left",
        Side::Right => "right",
        Side::Start => "start",
        Side::End => "end",
    }
}
