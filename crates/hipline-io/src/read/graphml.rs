//! GraphML with the keys of the Salzburg programs (surfer2, monos, format-converter).
//!
//! A key is known by its `attr.name`: `vertex-coordinate-x`, `vertex-coordinate-y`,
//! `vertex-coordinate-z` (a height), `edge-weight` (it holds on both sides) and
//! `edge-weight-additive` (when the edge starts).
//! Nodes are named by any strings; every `graph` is one feature.

use std::collections::HashMap;

use quick_xml::{
    Reader, XmlVersion,
    events::{BytesStart, Event},
};
use serde_json::Map;

use super::text::{Text, short};
use crate::{
    Document, Feature, Format, ReadError,
    document::{GraphShape, Shape},
    motion::Motion,
};

pub(super) fn read(bytes: &[u8]) -> Result<Document, ReadError> {
    let text = Text::new(Format::GraphMl.name(), bytes)?;
    let mut reader = Reader::from_str(text.text);
    reader.config_mut().expand_empty_elements = true;
    let mut state = State::new(text);
    loop {
        state.at = usize::try_from(reader.buffer_position()).unwrap_or(usize::MAX);
        let event = reader.read_event().map_err(|e| {
            let at = usize::try_from(reader.error_position()).unwrap_or(usize::MAX);
            text.error(at, e.to_string())
        })?;
        match event {
            Event::Start(tag) | Event::Empty(tag) => state.open(&tag)?,
            Event::End(tag) => state.close(tag.local_name().into_inner())?,
            Event::Text(t) => state.buffer.push_str(&t.xml10_content()),
            Event::CData(t) => state.buffer.push_str(&t.xml10_content()),
            Event::GeneralRef(entity) => match entity.resolve_char_ref() {
                Ok(Some(c)) => state.buffer.push(c),
                _ => state.buffer.push('\u{fffd}'),
            },
            Event::Eof => break,
            Event::Decl(_) | Event::PI(_) | Event::DocType(_) | Event::Comment(_) => {}
        }
    }
    if state.depth > 0 {
        return Err(text.error(text.text.len(), "the file ends inside an element"));
    }
    if state.document.features.is_empty() {
        return Err(text.content("there is no <graph>"));
    }
    Ok(state.document)
}

/// What the reader has seen so far.
struct State<'a> {
    text: Text<'a>,
    /// Where the current tag starts.
    at: usize,
    /// Open elements.
    depth: usize,
    /// Key by its id.
    keys: HashMap<String, Key>,
    /// The key element that is open.
    key: Option<String>,
    /// The id of the key of the data element that is open, and where it starts.
    data: Option<(String, usize)>,
    buffer: String,
    graph: Option<Graph>,
    document: Document,
}

struct Key {
    name: String,
    default: Option<(String, usize)>,
}

#[derive(Default)]
struct Graph {
    id: Option<String>,
    names: HashMap<String, usize>,
    vertices: Vec<[f64; 2]>,
    z: Vec<Option<f64>>,
    edges: Vec<Edge>,
    node: Option<Node>,
    edge: Option<Edge>,
    weighted: bool,
}

struct Node {
    id: String,
    at: usize,
    place: [Option<f64>; 3],
}

struct Edge {
    ends: [String; 2],
    at: usize,
    weight: Option<f64>,
    additive: Option<f64>,
}

impl<'a> State<'a> {
    fn new(text: Text<'a>) -> Self {
        Self {
            text,
            at: 0,
            depth: 0,
            keys: HashMap::new(),
            key: None,
            data: None,
            buffer: String::new(),
            graph: None,
            document: Document::default(),
        }
    }

    fn fail<T>(&self, message: impl Into<String>) -> Result<T, ReadError> {
        Err(self.text.error(self.at, message))
    }

    fn attribute(&self, tag: &BytesStart, name: &str) -> Result<Option<String>, ReadError> {
        let wrong = |e: String| self.text.error(self.at, e);
        match tag
            .try_get_attribute(name)
            .map_err(|e| wrong(e.to_string()))?
        {
            None => Ok(None),
            Some(attribute) => match attribute.normalized_value(XmlVersion::Implicit1_0) {
                Ok(value) => Ok(Some(value.into_owned())),
                Err(e) => Err(wrong(e.to_string())),
            },
        }
    }

