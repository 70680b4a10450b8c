//! `hipline draw`

use hipline::{
    Figure, Region, Skeleton,
    skeleton::{InputGraph, Node, NodeKind},
    topology::VertexId,
};
use hipline_io::{Shape, read_skeletons};

use super::skeleton::picture;
use crate::{
    args::{
        DrawArgs,
        OutputFormat::{Png, Svg},
    },
    failure::{Failure, Outcome, report, warn},
    input::{self, Item},
    output,
};

pub fn run(args: &DrawArgs) -> Result<Outcome, Failure> {
    let targets = output::targets(&args.output, Svg, &[Svg, Png])?;
    super::warn_of_labels(args.picture.labels, &targets);
    let bytes = input::bytes(&args.input.path)?;
    let mut outcome = Outcome::Done;
    let mut skeletons = Vec::new();
    if args.input.from.is_none() && is_result(&bytes) {
        let records = read_skeletons(&bytes)
            .map_err(|e| Failure::Input(format!("{}: {e}", input::name(&args.input.path))))?;
        for record in records {
            match record.result {
                Ok(skeleton) => skeletons.push(skeleton),
                Err(error) => {
                    report(format_args!("result {}: {error}", record.index));
                    outcome = Outcome::Flawed;
                }
            }
        }
    } else {
        let document = input::parse(&args.input, &args.gables, &bytes)?;
        for item in Item::all(&document, args.input.together) {
            match item.figure() {
                Ok(figure) => skeletons.push(of_figure(&figure)),
                Err(error) if error.is_empty_geometry() => {}
                Err(error) => {
                    // Flaws are easier to find in a picture.
                    warn(format_args!("{error}; drawn as it is"));
                    skeletons.push(match item {
                        Item::Feature(feature, _) => of_shapes([&feature.case]),
                        Item::Together(all) => of_shapes(all.features.iter().map(|f| &f.case)),
                    });
                }
            }
        }
    }
    if outcome == Outcome::Flawed && skeletons.is_empty() {
        return Ok(outcome);
    }
    let mut picture = picture(skeletons.iter());
    picture.layers(args.picture.layers());
    for target in &targets {
        target.picture(&picture, args.picture.size.size)?;
    }
    Ok(outcome)
}

/// Whether a file holds skeletons, and not features. The format is the first member that
/// hipline writes; of others' files, the first few are looked at.
fn is_result(bytes: &[u8]) -> bool {
    const LOOKED_AT: usize = 4096;
    let start = &bytes[..bytes.len().min(LOOKED_AT)];
    let wanted = b"\"hipline-skeleton";
    start.trim_ascii_start().starts_with(b"{")
        && start.windows(wanted.len()).any(|window| window == wanted)
}

fn of_figure(figure: &Figure) -> Skeleton {
    let edges = figure
        .edges()
        .iter()
        .map(|e| [e.from, e.to].map(VertexId::index));
    bare(figure.vertices(), &edges.collect::<Vec<_>>())
}

/// Whatever the shapes are, flaws and all.
fn of_shapes<'a>(shapes: impl IntoIterator<Item = &'a Shape>) -> Skeleton {
    let (mut vertices, mut edges) = (Vec::new(), Vec::new());
    for shape in shapes {
        add(shape, &mut vertices, &mut edges);
    }
    bare(&vertices, &edges)
}

fn add(shape: &Shape, vertices: &mut Vec<[f64; 2]>, edges: &mut Vec<[usize; 2]>) {
    let mut chain = |points: &[[f64; 2]], is_ring: bool| {
        let first = vertices.len();
        vertices.extend(points);
        edges.extend((first + 1..vertices.len()).map(|v| [v - 1, v]));
        if is_ring && points.len() > 1 {
            edges.push([vertices.len() - 1, first]);
        }
    };
    match shape {
        Shape::Polygons(polygons) => {
            for ring in polygons.iter().flat_map(|p| &p.rings) {
                chain(ring, true);
            }
        }
        Shape::Lines(lines) => {
            for line in lines {
                chain(&line.points, false);
            }
        }
        Shape::Graph(graph) => {
            let first = vertices.len();
            let count = graph.vertices.len();
            vertices.extend(&graph.vertices);
            let ends = graph.edges.iter().filter(|e| e.iter().all(|v| *v < count));
            edges.extend(ends.map(|e| e.map(|v| first + v)));
        }
        Shape::Collection(shapes) => {
            for shape in shapes {
                add(shape, vertices, edges);
            }
        }
        Shape::Empty | Shape::Points(_) => {}
    }
}

/// A skeleton without arcs and faces: a graph.
fn bare(vertices: &[[f64; 2]], edges: &[[usize; 2]]) -> Skeleton {
    let node = |(i, &[x, y]): (usize, &[f64; 2])| Node {
        x,
        y,
        time: 0.0,
        kind: NodeKind::Input(VertexId::new(i)),
    };
    let input = InputGraph {
        vertices: vertices.len(),
        edges: edges.iter().map(|e| e.map(VertexId::new)).collect(),
        terminals: 0,
    };
    let nodes = vertices.iter().enumerate().map(node).collect();
    Skeleton::from_parts(nodes, vec![], vec![], input, Region::Both)
        .expect("every edge ends at a vertex")
}
