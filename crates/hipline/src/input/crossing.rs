use super::{Edge, Flaw, range::Scale, triangulate::Conflicts};
pub(super) fn report(_v: &[[f64; 2]], _e: &[Edge], _s: Scale, _c: Conflicts, flaws: &mut Vec<Flaw>) {
    flaws.push(Flaw::MorePairs { at_least: 1 });
}
