//! Skeletons of chains against the kinetic engine on lines whose ends are prolonged far beyond anything that
//! happens: what is finite must be the same, arc for arc and bit for bit, and what goes to infinity must start alike.

use hipline::offset::InvalidOffset;
use hipline::skeleton::Side;
use hipline::{Chain, Engine, InvalidChain, Options, Skeleton};
use hipline_testkit::Case;
use hipline_testkit::agreement::{Drawn, drawn};
use hipline_testkit::case::Part;
use hipline_testkit::generate::chain_small;

/// The ends are prolonged to this many times the length of their edges.
const FAR: f64 = (1_u64 << 40) as f64;

/// What happens later than this is the doing of the far ends.
const LATE: f64 = (1_u64 << 30) as f64;

/// The same line with its ends far away.
fn prolonged(case: &Case) -> Case {
    let mut case = case.clone();
    let [Part::Line { points, .. }] = &mut case.parts[..] else {
        panic!("a line")
    };
    let n = points.len();
    let beyond = |p: [f64; 2], q: [f64; 2]| [0, 1].map(|k| p[k] + FAR * (q[k] - p[k]));
    (points[0], points[n - 1]) = (
        beyond(points[1], points[0]),
        beyond(points[n - 2], points[n - 1]),
    );
    case
}

/// Whether an arc is traced early, at least at first, and starts inside of the chain.
fn is_early(arc: &Drawn) -> bool {
    arc.ends[0].time() < LATE && arc.ends[0].place().iter().all(|x| x.abs() < LATE)
}

/// The arcs between faces of one side; those that go on for ever, or nearly, without their ends.
fn arcs_of(skeleton: &Skeleton, side: Side) -> (Vec<Drawn>, Vec<String>) {
    let mut whole = Vec::new();
    let mut open = Vec::new();
    for arc in drawn(skeleton) {
        if !arc.faces.iter().all(|face| face.1 == side) || !is_early(&arc) {
            continue;
        }
        let [from, to] = arc.ends;
        if to.time() < LATE && to.place().iter().all(|x| x.abs() < LATE) {
            whole.push(arc);
        } else {
            let place = from.place().map(|x| x + 0.0);
            open.push(format!(
                "{:?} {place:?} {:?} {:?}",
                arc.kind(),
                from.time(),
                arc.faces
            ));
        }
    }
    whole.sort_unstable();
    open.sort();
    (whole, open)
}

#[test]
fn agrees_with_lines_prolonged() {
    let count: u64 = if cfg!(debug_assertions) { 200 } else { 20_000 };
    let count = std::env::var("HIPLINE_CASES").map_or(count, |n| n.parse().expect("a number"));
    let (mut compared, mut vanishing, mut unbounded) = (0, 0, 0);
    for seed in 0..count {
        let case = chain_small(seed);
        let text = case.to_text();
        let figure = case.figure().expect("a line");
        let far = prolonged(&case).figure().expect("a longer line");
        let expected = far
            .skeleton_by(Engine::Kinetic, Options::default())
            .expect("applies to everything");
        let chain = Chain::new(&figure).unwrap_or_else(|error| panic!("{text}{error}"));
        for side in [Side::Left, Side::Right] {
            let skeleton = match chain.skeleton(side) {
                Ok(skeleton) => skeleton,
                Err(InvalidChain::RayVanishes { .. }) => {
                    vanishing += 1;
                    continue;
                }
                Err(error) => panic!("{text}{error}"),
            };
            let (ours, due) = (arcs_of(&skeleton, side), arcs_of(&expected, side));
            assert_eq!(ours, due, "{text}{side:?}");
            assert_eq!(skeleton.faces().len(), figure.edges().len(), "{text}");
            compared += 1;
            unbounded += ours.1.len();
        }
    }
    println!(
        "seeds 0 to {count}: {compared} agree, {vanishing} have rays that vanish, {unbounded} arcs go to infinity"
    );
    assert!(compared > count, "{vanishing} of {count} vanish");
}

#[test]
fn chains_that_are_none_are_refused() {
    let line = |points: &[[f64; 2]]| {
        let case = Case::of(vec![Part::line(points.to_vec())]);
        case.figure().expect("a line")
    };
    let spiral = line(&[[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0], [0.0, 2.0]]);
    let why = Chain::new(&spiral).expect_err("turns back");
    assert_eq!(
        why.to_string(),
        "edge 3 turns the chain back: it is monotone in no direction"
    );
    let bay = line(&[[0.0, 5.0], [0.0, 0.0], [4.0, 0.0], [4.0, 5.0]]);
    let chain = Chain::new(&bay).expect("monotone");
    assert!(chain.skeleton(Side::Right).is_ok(), "the rays part");
    let why = chain.skeleton(Side::Left).expect_err("the rays meet");
    assert_eq!(
        why.to_string(),
        "the ray of edge 0 vanishes at once, as far as it goes"
    );
    assert_eq!(chain.skeleton(Side::Start), Err(InvalidChain::NoSide));
}

#[test]
fn wavefronts_of_chains_are_no_loops() {
    for seed in 0..200 {
        let case = chain_small(seed);
        let figure = case.figure().expect("a figure");
        for side in [Side::Left, Side::Right] {
            let Ok(skeleton) = Chain::new(&figure).and_then(|chain| chain.skeleton(side)) else {
                continue;
            };
            assert!(skeleton.is_of_chain(), "{seed}");
            for distance in [0.0, 0.5, 1e9] {
                let refused = skeleton.offset(&figure, distance);
                assert_eq!(refused, Err(InvalidOffset::Chain), "{seed}");
            }
        }
        let whole = figure.skeleton(Options::default());
        assert!(!whole.is_of_chain(), "{seed}");
        whole
            .offset(&figure, 0.5)
            .expect("a whole skeleton has offsets");
    }
}
