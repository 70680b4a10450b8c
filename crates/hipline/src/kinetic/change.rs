//! Moments at which speeds change.
//!
//! First everything that collapses at that moment is resolved, on the planes on which the
//! wavefront arrived. Then each wavefront edge whose speed changes gives way to one on the
//! next plane of its course: the place is the same, so nothing of the triangulation
//! changes, but the vertices at its ends are new, and the old face ends where a new one starts,
//! at an arc of one height, a crease. Each piece of the wavefront starts a face of its own.
//!
//! A terminal whose edge stands still on both sides emits no wavefront edge, which would
//! have no length; its vertex is opened when the edge starts to move.

use std::{
    cmp::Ordering,
    collections::{BTreeMap, btree_map::Entry},
};

use super::Kinetic;
use crate::{
    predicates::{Bounds, Eave, Moment, PlaneId},
    topology::{TraceId, TriangleId, WaveId},
    wavefront::{End, FaceStart, Trace, Walk, Wave},
};
use hipline_num::Sign;

/// What is known about changes to come.
#[derive(Debug, Default)]
pub(super) struct Changes {
    /// How many of the times of changes have passed.
    passed: usize,
    /// The moment of the next one.
    next: Option<(Moment, Bounds)>,
    /// The wavefront edges on planes that will give way to others.
    pub(super) waves: BTreeMap<PlaneId, Vec<WaveId>>,
    /// The vertices at terminals that stand still.
    pub(super) closed: BTreeMap<usize, TraceId>,
    /// Terminals that start at this moment, with their planes.
    opening: Vec<(TraceId, usize, PlaneId)>,
    /// The eaves whose facets start next at this moment, by their walls.
    pub(super) births: BTreeMap<PlaneId, Eave>,
    /// Vertices at which one of them comes between its wall and a wavefront edge on the wall's line, if it starts.
    pub(super) below: Vec<TraceId>,
}

