//! How often each rung of the ladder answered.

use std::ops::AddAssign;

/// Counts of the questions that each rung answered.
#[derive(Clone, Copy, Default, Debug, PartialEq, Eq)]
pub struct Rungs {
    /// Answered by [`Ball`](crate::Ball).
    pub by_f64: u64,
    /// Answered by [`BallDd`](crate::BallDd).
    pub by_double_double: u64,
    /// Answered by [`Wide`](crate::Wide).
    pub by_wide: u64,
    /// Answered by exact numbers: [`Fixed`](crate::Fixed) or [`Surd`](crate::Surd).
    pub by_exact: u64,
}

impl Rungs {
    /// Adds the counts of `o`.
    #[inline]
    pub fn add(&mut self, o: &Self) {
        self.by_f64 += o.by_f64;
        self.by_double_double += o.by_double_double;
        self.by_wide += o.by_wide;
        self.by_exact += o.by_exact;
    }

    /// How many questions were asked in all.
    #[must_use]
    pub const fn total(&self) -> u64 {
        self.by_f64 + self.by_double_double + self.by_wide + self.by_exact
    }
}

impl AddAssign for Rungs {
    fn add_assign(&mut self, o: Self) {
        self.add(&o);
    }
}
