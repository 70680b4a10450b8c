//! Points from the command line and from files.

use crate::{args::PointArgs, failure::Failure, input};

/// The points on the command line, then those of a file.
pub fn all(args: &PointArgs) -> Result<Vec<[f64; 2]>, Failure> {
    let mut points = args.at.clone();
    if let Some(path) = &args.points {
        let bytes = input::bytes(path)?;
        let name = input::name(path);
        let text = std::str::from_utf8(&bytes)
            .map_err(|_| Failure::Input(format!("{name}: this is no text")))?;
        points.extend(parse(text).map_err(|e| Failure::Input(format!("{name}: {e}")))?);
    }
    Ok(points)
}

/// One point a line; empty lines and those that start with `#` are skipped, and so is a first line
/// without numbers.
fn parse(text: &str) -> Result<Vec<[f64; 2]>, String> {
    let mut points = Vec::new();
    let mut is_first = true;
    for (i, line) in text.lines().enumerate() {
        let line = line.trim_start_matches('\u{feff}').trim();
        if line.is_empty() || line.starts_with('#') {
            continue;
        }
        let words = line.split([',', ';', '\t', ' ']).filter(|w| !w.is_empty());
        let mut words = words.map(|w| w.trim_matches('"').parse::<f64>());
        let point = (words.next(), words.next());
        match point {
            (Some(Ok(x)), Some(Ok(y))) if x.is_finite() && y.is_finite() => points.push([x, y]),
            (Some(Err(_)), _) if is_first => {}
            _ => return Err(format!("line {}: no point: {line}", i + 1)),
        }
        is_first = false;
    }
    Ok(points)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn points_of_tables() {
        let points = parse("x,y,name\n1,2,a\n\n# no\n\"3\"; -4e1\n 5\t6 7\n").unwrap();
        assert_eq!(points, [[1.0, 2.0], [3.0, -40.0], [5.0, 6.0]]);
        for (text, line) in [("1,2\n3\n", 2), ("1,2\na,b\n", 2), ("1,nan", 1), ("1,", 1)] {
            let error = parse(text).unwrap_err();
            assert!(error.starts_with(&format!("line {line}:")), "{error}");
        }
    }
}
