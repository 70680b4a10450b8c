//! Offsets of many small figures, at the moments of their events and beside them: areas against
//! the areas of the faces, polygons against the rules for polygons.

#![allow(clippy::float_cmp, reason = "a test of exact results")]

mod common;

use common::count;
use hipline::{
    Figure, Options, Region, Skeleton,
    offset::{Offset, OffsetLoop},
};
use hipline_testkit::{
    Case,
    generate::small,
    measure::{area, swept},
};
use robust::{Coord, orient2d};

fn side(a: [f64; 2], b: [f64; 2], c: [f64; 2]) -> i32 {
    let coord = |[x, y]: [f64; 2]| Coord { x, y };
    let sign = orient2d(coord(a), coord(b), coord(c));
    i32::from(sign > 0.0) - i32::from(sign < 0.0)
}

/// Whether two segments have more in common than a point that is an end of one, exactly.
fn conflict([a, b]: [[f64; 2]; 2], [c, d]: [[f64; 2]; 2]) -> bool {
    let [p, q] = [side(a, b, c), side(a, b, d)];
    if p == 0 && q == 0 {
        let k = usize::from(a[0] == b[0]);
        let (low, high) = (a[k].min(b[k]), a[k].max(b[k]));
        let (from, to) = (c[k].min(d[k]), c[k].max(d[k]));
        return low.max(from) < high.min(to);
    }
    p * q < 0 && side(c, d, a) * side(c, d, b) < 0
}

/// Whether two segments cross by so little that the rounding of their ends can have made it.
fn is_scratch([a, b]: [[f64; 2]; 2], [c, d]: [[f64; 2]; 2]) -> bool {
    let distance = |p: [f64; 2], a: [f64; 2], b: [f64; 2]| {
        let [u, v] = [[b[0] - a[0], b[1] - a[1]], [p[0] - a[0], p[1] - a[1]]];
        let square = u[0] * u[0] + u[1] * u[1];
        let s = ((u[0] * v[0] + u[1] * v[1]) / square).clamp(0.0, 1.0);
        (v[0] - s * u[0]).hypot(v[1] - s * u[1])
    };
    let least = [
        distance(a, c, d),
        distance(b, c, d),
        distance(c, a, b),
        distance(d, a, b),
    ];
    least.into_iter().fold(f64::INFINITY, f64::min) < 1e-12
}

/// What is wrong with a polygon by the rules of OGC Simple Features. At the very moment of an
/// event, as it is rounded, what nearly touches may scratch.
fn flaw(rings: &[OffsetLoop], is_event: bool) -> Option<String> {
    let mut segments = Vec::new();
    for (r, ring) in rings.iter().enumerate() {
        let points = ring.points();
        if (area(points) > 0.0) != (r == 0) {
            return Some(format!("ring {r} has the area {}", area(points)));
        }
        for (i, &p) in points.iter().enumerate() {
            if points[..i].contains(&p) {
                return Some(format!("ring {r} is twice at {p:?}"));
            }
            segments.push([p, points[(i + 1) % points.len()]]);
        }
    }
    for (i, &s) in segments.iter().enumerate() {
        let is_wrong = |t: [[f64; 2]; 2]| conflict(s, t) && !(is_event && is_scratch(s, t));
        if let Some(t) = segments[..i].iter().find(|&&t| is_wrong(t)) {
            return Some(format!("{s:?} and {t:?} cross"));
        }
    }
    // A hole: each of its points is in the shell or on it.
    let shell = rings[0].points();
    for p in rings[1..].iter().flat_map(OffsetLoop::points) {
        let (mut inside, mut on) = (false, false);
        for (i, &a) in shell.iter().enumerate() {
            let b = shell[(i + 1) % shell.len()];
            let s = side(a, b, *p);
            let within = |k: usize| (a[k].min(b[k])..=a[k].max(b[k])).contains(&p[k]);
            on |= s == 0 && within(0) && within(1);
            inside ^= (a[1] > p[1]) != (b[1] > p[1]) && (s > 0) == (b[1] > a[1]);
        }
        if !(on || inside || is_event) {
            return Some(format!("{p:?} of a hole is outside of the shell"));
        }
    }
    None
}

/// The times of all events, the numbers beside them, and times between.
fn distances(skeleton: &Skeleton) -> Vec<(f64, bool)> {
    let times = skeleton.nodes().iter().map(|n| n.time);
    let mut times: Vec<f64> = times.filter(|t| t.is_finite() && *t > 0.0).collect();
    times.sort_by(f64::total_cmp);
    times.dedup();
    let beside = times.iter().flat_map(|t| [t.next_down(), *t, t.next_up()]);
    let beside = beside.map(|t| (t, true));
    let between = times
        .windows(2)
        .map(|w| (w[0] + 0.375 * (w[1] - w[0]), w[1] - w[0] < 1e-9));
    let last = times.last().map(|t| (1.25 * t, false));
    beside.chain(between).chain(last).collect()
}

