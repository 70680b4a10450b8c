//! Heights of vertices: walls, tilted eaves, and whether the surface passes through them.

#![expect(
    clippy::float_cmp,
    clippy::disallowed_methods,
    reason = "tests compare numbers that must be the same, and the textbook's formula has a root"
)]

use hipline::{
    Figure, FigureBuilder, Options, Region, Skeleton,
    input::{Flaw, Place},
    observe::Index,
    skeleton::{ArcKind, NodeKind, Side},
    topology::{FaceId, VertexId},
};
use hipline_testkit::{
    generate::Random,
    measure::{area, winding},
};

const fn at(ring: usize, index: usize) -> Place {
    Place {
        part: 0,
        ring,
        index,
    }
}

fn polygon(points: &[[f64; 2]], heights: &[f64]) -> FigureBuilder {
    let mut builder = FigureBuilder::new();
    builder.polygon(vec![points.to_vec()]);
    for (index, &height) in heights.iter().enumerate() {
        builder.elevate(at(0, index), height);
    }
    builder
}

fn line(points: &[[f64; 2]], heights: &[f64]) -> FigureBuilder {
    let mut builder = FigureBuilder::new();
    builder.polyline(points.to_vec());
    for (index, &height) in heights.iter().enumerate() {
        builder.elevate(at(0, index), height);
    }
    builder
}

fn skeleton(figure: &Figure) -> Skeleton {
    let skeleton = figure.skeleton(Options::default());
    assert_eq!(skeleton.verify(figure), Ok(()), "{:?}", figure.vertices());
    skeleton
}

const HOUSE: [[f64; 2]; 4] = [[0.0, 0.0], [8.0, 0.0], [8.0, 6.0], [0.0, 6.0]];

fn events(skeleton: &Skeleton) -> Vec<[f64; 3]> {
    let nodes = skeleton.nodes().iter();
    let mut list: Vec<[f64; 3]> = nodes
        .filter(|node| node.kind == NodeKind::Event)
        .map(|node| [node.x, node.y, node.time])
        .collect();
    list.sort_by(|a, b| a.partial_cmp(b).expect("numbers"));
    list
}

#[test]
fn a_figure_at_one_height_has_the_same_roof_on_walls() {
    let low = skeleton(&polygon(&HOUSE, &[]).build().unwrap());
    let figure = polygon(&HOUSE, &[2.5; 4]).build().unwrap();
    let high = skeleton(&figure);
    assert_eq!(high.check_heights(&figure), Ok(()));
    let mut expected: Vec<[f64; 3]> = events(&low)
        .into_iter()
        .map(|[x, y, t]| [x, y, t + 2.5])
        .chain(HOUSE.map(|[x, y]| [x, y, 2.5]))
        .collect();
    expected.sort_by(|a, b| a.partial_cmp(b).unwrap());
    assert_eq!(events(&high), expected);
}

#[test]
fn a_tilted_eave_runs_up_between_its_ends() {
    let figure = polygon(&HOUSE, &[0.0, 0.0, 1.0, 1.0]).build().unwrap();
    let skeleton = skeleton(&figure);
    assert_eq!(skeleton.check_heights(&figure), Ok(()));
    // The facets over the tilted eaves of length 6, which rise by 1, run in by
    // sqrt(36 - 1) / 6 of what those over level eaves do, and end in one ridge.
    let inset = 35.0_f64.sqrt() / 2.0;
    let ridge: Vec<[f64; 3]> = events(&skeleton)
        .into_iter()
        .filter(|[_, _, t]| *t > 1.0)
        .collect();
    assert_eq!(ridge.len(), 2);
    for (found, x) in ridge.iter().zip([inset, 8.0 - inset]) {
        let [fx, fy, t] = *found;
        assert!((fx - x).abs() < 1e-14, "{fx} {x}");
        assert_eq!([fy, t], [3.5, 3.5]);
    }
    let rising = skeleton.arcs().iter().filter(|arc| {
        let [from, to] = arc.nodes.map(|n| skeleton.node(n).time);
        arc.kind == ArcKind::Crease && from < to
    });
    assert_eq!(rising.count(), 2);
}

#[test]
fn a_straight_river_falls_to_the_sea() {
    // The vertex in the middle is straight, and its eaves have two slopes.
    let points = [[0.0, 0.0], [4.0, 0.0], [12.0, 0.0]];
    let figure = line(&points, &[0.0, 0.5, 2.5]).build().unwrap();
    let skeleton = figure.skeleton(Options::default());
    assert_eq!(skeleton.verify(&figure), Ok(()));
    assert_eq!(skeleton.check_heights(&figure), Ok(()));
    let places: Vec<[f64; 3]> = events(&skeleton);
    assert!(places.contains(&[4.0, 0.0, 0.5]), "{places:?}");
    assert!(places.contains(&[12.0, 0.0, 2.5]), "{places:?}");
    // One facet a side of each edge, and one a terminal.
    let facets = skeleton.faces().iter().filter(|f| f.phase == 1).count();
    assert_eq!(facets, 5);
}

