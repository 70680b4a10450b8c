//! From features to skeletons, each on its own: what is wrong with one is no reason to lose
//! the others.

use std::{
    any::Any,
    io::{self, IsTerminal},
    panic::{AssertUnwindSafe, catch_unwind},
    time::{Duration, Instant},
};

use hipline::{
    Chain, Figure, Region, Skeleton,
    skeleton::{InputGraph, Stats},
};
use hipline_io::FeatureName;
use indicatif::{ProgressBar, ProgressStyle};
use rayon::prelude::*;

use crate::{
    args::{ChainArg, ComputeArgs},
    failure::{Outcome, print_to_stderr, report},
    input::Item,
};

/// What came of one item.
pub struct Computed<T = Skeleton> {
    /// Its name.
    pub name: FeatureName,
    /// What it was computed from; none of an empty geometry.
    pub figure: Option<Figure>,
    /// The result, or the error, which names the item.
    pub result: Result<T, String>,
}

/// The skeletons among what was computed, for the statistics.
pub fn skeletons_of<T>(
    computed: Vec<Computed<T>>,
    skeleton: impl Fn(T) -> Skeleton,
) -> Vec<Computed> {
    let skeletons = computed.into_iter().map(|c| Computed {
        name: c.name,
        figure: c.figure,
        result: c.result.map(&skeleton),
    });
    skeletons.collect()
}

/// A job with fewer points has no progress bar.
const LONG: usize = 20_000;

/// The skeletons of all items, in their order; of one side of them, if they are chains.
pub fn skeletons(items: &[Item], compute: ComputeArgs, chain: Option<ChainArg>) -> Vec<Computed> {
    each(items, |item, figure| match (figure, chain) {
        (Some(figure), Some(side)) => Chain::new(figure)
            .and_then(|chain| chain.skeleton(side.into()))
            .map_err(|reason| reason.to_string()),
        (Some(figure), None) => skeleton(item, figure, compute),
        (None, _) => Ok(empty(compute.region())),
    })
}

/// The skeleton of an item, if the engine applies, and every edge was reached at its own heights, or need not.
pub fn skeleton(item: &Item, figure: &Figure, compute: ComputeArgs) -> Result<Skeleton, String> {
    let skeleton = figure
        .skeleton_by(compute.engine.into(), compute.options())
        .map_err(|reason| reason.to_string())?;
    if !item.allows_walls() {
        skeleton.check_heights(figure).map_err(|early| {
            let lines = early.to_string().replace('\n', "; ");
            format!("{lines}; --allow-walls computes it nonetheless")
        })?;
    }
    Ok(skeleton)
}

/// Computes something of each item's figure, or of none if its geometry is empty. On all
/// processors; the order of the results is that of the items.
pub fn each<T: Send>(
    items: &[Item],
    compute: impl Fn(&Item, Option<&Figure>) -> Result<T, String> + Sync,
) -> Vec<Computed<T>> {
    let progress = progress(items);
    let results = items
        .par_iter()
        .map(|item| {
            let computed = one(item, &compute);
            progress.inc(item.points() as u64);
            computed
        })
        .collect();
    progress.finish_and_clear();
    results
}

fn one<T>(
    item: &Item,
    compute: &impl Fn(&Item, Option<&Figure>) -> Result<T, String>,
) -> Computed<T> {
    let title = item.title();
    // A bug in the library costs the feature that shows it, not the others.
    let attempt = catch_unwind(AssertUnwindSafe(|| match item.figure() {
        Ok(figure) => {
            let result = compute(item, Some(&figure)).map_err(|e| format!("{title}: {e}"));
            (Some(figure), result)
        }
        Err(error) if error.is_empty_geometry() => (
            None,
            compute(item, None).map_err(|e| format!("{title}: {e}")),
        ),
        Err(error) => (None, Err(error.to_string())),
    }));
    let (figure, result) = attempt.unwrap_or_else(|payload| {
        let message = message(payload.as_ref());
        (
            None,
            Err(format!(
                "{title}: a bug in hipline, please report it: {message}"
            )),
        )
    });
    Computed {
        name: item.name(),
        figure,
        result,
    }
}

fn message(payload: &(dyn Any + Send)) -> &str {
    payload
        .downcast_ref::<String>()
        .map(String::as_str)
        .or_else(|| payload.downcast_ref::<&str>().copied())
        .unwrap_or("no message")
}

