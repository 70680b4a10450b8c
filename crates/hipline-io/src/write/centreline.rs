//! Centrelines as GeoJSON and well-known text, with the time in every point.

use std::io::{self, Write};

use hipline::centreline::{Centreline, Line};

use super::{geojson::Collection, json::string, number::Number};
use crate::FeatureName;

/// What the numbers beyond x and y of a point in well-known text are.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Measure {
    /// `LINESTRING Z (x y time, ...)`.
    Z,
    /// `LINESTRING M (x y time, ...)`.
    M,
    /// `LINESTRING ZM (x y time width, ...)`; the width is twice the time.
    #[default]
    Zm,
}

/// Writes centrelines as one FeatureCollection of LineStrings, one line a feature; the third
/// coordinate of a point is its time, half the local width. The properties are
///
/// * `source` and `source_id`: the feature that it is the centreline of;
/// * `ends`: the numbers of the skeleton's nodes that it ends at, so that lines that meet have one
///   in common; `closed`: whether they are one;
/// * `length`; `width_min`, `width_max` and `width_mean` (over the length); `widths`, one for
///   each point.
///
/// # Errors
/// Those of `w`.
pub fn centreline_geojson<'a>(
    mut w: impl Write,
    centrelines: impl IntoIterator<Item = (FeatureName, &'a Centreline)>,
) -> io::Result<()> {
    let mut collection = Collection::new(&mut w)?;
    for (name, centreline) in centrelines {
        for line in centreline.lines() {
            let w = collection.next()?;
            properties(w, &name, line)?;
            w.write_all(b",\"geometry\":{\"type\":\"LineString\",\"coordinates\":[")?;
            for (i, point) in line.points().iter().enumerate() {
                let [x, y, time] = point.map(Number);
                write!(w, "{}[{x},{y},{time}]", if i == 0 { "" } else { "," })?;
            }
            w.write_all(b"]}}")?;
        }
    }
    collection.finish()
}

fn properties(w: &mut impl Write, name: &FeatureName, line: &Line) -> io::Result<()> {
    write!(w, "{{\"source\":{}", name.index)?;
    if let Some(id) = &name.id {
        write!(w, ",\"source_id\":{}", string(id))?;
    }
    let [from, to] = line.ends().map(|node| node.index());
    let widths = || line.points().iter().map(|point| 2.0 * point[2]);
    let length = line.length();
    write!(
        w,
        ",\"ends\":[{from},{to}],\"closed\":{},\"length\":{},\"width_min\":{},\"width_max\":{},\
         \"width_mean\":{},\"widths\":[",
        line.is_closed(),
        Number(length),
        Number(widths().fold(f64::INFINITY, f64::min)),
        Number(widths().fold(0.0, f64::max)),
        Number(mean_width(line)),
    )?;
    for (i, width) in widths().enumerate() {
        let comma = if i == 0 { "" } else { "," };
        write!(w, "{comma}{}", Number(width))?;
    }
    w.write_all(b"]}")
}

/// The width, averaged over the length.
fn mean_width(line: &Line) -> f64 {
    let steps = line.points().windows(2).map(|step| {
        let [p, q] = [step[0], step[1]];
        let length = hipline_num::hypot(q[0] - p[0], q[1] - p[1]);
        [length, length * (p[2] + q[2])]
    });
    let [length, area] = steps.fold([0.0, 0.0], |sum, step| [sum[0] + step[0], sum[1] + step[1]]);
    area / length
}

/// Writes each line of a centreline as well-known text, one a line.
///
/// # Errors
/// Those of `w`.
pub fn centreline_wkt(
    mut w: impl Write,
    centreline: &Centreline,
    measure: Measure,
) -> io::Result<()> {
    let word = match measure {
        Measure::Z => "Z",
        Measure::M => "M",
        Measure::Zm => "ZM",
    };
    for line in centreline.lines() {
        write!(w, "LINESTRING {word} (")?;
        for (i, point) in line.points().iter().enumerate() {
            let [x, y, time] = point.map(Number);
            write!(w, "{}{x} {y} {time}", if i == 0 { "" } else { ", " })?;
            if measure == Measure::Zm {
                write!(w, " {}", Number(2.0 * point[2]))?;
            }
        }
        w.write_all(b")\n")?;
    }
    Ok(())
}
