//! From a file or standard input to features.

use std::{
    fmt::Display,
    fs,
    io::{self, Read},
    ops::Deref,
    path::Path,
};

use hipline::Figure;
use hipline_io::{
    Document, Feature, FeatureName, FigureError, Format, Setting, read, read_settings,
};

use crate::{
    args::{GableArgs, HeightsArg, InputArgs},
    failure::Failure,
};

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

/// What was asked for, with its weights and heights.
pub struct Input {
    pub document: Document,
    /// Whether edges may pass below the heights of others.
    allow_walls: bool,
}

impl Deref for Input {
    type Target = Document;

    fn deref(&self) -> &Document {
        &self.document
    }
}

/// Reads the input that was asked for.
pub fn document(args: &InputArgs) -> Result<Input, Failure> {
    weighted(args, &GableArgs::default())
}

/// Reads the input that was asked for, with weights of single edges.
pub fn weighted(args: &InputArgs, gables: &GableArgs) -> Result<Input, Failure> {
    one_stream(args)?;
    parse(args, gables, &bytes(&args.path)?)
}

/// Reads the input that was asked for from its bytes.
pub fn parse(args: &InputArgs, gables: &GableArgs, bytes: &[u8]) -> Result<Input, Failure> {
    let failed = |e: &dyn Display| Failure::Input(format!("{}: {e}", name(&args.path)));
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
    let mut document = read(bytes, format).map_err(|e| failed(&e))?;
    let settings = settings(args, gables)?;
    document.set(&settings).map_err(|e| failed(&e))?;
    if args.weights.heights == Some(HeightsArg::Z) {
        document
            .heights_from_z()
            .map_err(|(feature, e)| failed(&format_args!("--heights z: {feature}: {e}")))?;
    }
    Ok(Input {
        document,
        allow_walls: args.weights.allow_walls,
    })
}

/// Reads a file for its geometry alone, in the format that it seems to have.
pub fn plain(path: &Path) -> Result<Document, Failure> {
    let bytes = bytes(path)?;
    let failed = |e: &dyn Display| Failure::Input(format!("{}: {e}", name(path)));
    let format = Format::from_path(path)
        .or_else(|unknown| Format::from_content(&bytes).map_err(|_| unknown))
        .map_err(|e| Failure::Input(e.to_string()))?;
    read(&bytes, format).map_err(|e| failed(&e))
}

/// Standard input can be read once.
fn one_stream(args: &InputArgs) -> Result<(), Failure> {
    let weights = args.weights.weights.as_deref();
    if weights.is_some_and(is_standard) && is_standard(&args.path) {
        let message = "standard input cannot be both the input and its weights";
        return Err(Failure::Usage(message.to_owned()));
    }
    Ok(())
}

/// All weights and heights that were given apart from the file.
fn settings(args: &InputArgs, gables: &GableArgs) -> Result<Vec<Setting>, Failure> {
    one_stream(args)?;
    let weights = &args.weights;
    let mut settings = match &weights.weights {
        None => Vec::new(),
        Some(path) => read_settings(&bytes(path)?, &name(path))
            .map_err(|e| Failure::Input(format!("{}: {e}", name(path))))?,
    };
    for list in [
        &weights.weight,
        &gables.gable,
        &weights.start,
        &weights.profile,
        &gables.height,
    ] {
        settings.extend(list.iter().cloned());
    }
    Ok(settings)
}

/// Something to compute one skeleton of.
pub enum Item<'a> {
    /// A feature on its own, and whether edges may pass below the heights of others.
    Feature(&'a Feature, bool),
    /// All features, in one plane.
    Together(&'a Input),
}

impl Item<'_> {
    /// The items of a document.
    pub fn all(input: &Input, together: bool) -> Vec<Item<'_>> {
        if together {
            return vec![Item::Together(input)];
        }
        let item = |feature| Item::Feature(feature, input.allow_walls);
        input.features.iter().map(item).collect()
    }

    /// Whether edges may pass below the heights of others.
    pub fn allows_walls(&self) -> bool {
        match self {
            Self::Feature(_, allow_walls) => *allow_walls,
            Self::Together(input) => input.allow_walls,
        }
    }

    /// How results name it.
    pub fn name(&self) -> FeatureName {
        match self {
            Self::Feature(feature, _) => feature.name(),
            Self::Together(_) => FeatureName { index: 0, id: None },
        }
    }

    /// How errors name it.
    pub fn title(&self) -> String {
        match self {
            Self::Feature(feature, _) => feature.name().to_string(),
            Self::Together(document) => format!("{} features together", document.features.len()),
        }
    }

    /// The checked figure.
    pub fn figure(&self) -> Result<Figure, FigureError> {
        match self {
            Self::Feature(feature, _) => feature.figure(),
            Self::Together(document) => document.together(),
        }
    }

    /// How many points the file gives for it.
    pub fn points(&self) -> usize {
        match self {
            Self::Feature(feature, _) => feature.case.points(),
            Self::Together(document) => document.features.iter().map(|f| f.case.points()).sum(),
        }
    }
}
