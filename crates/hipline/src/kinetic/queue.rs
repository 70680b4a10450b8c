//! The priority queue of collapsing triangles: two indexed 4-ary heaps.
//!
//! The order of two moments is usually decided by their bounds; where it is not, the caller's
//! exact comparison is asked. That is why no queue off the shelf serves.
//!
//! Most moments are found anew before they come, and need not be ordered exactly. So they wait in the order
//! of their lower bounds, until one of them may be the next: then it moves to the front, which
//! is ordered exactly.

use crate::predicates::Bounds;
use crate::topology::TriangleId;
use std::cmp::Ordering;

const ARITY: usize = 4;
const ABSENT: u32 = u32::MAX;
/// Marks positions in the front.
const FRONT: u32 = 1 << 31;

#[derive(Clone, Copy, Debug)]
struct Entry {
    bounds: Bounds,
    triangle: TriangleId,
}

/// Triangles by the moment of their collapse.
#[derive(Debug, Default)]
pub(super) struct Queue {
    /// By lower bounds.
    waiting: Vec<Entry>,
    /// By moments.
    front: Vec<Entry>,
    position: Vec<u32>,
}

impl Queue {
    /// Empties the queue and makes room for triangles up to the given number.
    pub(super) fn reset(&mut self, triangles: usize) {
        self.waiting.clear();
        self.front.clear();
        self.position.clear();
        self.position.resize(triangles, ABSENT);
    }

    /// A triangle that collapses first. Of several at one moment, any.
    pub(super) fn peek(
        &mut self,
        exact: &impl Fn(TriangleId, TriangleId) -> Ordering,
    ) -> Option<TriangleId> {
        while let Some(&next) = self.waiting.first() {
            // All that wait come after the first one at the front.
            if let Some(first) = self.front.first()
                && first.bounds.high < next.bounds.low
            {
                break;
            }
            self.waiting().remove(0);
            self.front(exact).insert(next);
        }
        self.front.first().map(|entry| entry.triangle)
    }

    /// The bounds of a queued triangle's moment.
    pub(super) fn bounds(&self, t: TriangleId) -> Option<Bounds> {
        let at = self.position[t.index()];
        if at == ABSENT {
            return None;
        }
        let heap = if at & FRONT == 0 {
            &self.waiting
        } else {
            &self.front
        };
        Some(heap[(at & !FRONT) as usize].bounds)
    }

    /// Fills the queue anew, in linear time.
    pub(super) fn fill(&mut self, entries: impl Iterator<Item = (TriangleId, Bounds)>) {
        self.waiting
            .extend(entries.map(|(triangle, bounds)| Entry { bounds, triangle }));
        for (i, entry) in self.waiting.iter().enumerate() {
            self.position[entry.triangle.index()] = i as u32;
        }
        for i in (0..self.waiting.len().div_ceil(ARITY)).rev() {
            self.waiting().sift_down(i);
        }
    }

    /// Sets or replaces the moment of a triangle; `None` removes it.
    pub(super) fn set(
        &mut self,
        t: TriangleId,
        bounds: Option<Bounds>,
        exact: &impl Fn(TriangleId, TriangleId) -> Ordering,
    ) {
        let at = self.position[t.index()];
        if at != ABSENT {
            if at & FRONT == 0 {
                self.waiting().remove(at as usize);
            } else {
                self.front(exact).remove((at & !FRONT) as usize);
            }
        }
        if let Some(bounds) = bounds {
            let triangle = t;
            self.waiting().insert(Entry { bounds, triangle });
        }
    }

    fn waiting(&mut self) -> Heap<'_, impl Fn(&Entry, &Entry) -> bool> {
        Heap {
            entries: &mut self.waiting,
            position: &mut self.position,
            mark: 0,
            less: |a: &Entry, b: &Entry| a.bounds.low < b.bounds.low,
        }
    }

    fn front<'a>(
        &'a mut self,
        exact: &'a impl Fn(TriangleId, TriangleId) -> Ordering,
    ) -> Heap<'a, impl Fn(&Entry, &Entry) -> bool> {
        Heap {
            entries: &mut self.front,
            position: &mut self.position,
            mark: FRONT,
            less: |a: &Entry, b: &Entry| {
                a.bounds
                    .compare(b.bounds)
                    .unwrap_or_else(|| exact(a.triangle, b.triangle))
                    .is_lt()
            },
        }
    }
}

/// One of the heaps.
struct Heap<'a, F> {
    entries: &'a mut Vec<Entry>,
    position: &'a mut [u32],
    mark: u32,
    less: F,
}

impl<F: Fn(&Entry, &Entry) -> bool> Heap<'_, F> {
    fn insert(&mut self, entry: Entry) {
        self.entries.push(entry);
        self.sift_up(self.entries.len() - 1);
    }

    fn remove(&mut self, at: usize) {
        self.position[self.entries[at].triangle.index()] = ABSENT;
        let last = self.entries.pop().expect("the queue is not empty");
        if at < self.entries.len() {
            self.entries[at] = last;
            let stays = self.sift_down(at) == at;
            if stays {
                self.sift_up(at);
            }
        }
    }

    fn put(&mut self, i: usize, entry: Entry) {
        self.entries[i] = entry;
        self.position[entry.triangle.index()] = i as u32 | self.mark;
    }

    fn sift_up(&mut self, mut i: usize) {
        let entry = self.entries[i];
        while i > 0 {
            let parent = (i - 1) / ARITY;
            if !(self.less)(&entry, &self.entries[parent]) {
                break;
            }
            self.put(i, self.entries[parent]);
            i = parent;
        }
        self.put(i, entry);
    }

    /// Returns where the entry came to lie.
    fn sift_down(&mut self, mut i: usize) -> usize {
        let entry = self.entries[i];
        loop {
            let first = i * ARITY + 1;
            if first >= self.entries.len() {
                break;
            }
            let mut least = first;
            for child in first + 1..(first + ARITY).min(self.entries.len()) {
                if (self.less)(&self.entries[child], &self.entries[least]) {
                    least = child;
                }
            }
            if !(self.less)(&self.entries[least], &entry) {
                break;
            }
            self.put(i, self.entries[least]);
            i = least;
        }
        self.put(i, entry);
        i
    }
}
