//! Skeletons of shapes full of coincidences pass their verification, in every region.

use hipline::{Figure, FigureBuilder, Options, Region};
use hipline_testkit::generate::STRAIGHT_VERTICES;

type Ring = Vec<[f64; 2]>;

fn polygon(rings: Vec<Ring>) -> Figure {
    let mut builder = FigureBuilder::new();
    builder.polygon(rings);
    builder.build().expect("a valid polygon")
}

fn lines(lines: Vec<Ring>) -> Figure {
    let mut builder = FigureBuilder::new();
    for line in lines {
        builder.polyline(line);
    }
    builder.build().expect("valid lines")
}

fn check(figure: &Figure) {
    for region in [Region::Interior, Region::Exterior, Region::Both] {
        if region != Region::Both && !figure.has_polygon() {
            continue;
        }
        let skeleton = figure.skeleton(Options::default().region(region));
        let outcome = skeleton.verify(figure);
        assert_eq!(outcome, Ok(()), "{region:?} of {:?}", figure.vertices());
    }
}

fn rectangle([x, y]: [f64; 2], [w, h]: [f64; 2]) -> Ring {
    vec![[x, y], [x + w, y], [x + w, y + h], [x, y + h]]
}

/// Corners on a circle, rounded to a grid, or not.
fn circle(corners: u32, radius: f64, grid: bool) -> Ring {
    (0..corners)
        .map(|i| {
            let angle = f64::from(i) / f64::from(corners) * std::f64::consts::TAU;
            let point = [radius * angle.cos(), radius * angle.sin()];
            if grid { point.map(f64::round) } else { point }
        })
        .collect()
}

#[test]
fn rectangles() {
    check(&polygon(vec![rectangle([0.0, 0.0], [4.0, 4.0])]));
    check(&polygon(vec![rectangle([1.0, -3.0], [8.0, 4.0])]));
    check(&polygon(vec![vec![
        [0.0, 0.0],
        [2.0, -2.0],
        [5.0, 1.0],
        [3.0, 3.0],
    ]]));
}

#[test]
fn rings_in_rings() {
    let outer = rectangle([0.0, 0.0], [9.0, 9.0]);
    check(&polygon(vec![
        outer.clone(),
        rectangle([3.0, 3.0], [3.0, 3.0]),
    ]));
    check(&polygon(vec![
        outer,
        rectangle([1.0, 1.0], [3.0, 3.0]),
        rectangle([5.0, 5.0], [3.0, 2.0]),
    ]));
    let mut builder = FigureBuilder::new();
    builder.polygon(vec![
        rectangle([0.0, 0.0], [20.0, 20.0]),
        rectangle([4.0, 4.0], [12.0, 12.0]),
    ]);
    builder.polygon(vec![rectangle([8.0, 8.0], [4.0, 4.0])]);
    check(&builder.build().expect("an island in a lake"));
}

#[test]
fn circles() {
    for corners in 3..40 {
        check(&polygon(vec![circle(corners, 1000.0, true)]));
        check(&polygon(vec![circle(corners, 1.0, false)]));
    }
}

#[test]
fn combs_and_stairs() {
    let mut comb = vec![[0.0, 0.0], [12.0, 0.0]];
    for i in (0..6).rev() {
        let x = f64::from(i) * 2.0;
        comb.extend([[x + 2.0, 4.0], [x + 1.0, 4.0], [x + 1.0, 2.0], [x, 2.0]]);
    }
    check(&polygon(vec![comb]));
    let mut stairs = vec![[0.0, 0.0]];
    for i in 0..7 {
        let i = f64::from(i);
        stairs.extend([[7.0 - i, i], [7.0 - i, i + 1.0]]);
    }
    stairs.push([0.0, 7.0]);
    check(&polygon(vec![stairs]));
}

#[test]
fn straight_vertices() {
    check(&polygon(vec![STRAIGHT_VERTICES.to_vec()]));
}

#[test]
fn grids_of_squares() {
    let mut builder = FigureBuilder::new();
    for i in 0..4 {
        for j in 0..4 {
            builder.polygon(vec![rectangle(
                [f64::from(i) * 3.0, f64::from(j) * 3.0],
                [2.0, 2.0],
            )]);
        }
    }
    check(&builder.build().expect("disjoint squares"));
}

#[test]
fn segments() {
    check(&lines(vec![vec![[0.0, 0.0], [4.0, 0.0]]]));
    check(&lines(vec![vec![[0.0, 0.0], [4.0, 3.0]]]));
    check(&lines(vec![
        vec![[0.0, 0.0], [4.0, 0.0]],
        vec![[6.0, 0.0], [10.0, 0.0]],
    ]));
    check(&lines(vec![
        vec![[0.0, 0.0], [4.0, 0.0]],
        vec![[0.0, 2.0], [4.0, 2.0]],
    ]));
    check(&lines(vec![vec![
        [0.0, 0.0],
        [4.0, 0.0],
        [4.0, 4.0],
        [8.0, 4.0],
        [8.0, 8.0],
    ]]));
    let spokes = circle(12, 100.0, true)
        .into_iter()
        .map(|end| vec![[0.0, 0.0], end]);
    check(&lines(spokes.collect()));
}

/// The face above the bar is cut in two at infinity by those of the house above it.
#[test]
fn a_face_that_is_unbounded_on_both_sides() {
    let mut builder = FigureBuilder::new();
    let house = [
        [-40.0, 10.0],
        [40.0, 10.0],
        [40.0, 12.0],
        [0.0, 13.0],
        [-40.0, 12.0],
    ];
    builder.polygon(vec![house.to_vec()]);
    builder.polygon(vec![rectangle([-100.0, -10.0], [200.0, 10.0])]);
    let figure = builder.build().expect("valid polygons");
    check(&figure);
    let skeleton = figure.skeleton(Options::default().region(Region::Both));
    let jumps = (0..skeleton.faces().len()).map(|face| {
        let corners = skeleton.boundary(hipline::topology::FaceId::new(face));
        let infinite = corners
            .iter()
            .filter(|&&n| skeleton.node(n).time.is_infinite());
        infinite.count() / 2
    });
    assert_eq!(jumps.max(), Some(2), "a face that is unbounded twice");
}
