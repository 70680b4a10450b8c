//! Two skeletons in sequence: what happens after a change of speed is the skeleton of the wavefront
//! at that moment, with the speeds from then on.
//!
//! The level set at the time of the change is the offset of a figure whose speeds never change. It
//! has exact coordinates where all edges are parallel to the axes, or all turned into the
//! direction (3, 4), and all numbers are multiples of small powers of two. Its own skeleton must be, arc for
//! arc, what the skeleton of the figure with changes is above that time: late starts (speeds of zero up to
//! the change) and profiles.

mod common;

use std::collections::BTreeMap;

use common::count;
use hipline::input::{Change, Place, Sides};
use hipline::skeleton::{ArcKind, Face, Side};
use hipline::{Figure, FigureBuilder, Options, Region, Skeleton};
use hipline_testkit::agreement::{Drawn, End, drawn};
use hipline_testkit::case::{Case, Part};
use hipline_testkit::generate::{Kind, Random, small_of};
use hipline_testkit::hunt::overruns_at_zero;

/// What an edge is called in both figures: edge and side.
type Name = (usize, Side);

/// Speeds before and after the change; equal ones before are equal after.
#[derive(Debug)]
struct Course {
    time: f64,
    speeds: Vec<[f64; 2]>,
}

/// Chooses speeds for all edges.
fn late(random: &mut Random) -> Course {
    Course {
        time: time(random),
        speeds: vec![
            [0.0, *random.pick(&[1.0, 2.0, 0.5])],
            [1.0, 1.0],
            [1.0, 1.0],
        ],
    }
}

fn profile(random: &mut Random) -> Course {
    let mut speeds = vec![[1.0; 2], [2.0, 2.0], [0.5, 0.5]];
    let choices = [0.5, 1.0, 1.0, 2.0, 4.0, 0.0, 3.0];
    for pair in &mut speeds {
        pair[1] = *random.pick(&choices);
    }
    if random.one_in(3) {
        speeds.truncate(1);
    }
    Course {
        time: time(random),
        speeds,
    }
}

/// Times at which little happens on a grid; but what counts is checked.
fn time(random: &mut Random) -> f64 {
    *random.pick(&[0.125, 0.375, 0.25, 0.625, 0.875, 1.125, 1.375])
}

/// Speeds of the edges, one choice for each; the changes go to `late` ones only.
fn with_speeds(case: &Case, course: &Course, chosen: &[usize], changing: bool) -> Case {
    let mut case = case.clone();
    let places = case.places();
    for part in &mut case.parts {
        if let Part::Polygon { rings, speeds } = part {
            *speeds = rings.iter().map(|ring| vec![1.0; ring.len()]).collect();
        }
    }
    for (&place, &choice) in places.iter().zip(chosen) {
        let Place { part, ring, index } = place;
        let [before, after] = course.speeds[choice];
        let edges = case.edges(part, ring);
        match &mut case.parts[part] {
            Part::Polygon { speeds, .. } => speeds[ring][index] = before,
            Part::Line { speeds, .. } | Part::Graph { speeds, .. } => {
                speeds.resize(edges, [1.0; 2]);
                speeds[index] = [before; 2];
            }
        }
        if changing {
            case.changes.push(Change {
                edge: place,
                sides: Sides::Both,
                time: course.time,
                speed: after,
            });
        }
    }
    case
}

/// Turned into the direction (3, 4) and five times as large.
fn pythagorean(case: &mut Case) {
    let points = case.parts.iter_mut().flat_map(Part::points_mut);
    points.for_each(|p| *p = [3.0 * p[0] - 4.0 * p[1], 4.0 * p[0] + 3.0 * p[1]]);
}

/// An edge of the level set: where it starts, what it is called, its speed from then on, and whether
/// that is a new one.
#[derive(Debug, Clone, Copy)]
struct Step {
    from: [f64; 2],
    name: Name,
    speed: f64,
    changed: bool,
}

/// The speed after the change of the edge that a face belongs to.
fn after(figure: &Figure, face: &Face) -> [f64; 2] {
    let edge = figure.edges()[face.edge.index()];
    let last = |right: bool| {
        let change = figure.changes_of(face.edge, right).last();
        change.map_or(edge.speeds[usize::from(right)], |change| change.speed)
    };
    let [left, right] = edge.speeds;
    match face.side {
        Side::Left => [left, last(false)],
        Side::Right => [right, last(true)],
        Side::Start | Side::End => [left.max(right), last(false).max(last(true))],
    }
}

