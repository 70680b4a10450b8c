//! What can be wrong with an input, in the caller's own numbering.

/// A vertex in the caller's numbering.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Place {
    /// Which polygon, line or graph, in the order of the calls to the builder.
    pub part: usize,
    /// Which ring of a polygon (0 is the shell), 0 otherwise.
    pub ring: usize,
    /// Which vertex of the ring, line or graph; an edge is named by its first vertex (in a
    /// graph, by its number in the list of edges).
    pub index: usize,
}

/// One reason why an input is not a figure. (to be completed)
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum Flaw {
    /// Nothing to compute a skeleton of.
    #[error("there is no edge")]
    Empty,
}

/// Everything that is wrong with an input.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[error("{} flaws, the first: {}", .flaws.len(), .flaws[0])]
pub struct InvalidFigure {
    /// Every flaw, at least one.
    pub flaws: Vec<Flaw>,
}
