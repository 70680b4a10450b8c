//! Corrupted skeletons: every violation is found when it is there.

use super::{Violation, Violations};
use crate::{
    Figure, FigureBuilder, Options, Region, Skeleton,
    skeleton::{Arc, ArcKind, Node, NodeKind, Side},
    topology::{ArcId, EdgeId, FaceId, NodeId, VertexId},
};
use hipline_testkit::generate::STRAIGHT_VERTICES;

type Ring = Vec<[f64; 2]>;

fn polygon(rings: &[Ring]) -> Figure {
    let mut builder = FigureBuilder::new();
    builder.polygon(rings.to_vec());
    builder.build().expect("a valid polygon")
}

fn lines(lines: &[Ring]) -> Figure {
    let mut builder = FigureBuilder::new();
    for line in lines {
        builder.polyline(line.clone());
    }
    builder.build().expect("valid lines")
}

fn weighted(ring: &Ring, speeds: &[f64]) -> Figure {
    let mut builder = FigureBuilder::new();
    builder.weighted_polygon(vec![ring.clone()], vec![speeds.to_vec()]);
    builder.build().expect("a valid polygon")
}

fn square() -> Ring {
    vec![[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0]]
}

fn rectangle() -> Ring {
    vec![[0.0, 0.0], [8.0, 0.0], [8.0, 4.0], [0.0, 4.0]]
}

/// A straight vertex right below the end of the rectangle's ridge.
fn rectangle_with(x: f64) -> Ring {
    vec![[0.0, 0.0], [x, 0.0], [8.0, 0.0], [8.0, 4.0], [0.0, 4.0]]
}

/// Even numbers from a fixed seed.
struct Dice(u64);

impl Dice {
    fn roll(&mut self) -> f64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 % 1024) as f64 / 1024.0
    }
}

/// A jagged star.
fn star(points: usize, seed: u64) -> Ring {
    let mut dice = Dice(seed);
    (0..points)
        .map(|i| {
            let angle = i as f64 / points as f64 * std::f64::consts::TAU;
            let radius = 40.0 + 60.0 * dice.roll();
            [
                (radius * angle.cos()).round(),
                (radius * angle.sin()).round(),
            ]
        })
        .collect()
}

fn samples() -> Vec<(Figure, Region)> {
    let ring_with_hole = [
        vec![[0.0, 0.0], [9.0, 0.0], [9.0, 9.0], [0.0, 9.0]],
        vec![[3.0, 3.0], [6.0, 3.0], [6.0, 6.0], [3.0, 6.0]],
    ];
    let l_shape = vec![
        [0.0, 0.0],
        [5.0, 0.0],
        [5.0, 5.0],
        [4.0, 5.0],
        [4.0, 4.0],
        [0.0, 4.0],
    ];
    let cross = [
        vec![[-5.0, 0.0], [0.0, 0.0]],
        vec![[0.0, 0.0], [5.0, 0.0]],
        vec![[0.0, -5.0], [0.0, 0.0]],
        vec![[0.0, 0.0], [0.0, 5.0]],
    ];
    let gap = [vec![[0.0, 0.0], [4.0, 0.0]], vec![[6.0, 0.0], [10.0, 0.0]]];
    vec![
        (polygon(&[square()]), Region::Interior),
        (polygon(&[rectangle()]), Region::Both),
        (polygon(&[rectangle_with(2.0)]), Region::Interior),
        (polygon(&[STRAIGHT_VERTICES.to_vec()]), Region::Both),
        (polygon(&ring_with_hole), Region::Interior),
        (polygon(&ring_with_hole), Region::Exterior),
        (polygon(&[l_shape]), Region::Both),
        (polygon(&[star(17, 3)]), Region::Both),
        (lines(&cross), Region::Both),
        (lines(&gap), Region::Both),
        (lines(&[vec![[0.0, 0.0], [4.0, 3.0]]]), Region::Both),
        (
            weighted(&star(9, 5), &[1.0, 2.0, 1.0, 1.0, 3.0, 1.0, 1.0, 0.5, 1.0]),
            Region::Interior,
        ),
    ]
}

