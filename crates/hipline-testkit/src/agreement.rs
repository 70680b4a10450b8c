//! Arc for arc, bit for bit: does a skeleton agree with the reference?
//!
//! Node coordinates are correctly rounded on both sides, so equal results have equal bits, and
//! arcs can be compared as values: the names of their faces, their kind, their ends.

use std::collections::BTreeMap;
use std::fmt;

use hipline::skeleton::{ArcKind, NodeKind, Side};
use hipline::topology::{FaceId, NodeId, VertexId};
use hipline::{Figure, Skeleton};

use crate::reference::{RefKind, Reference};

/// An end of an arc, as bits that sort like the numbers.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct End {
    /// Time, x, y.
    bits: [i64; 3],
    /// The direction, of a node at infinity.
    direction: Option<[i64; 2]>,
}

impl End {
    /// An end from its numbers; there is only one zero.
    #[must_use]
    pub fn new(place: [f64; 2], time: f64, direction: Option<[f64; 2]>) -> Self {
        Self {
            bits: [time, place[0], place[1]].map(key),
            direction: direction.map(|v| v.map(key)),
        }
    }

    /// Where it is.
    #[must_use]
    pub fn place(&self) -> [f64; 2] {
        [self.bits[1], self.bits[2]].map(value)
    }

    /// When the wavefront gets there.
    #[must_use]
    pub fn time(&self) -> f64 {
        value(self.bits[0])
    }

    /// The direction, of a node at infinity.
    #[must_use]
    pub fn direction(&self) -> Option<[f64; 2]> {
        self.direction.map(|v| v.map(value))
    }
}

/// Orders like `f64::total_cmp`, with one zero only.
fn key(x: f64) -> i64 {
    let bits = (x + 0.0).to_bits() as i64;
    bits ^ ((bits >> 63) as u64 >> 1) as i64
}

fn value(key: i64) -> f64 {
    f64::from_bits((key ^ ((key >> 63) as u64 >> 1) as i64) as u64)
}

/// What a face is called: edge, side and phase. (Of later phases, several may have one name.)
pub type FaceName = (usize, Side, u32);

/// An arc as a value; the order of its faces goes with that of its ends.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Drawn {
    /// Its ends, ordered by time, then place.
    pub ends: [End; 2],
    /// The faces on its left and right, seen from the first end.
    pub faces: [FaceName; 2],
    /// 0 for a ridge, 1 for a valley, 2 for a ghost, 3 for a crease.
    kind: u8,
}

impl Drawn {
    /// An arc from its parts.
    #[must_use]
    pub fn new(mut ends: [End; 2], mut faces: [FaceName; 2], kind: ArcKind) -> Self {
        // Ends that round to one place leave the faces alone to go by.
        if ends[0] > ends[1] || ends[0] == ends[1] && faces[0] > faces[1] {
            ends.reverse();
            faces.reverse();
        }
        let kind = match kind {
            ArcKind::Ridge => 0,
            ArcKind::Valley => 1,
            ArcKind::Ghost => 2,
            ArcKind::Crease => 3,
        };
        Self { ends, faces, kind }
    }

    /// The same arc with other ends.
    #[must_use]
    pub fn with_ends(&self, ends: [End; 2]) -> Self {
        Self::new(ends, self.faces, self.kind())
    }

    /// What it is.
    #[must_use]
    pub const fn kind(&self) -> ArcKind {
        match self.kind {
            0 => ArcKind::Ridge,
            1 => ArcKind::Valley,
            2 => ArcKind::Ghost,
            _ => ArcKind::Crease,
        }
    }
}

impl fmt::Display for Drawn {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [[left, from], [right, to]] =
            [0, 1].map(|k| [face_text(self.faces[k]), end_text(&self.ends[k])]);
        write!(f, "{:?} {left} | {right}: {from} -> {to}", self.kind())
    }
}

