//! Modified skeletons (Aichholzer & Aurenhammer 1996, section 5): by hand, by their laws, by the
//! rectangles that the edges send out, and under maps.

mod common;

use std::sync::atomic::{AtomicUsize, Ordering};

use common::count;
use hipline::engine::NotApplicable;
use hipline::input::Place;
use hipline::observe::{Index, Terrain, Window};
use hipline::skeleton::{ArcKind, NodeKind, Side};
use hipline::topology::{EdgeId, FaceId, NodeId};
use hipline::{Engine, Figure, Options, Region, Skeleton};
use hipline_testkit::Case;
use hipline_testkit::agreement::drawn;
use hipline_testkit::case::Part;
use hipline_testkit::generate::{Family, Kind, Random, small_of};
use hipline_testkit::hunt::check_all;
use hipline_testkit::metamorphic::Map;

/// One more than rounding adds to a quotient near one.
const ROUNDED: f64 = 1.0 + 1e-12;

fn figure(case: &Case) -> Figure {
    case.figure()
        .unwrap_or_else(|flaws| panic!("{}{flaws}", case.to_text()))
}

fn of(figure: &Figure, region: Region) -> Skeleton {
    let options = Options::default().region(region).modified(true);
    let skeleton = figure.skeleton_by(Engine::Kinetic, options);
    skeleton.expect("no weights")
}

/// The modified skeleton of a text, verified.
fn run(text: &str) -> (Figure, Skeleton) {
    let case = Case::parse(text).unwrap_or_else(|error| panic!("{text}: {error}"));
    let figure = figure(&case);
    let skeleton = of(&figure, case.region);
    assert_eq!(skeleton.verify(&figure), Ok(()), "{text}");
    (figure, skeleton)
}

/// The faces beyond ends of edges, as edge and side.
fn caps(skeleton: &Skeleton) -> Vec<(usize, Side)> {
    let faces = skeleton.faces().iter();
    let ends = faces.filter(|face| matches!(face.side, Side::Start | Side::End));
    ends.map(|face| (face.edge.index(), face.side)).collect()
}

/// How many arcs of each kind start at a vertex: ridges, valleys.
fn at(skeleton: &Skeleton, vertex: usize) -> [usize; 2] {
    [ArcKind::Ridge, ArcKind::Valley].map(|kind| {
        let arcs = skeleton.arcs().iter();
        arcs.filter(|arc| arc.kind == kind && arc.nodes[0].index() == vertex)
            .count()
    })
}

#[test]
fn an_acute_angle_turns_three_times() {
    let (figure, skeleton) = run("line 10 0, 0 0, 8 6");
    assert!(skeleton.is_modified());
    let all = [
        (0, Side::Start),
        (0, Side::End),
        (1, Side::Start),
        (1, Side::End),
    ];
    assert_eq!(caps(&skeleton), all);
    assert_eq!(at(&skeleton, 1), [2, 2], "one ridge inside of the angle");
    let offset = skeleton.offset(&figure, 1.0).expect("a distance");
    let [ring] = offset.loops() else {
        panic!("{:?}", offset.loops())
    };
    // The corners of the rectangle of one edge, where the caps meet, and of the other's.
    for corner in [
        [-1.0, -1.0],
        [-1.0, -1.0 / 3.0],
        [-1.4, 0.2],
        [11.0, -1.0],
        [11.0, 1.0],
        [3.0, 1.0],
        [9.4, 5.8],
    ] {
        let near = |p: &[f64; 2]| (0..2).all(|k| (p[k] - corner[k]).abs() < 1e-14);
        assert!(ring.points().iter().any(near), "{corner:?} {ring:?}");
    }
    let plain = figure.skeleton(Options::default());
    assert!(!plain.is_modified());
    assert_eq!(plain.faces().len() + 2, skeleton.faces().len());
}

/// Like Figure 9 of the paper: the interior angles above 270 degrees.
#[test]
fn wide_interior_angles_get_two_faces_more() {
    let text = "polygon\nring 0 0, 20 0, 20 20, 12 20, 10 8, 8 20, 0 20";
    let (figure, skeleton) = run(text);
    assert_eq!(caps(&skeleton), [(3, Side::End), (4, Side::Start)]);
    assert_eq!(at(&skeleton, 4), [1, 2]);
    // The caps are perpendicular to the spike's sides, and symmetric as these.
    let offset = skeleton.offset(&figure, 1.0).expect("a distance");
    let lowest = 8.0 - f64::hypot(1.0, 1.0 / 6.0);
    let on_axis = |p: &[f64; 2]| (p[0] - 10.0).abs() < 1e-14 && (p[1] - lowest).abs() < 1e-13;
    let mut points = offset.loops().iter().flat_map(|ring| ring.points());
    assert!(points.any(on_axis), "{offset:?}");
    // The other side of the polygon has them at its own sharp corners, of which there is none.
    let outside = of(&figure, Region::Exterior);
    assert!(!outside.is_modified());
    let sharp = "region exterior\npolygon\nring 0 0, 20 0, 10 1";
    let (_, skeleton) = run(sharp);
    let around = [
        (0, Side::Start),
        (0, Side::End),
        (1, Side::Start),
        (2, Side::End),
    ];
    assert_eq!(caps(&skeleton), around);
}

