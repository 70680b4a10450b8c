//! Offsets of any small figure, at its events and beside them: every loop belongs to one part on
//! either side, areas do not grow, and polygons have the area of their loops. Centrelines, too.
#![no_main]

mod figure;

use arbitrary::Arbitrary;
use figure::Shape;
use hipline::{
    Options, Region,
    centreline::CentrelineOptions,
    offset::{Offset, OffsetLoop, Part},
};
use libfuzzer_sys::fuzz_target;

#[derive(Debug, Arbitrary)]
struct Input {
    shape: Shape,
    quarters: Vec<u8>,
    prune: u8,
    longest: bool,
}

fn area<'a>(loops: impl IntoIterator<Item = &'a OffsetLoop>) -> f64 {
    loops.into_iter().map(OffsetLoop::area).sum()
}

/// Each loop belongs to one of the parts.
fn covers(parts: &[Part], offset: &Offset) {
    let mut seen = vec![0; offset.loops().len()];
    for part in parts {
        for &i in part.shell.iter().chain(&part.holes) {
            seen[i] += 1;
        }
    }
    assert!(seen.iter().all(|&n| n == 1), "{parts:?} of {offset:?}");
}

fuzz_target!(|input: Input| {
    let Some(figure) = input.shape.figure() else { return };
    for region in [Region::Auto, Region::Both] {
        let skeleton = figure.skeleton(Options::default().region(region));
        let times = skeleton.nodes().iter().map(|node| node.time);
        let times = times.filter(|time| time.is_finite());
        let quarters = input.quarters.iter().map(|&q| f64::from(q) / 4.0);
        let mut distances: Vec<f64> = times.chain(quarters).collect();
        distances.sort_by(f64::total_cmp);
        let offsets = skeleton.offsets(&figure, &distances).expect("distances");
        let mut before = f64::INFINITY;
        for offset in &offsets {
            covers(offset.parts(), offset);
            let all = area(offset.loops());
            let extent: f64 = offset.loops().iter().map(OffsetLoop::perimeter).sum();
            let tolerance = 1e-9 * (1.0 + all.abs() + extent * (1.0 + offset.distance()));
            assert!(all <= before + tolerance, "{all} after {before}");
            before = all;
            let simple: Vec<OffsetLoop> = offset.simple_loops().collect();
            assert!((area(&simple) - all).abs() <= tolerance, "{offset:?}");
            if skeleton.region() == Region::Interior {
                let rings: Vec<OffsetLoop> = offset.rings().flatten().collect();
                assert!((area(&rings) - all).abs() <= tolerance, "{offset:?}");
            } else {
                covers(offset.swept_parts(), offset);
                let rings: Vec<OffsetLoop> = offset.swept_rings().flatten().collect();
                assert!((area(&rings) + all).abs() <= tolerance, "{offset:?}");
            }
        }
        let options = CentrelineOptions::default()
            .prune(f64::from(input.prune) / 8.0)
            .longest(input.longest)
            .extend(true);
        let centreline = skeleton.centreline(&figure, options).expect("options");
        assert!(centreline.lines().iter().all(|line| line.points().len() > 1));
    }
});
