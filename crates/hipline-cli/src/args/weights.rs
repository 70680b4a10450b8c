//! Flags for weights and heights: how edges move, and how high vertices are.

use std::path::PathBuf;

use clap::{Args as Group, ValueEnum};
use hipline::input::Sides;
use hipline_io::{Profile, Setting, Target, Value};

const HEADING: &str = "Weights";

/// How edges move.
#[derive(Debug, Clone, Default, Group)]
pub struct WeightArgs {
    /// A table of weights (CSV): columns ring, edge and speed; feature, side, time and start if
    /// wanted
    #[arg(long, help_heading = HEADING, value_name = "CSV")]
    pub weights: Option<PathBuf>,

    /// The speed of an edge's wavefront. An edge is EDGE (of ring 0), RING:EDGE or
    /// FEATURE:RING:EDGE, numbers from 0; * stands for all
    #[arg(long, help_heading = HEADING, value_name = "EDGE=SPEED", value_parser = weight)]
    pub weight: Vec<Setting>,

    /// When an edge starts to move; it stands still before
    #[arg(long, help_heading = HEADING, value_name = "EDGE=TIME", value_parser = start)]
    pub start: Vec<Setting>,

    /// Speeds by time, as 0:1,2.5:4, which multiply the weights; of all edges, or of one with
    /// EDGE= before them
    #[arg(long, help_heading = HEADING, value_name = "TIME:SPEED,...", value_parser = profile)]
    pub profile: Vec<Setting>,

    /// Where heights of vertices come from [default: what the file says of them]
    #[arg(long, help_heading = HEADING, value_name = "FROM")]
    pub heights: Option<HeightsArg>,

    /// Compute also where edges pass below the heights of others, which then stand as walls
    #[arg(long, help_heading = HEADING)]
    pub allow_walls: bool,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum HeightsArg {
    /// The third coordinates are heights
    Z,
}

/// The same for single edges and vertices. Apart, because roofs have other words for it.
#[derive(Debug, Clone, Default, Group)]
pub struct GableArgs {
    /// An edge that stands still, as a wall with a gable; the same as --weight EDGE=0
    #[arg(long, help_heading = HEADING, value_name = "EDGE", value_parser = gable)]
    pub gable: Vec<Setting>,

    /// The height of a vertex, in units of time: no wavefront starts there before
    #[arg(long, help_heading = HEADING, value_name = "VERTEX=HEIGHT", value_parser = height)]
    pub height: Vec<Setting>,
}

fn weight(text: &str) -> Result<Setting, String> {
    let (target, speed) = assignment(text, "EDGE=SPEED, as 3=2 or 1:3=2")?;
    setting(
        "weight",
        text,
        target.parse()?,
        Value::Weight(super::distance(speed)?),
    )
}

fn start(text: &str) -> Result<Setting, String> {
    let (target, time) = assignment(text, "EDGE=TIME, as 3=2 or 1:3=2")?;
    setting(
        "start",
        text,
        target.parse()?,
        Value::Start(super::distance(time)?),
    )
}

fn gable(text: &str) -> Result<Setting, String> {
    setting("gable", text, text.parse()?, Value::Weight(0.0))
}

fn height(text: &str) -> Result<Setting, String> {
    let (target, height) = assignment(text, "VERTEX=HEIGHT, as 3=2 or 1:3=2")?;
    setting(
        "height",
        text,
        target.parse()?,
        Value::Height(super::distance(height)?),
    )
}

fn profile(text: &str) -> Result<Setting, String> {
    let (target, pieces) = match text.rsplit_once('=') {
        Some((target, pieces)) => (target.parse()?, pieces),
        None => (Target::default(), text),
    };
    let piece = |piece: &str| {
        let pair = piece.split_once(':');
        let (time, speed) = pair.ok_or_else(|| format!("`{piece}` is not TIME:SPEED, as 2.5:4"))?;
        Ok([super::finite(time)?, super::finite(speed)?])
    };
    let pieces: Result<_, String> = pieces.split(',').map(piece).collect();
    setting(
        "profile",
        text,
        target,
        Value::Profile(Profile::new(pieces?)?),
    )
}

fn assignment<'a>(text: &'a str, form: &str) -> Result<(&'a str, &'a str), String> {
    text.rsplit_once('=').ok_or_else(|| format!("it is {form}"))
}

fn setting(flag: &str, text: &str, target: Target, value: Value) -> Result<Setting, String> {
    Ok(Setting {
        target,
        sides: Sides::Both,
        value,
        origin: format!("--{flag} {text}"),
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn target(feature: Option<&str>, ring: Option<usize>, index: Option<usize>) -> Target {
        Target {
            feature: feature.map(str::to_owned),
            ring,
            index,
        }
    }

    #[test]
    fn targets_and_values() {
        let one = weight("1:3=2.5").unwrap();
        assert_eq!(one.target, target(None, Some(1), Some(3)));
        assert_eq!(one.value, Value::Weight(2.5));
        assert_eq!(one.origin, "--weight 1:3=2.5");
        assert_eq!(weight("*=2").unwrap().target, Target::default());
        assert_eq!(gable("7").unwrap().target, target(None, Some(0), Some(7)));
        // An id may have colons and equal signs.
        let far = start("urn:x=1:0:*=4").unwrap();
        assert_eq!(far.target, target(Some("urn:x=1"), Some(0), None));
        assert_eq!(far.value, Value::Start(4.0));
        let mansard = Value::Profile(Profile::new(vec![[0.0, 1.0], [2.5, 4.0]]).unwrap());
        assert_eq!(profile("0:1,2.5:4").unwrap().value, mansard);
        let one = profile("2=0:1,2.5:4").unwrap();
        assert_eq!(
            (one.target, one.value),
            (target(None, Some(0), Some(2)), mansard)
        );
        assert_eq!(height("*:0=3").unwrap().target, target(None, None, Some(0)));
    }

    #[test]
    fn what_is_none_is_told() {
        for (result, message) in [
            (weight("3"), "it is EDGE=SPEED, as 3=2 or 1:3=2"),
            (weight("x=2"), "`x` is neither a number from 0 nor *"),
            (weight("-1=2"), "`-1` is neither a number from 0 nor *"),
            (weight("1=-2"), "it must not be below 0"),
            (weight("1=inf"), "it must be finite"),
            (start("1=soon"), "this is not a number"),
            (height("1=nan"), "it must be finite"),
            (profile("1"), "`1` is not TIME:SPEED, as 2.5:4"),
            (
                profile("1:1"),
                "a profile starts at the time 0, and this one at 1",
            ),
            (
                profile("0:1,2:1,2:3"),
                "the times of a profile increase, but 2 comes after 2",
            ),
            (
                profile("0:-1"),
                "a speed must not be below 0, and this is -1",
            ),
        ] {
            assert_eq!(result.unwrap_err(), message);
        }
    }
}
