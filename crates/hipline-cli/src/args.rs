//! What can be asked for. Help, completions and the man page derive from here.

use std::path::PathBuf;

use clap::{
    Args as Group, Parser, Subcommand, ValueEnum,
    builder::{PossibleValuesParser, TypedValueParser},
};
use hipline::{Region, skeleton::Options};
use hipline_io::{Format, write::Layers};

mod weights;
pub use weights::{GableArgs, HeightsArg, WeightArgs};

const EXAMPLES: &str = "\
Examples:
  hipline skeleton village.geojson -o village.svg
  hipline offset park.wkt --step 0.5 -o park.png
  hipline roof house.geojson --slope 35deg -o house.obj -o house.png
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
    Roof(RoofArgs),
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

/// How skeletons are computed.
#[derive(Debug, Clone, Copy, Group)]
pub struct ComputeArgs {
    /// Which part of the plane [default: the interior of polygons, both sides of lines]
    #[arg(long, value_name = "SIDE")]
    pub side: Option<SideArg>,

    /// The algorithm; all give the same result
    #[arg(long, value_name = "ENGINE", default_value = "auto")]
    pub engine: Engine,

    /// Print counts and times to standard error
    #[arg(long)]
    pub stats: bool,
}

impl ComputeArgs {
    pub fn region(self) -> Region {
        match self.side {
            None => Region::Auto,
            Some(SideArg::Interior) => Region::Interior,
            Some(SideArg::Exterior) => Region::Exterior,
            Some(SideArg::Both) => Region::Both,
        }
    }

    pub fn options(self) -> Options {
        match self.engine {
            Engine::Auto | Engine::Kinetic => Options::default().region(self.region()),
        }
    }
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum SideArg {
    /// The inside of the polygons
    Interior,
    /// The plane without the inside of the polygons
    Exterior,
    /// The whole plane
    Both,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum Engine {
    /// Whichever suits the input
    Auto,
    /// The kinetic triangulation
    Kinetic,
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
    #[command(flatten)]
    pub output: OutputArgs,
    #[command(flatten)]
    pub picture: PictureArgs,
}

/// Move a figure's edges by given distances.
///
/// Writes pictures (svg, png) of the offsets over the figure, or data (geojson, wkt): what
/// remains of an interior as polygons with holes, other offsets as closed lines with the swept
/// part on the left. Each has its distance: as a property in GeoJSON, as height in WKT.
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

    #[command(flatten)]
    pub compute: ComputeArgs,
    #[command(flatten)]
    pub output: OutputArgs,

    /// Draw the skeleton under the offsets
    #[arg(long, help_heading = "Pictures")]
    pub skeleton: bool,
    #[command(flatten, next_help_heading = "Pictures")]
    pub size: SizeArgs,
}

/// Build the hip roof over polygons.
///
/// Writes a mesh (obj), a view from the side (png) or a plan (svg). The mesh is a closed
/// solid, each feature an object of its own; the height of a point is the time at which
/// the wavefront arrives, times the slope.
///
/// Without -o, OBJ goes to standard output.
#[derive(Debug, Parser)]
#[command(after_help = "\
Examples:
  hipline roof house.geojson -o house.obj
  hipline roof house.geojson --slope 35deg -o house.obj -o house.png
  hipline roof village.geojson --slope 0.7 --open --triangles > village.obj")]
pub struct RoofArgs {
    #[command(flatten)]
    pub input: InputArgs,

    /// How steep: an angle as 45deg, or rise over run as 0.7
    #[arg(short, long, value_name = "SLOPE", default_value = "45deg",
          allow_hyphen_values = true, value_parser = slope)]
    pub slope: f64,

    /// Leave out the floor: only the facets of the roof
    #[arg(long)]
    pub open: bool,

    /// Cut every facet into triangles
    #[arg(long)]
    pub triangles: bool,

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

    /// How high the walls are, in input units [default: a little lower than the roof]
    #[arg(long, value_name = "HEIGHT", value_parser = distance, help_heading = "Pictures")]
    pub walls: Option<f64>,

    #[command(flatten, next_help_heading = "Pictures")]
    pub size: SizeArgs,
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

fn number(text: &str) -> Result<f64, String> {
    text.trim()
        .parse::<f64>()
        .map_err(|_| "this is not a number".to_owned())
}

fn finite(text: &str) -> Result<f64, String> {
    let value = number(text)?;
    if value.is_finite() {
        Ok(value)
    } else {
        Err("it must be finite".to_owned())
    }
}

fn distance(text: &str) -> Result<f64, String> {
    let value = finite(text)?;
    if value >= 0.0 {
        Ok(value)
    } else {
        Err("it must not be below 0".to_owned())
    }
}

fn positive(text: &str) -> Result<f64, String> {
    let value = finite(text)?;
    if value > 0.0 {
        Ok(value)
    } else {
        Err("it must be above 0".to_owned())
    }
}

fn elevation(text: &str) -> Result<f64, String> {
    let value = finite(text)?;
    if (0.0..=90.0).contains(&value) {
        Ok(value)
    } else {
        Err("it must be between 0 and 90".to_owned())
    }
}

/// A slope: degrees with a unit, or a ratio without.
fn slope(text: &str) -> Result<f64, String> {
    let degrees = text.strip_suffix("deg").or_else(|| text.strip_suffix('°'));
    let Some(degrees) = degrees else {
        return positive(text);
    };
    let degrees = positive(degrees)?;
    if degrees >= 90.0 {
        return Err("it must be below 90 degrees".to_owned());
    }
    // The tangent of the f64 nearest to pi/4 is not 1.
    if degrees.to_bits() == 45.0_f64.to_bits() {
        return Ok(1.0);
    }
    positive(&degrees.to_radians().tan().to_string())
}

#[cfg(test)]
mod tests {
    use super::*;
    use clap::CommandFactory;

    #[test]
    fn the_definition_is_consistent() {
        Args::command().debug_assert();
    }

    #[test]
    fn slopes() {
        assert_eq!(slope("45deg"), Ok(1.0));
        assert_eq!(slope("45°"), Ok(1.0));
        assert_eq!(slope("0.7"), Ok(0.7));
        let steep = slope("60deg").unwrap();
        assert!((steep * steep - 3.0).abs() < 1e-12, "{steep}");
        for wrong in [
            "", "0", "-1", "nan", "inf", "90deg", "0deg", "deg", "1rad", "1e999",
        ] {
            assert!(slope(wrong).is_err(), "{wrong}");
        }
    }
}
