//! The priority queue of edge collapses: an indexed binary heap, as in the kinetic engine.
//!
//! The order of two moments is usually decided by their bounds; where it is not, the caller's
//! exact comparison is asked.

use crate::predicates::Bounds;
use std::cmp::Ordering;

const ABSENT: u32 = u32::MAX;

/// Wavefront edges by the moment of their collapse.
#[derive(Debug, Default)]
pub(super) struct Queue {
    heap: Vec<(Bounds, u32)>,
    position: Vec<u32>,
    /// How often two entries were compared.
    pub comparisons: u64,
}

impl Queue {
    pub(super) fn new(waves: usize) -> Self {
        Self {
            heap: Vec::with_capacity(waves),
            position: vec![ABSENT; waves],
            comparisons: 0,
        }
    }

    /// The first wavefront edge to collapse, and bounds of the moment.
    pub(super) fn peek(&self) -> Option<(Bounds, u32)> {
        self.heap.first().copied()
    }

    /// Fills the queue, in linear time.
    pub(super) fn fill(
        &mut self,
        entries: impl Iterator<Item = (Bounds, u32)>,
        exact: &impl Fn(u32, u32) -> Ordering,
    ) {
        self.heap.extend(entries);
        for (i, &(_, wave)) in self.heap.iter().enumerate() {
            self.position[wave as usize] = i as u32;
        }
        for i in (0..self.heap.len() / 2).rev() {
            self.sift_down(i, exact);
        }
    }

    /// Sets or replaces the moment of a wavefront edge; `None` removes it.
    pub(super) fn set(
        &mut self,
        wave: u32,
        bounds: Option<Bounds>,
        exact: &impl Fn(u32, u32) -> Ordering,
    ) {
        let at = self.position[wave as usize];
        match (at, bounds) {
            (ABSENT, None) => {}
            (ABSENT, Some(bounds)) => {
                self.heap.push((bounds, wave));
                self.sift_up(self.heap.len() - 1, exact);
            }
            (at, None) => {
                self.position[wave as usize] = ABSENT;
                let last = self.heap.pop().expect("the queue is not empty");
                if (at as usize) < self.heap.len() {
                    self.heap[at as usize] = last;
                    self.position[last.1 as usize] = at;
                    self.sift_down(at as usize, exact);
                    self.sift_up(self.position[last.1 as usize] as usize, exact);
                }
            }
            (at, Some(bounds)) => {
                self.heap[at as usize].0 = bounds;
                self.sift_down(at as usize, exact);
                self.sift_up(self.position[wave as usize] as usize, exact);
            }
        }
    }

    fn less(
        &mut self,
        a: (Bounds, u32),
        b: (Bounds, u32),
        exact: &impl Fn(u32, u32) -> Ordering,
    ) -> bool {
        self.comparisons += 1;
        a.0.compare(b.0).unwrap_or_else(|| exact(a.1, b.1)).is_lt()
    }

    fn sift_up(&mut self, mut i: usize, exact: &impl Fn(u32, u32) -> Ordering) {
        let entry = self.heap[i];
        while i > 0 {
            let parent = (i - 1) / 2;
            if !self.less(entry, self.heap[parent], exact) {
                break;
            }
            self.heap[i] = self.heap[parent];
            self.position[self.heap[i].1 as usize] = i as u32;
            i = parent;
        }
        self.heap[i] = entry;
        self.position[entry.1 as usize] = i as u32;
    }

    fn sift_down(&mut self, mut i: usize, exact: &impl Fn(u32, u32) -> Ordering) {
        let entry = self.heap[i];
        loop {
            let mut child = 2 * i + 1;
            if child >= self.heap.len() {
                break;
            }
            if child + 1 < self.heap.len()
                && self.less(self.heap[child + 1], self.heap[child], exact)
            {
                child += 1;
            }
            if !self.less(self.heap[child], entry, exact) {
                break;
            }
            self.heap[i] = self.heap[child];
            self.position[self.heap[i].1 as usize] = i as u32;
            i = child;
        }
        self.heap[i] = entry;
        self.position[entry.1 as usize] = i as u32;
    }
}
