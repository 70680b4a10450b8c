//! The engines side by side, and beside a plain sort of the vertices, on orthogonal monotone polygons.
//!
//! Each measurement is a process of its own, as in the other campaigns. What is sorted are the vertices by x: what any algorithm that is not
//! linear would begin with. What is copied is the result: what writing it into fresh memory costs, whatever the algorithm.

use std::ffi::OsString;
use std::process::Command;

use hipline::{Engine, Figure, FigureBuilder, Options, Skeleton};
use hipline_testkit::generate::{Columns, Random, columns};
use serde::{Deserialize, Serialize};

use crate::MEMORY;
use crate::measure::{again, timed};

/// The first argument of the campaign.
pub const FLAG: &str = "--engines";
/// The first argument of a process that measures.
pub const WORKER: &str = "--engines-worker";

/// The kinetic engine is measured up to this size.
const KINETIC_UP_TO: usize = 1_000_000;

/// A kind of polygon.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Family {
    /// Floors and ceilings of any heights, integers.
    Streets,
    /// The same with equal steps of height one: many events at one time and place.
    Terraces,
    /// Heights that walk up and down, integers.
    Ridge,
    /// Like streets, with coordinates that use all digits of an f64.
    Decimals,
}

impl Family {
    const ALL: [Self; 4] = [Self::Streets, Self::Terraces, Self::Ridge, Self::Decimals];

    const fn name(self) -> &'static str {
        match self {
            Self::Streets => "streets",
            Self::Terraces => "terraces",
            Self::Ridge => "ridge",
            Self::Decimals => "decimals",
        }
    }

    fn ring(self, n: usize) -> Vec<[f64; 2]> {
        let random = &mut Random::new(1);
        let (count, widest, how) = match self {
            Self::Streets | Self::Decimals => (n / 4, 1000, Columns::Apart(100_000)),
            Self::Terraces => (n / 4, 2, Columns::Apart(6)),
            Self::Ridge => (n / 4, 1000, Columns::Walk(1000)),
        };
        let ring = columns(random, count.max(1), widest, how);
        let scale = if self == Self::Decimals { 0.1 } else { 1.0 };
        ring.into_iter()
            .map(|point| point.map(|x| x as f64 * scale))
            .collect()
    }
}

/// Seconds, bytes and steps for one polygon.
#[derive(Debug, Clone, Copy, Serialize, Deserialize)]
struct Measured {
    vertices: usize,
    sort: f64,
    build: f64,
    orthogonal: f64,
    /// A copy of the result.
    copy: f64,
    kinetic: Option<f64>,
    steps: u64,
    /// Most bytes in use at any time, with the points given and the result.
    peak: usize,
    arcs: usize,
}

/// Makes all measurements, and prints a table.
pub fn run(arguments: Vec<OsString>) -> Result<(), String> {
    let mut arguments = pico_args::Arguments::from_vec(arguments);
    let sizes = match arguments
        .opt_value_from_str::<_, String>("--sizes")
        .map_err(|e| e.to_string())?
    {
        None => vec![1000, 10_000, 100_000, 1_000_000, 10_000_000],
        Some(sizes) => sizes
            .split(',')
            .map(|size| size.parse().map_err(|_| format!("{size} is not a size")))
            .collect::<Result<Vec<usize>, _>>()?,
    };
    if let Some(unknown) = arguments.finish().first() {
        return Err(format!("{} is no option of {FLAG}", unknown.display()));
    }
    println!(
        "| family | vertices | sort ns | build ns | orthogonal ns | times the sort | copy ns | kinetic ns | steps | bytes |\n\
         | --- | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: |"
    );
    for family in Family::ALL {
        for &n in &sizes {
            let measured = measured(family, n)?;
            let count = measured.vertices as f64;
            let each = |seconds: f64| 1e9 * seconds / count;
            let kinetic = measured
                .kinetic
                .map_or_else(String::new, |seconds| format!("{:.0}", each(seconds)));
            println!(
                "| {} | {} | {:.0} | {:.0} | {:.0} | {:.1} | {:.0} | {kinetic} | {:.2} | {:.0} |",
                family.name(),
                measured.vertices,
                each(measured.sort),
                each(measured.build),
                each(measured.orthogonal),
                measured.orthogonal / measured.sort,
                each(measured.copy),
                measured.steps as f64 / count,
                measured.peak as f64 / count,
            );
        }
    }
    Ok(())
}

