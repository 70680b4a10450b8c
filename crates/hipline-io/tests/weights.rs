//! Weights, profiles, starts and heights: every way to give them, what it means to the figure, and what
//! is said of those that cannot be.

use hipline::{
    Figure, FigureBuilder, Options,
    input::{Change, Place, Sides},
};
use hipline_io::{Document, Format, Setting, Target, Value, read, read_settings};
use serde_json::{Value as Json, json};

const RECTANGLE: &str = "POLYGON ((0 0, 12 0, 12 8, 0 8, 0 0))";
const LINE: &str = "LINESTRING (0 0, 4 0, 4 3)";

fn wkt(text: &str) -> Document {
    read(text.as_bytes(), Format::Wkt).unwrap()
}

/// One feature with properties.
fn feature(geometry: &Json, properties: &Json) -> Result<Document, String> {
    let text = json!({"type": "Feature", "geometry": geometry, "properties": properties});
    read(text.to_string().as_bytes(), Format::GeoJson).map_err(|e| e.to_string())
}

fn rectangle(properties: &Json) -> Result<Document, String> {
    let ring = [[0, 0], [12, 0], [12, 8], [0, 8], [0, 0]];
    feature(
        &json!({"type": "Polygon", "coordinates": [ring]}),
        properties,
    )
}

/// What a figure says of speeds and heights: `[left, right]` speeds, changes, heights.
fn told(figure: &Figure) -> String {
    let mut lines: Vec<String> = figure
        .edges()
        .iter()
        .enumerate()
        .map(|(i, e)| format!("{i}: {} {}", e.speeds[0], e.speeds[1]))
        .collect();
    lines.extend(figure.changes().iter().map(|c| {
        let side = if c.right { "right" } else { "left" };
        format!("{} {side} at {}: {}", c.edge.index(), c.time, c.speed)
    }));
    let heights = (0..figure.vertices().len()).map(|v| {
        let height = figure.height(hipline::topology::VertexId::new(v));
        (v, height)
    });
    let high = heights.filter(|(_, height)| *height > 0.0);
    lines.extend(high.map(|(v, height)| format!("vertex {v}: {height}")));
    lines.join("; ")
}

fn figure(document: &Document) -> Figure {
    document.features[0]
        .figure()
        .unwrap_or_else(|e| panic!("{e}"))
}

fn setting(target: &str, sides: Sides, value: Value) -> Setting {
    Setting {
        target: target.parse().unwrap(),
        sides,
        origin: format!("{target} {value:?}"),
        value,
    }
}

#[test]
fn properties_of_polygons() {
    for (properties, expected) in [
        (
            json!({"edge_weights": [1, 0, 2, 0]}),
            "0: 1 1; 1: 0 0; 2: 2 2; 3: 0 0",
        ),
        (
            json!({"edge_starts": [[0, 3, 0, 0]], "edge_weights": 2}),
            "0: 2 2; 1: 0 0; 2: 2 2; 3: 2 2; 1 left at 3: 2; 1 right at 3: 2",
        ),
        (
            json!({"profile": [[0, 1], [2, 4]], "edge_weights": [0, 1, 0, 0.5]}),
            "0: 0 0; 1: 1 1; 2: 0 0; 3: 0.5 0.5; 1 left at 2: 4; 1 right at 2: 4; \
             3 left at 2: 2; 3 right at 2: 2",
        ),
        (
            json!({"profile": [[0, 1]], "edge_profiles": [null, [[0, 3]], null, [[0, 1], [1, 0]]]}),
            "0: 1 1; 1: 3 3; 2: 1 1; 3: 1 1; 3 left at 1: 0; 3 right at 1: 0",
        ),
        // Times of the profile go on before the start.
        (
            json!({"profile": [[0, 1], [2, 4], [5, 6]], "edge_starts": [0, 0, 0, 3]}),
            "0: 1 1; 1: 1 1; 2: 1 1; 3: 0 0; \
             0 left at 2: 4; 0 left at 5: 6; 0 right at 2: 4; 0 right at 5: 6; \
             1 left at 2: 4; 1 left at 5: 6; 1 right at 2: 4; 1 right at 5: 6; \
             2 left at 2: 4; 2 left at 5: 6; 2 right at 2: 4; 2 right at 5: 6; \
             3 left at 3: 4; 3 left at 5: 6; 3 right at 3: 4; 3 right at 5: 6",
        ),
        (
            json!({"vertex_heights": [0, 0, 1, 1.5]}),
            "0: 1 1; 1: 1 1; 2: 1 1; 3: 1 1; vertex 2: 1; vertex 3: 1.5",
        ),
        (
            json!({"profile": null, "heights_from_z": false, "edge_starts": 0}),
            "0: 1 1; 1: 1 1; 2: 1 1; 3: 1 1",
        ),
    ] {
        assert_eq!(
            told(&figure(&rectangle(&properties).unwrap())),
            expected,
            "{properties}"
        );
    }
}

