//! How the wavefront of a modified skeleton starts at acute angles.
//!
//! The vertex of a sector of more than 270 degrees becomes three: from the wavefront edge that comes in, right
//! into the cap of its edge, left into the other edge's cap, right into the wavefront edge that goes
//! out. See [`Terminal::with_caps`] for when, and where that departs from the paper.

use super::{
    Kinetic,
    triangulation::{Spokes, Tip, next, prev},
};
use crate::{
    predicates::{Area, Corner, Moment, Part, Terminal},
    topology::{TraceId, TriangleId, WaveId},
    wavefront::{Trace, Walk, Wave},
};
use hipline_num::Sign;

impl Kinetic<'_> {
    /// The vertices of sectors of more than 270 degrees, while everything still stands, each with the number of
    /// the cap of the edge that goes out; the next one is that of the edge that comes in.
    pub(super) fn wide_sectors(&self) -> Vec<(TraceId, usize)> {
        let terminals = self.figure.terminals();
        let (caps, _) = self.terminals[terminals..].as_chunks::<2>();
        if caps.is_empty() {
            return Vec::new();
        }
        let mut list = Vec::with_capacity(caps.len());
        for (i, trace) in self.front.traces.iter().enumerate() {
            let tip = trace.born as usize;
            let Ok(k) = caps.binary_search_by_key(&tip, |[cap, _]| cap.tip) else {
                continue;
            };
            // Of the sectors there, the wide one is to the left of the edge that goes out.
            let Terminal { edge, .. } = caps[k][0];
            let is_right = self.figure.edges()[edge].from.index() != tip;
            let face = (2 * edge + usize::from(is_right)) as u32;
            if self.front.wave(trace.out).face == face {
                list.push((TraceId::new(i), terminals + 2 * k));
            }
        }
        list
    }

    /// Adds the wavefront edge of a cap, and names its face.
    fn push_cap(&mut self, cap: usize, triangle: TriangleId) -> (WaveId, u32) {
        let face = (2 * self.figure.edges().len() + cap) as u32;
        let wave = self.triangulation.push_wave(triangle);
        self.front.waves.push(Wave {
            plane: self.terminal_plane(cap),
            face,
        });
        self.register(wave);
        (wave, face)
    }

    /// Triples the vertex of a wide sector: `x` becomes the one where the wavefront arrives, reflex, before a
    /// convex one and another reflex one.
    pub(super) fn open_caps(&mut self, x: TraceId, cap: usize) {
        let trace = *self.front.trace(x);
        let [plane_out, plane_inn] = [cap, cap + 1].map(|cap| self.terminal_plane(cap));
        let [inn, out] = [trace.inn, trace.out].map(|wave| self.front.wave(wave).plane);
        let corners = [[plane_inn, inn], [out, plane_out]];
        let fan: Spokes = self.triangulation.fan(trace.out).collect();
        let cut = fan[..fan.len() - 1]
            .iter()
            .position(|&(t, corner)| {
                let far = self.triangulation.get(t).tips[prev(corner)];
                self.is_ahead(far, corners.map(Corner::Finite))
            })
            .expect("some spoke points ahead: no angle between spokes reaches 180 degrees");
        // Two triangles: the one between the three vertices, and behind it the opened spoke.
        let between = TriangleId::new(self.triangulation.len());
        let (wave_inn, face_inn) = self.push_cap(cap + 1, between);
        let (wave_out, face_out) = self.push_cap(cap, between);
        let middle = self.front.push_trace(Trace {
            pair: [plane_inn, plane_out],
            inn: wave_inn,
            out: wave_out,
            turn: Sign::Positive,
            after_up: Walk::Open,
            after_down: Walk::Base(face_out),
            ..trace
        });
        let last = self.front.push_trace(Trace {
            pair: corners[1],
            inn: wave_out,
            turn: Sign::Negative,
            ..trace
        });
        let first = self.front.trace_mut(x);
        first.pair = corners[0];
        first.out = wave_inn;
        first.turn = Sign::Negative;
        first.after_down = Walk::Base(face_inn);
        self.front.after_base[face_inn as usize] = Walk::Up(middle);
        self.front.after_base[face_out as usize] = Walk::Up(last);
        for &(t, corner) in &fan[..=cut] {
            self.triangulation.triangles[t.index()].tips[corner] = last.into();
        }
        let (before, corner) = fan[cut];
        let (after, other) = fan[cut + 1];
        let far = self.triangulation.get(before).tips[prev(corner)];
        let opened = TriangleId::new(between.index() + 1);
        self.triangulation.push(
            [x.into(), middle.into(), last.into()],
            [wave_out.into(), opened.into(), wave_inn.into()],
        );
        self.triangulation.push(
            [far, x.into(), last.into()],
            [between.into(), before.into(), after.into()],
        );
        self.triangulation
            .attach(before, next(corner), opened.into());
        self.triangulation.attach(after, prev(other), opened.into());
    }

    /// Whether the far end of a spoke is ahead of the segment between two vertices that leave the
    /// spoke's other end: whether the triangle between them starts to grow.
    fn is_ahead(&self, far: Tip, [first, last]: [Corner; 2]) -> bool {
        let far = match far.trace() {
            Some(far) => Corner::Finite(self.front.trace(far).pair),
            None => Corner::Ideal(far.direction().expect("a direction")),
        };
        let growth = Area([far, first, last], Part::Slope);
        self.planes.sign_at(&Moment::Start, &growth) == Sign::Positive
    }
}