    fn required(&self, tag: &BytesStart, name: &str) -> Result<String, ReadError> {
        match self.attribute(tag, name)? {
            Some(value) => Ok(value),
            None => self.fail(format!(
                "<{}> without {name}",
                tag.local_name().into_inner()
            )),
        }
    }

    fn open(&mut self, tag: &BytesStart) -> Result<(), ReadError> {
        if self.depth == 0 && tag.local_name().into_inner() != "graphml" {
            return self.fail("the outermost element is not <graphml>");
        }
        self.depth += 1;
        let open_graph = self.graph.as_ref();
        match tag.local_name().into_inner() {
            // Programs put elements of their own inside data; none of them means anything here.
            _ if self.data.is_some() => {}
            "key" => {
                let id = self.required(tag, "id")?;
                let name = self.attribute(tag, "attr.name")?.unwrap_or_default();
                self.keys.insert(
                    id.clone(),
                    Key {
                        name,
                        default: None,
                    },
                );
                self.key = Some(id);
            }
            "default" | "data" => {
                self.buffer.clear();
                if tag.local_name().into_inner() == "data" {
                    self.data = Some((self.required(tag, "key")?, self.at));
                }
            }
            "graph" if open_graph.is_some() => return self.fail("a graph inside a graph"),
            "graph" => {
                self.graph = Some(Graph {
                    id: self.attribute(tag, "id")?,
                    ..Graph::default()
                })
            }
            "node" | "edge" if open_graph.is_none_or(|g| g.node.is_some() || g.edge.is_some()) => {
                return self.fail("nodes and edges belong directly into a <graph>");
            }
            "node" => {
                let node = Node {
                    id: self.required(tag, "id")?,
                    at: self.at,
                    place: [None; 3],
                };
                if let Some(graph) = &mut self.graph {
                    graph.node = Some(node);
                }
            }
            "edge" => {
                let ends = [self.required(tag, "source")?, self.required(tag, "target")?];
                if let Some(graph) = &mut self.graph {
                    graph.edge = Some(Edge {
                        ends,
                        at: self.at,
                        weight: None,
                        additive: None,
                    });
                }
            }
            "hyperedge" => return self.fail("hyperedges have no place in the plane"),
            _ => {}
        }
        Ok(())
    }

    fn close(&mut self, name: &str) -> Result<(), ReadError> {
        self.depth = self.depth.saturating_sub(1);
        match name {
            "data" => {
                if let Some((key, at)) = self.data.take() {
                    let name = self
                        .keys
                        .get(&key)
                        .map_or(key.as_str(), |k| &k.name)
                        .to_owned();
                    let value = std::mem::take(&mut self.buffer);
                    self.value(&name, at, value.trim())?;
                }
            }
            _ if self.data.is_some() => {}
            "default" => {
                if let Some(key) = self.key.as_ref().and_then(|id| self.keys.get_mut(id)) {
                    key.default = Some((self.buffer.trim().to_owned(), self.at));
                }
            }
            "key" => self.key = None,
            "node" => self.close_node()?,
            "edge" => self.close_edge()?,
            "graph" => self.close_graph()?,
            _ => {}
        }
        Ok(())
    }

    /// A value of the open node or edge.
    fn value(&mut self, name: &str, at: usize, value: &str) -> Result<(), ReadError> {
        let Some(graph) = &mut self.graph else {
            return Ok(());
        };
        let slot = match (name, &mut graph.node, &mut graph.edge) {
            ("vertex-coordinate-x", Some(node), _) => &mut node.place[0],
            ("vertex-coordinate-y", Some(node), _) => &mut node.place[1],
            ("vertex-coordinate-z", Some(node), _) => &mut node.place[2],
            ("edge-weight", _, Some(edge)) => &mut edge.weight,
            ("edge-weight-additive", _, Some(edge)) => &mut edge.additive,
            _ => return Ok(()),
        };
        *slot = Some(self.text.number(at, value)?);
        Ok(())
    }

