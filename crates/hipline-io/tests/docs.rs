//! The examples of the documentation are what they claim to be.

mod common;

use hipline_io::{Format, Shape, read, read_settings, read_skeleton, write};

/// The fenced blocks of a language in a page, each with the heading above it.
fn blocks<'a>(page: &'a str, language: &str) -> Vec<(&'a str, &'a str)> {
    let fence = format!("```{language}\n");
    let mut blocks = Vec::new();
    for section in page.split("\n## ") {
        let heading = section.lines().next().unwrap_or_default();
        for part in section.split(&fence).skip(1) {
            blocks.push((heading, part.split("```").next().unwrap_or_default()));
        }
    }
    blocks
}

#[test]
fn the_skeleton_on_the_page_is_the_one_we_write() {
    let page = include_str!("../../../docs/skeleton-json.md");
    let example = blocks(page, "json")[0].1;
    let mut json = Vec::new();
    write::json(&mut json, &common::hip_roof()).unwrap();
    assert_eq!(example, String::from_utf8(json).unwrap());
    assert_eq!(
        read_skeleton(example.as_bytes()).unwrap(),
        common::hip_roof()
    );
}

/// The properties on the page, each on a geometry of four edges, and the table.
#[test]
fn the_weights_on_the_page_can_be_read() {
    let page = include_str!("../../../docs/formats.md");
    let lines: Vec<_> = blocks(page, "properties")[0].1.lines().collect();
    assert_eq!(lines.len(), 3);
    let ring = "[[0,0],[12,0],[12,8],[0,8],[0,0]]";
    for line in lines {
        let text = format!(
            r#"{{"type":"Feature",{line},"geometry":{{"type":"Polygon","coordinates":[{ring}]}}}}"#
        );
        let document = read(text.as_bytes(), Format::GeoJson).unwrap();
        let figure = document.features[0].figure().unwrap();
        let vertices = (0..4).map(hipline::topology::VertexId::new);
        let is_high = vertices
            .map(|v| figure.height(v))
            .any(|height| height > 0.0);
        assert!(is_high || !figure.changes().is_empty(), "{line}");
        let skeleton = figure.skeleton(hipline::Options::default());
        skeleton.verify(&figure).unwrap();
    }
    let table = blocks(page, "csv")[0].1;
    let settings = read_settings(table.as_bytes(), "table").unwrap();
    let mut yard = read(
        b"v 0 0\nv 9 0\nv 9 9\nv 0 9\no yard\nf 1 2 3 4",
        Format::Obj,
    )
    .unwrap();
    yard.set(&settings).unwrap();
    assert_eq!(yard.features[0].figure().unwrap().changes().len(), 4);
}

#[test]
fn the_inputs_on_the_page_can_be_read() {
    let page = include_str!("../../../docs/formats.md");
    let mut read_formats = Vec::new();
    for language in ["json", "text", "xml"] {
        for (heading, example) in blocks(page, language) {
            let format: Format = heading.trim_start_matches('.').parse().unwrap();
            let document =
                read(example.as_bytes(), format).unwrap_or_else(|e| panic!("{heading}: {e}"));
            if format != Format::Poly {
                // .poly is told from .line by its name only.
                assert_eq!(Format::from_content(example.as_bytes()), Ok(format));
            }
            let Some(feature) = document.features.first() else {
                panic!("{heading}: nothing")
            };
            assert!(!feature.case.is_empty());
            let has_speeds = match &feature.case {
                Shape::Polygons(polygons) => polygons[0].speeds.is_some(),
                Shape::Graph(graph) => graph.speeds.is_some(),
                _ => false,
            };
            assert_eq!(
                has_speeds,
                matches!(format, Format::GeoJson | Format::GraphMl),
                "{heading}"
            );
            read_formats.push(format);
        }
    }
    assert_eq!(read_formats.len(), Format::ALL.len());
    assert!(Format::ALL.iter().all(|f| read_formats.contains(f)));
}
