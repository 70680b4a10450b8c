//! A table of weights: comma-separated values with a header, one setting a row.
//!
//! Columns `ring`, `edge` and `speed`; `feature`, `side`, `time` and `start` if wanted, in any order.
//! What a target is: see [`Target`].

use csv::{Position, ReaderBuilder, StringRecord, Trim};
use hipline::input::Sides;

use super::text::{number, short};
use crate::{ReadError, Setting, Target, Value};

const NAME: &str = "weights table";

const COLUMNS: [&str; 7] = ["feature", "ring", "edge", "side", "speed", "time", "start"];

/// Reads a table of weights. Errors about its settings call them by `name` and line.
///
/// ```
/// let table = b"ring,edge,speed\n0,2,0\n0,*,1.5\n";
/// let settings = hipline_io::read_settings(table, "speeds.csv")?;
/// assert_eq!(settings[0].origin, "speeds.csv, line 2");
/// # Ok::<(), hipline_io::ReadError>(())
/// ```
///
/// # Errors
/// What is no table of weights, with the line.
pub fn read_settings(bytes: &[u8], name: &str) -> Result<Vec<Setting>, ReadError> {
    let bytes = bytes.strip_prefix(b"\xEF\xBB\xBF").unwrap_or(bytes);
    let mut reader = ReaderBuilder::new().trim(Trim::All).from_reader(bytes);
    let columns = columns(reader.headers().map_err(|e| broken(bytes, &e))?)?;
    let mut settings = Vec::new();
    for record in reader.records() {
        let record = record.map_err(|e| broken(bytes, &e))?;
        let line = record.position().map_or(0, |place| line(bytes, place));
        let row = Row {
            columns,
            record: &record,
            origin: format!("{name}, line {line}"),
        };
        row.settings(&mut settings)
            .map_err(|message| content(format!("line {line}: {message}")))?;
    }
    Ok(settings)
}

fn content(message: String) -> ReadError {
    ReadError::Content {
        format: NAME,
        message,
    }
}

/// The line of a record, which the reader places before the empty lines that it passed over.
fn line(bytes: &[u8], place: &Position) -> u64 {
    let start = usize::try_from(place.byte()).unwrap_or(usize::MAX);
    let rest = bytes.get(start..).unwrap_or_default();
    let breaks = rest.iter().take_while(|b| matches!(b, b'\r' | b'\n'));
    place.line() + breaks.filter(|b| **b == b'\n').count() as u64
}

fn broken(bytes: &[u8], e: &csv::Error) -> ReadError {
    let place = e.position().map_or_else(String::new, |place| {
        format!("line {}: ", line(bytes, place))
    });
    content(match e.kind() {
        csv::ErrorKind::Utf8 { .. } => format!("{place}not UTF-8 text"),
        csv::ErrorKind::UnequalLengths {
            expected_len, len, ..
        } => format!("{place}{len} cells, but there are {expected_len} columns"),
        _ => e.to_string(),
    })
}

/// In which column each of [`COLUMNS`] is.
fn columns(header: &StringRecord) -> Result<[Option<usize>; 7], ReadError> {
    let mut found = [None; 7];
    for (i, title) in header.iter().enumerate() {
        let Some(column) = COLUMNS.iter().position(|c| *c == title) else {
            let known = COLUMNS.join(", ");
            return Err(content(format!(
                "line 1: {} is no column of a table of weights; those are {known}",
                short(title)
            )));
        };
        if found[column].replace(i).is_some() {
            return Err(content(format!(
                "line 1: the column {title} is there twice"
            )));
        }
    }
    if found[2].is_none() {
        return Err(content("line 1: there is no column edge".to_owned()));
    }
    if found[4].is_none() && found[6].is_none() {
        return Err(content(
            "line 1: there is no column speed, and none start".to_owned(),
        ));
    }
    Ok(found)
}

struct Row<'a> {
    columns: [Option<usize>; 7],
    record: &'a StringRecord,
    origin: String,
}

impl Row<'_> {
    /// What a cell of one of [`COLUMNS`] says, if anything.
    fn cell(&self, column: usize) -> Option<&str> {
        let text = self.record.get(self.columns[column]?)?;
        (!text.is_empty()).then_some(text)
    }

    /// A number that is not negative.
    fn number(&self, column: usize) -> Result<Option<f64>, String> {
        let Some(text) = self.cell(column) else {
            return Ok(None);
        };
        match number(text) {
            Ok(value) if value < 0.0 => Err(format!("{}: {value} is below 0", COLUMNS[column])),
            Ok(value) => Ok(Some(value)),
            Err(message) => Err(format!("{}: {message}", COLUMNS[column])),
        }
    }

    /// A number of a ring or an edge; `None` for all of them.
    fn index(&self, column: usize) -> Result<Option<usize>, String> {
        match self.cell(column) {
            Some("*") => Ok(None),
            Some(text) => text.parse().map(Some).map_err(|_| {
                let title = COLUMNS[column];
                format!("{title}: {} is neither a number from 0 nor *", short(text))
            }),
            None if column == 1 => Ok(Some(0)),
            None => Err("it names no edge".to_owned()),
        }
    }

    fn settings(&self, settings: &mut Vec<Setting>) -> Result<(), String> {
        let target = Target {
            feature: self.cell(0).filter(|name| *name != "*").map(str::to_owned),
            ring: self.index(1)?,
            index: self.index(2)?,
        };
        let sides = match self.cell(3) {
            None | Some("both") => Sides::Both,
            Some("left") => Sides::Left,
            Some("right") => Sides::Right,
            Some(other) => {
                return Err(format!("side: {} is not left, right or both", short(other)));
            }
        };
        let [speed, time, start] = [self.number(4)?, self.number(5)?, self.number(6)?];
        let speed = match (speed, time.filter(|time| *time > 0.0)) {
            (None, _) if time.is_some() => return Err("it has a time, but no speed".to_owned()),
            (None, _) if start.is_none() => return Err("it has no speed and no start".to_owned()),
            (None, _) => None,
            (Some(speed), None) => Some(Value::Weight(speed)),
            (Some(speed), Some(time)) => Some(Value::From { time, speed }),
        };
        for value in [speed, start.map(Value::Start)].into_iter().flatten() {
            settings.push(Setting {
                target: target.clone(),
                sides,
                value,
                origin: self.origin.clone(),
            });
        }
        Ok(())
    }
}
