//! Offsets: loops known by hand.

#![allow(clippy::float_cmp, reason = "these results are exact")]

mod offset_support;

use hipline::{
    Figure, FigureBuilder, Options, Region,
    offset::{InvalidOffset, Offset, Part},
};
use offset_support::{ELL, FUNNEL, HOLE, OUTER, PLUS, RECTANGLE, SQUARE, area, lines, polygon};

fn offset(figure: &Figure, region: Region, distance: f64) -> Offset {
    let skeleton = figure.skeleton(Options::default().region(region));
    skeleton.offset(figure, distance).expect("a distance")
}

fn inside(figure: &Figure, distance: f64) -> Offset {
    offset(figure, Region::Interior, distance)
}

/// The points of the only loop, sorted.
fn only_loop(offset: &Offset) -> Vec<[f64; 2]> {
    let [one] = offset.loops() else {
        panic!("{} loops", offset.loops().len())
    };
    let mut points = one.points().to_vec();
    points.sort_by(|a, b| a.partial_cmp(b).expect("numbers"));
    points
}

#[test]
fn square_shrinks_to_nothing() {
    let figure = polygon(&[SQUARE]);
    assert_eq!(
        only_loop(&inside(&figure, 0.0)),
        [[0.0, 0.0], [0.0, 4.0], [4.0, 0.0], [4.0, 4.0]]
    );
    let one = inside(&figure, 1.0);
    assert_eq!(
        only_loop(&one),
        [[1.0, 1.0], [1.0, 3.0], [3.0, 1.0], [3.0, 3.0]]
    );
    assert_eq!(
        one.parts(),
        [Part {
            shell: Some(0),
            holes: vec![]
        }]
    );
    assert_eq!(one.loops()[0].perimeter(), 8.0);
    for gone in [2.0, 2.5] {
        assert_eq!(inside(&figure, gone).loops().len(), 0, "at {gone}");
    }
}

#[test]
fn each_edge_knows_its_face() {
    let figure = polygon(&[RECTANGLE]);
    let skeleton = figure.skeleton(Options::default());
    let offset = skeleton.offset(&figure, 1.0).expect("a distance");
    let ring = &offset.loops()[0];
    for (i, face) in ring.faces().iter().enumerate() {
        let [p, q] = [
            ring.points()[i],
            ring.points()[(i + 1) % ring.points().len()],
        ];
        let edge = &figure.edges()[skeleton.face(*face).edge.index()];
        let [a, b] = [edge.from, edge.to].map(|v| figure.vertices()[v.index()]);
        let (u, v) = ([q[0] - p[0], q[1] - p[1]], [b[0] - a[0], b[1] - a[1]]);
        assert_eq!(u[0] * v[1] - u[1] * v[0], 0.0, "parallel");
        assert!(u[0] * v[0] + u[1] * v[1] > 0.0, "in the same sense");
        let lead = ((p[1] - a[1]) * v[0] - (p[0] - a[0]) * v[1]) / v[0].hypot(v[1]);
        assert_eq!(lead, 1.0, "one ahead");
    }
}

#[test]
fn what_collapses_is_absent() {
    // The ridge of a rectangle, at once.
    assert_eq!(inside(&polygon(&[RECTANGLE]), 2.0).loops().len(), 0);
    // The arm of the L at 1; what is left is no spike.
    let ell = inside(&polygon(&[ELL]), 1.0);
    assert_eq!(
        only_loop(&ell),
        [[1.0, 1.0], [1.0, 3.0], [5.0, 1.0], [5.0, 3.0]]
    );
    // All four arms of the plus.
    let plus = inside(&polygon(&[PLUS]), 1.0);
    assert_eq!(plus.loops().len(), 0);
    let frame = inside(&polygon(&[OUTER, HOLE]), 1.5);
    assert_eq!(frame.loops().len(), 0);
}

#[test]
fn frame_is_one_part_with_a_hole() {
    let offset = inside(&polygon(&[OUTER, HOLE]), 1.0);
    assert_eq!(offset.loops().len(), 2);
    let [part] = offset.parts() else {
        panic!("one part")
    };
    let [hole] = part.holes[..] else {
        panic!("one hole")
    };
    assert_eq!(offset.loops()[part.shell.expect("a shell")].area(), 49.0);
    assert_eq!(offset.loops()[hole].area(), -25.0);
    let rings: Vec<_> = offset.polygons().collect();
    assert_eq!(rings.len(), 1);
    assert_eq!([area(&rings[0][0]), area(&rings[0][1])], [49.0, -25.0]);
}