#[test]
fn neighbours_decide_where_many_edges_meet() {
    // All within 80 degrees: caps of the outermost two.
    let star =
        "graph\nvertices 0 0, 90 0, 80 20, 60 50, 30 80, 10 90\nedges 0 1, 2 0, 0 3, 0 4, 5 0";
    let (_, skeleton) = run(star);
    let at_middle: Vec<_> = caps(&skeleton)
        .into_iter()
        .filter(|cap| [(0, Side::Start), (4, Side::End)].contains(cap))
        .collect();
    assert_eq!(at_middle.len(), 2, "{:?}", caps(&skeleton));
    assert_eq!(caps(&skeleton).len(), 5 + 2);
    assert_eq!(at(&skeleton, 0), [4 + 1, 2]);
    // A road that joins a straight one at 80 degrees, and a star all around: none.
    for text in [
        "graph\nvertices -50 0, 0 0, 50 0, 17 98\nedges 0 1, 1 2, 1 3",
        "graph\nvertices 0 0, 9 1, 2 8, -7 5, -6 -6, 4 -9\nedges 0 1, 2 0, 0 3, 0 4, 5 0",
    ] {
        let (figure, skeleton) = run(text);
        assert_eq!(
            drawn(&skeleton),
            drawn(&figure.skeleton(Options::default()))
        );
    }
}

/// The limit is at 90 degrees exactly, whatever the position.
#[test]
fn a_right_angle_is_not_acute() {
    for [x, y] in [[3.0_f64, 1.0_f64], [1.0, 1e9], [0.1, 0.7]] {
        for (ordinate, modified) in [(y, false), (y.next_down(), true), (y.next_up(), false)] {
            let points = vec![[x, y], [0.0, 0.0], [-ordinate, x]];
            let figure = figure(&Case::of(vec![Part::line(points)]));
            let skeleton = of(&figure, Region::Both);
            assert_eq!(skeleton.is_modified(), modified, "{x} {y} {ordinate}");
            assert_eq!(skeleton.verify(&figure), Ok(()));
        }
    }
}

#[test]
fn without_acute_angles_nothing_differs() {
    for kind in [Kind::Polyomino, Kind::Windows] {
        for seed in 0..count(400, 40) {
            let case = small_of(kind, seed);
            let figure = figure(&case);
            let plain = figure.skeleton(Options::default().region(Region::Both));
            let modified = of(&figure, Region::Both);
            assert_eq!(drawn(&plain), drawn(&modified), "{}", case.to_text());
            assert_eq!(plain.nodes().len(), modified.nodes().len());
            assert!(!modified.is_modified());
        }
    }
}

#[test]
fn speeds_and_heights_are_refused() {
    let modified = Options::default().modified(true);
    for (text, reason) in [
        (
            "line 9 0, 0 0, 8 6\nspeeds 1 1, 1 2",
            "the speed of edge 1 does not allow for it",
        ),
        (
            "line 9 0, 0 0, 8 6\nchanges 1 both 2.5 0",
            "the speed of edge 1 does not allow for it",
        ),
    ] {
        let figure = figure(&Case::parse(text).expect("a case"));
        let refused = figure.skeleton_by(Engine::Auto, modified);
        assert_eq!(refused.map_err(|e| e.to_string()), Err(reason.to_owned()));
        let plain = figure.skeleton(Options::default());
        assert_eq!(drawn(&figure.skeleton(modified)), drawn(&plain));
    }
    let mut builder = Case::parse("line 9 0, 0 0, 8 6")
        .expect("a case")
        .to_builder();
    let place = Place {
        part: 0,
        ring: 0,
        index: 1,
    };
    builder.elevate(place, 2.0);
    let figure = builder.build().expect("a figure");
    let refused = figure.skeleton_by(Engine::Auto, modified);
    assert_eq!(refused.err(), Some(NotApplicable::Heights));
}

