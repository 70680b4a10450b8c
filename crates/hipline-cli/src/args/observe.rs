//! What the surface over a figure can be asked for.

use std::path::PathBuf;

use clap::{Args as Group, Parser, ValueEnum};
use hipline_io::Format;

use super::{
    ComputeArgs, InputArgs, OutputArgs, SizeArgs, WeightArgs, finite, input_format, positive, slope,
};

/// Where the input comes from; its features share one plane.
#[derive(Debug, Group)]
pub struct PlaneArgs {
    /// The file to read: GeoJSON, WKT, GraphML, .line, .poly or OBJ; `-` is standard input. All
    /// features lie in one plane
    #[arg(value_name = "IN")]
    pub path: PathBuf,

    /// The format of the input [default: by its name, else by a look at it]
    #[arg(long, value_name = "FORMAT", value_parser = input_format())]
    pub from: Option<Format>,

    #[command(flatten)]
    pub weights: WeightArgs,
}

impl PlaneArgs {
    pub fn input(&self) -> InputArgs {
        InputArgs {
            path: self.path.clone(),
            from: self.from,
            together: true,
            weights: self.weights.clone(),
        }
    }
}

/// How high the surface is.
#[derive(Debug, Clone, Copy, Group)]
pub struct SurfaceArgs {
    /// How steep: an angle as 45deg, or rise over run as 0.7
    #[arg(short, long, value_name = "SLOPE", default_value = "1",
          allow_hyphen_values = true, value_parser = slope)]
    pub slope: f64,

    /// How high the input lies
    #[arg(long, value_name = "HEIGHT", default_value_t = 0.0,
          allow_hyphen_values = true, value_parser = finite)]
    pub elevation: f64,
}

impl SurfaceArgs {
    /// The height at a time.
    pub fn height(self, time: f64) -> f64 {
        self.slope.mul_add(time, self.elevation)
    }
}

/// A rectangle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Corners(pub [f64; 4]);

/// Which points to ask about.
#[derive(Debug, Group)]
pub struct PointArgs {
    /// A point, or a place that a drop falls on; may be given several times
    #[arg(long, value_name = "X,Y", allow_hyphen_values = true, value_parser = point)]
    pub at: Vec<[f64; 2]>,

    /// A file with a point in each line: x and y, with commas, semicolons or spaces between
    /// them. A first line without numbers is skipped
    #[arg(long, value_name = "FILE")]
    pub points: Option<PathBuf>,
}

/// Turn rivers, lakes and coasts into a terrain.
///
/// The surface rises from the input with the given slope, as a roof does from its eaves.
/// Writes a mesh (obj), a raster (asc: ESRI ASCII grid; tif: GeoTIFF), contour lines (geojson), or
/// a shaded relief (svg, png).
///
/// Without -o, OBJ goes to standard output.
#[derive(Debug, Parser)]
#[command(after_help = "\
Examples:
  hipline terrain rivers.geojson -o relief.png --contours 5
  hipline terrain rivers.geojson --slope 2deg --cell 0.5 -o heights.tif
  hipline terrain rivers.geojson --window 0,0,40,30 --contours 2 -o contours.geojson
  hipline terrain island.geojson --side interior --slope 10deg -o island.obj")]
pub struct TerrainArgs {
    #[command(flatten)]
    pub input: PlaneArgs,
    #[command(flatten)]
    pub surface: SurfaceArgs,

    /// The part of the plane [default: around the input, with a margin]
    #[arg(short, long, value_name = "X0,Y0,X1,Y1", allow_hyphen_values = true, value_parser = corners)]
    pub window: Option<Corners>,

    /// The side of a cell of a raster [default: a 500th of the window's longer side]
    #[arg(long, value_name = "SIDE", allow_hyphen_values = true, value_parser = positive)]
    pub cell: Option<f64>,

    /// The height between contour lines [default in geojson: about a tenth of all; in pictures: none]
    #[arg(long, value_name = "HEIGHT", allow_hyphen_values = true, value_parser = positive)]
    pub contours: Option<f64>,

    #[command(flatten)]
    pub compute: ComputeArgs,
    #[command(flatten)]
    pub output: OutputArgs,
    #[command(flatten, next_help_heading = "Pictures")]
    pub size: SizeArgs,
}

