//! The triangulation of the unswept region: corners and neighbours, no coordinate.
//!
//! Every triangle's corners are in counterclockwise order; side k lies opposite corner k,
//! from corner k+1 to corner k+2. Across a side lies a triangle, a wavefront edge (directed
//! like the side, the triangle on its left), or, between two points at infinity, nothing.

use crate::predicates::Direction;
use crate::topology::{TraceId, TriangleId, WaveId};
use smallvec::SmallVec;

/// The next side or corner, counterclockwise.
pub(super) const fn next(k: usize) -> usize {
    if k == 2 { 0 } else { k + 1 }
}

/// The previous side or corner.
pub(super) const fn prev(k: usize) -> usize {
    if k == 0 { 2 } else { k - 1 }
}

/// A corner of a triangle: a wavefront vertex or a point at infinity.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) struct Tip(u32);

impl Tip {
    const FIRST_IDEAL: u32 = u32::MAX - 3;

    pub(super) fn ideal(direction: usize) -> Self {
        Self(Self::FIRST_IDEAL + (direction % 4) as u32)
    }

    pub(super) const fn trace(self) -> Option<TraceId> {
        if self.0 < Self::FIRST_IDEAL {
            Some(TraceId::raw(self.0))
        } else {
            None
        }
    }

    pub(super) const fn direction(self) -> Option<Direction> {
        if self.0 < Self::FIRST_IDEAL {
            None
        } else {
            Some(Direction::ALL[(self.0 - Self::FIRST_IDEAL) as usize])
        }
    }
}

impl From<TraceId> for Tip {
    fn from(trace: TraceId) -> Self {
        Self(trace.index() as u32)
    }
}

impl std::fmt::Debug for Tip {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self.direction() {
            Some(direction) => write!(f, "{direction:?}"),
            None => write!(f, "x{}", self.0),
        }
    }
}

/// What lies across a side.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) struct Across(u32);

impl Across {
    const WAVE: u32 = 1 << 31;
    /// Beyond infinity.
    pub(super) const NOTHING: Self = Self(u32::MAX);

    pub(super) const fn triangle(self) -> Option<TriangleId> {
        if self.0 & Self::WAVE == 0 {
            Some(TriangleId::raw(self.0))
        } else {
            None
        }
    }

    pub(super) const fn wave(self) -> Option<WaveId> {
        if self.0 & Self::WAVE == 0 || self.0 == u32::MAX {
            None
        } else {
            Some(WaveId::raw(self.0 & !Self::WAVE))
        }
    }
}

impl From<TriangleId> for Across {
    fn from(triangle: TriangleId) -> Self {
        Self(triangle.index() as u32)
    }
}

impl From<WaveId> for Across {
    fn from(wave: WaveId) -> Self {
        Self(wave.index() as u32 | Self::WAVE)
    }
}

impl std::fmt::Debug for Across {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match (self.triangle(), self.wave()) {
            (Some(t), _) => write!(f, "{t:?}"),
            (_, Some(w)) => write!(f, "{w:?}"),
            _ => f.write_str("-"),
        }
    }
}

/// One triangle.
#[derive(Clone, Copy, Debug)]
pub(super) struct Triangle {
    pub tips: [Tip; 3],
    pub across: [Across; 3],
    /// The batch in which it was last visited, or `DEAD`.
    visited: u32,
}

/// Marks triangles that have collapsed.
const DEAD: u32 = u32::MAX;

/// All triangles, and for each wavefront edge the triangle that it bounds.
#[derive(Debug, Default)]
pub(super) struct Triangulation {
    pub triangles: Vec<Triangle>,
    beside: Vec<TriangleId>,
}

impl Triangulation {
    pub(super) fn with_capacity(triangles: usize, waves: usize) -> Self {
        Self {
            triangles: Vec::with_capacity(triangles),
            beside: Vec::with_capacity(waves),
        }
    }

    pub(super) fn push(&mut self, tips: [Tip; 3], across: [Across; 3]) -> TriangleId {
        self.triangles.push(Triangle {
            tips,
            across,
            visited: 0,
        });
        TriangleId::new(self.triangles.len() - 1)
    }

    /// Registers the next wavefront edge and the triangle it bounds.
    pub(super) fn push_wave(&mut self, triangle: TriangleId) -> WaveId {
        self.beside.push(triangle);
        WaveId::new(self.beside.len() - 1)
    }

    pub(super) fn len(&self) -> usize {
        self.triangles.len()
    }

    pub(super) fn get(&self, t: TriangleId) -> &Triangle {
        &self.triangles[t.index()]
    }

    pub(super) fn is_alive(&self, t: TriangleId) -> bool {
        self.get(t).visited != DEAD
    }

    /// Whether a triangle was not yet visited in this batch; now it is. Collapsed triangles always are new.
    pub(super) fn visit(&mut self, t: TriangleId, batch: u32) -> bool {
        let visited = &mut self.triangles[t.index()].visited;
        if *visited == DEAD {
            return true;
        }
        std::mem::replace(visited, batch) != batch
    }

    pub(super) fn kill(&mut self, t: TriangleId) {
        self.triangles[t.index()].visited = DEAD;
    }

    /// Whether a wavefront edge is still there.
    pub(super) fn has(&self, wave: WaveId) -> bool {
        let t = self.beside[wave.index()];
        self.is_alive(t) && self.get(t).across.contains(&wave.into())
    }

    /// The triangle on the left of a wavefront edge, and its side there.
    pub(super) fn beside(&self, wave: WaveId) -> (TriangleId, usize) {
        let t = self.beside[wave.index()];
        (t, self.side_to(t, wave.into()))
    }

