//! Pictures of the subdivision that the envelope engine makes: after the cuts through motorcycle vertices, and after those between valleys.
//!
//! ```text
//! cargo run --release -p hipline-bench --example subdivision FAMILY:SIZE FIRST.svg LAST.svg
//! ```

use std::fmt::Write;

use hipline::subdivision::{Border, SubdivisionCell};
use hipline::{Figure, Options, Region};
use hipline_testkit::generate::{Family, tight};

/// Draws cells over the skeleton of a figure; what is white are empty cells.
fn draw(figure: &Figure, cells: &[SubdivisionCell]) -> String {
    let mut frame = [[f64::INFINITY, f64::NEG_INFINITY]; 2];
    for point in figure.vertices() {
        for k in 0..2 {
            frame[k] = [frame[k][0].min(point[k]), frame[k][1].max(point[k])];
        }
    }
    let size = (frame[0][1] - frame[0][0]).max(frame[1][1] - frame[1][0]);
    let scale = 1000.0 / size;
    let at = |p: [f64; 2]| [(p[0] - frame[0][0]) * scale, (frame[1][1] - p[1]) * scale];
    let mut svg = String::from(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"-5 -5 1010 1010\" width=\"1010\" height=\"1010\">\n\
         <rect x=\"-5\" y=\"-5\" width=\"1010\" height=\"1010\" fill=\"white\"/>\n",
    );
    for (number, cell) in cells.iter().enumerate() {
        let mut path = String::new();
        let mut last = [f64::NAN; 2];
        for &([from, to], _) in &cell.edges {
            let [x, y] = at(from);
            if from.map(f64::to_bits) != last.map(f64::to_bits) {
                let _ = write!(path, "M{x:.2} {y:.2}");
            }
            let [x, y] = at(to);
            let _ = write!(path, "L{x:.2} {y:.2}");
            last = to;
        }
        let hue = (number * 137) % 360;
        let light = if cell.valleys > 0 { 78 } else { 92 };
        let _ = writeln!(
            svg,
            "<path d=\"{path}\" fill=\"hsl({hue},60%,{light}%)\" fill-rule=\"evenodd\"/>"
        );
    }
    let mut line = |[p, q]: [[f64; 2]; 2], style: &str| {
        let ([a, b], [c, d]) = (at(p), at(q));
        let _ = writeln!(
            svg,
            "<path d=\"M{a:.2} {b:.2}L{c:.2} {d:.2}\" fill=\"none\" {style}/>"
        );
    };
    let skeleton = figure.skeleton(Options::default().region(Region::Interior));
    for arc in skeleton.arcs() {
        let ends = arc.nodes.map(|node| {
            let node = &skeleton.nodes()[node.index()];
            [node.x, node.y]
        });
        line(ends, "stroke=\"#999\" stroke-width=\"0.7\"");
    }
    for cell in cells {
        for &(ends, border) in &cell.edges {
            line(
                ends,
                match border {
                    Border::Cut => "stroke=\"#c00\" stroke-width=\"1.2\"",
                    Border::Valley => "stroke=\"#06c\" stroke-width=\"1.6\"",
                    Border::Edge => "stroke=\"black\" stroke-width=\"1.6\"",
                    _ => "stroke=\"#080\" stroke-width=\"0.8\"",
                },
            );
        }
    }
    svg.push_str("</svg>\n");
    svg
}

fn main() {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let [what, first, last] = &arguments[..] else {
        panic!("FAMILY:SIZE FIRST.svg LAST.svg");
    };
    let (name, size) = what.split_once(':').expect("FAMILY:SIZE");
    let n: usize = size.parse().expect("a size");
    let case = if name == "tight" {
        tight(n, n / 2, 1)
    } else {
        Family::named(name).expect("a family").generate(n, 1)
    };
    let figure = case.figure().expect("a figure");
    let subdivision = figure.subdivision().expect("polygons");
    for (file, cells) in [(first, &subdivision.first), (last, &subdivision.last)] {
        std::fs::write(file, draw(&figure, cells)).expect("a file that can be written");
        println!("{file}: {} cells", cells.len());
    }
}