/// Some case of every kind, without weights.
fn some(seed: u64) -> Case {
    small_of(Kind::ALL[seed as usize % Kind::ALL.len()], seed)
}

/// Every valley starts at a vertex, and is no faster than the square root of two; and each point of a
/// face is in the rectangle that its edge has sent out until then.
fn bounds(figure: &Figure, skeleton: &Skeleton) -> Vec<String> {
    let mut wrong = Vec::new();
    for (i, arc) in skeleton.arcs().iter().enumerate() {
        if arc.kind != ArcKind::Valley {
            continue;
        }
        let [from, to] = arc.nodes.map(|node| *skeleton.node(node));
        if !matches!(from.kind, NodeKind::Input(_)) {
            // Cut where a ghost arc ends.
            let below = |a: &&hipline::skeleton::Arc| a.nodes[1] == arc.nodes[0];
            let kind = |a: &hipline::skeleton::Arc| a.kind == ArcKind::Valley;
            if !skeleton.arcs().iter().filter(below).any(kind) {
                wrong.push(format!("valley {i} starts at {from:?}"));
            }
        }
        let speed = match to.kind {
            NodeKind::Infinite { direction: [x, y] } => f64::hypot(x, y),
            _ if to.time - from.time < 1e-3 => continue,
            _ => f64::hypot(to.x - from.x, to.y - from.y) / (to.time - from.time),
        };
        if speed > std::f64::consts::SQRT_2 + 1e-9 {
            wrong.push(format!("valley {i} has a speed of {speed}"));
        }
    }
    for (i, face) in skeleton.faces().iter().enumerate() {
        let id = FaceId::new(i);
        let outer = std::iter::once(skeleton.boundary(id));
        for &node in outer.chain(skeleton.holes(id)).flatten() {
            if skeleton.node(node).time.is_finite()
                && let Some(how) = outside(figure, skeleton, face.edge, face.side, node)
            {
                wrong.push(format!("{id} {:?} of {}: {how}", face.side, face.edge));
            }
        }
    }
    wrong
}

/// How a node is not where the rectangle of an edge has that side of it.
fn outside(
    figure: &Figure,
    skeleton: &Skeleton,
    edge: EdgeId,
    side: Side,
    node: NodeId,
) -> Option<String> {
    let node = skeleton.node(node);
    let [along, off, length] = local(figure, edge, [node.x, node.y]);
    let t = node.time;
    let slack = 1e-9 * (1.0 + t + length);
    let (ahead, beside) = match side {
        Side::Left => (off, (-along).max(along - length)),
        Side::Right => (-off, (-along).max(along - length)),
        Side::Start => (-along, off.abs()),
        Side::End => (along - length, off.abs()),
    };
    let fits = (ahead - t).abs() <= slack && beside <= t + slack;
    (!fits).then(|| format!("{node:?}: {ahead} ahead, {beside} beside"))
}

/// A place relative to an edge: how far along it, how far to the left; and its length.
fn local(figure: &Figure, edge: EdgeId, [x, y]: [f64; 2]) -> [f64; 3] {
    let edge = &figure.edges()[edge.index()];
    let [p, q] = [edge.from, edge.to].map(|v| figure.vertices()[v.index()]);
    let length = f64::hypot(q[0] - p[0], q[1] - p[1]);
    let [ux, uy] = [(q[0] - p[0]) / length, (q[1] - p[1]) / length];
    let [dx, dy] = [x - p[0], y - p[1]];
    [ux * dx + uy * dy, ux * dy - uy * dx, length]
}

/// The time when the first rectangle of an edge reaches a point.
fn reached(figure: &Figure, point: [f64; 2]) -> f64 {
    let time = |e: usize| {
        let [along, off, length] = local(figure, EdgeId::new(e), point);
        off.abs().max(-along).max(along - length)
    };
    (0..figure.edges().len())
        .map(time)
        .fold(f64::INFINITY, f64::min)
}

#[test]
fn small_cases_obey_the_laws() {
    check_all((0..count(14_000, 280)).map(some), |case| {
        let figure = figure(case);
        let mut wrong = Vec::new();
        for region in [case.region, Region::Both] {
            let skeleton = of(&figure, region);
            if let Err(violations) = skeleton.verify(&figure) {
                wrong.push(format!("{region:?}: {violations}"));
            }
            wrong.extend(bounds(&figure, &skeleton));
        }
        wrong
    });
}