/// `e3 Left`, `e3 Left'` in phase 1, and so on.
fn face_text((edge, side, phase): FaceName) -> String {
    format!("e{edge} {side:?}{}", "'".repeat(phase as usize))
}

fn end_text(end: &End) -> String {
    let [x, y] = end.place();
    end.direction().map_or_else(
        || format!("({x} {y}) t={}", end.time()),
        |v| format!("infinity along {v:?}"),
    )
}

/// The arcs of a skeleton, sorted.
#[must_use]
pub fn drawn(skeleton: &Skeleton) -> Vec<Drawn> {
    let mut drawn: Vec<Drawn> = all_drawn(skeleton).collect();
    drawn.sort_unstable();
    drawn
}

/// The arcs of a skeleton, in its order.
fn all_drawn(skeleton: &Skeleton) -> impl Iterator<Item = Drawn> {
    let face = |id: FaceId| {
        let face = skeleton.face(id);
        (face.edge.index(), face.side, face.phase)
    };
    let end = |id: NodeId| {
        let node = skeleton.node(id);
        let direction = if let NodeKind::Infinite { direction } = node.kind {
            Some(direction)
        } else {
            None
        };
        End::new([node.x, node.y], node.time, direction)
    };
    let arcs = skeleton.arcs().iter();
    arcs.map(move |arc| Drawn::new(arc.nodes.map(end), arc.faces.map(face), arc.kind))
}

/// The arcs of a reference, sorted.
#[must_use]
pub fn drawn_reference(reference: &Reference) -> Vec<Drawn> {
    let mut drawn: Vec<Drawn> = all_drawn_reference(reference).collect();
    drawn.sort_unstable();
    drawn
}

/// The arcs of a reference, in its order.
fn all_drawn_reference(reference: &Reference) -> impl Iterator<Item = Drawn> {
    let end = |n: usize| {
        let node = &reference.nodes[n];
        let direction = if let RefKind::Infinite(direction) = node.kind {
            Some(direction)
        } else {
            None
        };
        End::new(node.place, node.time, direction)
    };
    let arcs = reference.arcs.iter();
    arcs.map(move |arc| {
        Drawn::new(
            arc.nodes.map(end),
            arc.faces.map(|face| reference.faces[face]),
            arc.kind,
        )
    })
}

/// Each face of a later phase: its name and the arcs around it, sorted.
fn later_faces(
    names: impl Iterator<Item = FaceName>,
    arcs: impl Iterator<Item = ([usize; 2], Drawn)>,
) -> Vec<(FaceName, Vec<Drawn>)> {
    let mut faces: Vec<(FaceName, Vec<Drawn>)> = names.map(|name| (name, Vec::new())).collect();
    for (beside, arc) in arcs {
        for face in beside {
            faces[face].1.push(arc);
        }
    }
    faces.retain(|((.., phase), _)| *phase > 0);
    for (_, arcs) in &mut faces {
        arcs.sort_unstable();
    }
    faces.sort_unstable();
    faces
}

/// Later faces that only one of the two has; several faces may have one name, so arcs alone do not tell
/// how they are distributed.
fn faces_differ(skeleton: &Skeleton, reference: &Reference) -> Option<String> {
    let names = skeleton.faces().iter();
    let names = names.map(|face| (face.edge.index(), face.side, face.phase));
    let beside = skeleton
        .arcs()
        .iter()
        .map(|arc| arc.faces.map(FaceId::index));
    let ours = later_faces(names, beside.zip(all_drawn(skeleton)));
    let beside = reference.arcs.iter().map(|arc| arc.faces);
    let arcs = beside.zip(all_drawn_reference(reference));
    let mut due = later_faces(reference.faces.iter().copied(), arcs);
    // Facets that were overtaken the moment they started.
    due.retain(|(_, arcs)| !arcs.is_empty());
    if ours == due {
        return None;
    }
    let text = |faces: &[(FaceName, Vec<Drawn>)]| {
        let each = faces
            .iter()
            .map(|(name, arcs)| format!("{} ({} arcs)", face_text(*name), arcs.len()));
        each.collect::<Vec<_>>().join(", ")
    };
    Some(format!(
        "later faces {} instead of {}",
        text(&ours),
        text(&due)
    ))
}

