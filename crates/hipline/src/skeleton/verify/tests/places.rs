//! Nodes and arcs that are not where they say.

use super::*;

#[test]
fn nodes_must_be_on_all_planes() {
    // The rectangle's ridge is contracted: its four planes do not meet in a point.
    let figure = polygon(&[rectangle()]);
    let found = after(&figure, Region::Interior, |s| {
        let ridge = s
            .arcs
            .iter()
            .position(|arc| arc.nodes.iter().all(|n| n.index() >= 4))
            .expect("a ridge");
        let [p, q] = s.arcs.swap_remove(ridge).nodes.map(NodeId::index);
        let (kept, gone) = (p.min(q), p.max(q));
        identify(s, kept, gone);
        let mut c = 0;
        while c + 1 < s.corners.len() {
            let same_cycle = !s.cycles.contains(&(c as u32 + 1));
            if same_cycle && s.corners[c] == s.corners[c + 1] {
                drop_corner(s, c);
            } else {
                c += 1;
            }
        }
    });
    assert_found!(found, Violation::OffPlane { .. });
    // Without its ghost arc the foot of one is not determined.
    let found = after(
        &polygon(&[STRAIGHT_VERTICES.to_vec()]),
        Region::Interior,
        |s| {
            for arc in &mut s.arcs {
                if arc.kind == ArcKind::Ghost {
                    arc.kind = ArcKind::Ridge;
                }
            }
        },
    );
    assert_found!(found, Violation::Undetermined { .. });
}

#[test]
fn nodes_must_not_be_taken_for_one() {
    // Two events of a star that have no neighbour in common.
    let figure = polygon(&[star(17, 3)]);
    let found = after(&figure, Region::Interior, |s| {
        let faces = |n: usize| -> Vec<FaceId> {
            s.arcs
                .iter()
                .filter(|arc| arc.nodes.contains(&NodeId::new(n)))
                .flat_map(|arc| arc.faces)
                .collect()
        };
        let first = s.input.vertices;
        let gone = (first + 1..s.nodes.len())
            .find(|&n| faces(n).iter().all(|f| !faces(first).contains(f)))
            .expect("a node that is far");
        identify(s, first, gone);
    });
    assert_found!(found.clone(), Violation::OffPlane { .. });
    assert_found!(found.clone(), Violation::Unordered { .. });
    assert_found!(found.clone(), Violation::Euler { .. });
    assert_found!(found, Violation::Count { .. });
}

#[test]
fn rounding_is_checked_to_the_last_bit() {
    let figure = polygon(&[star(17, 3)]);
    let last = |s: &Skeleton| {
        s.nodes
            .iter()
            .rposition(|node| node.kind == NodeKind::Event)
            .expect("an event")
    };
    assert_found!(
        after(&figure, Region::Both, |s| {
            let i = last(s);
            s.nodes[i].x = s.nodes[i].x.next_up();
        }),
        Violation::NotRounded { .. }
    );
    assert_found!(
        after(&figure, Region::Both, |s| {
            for node in &mut s.nodes {
                if let NodeKind::Infinite { direction } = &mut node.kind {
                    direction[0] = direction[0].next_up();
                }
            }
        }),
        Violation::WrongDirection { .. }
    );
}

#[test]
fn arcs_of_no_length_are_found() {
    // The centre of a square, split into two nodes with an arc of length zero.
    let found = after(&polygon(&[square()]), Region::Interior, |s| {
        let [centre, twin] = [4, 5].map(NodeId::new);
        s.nodes.push(s.nodes[4]);
        // The arcs of vertices 1 and 2 end in the twin; faces 0 and 2 get one more corner.
        for arc in &mut s.arcs {
            if [1, 2].contains(&arc.nodes[0].index()) {
                arc.nodes[1] = twin;
            }
        }
        let id = |i: usize| NodeId::new(i);
        s.corners = vec![
            id(0),
            id(1),
            twin,
            centre, //
            id(1),
            id(2),
            twin, //
            id(2),
            id(3),
            centre,
            twin, //
            id(3),
            id(0),
            centre,
        ];
        s.cycles = vec![0, 4, 7, 11, 14];
        s.arcs.push(Arc {
            nodes: [centre, twin],
            faces: [2, 0].map(FaceId::new),
            kind: ArcKind::Ridge,
        });
    });
    assert_found!(found, Violation::NoLength { arc: _ });
}

#[test]
fn kinds_and_starts_of_arcs_are_checked() {
    let figure = polygon(&[star(17, 3)]);
    let inner = |s: &Skeleton| {
        s.arcs
            .iter()
            .position(|arc| s.node(arc.nodes[0]).kind == NodeKind::Event)
            .expect("an inner arc")
    };
    let found = after(&figure, Region::Interior, |s| {
        let a = inner(s);
        s.arcs[a].kind = ArcKind::Valley;
    });
    assert_found!(found.clone(), Violation::WrongKind { .. });
    assert_found!(found.clone(), Violation::WrongProgress { .. });
    assert_found!(found, Violation::ValleyFromNothing { .. });
    // All arcs between events turned over.
    let found = after(&figure, Region::Interior, |s| {
        let vertices = s.input.vertices;
        for arc in &mut s.arcs {
            if arc.nodes[0].index() >= vertices {
                arc.nodes.swap(0, 1);
                arc.faces.swap(0, 1);
            }
        }
    });
    assert_found!(found.clone(), Violation::NotLater { .. });
    assert_found!(found, Violation::LocalMinimum { .. });
}