#[test]
fn families_obey_the_laws() {
    let n = count(2000, 200) as usize;
    let cases: Vec<Case> = Family::all()
        .into_iter()
        .map(|family| family.generate(n, 11))
        .filter(|case| !case.is_weighted())
        .collect();
    let mut modified = 0;
    for case in &cases {
        let figure = figure(case);
        let skeleton = of(&figure, Region::Both);
        assert_eq!(skeleton.verify(&figure), Ok(()), "{:?}", case.comments);
        let wrong = bounds(&figure, &skeleton);
        assert_eq!(wrong, Vec::<String>::new(), "{:?}", case.comments);
        modified += usize::from(skeleton.is_modified());
    }
    assert!(modified > 2, "{modified} of {}", cases.len());
}

/// The edges of a figure, drawn back from vertices where all edges are within less than 90 degrees:
/// what the modified skeleton is the limit of.
fn drawn_back(figure: &Figure, by: f64) -> Case {
    let place = |v: usize| figure.vertices()[v];
    let ends = |e: usize| {
        let edge = figure.edges()[e];
        [edge.from.index(), edge.to.index()]
    };
    let toward = |v: usize, w: usize| {
        let [p, q] = [v, w].map(place);
        let length = f64::hypot(q[0] - p[0], q[1] - p[1]);
        [0, 1].map(|k| (q[k] - p[k]) / length)
    };
    let mut around = vec![Vec::new(); figure.vertices().len()];
    for [v, w] in (0..figure.edges().len()).map(ends) {
        around[v].push(toward(v, w));
        around[w].push(toward(w, v));
    }
    let is_acute = |list: &Vec<[f64; 2]>| {
        let dot = |p: &[f64; 2], q: &[f64; 2]| p[0] * q[0] + p[1] * q[1];
        list.len() > 1 && list.iter().all(|p| list.iter().all(|q| dot(p, q) > 0.0))
    };
    let mut vertices = figure.vertices().to_vec();
    let mut edges: Vec<[usize; 2]> = (0..figure.edges().len()).map(ends).collect();
    let mut kept = vec![true; vertices.len()];
    for edge in &mut edges {
        for k in 0..2 {
            let [v, w] = [edge[k], edge[1 - k]];
            if v < around.len() && is_acute(&around[v]) {
                let other = if w < around.len() {
                    place(w)
                } else {
                    vertices[w]
                };
                let [p, q] = [place(v), other];
                let part = by / f64::hypot(q[0] - p[0], q[1] - p[1]);
                vertices.push([0, 1].map(|k| p[k] + part * (q[k] - p[k])));
                kept[v] = false;
                edge[k] = vertices.len() - 1;
            }
        }
    }
    kept.resize(vertices.len(), true);
    let mut number = vec![0; vertices.len()];
    for v in 1..vertices.len() {
        number[v] = number[v - 1] + usize::from(kept[v - 1]);
    }
    let edges = edges.into_iter().map(|edge| edge.map(|v| number[v]));
    let vertices = vertices.into_iter().zip(kept).filter(|(_, kept)| *kept);
    Case::of(vec![Part::Graph {
        vertices: vertices.map(|(v, _)| v).collect(),
        edges: edges.collect(),
        speeds: Vec::new(),
    }])
}

/// A case without its degeneracies: every vertex moved a little.
fn shaken(case: &Case) -> Option<Figure> {
    let before = figure(case);
    let mut random = Random::new(31);
    let mut shake = || f64::from(random.range(0, 1_000_000) as u32) * 1e-7;
    let vertices = before.vertices().iter();
    let vertices = vertices.map(|v| v.map(|x| x + shake())).collect();
    let edges = before.edges().iter();
    let edges = edges.map(|edge| [edge.from.index(), edge.to.index()]);
    let case = Case::of(vec![Part::Graph {
        vertices,
        edges: edges.collect(),
        speeds: Vec::new(),
    }]);
    let after = case.figure().ok()?;
    (after.edges().len() == before.edges().len()).then_some(after)
}