/// The loops of a level set, pieces of edges that go on as one and change together joined, and what
/// has no exact coordinates refused.
fn level_set(
    figure: &Figure,
    below: &Skeleton,
    constant: &Figure,
    time: f64,
) -> Option<Vec<Vec<Step>>> {
    let happens = |at: f64| at.total_cmp(&time).is_eq();
    if below.nodes().iter().any(|node| happens(node.time)) {
        return None;
    }
    let offset = below.offset(constant, time).expect("a good time");
    let mut loops = Vec::new();
    for part in offset.loops() {
        // A rational number of small denominator this close to a multiple of 1/1024 is one.
        let exact = |x: &f64| (x * 1024.0).fract() == 0.0;
        if !part.points().iter().flatten().all(exact) {
            return None;
        }
        let mut steps: Vec<Step> = Vec::new();
        for (&from, &face) in part.points().iter().zip(part.faces()) {
            let face = below.face(face);
            let [before, after] = after(figure, face);
            steps.push(Step {
                from,
                name: (face.edge.index(), face.side),
                speed: after,
                changed: before.total_cmp(&after).is_ne(),
            });
        }
        loops.push(joined(steps));
    }
    Some(loops)
}

/// Neighbours on one line are one, if their speed changes.
fn joined(mut steps: Vec<Step>) -> Vec<Step> {
    let is_straight = |steps: &[Step], i: usize| {
        let count = steps.len();
        let [a, b, c] = [i + count - 1, i, i + 1].map(|k| steps[k % count].from);
        let cross = (b[0] - a[0]) * (c[1] - b[1]) - (b[1] - a[1]) * (c[0] - b[0]);
        cross == 0.0 && steps[i].changed
    };
    let mut i = 0;
    while i < steps.len() {
        if is_straight(&steps, i) {
            let before = (i + steps.len() - 1) % steps.len();
            steps[before].name = steps[before].name.min(steps[i].name);
            steps.remove(i);
            i = 0;
        } else {
            i += 1;
        }
    }
    steps
}

/// The skeletons of the parts of the plane that a level set leaves: their arcs, named and timed as those
/// of the whole.
fn upper(
    loops: &[Vec<Step>],
    below: &Skeleton,
    constant: &Figure,
    time: f64,
) -> Option<Vec<Drawn>> {
    let offset = below.offset(constant, time).expect("a good time");
    let mut arcs = Vec::new();
    for part in offset.parts() {
        let mut builder = FigureBuilder::new();
        let rings: Vec<&Vec<Step>> = part
            .shell
            .iter()
            .chain(&part.holes)
            .map(|&l| &loops[l])
            .collect();
        let points = |ring: &Vec<Step>| ring.iter().map(|step| step.from).collect::<Vec<_>>();
        let speeds = |ring: &Vec<Step>| ring.iter().map(|step| step.speed).collect::<Vec<_>>();
        let mut names: BTreeMap<(u32, u32, u32), (Name, bool)> = BTreeMap::new();
        for (r, ring) in rings.iter().enumerate() {
            for (s, step) in ring.iter().enumerate() {
                let (r, s) = (r as u32, s as u32);
                let place = if part.shell.is_some() {
                    (0, r, s)
                } else {
                    (r, 0, s)
                };
                names.insert(place, (step.name, step.changed));
            }
        }
        if part.shell.is_none() && below.region() == Region::Interior {
            // All around stands still for ever: offsets take that for unbounded.
            return None;
        }
        let region = if part.shell.is_some() {
            builder.weighted_polygon(
                rings.iter().map(|ring| points(ring)).collect(),
                rings.iter().map(|ring| speeds(ring)).collect(),
            );
            Region::Interior
        } else {
            for ring in &rings {
                builder.weighted_polygon(vec![points(ring)], vec![speeds(ring)]);
            }
            Region::Exterior
        };
        // A loop that touches itself is no polygon.
        let figure = builder.build().ok()?;
        let skeleton = figure.skeleton(Options::default().region(region));
        if !overruns_at_zero(&skeleton) {
            assert_eq!(skeleton.verify(&figure), Ok(()), "the upper part");
        }
        for arc in drawn(&skeleton) {
            let [f, g] = arc.faces.map(|(edge, ..)| {
                let source = figure.edges()[edge].source;
                names[&(source.part, source.ring, source.edge)]
            });
            // Pieces of a face that does not change are no different faces.
            let one = f.0 == g.0 && !f.1 && arc.kind() == ArcKind::Ghost;
            if !one && arc.ends[1].time() > 0.0 {
                let faces = [f.0, g.0].map(|(edge, side)| (edge, side, 0));
                let ends = arc
                    .ends
                    .map(|end| End::new(end.place(), end.time() + time, end.direction()));
                arcs.push(Drawn::new(ends, faces, arc.kind()));
            }
        }
    }
    Some(arcs)
}

