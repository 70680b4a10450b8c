//! The engine for monotone polygons, and chains (Biedl, Held, Huber, Kaaser & Palfrader 2015, *A simple algorithm
//! for computing positively weighted straight skeletons of monotone polygons*).
//!
//! A polygon that is monotone is split into two chains, whose ends go on to infinity. The skeleton
//! of a chain needs no triangulation: all that ever happens is that edges shrink to nothing ([`chains`]).
//! The roofs of both meet in the merge chain ([`merge`]).

mod boundary;
mod chains;
mod merge;
mod queue;
mod split;
mod straight;

use crate::{
    engine::NotApplicable,
    input::Figure,
    predicates::{Planes, Terminal},
    skeleton::{Region, Skeleton, Stats, assemble},
    topology::EdgeId,
    wavefront::End,
};
use chains::{Chains, NONE, Side, Trouble};
use hipline_num::Sign;
use merge::Merge;
use split::Ring;

/// The straight skeleton of the inside of a monotone polygon.
pub(crate) fn skeleton(figure: &Figure) -> Result<Skeleton, NotApplicable> {
    let ring = Ring::new(figure);
    let [west, east] = ring.extremes(figure).ok_or(NotApplicable::NotMonotone)?;
    let terminals: Vec<Terminal> = Vec::new();
    let planes = Planes::new(figure, &terminals);
    let starts = ring.split(west, east);
    let faces = 2 * figure.edges().len();
    let mut chains = Chains::new(&planes, figure.vertices(), faces, &starts);
    let ends = [west, east].map(|i| ring.vertices[i]);
    merge_chains(&mut chains, ends).map_err(|Trouble(plane)| NotApplicable::Speed {
        edge: EdgeId::new((plane.0 >> 1) as usize),
    })?;
    let Chains {
        mut front,
        queue,
        steps,
        events,
        ..
    } = chains;
    // Only what was not cut off has been joined.
    for x in 0..front.traces.len() {
        let trace = front.traces[x];
        if trace.end == End::Ghost {
            let [a, b] = [trace.inn, trace.out].map(|w| front.wave(w).face);
            front.join_faces(a, b);
        }
    }
    let rungs = planes.rungs.get();
    let stats = Stats {
        edge_events: events,
        by_f64: rungs.by_f64,
        by_double_double: rungs.by_double_double,
        by_wide: rungs.by_wide,
        by_exact: rungs.by_exact,
        ..Stats::default()
    };
    let _ = (queue.comparisons, steps);
    Ok(assemble(
        figure,
        &planes,
        &terminals,
        front,
        Region::Interior,
        stats,
    ))
}

/// Lets two chains move, and merges them.
fn merge_chains(chains: &mut Chains, [west, east]: [u32; 2]) -> Result<(), Trouble> {
    // The rays at time zero, when the faster ones of those on one line have won.
    let ray = |chains: &Chains, side: Side| {
        let is_ray = |w: &&u32| {
            let wave = &chains.waves[**w as usize];
            let far = if side == Side::Lower { wave.start } else { wave.end };
            wave.side == side && far == NONE && wave.death == NONE && wave.joined == NONE
        };
        let all: Vec<u32> = (0..chains.waves.len() as u32).collect();
        *all.iter().find(is_ray).expect("a chain has rays")
    };
    let rays = [Side::Lower, Side::Upper].map(|side| ray(chains, side));
    // The upper chain's last edge is the western one; any other plane of the lower chain that it
    // turns into does.
    let lower: Vec<u32> = (0..chains.waves.len() as u32)
        .filter(|&w| chains.waves[w as usize].side == Side::Lower)
        .collect();
    let flat = lower
        .iter()
        .map(|&w| chains.waves[w as usize].plane)
        .find(|&k| {
            let turn = chains.planes.turn(chains.waves[rays[1] as usize].plane, k);
            turn == Sign::Positive
        });
    let flat = flat.expect("the chains part at the western end");
    chains.propagate()?;
    Merge::run(chains, rays, west, east, flat)
}
