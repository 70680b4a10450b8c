//! Queries, rain and terrain on small cases, degenerate in nearly every way: laws, and a search
//! through all faces.

#![allow(clippy::float_cmp, reason = "the numbers are to be these very ones")]

mod common;

use std::collections::BTreeMap;

use common::{count, run};
use hipline::observe::{
    Ending, Grid, Index, InvalidWindow, NoAnswer, Systems, Terrain, Window, contours,
};
use hipline::skeleton::NodeKind;
use hipline::topology::FaceId;
use hipline::{Figure, Options, Region, Skeleton};
use hipline_testkit::Case;
use hipline_testkit::generate::{Random, small};

/// The cases of many seeds, in the whole plane.
fn cases(from: u64, many: u64) -> impl Iterator<Item = (u64, Case, Figure, Skeleton)> {
    (from..from + many).map(|seed| {
        let case = small(seed);
        let figure = case.figure().expect("a figure");
        let skeleton = run(&case);
        (seed, case, figure, skeleton)
    })
}

fn is_weighted(figure: &Figure) -> bool {
    figure.edges().iter().any(|e| e.speeds != [1.0, 1.0])
}

fn window(figure: &Figure) -> Window {
    Window::around(figure.vertices().iter().copied(), 0.4).expect("a window")
}

/// Points to ask for: on a grid, where most lie on something, and anywhere.
fn points(seed: u64, figure: &Figure, skeleton: &Skeleton) -> Vec<[f64; 2]> {
    let mut random = Random::new(seed);
    let window = window(figure);
    let (min, size) = (window.min(), window.size());
    let mut fraction = || random.next() as f64 / u64::MAX as f64;
    let mut points: Vec<[f64; 2]> = (0..20)
        .map(|_| [0, 1].map(|k| min[k] + size[k] * fraction()))
        .collect();
    for _ in 0..20 {
        let grid = [0, 1].map(|k| ((min[k] + size[k] * fraction()) * 2.0).round() / 2.0);
        points.push(grid);
    }
    let finite = skeleton.nodes().iter().filter(|n| n.time.is_finite());
    points.extend(finite.map(|n| [n.x, n.y]));
    for arc in skeleton.arcs() {
        let [a, b] = arc.nodes.map(|n| skeleton.node(n));
        if b.time.is_finite() {
            points.push([f64::midpoint(a.x, b.x), f64::midpoint(a.y, b.y)]);
        }
    }
    points
}

/// A face's boundary, unbounded arcs cut off at a late time.
fn outline(skeleton: &Skeleton, face: FaceId, late: f64) -> Vec<[f64; 2]> {
    let boundary = skeleton.boundary(face);
    let node = |i: usize| skeleton.node(boundary[i % boundary.len()]);
    (0..boundary.len())
        .map(|i| match node(i).kind {
            NodeKind::Infinite { direction } => {
                let before = node(i + boundary.len() - 1);
                let start = if before.time.is_finite() {
                    before.time
                } else {
                    node(i + 1).time
                };
                [
                    node(i).x + direction[0] * (late - start),
                    node(i).y + direction[1] * (late - start),
                ]
            }
            _ => [node(i).x, node(i).y],
        })
        .collect()
}

/// How far a point is inside of rings: below 0 outside.
fn depth(rings: &[Vec<[f64; 2]>], p: [f64; 2]) -> f64 {
    let (mut inside, mut nearest) = (false, f64::INFINITY);
    for ring in rings {
        for (i, a) in ring.iter().enumerate() {
            let b = ring[(i + 1) % ring.len()];
            if (a[1] > p[1]) != (b[1] > p[1]) {
                let x = a[0] + (p[1] - a[1]) / (b[1] - a[1]) * (b[0] - a[0]);
                inside ^= p[0] < x;
            }
            let d = [b[0] - a[0], b[1] - a[1]];
            let square = d[0] * d[0] + d[1] * d[1];
            let s = ((p[0] - a[0]) * d[0] + (p[1] - a[1]) * d[1]) / square;
            let s = if s.is_finite() {
                s.clamp(0.0, 1.0)
            } else {
                0.0
            };
            let q = [a[0] + s * d[0], a[1] + s * d[1]];
            nearest = nearest.min((p[0] - q[0]).hypot(p[1] - q[1]));
        }
    }
    if inside { nearest } else { -nearest }
}

