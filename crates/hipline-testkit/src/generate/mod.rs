//! Deterministic inputs from seeds.

use crate::case::Case;

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
pub use small::{Kind, small, small_fine, small_of, weigh};
pub use tight::{tight, wheel};
pub use tilted::{Heights, raise, small_tilted};
pub use weighted::{Weights, change_speeds, small_weighted};

/// What makes a case of a seed.
pub type Generate = fn(u64) -> Case;

/// The kinds of random small cases by name.
pub const SMALL: [(&str, Generate); 4] = [
    ("plain", small),
    ("fine", small_fine),
    ("weighted", small_weighted),
    ("tilted", small_tilted),
];

/// Takes the name of a kind from the front of a list of arguments; without one, it is `plain`.
pub fn named(arguments: &mut Vec<String>) -> Generate {
    let found = SMALL
        .into_iter()
        .find(|(name, _)| arguments.first().is_some_and(|first| first == name));
    match found {
        Some((_, generate)) => {
            arguments.remove(0);
            generate
        }
        None => small,
    }
}
