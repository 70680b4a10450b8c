//! Every flaw is named with its place; what is legal is accepted.

use hipline::{
    Figure, FigureBuilder, InvalidFigure, Polygon,
    input::{Flaw, Place},
};

type Ring = Vec<[f64; 2]>;

/// A ring from "x,y x,y ...".
fn ring(text: &str) -> Ring {
    let number = |text: &str| text.parse().expect("a number");
    text.split_whitespace()
        .map(|pair| {
            let (x, y) = pair.split_once(',').expect("a comma");
            [number(x), number(y)]
        })
        .collect()
}

/// A square from its lower left corner and its side.
fn square(x: f64, y: f64, side: f64) -> Ring {
    vec![[x, y], [x + side, y], [x + side, y + side], [x, y + side]]
}

/// Polygons, given as their rings.
fn polygons(parts: &[&[Ring]]) -> Result<Figure, InvalidFigure> {
    let mut builder = FigureBuilder::new();
    for rings in parts {
        builder.polygon(rings.to_vec());
    }
    builder.build()
}

fn lines(lines: &[&str]) -> Result<Figure, InvalidFigure> {
    let mut builder = FigureBuilder::new();
    for line in lines {
        builder.polyline(ring(line));
    }
    builder.build()
}

fn place(part: usize, ring: usize, index: usize) -> Place {
    Place { part, ring, index }
}

#[track_caller]
fn flaws(result: Result<Figure, InvalidFigure>, expected: &[Flaw]) {
    assert_eq!(result.expect_err("the figure is flawed").flaws, expected);
}

#[test]
fn nothing() {
    flaws(FigureBuilder::new().build(), &[Flaw::Empty]);
    flaws(polygons(&[&[]]), &[Flaw::Empty]);
}

#[test]
fn not_finite() {
    let message = polygons(&[&[square(0., 0., 9.), ring("1,1 NaN,2 2,inf 2,1")]])
        .unwrap_err()
        .to_string();
    let expected = "2 flaws:\n- part 0, ring 1, vertex 1 is not finite: (NaN, 2)\n\
        - part 0, ring 1, vertex 2 is not finite: (2, inf)";
    assert_eq!(message, expected);
}

#[test]
fn too_few_vertices() {
    let few = |at, found, needed| Flaw::TooFewVertices { at, found, needed };
    flaws(
        polygons(&[&[ring("0,0 1,1 0,0")]]),
        &[few(place(0, 0, 0), 2, 3)],
    );
    flaws(
        polygons(&[&[square(0., 0., 9.), ring("")]]),
        &[few(place(0, 1, 0), 0, 3)],
    );
    flaws(lines(&["0,0 1,0", ""]), &[few(place(1, 0, 0), 0, 2)]);
}

#[test]
fn zero_length() {
    let zero = |edge, point| Flaw::ZeroLengthEdge { edge, point };
    flaws(
        polygons(&[&[ring("0,0 4,0 4,0 4,4")]]),
        &[zero(place(0, 0, 1), [4., 0.])],
    );
    // Zero has one sign only.
    flaws(
        lines(&["1,0 0,0 -0,-0 3,3"]),
        &[zero(place(0, 0, 1), [0., 0.])],
    );
    // The closing point may be given once, not twice.
    flaws(
        polygons(&[&[ring("0,0 4,0 4,4 0,0 0,0")]]),
        &[zero(place(0, 0, 3), [0., 0.])],
    );
}

#[test]
fn graph_numbers() {
    let graph = |vertices: &str, edges: &[[usize; 2]]| {
        let mut builder = FigureBuilder::new();
        builder.graph(ring(vertices), edges.to_vec());
        builder.build()
    };
    let duplicate = Flaw::DuplicateVertex {
        first: place(0, 0, 0),
        second: place(0, 0, 2),
        point: [0., 0.],
    };
    flaws(graph("0,0 1,0 0,0 1,1", &[[0, 1], [2, 3]]), &[duplicate]);
    flaws(
        graph("0,0 1,0 5,5", &[[0, 1]]),
        &[Flaw::LonePoint {
            at: place(0, 0, 2),
            point: [5., 5.],
        }],
    );
    let range = Flaw::EdgeIndexOutOfRange {
        edge: place(0, 0, 1),
        vertex: 7,
        count: 2,
    };
    flaws(graph("0,0 1,0", &[[0, 1], [1, 7]]), &[range]);
    flaws(
        graph("0,0 1,0", &[[0, 1], [1, 1]]),
        &[Flaw::ZeroLengthEdge {
            edge: place(0, 0, 1),
            point: [1., 0.],
        }],
    );
}

