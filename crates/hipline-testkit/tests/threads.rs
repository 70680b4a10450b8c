//! The same bits for every number of threads, on figures that are computed in parts.

use hipline::{FigureBuilder, Options, Region, Skeleton};
use hipline_testkit::generate::Random;

/// Many small polygons in rows, some with a hole or a segment in it.
fn town(count: usize) -> FigureBuilder {
    let mut random = Random::new(7);
    let mut builder = FigureBuilder::new();
    for i in 0..count {
        let [x, y] = [i % 64, i / 64].map(|k| k as f64 * 20.0);
        let mut corner = |dx: f64, dy: f64| [x + dx, y + dy].map(|c| c + random.below(5) as f64);
        let shell = vec![
            corner(0.0, 0.0),
            corner(6.0, 0.0),
            corner(12.0, 0.0),
            corner(12.0, 12.0),
            corner(6.0, 12.0),
            corner(0.0, 12.0),
        ];
        let mut rings = vec![shell];
        if i % 3 == 0 {
            rings.push(vec![
                [x + 7.0, y + 6.0],
                [x + 9.0, y + 6.0],
                [x + 8.0, y + 8.0],
            ]);
        }
        builder.polygon(rings);
    }
    builder
}

fn with_threads(threads: usize, compute: impl Fn() -> Skeleton + Send) -> Skeleton {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build();
    pool.expect("a pool").install(compute)
}

#[test]
fn results_do_not_depend_on_threads() {
    let figure = town(5_000).build().expect("a figure");
    for region in [Region::Interior, Region::Both] {
        let options = Options::default().region(region);
        let one = with_threads(1, || figure.skeleton(options));
        assert!(
            one.faces().len() >= 30_000,
            "large enough to be computed in parts"
        );
        for threads in [2, 5] {
            let several = with_threads(threads, || figure.skeleton(options));
            assert!(several == one, "{threads} threads, {region:?}");
        }
        assert_eq!(one.verify(&figure), Ok(()), "{region:?}");
    }
}
