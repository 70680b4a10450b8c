//! What can be asked for. Help, completions and the man page derive from here.

mod compute;
mod observe;

use std::path::PathBuf;

use clap::{
    Args as Group, Parser, Subcommand, ValueEnum,
    builder::{PossibleValuesParser, TypedValueParser},
};
use hipline_io::{
    Format,
    write::{Layers, Measure},
};

use crate::parse::{
    GableArg, RoofEdge, distance, edge_slope, elevation, finite, gable, positive, slope,
};
pub use compute::{ChainArg, ComputeArgs, SideArg};
pub use observe::{Corners, Drained, PlaneArgs, PointArgs, QueryArgs, RainArgs, TerrainArgs};

mod motorcycles;
pub use motorcycles::MotorcyclesArgs;
mod weights;
pub use weights::{GableArgs, HeightsArg, WeightArgs};

const EXAMPLES: &str = "\
Examples:
  hipline skeleton village.geojson -o village.svg
  hipline offset park.wkt --step 0.5 -o park.png
  hipline centreline river.geojson --prune-ratio 1 --extend -o middle.geojson
  hipline roof house.geojson --slope 35deg -o house.obj -o house.png
  hipline terrain rivers.geojson -o relief.png --contours 5
  hipline rain rivers.geojson --catchments system -o basins.png
  hipline query rivers.geojson --at 3,4
  hipline motorcycles village.geojson -o tracks.svg
  hipline skeleton parcels.geojson > parcels.json
  hipline check parcels.geojson --result parcels.json

Exit codes:
  0  done
  1  something is wrong with the input: a file, a feature, or a result
  2  wrong usage";

/// Exact straight skeletons of polygons, lines and planar graphs, with weights.
#[derive(Debug, Parser)]
#[command(name = "hipline", version, after_help = EXAMPLES, max_term_width = 100)]
pub struct Args {
    #[command(subcommand)]
    pub command: Command,
}

#[derive(Debug, Subcommand)]
pub enum Command {
    Skeleton(SkeletonArgs),
    Offset(OffsetArgs),
    Centreline(CentrelineArgs),
    Roof(RoofArgs),
    Terrain(TerrainArgs),
    Rain(RainArgs),
    Query(QueryArgs),
    Motorcycles(MotorcyclesArgs),
    Check(CheckArgs),
    Draw(DrawArgs),
    Completions(CompletionsArgs),
    /// Print the man page.
    #[command(hide = true)]
    Man,
}

/// Where the input comes from.
#[derive(Debug, Group)]
pub struct InputArgs {
    /// The file to read: GeoJSON, WKT, GraphML, .line, .poly or OBJ; `-` is standard input
    #[arg(value_name = "IN")]
    pub path: PathBuf,

    /// The format of the input [default: by its name, else by a look at it]
    #[arg(long, value_name = "FORMAT", value_parser = input_format())]
    pub from: Option<Format>,

    /// Take all features as one graph: their wavefronts meet
    #[arg(long)]
    pub together: bool,

    #[command(flatten)]
    pub weights: WeightArgs,
}

fn input_format() -> impl TypedValueParser<Value = Format> {
    PossibleValuesParser::new(Format::ALL.map(|format| format.extensions()[0]))
        .try_map(|name| name.parse::<Format>())
}

/// Where the output goes.
#[derive(Debug, Group)]
pub struct OutputArgs {
    /// A file to write, in the format that its extension tells; may be given several times;
    /// `-` is standard output
    #[arg(short, long, value_name = "OUT")]
    pub output: Vec<PathBuf>,

    /// The format of the output, whatever it is called
    #[arg(short, long, value_name = "FORMAT")]
    pub format: Option<OutputFormat>,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum OutputFormat {
    /// The full result, exact
    Json,
    /// Points, lines and polygons for maps
    Geojson,
    /// Lines as well-known text
    Wkt,
    /// A surface for 3D programs
    Obj,
    /// A raster of heights as text, for maps: an ESRI ASCII grid
    Asc,
    /// A raster of heights for maps: GeoTIFF
    #[value(alias = "tiff")]
    Tif,
    /// A table, with commas
    Csv,
    /// A table, with tabs
    Tsv,
    /// A mesh of triangles, with coordinates of 64 bits
    Ply,
    /// Triangles for printers, with coordinates of 32 bits
    Stl,
    /// A scene for viewers, binary glTF
    Glb,
    /// The same as JSON
    Gltf,
    /// Buildings with roof, wall and ground surfaces (.city.json)
    Cityjson,
    /// A drawing that scales
    Svg,
    /// A drawing in pixels
    Png,
}

/// How pictures look.
#[derive(Debug, Clone, Copy, Group)]
#[command(next_help_heading = "Pictures")]
pub struct PictureArgs {
    /// Write the ids of nodes, arcs, faces and edges into an SVG
    #[arg(long)]
    pub labels: bool,

