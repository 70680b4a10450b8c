//! The result: nodes, arcs and faces of a straight skeleton. The only way out.

mod assemble;
mod heights;
mod merge;
mod model;
mod stats;
mod verify;

pub(crate) use assemble::assemble;
pub use heights::ReachedEarly;
pub(crate) use merge::merge;
pub use model::{Arc, ArcKind, Face, InputGraph, Node, NodeKind, Options, Region, Side, Skeleton};
pub use stats::Stats;
pub use verify::{Uncertified, Violation, Violations};
