//! Prints the small case of a seed in the corpus format; of `weighted SEED`, one with speeds of zero
//! and speeds that change; of `tilted SEED`, one with heights.

use hipline_testkit::generate::{small, small_tilted, small_weighted};

fn main() {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let seed = arguments.last().and_then(|seed| seed.parse().ok());
    let generate = match arguments.first().map(String::as_str) {
        Some("weighted") => small_weighted,
        Some("tilted") => small_tilted,
        _ => small,
    };
    print!("{}", generate(seed.unwrap_or(0)).to_text());
}