    /// Leave out the faces
    #[arg(long)]
    pub no_faces: bool,

    /// Leave out the arcs
    #[arg(long)]
    pub no_arcs: bool,

    /// Leave out the ghost arcs, which separate faces of one plane
    #[arg(long)]
    pub no_ghosts: bool,

    /// Leave out the input's edges
    #[arg(long)]
    pub no_input: bool,

    /// Leave out the nodes
    #[arg(long)]
    pub no_nodes: bool,

    #[command(flatten)]
    pub size: SizeArgs,
}

impl PictureArgs {
    pub fn layers(self) -> Layers {
        Layers {
            faces: !self.no_faces,
            arcs: !self.no_arcs,
            ghosts: !self.no_ghosts,
            input: !self.no_input,
            nodes: !self.no_nodes,
            labels: self.labels,
        }
    }
}

#[derive(Debug, Clone, Copy, Group)]
pub struct SizeArgs {
    /// The longer side of a PNG picture, in pixels
    #[arg(long, value_name = "PIXELS", default_value_t = 1600,
          value_parser = clap::value_parser!(u32).range(1..=16384))]
    pub size: u32,
}

/// How pictures of lines look.
#[derive(Debug, Clone, Copy, Group)]
pub struct LineLookArgs {
    /// Draw the skeleton under the lines
    #[arg(long)]
    pub skeleton: bool,
    #[command(flatten)]
    pub size: SizeArgs,
}

impl LineLookArgs {
    /// What of the skeleton is drawn.
    pub fn layers(self) -> Layers {
        Layers {
            faces: self.skeleton,
            arcs: self.skeleton,
            ghosts: self.skeleton,
            nodes: false,
            ..Layers::default()
        }
    }
}

/// Compute the straight skeletons of a file's features.
///
/// Without -o, the result goes to standard output as JSON. The other formats hold less:
/// GeoJSON the nodes, arcs and faces, WKT the arcs, OBJ the roof of slope 1.
///
/// A feature that is not a planar straight-line graph is reported and left out; the others
/// are written, and the exit code is 1.
#[derive(Debug, Parser)]
#[command(after_help = "\
Examples:
  hipline skeleton village.geojson -o village.svg
  hipline skeleton coast.wkt --side exterior -o coast.json --stats
  hipline skeleton stars.geojson --modified --side both -o stars.svg
  hipline skeleton house.geojson --gable 1 --gable 3 -o house.svg
  hipline skeleton house.geojson --profile 0:1,2.5:4 -o mansard.svg
  hipline skeleton streets.graphml --format geojson > faces.geojson
  echo 'POLYGON ((0 0, 8 0, 8 4, 0 4))' | hipline skeleton - -o plan.svg --labels")]
pub struct SkeletonArgs {
    #[command(flatten)]
    pub input: InputArgs,
    #[command(flatten)]
    pub gables: GableArgs,
    #[command(flatten)]
    pub compute: ComputeArgs,

    /// Take lines as monotone chains whose ends go on for ever; one side of them
    #[arg(long, value_name = "SIDE", conflicts_with_all = ["side", "modified"])]
    pub chain: Option<ChainArg>,

    #[command(flatten)]
    pub output: OutputArgs,
    #[command(flatten)]
    pub picture: PictureArgs,
}

/// Move a figure's edges by given distances.
///
/// Writes pictures (svg, png) of the offsets over the figure, or polygons with holes (geojson,
/// wkt): what remains of an interior; around the outside of polygons and around lines, the figure
/// grown. Each has its distance: as a property in GeoJSON, as height in WKT.
///
/// Without -o, GeoJSON goes to standard output.
#[derive(Debug, Parser)]
#[command(after_help = "\
Examples:
  hipline offset park.geojson --distance 1,2.5 -o paths.geojson
  hipline offset park.geojson --step 0.5 -o park.svg
  hipline offset lake.wkt --side exterior --step 10 --count 5 -o shore.png")]
#[command(group = clap::ArgGroup::new("how_far").required(true).args(["distance", "step"]))]
pub struct OffsetArgs {
    #[command(flatten)]
    pub input: InputArgs,
    #[command(flatten)]
    pub gables: GableArgs,

