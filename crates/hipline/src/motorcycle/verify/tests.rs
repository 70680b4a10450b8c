//! Each breach of a law is seen.

use super::{GraphViolation, GraphViolations};
use crate::{
    Figure, Polygon,
    motorcycle::{End, Launch, MotorcycleGraph, Origin},
    topology::{EdgeId, MeetingId, MotorcycleId, VertexId, WallId},
};

type Wall = [[f64; 2]; 2];

/// The first goes to the right, the second up across its way, later; the third far off.
fn launches() -> Vec<Launch> {
    vec![
        Launch::new([0., 0.], [1., 0.]),
        Launch::new([3., -4.], [0., 1.]),
        Launch::new([0., 20.], [1., 1.]),
    ]
}

fn first(result: Result<(), GraphViolations>) -> GraphViolation {
    result.expect_err("a breach").list[0]
}

/// What is said of the graph of the launches and walls after a change.
fn changed(walls: &[Wall], change: impl FnOnce(&mut MotorcycleGraph)) -> GraphViolation {
    let mut graph = MotorcycleGraph::new(&launches(), walls).expect("valid");
    assert_eq!(graph.verify_launches(&launches(), walls), Ok(()));
    change(&mut graph);
    first(graph.verify_launches(&launches(), walls))
}

fn id(who: usize) -> MotorcycleId {
    MotorcycleId::new(who)
}

#[test]
fn who_does_not_stop_at_a_track_is_seen() {
    let alone = MotorcycleGraph::new(&launches()[1..2], &[]).expect("valid");
    let said = changed(&[], |graph| graph.motorcycles[1] = alone.motorcycles[0]);
    let at = End::Track(id(0));
    assert_eq!(
        said,
        GraphViolation::GoesOn {
            motorcycle: id(1),
            at
        }
    );
}

#[test]
fn who_does_not_stop_at_a_wall_is_seen() {
    // Nobody stops at a track here.
    let (one, wall) = (&launches()[..1], [[[2., -1.], [2., 1.]]]);
    let free = MotorcycleGraph::new(one, &[]).expect("valid");
    let at = End::Wall(WallId::new(0));
    assert_eq!(
        first(free.verify_launches(one, &wall)),
        GraphViolation::GoesOn {
            motorcycle: id(0),
            at
        }
    );
}

#[test]
fn who_stops_at_a_track_that_is_not_there_is_seen() {
    let wall = [[[2., -1.], [2., 1.]]];
    let free = MotorcycleGraph::new(&launches(), &[]).expect("valid");
    let said = changed(&wall, |graph| graph.motorcycles[1] = free.motorcycles[1]);
    assert_eq!(
        said,
        GraphViolation::WrongEnd {
            motorcycle: id(1),
            by: None
        }
    );
}

#[test]
fn who_stops_at_a_wall_that_is_not_there_is_seen() {
    let (wall, short) = ([[[2., -1.], [2., 1.]]], [[[2., 1.], [2., 3.]]]);
    let stopped = MotorcycleGraph::new(&launches(), &wall).expect("valid");
    let said = changed(&short, |graph| {
        graph.motorcycles[0] = stopped.motorcycles[0];
        graph.motorcycles[1] = stopped.motorcycles[1];
    });
    assert_eq!(
        said,
        GraphViolation::WrongEnd {
            motorcycle: id(0),
            by: None
        }
    );
}

#[test]
fn a_wrong_reason_is_seen() {
    // Two walls at one place: the lower number counts.
    let walls = [[[2., -1.], [2., 1.]], [[1., -1.], [3., 1.]]];
    let said = changed(&walls, |graph| {
        graph.motorcycles[0].end = End::Wall(WallId::new(1));
    });
    let by = Some(End::Wall(WallId::new(0)));
    assert_eq!(
        said,
        GraphViolation::WrongEnd {
            motorcycle: id(0),
            by
        }
    );
    let said = changed(&[], |graph| graph.motorcycles[1].end = End::Track(id(2)));
    assert!(matches!(
        said,
        GraphViolation::NotRounded { .. } | GraphViolation::NoWay { .. }
    ));
}

#[test]
fn numbers_that_are_off_by_one_digit_are_seen() {
    let not_rounded = GraphViolation::NotRounded { motorcycle: id(1) };
    let next = |x: &mut f64| *x = x.next_up();
    type Change = fn(&mut MotorcycleGraph, fn(&mut f64));
    let changes: [Change; 6] = [
        |graph, next| next(&mut graph.motorcycles[1].start.x),
        |graph, next| next(&mut graph.motorcycles[1].start.time),
        |graph, next| next(&mut graph.motorcycles[1].velocity[1]),
        |graph, next| {
            graph.motorcycles[1]
                .stop
                .iter_mut()
                .for_each(|s| next(&mut s.x))
        },
        |graph, next| {
            graph.motorcycles[1]
                .stop
                .iter_mut()
                .for_each(|s| next(&mut s.y))
        },
        |graph, next| {
            graph.motorcycles[1]
                .stop
                .iter_mut()
                .for_each(|s| next(&mut s.time))
        },
    ];
    for change in changes {
        assert_eq!(changed(&[], |graph| change(graph, next)), not_rounded);
    }
}

