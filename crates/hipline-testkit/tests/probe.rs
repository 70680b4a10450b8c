use hipline::Region;
use hipline_testkit::generate::{small, Family};
use hipline_testkit::reference::{Graph, reference};
#[test]
fn probe() {
    let count: u64 = std::env::var("N").ok().and_then(|s| s.parse().ok()).unwrap_or(300);
    let (mut ok, mut bad, mut panics) = (0, 0, 0);
    let start = std::time::Instant::now();
    let mut slow = (std::time::Duration::ZERO, 0, 0);
    for seed in 0..count {
        let case = small(seed);
        match case.figure() {
            Err(e) => { bad += 1; if bad < 6 { println!("{}\n{e:?}", case.to_text()); } }
            Ok(f) => {
                let graph = Graph::from(&f);
                let t = std::time::Instant::now();
                if std::panic::catch_unwind(|| reference(&graph, Region::Both)).is_err() { panics += 1; println!("PANIC {seed} {}", case.to_text()); } else { ok += 1; }
                if t.elapsed() > slow.0 { slow = (t.elapsed(), seed, graph.edges.len()); }
            }
        }
    }
    println!("{ok} ok, {bad} invalid, {panics} panics {:?} slowest {slow:?}", start.elapsed());
    for family in Family::all() {
        for n in [8, 20, 100, 1000, 30000] {
            let case = family.generate(n, 1);
            let r = case.figure();
            println!("{} {n} {} {:?}", family.name(), case.size(), r.map(|_| ()).err().map(|e| format!("{e:?}").chars().take(300).collect::<String>()));
        }
    }
}
