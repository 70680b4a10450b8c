//! What motorcycle graphs can be asked for.

use std::path::PathBuf;

use clap::Parser;

use super::{InputArgs, OutputArgs, SizeArgs};

/// Compute the motorcycle graphs of polygons, or of motorcycles in a table.
///
/// Each reflex vertex of a polygon sends a motorcycle with the velocity of its wavefront vertex. It stops at
/// the boundary, or where it reaches the track of another one that was there before. Every valley of the
/// roof lies on a track.
///
/// A table (.csv, with the columns x, y, vx, vy, and time if wanted) has motorcycles of any
/// velocities; --walls names a file whose lines and rings stop them.
///
/// Without -o, the result goes to standard output as JSON.
#[derive(Debug, Parser)]
#[command(after_help = "\
Examples:
  hipline motorcycles village.geojson -o tracks.svg
  hipline motorcycles coast.wkt -o tracks.geojson -o tracks.png
  hipline motorcycles race.csv --walls walls.wkt -o race.svg")]
pub struct MotorcyclesArgs {
    #[command(flatten)]
    pub input: InputArgs,

    /// The input is a table of motorcycles, whatever it is called
    #[arg(long)]
    pub csv: bool,

    /// A file whose lines and rings are walls for the motorcycles of a table
    #[arg(long, value_name = "FILE")]
    pub walls: Option<PathBuf>,

    /// Also check the result against the laws of motorcycle graphs, without what made it
    #[arg(long)]
    pub verify: bool,

    #[command(flatten)]
    pub output: OutputArgs,

    #[command(flatten, next_help_heading = "Pictures")]
    pub size: SizeArgs,
}
