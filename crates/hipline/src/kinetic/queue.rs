//! The priority queue of collapsing triangles: an indexed 4-ary heap.
//!
//! The order of two moments is usually decided by their bounds; where it is not, the caller's
//! exact comparison is asked. That is why no queue off the shelf serves.

use crate::predicates::Bounds;
use crate::topology::TriangleId;
use std::cmp::Ordering;

const ARITY: usize = 4;
const ABSENT: u32 = u32::MAX;

#[derive(Clone, Copy, Debug)]
struct Entry {
    bounds: Bounds,
    triangle: TriangleId,
}

/// Triangles by the moment of their collapse.
#[derive(Debug, Default)]
pub(super) struct Queue {
    heap: Vec<Entry>,
    position: Vec<u32>,
}

impl Queue {
    /// Empties the queue and makes room for triangles up to the given number.
    pub(super) fn reset(&mut self, triangles: usize) {
        self.heap.clear();
        self.position.clear();
        self.position.resize(triangles, ABSENT);
    }

    pub(super) fn peek(&self) -> Option<TriangleId> {
        self.heap.first().map(|entry| entry.triangle)
    }

    /// The bounds of a queued triangle's moment.
    pub(super) fn bounds(&self, t: TriangleId) -> Option<Bounds> {
        let at = self.position[t.index()];
        (at != ABSENT).then(|| self.heap[at as usize].bounds)
    }

    /// Fills the queue anew, in linear time.
    pub(super) fn fill(
        &mut self,
        entries: impl Iterator<Item = (TriangleId, Bounds)>,
        exact: &impl Fn(TriangleId, TriangleId) -> Ordering,
    ) {
        self.heap
            .extend(entries.map(|(triangle, bounds)| Entry { bounds, triangle }));
        for (i, entry) in self.heap.iter().enumerate() {
            self.position[entry.triangle.index()] = i as u32;
        }
        for i in (0..self.heap.len().div_ceil(ARITY)).rev() {
            self.sift_down(i, exact);
        }
    }

    /// Sets or replaces the moment of a triangle; `None` removes it.
    pub(super) fn set(
        &mut self,
        t: TriangleId,
        bounds: Option<Bounds>,
        exact: &impl Fn(TriangleId, TriangleId) -> Ordering,
    ) {
        match (self.position[t.index()], bounds) {
            (ABSENT, None) => {}
            (ABSENT, Some(bounds)) => {
                self.heap.push(Entry {
                    bounds,
                    triangle: t,
                });
                let last = self.heap.len() - 1;
                self.position[t.index()] = last as u32;
                self.sift_up(last, exact);
            }
            (at, None) => {
                let at = at as usize;
                self.position[t.index()] = ABSENT;
                let last = self.heap.pop().expect("the queue is not empty");
                if at < self.heap.len() {
                    self.heap[at] = last;
                    self.position[last.triangle.index()] = at as u32;
                    self.sift_down(at, exact);
                    self.sift_up(self.position[last.triangle.index()] as usize, exact);
                }
            }
            (at, Some(bounds)) => {
                self.heap[at as usize].bounds = bounds;
                self.sift_down(at as usize, exact);
                self.sift_up(self.position[t.index()] as usize, exact);
            }
        }
    }

    fn less(a: &Entry, b: &Entry, exact: &impl Fn(TriangleId, TriangleId) -> Ordering) -> bool {
        a.bounds
            .compare(b.bounds)
            .unwrap_or_else(|| exact(a.triangle, b.triangle))
            .is_lt()
    }

    fn sift_up(&mut self, mut i: usize, exact: &impl Fn(TriangleId, TriangleId) -> Ordering) {
        let entry = self.heap[i];
        while i > 0 {
            let parent = (i - 1) / ARITY;
            if !Self::less(&entry, &self.heap[parent], exact) {
                break;
            }
            self.heap[i] = self.heap[parent];
            self.position[self.heap[i].triangle.index()] = i as u32;
            i = parent;
        }
        self.heap[i] = entry;
        self.position[entry.triangle.index()] = i as u32;
    }

    fn sift_down(&mut self, mut i: usize, exact: &impl Fn(TriangleId, TriangleId) -> Ordering) {
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
            self.position[self.heap[i].triangle.index()] = i as u32;
            i = least;
        }
        self.heap[i] = entry;
        self.position[entry.triangle.index()] = i as u32;
    }
}
