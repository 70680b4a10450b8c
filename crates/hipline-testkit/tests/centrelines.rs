//! Centrelines of many small figures: their shape, their times, and pruning against the
//! simplest way to prune.

mod common;

use std::collections::{BTreeMap, BTreeSet};

use common::{count, field};
use hipline::{
    Figure, Options, Region, Skeleton,
    centreline::{Centreline, CentrelineOptions},
    topology::NodeId,
};
use hipline_testkit::{
    Case,
    case::Part,
    generate::{Kind, small_of},
};

const KINDS: [Kind; 7] = [
    Kind::Simple,
    Kind::Star,
    Kind::Shape,
    Kind::Polyomino,
    Kind::Holes,
    Kind::Symmetric,
    Kind::Islands,
];

fn plain() -> CentrelineOptions {
    CentrelineOptions::default()
}

/// The interior of each case that consists of polygons.
fn each(seeds: u64, mut test: impl FnMut(&Case, &Figure, &Skeleton)) {
    let mut tested = 0;
    for seed in 0..seeds {
        for kind in KINDS {
            let case = small_of(kind, seed);
            let only_polygons = case.parts.iter().all(|p| matches!(p, Part::Polygon { .. }));
            let Ok(figure) = case.figure() else { continue };
            if only_polygons {
                let skeleton = figure.skeleton(Options::default().region(Region::Interior));
                test(&case, &figure, &skeleton);
                tested += 1;
            }
        }
    }
    assert!(tested > 5 * seeds, "only {tested} cases");
}

/// Lines minus ends plus connected parts.
fn cycles(centreline: &Centreline) -> usize {
    let mut parents: BTreeMap<NodeId, NodeId> = BTreeMap::new();
    fn root(parents: &mut BTreeMap<NodeId, NodeId>, node: NodeId) -> NodeId {
        let parent = *parents.entry(node).or_insert(node);
        if parent == node {
            node
        } else {
            root(parents, parent)
        }
    }
    let mut cycles = 0;
    for line in centreline.lines() {
        let [a, b] = line.ends().map(|end| root(&mut parents, end));
        if a == b {
            cycles += 1;
        }
        parents.insert(a, b);
    }
    cycles
}

/// The lines of edges whose distance from a point is the given one.
fn edges_at(figure: &Figure, [x, y, time]: [f64; 3]) -> usize {
    let scale = figure
        .vertices()
        .iter()
        .flatten()
        .fold(1.0, |m: f64, c| m.max(c.abs()));
    let edges = figure.edges().iter().filter(|edge| {
        let [p, q] = [edge.from, edge.to].map(|v| figure.vertices()[v.index()]);
        let [dx, dy] = [q[0] - p[0], q[1] - p[1]];
        let distance = ((y - p[1]) * dx - (x - p[0]) * dy) / dx.hypot(dy);
        (distance.abs() - time).abs() <= 1e-9 * scale
    });
    edges.count()
}

#[test]
fn cycles_are_holes_and_times_are_distances() {
    each(count(400, 20), |case, figure, skeleton| {
        let found = skeleton.centreline(figure, plain()).expect("options");
        let touches = || {
            let sum: usize = case
                .parts
                .iter()
                .map(|part| match part {
                    Part::Polygon { rings, .. } => rings.iter().map(Vec::len).sum(),
                    _ => 0,
                })
                .sum();
            // A vertex on another ring's edge splits it; one on another's vertex is the same.
            figure.vertices().len() != sum || figure.edges().len() != sum
        };
        if !touches() {
            let holes: usize = case
                .parts
                .iter()
                .map(|part| match part {
                    Part::Polygon { rings, .. } => rings.len() - 1,
                    _ => 0,
                })
                .sum();
            assert_eq!(cycles(&found), holes, "{}", case.to_text());
        }
        for line in found.lines() {
            assert!(line.points().len() > 1, "{}", case.to_text());
            for &point in line.points() {
                assert!(point[2] > 0.0, "{point:?}: {}", case.to_text());
                assert!(edges_at(figure, point) > 1, "{point:?}: {}", case.to_text());
            }
        }
    });
}

#[test]
fn extended_ends_are_on_the_boundary() {
    each(count(200, 10), |case, figure, skeleton| {
        let found = skeleton.centreline(figure, plain()).expect("options");
        let extended = skeleton
            .centreline(figure, plain().extend(true))
            .expect("options");
        let mut degrees: BTreeMap<NodeId, usize> = BTreeMap::new();
        for end in found.lines().iter().flat_map(|line| line.ends()) {
            *degrees.entry(end).or_default() += 1;
        }
        for (line, longer) in found.lines().iter().zip(extended.lines()) {
            assert_eq!(line.ends(), longer.ends(), "{}", case.to_text());
            for (k, end) in line.ends().into_iter().enumerate() {
                let points = longer.points();
                let point = points[if k == 0 { 0 } else { points.len() - 1 }];
                let is_free = degrees[&end] == 1;
                assert_eq!(is_free, point[2] <= 0.0, "{point:?}: {}", case.to_text());
                if is_free {
                    assert!(edges_at(figure, point) > 0, "{point:?}: {}", case.to_text());
                }
            }
        }
    });
}