#[test]
fn speeds() {
    let mut builder = FigureBuilder::new();
    builder.weighted_polygon(
        vec![square(0., 0., 9.)],
        vec![vec![1., -0.5, 0., f64::INFINITY]],
    );
    builder.weighted_polygon(vec![square(20., 0., 9.)], vec![vec![1., 1., 2.]]);
    builder.weighted_polygon(vec![square(40., 0., 9.)], vec![]);
    builder.weighted_polyline(ring("0,20 1,20 2,20"), vec![[1., -1.], [1., 1.]]);
    builder.weighted_graph(ring("0,30 1,30"), vec![[0, 1]], vec![]);
    let bad = |edge, speed| Flaw::BadSpeed { edge, speed };
    let expected = [
        bad(place(0, 0, 1), -0.5),
        bad(place(0, 0, 3), f64::INFINITY),
        Flaw::SpeedCount {
            at: place(1, 0, 0),
            found: 3,
            needed: 4,
        },
        Flaw::SpeedLists {
            part: 2,
            found: 0,
            needed: 1,
        },
        bad(place(3, 0, 0), -1.),
        Flaw::SpeedCount {
            at: place(4, 0, 0),
            found: 0,
            needed: 1,
        },
    ];
    flaws(builder.build(), &expected);
}

#[test]
fn speeds_arrive_at_their_edges() {
    let mut builder = FigureBuilder::new();
    builder.weighted_polygon(vec![square(0., 0., 9.)], vec![vec![1., 2., 3., 4.]]);
    builder.weighted_polyline(ring("9,4 5,4"), vec![[7., 8.]]);
    let figure = builder.build().unwrap();
    let speeds: Vec<[f64; 2]> = figure.edges().iter().map(|edge| edge.speeds).collect();
    // The second edge is split by the line; both halves have its speed.
    assert_eq!(
        speeds,
        [[1., 1.], [2., 2.], [3., 3.], [4., 4.], [7., 8.], [2., 2.]]
    );
    assert_eq!(figure.edges()[5].source, figure.edges()[1].source);
    assert_eq!(figure.terminals(), 1);
}

#[test]
fn edges_cross() {
    let crossing = Flaw::EdgesCross {
        first: place(0, 0, 0),
        second: place(1, 0, 1),
        near: [2., 0.],
    };
    flaws(lines(&["0,0 4,0", "0,9 2,9 2,-9"]), &[crossing]);
    // A bow tie.
    let bow = Flaw::EdgesCross {
        first: place(0, 0, 1),
        second: place(0, 0, 3),
        near: [2., 2.],
    };
    flaws(polygons(&[&[ring("0,0 4,0 0,4 4,4")]]), &[bow]);
}

#[test]
fn edges_overlap() {
    let overlap = |first, second, from, to| Flaw::EdgesOverlap {
        first,
        second,
        from,
        to,
    };
    // Polygons side by side.
    let side = overlap(place(0, 0, 1), place(1, 0, 3), [4., 1.], [4., 3.]);
    flaws(
        polygons(&[&[square(0., 0., 4.)], &[square(4., 1., 2.)]]),
        &[side],
    );
    // The same edge.
    let same = overlap(place(0, 0, 1), place(1, 0, 3), [4., 0.], [4., 4.]);
    flaws(
        polygons(&[&[square(0., 0., 4.)], &[square(4., 0., 4.)]]),
        &[same],
    );
    // A spike.
    let spike = overlap(place(0, 0, 1), place(0, 0, 2), [4., 4.], [4., 7.]);
    flaws(polygons(&[&[ring("0,0 4,0 4,7 4,4 0,4")]]), &[spike]);
    let there_and_back = overlap(place(0, 0, 0), place(0, 0, 1), [0., 0.], [1., 1.]);
    flaws(lines(&["0,0 1,1 0,0"]), &[there_and_back]);
}