#[test]
fn location_agrees_with_a_search_through_all_faces() {
    let (mut deep, mut shallow) = (0, 0);
    for (seed, case, figure, skeleton) in cases(100, count(400, 30)) {
        let index = Index::new(&skeleton, &figure);
        let times = skeleton.nodes().iter().map(|n| n.time);
        let late = 1e4 + 2.0 * times.filter(|t| t.is_finite()).fold(0.0, f64::max);
        let faces: Vec<FaceId> = (0..skeleton.faces().len()).map(FaceId::new).collect();
        let rings: Vec<Vec<Vec<[f64; 2]>>> = faces
            .iter()
            .map(|&face| {
                let mut rings = vec![outline(&skeleton, face, late)];
                rings.extend(skeleton.holes(face).map(|hole| {
                    let point = |n| [skeleton.node(n).x, skeleton.node(n).y];
                    hole.iter().copied().map(point).collect()
                }));
                rings
            })
            .collect();
        for p in points(seed, &figure, &skeleton) {
            let answer = index.locate(p);
            let answer = answer.unwrap_or_else(|e| panic!("{seed}: {e}\n{}", case.to_text()));
            let found = depth(&rings[answer.face.index()], p);
            let context = || format!("seed {seed}, {p:?}, {answer:?}\n{}", case.to_text());
            assert!(found > -1e-6, "{found} outside: {}", context());
            if found > 1e-6 {
                deep += 1;
            } else {
                shallow += 1;
            }
            let other = faces
                .iter()
                .find(|&&f| f != answer.face && depth(&rings[f.index()], p) > 1e-6);
            assert_eq!(other, None, "{}", context());
        }
    }
    println!("{deep} inside, {shallow} on borders");
    assert!(deep > 100 && shallow > 100);
}

#[test]
fn the_surface_is_continuous_and_zero_on_the_graph() {
    for (seed, case, figure, skeleton) in cases(5_000, count(300, 30)) {
        let index = Index::new(&skeleton, &figure);
        let context = || format!("seed {seed}\n{}", case.to_text());
        for arc in skeleton.arcs() {
            let [a, b] = arc.nodes.map(|n| skeleton.node(n));
            if b.time.is_infinite() || arc.faces.iter().any(|&f| skeleton.boundary(f).len() < 3) {
                continue;
            }
            let middle = [f64::midpoint(a.x, b.x), f64::midpoint(a.y, b.y)];
            let [s, t] = arc.faces.map(|f| index.time_of(f, middle).expect("finite"));
            let here = index.locate(middle).expect("covered").time;
            let size = 1.0 + s.abs() + middle[0].abs() + middle[1].abs();
            assert!((s - t).abs() <= 1e-9 * size, "{s} {t} {}", context());
            assert!((s - here).abs() <= 1e-9 * size, "{s} {here} {}", context());
        }
        for &v in figure.vertices() {
            assert_eq!(
                index.locate(v).expect("covered").time,
                0.0,
                "{v:?} {}",
                context()
            );
        }
        for edge in figure.edges() {
            let [p, q] = [edge.from, edge.to].map(|v| figure.vertices()[v.index()]);
            // On the grid of these cases the middle is exact.
            let middle = [f64::midpoint(p[0], q[0]), f64::midpoint(p[1], q[1])];
            let answer = index.locate(middle).expect("covered");
            assert_eq!(answer.time, 0.0, "{middle:?} {}", context());
        }
    }
}

/// Lemma 6 of Aichholzer and Aurenhammer (1996).
#[test]
fn a_drop_ends_on_the_edge_of_its_face() {
    let (mut drops, mut crossing) = (0, 0);
    for (seed, case, figure, skeleton) in cases(9_000, count(400, 30)) {
        let index = Index::new(&skeleton, &figure);
        for p in points(seed, &figure, &skeleton) {
            let drop = index.path(p).expect("covered");
            let context = || format!("seed {seed}, {p:?}, {drop:?}\n{}", case.to_text());
            drops += 1;
            let face = skeleton.face(drop.face);
            let ends = skeleton.input().edges[face.edge.index()];
            let is_own = match drop.ending {
                Ending::Edge(edge) => edge == face.edge,
                Ending::Vertex(v) => ends.contains(&v),
                _ => panic!("a pit: {}", context()),
            };
            if is_weighted(&figure) {
                crossing += u32::from(!is_own);
            } else {
                assert!(is_own, "{}", context());
            }
            let last = drop.points.last().expect("a start");
            assert!(last[2].abs() < 1e-9, "{}", context());
            for pair in drop.points.windows(2) {
                assert!(pair[1][2] <= pair[0][2] + 1e-9, "uphill: {}", context());
                let middle = [0, 1].map(|k| f64::midpoint(pair[0][k], pair[1][k]));
                let time = index.locate(middle).expect("covered").time;
                let expected = f64::midpoint(pair[0][2], pair[1][2]);
                assert!(
                    (time - expected).abs() <= 1e-6 * (1.0 + expected),
                    "{time} off the surface: {}",
                    context()
                );
            }
        }
    }
    println!("{drops} drops, {crossing} into other faces");
    assert!(crossing > 0, "no case in which a drop crosses an arc");
}

