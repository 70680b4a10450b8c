//! The reference engine on figures whose skeletons can be worked out by hand.

use hipline::skeleton::ArcKind;
use hipline_testkit::case::Case;
use hipline_testkit::reference::{Graph, RefKind, Reference, check_laws, reference};

fn run(text: &str) -> Reference {
    let case = Case::parse(text).unwrap_or_else(|error| panic!("{text}: {error}"));
    let figure = case
        .figure()
        .unwrap_or_else(|flaws| panic!("{text}: {flaws:?}"));
    let graph = Graph::from(&figure);
    let result = reference(&graph, case.region);
    assert_eq!(check_laws(&graph, &result), Ok(()), "{text}");
    result
}

/// Checks the event nodes: x, y, time, number of arcs; in any order.
fn check(text: &str, expected: &[([f64; 3], usize)]) -> Reference {
    let result = run(text);
    let degrees = result.degrees();
    let events = result
        .nodes
        .iter()
        .zip(&degrees)
        .filter(|(node, _)| node.kind == RefKind::Event);
    let mut found: Vec<([f64; 3], usize)> = events
        .map(|(node, &degree)| ([node.place[0], node.place[1], node.time], degree))
        .collect();
    let mut expected = expected.to_vec();
    for list in [&mut found, &mut expected] {
        list.sort_by(|a, b| {
            (0..3).fold(std::cmp::Ordering::Equal, |o, k| {
                o.then(a.0[k].total_cmp(&b.0[k]))
            })
        });
    }
    assert_eq!(found.len(), expected.len(), "{text}: {found:?}");
    for (f, e) in found.iter().zip(&expected) {
        let near = (0..3).all(|k| (f.0[k] - e.0[k]).abs() < 1e-14);
        assert!(
            near && f.1 == e.1,
            "{text}: found {found:?}, expected {expected:?}"
        );
    }
    result
}

/// How many ridges, valleys and ghosts; and of all of them, how many are unbounded or level.
fn count(result: &Reference) -> [usize; 5] {
    let of = |kind: ArcKind| result.arcs.iter().filter(|arc| arc.kind == kind).count();
    let times = |arc: &&hipline_testkit::reference::RefArc| arc.nodes.map(|n| result.nodes[n].time);
    let unbounded = result
        .arcs
        .iter()
        .filter(|arc| times(arc)[1].is_infinite())
        .count();
    let level = result
        .arcs
        .iter()
        .filter(|arc| times(arc)[0].total_cmp(&times(arc)[1]).is_eq())
        .count();
    [
        of(ArcKind::Ridge),
        of(ArcKind::Valley),
        of(ArcKind::Ghost),
        unbounded,
        level,
    ]
}

/// The directions of the nodes at infinity, sorted.
fn directions(result: &Reference) -> Vec<[f64; 2]> {
    let direction = |kind| {
        if let RefKind::Infinite(direction) = kind {
            Some(direction)
        } else {
            None
        }
    };
    let mut found: Vec<[f64; 2]> = result
        .nodes
        .iter()
        .filter_map(|node| direction(node.kind))
        .collect();
    found.sort_by(|a, b| a[0].total_cmp(&b[0]).then(a[1].total_cmp(&b[1])));
    found
}

#[test]
fn square_and_rectangle() {
    let square = check("polygon\nring 0 0, 2 0, 2 2, 0 2", &[([1.0, 1.0, 1.0], 4)]);
    assert_eq!(count(&square), [4, 0, 0, 0, 0], "four ridges");
    let rectangle = check(
        "polygon\nring 0 0, 4 0, 4 2, 0 2",
        &[([1.0, 1.0, 1.0], 3), ([3.0, 1.0, 1.0], 3)],
    );
    assert_eq!(
        count(&rectangle),
        [5, 0, 0, 0, 1],
        "the long sides meet face to face"
    );
}

#[test]
fn triangle_and_tangent_octagon() {
    check("polygon\nring 0 0, 4 0, 0 3", &[([1.0, 1.0, 1.0], 3)]);
    let octagon = "polygon\nring 6 -3, 6 3, 2 6, -2 6, -6 3, -6 -3, -2 -6, 2 -6";
    check(octagon, &[([0.0, 0.0, 6.0], 8)]);
}

#[test]
fn the_l_and_the_cross() {
    let l = "polygon\nring 0 0, 4 0, 4 2, 2 2, 2 4, 0 4";
    let l = check(
        l,
        &[
            ([1.0, 1.0, 1.0], 4),
            ([3.0, 1.0, 1.0], 3),
            ([1.0, 3.0, 1.0], 3),
        ],
    );
    assert_eq!(
        count(&l),
        [7, 1, 0, 0, 2],
        "one valley from the reflex corner"
    );
    let cross = "polygon\nring 2 0, 4 0, 4 2, 6 2, 6 4, 4 4, 4 6, 2 6, 2 4, 0 4, 0 2, 2 2";
    let arm = |x, y| ([x, y, 1.0], 3);
    let nodes = [
        arm(3.0, 1.0),
        arm(5.0, 3.0),
        arm(3.0, 5.0),
        arm(1.0, 3.0),
        ([3.0, 3.0, 1.0], 8),
    ];
    let cross = check(cross, &nodes);
    assert_eq!(
        count(&cross),
        [12, 4, 0, 0, 4],
        "four reflex corners meet in the middle"
    );
}

