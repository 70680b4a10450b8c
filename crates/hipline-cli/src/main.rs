//! The command line of hipline.
fn main() {}
