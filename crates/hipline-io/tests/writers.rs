//! Every writer, on skeletons made by hand.

mod common;

use common::{hip_roof, segment, with_hole};
use expect_test::{Expect, expect};
use hipline::{
    Region, Skeleton,
    skeleton::{InputGraph, NodeKind},
};
use hipline_io::{
    FeatureName, Format, Shape, read, read_skeleton, read_skeletons,
    write::{self, Layers, OffsetLine, Picture, ResultsJson},
};

fn text(write: impl FnOnce(&mut Vec<u8>) -> std::io::Result<()>) -> String {
    let mut bytes = Vec::new();
    write(&mut bytes).unwrap();
    String::from_utf8(bytes).unwrap()
}

fn empty() -> Skeleton {
    Skeleton::from_parts(vec![], vec![], vec![], InputGraph::default(), Region::Both).unwrap()
}

fn name(index: usize, id: Option<&str>) -> FeatureName {
    FeatureName {
        index,
        id: id.map(str::to_owned),
    }
}

fn check(actual: &str, expected: Expect) {
    expected.assert_eq(actual);
}

/// Equal to the last bit: `==` does not tell -0 from 0.
fn assert_same(a: &Skeleton, b: &Skeleton) {
    assert_eq!(a, b);
    let bits = |s: &Skeleton| -> Vec<u64> {
        let numbers = s.nodes().iter().flat_map(|n| {
            let [dx, dy] = if let NodeKind::Infinite { direction } = n.kind {
                direction
            } else {
                [0.0; 2]
            };
            [n.x, n.y, n.time, dx, dy]
        });
        numbers.map(f64::to_bits).collect()
    };
    assert_eq!(bits(a), bits(b));
}