    /// Distances, in input units, with commas between them
    #[arg(short, long, value_name = "D,...", value_delimiter = ',',
          allow_hyphen_values = true, value_parser = distance)]
    pub distance: Vec<f64>,

    /// Every multiple of this distance until nothing is left, or --count of them
    #[arg(long, value_name = "D", allow_hyphen_values = true, value_parser = positive)]
    pub step: Option<f64>,

    /// How many steps; needed where offsets never end
    #[arg(long, value_name = "N", requires = "step", conflicts_with = "distance",
          value_parser = clap::value_parser!(u32).range(1..=1_000_000))]
    pub count: Option<u32>,

    /// Tell in GeoJSON which input edge each edge comes from, as [part, ring, edge]
    #[arg(long)]
    pub edges: bool,

    #[command(flatten)]
    pub compute: ComputeArgs,
    #[command(flatten)]
    pub output: OutputArgs,
    #[command(flatten, next_help_heading = "Pictures")]
    pub look: LineLookArgs,
}

/// Find the line in the middle: the approximate medial axis.
///
/// Writes lines between the places where it ends or branches, as data (geojson, wkt) or over the
/// figure (svg, png). Each point has its time, half the local width: as height in GeoJSON, as
/// --measure says in WKT. GeoJSON has the widths and the length as properties, too.
///
/// A branch runs from an end inwards until it meets a longer one, or a cycle. Neither cycles nor
/// the longest branch of a part without cycles are ever dropped.
///
/// Without -o, GeoJSON goes to standard output.
#[derive(Debug, Parser)]
#[command(after_help = "\
Examples:
  hipline centreline river.geojson --prune-ratio 1 --extend -o middle.geojson
  hipline centreline lake.wkt --longest -o label.wkt --measure m
  hipline centreline streets.geojson --prune 12 -o streets.svg --skeleton")]
pub struct CentrelineArgs {
    #[command(flatten)]
    pub input: InputArgs,

    /// Drop branches shorter than this, in input units
    #[arg(long, value_name = "LENGTH", default_value_t = 0.0,
          allow_hyphen_values = true, value_parser = distance)]
    pub prune: f64,

    /// Drop branches shorter than so many times the width where they end
    #[arg(long, value_name = "RATIO", default_value_t = 0.0,
          allow_hyphen_values = true, value_parser = distance)]
    pub prune_ratio: f64,

    /// Keep the longest branch only; where there are holes, the cycles and what joins them
    #[arg(long)]
    pub longest: bool,

    /// Carry the ends on to the boundary
    #[arg(long)]
    pub extend: bool,

    /// What the numbers after x and y are in WKT
    #[arg(long, value_name = "MEASURE", default_value = "zm")]
    pub measure: MeasureArg,

    #[command(flatten)]
    pub compute: ComputeArgs,
    #[command(flatten)]
    pub output: OutputArgs,
    #[command(flatten, next_help_heading = "Pictures")]
    pub look: LineLookArgs,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum MeasureArg {
    /// LINESTRING Z: the time
    Z,
    /// LINESTRING M: the time
    M,
    /// LINESTRING ZM: the time and the width
    Zm,
}

impl From<MeasureArg> for Measure {
    fn from(measure: MeasureArg) -> Self {
        match measure {
            MeasureArg::Z => Self::Z,
            MeasureArg::M => Self::M,
            MeasureArg::Zm => Self::Zm,
        }
    }
}

/// Build roofs over polygons.
///
/// Writes a mesh (obj, ply, stl, glb, gltf, cityjson), a view from the side (png) or a plan (svg).
/// The mesh is a closed solid, each feature an object of its own. What the flags leave open, the
/// OpenStreetMap tags of a feature decide: roof:shape, roof:angle, roof:height, height,
/// min_height.
///
/// Without -o, OBJ goes to standard output.
#[derive(Debug, Parser)]
#[command(after_help = "\
Examples:
  hipline roof house.geojson -o house.obj
  hipline roof house.geojson --slope 35deg --eaves 6 --overhang 0.5 -o house.glb -o house.png
  hipline roof village.geojson --height 4 --eaves 5 -o village.city.json
  hipline roof village.geojson --slope 0.7 --open --triangles > village.obj")]
pub struct RoofArgs {
    #[command(flatten)]
    pub input: InputArgs,

    /// The shape of the roofs [default: as tagged, else hip]
    #[arg(long, value_name = "SHAPE")]
    pub shape: Option<ShapeArg>,

    /// How steep: an angle as 35 or 35deg, or rise over run as 1:2 or 0.7; below 3 a number
    /// without unit is a ratio [default: as tagged, else 45deg]
    #[arg(short, long, value_name = "SLOPE", allow_hyphen_values = true, value_parser = slope)]
    pub slope: Option<f64>,