fn build(figure: &Figure, region: Region) -> Skeleton {
    let skeleton = figure.skeleton(Options::default().region(region));
    skeleton
        .verify(figure)
        .unwrap_or_else(|found| panic!("before the corruption: {found:#?}"));
    skeleton
}

/// What verification finds after a corruption.
fn after(figure: &Figure, region: Region, corrupt: impl FnOnce(&mut Skeleton)) -> Violations {
    let mut skeleton = build(figure, region);
    corrupt(&mut skeleton);
    skeleton
        .verify(figure)
        .expect_err("the corruption is found")
}

macro_rules! assert_found {
    ($found:expr, $pattern:pat) => {
        let found: Violations = $found;
        assert!(
            found
                .list
                .iter()
                .any(|violation| matches!(violation, $pattern)),
            "no {} in {found:#?}",
            stringify!($pattern)
        );
    };
}

mod places;

/// Every single corruption of one field is found.
#[test]
fn no_field_can_be_changed_unnoticed() {
    let mut count = 0;
    for (number, (figure, region)) in samples().into_iter().enumerate() {
        let good = build(&figure, region);
        let mut check = |what: &str, corrupt: &dyn Fn(&mut Skeleton)| {
            let mut bad = good.clone();
            corrupt(&mut bad);
            if bad != good {
                count += 1;
                assert!(
                    bad.verify(&figure).is_err(),
                    "figure {number} {region:?}: {what} goes unnoticed"
                );
            }
        };
        for i in 0..good.nodes.len() {
            check("x", &|s| s.nodes[i].x = s.nodes[i].x.next_up());
            check("y", &|s| s.nodes[i].y = s.nodes[i].y.next_down());
            check("time up", &|s| s.nodes[i].time = s.nodes[i].time.next_up());
            check("time down", &|s| {
                s.nodes[i].time = s.nodes[i].time.next_down()
            });
            check("no number", &|s| s.nodes[i].x = f64::NAN);
            check("event", &|s| s.nodes[i].kind = NodeKind::Event);
            check("vertex", &|s| {
                s.nodes[i].kind = NodeKind::Input(VertexId::new(i + 1))
            });
            check("infinite", &|s| {
                s.nodes[i].kind = NodeKind::Infinite {
                    direction: [1.0, 0.0],
                }
            });
            check("direction", &|s| {
                if let NodeKind::Infinite { direction } = &mut s.nodes[i].kind {
                    direction[1] = direction[1].next_up();
                }
            });
        }
        for a in 0..good.arcs.len() {
            check("swapped nodes", &|s| s.arcs[a].nodes.swap(0, 1));
            check("swapped faces", &|s| s.arcs[a].faces.swap(0, 1));
            for kind in [ArcKind::Ridge, ArcKind::Valley, ArcKind::Ghost] {
                check("kind", &|s| s.arcs[a].kind = kind);
            }
            for k in 0..2 {
                check("other node", &|s| {
                    s.arcs[a].nodes[k] =
                        NodeId::new((s.arcs[a].nodes[k].index() + 1) % s.nodes.len());
                });
                check("other face", &|s| {
                    s.arcs[a].faces[k] =
                        FaceId::new((s.arcs[a].faces[k].index() + 1) % s.faces.len());
                });
            }
            check("missing arc", &|s| {
                s.arcs.swap_remove(a);
            });
        }
        for c in 0..good.corners.len() {
            check("swapped corners", &|s| {
                s.corners.swap(c, (c + 1) % good.corners.len())
            });
            check("other corner", &|s| {
                s.corners[c] = NodeId::new((s.corners[c].index() + 1) % s.nodes.len())
            });
            check("missing corner", &|s| drop_corner(s, c));
        }
        for f in 0..good.faces.len() {
            check("edge", &|s| {
                s.faces[f].edge = EdgeId::new((s.faces[f].edge.index() + 1) % s.input.edges.len())
            });
            for side in [Side::Left, Side::Right, Side::Start, Side::End] {
                check("side", &|s| s.faces[f].side = side);
            }
            check("face order", &|s| {
                s.faces.swap(f, (f + 1) % good.faces.len())
            });
            check("cycle", &|s| s.cycles[f + 1] += 1);
        }
    }
    assert!(count > 5000, "only {count} corruptions");
}

