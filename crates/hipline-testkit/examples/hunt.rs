//! Hunts for disagreements between the library and the reference engine.
//!
//! `cargo run --release -p hipline-testkit --example hunt -- FIRST COUNT [MOST]` tries COUNT seeds
//! from FIRST on, on all cores, and prints up to MOST failures, each reduced. With `weighted` before
//! the numbers, cases have speeds of zero and speeds that change; with `tilted`, vertices have heights; with
//! `fine`, coordinates have many digits. With the name of a
//! corpus file instead of numbers, it tries that case as it is.

use std::env;
use std::fs;
use std::thread;

use hipline_testkit::Case;
use hipline_testkit::generate::named;
use hipline_testkit::hunt::{failure, hunt};

fn main() {
    let mut arguments: Vec<String> = env::args().skip(1).collect();
    let generate = named(&mut arguments);
    let number = |k: usize| arguments.get(k).and_then(|text| text.parse::<u64>().ok());
    if let (Some(file), None) = (arguments.first(), number(0)) {
        let text = fs::read_to_string(file).expect("a readable file");
        let case = Case::parse(&text).expect("a case");
        println!("{}", failure(&case).unwrap_or_else(|| "agrees".to_owned()));
        return;
    }
    let (first, count, most) = (
        number(0).unwrap_or(0),
        number(1).unwrap_or(1000),
        number(2).unwrap_or(3),
    );
    std::panic::set_hook(Box::new(|_| {}));
    let threads = thread::available_parallelism().map_or(1, |n| n.get() as u64);
    let start = std::time::Instant::now();
    let found: Vec<_> = thread::scope(|scope| {
        let search = |k: u64| {
            move || {
                hunt(
                    generate,
                    (first..first + count).filter(|seed| seed % threads == k),
                    most as usize,
                )
            }
        };
        let running: Vec<_> = (0..threads).map(|k| scope.spawn(search(k))).collect();
        running
            .into_iter()
            .flat_map(|thread| thread.join().expect("hunts catch panics"))
            .collect()
    });
    for (case, how) in found.iter().take(most as usize) {
        println!("{}{how}\n", case.to_text());
    }
    println!(
        "{count} seeds from {first}: {} failures in {:?}",
        found.len(),
        start.elapsed()
    );
    std::process::exit(i32::from(!found.is_empty()));
}