    /// How high the roof is from eaves to ridge, in place of a slope
    #[arg(long, value_name = "HEIGHT", conflicts_with = "slope", allow_hyphen_values = true,
          value_parser = positive)]
    pub height: Option<f64>,

    /// The slope of an edge, in place of the common one; may be given several times.
    /// An edge is its number, or RING/EDGE, or PART/RING/EDGE, all from 0
    #[arg(long, value_name = "EDGE=SLOPE", allow_hyphen_values = true, value_parser = edge_slope)]
    pub edge_slope: Vec<(RoofEdge, f64)>,

    /// Which edges carry gables: auto (the short ends), none, or edges with commas between
    #[arg(long, value_name = "EDGES", value_parser = gable)]
    pub gable: Option<GableArg>,

    /// The slope of a mansard or gambrel roof below its break [default: 3:1]
    #[arg(long, value_name = "SLOPE", value_parser = slope)]
    pub lower_slope: Option<f64>,

    /// The height of the break of a mansard or gambrel roof above the eaves [default: 2]
    #[arg(long, value_name = "HEIGHT", value_parser = positive)]
    pub break_height: Option<f64>,

    /// The height at which the roof meets the walls [default: as tagged, else that of the floor]
    #[arg(long, value_name = "HEIGHT", allow_hyphen_values = true, value_parser = finite)]
    pub eaves: Option<f64>,

    /// How far the roof reaches beyond the walls
    #[arg(long, value_name = "DISTANCE", default_value_t = 0.0,
          allow_hyphen_values = true, value_parser = distance)]
    pub overhang: f64,

    /// The height of the floor [default: as tagged, else 0]
    #[arg(long, value_name = "HEIGHT", allow_hyphen_values = true, value_parser = finite)]
    pub floor: Option<f64>,

    /// Leave out the floor
    #[arg(long)]
    pub no_floor: bool,

    /// Leave out the walls
    #[arg(long)]
    pub no_walls: bool,

    /// Leave out floor and walls: only the facets of the roof
    #[arg(long)]
    pub open: bool,

    /// Do not look at tags
    #[arg(long)]
    pub no_tags: bool,

    /// In OBJ, cut every facet into triangles
    #[arg(long)]
    pub triangles: bool,

    /// Write PLY as text
    #[arg(long)]
    pub ascii: bool,

    /// Print counts and times to standard error
    #[arg(long)]
    pub stats: bool,

    #[command(flatten)]
    pub output: OutputArgs,

    /// From where to look: 0 from the south, 90 from the east, in degrees
    #[arg(long, value_name = "DEGREES", default_value_t = 28.0,
          allow_hyphen_values = true, value_parser = finite, help_heading = "Pictures")]
    pub azimuth: f64,

    /// From how high to look: 0 level, 90 from above, in degrees
    #[arg(long, value_name = "DEGREES", default_value_t = 34.0,
          value_parser = elevation, help_heading = "Pictures")]
    pub elevation: f64,

    #[command(flatten, next_help_heading = "Pictures")]
    pub size: SizeArgs,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum ShapeArg {
    /// Every edge rises
    Hip,
    /// Some edges carry gables
    Gable,
    /// Steep below, flatter above
    Mansard,
    /// Steep below, flatter above, between gables
    Gambrel,
    /// Level
    Flat,
}

/// Check an input, or a result against it.
///
/// Every flaw of every feature is listed. With --result, the skeletons of a JSON file are
/// held against the laws that the skeletons of the input obey: exactly, and independently of
/// how they were computed.
#[derive(Debug, Parser)]
#[command(after_help = "\
Examples:
  hipline check parcels.geojson
  hipline skeleton parcels.geojson -o parcels.json && hipline check parcels.geojson --result parcels.json")]
pub struct CheckArgs {
    #[command(flatten)]
    pub input: InputArgs,
    #[command(flatten)]
    pub gables: GableArgs,

    /// The JSON that `hipline skeleton` made of the input (with --together if so)
    #[arg(long, value_name = "JSON")]
    pub result: Option<PathBuf>,
}

/// Draw an input or a skeleton as it is, without computing.
#[derive(Debug, Parser)]
#[command(after_help = "\
Examples:
  hipline draw parcels.geojson -o parcels.svg --labels
  hipline draw skeletons.json -o roof.png --no-nodes --size 800")]
pub struct DrawArgs {
    #[command(flatten)]
    pub input: InputArgs,
    #[command(flatten)]
    pub gables: GableArgs,
    #[command(flatten)]
    pub output: OutputArgs,
    #[command(flatten)]
    pub picture: PictureArgs,
}

/// Print a script that completes hipline's commands and flags in a shell.
#[derive(Debug, Parser)]
#[command(after_help = "\
Example:
  hipline completions bash > ~/.local/share/bash-completion/completions/hipline")]
pub struct CompletionsArgs {
    /// For which shell
    pub shell: clap_complete::Shell,
}

#[cfg(test)]
mod tests {
    use super::*;
    use clap::CommandFactory;

    #[test]
    fn the_definition_is_consistent() {
        Args::command().debug_assert();
    }
}
