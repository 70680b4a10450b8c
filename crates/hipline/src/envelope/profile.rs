//! Lower envelopes of segments over a line, by merging halves.
//!
//! What the segments are, and how their ends compare, is the [`Chart`]'s matter: the boundary of a face seen along its
//! edge, or the roof above a cut. No two lines may coincide, so envelopes never tie along a stretch.
//!
//! *Departure.* Hershberger (1989) sorts the segments into groups first, so that each envelope has linear size, and gets
//! O(k log k); merging halves takes O(k α(k) log k), where α is the inverse of Ackermann's function: less than five.

use hipline_num::Sign;
use std::cmp::Ordering;

/// How two lines lie to each other.
pub(super) enum Meet<S> {
    /// They never meet; positive if the first one is lower.
    Never(Sign),
    /// They cross; positive if the first one is lower on the right.
    At(S, Sign),
}

/// A line to look along, with curves over it that cross in one point at most.
pub(super) trait Chart {
    /// A place on the line.
    type Spot: Clone;
    /// From left to right.
    fn order(&self, p: &Self::Spot, q: &Self::Spot) -> Ordering;
    /// How two different curves lie to each other.
    fn meet(&self, a: u32, b: u32) -> Meet<Self::Spot>;
}

/// A stretch of a curve, from left to right.
#[derive(Clone, Debug)]
pub(super) struct Piece<S> {
    pub from: S,
    pub to: S,
    /// Which curve.
    pub of: u32,
}

/// Counts of what was done.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Count {
    /// Stretches over which two curves were compared.
    pub steps: u64,
}

/// The lower envelope of pieces that may overlap, from left to right.
///
/// # Complexity
/// O(k α(k) log k) questions for k pieces.
pub(super) fn lower_envelope<C: Chart>(
    chart: &C,
    pieces: Vec<Piece<C::Spot>>,
    count: &mut Count,
) -> Vec<Piece<C::Spot>> {
    let mut lists: Vec<Vec<Piece<C::Spot>>> = pieces.into_iter().map(|piece| vec![piece]).collect();
    // Bottom up: no recursion.
    while lists.len() > 1 {
        let mut merged = Vec::with_capacity(lists.len().div_ceil(2));
        let mut rest = lists.into_iter();
        while let Some(a) = rest.next() {
            merged.push(match rest.next() {
                Some(b) => merge(chart, a, b, count),
                None => a,
            });
        }
        lists = merged;
    }
    lists.pop().unwrap_or_default()
}

/// Adds a stretch on the right; one that goes on along the same curve is joined.
fn push<C: Chart>(chart: &C, list: &mut Vec<Piece<C::Spot>>, piece: Piece<C::Spot>) {
    if let Some(last) = list.last_mut()
        && last.of == piece.of
        && chart.order(&last.to, &piece.from).is_ge()
    {
        last.to = piece.to;
        return;
    }
    list.push(piece);
}

/// The lower one of two envelopes.
fn merge<C: Chart>(
    chart: &C,
    a: Vec<Piece<C::Spot>>,
    b: Vec<Piece<C::Spot>>,
    count: &mut Count,
) -> Vec<Piece<C::Spot>> {
    let mut merged = Vec::with_capacity(a.len() + b.len());
    let (mut a, mut b) = (a.into_iter(), b.into_iter());
    let (mut next_a, mut next_b) = (a.next(), b.next());
    loop {
        let (mut p, mut q) = match (next_a.take(), next_b.take()) {
            (Some(p), Some(q)) => (p, q),
            (Some(p), None) => {
                push(chart, &mut merged, p);
                a.by_ref().for_each(|p| push(chart, &mut merged, p));
                return merged;
            }
            (None, Some(q)) => {
                push(chart, &mut merged, q);
                b.by_ref().for_each(|q| push(chart, &mut merged, q));
                return merged;
            }
            (None, None) => return merged,
        };
        count.steps += 1;
        // What one has alone on the left.
        let starts = chart.order(&p.from, &q.from);
        if starts.is_lt() {
            if chart.order(&p.to, &q.from).is_le() {
                push(chart, &mut merged, p);
                (next_a, next_b) = (a.next(), Some(q));
                continue;
            }
            let alone = Piece {
                from: p.from,
                to: q.from.clone(),
                of: p.of,
            };
            push(chart, &mut merged, alone);
            p.from = q.from.clone();
        } else if starts.is_gt() {
            if chart.order(&q.to, &p.from).is_le() {
                push(chart, &mut merged, q);
                (next_a, next_b) = (Some(p), b.next());
                continue;
            }
            let alone = Piece {
                from: q.from,
                to: p.from.clone(),
                of: q.of,
            };
            push(chart, &mut merged, alone);
            q.from = p.from.clone();
        }
        // Both, as far as the first one ends.
        let ends = chart.order(&p.to, &q.to);
        let to = if ends.is_le() {
            p.to.clone()
        } else {
            q.to.clone()
        };
        let lower = |of: u32, from: C::Spot, to: C::Spot| Piece { from, to, of };
        let from = p.from.clone();
        if p.of == q.of {
            push(chart, &mut merged, lower(p.of, from, to.clone()));
        } else {
            let whole = |sign: Sign| if sign.is_positive() { p.of } else { q.of };
            match chart.meet(p.of, q.of) {
                Meet::Never(sign) => push(chart, &mut merged, lower(whole(sign), from, to.clone())),
                Meet::At(x, right) if chart.order(&x, &from).is_le() => {
                    push(chart, &mut merged, lower(whole(right), from, to.clone()));
                    drop(x);
                }
                Meet::At(x, right) if chart.order(&x, &to).is_ge() => {
                    push(chart, &mut merged, lower(whole(-right), from, to.clone()));
                    drop(x);
                }
                Meet::At(x, right) => {
                    push(chart, &mut merged, lower(whole(-right), from, x.clone()));
                    push(chart, &mut merged, lower(whole(right), x, to.clone()));
                }
            }
        }
        let rest = |piece: Piece<C::Spot>, from: C::Spot| Piece { from, ..piece };
        (next_a, next_b) = match ends {
            Ordering::Less => (a.next(), Some(rest(q, to))),
            Ordering::Equal => (a.next(), b.next()),
            Ordering::Greater => (Some(rest(p, to)), b.next()),
        };
    }
}

#[cfg(test)]
mod tests;