#[test]
fn square_with_square_hole() {
    let text = "polygon\nring 0 0, 6 0, 6 6, 0 6\nring 2 2, 2 4, 4 4, 4 2";
    let nodes = [[1.0, 1.0], [5.0, 1.0], [5.0, 5.0], [1.0, 5.0]].map(|[x, y]| ([x, y, 1.0], 4));
    assert_eq!(
        count(&check(text, &nodes)),
        [8, 4, 0, 0, 4],
        "a ridge all around"
    );
}

#[test]
fn notch_splits_the_opposite_edge() {
    let root = 2.0_f64.powf(0.5);
    let (split, end) = (2.0 * root - 2.0, 6.0 - 3.0 * root);
    let result = check(
        "polygon\nring 0 0, 8 0, 8 6, 4 2, 0 6",
        &[
            ([4.0, split, split], 3),
            ([end, end, end], 3),
            ([8.0 - end, end, end], 3),
        ],
    );
    assert_eq!(count(&result), [6, 1, 0, 0, 0], "2n - 3 arcs");
}

#[test]
fn one_segment() {
    let result = check("line 0 0, 2 0", &[]);
    assert_eq!(count(&result), [0, 4, 0, 4, 0], "a growing rectangle");
    assert_eq!(
        directions(&result),
        [[-1.0, -1.0], [-1.0, 1.0], [1.0, -1.0], [1.0, 1.0]],
        "{result:?}"
    );
}

#[test]
fn parallel_segments_meet_face_to_face() {
    let result = check(
        "line 0 0, 4 0\nline 0 2, 4 2",
        &[([-1.0, 1.0, 1.0], 4), ([5.0, 1.0, 1.0], 4)],
    );
    assert_eq!(
        count(&result),
        [1, 8, 2, 6, 1],
        "the caps go on side by side, with ghosts between"
    );
    assert!(
        directions(&result).contains(&[-1.0, 0.0]),
        "a ghost to the left"
    );
}

#[test]
fn crossing_and_junction() {
    let cross = check("line -2 0, 0 0, 2 0\nline 0 -2, 0 0, 0 2", &[]);
    assert_eq!(count(&cross), [4, 8, 0, 12, 0], "four arms");
    let junction = check("line -2 0, 2 0\nline 0 0, 0 -2", &[]);
    assert_eq!(
        count(&junction),
        [2, 6, 1, 9, 0],
        "a ghost on the flat side"
    );
    assert!(
        directions(&junction).contains(&[0.0, 1.0]),
        "the ghost goes up"
    );
}

#[test]
fn facing_brackets() {
    // Two U's that open towards each other, 2 apart: the tips meet at time 1.
    let text = "line 3 0, 0 0, 0 4, 3 4\nline 5 0, 8 0, 8 4, 5 4";
    let result = run(text);
    let at = |place: [f64; 2]| {
        result
            .nodes
            .iter()
            .position(|node| {
                node.place.map(f64::to_bits) == place.map(f64::to_bits) && node.time.is_finite()
            })
            .expect("a node")
    };
    let degrees = result.degrees();
    for y in [-1.0, 1.0, 3.0, 5.0] {
        assert_eq!(
            degrees[at([4.0, y])],
            4,
            "two valleys, the ridge, a ghost at y = {y}"
        );
    }
    // Inside, a rectangle of 8 by 4 remains, with ghosts that end on its ridge.
    assert_eq!(
        degrees[at([4.0, 2.0])],
        4,
        "two ghosts end on the long ridge"
    );
}

#[test]
fn collinear_corner_makes_a_ghost() {
    let text = "polygon\nring 0 0, 1 0, 4 0, 4 4, 0 4";
    let result = check(text, &[([1.0, 1.0, 1.0], 3), ([2.0, 2.0, 2.0], 4)]);
    assert_eq!(
        count(&result),
        [5, 0, 1, 0, 0],
        "the ghost ends where it meets the ridge"
    );
}

#[test]
fn equal_teeth_meet_the_base_together() {
    // Two reflex corners reach the base at the same moment, and the middle tooth between them
    // ends in a ridge of its own.
    let root = 5.0_f64.powf(0.5);
    let result = run("polygon\nring 0 0, 12 0, 12 8, 10 8, 8 4, 6 8, 4 4, 2 8, 0 8");
    let split = 4.0 / (1.0 + root);
    for x in [4.0, 8.0] {
        let hit =
            |place: [f64; 2]| (place[0] - x).abs() < 1e-14 && (place[1] - split).abs() < 1e-14;
        assert!(
            result.nodes.iter().any(|node| hit(node.place)),
            "{x}: {:?}",
            result.nodes
        );
    }
    assert_eq!(result.arcs.len(), 2 * 9 - 3, "a tree");
}

