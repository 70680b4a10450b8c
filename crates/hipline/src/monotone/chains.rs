//! The wavefronts of chains: what they consist of, and how they propagate (section 2).
//!
//! A chain is a list of wavefront edges, with the unswept side on the left. Its first and its last
//! one are rays. Each keeps its direction, so the wavefront stays monotone as long as no edge
//! shrinks to nothing, and every change is witnessed by such a collapse (Lemma 1), with weights
//! too. One queue serves several chains at once; they do not see each other.
//!
//! All collapses of one moment are resolved together: each run of wavefront edges of length zero
//! becomes one vertex. That is how vertex events, where reflex vertices meet and a new one is
//! born, need no case of their own.

use std::cmp::Ordering;

use crate::{
    predicates::{Bounds, Moment, Place, PlaneId, Planes},
    topology::{TraceId, WaveId},
    wavefront::{End, EventNode, Queue, Trace, Walk, Wave, Wavefront},
};
use hipline_num::Sign;

/// No wavefront edge, trace, node or join.
pub(super) const NONE: u32 = u32::MAX;

/// Which of the two chains of a polygon.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Side {
    /// The one that goes from west to east.
    Lower,
    /// The one that goes from east to west.
    Upper,
}

/// A wavefront edge of a chain.
#[derive(Clone, Copy, Debug)]
pub(super) struct Front {
    pub plane: PlaneId,
    pub side: Side,
    /// The wavefront edges before and after it.
    pub prev: u32,
    pub next: u32,
    /// The vertices where it starts and ends; none at the far end of a ray.
    pub start: u32,
    pub end: u32,
    /// The same at time zero.
    pub first_start: u32,
    pub first_end: u32,
    /// The node where it vanished.
    pub death: u32,
    /// The join in which it, the western one, became part of another.
    pub joined: u32,
    /// The last join in which it, the eastern one, took another over.
    pub last_join: u32,
    /// The first and the last base on its plane at time zero.
    pub bases: [u32; 2],
    /// Of a ray: the first and the last walk of the boundary of its face.
    pub head: Walk,
    pub tail: Walk,
}

/// What comes before and after a trace along the boundaries of its two faces, in time.
#[derive(Clone, Copy, Debug)]
pub(super) struct Links {
    pub next_in: u32,
    pub prev_in: u32,
    pub next_out: u32,
    pub prev_out: u32,
}

const UNLINKED: Links = Links {
    next_in: NONE,
    prev_in: NONE,
    next_out: NONE,
    prev_out: NONE,
};

/// Two wavefront edges on one plane became one, which is the eastern one.
#[derive(Clone, Copy, Debug)]
pub(super) struct Join {
    pub ghost: u32,
    pub west: u32,
    pub east: u32,
    /// The eastern boundary of the eastern one at that moment, and the western boundary of the western one.
    pub boundary: u32,
    pub western: u32,
    /// The join of the eastern one before this one.
    pub before: u32,
}

/// A chain as it starts: a plane with a face of the same number for each edge, in order, and the
/// vertices between them.
pub(super) struct Start {
    pub side: Side,
    pub planes: Vec<PlaneId>,
    pub vertices: Vec<u32>,
    /// The vertices where its rays are cut off, if they are.
    pub ends: [Option<u32>; 2],
}

/// Why a wavefront has no skeleton that could be written down, or cut: the faces concerned.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Trouble(pub PlaneId);

/// The state of the propagation.
pub(super) struct Chains<'a> {
    pub planes: &'a Planes,
    /// The vertices of the figure.
    pub vertices: &'a [[f64; 2]],
    pub front: Wavefront,
    pub waves: Vec<Front>,
    pub links: Vec<Links>,
    pub joins: Vec<Join>,
    /// For each event node, bounds of its moment.
    pub bounds: Vec<Bounds>,
    /// For each wavefront edge, the planes that meet when it collapses.
    collapse: Vec<[PlaneId; 3]>,
    queue: Queue<WaveId>,
    /// Whether there are ghosts.
    pub ghosts: bool,
    pub(super) now: Moment,
    pub(super) now_bounds: Bounds,
    /// The first node of this moment.
    first_node: u32,
    pub(super) straight: Vec<TraceId>,
    facing: Vec<TraceId>,
    fresh: Vec<TraceId>,
    /// By wavefront edge: whether it has length zero now.
    zero: Vec<bool>,
    pub events: u64,
    /// Steps of the merge.
    pub steps: u64,
}

