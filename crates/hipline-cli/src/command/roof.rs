//! `hipline roof`

use std::collections::BTreeSet;

use hipline::{
    Figure, Region, Skeleton,
    input::Source,
    roof::{Gables, Mesh, RoofOptions, RoofShape, Steepness},
    skeleton::Options,
};
use hipline_io::write::{
    Building, Layers, PlyEncoding, RoofView, mesh_cityjson, mesh_glb, mesh_gltf, mesh_obj,
    mesh_ply, mesh_stl, roof_png,
};
use serde_json::{Map, Value};

use crate::{
    args::{
        OutputFormat::{self, Cityjson, Glb, Gltf, Obj, Ply, Png, Stl, Svg},
        RoofArgs, ShapeArg,
    },
    compute::{Computed, Watch, each, empty, is_hopeless, report_errors, skeletons_of},
    failure::{Failure, Outcome, warn},
    input::{self, Item},
    output::{self, Target, picture_error},
    parse::{GableArg, RoofEdge},
    tags::Tags,
};

const FORMATS: [OutputFormat; 8] = [Obj, Ply, Stl, Glb, Gltf, Cityjson, Png, Svg];

/// What is made of an item.
struct House {
    /// For the plan and the statistics.
    skeleton: Skeleton,
    /// None of an empty geometry.
    mesh: Option<Mesh>,
    /// For the picture, with walls where nothing says how high they are.
    view: Option<Mesh>,
}

pub fn run(args: &RoofArgs) -> Result<Outcome, Failure> {
    let targets = output::targets(&args.output, Obj, &FORMATS)?;
    let mut watch = Watch::start();
    let document = input::document(&args.input)?;
    let items = Item::all(&document, args.input.together);
    warn_of_shapes(&items);
    watch.lap("read");
    let needs = |formats: &[OutputFormat]| targets.iter().any(|t| formats.contains(&t.format));
    let has_plan = needs(&[Svg]) || args.stats;
    let has_view = needs(&[Png]);
    let computed = each(&items, |item, figure| {
        let skeleton = match figure {
            Some(figure) if has_plan => figure.skeleton(Options::default().region(Region::Auto)),
            _ => empty(Region::Auto),
        };
        // Nothing has no roof, and that is no error.
        let Some(figure) = figure else {
            return Ok(House {
                skeleton,
                mesh: None,
                view: None,
            });
        };
        let (options, has_eaves) = options(figure, properties(item), args)?;
        let mesh = figure.roof(&options).map_err(|e| e.to_string())?;
        let view = (has_view && !has_eaves).then(|| with_walls(figure, &options, &mesh));
        Ok(House {
            skeleton,
            mesh: Some(mesh),
            view: view.flatten(),
        })
    });
    watch.lap("compute");
    let outcome = report_errors(&computed);
    if !is_hopeless(&computed) {
        for target in &targets {
            write(target, &items, &computed, args)?;
        }
    }
    watch.lap("write");
    if args.stats {
        watch.print_stats(&skeletons_of(computed, |made| made.skeleton));
    }
    Ok(outcome)
}

fn properties<'a>(item: &Item<'a>) -> Option<&'a Map<String, Value>> {
    match item {
        Item::Feature(feature, _) => Some(&feature.properties),
        Item::Together(_) => None,
    }
}

/// One warning for each shape that tags name and nobody knows.
fn warn_of_shapes(items: &[Item]) {
    let unknown: BTreeSet<String> = items
        .iter()
        .filter_map(|item| Tags::read(properties(item)?).ok()?.1)
        .collect();
    for shape in unknown {
        warn(format_args!(
            "roof:shape {shape} is not known; such roofs get the shape that --shape says, or hips"
        ));
    }
}

