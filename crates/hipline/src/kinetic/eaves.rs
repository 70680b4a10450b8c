//! Tilted eaves: their facets start at a point.
//!
//! When the wavefront's time reaches the height of the lower end of a tilted eave, a wavefront edge of its facet is
//! born there, of length zero; one of its ends runs up along the eave, until it meets the end of the wall at
//! the upper end. The triangle that the new wavefront edge bounds has its third corner at the
//! upper end of the eave, which is ahead of the facet.

use std::{collections::BTreeMap, ops::Range};

use super::{
    Kinetic,
    triangulation::{next, prev},
};
use crate::{
    predicates::{Eave, PlaneId},
    topology::{TraceId, WaveId},
    wavefront::{End, FaceStart, Trace, Walk, Wave},
};

use hipline_num::Sign;

/// The eaves that start at one vertex: that of the wavefront edge before it, and that of the one
/// after it.
type Pair = [Option<Eave>; 2];

impl Kinetic<'_> {
    /// From now on, a wavefront edge does not overrun a wall on its line where a facet starts between them next, at
    /// a time at which speeds change.
    pub(super) fn await_facets(&mut self, level: usize) {
        let eaves = self.planes.phases.births(Some(level));
        self.changes.births = eaves.into_iter().map(|eave| (eave.wall, eave)).collect();
        let straight = std::mem::take(&mut self.batch.straight);
        let waits = |&x: &TraceId| self.awaits_facet(x);
        let (below, straight) = straight.into_iter().partition(waits);
        (self.changes.below, self.batch.straight) = (below, straight);
    }

    /// Whether a facet starts next between the two wavefront edges at a straight vertex.
    pub(super) fn awaits_facet(&self, x: TraceId) -> bool {
        let births = &self.changes.births;
        if births.is_empty() {
            return false;
        }
        let trace = self.front.trace(x);
        let [i, j] = [trace.inn, trace.out].map(|wave| self.front.wave(wave).plane);
        let starts = |wall: PlaneId, rises: bool| {
            births.get(&wall).is_some_and(|eave| {
                let lead = || self.planes.lead(&self.now, trace.pair, eave.low_post());
                eave.rises == rises && lead().is_zero()
            })
        };
        starts(i, false) || starts(j, true)
    }

    /// Where there are tilted eaves, what lies on one line settles before terminals and facets start: so they start
    /// between wavefront edges that stay.
    pub(super) fn settle_before_facets(&mut self, successor: &mut BTreeMap<TraceId, TraceId>) {
        if self.planes.phases.eaves().is_empty() {
            return;
        }
        self.remove_straight_vertices();
        // Terminals may have been replaced.
        let fresh = self.fresh_at_terminals();
        for (&terminal, x) in &mut self.changes.closed {
            let here = successor.get(x).copied().unwrap_or(*x);
            if self.front.trace(here).end != End::Moving
                && let Some(&new) = fresh.get(&terminal)
            {
                let Trace { inn, out, .. } = *self.front.trace(new);
                let [i, j] = [inn, out].map(|wave| self.front.wave(wave).plane);
                // The sides of an edge lie back to back.
                if self.planes.turn(i, j).is_zero() && !self.planes.same_direction(i, j) {
                    successor.insert(*x, new);
                }
            }
        }
    }

    /// Starts the facets of the eaves whose lower end has the height of a level, or zero. Then what lies on one line
    /// settles, and facets that are covered since are gone again.
    pub(super) fn start_facets(&mut self, level: Option<usize>) {
        let starting = self.planes.phases.births(level);
        let mut at: BTreeMap<TraceId, Pair> = BTreeMap::new();
        for eave in starting {
            if let Some(x) = self.low_end(&eave) {
                at.entry(x).or_default()[usize::from(eave.rises)] = Some(eave);
            }
        }
        let before = self.front.waves.len();
        for (x, mut pair) in at {
            self.drop_shrinking(x, &mut pair);
            let mut x = x;
            if let Some(eave) = pair[0] {
                x = self.start_facet(x, &eave);
            }
            if let Some(eave) = pair[1] {
                self.start_facet(x, &eave);
            }
        }
        self.changes.births.clear();
        let below = std::mem::take(&mut self.changes.below);
        self.batch.straight.extend(below);
        if level.is_none() {
            self.leave_posts();
        }
        let started = before..self.front.waves.len();
        if started.is_empty() {
            return;
        }
        while self.drop_overtaken(started.clone()) {}
        self.remove_straight_vertices();
        while self.drop_overtaken(started.clone()) {
            self.remove_straight_vertices();
        }
    }

    /// Removes one of the facets that have just started, if it has no length still and does not grow, or will not after
    /// a faster one has overrun what is between them on their line.
    fn drop_overtaken(&mut self, started: Range<usize>) -> bool {
        for wave in started.map(WaveId::new) {
            if !self.triangulation.has(wave) {
                continue;
            }
            let [start, end] = self.triangulation.ends(wave).map(|x| *self.front.trace(x));
            let nodes = [start.born, end.born].map(|node| self.front.node(node));
            let three = [start.inn, wave, end.out].map(|wave| self.front.wave(wave).plane);
            if nodes[0] != nodes[1] || self.planes.grows(three) && !self.is_overtaken(wave) {
                continue;
            }
            let face = self.front.wave(wave).face;
            let (t, k) = self.triangulation.beside(wave);
            self.contract(t, k);
            // Nothing is flat here but what has no length yet.
            self.batch.work.clear();
            self.front.start_face_with(face, Walk::Open);
            return true;
        }
        false
    }

    /// The vertex at the lower end of an eave, if the wall is still there.
    fn low_end(&self, eave: &Eave) -> Option<TraceId> {
        let waves = self.changes.waves.get(&eave.wall)?;
        waves
            .iter()
            .filter(|&&wave| self.triangulation.has(wave))
            .map(|&wave| self.triangulation.ends(wave)[usize::from(!eave.rises)])
            .find(|&x| {
                let pair = self.front.trace(x).pair;
                self.planes.lead(&self.now, pair, eave.low_post()).is_zero()
            })
    }

    /// A facet that its neighbours cover at once does not start.
    fn drop_shrinking(&self, x: TraceId, pair: &mut Pair) {
        let trace = self.front.trace(x);
        let [i, j] = [trace.inn, trace.out].map(|wave| self.front.wave(wave).plane);
        loop {
            let mut chain: Vec<PlaneId> = vec![i];
            chain.extend(pair.iter().flatten().map(|eave| eave.facet));
            chain.push(j);
            let shrinking = chain
                .windows(3)
                .find(|three| !self.planes.grows([three[0], three[1], three[2]]));
            let Some(three) = shrinking else { return };
            for eave in pair.iter_mut() {
                if eave.is_some_and(|eave| eave.facet == three[1]) {
                    *eave = None;
                }
            }
        }
    }

    /// Whether the wavefront edge beside a slower neighbour on one line is on that line, too, and faster than both.
    fn is_overtaken(&self, wave: WaveId) -> bool {
        let plane = |wave| self.front.wave(wave).plane;
        let of_line = |other: &WaveId| {
            let [i, j] = [plane(wave), plane(*other)];
            self.planes.turn(i, j).is_zero() && self.planes.same_direction(i, j)
        };
        let before = |wave| self.front.trace(self.triangulation.ends(wave)[0]).inn;
        let after = |wave| self.front.trace(self.triangulation.ends(wave)[1]).out;
        let beyond = [
            Some(before(wave)).filter(of_line).map(before),
            Some(after(wave)).filter(of_line).map(after),
        ];
        let faster = |other: WaveId| {
            self.planes
                .compare_speeds(plane(other), plane(wave))
                .is_gt()
        };
        (beyond.into_iter().flatten()).any(|other| of_line(&other) && faster(other))
    }

    /// Starts a facet at a vertex. Returns the vertex at the far end of it, seen along the
    /// wavefront.
    fn start_facet(&mut self, x: TraceId, eave: &Eave) -> TraceId {
        let x = self.restart(x);
        let trace = *self.front.trace(x);
        let node = trace.born;
        let wall = if eave.rises { trace.out } else { trace.inn };
        let (beside, k) = self.triangulation.beside(wall);
        let fan: Vec<_> = self.triangulation.fan(trace.out).collect();
        let upper = self.triangulation.get(beside).tips[if eave.rises { prev(k) } else { next(k) }];
        let wave = self.triangulation.push_wave(beside);
        let face = self.front.push_face(FaceStart {
            walk: Walk::Open,
            plane: eave.facet,
            before: None,
        });
        self.front.waves.push(Wave {
            plane: eave.facet,
            face,
        });
        let start = self.spawn(trace.inn, wave, node, x);
        let end = self.spawn(wave, trace.out, node, x);
        self.front.trace_mut(x).end = End::At(node);
        self.front.end_moves(x, start);
        self.front.start_moves(x, end);
        self.front.is_cut(end, start);
        self.front.start_face_with(
            face,
            if eave.rises {
                Walk::Up(end)
            } else {
                Walk::Down(start)
            },
        );
        // The other triangles around the vertex stay at the end that does not run along the wall.
        let kept = if eave.rises { start } else { end };
        for &(t, corner) in &fan {
            self.triangulation.triangles[t.index()].tips[corner] = kept.into();
        }
        let opened = self.triangulation.push(
            [upper, start.into(), end.into()],
            [wave.into(), beside.into(), beside.into()],
        );
        self.triangulation.attach(opened, 0, wave.into());
        let along = if eave.rises { 1 } else { 2 };
        self.triangulation.attach(opened, along, wall.into());
        self.triangulation.attach(beside, k, opened.into());
        end
    }

    /// Whether one of two wavefront edges on one line is the wall of an eave that rises from the vertex between
    /// them from the start on: its facet comes between the two, if it starts. Until then, the vertex is at a
    /// post.
    pub(super) fn post_below(&self, i: WaveId, j: WaveId) -> Option<[PlaneId; 2]> {
        let [i, j] = [i, j].map(|wave| self.front.wave(wave).plane);
        let phases = &self.planes.phases;
        let rises = |wall: PlaneId, rises: bool| {
            let eave = phases.eave_of(wall)?;
            (eave.rises == rises && eave.from <= 0.0).then(|| eave.low_post())
        };
        rises(i, false)
            .map(|post| [post, i])
            .or_else(|| rises(j, true).map(|post| [post, j]))
    }

    /// At the start: where no facet has come between a wall and a wavefront edge that moves on its line, they are
    /// neighbours.
    pub(super) fn leave_posts(&mut self) {
        for x in (0..self.front.traces.len()).map(TraceId::new) {
            let trace = self.front.trace(x);
            if trace.end != End::Moving || !self.planes.phases.is_post(trace.pair[0]) {
                continue;
            }
            let [i, j] = [trace.inn, trace.out].map(|wave| self.front.wave(wave).plane);
            let moves = |plane| !self.planes.stands_still(plane);
            if self.planes.same_direction(i, j) && (moves(i) || moves(j)) {
                self.front.trace_mut(x).turn = Sign::Zero;
                self.batch.straight.push(x);
            }
        }
    }

    /// Whether the wall of a tilted eave ends between two walls on one line, where the eave does: then the vertex
    /// between them stands at a post. It is at the place of a pair of planes now, if one is given; at the start, walls end
    /// at posts.
    pub(super) fn post_between(
        &self,
        i: WaveId,
        j: WaveId,
        place: Option<[PlaneId; 2]>,
    ) -> Option<[PlaneId; 2]> {
        let planes = &self.planes;
        if planes.phases.eaves().is_empty() {
            return None;
        }
        let [i, j] = [i, j].map(|wave| self.front.wave(wave).plane);
        if !planes.stands_still(i) || !planes.stands_still(j) || !planes.same_direction(i, j) {
            return None;
        }
        let post_of = |wall, end: usize| planes.phases.eave_of(wall).map(|eave| eave.posts[end]);
        let is_here =
            |post: &PlaneId| place.is_none_or(|pair| planes.lead(&self.now, pair, *post).is_zero());
        let post = (post_of(i, 1).filter(is_here)).or_else(|| post_of(j, 0).filter(is_here))?;
        // The first plane of a pair turns left into the second.
        let turned = PlaneId(post.0 ^ 1);
        let turns_left = planes.turn(post, j).is_positive();
        Some([if turns_left { post } else { turned }, j])
    }
}
