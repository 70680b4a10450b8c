//! Motorcycle graphs: the fast grounds against a look at all pairs and against the reference, which shares no code
//! with them, bit for bit; and what they are good for: every valley of the skeleton lies on a track.

mod common;

use common::{count, field};
use hipline::motorcycle::{Launch, MotorcycleGraph};
use hipline::skeleton::{ArcKind, Side};
use hipline::topology::EdgeId;
use hipline::{Figure, Options};
use hipline_testkit::Case;
use hipline_testkit::generate::{Kind, Random, small_of};
use hipline_testkit::reference::{Graph, RefMotorcycle, reference_launches, reference_motorcycles};

const KINDS: [Kind; 8] = [
    Kind::Simple,
    Kind::Star,
    Kind::Shape,
    Kind::Polyomino,
    Kind::Holes,
    Kind::Touching,
    Kind::Symmetric,
    Kind::Islands,
];

fn told(graph: &MotorcycleGraph) -> Vec<RefMotorcycle> {
    let spot = |spot: hipline::motorcycle::Spot| [spot.x, spot.y, spot.time];
    let all = graph.motorcycles().iter();
    all.map(|m| RefMotorcycle {
        start: spot(m.start),
        stop: m.stop.map(spot),
        end: m.end,
    })
    .collect()
}

/// The line of an edge and the side of it: two are equal if their wavefronts lie on one plane.
fn plane(figure: &Figure, (edge, side): (EdgeId, Side)) -> [i64; 3] {
    fn gcd(a: i64, b: i64) -> i64 {
        if b == 0 { a.abs() } else { gcd(b, a % b) }
    }
    let edge = figure.edges()[edge.index()];
    let [[px, py], [qx, qy]] =
        [edge.from, edge.to].map(|v| figure.vertices()[v.index()].map(|x| (x * 1024.0) as i64));
    let (a, b) = (py - qy, qx - px);
    let line = [a, b, a * px + b * py];
    let by = gcd(a, b) * if side == Side::Right { -1 } else { 1 };
    line.map(|x| x / by)
}

/// Each valley lies on the track of a motorcycle that runs between the same wavefronts.
fn covers_valleys(case: &Case, figure: &Figure, graph: &MotorcycleGraph) -> usize {
    let skeleton = figure.skeleton(Options::default());
    let mut valleys = 0;
    for arc in skeleton.arcs() {
        if arc.kind != ArcKind::Valley {
            continue;
        }
        valleys += 1;
        let faces = arc.faces.map(|face| {
            let face = skeleton.face(face);
            plane(figure, (face.edge, face.side))
        });
        let [from, to] = arc.nodes.map(|node| skeleton.node(node).time);
        let covered = graph.motorcycles().iter().any(|m| {
            let between = m
                .between
                .expect("of a figure")
                .map(|side| plane(figure, side));
            between == faces && m.start.time <= from && m.stop.is_none_or(|stop| to <= stop.time)
        });
        assert!(
            covered,
            "the valley {arc:?} is on no track\n{}",
            case.to_text()
        );
    }
    valleys
}

fn agrees(case: &Case) -> bool {
    let Ok(figure) = case.figure() else {
        return false;
    };
    let Ok(walked) = figure.motorcycles() else {
        return false;
    };
    let pairs = figure.motorcycles_by_pairs().expect("it applies");
    assert_eq!(walked, pairs, "{}", case.to_text());
    !walked.motorcycles().is_empty()
}

#[test]
fn walks_agree_with_all_pairs() {
    let (mut seen, mut meetings, mut births, mut valleys) = (0, 0, 0, 0);
    for seed in 0..count(20_000, 500) {
        let case = small_of(KINDS[seed as usize % KINDS.len()], seed);
        if agrees(&case) {
            seen += 1;
            let figure = case.figure().expect("a figure");
            let graph = figure.motorcycles().expect("applies");
            meetings += graph.meetings().len();
            births += graph
                .meetings()
                .iter()
                .filter(|m| m.child.is_some())
                .count();
            valleys += covers_valleys(&case, &figure, &graph);
            let reference = reference_motorcycles(&Graph::from(&figure));
            assert_eq!(told(&graph), reference, "{}", case.to_text());
        }
    }
    println!("{seen} with motorcycles, {meetings} meetings, {births} births, {valleys} valleys");
    assert!(seen > count(10_000, 250));
}

#[test]
fn walks_agree_with_all_pairs_in_the_field() {
    let mut vertices = 0;
    for case in field(1500, 15) {
        if agrees(&case) {
            vertices += case.size();
        }
    }
    println!("{vertices} vertices");
}

/// Motorcycles and walls on a small grid, so that nearly everything coincides with something.
fn launches(seed: u64) -> (Vec<Launch>, Vec<[[f64; 2]; 2]>) {
    let mut random = Random::new(seed);
    let size = 3 + random.below(8);
    let fine = if random.one_in(2) { 1.0 } else { 0.5 };
    let point = |random: &mut Random| [0, 1].map(|_| random.below(size) as f64 * fine);
    let timed = random.one_in(3);
    let mut list: Vec<Launch> = Vec::new();
    for _ in 0..1 + random.below(9) {
        let place = point(&mut random);
        let velocity = [0, 1].map(|_| random.below(5) as f64 - 2.0);
        let time = if timed { random.below(4) as f64 } else { 0.0 };
        let launch = Launch::new(place, velocity).at(time);
        if velocity != [0.0, 0.0] && !list.contains(&launch) {
            list.push(launch);
        }
    }
    let mut walls = Vec::new();
    for _ in 0..random.below(4) {
        let wall = [point(&mut random), point(&mut random)];
        if wall[0] != wall[1] {
            walls.push(wall);
        }
    }
    (list, walls)
}

#[test]
fn grids_agree_with_all_pairs() {
    for seed in 0..count(20_000, 500) {
        let (list, walls) = launches(seed);
        let fast = MotorcycleGraph::new(&list, &walls).expect("valid");
        let pairs = MotorcycleGraph::of_all_pairs(&list, &walls).expect("valid");
        assert_eq!(fast, pairs, "seed {seed}: {list:?} {walls:?}");
        let reference = reference_launches(&list, &walls);
        assert_eq!(told(&fast), reference, "seed {seed}: {list:?} {walls:?}");
    }
}
