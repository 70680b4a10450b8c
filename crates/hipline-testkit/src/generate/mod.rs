//! Deterministic inputs from seeds.

mod family;
mod grid;
mod maze;
mod monotone;
mod orthogonal;
mod random;
mod shapes;
mod small;
mod tight;
mod tilted;
mod weighted;

pub use family::Family;
pub use monotone::{chain_small, monotone_large, monotone_small, monotone_weighted};
pub use orthogonal::{Columns, columns, orthogonal, subdivide};
pub use random::Random;
pub use shapes::STRAIGHT_VERTICES;
pub use small::{Kind, small, small_of, weigh};
pub use tight::{tight, wheel};
pub use tilted::{Heights, raise, small_tilted};
pub use weighted::{Weights, change_speeds, small_weighted};
