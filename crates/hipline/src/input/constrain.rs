//! Brings edges into a triangulation.
//!
//! A missing edge crosses a row of triangles, its corridor. What is left and right of it
//! in there are two polygons all of whose sides can be seen from the edge; such a polygon
//! is triangulated by one scan that cuts off convex corners (Toussaint & Avis 1982), with
//! orientation tests only. Afterwards flips make the new triangles well shaped.

use super::delaunay::{INFINITE, NONE, Triangulation, next, prev};

/// What a straight walk between two vertices meets.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Step {
    /// It runs along this half-edge.
    Along(u32),
    /// It crosses this half-edge, which runs from the right of the walk to its left.
    Across(u32),
    /// It has arrived at this vertex (on its way, or its end).
    Vertex(u32),
}

/// Whether two vertices are neighbours, or else which one has fewer neighbours.
enum Neighbours {
    Yes(u32),
    /// No; begin at the first.
    First,
    /// No; begin at the second.
    Second,
}

impl Triangulation<'_> {
    /// The half-edge between two vertices, if there is one.
    pub(super) fn find(&self, from: u32, to: u32) -> Option<u32> {
        match self.neighbours(from, to) {
            Neighbours::Yes(h) => Some(h),
            _ => None,
        }
    }

    /// Turns around both vertices at once, so that the cost is that of the one with fewer
    /// neighbours: a hub of many edges is no obstacle.
    fn neighbours(&self, from: u32, to: u32) -> Neighbours {
        let [first, second] = [from, to].map(|vertex| self.spoke[vertex as usize]);
        let (mut h, mut g) = (first, second);
        loop {
            if self.to(h) == to {
                return Neighbours::Yes(h);
            }
            if self.to(g) == from {
                return Neighbours::Yes(self.twin(g));
            }
            h = self.twin(prev(h));
            g = self.twin(prev(g));
            if h == first {
                return Neighbours::First;
            }
            if g == second {
                return Neighbours::Second;
            }
        }
    }

    /// Walks from one vertex to another until `visit` says stop. Exact.
    pub(super) fn walk(&self, from: u32, to: u32, mut visit: impl FnMut(Step) -> bool) {
        let mut at = from;
        while at != to {
            let step = self.set_out(at, to);
            if !visit(step) {
                return;
            }
            at = match step {
                Step::Along(h) => self.to(h),
                Step::Vertex(vertex) => vertex,
                Step::Across(mut crossed) => loop {
                    let g = self.twin(crossed);
                    let apex = self.from(prev(g));
                    let side = self.side(from, to, apex);
                    if apex == to || side == 0.0 {
                        break apex;
                    }
                    crossed = if side > 0.0 { next(g) } else { prev(g) };
                    if !visit(Step::Across(crossed)) {
                        return;
                    }
                },
            };
            if !visit(Step::Vertex(at)) {
                return;
            }
        }
    }

    /// The first step from a vertex towards another one.
    fn set_out(&self, at: u32, to: u32) -> Step {
        let forward = |vertex| {
            let [a, b, v] = [at, to, vertex].map(|vertex| self.point(vertex));
            ((a.x, a.y) < (b.x, b.y)) == ((a.x, a.y) < (v.x, v.y))
        };
        let start = self.spoke[at as usize];
        let mut h = start;
        loop {
            let (right, left) = (self.to(h), self.from(prev(h)));
            if right != INFINITE {
                let side = self.side(at, right, to);
                if side == 0.0 && forward(right) {
                    return Step::Along(h);
                }
                if side > 0.0 && left != INFINITE && self.side(at, left, to) < 0.0 {
                    return Step::Across(next(h));
                }
            }
            h = self.twin(prev(h));
            assert_ne!(h, start, "there is a way from vertex {at} to vertex {to}");
        }
    }

    /// Makes the edge a part of the triangulation, and returns the vertices on it, both
    /// ends included. The pieces have no owner yet.
    ///
    /// None, and no change, if it crosses an edge that has an owner.
    pub(super) fn constrain(&mut self, from: u32, to: u32) -> Option<Vec<u32>> {
        let backward = match self.neighbours(from, to) {
            Neighbours::Yes(_) => return Some(vec![from, to]),
            Neighbours::First => false,
            Neighbours::Second => true,
        };
        let (start, end) = if backward { (to, from) } else { (from, to) };
        let mut passed = vec![start];
        let mut crossed = Vec::new();
        let mut corridors = Vec::new();
        let mut free = true;
        self.walk(start, end, |step| {
            match step {
                Step::Along(_) => {}
                Step::Across(h) => {
                    free = self.owner[h as usize] == NONE;
                    crossed.push(h);
                }
                Step::Vertex(vertex) => {
                    passed.push(vertex);
                    if !crossed.is_empty() {
                        corridors.push(std::mem::take(&mut crossed));
                    }
                }
            }
            free
        });
        if !free {
            return None;
        }
        let mut suspects = Vec::new();
        for corridor in corridors {
            self.clear(&corridor, &mut suspects);
        }
        // The new edges must not be flipped away again.
        for pair in passed.windows(2) {
            let h = self.find(pair[0], pair[1]).expect("a cleared corridor has an edge through it");
            if self.owner[h as usize] == NONE {
                self.own(h, PENDING);
            }
        }
        self.legalize(&mut suspects);
        for pair in passed.windows(2) {
            let h = self.find(pair[0], pair[1]).expect("edges with an owner stay");
            if self.owner[h as usize] == PENDING {
                self.own(h, NONE);
            }
        }
        if backward {
            passed.reverse();
        }
        Some(passed)
    }

    /// Sets the owner of both sides of an edge.
    pub(super) fn own(&mut self, h: u32, owner: u32) {
        let g = self.twin(h);
        self.owner[h as usize] = owner;
        self.owner[g as usize] = owner;
    }

    /// Retriangulates the triangles on both sides of the crossed half-edges so that there
    /// is an edge through the corridor; adds the new half-edges to the suspects.
    fn clear(&mut self, crossed: &[u32], suspects: &mut Vec<u32>) {
        let first = crossed[0];
        let mut corridor = Corridor { border: Vec::new(), slots: vec![first / 3], scan: Vec::new() };
        let mut right = vec![corridor.side(self, prev(first))];
        let mut left = vec![corridor.side(self, next(first))];
        for (k, &h) in crossed.iter().enumerate() {
            let g = self.twin(h);
            corridor.slots.push(g / 3);
            let onward = crossed.get(k + 1);
            if onward != Some(&next(g)) {
                right.push(corridor.side(self, next(g)));
            }
            if onward != Some(&prev(g)) {
                left.push(corridor.side(self, prev(g)));
            }
        }
        left.reverse();
        corridor.slots.sort_unstable();
        let doomed = corridor.slots.clone();
        let base = corridor.fill(self, &right);
        let other = corridor.fill(self, &left);
        self.link(base, other);
        for h in [base, other] {
            self.owner[h as usize] = NONE;
        }
        corridor.attach(self, &doomed);
        for slot in doomed {
            for h in 3 * slot..3 * slot + 3 {
                let from = self.from(h);
                self.spoke[from as usize] = h;
                suspects.push(h);
            }
        }
    }
}