#[test]
fn json_of_a_hip_roof() {
    check(
        &text(|w| write::json(w, &hip_roof())),
        expect![[r#"
        {"format":"hipline-skeleton","version":1,"region":"interior",
        "nodes":[
        {"x":0,"y":0,"time":0,"kind":"input"},
        {"x":8,"y":0,"time":0,"kind":"input"},
        {"x":8,"y":4,"time":0,"kind":"input"},
        {"x":0,"y":4,"time":0,"kind":"input"},
        {"x":2,"y":2,"time":2,"kind":"event"},
        {"x":6,"y":2,"time":2,"kind":"event"}],
        "arcs":[
        {"nodes":[0,4],"faces":[3,0],"kind":"ridge"},
        {"nodes":[1,5],"faces":[0,1],"kind":"ridge"},
        {"nodes":[2,5],"faces":[1,2],"kind":"ridge"},
        {"nodes":[3,4],"faces":[2,3],"kind":"ridge"},
        {"nodes":[4,5],"faces":[2,0],"kind":"ridge"}],
        "faces":[
        {"edge":0,"side":"left","nodes":[0,1,5,4]},
        {"edge":1,"side":"left","nodes":[1,2,5]},
        {"edge":2,"side":"left","nodes":[2,3,4,5]},
        {"edge":3,"side":"left","nodes":[3,0,4]}],
        "input":{"vertices":4,"terminals":0,"edges":[
        [0,1],
        [1,2],
        [2,3],
        [3,0]]},
        "stats":{"edge_events":0,"split_events":0,"flips":0,"steps":0,"by_f64":0,"by_double_double":0,"by_wide":0,"by_exact":0}}
    "#]],
    );
}

#[test]
fn json_of_a_segment() {
    check(
        &text(|w| write::json(w, &segment())),
        expect![[r#"
        {"format":"hipline-skeleton","version":1,"region":"both",
        "nodes":[
        {"x":0,"y":0,"time":0,"kind":"input"},
        {"x":3,"y":0,"time":0,"kind":"input"},
        {"x":0,"y":0,"time":null,"kind":"infinite","direction":[-1,1]},
        {"x":0,"y":0,"time":null,"kind":"infinite","direction":[-1,-1]},
        {"x":3,"y":0,"time":null,"kind":"infinite","direction":[1,1]},
        {"x":3,"y":0,"time":null,"kind":"infinite","direction":[1,-1]}],
        "arcs":[
        {"nodes":[0,2],"faces":[2,0],"kind":"valley"},
        {"nodes":[0,3],"faces":[1,2],"kind":"valley"},
        {"nodes":[1,4],"faces":[0,3],"kind":"valley"},
        {"nodes":[1,5],"faces":[3,1],"kind":"valley"}],
        "faces":[
        {"edge":0,"side":"left","nodes":[0,1,4,2]},
        {"edge":0,"side":"right","nodes":[1,0,3,5]},
        {"edge":0,"side":"start","nodes":[0,2,3]},
        {"edge":0,"side":"end","nodes":[1,5,4]}],
        "input":{"vertices":2,"terminals":2,"edges":[
        [0,1]]},
        "stats":{"edge_events":0,"split_events":0,"flips":0,"steps":0,"by_f64":0,"by_double_double":0,"by_wide":0,"by_exact":0}}
    "#]],
    );
}

#[test]
fn json_is_read_back_bit_for_bit() {
    for skeleton in [hip_roof(), segment(), with_hole(), empty()] {
        let json = text(|w| write::json(w, &skeleton));
        assert_same(&read_skeleton(json.as_bytes()).unwrap(), &skeleton);
        let value: serde_json::Value = serde_json::from_str(&json).unwrap();
        assert_eq!(value["format"], "hipline-skeleton");
    }
}

#[test]
fn results_of_several_features() {
    let mut results = ResultsJson::new(Vec::new()).unwrap();
    results
        .push(&name(0, Some("a \"quoted\"\nname")), Ok(&with_hole()))
        .unwrap();
    results
        .push(&name(2, None), Err("edges 1 and 3 cross"))
        .unwrap();
    results.push(&name(3, None), Ok(&empty())).unwrap();
    let json = results.finish().unwrap();
    let records = read_skeletons(&json).unwrap();
    let names: Vec<_> = records.iter().map(|r| (r.index, r.id.as_deref())).collect();
    assert_eq!(
        names,
        [(0, Some("a \"quoted\"\nname")), (2, None), (3, None)]
    );
    assert_same(records[0].result.as_ref().unwrap(), &with_hole());
    assert_eq!(records[1].result, Err("edges 1 and 3 cross".to_owned()));
    assert_same(records[2].result.as_ref().unwrap(), &empty());
    let error = read_skeleton(&json).unwrap_err();
    assert_eq!(
        error.to_string(),
        "skeleton JSON: there are 3 results, not one"
    );
    let none = ResultsJson::new(Vec::new()).unwrap().finish().unwrap();
    assert_eq!(read_skeletons(&none).unwrap(), []);
}

#[test]
fn wrong_json_is_refused() {
    let good = text(|w| write::json(w, &hip_roof()));
    for (from, to, message) in [
        ("\"version\":1", "\"version\":2", "\"version\" is not 1"),
        (
            "hipline-skeleton",
            "other",
            "\"format\" is neither hipline-skeleton nor hipline-skeletons with \"results\"",
        ),
        (
            "[0,4]",
            "[0,9]",
            "arc 0 ends at n9, but there is no such node",
        ),
        (
            "\"faces\":[3,0]",
            "\"faces\":[3,7]",
            "arc 0 borders f7, but there is no such face",
        ),
        (
            "\"edge\":3",
            "\"edge\":4",
            "face 3 starts at e4, but there is no such edge",
        ),
        (
            "[0,1,5,4]",
            "[0,1,5,6]",
            "face 0 has the corner n6, but there is no such node",
        ),
        (
            "[3,0]]",
            "[3,4]]",
            "edge 3 ends at v4, but there is no such vertex",
        ),
        (
            "\"vertices\":4",
            "\"vertices\":7",
            "6 nodes cannot hold 7 input vertices",
        ),
        (
            "\"time\":2",
            "\"time\":null",
            "node 4: the \"time\" of infinite nodes is null, that of others is not",
        ),
        (
            "\"event\"",
            "\"infinite\"",
            "node 4: infinite nodes have a \"direction\", others have none",
        ),
    ] {
        let bad = good
            .replacen(from, to, 1)
            .replace("[3,0]\n]},", &format!("{to}\n}},"));
        assert_ne!(bad, good, "{from}");
        let error = read_skeleton(bad.as_bytes()).unwrap_err();
        assert_eq!(error.to_string(), format!("skeleton JSON: {message}"));
    }
    let error = read_skeleton(good.replace("\"ridge\"", "\"crest\"").as_bytes()).unwrap_err();
    assert!(
        error.to_string().contains("unknown variant `crest`"),
        "{error}"
    );
    let error = read_skeleton(good.replace("\"x\":8", "\"x\":1e999").as_bytes()).unwrap_err();
    assert!(error.to_string().contains("number out of range"), "{error}");
}

#[test]
fn geojson_of_a_hip_roof() {
    let skeleton = hip_roof();
    check(
        &text(|w| write::geojson(w, [(name(5, Some("house")), &skeleton)])),
        expect![[r#"
            {"type":"FeatureCollection","features":[
            {"type":"Feature","properties":{"element":"node","source":5,"source_id":"house","node":0,"kind":"input","time":0},"geometry":{"type":"Point","coordinates":[0,0]}},
            {"type":"Feature","properties":{"element":"node","source":5,"source_id":"house","node":1,"kind":"input","time":0},"geometry":{"type":"Point","coordinates":[8,0]}},
            {"type":"Feature","properties":{"element":"node","source":5,"source_id":"house","node":2,"kind":"input","time":0},"geometry":{"type":"Point","coordinates":[8,4]}},
            {"type":"Feature","properties":{"element":"node","source":5,"source_id":"house","node":3,"kind":"input","time":0},"geometry":{"type":"Point","coordinates":[0,4]}},
            {"type":"Feature","properties":{"element":"node","source":5,"source_id":"house","node":4,"kind":"event","time":2},"geometry":{"type":"Point","coordinates":[2,2]}},
            {"type":"Feature","properties":{"element":"node","source":5,"source_id":"house","node":5,"kind":"event","time":2},"geometry":{"type":"Point","coordinates":[6,2]}},
            {"type":"Feature","properties":{"element":"arc","source":5,"source_id":"house","arc":0,"kind":"ridge","nodes":[0,4],"faces":[3,0],"times":[0,2]},"geometry":{"type":"LineString","coordinates":[[0,0],[2,2]]}},
            {"type":"Feature","properties":{"element":"arc","source":5,"source_id":"house","arc":1,"kind":"ridge","nodes":[1,5],"faces":[0,1],"times":[0,2]},"geometry":{"type":"LineString","coordinates":[[8,0],[6,2]]}},
            {"type":"Feature","properties":{"element":"arc","source":5,"source_id":"house","arc":2,"kind":"ridge","nodes":[2,5],"faces":[1,2],"times":[0,2]},"geometry":{"type":"LineString","coordinates":[[8,4],[6,2]]}},
            {"type":"Feature","properties":{"element":"arc","source":5,"source_id":"house","arc":3,"kind":"ridge","nodes":[3,4],"faces":[2,3],"times":[0,2]},"geometry":{"type":"LineString","coordinates":[[0,4],[2,2]]}},
            {"type":"Feature","properties":{"element":"arc","source":5,"source_id":"house","arc":4,"kind":"ridge","nodes":[4,5],"faces":[2,0],"times":[2,2]},"geometry":{"type":"LineString","coordinates":[[2,2],[6,2]]}},
            {"type":"Feature","properties":{"element":"face","source":5,"source_id":"house","face":0,"edge":0,"side":"left","bounded":true},"geometry":{"type":"Polygon","coordinates":[[[0,0],[8,0],[6,2],[2,2],[0,0]]]}},
            {"type":"Feature","properties":{"element":"face","source":5,"source_id":"house","face":1,"edge":1,"side":"left","bounded":true},"geometry":{"type":"Polygon","coordinates":[[[8,0],[8,4],[6,2],[8,0]]]}},
            {"type":"Feature","properties":{"element":"face","source":5,"source_id":"house","face":2,"edge":2,"side":"left","bounded":true},"geometry":{"type":"Polygon","coordinates":[[[8,4],[0,4],[2,2],[6,2],[8,4]]]}},
            {"type":"Feature","properties":{"element":"face","source":5,"source_id":"house","face":3,"edge":3,"side":"left","bounded":true},"geometry":{"type":"Polygon","coordinates":[[[0,4],[0,0],[2,2],[0,4]]]}}
            ]}
        "#]],
    );
}

#[test]
fn unbounded_parts_are_cut_at_the_window() {
    let skeleton = segment();
    let geojson = text(|w| write::geojson(w, [(name(0, None), &skeleton)]));
    check(
        &geojson,
        expect![[r#"
            {"type":"FeatureCollection","features":[
            {"type":"Feature","properties":{"element":"node","source":0,"node":0,"kind":"input","time":0},"geometry":{"type":"Point","coordinates":[0,0]}},
            {"type":"Feature","properties":{"element":"node","source":0,"node":1,"kind":"input","time":0},"geometry":{"type":"Point","coordinates":[3,0]}},
            {"type":"Feature","properties":{"element":"arc","source":0,"arc":0,"kind":"valley","nodes":[0,2],"faces":[2,0],"times":[0,null]},"geometry":{"type":"LineString","coordinates":[[0,0],[-0.75,0.75]]}},
            {"type":"Feature","properties":{"element":"arc","source":0,"arc":1,"kind":"valley","nodes":[0,3],"faces":[1,2],"times":[0,null]},"geometry":{"type":"LineString","coordinates":[[0,0],[-0.75,-0.75]]}},
            {"type":"Feature","properties":{"element":"arc","source":0,"arc":2,"kind":"valley","nodes":[1,4],"faces":[0,3],"times":[0,null]},"geometry":{"type":"LineString","coordinates":[[3,0],[3.75,0.75]]}},
            {"type":"Feature","properties":{"element":"arc","source":0,"arc":3,"kind":"valley","nodes":[1,5],"faces":[3,1],"times":[0,null]},"geometry":{"type":"LineString","coordinates":[[3,0],[3.75,-0.75]]}},
            {"type":"Feature","properties":{"element":"face","source":0,"face":0,"edge":0,"side":"left","bounded":false},"geometry":{"type":"Polygon","coordinates":[[[0,0],[3,0],[3.75,0.75],[-0.75,0.75],[0,0]]]}},
            {"type":"Feature","properties":{"element":"face","source":0,"face":1,"edge":0,"side":"right","bounded":false},"geometry":{"type":"Polygon","coordinates":[[[3,0],[0,0],[-0.75,-0.75],[3.75,-0.75],[3,0]]]}},
            {"type":"Feature","properties":{"element":"face","source":0,"face":2,"edge":0,"side":"start","bounded":false},"geometry":{"type":"Polygon","coordinates":[[[0,0],[-0.75,0.75],[-0.75,-0.75],[0,0]]]}},
            {"type":"Feature","properties":{"element":"face","source":0,"face":3,"edge":0,"side":"end","bounded":false},"geometry":{"type":"Polygon","coordinates":[[[3,0],[3.75,-0.75],[3.75,0.75],[3,0]]]}}
            ]}
        "#]],
    );
    check(
        &text(|w| write::wkt(w, &skeleton)),
        expect![[r#"
        LINESTRING Z (0 0 0, -0.75 0.75 0.75)
        LINESTRING Z (0 0 0, -0.75 -0.75 0.75)
        LINESTRING Z (3 0 0, 3.75 0.75 0.75)
        LINESTRING Z (3 0 0, 3.75 -0.75 0.75)
    "#]],
    );
}

#[test]
fn what_is_written_can_be_read() {
    let skeleton = hip_roof();
    let lines = [
        OffsetLine {
            distance: 1.0,
            points: vec![[0.1, 0.2], [3.0, 1e-7], [5e-324, 1e300]],
            is_closed: true,
        },
        OffsetLine {
            distance: 0.5,
            points: vec![[1.0, 1.0], [2.0, 2.0]],
            is_closed: false,
        },
    ];
    let read_lines = |bytes: &str, format| -> Vec<Vec<[f64; 2]>> {
        let document = read(bytes.as_bytes(), format).unwrap();
        let chains = document.features.into_iter().map(|f| match f.case {
            Shape::Lines(mut lines) => lines.remove(0).points,
            other => panic!("{other:?}"),
        });
        chains.collect()
    };
    let mut closed = lines[0].points.clone();
    closed.push(closed[0]);
    let expected = [closed, lines[1].points.clone()];
    assert_eq!(
        read_lines(&text(|w| write::lines_geojson(w, &lines)), Format::GeoJson),
        expected
    );
    assert_eq!(
        read_lines(&text(|w| write::lines_wkt(w, &lines)), Format::Wkt),
        expected
    );
    assert_eq!(
        read_lines(&text(|w| write::wkt(w, &skeleton)), Format::Wkt).len(),
        5
    );
    let document = read(
        text(|w| write::geojson(w, [(name(0, None), &skeleton)])).as_bytes(),
        Format::GeoJson,
    )
    .unwrap();
    assert_eq!(document.features.len(), 6 + 5 + 4);
    let document = read(
        text(|w| write::obj(w, &skeleton, 0.5)).as_bytes(),
        Format::Obj,
    )
    .unwrap();
    let Shape::Polygons(faces) = &document.features[0].case else {
        panic!("not polygons")
    };
    assert_eq!(faces.len(), 4);
}

#[test]
fn obj_of_roofs() {
    check(
        &text(|w| write::obj(w, &hip_roof(), 0.5)),
        expect![[r#"
        v 0 0 0
        v 8 0 0
        v 8 4 0
        v 0 4 0
        v 2 2 1
        v 6 2 1
        f 1 2 6 5
        f 2 3 6
        f 3 4 5 6
        f 4 1 5
    "#]],
    );
    let mut w = write::ObjWriter::new(Vec::new(), 1.0);
    w.push(Some(&name(0, Some("first\nhouse"))), &with_hole())
        .unwrap();
    w.push(Some(&name(1, None)), &segment()).unwrap();
    check(
        &String::from_utf8(w.into_inner()).unwrap(),
        expect![[r#"
        o first house
        v -0.0 0 0
        v 9 0.30000000000000004 0
        v 9 1e-300 0
        v 0 9.000000000000002 0
        v 1 1 5e-324
        v 2 1 1e22
        v 1 2 1.7976931348623157e308
        f 1 5 7 6 5 1 2 3 4
        o feature_1
        v 0 0 0
        v 3 0 0
    "#]],
    );
}

#[test]
fn svg_has_every_layer() {
    let skeleton = segment();
    let mut picture = Picture::new();
    picture
        .skeleton(&skeleton)
        .layers(Layers {
            labels: true,
            ..Layers::default()
        })
        .line(OffsetLine {
            distance: 1.0,
            points: vec![[0.0, 1.0], [3.0, 1.0]],
            is_closed: true,
        });
    check(
        &text(|w| picture.svg(w)),
        expect![[r##"
            <svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 1000 404.002" width="1000" height="404.002" stroke-linecap="round" stroke-linejoin="round">
            <rect width="100%" height="100%" fill="#fbfaf6"/>
            <g id="faces" stroke-width="0.6">
            <path fill="#aeb9c1" stroke="#aeb9c1" fill-rule="evenodd" d="M100.894 303.108L899.106 303.108L1000 202.214L1000 0L0 0L0 202.214Z"/>
            <path fill="#e0dacb" stroke="#e0dacb" fill-rule="evenodd" d="M899.106 303.108L100.894 303.108L0 404.002L1000 404.002Z"/>
            <path fill="#98abbc" stroke="#98abbc" fill-rule="evenodd" d="M100.894 303.108L0 202.214L0 404.002Z"/>
            <path fill="#f6e8d0" stroke="#f6e8d0" fill-rule="evenodd" d="M899.106 303.108L1000 404.002L1000 404.002L1000 202.214Z"/>
            </g>
            <g id="arcs">
            <g id="ghost" fill="none" stroke="#8d8f94" stroke-width="1.2" stroke-dasharray="6 6">
            </g>
            <g id="crease" fill="none" stroke="#b98a2f" stroke-width="1.6">
            </g>
            <g id="valley" fill="none" stroke="#2c6d9e" stroke-width="2">
            <path d="M100.894 303.108L0 202.214M100.894 303.108L0 404.002M899.106 303.108L1000 202.214M899.106 303.108L1000 404.002"/>
            </g>
            <g id="ridge" fill="none" stroke="#a8412f" stroke-width="2">
            </g>
            </g>
            <g id="offsets" fill="none" stroke="#6b4a8c" stroke-width="2.4">
            <path d="M100.894 37.037L899.106 37.037Z"/>
            </g>
            <g id="input" fill="none" stroke="#23272e" stroke-width="3.6">
            <path d="M100.894 303.108L899.106 303.108"/>
            </g>
            <g id="nodes" fill="#23272e">
            <circle cx="100.894" cy="303.108" r="3.2"/>
            <circle cx="899.106" cy="303.108" r="3.2"/>
            </g>
            <g id="labels" fill="#4b5058" font-family="sans-serif" font-size="14" text-anchor="middle" dominant-baseline="central">
            <text x="112.894" y="291.108">n0</text>
            <text x="911.106" y="291.108">n1</text>
            <text x="50.447" y="252.661">a0</text>
            <text x="50.447" y="353.555">a1</text>
            <text x="949.553" y="252.661">a2</text>
            <text x="949.553" y="353.555">a3</text>
            <text x="500" y="303.108">e0</text>
            <text x="500" y="168.44">f0</text>
            <text x="500" y="353.555">f1</text>
            <text x="33.631" y="303.108">f2</text>
            <text x="974.777" y="328.331">f3</text>
            </g>
            </svg>
        "##]],
    );
}

#[test]
fn pictures_of_nothing_are_pictures() {
    let skeleton = empty();
    let mut nothing = Picture::new();
    nothing.skeleton(&skeleton);
    for picture in [Picture::new(), nothing] {
        assert!(text(|w| picture.svg(w)).contains("viewBox=\"0 0 1000 1000\""));
        png(|w| picture.png(w, 16).unwrap(), 16, 16);
    }
    png(
        |w| {
            write::roof_png(
                w,
                &[],
                &write::RoofView {
                    size: 16,
                    ..Default::default()
                },
            )
            .unwrap()
        },
        16,
        16,
    );
}

/// The size in the header of a PNG, and that something was drawn.
fn png(draw: impl FnOnce(&mut Vec<u8>), width: u32, height: u32) {
    let mut bytes = Vec::new();
    draw(&mut bytes);
    assert_eq!(&bytes[..8], b"\x89PNG\r\n\x1a\n");
    let number = |at: usize| u32::from_be_bytes(bytes[at..at + 4].try_into().unwrap());
    assert_eq!((number(16), number(20)), (width, height));
}

/// A house of 12 by 6, its eaves at 3, its ridge at 6.
fn house() -> hipline::roof::Mesh {
    let ring = [[0.0, 0.0], [12.0, 0.0], [12.0, 6.0], [0.0, 6.0]];
    let polygon = hipline::Polygon::new([ring]).unwrap();
    let options = hipline::roof::RoofOptions {
        eaves: 3.0,
        ..Default::default()
    };
    polygon.figure().roof(&options).unwrap()
}

#[test]
fn png_pictures_have_the_size_asked_for() {
    let skeleton = hip_roof();
    let mut picture = Picture::new();
    picture.skeleton(&skeleton);
    png(|w| picture.png(w, 300).unwrap(), 300, 161);
    let view = write::RoofView {
        size: 300,
        ..Default::default()
    };
    let mesh = house();
    // 13.41 by 8.82 units on the screen, and a margin of a twentieth of 13.41 on each side.
    png(|w| write::roof_png(w, &[&mesh], &view).unwrap(), 300, 207);
    for size in [0, 1 << 20] {
        let message = format!("a picture has between 1 and 16384 pixels to a side, not {size}");
        assert_eq!(
            picture.png(Vec::new(), size).unwrap_err().to_string(),
            message
        );
        let view = write::RoofView { size, ..view };
        assert_eq!(
            write::roof_png(Vec::new(), &[&mesh], &view)
                .unwrap_err()
                .to_string(),
            message
        );
    }
    if let Some(directory) = std::env::var_os("HIPLINE_PICTURES") {
        let directory = std::path::Path::new(&directory);
        write::write_atomically(directory.join("hip.png"), |w| {
            picture.png(w, 800).map_err(std::io::Error::other)
        })
        .unwrap();
        write::write_atomically(directory.join("roof.png"), |w| {
            write::roof_png(w, &[&mesh], &write::RoofView { size: 800, ..view })
                .map_err(std::io::Error::other)
        })
        .unwrap();
    }
}