/// The order in which wavefront edges collapse, given the planes that meet when each does.
fn exact_order(planes: &Planes, collapse: &[[PlaneId; 3]]) -> impl Fn(WaveId, WaveId) -> Ordering {
    move |v, w| {
        let [v, w] = [v, w].map(|w| Moment::Planes(collapse[w.index()]));
        planes.compare(&v, &w)
    }
}

impl<'a> Chains<'a> {
    /// The wavefronts at time zero, before anything happens.
    pub(super) fn new(
        planes: &'a Planes,
        vertices: &'a [[f64; 2]],
        faces: usize,
        starts: &[Start],
    ) -> Result<Self, Trouble> {
        let count: usize = starts.iter().map(|start| start.planes.len()).sum();
        let mut chains = Self {
            planes,
            vertices,
            front: Wavefront::new(vertices.len(), faces),
            waves: Vec::with_capacity(count),
            links: Vec::with_capacity(3 * count),
            joins: Vec::new(),
            bounds: Vec::with_capacity(count),
            collapse: vec![[PlaneId(0); 3]; count],
            queue: Queue::default(),
            ghosts: false,
            now: Moment::Start,
            now_bounds: Bounds::START,
            first_node: 0,
            straight: Vec::new(),
            facing: Vec::new(),
            fresh: Vec::new(),
            zero: vec![false; count],
            events: 0,
            steps: 0,
        };
        chains.queue.reset(count);
        chains.front.traces.reserve(3 * count);
        for start in starts {
            chains.add(start)?;
        }
        Ok(chains)
    }

    fn add(&mut self, start: &Start) -> Result<(), Trouble> {
        let first = self.waves.len() as u32;
        let count = start.planes.len() as u32;
        for (i, &plane) in start.planes.iter().enumerate() {
            let i = i as u32;
            self.waves.push(Front {
                plane,
                side: start.side,
                prev: if i > 0 { first + i - 1 } else { NONE },
                next: if i + 1 < count { first + i + 1 } else { NONE },
                start: NONE,
                end: NONE,
                first_start: NONE,
                first_end: NONE,
                death: NONE,
                joined: NONE,
                last_join: NONE,
                bases: [plane.0; 2],
                head: Walk::Base(plane.0),
                tail: Walk::Base(plane.0),
            });
            self.front.waves.push(Wave {
                plane,
                face: plane.0,
            });
        }
        for (i, &vertex) in start.vertices.iter().enumerate() {
            let (inn, out) = (first + i as u32, first + i as u32 + 1);
            let x = self.spawn(inn, out, vertex, None);
            self.waves[inn as usize].first_end = x.index() as u32;
            self.waves[out as usize].first_start = x.index() as u32;
            let [a, b] = [inn, out].map(|w| self.waves[w as usize].plane.0);
            self.front.after_base[a as usize] = Walk::Up(x);
            self.front.trace_mut(x).after_down = Walk::Base(b);
        }
        self.start_straight(start.ends)?;
        self.fresh.clear();
        Ok(())
    }

    /// A new vertex at a node between two wavefront edges; where they are parallel it stands on
    /// the pair of another one at its place.
    pub(super) fn spawn(
        &mut self,
        inn: u32,
        out: u32,
        born: u32,
        here: Option<TraceId>,
    ) -> TraceId {
        let (i, j) = (
            self.waves[inn as usize].plane,
            self.waves[out as usize].plane,
        );
        let turn = self.planes.turn(i, j);
        let pair = match (turn, here) {
            (Sign::Negative, _) => [j, i],
            (Sign::Zero, Some(here)) => self.front.trace(here).pair,
            _ => [i, j],
        };
        let x = self.front.push_trace(Trace {
            pair,
            inn: WaveId::new(inn as usize),
            out: WaveId::new(out as usize),
            born,
            end: End::Moving,
            turn,
            after_up: Walk::Open,
            after_down: Walk::Open,
        });
        self.links.push(UNLINKED);
        self.waves[inn as usize].end = x.index() as u32;
        self.waves[out as usize].start = x.index() as u32;
        self.waves[inn as usize].next = out;
        self.waves[out as usize].prev = inn;
        if turn.is_zero() {
            if self.planes.same_direction(i, j) {
                self.straight.push(x);
            } else {
                self.facing.push(x);
            }
        }
        self.fresh.push(x);
        x
    }

    pub(super) fn trace(&self, x: u32) -> &Trace {
        self.front.trace(TraceId::raw(x))
    }

    /// The end of `inn`'s boundary goes on from `old` to `new`.
    pub(super) fn end_goes_on(&mut self, old: TraceId, new: TraceId) {
        self.front.end_moves(old, new);
        self.links[old.index()].next_in = new.index() as u32;
        self.links[new.index()].prev_in = old.index() as u32;
    }

