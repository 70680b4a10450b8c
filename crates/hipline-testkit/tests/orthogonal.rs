//! The engine for orthogonal monotone polygons against the kinetic one and the reference, arc for arc and bit for bit.

mod common;

use std::panic::{AssertUnwindSafe, catch_unwind};
use std::thread;

use common::count;
use hipline::Figure;
use hipline::topology::{FaceId, NodeId};
use hipline::{Engine, NotApplicable, Options, Region, Skeleton};
use hipline_testkit::agreement::{End, compare, drawn};
use hipline_testkit::case::{Case, Part};
use hipline_testkit::generate::{Columns, Random, columns, orthogonal, subdivide};
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

fn check(cases: u64, with_reference: impl Fn(&Case) -> bool + Sync) {
    let threads = 2;
    println!("seeds 0 to {cases}");
    let wrong: Vec<String> = thread::scope(|scope| {
        let one = |first: u64| {
            let with_reference = &with_reference;
            move || -> Vec<String> {
                let seeds = (first..cases).step_by(threads);
                let failures = seeds.map(orthogonal).filter_map(|case| {
                    let how = failure(&case, with_reference(&case))?;
                    Some(format!("{}{how}\n", case.to_text()))
                });
                let mut found: Vec<String> = failures.take(400).collect();
                found.sort_by_key(String::len);
                found
            }
        };
        let running = [0, 1].map(|first| scope.spawn(one(first)));
        running
            .into_iter()
            .flat_map(|thread| thread.join().expect("panics are caught"))
            .collect()
    });
    let shown = wrong[..wrong.len().min(4)].join("\n");
    assert!(wrong.is_empty(), "{} wrong\n{shown}", wrong.len());
}

#[test]
fn agrees_with_the_kinetic_engine() {
    check(count(20_000, 500), |_| false);
}

#[test]
fn agrees_with_the_reference() {
    check(count(1500, 50), |case| case.size() <= 14);
}