/// Has a process measure, and waits for it.
fn measured(family: Family, n: usize) -> Result<Measured, String> {
    let output = Command::new(std::env::current_exe().map_err(|e| e.to_string())?)
        .args([WORKER, family.name(), &n.to_string()])
        .output()
        .map_err(|e| e.to_string())?;
    if !output.status.success() {
        return Err(String::from_utf8_lossy(&output.stderr).into_owned());
    }
    serde_json::from_slice(&output.stdout).map_err(|e| e.to_string())
}

/// The other side: measures and prints.
pub fn serve(arguments: &[OsString]) -> Result<(), String> {
    let [family, n] = arguments else {
        return Err("a worker takes two arguments".to_owned());
    };
    let family = Family::ALL
        .into_iter()
        .find(|f| *family == *f.name())
        .ok_or("unknown family")?;
    let n = n.to_string_lossy().parse().map_err(|_| "not a size")?;
    let measured = measure(&family.ring(n))?;
    println!(
        "{}",
        serde_json::to_string(&measured).map_err(|e| e.to_string())?
    );
    Ok(())
}

fn built(points: Vec<[f64; 2]>) -> Result<Figure, String> {
    let mut builder = FigureBuilder::new();
    builder.polygon(vec![points]);
    builder.build().map_err(|flaws| flaws.to_string())
}

fn by(engine: Engine, figure: &Figure) -> Result<Skeleton, String> {
    figure
        .skeleton_by(engine, Options::default())
        .map_err(|reason| reason.to_string())
}

fn measure(ring: &[[f64; 2]]) -> Result<Measured, String> {
    let mut best = Measured {
        vertices: ring.len(),
        sort: f64::INFINITY,
        build: f64::INFINITY,
        orthogonal: f64::INFINITY,
        copy: f64::INFINITY,
        kinetic: None,
        steps: 0,
        peak: 0,
        arcs: 0,
    };
    let mut repetitions = 0;
    let mut spent = 0.0;
    while again(repetitions, spent) {
        // Memory first, before anything else has been in use.
        let before = MEMORY.allocated();
        let points = ring.to_vec();
        let (figure, build) = timed(|| built(points));
        let figure = figure?;
        let (skeleton, orthogonal) = timed(|| by(Engine::Orthogonal, &figure));
        let skeleton = skeleton?;
        if repetitions == 0 {
            best.peak = MEMORY.max_allocated() - before;
            best.steps = skeleton.stats().steps;
            best.arcs = skeleton.arcs().len();
        }
        drop(skeleton);
        drop(figure);
        let mut sorted = ring.to_vec();
        let ((), sort) = timed(|| sorted.sort_unstable_by(|p, q| p[0].total_cmp(&q[0])));
        std::hint::black_box(&sorted);
        best.build = best.build.min(build);
        best.orthogonal = best.orthogonal.min(orthogonal);
        best.sort = best.sort.min(sort);
        repetitions += 1;
        spent += build + orthogonal + sort;
    }
    let figure = built(ring.to_vec())?;
    let skeleton = by(Engine::Orthogonal, &figure)?;
    // Apart: it leaves memory behind that would be used again above.
    for _ in 0..3 {
        let (copied, copy) = timed(|| skeleton.clone());
        std::hint::black_box(&copied);
        best.copy = best.copy.min(copy);
    }
    drop(skeleton);
    if ring.len() <= KINETIC_UP_TO {
        // With the triangulation, which only this engine needs.
        let (skeleton, seconds) = timed(|| by(Engine::Kinetic, &figure));
        let arcs = skeleton?.arcs().len();
        if arcs != best.arcs {
            return Err(format!("{} arcs, but {arcs} kinetic ones", best.arcs));
        }
        best.kinetic = Some(seconds);
    }
    Ok(best)
}
