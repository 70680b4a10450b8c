//! GeoJSON (RFC 7946), one object or several: one per line, or after record separators.
//!
//! Read by a visitor of our own instead of a general JSON tree, because a position then
//! takes 32 bytes, and because `serde_json` with `float_roundtrip` gives every number as
//! the nearest f64. The depth of nesting is limited by `serde_json` (128).

use std::borrow::Cow;

use serde::Deserialize;
use serde_json::{Map, Value};

use super::{
    position::{lines, polygons},
    weights,
};
use crate::{Document, Feature, FeatureName, Format, ReadError, document::Shape};

mod coordinates;
use coordinates::Coordinates;

const NAME: &str = Format::GeoJson.name();

/// Any GeoJSON object; which members it needs depends on its type.
#[derive(Deserialize)]
struct Object {
    #[serde(rename = "type")]
    kind: Option<String>,
    id: Option<Value>,
    properties: Option<Map<String, Value>>,
    #[serde(default, deserialize_with = "present")]
    geometry: Option<Option<Box<Object>>>,
    geometries: Option<Vec<Object>>,
    features: Option<Vec<Object>>,
    coordinates: Option<Coordinates>,
}

/// Tells `null` (`Some(None)`) from absence (`None`).
fn present<'de, D: serde::Deserializer<'de>>(
    d: D,
) -> Result<Option<Option<Box<Object>>>, D::Error> {
    Option::deserialize(d).map(Some)
}

pub(super) fn read(bytes: &[u8]) -> Result<Document, ReadError> {
    let bytes = bytes.strip_prefix(b"\xEF\xBB\xBF").unwrap_or(bytes);
    // The record separator of RFC 8142 cannot occur inside JSON, not even in a string.
    let bytes: Cow<[u8]> = if bytes.contains(&0x1E) {
        bytes
            .iter()
            .map(|&b| if b == 0x1E { b' ' } else { b })
            .collect::<Vec<_>>()
            .into()
    } else {
        bytes.into()
    };
    // A list would be taken for the members of an object, in some order.
    if bytes.trim_ascii_start().starts_with(b"[") {
        return Err(content("a list where an object should be"));
    }
    let mut document = Document::default();
    let mut objects = 0;
    for object in serde_json::Deserializer::from_slice(&bytes).into_iter::<Object>() {
        let object = object.map_err(|e| super::json_error(NAME, &e))?;
        objects += 1;
        top(object, &mut document)?;
    }
    if objects == 0 {
        return Err(content("there is no JSON object"));
    }
    Ok(document)
}

fn content(message: &str) -> ReadError {
    ReadError::Content {
        format: NAME,
        message: message.to_owned(),
    }
}

fn top(object: Object, document: &mut Document) -> Result<(), ReadError> {
    match object.kind.as_deref() {
        Some("FeatureCollection") => {
            let features = object
                .features
                .ok_or_else(|| content("a FeatureCollection without \"features\""))?;
            for member in features {
                let index = document.features.len();
                if member.kind.as_deref() != Some("Feature") {
                    let message = format!(
                        "a member of \"features\" is {}, not a Feature",
                        describe(member.kind.as_deref())
                    );
                    return Err(ReadError::Feature {
                        format: NAME,
                        feature: FeatureName { index, id: None },
                        message,
                    });
                }
                document.features.push(feature(member, index)?);
            }
        }
        Some("Feature") => document
            .features
            .push(feature(object, document.features.len())?),
        _ => {
            let index = document.features.len();
            let case = shape(object).map_err(|message| ReadError::Feature {
                format: NAME,
                feature: FeatureName { index, id: None },
                message,
            })?;
            document.features.push(Feature {
                index,
                id: None,
                properties: Map::new(),
                case,
            });
        }
    }
    Ok(())
}

fn describe(kind: Option<&str>) -> String {
    kind.map_or_else(
        || "without a \"type\"".to_owned(),
        |kind| format!("a {}", super::text::short(kind)),
    )
}

fn feature(object: Object, index: usize) -> Result<Feature, ReadError> {
    let properties = object.properties.unwrap_or_default();
    let id = text_of(object.id.as_ref()).or_else(|| text_of(properties.get("id")));
    let fail = |message| ReadError::Feature {
        format: NAME,
        feature: FeatureName {
            index,
            id: id.clone(),
        },
        message,
    };
    let mut case = match object.geometry {
        Some(Some(geometry)) => shape(*geometry).map_err(fail)?,
        Some(None) => Shape::Empty,
        None => return Err(fail("a Feature without \"geometry\"".to_owned())),
    };
    weights::assign(&mut case, &properties).map_err(fail)?;
    Ok(Feature {
        index,
        id,
        properties,
        case,
    })
}

fn text_of(value: Option<&Value>) -> Option<String> {
    match value? {
        Value::String(text) => Some(text.clone()),
        Value::Number(number) => Some(number.to_string()),
        _ => None,
    }
}

fn shape(object: Object) -> Result<Shape, String> {
    let Some(kind) = object.kind else {
        return Err("an object without a \"type\"".to_owned());
    };
    if kind == "GeometryCollection" {
        let members = object
            .geometries
            .ok_or("a GeometryCollection without \"geometries\"")?;
        return Ok(Shape::Collection(
            members.into_iter().map(shape).collect::<Result<_, _>>()?,
        ));
    }
    let known = [
        "Point",
        "MultiPoint",
        "LineString",
        "MultiLineString",
        "Polygon",
        "MultiPolygon",
    ];
    if !known.contains(&kind.as_str()) {
        return Err(format!(
            "{} is not a type of geometry",
            super::text::short(&kind)
        ));
    }
    let coordinates = object
        .coordinates
        .ok_or_else(|| format!("a {kind} without \"coordinates\""))?;
    let shape = match kind.as_str() {
        "Point" => coordinates.point().map(Shape::Points),
        "MultiPoint" => coordinates
            .points()
            .map(|points| Shape::Points(points.len())),
        "LineString" => coordinates.points().map(|line| lines(&[line])),
        "MultiLineString" => coordinates.chains().map(|chains| lines(&chains)),
        "Polygon" => coordinates.chains().map(|rings| polygons(&[rings])),
        _ => coordinates.polygons().map(|list| polygons(&list)),
    };
    let mut shape =
        shape.ok_or_else(|| format!("the \"coordinates\" of a {kind} are nested wrongly"))?;
    if shape.is_empty() {
        shape = Shape::Empty;
    }
    Ok(shape)
}

#[cfg(test)]
mod tests;
