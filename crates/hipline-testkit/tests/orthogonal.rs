//! The engine for orthogonal monotone polygons against the kinetic one and the reference, arc for arc and bit for bit.

mod common;

use std::panic::{AssertUnwindSafe, catch_unwind};

use common::count;
use hipline::Figure;
use hipline::topology::{FaceId, NodeId};
use hipline::{Engine, NotApplicable, Options, Region, Skeleton};
use hipline_testkit::Case;
use hipline_testkit::agreement::{End, compare, drawn};
use hipline_testkit::case::Part;
use hipline_testkit::generate::{Columns, Random, columns, orthogonal, subdivide};
use hipline_testkit::hunt::check_all;
use hipline_testkit::metamorphic::Map;
use hipline_testkit::reference::{Graph, reference};

fn by(engine: Engine, figure: &Figure) -> Skeleton {
    figure
        .skeleton_by(engine, Options::default())
        .unwrap_or_else(|reason| panic!("{engine:?}: {reason}"))
}

/// The corners of a face as places.
fn corners(skeleton: &Skeleton, face: usize) -> Vec<End> {
    let end = |node: &NodeId| {
        let node = skeleton.node(*node);
        End::new([node.x, node.y], node.time, None)
    };
    skeleton
        .boundary(FaceId::new(face))
        .iter()
        .map(end)
        .collect()
}

/// How two skeletons of one figure differ.
fn difference(found: &Skeleton, due: &Skeleton) -> Option<String> {
    let (arcs, expected) = (drawn(found), drawn(due));
    let missing = expected
        .iter()
        .filter(|arc| arcs.binary_search(arc).is_err());
    let extra = arcs
        .iter()
        .filter(|arc| expected.binary_search(arc).is_err());
    let mut lines: Vec<String> = missing
        .take(20)
        .map(|arc| format!("missing {arc}"))
        .collect();
    lines.extend(extra.take(20).map(|arc| format!("extra {arc}")));
    if arcs.len() != expected.len() {
        lines.push(format!("{} arcs instead of {}", arcs.len(), expected.len()));
    }
    if found.nodes().len() != due.nodes().len() {
        let counts = [found, due].map(|skeleton| skeleton.nodes().len());
        lines.push(format!("{} nodes instead of {}", counts[0], counts[1]));
    }
    let vertices = due.input().vertices;
    if found.nodes()[..vertices] != due.nodes()[..vertices] {
        lines.push("other vertices".to_owned());
    }
    if found.input() != due.input() || found.region() != due.region() {
        lines.push("another input".to_owned());
    }
    if found.faces() != due.faces() {
        let names = |skeleton: &Skeleton| -> Vec<_> {
            let faces = skeleton.faces().iter();
            faces
                .map(|face| (face.edge, face.side, face.phase))
                .collect()
        };
        if names(found) != names(due) {
            lines.push("other faces".to_owned());
        }
    } else if lines.is_empty() {
        for face in 0..due.faces().len() {
            let [one, other] = [found, due].map(|skeleton| corners(skeleton, face));
            if one != other {
                lines.push(format!("face {face}: {one:?} instead of {other:?}"));
            }
        }
    }
    (!lines.is_empty()).then(|| lines.join("\n"))
}

/// How the engine fails on a case.
fn failure(case: &Case, with_reference: bool) -> Option<String> {
    let figure = match case.figure() {
        Ok(figure) => figure,
        Err(flaws) => return Some(format!("{flaws}")),
    };
    let found = catch_unwind(AssertUnwindSafe(|| by(Engine::Orthogonal, &figure)));
    let Ok(found) = found else {
        return Some("the engine panics".to_owned());
    };
    let mut how = difference(&found, &by(Engine::Kinetic, &figure));
    if how.is_none() && with_reference {
        let expected = reference(&Graph::from(&figure), Region::Interior);
        how = compare(&figure, &found, &expected)
            .err()
            .map(|d| d.to_string());
    }
    if how.is_none() {
        how = found
            .verify(&figure)
            .err()
            .map(|violations| violations.to_string());
    }
    how
}

#[test]
fn agrees_with_the_kinetic_engine() {
    check_all((0..count(20_000, 500)).map(orthogonal), |case| {
        failure(case, false).into_iter().collect()
    });
}

#[test]
fn agrees_with_the_reference() {
    check_all((0..count(1500, 50)).map(orthogonal), |case| {
        failure(case, case.size() <= 14).into_iter().collect()
    });
}

#[test]
fn maps_along() {
    for seed in 0..count(3000, 100) {
        let case = orthogonal(1_000_000 + seed);
        let arcs = |case: &Case| {
            let figure = case.figure().expect("valid");
            drawn(&by(Engine::Orthogonal, &figure))
        };
        let before = arcs(&case);
        for map in Map::some().into_iter().filter(|map| !map.rounds()) {
            if let Err(difference) = map.check(&before, &arcs(&map.apply(&case))) {
                panic!("{difference}\n{}", case.to_text());
            }
        }
    }
}