#[test]
fn cells_get_what_points_get() {
    for (seed, case, figure, skeleton) in cases(20_000, count(200, 20)) {
        let region = [Region::Both, Region::Auto][seed as usize % 2];
        let skeleton = if region == Region::Both {
            skeleton
        } else {
            figure.skeleton(Options::default().region(region))
        };
        let index = Index::new(&skeleton, &figure);
        let window = window(&figure);
        // Centres on the grid of the input, where they lie on edges and nodes, and others.
        let aligned = Window::new(
            window.min().map(|c| c.floor() - 0.25),
            window.max().map(|c| c.ceil() + 0.25),
        );
        for (window, cell) in [(aligned.expect("a window"), 0.5), (window, 0.37)] {
            let grid = Grid::new(window, cell).expect("a grid");
            let cells = index.locate_grid(&grid);
            assert_eq!(cells.len(), grid.columns() * grid.rows());
            for (i, cell) in cells.iter().enumerate() {
                let centre = grid.centre(i % grid.columns(), i / grid.columns());
                let expected = index.locate(centre);
                assert_eq!(
                    *cell,
                    expected,
                    "seed {seed} {centre:?}\n{}",
                    case.to_text()
                );
            }
        }
    }
}

#[test]
fn terrains_fill_their_windows_without_cracks() {
    for (seed, case, figure, skeleton) in cases(30_000, count(300, 30)) {
        let context = || format!("seed {seed}\n{}", case.to_text());
        let wide = window(&figure);
        let [w, h] = wide.size();
        let corner = wide.min();
        let narrow = Window::new(
            [corner[0] + 0.31 * w, corner[1] + 0.27 * h],
            [corner[0] + 0.73 * w, corner[1] + 0.66 * h],
        );
        for window in [wide, narrow.expect("a window")] {
            let terrain = match Terrain::new(&skeleton, &figure, window) {
                Ok(terrain) => terrain,
                Err(error) => panic!("{error} {}", context()),
            };
            let area = window.area();
            assert!(
                (terrain.area() - area).abs() <= 1e-9 * area,
                "{} of {area}: {}",
                terrain.area(),
                context()
            );
            let catchments = terrain.catchments(FaceId::index);
            let sum: f64 = catchments.iter().map(|c| c.area).sum();
            assert!(
                (sum - area).abs() <= 1e-9 * area,
                "{sum} of {area}: {}",
                context()
            );
            for catchment in &catchments {
                let rings = catchment.polygons.iter().flatten();
                let outlined: f64 = rings.map(|ring| signed_area(ring)).sum();
                assert!(
                    (outlined - catchment.area).abs() <= 1e-9 * area,
                    "{catchment:?}: {}",
                    context()
                );
            }
            cracks(&terrain, &context);
            heights(&terrain, &Index::new(&skeleton, &figure), &context);
        }
        let systems = Systems::new(&figure);
        let terrain = Terrain::new(&skeleton, &figure, wide).expect("a terrain");
        let of = |face: FaceId| systems.of_edges()[skeleton.face(face).edge.index()];
        let basins = terrain.catchments(of);
        assert_eq!(basins.len(), systems.count(), "{}", context());
    }
}

fn signed_area(ring: &[[f64; 2]]) -> f64 {
    let next = ring.iter().skip(1).chain(ring.first());
    let cross = |(p, q): (&[f64; 2], &[f64; 2])| p[0] * q[1] - q[0] * p[1];
    ring.iter().zip(next).map(cross).sum::<f64>() / 2.0
}

