//! All pairs: the definition itself, in quadratic time. What faster grounds have to agree with.

use super::{
    encounter::{Window, encounter},
    field::{Field, Ground},
    hits::{Found, Step},
    walls::{Edges, Segment},
};

/// What stands still.
pub(super) enum Standing<'a> {
    Edges(Edges<'a>),
    Walls(Vec<Segment>),
}

/// Everybody looks at everybody and at all that stands still.
pub(super) struct AllPairs<'a>(pub Standing<'a>);

impl Ground for AllPairs<'_> {
    fn start(&mut self, field: &Field, who: u32, _: &[u32], found: &mut Found) {
        match &self.0 {
            Standing::Edges(edges) => {
                for edge in 0..edges.figure().edges().len() {
                    edges.hits(field, who, edge, found);
                }
            }
            Standing::Walls(walls) => {
                for wall in walls {
                    found.hits.extend(wall.hit(field, who, 0));
                }
            }
        }
        for other in 0..who {
            encounter(field, other, who, Window::ALL, found);
        }
    }

    fn step(&mut self, _: &Field, step: Step, _: &mut Found) {
        unreachable!("motorcycle {} takes no steps", step.who);
    }
}
