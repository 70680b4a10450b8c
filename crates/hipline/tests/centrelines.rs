//! Centrelines known by hand.

#![allow(clippy::float_cmp, reason = "these results are exact")]

mod offset_support;

use hipline::{
    Figure, FigureBuilder, Options, Region,
    centreline::{CentrelineOptions, InvalidPruning, Line},
};
use offset_support::{HOLE, OUTER, PLUS, RECTANGLE, SQUARE, lines, polygon};

/// A figure's centreline, each line beginning with its smaller end, sorted.
fn centreline(figure: &Figure, options: CentrelineOptions) -> Vec<Vec<[f64; 3]>> {
    let skeleton = figure.skeleton(Options::default());
    let found = skeleton.centreline(figure, options).expect("options");
    let mut list: Vec<Vec<[f64; 3]>> = found
        .lines()
        .iter()
        .map(|line| {
            let mut points = line.points().to_vec();
            if points[points.len() - 1] < points[0] {
                points.reverse();
            }
            points
        })
        .collect();
    list.sort_by(|a, b| a.partial_cmp(b).expect("numbers"));
    list
}

fn plain() -> CentrelineOptions {
    CentrelineOptions::default()
}

/// A bar of width 4 from x = 0 to 20, with a stem of width 2 and a length of 6 below it.
const TEE: &[[f64; 2]] = &[
    [0.0, 0.0],
    [9.0, 0.0],
    [9.0, -6.0],
    [11.0, -6.0],
    [11.0, 0.0],
    [20.0, 0.0],
    [20.0, 4.0],
    [0.0, 4.0],
];

#[test]
fn rectangle_has_its_ridge() {
    let figure = polygon(&[RECTANGLE]);
    let ridge = vec![[2.0, 2.0, 2.0], [6.0, 2.0, 2.0]];
    assert_eq!(centreline(&figure, plain()), std::slice::from_ref(&ridge));
    // Neither pruning nor choosing leaves nothing.
    for options in [
        plain().prune(1e300),
        plain().prune_ratio(1e300),
        plain().longest(true),
    ] {
        assert_eq!(centreline(&figure, options), std::slice::from_ref(&ridge));
    }
    let whole = [[0.0, 2.0, 0.0], ridge[0], ridge[1], [8.0, 2.0, 0.0]];
    assert_eq!(centreline(&figure, plain().extend(true)), [whole]);
}

#[test]
fn a_point_is_no_line() {
    let figure = polygon(&[SQUARE]);
    assert_eq!(centreline(&figure, plain().extend(true)).len(), 0);
    let triangle = polygon(&[&[[0.0, 0.0], [4.0, 0.0], [1.0, 3.0]]]);
    assert_eq!(centreline(&triangle, plain()).len(), 0);
}

#[test]
fn straight_vertices_change_nothing() {
    // One whose ghost arc ends on an arc at a corner, one at the end of the ridge, one below it.
    let figure = polygon(&[&[
        [0.0, 0.0],
        [5.0, 0.0],
        [8.0, 0.0],
        [8.0, 2.0],
        [8.0, 4.0],
        [0.0, 4.0],
        [0.0, 1.0],
    ]]);
    let whole = [
        [0.0, 2.0, 0.0],
        [2.0, 2.0, 2.0],
        [5.0, 2.0, 2.0],
        [6.0, 2.0, 2.0],
        [8.0, 2.0, 0.0],
    ];
    assert_eq!(centreline(&figure, plain()), [whole[1..4].to_vec()]);
    assert_eq!(centreline(&figure, plain().extend(true)), [whole]);
}

#[test]
fn cross_has_four_arms() {
    let figure = polygon(&[PLUS]);
    let middle = [3.0, 3.0, 1.0];
    let arms = [
        vec![[1.0, 3.0, 1.0], middle],
        vec![[3.0, 1.0, 1.0], middle],
        vec![middle, [3.0, 5.0, 1.0]],
        vec![middle, [5.0, 3.0, 1.0]],
    ];
    assert_eq!(centreline(&figure, plain()), arms);
    // All arms are equally long; two remain, and those that were shortest first go first.
    let pruned = centreline(&figure, plain().prune(2.1));
    assert_eq!(pruned.len(), 1, "{pruned:?}");
    assert_eq!(pruned, centreline(&figure, plain().longest(true)));
    assert_eq!(centreline(&figure, plain().prune(2.0)), arms);
}

