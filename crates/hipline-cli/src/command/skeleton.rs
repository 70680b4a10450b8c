//! `hipline skeleton`

use std::io;

use hipline::Skeleton;
use hipline_io::write::{ObjWriter, Picture, ResultsJson, geojson, json, wkt};

use crate::{
    args::{
        OutputFormat::{self, Geojson, Json, Obj, Png, Svg, Wkt},
        PictureArgs, SkeletonArgs,
    },
    compute::{Computed, Watch, is_hopeless, report_errors, skeletons, successes},
    failure::{Failure, Outcome},
    input::{self, Item},
    output::{self, Target},
};

const FORMATS: [OutputFormat; 6] = [Json, Geojson, Wkt, Obj, Svg, Png];

pub fn run(args: &SkeletonArgs) -> Result<Outcome, Failure> {
    let targets = output::targets(&args.output, Json, &FORMATS)?;
    super::warn_of_labels(args.picture.labels, &targets);
    if args.chain.is_some() && !args.compute.engine.is_for_chains() {
        let message = "--chain is for the monotone engine: no other one computes chains";
        return Err(Failure::Usage(message.to_owned()));
    }
    let mut watch = Watch::start();
    let document = input::weighted(&args.input, &args.gables)?;
    let items = Item::all(&document, args.input.together);
    watch.lap("read");
    let computed = skeletons(&items, args.compute, args.chain);
    watch.lap("compute");
    let outcome = report_errors(&computed);
    if !is_hopeless(&computed) {
        for target in &targets {
            write(target, &computed, args.picture)?;
        }
    }
    watch.lap("write");
    if args.compute.stats {
        watch.print_stats(&computed);
    }
    Ok(outcome)
}

fn write(target: &Target, computed: &[Computed], look: PictureArgs) -> Result<(), Failure> {
    match target.format {
        Json => target.write(|mut w| match computed {
            [
                Computed {
                    result: Ok(only), ..
                },
            ] => json(w, only),
            _ => results(&mut w, computed),
        }),
        Geojson => {
            target.write(|w| geojson(w, successes(computed).map(|(name, s)| (name.clone(), s))))
        }
        Wkt => target
            .write(|w| successes(computed).try_for_each(|(_, skeleton)| wkt(&mut *w, skeleton))),
        Obj => target.write(|w| {
            let mut objects = ObjWriter::new(w, 1.0);
            successes(computed).try_for_each(|(name, s)| objects.push(Some(name), s))
        }),
        _ => {
            let mut picture = picture(successes(computed).map(|(_, s)| s));
            target.picture(picture.layers(look.layers()), look.size.size)
        }
    }
}

fn results(w: &mut dyn io::Write, computed: &[Computed]) -> io::Result<()> {
    let mut results = ResultsJson::new(w)?;
    for Computed { name, result, .. } in computed {
        results.push(name, result.as_ref().map_err(String::as_str))?;
    }
    results.finish().map(|_| ())
}

/// All skeletons in one picture.
pub fn picture<'a>(skeletons: impl Iterator<Item = &'a Skeleton>) -> Picture<'a> {
    let mut picture = Picture::new();
    for skeleton in skeletons {
        picture.skeleton(skeleton);
    }
    picture
}
