//! Sets of numbers that are joined step by step.

/// Disjoint sets of the numbers below a count (union-find, halving paths).
#[derive(Debug, Clone, Default)]
pub(crate) struct Sets(Vec<u32>);

impl Sets {
    /// Each number by itself.
    pub(crate) fn new(count: usize) -> Self {
        let count = u32::try_from(count).expect("more than 2^32 elements");
        Self((0..count).collect())
    }

    /// No numbers yet, with room for some.
    pub(crate) fn with_capacity(count: usize) -> Self {
        Self(Vec::with_capacity(count))
    }

    /// Adds the next number, by itself, and returns it.
    pub(crate) fn push(&mut self) -> u32 {
        let next = u32::try_from(self.0.len()).expect("more than 2^32 elements");
        self.0.push(next);
        next
    }

    /// The smallest number of a set.
    pub(crate) fn root(&mut self, i: usize) -> usize {
        let mut i = i;
        while self.0[i] as usize != i {
            self.0[i] = self.0[self.0[i] as usize];
            i = self.0[i] as usize;
        }
        i
    }

    /// Joins the sets of two numbers.
    pub(crate) fn join(&mut self, a: usize, b: usize) {
        let (a, b) = (self.root(a), self.root(b));
        self.0[a.max(b)] = a.min(b) as u32;
    }
}