#[test]
fn flaws_name_vertices_and_edges() {
    let flaws = |builder: FigureBuilder| builder.build().unwrap_err().flaws;
    assert_eq!(
        flaws(polygon(&HOUSE, &[0.0, 0.0, 6.0, 6.0])),
        [
            Flaw::TooSteep {
                edge: at(0, 1),
                heights: [0.0, 6.0],
                speed: 1.0
            },
            Flaw::TooSteep {
                edge: at(0, 3),
                heights: [6.0, 0.0],
                speed: 1.0
            },
        ]
    );
    // One unit in the last place less is not too steep.
    assert!(
        polygon(
            &HOUSE,
            &[0.0, 0.0, 6.0_f64.next_down(), 6.0_f64.next_down()]
        )
        .build()
        .is_ok()
    );
    assert_eq!(
        flaws(polygon(&HOUSE, &[0.0, -1.0])),
        [Flaw::BadHeight {
            at: at(0, 1),
            height: -1.0
        }]
    );
    assert_eq!(
        flaws(polygon(&HOUSE, &[0.0, 0.0, 0.0, 0.0, 1.0])),
        [Flaw::NoSuchVertex { at: at(0, 4) }]
    );
    let mut builder = line(&[[0.0, 0.0], [4.0, 0.0]], &[0.0, 1.0]);
    let part = builder.polyline(vec![[4.0, 0.0], [6.0, 3.0]]);
    let other = Place {
        part,
        ring: 0,
        index: 0,
    };
    builder.elevate(other, 2.0);
    assert_eq!(
        flaws(builder),
        [Flaw::TwoHeights {
            first: at(0, 1),
            second: other,
            heights: [1.0, 2.0]
        }]
    );
}

#[test]
fn an_eave_that_is_covered_is_named() {
    // A river runs beside a lake shore that is higher than it is far.
    let mut builder = line(&[[0.0, 0.0], [4.0, 0.0]], &[]);
    let part = builder.polyline(vec![[1.0, 2.0], [3.0, 2.0]]);
    for index in 0..2 {
        let vertex = Place {
            part,
            ring: 0,
            index,
        };
        builder.elevate(vertex, 3.0);
    }
    let figure = builder.build().unwrap();
    let skeleton = skeleton(&figure);
    let error = skeleton.check_heights(&figure).unwrap_err();
    assert!(!error.edges.is_empty());
    let text = error.to_string();
    assert!(text.contains("part 1, ring 0, edge 0"), "{text}");
}

/// A facet of the textbook: height at a point, for an eave p q with heights, on the left.
fn facet_height(p: [f64; 2], q: [f64; 2], heights: [f64; 2], [x, y]: [f64; 2]) -> f64 {
    let d = [q[0] - p[0], q[1] - p[1]];
    let length = d[0].hypot(d[1]);
    let along = (heights[1] - heights[0]) / length;
    let across = (1.0 - along * along).sqrt();
    let (dx, dy) = (x - p[0], y - p[1]);
    heights[0]
        + along * (dx * d[0] + dy * d[1]) / length
        + across * (dy * d[0] - dx * d[1]) / length
}

/// Checks facets against the textbook's planes, and the sum of their areas.
fn check_facets(figure: &Figure, skeleton: &Skeleton, seed: u64) {
    let mut sum = 0.0;
    for (i, face) in skeleton.faces().iter().enumerate() {
        let edge = &figure.edges()[face.edge.index()];
        let mut ends = [edge.from, edge.to];
        if face.side == Side::Right {
            ends.reverse();
        }
        let [p, q] = ends.map(|v| figure.vertices()[v.index()]);
        let heights = ends.map(|v| figure.height(v));
        let corners: Vec<[f64; 2]> = skeleton
            .boundary(FaceId::new(i))
            .iter()
            .map(|&n| [skeleton.node(n).x, skeleton.node(n).y])
            .collect();
        sum += area(&corners);
        let is_wall = face.phase == 0 && heights != [0.0, 0.0];
        for (&n, &corner) in skeleton.boundary(FaceId::new(i)).iter().zip(&corners) {
            let time = skeleton.node(n).time;
            if !is_wall {
                let expected = facet_height(p, q, heights, corner);
                assert!(
                    (expected - time).abs() < 1e-9,
                    "seed {seed}: {expected} {time}"
                );
            }
        }
    }
    let whole = area(figure.vertices());
    assert!(
        (sum - whole.abs()).abs() < 1e-9 * whole.abs(),
        "seed {seed}: {sum} {whole}"
    );
}