#[test]
fn many_crossings_are_cut_short() {
    let size = 150;
    let mut builder = FigureBuilder::new();
    for i in 0..size {
        let x = f64::from(i);
        builder.polyline(vec![[x, -1.], [x, f64::from(size)]]);
        builder.polyline(vec![[-1., x], [f64::from(size), x]]);
    }
    let invalid = builder.build().unwrap_err();
    assert_eq!(invalid.flaws.len(), InvalidFigure::MAX_PAIRS + 1);
    assert!(matches!(
        invalid.flaws.last(),
        Some(Flaw::MorePairs { at_least: 1.. })
    ));
    let message = invalid.to_string();
    assert_eq!(message.lines().count(), 22, "{message}");
}

#[test]
fn holes_outside_shells() {
    let outside = |hole, point| Flaw::HoleOutsideShell { hole, point };
    let shell = square(0., 0., 4.);
    let result = polygons(&[&[shell.clone(), square(6., 1., 2.)]]);
    assert!(matches!(
        result.unwrap_err().flaws[..],
        [Flaw::HoleOutsideShell {
            hole: Place { ring: 1, .. },
            ..
        }]
    ));
    // Around the shell.
    let result = polygons(&[&[shell, square(-1., -1., 9.)]]);
    assert!(matches!(
        result.unwrap_err().flaws[..],
        [Flaw::HoleOutsideShell {
            hole: Place { ring: 1, .. },
            ..
        }]
    ));
    // In the hole of its own... shell, but one polygon further.
    let result = polygons(&[
        &[square(0., 0., 9.)],
        &[square(10., 0., 9.), square(1., 1., 2.)],
    ]);
    assert!(matches!(
        result.unwrap_err().flaws[..],
        [Flaw::HoleOutsideShell {
            hole: Place {
                part: 1,
                ring: 1,
                ..
            },
            ..
        }]
    ));
    // Out through two vertices of the shell.
    let result = polygons(&[&[
        ring("0,0 4,0 4,4 2,4 0,4"),
        ring("1,1 3,1 2,4 3,9 4,4 5,9 1,9 2,4"),
    ]]);
    assert!(result.is_err());
    let message = outside(place(0, 1, 2), [6., 1.]).to_string();
    assert_eq!(
        message,
        "part 0, ring 1 is not inside its shell, at part 0, ring 1, edge 2 (6, 1)"
    );
}

#[test]
fn holes_in_holes() {
    let result = polygons(&[&[square(0., 0., 9.), square(1., 1., 6.), square(2., 2., 2.)]]);
    let flaws = result.unwrap_err().flaws;
    assert!(matches!(
        flaws[..],
        [Flaw::HoleInHole {
            inner: Place { ring: 2, .. },
            outer: Place { ring: 1, .. },
            ..
        }]
    ));
}

#[test]
fn shells_overlap() {
    let result = polygons(&[&[square(0., 0., 9.)], &[square(2., 2., 2.)]]);
    let flaws = result.unwrap_err().flaws;
    assert!(matches!(
        flaws[..],
        [Flaw::ShellsOverlap {
            ring: Place {
                part: 1,
                ring: 0,
                ..
            },
            other: 0,
            ..
        }]
    ));
    // They overlap, but have vertices wherever they meet.
    let result = polygons(&[
        &[ring("0,0 4,0 4,2 4,4 2,4 0,4")],
        &[ring("2,2 4,2 6,2 6,6 2,6 2,4")],
    ]);
    let flaws = result.unwrap_err().flaws;
    assert!(
        flaws
            .iter()
            .all(|flaw| matches!(flaw, Flaw::ShellsOverlap { .. })),
        "{flaws:?}"
    );
}

