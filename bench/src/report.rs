//! Tables, verdicts, JSON.

use std::fmt::Write as _;

use serde_json::{Value, json};

use crate::campaign::Row;
use crate::input::Input;
use crate::options::Options;

/// How tables look.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Style {
    Plain,
    Markdown,
}

/// The size at which the ratio to the triangulation is judged.
const RATIO_AT: usize = 100_000;
/// The sizes between which the growth of the time per vertex is judged.
const GROWTH: [usize; 2] = [10_000, 1_000_000];
/// How much the time per vertex may grow between them.
const ALLOWED_GROWTH: f64 = 1.6;
/// How many bytes per vertex may be in use, beyond the input; judged from [`GROWTH`]'s first size on.
const ALLOWED_MEMORY: f64 = 1200.0;

/// All tables.
pub fn text(rows: &[Row], style: Style) -> String {
    let (files, others): (Vec<&Row>, Vec<&Row>) = rows
        .iter()
        .partition(|row| matches!(row.input, Input::Each(_)));
    let mut text = String::new();
    for (title, table) in [
        ("Time and memory", times(&others)),
        ("Events and decisions, per vertex", counts(rows)),
        ("Many small figures, one after the other", small(&files)),
        ("Targets", targets(rows)),
    ] {
        if table.len() > 1 {
            let mark = if style == Style::Markdown { "### " } else { "" };
            write!(text, "\n{mark}{title}\n\n{}", layout(&table, style)).expect("memory");
        }
    }
    text
}

/// A table: its head, then its lines.
type Table = Vec<Vec<String>>;

fn head(names: &[&str]) -> Table {
    vec![names.iter().map(ToString::to_string).collect()]
}

fn number(x: Option<f64>, digits: usize) -> String {
    x.map_or_else(|| "-".to_owned(), |x| format!("{x:.digits$}"))
}

fn memory(row: &Row) -> Option<f64> {
    row.hipline
        .peak
        .map(|peak| row.hipline.per_vertex(peak as f64))
}

fn times(rows: &[&Row]) -> Table {
    let mut table = head(&[
        "input",
        "n",
        "build",
        "skeleton",
        "total us/v",
        "spade us/v",
        "by",
        "ratio",
        "growth",
        "B/v",
    ]);
    for row in rows {
        let all = &row.hipline;
        let first = rows
            .iter()
            .find(|other| other.input == row.input && other.n == GROWTH[0]);
        table.push(vec![
            row.input.name().to_owned(),
            all.vertices.to_string(),
            number(Some(all.per_vertex(1e6 * all.build)), 2),
            number(Some(all.per_vertex(1e6 * all.skeleton)), 2),
            number(Some(row.time()), 2),
            number(
                row.rival.map(|rival| all.per_vertex(1e6 * rival.seconds)),
                2,
            ),
            row.rival.map_or("-", |rival| rival.program).to_owned(),
            number(row.ratio(), 1),
            number(
                first
                    .filter(|_| row.n > GROWTH[0])
                    .map(|first| row.time() / first.time()),
                2,
            ),
            number(memory(row), 0),
        ]);
    }
    table
}

fn counts(rows: &[Row]) -> Table {
    let mut table = head(&[
        "input", "n", "edge", "split", "flips", "f64", "dd", "wide", "exact", "dd %", "wide %",
        "exact %",
    ]);
    for row in rows {
        let all = &row.hipline;
        let count = |count: u64, digits| number(Some(all.per_vertex(count as f64)), digits);
        let decisions =
            (all.by_f64 + all.by_double_double + all.by_wide + all.by_exact).max(1) as f64;
        let share = |count: u64| number(Some(100.0 * count as f64 / decisions), 3);
        table.push(vec![
            row.input.name().to_owned(),
            all.vertices.to_string(),
            count(all.edge_events, 2),
            count(all.split_events, 2),
            count(all.flips, 2),
            count(all.by_f64, 1),
            count(all.by_double_double, 3),
            count(all.by_wide, 3),
            count(all.by_exact, 3),
            share(all.by_double_double),
            share(all.by_wide),
            share(all.by_exact),
        ]);
    }
    table
}

fn small(rows: &[&Row]) -> Table {
    let mut table = head(&[
        "file",
        "figures",
        "refused",
        "vertices",
        "build",
        "skeleton",
        "total us/v",
        "figures/s",
        "spade us/v",
        "by",
        "ratio",
    ]);
    for row in rows {
        let all = &row.hipline;
        table.push(vec![
            row.input.name().to_owned(),
            all.figures.to_string(),
            all.refused.to_string(),
            all.vertices.to_string(),
            number(Some(all.per_vertex(1e6 * all.build)), 2),
            number(Some(all.per_vertex(1e6 * all.skeleton)), 2),
            number(Some(row.time()), 2),
            number(Some(all.figures as f64 / all.seconds()), 0),
            number(
                row.rival.map(|rival| all.per_vertex(1e6 * rival.seconds)),
                2,
            ),
            row.rival.map_or("-", |rival| rival.program).to_owned(),
            number(row.ratio(), 1),
        ]);
    }
    table
}