#[test]
fn a_stem_is_joined_to_its_bar_and_pruned_by_length() {
    // The edges on both sides of the stem are on one line: what joins it is a ghost arc.
    let figure = polygon(&[TEE]);
    let bar = [[2.0, 2.0, 2.0], [10.0, 2.0, 2.0], [18.0, 2.0, 2.0]];
    let stem = vec![[10.0, -5.0, 1.0], [10.0, 1.0, 1.0], bar[1]];
    let all = [bar[..2].to_vec(), stem, bar[1..].to_vec()];
    // The stem is 7 long, and the bar is 4 wide where it ends.
    for options in [plain(), plain().prune(7.0), plain().prune_ratio(1.75)] {
        assert_eq!(centreline(&figure, options), all, "{options:?}");
    }
    for options in [
        plain().prune(7.0_f64.next_up()),
        plain().prune_ratio(1.75_f64.next_up()),
        plain().longest(true),
    ] {
        assert_eq!(centreline(&figure, options), [bar.to_vec()], "{options:?}");
    }
    let whole = centreline(&figure, plain().extend(true));
    let ends: Vec<_> = whole.iter().flat_map(|line| line.iter()).collect();
    for end in [[0.0, 2.0, 0.0], [20.0, 2.0, 0.0], [10.0, -6.0, 0.0]] {
        assert!(ends.contains(&&end), "{end:?} in {whole:?}");
    }
}

#[test]
fn an_odd_number_of_arcs_ends_at_a_vertex() {
    // A house with a pointed gable: the ridge ends where arcs of three vertices meet.
    let figure = polygon(&[&[
        [0.0, 0.0],
        [8.0, 0.0],
        [8.0, 12.0],
        [4.0, 15.0],
        [0.0, 12.0],
    ]]);
    let [line] = &centreline(&figure, plain().extend(true))[..] else {
        panic!("one line")
    };
    assert_eq!(line[0], [4.0, 0.0, 0.0]);
    assert_eq!(line[1], [4.0, 4.0, 4.0]);
    assert_eq!(line[line.len() - 1], [4.0, 15.0, 0.0]);
    assert_eq!(line[2], [4.0, 10.0, 4.0], "the apothem of the gable");
}

#[test]
fn ring_is_a_cycle_that_nothing_prunes() {
    let figure = polygon(&[OUTER, HOLE]);
    for options in [
        plain(),
        plain()
            .prune(1e9)
            .prune_ratio(1e9)
            .longest(true)
            .extend(true),
    ] {
        let [cycle] = &centreline(&figure, options)[..] else {
            panic!("one line")
        };
        assert_eq!(cycle.len(), 5, "{cycle:?}");
        assert_eq!(cycle[0], cycle[4]);
        for [x, y, time] in cycle {
            assert_eq!([(x - 4.5).abs(), (y - 4.5).abs(), *time], [3.0, 3.0, 1.5]);
        }
    }
    let skeleton = figure.skeleton(Options::default());
    let found = skeleton.centreline(&figure, plain()).expect("options");
    assert!(found.lines().iter().all(Line::is_closed));
    assert_eq!(found.lines()[0].length(), 24.0);
}

#[test]
fn lines_have_one_between_them() {
    // Between two parallel lines of the same length, whose ends move on, too; what goes to
    // infinity is left out.
    let figure = lines(&[&[[0.0, 0.0], [8.0, 0.0]], &[[0.0, 2.0], [8.0, 2.0]]]);
    assert_eq!(
        centreline(&figure, plain()),
        [vec![[-1.0, 1.0, 1.0], [9.0, 1.0, 1.0]]]
    );
    let skeleton = polygon(&[RECTANGLE]);
    let outside = skeleton.skeleton(Options::default().region(Region::Exterior));
    let found = outside.centreline(&skeleton, plain()).expect("options");
    assert_eq!(found.lines(), []);
}

#[test]
fn several_polygons_have_one_each() {
    let mut builder = FigureBuilder::new();
    for x in [0.0, 10.0] {
        builder.polygon(vec![RECTANGLE.iter().map(|p| [p[0] + x, p[1]]).collect()]);
    }
    let figure = builder.build().expect("valid");
    let found = centreline(&figure, plain().longest(true));
    assert_eq!(found.len(), 2, "{found:?}");
}

#[test]
fn pruning_by_nonsense_is_refused() {
    let figure = polygon(&[RECTANGLE]);
    let skeleton = figure.skeleton(Options::default());
    for wrong in [-1.0, f64::INFINITY, f64::NAN] {
        for options in [plain().prune(wrong), plain().prune_ratio(wrong)] {
            let Err(InvalidPruning(value)) = skeleton.centreline(&figure, options) else {
                panic!("{wrong} was taken")
            };
            assert_eq!(value.to_bits(), wrong.to_bits());
        }
    }
}
