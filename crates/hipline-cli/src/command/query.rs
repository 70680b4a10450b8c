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
    let points = points::all(&args.at, args.points.as_deref())?;
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
            Tsv => table(w, &rows, &features, args, '\t'),
            _ => table(w, &rows, &features, args, ','),
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

fn table(
    w: &mut dyn Write,
    rows: &[Row],
    features: &[usize],
    args: &QueryArgs,
    separator: char,
) -> io::Result<()> {
    let s = separator;
    writeln!(
        w,
        "x{s}y{s}height{s}face{s}edge{s}side{s}feature{s}part{s}ring{s}source_edge"
    )?;
    for ([x, y], answer) in rows {
        write!(w, "{x}{s}{y}")?;
        match answer {
            Ok(a) => writeln!(
                w,
                "{s}{}{s}{}{s}{}{s}{}{s}{}{s}{}{s}{}{s}{}",
                args.surface.height(a.time),
                a.face.index(),
                a.edge.index(),
                scene::side(a.side),
                features[a.source.part as usize],
                a.source.part,
                a.source.ring,
                a.source.edge
            )?,
            Err(_) => writeln!(w, "{s}{s}{s}{s}{s}{s}{s}{s}")?,
        }
    }
    Ok(())
}

fn json(w: &mut dyn Write, rows: &[Row], features: &[usize], args: &QueryArgs) -> io::Result<()> {
    w.write_all(b"[")?;
    for (i, ([x, y], answer)) in rows.iter().enumerate() {
        write!(
            w,
            "{}{{\"x\":{x},\"y\":{y},",
            if i == 0 { "\n" } else { ",\n" }
        )?;
        match answer {
            Ok(a) => write!(
                w,
                "\"height\":{},\"face\":{},\"edge\":{},\"side\":\"{}\",\"feature\":{},\"part\":{},\"ring\":{},\"source_edge\":{}}}",
                args.surface.height(a.time),
                a.face.index(),
                a.edge.index(),
                scene::side(a.side),
                features[a.source.part as usize],
                a.source.part,
                a.source.ring,
                a.source.edge
            )?,
            Err(_) => w.write_all(b"\"height\":null}")?,
        }
    }
    w.write_all(b"\n]\n")
}
