//! Quick timing of families.
use hipline::{FigureBuilder, Options, Region};
use std::time::Instant;
fn rnd(s: &mut u64) -> f64 { *s ^= *s << 13; *s ^= *s >> 7; *s ^= *s << 17; (*s >> 11) as f64 / (1u64 << 53) as f64 }
fn family(name: &str, n: usize) -> Vec<Vec<[f64; 2]>> {
    let mut s = 88172645463325252u64;
    let tau = std::f64::consts::TAU;
    match name {
        "star" => vec![(0..n).map(|i| { let a = tau * i as f64 / n as f64; let r = 1000.0 * (1.0 + 0.3 * rnd(&mut s)); [r * a.cos(), r * a.sin()] }).collect()],
        "smooth" => { let mut r = 0.0; vec![(0..n).map(|i| { let a = tau * i as f64 / n as f64; r += (rnd(&mut s)-0.5) * 60.0/ n as f64; let rr=1000.0*(1.5+0.3*(a*7.0).sin()+0.1*(a*31.0).cos()+r*0.1); [rr * a.cos(), rr * a.sin()] }).collect()] }
        "circle" => vec![(0..n).map(|i| { let a = tau * i as f64 / n as f64; [1e6 * a.cos(), 1e6 * a.sin()] }).collect()],
        "comb" => { let m = n / 4; let mut v = vec![[0.0, 0.0], [4.0 * m as f64, 0.0]]; for i in (0..m).rev() { let x = 4.0 * i as f64; let h = (rnd(&mut s) * 20.0).floor() + 3.0; v.extend([[x + 4.0, h + 30.0], [x + 2.0, h + 30.0], [x + 2.0, h], [x, h]]); } let l = v.len(); v.truncate(l); vec![v] }
        "holes" => { let k = ((n / 4) as f64).sqrt() as usize; let e = 3.0 * k as f64; let mut v = vec![vec![[0.0, 0.0], [e, 0.0], [e, e], [0.0, e]]]; for i in 0..k { for j in 0..k { let (x, y) = (3.0 * i as f64 + 1.0, 3.0 * j as f64 + 1.0); v.push(vec![[x, y], [x, y + 1.0], [x + 1.0, y + 1.0], [x + 1.0, y]]); } } v }
        "rholes" => { let k = ((n / 4) as f64).sqrt() as usize; let e = 3.0 * k as f64; let mut v = vec![vec![[0.0, 0.0], [e, 0.0], [e, e], [0.0, e]]]; for i in 0..k { for j in 0..k { let (x, y) = (3.0 * i as f64 + 1.0, 3.0 * j as f64 + 1.0); let mut q = || rnd(&mut s) * 0.4; v.push(vec![[x + q(), y + q()], [x + q(), y + 1.0 - q()], [x + 1.0 - q(), y + 1.0 - q()], [x + 1.0 - q(), y + q()]]); } } v }
        "koch" => { let mut p = vec![[0.0, 0.0], [0.5, 0.75f64.sqrt()], [1.0, 0.0]]; while p.len() < n { let mut q = Vec::new(); for i in 0..p.len() { let (a, b) = (p[i], p[(i + 1) % p.len()]); let d = [(b[0] - a[0]) / 3.0, (b[1] - a[1]) / 3.0]; let c = [a[0] + d[0], a[1] + d[1]]; let h = 0.75f64.sqrt(); q.extend([a, c, [c[0] + 0.5 * d[0] - h * d[1], c[1] + 0.5 * d[1] + h * d[0]], [a[0] + 2.0 * d[0], a[1] + 2.0 * d[1]]]); } p = q; } vec![p] }
        _ => panic!(),
    }
}
fn main() {
    let names: Vec<String> = std::env::args().nth(1).map_or(vec![], |s| s.split(',').map(String::from).collect());
    let sizes: Vec<usize> = std::env::args().nth(2).map_or(vec![10000, 100000], |s| s.split(',').map(|x| x.parse().unwrap()).collect());
    for name in &names { for &n in &sizes {
        let rings = family(name, n);
        let n: usize = rings.iter().map(Vec::len).sum();
        let t = Instant::now();
        let mut b = FigureBuilder::new(); b.polygon(rings);
        let f = b.build().unwrap();
        let build = t.elapsed().as_secs_f64();
        let t = Instant::now();
        let s = f.skeleton(Options::default().region(Region::Interior));
        let k = t.elapsed().as_secs_f64();
        let us = 1e6 / n as f64;
        let st = s.stats();
        println!("{name} n={n} build {:.2} us/v  skeleton {:.2} us/v ratio {:.1}  edge {:.2} split {:.2} flips {:.2} f64 {:.1} dd {:.3} exact {:.3}", build * us, k * us, (build + k) / build, st.edge_events as f64 / n as f64, st.split_events as f64 / n as f64, st.flips as f64 / n as f64, st.by_f64 as f64 / n as f64, st.by_double_double as f64 / n as f64, st.by_exact as f64 / n as f64);
    } }
}
