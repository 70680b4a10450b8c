//! The kinetic triangulation engine (Aichholzer & Aurenhammer 1996, section 3).
//!
//! The unswept region is kept triangulated while the wavefront moves. Every event of the
//! wavefront is witnessed by a triangle that collapses; collapsing triangles wait in a
//! priority queue. Departures from the paper:
//!
//! * All collapses of one moment are resolved together ([`resolve`]), on the figure as it
//!   stands at that moment: sides of length zero are contracted, then flat triangles are
//!   split or flipped, the longest side first. Nothing is perturbed, and wavefront vertices
//!   of infinite speed live only within one such batch, so they never need a velocity.
//! * The exterior is framed by four points at infinity ([`Direction`](crate::predicates::Direction))
//!   instead of one, so that each unbounded triangle has an area that is linear in time.
//! * The modified skeleton of section 5 is a matter of how the wavefront starts at acute angles ([`acute`]).
//! * Neighbours on one plane are carried as one wavefront edge ([`straight`]); their faces
//!   are cut apart afterwards by ghost arcs.
//!
//! Invariant: between two batches every triangle has positive area, and no wavefront vertex
//! has an angle of 0 or 180 degrees.

mod acute;
mod change;
mod eaves;
mod resolve;
mod schedule;
mod setup;
mod straight;
#[cfg(test)]
mod tests;
mod triangulation;

use std::cmp::Ordering;

use crate::{
    input::{Figure, Parts},
    predicates::{Bounds, Moment, Planes, Terminal},
    skeleton::{Region, Skeleton, Stats, assemble, merge},
    topology::{TraceId, TriangleId},
    wavefront::{End, Queue, Wavefront},
};
use change::Changes;
use schedule::Agenda;
use triangulation::{Spokes, Triangulation, next};

/// The state of the propagation.
struct Kinetic<'a> {
    figure: &'a Figure,
    planes: Planes,
    /// The terminals, then the caps of a modified skeleton.
    terminals: Vec<Terminal>,
    triangulation: Triangulation,
    front: Wavefront,
    queue: Queue<TriangleId>,
    /// For each triangle in the queue, when it collapses.
    agenda: Agenda,
    now: Moment,
    /// Bounds of `now`.
    bounds: Bounds,
    batch: Batch,
    changes: Changes,
    stats: Stats,
}

/// A vertex with more triangles is relieved of some when something happens at it: each event
/// at a vertex takes time for each of them, and there may be as many events.
const CROWDED: usize = 48;

/// What is to do and was done at one moment.
#[derive(Default)]
struct Batch {
    /// Number of the batch.
    number: u32,
    /// The first node of this batch.
    first_node: u32,
    /// Triangles that may be flat, the next one last.
    work: Vec<TriangleId>,
    /// Vertices with an angle of 180 degrees.
    straight: Vec<TraceId>,
    /// Vertices that are new.
    fresh: Vec<TraceId>,
    /// Triangles whose next collapse is to be found anew.
    dirty: Vec<TriangleId>,
}

/// The straight skeleton of a part of the plane, or the modified one, by this engine. Total: every
/// figure has one.
///
/// Components of the plane that the edges keep apart are independent: where there are many, groups of them are computed
/// on all processors. The result is the same for every number of them.
///
/// # Complexity
/// O(n) memory; about n log n time on ordinary input, O(n^3 log n) at worst (Lemma 5).
pub(crate) fn skeleton(figure: &Figure, region: Region, modified: bool) -> Skeleton {
    // Caps at a vertex depend on edges that may be in other parts.
    match figure.parts(region).filter(|_| !modified) {
        Some(parts) => of_parts(figure, region, &parts),
        None => of_whole(figure, region, modified),
    }
}

/// The skeleton by one propagation for each part.
fn of_parts(figure: &Figure, region: Region, parts: &Parts) -> Skeleton {
    let compute = |i: usize| {
        let part = parts.part(i);
        let skeleton = of_whole(&part.figure, part.region, false);
        (part, skeleton)
    };
    merge(figure, region, &in_parallel(parts.len(), compute))
}

/// The values of a function from 0 on, in order.
#[cfg(feature = "parallel")]
fn in_parallel<T: Send>(count: usize, compute: impl Fn(usize) -> T + Sync + Send) -> Vec<T> {
    use rayon::prelude::*;
    (0..count).into_par_iter().map(compute).collect()
}

#[cfg(not(feature = "parallel"))]
fn in_parallel<T>(count: usize, compute: impl Fn(usize) -> T) -> Vec<T> {
    (0..count).map(compute).collect()
}

/// The skeleton by one propagation.
fn of_whole(figure: &Figure, region: Region, modified: bool) -> Skeleton {
    let mut kinetic = Kinetic::new(figure, region, modified);
    kinetic.propagate();
    let rungs = kinetic.planes.rungs.get();
    kinetic.stats.by_f64 = rungs.by_f64;
    kinetic.stats.by_double_double = rungs.by_double_double;
    kinetic.stats.by_wide = rungs.by_wide;
    kinetic.stats.by_exact = rungs.by_exact;
    // Only what the wavefront left behind is needed from here on.
    let Kinetic {
        planes,
        terminals,
        front,
        stats,
        ..
    } = kinetic.reduced();
    assemble(figure, &planes, &terminals, front, region, stats)
}

