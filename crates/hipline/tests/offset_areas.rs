//! Offsets: areas measured in another way.
#![allow(clippy::float_cmp, reason = "these results are exact")]

mod offset_support;

use hipline::{Figure, FigureBuilder, Options, Region, Skeleton, topology::FaceId};
use hipline_testkit::measure::swept;
use offset_support::{ELL, FUNNEL, HOLE, OUTER, PLUS, RECTANGLE, SQUARE, area, polygon, polygons};

/// Checks what must hold of every offset; `covered` is the area of the skeleton's region, or
/// minus the area of what it leaves out of the plane.
fn check(
    skeleton: &Skeleton,
    figure: &Figure,
    distances: &[f64],
    covered: f64,
) -> Result<(), String> {
    let offsets = skeleton.offsets(figure, distances).expect("distances");
    for offset in &offsets {
        let d = offset.distance();
        let sum: f64 = offset.loops().iter().map(|l| l.area()).sum();
        let expected = covered - swept(skeleton, d);
        let extent: f64 = offset.loops().iter().map(|l| l.perimeter()).sum();
        let tolerance = 1e-9 * (covered.abs() + swept(skeleton, d) + d * extent);
        if (sum - expected).abs() > tolerance {
            return Err(format!("at {d} the loops enclose {sum}, not {expected}"));
        }
        let mut seen = vec![0; offset.loops().len()];
        for part in offset.parts() {
            if let Some(shell) = part.shell {
                seen[shell] += 1;
                if offset.loops()[shell].area() < 0.0 {
                    return Err(format!("at {d} a shell is clockwise"));
                }
            } else if skeleton.region() == Region::Interior {
                return Err(format!("at {d} a part of the inside is unbounded"));
            }
            for &hole in &part.holes {
                seen[hole] += 1;
                if offset.loops()[hole].area() > tolerance {
                    return Err(format!("at {d} a hole is counterclockwise"));
                }
            }
        }
        if seen.iter().any(|&n| n != 1) {
            return Err(format!("at {d} the parts do not have each loop once"));
        }
        for ring in offset.loops() {
            if ring.points().len() != ring.faces().len() {
                return Err(format!("at {d} a loop has not one face for each edge"));
            }
        }
        let alone = skeleton.offset(figure, d).expect("a distance");
        if alone != *offset {
            return Err(format!(
                "at {d} several distances at once give another result"
            ));
        }
    }
    Ok(())
}

/// Times of events, spread over all of them, and times between.
fn telling_distances(skeleton: &Skeleton, count: usize) -> Vec<f64> {
    let mut times: Vec<f64> = skeleton
        .nodes()
        .iter()
        .map(|n| n.time)
        .filter(|t| t.is_finite())
        .collect();
    times.sort_by(f64::total_cmp);
    times.dedup();
    let step = times.len().div_ceil(count);
    let mut list: Vec<f64> = times.iter().step_by(step).copied().collect();
    list.extend(
        times
            .windows(2)
            .step_by(step)
            .map(|w| w[0] + 0.4 * (w[1] - w[0])),
    );
    list.push(times[times.len() - 1] * 1.25);
    list
}

#[test]
fn areas_of_shapes() {
    let shapes: [&[&[[f64; 2]]]; 6] = [
        &[SQUARE],
        &[RECTANGLE],
        &[ELL],
        &[PLUS],
        &[OUTER, HOLE],
        &[FUNNEL],
    ];
    for rings in shapes {
        let figure = polygon(rings);
        let size: f64 = rings.iter().map(|ring| area(ring)).sum();
        for (region, covered) in [
            (Region::Interior, size),
            (Region::Exterior, -size),
            (Region::Both, 0.0),
        ] {
            let skeleton = figure.skeleton(Options::default().region(region));
            let distances = telling_distances(&skeleton, 30);
            check(&skeleton, &figure, &distances, covered)
                .unwrap_or_else(|e| panic!("{rings:?}: {e}"));
        }
    }
}

