//! The priority queue of what collapses, triangles or wavefront edges: two indexed heaps, and buckets
//! before them.
//!
//! The order of two moments is usually decided by their bounds; where it is not, the caller's
//! exact comparison is asked. That is why no queue off the shelf serves.
//!
//! Most moments are found anew before they come, and need not be ordered at all. So there are three stages:
//!
//! 1. `far`: buckets by lower bounds, in no order. Their limits are quantiles of the first moments. To
//!    come and go takes constant time but for a search among the limits, and no walk through a heap
//!    that does not fit the cache.
//! 2. `waiting`: a heap in the order of lower bounds, of what was in the earliest bucket.
//! 3. `front`: what may be the next, ordered exactly.

use crate::predicates::Bounds;
use crate::topology::Numbered;
use std::cmp::Ordering;

/// Children in the heap of those that wait: few cache lines.
const WAITING: usize = 4;
/// Children in the heap at the front: few comparisons, which may be exact.
const FIRST: usize = 2;
const ABSENT: u32 = u32::MAX;
/// Marks positions in the front.
const FRONT: u32 = 1 << 31;
/// Marks numbers of buckets.
const FAR: u32 = 1 << 30;
/// As many moments go to one bucket at least.
const BUCKET: usize = 64;
/// Fewer moments go to the heap at once.
const FEW: usize = 8 * BUCKET;
/// More buckets there are not: their limits and their ends fit the cache.
const BUCKETS: usize = 1 << 11;

#[derive(Clone, Copy, Debug)]
struct Entry<I> {
    bounds: Bounds,
    id: I,
}

/// Things by the moment of their collapse.
#[derive(Debug)]
pub(crate) struct Queue<I> {
    /// Where the buckets that are left begin, the latest first; `waiting` has what comes before them.
    limits: Vec<f64>,
    /// What comes after each of these limits. Things that are gone may be left there; of several entries of one
    /// thing the last one counts.
    far: Vec<Vec<Entry<I>>>,
    /// By lower bounds.
    waiting: Vec<Entry<I>>,
    /// By moments.
    front: Vec<Entry<I>>,
    /// For each thing, where it is: a position in a heap, or the number of a bucket.
    position: Vec<u32>,
}

impl<I> Default for Queue<I> {
    fn default() -> Self {
        Self {
            limits: Vec::new(),
            far: Vec::new(),
            waiting: Vec::new(),
            front: Vec::new(),
            position: Vec::new(),
        }
    }
}

impl<I: Numbered> Queue<I> {
    /// Empties the queue and makes room for things up to the given number.
    pub(crate) fn reset(&mut self, count: usize) {
        self.limits.clear();
        self.far.clear();
        self.waiting.clear();
        self.front.clear();
        self.position.clear();
        self.position.resize(count, ABSENT);
    }

    /// What collapses first, and the bounds of its moment. Of several at one moment, any.
    pub(crate) fn peek(&mut self, exact: &impl Fn(I, I) -> Ordering) -> Option<(I, Bounds)> {
        loop {
            let high = self.front.first().map(|first| first.bounds.high);
            // All that wait come after the first one at the front.
            let is_later = |low: f64| high.is_some_and(|high| high < low);
            if let Some(&next) = self.waiting.first() {
                if is_later(next.bounds.low) {
                    break;
                }
                self.waiting().remove(0);
                self.front(exact).insert(next);
            } else if let Some(&limit) = self.limits.last()
                && !is_later(limit)
            {
                self.open_bucket();
            } else {
                break;
            }
        }
        self.front.first().map(|entry| (entry.id, entry.bounds))
    }

    /// Lets the things of the earliest bucket wait in order.
    fn open_bucket(&mut self) {
        self.limits.pop();
        let bucket = self.far.pop().unwrap_or_default();
        let number = self.far.len() as u32 | FAR;
        for entry in bucket.into_iter().rev() {
            if self.position[entry.id.number()] == number {
                self.waiting().insert(entry);
            }
        }
    }

    /// Whether something is queued.
    pub(crate) fn contains(&self, t: I) -> bool {
        self.position[t.number()] != ABSENT
    }

