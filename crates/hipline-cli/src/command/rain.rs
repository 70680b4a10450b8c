//! `hipline rain`

use std::io::{self, Write};

use hipline::{
    observe::{Catchment, Drop, Ending, Index, Systems, Terrain, Window},
    topology::{EdgeId, FaceId},
};
use hipline_io::write::{Relief, catchments_geojson, drops_geojson};

use super::{points, scene};
use crate::{
    args::{
        Drained,
        OutputFormat::{self, Csv, Geojson, Png, Svg, Tsv},
        RainArgs,
    },
    failure::{Failure, Outcome, report},
    output::{self, Target, picture_error},
};
use scene::Scene;

const FORMATS: [OutputFormat; 5] = [Geojson, Csv, Tsv, Svg, Png];

pub fn run(args: &RainArgs) -> Result<Outcome, Failure> {
    let targets = output::targets(&args.output, Geojson, &FORMATS)?;
    let points = points::all(&args.points)?;
    let mut scene = Scene::load(&args.input, &args.compute, args.surface.slope)?;
    let outcome = match args.catchments {
        Some(of) => catchments(args, &targets, &scene, of)?,
        None => drops(args, &targets, &scene, &points)?,
    };
    scene.watch.lap("rain");
    scene.finish(args.compute.stats);
    Ok(outcome)
}

/// What a catchment's number stands for.
struct Names {
    of: Drained,
    of_faces: Vec<usize>,
    labels: Vec<Vec<(&'static str, String)>>,
}

impl Names {
    fn new(scene: &Scene, of: Drained) -> Self {
        let skeleton = scene.skeleton();
        let faces = || (0..skeleton.faces().len()).map(FaceId::new);
        let features = scene.features();
        let source = |face: FaceId| scene.figure.edges()[scene.edge(face).index()].source;
        let feature = |i: usize| {
            let mut labels = vec![("feature", i.to_string())];
            if let Some(id) = scene.document.features.get(i).and_then(|f| f.id.as_ref()) {
                labels.push(("id", serde_json::Value::from(id.as_str()).to_string()));
            }
            labels
        };
        let (of_faces, labels) = match of {
            Drained::Edge => {
                let label = |face: FaceId| {
                    let source = source(face);
                    let mut labels = feature(features[source.part as usize]);
                    let side = scene::side(skeleton.face(face).side);
                    labels.extend([
                        ("part", source.part.to_string()),
                        ("ring", source.ring.to_string()),
                        ("source_edge", source.edge.to_string()),
                        ("side", format!("\"{side}\"")),
                        ("face", face.index().to_string()),
                    ]);
                    labels
                };
                (
                    faces().map(FaceId::index).collect(),
                    faces().map(label).collect(),
                )
            }
            Drained::Feature => (
                faces()
                    .map(|face| features[source(face).part as usize])
                    .collect(),
                (0..scene.document.features.len()).map(feature).collect(),
            ),
            Drained::System => {
                let systems = Systems::new(&scene.figure);
                (
                    faces()
                        .map(|face| systems.of_edges()[scene.edge(face).index()])
                        .collect(),
                    (0..systems.count())
                        .map(|i| vec![("system", i.to_string())])
                        .collect(),
                )
            }
        };
        Self {
            of,
            of_faces,
            labels,
        }
    }

    fn json(&self, key: usize) -> String {
        let members = self.labels[key].iter();
        let members: Vec<String> = members.map(|(k, v)| format!("\"{k}\":{v}")).collect();
        members.join(",")
    }

    /// The names of a table's columns.
    const fn columns(&self) -> &'static [&'static str] {
        match self.of {
            Drained::Edge => &[
                "feature",
                "id",
                "part",
                "ring",
                "source_edge",
                "side",
                "face",
            ],
            Drained::Feature => &["feature", "id"],
            Drained::System => &["system"],
        }
    }

    fn cell(&self, key: usize, column: &str, separator: char) -> String {
        let found = self.labels[key].iter().find(|(name, _)| *name == column);
        let text = found.map_or("", |(_, value)| value);
        let plain: String = match serde_json::from_str(text) {
            Ok(serde_json::Value::String(text)) => text,
            _ => text.to_owned(),
        };
        if plain.contains([separator, '"', '\n', '\r', '\t']) {
            format!("\"{}\"", plain.replace('"', "\"\""))
        } else {
            plain
        }
    }
}

fn terrain(scene: &Scene, window: Window) -> Result<Terrain, Failure> {
    Terrain::new(scene.skeleton(), &scene.figure, window).map_err(|e| Failure::Input(e.to_string()))
}