    /// The ends of a wavefront edge.
    pub(super) fn ends(&self, wave: WaveId) -> [TraceId; 2] {
        let (t, k) = self.beside(wave);
        let tips = self.get(t).tips;
        [tips[next(k)], tips[prev(k)]].map(|tip| tip.trace().expect("wavefront edges are finite"))
    }

    /// The side of `t` across which `what` lies.
    pub(super) fn side_to(&self, t: TriangleId, what: Across) -> usize {
        let across = &self.get(t).across;
        across
            .iter()
            .position(|&a| a == what)
            .unwrap_or_else(|| panic!("{t} has no side to {what:?}"))
    }

    /// The corner of `t` that is `tip`.
    pub(super) fn corner_of(&self, t: TriangleId, tip: Tip) -> usize {
        let tips = &self.get(t).tips;
        tips.iter()
            .position(|&a| a == tip)
            .unwrap_or_else(|| panic!("{t} has no corner {tip:?}"))
    }

    /// Puts `what` across side k of `t`, and `t` beside it.
    pub(super) fn attach(&mut self, t: TriangleId, k: usize, what: Across) {
        self.triangles[t.index()].across[k] = what;
        if let Some(wave) = what.wave() {
            self.beside[wave.index()] = t;
        }
    }

    /// Joins what lies across two sides that have become one: `a` and `b` lay across from
    /// triangle `old`. Returns the triangle that has got a wavefront edge, if one has.
    pub(super) fn glue(&mut self, old: TriangleId, a: Across, b: Across) -> Option<TriangleId> {
        let (ka, kb) = (
            a.triangle().map(|t| (t, self.side_to(t, old.into()))),
            b.triangle().map(|t| (t, self.side_to(t, old.into()))),
        );
        if let Some((t, k)) = ka {
            self.attach(t, k, b);
        }
        if let Some((t, k)) = kb {
            self.attach(t, k, a);
        }
        match (ka, kb) {
            (Some((t, _)), None) | (None, Some((t, _))) => Some(t),
            _ => None,
        }
    }

    /// The triangles around a vertex, counterclockwise from a wavefront edge that leaves it
    /// to the one that enters it, with the vertex's corner in each.
    pub(super) fn fan(&self, out: WaveId) -> Fan<'_> {
        let (t, k) = self.beside(out);
        Fan {
            triangulation: self,
            at: Some((t, next(k))),
        }
    }

    /// The step of a fan: across the side that follows the corner counterclockwise.
    fn step(&self, t: TriangleId, corner: usize) -> Option<(TriangleId, usize)> {
        let side = next(corner);
        let after = self.get(t).across[side].triangle()?;
        Some((after, next(self.side_to(after, t.into()))))
    }

    /// What two triangles that follow each other around a vertex have there besides it, counterclockwise; each is given with the
    /// vertex's corner. The second is the end of the spoke between the two.
    pub(super) fn rim(&self, [(t, corner), (other, k)]: [(TriangleId, usize); 2]) -> [Tip; 3] {
        let tips = self.get(t).tips;
        [
            tips[next(corner)],
            tips[prev(corner)],
            self.get(other).tips[prev(k)],
        ]
    }

    /// Replaces the diagonal on side k of `t`. Returns the two new triangles, which keep
    /// the ids: `t` has the corners `[k, k+1, apex]`, the other `[k, apex, k+2]`.
    pub(super) fn flip(&mut self, t: TriangleId, k: usize) -> TriangleId {
        let other = self.get(t).across[k]
            .triangle()
            .expect("only spokes are flipped");
        let j = self.side_to(other, t.into());
        let (a, b) = (*self.get(t), *self.get(other));
        let (p, q, r, s) = (a.tips[k], a.tips[next(k)], a.tips[prev(k)], b.tips[j]);
        // a = p q r, b = s r q; across q-s lies b's side opposite r, across s-r the one opposite q.
        let (pq, rp) = (a.across[prev(k)], a.across[next(k)]);
        let (qs, sr) = (b.across[next(j)], b.across[prev(j)]);
        self.triangles[t.index()] = Triangle {
            tips: [p, q, s],
            across: [qs, other.into(), pq],
            ..a
        };
        self.triangles[other.index()] = Triangle {
            tips: [p, s, r],
            across: [sr, rp, t.into()],
            ..b
        };
        self.redirect(qs, other, t, 0);
        self.redirect(rp, t, other, 1);
        self.redirect(pq, t, t, 2);
        self.redirect(sr, other, other, 0);
        other
    }

    /// After side k of `new` took over `what` from `old`.
    fn redirect(&mut self, what: Across, old: TriangleId, new: TriangleId, _k: usize) {
        if let Some(wave) = what.wave() {
            self.beside[wave.index()] = new;
        } else if let Some(t) = what.triangle()
            && old != new
        {
            let side = self.side_to(t, old.into());
            self.triangles[t.index()].across[side] = new.into();
        }
    }
}

/// The triangles around a vertex, mostly few, and its corner in each.
pub(super) type Spokes = SmallVec<[(TriangleId, usize); 12]>;

/// Iterator over the triangles around a vertex.
pub(super) struct Fan<'a> {
    triangulation: &'a Triangulation,
    at: Option<(TriangleId, usize)>,
}

impl Iterator for Fan<'_> {
    type Item = (TriangleId, usize);

    fn next(&mut self) -> Option<Self::Item> {
        let (t, corner) = self.at?;
        self.at = self.triangulation.step(t, corner);
        Some((t, corner))
    }
}
