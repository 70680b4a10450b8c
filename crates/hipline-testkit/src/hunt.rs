//! Runs the library against the reference on one case after another.

use std::panic::{AssertUnwindSafe, catch_unwind};
use std::thread;

use hipline::{Engine, Figure, Options, Skeleton};

use crate::agreement::{compare, wkt};
use crate::case::Case;
use crate::reduce::reduce;
use crate::reference::{Graph, Reference, reference};

/// How the library fails on a case, in words; `None` if it agrees with the reference and passes
/// verification, or if the case is not a figure. That holds where heights are not reached, too, and both must say so.
///
/// A panic counts as a failure; the panic hook still sees it.
#[must_use]
pub fn failure(case: &Case) -> Option<String> {
    let Ok(figure) = catch_unwind(|| case.figure()) else {
        return Some("the check of the input panics".to_owned());
    };
    let figure = figure.ok()?;
    let graph = Graph::from(&figure);
    let Ok(expected) = catch_unwind(|| reference(&graph, case.region)) else {
        return Some("the reference panics".to_owned());
    };
    let options = Options::default().region(case.region);
    // Often both are one; comparing costs little beside the reference.
    [Engine::Kinetic, Engine::Auto]
        .into_iter()
        .find_map(|engine| {
            let how = failure_of(engine, &figure, options, &graph, &expected)?;
            Some(format!("{engine:?}:\n{how}"))
        })
}

/// How one engine fails, in words.
fn failure_of(
    engine: Engine,
    figure: &Figure,
    options: Options,
    graph: &Graph,
    expected: &Reference,
) -> Option<String> {
    let run = AssertUnwindSafe(|| figure.skeleton_by(engine, options));
    let skeleton = match catch_unwind(run) {
        Ok(result) => result.expect("they apply to everything"),
        Err(cause) => {
            let text = cause.downcast_ref::<String>().map(String::as_str);
            let text = text
                .or_else(|| cause.downcast_ref::<&str>().copied())
                .unwrap_or("no message");
            return Some(format!("the library panics: {text}"));
        }
    };
    let reached = expected.reaches_heights(graph);
    let early = skeleton.check_heights(figure).err();
    if early.is_none() != reached {
        let ours = early.map_or_else(|| "reached".to_owned(), |early| early.to_string());
        let due = if reached { "" } else { "not " };
        return Some(format!(
            "heights: {ours}\nby the reference, they are {due}reached\n{}",
            wkt(figure)
        ));
    }
    let difference = compare(figure, &skeleton, expected);
    if let Err(difference) = difference {
        return Some(difference.to_string());
    }
    if overruns_at_zero(&skeleton) {
        return None;
    }
    let violations = skeleton.verify(figure).err()?;
    Some(format!("verification fails: {violations}"))
}

/// Whether an edge is overrun at time zero: then an arc covers its base from vertex to vertex, and
/// [`Skeleton::verify`] does not know two such arcs between the same vertices.
#[must_use]
pub fn overruns_at_zero(skeleton: &Skeleton) -> bool {
    let vertices = skeleton.input().vertices;
    let mut arcs = skeleton.arcs().iter();
    arcs.any(|arc| arc.nodes.iter().all(|node| node.index() < vertices))
}

/// What kind of failure that is: a panic without its numbers, names of faces only, or arcs.
#[must_use]
pub fn manner(how: &str) -> String {
    if let Some(at) = how.find("panics") {
        let text = how[at..].split(['{', '(']).next().unwrap_or_default();
        return text.chars().filter(|c| !c.is_ascii_digit()).collect();
    }
    if how.contains("\nverification") {
        let last = how.rsplit(' ').take(3).collect::<Vec<_>>();
        return last.join(" ");
    }
    let bare = |verb: &str| {
        let lines = how.lines().filter_map(|line| line.strip_prefix(verb));
        let places = lines.filter_map(|line| line.split_once(": "));
        let mut places: Vec<&str> = places.map(|(_, ends)| ends).collect();
        places.sort_unstable();
        places
    };
    let names = !bare("missing").is_empty() && bare("missing") == bare("extra");
    if names { "names" } else { "arcs" }.to_owned()
}

/// Tries the cases of some seeds; for each failure, up to `most`, the smallest case that
/// still fails in the same manner, and how.
pub fn hunt(
    generate: impl Fn(u64) -> Case,
    seeds: impl IntoIterator<Item = u64>,
    most: usize,
) -> Vec<(Case, String)> {
    let mut found = Vec::new();
    for seed in seeds {
        let case = generate(seed);
        let Some(first) = failure(&case) else {
            continue;
        };
        let kind = manner(&first);
        let smallest = reduce(&case, |case| {
            failure(case).is_some_and(|how| manner(&how) == kind)
        });
        let how = failure(&smallest).unwrap_or_else(|| "it failed only once".to_owned());
        found.push((smallest, how));
        if found.len() >= most {
            break;
        }
    }
    found
}

/// Runs a check over all cases in two threads, and panics with what it finds.
pub fn check_all(
    cases: impl Iterator<Item = Case> + Clone + Send,
    check: fn(&Case) -> Vec<String>,
) {
    let wrong: Vec<String> = thread::scope(|scope| {
        let half = |k: usize| {
            let cases = cases.clone().skip(k).step_by(2);
            let found = move |case: Case| {
                let wrong = check(&case).into_iter();
                wrong.map(move |what| format!("{what}\n{}", case.to_text()))
            };
            move || cases.flat_map(found).collect::<Vec<_>>()
        };
        let running = [scope.spawn(half(0)), scope.spawn(half(1))];
        running
            .into_iter()
            .flat_map(|thread| thread.join().expect("no panic"))
            .collect()
    });
    let shown = wrong[..wrong.len().min(8)].join("\n");
    assert!(wrong.is_empty(), "{} wrong\n{shown}", wrong.len());
}
