//! Values of flags: numbers, slopes, edges.

use crate::tags::tangent;

/// Which edges carry gables.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum GableArg {
    /// The short ends.
    Auto,
    /// None.
    None,
    /// These.
    Edges(Vec<RoofEdge>),
}

/// An edge of a feature: of which polygon, of which ring, which one.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct RoofEdge {
    pub part: u32,
    pub ring: u32,
    pub edge: u32,
}

fn number(text: &str) -> Result<f64, String> {
    text.trim()
        .parse::<f64>()
        .map_err(|_| "this is not a number".to_owned())
}

pub fn finite(text: &str) -> Result<f64, String> {
    let value = number(text)?;
    if value.is_finite() {
        Ok(value)
    } else {
        Err("it must be finite".to_owned())
    }
}

pub fn distance(text: &str) -> Result<f64, String> {
    let value = finite(text)?;
    if value >= 0.0 {
        Ok(value)
    } else {
        Err("it must not be below 0".to_owned())
    }
}

pub fn positive(text: &str) -> Result<f64, String> {
    let value = finite(text)?;
    if value > 0.0 {
        Ok(value)
    } else {
        Err("it must be above 0".to_owned())
    }
}

pub fn elevation(text: &str) -> Result<f64, String> {
    let value = finite(text)?;
    if (0.0..=90.0).contains(&value) {
        Ok(value)
    } else {
        Err("it must be between 0 and 90".to_owned())
    }
}

/// A slope: an angle or a ratio. A bare number of 3 or more is an angle in degrees, because such
/// roofs are rare, and such angles are not.
pub fn slope(text: &str) -> Result<f64, String> {
    const DEGREES_FROM: f64 = 3.0;
    let text = text.trim();
    if let Some((rise, run)) = text.split_once(':') {
        return ratio(positive(rise)? / positive(run)?);
    }
    let unit = text.strip_suffix("deg").or_else(|| text.strip_suffix('°'));
    let number = positive(unit.unwrap_or(text))?;
    if unit.is_none() && number < DEGREES_FROM {
        return Ok(number);
    }
    if number >= 90.0 {
        return Err("it must be below 90 degrees".to_owned());
    }
    ratio(tangent(number))
}

fn ratio(slope: f64) -> Result<f64, String> {
    if slope.is_finite() && slope > 0.0 {
        Ok(slope)
    } else {
        Err("it is steeper or flatter than any number".to_owned())
    }
}

/// An edge as `EDGE`, `RING/EDGE` or `PART/RING/EDGE`.
fn roof_edge(text: &str) -> Result<RoofEdge, String> {
    let numbers: Result<Vec<u32>, _> = text.split('/').map(|n| n.trim().parse()).collect();
    let [part, ring, edge] = match numbers.as_deref() {
        Ok(&[edge]) => [0, 0, edge],
        Ok(&[ring, edge]) => [0, ring, edge],
        Ok(&[part, ring, edge]) => [part, ring, edge],
        _ => {
            return Err(format!(
                "`{text}` is no edge; one is EDGE, RING/EDGE or PART/RING/EDGE"
            ));
        }
    };
    Ok(RoofEdge { part, ring, edge })
}

pub fn edge_slope(text: &str) -> Result<(RoofEdge, f64), String> {
    let (edge, steep) = text.split_once('=').ok_or("it is EDGE=SLOPE, as 3=60deg")?;
    Ok((roof_edge(edge)?, slope(steep)?))
}

pub fn gable(text: &str) -> Result<GableArg, String> {
    match text {
        "auto" => Ok(GableArg::Auto),
        "none" => Ok(GableArg::None),
        list => Ok(GableArg::Edges(
            list.split(',').map(roof_edge).collect::<Result<_, _>>()?,
        )),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn edges() {
        let edge = |part, ring, edge| RoofEdge { part, ring, edge };
        assert_eq!(roof_edge("7"), Ok(edge(0, 0, 7)));
        assert_eq!(roof_edge("1/7"), Ok(edge(0, 1, 7)));
        assert_eq!(roof_edge("2/1/7"), Ok(edge(2, 1, 7)));
        assert_eq!(edge_slope("1/7=45"), Ok((edge(0, 1, 7), 1.0)));
        assert_eq!(
            gable("0,2"),
            Ok(GableArg::Edges(vec![edge(0, 0, 0), edge(0, 0, 2)]))
        );
        for wrong in ["", "x", "-1", "1/2/3/4", "1.5"] {
            assert!(
                roof_edge(wrong).is_err() && gable(wrong).is_err(),
                "{wrong}"
            );
        }
    }

    #[test]
    fn slopes() {
        assert_eq!(slope("45deg"), Ok(1.0));
        assert_eq!(slope("45°"), Ok(1.0));
        assert_eq!(slope("0.7"), Ok(0.7));
        assert_eq!(slope("1:2"), Ok(0.5));
        assert_eq!(slope("35"), slope("35deg"));
        assert_eq!(slope("2.9"), Ok(2.9));
        let steep = slope("60deg").unwrap();
        assert!((steep * steep - 3.0).abs() < 1e-12, "{steep}");
        for wrong in [
            "",
            "0",
            "-1",
            "nan",
            "inf",
            "90deg",
            "0deg",
            "deg",
            "1rad",
            "1e999",
            "90",
            "1:0",
            "0:1",
            "1:2:3",
            "1e-300:1e300",
        ] {
            assert!(slope(wrong).is_err(), "{wrong}");
        }
    }
}
