//! The options of all commands that compute skeletons.

use clap::{Args as Group, ValueEnum};
use hipline::{
    Engine, Region,
    skeleton::{Options, Side},
};

/// How skeletons are computed.
#[derive(Debug, Clone, Copy, Group)]
pub struct ComputeArgs {
    /// Which part of the plane [default: the interior of polygons, both sides of lines]
    #[arg(long, value_name = "SIDE")]
    pub side: Option<SideArg>,

    /// The algorithm; all give the same result
    #[arg(long, value_name = "ENGINE", default_value = "auto")]
    pub engine: EngineArg,

    /// Let every edge send out a rectangle of its own, so that nothing shoots ahead of acute
    /// angles: the modified skeleton. Not with weights or heights
    #[arg(long)]
    pub modified: bool,

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
        Options::default()
            .region(self.region())
            .modified(self.modified)
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
pub enum ChainArg {
    Left,
    Right,
}

impl From<ChainArg> for Side {
    fn from(side: ChainArg) -> Self {
        match side {
            ChainArg::Left => Self::Left,
            ChainArg::Right => Self::Right,
        }
    }
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum EngineArg {
    /// The fastest one that applies
    Auto,
    /// The kinetic triangulation
    Kinetic,
    /// Monotone polygons; with weights, if the chains allow for it
    Monotone,
    /// Orthogonal monotone polygons, in linear time
    Orthogonal,
    /// The lower envelope of slabs; for the inside of polygons with unit speeds
    Envelope,
}

impl EngineArg {
    /// Whether it computes the skeleton of a chain.
    pub const fn is_for_chains(self) -> bool {
        matches!(self, Self::Auto | Self::Monotone)
    }
}

impl From<EngineArg> for Engine {
    fn from(engine: EngineArg) -> Self {
        match engine {
            EngineArg::Auto => Self::Auto,
            EngineArg::Kinetic => Self::Kinetic,
            EngineArg::Monotone => Self::Monotone,
            EngineArg::Orthogonal => Self::Orthogonal,
            EngineArg::Envelope => Self::Envelope,
        }
    }
}