/// A large polygon of each kind of landscape, on integers and off them.
fn large(n: usize, random: &mut Random) -> Vec<(String, Case)> {
    let hows = [
        Columns::Any(1000),
        Columns::Walk(3),
        Columns::Walk(1000),
        Columns::Apart(4),
        Columns::Apart(1_000_000),
    ];
    let mut cases = Vec::new();
    for (how, scale) in hows.into_iter().zip([0.1, 1.0, 0.1, 1.0, 1.0]) {
        let mut ring = columns(random, n / 5, 5, how);
        if random.one_in(2) {
            ring = subdivide(random, &ring, 5);
        }
        let points = ring.iter().map(|p| p.map(|x| x as f64 * scale)).collect();
        let label = format!("{how:?} times {scale}");
        cases.push((label, Case::of(vec![Part::polygon(vec![points])])));
    }
    cases
}

#[test]
fn large_ones_agree_with_the_kinetic_engine() {
    for (label, case) in large(count(100_000, 2000) as usize, &mut Random::new(3)) {
        let figure = case.figure().expect("valid");
        let found = by(Engine::Orthogonal, &figure);
        let difference = difference(&found, &by(Engine::Kinetic, &figure));
        assert_eq!(difference, None, "{label}");
        // The automatic choice is this engine: it counts its steps.
        let chosen = figure.skeleton(Options::default());
        assert!(
            chosen.stats().steps > 0,
            "{label}: another engine was chosen"
        );
        assert_eq!(chosen, found, "{label}: the same twice");
    }
}

/// Counted steps per vertex do not grow.
#[test]
fn steps_grow_linearly() {
    for n in [1000, 10_000, 100_000, 1_000_000] {
        if n > 100_000 && cfg!(debug_assertions) {
            continue;
        }
        for (label, case) in large(n, &mut Random::new(n as u64)) {
            let figure = case.figure().expect("valid");
            let skeleton = by(Engine::Orthogonal, &figure);
            let steps = skeleton.stats().steps as f64 / figure.vertices().len() as f64;
            assert!(steps < 6.0, "{label}, {n}: {steps} steps a vertex");
        }
    }
}

/// A wall whose face has a long right chain, and a merge chain that comes down along it in many steps: a merge that
/// searched from the start each time would take a quadratic number of steps.
#[test]
fn long_chains_are_walked_once() {
    let mut steps = Vec::new();
    for n in [500_i32, 4000] {
        // Stairs up on the floor and stairs down from the ceiling, behind a wall that is as high as all.
        let mut ring = vec![[0.0, f64::from(100 * n)], [0.0, 0.0]];
        for k in 0..n {
            let x = f64::from(4 * k);
            ring.extend([
                [x + 3.0, 0.0],
                [x + 3.0, 1.0],
                [x + 4.0, 1.0],
                [x + 4.0, 0.0],
            ]);
        }
        let last = f64::from(4 * n + 1);
        ring.extend([[last, 0.0], [last, f64::from(50 * n)]]);
        for k in (1..n).rev() {
            let x = f64::from(4 * k);
            let y = f64::from(50 * n) + f64::from(n - k) * 3.0;
            ring.extend([[x, y - 3.0], [x, y]]);
        }
        ring.push([2.0, f64::from(53 * n) - 3.0]);
        ring.push([2.0, f64::from(100 * n)]);
        let figure = Case::of(vec![Part::polygon(vec![ring])])
            .figure()
            .expect("valid");
        let found = by(Engine::Orthogonal, &figure);
        if n < 1000 {
            assert_eq!(difference(&found, &by(Engine::Kinetic, &figure)), None);
        }
        steps.push(found.stats().steps as f64 / figure.vertices().len() as f64);
    }
    assert!(
        steps[1] < 1.2 * steps[0] && steps[1] < 8.0,
        "{steps:?} steps a vertex"
    );
}

#[test]
fn others_are_refused_or_left_to_the_kinetic_engine() {
    let triangle = Case::of(vec![Part::polygon(vec![vec![
        [0., 0.],
        [4., 0.],
        [0., 3.],
    ]])]);
    let figure = triangle.figure().expect("valid");
    let refused = figure.skeleton_by(Engine::Orthogonal, Options::default());
    assert!(
        matches!(refused, Err(NotApplicable::NotOrthogonal { edge }) if edge.index() == 1),
        "the slanted edge is named"
    );
    assert_eq!(
        drawn(&figure.skeleton(Options::default())),
        drawn(&by(Engine::Kinetic, &figure))
    );
}