struct Counts {
    offsets: usize,
    holes: usize,
    grown_holes: usize,
    cut: usize,
}

fn check(case: &Case, figure: &Figure, region: Region, covered: f64, counts: &mut Counts) {
    let skeleton = figure.skeleton(Options::default().region(region));
    let (distances, is_event): (Vec<f64>, Vec<bool>) = distances(&skeleton).into_iter().unzip();
    let offsets = skeleton.offsets(figure, &distances).expect("distances");
    for (offset, is_event) in offsets.iter().zip(is_event) {
        let d = offset.distance();
        let title = || format!("{region:?} at {d:?}\n{}", case.to_text());
        let gone = swept(&skeleton, d);
        let sum: f64 = offset.loops().iter().map(OffsetLoop::area).sum();
        let extent: f64 = offset.loops().iter().map(OffsetLoop::perimeter).sum();
        let tolerance = 1e-9 * (1.0 + covered.abs() + gone + d * extent);
        let expected = covered - gone;
        assert!(
            (sum - expected).abs() <= tolerance,
            "{sum}, not {expected}: {}",
            title()
        );
        let simple: f64 = offset.simple_loops().map(|ring| ring.area()).sum();
        assert!(
            (simple - sum).abs() <= tolerance,
            "{simple}, not {sum}: {}",
            title()
        );
        counts.offsets += 1;
        counts.cut += usize::from(offset.simple_loops().count() > offset.loops().len());
        check_polygons(offset, is_event, tolerance, counts, &title);
        if region != Region::Interior {
            check_grown(offset, is_event, tolerance, counts, &title);
        }
    }
}

fn check_polygons(
    offset: &Offset,
    is_event: bool,
    tolerance: f64,
    counts: &mut Counts,
    title: &impl Fn() -> String,
) {
    let mut sum = 0.0;
    for rings in offset.rings() {
        sum += rings.iter().map(OffsetLoop::area).sum::<f64>();
        counts.holes += rings.len() - 1;
        if let Some(flaw) = flaw(&rings, is_event) {
            // What is so small is made of rounding.
            let size: f64 = rings.iter().map(OffsetLoop::area).sum();
            assert!(size.abs() <= tolerance, "{flaw} in {rings:?}: {}", title());
        }
    }
    // At an event, a bay whose mouth is rounded shut is a polygon, too.
    let bounded = offset.parts().iter().filter(|part| part.shell.is_some());
    let loops = bounded.flat_map(|part| part.shell.iter().chain(&part.holes));
    let expected: f64 = loops.map(|&i| offset.loops()[i].area()).sum();
    let is_right = if is_event {
        sum >= expected - tolerance
    } else {
        (sum - expected).abs() <= tolerance
    };
    assert!(is_right, "{sum}, not {expected}: {}", title());
}

/// The figure grown: all loops, the other way around, each once.
fn check_grown(
    offset: &Offset,
    is_event: bool,
    tolerance: f64,
    counts: &mut Counts,
    title: &impl Fn() -> String,
) {
    let mut sum = 0.0;
    for rings in offset.swept_rings() {
        let size: f64 = rings.iter().map(OffsetLoop::area).sum();
        sum += size;
        counts.grown_holes += rings.len() - 1;
        if let Some(flaw) = flaw(&rings, is_event) {
            assert!(size.abs() <= tolerance, "{flaw} in {rings:?}: {}", title());
        }
    }
    let expected: f64 = offset.loops().iter().map(OffsetLoop::area).sum();
    assert!(
        (sum + expected).abs() <= tolerance,
        "{sum}, not {}: {}",
        -expected,
        title()
    );
}

#[test]
fn offsets_at_and_beside_events() {
    let mut counts = Counts {
        offsets: 0,
        holes: 0,
        grown_holes: 0,
        cut: 0,
    };
    for seed in 0..count(800, 40) {
        let case = small(seed);
        let Ok(figure) = case.figure() else { continue };
        check(&case, &figure, Region::Both, 0.0, &mut counts);
        if figure.has_polygon() {
            let inside = figure.skeleton(Options::default().region(Region::Interior));
            let size = swept(&inside, f64::MAX);
            check(&case, &figure, Region::Interior, size, &mut counts);
            check(&case, &figure, Region::Exterior, -size, &mut counts);
        }
    }
    println!(
        "{} offsets, {} holes, {} with loops that touch themselves",
        counts.offsets, counts.holes, counts.cut
    );
    assert!(
        counts.holes > 0 && counts.grown_holes > 0 && counts.cut > 0,
        "nothing was tested"
    );
}