impl Kinetic<'_> {
    /// Frees what only the propagation needs.
    fn reduced(self) -> Self {
        Self {
            triangulation: Triangulation::default(),
            queue: Queue::default(),
            agenda: Agenda::default(),
            batch: Batch::default(),
            ..self
        }
    }

    /// Lets the wavefront move until nothing happens any more.
    fn propagate(&mut self) {
        self.start();
        loop {
            let first = self.first();
            if let Some((moment, bounds)) = self.change_before(first) {
                self.begin_change(moment, bounds);
                self.resolve_batch();
                self.change_speeds();
            } else if let Some((first, bounds)) = first {
                self.begin_batch(first, bounds);
                self.resolve_batch();
            } else {
                break;
            }
            self.remove_straight_vertices();
            self.open_starting_terminals();
            self.open_moved_terminals();
            self.end_batch();
        }
        self.finish();
    }

    /// Takes all triangles that collapse at the next moment from the queue.
    fn begin_batch(&mut self, first: TriangleId, bounds: Bounds) {
        self.batch.number += 1;
        self.batch.first_node = self.front.vertices + self.front.events.len() as u32;
        self.now = self.agenda.moment(first);
        self.bounds = bounds;
        self.take(first);
        while let Some((t, other)) = self.first() {
            let moment = self.agenda.moment(t);
            let order = bounds
                .compare(other)
                .unwrap_or_else(|| self.agenda.compare(&self.planes, first, t));
            if order != Ordering::Equal {
                break;
            }
            if let (Moment::Root(_), Moment::Planes(_)) = (self.now, moment) {
                self.now = moment;
            }
            self.take(t);
        }
    }

    /// Takes all triangles that collapse at a moment when speeds change from the queue.
    fn begin_change(&mut self, moment: Moment, bounds: Bounds) {
        self.batch.number += 1;
        self.batch.first_node = self.front.vertices + self.front.events.len() as u32;
        self.now = moment;
        self.bounds = bounds;
        while let Some((t, other)) = self.first() {
            let order = bounds
                .compare(other)
                .unwrap_or_else(|| self.planes.compare(&moment, &self.agenda.moment(t)));
            if order != Ordering::Equal {
                break;
            }
            self.take(t);
        }
    }

    /// A triangle that collapses next, and the bounds of its moment.
    fn first(&mut self) -> Option<(TriangleId, Bounds)> {
        let Self {
            queue,
            planes,
            agenda,
            ..
        } = self;
        queue.peek(&|a, b| agenda.compare(planes, a, b))
    }

    fn take(&mut self, t: TriangleId) {
        self.enqueue(t, None);
        self.batch.work.push(t);
        self.batch.dirty.push(t);
    }

    /// Finds the next collapse of every triangle that changed.
    fn end_batch(&mut self) {
        let fresh = std::mem::take(&mut self.batch.fresh);
        for &x in &fresh {
            let trace = *self.front.trace(x);
            if trace.end == End::Moving {
                assert!(
                    !trace.turn.is_zero(),
                    "{x} between parallel {:?} and {:?} outlives its moment {:?}",
                    self.front.wave(trace.inn),
                    self.front.wave(trace.out),
                    self.now
                );
                let spokes = self.triangulation.fan(trace.out).map(|(t, _)| t);
                let before = self.batch.dirty.len();
                self.batch.dirty.extend(spokes);
                if self.batch.dirty.len() - before > CROWDED {
                    self.thin_out(x);
                }
            }
        }
        self.batch.fresh = fresh;
        self.batch.fresh.clear();
        let mut dirty = std::mem::take(&mut self.batch.dirty);
        for t in dirty.drain(..) {
            if self.triangulation.visit(t, self.batch.number) {
                self.reschedule(t);
            }
        }
        self.batch.dirty = dirty;
    }

    /// Flips every other spoke of a vertex away, where it can be done: where the two triangles beside it
    /// make a strictly convex quadrilateral.
    fn thin_out(&mut self, x: TraceId) {
        let fan: Spokes = self.triangulation.fan(self.front.trace(x).out).collect();
        let mut i = 0;
        while let Some(&[(t, corner), after]) = fan.get(i..i + 2) {
            i += 1;
            let [a, b, c] = self.triangulation.rim([(t, corner), after]);
            let is_finite = [a, b, c].iter().all(|tip| tip.trace().is_some());
            let is_positive = |tips| self.area_now(tips).is_positive();
            if is_finite && is_positive([a, b, c]) && is_positive([x.into(), a, c]) {
                self.triangulation.flip(t, next(corner));
                self.stats.flips += 1;
                i += 1;
            }
        }
    }

    /// Lets what is left run to infinity.
    fn finish(&mut self) {
        for i in 0..self.triangulation.len() {
            let t = TriangleId::new(i);
            if self.triangulation.is_alive(t) {
                for wave in self
                    .triangulation
                    .get(t)
                    .across
                    .iter()
                    .filter_map(|a| a.wave())
                {
                    let [start, end] = self.triangulation.ends(wave);
                    self.front.vanishes(start, end);
                }
            }
        }
    }
}
