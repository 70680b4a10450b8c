//! `hipline check`

use std::{collections::BTreeMap, path::Path};

use hipline::{Figure, skeleton::Uncertified};
use hipline_io::{FigureError, Reason, SkeletonRecord, read_skeletons};

use crate::{
    args::CheckArgs,
    compute::{Computed, each, report_errors},
    failure::{Failure, Outcome, report},
    input::{self, Item},
};

/// At most this many flaws or violations of one feature are printed.
const SHOWN: usize = 20;

pub fn run(args: &CheckArgs) -> Result<Outcome, Failure> {
    let document = input::weighted(&args.input, &args.gables)?;
    let items = Item::all(&document, args.input.together);
    match &args.result {
        None => check_input(&items),
        Some(path) => check_result(&items, path),
    }
}

/// Whether every item is a planar straight-line graph.
fn check_input(items: &[Item]) -> Result<Outcome, Failure> {
    let [mut vertices, mut edges, mut empty, mut flawed] = [0; 4];
    for item in items {
        match item.figure() {
            Ok(figure) => {
                vertices += figure.vertices().len();
                edges += figure.edges().len();
            }
            Err(error) if error.is_empty_geometry() => empty += 1,
            Err(error) => {
                flawed += 1;
                report_flaws(item, &error);
            }
        }
    }
    if flawed > 0 {
        return Err(Failure::Input(format!(
            "{flawed} of {} flawed",
            count(items.len(), "feature")
        )));
    }
    let empty = match empty {
        0 => String::new(),
        n => format!(" ({n} empty)"),
    };
    super::print(
        format!(
            "ok: {}{empty}, {}, {}\n",
            count(items.len(), "feature"),
            count_of(vertices, "vertex", "vertices"),
            count(edges, "edge")
        )
        .as_bytes(),
    )
}

/// One line for each flaw.
fn report_flaws(item: &Item, error: &FigureError) {
    let (Reason::Invalid(invalid), [_]) = (&error.reason, error.features.as_slice()) else {
        // Of several features together, the message tells which is which.
        report(error);
        return;
    };
    for flaw in invalid.flaws.iter().take(SHOWN) {
        report(format_args!("{}: {flaw}", item.title()));
    }
    if let Some(more) = invalid.flaws.len().checked_sub(SHOWN).filter(|n| *n > 0) {
        report(format_args!("{}: and {more} more", item.title()));
    }
}

/// Whether the skeletons of a file are those of the items.
fn check_result(items: &[Item], path: &Path) -> Result<Outcome, Failure> {
    let records = read_skeletons(&input::bytes(path)?)
        .map_err(|e| Failure::Input(format!("{}: {e}", input::name(path))))?;
    let mut by_index: BTreeMap<usize, SkeletonRecord> = BTreeMap::new();
    let total = records.len();
    for record in records {
        let index = record.index;
        if by_index.insert(index, record).is_some() {
            return Err(Failure::Input(format!("result {index} is there twice")));
        }
    }
    let mut outcome = Outcome::Done;
    let known: Vec<usize> = items.iter().map(|item| item.name().index).collect();
    for index in by_index.keys().filter(|index| !known.contains(index)) {
        report(format_args!("result {index} belongs to no feature"));
        outcome = Outcome::Flawed;
    }
    let checked: Vec<Computed<Verified>> = each(items, |item, figure| {
        verify(figure, by_index.get(&item.name().index))
    });
    if report_errors(&checked) == Outcome::Flawed {
        outcome = Outcome::Flawed;
    }
    let sum = |part: fn(&Verified) -> usize| -> usize {
        checked
            .iter()
            .filter_map(|c| c.result.as_ref().ok())
            .map(part)
            .sum()
    };
    if outcome == Outcome::Flawed {
        let good = checked.iter().filter(|c| c.result.is_ok()).count();
        return Err(Failure::Input(format!(
            "of {} and {}, {good} agree",
            count(items.len(), "feature"),
            count(total, "result")
        )));
    }
    let certified = match sum(|v| usize::from(v.certified)) {
        0 => String::new(),
        n => format!("; {n} certified"),
    };
    super::print(
        format!(
            "ok: {} verified: {}, {}, {}{certified}\n",
            count(checked.len(), "skeleton"),
            count(sum(|v| v.nodes), "node"),
            count(sum(|v| v.arcs), "arc"),
            count(sum(|v| v.faces), "face")
        )
        .as_bytes(),
    )
}

/// What was verified.
struct Verified {
    /// Whether it is proved to be the straight skeleton.
    certified: bool,
    nodes: usize,
    arcs: usize,
    faces: usize,
}

/// Larger figures are checked by the laws alone.
const CERTIFIED: usize = 5_000;

fn verify(figure: Option<&Figure>, record: Option<&SkeletonRecord>) -> Result<Verified, String> {
    let skeleton = match record.map(|record| &record.result) {
        None => return Err("there is no result for it".to_owned()),
        Some(Err(error)) => return Err(format!("there is no skeleton, but an error: {error}")),
        Some(Ok(skeleton)) => skeleton,
    };
    let mut verified = Verified {
        certified: false,
        nodes: skeleton.nodes().len(),
        arcs: skeleton.arcs().len(),
        faces: skeleton.faces().len(),
    };
    let Some(figure) = figure else {
        return if verified.nodes == 0 {
            Ok(verified)
        } else {
            Err("the geometry is empty, but its skeleton is not".to_owned())
        };
    };
    // The motorcycle graph takes too long on some large inputs.
    let checked = if figure.vertices().len() <= CERTIFIED {
        skeleton.certify(figure)
    } else {
        skeleton.verify(figure).map_err(Uncertified::Unlawful)
    };
    let violations = match checked {
        Ok(()) => {
            verified.certified = figure.vertices().len() <= CERTIFIED;
            return Ok(verified);
        }
        // Where the theorem says nothing, the laws alone are asked.
        Err(Uncertified::NotApplicable(_)) => match skeleton.verify(figure) {
            Ok(()) => return Ok(verified),
            Err(violations) => violations,
        },
        Err(Uncertified::Unlawful(violations)) => violations,
        Err(other) => return Err(format!("not the straight skeleton: {other}")),
    };
    let mut lines = vec![count(violations.total, "violation")];
    lines.extend(
        violations
            .list
            .iter()
            .take(SHOWN)
            .map(|violation| format!("  {violation}")),
    );
    if violations.total > SHOWN {
        lines.push(format!("  and {} more", violations.total - SHOWN));
    }
    Err(lines.join("\n"))
}

fn count(n: usize, what: &str) -> String {
    count_of(n, what, &format!("{what}s"))
}

fn count_of(n: usize, one: &str, many: &str) -> String {
    format!("{n} {}", if n == 1 { one } else { many })
}