/// Follow rain: the path of a drop, or what drains where.
///
/// With --at or --points, writes the path that a drop takes from each point down to the input
/// (geojson, csv, tsv, svg, png). With --catchments, writes what of the window drains into each
/// side of an edge, each feature, or each river system, with its area, as polygons (geojson), a table
/// (csv, tsv), or a picture (svg, png).
///
/// Without -o, GeoJSON goes to standard output.
#[derive(Debug, Parser)]
#[command(after_help = "\
Examples:
  hipline rain rivers.geojson --at 3,4 --at 7.5,2
  hipline rain rivers.geojson --points wells.csv -o paths.geojson -o paths.png
  hipline rain rivers.geojson --catchments system -o basins.png -o basins.csv
  hipline rain rivers.geojson --catchments edge --window 0,0,40,30 > faces.geojson")]
#[command(group = clap::ArgGroup::new("what").required(true).multiple(true).args(["at", "points", "catchments"]))]
pub struct RainArgs {
    #[command(flatten)]
    pub input: PlaneArgs,

    #[command(flatten)]
    pub points: PointArgs,

    /// What drains into each of these
    #[arg(long, value_name = "OF", conflicts_with_all = ["at", "points"])]
    pub catchments: Option<Drained>,

    #[command(flatten)]
    pub surface: SurfaceArgs,

    /// The part of the plane [default: around the input, with a margin]
    #[arg(short, long, value_name = "X0,Y0,X1,Y1", allow_hyphen_values = true, value_parser = corners)]
    pub window: Option<Corners>,

    #[command(flatten)]
    pub compute: ComputeArgs,
    #[command(flatten)]
    pub output: OutputArgs,
    #[command(flatten, next_help_heading = "Pictures")]
    pub size: SizeArgs,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum Drained {
    /// Each side of each input edge, and each end of a line
    Edge,
    /// Each feature of the file
    Feature,
    /// Each connected component of the input
    System,
}

/// Ask for height, face and input edge at points.
///
/// Points on the command line, in a file, or the centres of a grid's cells. Writes a table (csv, tsv)
/// or json, one row a point: x, y, height, face, edge, side, and the edge as the file has it: its feature,
/// part, ring, and number. A point that is not covered has an empty height.
///
/// Without -o, CSV goes to standard output.
#[derive(Debug, Parser)]
#[command(after_help = "\
Examples:
  hipline query rivers.geojson --at 3,4 --at 7.5,2
  hipline query house.geojson --points chimneys.csv --slope 35deg --format json
  hipline query rivers.geojson --grid 0.5 --window 0,0,40,30 -o heights.csv")]
#[command(group = clap::ArgGroup::new("where").required(true).multiple(true).args(["at", "points", "grid"]))]
pub struct QueryArgs {
    #[command(flatten)]
    pub input: PlaneArgs,

    #[command(flatten)]
    pub points: PointArgs,

    /// The centres of square cells with this side
    #[arg(long, value_name = "SIDE", allow_hyphen_values = true, value_parser = positive,
          conflicts_with_all = ["at", "points"])]
    pub grid: Option<f64>,

    #[command(flatten)]
    pub surface: SurfaceArgs,

    /// The part of the plane that the grid covers [default: around the input, with a margin]
    #[arg(short, long, value_name = "X0,Y0,X1,Y1", allow_hyphen_values = true, value_parser = corners)]
    pub window: Option<Corners>,

    #[command(flatten)]
    pub compute: ComputeArgs,
    #[command(flatten)]
    pub output: OutputArgs,
}

fn numbers<const N: usize>(text: &str) -> Result<[f64; N], String> {
    let parts: Result<Vec<f64>, String> = text.split(',').map(finite).collect();
    parts?
        .try_into()
        .map_err(|_| format!("these are not {N} numbers with commas between them"))
}

fn point(text: &str) -> Result<[f64; 2], String> {
    numbers(text)
}

fn corners(text: &str) -> Result<Corners, String> {
    let [x0, y0, x1, y1] = numbers(text)?;
    if x0 < x1 && y0 < y1 {
        Ok(Corners([x0, y0, x1, y1]))
    } else {
        Err("the window has no area: the lower left corner is first".to_owned())
    }
}
