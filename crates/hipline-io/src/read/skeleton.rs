//! A skeleton from the JSON that [`write::json`](crate::write::json) makes of it.

use hipline::{
    Region, Skeleton,
    skeleton::{Arc, ArcKind, InputGraph, Node, NodeKind, Side},
    topology::{EdgeId, FaceId, NodeId, VertexId},
};
use serde::Deserialize;

use crate::ReadError;

const NAME: &str = "skeleton JSON";

/// One result of a file with several.
#[derive(Debug, Clone, PartialEq)]
pub struct SkeletonRecord {
    /// The number of the feature in the file it was computed from.
    pub index: usize,
    /// The feature's id, if it has one.
    pub id: Option<String>,
    /// The skeleton, or why there is none.
    pub result: Result<Skeleton, String>,
}

/// Reads one skeleton back, bit for bit; only the counts of [`Skeleton::stats`] are not
/// restored.
///
/// # Errors
/// What is no JSON, or not of the form that `docs/skeleton-json.md` describes, or refers to
/// a node, face or edge that is not there.
pub fn read_skeleton(bytes: &[u8]) -> Result<Skeleton, ReadError> {
    let mut records = read_skeletons(bytes)?;
    match records.pop() {
        Some(record) if records.is_empty() => record.result.map_err(content),
        _ => Err(content(format!(
            "there are {} results, not one",
            records.len() + 1
        ))),
    }
}

/// Reads the results of several features, or the one skeleton that there is.
///
/// # Errors
/// See [`read_skeleton`].
pub fn read_skeletons(bytes: &[u8]) -> Result<Vec<SkeletonRecord>, ReadError> {
    let file: File = serde_json::from_slice(bytes).map_err(|e| super::json_error(NAME, &e))?;
    if file.version != Some(1) {
        return Err(content("\"version\" is not 1".to_owned()));
    }
    match (file.format.as_deref(), file.results) {
        (Some("hipline-skeleton"), None) => {
            let wire: Wire =
                serde_json::from_slice(bytes).map_err(|e| super::json_error(NAME, &e))?;
            Ok(vec![SkeletonRecord {
                index: 0,
                id: None,
                result: Ok(wire.skeleton().map_err(content)?),
            }])
        }
        (Some("hipline-skeletons"), Some(results)) => {
            results.into_iter().map(WireRecord::record).collect()
        }
        _ => Err(content(
            "\"format\" is neither hipline-skeleton nor hipline-skeletons with \"results\""
                .to_owned(),
        )),
    }
}

fn content(message: String) -> ReadError {
    ReadError::Content {
        format: NAME,
        message,
    }
}

#[derive(Deserialize)]
struct File {
    format: Option<String>,
    version: Option<u32>,
    results: Option<Vec<WireRecord>>,
}

#[derive(Deserialize)]
struct WireRecord {
    index: usize,
    id: Option<String>,
    skeleton: Option<Wire>,
    error: Option<String>,
}

impl WireRecord {
    fn record(self) -> Result<SkeletonRecord, ReadError> {
        let Self {
            index,
            id,
            skeleton,
            error,
        } = self;
        let result = match (skeleton, error) {
            (Some(wire), None) => Ok(wire
                .skeleton()
                .map_err(|e| content(format!("result {index}: {e}")))?),
            (None, Some(error)) => Err(error),
            _ => {
                return Err(content(format!(
                    "result {index} needs either a \"skeleton\" or an \"error\""
                )));
            }
        };
        Ok(SkeletonRecord { index, id, result })
    }
}

#[derive(Deserialize)]
struct Wire {
    region: WireRegion,
    nodes: Vec<WireNode>,
    arcs: Vec<WireArc>,
    faces: Vec<WireFace>,
    input: WireInput,
}

#[derive(Deserialize)]
#[serde(rename_all = "lowercase")]
enum WireRegion {
    Interior,
    Exterior,
    Both,
}

#[derive(Deserialize)]
#[serde(rename_all = "lowercase")]
enum WireNodeKind {
    Input,
    Event,
    Infinite,
}

