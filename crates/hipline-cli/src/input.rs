//! From a file or standard input to features.

use std::{
    fs,
    io::{self, Read},
    path::Path,
};

use hipline::Figure;
use hipline_io::{Document, FeatureName, FigureError, Format, read};

use crate::{args::InputArgs, failure::Failure};

/// Whether a path stands for standard input or output.
pub fn is_standard(path: &Path) -> bool {
    path.as_os_str() == "-"
}

/// How messages call an input.
pub fn name(path: &Path) -> String {
    if is_standard(path) {
        "standard input".to_owned()
    } else {
        path.display().to_string()
    }
}

/// Everything in a file.
pub fn bytes(path: &Path) -> Result<Vec<u8>, Failure> {
    let result = if is_standard(path) {
        let mut bytes = Vec::new();
        io::stdin().lock().read_to_end(&mut bytes).map(|_| bytes)
    } else {
        fs::read(path)
    };
    result.map_err(|e| Failure::file(name(path), &e))
}

/// Reads the input that was asked for.
pub fn document(args: &InputArgs) -> Result<Document, Failure> {
    parse(args, &bytes(&args.path)?)
}

/// Reads the input that was asked for from its bytes.
pub fn parse(args: &InputArgs, bytes: &[u8]) -> Result<Document, Failure> {
    let failed = |e| Failure::Input(format!("{}: {e}", name(&args.path)));
    let format = match args.from {
        Some(format) => format,
        None if is_standard(&args.path) => Format::from_content(bytes).map_err(|_| {
            Failure::Input("standard input is in no known format; --from tells it".to_owned())
        })?,
        // A name that says nothing is not the last word.
        None => Format::from_path(&args.path)
            .or_else(|unknown| Format::from_content(bytes).map_err(|_| unknown))
            .map_err(|e| Failure::Input(e.to_string()))?,
    };
    read(bytes, format).map_err(failed)
}

/// Something to compute one skeleton of.
pub enum Item<'a> {
    /// A feature on its own.
    Feature(&'a hipline_io::Feature),
    /// All features, in one plane.
    Together(&'a Document),
}

impl Item<'_> {
    /// The items of a document.
    pub fn all(document: &Document, together: bool) -> Vec<Item<'_>> {
        if together {
            vec![Item::Together(document)]
        } else {
            document.features.iter().map(Item::Feature).collect()
        }
    }

    /// How results name it.
    pub fn name(&self) -> FeatureName {
        match self {
            Self::Feature(feature) => feature.name(),
            Self::Together(_) => FeatureName { index: 0, id: None },
        }
    }

    /// How errors name it.
    pub fn title(&self) -> String {
        match self {
            Self::Feature(feature) => feature.name().to_string(),
            Self::Together(document) => format!("{} features together", document.features.len()),
        }
    }

    /// The checked figure.
    pub fn figure(&self) -> Result<Figure, FigureError> {
        match self {
            Self::Feature(feature) => feature.figure(),
            Self::Together(document) => document.together(),
        }
    }

    /// How many points the file gives for it.
    pub fn points(&self) -> usize {
        match self {
            Self::Feature(feature) => feature.case.points(),
            Self::Together(document) => document.features.iter().map(|f| f.case.points()).sum(),
        }
    }
}