/// How a skeleton differs from the reference.
#[derive(Debug, Clone, PartialEq)]
pub struct Difference {
    /// The input, edge by edge, as WKT.
    pub input: String,
    /// Arcs of the reference that the skeleton lacks.
    pub missing: Vec<Drawn>,
    /// Arcs of the skeleton that the reference lacks.
    pub extra: Vec<Drawn>,
    /// Anything else.
    pub other: Vec<String>,
}

impl fmt::Display for Difference {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(f, "{}", self.input)?;
        self.missing
            .iter()
            .try_for_each(|arc| writeln!(f, "missing {arc}"))?;
        self.extra
            .iter()
            .try_for_each(|arc| writeln!(f, "extra   {arc}"))?;
        self.other.iter().try_for_each(|text| writeln!(f, "{text}"))
    }
}

impl std::error::Error for Difference {}

/// Compares a skeleton with the reference for the same figure and region.
///
/// # Errors
/// All differences, if there are any: arcs, how they are distributed over faces of later phases, numbers
/// of nodes, and boundaries of the skeleton's faces that do not consist of its arcs.
pub fn compare(
    figure: &Figure,
    skeleton: &Skeleton,
    reference: &Reference,
) -> Result<(), Box<Difference>> {
    let mut balance: BTreeMap<Drawn, i32> = BTreeMap::new();
    for arc in drawn_reference(reference) {
        *balance.entry(arc).or_default() += 1;
    }
    for arc in drawn(skeleton) {
        *balance.entry(arc).or_default() -= 1;
    }
    let of = |sign: i32| {
        balance
            .iter()
            .filter(move |(_, by)| by.signum() == sign)
            .map(|(arc, _)| *arc)
            .collect()
    };
    let (missing, extra): (Vec<Drawn>, Vec<Drawn>) = (of(1), of(-1));
    let mut other = boundaries(skeleton);
    if missing.is_empty() && extra.is_empty() {
        other.extend(faces_differ(skeleton, reference));
    }
    // On either side of an edge that stands still, for a while or for ever, something may happen at one place and time:
    // whether that is one node or two is nobody's business.
    let changes = figure.changes().iter().map(|change| change.speed);
    let mut speeds = figure
        .edges()
        .iter()
        .flat_map(|edge| edge.speeds)
        .chain(changes);
    let walls = speeds.any(|speed| key(speed) == 0) || heights(figure).next().is_some();
    if !walls && skeleton.nodes().len() != reference.nodes.len() {
        other.push(format!(
            "{} nodes instead of {}",
            skeleton.nodes().len(),
            reference.nodes.len()
        ));
    }
    if missing.is_empty() && extra.is_empty() && other.is_empty() {
        return Ok(());
    }
    Err(Box::new(Difference {
        input: wkt(figure),
        missing,
        extra,
        other,
    }))
}

/// The vertices with heights other than zero.
fn heights(figure: &Figure) -> impl Iterator<Item = (VertexId, f64)> + '_ {
    let all = (0..figure.vertices().len()).map(VertexId::new);
    all.map(|v| (v, figure.height(v)))
        .filter(|&(_, height)| height > 0.0)
}

