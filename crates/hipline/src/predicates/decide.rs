//! The ladder: a question is asked of one kind of numbers after the other, until one answers.

use hipline_num::{
    Ball, BallDd, Binomial, Fixed, Limbs, Number, Rough, Rungs, Short, Sign, Surd, Wide,
};

use super::{
    fixed::Kept,
    planes::{Planes, Rung},
};

impl Planes {
    /// Asks one rung after the other until one answers.
    #[inline]
    pub(crate) fn decide<Q: Question>(&self, question: &Q) -> Sign {
        let Some(sign) = question.ask::<Rough>(self) else {
            return self.decide_slowly(question);
        };
        self.count(|rungs| rungs.by_f64 += 1);
        sign
    }

    /// Counts a decision.
    #[inline]
    pub(super) fn count(&self, by: impl FnOnce(&mut Rungs)) {
        let mut rungs = self.rungs.get();
        by(&mut rungs);
        self.rungs.set(rungs);
    }

    #[cold]
    fn decide_slowly<Q: Question>(&self, question: &Q) -> Sign {
        let mut rungs = self.rungs.get();
        let sign = if let Some(sign) = question.ask::<Ball>(self) {
            rungs.by_f64 += 1;
            sign
        } else if let Some(sign) = self.ask_on_grid(question) {
            rungs.by_exact += 1;
            sign
        } else if let Some(sign) = question.ask::<BallDd>(self) {
            rungs.by_double_double += 1;
            sign
        } else if let Some(sign) = question.ask::<Wide>(self) {
            rungs.by_wide += 1;
            sign
        } else {
            rungs.by_exact += 1;
            let exactly = || question.ask_exactly::<Surd>(self);
            let sign = self.ask_in_limbs(question).or_else(exactly);
            sign.expect("exact numbers know their sign")
        };
        self.rungs.set(rungs);
        sign
    }

    /// Whether coordinates are so small that many polynomials in them fit machine integers.
    pub(crate) const fn is_on_grid(&self) -> bool {
        self.grid
    }

    /// The answer in machine integers, where these are likely to hold it. There, what f64 cannot
    /// tell is nearly always zero, which double-double cannot tell either.
    fn ask_on_grid<Q: Question>(&self, question: &Q) -> Option<Sign> {
        if self.has_one_root() {
            question.ask_exactly::<Binomial>(self)
        } else if self.grid {
            question.ask_exactly::<Fixed<i128>>(self)
        } else {
            None
        }
    }

    /// The answer in integers of 448 or 1024 binary digits, if they hold it.
    fn ask_in_limbs<Q: Question>(&self, question: &Q) -> Option<Sign> {
        (question.ask_exactly::<Fixed<Short>>(self))
            .or_else(|| question.ask_exactly::<Fixed<Limbs>>(self))
    }

    /// The answer in the least exact numbers that are likely to hold it.
    pub(super) fn ask_shortly<Q: Question>(&self, question: &Q) -> Option<Sign> {
        if self.grid {
            self.ask_on_grid(question)
        } else {
            question.ask_exactly::<Fixed<Short>>(self)
        }
    }

    /// The answer in exact numbers of a fixed width, if they hold it; it is counted.
    pub(super) fn decide_fixed<Q: Question>(&self, question: &Q) -> Option<Sign> {
        let sign = self
            .ask_on_grid(question)
            .or_else(|| self.ask_in_limbs(question))?;
        let mut rungs = self.rungs.get();
        rungs.by_exact += 1;
        self.rungs.set(rungs);
        Some(sign)
    }
}

/// A question whose answer is a sign, to be asked of each rung in turn.
pub(crate) trait Question {
    /// The answer in the numbers of one rung, or `None` where it abstains.
    fn ask<T: Rung>(&self, planes: &Planes) -> Option<Sign>;

    /// The answer in exact numbers.
    fn ask_exactly<T: Exact>(&self, planes: &Planes) -> Option<Sign> {
        self.ask::<T>(planes)
    }
}

/// The rungs of exact numbers.
pub(crate) trait Exact: Rung {
    /// The sign of a + b·√delta, where delta is not negative.
    fn sign_with_root(a: &Self, b: &Self, delta: &Self) -> Option<Sign>;

    /// Whether two numbers are known to be one.
    fn is_same(&self, o: &Self) -> bool {
        self.minus(o).sign().is_some_and(Sign::is_zero)
    }
}

impl Exact for Binomial {
    fn sign_with_root(a: &Self, b: &Self, delta: &Self) -> Option<Sign> {
        Self::sign_with_root(a, b, delta)
    }
}

impl<I: Kept> Exact for Fixed<I> {
    fn sign_with_root(a: &Self, b: &Self, delta: &Self) -> Option<Sign> {
        Self::sign_with_root(a, b, delta)
    }
    fn is_same(&self, o: &Self) -> bool {
        self.minus(o).is_zero()
    }
}

impl Exact for Surd {
    fn sign_with_root(a: &Self, b: &Self, delta: &Self) -> Option<Sign> {
        Some(Self::sign_with_root(a, b, delta))
    }
}
