//! Prints the small case of a seed in the corpus format: `case [plain|fine|weighted|tilted] SEED`.

use hipline_testkit::generate::named;

fn main() {
    let mut arguments: Vec<String> = std::env::args().skip(1).collect();
    let generate = named(&mut arguments);
    let seed = arguments.first().and_then(|seed| seed.parse().ok());
    print!("{}", generate(seed.unwrap_or(0)).to_text());
}
