//! `hipline centreline`

use hipline::{
    Region, Skeleton,
    centreline::{Centreline, CentrelineOptions},
};
use hipline_io::{
    FeatureName,
    write::{OffsetLine, Picture, Window, centreline_geojson, centreline_wkt},
};

use crate::{
    args::{
        CentrelineArgs,
        OutputFormat::{self, Geojson, Png, Svg, Wkt},
    },
    compute::{self, Computed, Watch, each, is_hopeless, report_errors, skeletons_of},
    failure::{Failure, Outcome},
    input::{self, Item},
    output::{self, Target},
};

const FORMATS: [OutputFormat; 4] = [Geojson, Wkt, Svg, Png];

/// The border of a picture of the outside, as a part of its longer side.
const MARGIN: f64 = 0.2;

/// A skeleton with its centreline.
struct Lines {
    skeleton: Skeleton,
    centreline: Centreline,
}

pub fn run(args: &CentrelineArgs) -> Result<Outcome, Failure> {
    let targets = output::targets(&args.output, Geojson, &FORMATS)?;
    let mut watch = Watch::start();
    let document = input::document(&args.input)?;
    let items = Item::all(&document, args.input.together);
    watch.lap("read");
    let options = CentrelineOptions::default()
        .prune(args.prune)
        .prune_ratio(args.prune_ratio)
        .longest(args.longest)
        .extend(args.extend);
    let computed = each(&items, |item, figure| {
        let Some(figure) = figure else {
            return Ok(Lines {
                skeleton: compute::empty(args.compute.region()),
                centreline: Centreline::default(),
            });
        };
        let skeleton = compute::skeleton(item, figure, args.compute)?;
        let centreline = skeleton
            .centreline(figure, options)
            .map_err(|e| e.to_string())?;
        Ok(Lines {
            skeleton,
            centreline,
        })
    });
    watch.lap("compute");
    let outcome = report_errors(&computed);
    if !is_hopeless(&computed) {
        for target in &targets {
            write(target, &computed, args)?;
        }
    }
    watch.lap("write");
    if args.compute.stats {
        watch.print_stats(&skeletons_of(computed, |made| made.skeleton));
    }
    Ok(outcome)
}

fn successes(computed: &[Computed<Lines>]) -> impl Iterator<Item = (&FeatureName, &Lines)> {
    computed
        .iter()
        .filter_map(|c| Some((&c.name, c.result.as_ref().ok()?)))
}

fn write(
    target: &Target,
    computed: &[Computed<Lines>],
    args: &CentrelineArgs,
) -> Result<(), Failure> {
    let lines = || successes(computed).map(|(name, lines)| (name.clone(), &lines.centreline));
    match target.format {
        Geojson => target.write(|w| centreline_geojson(w, lines())),
        Wkt => target.write(|w| {
            lines().try_for_each(|(_, lines)| centreline_wkt(&mut *w, lines, args.measure.into()))
        }),
        _ => target.picture(&picture(computed, args), args.look.size.size),
    }
}

fn picture<'a>(computed: &'a [Computed<Lines>], args: &CentrelineArgs) -> Picture<'a> {
    let mut picture = Picture::new();
    for (_, one) in successes(computed) {
        picture.skeleton(&one.skeleton);
        for line in one.centreline.lines() {
            picture.line(OffsetLine {
                distance: 0.0,
                points: line.points().iter().map(|&[x, y, _]| [x, y]).collect(),
                is_closed: false,
            });
        }
    }
    // Outside of polygons a centreline can go very far, and the input would be a dot.
    let is_inside = |(_, one): (_, &Lines)| one.skeleton.region() == Region::Interior;
    let input = successes(computed).flat_map(|(_, Lines { skeleton, .. })| {
        let nodes = skeleton.nodes().iter().take(skeleton.input().vertices);
        nodes.map(|node| [node.x, node.y])
    });
    if !successes(computed).all(is_inside)
        && let Some(window) = Window::around(input)
    {
        picture.window(window.enlarged(MARGIN));
    }
    picture.layers(args.look.layers());
    picture
}
