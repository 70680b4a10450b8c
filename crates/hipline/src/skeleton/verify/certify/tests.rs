//! Tracks that are wrong on purpose: the certificate fails, and names a place.

use super::Uncertified;
use crate::{
    Figure, FigureBuilder, Options,
    engine::NotApplicable,
    motorcycle::{
        self,
        tracks::{Crash, Origin, Track, Tracks},
    },
    predicates::{Place, PlaneId},
    skeleton::{ArcKind, Region},
    topology::VertexId,
};
use hipline_num::Sign;

fn polygon(rings: &[Vec<[f64; 2]>]) -> Figure {
    let mut builder = FigureBuilder::new();
    builder.polygon(rings.to_vec());
    builder.build().expect("a valid polygon")
}

/// Two thin spikes that point at one place.
fn spikes() -> Figure {
    polygon(&[vec![
        [0.0, 0.0],
        [1.0, 0.0],
        [6.0, 4.0],
        [3.0, 0.0],
        [17.0, 0.0],
        [14.0, 4.0],
        [19.0, 0.0],
        [20.0, 0.0],
        [20.0, 20.0],
        [0.0, 20.0],
    ]])
}

fn l_shape() -> Figure {
    polygon(&[vec![
        [0.0, 0.0],
        [5.0, 0.0],
        [5.0, 7.0],
        [3.0, 7.0],
        [3.0, 3.0],
        [0.0, 4.0],
    ]])
}

#[test]
fn every_missing_piece_of_a_track_is_noticed() {
    for figure in [spikes(), l_shape()] {
        let skeleton = figure.skeleton(Options::default());
        assert_eq!(skeleton.certify(&figure), Ok(()));
        let (_, tracks) = motorcycle::induced(&figure).expect("a polygon");
        for i in 0..tracks.motorcycles.len() {
            let mut wrong = tracks.clone();
            wrong.motorcycles[i].end = Some(wrong.motorcycles[i].start);
            match skeleton.certify_by(&figure, &wrong) {
                Err(Uncertified::StrayValley { arc }) => {
                    assert_eq!(skeleton.arc(arc).kind, ArcKind::Valley);
                }
                other => panic!("track {i}: {other:?}"),
            }
        }
    }
}

#[test]
fn a_motorcycle_that_starts_at_a_meeting_counts() {
    let figure = spikes();
    let (_, mut tracks) = motorcycle::induced(&figure).expect("a polygon");
    let child = tracks.meetings[0]
        .child
        .take()
        .expect("a reflex vertex is born");
    tracks.motorcycles.truncate(child as usize);
    let found = figure
        .skeleton(Options::default())
        .certify_by(&figure, &tracks);
    assert!(
        matches!(found, Err(Uncertified::StrayValley { .. })),
        "{found:?}"
    );
}

#[test]
fn the_theorem_is_not_stretched() {
    let figure = l_shape();
    let outside = figure.skeleton(Options::default().region(Region::Exterior));
    let expected = Err(Uncertified::NotApplicable(NotApplicable::NotInterior));
    assert_eq!(outside.certify(&figure), expected);
    let mut skeleton = figure.skeleton(Options::default());
    skeleton.nodes[7].x = skeleton.nodes[7].x.next_up();
    assert!(matches!(
        skeleton.certify(&figure),
        Err(Uncertified::Unlawful(_))
    ));
}

/// Invented motorcycles on any two planes: where the roof is above one, in f64 along the arc that is named, the certificate
/// fails; where it is below at all arcs, it does not.
#[test]
fn the_roof_is_nowhere_above_a_track() {
    let figure = polygon(&[
        vec![[0.0, 0.0], [13.0, 0.0], [12.0, 12.0], [1.0, 11.0]],
        vec![[4.0, 4.0], [5.0, 8.0], [8.0, 8.0], [9.0, 4.0]],
    ]);
    let skeleton = figure.skeleton(Options::default());
    let checker = skeleton.examine(&figure);
    let planes = &checker.planes;
    let mut above = 0;
    let count = 2 * figure.edges().len() as u32;
    for (i, j) in (0..count).flat_map(|i| (0..count).map(move |j| (i, j))) {
        let pair = [i, j].map(PlaneId);
        if planes.turn(pair[0], pair[1]) != Sign::Positive {
            continue;
        }
        let at = |time: f64| Place::At { pair, time };
        let [start, end] = [at(0.0), at(3.0)];
        let tracks = Tracks {
            motorcycles: vec![Track {
                pair,
                origin: Origin::Vertex(VertexId::new(0)),
                start,
                crash: Crash::Escape,
                end: Some(end),
            }],
            meetings: Vec::new(),
        };
        // How much the roof is above the track at most, along the track, at arcs.
        let [p, q] = [start, end].map(|place| planes.round(&place));
        let mut most = f64::NEG_INFINITY;
        for arc in skeleton.arcs() {
            let [u, v] = arc.nodes.map(|n| *skeleton.node(n));
            let [dx, dy] = [q[0] - p[0], q[1] - p[1]];
            let side = |x: f64, y: f64| dx * (y - p[1]) - dy * (x - p[0]);
            let (a, b) = (side(u.x, u.y), side(v.x, v.y));
            if a * b >= 0.0 {
                continue;
            }
            let s = a / (a - b);
            let [x, y] = [u.x + s * (v.x - u.x), u.y + s * (v.y - u.y)];
            let t = ((x - p[0]) * dx + (y - p[1]) * dy) / (dx * dx + dy * dy);
            if (0.0..=1.0).contains(&t) {
                most = most.max(u.time + s * (v.time - u.time) - 3.0 * t);
            }
        }
        let found = checker.check_tracks(&tracks);
        if most > 0.01 {
            assert!(
                matches!(found, Err(Uncertified::AboveTrack { .. })),
                "{pair:?} {most}"
            );
            above += 1;
        } else if most < -0.01 {
            assert_eq!(found, Ok(()), "{pair:?} {most}");
        }
    }
    assert!(above > 0, "no track is below the roof");
}
