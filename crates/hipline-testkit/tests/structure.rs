//! Invariants of the code that are absences: a search of the sources holds them.

mod common;

use std::fs;
use std::path::{Path, PathBuf};

use common::repository;

/// All Rust files below a folder, with their text.
fn sources(folder: &Path) -> Vec<(PathBuf, String)> {
    let mut found = Vec::new();
    let mut folders = vec![folder.to_path_buf()];
    while let Some(folder) = folders.pop() {
        for entry in fs::read_dir(&folder).expect("a folder") {
            let path = entry.expect("an entry").path();
            if path.is_dir() {
                if path.file_name().is_none_or(|name| name != "target") {
                    folders.push(path);
                }
            } else if path.extension().is_some_and(|ending| ending == "rs") {
                let text = fs::read_to_string(&path).expect("text");
                found.push((path, text));
            }
        }
    }
    assert!(!found.is_empty(), "no sources in {}", folder.display());
    found.sort();
    found
}

/// Lines without comments, numbered.
fn code(text: &str) -> impl Iterator<Item = (usize, &str)> {
    let lines = text
        .lines()
        .map(|line| line.split("//").next().unwrap_or(""));
    lines.enumerate().map(|(i, line)| (i + 1, line))
}

/// Lines of the files below `crates/<folder>` whose code contains one of the words.
fn with(folder: &str, words: &[&str]) -> Vec<String> {
    let mut found = Vec::new();
    for (path, text) in sources(&repository().join("crates").join(folder)) {
        for (number, line) in code(&text) {
            if words.iter().any(|word| line.contains(word)) {
                found.push(format!("{}:{number}: {}", path.display(), line.trim()));
            }
        }
    }
    found
}

fn absent(folder: &str, words: &[&str]) {
    let found = with(folder, words);
    assert!(
        found.is_empty(),
        "{words:?} in {folder}:\n{}",
        found.join("\n")
    );
}

/// The same for one file.
fn absent_in(file: &str, words: &[&str]) {
    let path = repository().join("crates").join(file);
    let text = fs::read_to_string(&path).expect("text");
    let found: Vec<_> = code(&text)
        .filter(|(_, line)| words.iter().any(|word| line.contains(word)))
        .collect();
    assert!(found.is_empty(), "{words:?} in {file}: {found:?}");
}

#[test]
fn dependencies_point_one_way() {
    absent("hipline-num/src", &["hipline::", "spade", "robust"]);
    absent("hipline/src/topology", &["f64", "crate::"]);
    absent(
        "hipline/src/predicates",
        &["kinetic", "skeleton", "offset::", "roof::"],
    );
    absent(
        "hipline/src/wavefront",
        &["kinetic", "skeleton::{", "offset::", "roof::", "observe::"],
    );
    absent("hipline/src/kinetic", &["offset::", "roof::", "observe::"]);
    absent(
        "hipline/src/monotone",
        &[
            "kinetic::",
            "orthogonal::",
            "offset::",
            "roof::",
            "observe::",
        ],
    );
    absent(
        "hipline/src/orthogonal",
        &[
            "kinetic::",
            "predicates::",
            "wavefront::",
            "offset::",
            "roof::",
            "observe::",
        ],
    );
    absent(
        "hipline/src/envelope",
        &["kinetic::", "offset::", "roof::", "observe::"],
    );
    absent(
        "hipline/src/skeleton",
        &["kinetic::", "offset::", "roof::", "observe::"],
    );
    absent(
        "hipline/src/offset",
        &["kinetic::", "roof::", "observe::", "centreline::"],
    );
    absent("hipline/src/observe", &["kinetic::"]);
    absent(
        "hipline/src/centreline",
        &["kinetic::", "roof::", "observe::"],
    );
    absent(
        "hipline/src/roof",
        &["kinetic::", "offset::", "predicates::"],
    );
    absent(
        "hipline/src/motorcycle",
        &[
            "kinetic::",
            "offset::",
            "roof::",
            "observe::",
            "centreline::",
        ],
    );
    absent(
        "hipline/src",
        &["std::fs", "std::io", "println!", "hipline_io"],
    );
    absent("hipline-io/src", &["hipline_cli", "hipline_testkit"]);
}

/// What decides never rounds: `kinetic` holds no coordinate, and no number is compared within a
/// tolerance.
#[test]
fn decisions_know_no_tolerance() {
    absent(
        "hipline/src/monotone",
        &["f64::EPSILON", "sqrt", ".abs()", "1e-", "as f64"],
    );
    absent(
        "hipline/src/kinetic",
        &["f64::EPSILON", "sqrt", ".abs()", "1e-"],
    );
    // Nor a logarithm (nor what sorts or searches in logarithmic time) where everything is linear.
    for file in ["chain", "graph", "merge", "result", "ring", "runs"] {
        absent_in(
            &format!("hipline/src/orthogonal/{file}.rs"),
            &[
                "sort",
                "binary_search",
                "BTree",
                ".log",
                "sqrt",
                ".abs()",
                "partition_point",
            ],
        );
    }
    // `cells.rs` chooses cuts and shortens lists with f64; nothing there decides what the result is.
    absent("hipline/src/envelope", &["f64::EPSILON", "sqrt", "1e-"]);
    for folder in ["hipline/src", "hipline-io/src"] {
        absent(
            folder,
            &["1e-6", "1e-7", "1e-8", "1e-9", "1e-10", "1e-12", "1e-15"],
        );
    }
    // Two uses are proofs, not tolerances: the error of one rounding, and the bounds within which a
    // motorcycle is in a cell, which only ever let it be looked for in more of them.
    let allowed = ["planes.rs", "way.rs"];
    let found = with("hipline/src", &["EPSILON"]);
    let stray = found
        .iter()
        .filter(|line| !allowed.iter().any(|file| line.contains(file)));
    assert_eq!(stray.collect::<Vec<_>>(), Vec::<&String>::new(), "EPSILON");
}

