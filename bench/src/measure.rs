//! One measurement, within a process of its own.
//!
//! Times are CPU times of the thread, so that other programs disturb little; the best of several
//! repetitions, so that they disturb less. What is timed begins with the input in memory and
//! ends with the result in memory: copying the former and freeing the latter is left out.

use std::time::Duration;

use cpu_time::ProcessTime;
use hipline::{Figure, FigureBuilder, Options, Region, Skeleton};
use hipline_testkit::case::Case;
use serde::{Deserialize, Serialize};
use spade::{ConstrainedDelaunayTriangulation, Point2, Triangulation as _};

use crate::MEMORY;

/// Who is measured.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Program {
    /// hipline: figure, then skeleton.
    Hipline,
    /// spade's triangulation, all points at once.
    Bulk,
    /// spade's triangulation, point after point in the order of the input.
    Incremental,
}

impl Program {
    pub const ALL: [Self; 3] = [Self::Hipline, Self::Bulk, Self::Incremental];

    /// A short name.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Hipline => "hipline",
            Self::Bulk => "bulk",
            Self::Incremental => "incremental",
        }
    }
}

/// What was measured: sums over all figures.
#[derive(Debug, Clone, Copy, Default, Serialize, Deserialize)]
pub struct Measured {
    /// Figures measured.
    pub figures: usize,
    /// Cases left out, because their input has a flaw.
    pub refused: usize,
    /// Vertices of the figures.
    pub vertices: usize,
    /// How often it was repeated.
    pub repetitions: u32,
    /// Seconds to check and triangulate the input; all of it for a triangulation.
    pub build: f64,
    /// Seconds from the figure to the skeleton.
    pub skeleton: f64,
    /// Most bytes in use at any time, beyond the input; of a single figure only.
    pub peak: Option<usize>,
    pub edge_events: u64,
    pub split_events: u64,
    pub flips: u64,
    pub by_f64: u64,
    pub by_double_double: u64,
    pub by_wide: u64,
    pub by_exact: u64,
}

impl Measured {
    /// All seconds.
    pub const fn seconds(&self) -> f64 {
        self.build + self.skeleton
    }

    /// An amount per vertex.
    pub const fn per_vertex(&self, amount: f64) -> f64 {
        amount / self.vertices as f64
    }
}

/// Measures a program on all cases that are fine.
pub fn measure(
    program: Program,
    mut cases: Vec<Case>,
    both_sides: bool,
) -> Result<Measured, String> {
    let given = cases.len();
    if given > 1 {
        cases.retain(|case| case.figure().is_ok());
    }
    let mut measured = match program {
        Program::Hipline => hipline(&cases, both_sides)?,
        _ => triangulation(program, &cases)?,
    };
    measured.figures = cases.len();
    measured.refused = given - cases.len();
    Ok(measured)
}

/// Whether to measure again: small inputs often, large ones at least three times or until it
/// takes too long.
pub fn again(repetitions: u32, spent: f64) -> bool {
    match repetitions {
        0 => true,
        1..3 => spent < 6.0,
        _ => spent < 1.0 && repetitions < 50,
    }
}

/// The result of some work, and how many seconds it took.
pub fn timed<T>(work: impl FnOnce() -> T) -> (T, f64) {
    let start = ProcessTime::now();
    let result = work();
    (
        result,
        start.elapsed().max(Duration::from_nanos(1)).as_secs_f64(),
    )
}

fn hipline(cases: &[Case], both_sides: bool) -> Result<Measured, String> {
    let mut best = Measured {
        build: f64::INFINITY,
        skeleton: f64::INFINITY,
        ..Measured::default()
    };
    let mut spent = 0.0;
    while again(best.repetitions, spent) {
        let (before, most_before) = (MEMORY.allocated(), MEMORY.max_allocated());
        let builders: Vec<FigureBuilder> = cases.iter().map(Case::to_builder).collect();
        let (figures, build) = timed(|| -> Result<Vec<Figure>, _> {
            builders.into_iter().map(FigureBuilder::build).collect()
        });
        let figures = figures.map_err(|flaws| flaws.to_string())?;
        let (skeletons, skeleton) = timed(|| -> Vec<Skeleton> {
            figures
                .iter()
                .map(|figure| {
                    figure.skeleton(Options::default().region(region(figure, both_sides)))
                })
                .collect()
        });
        spent += build + skeleton;
        best.repetitions += 1;
        best.build = best.build.min(build);
        best.skeleton = best.skeleton.min(skeleton);
        if best.repetitions > 1 {
            continue;
        }
        let most = MEMORY.max_allocated();
        // Several figures are kept together here as nobody would; and if more was in use before,
        // nothing is known.
        best.peak = (cases.len() == 1 && most > most_before).then(|| most - before);
        best.vertices = figures.iter().map(|figure| figure.vertices().len()).sum();
        for stats in skeletons.iter().map(Skeleton::stats) {
            best.edge_events += stats.edge_events;
            best.split_events += stats.split_events;
            best.flips += stats.flips;
            best.by_f64 += stats.by_f64;
            best.by_double_double += stats.by_double_double;
            best.by_wide += stats.by_wide;
            best.by_exact += stats.by_exact;
        }
    }
    Ok(best)
}

/// "Interior" means something only if there is a polygon.
const fn region(figure: &Figure, both_sides: bool) -> Region {
    if both_sides || !figure.has_polygon() {
        Region::Both
    } else {
        Region::Interior
    }
}

/// A checked figure as spade takes it.
type Graph = (Vec<Point2<f64>>, Vec<[usize; 2]>);

fn triangulation(program: Program, cases: &[Case]) -> Result<Measured, String> {
    let mut graphs: Vec<Graph> = Vec::new();
    for case in cases {
        let figure = case.figure().map_err(|flaws| flaws.to_string())?;
        let points = figure
            .vertices()
            .iter()
            .map(|&[x, y]| Point2::new(x, y))
            .collect();
        let edges = figure
            .edges()
            .iter()
            .map(|edge| [edge.from.index(), edge.to.index()])
            .collect();
        graphs.push((points, edges));
    }
    let mut best = Measured {
        build: f64::INFINITY,
        ..Measured::default()
    };
    best.vertices = graphs.iter().map(|(points, _)| points.len()).sum();
    let mut spent = 0.0;
    while again(best.repetitions, spent) {
        let copies = graphs.clone();
        let (result, seconds) = timed(|| -> Result<Vec<_>, _> {
            copies
                .into_iter()
                .map(|graph| {
                    if program == Program::Bulk {
                        bulk(graph)
                    } else {
                        incremental(&graph)
                    }
                })
                .collect()
        });
        result.map_err(|e| e.to_string())?;
        spent += seconds;
        best.repetitions += 1;
        best.build = best.build.min(seconds);
    }
    Ok(best)
}

type Cdt = ConstrainedDelaunayTriangulation<Point2<f64>>;

fn bulk((points, edges): Graph) -> Result<Cdt, spade::InsertionError> {
    Cdt::bulk_load_cdt(points, edges)
}

fn incremental((points, edges): &Graph) -> Result<Cdt, spade::InsertionError> {
    let mut cdt = Cdt::new();
    let handles = points
        .iter()
        .map(|&point| cdt.insert(point))
        .collect::<Result<Vec<_>, _>>()?;
    for &[from, to] in edges {
        cdt.add_constraint(handles[from], handles[to]);
    }
    Ok(cdt)
}