#[test]
fn disconnected_insides() {
    let pieces = |pieces, places: &[(Place, [f64; 2])]| Flaw::InteriorDisconnected {
        part: 0,
        pieces,
        places: places.to_vec(),
    };
    // A figure of eight.
    let eight = pieces(2, &[(place(0, 0, 2), [4., 4.])]);
    flaws(
        polygons(&[&[ring("0,0 4,0 4,4 8,4 8,8 4,8 4,4 0,4")]]),
        &[eight],
    );
    // A hole from wall to wall; it touches the insides of two edges.
    let hole = pieces(2, &[(place(0, 1, 0), [0., 2.]), (place(0, 1, 2), [4., 2.])]);
    flaws(
        polygons(&[&[square(0., 0., 4.), ring("0,2 2,1 4,2 2,3")]]),
        &[hole],
    );
    // Two holes with a pocket between them.
    let pocket = pieces(2, &[(place(0, 1, 1), [4., 1.]), (place(0, 1, 3), [4., 5.])]);
    flaws(
        polygons(&[&[
            square(0., 0., 9.),
            ring("1,1 4,1 3,3 4,5 1,5"),
            ring("4,1 7,3 4,5 5,3"),
        ]]),
        &[pocket],
    );
    let message = polygons(&[&[square(0., 0., 4.), ring("0,2 2,1 4,2 2,3")]])
        .unwrap_err()
        .to_string();
    assert_eq!(
        message,
        "the inside of part 0 is in 2 pieces, which touch at part 0, ring 1, edge 0 (0, 2); part 0, ring 1, edge 2 (4, 2)"
    );
}

#[test]
fn ranges_of_coordinates() {
    let small = Flaw::CoordinateRange {
        at: place(0, 0, 2),
        point: [8e300, 1e-9],
        largest: 8e300,
    };
    flaws(
        polygons(&[&[ring("0,0 8e300,0 8e300,1e-9 0,8e300")]]),
        &[small],
    );
    for scale in [1e-320, 1e-310, 1e-300, 1e-100, 1e60, 1e100, 1e300, 2e307] {
        let figure =
            polygons(&[&[square(0., 0., 8. * scale), square(scale, scale, 2. * scale)]]).unwrap();
        let bits = |v: [f64; 2]| v.map(f64::to_bits);
        assert_eq!(
            bits(figure.vertices()[5]),
            bits([scale + 2. * scale, scale])
        );
    }
    // 102 orders of magnitude are fine.
    polygons(&[&[ring("0,0 1e-42,0 1,1 0,1e60")]]).unwrap();
}

#[test]
fn several_flaws_at_once() {
    let result = polygons(&[&[ring("0,0 4,0 4,0 0,4 4,4")], &[ring("NaN,0 1,1 5,2")]]);
    let flaws = result.unwrap_err().flaws;
    let kinds = matches!(
        flaws[..],
        [
            Flaw::ZeroLengthEdge { .. },
            Flaw::NotFinite { .. },
            Flaw::EdgesCross { .. }
        ]
    );
    assert!(kinds, "{flaws:?}");
}

