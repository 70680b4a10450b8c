//! Tilted eaves: their facets start at a point.
//!
//! When the wavefront's time reaches the height of the lower end of a tilted eave, a wavefront edge of its facet is
//! born there, of length zero; one of its ends runs up along the eave, until it meets the end of the wall at
//! the upper end. The triangle that the new wavefront edge bounds has its third corner at the
//! upper end of the eave, which is ahead of the facet.

use std::collections::BTreeMap;

use super::{
    Kinetic,
    triangulation::{next, prev},
};
use crate::{
    predicates::{Eave, PlaneId},
    topology::{TraceId, WaveId},
    wavefront::{FaceStart, Walk, Wave},
};

/// The eaves that start at one vertex: that of the wavefront edge before it, and that of the one
/// after it.
type Pair = [Option<Eave>; 2];

impl Kinetic<'_> {
    /// Starts the facets of the eaves whose lower end has the height of a level, or zero.
    pub(super) fn start_facets(&mut self, level: Option<usize>) {
        let starting = self.planes.phases.births(level);
        let mut at: BTreeMap<TraceId, Pair> = BTreeMap::new();
        for eave in starting {
            if let Some(x) = self.low_end(&eave) {
                at.entry(x).or_default()[usize::from(eave.rises)] = Some(eave);
            }
        }
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
        self.front.trace_mut(x).end = super::End::At(node);
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

    /// Whether a wall of a tilted eave lies on one line with another wall: the vertex between them
    /// stands at a post.
    pub(super) fn post_between(&self, i: WaveId, j: WaveId) -> Option<[PlaneId; 2]> {
        let [i, j] = [i, j].map(|wave| self.front.wave(wave).plane);
        let planes = &self.planes;
        if !planes.stands_still(i) || !planes.stands_still(j) {
            return None;
        }
        let post = match (planes.phases.eave_of(i), planes.phases.eave_of(j)) {
            (Some(eave), _) => eave.posts[1],
            (None, Some(eave)) => eave.posts[0],
            (None, None) => return None,
        };
        // The first plane of a pair turns left into the second.
        let turned = PlaneId(post.0 ^ 1);
        let turns_left = planes.turn(post, j).is_positive();
        Some([if turns_left { post } else { turned }, j])
    }
}
