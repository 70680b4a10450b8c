//! The priority queue of what collapses, triangles or wavefront edges: an indexed 4-ary heap.
//!
//! The order of two moments is usually decided by their bounds; where it is not, the caller's
//! exact comparison is asked. That is why no queue off the shelf serves.

use crate::predicates::Bounds;
use crate::topology::Numbered;
use std::cmp::Ordering;

const ARITY: usize = 4;
const ABSENT: u32 = u32::MAX;

#[derive(Clone, Copy, Debug)]
struct Entry<I> {
    bounds: Bounds,
    id: I,
}

/// Things by the moment of their collapse.
#[derive(Debug)]
pub(crate) struct Queue<I> {
    heap: Vec<Entry<I>>,
    position: Vec<u32>,
}

impl<I> Default for Queue<I> {
    fn default() -> Self {
        Self {
            heap: Vec::new(),
            position: Vec::new(),
        }
    }
}

impl<I: Numbered> Queue<I> {
    /// Empties the queue and makes room for things up to the given number.
    pub(crate) fn reset(&mut self, count: usize) {
        self.heap.clear();
        self.position.clear();
        self.position.resize(count, ABSENT);
    }

    pub(crate) fn peek(&self) -> Option<I> {
        self.heap.first().map(|entry| entry.id)
    }

    /// The bounds of the moment of something queued.
    pub(crate) fn bounds(&self, t: I) -> Option<Bounds> {
        let at = self.position[t.number()];
        (at != ABSENT).then(|| self.heap[at as usize].bounds)
    }

    /// Fills the queue anew, in linear time.
    pub(crate) fn fill(
        &mut self,
        entries: impl Iterator<Item = (I, Bounds)>,
        exact: &impl Fn(I, I) -> Ordering,
    ) {
        self.heap
            .extend(entries.map(|(id, bounds)| Entry { bounds, id }));
        for (i, entry) in self.heap.iter().enumerate() {
            self.position[entry.id.number()] = i as u32;
        }
        for i in (0..self.heap.len().div_ceil(ARITY)).rev() {
            self.sift_down(i, exact);
        }
    }

    /// Sets or replaces the moment of something; `None` removes it.
    pub(crate) fn set(&mut self, t: I, bounds: Option<Bounds>, exact: &impl Fn(I, I) -> Ordering) {
        match (self.position[t.number()], bounds) {
            (ABSENT, None) => {}
            (ABSENT, Some(bounds)) => {
                self.heap.push(Entry { bounds, id: t });
                let last = self.heap.len() - 1;
                self.position[t.number()] = last as u32;
                self.sift_up(last, exact);
            }
            (at, None) => {
                let at = at as usize;
                self.position[t.number()] = ABSENT;
                let last = self.heap.pop().expect("the queue is not empty");
                if at < self.heap.len() {
                    self.heap[at] = last;
                    self.position[last.id.number()] = at as u32;
                    self.sift_down(at, exact);
                    self.sift_up(self.position[last.id.number()] as usize, exact);
                }
            }
            (at, Some(bounds)) => {
                self.heap[at as usize].bounds = bounds;
                self.sift_down(at as usize, exact);
                self.sift_up(self.position[t.number()] as usize, exact);
            }
        }
    }

    fn less(a: &Entry<I>, b: &Entry<I>, exact: &impl Fn(I, I) -> Ordering) -> bool {
        a.bounds
            .compare(b.bounds)
            .unwrap_or_else(|| exact(a.id, b.id))
            .is_lt()
    }

    fn sift_up(&mut self, mut i: usize, exact: &impl Fn(I, I) -> Ordering) {
        let entry = self.heap[i];
        while i > 0 {
            let parent = (i - 1) / ARITY;
            if !Self::less(&entry, &self.heap[parent], exact) {
                break;
            }
            self.heap[i] = self.heap[parent];
            self.position[self.heap[i].id.number()] = i as u32;
            i = parent;
        }
        self.heap[i] = entry;
        self.position[entry.id.number()] = i as u32;
    }

    fn sift_down(&mut self, mut i: usize, exact: &impl Fn(I, I) -> Ordering) {
        let entry = self.heap[i];
        loop {
            let first = i * ARITY + 1;
            if first >= self.heap.len() {
                break;
            }
            let mut least = first;
            for child in first + 1..(first + ARITY).min(self.heap.len()) {
                if Self::less(&self.heap[child], &self.heap[least], exact) {
                    least = child;
                }
            }
            if !Self::less(&self.heap[least], &entry, exact) {
                break;
            }
            self.heap[i] = self.heap[least];
            self.position[self.heap[i].id.number()] = i as u32;
            i = least;
        }
        self.heap[i] = entry;
        self.position[entry.id.number()] = i as u32;
    }
}
