use hipline::{Engine, Options, Region};
use hipline_testkit::agreement::drawn;
use hipline_testkit::generate::{Family, Kind, small_of};
use std::time::Instant;
const KINDS: [Kind; 8] = [
    Kind::Simple,
    Kind::Star,
    Kind::Shape,
    Kind::Polyomino,
    Kind::Holes,
    Kind::Touching,
    Kind::Symmetric,
    Kind::Islands,
];
fn main() {
    let a: Vec<String> = std::env::args().skip(1).collect();
    let o = Options::default().region(Region::Interior);
    let number = |i: usize| a[i].parse::<u64>().unwrap();
    if let Some(family) = Family::named(&a[0]) {
        for n in &a[1..] {
            let case = family.generate(n.parse().unwrap(), 1);
            let f = case.figure().unwrap();
            let t = Instant::now();
            let k = f.skeleton(o);
            let tk = t.elapsed();
            let t = Instant::now();
            let m = f.motorcycles().unwrap();
            let tm = t.elapsed();
            let t = Instant::now();
            let e = f.skeleton_by(Engine::Envelope, o).unwrap();
            let te = t.elapsed();
            if std::env::var_os("DIFF").is_some() {
                let (k, e) = (drawn(&k), drawn(&e));
                for x in &k {
                    if !e.contains(x) {
                        println!("  k {x}");
                    }
                }
                for x in &e {
                    if !k.contains(x) {
                        println!("  e {x}");
                    }
                }
                println!("{:?}", m.motorcycles().len());
            }
            let t = Instant::now();
            let c = k.certify(&f);
            let tc = t.elapsed();
            println!(
                "{} n={} r={} kinetic {tk:?} motorcycles {tm:?} envelope {te:?} same {} certify {c:?} {tc:?}",
                a[0],
                f.edges().len(),
                m.motorcycles().len(),
                drawn(&k) == drawn(&e)
            );
        }
        return;
    }
    let (mut ok, mut bad) = (0, 0);
    for seed in number(0)..number(1) {
        let case = small_of(KINDS[(seed % 8) as usize], seed);
        let Ok(f) = case.figure() else { continue };
        let e = match std::panic::catch_unwind(|| f.skeleton_by(Engine::Envelope, o)) {
            Ok(Ok(e)) => e,
            Ok(Err(_)) => continue,
            Err(_) => {
                println!("PANIC {seed} size {}", case.size());
                bad += 1;
                continue;
            }
        };
        let (k, e) = (drawn(&f.skeleton(o)), drawn(&e));
        if k == e {
            ok += 1;
            continue;
        }
        bad += 1;
        println!("DIFFER {seed} size {}", case.size());
        if a.len() > 2 {
            println!("{}", case.to_text());
            for x in &k {
                if !e.contains(x) {
                    println!("  k {x}");
                }
            }
            for x in &e {
                if !k.contains(x) {
                    println!("  e {x}");
                }
            }
        }
    }
    println!("ok {ok} bad {bad}");
}