#[test]
fn a_fast_side() {
    let text = "polygon\nring 0 0, 3 0, 3 3, 0 3\nspeeds 2, 1, 1, 1";
    let result = check(text, &[([1.0, 2.0, 1.0], 3), ([2.0, 2.0, 1.0], 3)]);
    assert_eq!(count(&result), [5, 0, 0, 0, 1], "a roof with one flat side");
}

#[test]
fn the_faster_of_two_collinear_sides_wins() {
    let text = "polygon\nring 0 0, 2 0, 4 0, 4 4, 0 4\nspeeds 2, 1, 1, 1, 1";
    let third = 4.0 / 3.0;
    let nodes = [
        ([third, 2.0 * third, third], 3),
        ([4.0 - third, 2.0 * third, third], 3),
    ];
    let result = check(text, &nodes);
    assert_eq!(
        count(&result),
        [6, 0, 0, 0, 2],
        "an arc along the slower side, at time 0"
    );
    let at_once = result
        .arcs
        .iter()
        .find(|arc| arc.nodes == [1, 2])
        .expect("from vertex 1 to vertex 2");
    let names = at_once.faces.map(|face| result.faces[face].0);
    assert_eq!(
        names,
        [0, 1],
        "the faster face on the left of the way it spreads"
    );
}

#[test]
fn the_earlier_of_two_equally_fast_sides_wins() {
    // Walking with the inside on the left, edge 0 comes before the slow edge 1.
    let text = "polygon\nring 0 0, 2 0, 4 0, 6 0, 6 6, 0 6\nspeeds 2, 1, 2, 1, 1, 1";
    let result = run(text);
    let ghost = result
        .arcs
        .iter()
        .find(|arc| arc.kind == ArcKind::Ghost)
        .expect("between edges 0 and 2");
    assert_eq!(ghost.nodes[0], 2, "it starts where the slow edge ends");
}

#[test]
fn edges_that_stand_still_are_gables() {
    let result = check(
        "polygon\nring 0 0, 8 0, 8 4, 0 4\nspeeds 1, 0, 1, 0",
        &[([8.0, 2.0, 2.0], 3), ([0.0, 2.0, 2.0], 3)],
    );
    assert_eq!(count(&result), [5, 0, 0, 0, 1], "a ridge over the house");
}

#[test]
fn a_square_with_a_break_is_a_mansard_roof() {
    let corners = [[1.0, 1.0], [7.0, 1.0], [7.0, 7.0], [1.0, 7.0]];
    let mut nodes: Vec<([f64; 3], usize)> = corners.map(|[x, y]| ([x, y, 1.0], 4)).to_vec();
    nodes.push(([4.0, 4.0, 2.5], 4));
    let result = check(
        "polygon\nring 0 0, 8 0, 8 8, 0 8\nchanges 0 both 1 2, 1 both 1 2, 2 both 1 2, 3 both 1 2",
        &nodes,
    );
    assert_eq!(
        count(&result),
        [8, 0, 0, 0, 4],
        "two ridges over each corner"
    );
    let later = result.faces.iter().filter(|(.., phase)| *phase == 1);
    assert_eq!(later.count(), 4, "each slope has an upper part");
}

#[test]
fn a_terminal_opens_when_a_side_starts() {
    let result = check(
        "region both\nline 0 0, 4 0\nspeeds 0 0\nchanges 0 left 2 1",
        &[([0.0, 0.0, 2.0], 4), ([4.0, 0.0, 2.0], 4)],
    );
    // The right side stands for ever, and grows at both ends.
    let due = [[-1.0, 0.0], [-1.0, 1.0], [1.0, 0.0], [1.0, 1.0]];
    assert_eq!(directions(&result), due, "of its four vertices");
    let upright = result.arcs.iter().filter(|arc| {
        let [a, b] = arc.nodes.map(|node| result.nodes[node]);
        b.time.is_finite() && a.time < b.time
    });
    assert_eq!(upright.count(), 2, "one at each closed end");
}

#[test]
fn of_equally_fast_neighbours_the_one_that_will_be_faster_wins() {
    let text = "region both\nline 0 0, 2 0, 4 0\nspeeds 1 1, 1 1\nchanges 0 left 3 2";
    let result = run(text);
    let vertices =
        |arc: &&hipline_testkit::reference::RefArc| arc.nodes.iter().all(|&node| node < 3);
    let over: Vec<_> = result.arcs.iter().filter(vertices).collect();
    assert_eq!(over.len(), 1, "the left side of the second edge is covered");
    let names = over[0].faces.map(|face| result.faces[face]);
    assert!(
        names.contains(&(1, hipline::skeleton::Side::Left, 0)),
        "{names:?}"
    );
    assert!(
        names.contains(&(0, hipline::skeleton::Side::Left, 0)),
        "{names:?}"
    );
}