#[test]
fn a_waist_splits_the_loop_at_its_time() {
    // Two chambers, a waist of width 2 between them: reflex points at (5, 2) and (5, 4).
    let hourglass = polygon(&[&[
        [0.0, 0.0],
        [5.0, 2.0],
        [10.0, 0.0],
        [10.0, 6.0],
        [5.0, 4.0],
        [0.0, 6.0],
    ]]);
    let skeleton = hourglass.skeleton(Options::default());
    let split = skeleton
        .nodes()
        .iter()
        .find(|n| n.x == 5.0 && n.y == 3.0)
        .expect("a split")
        .time;
    let count = |d: f64| {
        let offset = skeleton.offset(&hourglass, d).expect("a distance");
        assert_eq!(offset.parts().len(), offset.loops().len(), "no holes");
        offset.loops().len()
    };
    assert_eq!(count(split.next_down()), 1);
    // The split is at 5 / sqrt(29): on which side of it does the nearest f64 lie?
    let mantissa = (split * (1_u64 << 53) as f64) as u128;
    let reached = 29 * mantissa * mantissa >= 25 << 106;
    assert_eq!(count(split), if reached { 2 } else { 1 });
    assert_eq!(count(split.next_up()), 2);
}

#[test]
fn rational_split_is_decided_exactly() {
    // A bar of width 2 with a notch of 45 degrees would be irrational; this one is 3-4-5.
    let figure = polygon(&[&[
        [-8.0, 0.0],
        [8.0, 0.0],
        [8.0, 9.0],
        [3.0, 9.0],
        [0.0, 5.0],
        [-3.0, 9.0],
        [-8.0, 9.0],
    ]]);
    let skeleton = figure.skeleton(Options::default());
    let split = skeleton
        .nodes()
        .iter()
        .find(|n| n.x == 0.0 && n.time > 0.0)
        .expect("a split");
    // Tip (0, 5) descends with speed 5/3, the floor rises with 1: 5 / (8/3) = 1.875.
    assert_eq!(split.time, 1.875);
    let loops = |d: f64| {
        skeleton
            .offset(&figure, d)
            .expect("a distance")
            .loops()
            .len()
    };
    assert_eq!([loops(1.874), loops(1.875), loops(1.876)], [1, 2, 2]);
}

#[test]
fn outward_rings_are_mitred() {
    let offset = offset(&polygon(&[SQUARE]), Region::Exterior, 1.0);
    assert_eq!(
        only_loop(&offset),
        [[-1.0, -1.0], [-1.0, 5.0], [5.0, -1.0], [5.0, 5.0]]
    );
    assert_eq!(offset.loops()[0].area(), -36.0);
    assert_eq!(
        offset.parts(),
        [Part {
            shell: None,
            holes: vec![0]
        }]
    );
    assert_eq!(offset.polygons().count(), 0);
}

#[test]
fn whole_plane_has_both() {
    let offset = offset(&polygon(&[SQUARE]), Region::Both, 1.0);
    assert_eq!(offset.loops().len(), 2);
    assert_eq!(offset.parts().len(), 2);
    let areas: f64 = offset.loops().iter().map(|l| l.area()).sum();
    assert_eq!(areas, 4.0 - 36.0);
}

#[test]
fn outside_merges_when_loops_meet() {
    let mut builder = FigureBuilder::new();
    builder.polygon(vec![SQUARE.to_vec()]);
    builder.polygon(vec![SQUARE.iter().map(|p| [p[0] + 6.0, p[1]]).collect()]);
    let figure = builder.build().expect("valid");
    let loops = |d: f64| offset(&figure, Region::Exterior, d).loops().len();
    assert_eq!(
        [loops(0.0), loops(0.75), loops(1.0), loops(1.25)],
        [2, 2, 1, 1]
    );
    // Both have edges on the lines y = 5 and y = -1: ghost arcs keep the points between them.
    let merged = only_loop(&offset(&figure, Region::Exterior, 1.5));
    let corners = [-1.5, 11.5].into_iter().flat_map(|x| [[x, -1.5], [x, 5.5]]);
    assert!(
        corners.into_iter().all(|p| merged.contains(&p)),
        "{merged:?}"
    );
    assert!(
        merged.contains(&[5.0, -1.5]) && merged.contains(&[5.0, 5.5]),
        "{merged:?}"
    );
}

#[test]
fn segment_on_both_sides() {
    let figure = lines(&[&[[0.0, 0.0], [4.0, 0.0]]]);
    let ring = offset(&figure, Region::Both, 1.0);
    assert_eq!(
        only_loop(&ring),
        [[-1.0, -1.0], [-1.0, 1.0], [5.0, -1.0], [5.0, 1.0]]
    );
    assert_eq!(ring.loops()[0].area(), -12.0);
    let start = offset(&figure, Region::Both, 0.0);
    assert_eq!(only_loop(&start), [[0.0, 0.0], [4.0, 0.0]]);
}

