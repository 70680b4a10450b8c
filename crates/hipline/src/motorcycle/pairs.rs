//! All pairs: the definition itself, in quadratic time. What faster grounds have to agree with.

use super::{
    encounter::{Window, encounter},
    field::{Field, Ground},
    hits::{Found, Step},
    walls::Standing,
    way::ALWAYS,
};

/// Everybody looks at everybody and at all that stands still.
pub(super) struct AllPairs<'a>(pub Standing<'a>);

impl Ground for AllPairs<'_> {
    fn start(&mut self, field: &Field, who: u32, found: &mut Found) {
        for wall in 0..self.0.len() {
            self.0.hits(field, who, wall, ALWAYS, &mut found.hits);
        }
        for other in 0..who {
            encounter(field, other, who, Window::ALL, found);
        }
    }

    fn step(&mut self, _: &Field, step: Step, _: &mut Found) {
        unreachable!("motorcycle {} takes no steps", step.who);
    }
}