/// What one input is held to: the values, nothing where not measured.
struct Verdicts {
    input: Input,
    ratio: Option<f64>,
    growth: Option<f64>,
    memory: Option<f64>,
}

fn verdicts(rows: &[Row]) -> Vec<(Verdicts, f64)> {
    let mut found: Vec<(Verdicts, f64)> = Vec::new();
    for row in rows {
        let input = row.input;
        let Some(allowed) = input.allowed_ratio() else {
            continue;
        };
        if found.iter().any(|(verdicts, _)| verdicts.input == input) {
            continue;
        }
        let at = |n| rows.iter().find(|row| row.input == input && row.n == n);
        let growth = at(GROWTH[1])
            .zip(at(GROWTH[0]))
            .map(|(large, small)| large.time() / small.time());
        let large = rows
            .iter()
            .filter(|row| row.input == input && row.n >= GROWTH[0]);
        let memory = large.filter_map(memory).max_by(f64::total_cmp);
        found.push((
            Verdicts {
                input,
                ratio: at(RATIO_AT).and_then(Row::ratio),
                growth,
                memory,
            },
            allowed,
        ));
    }
    found
}

fn verdict(value: Option<f64>, fine: impl Fn(f64) -> bool) -> &'static str {
    match value {
        None => "not measured",
        Some(value) if fine(value) => "PASS",
        Some(_) => "FAIL",
    }
}

fn targets(rows: &[Row]) -> Table {
    let mut table = head(&[
        "input",
        "ratio at 1e5",
        "allowed",
        "verdict",
        "1e6 over 1e4",
        "allowed",
        "verdict",
        "B/v",
        "allowed",
        "verdict",
    ]);
    for (verdicts, allowed) in verdicts(rows) {
        table.push(vec![
            verdicts.input.name().to_owned(),
            number(verdicts.ratio, 1),
            format!("<= {allowed}"),
            verdict(verdicts.ratio, |x| x <= allowed).to_owned(),
            number(verdicts.growth, 2),
            format!("< {ALLOWED_GROWTH}"),
            verdict(verdicts.growth, |x| x < ALLOWED_GROWTH).to_owned(),
            number(verdicts.memory, 0),
            format!("<= {ALLOWED_MEMORY}"),
            verdict(verdicts.memory, |x| x <= ALLOWED_MEMORY).to_owned(),
        ]);
    }
    table
}

/// A table as text: words to the left, numbers to the right.
fn layout(table: &Table, style: Style) -> String {
    let columns = table[0].len();
    let is_number = |cell: &str| cell == "-" || cell.parse::<f64>().is_ok();
    let numeric: Vec<bool> = (0..columns)
        .map(|c| table[1..].iter().all(|line| is_number(&line[c])))
        .collect();
    let widths: Vec<usize> = (0..columns)
        .map(|c| {
            table
                .iter()
                .map(|line| line[c].len())
                .max()
                .unwrap_or(0)
                .max(2)
        })
        .collect();
    let mut text = String::new();
    let mut line = |cells: Vec<String>| {
        let row = match style {
            Style::Plain => cells.join("  "),
            Style::Markdown => format!("| {} |", cells.join(" | ")),
        };
        writeln!(text, "{}", row.trim_end()).expect("memory");
    };
    for (i, cells) in table.iter().enumerate() {
        let pad = |(c, cell): (usize, &String)| {
            let width = widths[c];
            if numeric[c] {
                format!("{cell:>width$}")
            } else {
                format!("{cell:<width$}")
            }
        };
        line(cells.iter().enumerate().map(pad).collect());
        if i == 0 && style == Style::Markdown {
            let rule = |c: usize| {
                format!(
                    "{}{}",
                    "-".repeat(widths[c] - 1),
                    if numeric[c] { ":" } else { "-" }
                )
            };
            line((0..columns).map(rule).collect());
        }
    }
    text
}

/// Everything, for machines.
pub fn json(rows: &[Row], options: &Options) -> String {
    let row = |row: &Row| {
        json!({
            "input": row.input.name(),
            "n": row.n,
            "hipline": row.hipline,
            "spade": row.rival,
            "us_per_vertex": row.time(),
            "ratio": row.ratio(),
            "bytes_per_vertex": memory(row),
        })
    };
    let target = |(verdicts, allowed): &(Verdicts, f64)| {
        json!({
            "input": verdicts.input.name(),
            "ratio": { "value": verdicts.ratio, "allowed": allowed, "verdict": verdict(verdicts.ratio, |x| x <= *allowed) },
            "growth": { "value": verdicts.growth, "allowed": ALLOWED_GROWTH, "verdict": verdict(verdicts.growth, |x| x < ALLOWED_GROWTH) },
            "bytes_per_vertex": { "value": verdicts.memory, "allowed": ALLOWED_MEMORY, "verdict": verdict(verdicts.memory, |x| x <= ALLOWED_MEMORY) },
        })
    };
    let all: Value = json!({
        "side": if options.both_sides { "both" } else { "interior" },
        "rows": rows.iter().map(row).collect::<Vec<_>>(),
        "targets": verdicts(rows).iter().map(target).collect::<Vec<_>>(),
    });
    format!("{all:#}\n")
}