fn catchments(
    args: &RainArgs,
    targets: &[Target],
    scene: &Scene,
    of: Drained,
) -> Result<Outcome, Failure> {
    let terrain = terrain(scene, scene.window(args.window)?)?;
    let names = Names::new(scene, of);
    let found = terrain.catchments(|face| names.of_faces[face.index()]);
    let index = Index::new(scene.skeleton(), &scene.figure);
    let relief = Relief {
        index: &index,
        terrain: &terrain,
        groups: Some(&names.of_faces),
        contours: &[],
        drops: &[],
    };
    for target in targets {
        match target.format {
            Geojson => target
                .write(|w| catchments_geojson(w, found.iter().map(|c| (c, names.json(c.key)))))?,
            Svg => target.write(|w| relief.svg(w))?,
            Png => target.write(|w| relief.png(w, args.size.size).map_err(picture_error))?,
            Tsv => target.write(|w| table(w, &found, &names, '\t'))?,
            _ => target.write(|w| table(w, &found, &names, ','))?,
        }
    }
    Ok(Outcome::Done)
}

fn table(
    w: &mut dyn Write,
    catchments: &[Catchment],
    names: &Names,
    separator: char,
) -> io::Result<()> {
    for column in names.columns() {
        write!(w, "{column}{separator}")?;
    }
    writeln!(w, "area{separator}cut")?;
    for catchment in catchments {
        for column in names.columns() {
            write!(
                w,
                "{}{separator}",
                names.cell(catchment.key, column, separator)
            )?;
        }
        writeln!(w, "{}{separator}{}", catchment.area, catchment.is_cut)?;
    }
    Ok(())
}

fn drops(
    args: &RainArgs,
    targets: &[Target],
    scene: &Scene,
    points: &[[f64; 2]],
) -> Result<Outcome, Failure> {
    let index = Index::new(scene.skeleton(), &scene.figure);
    let mut outcome = Outcome::Done;
    let mut drops = Vec::new();
    for &point in points {
        match index.path(point) {
            Ok(drop) => drops.push(drop),
            Err(error) => {
                report(error);
                outcome = Outcome::Flawed;
            }
        }
    }
    if drops.is_empty() && outcome == Outcome::Flawed {
        return Ok(outcome);
    }
    let height = |time| args.surface.height(time);
    let features = scene.features();
    let needs_picture = targets.iter().any(|t| matches!(t.format, Svg | Png));
    let terrain = if needs_picture {
        Some(terrain(scene, scene.window(args.window)?)?)
    } else {
        None
    };
    let relief = terrain.as_ref().map(|terrain| Relief {
        index: &index,
        terrain,
        groups: None,
        contours: &[],
        drops: &drops,
    });
    let named = || {
        drops
            .iter()
            .map(|drop| (drop, ending(scene, &features, drop)))
    };
    for target in targets {
        match (target.format, &relief) {
            (Svg, Some(relief)) => target.write(|w| relief.svg(w))?,
            (Png, Some(relief)) => {
                target.write(|w| relief.png(w, args.size.size).map_err(picture_error))?;
            }
            (Tsv, _) => target.write(|w| path_table(w, scene, &drops, args, '\t'))?,
            (Csv, _) => target.write(|w| path_table(w, scene, &drops, args, ','))?,
            _ => target.write(|w| drops_geojson(w, named(), height))?,
        }
    }
    Ok(outcome)
}

/// What a drop ends on, as members of a JSON object.
fn ending(scene: &Scene, features: &[usize], drop: &Drop) -> String {
    let edge = match drop.ending {
        Ending::Edge(edge) => edge,
        // Of the edges at the vertex, that of the face which the drop fell on, if it is one.
        Ending::Vertex(v) => {
            let own = scene.edge(drop.face);
            let edges = scene.figure.edges();
            let is_at = |e: &hipline::input::Edge| [e.from, e.to].contains(&v);
            let first = edges.iter().position(is_at).map_or(own, EdgeId::new);
            if is_at(&edges[own.index()]) {
                own
            } else {
                first
            }
        }
        _ => scene.edge(drop.face),
    };
    let source = scene.figure.edges()[edge.index()].source;
    let place = match drop.ending {
        Ending::Edge(edge) => format!("\"ends\":\"edge\",\"edge\":{}", edge.index()),
        Ending::Vertex(v) => format!("\"ends\":\"vertex\",\"vertex\":{}", v.index()),
        Ending::Pit(n) => format!("\"ends\":\"pit\",\"node\":{}", n.index()),
        _ => "\"ends\":\"unknown\"".to_owned(),
    };
    format!(
        "{place},\"face\":{},\"feature\":{},\"part\":{},\"ring\":{},\"source_edge\":{},\"length\":{:?}",
        drop.face.index(),
        features[source.part as usize],
        source.part,
        source.ring,
        source.edge,
        drop.length()
    )
}

/// One row a corner of a path.
fn path_table(
    w: &mut dyn Write,
    scene: &Scene,
    drops: &[Drop],
    args: &RainArgs,
    s: char,
) -> io::Result<()> {
    writeln!(w, "drop{s}x{s}y{s}height{s}edge")?;
    for (i, drop) in drops.iter().enumerate() {
        let edge = scene.edge(drop.face).index();
        for [x, y, time] in &drop.points {
            writeln!(
                w,
                "{i}{s}{x}{s}{y}{s}{}{s}{edge}",
                args.surface.height(*time)
            )?;
        }
    }
    Ok(())
}
