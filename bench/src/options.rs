//! The command line.

use std::ffi::OsString;
use std::path::{Path, PathBuf};
use std::time::Duration;

use crate::input::{self, Input};
use crate::report::Style;

pub const HELP: &str = "\
Measures hipline beside a plain constrained Delaunay triangulation (spade) of the same input.

    cargo run --release -p hipline-bench -- [OPTIONS]

    --families A,B,..  only these: families, or `nz-coast` and the other files; `all` for
                       the families that are left out otherwise, too
    --sizes N,M,..     vertices of the families' inputs [1000,10000,100000,1000000]
    --quick            the same as --sizes 1000,10000,100000
    --roofs            instead: roofs per second on the files of buildings
    --engines          instead (as the first option; only --sizes may follow): the engines side by side on
                       orthogonal monotone polygons, beside a sort of the vertices
    --side SIDE        interior or both sides of polygons [interior]
    --limit SECONDS    leave out what would take longer, judged by the sizes before [120]
    --data DIR         where the files are [../shared/data beside the repository]
    --markdown         tables in Markdown
    --json FILE        everything measured, for machines
";

/// What the caller wants.
pub struct Options {
    pub inputs: Vec<Input>,
    pub sizes: Vec<usize>,
    pub both_sides: bool,
    /// Whether to measure roofs, and nothing else.
    pub roofs: bool,
    pub limit: Duration,
    pub data: PathBuf,
    pub style: Style,
    pub json: Option<PathBuf>,
}

/// Reads the arguments; nothing if help is wanted.
pub fn parse(arguments: Vec<OsString>) -> Result<Option<Options>, String> {
    let mut arguments = pico_args::Arguments::from_vec(arguments);
    if arguments.contains(["-h", "--help"]) {
        return Ok(None);
    }
    let quick = arguments.contains("--quick");
    let roofs = arguments.contains("--roofs");
    let style = if arguments.contains("--markdown") {
        Style::Markdown
    } else {
        Style::Plain
    };
    let mut text = |key| {
        arguments
            .opt_value_from_str::<_, String>(key)
            .map_err(|e| e.to_string())
    };
    let inputs = match text("--families")? {
        None => input::usual(),
        Some(names) if names == "all" => input::all(),
        Some(names) => names
            .split(',')
            .map(|name| input::named(name).ok_or_else(|| format!("no family is called {name}")))
            .collect::<Result<_, _>>()?,
    };
    let sizes = match text("--sizes")? {
        Some(sizes) => sizes
            .split(',')
            .map(|size| size.parse().map_err(|_| format!("{size} is not a size")))
            .collect::<Result<_, _>>()?,
        None if quick => vec![1000, 10_000, 100_000],
        None => vec![1000, 10_000, 100_000, 1_000_000],
    };
    let both_sides = match text("--side")?.as_deref() {
        None | Some("interior") => false,
        Some("both") => true,
        Some(side) => return Err(format!("{side} is not a side: interior or both")),
    };
    let limit: u64 = match text("--limit")? {
        None => 120,
        Some(limit) => limit
            .parse()
            .map_err(|_| format!("{limit} is not a number of seconds"))?,
    };
    let data = text("--data")?.map_or_else(
        || Path::new(env!("CARGO_MANIFEST_DIR")).join("../../shared/data"),
        PathBuf::from,
    );
    let json = text("--json")?.map(PathBuf::from);
    if let Some(unknown) = arguments.finish().first() {
        return Err(format!("{} is no option; see --help", unknown.display()));
    }
    Ok(Some(Options {
        inputs,
        sizes,
        both_sides,
        roofs,
        limit: Duration::from_secs(limit),
        data,
        style,
        json,
    }))
}
