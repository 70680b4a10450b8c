use hipline::{Engine, Options, Region};
use hipline_testkit::agreement::drawn;
use hipline_testkit::generate::{Kind, small_of};
const KINDS: [Kind; 8] = [Kind::Simple, Kind::Star, Kind::Shape, Kind::Polyomino, Kind::Holes, Kind::Touching, Kind::Symmetric, Kind::Islands];
fn main() {
    let a: Vec<u64> = std::env::args().skip(1).map(|x| x.parse().unwrap()).collect();
    let o = Options::default().region(Region::Interior);
    let (mut ok, mut bad) = (0, 0);
    for seed in a[0]..a[1] {
        let case = small_of(KINDS[(seed % 8) as usize], seed);
        let Ok(f) = case.figure() else { continue };
        let e = match std::panic::catch_unwind(|| f.skeleton_by(Engine::Envelope, o)) {
            Ok(Ok(e)) => e, Ok(Err(_)) => continue,
            Err(_) => { println!("PANIC {seed} size {}", case.size()); bad += 1; continue }
        };
        let (k, e) = (drawn(&f.skeleton(o)), drawn(&e));
        if k == e { ok += 1; continue; }
        bad += 1;
        println!("DIFFER {seed} size {}", case.size());
        if a.len() > 2 {
            println!("{}", case.to_text());
            for x in &k { if !e.contains(x) { println!("  k {x}"); } }
            for x in &e { if !k.contains(x) { println!("  e {x}"); } }
        }
    }
    println!("ok {ok} bad {bad}");
}
