//! Prints the small case of a seed in the corpus format.
fn main() {
    let seed = std::env::args()
        .nth(1)
        .and_then(|s| s.parse().ok())
        .unwrap_or(0);
    print!("{}", hipline_testkit::generate::small(seed).to_text());
}
