//! A table of motorcycles: comma-separated values with a header, one motorcycle a row.
//!
//! Columns `x`, `y`, `vx` and `vy`, and `time` if wanted, in any order.

use csv::{ReaderBuilder, StringRecord, Trim};
use hipline::motorcycle::Launch;

use super::text::{number, short};
use crate::ReadError;

const NAME: &str = "table of motorcycles";

const COLUMNS: [&str; 5] = ["x", "y", "vx", "vy", "time"];

/// Reads a table of motorcycles.
///
/// ```
/// let table = b"x,y,vx,vy\n0,0,1,0\n3,-4,0,2\n";
/// let launches = hipline_io::read_launches(table)?;
/// assert_eq!(launches[1].velocity, [0.0, 2.0]);
/// # Ok::<(), hipline_io::ReadError>(())
/// ```
///
/// # Errors
/// What is no such table, with the line.
pub fn read_launches(bytes: &[u8]) -> Result<Vec<Launch>, ReadError> {
    let bytes = bytes.strip_prefix(b"\xEF\xBB\xBF").unwrap_or(bytes);
    let mut reader = ReaderBuilder::new().trim(Trim::All).from_reader(bytes);
    let header = reader.headers().map_err(|e| content(e.to_string()))?;
    let columns = columns(header)?;
    let mut launches = Vec::new();
    for (row, record) in reader.records().enumerate() {
        // Broken records tell their lines themselves.
        let record = record.map_err(|e| content(e.to_string()))?;
        launches.push(
            launch(&columns, &record)
                .map_err(|message| content(format!("motorcycle {row}: {message}")))?,
        );
    }
    Ok(launches)
}

fn content(message: String) -> ReadError {
    ReadError::Content {
        format: NAME,
        message,
    }
}

/// In which column each of [`COLUMNS`] is.
fn columns(header: &StringRecord) -> Result<[Option<usize>; 5], ReadError> {
    let mut found = [None; 5];
    for (i, title) in header.iter().enumerate() {
        let Some(column) = COLUMNS.iter().position(|c| *c == title) else {
            return Err(content(format!(
                "line 1: {} is no column of it; those are {}",
                short(title),
                COLUMNS.join(", ")
            )));
        };
        if found[column].replace(i).is_some() {
            return Err(content(format!(
                "line 1: the column {title} is there twice"
            )));
        }
    }
    match (0..4).find(|&column| found[column].is_none()) {
        Some(column) => Err(content(format!(
            "line 1: there is no column {}",
            COLUMNS[column]
        ))),
        None => Ok(found),
    }
}

fn launch(columns: &[Option<usize>; 5], record: &StringRecord) -> Result<Launch, String> {
    let cell = |column: usize| -> Result<f64, String> {
        let text = columns[column].and_then(|i| record.get(i)).unwrap_or("");
        if column == 4 && text.is_empty() {
            return Ok(0.0);
        }
        number(text).map_err(|message| format!("{}: {message}", COLUMNS[column]))
    };
    Ok(Launch::new([cell(0)?, cell(1)?], [cell(2)?, cell(3)?]).at(cell(4)?))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tables_say_what_is_wrong_with_them() {
        for (table, expected) in [
            ("x,y,vx\n", "there is no column vy"),
            ("x,y,vx,vy,colour\n", "colour` is no column of it"),
            ("x,y,vx,vy,x\n", "the column x is there twice"),
            (
                "x,y,vx,vy\n1,2,3,4\n1,2,three,4\n",
                "motorcycle 1: vx: `three` is not a number",
            ),
            (
                "x,y,vx,vy\n1,2,,4\n",
                "motorcycle 0: vx: `` is not a number",
            ),
            ("x,y,vx,vy\n1,2,inf,4\n", "is not a finite number"),
            ("x,y,vx,vy\n1,2,3\n", "line: 2"),
        ] {
            let error = read_launches(table.as_bytes()).unwrap_err().to_string();
            assert!(error.contains(expected), "{table:?}: {error}");
        }
        let launches = read_launches(b"vy,time,x,y,vx\n4,,1,2,3\n4,0.5,1,2,3\n").unwrap();
        assert_eq!(launches[0], Launch::new([1.0, 2.0], [3.0, 4.0]));
        assert_eq!(launches[1], launches[0].at(0.5));
    }
}
