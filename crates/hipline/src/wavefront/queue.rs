//! The priority queue of what collapses, triangles or wavefront edges: two indexed 4-ary heaps.
//!
//! The order of two moments is usually decided by their bounds; where it is not, the caller's
//! exact comparison is asked. That is why no queue off the shelf serves.
//!
//! Most moments are found anew before they come, and need not be ordered exactly. So they wait in the order
//! of their lower bounds, until one of them may be the next: then it moves to the front, which
//! is ordered exactly.

use crate::predicates::Bounds;
use crate::topology::Numbered;
use std::cmp::Ordering;

const ARITY: usize = 4;
const ABSENT: u32 = u32::MAX;
/// Marks positions in the front.
const FRONT: u32 = 1 << 31;

#[derive(Clone, Copy, Debug)]
struct Entry<I> {
    bounds: Bounds,
    id: I,
}

/// Things by the moment of their collapse.
#[derive(Debug)]
pub(crate) struct Queue<I> {
    /// By lower bounds.
    waiting: Vec<Entry<I>>,
    /// By moments.
    front: Vec<Entry<I>>,
    position: Vec<u32>,
}

impl<I> Default for Queue<I> {
    fn default() -> Self {
        Self {
            waiting: Vec::new(),
            front: Vec::new(),
            position: Vec::new(),
        }
    }
}

impl<I: Numbered> Queue<I> {
    /// Empties the queue and makes room for things up to the given number.
    pub(crate) fn reset(&mut self, count: usize) {
        self.waiting.clear();
        self.front.clear();
        self.position.clear();
        self.position.resize(count, ABSENT);
    }

    /// What collapses first. Of several at one moment, any.
    pub(crate) fn peek(&mut self, exact: &impl Fn(I, I) -> Ordering) -> Option<I> {
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
        self.front.first().map(|entry| entry.id)
    }

    /// The bounds of the moment of something queued.
    pub(crate) fn bounds(&self, t: I) -> Option<Bounds> {
        let at = self.position[t.number()];
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
    pub(crate) fn fill(&mut self, entries: impl Iterator<Item = (I, Bounds)>) {
        self.waiting
            .extend(entries.map(|(id, bounds)| Entry { bounds, id }));
        for (i, entry) in self.waiting.iter().enumerate() {
            self.position[entry.id.number()] = i as u32;
        }
        for i in (0..self.waiting.len().div_ceil(ARITY)).rev() {
            self.waiting().sift_down(i);
        }
    }

    /// Sets or replaces the moment of something; `None` removes it.
    pub(crate) fn set(&mut self, t: I, bounds: Option<Bounds>, exact: &impl Fn(I, I) -> Ordering) {
        let at = self.position[t.number()];
        if at != ABSENT {
            if at & FRONT == 0 {
                self.waiting().remove(at as usize);
            } else {
                self.front(exact).remove((at & !FRONT) as usize);
            }
        }
        if let Some(bounds) = bounds {
            self.waiting().insert(Entry { bounds, id: t });
        }
    }

    fn waiting(&mut self) -> Heap<'_, I, impl Fn(&Entry<I>, &Entry<I>) -> bool> {
        Heap {
            entries: &mut self.waiting,
            position: &mut self.position,
            mark: 0,
            less: |a: &Entry<I>, b: &Entry<I>| a.bounds.low < b.bounds.low,
        }
    }

    fn front<'a>(
        &'a mut self,
        exact: &'a impl Fn(I, I) -> Ordering,
    ) -> Heap<'a, I, impl Fn(&Entry<I>, &Entry<I>) -> bool> {
        Heap {
            entries: &mut self.front,
            position: &mut self.position,
            mark: FRONT,
            less: |a: &Entry<I>, b: &Entry<I>| {
                a.bounds
                    .compare(b.bounds)
                    .unwrap_or_else(|| exact(a.id, b.id))
                    .is_lt()
            },
        }
    }
}

/// One of the heaps.
struct Heap<'a, I, F> {
    entries: &'a mut Vec<Entry<I>>,
    position: &'a mut [u32],
    mark: u32,
    less: F,
}

impl<I: Numbered, F: Fn(&Entry<I>, &Entry<I>) -> bool> Heap<'_, I, F> {
    fn insert(&mut self, entry: Entry<I>) {
        self.entries.push(entry);
        self.sift_up(self.entries.len() - 1);
    }

    fn remove(&mut self, at: usize) {
        self.position[self.entries[at].id.number()] = ABSENT;
        let last = self.entries.pop().expect("the queue is not empty");
        if at < self.entries.len() {
            self.entries[at] = last;
            let stays = self.sift_down(at) == at;
            if stays {
                self.sift_up(at);
            }
        }
    }

    fn put(&mut self, i: usize, entry: Entry<I>) {
        self.entries[i] = entry;
        self.position[entry.id.number()] = i as u32 | self.mark;
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
