//! The engine for monotone polygons, and chains (Biedl, Held, Huber, Kaaser & Palfrader 2015, *A simple
//! algorithm for computing positively weighted straight skeletons of monotone polygons*).
//!
//! A polygon that is monotone is split into two chains, whose ends go on to infinity ([`split`]). The skeleton of a
//! chain needs no triangulation: all that ever happens is that edges shrink to nothing ([`chains`], section 2;
//! neighbours on one line: [`straight`]). The roofs of both meet in the merge chain ([`merge`], sections 3 and 4), which
//! leaves faces over their eastern boundaries ([`boundary`]). Chains are results of their own, too ([`chain`]).
//!
//! Departures from the paper, with reasons in `docs/engines.md`:
//!
//! * No trapezoidation, and no rotation: faces are monotone in time, which serves instead.
//! * Edges along the levels are taken as they are, and so is what they lead to: edges that meet face to face, within
//!   a chain or across both, and edges of both chains on one plane.
//! * Theorem 8 does not hold with weights: what was cut off may come back in its own chain. The merge finds that
//!   out, and refuses. (Chains have any positive speeds.)

mod boundary;
mod chain;
mod chains;
mod merge;
mod split;
mod straight;

use crate::{
    engine::NotApplicable,
    input::{Edge, Figure},
    predicates::{Planes, turn},
    skeleton::{Region, Skeleton, Stats, assemble},
    topology::{EdgeId, VertexId, WaveId},
    wavefront::{End, Walk, Wavefront},
};
pub use chain::{Chain, InvalidChain};
use chains::{Chains, NONE, Side, Start, Trouble};
use merge::Merge;

/// Why this engine does not apply to a figure, if that can be seen before.
fn refusal(figure: &Figure, region: Region) -> Option<NotApplicable> {
    if region != Region::Interior {
        return Some(NotApplicable::NotInterior);
    }
    if figure.has_heights() {
        return Some(NotApplicable::Heights);
    }
    let edges = figure.edges();
    if figure.monotone().is_none() {
        let source = |e: usize| (edges[e].source.part, edges[e].source.ring, edges[e].on_ring);
        let one = (0..edges.len()).all(|e| source(e) == source(0) && edges[e].on_ring);
        return Some(if one {
            NotApplicable::NotMonotone
        } else {
            NotApplicable::NotOneRing
        });
    }
    let changes = figure.changes().first().map(|change| change.edge);
    let still = edges.iter().position(|edge| edge.speeds.contains(&0.0));
    changes
        .or(still.map(EdgeId::new))
        .map(|edge| NotApplicable::Speed { edge })
}

/// Whether a polygon is strictly monotone: no edge lies along a level. Then nothing is ever parallel across both chains.
pub(crate) fn is_strict(figure: &Figure) -> bool {
    let place = |v: VertexId| figure.vertices()[v.index()];
    figure.monotone().is_some_and(|monotone| {
        let level =
            |edge: &Edge| turn([place(edge.from), place(edge.to)], monotone.across).is_zero();
        !figure.edges().iter().any(level)
    })
}

/// The straight skeleton of the inside of a monotone polygon.
///
/// # Complexity
/// O(n log n) time, O(n) memory.
pub(crate) fn skeleton(figure: &Figure, region: Region) -> Result<Skeleton, NotApplicable> {
    if let Some(refusal) = refusal(figure, region) {
        return Err(refusal);
    }
    let monotone = figure.monotone().ok_or(NotApplicable::NotMonotone)?;
    let planes = Planes::new(figure, &[]);
    let starts = split::split(monotone, figure.vertices().len());
    let faces = 2 * figure.edges().len();
    let refused = |Trouble(plane)| NotApplicable::RunsAhead {
        edge: EdgeId::new((plane.0 >> 1) as usize),
    };
    let mut chains = Chains::new(&planes, figure.vertices(), faces, &starts).map_err(refused)?;
    merge_chains(&mut chains, &starts).map_err(refused)?;
    let stats = Stats {
        edge_events: chains.events,
        ..Stats::default()
    };
    Ok(finish(figure, chains, stats))
}

/// The result.
fn finish(figure: &Figure, chains: Chains, mut stats: Stats) -> Skeleton {
    let (planes, front) = (chains.planes, chains.into_front());
    let rungs = planes.rungs.get();
    stats.by_f64 = rungs.by_f64;
    stats.by_double_double = rungs.by_double_double;
    stats.by_wide = rungs.by_wide;
    stats.by_exact = rungs.by_exact;
    assemble(figure, planes, &[], front, Region::Interior, stats)
}

/// Lets two chains move, and merges them.
fn merge_chains(chains: &mut Chains, starts: &[Start; 2]) -> Result<(), Trouble> {
    // The western rays at time zero, where the faster ones of those on one line have won.
    let west = |side: Side, chains: &Chains| {
        let all = 0..chains.waves.len() as u32;
        let mut rays = all.filter(|&w| {
            let wave = &chains.waves[w as usize];
            let far = match side {
                Side::Lower => wave.start,
                Side::Upper => wave.end,
            };
            wave.side == side && far == NONE && wave.death == NONE && wave.joined == NONE
        });
        rays.next().expect("a chain has rays")
    };
    let rays = [Side::Lower, Side::Upper].map(|side| west(side, chains));
    chains.propagate()?;
    let [west, east] = starts[0].ends.map(|end| end.expect("a vertex"));
    // The first edge of the lower chain heads east.
    Merge::run(chains, rays, west, east, starts[0].planes[0])
}

impl Chains<'_> {
    /// What the propagation and the merge leave behind; all else is forgotten.
    fn into_front(mut self) -> Wavefront {
        if self.ghosts {
            join_faces(&mut self.front);
        }
        self.front
    }
}

/// Faces whose boundaries are linked, by ghosts, are joint. (What was joined in a chain may have been cut off since,
/// so that is not to be asked.)
fn join_faces(front: &mut Wavefront) {
    let mut wave_of = vec![WaveId::raw(0); front.after_base.len()];
    for (w, wave) in front.waves.iter().enumerate() {
        wave_of[wave.face as usize] = WaveId::new(w);
    }
    let mut seen = vec![false; front.after_base.len()];
    for face in 0..front.after_base.len() as u32 {
        if seen[face as usize] || front.after_base[face as usize] == Walk::Open {
            continue;
        }
        let first = Walk::Base(face);
        let mut walk = first;
        loop {
            walk = match walk {
                Walk::Base(other) => {
                    seen[other as usize] = true;
                    if other != face {
                        front.join_faces(face, other);
                    }
                    front.after_base[other as usize]
                }
                Walk::Up(x) | Walk::Down(x) => {
                    let trace = front.trace_mut(x);
                    if trace.end == End::Ghost {
                        (trace.inn, trace.out) = (wave_of[face as usize], wave_of[face as usize]);
                    }
                    if walk == Walk::Up(x) {
                        trace.after_up
                    } else {
                        trace.after_down
                    }
                }
                Walk::Open => unreachable!("every walk goes on"),
            };
            if walk == first {
                break;
            }
        }
    }
}
