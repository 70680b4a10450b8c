//! OpenStreetMap's tags of buildings, read from the properties of a feature.
//!
//! `roof:shape`, `roof:angle`, `roof:height`, `height` and `min_height`, as described in
//! `docs/roofs.md`. Numbers may be JSON numbers or text, with a unit: metres, feet and inches.

use hipline::roof::RoofShape;
use serde_json::{Map, Value};

/// What the tags of a feature say.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Tags {
    /// `roof:shape`, as far as it is understood.
    pub shape: Option<RoofShape>,
    /// `roof:angle`, as rise over run.
    pub slope: Option<f64>,
    /// `roof:height`: from the eaves to the ridge.
    pub roof_height: Option<f64>,
    /// `height`: from the ground to the ridge.
    pub height: Option<f64>,
    /// `min_height`: of the floor.
    pub min_height: Option<f64>,
}

impl Tags {
    /// From the properties of a feature, and what in them is not understood.
    ///
    /// # Errors
    /// A number that is none, or out of range; the message names the tag.
    pub fn read(properties: &Map<String, Value>) -> Result<(Self, Option<String>), String> {
        let length = |key: &str| match properties.get(key) {
            None | Some(Value::Null) => Ok(None),
            Some(value) => match metres(value) {
                Some(number) if number.is_finite() && number >= 0.0 => Ok(Some(number)),
                _ => Err(format!("{key} is {value}, which is no length")),
            },
        };
        let slope = match properties.get("roof:angle") {
            None | Some(Value::Null) => None,
            Some(value) => {
                let text = text(value);
                let degrees = text.trim().trim_end_matches('°').trim().parse::<f64>();
                match degrees {
                    Ok(degrees) if degrees > 0.0 && degrees < 90.0 => Some(tangent(degrees)),
                    _ => {
                        return Err(format!(
                            "roof:angle is {value}; it must be above 0 and below 90 degrees"
                        ));
                    }
                }
            }
        };
        let (mut shape, mut unknown) = (None, None);
        if let Some(Value::String(name)) = properties.get("roof:shape") {
            shape = match name.as_str() {
                "hipped" | "pyramidal" => Some(RoofShape::Hip),
                "gabled" => Some(RoofShape::Gable),
                "mansard" => Some(RoofShape::Mansard),
                "gambrel" => Some(RoofShape::Gambrel),
                "flat" => Some(RoofShape::Flat),
                _ => None,
            };
            if shape.is_none() {
                unknown = Some(name.clone());
            }
        }
        let tags = Self {
            shape,
            slope,
            roof_height: length("roof:height")?,
            height: length("height")?,
            min_height: length("min_height")?,
        };
        Ok((tags, unknown))
    }
}

/// The slope of an angle in degrees, exactly 1 for 45.
pub fn tangent(degrees: f64) -> f64 {
    // The tangent of the f64 nearest to pi/4 is not 1.
    if degrees.to_bits() == 45.0_f64.to_bits() {
        1.0
    } else {
        degrees.to_radians().tan()
    }
}

fn text(value: &Value) -> String {
    match value {
        Value::String(text) => text.clone(),
        other => other.to_string(),
    }
}

/// A length as OpenStreetMap writes it: `7`, `7.5 m`, `24 ft`, `12'6"`.
fn metres(value: &Value) -> Option<f64> {
    const FOOT: f64 = 0.3048;
    let text = text(value);
    let text = text.trim();
    if let Some((feet, inches)) = text.split_once('\'') {
        let inches = inches.trim().trim_end_matches('"').trim();
        let inches = if inches.is_empty() {
            0.0
        } else {
            inches.parse::<f64>().ok()?
        };
        return Some((feet.trim().parse::<f64>().ok()? + inches / 12.0) * FOOT);
    }
    if let Some(feet) = text.strip_suffix("ft") {
        return Some(feet.trim().parse::<f64>().ok()? * FOOT);
    }
    text.strip_suffix('m').unwrap_or(text).trim().parse().ok()
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    fn read(value: &Value) -> Result<(Tags, Option<String>), String> {
        Tags::read(value.as_object().expect("an object"))
    }

    #[test]
    fn lengths_have_units() {
        for (value, expected) in [
            (json!(7), Some(7.0)),
            (json!("7.5"), Some(7.5)),
            (json!(" 7.5 m"), Some(7.5)),
            (json!("10 ft"), Some(3.048)),
            (json!("10'"), Some(3.048)),
            (json!("9'12\""), Some(3.048)),
            (json!("tall"), None),
            (json!([]), None),
        ] {
            assert_eq!(metres(&value), expected, "{value}");
        }
    }

    #[test]
    fn tags_are_understood_or_named() {
        let (tags, unknown) = read(&json!({
            "roof:shape": "gabled", "roof:angle": "45", "height": "9 m", "roof:height": 3,
            "min_height": null, "roof:colour": "red"
        }))
        .expect("tags");
        assert_eq!(unknown, None);
        assert_eq!(
            tags,
            Tags {
                shape: Some(RoofShape::Gable),
                slope: Some(1.0),
                roof_height: Some(3.0),
                height: Some(9.0),
                min_height: None,
            }
        );
        let (tags, unknown) = read(&json!({ "roof:shape": "onion" })).expect("tags");
        assert_eq!((tags, unknown.as_deref()), (Tags::default(), Some("onion")));
        for (wrong, key) in [
            (json!({ "roof:angle": 90 }), "roof:angle"),
            (json!({ "roof:angle": "steep" }), "roof:angle"),
            (json!({ "height": -3 }), "height"),
            (json!({ "min_height": "high" }), "min_height"),
        ] {
            let message = read(&wrong).expect_err("a wrong tag");
            assert!(message.starts_with(key), "{message}");
        }
    }
}