#[test]
fn properties_of_lines() {
    let line = json!({"type": "LineString", "coordinates": [[0, 0, 2], [4, 0, 1], [4, 3, 0]]});
    for (properties, expected) in [
        (json!({}), "0: 1 1; 1: 1 1"),
        (
            json!({"edge_weights": [[1, 2], 3], "edge_starts": [0, [0, 4]]}),
            "0: 1 2; 1: 3 0; 1 right at 4: 3",
        ),
        (
            json!({"heights_from_z": true}),
            "0: 1 1; 1: 1 1; vertex 0: 2; vertex 1: 1",
        ),
        (
            json!({"heights_from_z": true, "vertex_heights": [0.5, 0.5, 0.5]}),
            "0: 1 1; 1: 1 1; vertex 0: 0.5; vertex 1: 0.5; vertex 2: 0.5",
        ),
        (
            json!({"edge_profiles": [[[[0, 2], [1, 3]], null]]}),
            "0: 2 2; 1: 1 1; 0 left at 1: 3; 0 right at 1: 3",
        ),
    ] {
        assert_eq!(
            told(&figure(&feature(&line, &properties).unwrap())),
            expected,
            "{properties}"
        );
    }
}

#[test]
fn a_document_says_the_same_as_a_builder() {
    let properties = json!({"edge_weights": [1, 0, 1, 2], "edge_starts": [0, 0, 1, 0], "profile": [[0, 1], [2, 3]]});
    let read = figure(&rectangle(&properties).unwrap());
    let mut builder = FigureBuilder::new();
    let ring = vec![[0.0, 0.0], [12.0, 0.0], [12.0, 8.0], [0.0, 8.0]];
    let part = builder.weighted_polygon(vec![ring], vec![vec![1.0, 0.0, 0.0, 2.0]]);
    for (index, time, speed) in [(0, 2.0, 3.0), (2, 1.0, 1.0), (2, 2.0, 3.0), (3, 2.0, 6.0)] {
        let edge = Place {
            part,
            ring: 0,
            index,
        };
        builder.change(Change {
            edge,
            sides: Sides::Both,
            time,
            speed,
        });
    }
    let built = builder.build().unwrap();
    assert_eq!(told(&read), told(&built));
    let skeleton = read.skeleton(Options::default());
    assert_eq!(skeleton.nodes(), built.skeleton(Options::default()).nodes());
    skeleton.verify(&built).unwrap();
}

