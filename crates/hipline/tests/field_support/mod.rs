//! What tests on inputs from the field share: features read into figures.
#![allow(dead_code, reason = "no test needs all of it")]

use hipline::FigureBuilder;
use serde_json::Value;

pub fn list<T>(value: &Value, convert: impl FnMut(&Value) -> T) -> Vec<T> {
    let values = value.as_array().expect("an array");
    values.iter().map(convert).collect()
}

pub fn point(value: &Value) -> [f64; 2] {
    [0, 1].map(|axis| value[axis].as_f64().expect("a number"))
}

pub fn rings(value: &Value) -> Vec<Vec<[f64; 2]>> {
    list(value, |ring| list(ring, point))
}

/// A builder with a feature, if it is of a type that the data has.
pub fn builder(feature: &Value) -> Option<FigureBuilder> {
    let geometry = &feature["geometry"];
    let coordinates = &geometry["coordinates"];
    let mut builder = FigureBuilder::new();
    match geometry["type"].as_str()? {
        "Polygon" => {
            let weights = &feature["properties"]["edge_weights"];
            if weights.is_array() {
                let speeds = list(weights, |ring| {
                    list(ring, |w| w.as_f64().expect("a number"))
                });
                builder.weighted_polygon(rings(coordinates), speeds);
            } else {
                builder.polygon(rings(coordinates));
            }
        }
        "MultiPolygon" => list(coordinates, rings).into_iter().for_each(|rings| {
            builder.polygon(rings);
        }),
        "MultiLineString" => rings(coordinates).into_iter().for_each(|line| {
            builder.polyline(line);
        }),
        "LineString" => {
            builder.polyline(list(coordinates, point));
        }
        _ => return None,
    }
    Some(builder)
}
