//! Agreement with the nodes that another exact program found on inputs from the field.
//!
//! The folder `shared/data` lies beside the repository where it is there at all; `HIPLINE_DATA`
//! names another place.
//!
//! Nodes agree if they differ by a ten-millionth of the figure's size at most. The other
//! program's numbers are rounded on the way, so where planes are nearly parallel it may be off
//! by more. A difference is accepted only with a certificate, which does not come from
//! comparing the two programs:
//!
//! * the skeleton found here passes [`Skeleton::verify`], so its nodes lie on their planes; and
//! * each node that differs either is ill-conditioned: moving all input coordinates to
//!   neighbouring numbers moves our own node by a tenth of the difference or more; or the
//!   expected node lies on fewer than three planes of the figure, and so cannot be a node.
//!
//! `HIPLINE_ONLY` names a part of an id; only such cases are compared then.

mod field_support;

use std::collections::{BTreeMap, BTreeSet};
use std::sync::atomic::{AtomicUsize, Ordering};
use std::thread;

use field_support::builder;
use hipline::{
    Figure, Options, Region, Skeleton,
    skeleton::{ArcKind, NodeKind},
};
use hipline_testkit::data;
use serde_json::Value;

/// The figure of a feature.
fn figure(feature: &Value) -> Option<Figure> {
    builder(feature)?.build().ok()
}

fn whole_plane(figure: &Figure) -> Skeleton {
    figure.skeleton(Options::default().region(Region::Both))
}

type Place = [f64; 3];

/// The nodes with time above zero: x, y, time.
fn events(skeleton: &Skeleton) -> Vec<Place> {
    let nodes = skeleton.nodes().iter();
    nodes
        .filter(|n| matches!(n.kind, NodeKind::Event) && n.time > 0.0)
        .map(|n| [n.x, n.y, n.time])
        .collect()
}

fn distance(a: &Place, b: &Place) -> f64 {
    (0..3).map(|k| (a[k] - b[k]).abs()).fold(0.0, f64::max)
}

/// The distance to the nearest of some places.
fn nearest<'a>(p: &Place, places: &'a [Place]) -> (f64, Option<&'a Place>) {
    let with = places.iter().map(|q| (distance(p, q), Some(q)));
    with.min_by(|a, b| a.0.total_cmp(&b.0))
        .unwrap_or((f64::INFINITY, None))
}

fn size(figure: &Figure) -> f64 {
    figure
        .vertices()
        .iter()
        .fold(0.0, |s, v| v[0].abs().max(v[1].abs()).max(s))
}

/// Expected nodes that are missing, and nodes that are not expected.
fn differences(figure: &Figure, skeleton: &Skeleton, theirs: &[Place]) -> [Vec<Place>; 2] {
    let size = size(figure);
    let tolerance = |p: &Place| 1e-7 * (size + p.iter().map(|x| x.abs()).sum::<f64>());
    let mine = events(skeleton);
    let unlike = |these: &[Place], those: &[Place]| -> Vec<Place> {
        let alone = |p: &&Place| nearest(p, those).0 > tolerance(p);
        these.iter().filter(alone).copied().collect()
    };
    // Ghost arcs end in nodes of their own here, which the other program does not have.
    let ghosts = skeleton
        .arcs()
        .iter()
        .filter(|arc| arc.kind == ArcKind::Ghost);
    let ends: BTreeSet<_> = ghosts
        .map(|arc| skeleton.node(arc.nodes[1]))
        .map(|n| [n.x, n.y, n.time].map(f64::to_bits))
        .collect();
    let mut extra = unlike(&mine, theirs);
    extra.retain(|p| !ends.contains(&p.map(f64::to_bits)));
    [unlike(theirs, &mine), extra]
}