#[test]
fn ghost_arcs_keep_their_points() {
    let figure = polygon(&[&[[0.0, 0.0], [1.5, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0]]]);
    let offset = inside(&figure, 1.0);
    assert_eq!(
        only_loop(&offset),
        [[1.0, 1.0], [1.0, 3.0], [1.5, 1.0], [3.0, 1.0], [3.0, 3.0]]
    );
    // At 1.5 the shorter piece ends, in a point that exists exactly.
    let later = inside(&figure, 1.5);
    assert_eq!(
        only_loop(&later),
        [[1.5, 1.5], [1.5, 2.5], [2.5, 1.5], [2.5, 2.5]]
    );
}

#[test]
fn wrong_distances() {
    let figure = polygon(&[SQUARE]);
    let skeleton = figure.skeleton(Options::default());
    for wrong in [-1.0, f64::INFINITY, f64::NEG_INFINITY] {
        assert_eq!(
            skeleton.offsets(&figure, &[1.0, wrong]),
            Err(InvalidOffset::Distance(wrong))
        );
    }
    assert!(skeleton.offset(&figure, f64::NAN).is_err());
    assert_eq!(skeleton.offsets(&figure, &[]), Ok(vec![]));
    let order: Vec<f64> = [1.5, 0.5, 1.5].into();
    let found = skeleton.offsets(&figure, &order).expect("distances");
    assert_eq!(
        found.iter().map(Offset::distance).collect::<Vec<_>>(),
        order
    );
}

#[test]
#[should_panic(expected = "not that of this figure")]
fn figure_of_another_skeleton() {
    let skeleton = polygon(&[SQUARE]).skeleton(Options::default());
    let _ = skeleton.offset(&polygon(&[ELL]), 1.0);
}

#[test]
fn offset_of_an_offset() {
    for shape in [SQUARE, RECTANGLE, ELL, PLUS, FUNNEL] {
        let figure = polygon(&[shape]);
        let first = only_loop_in_order(&inside(&figure, 0.25));
        let second = inside(&polygon(&[&first]), 0.5);
        let at_once = inside(&figure, 0.75);
        let [p, q] = [second, at_once].map(|o| only_loop(&o));
        assert_eq!(p.len(), q.len(), "{p:?} {q:?}");
        let far = p
            .iter()
            .flatten()
            .zip(q.iter().flatten())
            .map(|(a, b)| (a - b).abs());
        assert!(far.fold(0.0, f64::max) < 1e-12, "{p:?} {q:?}");
    }
}

fn only_loop_in_order(offset: &Offset) -> Vec<[f64; 2]> {
    assert_eq!(offset.loops().len(), 1);
    offset.loops()[0].points().to_vec()
}

#[test]
fn perimeter_of_a_convex_polygon_falls() {
    let figure = polygon(&[&[[0.0, 0.0], [7.0, 1.0], [9.0, 5.0], [5.0, 8.0], [1.0, 6.0]]]);
    let skeleton = figure.skeleton(Options::default());
    let distances: Vec<f64> = (0..40).map(|i| f64::from(i) * 0.1).collect();
    let offsets = skeleton.offsets(&figure, &distances).expect("distances");
    let lengths: Vec<f64> = offsets
        .iter()
        .map(|o| o.loops().iter().map(|l| l.perimeter()).sum())
        .collect();
    assert!(
        lengths.windows(2).all(|w| w[1] < w[0] || w[0] == 0.0),
        "{lengths:?}"
    );
    assert!(lengths[39] == 0.0);
}

#[test]
fn an_island_in_a_face_belongs_to_the_part_around_it() {
    // A fast front overruns a slow square, which then lies inside the front's face.
    let mut builder = FigureBuilder::new();
    builder.weighted_polyline(vec![[-50.0, 0.0], [50.0, 0.0]], vec![[4.0, 1.0]]);
    let island = vec![
        [-1.0, 3.0],
        [1.0, 3.0],
        [1.0, 5.0],
        [-1.0, 5.0],
        [-1.0, 3.0],
    ];
    builder.weighted_polyline(island, vec![[0.5, 0.5]; 4]);
    let figure = builder.build().expect("valid");
    let skeleton = figure.skeleton(Options::default().region(Region::Both));
    let offset = skeleton.offset(&figure, 0.25).expect("a distance");
    assert_eq!(offset.loops().len(), 3);
    let outside: Vec<&Part> = offset
        .parts()
        .iter()
        .filter(|p| p.shell.is_none())
        .collect();
    let [part] = outside[..] else {
        panic!("{:?}", offset.parts())
    };
    assert_eq!(part.holes.len(), 2, "the front and the island");
    assert_eq!(offset.parts().len(), 2, "and the inside of the island");
    // Beyond the island the front is one edge again.
    let later = skeleton.offset(&figure, 2.0).expect("a distance");
    let ring = &later.loops()[0];
    let next = ring.faces().iter().skip(1).chain(ring.faces().first());
    assert!(
        ring.faces().iter().zip(next).all(|(f, g)| f != g),
        "{ring:?}"
    );
}