    /// The start of `out`'s boundary goes on from `old` to `new`.
    pub(super) fn start_goes_on(&mut self, old: TraceId, new: TraceId) {
        self.front.start_moves(old, new);
        self.links[old.index()].next_out = new.index() as u32;
        self.links[new.index()].prev_out = old.index() as u32;
    }

    /// The moment of a node.
    pub(super) fn moment(&self, node: u32) -> Moment {
        match node.checked_sub(self.front.vertices) {
            None => Moment::Start,
            Some(event) => Moment::Planes(self.front.events[event as usize].moment),
        }
    }

    pub(super) fn bounds_of(&self, node: u32) -> Bounds {
        match node.checked_sub(self.front.vertices) {
            None => Bounds::START,
            Some(event) => self.bounds[event as usize],
        }
    }

    pub(super) fn new_node(&mut self, node: EventNode, bounds: Bounds) -> u32 {
        self.bounds.push(bounds);
        self.front.push_node(node)
    }

    /// The node at the place of a vertex now.
    pub(super) fn node_now(&mut self, x: TraceId) -> u32 {
        let Trace { born, pair, .. } = *self.front.trace(x);
        if born >= self.first_node {
            return self.front.node(born);
        }
        let Moment::Planes(moment) = self.now else {
            unreachable!("nodes of time zero are vertices")
        };
        self.new_node(EventNode { pair, moment }, self.now_bounds)
    }

    /// The place of a node.
    pub(super) fn place_of(&self, node: u32) -> Place {
        match node.checked_sub(self.front.vertices) {
            Some(event) => {
                let EventNode { pair, moment } = self.front.events[event as usize];
                Place::Event { pair, moment }
            }
            None => Place::Vertex(self.vertices[node as usize]),
        }
    }

    /// The place of a vertex now.
    fn place_now(&self, x: TraceId) -> Place {
        let Trace { born, pair, .. } = *self.front.trace(x);
        match self.now {
            Moment::Planes(moment) if born < self.first_node => Place::Event { pair, moment },
            _ => self.place_of(born),
        }
    }

    /// Finds when a wavefront edge collapses next.
    fn next_collapse(&mut self, w: u32) -> Option<Bounds> {
        let wave = &self.waves[w as usize];
        if wave.death != NONE || wave.joined != NONE || wave.start == NONE || wave.end == NONE {
            return None;
        }
        let [before, after] =
            [wave.prev, wave.next].map(|neighbour| self.waves[neighbour as usize].plane);
        let turns = self.trace(wave.start).turn * self.trace(wave.end).turn;
        let bounds = self.planes.meeting_if([before, wave.plane, after], turns)?;
        let mut triple = [before, wave.plane, after];
        triple.sort_unstable();
        self.collapse[w as usize] = triple;
        Some(bounds)
    }

    /// Lets the wavefronts move until nothing happens any more.
    pub(super) fn propagate(&mut self) -> Result<(), Trouble> {
        let mut first: Vec<(WaveId, Bounds)> = Vec::with_capacity(self.waves.len());
        for w in 0..self.waves.len() as u32 {
            if let Some(bounds) = self.next_collapse(w) {
                first.push((WaveId::raw(w), bounds));
            }
        }
        self.queue.fill(first.into_iter());
        let mut batch = Vec::new();
        while let Some(first) = self.first() {
            self.take_batch(first, &mut batch);
            for &w in &batch {
                self.zero[w as usize] = true;
            }
            for &w in &batch {
                if self.zero[w as usize] {
                    self.contract(w);
                }
            }
            while let Some(x) = self.facing.pop() {
                self.zip(x)?;
            }
            self.remove_straight()?;
            self.end_batch();
        }
        Ok(())
    }

    /// Takes all that collapses at the next moment from the queue.
    fn take_batch(&mut self, first: WaveId, batch: &mut Vec<u32>) {
        let bounds = self.queue.bounds(first).expect("it is queued");
        self.now = Moment::Planes(self.collapse[first.index()]);
        self.now_bounds = bounds;
        self.first_node = self.front.vertices + self.front.events.len() as u32;
        batch.clear();
        while let Some(w) = self.first() {
            let other = self.queue.bounds(w).expect("it is queued");
            let at = Moment::Planes(self.collapse[w.index()]);
            let order = bounds
                .compare(other)
                .unwrap_or_else(|| self.planes.compare(&self.now, &at));
            if order != Ordering::Equal {
                break;
            }
            self.dequeue(w.index() as u32);
            batch.push(w.index() as u32);
        }
        // Whatever the order in which the queue gave them.
        batch.sort_unstable();
    }

