//! Motorcycle graphs: the fast grounds against a look at all pairs and against the reference, which shares no code
//! with them, bit for bit; and what they are good for: every valley of the skeleton lies on a track.

mod common;

use common::{count, field};
use hipline::motorcycle::{End, Launch, MotorcycleGraph, Origin, Spot};
use hipline::skeleton::{ArcKind, Side};
use hipline::topology::{EdgeId, MeetingId, MotorcycleId};
use hipline::{Figure, Options};
use hipline_testkit::Case;
use hipline_testkit::agreement as drawn;
use hipline_testkit::case::Part;
use hipline_testkit::generate::{Family, Kind, Random, small_of};
use hipline_testkit::metamorphic::Map;
use hipline_testkit::reference::{Graph, RefMotorcycle, reference_launches, reference_motorcycles};

fn told(graph: &MotorcycleGraph) -> Vec<RefMotorcycle> {
    let spot = |spot: Spot| [spot.x, spot.y, spot.time];
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
    assert_eq!(walked.verify(&figure), Ok(()), "{}", case.to_text());
    !walked.motorcycles().is_empty()
}

#[test]
fn walks_agree_with_all_pairs() {
    let (mut seen, mut meetings, mut births, mut valleys) = (0, 0, 0, 0);
    for seed in 0..count(20_000, 500) {
        let case = small_of(Kind::POLYGONS[seed as usize % Kind::POLYGONS.len()], seed);
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

#[test]
fn graphs_of_the_field_obey_their_laws() {
    let (mut vertices, mut motorcycles) = (0, 0);
    for case in field(100_000, count(300, 3) as usize) {
        let figure = case.figure().expect("a figure");
        let Ok(graph) = figure.motorcycles() else {
            continue;
        };
        assert_eq!(graph.verify(&figure), Ok(()), "{:?}", case.comments);
        vertices += figure.vertices().len();
        motorcycles += graph.motorcycles().len();
    }
    println!("{vertices} vertices, {motorcycles} motorcycles");
}

#[test]
fn graphs_of_families_obey_their_laws() {
    for family in Family::all() {
        let case = family.generate(count(3000, 200) as usize, 3);
        let Ok(figure) = case.figure() else {
            continue;
        };
        if let Ok(graph) = figure.motorcycles() {
            assert_eq!(graph.verify(&figure), Ok(()), "{}", family.name());
        }
    }
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
        if wall[0].map(f64::to_bits) != wall[1].map(f64::to_bits) {
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
        let verified = fast.verify_launches(&list, &walls);
        assert_eq!(verified, Ok(()), "seed {seed}: {list:?} {walls:?}");
        let reference = reference_launches(&list, &walls);
        assert_eq!(told(&fast), reference, "seed {seed}: {list:?} {walls:?}");
    }
}

/// Where motorcycles start and stop, mapped and sorted.
fn tracks(case: &Case, map: Map) -> Vec<[drawn::End; 2]> {
    let graph = case
        .figure()
        .expect("a figure")
        .motorcycles()
        .expect("polygons");
    let end = |spot: Spot| map.end(&drawn::End::new([spot.x, spot.y], spot.time, None));
    let mut tracks: Vec<_> = (graph.motorcycles().iter())
        .map(|m| [end(m.start), end(m.stop.expect("there is a boundary"))])
        .collect();
    tracks.sort_unstable();
    tracks
}

#[test]
fn maps_carry_motorcycles_along() {
    for seed in 0..count(2000, 100) {
        let case = small_of(
            Kind::POLYGONS[seed as usize % Kind::POLYGONS.len()],
            1_000_000 + seed,
        );
        if !case
            .figure()
            .is_ok_and(|figure| figure.motorcycles().is_ok())
        {
            continue;
        }
        for map in Map::some().into_iter().filter(|map| !map.rounds()) {
            let due = tracks(&case, map);
            let found = tracks(&map.apply(&case), Map::Start(0));
            assert_eq!(due, found, "{map:?}\n{}", case.to_text());
        }
    }
}

/// A case whose coordinates are multiplied by powers of two.
fn stretched(case: &Case, powers: [i32; 2]) -> Case {
    let mut case = case.clone();
    for point in case.parts.iter_mut().flat_map(Part::points_mut) {
        *point = [0, 1].map(|k| scaled(point[k], powers[k]));
    }
    case
}

/// A number times a power of two, of which f64 need not hold the latter.
fn scaled(x: f64, power: i32) -> f64 {
    let half = power / 2;
    x * 2.0_f64.powi(half) * 2.0_f64.powi(power - half)
}

/// The graph of a figure that is made tiny or huge is that of the figure, tiny or huge.
#[test]
fn tiny_and_huge_figures_have_the_same_graphs() {
    let mut seen = 0;
    for seed in 0..count(2000, 40) {
        let kind = Kind::POLYGONS[seed as usize % Kind::POLYGONS.len()];
        let case = small_of(kind, 2_000_000 + seed);
        let Some(graph) = (case.figure().ok()).and_then(|figure| figure.motorcycles().ok()) else {
            continue;
        };
        // Multiples of 2^-10 become multiples of the least number.
        for power in [-1064, -1050, -1020, 900] {
            let other = stretched(&case, [power; 2]);
            let figure = other.figure().expect("a figure");
            let found = figure.motorcycles().expect("it applies");
            assert_eq!(found.verify(&figure), Ok(()), "{}", other.to_text());
            let same = |due: Spot, found: Spot| {
                [(due.x, found.x), (due.y, found.y), (due.time, found.time)]
                    .into_iter()
                    .all(|(due, found)| {
                        let due = scaled(due, power);
                        // The number is rounded twice here if it is subnormal.
                        let last = if due.is_normal() {
                            0.0
                        } else {
                            f64::from_bits(1)
                        };
                        (due - found).abs() <= last
                    })
            };
            assert_eq!(graph.motorcycles().len(), found.motorcycles().len());
            for (due, m) in graph.motorcycles().iter().zip(found.motorcycles()) {
                let stops = due.stop.zip(m.stop).is_some_and(|(p, q)| same(p, q));
                assert!(same(due.start, m.start) && stops, "{}", other.to_text());
                assert_eq!(
                    (due.origin, due.end, due.between, due.velocity),
                    (m.origin, m.end, m.between, m.velocity),
                    "{}",
                    other.to_text()
                );
            }
            seen += graph.motorcycles().len();
        }
    }
    println!("{seen} motorcycles");
    assert!(seen > 100);
}

#[test]
fn flat_figures_agree_with_all_pairs() {
    let mut seen = 0;
    for seed in 0..count(600, 20) {
        let kind = Kind::POLYGONS[seed as usize % Kind::POLYGONS.len()];
        let case = small_of(kind, 3_000_000 + seed);
        for powers in [[0, -100], [-1064, -964], [-964, -1064], [900, 800]] {
            seen += u64::from(agrees(&stretched(&case, powers)));
        }
    }
    println!("{seen} with motorcycles");
    assert!(seen > 40);
}

fn of_ring(ring: &[[f64; 2]]) -> MotorcycleGraph {
    let polygon = hipline::Polygon::new([ring.to_vec()]).expect("a ring");
    polygon.figure().motorcycles().expect("a polygon")
}

#[test]
fn two_teeth_that_meet_send_one_on() {
    // Both tips go up at 45 degrees; above them, a valley between the upper sides is left.
    let graph = of_ring(&[
        [-4.5, -10.0],
        [4.5, -10.0],
        [2.0, 0.0],
        [10.0, -2.0],
        [10.0, 10.0],
        [-10.0, 10.0],
        [-10.0, -2.0],
        [-2.0, 0.0],
    ]);
    let [right, left, child] = *graph.motorcycles() else {
        panic!("{graph:?}");
    };
    let [meeting] = graph.meetings() else {
        panic!("{graph:?}");
    };
    assert_eq!((meeting.spot.x, meeting.spot.y), (0.0, 2.0));
    // 6 / sqrt(17), correctly rounded.
    assert_eq!(meeting.spot.time.to_string(), "1.4552137502179978");
    assert_eq!(meeting.members, [0, 1].map(MotorcycleId::new));
    assert_eq!(meeting.child, Some(MotorcycleId::new(2)));
    assert_eq!(right.end, left.end);
    assert_eq!(child.origin, Origin::Meeting(MeetingId::new(0)));
    assert_eq!(child.start, meeting.spot);
    assert_eq!(format!("{:?}", child.velocity), "[0.0, 1.0307764064044151]");
    let stop = child.stop.expect("the upper edge");
    assert_eq!((stop.x, stop.y), (0.0, 10.0));
    assert_eq!(child.end, End::Edge(EdgeId::new(4), Side::Left));
    // It runs between the upper sides: that of the left tooth is on its left.
    let edges = child.between.expect("edges").map(|(edge, _)| edge.index());
    assert_eq!(edges, [6, 2]);
}

#[test]
fn head_on_nobody_goes_on() {
    let graph = of_ring(&[
        [-10.0, -10.0],
        [10.0, -10.0],
        [10.0, -1.0],
        [1.0, 0.0],
        [10.0, 1.0],
        [10.0, 10.0],
        [-10.0, 10.0],
        [-10.0, 1.0],
        [-1.0, 0.0],
        [-10.0, -1.0],
    ]);
    assert_eq!(graph.motorcycles().len(), 2, "{graph:?}");
    assert_eq!(graph.meetings().len(), 1, "{graph:?}");
    assert_eq!(graph.meetings()[0].child, None);
    let spot = graph.meetings()[0].spot;
    assert_eq!((spot.x, spot.y), (0.0, 0.0));
}

/// What becomes of motorcycles `[x, y, vx, vy, time]`: place and cause of each end.
fn race(list: &[[f64; 5]], walls: &[[[f64; 2]; 2]]) -> Vec<String> {
    let launches: Vec<Launch> = (list.iter())
        .map(|&[x, y, v, w, time]| Launch::new([x, y], [v, w]).at(time))
        .collect();
    let graph = MotorcycleGraph::new(&launches, walls).expect("valid");
    let tell = |m: &hipline::motorcycle::Motorcycle| match m.stop {
        Some(stop) => format!("{},{} at {}: {:?}", stop.x, stop.y, stop.time, m.end),
        None => format!("{:?}", m.end),
    };
    graph.motorcycles().iter().map(tell).collect()
}

#[test]
fn special_cases_have_one_answer() {
    for (list, walls, expected) in [
        // The later one runs into the track; at the same moment both stop.
        (
            vec![[0., 0., 1., 0., 0.], [3., -4., 0., 2., 0.]],
            vec![],
            vec!["3,0 at 3: Track(m1)", "Escape"],
        ),
        (
            vec![[0., 0., 1., 0., 0.], [2., -2., 0., 1., 0.]],
            vec![],
            vec!["2,0 at 2: Meeting(j0)", "2,0 at 2: Meeting(j0)"],
        ),
        // A start at that very moment, and one on a track.
        (
            vec![[0., 0., 1., 0., 0.], [2., 0., 0., 1., 2.]],
            vec![],
            vec!["2,0 at 2: Track(m1)", "Escape"],
        ),
        (
            vec![[0., 0., 1., 0., 0.], [2., 0., 0., 1., 3.]],
            vec![],
            vec!["Escape", "2,0 at 3: Track(m0)"],
        ),
        // On one line: following, head on, apart, back along the track.
        (
            vec![[0., 0., 1., 0., 0.], [2., 0., 1., 0., 0.]],
            vec![],
            vec!["2,0 at 2: Track(m1)", "Escape"],
        ),
        (
            vec![[0., 0., 1., 0., 0.], [4., 0., -3., 0., 0.]],
            vec![],
            vec!["1,0 at 1: Meeting(j0)", "1,0 at 1: Meeting(j0)"],
        ),
        (
            vec![[0., 0., -1., 0., 0.], [0., 0., 1., 0., 0.]],
            vec![],
            vec!["Escape", "Escape"],
        ),
        (
            vec![[0., 0., 1., 0., 0.], [2., 0., -1., 0., 2.]],
            vec![],
            vec!["2,0 at 2: Track(m1)", "2,0 at 2: Track(m0)"],
        ),
        (
            vec![[0., 0., 2., 0., 0.], [0., 0., 1., 0., 0.]],
            vec![],
            vec!["Escape", "0,0 at 0: Track(m0)"],
        ),
        // Walls: on the inside, at an end, lengthwise, and started on.
        (
            vec![[0., 0., 1., 1., 0.]],
            vec![[[0., 4.], [4., 0.]]],
            vec!["2,2 at 2: Wall(b0)"],
        ),
        (
            vec![[0., 0., 1., 1., 0.]],
            vec![[[2., 2.], [4., 0.]]],
            vec!["2,2 at 2: Wall(b0)"],
        ),
        (
            vec![[0., 0., 1., 0., 0.]],
            vec![[[3., 0.], [1., 0.]]],
            vec!["1,0 at 1: Wall(b0)"],
        ),
        (
            vec![[0., 0., 1., 0., 0.]],
            vec![[[0., -1.], [0., 1.]]],
            vec!["Escape"],
        ),
        (
            vec![[0., 0., 1., 0., 0.]],
            vec![[[-1., 0.], [1., 0.]]],
            vec!["0,0 at 0: Wall(b0)"],
        ),
        (
            vec![[1., 0., 1., 0., 0.]],
            vec![[[-1., 0.], [1., 0.]]],
            vec!["Escape"],
        ),
        // A wall counts before a track.
        (
            vec![[0., 0., 1., 0., 0.], [2., -1., 0., 2., 0.]],
            vec![[[2., 0.], [3., 1.]]],
            vec!["2,0 at 2: Wall(b0)", "2,0 at 0.5: Wall(b0)"],
        ),
    ] {
        assert_eq!(race(&list, &walls), expected, "{list:?} {walls:?}");
    }
}

#[test]
fn every_flaw_of_launches_is_named() {
    let fine = Launch::new([0.0, 0.0], [1.0, 0.0]);
    let launches = [
        fine,
        Launch::new([f64::NAN, 0.0], [1.0, 0.0]),
        Launch::new([0.0, 0.0], [0.0, -0.0]),
        Launch::new([-0.0, 0.0], [1.0, 0.0]),
        Launch::new([1e300, 0.0], [1.0, 0.0]),
        fine.at(f64::INFINITY),
    ];
    let walls = [
        [[0.0, 1.0], [0.0, 1.0]],
        [[0.0, f64::INFINITY], [0.0, 1.0]],
        [[1e-300, 0.0], [0.0, 1.0]],
    ];
    let flaws = MotorcycleGraph::new(&launches, &walls)
        .expect_err("flaws")
        .to_string();
    let expected = [
        "motorcycle 1: its place, velocity and time have to be finite numbers",
        "motorcycle 2: its velocity is zero",
        "motorcycles 0 and 3: they start at one place and time with one velocity",
        "motorcycle 4: the size of its numbers has to be between 2^-140 and 2^140, or zero",
        "motorcycle 5: its place, velocity and time have to be finite numbers",
        "wall 0: its ends are one point",
        "wall 1: its ends have to be finite numbers",
        "wall 2: the size of its numbers has to be between 2^-140 and 2^140, or zero",
    ];
    assert_eq!(flaws.lines().collect::<Vec<_>>(), expected);
}

#[test]
fn far_and_tiny_launches_agree_with_all_pairs() {
    let mut random = Random::new(3);
    for _ in 0..count(300, 20) {
        let scale = |random: &mut Random| 2.0_f64.powi(random.range(-130, 130) as i32);
        let [size, speed, time, far] = [(); 4].map(|()| scale(&mut random));
        let list: Vec<Launch> = (0..8)
            .map(|_| {
                let mut number = || random.unit() - 0.5;
                Launch::new(
                    [number() * size + far, number() * size],
                    [number() * speed, number() * speed],
                )
                .at(number() * time)
            })
            .collect();
        let Ok(fast) = MotorcycleGraph::new(&list, &[]) else {
            continue;
        };
        assert_eq!(
            Ok(fast),
            MotorcycleGraph::of_all_pairs(&list, &[]),
            "{list:?}"
        );
    }
}
