//! Edges that stand still, start late and change their speed: offsets and point location against each other.

mod common;

use common::count;
use hipline::observe::{Index, NoAnswer};
use hipline::offset::{Offset, OffsetLoop};
use hipline::{Figure, Options, Region, Skeleton};
use hipline_testkit::generate::{Random, small_weighted};
use hipline_testkit::hunt::overruns_at_zero;
use hipline_testkit::measure::winding;

/// Points anywhere around a figure.
fn points(seed: u64, figure: &Figure) -> Vec<[f64; 2]> {
    let mut random = Random::new(seed);
    let range = |axis: usize| {
        let values = figure.vertices().iter().map(|v| v[axis]);
        values.fold((f64::MAX, f64::MIN), |(l, h), x| (l.min(x), h.max(x)))
    };
    let ranges = [range(0), range(1)];
    let mut point = || ranges.map(|(l, h)| l - 1.0 + (h - l + 2.0) * random.unit());
    (0..40).map(|_| point()).collect()
}

/// The loops of the parts, each loop in exactly one of them.
fn check_parts(offset: &Offset, name: &str) {
    let mut used = vec![0; offset.loops().len()];
    for part in offset.parts() {
        for &k in part.shell.iter().chain(&part.holes) {
            used[k] += 1;
        }
        if let Some(shell) = part.shell {
            let area = offset.loops()[shell].area();
            assert!(area > 0.0, "{name}: a shell of {area}");
        }
    }
    assert!(used.iter().all(|&n| n == 1), "{name}: {used:?}");
}

/// In how many parts a point lies.
fn parts_around(offset: &Offset, point: [f64; 2]) -> usize {
    let winding = |&k: &usize| winding(offset.loops()[k].points(), point);
    let around = offset.parts().iter().map(|part| {
        let shell = part.shell.as_ref().map_or(1, winding);
        shell + part.holes.iter().map(winding).sum::<i32>()
    });
    let around: Vec<i32> = around.collect();
    assert!(around.iter().all(|n| [0, 1].contains(n)), "{around:?}");
    around.iter().filter(|&&n| n == 1).count()
}

/// Returns how many points were reached before a distance, after it, and never.
fn check(seed: u64, figure: &Figure, skeleton: &Skeleton) -> [usize; 3] {
    let last = skeleton.nodes().iter().map(|n| n.time);
    let last = last.filter(|t| t.is_finite()).fold(1.0, f64::max);
    let distances = [0.25, 0.5, 1.0, 1.5, last + 1.0];
    let offsets = skeleton.offsets(figure, &distances).expect("distances");
    let index = Index::new(skeleton, figure);
    let everywhere = i32::from(skeleton.region() != Region::Interior);
    let mut seen = [0; 3];
    for point in points(seed, figure) {
        let time = match index.locate(point) {
            Ok(answer) => answer.time,
            Err(NoAnswer::TooFar(..)) => f64::INFINITY,
            Err(_) => continue,
        };
        for (offset, d) in offsets.iter().zip(distances) {
            if (time - d).abs() < 1e-9 {
                continue;
            }
            let around = |l: &OffsetLoop| winding(l.points(), point);
            let total = everywhere + offset.loops().iter().map(around).sum::<i32>();
            let unswept = i32::from(time > d);
            let name = format!("seed {seed}, {point:?} at {time}, offset {d}");
            assert_eq!(total, unswept, "{name}");
            // The whole plane is no part that any loop belongs to.
            if !offset.loops().is_empty() {
                assert_eq!(parts_around(offset, point), unswept as usize, "{name}");
            }
            let k = if time.is_finite() {
                unswept as usize
            } else {
                2
            };
            seen[k] += 1;
            check_parts(offset, &name);
        }
    }
    seen
}

#[test]
fn offsets_enclose_what_is_not_yet_reached() {
    let mut seen = [0; 3];
    for seed in 0..count(2_000, 60) {
        let case = small_weighted(seed);
        let figure = case.figure().expect("a figure");
        let skeleton = figure.skeleton(Options::default().region(case.region));
        if overruns_at_zero(&skeleton) {
            continue;
        }
        let here = check(seed, &figure, &skeleton);
        for k in 0..3 {
            seen[k] += here[k];
        }
    }
    assert!(seen.iter().all(|&n| n > 500), "{seen:?}");
}