/// Roots of f64 are taken in hipline-num only. (Elsewhere `sqrt` is that of its balls and of big
/// integers; `clippy.toml` forbids the one of f64. Lengths are measured for output only.)
#[test]
fn roots_of_floats_are_walled_off() {
    absent("hipline/src", &["f64::sqrt", "as f64).sqrt", "powf("]);
    let roots = with("hipline/src", &[".sqrt()", ".hypot("]);
    let allowed = [
        "predicates/eaves.rs",
        "predicates/lines.rs",
        "predicates/root.rs",
        "observe/terrain.rs",
    ];
    let stray = roots
        .iter()
        .filter(|line| !allowed.iter().any(|file| line.contains(file)));
    assert_eq!(stray.collect::<Vec<_>>(), Vec::<&String>::new(), "roots");
}

/// The check of the input looks things up in hash tables, but never goes through one in its order.
#[test]
fn nothing_depends_on_hash_order_or_clocks() {
    absent("hipline/src", &["HashSet", "Instant", "SystemTime"]);
    absent(
        "hipline-num/src",
        &["HashMap", "HashSet", "Instant", "SystemTime"],
    );
    for folder in [
        "engine",
        "envelope",
        "kinetic",
        "monotone",
        "orthogonal",
        "motorcycle",
        "wavefront",
        "lift",
        "predicates",
        "topology",
        "skeleton",
        "offset",
        "centreline",
        "roof",
        "observe",
    ] {
        absent(&format!("hipline/src/{folder}"), &["HashMap"]);
    }
}

/// A library's powers and logarithms differ between platforms, and are not exact: `hipline_num::ldexp` and
/// `exponent` are.
#[test]
fn powers_and_logarithms_are_exact() {
    for folder in ["hipline/src", "hipline-num/src"] {
        let words = [".powi(", ".powf(", ".log2()", ".log10()", ".ln()", ".exp("];
        absent(folder, &words);
    }
}

/// All but lists of tests.
#[test]
fn files_stay_small() {
    let crates = repository().join("crates");
    let long: Vec<String> = sources(&crates)
        .iter()
        .filter(|(path, _)| !path.ends_with("tests.rs") && !path.iter().any(|part| part == "tests"))
        .map(|(path, text)| (path, text.lines().count()))
        .filter(|&(_, lines)| lines >= 600)
        .map(|(path, lines)| format!("{}: {lines} lines", path.display()))
        .collect();
    assert!(long.is_empty(), "{}", long.join("\n"));
}

/// Paths in backticks or links that the project's documents name.
fn named(text: &str) -> Vec<&str> {
    let quoted = text.split('`').skip(1).step_by(2);
    let linked = text
        .split("](")
        .skip(1)
        .filter_map(|rest| rest.split(')').next());
    let tops = [
        "crates/",
        "docs/",
        "corpus/",
        "bench/",
        "fuzz/",
        ".ci/",
        ".github/",
        "README",
        "ARCHI",
        "CHANGELOG",
        "CONTRIB",
        "LICENSE",
    ];
    quoted
        .chain(linked)
        .map(|name| name.split('#').next().unwrap_or(name))
        .filter(|name| tops.iter().any(|top| name.starts_with(top)))
        .filter(|name| !name.contains([' ', '*', '<', '{']))
        .collect()
}

#[test]
fn documents_name_files_that_exist() {
    let root = repository();
    let documents = [
        "README.md",
        "ARCHITECTURE.md",
        "CONTRIBUTING.md",
        "CHANGELOG.md",
    ];
    let mut missing = Vec::new();
    let mut check = |document: &str| {
        let text = fs::read_to_string(root.join(document)).expect(document);
        for name in named(&text) {
            if !root.join(name).exists() {
                missing.push(format!("{document}: {name}"));
            }
        }
    };
    documents.iter().for_each(|document| check(document));
    for entry in fs::read_dir(root.join("docs")).expect("docs") {
        let path = entry.expect("an entry").path();
        if path.extension().is_some_and(|ending| ending == "md") {
            let name = path
                .file_name()
                .expect("a name")
                .to_string_lossy()
                .into_owned();
            check(&format!("docs/{name}"));
        }
    }
    assert!(missing.is_empty(), "missing:\n{}", missing.join("\n"));
}
