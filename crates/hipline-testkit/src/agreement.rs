//! Arc for arc, bit for bit: does a skeleton agree with the reference?
//!
//! Node coordinates are correctly rounded on both sides, so equal results have equal bits, and
//! arcs can be compared as values: the names of their faces, their kind, their ends.

use std::collections::BTreeMap;
use std::fmt;

use hipline::skeleton::{ArcKind, NodeKind, Side};
use hipline::topology::{FaceId, NodeId};
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

/// An arc as a value; the order of its faces goes with that of its ends.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Drawn {
    /// Its ends, ordered by time, then place.
    pub ends: [End; 2],
    /// The faces (edge and side) on its left and right, seen from the first end.
    pub faces: [(usize, Side); 2],
    /// 0 for a ridge, 1 for a valley, 2 for a ghost, 3 for a crease.
    kind: u8,
}

impl Drawn {
    /// An arc from its parts.
    #[must_use]
    pub fn new(mut ends: [End; 2], mut faces: [(usize, Side); 2], kind: ArcKind) -> Self {
        if ends[0] > ends[1] {
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
        let [[left, from], [right, to]] = [0, 1].map(|k| {
            [
                format!("e{} {:?}", self.faces[k].0, self.faces[k].1),
                end_text(&self.ends[k]),
            ]
        });
        write!(f, "{:?} {left} | {right}: {from} -> {to}", self.kind())
    }
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
    let face = |id: FaceId| (skeleton.face(id).edge.index(), skeleton.face(id).side);
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
    let mut drawn: Vec<Drawn> = arcs
        .map(|arc| Drawn::new(arc.nodes.map(end), arc.faces.map(face), arc.kind))
        .collect();
    drawn.sort_unstable();
    drawn
}

/// The arcs of a reference, sorted.
#[must_use]
pub fn drawn_reference(reference: &Reference) -> Vec<Drawn> {
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
    let mut drawn: Vec<Drawn> = arcs
        .map(|arc| {
            Drawn::new(
                arc.nodes.map(end),
                arc.faces.map(|face| reference.faces[face]),
                arc.kind,
            )
        })
        .collect();
    drawn.sort_unstable();
    drawn
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
/// All differences, if there are any: arcs, numbers of nodes, and boundaries of the skeleton's
/// faces that do not consist of its arcs.
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
    if skeleton.nodes().len() != reference.nodes.len() {
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

/// A figure as WKT, with speeds where they are not all 1.
#[must_use]
pub fn wkt(figure: &Figure) -> String {
    let point = |v: hipline::topology::VertexId| {
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
        let faces = [(3, Side::Left), (4, Side::End)];
        let arc = Drawn::new(ends, faces, ArcKind::Valley);
        let turned = Drawn::new([ends[1], ends[0]], [faces[1], faces[0]], ArcKind::Valley);
        assert_eq!(arc, turned, "the same arc");
        assert_eq!(
            arc.to_string(),
            "Valley e3 Left | e4 End: (0 1) t=0 -> (2 1) t=0.5",
            "its text"
        );
    }
}
