//! Hits in the exact order of their times.
//!
//! The times of hits that f64 cannot tell apart are kept in double-doubles, which tell nearly all of them apart; exact
//! numbers are asked where these overlap. Hits of one moment are one entry, so that a further one costs one comparison.

use super::{field::Field, hits::Hit};
use hipline_num::{BallDd, Number};
use std::{cmp::Ordering, collections::VecDeque};

/// A hit and its time.
#[derive(Clone, Copy)]
struct Timed {
    hit: Hit,
    time: BallDd,
}

/// Hits, moment by moment.
#[derive(Default)]
pub(super) struct Agenda {
    moments: VecDeque<Vec<Timed>>,
}

impl Timed {
    fn new(field: &Field, hit: Hit) -> Self {
        Self {
            hit,
            time: field.planes.near_time(&hit.place),
        }
    }

    fn compare(&self, field: &Field, other: &Self) -> Ordering {
        match self.time.minus(&other.time).sign() {
            Some(sign) if !sign.is_zero() => sign.ordering(),
            _ => field.compare(
                (&self.hit.place, self.hit.bounds),
                (&other.hit.place, other.hit.bounds),
            ),
        }
    }
}

impl Agenda {
    /// Sorts hits.
    pub(super) fn new(field: &Field, hits: impl IntoIterator<Item = Hit>) -> Self {
        let mut hits: Vec<Timed> = (hits.into_iter())
            .map(|hit| Timed::new(field, hit))
            .collect();
        // Nearly in order; a hit then goes to its place from the end.
        hits.sort_by(|p, q| p.time.value().total_cmp(&q.time.value()));
        let mut agenda = Self::default();
        for hit in hits {
            let mut at = agenda.moments.len();
            loop {
                let order = match at.checked_sub(1) {
                    Some(last) => hit.compare(field, &agenda.moments[last][0]),
                    None => Ordering::Greater,
                };
                match order {
                    Ordering::Less => at -= 1,
                    Ordering::Equal => {
                        agenda.moments[at - 1].push(hit);
                        break;
                    }
                    Ordering::Greater => {
                        agenda.moments.insert(at, vec![hit]);
                        break;
                    }
                }
            }
        }
        agenda
    }

    /// Adds a hit.
    pub(super) fn add(&mut self, field: &Field, hit: Hit) {
        let hit = Timed::new(field, hit);
        let found = (self.moments).binary_search_by(|moment| moment[0].compare(field, &hit));
        match found {
            Ok(at) => self.moments[at].push(hit),
            Err(at) => self.moments.insert(at, vec![hit]),
        }
    }

    /// The hits of the next moment.
    pub(super) fn pop(&mut self) -> Option<Vec<Hit>> {
        let moment = self.moments.pop_front()?;
        Some(moment.into_iter().map(|timed| timed.hit).collect())
    }
}
