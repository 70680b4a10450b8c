//! All pairs: the definition itself, in quadratic time. What faster grounds have to agree with.

use super::{
    encounter::{Window, encounter},
    race::{Field, Found, Ground, Step},
    walls::Edges,
};

/// Everybody looks at everybody and at every edge.
pub(super) struct AllPairs<'a>(pub Edges<'a>);

impl Ground for AllPairs<'_> {
    fn start(&mut self, field: &Field, who: u32, _: &[u32], found: &mut Found) {
        for edge in 0..self.0.figure().edges().len() {
            self.0.hits(field, who, edge, found);
        }
        for other in 0..who {
            encounter(field, other, who, Window::ALL, found);
        }
    }

    fn step(&mut self, _: &Field, step: Step, _: &mut Found) {
        unreachable!("motorcycle {} takes no steps", step.who);
    }
}
