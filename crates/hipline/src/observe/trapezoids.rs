//! Trapezoids between the segments of a plan, and a graph that leads to the one around a point.
//!
//! The randomised incremental map of Seidel (1991) and Mulmuley (1990), as told by de Berg and
//! others (Computational Geometry, chapter 6): n segments make at most 3 n + 1 trapezoids, in
//! O(n log n) expected time, and a point is found in O(log n). The expectation is over the order
//! in which segments come, which is shuffled from a fixed seed. Positions are numbered by x, then
//! y, so that points above each other are no special case.
//!
//! Invariant: this module reads no coordinate; it asks the plan for sides.

use super::plan::{Ground, Plan, Query};
use hipline_num::Sign;

const NONE: u32 = u32::MAX;

/// A trapezoid: between two segments, and between the verticals through two positions.
#[derive(Debug, Clone, Copy)]
pub(super) struct Trapezoid {
    /// The segments above and below; `NONE` without a limit.
    pub sides: [u32; 2],
    /// The positions at its left and right end; `NONE` without a limit.
    pub ends: [u32; 2],
    /// The neighbours beyond the ends, `[left, right]`, that share the segment above and the
    /// one below.
    next: [[u32; 2]; 2],
    leaf: u32,
}

/// A node of the graph.
#[derive(Debug, Clone, Copy)]
enum Step {
    /// Is the point before a position?
    Position {
        position: u32,
        next: [u32; 2],
    },
    /// Is the point above a segment?
    Segment {
        segment: u32,
        next: [u32; 2],
    },
    Trapezoid(u32),
}

/// The trapezoids of a plan.
#[derive(Debug)]
pub(super) struct Trapezoids {
    steps: Vec<Step>,
    pub list: Vec<Trapezoid>,
}

const ABOVE: usize = 0;
const BELOW: usize = 1;
const LEFT: usize = 0;
const RIGHT: usize = 1;

/// A fixed order that looks random (splitmix64).
fn shuffled(count: usize) -> Vec<u32> {
    let mut order: Vec<u32> = (0..count as u32).collect();
    let mut state = 0x9e37_79b9_7f4a_7c15_u64;
    for i in (1..count).rev() {
        state = state.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = state;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^= z >> 31;
        order.swap(i, (z % (i as u64 + 1)) as usize);
    }
    order
}

impl Trapezoids {
    pub(super) fn new(plan: &Plan) -> Self {
        let mut this = Self {
            steps: vec![Step::Trapezoid(0)],
            list: vec![Trapezoid {
                sides: [NONE; 2],
                ends: [NONE; 2],
                next: [[NONE; 2]; 2],
                leaf: 0,
            }],
        };
        for segment in shuffled(plan.segments.len()) {
            this.insert(plan, segment);
        }
        this
    }

    /// The trapezoid around a point that is moved a little to the east, and still less to the
    /// north.
    pub(super) fn find(&self, plan: &Plan, query: &Query) -> usize {
        let mut at = 0;
        loop {
            at = match self.steps[at as usize] {
                Step::Trapezoid(found) => return found as usize,
                Step::Position { position, next } => {
                    next[usize::from(plan.compare_query(query, position).is_ge())]
                }
                Step::Segment { segment, next } => {
                    let segment = &plan.segments[segment as usize];
                    let is_below = match plan.side(segment, query) {
                        Sign::Zero => !plan.falls(segment),
                        side => side.is_negative(),
                    };
                    next[usize::from(is_below)]
                }
            };
        }
    }

    /// What the trapezoid belongs to.
    pub(super) fn ground(&self, plan: &Plan, trapezoid: usize) -> Ground {
        let [above, below] = self.list[trapezoid].sides;
        if above != NONE {
            plan.segments[above as usize].below
        } else if below != NONE {
            plan.segments[below as usize].above
        } else {
            plan.background
        }
    }

    /// Whether a segment is above another that starts at the same position or leads over it.
    fn is_above(plan: &Plan, segment: u32, other: u32) -> bool {
        let [from, to] = plan.segments[segment as usize].ends;
        let other = &plan.segments[other as usize];
        match plan.side_of(other, from) {
            Sign::Zero => plan.side_of(other, to).is_positive(),
            side => side.is_positive(),
        }
    }

    /// The trapezoid in which a segment starts.
    fn start(&self, plan: &Plan, segment: u32) -> u32 {
        let [from, _] = plan.segments[segment as usize].ends;
        let mut at = 0;
        loop {
            at = match self.steps[at as usize] {
                Step::Trapezoid(found) => return found,
                Step::Position { position, next } => next[usize::from(from >= position)],
                Step::Segment {
                    segment: other,
                    next,
                } => next[usize::from(!Self::is_above(plan, segment, other))],
            };
        }
    }