#[derive(Deserialize)]
struct WireNode {
    x: f64,
    y: f64,
    time: Option<f64>,
    kind: WireNodeKind,
    direction: Option<[f64; 2]>,
}

#[derive(Deserialize)]
#[serde(rename_all = "lowercase")]
enum WireArcKind {
    Ridge,
    Valley,
    Ghost,
    Crease,
}

#[derive(Deserialize)]
struct WireArc {
    nodes: [u32; 2],
    faces: [u32; 2],
    kind: WireArcKind,
}

#[derive(Deserialize)]
#[serde(rename_all = "lowercase")]
enum WireSide {
    Left,
    Right,
    Start,
    End,
}

#[derive(Deserialize)]
struct WireFace {
    edge: u32,
    side: WireSide,
    #[serde(default)]
    phase: u32,
    nodes: Vec<u32>,
    #[serde(default)]
    holes: Vec<Vec<u32>>,
}

#[derive(Deserialize)]
struct WireInput {
    vertices: u32,
    edges: Vec<[u32; 2]>,
    terminals: u32,
}

impl Wire {
    fn skeleton(self) -> Result<Skeleton, String> {
        let nodes = self
            .nodes
            .into_iter()
            .enumerate()
            .map(|(i, n)| n.node(i))
            .collect::<Result<_, _>>()?;
        let arcs = self.arcs.into_iter().map(|a| Arc {
            nodes: a.nodes.map(|n| NodeId::new(n as usize)),
            faces: a.faces.map(|f| FaceId::new(f as usize)),
            kind: match a.kind {
                WireArcKind::Ridge => ArcKind::Ridge,
                WireArcKind::Valley => ArcKind::Valley,
                WireArcKind::Ghost => ArcKind::Ghost,
                WireArcKind::Crease => ArcKind::Crease,
            },
        });
        let input = InputGraph {
            vertices: self.input.vertices as usize,
            edges: self
                .input
                .edges
                .into_iter()
                .map(|e| e.map(|v| VertexId::new(v as usize)))
                .collect(),
            terminals: self.input.terminals as usize,
        };
        let region = match self.region {
            WireRegion::Interior => Region::Interior,
            WireRegion::Exterior => Region::Exterior,
            WireRegion::Both => Region::Both,
        };
        let faces = self.faces.into_iter().map(WireFace::face).collect();
        Skeleton::from_parts(nodes, arcs.collect(), faces, input, region)
    }
}

impl WireNode {
    fn node(self, index: usize) -> Result<Node, String> {
        let Self {
            x,
            y,
            time,
            kind,
            direction,
        } = self;
        let kind = match (kind, direction) {
            (WireNodeKind::Input, None) => NodeKind::Input(VertexId::new(index)),
            (WireNodeKind::Event, None) => NodeKind::Event,
            (WireNodeKind::Infinite, Some(direction)) => NodeKind::Infinite { direction },
            _ => {
                return Err(format!(
                    "node {index}: infinite nodes have a \"direction\", others have none"
                ));
            }
        };
        let time = match (time, kind) {
            (None, NodeKind::Infinite { .. }) => f64::INFINITY,
            (Some(time), NodeKind::Input(_) | NodeKind::Event) => time,
            _ => {
                return Err(format!(
                    "node {index}: the \"time\" of infinite nodes is null, that of others is not"
                ));
            }
        };
        Ok(Node { x, y, time, kind })
    }
}

impl WireFace {
    fn face(self) -> (EdgeId, Side, u32, Vec<Vec<NodeId>>) {
        let side = match self.side {
            WireSide::Left => Side::Left,
            WireSide::Right => Side::Right,
            WireSide::Start => Side::Start,
            WireSide::End => Side::End,
        };
        let cycle = |cycle: Vec<u32>| cycle.into_iter().map(|n| NodeId::new(n as usize)).collect();
        let boundaries = std::iter::once(self.nodes)
            .chain(self.holes)
            .map(cycle)
            .collect();
        (
            EdgeId::new(self.edge as usize),
            side,
            self.phase,
            boundaries,
        )
    }
}