/// The feature with every coordinate moved to a neighbouring f64; the trial's number chooses the
/// directions, the same for equal coordinates of equal points, so that rings stay closed.
fn shaken(feature: &Value, trial: u64) -> Value {
    fn shake(value: &mut Value, trial: u64) {
        let point = [&value[0], &value[1]].map(Value::as_f64);
        let Some(list) = value.as_array_mut() else {
            return;
        };
        let [Some(x), Some(y)] = point else {
            list.iter_mut().for_each(|value| shake(value, trial));
            return;
        };
        let mut bits = trial;
        for word in [x.to_bits(), y.to_bits()] {
            bits = (bits ^ word).wrapping_mul(0x9e37_79b9_7f4a_7c15);
            bits ^= bits >> 29;
        }
        let step = |x: f64, way: u64| match way % 3 {
            0 => x.next_up(),
            1 => x.next_down(),
            _ => x,
        };
        *value = Value::from(vec![step(x, bits >> 7), step(y, bits >> 33)]);
    }
    let mut feature = feature.clone();
    shake(&mut feature["geometry"]["coordinates"], trial);
    feature
}

/// How far our own nodes around a place move when the input moves by one unit in the last place:
/// by how much the distance to the nearest one changes.
fn sways(place: &Place, mine: &[Place], shaken: &[Vec<Place>]) -> f64 {
    let before = nearest(place, mine).0;
    let moves = shaken
        .iter()
        .map(|nodes| (nearest(place, nodes).0 - before).abs());
    moves.filter(|by| by.is_finite()).fold(0.0, f64::max)
}

/// On how many planes of the figure a place lies, up to ten times what it costs to round the place
/// (three halves of 2^-53) and to compute the distance (less than six times 2^-53).
fn planes_through(figure: &Figure, place: &Place) -> usize {
    let [x, y, time] = *place;
    let slack = 1e-14 * (size(figure) + x.abs() + y.abs() + time);
    let mut degree = vec![0; figure.vertices().len()];
    for edge in figure.edges() {
        degree[edge.from.index()] += 1;
        degree[edge.to.index()] += 1;
    }
    let mut count = 0;
    for edge in figure.edges() {
        let [p, q] = [edge.from, edge.to].map(|v| figure.vertices()[v.index()]);
        let (dx, dy) = (q[0] - p[0], q[1] - p[1]);
        let length = dx.hypot(dy);
        let ahead = (dx * (y - p[1]) - dy * (x - p[0])) / length;
        let along = (dx * (x - p[0]) + dy * (y - p[1])) / length;
        let on = |distance: f64, speed: f64| usize::from((distance - speed * time).abs() <= slack);
        count += on(ahead, edge.speeds[0]) + on(-ahead, edge.speeds[1]);
        let fastest = edge.speeds[0].max(edge.speeds[1]);
        if degree[edge.from.index()] == 1 {
            count += on(-along, fastest);
        }
        if degree[edge.to.index()] == 1 {
            count += on(along - length, fastest);
        }
    }
    count
}

/// What comparing one case says.
enum Outcome {
    Agrees,
    /// It differs where the other program's numbers cannot be right, or are ill-conditioned.
    Certified,
    Differs(String),
}

/// Where edges nearly touch, not everything that is shaken is a figure.
const TRIALS: u64 = 400;
const ENOUGH: usize = 12;

fn judge(feature: &Value, figure: &Figure, theirs: &[Place]) -> Outcome {
    let Ok(skeleton) = std::panic::catch_unwind(|| whole_plane(figure)) else {
        return Outcome::Differs("a panic".to_owned());
    };
    let [missing, extra] = differences(figure, &skeleton, theirs);
    if missing.is_empty() && extra.is_empty() {
        return Outcome::Agrees;
    }
    if let Err(violations) = skeleton.verify(figure) {
        return Outcome::Differs(format!("not verified: {violations}"));
    }
    let mine = events(&skeleton);
    let trials = (1..=TRIALS).filter_map(|trial| self::figure(&shaken(feature, trial)));
    let trials = trials.take(ENOUGH);
    let shaken: Vec<Vec<Place>> = trials.map(|figure| events(&whole_plane(&figure))).collect();
    for p in &missing {
        let (by, ours) = nearest(p, &mine);
        let around = |place: &Place| sways(place, &mine, &shaken);
        let sway = around(p).max(ours.map_or(0.0, around));
        let on = planes_through(figure, p);
        if sway < by / 10.0 && on >= 3 {
            return Outcome::Differs(format!(
                "{p:?}, on {on} planes, is missing; the next node is {by:e} away and sways by {sway:e}"
            ));
        }
    }
    // What was certified above to be no node may stand for one of ours.
    let impossible = missing
        .iter()
        .filter(|p| planes_through(figure, p) < 3)
        .count();
    let mut unexplained = 0;
    for p in &extra {
        let by = nearest(p, theirs).0;
        let sway = sways(p, &mine, &shaken);
        if sway < by / 10.0 {
            unexplained += 1;
            if unexplained > impossible {
                return Outcome::Differs(format!(
                    "{p:?} is {by:e} from any other, sways by {sway:e}"
                ));
            }
        }
    }
    Outcome::Certified
}