/// An edge without a triangle beyond it is on the border of the window.
fn cracks(terrain: &Terrain, context: &dyn Fn() -> String) {
    let mut edges = BTreeMap::new();
    for triangle in terrain.triangles() {
        let [a, b, c] = triangle.corners;
        for edge in [[a, b], [b, c], [c, a]] {
            assert!(
                edges.insert(edge, ()).is_none(),
                "{edge:?} twice: {}",
                context()
            );
        }
    }
    let (min, max) = (terrain.window().min(), terrain.window().max());
    for [a, b] in edges.keys().filter(|[a, b]| !edges.contains_key(&[*b, *a])) {
        let [p, q] = [a, b].map(|v| terrain.vertices()[*v as usize]);
        let on_border = (0..2).any(|k| {
            // A corner of the window may be off by one rounding.
            let near = |x: f64, limit: f64| (x - limit).abs() <= 1e-12 * (1.0 + limit.abs());
            let at = |limit: f64| near(p[k], limit) && near(q[k], limit);
            at(min[k]) || at(max[k])
        });
        assert!(on_border, "a crack from {p:?} to {q:?}: {}", context());
    }
}

fn heights(terrain: &Terrain, index: &Index, context: &dyn Fn() -> String) {
    for &[x, y, time] in terrain.vertices() {
        let exact = index.locate([x, y]).expect("covered").time;
        let size = 1.0 + exact + x.abs() + y.abs();
        assert!(
            (time - exact).abs() <= 1e-9 * size,
            "{time} {exact} at {x} {y}: {}",
            context()
        );
    }
}

#[test]
fn contours_are_as_high_as_they_say() {
    let mut lines = 0;
    for (seed, case, figure, skeleton) in cases(40_000, count(200, 20)) {
        let index = Index::new(&skeleton, &figure);
        let window = window(&figure);
        let times = [0.25, 0.5, 1.0, 1.7];
        for line in contours(&skeleton, &figure, window, &times).expect("contours") {
            lines += 1;
            for &p in &line.points {
                let time = index.locate(p).expect("covered").time;
                assert!(
                    (time - line.time).abs() < 1e-9,
                    "{time} at {p:?}, seed {seed}\n{}",
                    case.to_text()
                );
                let (min, max) = (window.min(), window.max());
                let is_near = (0..2).all(|k| min[k] - 1e-9 <= p[k] && p[k] <= max[k] + 1e-9);
                assert!(is_near, "{p:?} beside the window");
            }
        }
    }
    assert!(lines > 100);
}

#[test]
fn errors_name_what_is_wrong() {
    let case = Case::parse("polygon\nring 0 0, 8 0, 8 4, 0 4\n").expect("a case");
    let figure = case.figure().expect("a figure");
    let inside = figure.skeleton(Options::default());
    let index = Index::new(&inside, &figure);
    assert_eq!(index.locate([9.0, 1.0]), Err(NoAnswer::Outside(9.0, 1.0)));
    assert!(matches!(
        index.locate([f64::NAN, 1.0]),
        Err(NoAnswer::NotFinite(..))
    ));
    // The boundary belongs to the inside.
    for p in [
        [0.0, 0.0],
        [8.0, 0.0],
        [8.0, 4.0],
        [0.0, 4.0],
        [8.0, 1.0],
        [3.0, 4.0],
    ] {
        assert_eq!(index.locate(p).map(|a| a.time), Ok(0.0), "{p:?}");
    }
    let both = figure.skeleton(Options::default().region(Region::Both));
    let index = Index::new(&both, &figure);
    assert!(matches!(
        index.locate([1e300, 1.0]),
        Err(NoAnswer::TooFar(..))
    ));
    assert_eq!(index.locate([-1e40, 1.0]).map(|a| a.time), Ok(1e40));
    let beside = Window::new([20.0, 0.0], [30.0, 5.0]).expect("a window");
    assert!(matches!(
        Terrain::new(&both, &figure, beside),
        Err(InvalidWindow::MissesData(..))
    ));
    assert!(matches!(
        Window::new([1.0, 0.0], [0.0, 1.0]),
        Err(InvalidWindow::Empty(..))
    ));
    assert!(matches!(
        Window::new([f64::NAN, 0.0], [0.0, 1.0]),
        Err(InvalidWindow::NotFinite(..))
    ));
    let tiny = Window::new([1e9, 1e9], [1e9 + 1e-3, 1e9 + 1e-3]).expect("a window");
    assert!(Grid::new(tiny, 1e-9).is_err(), "centres that are one f64");
    assert!(Grid::new(beside, 1e-6).is_err(), "too many cells");
    assert!(Grid::new(beside, 0.0).is_err());
}