/// A branch or a line between branchings: its ends, its length, the steps it consists of.
type Piece = ([NodeId; 2], f64, BTreeSet<[u64; 4]>);

fn pieces(centreline: &Centreline) -> Vec<Piece> {
    let of = |line: &hipline::centreline::Line| {
        let steps = line.points().windows(2).map(|s| {
            let [p, q] = [s[0], s[1]].map(|p| [p[0].to_bits(), p[1].to_bits()]);
            let [p, q] = [p.min(q), p.max(q)];
            [p[0], p[1], q[0], q[1]]
        });
        (line.ends(), line.length(), steps.collect())
    };
    centreline.lines().iter().map(of).collect()
}

/// Drops the shortest branch, again and again, until none is too short.
fn pruned(mut pieces: Vec<Piece>, length: f64) -> BTreeSet<[u64; 4]> {
    loop {
        let degree = |pieces: &[Piece], node: NodeId| {
            let ends = pieces.iter().flat_map(|piece| piece.0);
            ends.filter(|&end| end == node).count()
        };
        // Lengths that differ by rounding only are equal; then the larger number goes.
        let mut shortest: Option<(f64, NodeId, usize)> = None;
        for (i, &(ends, size, _)) in pieces.iter().enumerate() {
            let [a, b] = ends.map(|end| degree(&pieces, end));
            let free = match (a, b) {
                (1, 3..) => ends[0],
                (3.., 1) => ends[1],
                _ => continue,
            };
            if size < length - 1e-9
                && shortest.is_none_or(|(other, node, _)| {
                    size < other - 1e-9 || (size < other + 1e-9 && free > node)
                })
            {
                shortest = Some((size, free, i));
            }
        }
        let Some((_, free, i)) = shortest else { break };
        let (ends, ..) = pieces.swap_remove(i);
        let joint = if ends[0] == free { ends[1] } else { ends[0] };
        let at: Vec<usize> = (0..pieces.len())
            .filter(|&k| pieces[k].0.contains(&joint))
            .collect();
        if let [a, b] = at[..]
            && degree(&pieces, joint) == 2
        {
            let other = |k: usize| {
                let [p, q] = pieces[k].0;
                if p == joint { q } else { p }
            };
            let ends = [other(a), other(b)];
            let (_, more, steps) = pieces.swap_remove(a.max(b));
            let kept = &mut pieces[a.min(b)];
            kept.0 = ends;
            kept.1 += more;
            kept.2.extend(steps);
        }
    }
    pieces.into_iter().flat_map(|piece| piece.2).collect()
}

#[test]
fn pruning_is_dropping_the_shortest_again_and_again() {
    let mut dropped = 0;
    each(count(300, 15), |case, figure, skeleton| {
        let all = skeleton.centreline(figure, plain()).expect("options");
        let all = pieces(&all);
        let steps: usize = all.iter().map(|piece| piece.2.len()).sum();
        for length in [0.7, 1.0, 2.5, 4.0, 1e6] {
            let found = skeleton
                .centreline(figure, plain().prune(length))
                .expect("options");
            let found: BTreeSet<_> = pieces(&found).into_iter().flat_map(|p| p.2).collect();
            assert_eq!(
                found,
                pruned(all.clone(), length),
                "{length}: {}",
                case.to_text()
            );
            dropped += steps - found.len();
        }
    });
    assert!(dropped > 100, "only {dropped} were dropped");
}

#[test]
fn real_figures_have_their_holes() {
    let cases = field(2000, 3);
    for case in &cases {
        let figure = case.figure().expect("it was chosen so");
        let skeleton = figure.skeleton(Options::default().region(Region::Interior));
        let found = skeleton.centreline(&figure, plain()).expect("options");
        let Part::Polygon { rings, .. } = &case.parts[0] else {
            continue;
        };
        if figure.vertices().len() == case.size() && figure.edges().len() == case.size() {
            assert_eq!(cycles(&found), rings.len() - 1, "{:?}", case.comments);
        }
        for options in [plain().prune_ratio(1.0), plain().longest(true)] {
            let fewer = skeleton
                .centreline(&figure, options.extend(true))
                .expect("options");
            assert_eq!(cycles(&fewer), cycles(&found), "{:?}", case.comments);
            assert!(
                fewer.lines().len() <= found.lines().len(),
                "{:?}",
                case.comments
            );
        }
    }
    println!("{} real figures", cases.len());
}