    /// What collapses next.
    fn first(&mut self) -> Option<WaveId> {
        self.queue.peek(&exact_order(self.planes, &self.collapse))
    }

    /// A run of wavefront edges of length zero becomes one vertex.
    fn contract(&mut self, w: u32) {
        let (mut first, mut last) = (w, w);
        while self.zero[self.waves[first as usize].prev as usize] {
            first = self.waves[first as usize].prev;
        }
        while self.zero[self.waves[last as usize].next as usize] {
            last = self.waves[last as usize].next;
        }
        let before = self.waves[first as usize].prev;
        let after = self.waves[last as usize].next;
        let (begin, finish) = (
            TraceId::raw(self.waves[first as usize].start),
            TraceId::raw(self.waves[last as usize].end),
        );
        let node = self.node_now(begin);
        self.front.trace_mut(begin).end = End::At(node);
        let mut at = first;
        loop {
            self.events += 1;
            let Front {
                start, end, next, ..
            } = self.waves[at as usize];
            let (start, end) = (TraceId::raw(start), TraceId::raw(end));
            self.front.trace_mut(end).end = End::At(node);
            self.front.vanishes(start, end);
            self.waves[at as usize].death = node;
            self.zero[at as usize] = false;
            if at == last {
                break;
            }
            at = next;
        }
        let x = self.spawn(before, after, node, Some(begin));
        self.end_goes_on(begin, x);
        self.start_goes_on(finish, x);
    }

    /// Two wavefront edges face each other on one line: they vanish together, as far as the
    /// shorter one reaches, and leave a ridge of one height.
    fn zip(&mut self, x: TraceId) -> Result<(), Trouble> {
        let Trace { inn, out, .. } = *self.front.trace(x);
        let (a, c) = (inn.index(), out.index());
        let (start, end) = (self.waves[a].start, self.waves[c].end);
        let nearer = match (start, end) {
            (NONE, NONE) => return Err(Trouble(self.waves[a].plane)),
            (NONE, _) => Ordering::Less,
            (_, NONE) => Ordering::Greater,
            _ => {
                let [p, q] = [start, end].map(|t| self.place_now(TraceId::raw(t)));
                self.planes.compare_along(&p, &q, self.waves[a].plane)
            }
        };
        let (start, end) = (TraceId::raw(start), TraceId::raw(end));
        let node = match nearer {
            Ordering::Less => self.node_now(end),
            Ordering::Greater => self.node_now(start),
            Ordering::Equal => {
                let (m, n) = (self.node_now(start), self.node_now(end));
                self.front.same_node(m, n)
            }
        };
        self.front.trace_mut(x).end = End::At(node);
        let (mut old_end, mut before) = (x, a as u32);
        if nearer.is_ge() {
            self.front.trace_mut(start).end = End::At(node);
            self.front.vanishes(start, x);
            self.waves[a].death = node;
            (old_end, before) = (start, self.waves[a].prev);
            self.dequeue(a as u32);
        }
        let (mut old_start, mut after) = (x, c as u32);
        if nearer.is_le() {
            self.front.trace_mut(end).end = End::At(node);
            self.front.vanishes(x, end);
            self.waves[c].death = node;
            (old_start, after) = (end, self.waves[c].next);
            self.dequeue(c as u32);
        }
        let y = self.spawn(before, after, node, Some(x));
        self.end_goes_on(old_end, y);
        self.start_goes_on(old_start, y);
        Ok(())
    }

    /// The wavefront edges beside a vertex are to be scheduled anew.
    pub(super) fn fresh_again(&mut self, x: TraceId) {
        self.fresh.push(x);
    }

    /// Takes a wavefront edge that is gone from the queue.
    pub(super) fn dequeue(&mut self, w: u32) {
        self.set_queued(w, None);
    }

    fn set_queued(&mut self, w: u32, bounds: Option<Bounds>) {
        let exact = exact_order(self.planes, &self.collapse);
        self.queue.set(WaveId::raw(w), bounds, &exact);
    }

    /// Finds the next collapse of all wavefront edges with a new vertex.
    fn end_batch(&mut self) {
        let mut fresh = std::mem::take(&mut self.fresh);
        for x in fresh.drain(..) {
            if self.front.trace(x).end == End::Moving {
                for w in self.beside(x) {
                    let bounds = self.next_collapse(w);
                    self.set_queued(w, bounds);
                }
            }
        }
        self.fresh = fresh;
    }
}
