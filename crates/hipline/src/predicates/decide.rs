//! The ladder: a question is asked of one kind of numbers after the other, until one answers.

use hipline_num::{Ball, BallDd, Fixed, Limbs, Rough, Rungs, Short, Sign, Surd, Wide};

use super::fixed::Kept;
use super::planes::{Planes, Rung};

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
        } else if let Some((sign, exact)) = self.ask_further(question) {
            if exact {
                rungs.by_exact += 1;
            } else {
                rungs.by_wide += 1;
            }
            sign
        } else {
            rungs.by_exact += 1;
            question.ask_exactly(self)
        };
        self.rungs.set(rungs);
        sign
    }

    /// The answer of exact numbers of a fixed width or of 400 digits, and whether it is the former's.
    fn ask_further<Q: Question>(&self, question: &Q) -> Option<(Sign, bool)> {
        let fixed = || self.ask_in_limbs(question).map(|sign| (sign, true));
        let wide = || question.ask::<Wide>(self).map(|sign| (sign, false));
        if question.is_steep() {
            wide().or_else(fixed)
        } else {
            fixed().or_else(wide)
        }
    }

    /// Whether coordinates are so small that many polynomials in them fit machine integers.
    pub(crate) const fn is_on_grid(&self) -> bool {
        self.grid
    }

    /// The answer in machine integers, where these are likely to hold it. There, what f64 cannot
    /// tell is nearly always zero, which double-double cannot tell either.
    fn ask_on_grid<Q: Question>(&self, question: &Q) -> Option<Sign> {
        if self.grid {
            question.ask_fixed::<i128>(self)
        } else {
            None
        }
    }

    /// The answer in integers of 448 or 1024 binary digits, if they hold it.
    fn ask_in_limbs<Q: Question>(&self, question: &Q) -> Option<Sign> {
        (question.ask_fixed::<Short>(self)).or_else(|| question.ask_fixed::<Limbs>(self))
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

    /// Whether exact numbers have so many terms that 400 digits are cheaper.
    fn is_steep(&self) -> bool {
        false
    }

    /// The answer in exact numbers of a fixed width.
    fn ask_fixed<I: Kept>(&self, planes: &Planes) -> Option<Sign> {
        self.ask::<Fixed<I>>(planes)
    }

    /// The answer in exact numbers, which never abstain.
    fn ask_exactly(&self, planes: &Planes) -> Sign {
        self.ask::<Surd>(planes)
            .expect("exact numbers know their sign")
    }
}