/// Removes a corner from its boundary, and keeps the lists in order.
fn drop_corner(s: &mut Skeleton, c: usize) {
    s.corners.remove(c);
    for end in &mut s.cycles {
        if *end as usize > c {
            *end -= 1;
        }
    }
}

#[test]
fn errors_of_structure_are_named() {
    let figure = polygon(&[rectangle_with(2.0)]);
    let found = |corrupt: fn(&mut Skeleton)| after(&figure, Region::Interior, corrupt);
    assert_found!(found(|s| s.input.edges.swap(0, 1)), Violation::OtherFigure);
    assert_found!(found(|s| s.input.terminals = 1), Violation::OtherFigure);
    assert_found!(
        found(|s| s.region = Region::Auto),
        Violation::IndefiniteRegion
    );
    assert_found!(
        found(|s| s.region = Region::Both),
        Violation::MissingFace { .. }
    );
    assert_found!(
        found(|s| s.region = Region::Exterior),
        Violation::ExtraFace { .. }
    );
    assert_found!(found(|s| s.cycles[1] = 0), Violation::BrokenLists { .. });
    assert_found!(
        found(|s| s.faces[1].cycles = [0, 2]),
        Violation::BrokenLists { .. }
    );
    assert_found!(
        found(|s| s.corners[1] = NodeId::new(99)),
        Violation::NoSuchCorner { .. }
    );
    assert_found!(
        found(|s| s.arcs[0].nodes[1] = NodeId::new(99)),
        Violation::NoSuchEnd { .. }
    );
    assert_found!(
        found(|s| s.arcs[0].faces[1] = FaceId::new(99)),
        Violation::NoSuchEnd { .. }
    );
    assert_found!(
        found(|s| s.nodes[0].kind = NodeKind::Event),
        Violation::WrongVertex { .. }
    );
    assert_found!(
        found(|s| s.faces[1].side = Side::Right),
        Violation::MissingFace { .. }
    );
    assert_found!(
        found(|s| s.corners[..3].rotate_left(1)),
        Violation::NoBase { .. }
    );
    assert_found!(found(|s| drop_corner(s, 2)), Violation::NoArc { .. });
    assert_found!(
        found(|s| s.arcs[0].faces.swap(0, 1)),
        Violation::WrongSide { .. }
    );
    assert_found!(found(|s| drop_corner(s, 2)), Violation::NotOnce { .. });
    assert_found!(
        found(|s| s.arcs[0].faces[0] = s.arcs[0].faces[1]),
        Violation::OneFace { .. }
    );
    assert_found!(
        found(|s| s.arcs.push(s.arcs[0])),
        Violation::DoubleArc { .. }
    );
    assert_found!(
        found(|s| s.arcs[0].nodes.swap(0, 1)),
        Violation::WrongWay { .. }
    );
    let unused = Node {
        x: 1.0,
        y: 1.0,
        time: 1.0,
        kind: NodeKind::Event,
    };
    let mut bad = build(&figure, Region::Interior);
    bad.nodes.push(unused);
    assert_found!(
        bad.verify(&figure).expect_err("unused"),
        Violation::Degree { degree: 0, .. }
    );
    let other = polygon(&[square()]);
    assert_found!(
        bad.verify(&other).expect_err("another figure"),
        Violation::OtherFigure
    );
}

#[test]
fn the_terminal_must_start_its_face() {
    let figure = lines(&[vec![[0.0, 0.0], [4.0, 0.0]]]);
    let found = after(&figure, Region::Both, |s| {
        let cap = s
            .faces
            .iter()
            .position(|face| face.side == Side::Start)
            .expect("a terminal");
        let [from, to] =
            [s.faces[cap].cycles[0], s.faces[cap].cycles[1]].map(|k| s.cycles[k as usize] as usize);
        s.corners[from..to].rotate_left(1);
    });
    assert_found!(found, Violation::NoBase { .. });
}

#[test]
fn the_order_of_faces_counts() {
    let figure = polygon(&[square()]);
    let found = after(&figure, Region::Interior, |s| {
        let [e, f] = [s.faces[1].edge, s.faces[2].edge];
        (s.faces[1].edge, s.faces[2].edge) = (f, e);
    });
    assert_found!(found, Violation::MissingFace { .. });
}