/// Are two times equal but for the rounding of their difference to the change?
fn near(a: f64, b: f64) -> bool {
    a.total_cmp(&b).is_eq() || (a - b).abs() <= 4.0 * f64::EPSILON * a.abs()
}

/// Is an arc of the whole, above the change, that of the upper part?
fn same(whole: &Drawn, part: &Drawn, time: f64) -> bool {
    let name = |(edge, side, _)| (edge, side);
    let place = |end: &End| End::new(end.place(), 0.0, end.direction());
    let at_end = |a: &End, b: &End| place(a) == place(b) && near(a.time(), b.time());
    let starts_below = whole.ends[0].time() < time;
    whole.faces.map(name) == part.faces.map(name)
        && whole.kind() == part.kind()
        && if whole.ends[1].time().is_infinite() {
            // A node at infinity is at the place of its arc's other end.
            whole.ends[1].direction() == part.ends[1].direction()
        } else {
            at_end(&whole.ends[1], &part.ends[1])
        }
        && if starts_below {
            near(part.ends[0].time(), time)
        } else {
            at_end(&whole.ends[0], &part.ends[0])
        }
}

/// How the two differ, if they can be compared.
fn differ(case: &Case, course: &Course, random: &mut Random) -> Option<Result<usize, String>> {
    let chosen: Vec<usize> = case
        .places()
        .iter()
        .map(|_| random.below(course.speeds.len()))
        .collect();
    let [constant, changing] =
        [false, true].map(|changing| with_speeds(case, course, &chosen, changing));
    let text = changing.to_text();
    let [constant, figure] = [constant, changing].map(|case| case.figure().expect("a figure"));
    let options = Options::default().region(case.region);
    let below = constant.skeleton(options);
    let loops = level_set(&figure, &below, &constant, course.time)?;
    let mut due = upper(&loops, &below, &constant, course.time)?;
    let whole = figure.skeleton(options);
    if !overruns_at_zero(&whole)
        && let Err(violations) = whole.verify(&figure)
    {
        return Some(Err(format!("{violations}\n{text}")));
    }
    let above = drawn(&whole)
        .into_iter()
        .filter(|arc| arc.ends[1].time() > course.time);
    let mut compared = 0;
    for arc in above {
        let Some(found) = due.iter().position(|part| same(&arc, part, course.time)) else {
            return Some(Err(format!(
                "nothing like {arc}\namong {}\n{text}",
                list(&due)
            )));
        };
        due.swap_remove(found);
        compared += 1;
    }
    if due.is_empty() {
        Some(Ok(compared))
    } else {
        Some(Err(format!("missing {}\n{text}", list(&due))))
    }
}

fn list(arcs: &[Drawn]) -> String {
    let texts: Vec<String> = arcs.iter().map(ToString::to_string).collect();
    texts.join("\n      ")
}

/// Compares random figures; so many at least, with so many arcs, must be comparable.
fn check(kinds: &[Kind], regions: &[Region], course: fn(&mut Random) -> Course, seeds: usize) {
    let (mut figures, mut arcs, mut wrong) = (0, 0_usize, Vec::new());
    for seed in 0..seeds {
        let random = &mut Random::new(seed as u64 ^ 0x5e9e_11ce);
        let mut case = small_of(*random.pick(kinds), random.next());
        case.region = *random.pick(regions);
        if random.one_in(3) {
            pythagorean(&mut case);
        }
        let course = course(random);
        match differ(&case, &course, random) {
            None => {}
            Some(Ok(compared)) => {
                figures += 1;
                arcs += compared;
            }
            Some(Err(how)) => wrong.push(format!("seed {seed}: {how}")),
        }
    }
    println!("{figures} figures of {seeds}, {arcs} arcs");
    assert!(
        wrong.is_empty(),
        "{} wrong\n{}",
        wrong.len(),
        wrong[..wrong.len().min(3)].join("\n")
    );
    assert!(
        figures > seeds / 3,
        "only {figures} of {seeds} can be compared"
    );
    assert!(arcs > 4 * figures, "only {arcs} arcs");
}

#[test]
fn late_starts_go_on_as_the_shrunken_figure() {
    check(
        &[Kind::Polyomino],
        &[Region::Interior],
        late,
        count(2000, 100) as usize,
    );
}

#[test]
fn profiles_are_two_skeletons_in_sequence() {
    check(
        &[Kind::Polyomino],
        &[Region::Interior, Region::Exterior],
        profile,
        count(2000, 100) as usize,
    );
}

#[test]
fn profiles_of_graphs_are_two_skeletons_in_sequence() {
    check(
        &[Kind::Windows],
        &[Region::Both],
        profile,
        count(2000, 100) as usize,
    );
}