#[test]
fn facets_of_random_polygons_lie_on_their_planes_and_tile() {
    let mut attained = 0;
    for seed in 0..400 {
        let mut random = Random::new(seed);
        let n = 3 + random.below(5);
        let points: Vec<[f64; 2]> = (0..n)
            .map(|_| [0, 1].map(|_| 2.0 * random.below(8) as f64))
            .collect();
        let heights: Vec<f64> = (0..n).map(|_| random.below(4) as f64 * 0.25).collect();
        let Ok(figure) = polygon(&points, &heights).build() else {
            continue;
        };
        let skeleton = skeleton(&figure);
        if skeleton.check_heights(&figure).is_ok() {
            attained += 1;
            check_facets(&figure, &skeleton, seed);
        }
    }
    assert!(attained > 60, "{attained}");
}

#[test]
fn random_lines_with_heights_obey_the_laws() {
    let mut attained = [0, 0];
    for seed in 0..600 {
        let mut random = Random::new(seed ^ 0x5eed);
        let n = 2 + random.below(4);
        let grid = 3 + random.below(6);
        let mut points: Vec<[f64; 2]> = (0..n)
            .map(|_| [0, 1].map(|_| 2.0 * random.below(grid) as f64))
            .collect();
        let heights: Vec<f64> = (0..n).map(|_| random.below(3) as f64 * 0.5).collect();
        if n > 2 && random.below(2) == 0 {
            points.push(points[0]);
        }
        let Ok(figure) = line(&points, &heights).build() else {
            continue;
        };
        let skeleton = figure.skeleton(Options::default().region(Region::Both));
        assert_eq!(
            skeleton.verify(&figure),
            Ok(()),
            "seed {seed}: {points:?} {heights:?}"
        );
        let fits = skeleton.check_heights(&figure).is_ok();
        attained[usize::from(fits)] += 1;
        if fits {
            // Every vertex is on the surface at its height.
            for (v, place) in figure.vertices().iter().enumerate() {
                let height = figure.height(VertexId::new(v));
                let is_it = |n: &&hipline::skeleton::Node| [n.x, n.y] == *place && n.time == height;
                assert!(
                    skeleton.nodes().iter().any(|n| is_it(&n)),
                    "seed {seed}: v{v}"
                );
            }
        }
    }
    assert!(attained[1] > 200 && attained[0] > 5, "{attained:?}");
}

/// The offsets enclose what point location says is not yet reached.
fn check_offsets(figure: &Figure, skeleton: &Skeleton, seed: u64) -> [usize; 2] {
    let distances = [0.25, 0.5, 0.75, 1.0, 1.6, 3.0];
    let offsets = skeleton.offsets(figure, &distances).expect("distances");
    let index = Index::new(skeleton, figure);
    let everywhere = i32::from(skeleton.region() != Region::Interior);
    let mut seen = [0; 2];
    for k in 0..256 {
        let point = [k % 16, k / 16].map(f64::from);
        let point = [point[0] * 1.173 - 1.621, point[1] * 1.1917 - 1.7043];
        let Ok(answer) = index.locate(point) else {
            continue;
        };
        for (offset, d) in offsets.iter().zip(distances) {
            if (answer.time - d).abs() > 1e-9 {
                let around = everywhere
                    + offset
                        .loops()
                        .iter()
                        .map(|l| winding(l.points(), point))
                        .sum::<i32>();
                assert_eq!(
                    around,
                    i32::from(answer.time > d),
                    "seed {seed}: {:?} {:?}: {point:?} is reached at {}, offset {d} {:?}",
                    figure.vertices(),
                    (0..figure.vertices().len())
                        .map(|v| figure.height(VertexId::new(v)))
                        .collect::<Vec<_>>(),
                    answer.time,
                    offset.loops()
                );
                seen[usize::from(answer.time > d)] += 1;
            }
        }
    }
    seen
}

#[test]
fn offsets_know_walls_and_tilted_eaves() {
    let mut seen = [0; 2];
    let mut lines = 0;
    for seed in 0..600 {
        let mut random = Random::new(seed ^ 0x0ff5e7);
        let n = 3 + random.below(5);
        let points: Vec<[f64; 2]> = (0..n)
            .map(|_| [0, 1].map(|_| 2.0 * random.below(8) as f64))
            .collect();
        let heights: Vec<f64> = (0..n).map(|_| random.below(4) as f64 * 0.25).collect();
        let is_line = random.below(2) == 0;
        let builder = if is_line {
            line(&points, &heights)
        } else {
            polygon(&points, &heights)
        };
        let Ok(figure) = builder.build() else {
            continue;
        };
        lines += usize::from(is_line);
        let skeleton = figure.skeleton(Options::default());
        let here = check_offsets(&figure, &skeleton, seed);
        seen[0] += here[0];
        seen[1] += here[1];
    }
    assert!(
        seen[0] > 10_000 && seen[1] > 10_000 && lines > 50,
        "{seen:?} {lines}"
    );
}