/// The skeleton of nothing.
pub fn empty(region: Region) -> Skeleton {
    let region = match region {
        Region::Auto => Region::Both,
        region => region,
    };
    Skeleton::from_parts(vec![], vec![], vec![], InputGraph::default(), region)
        .expect("nothing has no wrong references")
}

/// A bar on a terminal, if the job is long; else one that is never seen.
fn progress(items: &[Item]) -> ProgressBar {
    let points: usize = items.iter().map(Item::points).sum();
    if points < LONG || !io::stderr().is_terminal() {
        return ProgressBar::hidden();
    }
    let bar = ProgressBar::new(points as u64);
    if let Ok(style) = ProgressStyle::with_template(
        "{spinner} {elapsed} {wide_bar} {human_pos}/{human_len} points",
    ) {
        bar.set_style(style);
    }
    bar.enable_steady_tick(Duration::from_millis(200));
    bar
}

/// Prints every error. Flawed if there is one.
pub fn report_errors<T>(computed: &[Computed<T>]) -> Outcome {
    let mut outcome = Outcome::Done;
    for error in computed.iter().filter_map(|c| c.result.as_ref().err()) {
        report(error);
        outcome = Outcome::Flawed;
    }
    outcome
}

/// Whether there were items and nothing came of any.
pub fn is_hopeless<T>(computed: &[Computed<T>]) -> bool {
    !computed.is_empty() && computed.iter().all(|c| c.result.is_err())
}

/// The skeletons that there are, with the names of what they were computed from.
pub fn successes(computed: &[Computed]) -> impl Iterator<Item = (&FeatureName, &Skeleton)> {
    computed
        .iter()
        .filter_map(|c| Some((&c.name, c.result.as_ref().ok()?)))
}

/// Measures the stages of a command.
pub struct Watch {
    last: Instant,
    stages: Vec<(&'static str, Duration)>,
}

impl Watch {
    /// Starts the first stage.
    pub fn start() -> Self {
        Self {
            last: Instant::now(),
            stages: Vec::new(),
        }
    }

    /// Ends a stage.
    pub fn lap(&mut self, stage: &'static str) {
        let now = Instant::now();
        self.stages.push((stage, now - self.last));
        self.last = now;
    }

    /// Prints what was done and how long it took.
    pub fn print_stats(&self, computed: &[Computed]) {
        let sum = |count: fn(&Skeleton) -> usize| -> usize {
            successes(computed).map(|(_, s)| count(s)).sum()
        };
        let total = |count: fn(&Stats) -> u64| -> u64 {
            successes(computed).map(|(_, s)| count(s.stats())).sum()
        };
        let failed = computed.iter().filter(|c| c.result.is_err()).count();
        print_to_stderr(format_args!(
            "features   {} ({failed} failed)",
            computed.len()
        ));
        print_to_stderr(format_args!(
            "input      {} vertices, {} edges, {} terminals",
            sum(|s| s.input().vertices),
            sum(|s| s.input().edges.len()),
            sum(|s| s.input().terminals)
        ));
        print_to_stderr(format_args!(
            "skeleton   {} nodes, {} arcs, {} faces",
            sum(|s| s.nodes().len()),
            sum(|s| s.arcs().len()),
            sum(|s| s.faces().len())
        ));
        print_to_stderr(format_args!(
            "events     {} edge, {} split, {} flips",
            total(|s| s.edge_events),
            total(|s| s.split_events),
            total(|s| s.flips)
        ));
        let rungs = [
            total(|s| s.by_f64),
            total(|s| s.by_double_double),
            total(|s| s.by_wide),
            total(|s| s.by_exact),
        ];
        let all = rungs.iter().sum::<u64>();
        let share = |n: u64| 100.0 * n as f64 / all.max(1) as f64;
        print_to_stderr(format_args!(
            "decisions  {all}: {:.2}% by f64, {:.2}% by double-double, {:.2}% by 400 digits, {:.2}% by exact integers",
            share(rungs[0]),
            share(rungs[1]),
            share(rungs[2]),
            share(rungs[3])
        ));
        let stages: Vec<_> = self
            .stages
            .iter()
            .map(|(stage, time)| format!("{stage} {:.3} s", time.as_secs_f64()))
            .collect();
        print_to_stderr(format_args!("time       {}", stages.join(", ")));
    }
}
