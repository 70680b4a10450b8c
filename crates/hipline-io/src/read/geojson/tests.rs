use super::*;
use crate::{LineShape, Motion, PolygonShape};

fn ok(text: &str) -> Vec<Feature> {
    read(text.as_bytes())
        .unwrap_or_else(|e| panic!("{text}: {e}"))
        .features
}

fn err(text: &str) -> String {
    read(text.as_bytes())
        .map(|d| panic!("{text}: {d:?}"))
        .unwrap_err()
        .to_string()
}

fn geometry(kind: &str, coordinates: &str) -> String {
    format!(r#"{{"type":"{kind}","coordinates":{coordinates}}}"#)
}

#[test]
fn every_geometry() {
    let ring = "[[0,0],[1,0,9],[0,1,9,9],[0,0]]";
    let points = vec![[0.0, 0.0], [1.0, 0.0], [0.0, 1.0], [0.0, 0.0]];
    let motion = Motion {
        z: vec![None, Some(9.0), Some(9.0), None],
        ..Motion::default()
    };
    let polygon = PolygonShape {
        motions: vec![motion.clone()],
        ..PolygonShape::new(vec![points.clone()])
    };
    let line = LineShape {
        motion,
        ..LineShape::new(points)
    };
    for (kind, coordinates, shape) in [
        (
            "Polygon",
            format!("[{ring}]"),
            Shape::Polygons(vec![polygon.clone()]),
        ),
        (
            "MultiPolygon",
            format!("[[{ring}],[],[{ring}]]"),
            Shape::Polygons(vec![polygon.clone(), polygon]),
        ),
        (
            "LineString",
            ring.to_owned(),
            Shape::Lines(vec![line.clone()]),
        ),
        (
            "MultiLineString",
            format!("[{ring},{ring}]"),
            Shape::Lines(vec![line.clone(), line]),
        ),
        ("Point", "[1,2]".to_owned(), Shape::Points(1)),
        ("MultiPoint", "[[1,2],[3,4]]".to_owned(), Shape::Points(2)),
        ("Polygon", "[]".to_owned(), Shape::Empty),
        ("Polygon", "[[]]".to_owned(), Shape::Empty),
        ("MultiPolygon", "[]".to_owned(), Shape::Empty),
        ("Point", "[]".to_owned(), Shape::Empty),
    ] {
        let bare = geometry(kind, &coordinates);
        assert_eq!(ok(&bare)[0].case, shape);
        let feature = format!(r#"{{"geometry":{bare},"type":"Feature","bbox":[0,0,1,1],"id":7}}"#);
        let features = ok(&feature);
        assert_eq!(
            (features[0].id.as_deref(), &features[0].case),
            (Some("7"), &shape)
        );
        let collection = format!(r#"{{"type":"GeometryCollection","geometries":[{bare}]}}"#);
        assert_eq!(ok(&collection)[0].case, Shape::Collection(vec![shape]));
    }
}

#[test]
fn several_objects_follow_each_other() {
    let line = geometry("LineString", "[[0,0],[1,1]]");
    let feature = format!(r#"{{"type":"Feature","properties":{{"id":"a"}},"geometry":{line}}}"#);
    let collection = format!(r#"{{"type":"FeatureCollection","features":[{feature},{feature}]}}"#);
    for text in [
        format!("{line}\n{feature}\n{collection}\n"),
        format!("\u{feff}{line}{feature} {collection}"),
        format!("\u{1e}{line}\n\u{1e}{feature}\n\u{1e}{collection}\n"),
    ] {
        let names: Vec<_> = ok(&text).iter().map(|f| f.name().to_string()).collect();
        assert_eq!(
            names,
            [
                "feature 0",
                "feature 1 (\"a\")",
                "feature 2 (\"a\")",
                "feature 3 (\"a\")"
            ]
        );
    }
    assert_eq!(ok(r#"{"type":"FeatureCollection","features":[]}"#), []);
}

#[test]
fn no_geometry_is_empty() {
    assert_eq!(
        ok(r#"{"type":"Feature","geometry":null,"properties":null}"#)[0].case,
        Shape::Empty
    );
}

#[test]
fn weights_reach_the_edges() {
    let polygon = geometry("Polygon", "[[[0,0],[1,0],[0,1],[0,0]]]");
    let feature = format!(
        r#"{{"type":"Feature","properties":{{"edge_weights":[[1,2,0.1]]}},"geometry":{polygon}}}"#
    );
    let Shape::Polygons(polygons) = &ok(&feature)[0].case else {
        panic!("not a polygon")
    };
    assert_eq!(polygons[0].speeds, Some(vec![vec![1.0, 2.0, 0.1]]));
    let feature = feature.replace("0.1", "null");
    assert_eq!(
        err(&feature),
        "GeoJSON, feature 0: edge_weights of ring or line 0: edge 2: `null` is not a number"
    );
}

#[test]
fn numbers_are_rounded_correctly() {
    // Halfway cases, the largest and smallest doubles, and one that a naive parser misses.
    let decimals = [
        "9007199254740993",
        "9007199254740992.99999999999999999999",
        "-0",
        "1e-400",
        "2.2250738585072012e-308",
        "2.2250738585072011e-308",
        "4.9406564584124654e-324",
        "2.4703282292062327208e-324",
        "1.7976931348623157e308",
        "0.1",
        "123456789.123456789123456789",
        "18446744073709551615",
        "18446744073709551616",
        "-9223372036854775809",
        "8.41e21",
        "9.5e-22",
        "1.2345678901234567e-300",
    ];
    for decimal in decimals {
        let features = ok(&geometry(
            "LineString",
            &format!("[[{decimal},0],[0,{decimal}]]"),
        ));
        let Shape::Lines(lines) = &features[0].case else {
            panic!("not a line")
        };
        let expected: f64 = decimal.parse().unwrap();
        assert_eq!(
            lines[0].points[0][0].to_bits(),
            expected.to_bits(),
            "{decimal}"
        );
        assert_eq!(
            lines[0].points[1][1].to_bits(),
            expected.to_bits(),
            "{decimal}"
        );
    }
}

#[test]
fn errors_name_the_place() {
    let line = |coordinates: &str| err(&geometry("LineString", coordinates));
    assert_eq!(err(""), "GeoJSON: there is no JSON object");
    assert_eq!(err("[1]"), "GeoJSON: a list where an object should be");
    assert_eq!(
        err("{\n\"type\":}"),
        "GeoJSON, line 2, column 8: expected value"
    );
    assert_eq!(
        err("{}"),
        "GeoJSON, feature 0: an object without a \"type\""
    );
    assert_eq!(
        err(r#"{"type":"Feature"}"#),
        "GeoJSON, feature 0: a Feature without \"geometry\""
    );
    assert_eq!(
        err(r#"{"type":"Polygon"}"#),
        "GeoJSON, feature 0: a Polygon without \"coordinates\""
    );
    assert_eq!(
        err(r#"{"type":"Circle"}"#),
        "GeoJSON, feature 0: `Circle` is not a type of geometry"
    );
    assert_eq!(
        line("[[0,0],[NaN,1]]"),
        "GeoJSON, line 1, column 44: expected value"
    );
    assert_eq!(
        line("[[0,0],[null,1]]"),
        "GeoJSON, line 1, column 47: invalid type: null, expected a number or a list of coordinates"
    );
    assert_eq!(
        line("[[0,0],[1e999,1]]"),
        "GeoJSON, line 1, column 48: number out of range"
    );
    assert_eq!(
        line("[[0,0],[1]]"),
        "GeoJSON, line 1, column 45: a position needs two numbers"
    );
    assert_eq!(
        line("[[0,0],1]"),
        "GeoJSON, line 1, column 44: a number among lists of coordinates"
    );
    assert_eq!(
        line("[[[0,0],[1,1]]]"),
        "GeoJSON, feature 0: the \"coordinates\" of a LineString are nested wrongly"
    );
    let nested = "[".repeat(100_000);
    assert_eq!(
        line(&nested),
        "GeoJSON, line 1, column 162: recursion limit exceeded"
    );
    assert_eq!(
        err(r#"{"type":"FeatureCollection","features":[{"type":"Polygon","coordinates":[]}]}"#),
        "GeoJSON, feature 0: a member of \"features\" is a `Polygon`, not a Feature"
    );
}
