//! Above a convex cell without valleys the roof is the lower envelope of the planes of its faces (section 4.1 of the thesis).
//!
//! The lower envelope of planes of one slope is the roof above a convex polygon, the one whose edges are all lines, long before any two of them
//! have met; it shrinks, and its edges vanish one after another. A heap has the next one first.

use super::{Envelope, slabs::sorted};
use crate::predicates::{Place, PlaneId};
use std::cmp::Ordering;

/// An edge that vanishes between its neighbours.
#[derive(Clone, Copy)]
struct Vanishing {
    members: [u32; 3],
    place: Place,
}

/// A heap by time.
struct Heap<'a, 'b>(&'a Envelope<'b>, Vec<Vanishing>);

impl Heap<'_, '_> {
    fn is_before(&self, i: usize, j: usize) -> bool {
        let [p, q] = [i, j].map(|k| &self.1[k].place);
        self.0.planes.compare_times(p, q).is_lt()
    }

    fn push(&mut self, item: Vanishing) {
        self.1.push(item);
        let mut at = self.1.len() - 1;
        while at > 0 && self.is_before(at, (at - 1) / 2) {
            self.1.swap(at, (at - 1) / 2);
            at = (at - 1) / 2;
        }
    }

    fn pop(&mut self) -> Option<Vanishing> {
        if self.1.is_empty() {
            return None;
        }
        let first = self.1.swap_remove(0);
        let mut at = 0;
        loop {
            let mut least = at;
            for child in [2 * at + 1, 2 * at + 2] {
                if child < self.1.len() && self.is_before(child, least) {
                    least = child;
                }
            }
            if least == at {
                return Some(first);
            }
            self.1.swap(at, least);
            at = least;
        }
    }
}

impl Envelope<'_> {
    /// The pairs of planes (by class) that border on each other on their lower envelope; a few more where nodes are of high degree.
    ///
    /// # Complexity
    /// O(k log k) questions.
    pub(super) fn convex_pairs(&mut self, mut planes: Vec<PlaneId>) -> Vec<[PlaneId; 2]> {
        planes.sort_unstable();
        planes.dedup();
        let ring = self.by_direction(planes);
        let mut pairs = Vec::with_capacity(2 * ring.len());
        let count = ring.len() as u32;
        if count < 2 {
            return pairs;
        }
        let mut beside: Vec<[u32; 2]> = (0..count)
            .map(|i| [(i + count - 1) % count, (i + 1) % count])
            .collect();
        let mut is_gone = vec![false; ring.len()];
        let mut heap = Heap(self, Vec::with_capacity(2 * ring.len()));
        let event = |members: [u32; 3]| {
            let [a, b, c] = members.map(|i| ring[i as usize]);
            if a == c
                || !self.planes.turn(a, b).is_positive()
                || !self.planes.turn(b, c).is_positive()
            {
                return None;
            }
            let pair = [a, b];
            let moment = sorted([a, b, c]);
            let place = Place::Event { pair, moment };
            Some(Vanishing { members, place })
        };
        let mut steps = 0;
        for i in 0..count {
            let [before, after] = beside[i as usize];
            pairs.push([ring[i as usize], ring[after as usize]]);
            if let Some(event) = event([before, i, after]) {
                heap.push(event);
            }
        }
        while let Some(Vanishing { members, .. }) = heap.pop() {
            let [a, b, c] = members;
            if is_gone[b as usize] || beside[b as usize] != [a, c] {
                continue;
            }
            steps += 1;
            is_gone[b as usize] = true;
            beside[a as usize][1] = c;
            beside[c as usize][0] = a;
            if a == c {
                break;
            }
            pairs.push([a, c].map(|i| ring[i as usize]));
            for middle in [a, c] {
                let [before, after] = beside[middle as usize];
                if let Some(event) = event([before, middle, after]) {
                    heap.push(event);
                }
            }
        }
        self.count.planes += steps;
        pairs
    }

    /// Planes in the order of their directions, counterclockwise; of those with one direction, the lowest.
    fn by_direction(&self, mut planes: Vec<PlaneId>) -> Vec<PlaneId> {
        let first = planes[0];
        let half = |i: PlaneId| match self.planes.turn(first, i) {
            sign if sign.is_positive() => 0,
            sign if sign.is_negative() => 1,
            _ => u8::from(!self.planes.same_direction(first, i)),
        };
        let mut keyed: Vec<(u8, PlaneId)> = planes.drain(..).map(|i| (half(i), i)).collect();
        let order = |&(k, i): &(u8, PlaneId), &(l, j): &(u8, PlaneId)| {
            k.cmp(&l).then_with(|| {
                if i == j {
                    Ordering::Equal
                } else {
                    self.planes.turn(j, i).ordering()
                }
            })
        };
        keyed.sort_by(order);
        let mut ring: Vec<(u8, PlaneId)> = Vec::with_capacity(keyed.len());
        for item in keyed {
            match ring.last_mut() {
                Some(last) if order(last, &item).is_eq() => {
                    if self.is_lower(item.1, last.1) {
                        *last = item;
                    }
                }
                _ => ring.push(item),
            }
        }
        ring.into_iter().map(|(_, i)| i).collect()
    }

    /// Whether one of two planes of one direction is below the other.
    fn is_lower(&self, i: PlaneId, j: PlaneId) -> bool {
        let across = self
            .across
            .into_iter()
            .find(|&k| !self.planes.turn(i, k).is_zero());
        let across = across.expect("they have two directions");
        let pair = self.planes.turning_left([i, across]).expect("they cross");
        // Where i is at time zero, j has not been yet, if it is later there.
        (self.planes.ahead(&Place::At { pair, time: 0.0 }, j)).is_positive()
    }
}