#[test]
fn properties_that_cannot_be() {
    for (properties, message) in [
        (
            json!({"edge_starts": [0, 0, 0, -1]}),
            "edge_starts of ring or line 0: edge 3: no edge starts before the time 0, and this is -1",
        ),
        (
            json!({"edge_starts": [0, 0, 0]}),
            "edge_starts of ring or line 0: 3 numbers for 4 edges",
        ),
        (
            json!({"edge_starts": [[0, 0, [1, 2], 0]]}),
            "edge_starts of ring or line 0: edge 2: a start on a polygon is one number; pairs are for lines",
        ),
        (
            json!({"profile": 3}),
            "profile: `3` is not a list of pairs [time, speed]",
        ),
        (
            json!({"profile": []}),
            "profile: a profile has one pair of a time and a speed at least",
        ),
        (
            json!({"profile": [[1, 1]]}),
            "profile: a profile starts at the time 0, and this one at 1",
        ),
        (
            json!({"profile": [[0, 1], [2, 1], [1, 1]]}),
            "profile: the times of a profile increase, but 1 comes after 2",
        ),
        (
            json!({"profile": [[0, -1]]}),
            "profile: a speed must not be below 0, and this is -1",
        ),
        (
            json!({"profile": [[0, 1, 2]]}),
            "profile: `[[0,1,2]]` is not a list of pairs [time, speed]",
        ),
        (
            json!({"edge_profiles": [null, null]}),
            "edge_profiles of ring or line 0: 2 profiles for 4 edges",
        ),
        (
            json!({"edge_profiles": [null, [[0, 1]], 7, null]}),
            "edge_profiles of ring or line 0: edge 2: `7` is not a list of pairs [time, speed]",
        ),
        (
            json!({"vertex_heights": [1, 2, 3, 4, 1]}),
            "vertex_heights of ring or line 0: 5 numbers for 4 vertices",
        ),
        (
            json!({"vertex_heights": [1, 2, null, 4]}),
            "vertex_heights of ring or line 0: vertex 2: `null` is not a number",
        ),
        (
            json!({"heights_from_z": "yes"}),
            "heights_from_z is `\"yes\"`, neither true nor false",
        ),
        (
            json!({"heights_from_z": true}),
            "heights_from_z: ring or line 0: vertex 0 has no third coordinate to be its height",
        ),
    ] {
        let error = rectangle(&properties).unwrap_err();
        assert_eq!(error, format!("GeoJSON, feature 0: {message}"));
    }
    // What only the figure shows is said in the caller's numbering.
    for (properties, message) in [
        (
            json!({"vertex_heights": [0, 0, 9, 9]}),
            "part 0, ring 0, edge 1 goes from height 0 to 9: that is not less steep than its facets, which rise by one in 1",
        ),
        (
            json!({"vertex_heights": [0, -1, 0, 0]}),
            "part 0, ring 0, vertex 1 has the height -1; a height must be finite and not negative",
        ),
        (
            json!({"edge_weights": [1, 1, -2, 1]}),
            "part 0, ring 0, edge 2 has the speed -2; a speed must be finite and not negative",
        ),
        (
            json!({"vertex_heights": [1, 1, 1, 1], "edge_starts": [0.5, 0, 0, 0]}),
            "part 0, ring 0, edge 0 changes its speed at the time 0.5; with ends at the heights 1 and 1 it must start first",
        ),
    ] {
        let error = rectangle(&properties).unwrap().features[0]
            .figure()
            .unwrap_err();
        let error = error.to_string();
        assert!(error.contains(message), "{error}");
    }
}

#[test]
fn third_coordinates_of_every_format() {
    let graphml = r#"<graphml><key id="x" attr.name="vertex-coordinate-x"/><key id="y" attr.name="vertex-coordinate-y"/>
        <key id="z" attr.name="vertex-coordinate-z"><default>1</default></key><graph>
        <node id="a"><data key="x">0</data><data key="y">0</data><data key="z">2</data></node>
        <node id="b"><data key="x">4</data><data key="y">0</data></node>
        <edge source="a" target="b"/></graph></graphml>"#;
    let geojson = r#"{"type":"LineString","coordinates":[[0,0,2],[4,0,1,7]]}"#;
    for (text, format) in [
        ("LINESTRING (0 0 2, 4 0 1)", Format::Wkt),
        ("LINESTRINGZM (0 0 2 9, 4 0 1 9)", Format::Wkt),
        ("v 0 0 2\nv 4 0 1 1\nl 1 2", Format::Obj),
        (geojson, Format::GeoJson),
        (graphml, Format::GraphMl),
    ] {
        let mut document = read(text.as_bytes(), format).unwrap();
        assert_eq!(told(&figure(&document)), "0: 1 1", "not asked for");
        document.heights_from_z().unwrap();
        assert_eq!(
            told(&figure(&document)),
            "0: 1 1; vertex 0: 2; vertex 1: 1",
            "{text}"
        );
    }
    for (text, format) in [
        ("LINESTRING (0 0 2, 4 0)", Format::Wkt),
        ("LINESTRING M (0 0 2, 4 0 1)", Format::Wkt),
        ("LINESTRINGM (0 0 2, 4 0 1)", Format::Wkt),
        ("v 0 0 2\nv 4 0\nl 1 2", Format::Obj),
        (
            r#"{"type":"LineString","coordinates":[[0,0,"2"],[4,0,null]]}"#,
            Format::GeoJson,
        ),
        ("2\n0 0\n4 0\n", Format::Line),
    ] {
        let mut document = read(text.as_bytes(), format).unwrap();
        let (feature, message) = document.heights_from_z().unwrap_err();
        assert_eq!(feature.index, 0);
        assert!(
            message.contains("has no third coordinate"),
            "{text}: {message}"
        );
    }
    let mut open = wkt("POLYGON ((0 0 1, 4 0 1, 4 4 1, 0 0 2))");
    let (_, message) = open.heights_from_z().unwrap_err();
    assert_eq!(
        message,
        "ring or line 0: it starts at the height 1 and ends there at the height 2"
    );
}

