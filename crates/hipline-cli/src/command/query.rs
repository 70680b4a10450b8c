//! `hipline query`

use std::io::{self, Write};

use hipline::observe::{Answer, Grid, Index, NoAnswer};

use super::{points, scene};
use crate::{
    args::{
        OutputFormat::{self, Csv, Json, Tsv},
        QueryArgs,
    },
    failure::{Failure, Outcome, report},
    output,
};
use scene::Scene;

const FORMATS: [OutputFormat; 3] = [Csv, Tsv, Json];

/// A point and what is known about it.
type Row = ([f64; 2], Result<Answer, NoAnswer>);

pub fn run(args: &QueryArgs) -> Result<Outcome, Failure> {
    let targets = output::targets(&args.output, Csv, &FORMATS)?;
    let points = points::all(&args.points)?;
    let mut scene = Scene::load(&args.input, &args.compute, args.surface.slope)?;
    let index = Index::new(scene.skeleton(), &scene.figure);
    let rows: Vec<Row> = if let Some(cell) = args.grid {
        let grid = Grid::new(scene.window(args.window)?, cell)
            .map_err(|e| Failure::Input(e.to_string()))?;
        let answers = index.locate_grid(&grid).into_iter().enumerate();
        answers
            .map(|(i, a)| (grid.centre(i % grid.columns(), i / grid.columns()), a))
            .collect()
    } else {
        let answers = index.locate_all(&points);
        points.iter().copied().zip(answers).collect()
    };
    drop(index);
    scene.watch.lap("query");
    let features = scene.features();
    for target in &targets {
        target.write(|w| match target.format {
            Json => json(w, &rows, &features, args),
            Tsv => table(w, &rows, &features, args, "\t"),
            _ => table(w, &rows, &features, args, ","),
        })?;
    }
    scene.finish(args.compute.stats);
    // Of a grid, parts that are not covered are expected.
    let mut outcome = Outcome::Done;
    if args.grid.is_none() {
        for error in rows.iter().filter_map(|(_, answer)| answer.as_ref().err()) {
            report(error);
            outcome = Outcome::Flawed;
        }
    }
    Ok(outcome)
}

/// What is told of a point that is covered.
const COLUMNS: [&str; 8] = [
    "height",
    "face",
    "edge",
    "side",
    "feature",
    "part",
    "ring",
    "source_edge",
];

/// The values of the columns.
fn values(a: &Answer, features: &[usize], args: &QueryArgs) -> [String; COLUMNS.len()] {
    [
        args.surface.height(a.time).to_string(),
        a.face.index().to_string(),
        a.edge.index().to_string(),
        scene::side(a.side).to_owned(),
        features[a.source.part as usize].to_string(),
        a.source.part.to_string(),
        a.source.ring.to_string(),
        a.source.edge.to_string(),
    ]
}

fn table(
    w: &mut dyn Write,
    rows: &[Row],
    features: &[usize],
    args: &QueryArgs,
    separator: &str,
) -> io::Result<()> {
    let s = separator;
    writeln!(w, "x{s}y{s}{}", COLUMNS.join(s))?;
    for ([x, y], answer) in rows {
        let values = match answer {
            Ok(a) => values(a, features, args),
            Err(_) => Default::default(),
        };
        writeln!(w, "{x}{s}{y}{s}{}", values.join(s))?;
    }
    Ok(())
}

fn json(w: &mut dyn Write, rows: &[Row], features: &[usize], args: &QueryArgs) -> io::Result<()> {
    w.write_all(b"[")?;
    for (i, ([x, y], answer)) in rows.iter().enumerate() {
        let start = if i == 0 { "\n" } else { ",\n" };
        write!(w, "{start}{{\"x\":{x},\"y\":{y}")?;
        match answer {
            Ok(a) => {
                for (name, value) in COLUMNS.iter().zip(values(a, features, args)) {
                    match *name {
                        "side" => write!(w, ",\"side\":\"{value}\"")?,
                        _ => write!(w, ",\"{name}\":{value}")?,
                    }
                }
            }
            Err(_) => w.write_all(b",\"height\":null")?,
        }
        w.write_all(b"}")?;
    }
    w.write_all(b"\n]\n")
}
