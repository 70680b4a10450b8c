use hipline::{Engine, Options};
use hipline_testkit::agreement::drawn;
use hipline_testkit::generate::{monotone_small, monotone_weighted};
use hipline_testkit::Case;
fn main() {
    let a: Vec<String> = std::env::args().collect();
    let case = match a[1].as_str() {
        "s" => monotone_small(a[2].parse().unwrap()),
        "w" => monotone_weighted(a[2].parse().unwrap()),
        f => Case::parse(&std::fs::read_to_string(f).unwrap()).unwrap(),
    };
    println!("{}", case.to_text());
    let f = case.figure().unwrap();
    let k = drawn(&f.skeleton_by(Engine::Kinetic, Options::default()).unwrap());
    for d in &k { println!("K {d}"); }
    match f.skeleton_by(Engine::Monotone, Options::default()) {
        Err(e) => println!("refused {e}"),
        Ok(s) => { let m = drawn(&s); for d in &m { println!("{} {d}", if k.contains(d) {"  "} else {"M!"}); }
          for d in &k { if !m.contains(d) { println!("K! {d}"); } } }
    }
}
