//! `hipline roof`

use hipline::{Region, roof::Mesh, skeleton::Options};
use hipline_io::{
    FeatureName,
    write::{Layers, RoofView, roof_png},
};

use crate::{
    args::{
        OutputFormat::{self, Obj, Png, Svg},
        RoofArgs,
    },
    compute::{self, Computed, Watch, is_hopeless, report_errors, skeletons, successes},
    failure::{Failure, Outcome},
    input::{self, Item},
    mesh,
    output::{self, Target, picture_error},
};

const FORMATS: [OutputFormat; 3] = [Obj, Png, Svg];

pub fn run(args: &RoofArgs) -> Result<Outcome, Failure> {
    let targets = output::targets(&args.output, Obj, &FORMATS)?;
    let mut watch = Watch::start();
    let document = input::document(&args.input)?;
    let items = Item::all(&document, args.input.together);
    watch.lap("read");
    let mut computed = skeletons(&items, Options::default().region(Region::Auto));
    let mut meshes = Vec::new();
    for (item, one) in items.iter().zip(&mut computed) {
        // Nothing has no roof, and that is no error.
        let (Ok(skeleton), true) = (&one.result, one.figure.is_some()) else {
            continue;
        };
        match skeleton.roof(args.slope) {
            Ok(roof) => meshes.push((one.name.clone(), finished(roof, args))),
            Err(error) => one.result = Err(format!("{}: {error}", item.title())),
        }
    }
    watch.lap("compute");
    let outcome = report_errors(&computed);
    if !is_hopeless(&computed) {
        for target in &targets {
            write(target, &computed, &meshes, args)?;
        }
    }
    watch.lap("write");
    if args.stats {
        watch.print_stats(&computed);
    }
    Ok(outcome)
}

fn finished(roof: Mesh, args: &RoofArgs) -> Mesh {
    let mesh = if args.open { roof } else { roof.with_base() };
    if args.triangles {
        mesh.triangulate()
    } else {
        mesh
    }
}

fn write(
    target: &Target,
    computed: &[Computed],
    meshes: &[(FeatureName, Mesh)],
    args: &RoofArgs,
) -> Result<(), Failure> {
    let skeletons = || compute::successes(computed).map(|(_, s)| s);
    match target.format {
        Obj => target.write(|w| mesh::obj(w, meshes.iter().map(|(name, mesh)| (name, mesh)))),
        Png => {
            let view = RoofView {
                size: args.size.size,
                slope: args.slope,
                walls: args.walls,
                azimuth: args.azimuth,
                elevation: args.elevation,
            };
            let list: Vec<_> = skeletons().collect();
            target.write(|w| roof_png(w, &list, &view).map_err(picture_error))
        }
        _ => {
            let mut plan = super::skeleton::picture(successes(computed).map(|(_, s)| s));
            plan.layers(Layers {
                nodes: false,
                ghosts: false,
                ..Layers::default()
            });
            target.picture(&plan, args.size.size)
        }
    }
}
