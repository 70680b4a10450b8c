//! Where inputs from the field are, which do not belong to the repository.

use std::path::{Path, PathBuf};

/// The folder that `HIPLINE_DATA` names, or `shared/data` beside the repository. `None`, said on the standard
/// output, where there is none: tests then pass without it.
#[must_use]
pub fn folder() -> Option<PathBuf> {
    let beside = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../../shared/data");
    let folder = std::env::var_os("HIPLINE_DATA").map_or(beside, PathBuf::from);
    let is_there = folder.is_dir();
    if !is_there {
        println!("skipped: there is no {}", folder.display());
    }
    is_there.then_some(folder)
}

/// The files of a folder whose names have an ending, in order.
///
/// # Panics
/// If the folder cannot be read.
#[must_use]
pub fn files(folder: &Path, ending: &str) -> Vec<PathBuf> {
    let entries = std::fs::read_dir(folder).expect("the folder can be read");
    let mut files: Vec<PathBuf> = entries
        .map(|entry| entry.expect("the folder can be read").path())
        .filter(|path| path.extension().is_some_and(|own| own == ending))
        .collect();
    files.sort();
    files
}