/// Flags override tags, and tags override defaults. Also whether anything tells the height of the
/// walls.
fn options(
    figure: &Figure,
    properties: Option<&Map<String, Value>>,
    args: &RoofArgs,
) -> Result<(RoofOptions, bool), String> {
    let tags = match properties {
        Some(properties) if !args.no_tags => Tags::read(properties)?.0,
        _ => Tags::default(),
    };
    let mut options = RoofOptions {
        overhang: args.overhang,
        walls: !args.open && !args.no_walls,
        floor: !args.open && !args.no_floor,
        ..RoofOptions::default()
    };
    options.shape = match args.shape {
        Some(ShapeArg::Hip) => RoofShape::Hip,
        Some(ShapeArg::Gable) => RoofShape::Gable,
        Some(ShapeArg::Mansard) => RoofShape::Mansard,
        Some(ShapeArg::Gambrel) => RoofShape::Gambrel,
        Some(ShapeArg::Flat) => RoofShape::Flat,
        None => tags.shape.unwrap_or_default(),
    };
    match &args.gable {
        None => {}
        // Without gables, a gable roof is a hip roof, and a gambrel roof a mansard roof.
        Some(GableArg::None) => match options.shape {
            RoofShape::Gable => options.shape = RoofShape::Hip,
            RoofShape::Gambrel => options.shape = RoofShape::Mansard,
            _ => {}
        },
        Some(GableArg::Auto) if options.shape == RoofShape::Hip => options.shape = RoofShape::Gable,
        Some(GableArg::Auto) => {}
        Some(GableArg::Edges(edges)) => {
            if options.shape == RoofShape::Hip {
                options.shape = RoofShape::Gable;
            }
            options.gables = Gables::Edges(edges.iter().map(source).collect());
        }
    }
    options.edge_slopes = args
        .edge_slope
        .iter()
        .map(|(e, s)| (source(e), *s))
        .collect();
    options.lower_slope = args.lower_slope.unwrap_or(options.lower_slope);
    options.break_height = args.break_height.unwrap_or(options.break_height);
    options.steepness = match (args.height, args.slope, tags.roof_height, tags.slope) {
        (Some(height), ..) => Steepness::Height(height),
        (_, Some(slope), ..) => Steepness::Slope(slope),
        (.., Some(height), _) if height > 0.0 => Steepness::Height(height),
        (.., Some(slope)) => Steepness::Slope(slope),
        _ => Steepness::Slope(1.0),
    };
    options.ground = args.floor.or(tags.min_height).unwrap_or(0.0);
    let is_flat = options.shape == RoofShape::Flat;
    let eaves = match (args.eaves, tags.height) {
        (Some(eaves), _) => Some(eaves),
        (_, Some(height)) if is_flat => Some(height),
        (_, Some(height)) => Some(height - roof_height(figure, &options)?),
        _ => None,
    };
    options.eaves = eaves.unwrap_or(options.ground);
    Ok((options, eaves.is_some()))
}

const fn source(edge: &RoofEdge) -> Source {
    Source {
        part: edge.part,
        ring: edge.ring,
        edge: edge.edge,
    }
}

/// How high the roof is above its eaves.
fn roof_height(figure: &Figure, options: &RoofOptions) -> Result<f64, String> {
    match options.steepness {
        Steepness::Height(height) => Ok(height),
        Steepness::Slope(_) => {
            let bare = RoofOptions {
                eaves: 0.0,
                ground: 0.0,
                overhang: 0.0,
                walls: false,
                floor: false,
                ..options.clone()
            };
            let roof = figure.roof(&bare).map_err(|e| e.to_string())?;
            Ok(top(&roof))
        }
    }
}

fn top(mesh: &Mesh) -> f64 {
    mesh.vertices().iter().map(|v| v[2]).fold(0.0, f64::max)
}

/// The same house on walls somewhat lower than its roof, for pictures.
fn with_walls(figure: &Figure, options: &RoofOptions, mesh: &Mesh) -> Option<Mesh> {
    const SHARE: f64 = 0.6;
    let raised = RoofOptions {
        eaves: options.ground + SHARE * (top(mesh) - options.ground),
        ..options.clone()
    };
    figure.roof(&raised).ok()
}

fn write(
    target: &Target,
    items: &[Item],
    computed: &[Computed<House>],
    args: &RoofArgs,
) -> Result<(), Failure> {
    let houses = || computed.iter().filter_map(|c| c.result.as_ref().ok());
    let buildings: Vec<Building> = items
        .iter()
        .zip(computed)
        .filter_map(|(item, c)| {
            Some(Building {
                name: &c.name,
                properties: properties(item),
                mesh: c.result.as_ref().ok()?.mesh.as_ref()?,
            })
        })
        .collect();
    let encoding = if args.ascii {
        PlyEncoding::Ascii
    } else {
        PlyEncoding::Binary
    };
    match target.format {
        Ply => target.write(|w| mesh_ply(w, &buildings, encoding)),
        Stl => target.write(|w| mesh_stl(w, &buildings)),
        Glb => target.write(|w| mesh_glb(w, &buildings)),
        Gltf => target.write(|w| mesh_gltf(w, &buildings)),
        Cityjson => target.write(|w| mesh_cityjson(w, &buildings)),
        Png => {
            let view = RoofView {
                size: args.size.size,
                azimuth: args.azimuth,
                elevation: args.elevation,
            };
            let seen = houses().filter_map(|house| house.view.as_ref().or(house.mesh.as_ref()));
            let list: Vec<&Mesh> = seen.collect();
            target.write(|w| roof_png(w, &list, &view).map_err(picture_error))
        }
        Svg => {
            let mut plan = super::skeleton::picture(houses().map(|house| &house.skeleton));
            plan.layers(Layers {
                nodes: false,
                ghosts: false,
                ..Layers::default()
            });
            target.picture(&plan, args.size.size)
        }
        _ => target.write(|w| mesh_obj(w, &buildings, args.triangles)),
    }
}
