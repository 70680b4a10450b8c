//! `hipline offset`

use std::sync::atomic::{AtomicBool, Ordering};

use hipline::{Figure, Region, Skeleton, offset::Offset};

use super::write_offset;
use crate::{
    args::{
        OffsetArgs,
        OutputFormat::{self, Geojson, Png, Svg, Wkt},
    },
    compute::{self, Watch, each, is_hopeless, report_errors, skeletons_of},
    failure::{Failure, Outcome},
    input::{self, Item},
    output,
};

const FORMATS: [OutputFormat; 4] = [Geojson, Wkt, Svg, Png];

/// More steps than this, for one feature, are a mistake in the step.
const MOST_STEPS: f64 = 1e5;

/// A skeleton with its offsets.
pub struct Offsets {
    pub skeleton: Skeleton,
    pub offsets: Vec<Offset>,
}

pub fn run(args: &OffsetArgs) -> Result<Outcome, Failure> {
    let targets = output::targets(&args.output, Geojson, &FORMATS)?;
    let mut watch = Watch::start();
    let document = input::weighted(&args.input, &args.gables)?;
    let items = Item::all(&document, args.input.together);
    watch.lap("read");
    let endless = AtomicBool::new(false);
    let computed = each(&items, |item, figure| {
        let Some(figure) = figure else {
            return Ok(Offsets {
                skeleton: compute::empty(args.compute.region()),
                offsets: Vec::new(),
            });
        };
        if never_ends(args, figure) {
            endless.store(true, Ordering::Relaxed);
            return Err("its offsets never end".to_owned());
        }
        let skeleton = compute::skeleton(item, figure, args.compute)?;
        let distances = distances(args, &skeleton)?;
        let offsets = skeleton
            .offsets(figure, &distances)
            .map_err(|e| e.to_string())?;
        Ok(Offsets { skeleton, offsets })
    });
    watch.lap("compute");
    if endless.into_inner() {
        return Err(Failure::Usage(
            "outside of polygons, offsets never end: --step needs --count".to_owned(),
        ));
    }
    let outcome = report_errors(&computed);
    if !is_hopeless(&computed) {
        for target in &targets {
            write_offset::write(target, &computed, args)?;
        }
    }
    watch.lap("write");
    if args.compute.stats {
        watch.print_stats(&skeletons_of(computed, |made| made.skeleton));
    }
    Ok(outcome)
}

fn never_ends(args: &OffsetArgs, figure: &Figure) -> bool {
    let is_bounded = match args.compute.region() {
        Region::Interior => true,
        Region::Auto => figure.has_polygon(),
        Region::Exterior | Region::Both => false,
    };
    args.step.is_some() && args.count.is_none() && !is_bounded
}

/// The distances asked for: as given, or the multiples of the step.
fn distances(args: &OffsetArgs, skeleton: &Skeleton) -> Result<Vec<f64>, String> {
    let Some(step) = args.step else {
        return Ok(args.distance.clone());
    };
    let count = if let Some(count) = args.count {
        f64::from(count)
    } else {
        let last = skeleton.nodes().iter().map(|n| n.time).fold(0.0, f64::max);
        (last / step).ceil()
    };
    if count > MOST_STEPS && args.count.is_none() {
        return Err(format!(
            "steps of {step} are {count} steps, more than {MOST_STEPS}; --count limits them"
        ));
    }
    let multiple = |k: u32| f64::from(k) * step;
    Ok((1..=count as u32)
        .map(multiple)
        .filter(|d| d.is_finite())
        .collect())
}