    /// The trapezoids that a segment goes through, from left to right, and for each but the last
    /// whether its right end is above the segment.
    fn path(&self, plan: &Plan, segment: u32) -> Vec<(u32, bool)> {
        let line = &plan.segments[segment as usize];
        let [_, to] = line.ends;
        let mut at = self.start(plan, segment);
        let mut path = Vec::new();
        loop {
            let trapezoid = &self.list[at as usize];
            let end = trapezoid.ends[RIGHT];
            if end >= to {
                path.push((at, false));
                return path;
            }
            let end_is_above = plan.side_of(line, end).is_positive();
            path.push((at, end_is_above));
            at = trapezoid.next[RIGHT][usize::from(end_is_above)];
        }
    }

    fn create(&mut self, sides: [u32; 2], ends: [u32; 2]) -> u32 {
        let id = self.list.len() as u32;
        self.steps.push(Step::Trapezoid(id));
        self.list.push(Trapezoid {
            sides,
            ends,
            next: [[NONE; 2]; 2],
            leaf: self.steps.len() as u32 - 1,
        });
        id
    }

    /// Makes two trapezoids neighbours, the first on the left, along the segment above or below.
    fn join(&mut self, left: u32, right: u32, side: usize) {
        if left != NONE {
            self.list[left as usize].next[RIGHT][side] = right;
        }
        if right != NONE {
            self.list[right as usize].next[LEFT][side] = left;
        }
    }

    /// Puts a segment in. Each trapezoid on its way is cut into one above and one below; those
    /// with the same segments on both sides grow together where the wall between them is cut short.
    fn insert(&mut self, plan: &Plan, segment: u32) {
        let path = self.path(plan, segment);
        let [from, to] = plan.segments[segment as usize].ends;
        let old: Vec<Trapezoid> = path.iter().map(|&(at, _)| self.list[at as usize]).collect();
        let (first, last) = (old[0], old[old.len() - 1]);
        // What is left of the first and of the last one.
        let start =
            (first.ends[LEFT] != from).then(|| self.create(first.sides, [first.ends[LEFT], from]));
        let end = (last.ends[RIGHT] != to).then(|| self.create(last.sides, [to, last.ends[RIGHT]]));
        let mut now = [
            self.create([first.sides[ABOVE], segment], [from, NONE]),
            self.create([segment, first.sides[BELOW]], [from, NONE]),
        ];
        for side in [ABOVE, BELOW] {
            match start {
                Some(start) => {
                    self.join(first.next[LEFT][side], start, side);
                    self.join(start, now[side], side);
                }
                None => self.join(first.next[LEFT][side], now[side], side),
            }
        }
        for (i, trapezoid) in old.iter().enumerate() {
            let mut at = self.split(segment, now);
            if i + 1 == old.len()
                && let Some(end) = end
            {
                at = self.ask(to, [at, self.list[end as usize].leaf]);
            }
            if i == 0
                && let Some(start) = start
            {
                at = self.ask(from, [self.list[start as usize].leaf, at]);
            }
            // The old leaf becomes what has just been made.
            self.steps[trapezoid.leaf as usize] = self.steps[at as usize];
            let Some(next) = old.get(i + 1) else { break };
            // The wall at the right end stays on one side of the segment only.
            let side = usize::from(!path[i].1);
            let (done, wall) = (now[side], trapezoid.ends[RIGHT]);
            self.list[done as usize].ends[RIGHT] = wall;
            let sides = if side == ABOVE {
                [next.sides[ABOVE], segment]
            } else {
                [segment, next.sides[BELOW]]
            };
            now[side] = self.create(sides, [wall, NONE]);
            self.join(done, trapezoid.next[RIGHT][side], side);
            self.join(next.next[LEFT][side], now[side], side);
            self.join(done, now[side], 1 - side);
        }
        for side in [ABOVE, BELOW] {
            self.list[now[side] as usize].ends[RIGHT] = to;
            match end {
                Some(end) => {
                    self.join(end, last.next[RIGHT][side], side);
                    self.join(now[side], end, side);
                }
                None => self.join(now[side], last.next[RIGHT][side], side),
            }
        }
    }

    fn split(&mut self, segment: u32, halves: [u32; 2]) -> u32 {
        let next = halves.map(|t| self.list[t as usize].leaf);
        self.steps.push(Step::Segment { segment, next });
        self.steps.len() as u32 - 1
    }

    fn ask(&mut self, position: u32, next: [u32; 2]) -> u32 {
        self.steps.push(Step::Position { position, next });
        self.steps.len() as u32 - 1
    }
}
