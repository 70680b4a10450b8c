//! Numbers as the shortest decimals that lead back to them.

use std::fmt;

/// Prints the shortest decimals that are read back as the same f64, `null` for what is not
/// finite. Both JSON and WKT understand the exponents.
pub(super) struct Number(pub f64);

/// Up to here a whole number is exact and no longer than with an exponent.
const PLAIN: f64 = 1e15;

impl fmt::Display for Number {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let value = self.0;
        if !value.is_finite() {
            f.write_str("null")
        } else if value.trunc().to_bits() == value.to_bits()
            && value.abs() < PLAIN
            && value.to_bits() != 1 << 63
        {
            write!(f, "{value}")
        } else {
            write!(f, "{value:?}")
        }
    }
}

/// Prints a number with at most three decimals, none of them a last zero: for pictures.
pub(super) struct Rounded(pub f64);

impl fmt::Display for Rounded {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let text = format!("{:.3}", self.0);
        let text = text.trim_end_matches('0').trim_end_matches('.');
        f.write_str(if text == "-0" { "0" } else { text })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn shortest_and_exact() {
        for (value, text) in [
            (0.0, "0"),
            (-0.0, "-0.0"),
            (3.0, "3"),
            (-1e14, "-100000000000000"),
            (1e15, "1000000000000000.0"),
            (1e300, "1e300"),
            (0.1, "0.1"),
            (0.1 + 0.2, "0.30000000000000004"),
            (5e-324, "5e-324"),
            (f64::MAX, "1.7976931348623157e308"),
            (f64::INFINITY, "null"),
        ] {
            assert_eq!(Number(value).to_string(), text);
            if value.is_finite() {
                assert_eq!(text.parse::<f64>().unwrap().to_bits(), value.to_bits());
            }
        }
        for (value, text) in [
            (1.0, "1"),
            (-0.0004, "0"),
            (100.0, "100"),
            (2.5, "2.5"),
            (-1.23456, "-1.235"),
        ] {
            assert_eq!(Rounded(value).to_string(), text);
        }
    }
}