/// Owner of an edge that must not be flipped and has no owner yet.
const PENDING: u32 = NONE - 1;

/// A side of the corridor: the half-edge it was, its twin, its owner, what it becomes.
struct Side {
    old: u32,
    twin: u32,
    owner: u32,
    new: u32,
}

/// What lies on the other side of an edge of the polygon that is being filled.
#[derive(Clone, Copy)]
enum Beyond {
    /// The surroundings: a side of the corridor, by number.
    Border(usize),
    /// A half-edge of a new triangle.
    Inner(u32),
}

/// An edge of the polygon that is being filled, by where it starts.
#[derive(Clone, Copy)]
struct Rim {
    from: u32,
    to: u32,
    beyond: Beyond,
}

struct Corridor {
    border: Vec<Side>,
    /// Triangles that may be overwritten.
    slots: Vec<u32>,
    scan: Vec<Rim>,
}

impl Corridor {
    fn side(&mut self, mesh: &Triangulation<'_>, old: u32) -> Rim {
        self.border.push(Side { old, twin: mesh.twin(old), owner: mesh.owner[old as usize], new: NONE });
        Rim { from: mesh.from(old), to: mesh.to(old), beyond: Beyond::Border(self.border.len() - 1) }
    }

    /// Triangulates the polygon on the left of a chain of edges, which is closed by an edge
    /// from its end to its start; returns the half-edge of that one, yet without a twin.
    fn fill(&mut self, mesh: &mut Triangulation<'_>, chain: &[Rim]) -> u32 {
        self.scan.clear();
        for &rim in chain {
            let mut rim = rim;
            while let Some(&before) = self.scan.last() {
                let convex = before.from != rim.to && mesh.side(before.from, rim.from, rim.to) > 0.0;
                if !convex {
                    break;
                }
                self.scan.pop();
                let h = 3 * self.slots.pop().expect("a corridor is filled with as many triangles as it had");
                mesh.origin[h as usize..][..3].copy_from_slice(&[before.from, rim.from, rim.to]);
                self.set(mesh, h, before.beyond);
                self.set(mesh, h + 1, rim.beyond);
                rim = Rim { from: before.from, to: rim.to, beyond: Beyond::Inner(h + 2) };
            }
            self.scan.push(rim);
        }
        match self.scan[..] {
            [Rim { beyond: Beyond::Inner(base), .. }] => base,
            _ => panic!("a polygon that can be seen from one edge is filled by one scan"),
        }
    }

    fn set(&mut self, mesh: &mut Triangulation<'_>, h: u32, beyond: Beyond) {
        match beyond {
            Beyond::Border(side) => self.border[side].new = h,
            Beyond::Inner(g) => {
                mesh.link(h, g);
                mesh.own(h, NONE);
            }
        }
    }

    /// Links the sides to the surroundings; or to each other, where an edge that is not
    /// crossed has the corridor on both sides.
    fn attach(&self, mesh: &mut Triangulation<'_>, doomed: &[u32]) {
        let mut by_old = Vec::new();
        for side in &self.border {
            let twin = if doomed.binary_search(&(side.twin / 3)).is_err() {
                side.twin
            } else {
                if by_old.is_empty() {
                    by_old = self.border.iter().map(|side| (side.old, side.new)).collect();
                    by_old.sort_unstable();
                }
                let found = by_old.binary_search_by_key(&side.twin, |&(old, _)| old);
                by_old[found.expect("the other side is a side of the corridor, too")].1
            };
            mesh.link(side.new, twin);
            mesh.own(side.new, side.owner);
        }
    }
}
