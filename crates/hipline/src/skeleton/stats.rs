//! What the computation did, counted.

/// Counts of one computation; [`Skeleton::stats`](super::Skeleton::stats).
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct Stats {
    /// Edge events: wavefront edges that shrank to a point.
    pub edge_events: u64,
    /// Split events: wavefront vertices that ran into a wavefront edge or into each other.
    pub split_events: u64,
    /// Flips of spokes.
    pub flips: u64,
    /// Elementary steps: triangles looked at by the kinetic engine, arcs drawn and arcs looked at by those
    /// without a triangulation.
    pub steps: u64,
    /// Decisions answered by f64 with a proven error bound.
    pub by_f64: u64,
    /// Decisions answered by double-double with a proven error bound.
    pub by_double_double: u64,
    /// Decisions answered by numbers of 400 digits with a proven error bound.
    pub by_wide: u64,
    /// Decisions answered by exact integers.
    pub by_exact: u64,
}

impl Stats {
    /// Adds the counts of another computation.
    pub(super) const fn add(&mut self, other: &Self) {
        self.edge_events += other.edge_events;
        self.split_events += other.split_events;
        self.flips += other.flips;
        self.steps += other.steps;
        self.by_f64 += other.by_f64;
        self.by_double_double += other.by_double_double;
        self.by_wide += other.by_wide;
        self.by_exact += other.by_exact;
    }
}
