//! Exact signs and correctly rounded values of polynomials in square roots.
//!
//! Every decision in a straight skeleton is the sign of an integer polynomial in a few
//! square roots of integers. This crate answers such questions on a ladder of
//! [`Number`] types, cheapest first:
//!
//! | rung | type | when it cannot tell |
//! | --- | --- | --- |
//! | f64 with a proven error bound | [`Ball`] | abstains |
//! | machine integers with one root | [`Binomial`] | abstains |
//! | double-double with a proven error bound | [`BallDd`] | abstains |
//! | 400 digits with a proven error bound | [`Wide`] | abstains |
//! | integers of up to 1024 digits and square roots | [`Fixed`] | abstains |
//! | integers and square roots | [`Surd`] | always tells |
//!
//! It knows no geometry. Nothing here compares against a tolerance: a sign is either proven
//! or withheld. In both kinds of ball an error of zero means *the value is this very
//! integer*, so that the degenerate cases of integer input are decided by the first rung.
//!
//! [`round_quotient`] and its relatives turn the exact answer into the nearest f64.
//!
//! The derivations are collected in `docs/numbers.md`; every constant repeats its own.

mod ball;
mod ball_dd;
mod binomial;
mod dyadic;
mod fixed;
mod length;
mod limbs;
mod number;
mod rough;
mod rounding;
mod rungs;
mod sign;
mod square;
mod surd;
mod surd_sign;

mod wide;
mod words;

pub use ball::Ball;
pub use ball_dd::BallDd;
pub use binomial::Binomial;
pub use dyadic::{
    common_unit, exponent, f64_to_parts, ilog2, in_units, ldexp, odd_parts, power_of_two,
};
pub use fixed::{Fixed, Radicals};
pub use length::{Segment, compare_lengths, distance, exponent_above, hypot};
pub use limbs::{Digits, Integer, Limbs, Short};
pub use number::Number;
pub use rough::Rough;
pub use rounding::{
    compare_quotient_f64, round_ball_dd, round_ball_dd_plus, round_quotient, round_quotient_plus,
    round_wide_plus,
};
pub use rungs::Rungs;
pub use sign::Sign;
pub use square::perfect_root;
pub use surd::Surd;

pub use wide::Wide;

/// Re-exported so that callers name the same integers.
pub use dashu_int::{IBig, UBig};
