//! Arcs and offset lines as well-known text, one geometry a line.

use std::io::{self, Write};

use hipline::Skeleton;

use super::{number::Number, picture::OffsetLine, window::Window};

/// Writes each arc as `LINESTRING Z (x y time, x y time)`. Unbounded arcs are cut off at the
/// window around the finite nodes, half as large again; their last time is that of the cut.
///
/// # Errors
/// Those of `w`.
pub fn wkt(mut w: impl Write, skeleton: &Skeleton) -> io::Result<()> {
    let Some(window) = Window::of(skeleton) else {
        return Ok(());
    };
    for arc in skeleton.arcs() {
        if let Some([p, q]) = window.clip_arc(skeleton, arc) {
            let [p, q] = [p, q].map(|p| p.map(Number));
            writeln!(
                w,
                "LINESTRING Z ({} {} {}, {} {} {})",
                p[0], p[1], p[2], q[0], q[1], q[2]
            )?;
        }
    }
    Ok(())
}

/// Writes each offset line as `LINESTRING Z (x y distance, ...)`; a closed line ends where
/// it starts.
///
/// # Errors
/// Those of `w`.
pub fn lines_wkt<'a>(
    mut w: impl Write,
    lines: impl IntoIterator<Item = &'a OffsetLine>,
) -> io::Result<()> {
    for line in lines {
        w.write_all(b"LINESTRING Z (")?;
        let first = line.points.first().filter(|_| line.is_closed);
        for (i, [x, y]) in line.points.iter().chain(first).enumerate() {
            let comma = if i == 0 { "" } else { ", " };
            write!(
                w,
                "{comma}{} {} {}",
                Number(*x),
                Number(*y),
                Number(line.distance)
            )?;
        }
        w.write_all(b")\n")?;
    }
    Ok(())
}