/// A figure as WKT, with heights and with speeds where they are not all 1.
#[must_use]
pub fn wkt(figure: &Figure) -> String {
    let point = |v: VertexId| {
        let [x, y] = figure.vertices()[v.index()];
        format!("{x} {y}")
    };
    let lines: Vec<String> = figure
        .edges()
        .iter()
        .map(|edge| format!("({}, {})", point(edge.from), point(edge.to)))
        .collect();
    let mut text = format!("MULTILINESTRING ({})", lines.join(", "));
    let plain = figure.edges().iter().all(|edge| {
        edge.speeds
            .iter()
            .all(|speed| speed.total_cmp(&1.0).is_eq())
    });
    if !plain {
        let speeds: Vec<String> = figure
            .edges()
            .iter()
            .map(|edge| format!("{} {}", edge.speeds[0], edge.speeds[1]))
            .collect();
        text += &format!("\nspeeds, left and right: {}", speeds.join(", "));
    }
    for (v, height) in heights(figure) {
        text += &format!("\nheight of {}: {height}", point(v));
    }
    for change in figure.changes() {
        let side = if change.right { "right" } else { "left" };
        text += &format!(
            "\ne{} {side}: {} from {} on",
            change.edge.index(),
            change.speed,
            change.time
        );
    }
    text
}

/// What is wrong with the boundaries of the faces: each must consist of the arcs beside the face,
/// the input edge, and a step between two nodes at infinity; the face on the left.
fn boundaries(skeleton: &Skeleton) -> Vec<String> {
    let mut flaws = Vec::new();
    let mut due: Vec<BTreeMap<(NodeId, NodeId), i32>> =
        vec![BTreeMap::new(); skeleton.faces().len()];
    for arc in skeleton.arcs() {
        let [a, b] = arc.nodes;
        *due[arc.faces[0].index()].entry((a, b)).or_default() += 1;
        *due[arc.faces[1].index()].entry((b, a)).or_default() += 1;
    }
    for (f, face) in skeleton.faces().iter().enumerate() {
        let id = FaceId::new(f);
        let [p, q] =
            skeleton.input().edges[face.edge.index()].map(|vertex| NodeId::new(vertex.index()));
        let due = &mut due[f];
        match face.side {
            // Later faces start at creases, which are arcs.
            _ if face.phase > 0 => {}
            Side::Left => *due.entry((p, q)).or_default() += 1,
            Side::Right => *due.entry((q, p)).or_default() += 1,
            Side::Start | Side::End => {}
        }
        let is_finite = |n: NodeId| skeleton.node(n).time.is_finite();
        for cycle in std::iter::once(skeleton.boundary(id)).chain(skeleton.holes(id)) {
            for (i, &a) in cycle.iter().enumerate() {
                let b = cycle[(i + 1) % cycle.len()];
                if is_finite(a) || is_finite(b) {
                    *due.entry((a, b)).or_default() -= 1;
                }
            }
        }
        for ((a, b), by) in due.iter().filter(|(_, by)| **by != 0) {
            let verb = if *by > 0 { "lacks" } else { "has a needless" };
            flaws.push(format!(
                "the boundary of {id} (e{} {:?}) {verb} step {a} -> {b}",
                face.edge.index(),
                face.side
            ));
        }
    }
    flaws
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn keys_sort_like_numbers_and_give_them_back() {
        let numbers = [
            f64::NEG_INFINITY,
            -2.5,
            -1e-300,
            0.0,
            1e-300,
            0.1,
            7.0,
            f64::INFINITY,
        ];
        for pair in numbers.windows(2) {
            assert!(key(pair[0]) < key(pair[1]), "{pair:?}");
        }
        for x in numbers {
            assert_eq!(value(key(x)).to_bits(), x.to_bits(), "{x}");
        }
        assert_eq!(key(-0.0), key(0.0), "one zero");
    }

    #[test]
    fn an_arc_has_one_form_from_either_end() {
        let ends = [
            End::new([0.0, 1.0], 0.0, None),
            End::new([2.0, 1.0], 0.5, None),
        ];
        let faces = [(3, Side::Left, 0), (4, Side::End, 2)];
        let arc = Drawn::new(ends, faces, ArcKind::Valley);
        let turned = Drawn::new([ends[1], ends[0]], [faces[1], faces[0]], ArcKind::Valley);
        assert_eq!(arc, turned, "the same arc");
        assert_eq!(
            arc.to_string(),
            "Valley e3 Left | e4 End'': (0 1) t=0 -> (2 1) t=0.5",
            "its text"
        );
    }
}
