//! Prints the small case of a seed in the corpus format; of `weighted SEED`, one with speeds of zero
//! and speeds that change.

use hipline_testkit::generate::{small, small_weighted};

fn main() {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let weighted = arguments.first().is_some_and(|first| first == "weighted");
    let seed = arguments.last().and_then(|seed| seed.parse().ok());
    let generate = if weighted { small_weighted } else { small };
    print!("{}", generate(seed.unwrap_or(0)).to_text());
}