    /// Fills the queue anew, in linear time but for the limits of the buckets.
    pub(crate) fn fill(&mut self, entries: impl Iterator<Item = (I, Bounds)>) {
        let entries = entries.map(|(id, bounds)| Entry { bounds, id });
        self.waiting.extend(entries);
        if self.waiting.len() > FEW {
            let first = std::mem::take(&mut self.waiting);
            self.set_limits(&first);
            for entry in first {
                self.put_off(entry);
            }
        }
        for (i, entry) in self.waiting.iter().enumerate() {
            self.position[entry.id.number()] = i as u32;
        }
        for i in (0..self.waiting.len().div_ceil(WAITING)).rev() {
            let entry = self.waiting[i];
            self.waiting().sift_down(i, i, entry);
        }
    }

    /// Chooses limits between buckets: every so many of the lower bounds in order, found from a sample.
    fn set_limits(&mut self, entries: &[Entry<I>]) {
        const EVERY: usize = 8;
        let bucket = BUCKET.max(entries.len() / BUCKETS);
        let mut sample: Vec<f64> = (entries.iter().step_by(EVERY))
            .map(|entry| entry.bounds.low)
            .collect();
        sample.sort_unstable_by(|a, b| b.total_cmp(a));
        self.limits.extend(sample.iter().step_by(bucket / EVERY));
        self.limits.dedup();
        self.far.resize_with(self.limits.len(), Vec::new);
    }

    /// Puts something that is not queued where it has to wait.
    fn put_off(&mut self, entry: Entry<I>) {
        let low = entry.bounds.low;
        // The limits fall; those before this place are above.
        let bucket = self.limits.partition_point(|&limit| limit > low);
        if let Some(list) = self.far.get_mut(bucket) {
            list.push(entry);
            self.position[entry.id.number()] = bucket as u32 | FAR;
        } else {
            self.waiting().insert(entry);
        }
    }

    /// Sets or replaces the moment of something; `None` removes it.
    pub(crate) fn set(&mut self, t: I, bounds: Option<Bounds>, exact: &impl Fn(I, I) -> Ordering) {
        let at = self.position[t.number()];
        if at != ABSENT {
            if at & FRONT != 0 {
                self.front(exact).remove((at & !FRONT) as usize);
            } else if at & FAR != 0 {
                self.position[t.number()] = ABSENT;
            } else {
                self.waiting().remove(at as usize);
            }
        }
        if let Some(bounds) = bounds {
            self.put_off(Entry { bounds, id: t });
        }
    }

    fn waiting(&mut self) -> Heap<'_, I, impl Fn(&Entry<I>, &Entry<I>) -> bool, WAITING> {
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
    ) -> Heap<'a, I, impl Fn(&Entry<I>, &Entry<I>) -> bool, FIRST> {
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
struct Heap<'a, I, F, const ARITY: usize> {
    entries: &'a mut Vec<Entry<I>>,
    position: &'a mut [u32],
    mark: u32,
    less: F,
}

impl<I: Numbered, F: Fn(&Entry<I>, &Entry<I>) -> bool, const ARITY: usize> Heap<'_, I, F, ARITY> {
    fn insert(&mut self, entry: Entry<I>) {
        self.entries.push(entry);
        self.sift_up(self.entries.len() - 1, 0, entry);
    }

    fn remove(&mut self, at: usize) {
        self.position[self.entries[at].id.number()] = ABSENT;
        let last = self.entries.pop().expect("the queue is not empty");
        if at < self.entries.len() {
            self.sift_down(at, 0, last);
        }
    }

    fn put(&mut self, i: usize, entry: Entry<I>) {
        self.entries[i] = entry;
        self.position[entry.id.number()] = i as u32 | self.mark;
    }

    /// Puts an entry at a place that is free, or above it, but not above the top.
    fn sift_up(&mut self, mut i: usize, top: usize, entry: Entry<I>) {
        while i > top {
            let parent = (i - 1) / ARITY;
            if !(self.less)(&entry, &self.entries[parent]) {
                break;
            }
            self.put(i, self.entries[parent]);
            i = parent;
        }
        self.put(i, entry);
    }

    /// Fills a place that is free with the least of what is below it, and so on, down to where nothing is; there an
    /// entry goes, or above, but not above the top. It is likely to belong far below: so it is compared with few.
    fn sift_down(&mut self, mut i: usize, top: usize, entry: Entry<I>) {
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
            self.put(i, self.entries[least]);
            i = least;
        }
        self.sift_up(i, top, entry);
    }
}