/// Makes one node of two that have no arc in common, and nothing else.
fn identify(s: &mut Skeleton, kept: usize, gone: usize) {
    let [kept, gone] = [kept, gone].map(NodeId::new);
    let name = |n: &mut NodeId| {
        if *n == gone {
            *n = kept;
        }
        if n.index() > gone.index() {
            *n = NodeId::new(n.index() - 1);
        }
    };
    s.arcs
        .iter_mut()
        .flat_map(|arc| &mut arc.nodes)
        .for_each(name);
    s.corners.iter_mut().for_each(name);
    s.nodes.remove(gone.index());
}

/// Moves the skeleton to a figure of the same graph: as wrong as can be, but in order.
fn transplant(skeleton: &Skeleton, figure: &Figure) -> Violations {
    let mut moved = skeleton.clone();
    for (node, &[x, y]) in moved.nodes.iter_mut().zip(figure.vertices()) {
        (node.x, node.y) = (x, y);
    }
    moved.verify(figure).expect_err("another skeleton")
}

#[test]
fn a_ghost_arc_must_be_perpendicular() {
    let skeleton = build(&polygon(&[rectangle_with(2.0)]), Region::Interior);
    assert_found!(
        transplant(&skeleton, &polygon(&[rectangle_with(3.0)])),
        Violation::Slanted { .. }
    );
}

#[test]
fn the_skeleton_of_another_figure_is_refused() {
    let closed = |mut ring: Ring| {
        ring.push(ring[0]);
        lines(&[ring])
    };
    // Mirrored, the inside becomes the outside: events lie before the start.
    let skeleton = build(&closed(star(9, 3)), Region::Both);
    let mirrored = closed(star(9, 3).into_iter().map(|[x, y]| [-x, y]).collect());
    let found = transplant(&skeleton, &mirrored);
    assert_found!(found.clone(), Violation::TooEarly { .. });
    assert_found!(found, Violation::UnorderedAtInfinity);
    // Other stars with the same graph: every law of shape is broken somewhere.
    let mut found = Vec::new();
    for seed in 1..60 {
        found.extend(transplant(&skeleton, &closed(star(9, seed + 10))).list);
    }
    let found = Violations {
        total: found.len(),
        list: found,
    };
    assert_found!(found.clone(), Violation::NotLater { .. });
    assert_found!(found.clone(), Violation::NotMonotone { .. });
    assert_found!(found.clone(), Violation::MeetsItself { .. });
    assert_found!(found.clone(), Violation::Unordered { .. });
    assert_found!(found, Violation::WrongProgress { .. });
}

#[test]
fn a_weighted_face_must_not_be_clockwise() {
    let speeds = [1.0, 2.0, 1.0, 1.0, 3.0, 1.0, 1.0, 0.5, 1.0];
    let skeleton = build(&weighted(&star(9, 5), &speeds), Region::Interior);
    let mut found = Vec::new();
    for seed in 1..20 {
        found.extend(transplant(&skeleton, &weighted(&star(9, seed + 10), &speeds)).list);
    }
    assert_found!(
        Violations {
            total: found.len(),
            list: found
        },
        Violation::Clockwise { .. }
    );
}

#[test]
fn the_list_is_capped_but_all_are_counted() {
    let ring: Ring = (0..1500)
        .map(|i| [f64::from(i), if i % 2 == 0 { 0.0 } else { 0.5 }])
        .collect();
    let figure = lines(&[ring]);
    let found = after(&figure, Region::Both, |s| {
        for node in &mut s.nodes {
            node.y += 1.0;
        }
    });
    assert_eq!(found.list.len(), Violations::CAP, "the list is capped");
    assert!(found.total > Violations::CAP, "{} in all", found.total);
    assert!(
        found.to_string().contains(&found.total.to_string()),
        "{found}"
    );
    let first = Violation::WrongKind { arc: ArcId::new(7) };
    assert_eq!(
        first.to_string(),
        "a7 is of the wrong kind",
        "violations name what they are about"
    );
}