impl Kinetic<'_> {
    /// A wavefront edge is there; remembers it if its speed will change.
    pub(super) fn register(&mut self, wave: WaveId) {
        let plane = self.front.wave(wave).plane;
        let phases = &self.planes.phases;
        if !phases.is_empty() && phases.will_change(plane) {
            self.changes.waves.entry(plane).or_default().push(wave);
        }
    }

    /// Finds the moment of the next change.
    pub(super) fn find_next_change(&mut self) {
        let levels = self.planes.phases.levels();
        self.changes.next = levels.get(self.changes.passed).map(|&(_, level)| {
            let triple = self
                .planes
                .moment_of_level(level)
                .expect("not all edges and terminals are parallel");
            let moment = Moment::of_planes(triple);
            (moment, self.planes.bounds(&moment))
        });
    }

    /// The moment of the next change, if no triangle collapses before.
    pub(super) fn change_before(
        &self,
        first: Option<(TriangleId, Bounds)>,
    ) -> Option<(Moment, Bounds)> {
        let (moment, bounds) = self.changes.next?;
        let Some((t, collapse)) = first else {
            return Some((moment, bounds));
        };
        let order = bounds
            .compare(collapse)
            .unwrap_or_else(|| self.planes.compare(&moment, &self.agenda.moment(t)));
        (order != Ordering::Greater).then_some((moment, bounds))
    }

    /// Lets the wavefront edges whose speed changes now go on with their new speeds.
    pub(super) fn change_speeds(&mut self) {
        let level = self.changes.passed;
        self.changes.passed += 1;
        let mut old = Vec::new();
        for &(plane, after) in self.planes.phases.steps(level) {
            let waves = self.changes.waves.remove(&plane).unwrap_or_default();
            let here = waves.into_iter().filter(|&w| self.triangulation.has(w));
            old.extend(here.map(|wave| (wave, after)));
        }
        // The vertices at their ends, and the nodes where these are now.
        let mut nodes = BTreeMap::new();
        for &(wave, _) in &old {
            for x in self.triangulation.ends(wave) {
                if let Entry::Vacant(entry) = nodes.entry(x) {
                    entry.insert(self.node_now(x));
                }
            }
        }
        let renewed: BTreeMap<WaveId, (WaveId, TraceId)> = old
            .into_iter()
            .map(|(wave, plane)| (wave, self.renew(wave, plane, &nodes)))
            .collect();
        let mut successor = BTreeMap::new();
        self.await_facets(level);
        for (x, node) in nodes {
            successor.insert(x, self.carry_on(x, node, &renewed));
        }
        self.settle_before_facets(&mut successor);
        self.open_terminals(level, &successor);
        self.start_facets(Some(level));
        self.find_next_change();
    }

    /// A wavefront edge gives way to one on another plane. Returns that one, and the crease
    /// between their faces.
    fn renew(
        &mut self,
        wave: WaveId,
        plane: PlaneId,
        nodes: &BTreeMap<TraceId, u32>,
    ) -> (WaveId, TraceId) {
        let (t, k) = self.triangulation.beside(wave);
        let [start, end] = self.triangulation.ends(wave);
        let new = self.triangulation.push_wave(t);
        self.triangulation.attach(t, k, new.into());
        // The old face lies to the left of the way from the end back to the start.
        let crease = self.front.push_trace(Trace {
            pair: self.front.trace(end).pair,
            inn: wave,
            out: new,
            born: nodes[&end],
            end: End::At(nodes[&start]),
            turn: Sign::Zero,
            after_up: Walk::Down(start),
            after_down: Walk::Open,
        });
        let face = self.front.push_face(FaceStart {
            walk: Walk::Down(crease),
            plane,
            before: Some(self.front.wave(wave).plane),
        });
        self.front.waves.push(Wave { plane, face });
        self.register(new);
        (new, crease)
    }

    /// A vertex at the end of a renewed wavefront edge, or of two, gives way to a new one.
    fn carry_on(
        &mut self,
        x: TraceId,
        node: u32,
        renewed: &BTreeMap<WaveId, (WaveId, TraceId)>,
    ) -> TraceId {
        let Trace { inn, out, .. } = *self.front.trace(x);
        let (before, after) = (renewed.get(&inn), renewed.get(&out));
        let new_inn = before.map_or(inn, |r| r.0);
        let new_out = after.map_or(out, |r| r.0);
        let new = self.replace(x, new_inn, new_out, node);
        match before {
            Some(&(_, crease)) => {
                self.front.end_moves(x, crease);
                self.front.trace_mut(crease).after_down = Walk::Up(new);
            }
            None => self.front.end_moves(x, new),
        }
        match after {
            Some(&(_, crease)) => self.front.trace_mut(new).after_down = Walk::Down(crease),
            None => self.front.start_moves(x, new),
        }
        new
    }

    /// Opens the terminals whose edges start to move.
    fn open_terminals(&mut self, level: usize, successor: &BTreeMap<TraceId, TraceId>) {
        let starting: Vec<(usize, PlaneId)> = (self.planes.phases.steps(level).iter())
            .filter_map(|&(plane, after)| {
                let (first, _) = self.planes.phases.origin(plane);
                Some((self.terminal_of(first)?, after))
            })
            .collect();
        let mut arrived = None;
        for (terminal, plane) in starting {
            let Some(x) = self.changes.closed.remove(&terminal) else {
                continue;
            };
            let is_there = self.front.trace(x).end == End::Moving;
            if let Some(here) = successor.get(&x).copied() {
                self.opens(here, terminal, plane);
            } else if is_there && self.is_between_walls(x, terminal) {
                self.changes.closed.insert(terminal, x);
            } else if is_there {
                let new = self.restart(x);
                self.opens(new, terminal, plane);
            } else if self.is_at_low_end(terminal) != Some(true) {
                // Facets come up to upper ends.
                let arrived = arrived.get_or_insert_with(|| self.arrived());
                let here = arrived.get(&self.terminals[terminal].edge);
                let here = here.into_iter().flatten().copied();
                let here = here.chain(self.arrived_as_one(terminal));
                let post = self.terminal_plane(terminal);
                let is_at = |&x: &TraceId| {
                    let pair = self.front.trace(x).pair;
                    self.planes.lead(&self.now, pair, post).is_zero()
                };
                let found = here.into_iter().find(is_at);
                if let Some(here) = found {
                    self.opens(here, terminal, plane);
                }
            }
        }
        for (x, &new) in successor {
            if let Some(terminal) = self.terminal_of(self.front.trace(*x).pair[0])
                && let Some(here) = self.changes.closed.get_mut(&terminal)
                && *here == *x
            {
                *here = new;
            }
        }
    }

    /// Whether a terminal at the upper end of a tilted eave has no facet beside it when it would start: none has come up to it, so
    /// its wavefront edge would lie between two walls on one line for ever, and have no length.
    fn is_between_walls(&self, x: TraceId, terminal: usize) -> bool {
        let Trace { inn, out, .. } = *self.front.trace(x);
        self.is_at_low_end(terminal) == Some(false)
            && [inn, out]
                .into_iter()
                .all(|wave| self.planes.stands_still(self.front.wave(wave).plane))
    }

    /// Whether a terminal is at the lower end of a tilted eave.
    fn is_at_low_end(&self, terminal: usize) -> Option<bool> {
        let edge = self.terminals[terminal].edge;
        let sides = [0, 1].map(|side| PlaneId(2 * edge as u32 + side));
        let eave = sides
            .into_iter()
            .find_map(|side| self.planes.phases.eave_of(side))?;
        // The wavefront edge on the left starts where the edge does.
        let is_first = self.figure.edges()[edge].from.index() == self.terminals[terminal].tip;
        Some(eave.rises == (is_first == (eave.wall == sides[0])))
    }

    /// The terminal whose wavefront edge has a plane at first.
    fn terminal_of(&self, plane: PlaneId) -> Option<usize> {
        let terminal = (plane.0 as usize / 2).checked_sub(self.figure.edges().len())?;
        (terminal < self.terminals.len()).then_some(terminal)
    }

    /// The new vertices that stand on the planes of terminals.
    pub(super) fn fresh_at_terminals(&self) -> BTreeMap<usize, TraceId> {
        let mut found = BTreeMap::new();
        for &x in &self.batch.fresh {
            let trace = self.front.trace(x);
            if trace.end == End::Moving
                && let Some(terminal) = self.terminal_of(trace.pair[0])
            {
                found.entry(terminal).or_insert(x);
            }
        }
        found
    }

    /// Opens the terminals whose edges stand still, but were overrun by others: what ends there moves now.
    pub(super) fn open_moved_terminals(&mut self) {
        if self.changes.closed.is_empty() {
            return;
        }
        // Between antiparallel wavefront edges, the new vertex has the planes of the old one.
        let mut moved = self.fresh_at_terminals();
        if self.now == Moment::Start {
            for (&terminal, &x) in &self.changes.closed {
                if self.front.trace(x).end == End::Moving {
                    moved.insert(terminal, x);
                }
            }
        }
        for (terminal, here) in moved {
            if !self.changes.closed.contains_key(&terminal) {
                continue;
            }
            let Trace { inn, out, .. } = *self.front.trace(here);
            let stands = |wave| self.planes.stands_still(self.front.wave(wave).plane);
            if stands(inn) && stands(out) {
                self.front.trace_mut(here).turn = Sign::Negative;
                self.changes.closed.insert(terminal, here);
            } else {
                self.changes.closed.remove(&terminal);
                self.open_terminal(here, terminal, self.terminal_plane(terminal));
            }
        }
    }

    /// A terminal starts: before facets over tilted eaves do, or else when no straight vertex is left, because the
    /// triangles beside its wavefront edge have no area yet.
    fn opens(&mut self, x: TraceId, terminal: usize, plane: PlaneId) {
        let edge = self.terminals[terminal].edge as u32;
        let mut sides = [PlaneId(2 * edge), PlaneId(2 * edge + 1)].into_iter();
        if sides.any(|side| self.planes.phases.eave_of(side).is_some()) {
            self.open_terminal(x, terminal, plane);
        } else {
            self.changes.opening.push((x, terminal, plane));
        }
    }

    /// Opens the terminals that start at this moment.
    pub(super) fn open_starting_terminals(&mut self) {
        if self.changes.opening.is_empty() {
            return;
        }
        let fresh = self.fresh_at_terminals();
        for (x, terminal, plane) in std::mem::take(&mut self.changes.opening) {
            let is_moving = self.front.trace(x).end == End::Moving;
            let here = if is_moving {
                Some(x)
            } else {
                fresh.get(&terminal).copied()
            };
            if let Some(here) = here {
                self.open_terminal(here, terminal, plane);
            }
        }
    }

    /// A vertex that goes on as a new one, between the same wavefront edges.
    pub(super) fn restart(&mut self, x: TraceId) -> TraceId {
        let node = if self.now == Moment::Start {
            self.front.trace(x).born
        } else {
            self.node_now(x)
        };
        let Trace { inn, out, .. } = *self.front.trace(x);
        let new = self.replace(x, inn, out, node);
        self.front.end_moves(x, new);
        self.front.start_moves(x, new);
        new
    }

    /// The new vertices between the two sides of a terminal's edge, a facet, or a wavefront edge that went on as one with it,
    /// on one or both of them.
    fn arrived_as_one(&self, terminal: usize) -> impl Iterator<Item = TraceId> + '_ {
        let edge = self.terminals[terminal].edge as u32;
        let walls = [PlaneId(2 * edge), PlaneId(2 * edge + 1)];
        let facets = walls.map(|wall| self.planes.phases.plane(wall, 1));
        let is_facet = move |plane, k: usize| {
            facets[k].is_some_and(|facet| self.planes.coplanar(plane, facet))
        };
        let come =
            move |i, j, k: usize| is_facet(i, k) && (j == walls[1 - k] || is_facet(j, 1 - k));
        self.batch.fresh.iter().copied().filter(move |&x| {
            let trace = self.front.trace(x);
            let [i, j] = [trace.inn, trace.out].map(|wave| self.front.wave(wave).plane);
            trace.end == End::Moving && (0..2).any(|k| come(i, j, k) || come(j, i, k))
        })
    }

    /// By edge, the new vertices between its two sides, one of which is a facet: it may have come up to a terminal just now. (The
    /// other side may be a wall that others cover.)
    fn arrived(&self) -> BTreeMap<usize, Vec<TraceId>> {
        let mut found: BTreeMap<usize, Vec<TraceId>> = BTreeMap::new();
        for &x in &self.batch.fresh {
            let trace = self.front.trace(x);
            let phases = &self.planes.phases;
            let [i, j] = [trace.inn, trace.out].map(|w| phases.origin(self.front.wave(w).plane));
            let sides = i.0.0 ^ j.0.0 == 1;
            if trace.end == End::Moving && sides && (i.1 == 1 || j.1 == 1) {
                found.entry(i.0.0 as usize / 2).or_default().push(x);
            }
        }
        found
    }
}
