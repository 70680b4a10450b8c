//! Where results go: whole files or none, standard output without panics.

use std::{
    fs,
    io::{self, BufWriter, IsTerminal, Write},
    path::{Path, PathBuf},
};

use clap::ValueEnum;
use hipline_io::write::{Picture, PictureError, write_atomically};

use crate::{
    args::{OutputArgs, OutputFormat},
    failure::Failure,
    input::is_standard,
};

/// One thing to write.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Target {
    /// The file; `None` is standard output.
    path: Option<PathBuf>,
    /// Its format.
    pub format: OutputFormat,
}

/// What is to be written, of the formats that a command has; `usual` is that of standard
/// output.
///
/// What cannot work is found here, before anything is computed.
pub fn targets(
    args: &OutputArgs,
    usual: OutputFormat,
    known: &[OutputFormat],
) -> Result<Vec<Target>, Failure> {
    let mut targets = Vec::new();
    for path in &args.output {
        if is_standard(path) {
            targets.push(Target {
                path: None,
                format: args.format.unwrap_or(usual),
            });
            continue;
        }
        let format = match args.format {
            Some(format) => format,
            None => by_extension(path).ok_or_else(|| {
                Failure::Usage(format!(
                    "`{}` does not tell a format; --format does: {}",
                    path.display(),
                    names(known)
                ))
            })?,
        };
        targets.push(Target {
            path: Some(path.clone()),
            format,
        });
    }
    if targets.is_empty() {
        targets.push(Target {
            path: None,
            format: args.format.unwrap_or(usual),
        });
    }
    for (i, target) in targets.iter().enumerate() {
        if !known.contains(&target.format) {
            return Err(Failure::Usage(format!(
                "this command cannot write {}; it writes {}",
                name(target.format),
                names(known)
            )));
        }
        if targets[..i].iter().any(|other| other.path == target.path) {
            return Err(Failure::Usage("the same output is given twice".to_owned()));
        }
        target.check()?;
    }
    Ok(targets)
}

/// Whether it is not text. PLY may be either.
const fn is_binary(format: OutputFormat) -> bool {
    matches!(
        format,
        OutputFormat::Png | OutputFormat::Stl | OutputFormat::Glb
    )
}

fn by_extension(path: &Path) -> Option<OutputFormat> {
    // The usual ending of CityJSON is two.
    let file = path.file_name()?.to_str()?.to_ascii_lowercase();
    if file.ends_with(".city.json") {
        return Some(OutputFormat::Cityjson);
    }
    let extension = path.extension()?.to_str()?;
    OutputFormat::from_str(extension, true).ok()
}

fn name(format: OutputFormat) -> String {
    format
        .to_possible_value()
        .map_or_else(String::new, |value| value.get_name().to_owned())
}

fn names(formats: &[OutputFormat]) -> String {
    let names: Vec<_> = formats.iter().map(|f| name(*f)).collect();
    names.join(", ")
}

impl Target {
    /// Finds what can be found before anything is computed.
    fn check(&self) -> Result<(), Failure> {
        match &self.path {
            None if is_binary(self.format) && io::stdout().is_terminal() => {
                Err(Failure::Usage(format!(
                    "a terminal cannot show {}; -o names a file",
                    name(self.format)
                )))
            }
            None => Ok(()),
            Some(path) => {
                let directory = match path.parent() {
                    Some(parent) if parent.as_os_str().is_empty() => Path::new("."),
                    Some(parent) => parent,
                    None => Path::new("/"),
                };
                if path.is_dir() {
                    return Err(Failure::Input(format!(
                        "{}: is a directory",
                        path.display()
                    )));
                }
                if !directory.is_dir() {
                    return Err(Failure::Input(format!(
                        "{}: there is no directory {}",
                        path.display(),
                        directory.display()
                    )));
                }
                Ok(())
            }
        }
    }

    /// Writes it: a file takes its place when it is complete.
    pub fn write(
        &self,
        write: impl FnOnce(&mut dyn Write) -> io::Result<()>,
    ) -> Result<(), Failure> {
        let Some(path) = &self.path else {
            let mut out = BufWriter::new(io::stdout().lock());
            return write(&mut out)
                .and_then(|()| out.flush())
                .map_err(|e| Failure::file("standard output", &e));
        };
        // What a link leads to is replaced, not the link.
        let place = fs::canonicalize(path).unwrap_or_else(|_| path.clone());
        let is_special = fs::metadata(&place).is_ok_and(|m| !m.is_file());
        let result = if is_special {
            // A device or a pipe must not be replaced by a file.
            fs::OpenOptions::new()
                .write(true)
                .open(&place)
                .and_then(|file| {
                    let mut w = BufWriter::new(file);
                    write(&mut w)?;
                    w.flush()
                })
        } else {
            write_atomically(&place, |w| write(w))
        };
        result.map_err(|e| Failure::file(path.display(), &e))
    }

    /// Writes a picture.
    pub fn picture(&self, picture: &Picture, size: u32) -> Result<(), Failure> {
        if self.format == OutputFormat::Png {
            self.write(|w| picture.png(w, size).map_err(picture_error))
        } else {
            self.write(|w| picture.svg(w))
        }
    }
}

/// A picture's error as one of its file.
pub fn picture_error(error: PictureError) -> io::Error {
    match error {
        PictureError::Io(error) => error,
        error => io::Error::other(error.to_string()),
    }
}