#[test]
fn graphs_start_late() {
    let graph = |additive: &str| {
        format!(
            r#"<graphml><key id="x" attr.name="vertex-coordinate-x"/><key id="y" attr.name="vertex-coordinate-y"/>
        <key id="w" attr.name="edge-weight"/><key id="wa" attr.name="edge-weight-additive"/><graph>
        <node id="a"><data key="x">0</data><data key="y">0</data></node>
        <node id="b"><data key="x">4</data><data key="y">0</data></node>
        <edge source="a" target="b"><data key="w">2</data><data key="wa">{additive}</data></edge></graph></graphml>"#
        )
    };
    let document = read(graph("1.5").as_bytes(), Format::GraphMl).unwrap();
    assert_eq!(
        told(&figure(&document)),
        "0: 0 0; 0 left at 1.5: 2; 0 right at 1.5: 2"
    );
    let error = read(graph("-1").as_bytes(), Format::GraphMl).unwrap_err();
    let message = "no edge starts before the time 0 (edge-weight-additive is -1)";
    assert!(error.to_string().contains(message), "{error}");
}

#[test]
fn tables() {
    let table = "\u{feff}ring, edge, side, speed, time, start\n,0,,2,,\n0,0,both,4,2.5,\n*,*,,3,,\n0,1,left,,,7\n";
    let settings = read_settings(table.as_bytes(), "t.csv").unwrap();
    assert_eq!(settings.len(), 4);
    assert_eq!(settings[2].target, Target::default());
    assert_eq!(settings[1].origin, "t.csv, line 3");
    let mut document = wkt(LINE);
    document.set(&settings).unwrap();
    assert_eq!(
        told(&figure(&document)),
        "0: 2 2; 1: 0 3; 0 left at 2.5: 4; 0 right at 2.5: 4; 1 left at 7: 3"
    );
    for (table, message) in [
        ("", "line 1: there is no column edge"),
        ("ring,speed\n", "line 1: there is no column edge"),
        (
            "edge\n1\n",
            "line 1: there is no column speed, and none start",
        ),
        (
            "edge,weight\n",
            "line 1: `weight` is no column of a table of weights; those are feature, ring, edge, side, speed, time, start",
        ),
        ("edge,edge\n", "line 1: the column edge is there twice"),
        (
            "edge,speed\n1,2\n1\n",
            "line 3: 1 cells, but there are 2 columns",
        ),
        ("edge,speed\n1,x\n", "line 2: speed: `x` is not a number"),
        (
            "edge,speed\n1,NaN\n",
            "line 2: speed: `NaN` is not a finite number",
        ),
        ("edge,speed\n\n1,-1\n", "line 3: speed: -1 is below 0"),
        ("edge,speed\n1,\n", "line 2: it has no speed and no start"),
        (
            "edge,speed,time\n1,,3\n",
            "line 2: it has a time, but no speed",
        ),
        ("edge,speed\n,1\n", "line 2: it names no edge"),
        (
            "edge,speed\n-1,1\n",
            "line 2: edge: `-1` is neither a number from 0 nor *",
        ),
        (
            "ring,edge,speed\none,1,1\n",
            "line 2: ring: `one` is neither a number from 0 nor *",
        ),
        (
            "edge,speed,side\n1,1,top\n",
            "line 2: side: `top` is not left, right or both",
        ),
    ] {
        let error = read_settings(table.as_bytes(), "t.csv").unwrap_err();
        assert_eq!(
            error.to_string(),
            format!("weights table: {message}"),
            "{table:?}"
        );
    }
    let error = read_settings(b"edge,speed\n1,\xff\n", "t.csv").unwrap_err();
    assert_eq!(error.to_string(), "weights table: line 2: not UTF-8 text");
}