#[test]
fn areas_with_weights() {
    let mut state = 7_u32;
    let mut draw = || {
        state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        f64::from(state >> 29) * 0.5 + 0.5
    };
    let mut missing = 0;
    for round in 0..200 {
        for rings in [vec![ELL], vec![PLUS], vec![OUTER, HOLE], vec![FUNNEL]] {
            let speeds = rings
                .iter()
                .map(|ring| ring.iter().map(|_| draw()).collect())
                .collect();
            let mut builder = FigureBuilder::new();
            builder.weighted_polygon(rings.iter().map(|ring| ring.to_vec()).collect(), speeds);
            let figure = builder.build().expect("valid");
            let size: f64 = rings.iter().map(|ring| area(ring)).sum();
            for (region, covered) in [(Region::Interior, size), (Region::Both, 0.0)] {
                let options = Options::default().region(region);
                let Ok(skeleton) = std::panic::catch_unwind(|| figure.skeleton(options)) else {
                    let speeds: Vec<_> = figure.edges().iter().map(|e| e.speeds[0]).collect();
                    println!("no skeleton: {region:?} {:?} {speeds:?}", figure.vertices());
                    missing += 1;
                    continue;
                };
                let distances = telling_distances(&skeleton, 30);
                check(&skeleton, &figure, &distances, covered)
                    .unwrap_or_else(|e| panic!("round {round}, {rings:?}, {region:?}: {e}"));
            }
        }
    }
    // Skeletons are not the subject here; where there is none, there are other tests.
    assert!(missing <= 2, "{missing} skeletons are missing");
}

#[test]
fn areas_around_lines_with_weights() {
    let mut state = 11_u32;
    let mut draw = |n: u32| {
        state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        f64::from((state >> 16) % n)
    };
    let (mut missing, mut holes, mut several) = (0, 0, 0);
    for round in 0..400 {
        let mut builder = FigureBuilder::new();
        let even = round % 4 == 0;
        for i in 0..6 {
            // Each in a field of its own, so that they never cross.
            let (x, y) = (f64::from(i % 3) * 12.0, f64::from(i / 3) * 12.0);
            let points = vec![[x + draw(5), y + draw(9)], [x + 5.0 + draw(5), y + draw(9)]];
            let mut speed = || if even { 1.0 } else { 0.5 + draw(16) * 0.25 };
            builder.weighted_polyline(points, vec![[speed(), speed()]]);
        }
        let figure = builder.build().expect("valid");
        let Ok(skeleton) = std::panic::catch_unwind(|| figure.skeleton(Options::default())) else {
            println!(
                "no skeleton in round {round}: {:?} {:?}",
                figure.vertices(),
                figure.edges()
            );
            missing += 1;
            continue;
        };
        holes += (0..skeleton.faces().len())
            .map(|f| skeleton.holes(FaceId::new(f)).count())
            .sum::<usize>();
        let distances = telling_distances(&skeleton, 20);
        check(&skeleton, &figure, &distances, 0.0).unwrap_or_else(|e| panic!("round {round}: {e}"));
        let offsets = skeleton.offsets(&figure, &distances).expect("distances");
        several += offsets.iter().filter(|o| o.parts().len() > 1).count();
        for offset in &offsets {
            let unbounded = offset
                .parts()
                .iter()
                .filter(|part| part.shell.is_none())
                .count();
            assert_eq!(
                unbounded,
                1,
                "round {round}, at {}: {:?}",
                offset.distance(),
                offset.parts()
            );
            for part in offset.parts() {
                let Some(shell) = part.shell else { continue };
                let size: f64 = part.holes.iter().map(|&h| offset.loops()[h].area()).sum();
                assert!(
                    size + offset.loops()[shell].area() > 0.0,
                    "round {round}: {part:?} of {offset:?}"
                );
            }
        }
    }
    println!("{missing} missing, {holes} holes in faces, {several} offsets of several parts");
    assert_eq!(missing, 0, "skeletons are missing");
    assert!(several > 0);
}

#[test]
fn areas_of_buildings() {
    let list = polygons(&["spacenet", "osm-helsinki", "momepy-bubenec"], 500);
    let mut failures = Vec::new();
    for (id, figure, size) in &list {
        for (region, covered) in [(Region::Interior, *size), (Region::Exterior, -size)] {
            let skeleton = figure.skeleton(Options::default().region(region));
            let distances = telling_distances(&skeleton, 8);
            if let Err(message) = check(&skeleton, figure, &distances, covered) {
                failures.push(format!("{id} {region:?}: {message}"));
            }
        }
    }
    println!("{} polygons, {} flawed", list.len(), failures.len());
    for failure in failures.iter().take(30) {
        println!("{failure}");
    }
    assert!(
        failures.is_empty(),
        "{} of {} polygons have flaws",
        failures.len(),
        list.len()
    );
}