#[test]
fn touching_is_legal() {
    // Two polygons, corner to corner and corner to wall.
    polygons(&[&[square(0., 0., 4.)], &[square(4., 4., 4.)]]).unwrap();
    let figure = polygons(&[&[square(0., 0., 4.)], &[ring("4,2 6,0 6,4")]]).unwrap();
    assert_eq!((figure.vertices().len(), figure.edges().len()), (7, 8));
    // A hole that touches its shell once, at a vertex and at a wall.
    polygons(&[&[square(0., 0., 4.), ring("0,0 2,1 1,2")]]).unwrap();
    polygons(&[&[square(0., 0., 4.), ring("0,2 2,1 2,3")]]).unwrap();
    // A chain of holes.
    polygons(&[&[
        square(0., 0., 9.),
        square(1., 1., 2.),
        square(3., 3., 2.),
        square(5., 5., 2.),
    ]])
    .unwrap();
    // A ring that touches itself from the inside: an island of outside.
    polygons(&[&[ring("0,0 8,0 8,8 0,8 0,0 4,2 2,4")]]).unwrap();
    // Lines through walls, where the walls have vertices, and along diagonals.
    let mut builder = FigureBuilder::new();
    builder.polygon(vec![ring("0,0 2,0 4,0 4,4 2,4 0,4")]);
    builder.polyline(ring("2,-3 2,0 2,4 2,9"));
    let figure = builder.build().unwrap();
    assert_eq!(figure.terminals(), 2);
    assert_eq!(figure.edges().iter().filter(|edge| edge.on_ring).count(), 6);
    // A line through vertices that it does not name.
    let mut builder = FigureBuilder::new();
    builder.polygon(vec![ring("0,0 2,0 4,0 4,4 2,4 0,4")]);
    builder.polyline(ring("2,-3 2,9"));
    assert_eq!(builder.build().unwrap().edges().len(), 9);
    // Four lines through one point that is a vertex of one of them only.
    let figure = lines(&["-1,0 0,0 1,0", "0,-1 0,1", "-1,-1 1,1", "-2,2 2,-2"]).unwrap();
    assert_eq!((figure.edges().len(), figure.terminals()), (8, 8));
}

#[test]
fn nesting_is_legal() {
    let nested = |depth: usize| {
        let mut builder = FigureBuilder::new();
        for k in 0..depth {
            let at = 2. * k as f64;
            let side = 4. * (depth - k) as f64;
            builder.polygon(vec![
                square(at, at, side),
                square(at + 1., at + 1., side - 2.),
            ]);
        }
        builder.build()
    };
    let figure = nested(3).unwrap();
    assert!(figure.has_polygon());
    assert_eq!(
        (
            figure.vertices().len(),
            figure.edges().len(),
            figure.terminals()
        ),
        (24, 24, 0)
    );
    nested(2_000).unwrap();
}

#[test]
fn either_orientation_and_closed_or_open() {
    let reversed = |mut ring: Ring| {
        ring.reverse();
        ring
    };
    for shell in [square(0., 0., 9.), reversed(square(0., 0., 9.))] {
        for hole in [
            square(2., 2., 2.),
            reversed(square(2., 2., 2.)),
            ring("2,2 4,2 4,4 2,4 2,2"),
        ] {
            let figure = Polygon::new([shell.clone(), hole]).unwrap();
            assert_eq!(figure.figure().edges().len(), 8);
        }
    }
}

#[test]
fn equal_edges_of_lines_are_one() {
    let figure = lines(&["0,0 1,0 1,1", "1,0 0,0 0,1"]).unwrap();
    assert_eq!((figure.edges().len(), figure.vertices().len()), (3, 4));
    let mut builder = FigureBuilder::new();
    builder.weighted_polyline(ring("0,0 1,0"), vec![[1., 2.]]);
    builder.weighted_polyline(ring("1,0 0,0"), vec![[2., 1.]]);
    assert_eq!(builder.clone().build().unwrap().edges().len(), 1);
    builder.weighted_polyline(ring("1,0 0,0"), vec![[1., 2.]]);
    let overlap = Flaw::EdgesOverlap {
        first: place(0, 0, 0),
        second: place(2, 0, 0),
        from: [0., 0.],
        to: [1., 0.],
    };
    flaws(builder.build(), &[overlap]);
}

#[test]
fn lines_on_one_line() {
    let figure = lines(&["0,0 2,2", "3,3 9,9", "4,4 9,9 10,10"]);
    let overlap = Flaw::EdgesOverlap {
        first: place(1, 0, 0),
        second: place(2, 0, 0),
        from: [4., 4.],
        to: [9., 9.],
    };
    flaws(figure, &[overlap]);
    let figure = lines(&["2,2 0,0", "3,3 9,9", "9,9 10,10 11,11"]).unwrap();
    assert_eq!((figure.edges().len(), figure.terminals()), (4, 4));
    assert!(!figure.has_polygon());
}