/// The definition: at acute angles every edge is a figure of its own. Edges that are drawn back from each
/// other so little that nobody would see it have a skeleton, by the unmodified rules, that nobody
/// could tell from the modified one.
#[test]
fn every_edge_is_a_figure_of_its_own() {
    static COMPARED: AtomicUsize = AtomicUsize::new(0);
    let cases = count(2800, 140);
    check_all((0..cases).map(some), |case| {
        let Some(figure) = shaken(case) else {
            return Vec::new();
        };
        let Ok(apart) = drawn_back(&figure, 1e-8).figure() else {
            return Vec::new();
        };
        let skeleton = of(&figure, Region::Both);
        if !skeleton.is_modified() {
            return Vec::new();
        }
        COMPARED.fetch_add(1, Ordering::Relaxed);
        let limit = apart.skeleton(Options::default());
        let indices = [Index::new(&skeleton, &figure), Index::new(&limit, &apart)];
        let mut wrong = Vec::new();
        let mut random = Random::new(5);
        for _ in 0..200 {
            // Around a vertex, where it differs.
            let v = *random.pick(figure.vertices());
            let p = v.map(|x| x + f64::from(random.range(0, 40_000) as u32) * 1e-4 - 2.0);
            let [found, expected] = indices.each_ref().map(|index| {
                let answer = index.locate(p).expect("the whole plane");
                answer.time
            });
            if (found - expected).abs() > 1e-4 {
                wrong.push(format!("{p:?} is reached at {found}, not at {expected}"));
            }
        }
        wrong.truncate(1);
        wrong
    });
    let compared = COMPARED.load(Ordering::Relaxed) as u64;
    assert!(compared > cases / 3, "{compared} of {cases}");
}

#[test]
fn results_map_along() {
    check_all((0..count(2800, 140)).map(some), |case| {
        let draw = |case: &Case| drawn(&of(&figure(case), Region::Both));
        let before = draw(case);
        let maps = Map::some().into_iter();
        // Translations of small integers by integers are exact.
        maps.filter_map(|map| map.check(&before, &draw(&map.apply(case))).err())
            .collect()
    });
}

/// What reads skeletons reads these: terrains, queries, roofs.
#[test]
fn modified_skeletons_are_read() {
    check_all((0..count(1400, 70)).map(some), |case| {
        let figure = figure(case);
        let skeleton = of(&figure, Region::Both);
        let window = Window::around(figure.vertices().iter().copied(), 3.0).expect("points");
        let terrain = Terrain::new(&skeleton, &figure, window).expect("not too much");
        let mut wrong = Vec::new();
        if (terrain.area() / window.area() - 1.0).abs() > 1e-9 {
            wrong.push(format!("a terrain of {} in {window:?}", terrain.area()));
        }
        let index = Index::new(&skeleton, &figure);
        let mut random = Random::new(9);
        for _ in 0..40 {
            let mut near = || f64::from(random.range(0, 24_000) as u32) / 1000.0 - 6.0;
            let p = [near(), near()];
            let answer = index.locate(p).expect("the whole plane");
            if answer.time * ROUNDED + 1e-12 < reached(&figure, p) {
                wrong.push(format!("{p:?} is reached at {}", answer.time));
            }
        }
        let inside = of(&figure, Region::Interior);
        if let Ok(roof) = inside.roof(1.0) {
            let times = inside.nodes().iter().map(|node| node.time);
            let top = times.fold(0.0, f64::max);
            let ridge = roof.vertices().iter().map(|v| v[2]).fold(0.0, f64::max);
            if (top - ridge).abs() > 1e-9 {
                wrong.push(format!("a roof that is {ridge} high, not {top}"));
            }
        }
        wrong
    });
}

/// A skeleton from its parts, with another side for some faces.
fn renamed(skeleton: &Skeleton, side: impl Fn(usize, Side) -> Side) -> Skeleton {
    let faces = skeleton.faces().iter().enumerate().map(|(i, face)| {
        let id = FaceId::new(i);
        let outer = std::iter::once(skeleton.boundary(id));
        let cycles = outer.chain(skeleton.holes(id)).map(<[_]>::to_vec);
        let side = side(face.edge.index(), face.side);
        (face.edge, side, face.phase, cycles.collect())
    });
    let faces = faces.collect();
    let (nodes, arcs) = (skeleton.nodes().to_vec(), skeleton.arcs().to_vec());
    let input = skeleton.input().clone();
    Skeleton::from_parts(nodes, arcs, faces, input, skeleton.region()).expect("sound parts")
}

#[test]
fn modified_skeletons_come_back_from_their_parts() {
    let (figure, skeleton) = run("line 10 0, 0 0, 8 6");
    let same = renamed(&skeleton, |_, side| side);
    assert!(same.is_modified());
    assert_eq!(same.verify(&figure), Ok(()));
    assert_eq!(
        same.offset(&figure, 1.5),
        skeleton.offset(&figure, 1.5),
        "offsets"
    );
    let swap = |edge: usize, side: Side| match (edge, side) {
        (0, Side::Start) => Side::End,
        (0, Side::End) => Side::Start,
        _ => side,
    };
    assert!(renamed(&skeleton, swap).verify(&figure).is_err());
    let lost = |edge: usize, side: Side| match (edge, side) {
        (1, Side::Start) => Side::Left,
        _ => side,
    };
    assert!(renamed(&skeleton, lost).verify(&figure).is_err());
}