#[test]
fn names_of_what_is_not_there_are_seen() {
    let wrong = GraphViolation::WrongStart { motorcycle: id(1) };
    for end in [
        End::Track(id(7)),
        End::Track(id(1)),
        End::Wall(WallId::new(0)),
        End::Meeting(MeetingId::new(0)),
        End::Vertex(VertexId::new(0)),
        End::Escape,
    ] {
        assert_eq!(changed(&[], |graph| graph.motorcycles[1].end = end), wrong);
    }
    let said = changed(&[], |graph| {
        graph.motorcycles.pop();
    });
    let count = GraphViolation::Count {
        found: 2,
        expected: 3,
    };
    assert_eq!(said, count);
    let graph = MotorcycleGraph::new(&launches(), &[]).expect("valid");
    assert!(graph.verify_launches(&launches()[1..], &[]).is_err());
    assert!(graph.verify_launches(&[], &[]).is_err());
}

/// Two reflex vertices whose motorcycles meet in the middle, where a third one starts.
fn figure() -> (Figure, MotorcycleGraph) {
    let ring = vec![
        [-4.5, -10.],
        [4.5, -10.],
        [2., 0.],
        [10., -2.],
        [10., 10.],
        [-10., 10.],
        [-10., -2.],
        [-2., 0.],
    ];
    let polygon = Polygon::new([ring]).expect("a polygon");
    let figure = polygon.figure().clone();
    let graph = figure.motorcycles().expect("it applies");
    (figure, graph)
}

#[test]
fn breaches_in_figures_are_seen() {
    let (figure, sound) = figure();
    assert_eq!(sound.verify(&figure), Ok(()));
    assert_eq!((sound.motorcycles.len(), sound.meetings.len()), (3, 1));
    let said = |change: &dyn Fn(&mut MotorcycleGraph)| {
        let mut graph = sound.clone();
        change(&mut graph);
        first(graph.verify(&figure))
    };
    let count = sound.motorcycles.len();
    assert!(matches!(
        said(&|graph| {
            graph.motorcycles.pop();
        }),
        GraphViolation::Count { .. } | GraphViolation::WrongMeeting { .. }
    ));
    for i in 0..count {
        let wrong = GraphViolation::WrongStart { motorcycle: id(i) };
        let swap = |graph: &mut MotorcycleGraph| {
            if let Some(between) = &mut graph.motorcycles[i].between {
                between.swap(0, 1);
            }
        };
        assert!(matches!(
            said(&swap),
            GraphViolation::WrongStart { .. } | GraphViolation::WrongMeeting { .. }
        ));
        let mut graph = sound.clone();
        graph.motorcycles[i].end = End::Escape;
        let list = graph.verify(&figure).expect_err("a breach").list;
        assert!(list.contains(&wrong), "{list:?}");
        let turn = |graph: &mut MotorcycleGraph| {
            if let End::Edge(edge, side) = graph.motorcycles[i].end {
                let other = EdgeId::new((edge.index() + 1) % 8);
                graph.motorcycles[i].end = End::Edge(other, side);
            } else {
                graph.motorcycles[i].origin = Origin::Given;
            }
        };
        assert!(!matches!(said(&turn), GraphViolation::Count { .. }));
    }
}

#[test]
fn breaches_of_meetings_are_seen() {
    // The outer corners of a cross: motorcycles of neighbours meet.
    let ring = vec![
        [0., 0.],
        [2., 0.],
        [2., -2.],
        [4., -2.],
        [4., 0.],
        [6., 0.],
        [6., 2.],
        [4., 2.],
        [4., 4.],
        [2., 4.],
        [2., 2.],
        [0., 2.],
    ];
    let polygon = Polygon::new([ring]).expect("a polygon");
    let sound = polygon.figure().motorcycles().expect("it applies");
    assert_eq!(sound.verify(polygon.figure()), Ok(()));
    assert!(!sound.meetings.is_empty());
    let wrong = GraphViolation::WrongMeeting {
        meeting: MeetingId::new(0),
    };
    let changes: [fn(&mut MotorcycleGraph); 5] = [
        |graph| {
            graph.meetings[0].members.pop();
        },
        |graph| graph.meetings[0].members.reverse(),
        |graph| graph.meetings[0].spot.time = graph.meetings[0].spot.time.next_up(),
        |graph| graph.meetings[0].spot.x = graph.meetings[0].spot.x.next_up(),
        |graph| graph.meetings[0].child = Some(MotorcycleId::new(0)),
    ];
    for change in changes {
        let mut graph = sound.clone();
        change(&mut graph);
        let list = graph.verify(polygon.figure()).expect_err("a breach").list;
        assert!(
            list.contains(&wrong) || matches!(list[0], GraphViolation::WrongStart { .. }),
            "{list:?}"
        );
    }
}
