//! Times the checking and triangulating of figures, by family and size.
//!
//! `cargo run --release --example build_figure -- [family] [vertices]`

use std::{f64::consts::TAU, hint::black_box, time::Instant};

use hipline::FigureBuilder;

type Ring = Vec<[f64; 2]>;

fn main() {
    let mut args = std::env::args().skip(1);
    let only = args.next();
    let sizes = args
        .next()
        .map_or(vec![10, 100, 10_000, 100_000, 1_000_000], |size| {
            vec![size.parse().expect("the number of vertices is a number")]
        });
    println!(
        "{:10} {:>9} {:>12} {:>10}",
        "family", "vertices", "ns/vertex", "us/figure"
    );
    for (name, family) in FAMILIES {
        if only
            .as_ref()
            .is_some_and(|only| only != name && only != "all")
        {
            continue;
        }
        for &size in &sizes {
            let polygons = family(size);
            let vertices: usize = polygons.iter().flatten().map(Vec::len).sum();
            let runs = (300_000 / vertices).max(1);
            let mut seconds = f64::INFINITY;
            for _ in 0..3 {
                let copies = vec![polygons.clone(); runs];
                let start = Instant::now();
                for polygons in copies {
                    let mut builder = FigureBuilder::new();
                    for rings in polygons {
                        builder.polygon(rings);
                    }
                    black_box(builder.build().expect("the families are valid"));
                }
                seconds = seconds.min(start.elapsed().as_secs_f64() / runs as f64);
            }
            let each = seconds * 1e9 / vertices as f64;
            println!("{name:10} {vertices:9} {each:12.0} {:10.1}", seconds * 1e6);
        }
    }
}

/// A family: its polygons, about so many vertices together.
type Family = fn(usize) -> Vec<Vec<Ring>>;

const FAMILIES: [(&str, Family); 8] = [
    ("circle", |n| vec![vec![polar(n, |_| 1000.0)]]),
    ("star", |n| {
        let mut random = 1_u64;
        vec![vec![polar(n, |_| 500.0 + 500.0 * next(&mut random))]]
    }),
    ("walk", |n| {
        let mut random = 2_u64;
        let step = (n as f64).sqrt().recip();
        let mut radius = 1000.0;
        let mut bounded = move || {
            radius = f64::clamp(
                radius + 1000.0 * step * (next(&mut random) - 0.5),
                500.0,
                2000.0,
            );
            radius
        };
        vec![vec![polar(n, move |_| bounded())]]
    }),
    ("comb", |n| vec![vec![comb(n, 1000.0)]]),
    ("saw", |n| vec![vec![saw(n)]]),
    ("squares", squares),
    ("fan", |n| {
        let mut ring: Ring = (0..n - 1).map(|i| [i as f64, 0.0]).collect();
        ring.push([n as f64 / 2.0, n as f64]);
        vec![vec![ring]]
    }),
    ("koch", |n| vec![vec![koch(n)]]),
];

fn next(state: &mut u64) -> f64 {
    *state = state
        .wrapping_mul(6_364_136_223_846_793_005)
        .wrapping_add(1_442_695_040_888_963_407);
    (*state >> 11) as f64 / (1_u64 << 53) as f64
}

fn polar(n: usize, mut radius: impl FnMut(usize) -> f64) -> Ring {
    (0..n)
        .map(|i| {
            let (sin, cos) = (TAU * i as f64 / n as f64).sin_cos();
            let radius = radius(i);
            [radius * cos, radius * sin]
        })
        .collect()
}

/// Long thin teeth on a bar, all on a grid.
fn comb(n: usize, length: f64) -> Ring {
    let teeth = (n / 4).max(2);
    let mut ring = vec![[4.0 * teeth as f64 - 2.0, -1.0], [0.0, -1.0]];
    for tooth in 0..teeth {
        let x = 4.0 * tooth as f64;
        ring.extend([[x, length], [x + 2.0, length]]);
        if tooth + 1 < teeth {
            ring.extend([[x + 2.0, 0.0], [x + 4.0, 0.0]]);
        }
    }
    ring
}

fn saw(n: usize) -> Ring {
    let mut ring: Ring = (0..n - 2)
        .map(|i| [i as f64, (i % 2) as f64 * 50.0])
        .collect();
    ring.extend([[n as f64, -1000.0], [-1.0, -1000.0]]);
    ring
}

fn squares(n: usize) -> Vec<Vec<Ring>> {
    let side = ((n / 4) as f64).sqrt().ceil() as usize;
    let square = |i: usize| {
        let (x, y) = (2.0 * (i % side) as f64, 2.0 * (i / side) as f64);
        vec![vec![[x, y], [x + 1.0, y], [x + 1.0, y + 1.0], [x, y + 1.0]]]
    };
    (0..n / 4).map(square).collect()
}

fn koch(n: usize) -> Ring {
    let height = 0.75_f64.sqrt();
    let mut ring = vec![[0.0, 0.0], [0.5, height], [1.0, 0.0]];
    while ring.len() * 4 <= n.max(12) {
        let mut finer = Vec::with_capacity(4 * ring.len());
        for (i, &[ax, ay]) in ring.iter().enumerate() {
            let [bx, by] = ring[(i + 1) % ring.len()];
            let (dx, dy) = ((bx - ax) / 3.0, (by - ay) / 3.0);
            let tip = [ax + 1.5 * dx - height * dy, ay + 1.5 * dy + height * dx];
            finer.extend([
                [ax, ay],
                [ax + dx, ay + dy],
                tip,
                [ax + 2.0 * dx, ay + 2.0 * dy],
            ]);
        }
        ring = finer;
    }
    ring
}
