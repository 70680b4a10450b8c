//! The program as a user meets it: each command, formats, pipes, exit codes, flawed input.

mod common;

use std::{fs, path::Path};

use common::{Scratch, code, err, json, out, run};
use expect_test::expect;
use serde_json::Value;

const RECTANGLE: &str = "POLYGON ((0 0, 8 0, 8 4, 0 4, 0 0))";

/// Three features; the second crosses itself.
const ONE_BAD: &str = r#"{"type":"FeatureCollection","features":[
{"type":"Feature","id":"a","properties":{},"geometry":{"type":"Polygon","coordinates":[[[0,0],[4,0],[4,4],[0,4],[0,0]]]}},
{"type":"Feature","id":"bow","properties":{},"geometry":{"type":"Polygon","coordinates":[[[0,0],[4,4],[4,0],[0,4],[0,0]]]}},
{"type":"Feature","id":"c","properties":{},"geometry":{"type":"Polygon","coordinates":[[[10,0],[14,0],[14,3],[10,3],[10,0]]]}}
]}"#;

#[test]
fn help() {
    let output = run(&["--help"], "");
    assert_eq!(code(&output), 0);
    expect![[r#"
        Exact straight skeletons of polygons, lines and planar graphs, with weights

        Usage: hipline <COMMAND>

        Commands:
          skeleton     Compute the straight skeletons of a file's features
          offset       Move a figure's edges by given distances
          centreline   Find the line in the middle: the approximate medial axis
          roof         Build roofs over polygons
          terrain      Turn rivers, lakes and coasts into a terrain
          rain         Follow rain: the path of a drop, or what drains where
          query        Ask for height, face and input edge at points
          motorcycles  Compute the motorcycle graphs of polygons, or of motorcycles in a table
          check        Check an input, or a result against it
          draw         Draw an input or a skeleton as it is, without computing
          completions  Print a script that completes hipline's commands and flags in a shell
          help         Print this message or the help of the given subcommand(s)

        Options:
          -h, --help     Print help
          -V, --version  Print version

        Examples:
          hipline skeleton village.geojson -o village.svg
          hipline offset park.wkt --step 0.5 -o park.png
          hipline centreline river.geojson --prune-ratio 1 --extend -o middle.geojson
          hipline roof house.geojson --slope 35deg -o house.obj -o house.png
          hipline terrain rivers.geojson -o relief.png --contours 5
          hipline rain rivers.geojson --catchments system -o basins.png
          hipline query rivers.geojson --at 3,4
          hipline motorcycles village.geojson -o tracks.svg
          hipline skeleton parcels.geojson > parcels.json
          hipline check parcels.geojson --result parcels.json

        Exit codes:
          0  done
          1  something is wrong with the input: a file, a feature, or a result
          2  wrong usage
    "#]]
    .assert_eq(out(&output));
    for command in ["skeleton", "offset", "roof", "check", "draw"] {
        let output = run(&[command, "--help"], "");
        assert!(out(&output).contains("Examples:"), "{command}");
    }
}

#[test]
fn skeleton_from_a_pipe() {
    let output = run(&["skeleton", "-"], RECTANGLE);
    assert_eq!(code(&output), 0, "{}", err(&output));
    assert_eq!(err(&output), "");
    let result = json(out(&output));
    assert_eq!(result["format"], "hipline-skeleton");
    assert_eq!(result["region"], "interior");
    assert_eq!(result["nodes"].as_array().unwrap().len(), 6);
    assert_eq!(result["nodes"][4]["time"], 2);
    assert_eq!(result["arcs"].as_array().unwrap().len(), 5);

    let output = run(
        &["skeleton", "-", "--side", "both", "--engine", "kinetic"],
        RECTANGLE,
    );
    assert_eq!(json(out(&output))["region"], "both");
    assert_eq!(json(out(&output))["faces"].as_array().unwrap().len(), 8);
}

#[test]
fn every_input_format() {
    let graphml = r#"<graphml><key id="x" for="node" attr.name="vertex-coordinate-x" attr.type="string"/>
        <key id="y" for="node" attr.name="vertex-coordinate-y" attr.type="string"/>
        <graph edgedefault="undirected">
        <node id="a"><data key="x">0</data><data key="y">0</data></node>
        <node id="b"><data key="x">8</data><data key="y">0</data></node>
        <edge source="a" target="b"/></graph></graphml>"#;
    let geojson = r#"{"type":"LineString","coordinates":[[0,0],[8,0]]}"#;
    let scratch = Scratch::new("inputs");
    for (name, content, faces) in [
        ("a.geojson", geojson, 4),
        ("a.wkt", "LINESTRING (0 0, 8 0)", 4),
        ("a.graphml", graphml, 4),
        ("a.line", "2\n0 0\n8 0\n", 4),
        ("a.obj", "v 0 0 0\nv 8 0 0\nl 1 2\n", 4),
        ("a.poly", "1\n4\n0 0\n8 0\n8 4\n0 4\n", 4),
        ("no-extension", "LINESTRING (0 0, 8 0)", 4),
    ] {
        let path = scratch.file(name, content);
        let output = run(&["skeleton", &path], "");
        assert_eq!(code(&output), 0, "{name}: {}", err(&output));
        let list = json(out(&output))["faces"].as_array().unwrap().len();
        assert_eq!(list, faces, "{name}");
        if let Some((_, format)) = name.split_once('.') {
            let output = run(&["skeleton", "-", "--from", format], content);
            assert_eq!(code(&output), 0, "--from {format}: {}", err(&output));
        }
    }
}

#[test]
fn every_output_format() {
    let scratch = Scratch::new("outputs");
    let names = ["r.json", "r.geojson", "r.wkt", "r.obj", "r.svg", "r.png"];
    let paths = names.map(|name| scratch.path(name));
    let mut args = vec!["skeleton", "-", "--size", "200", "--no-nodes"];
    for path in &paths {
        args.extend(["-o", path]);
    }
    let output = run(&args, RECTANGLE);
    assert_eq!(code(&output), 0, "{}", err(&output));
    assert_eq!(out(&output), "");
    let mut sorted = names.map(str::to_owned).to_vec();
    sorted.sort();
    assert_eq!(scratch.names(), sorted, "nothing else is left behind");
    let read = |i: usize| fs::read_to_string(&paths[i]).unwrap();
    assert_eq!(json(&read(0))["arcs"].as_array().unwrap().len(), 5);
    // 6 nodes, 5 arcs, 4 faces.
    assert_eq!(json(&read(1))["features"].as_array().unwrap().len(), 15);
    let ridge = ["(2 2 2, 6 2 2)", "(6 2 2, 2 2 2)"];
    assert!(ridge.iter().any(|r| read(2).contains(r)), "{}", read(2));
    assert_eq!(read(3).lines().filter(|l| l.starts_with("f ")).count(), 4);
    assert!(read(3).contains("v 2 2 2"), "{}", read(3));
    assert!(read(4).starts_with("<svg ") && read(4).contains("id=\"ridge\""));
    assert!(!read(4).contains("<circle"), "without nodes");
    let png = fs::read(&paths[5]).unwrap();
    assert!(png.starts_with(b"\x89PNG\r\n"));
    assert_eq!(png[16..20], [0, 0, 0, 200], "the width");

    for format in ["json", "geojson", "wkt", "obj", "svg", "png"] {
        let output = run(
            &["skeleton", "-", "--size", "200", "--no-nodes", "-f", format],
            RECTANGLE,
        );
        assert_eq!(code(&output), 0, "{format}");
        assert_eq!(
            output.stdout,
            fs::read(scratch.path(&format!("r.{format}"))).unwrap(),
            "the same on standard output as {format}"
        );
    }
    let output = run(&["skeleton", "-", "-f", "svg", "--labels"], RECTANGLE);
    assert!(out(&output).contains(">n4<"), "labels are drawn");
}

#[test]
fn a_bad_feature_among_good_ones() {
    let scratch = Scratch::new("bad");
    let input = scratch.file("in.geojson", ONE_BAD);
    let output = run(&["skeleton", &input], "");
    assert_eq!(code(&output), 1);
    assert!(
        err(&output).starts_with("error: feature 1 (\"bow\"): "),
        "{}",
        err(&output)
    );
    assert_eq!(err(&output).lines().count(), 1);
    let result = json(out(&output));
    assert_eq!(result["format"], "hipline-skeletons");
    let results = result["results"].as_array().unwrap();
    assert_eq!(results.len(), 3);
    assert_eq!(results[0]["id"], "a");
    assert!(results[0]["skeleton"].is_object());
    assert!(results[1]["error"].as_str().unwrap().contains("cross"));
    assert!(results[2]["skeleton"].is_object());

    for (args, good) in [
        (vec!["skeleton", &input, "-f", "obj"], "o c\n"),
        (vec!["offset", &input, "-d", "1"], "\"source_id\":\"c\""),
        (vec!["roof", &input], "o c\n"),
    ] {
        let output = run(&args, "");
        assert_eq!(code(&output), 1, "{args:?}");
        assert!(err(&output).contains("feature 1 (\"bow\")"), "{args:?}");
        assert!(out(&output).contains(good), "{args:?}");
    }

    let output = run(&["skeleton", &input, "--together"], "");
    assert_eq!(code(&output), 1);
    assert!(
        err(&output).contains("3 features together"),
        "{}",
        err(&output)
    );
}

#[test]
fn nothing_is_written_when_everything_fails() {
    let scratch = Scratch::new("hopeless");
    let target = scratch.file("out.json", "before");
    let bow = "POLYGON ((0 0, 4 4, 4 0, 0 4))\nPOINT (1 1)";
    let output = run(&["skeleton", "-", "-o", &target], bow);
    assert_eq!(code(&output), 1);
    assert_eq!(err(&output).lines().count(), 2, "{}", err(&output));
    assert_eq!(fs::read_to_string(&target).unwrap(), "before");
    let output = run(&["skeleton", "-"], bow);
    assert_eq!((code(&output), out(&output)), (1, ""));
}

#[test]
fn unwritable_places_are_found_before_anything_is_computed() {
    let scratch = Scratch::new("unwritable");
    let inside_none = scratch.path("none/out.svg");
    let output = run(&["skeleton", "-", "-o", &inside_none], RECTANGLE);
    assert_eq!(code(&output), 1);
    assert!(
        err(&output).contains("there is no directory"),
        "{}",
        err(&output)
    );
    let output = run(
        &[
            "skeleton",
            "-",
            "-f",
            "svg",
            "-o",
            scratch.0.to_str().unwrap(),
        ],
        RECTANGLE,
    );
    assert_eq!(code(&output), 1);
    assert!(err(&output).contains("is a directory"), "{}", err(&output));
    assert_eq!(scratch.names(), Vec::<String>::new());
}

#[cfg(unix)]
#[test]
fn devices_and_links_are_not_replaced() {
    use std::os::unix::fs::{FileTypeExt, symlink};
    let output = run(
        &["skeleton", "-", "-f", "json", "-o", "/dev/null"],
        RECTANGLE,
    );
    assert_eq!(code(&output), 0, "{}", err(&output));
    let kind = fs::metadata("/dev/null").unwrap().file_type();
    assert!(kind.is_char_device());

    let scratch = Scratch::new("links");
    let file = scratch.file("file.svg", "before");
    let link = scratch.path("link.svg");
    symlink(&file, &link).unwrap();
    assert_eq!(code(&run(&["skeleton", "-", "-o", &link], RECTANGLE)), 0);
    assert!(fs::symlink_metadata(&link).unwrap().is_symlink());
    assert!(fs::read_to_string(&file).unwrap().starts_with("<svg"));
}

#[test]
fn a_reader_that_goes_away_is_no_failure() {
    use std::{io::Read, process::Stdio};
    let points: Vec<String> = (0..20_000).map(|i| format!("{i} {}", i % 2)).collect();
    let scratch = Scratch::new("pipe");
    let input = scratch.file("in.wkt", &format!("LINESTRING ({})", points.join(", ")));
    let mut child = std::process::Command::new(assert_cmd::cargo::cargo_bin("hipline"))
        .args(["draw", &input])
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    let mut first = [0; 4];
    let mut pipe = child.stdout.take().unwrap();
    pipe.read_exact(&mut first).unwrap();
    drop(pipe);
    let output = child.wait_with_output().unwrap();
    assert_eq!(&first, b"<svg");
    assert_eq!((code(&output), err(&output)), (0, ""));
}

#[test]
fn wrong_usage() {
    for (args, says) in [
        (vec!["skeleton"], "<IN>"),
        (vec!["skelton", "-"], "skeleton"),
        (vec!["offset", "-"], "--distance"),
        (vec!["offset", "-", "--distance", "nan"], "must be finite"),
        (vec!["offset", "-", "--distance", "1,inf"], "must be finite"),
        (
            vec!["offset", "-", "--distance", "-1"],
            "must not be below 0",
        ),
        (vec!["offset", "-", "--step", "0"], "must be above 0"),
        (
            vec!["offset", "-", "--step", "1", "--distance", "1"],
            "cannot be used with",
        ),
        (
            vec!["offset", "-", "--distance", "1", "--count", "2"],
            "cannot be used with",
        ),
        (
            vec!["offset", "-", "--step", "1", "--side", "exterior"],
            "--step needs --count",
        ),
        (
            vec!["offset", "-", "-d", "1", "-f", "obj"],
            "cannot write obj",
        ),
        (vec!["roof", "-", "--slope", "90deg"], "below 90"),
        (vec!["roof", "-", "--slope", "nan"], "must be finite"),
        (
            vec!["skeleton", "-", "-o", "x.dwg"],
            "does not tell a format",
        ),
        (
            vec!["skeleton", "-", "-o", "x.svg", "-o", "x.svg"],
            "given twice",
        ),
        (vec!["draw", "-", "-f", "json"], "cannot write json"),
        (vec!["skeleton", "-", "--size", "0"], "1..=16384"),
        (vec!["skeleton", "-", "--side", "left"], "interior"),
    ] {
        let output = run(&args, RECTANGLE);
        assert_eq!(code(&output), 2, "{args:?}: {}", err(&output));
        assert!(err(&output).starts_with("error: "), "{args:?}");
        assert!(err(&output).contains(says), "{args:?}: {}", err(&output));
        assert_eq!(out(&output), "", "{args:?}");
    }
}

#[test]
fn bad_files() {
    let scratch = Scratch::new("files");
    let broken = scratch.file(
        "broken.geojson",
        "{\"type\": \"Polygon\",\n \"coordinates\": [[[0,",
    );
    let output = run(&["skeleton", &broken], "");
    assert_eq!(code(&output), 1);
    assert!(
        err(&output).contains("broken.geojson: GeoJSON, line 2"),
        "{}",
        err(&output)
    );
    let missing = scratch.path("missing.wkt");
    let output = run(&["check", &missing], "");
    assert_eq!(code(&output), 1);
    assert!(err(&output).contains("missing.wkt"), "{}", err(&output));
    for garbage in ["", "hello", "\u{0}\u{1}\u{2}", "-1 2"] {
        let output = run(&["skeleton", "-"], garbage);
        assert_eq!(code(&output), 1, "{garbage:?}");
        assert!(
            err(&output).starts_with("error: standard input"),
            "{}",
            err(&output)
        );
    }
}

#[test]
fn offsets_as_data() {
    let courtyard = "POLYGON ((0 0, 12 0, 12 12, 0 12), (5 5, 5 7, 7 7, 7 5))";
    let output = run(&["offset", "-", "--distance", "1,2"], courtyard);
    assert_eq!(code(&output), 0, "{}", err(&output));
    let features = json(out(&output));
    let features = features["features"].as_array().unwrap();
    assert_eq!(features.len(), 2);
    assert_eq!(features[0]["properties"]["distance"], 1.0);
    assert_eq!(features[0]["geometry"]["type"], "MultiPolygon");
    let polygons = features[0]["geometry"]["coordinates"].as_array().unwrap();
    assert_eq!(polygons.len(), 1);
    let rings = polygons[0].as_array().unwrap();
    assert_eq!(rings.len(), 2, "with its hole");
    for ring in rings {
        let ring = ring.as_array().unwrap();
        assert_eq!(ring.len(), 5);
        assert_eq!(ring.first(), ring.last(), "closed");
    }

    let output = run(&["offset", "-", "--step", "0.5", "-f", "wkt"], RECTANGLE);
    let lines: Vec<_> = out(&output).lines().collect();
    assert_eq!(lines.len(), 3, "at 2 nothing is left: {lines:?}");
    assert!(
        lines.iter().all(|l| l.starts_with("POLYGON Z ((")),
        "{lines:?}"
    );
    assert!(lines[1].contains("1.0 1.0 1.0"), "{lines:?}");

    let args = [
        "offset", "-", "--step", "1", "--count", "2", "--side", "exterior",
    ];
    let output = run(&args, RECTANGLE);
    let features = json(out(&output));
    let features = features["features"].as_array().unwrap();
    assert_eq!(features.len(), 2);
    assert_eq!(features[1]["geometry"]["type"], "MultiPolygon");
    let polygons: Vec<Vec<Vec<[f64; 2]>>> =
        serde_json::from_value(features[1]["geometry"]["coordinates"].clone()).unwrap();
    let [rings] = &polygons[..] else {
        panic!("one polygon: {polygons:?}")
    };
    let [ring] = &rings[..] else {
        panic!("no hole: {rings:?}")
    };
    let area: f64 = ring
        .windows(2)
        .map(|e| e[0][0] * e[1][1] - e[1][0] * e[0][1])
        .sum();
    assert_eq!((area / 2.0).to_string(), "96", "grown, counterclockwise");

    // Around lines, too; and every edge tells where it comes from.
    let args = ["offset", "-", "--distance", "1,3", "--edges"];
    let frame = "MULTILINESTRING ((0 0, 8 0, 8 8, 0 8, 0 0), (20 0, 28 0))";
    let output = run(&args, frame);
    let features = json(out(&output));
    let shapes = features["features"]
        .as_array()
        .unwrap()
        .iter()
        .map(|feature| {
            let edges: Vec<Vec<Vec<[usize; 3]>>> =
                serde_json::from_value(feature["properties"]["edges"].clone()).unwrap();
            let rings: Vec<Vec<Vec<[f64; 2]>>> =
                serde_json::from_value(feature["geometry"]["coordinates"].clone()).unwrap();
            for (edges, ring) in edges.iter().flatten().zip(rings.iter().flatten()) {
                assert_eq!(edges.len() + 1, ring.len(), "one for each edge");
            }
            let parts: Vec<Vec<usize>> = edges
                .iter()
                .map(|rings| rings.iter().map(|edges| edges[0][0]).collect())
                .collect();
            parts
        });
    assert_eq!(
        shapes.collect::<Vec<_>>(),
        [vec![vec![0, 0], vec![1]], vec![vec![0, 0], vec![1]]]
    );

    let output = run(&["offset", "-", "--step", "1e-9"], RECTANGLE);
    assert_eq!(code(&output), 1);
    assert!(
        err(&output).contains("--count limits them"),
        "{}",
        err(&output)
    );
}

#[test]
fn offsets_in_a_picture() {
    let output = run(&["offset", "-", "--step", "0.5", "-f", "svg"], RECTANGLE);
    let svg = out(&output);
    assert!(svg.contains("id=\"offsets\"") && svg.contains("id=\"input\""));
    assert!(!svg.contains("id=\"faces\""), "the skeleton is not drawn");
    let output = run(
        &["offset", "-", "--step", "0.5", "-f", "svg", "--skeleton"],
        RECTANGLE,
    );
    assert!(out(&output).contains("id=\"faces\""));
}

/// Vertices and faces of an OBJ file.
fn mesh(obj: &str) -> (Vec<[f64; 3]>, Vec<Vec<usize>>) {
    let numbers = |line: &str| -> Vec<f64> {
        let words = line.split(' ').skip(1);
        words.map(|word| word.parse().unwrap()).collect()
    };
    let lines = |lead: &'static str| obj.lines().filter(move |l| l.starts_with(lead));
    let vertices = lines("v ")
        .map(|l| numbers(l).try_into().unwrap())
        .collect();
    let faces = lines("f ").map(|l| numbers(l).iter().map(|n| *n as usize - 1).collect());
    (vertices, faces.collect())
}

/// Edges without the reverse edge of a neighbour.
fn open_edges(faces: &[Vec<usize>]) -> usize {
    let edges: Vec<_> = faces
        .iter()
        .flat_map(|f| (0..f.len()).map(|i| (f[i], f[(i + 1) % f.len()])))
        .collect();
    edges
        .iter()
        .filter(|(a, b)| !edges.contains(&(*b, *a)))
        .count()
}

#[test]
fn roofs() {
    let two =
        format!("{RECTANGLE}\nPOLYGON ((20 0, 32 0, 32 12, 20 12), (25 5, 25 7, 27 7, 27 5))");
    let output = run(&["roof", "-", "--slope", "0.5"], &two);
    assert_eq!(code(&output), 0, "{}", err(&output));
    assert!(out(&output).starts_with("o feature_0\n") && out(&output).contains("\no feature_1\n"));
    let (vertices, faces) = mesh(out(&output));
    assert!(vertices.contains(&[2.0, 2.0, 1.0]), "{vertices:?}");
    assert_eq!(open_edges(&faces), 0, "watertight");

    let (_, open) = mesh(out(&run(&["roof", "-", "--open"], &two)));
    assert_eq!((open.len(), open_edges(&open)), (12, 12));
    let (_, triangles) = mesh(out(&run(&["roof", "-", "--triangles"], &two)));
    assert!(triangles.iter().all(|f| f.len() == 3));
    assert_eq!(open_edges(&triangles), 0, "watertight");

    let scratch = Scratch::new("roofs");
    let [png, svg] = ["a.png", "a.svg"].map(|name| scratch.path(name));
    let output = run(
        &["roof", "-", "-o", &png, "-o", &svg, "--size", "300"],
        &two,
    );
    assert_eq!(code(&output), 0, "{}", err(&output));
    assert!(fs::read(png).unwrap().starts_with(b"\x89PNG"));
    assert!(fs::read_to_string(svg).unwrap().contains("id=\"ridge\""));

    for name in ["a.ply", "a.stl", "a.glb", "a.gltf", "a.city.json"] {
        let path = scratch.path(name);
        let flags = [
            "roof",
            "-",
            "--eaves",
            "3",
            "--overhang",
            "0.5",
            "-o",
            &path,
        ];
        let output = run(&flags, &two);
        assert_eq!(code(&output), 0, "{name}: {}", err(&output));
        let start: &[u8] = match name {
            "a.ply" => b"ply\nformat binary_little_endian 1.0\n",
            "a.stl" => b"hipline origin ",
            "a.glb" => b"glTF",
            "a.gltf" => b"{\"accessors\":",
            _ => b"{\"CityObjects\":",
        };
        assert!(fs::read(&path).unwrap().starts_with(start), "{name}");
    }

    let output = run(&["roof", "-"], "LINESTRING (0 0, 1 0)");
    assert_eq!((code(&output), out(&output)), (1, ""));
    assert!(
        err(&output).starts_with("error: feature 0: a roof needs"),
        "{}",
        err(&output)
    );
}

/// The heights of the vertices of a roof over a rectangle of 8 by 4 with such properties.
fn heights(properties: &str, flags: &[&str]) -> Result<Vec<f64>, String> {
    let feature = format!(
        "{{\"type\":\"Feature\",\"properties\":{properties},\"geometry\":{{\"type\":\"Polygon\",\
         \"coordinates\":[[[0,0],[8,0],[8,4],[0,4],[0,0]]]}}}}"
    );
    let output = run(&[&["roof", "-"], flags].concat(), &feature);
    if code(&output) != 0 {
        return Err(err(&output).to_owned());
    }
    let (vertices, faces) = mesh(out(&output));
    assert_eq!(open_edges(&faces), 0, "watertight");
    let mut heights: Vec<f64> = vertices.iter().map(|v| v[2]).collect();
    heights.sort_by(f64::total_cmp);
    heights.dedup();
    Ok(heights)
}

#[test]
fn tags_and_flags_of_roofs() {
    let tagged = r#"{"roof:shape":"hipped","roof:angle":45,"height":"9 m","min_height":1}"#;
    for (properties, flags, expected) in [
        ("{}", &[][..], &[0.0, 2.0][..]),
        (tagged, &[], &[1.0, 7.0, 9.0]),
        (tagged, &["--no-tags"], &[0.0, 2.0]),
        (tagged, &["--slope", "1:2"], &[1.0, 8.0, 9.0]),
        (tagged, &["--height", "3"], &[1.0, 6.0, 9.0]),
        (tagged, &["--eaves", "4", "--floor", "0"], &[0.0, 4.0, 6.0]),
        (tagged, &["--overhang", "0.5"], &[1.0, 6.5, 9.0]),
        (tagged, &["--shape", "flat"], &[1.0, 9.0]),
        (r#"{"roof:shape":"flat","height":5}"#, &[], &[0.0, 5.0]),
        (r#"{"roof:height":3}"#, &["--eaves", "2"], &[0.0, 2.0, 5.0]),
        (
            "{}",
            &["--edge-slope", "1=2", "--slope", "0.5"],
            &[0.0, 1.0],
        ),
        // Two up at three to one, then one to one as far as the middle.
        ("{}", &["--shape", "mansard"], &[0.0, 2.0, 10.0 / 3.0]),
        ("{}", &["--gable", "auto"], &[0.0, 2.0]),
    ] {
        assert_eq!(
            heights(properties, flags).as_deref(),
            Ok(expected),
            "{properties} {flags:?}"
        );
    }
    for (properties, flags, message) in [
        (
            "{}",
            &["--edge-slope", "4=1"][..],
            "there is no part 0, ring 0, edge 4",
        ),
        (
            "{}",
            &["--eaves", "1", "--overhang", "2"],
            "the eaves at height -1 are below the floor",
        ),
        (r#"{"roof:angle":"steep"}"#, &[], "roof:angle is \"steep\""),
        (
            r#"{"height":1,"min_height":2}"#,
            &[],
            "are below the floor at 2",
        ),
    ] {
        let error = heights(properties, flags).expect_err(message);
        assert!(
            error.starts_with("error: feature 0: ") && error.contains(message),
            "{error}"
        );
    }
    let output = run(&["roof", "-", "--edge-slope", "1:2"], "");
    assert_eq!(code(&output), 2);
}

#[test]
fn check_finds_every_flaw() {
    let output = run(&["check", "-"], &format!("{RECTANGLE}\nPOLYGON EMPTY"));
    assert_eq!(code(&output), 0, "{}", err(&output));
    assert_eq!(
        out(&output),
        "ok: 2 features (1 empty), 4 vertices, 4 edges\n"
    );
    let output = run(&["check", "-"], ONE_BAD);
    assert_eq!((code(&output), out(&output)), (1, ""));
    assert!(
        err(&output).contains("error: feature 1 (\"bow\"): "),
        "{}",
        err(&output)
    );
    assert!(
        err(&output).ends_with("error: 1 of 3 features flawed\n"),
        "{}",
        err(&output)
    );
}

#[test]
fn check_verifies_results() {
    let scratch = Scratch::new("verify");
    let two = format!("{RECTANGLE}\nLINESTRING (20 0, 30 3, 31 9)\nPOLYGON EMPTY");
    let input = scratch.file("in.wkt", &two);
    for mode in [&[][..], &["--together"][..]] {
        let result = scratch.path("result.json");
        let args = [&["skeleton", &input, "-o", &result], mode].concat();
        assert_eq!(code(&run(&args, "")), 0);
        let args = [&["check", &input, "--result", &result], mode].concat();
        let output = run(&args, "");
        assert_eq!(code(&output), 0, "{}", err(&output));
        assert!(out(&output).starts_with("ok: "), "{}", out(&output));
        assert!(out(&output).contains(" verified: "), "{}", out(&output));
    }
    let good = out(&run(&["skeleton", "-"], RECTANGLE)).to_owned();
    let rectangle = scratch.file("rectangle.wkt", RECTANGLE);
    for (what, bad, says) in [
        (
            "moved",
            good.replace("\"x\":6,\"y\":2", "\"x\":6.5,\"y\":2"),
            "feature 0: ",
        ),
        (
            "another",
            out(&run(&["skeleton", "-"], "POLYGON ((0 0, 8 0, 8 5))")).to_owned(),
            "violation",
        ),
        (
            "broken",
            good.replace("[3,0]]", "[3,99]]"),
            "there is no such vertex",
        ),
        (
            "cut",
            good[..good.len() / 2].to_owned(),
            "skeleton JSON, line",
        ),
    ] {
        assert_ne!(bad, good, "{what}");
        let bad = scratch.file("bad.json", &bad);
        let output = run(&["check", &rectangle, "--result", &bad], "");
        assert_eq!((code(&output), out(&output)), (1, ""), "{what}");
        assert!(err(&output).contains(says), "{what}: {}", err(&output));
    }
    let output = run(
        &[
            "check",
            &input,
            "--result",
            &scratch.file("one.json", &good),
        ],
        "",
    );
    assert_eq!(code(&output), 1);
    assert!(
        err(&output).contains("feature 1: there is no result for it"),
        "{}",
        err(&output)
    );
}

#[test]
fn draw_inputs_and_results() {
    let output = run(&["draw", "-"], RECTANGLE);
    assert_eq!(code(&output), 0, "{}", err(&output));
    assert!(out(&output).contains("id=\"input\""));
    let bow = run(&["draw", "-"], "POLYGON ((0 0, 4 4, 4 0, 0 4))");
    assert_eq!(code(&bow), 0, "a flawed figure can be seen");
    assert!(
        err(&bow).starts_with("warning: feature 0: "),
        "{}",
        err(&bow)
    );

    let result = run(&["skeleton", "-"], RECTANGLE);
    let drawn = run(&["draw", "-"], out(&result));
    let direct = run(&["skeleton", "-", "-f", "svg"], RECTANGLE);
    assert_eq!(
        out(&drawn),
        out(&direct),
        "a result is drawn as it was computed"
    );
    let drawn = run(
        &["draw", "-", "--no-faces", "--no-arcs", "--no-input"],
        out(&result),
    );
    assert!(!out(&drawn).contains("id=\"faces\"") && out(&drawn).contains("id=\"nodes\""));
}

#[test]
fn empty_inputs() {
    let output = run(
        &["skeleton", "-"],
        r#"{"type":"FeatureCollection","features":[]}"#,
    );
    assert_eq!(code(&output), 0, "{}", err(&output));
    assert_eq!(json(out(&output))["results"], Value::Array(vec![]));
    let output = run(&["skeleton", "-"], "POLYGON EMPTY");
    assert_eq!(code(&output), 0, "{}", err(&output));
    assert_eq!(json(out(&output))["nodes"], Value::Array(vec![]));
    for command in ["offset", "roof", "draw"] {
        let args = [command, "-", "--distance", "1"];
        let args = if command == "offset" {
            &args[..]
        } else {
            &args[..2]
        };
        assert_eq!(code(&run(args, "POLYGON EMPTY")), 0, "{command}");
    }
}

#[test]
fn stats_go_to_standard_error() {
    let output = run(&["skeleton", "-", "--stats"], RECTANGLE);
    assert_eq!(json(out(&output))["format"], "hipline-skeleton");
    assert!(
        err(&output).contains("skeleton   6 nodes, 5 arcs, 4 faces"),
        "{}",
        err(&output)
    );
    assert!(
        err(&output).contains("by exact integers"),
        "{}",
        err(&output)
    );
}

#[test]
fn completions_and_man_page() {
    let output = run(&["completions", "bash"], "");
    assert!(out(&output).contains("_hipline()"));
    assert!(out(&run(&["man"], "")).contains(".TH hipline 1"));
}

#[test]
fn the_village() {
    let village = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../corpus/village.geojson");
    let village = village.to_str().unwrap();
    let scratch = Scratch::new("village");
    let [svg, result] = ["village.svg", "village.json"].map(|name| scratch.path(name));
    let output = run(&["skeleton", village, "-o", &svg, "-o", &result], "");
    assert_eq!((code(&output), err(&output)), (0, ""));
    assert!(fs::read_to_string(svg).unwrap().matches("<path ").count() >= 202);
    let output = run(&["check", village, "--result", &result], "");
    assert_eq!(
        out(&output),
        "ok: 26 skeletons verified: 353 nodes, 329 arcs, 202 faces; 26 certified\n"
    );
}

#[test]
fn centrelines_have_times_and_widths() {
    let output = run(&["centreline", "-", "--extend"], RECTANGLE);
    assert_eq!(code(&output), 0, "{}", err(&output));
    let feature = &json(out(&output))["features"][0];
    let line = "[[8,2,0],[6,2,2],[2,2,2],[0,2,0]]";
    assert_eq!(feature["geometry"]["type"], "LineString");
    assert_eq!(feature["geometry"]["coordinates"], json(line));
    let properties = &feature["properties"];
    for (name, value) in [
        ("source", "0"),
        ("closed", "false"),
        ("length", "8"),
        ("width_min", "0"),
        ("width_max", "4"),
        ("width_mean", "3"),
        ("widths", "[0,4,4,0]"),
    ] {
        let found = &properties[name];
        let expected = json(value);
        let same = found == &expected || found.as_f64() == expected.as_f64();
        assert!(same, "{name}: {found}");
    }
    for (measure, line) in [
        ("z", "LINESTRING Z (6 2 2, 2 2 2)"),
        ("m", "LINESTRING M (6 2 2, 2 2 2)"),
        ("zm", "LINESTRING ZM (6 2 2 4, 2 2 2 4)"),
    ] {
        let output = run(
            &["centreline", "-", "--format", "wkt", "--measure", measure],
            RECTANGLE,
        );
        assert_eq!(out(&output).trim(), line);
    }
}

#[test]
fn centrelines_are_pruned() {
    // A bar with a stem of length 7 in the middle.
    let tee = "POLYGON ((0 0, 9 0, 9 -6, 11 -6, 11 0, 20 0, 20 4, 0 4))";
    for (args, count) in [
        (&["--prune", "7"][..], 3),
        (&["--prune", "7.5"], 1),
        (&["--prune-ratio", "2"], 1),
        (&["--longest"], 1),
    ] {
        let all = ["centreline", "-", "--format", "wkt"];
        let output = run(&[&all[..], args].concat(), tee);
        assert_eq!(out(&output).lines().count(), count, "{args:?}");
    }
    for wrong in ["-1", "nan", "inf", "x"] {
        let output = run(&["centreline", "-", "--prune", wrong], tee);
        assert_eq!(code(&output), 2, "{wrong}: {}", err(&output));
    }
}

#[test]
fn centrelines_are_drawn() {
    let scratch = Scratch::new("centreline");
    let river = concat!(env!("CARGO_MANIFEST_DIR"), "/../../corpus/river.wkt");
    for (name, magic) in [("a.svg", &b"<svg "[..]), ("a.png", b"\x89PNG")] {
        let path = scratch.path(name);
        let output = run(&["centreline", river, "-o", &path, "--size", "64"], "");
        assert_eq!(code(&output), 0, "{}", err(&output));
        let bytes = fs::read(&path).unwrap();
        assert!(bytes.starts_with(magic), "{name}");
        let is_svg = magic.starts_with(b"<");
        assert!(
            !is_svg
                || String::from_utf8(bytes)
                    .unwrap()
                    .contains("<g id=\"offsets\"")
        );
    }
}
