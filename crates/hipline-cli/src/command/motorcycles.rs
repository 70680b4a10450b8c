//! `hipline motorcycles`

use hipline::{Figure, motorcycle::MotorcycleGraph};
use hipline_io::{
    Document, FeatureName, Shape, read_launches,
    write::{Tracks, motorcycles_geojson, motorcycles_json, motorcycles_png, motorcycles_svg},
};

use crate::{
    args::{
        MotorcyclesArgs,
        OutputFormat::{self, Geojson, Json, Png, Svg},
    },
    compute::{Computed, each, is_hopeless, report_errors},
    failure::{Failure, Outcome},
    input::{self, Item},
    output::{self, Target, picture_error},
};

const FORMATS: [OutputFormat; 4] = [Json, Geojson, Svg, Png];

pub fn run(args: &MotorcyclesArgs) -> Result<Outcome, Failure> {
    let targets = output::targets(&args.output, Json, &FORMATS)?;
    if args.csv
        || args
            .input
            .path
            .extension()
            .is_some_and(|e| e.eq_ignore_ascii_case("csv"))
    {
        return given(args, &targets);
    }
    if args.walls.is_some() {
        return Err(Failure::Usage(
            "--walls goes with a table of motorcycles; the walls of polygons are their edges"
                .to_owned(),
        ));
    }
    let document = input::document(&args.input)?;
    let items = Item::all(&document, args.input.together);
    let computed = each(&items, |_, figure| match figure {
        Some(figure) => {
            let graph = figure.motorcycles().map_err(|reason| reason.to_string())?;
            if args.verify {
                graph.verify(figure).map_err(|broken| broken.to_string())?;
            }
            Ok(graph)
        }
        None => Ok(MotorcycleGraph::default()),
    });
    let outcome = report_errors(&computed);
    if !is_hopeless(&computed) {
        let all: Vec<Tracks> = computed.iter().filter_map(tracks).collect();
        write(&targets, &all, args)?;
    }
    Ok(outcome)
}

fn tracks(computed: &Computed<MotorcycleGraph>) -> Option<Tracks<'_>> {
    let graph = computed.result.as_ref().ok()?;
    Some(Tracks {
        name: computed.name.clone(),
        graph,
        walls: computed.figure.as_ref().map_or_else(Vec::new, edges),
    })
}

fn edges(figure: &Figure) -> Vec<[[f64; 2]; 2]> {
    let ends = figure.edges().iter().map(|edge| [edge.from, edge.to]);
    ends.map(|ends| ends.map(|v| figure.vertices()[v.index()]))
        .collect()
}

/// Motorcycles of a table, and walls of another file.
fn given(args: &MotorcyclesArgs, targets: &[Target]) -> Result<Outcome, Failure> {
    let path = &args.input.path;
    let weights = &args.input.weights;
    let has_weights =
        weights.weights.is_some() || !weights.weight.is_empty() || weights.heights.is_some();
    if has_weights || args.input.from.is_some() || args.input.together {
        let message = "a table of motorcycles has no weights, features or other formats";
        return Err(Failure::Usage(message.to_owned()));
    }
    if input::is_standard(path) && args.walls.as_deref().is_some_and(input::is_standard) {
        let message = "standard input cannot be both the motorcycles and their walls";
        return Err(Failure::Usage(message.to_owned()));
    }
    let launches = read_launches(&input::bytes(path)?)
        .map_err(|e| Failure::Input(format!("{}: {e}", input::name(path))))?;
    let walls = match &args.walls {
        Some(path) => segments(&input::plain(path)?),
        None => Vec::new(),
    };
    let graph = MotorcycleGraph::new(&launches, &walls).map_err(|invalid| {
        let lines = invalid.to_string().replace('\n', "\nerror: ");
        Failure::Input(lines)
    })?;
    if args.verify {
        graph
            .verify_launches(&launches, &walls)
            .map_err(|broken| Failure::Input(broken.to_string()))?;
    }
    let name = FeatureName { index: 0, id: None };
    write(
        targets,
        &[Tracks {
            name,
            graph: &graph,
            walls,
        }],
        args,
    )?;
    Ok(Outcome::Done)
}

/// Every edge of everything in a file.
fn segments(document: &Document) -> Vec<[[f64; 2]; 2]> {
    fn add(shape: &Shape, found: &mut Vec<[[f64; 2]; 2]>) {
        let mut chain = |points: &[[f64; 2]]| {
            found.extend(points.windows(2).map(|edge| [edge[0], edge[1]]));
        };
        match shape {
            Shape::Empty | Shape::Points(_) => {}
            Shape::Polygons(polygons) => {
                for ring in polygons.iter().flat_map(|polygon| &polygon.rings) {
                    chain(ring);
                    if let (Some(first), Some(last)) = (ring.first(), ring.last())
                        && first.map(f64::to_bits) != last.map(f64::to_bits)
                    {
                        chain(&[*last, *first]);
                    }
                }
            }
            Shape::Lines(lines) => lines.iter().for_each(|line| chain(&line.points)),
            Shape::Graph(graph) => {
                let ends = graph.edges.iter();
                found.extend(ends.map(|ends| ends.map(|v| graph.vertices[v])));
            }
            Shape::Collection(shapes) => shapes.iter().for_each(|shape| add(shape, found)),
        }
    }
    let mut found = Vec::new();
    for feature in &document.features {
        add(&feature.case, &mut found);
    }
    found
}

fn write(targets: &[Target], all: &[Tracks], args: &MotorcyclesArgs) -> Result<(), Failure> {
    for target in targets {
        match target.format {
            Json => target.write(|w| motorcycles_json(w, all.iter().cloned()))?,
            Geojson => target.write(|w| motorcycles_geojson(w, all.iter().cloned()))?,
            Png => {
                target.write(|w| motorcycles_png(w, all, args.size.size).map_err(picture_error))?
            }
            _ => target.write(|w| motorcycles_svg(w, all))?,
        }
    }
    Ok(())
}
