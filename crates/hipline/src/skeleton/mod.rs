//! The result: nodes, arcs and faces of a straight skeleton. The only way out.

mod model;
mod stats;

pub use model::{Arc, ArcKind, Face, InputGraph, Node, NodeKind, Options, Region, Side, Skeleton};
pub use stats::Stats;