/// One case: its id, the input, the nodes that the other program found.
struct Case {
    id: String,
    feature: Value,
    expected: Vec<Place>,
}

fn cases(folder: &std::path::Path) -> Vec<Case> {
    let only = std::env::var("HIPLINE_ONLY").unwrap_or_default();
    let mut cases = Vec::new();
    for path in data::files(&folder.join("expected"), "jsonl") {
        let stem = path.file_stem().and_then(|s| s.to_str()).expect("a name");
        let mut expected = BTreeMap::new();
        for line in std::fs::read_to_string(&path).expect("text").lines() {
            let value: Value = serde_json::from_str(line).expect("JSON");
            expected.insert(value["id"].as_str().expect("an id").to_owned(), value);
        }
        let text = std::fs::read_to_string(folder.join(format!("{stem}.geojson"))).expect("text");
        let mut collection: Value = serde_json::from_str(&text).expect("JSON");
        for feature in collection["features"].as_array_mut().expect("features") {
            let id = feature["properties"]["id"]
                .as_str()
                .expect("an id")
                .to_owned();
            if let Some(expected) = expected.get(&id)
                && id.contains(&only)
            {
                let nodes = expected["nodes"].as_array().expect("nodes").iter();
                let place = |n: &Value| [0, 1, 2].map(|k| n[k].as_f64().expect("a number"));
                let expected = nodes.map(place).collect();
                cases.push(Case {
                    id,
                    feature: feature.take(),
                    expected,
                });
            }
        }
    }
    cases
}

#[test]
fn nodes_are_those_of_another_exact_program() {
    let Some(folder) = data::folder() else {
        return;
    };
    let cases = cases(&folder);
    let next = AtomicUsize::new(0);
    let work = || {
        let mut found = Vec::new();
        while let Some(case) = cases.get(next.fetch_add(1, Ordering::Relaxed)) {
            if let Some(figure) = figure(&case.feature) {
                found.push((&case.id, judge(&case.feature, &figure, &case.expected)));
            }
        }
        found
    };
    let threads = thread::available_parallelism().map_or(1, |n| n.get());
    let mut outcomes: Vec<(&String, Outcome)> = thread::scope(|scope| {
        let running: Vec<_> = (0..threads).map(|_| scope.spawn(work)).collect();
        running
            .into_iter()
            .flat_map(|thread| thread.join().expect("panics are caught"))
            .collect()
    });
    outcomes.sort_by_key(|(id, _)| *id);
    let (mut certified, mut failures) = (Vec::new(), Vec::new());
    for (id, outcome) in &outcomes {
        match outcome {
            Outcome::Agrees => {}
            Outcome::Certified => certified.push(id.as_str()),
            Outcome::Differs(how) => failures.push(format!("{id}: {how}")),
        }
    }
    println!(
        "{} cases compared, {} accepted with a certificate:",
        outcomes.len(),
        certified.len()
    );
    println!("{}", certified.join("\n"));
    let shown = failures[..failures.len().min(60)].join("\n");
    assert!(
        failures.is_empty(),
        "{} of {} cases differ\n{shown}",
        failures.len(),
        outcomes.len()
    );
}