    fn default_of(&self, name: &str) -> Result<Option<f64>, ReadError> {
        match self
            .keys
            .values()
            .find(|k| k.name == name)
            .and_then(|k| k.default.as_ref())
        {
            Some((value, at)) => self.text.number(*at, value).map(Some),
            None => Ok(None),
        }
    }

    fn close_node(&mut self) -> Result<(), ReadError> {
        let Some(Node { id, at, mut place }) = self.graph.as_mut().and_then(|g| g.node.take())
        else {
            return Ok(());
        };
        for (slot, name) in place.iter_mut().zip([
            "vertex-coordinate-x",
            "vertex-coordinate-y",
            "vertex-coordinate-z",
        ]) {
            if slot.is_none() {
                *slot = self.default_of(name)?;
            }
        }
        let [Some(x), Some(y), z] = place else {
            let axis = if place[0].is_none() { "x" } else { "y" };
            return Err(self.text.error(
                at,
                format!("node {} has no vertex-coordinate-{axis}", short(&id)),
            ));
        };
        if let Some(graph) = &mut self.graph {
            if graph.names.contains_key(&id) {
                return Err(self
                    .text
                    .error(at, format!("node {} is there twice", short(&id))));
            }
            graph.names.insert(id, graph.vertices.len());
            graph.vertices.push([x, y]);
            graph.z.push(z);
        }
        Ok(())
    }

    fn close_edge(&mut self) -> Result<(), ReadError> {
        let Some(mut edge) = self.graph.as_mut().and_then(|g| g.edge.take()) else {
            return Ok(());
        };
        edge.weight = edge
            .weight
            .map_or_else(|| self.default_of("edge-weight"), |w| Ok(Some(w)))?;
        edge.additive = edge
            .additive
            .map_or_else(|| self.default_of("edge-weight-additive"), |w| Ok(Some(w)))?;
        if let Some(start) = edge.additive.filter(|start| *start < 0.0) {
            let message =
                format!("no edge starts before the time 0 (edge-weight-additive is {start})");
            return Err(self.text.error(edge.at, message));
        }
        if let Some(graph) = &mut self.graph {
            graph.weighted |= edge.weight.is_some();
            graph.edges.push(edge);
        }
        Ok(())
    }

    fn close_graph(&mut self) -> Result<(), ReadError> {
        let Some(graph) = self.graph.take() else {
            return Ok(());
        };
        let end = |edge: &Edge, i: usize| {
            let name = &edge.ends[i];
            let at = edge.at;
            graph.names.get(name).copied().ok_or_else(|| {
                self.text.error(
                    at,
                    format!("an edge leads to node {}, but there is none", short(name)),
                )
            })
        };
        let edges = graph
            .edges
            .iter()
            .map(|e| Ok([end(e, 0)?, end(e, 1)?]))
            .collect::<Result<_, ReadError>>()?;
        let speeds = graph.weighted.then(|| {
            graph
                .edges
                .iter()
                .map(|e| [e.weight.unwrap_or(1.0); 2])
                .collect()
        });
        let mut motion = Motion::default();
        let start = |(i, edge): (usize, &Edge)| {
            let start = edge.additive.filter(|start| *start > 0.0)?;
            Some((i, [start; 2]))
        };
        motion.starts = graph.edges.iter().enumerate().filter_map(start).collect();
        if graph.z.iter().any(Option::is_some) {
            motion.z = graph.z;
        }
        let shape = Shape::Graph(GraphShape {
            vertices: graph.vertices,
            edges,
            speeds,
            motion,
        });
        let case = if shape.is_empty() {
            Shape::Empty
        } else {
            shape
        };
        let index = self.document.features.len();
        self.document.features.push(Feature {
            index,
            id: graph.id,
            properties: Map::new(),
            case,
        });
        Ok(())
    }
}

#[cfg(test)]
mod tests;