#[test]
fn what_is_particular_goes_before_what_is_general() {
    use Value::{From, Height, Start, Weight};
    let both = Sides::Both;
    let mut document = wkt(RECTANGLE);
    let settings = [
        setting("0:1", both, Weight(5.0)),
        setting("*", both, Weight(2.0)),
        setting("0:*", both, Weight(3.0)),
        setting("0:0:2", both, Weight(7.0)),
        setting(
            "3",
            both,
            From {
                time: 4.0,
                speed: 9.0,
            },
        ),
        setting("3", both, Weight(0.5)),
        setting(
            "3",
            both,
            From {
                time: 2.0,
                speed: 8.0,
            },
        ),
        setting("1", both, Start(1.0)),
        setting("*", both, Height(0.0)),
    ];
    document.set(&settings).unwrap();
    let expected = "0: 3 3; 1: 0 0; 2: 7 7; 3: 0.5 0.5; 1 left at 1: 5; 1 right at 1: 5; \
                    3 left at 2: 8; 3 left at 4: 9; 3 right at 2: 8; 3 right at 4: 9";
    assert_eq!(told(&figure(&document)), expected);
    let mut reversed = wkt(RECTANGLE);
    reversed
        .set(&settings.iter().rev().cloned().collect::<Vec<_>>())
        .unwrap();
    assert_eq!(
        told(&figure(&reversed)),
        expected,
        "the order does not matter"
    );
}

#[test]
fn settings_that_cannot_be() {
    use Value::{Height, Start, Weight};
    let both = Sides::Both;
    let two = format!("{RECTANGLE}\nPOLYGON EMPTY\n{LINE}");
    for (settings, message) in [
        (
            vec![setting("7", both, Weight(1.0))],
            "7 Weight(1.0): feature 0: there is no edge 7 in ring or line 0, which has 4\n7 Weight(1.0): feature 2: there is no edge 7 in ring or line 0, which has 2",
        ),
        (
            vec![setting("2:0:2", both, Start(1.0))],
            "2:0:2 Start(1.0): feature 2: there is no edge 2 in ring or line 0, which has 2",
        ),
        (
            vec![setting("2:1:0", both, Start(1.0))],
            "2:1:0 Start(1.0): feature 2: there is no ring or line 1, only 1 of them",
        ),
        (
            vec![setting("1:0:0", both, Start(1.0))],
            "1:0:0 Start(1.0): feature 1: there is no ring or line 0, only 0 of them",
        ),
        (
            vec![setting("9:0:0", both, Start(1.0))],
            "9:0:0 Start(1.0): there is no feature `9`",
        ),
        (
            vec![setting("0:0:4", both, Height(1.0))],
            "0:0:4 Height(1.0): feature 0: there is no vertex 4 in ring or line 0, which has 4",
        ),
        (
            vec![setting("0:0:1", Sides::Left, Weight(1.0))],
            "0:0:1 Weight(1.0): feature 0: ring 0 is of a polygon, whose edges move alike on both sides",
        ),
        (
            vec![
                setting("1", both, Weight(1.0)),
                setting("1", Sides::Right, Weight(2.0)),
            ],
            "1 Weight(2.0): 1 Weight(1.0) says otherwise",
        ),
    ] {
        let error = wkt(&two).set(&settings).unwrap_err().to_string();
        assert!(error.starts_with(message), "{error}");
    }
    // The same twice is no contradiction.
    let same = [
        setting("1", both, Weight(2.0)),
        setting("1", both, Weight(2.0)),
    ];
    wkt(&two).set(&same).unwrap();
}

#[test]
fn features_are_named_by_id_then_by_number() {
    let text = format!(
        r#"{{"type":"FeatureCollection","features":[{0},{1},{1}]}}"#,
        r#"{"type":"Feature","id":1,"geometry":{"type":"LineString","coordinates":[[0,0],[4,0]]}}"#,
        r#"{"type":"Feature","geometry":{"type":"LineString","coordinates":[[0,0],[4,0]]}}"#
    );
    let mut document = read(text.as_bytes(), Format::GeoJson).unwrap();
    let settings = [
        setting("1:0:0", Sides::Both, Value::Weight(2.0)),
        setting("2:0:0", Sides::Both, Value::Weight(3.0)),
    ];
    document.set(&settings).unwrap();
    let speeds: Vec<_> = document
        .features
        .iter()
        .map(|f| told(&f.figure().unwrap()))
        .collect();
    assert_eq!(speeds, ["0: 2 2", "0: 1 1", "0: 3 3"]);
}
