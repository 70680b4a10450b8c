//! `hipline terrain`

use hipline::observe::{Contour, Grid, Index, Terrain, Window, contours};
use hipline_io::write::{Heights, Relief, contours_geojson, terrain_obj};

use super::scene::{Scene, raster_error};
use crate::{
    args::{
        OutputFormat::{self, Asc, Geojson, Obj, Png, Svg, Tif},
        TerrainArgs,
    },
    failure::{Failure, Outcome},
    output::{self, Target, picture_error},
};

const FORMATS: [OutputFormat; 6] = [Obj, Asc, Tif, Geojson, Svg, Png];

/// The usual number of cells along a raster's longer side.
const CELLS: f64 = 500.0;

/// More contour lines are a mistake in the step.
const MOST_LINES: f64 = 1e5;

pub fn run(args: &TerrainArgs) -> Result<Outcome, Failure> {
    let targets = output::targets(&args.output, Obj, &FORMATS)?;
    let mut scene = Scene::load(&args.input, &args.compute, args.surface.slope)?;
    let window = scene.window(args.window)?;
    let terrain = Terrain::new(scene.skeleton(), &scene.figure, window)
        .map_err(|e| Failure::Input(e.to_string()))?;
    let index = Index::new(scene.skeleton(), &scene.figure);
    let needs = |formats: &[OutputFormat]| targets.iter().any(|t| formats.contains(&t.format));
    let step = match args.contours {
        Some(step) => Some(step),
        None if needs(&[Geojson]) => Some(usual_step(args.surface.slope * terrain.highest())),
        None => None,
    };
    let lines = match step {
        Some(step) if needs(&[Geojson, Svg, Png]) => {
            lines(&scene, window, args, step, terrain.highest())?
        }
        _ => Vec::new(),
    };
    let heights = if needs(&[Asc, Tif]) {
        Some(heights(&index, window, args)?)
    } else {
        None
    };
    // Pictures draw lines only if they were asked for.
    let drawn: &[Contour] = if args.contours.is_some() { &lines } else { &[] };
    let relief = Relief {
        index: &index,
        terrain: &terrain,
        groups: None,
        contours: drawn,
        drops: &[],
    };
    for target in &targets {
        write(target, args, &relief, &lines, heights.as_ref())?;
    }
    drop(index);
    scene.watch.lap("terrain");
    scene.finish(args.compute.stats);
    Ok(Outcome::Done)
}

fn write(
    target: &Target,
    args: &TerrainArgs,
    relief: &Relief,
    lines: &[Contour],
    heights: Option<&Heights>,
) -> Result<(), Failure> {
    let height = |time| args.surface.height(time);
    match (target.format, heights) {
        (Asc, Some(heights)) => target.write(|w| heights.ascii(w)),
        (Tif, Some(heights)) => target.write(|w| heights.geotiff(w).map_err(raster_error)),
        (Geojson, _) => target.write(|w| contours_geojson(w, lines, height)),
        (Svg, _) => target.write(|w| relief.svg(w)),
        (Png, _) => target.write(|w| relief.png(w, args.size.size).map_err(picture_error)),
        _ => target.write(|w| terrain_obj(w, relief.terrain, height)),
    }
}

/// About a tenth of a height: 1, 2 or 5 times a power of ten.
fn usual_step(highest: f64) -> f64 {
    let tenth = highest / 10.0;
    let power = 10.0_f64.powi(tenth.log10().floor() as i32);
    let steps = [1.0, 2.0, 5.0, 10.0].map(|k| k * power);
    steps
        .into_iter()
        .find(|&s| s >= tenth && s > 0.0)
        .unwrap_or(1.0)
}

/// Contour lines at the multiples of the step above the input's elevation.
fn lines(
    scene: &Scene,
    window: Window,
    args: &TerrainArgs,
    step: f64,
    highest: f64,
) -> Result<Vec<Contour>, Failure> {
    let base = args.surface.elevation;
    let first = (base / step).floor() + 1.0;
    let last = (args.surface.height(highest) / step).floor();
    if last - first > MOST_LINES {
        return Err(Failure::Input(format!(
            "contour lines every {step} are more than {MOST_LINES}"
        )));
    }
    let count = (last - first).max(-1.0) as i64 + 1;
    let times: Vec<f64> = (0..count)
        .map(|k| ((first + k as f64) * step - base) / args.surface.slope)
        .collect();
    contours(scene.skeleton(), &scene.figure, window, &times)
        .map_err(|e| Failure::Input(e.to_string()))
}

fn heights(index: &Index, window: Window, args: &TerrainArgs) -> Result<Heights, Failure> {
    let [width, height] = window.size();
    let cell = args.cell.unwrap_or(width.max(height) / CELLS);
    let grid = Grid::new(window, cell).map_err(|e| Failure::Input(e.to_string()))?;
    let answers = index.locate_grid(&grid);
    let values = answers
        .iter()
        .map(|a| a.as_ref().ok().map(|a| args.surface.height(a.time)))
        .collect();
    Heights::new(grid, values).map_err(|e| Failure::Input(e.to_string()))
}
