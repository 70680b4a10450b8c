//! The roof as a lower envelope of slabs: Mencil, *A faster algorithm for computing straight skeletons* (2014), with Cheng and
//! Vigneron.
//!
//! By Theorem 2 of the thesis, the terrain of the straight skeleton is the lower envelope of the slabs of edges and
//! motorcycles. So, given the motorcycle graph ([`motorcycle`](crate::motorcycle)), no wavefront has to be
//! propagated.
//!
//! 1. [`slabs`]: sources and their slabs; the stretch on which two slabs meet.
//! 2. [`cells`]: divide and conquer over the plan tells which faces may border on each other. [`boundary`] has the cells, [`section`] the roof above a cut,
//!    [`split`] and [`strips`] what a cut and its descent paths leave, [`convex`] and [`extended`] the last cells.
//! 3. [`faces`]: what is visible of each face, a lower envelope seen along its edge ([`profile`]).
//! 4. [`glue`]: the visible stretches, each named by two faces, become traces, linked into boundaries.
//!
//! Nothing is perturbed and no case is degenerate: all that is asked are the signs of planes at meetings of planes, as
//! in the other engines. Where it departs from the thesis, and under which condition its bound holds, is told in [`split`], [`cells`] and in
//! `docs/engines.md`.

mod boundary;
mod cells;
mod chords;
mod convex;
mod extended;
mod faces;
mod glue;
mod outerplanar;
mod profile;
mod section;
mod slabs;
mod split;
mod spread;
mod strips;
pub mod subdivision;

use crate::{
    engine::NotApplicable,
    input::Figure,
    motorcycle::{self, tracks::Tracks},
    predicates::{PlaneId, Planes},
    skeleton::{Region, Skeleton, Stats, assemble},
};
use faces::Outline;
use slabs::{Slab, Sources};
use std::sync::Arc;

/// What was counted.
#[derive(Clone, Copy, Debug, Default)]
struct Count {
    /// Pairs of slabs that were cut with each other.
    cuts: u64,
    /// Cells, those that were cut among them.
    cells: u64,
    /// The largest number of cuts around a cell.
    depth: u32,
    /// The sum of the lengths of all lists of cells.
    listed: u64,
    /// Slabs restricted to cuts.
    sections: u64,
    /// Planes that vanished on lower envelopes of planes.
    planes: u64,
    /// The sum of the lengths of the lists of last cells.
    last: u64,
    /// Pairs of faces that were taken without a closer look.
    pairs: u64,
    merging: profile::Count,
}

impl Count {
    /// Adds what another thread counted.
    #[cfg(feature = "parallel")]
    fn add(&mut self, other: &Self) {
        self.cuts += other.cuts;
        self.cells += other.cells;
        self.depth = self.depth.max(other.depth);
        self.listed += other.listed;
        self.sections += other.sections;
        self.planes += other.planes;
        self.last += other.last;
        self.pairs += other.pairs;
        self.merging.steps += other.merging.steps;
    }
}

/// Where a slab is found.
#[derive(Clone, Copy, Debug)]
struct SlabRef {
    face: u32,
    /// Among those of its face.
    index: u32,
}

/// What is known of a figure. Faces are named by the numbers of their planes.
struct Shared<'a> {
    figure: &'a Figure,
    tracks: Tracks,
    /// The lowest number of a plane that is the same one.
    classes: Vec<u32>,
    /// Two planes that are not parallel.
    across: [PlaneId; 2],
    /// The sides of edges on the inside, ascending.
    faces: Vec<u32>,
    /// For each face, those of the wavefront edges before and after it.
    beside: Vec<[u32; 2]>,
    sources: Vec<Sources>,
    /// All slabs, numbered by face, from left to right.
    refs: Vec<SlabRef>,
    /// The slabs of each track: on its first plane, and on its second one.
    slabs_of_track: Vec<[u32; 2]>,
    /// Where tracks end, roughly.
    ends: Vec<[f64; 2]>,
    /// A triangle of the mesh at each face.
    triangles: Vec<u32>,
}

/// The same, with what one thread works with.
struct Envelope<'a> {
    shared: Arc<Shared<'a>>,
    planes: Planes,
    count: Count,
    /// Faces on one plane whose slabs lie over one another.
    twins: Vec<[u32; 2]>,
    /// The cells after the first stage and after the second one, if they are asked for.
    seen: Option<[Vec<boundary::Cell>; 2]>,
}

impl<'a> std::ops::Deref for Envelope<'a> {
    type Target = Shared<'a>;

    fn deref(&self) -> &Shared<'a> {
        &self.shared
    }
}

/// Computes the straight skeleton of the inside of a figure's polygons.
///
/// # Errors
/// If the figure is not made of polygons alone, or not all speeds are one, or more than the inside is asked for.
pub(crate) fn skeleton(figure: &Figure, region: Region) -> Result<Skeleton, NotApplicable> {
    if region != Region::Interior {
        return Err(NotApplicable::NotInterior);
    }
    let (planes, tracks) = motorcycle::induced(figure)?;
    Ok(build(figure, planes, tracks))
}

/// The lower envelope of the slabs of the edges and of given tracks.
fn build(figure: &Figure, planes: Planes, tracks: Tracks) -> Skeleton {
    let mut envelope = Envelope::new(figure, planes, tracks);
    let outlines = envelope.outlines();
    let front = envelope.glue(outlines);
    let rungs = envelope.planes.rungs.get();
    let count = envelope.count;
    let stats = Stats {
        steps: count.cuts + count.sections + count.planes + count.merging.steps,
        by_f64: rungs.by_f64,
        by_double_double: rungs.by_double_double,
        by_wide: rungs.by_wide,
        by_exact: rungs.by_exact,
        ..Stats::default()
    };
    assemble(
        figure,
        &envelope.planes,
        &[],
        front,
        Region::Interior,
        stats,
    )
}

impl<'a> Envelope<'a> {
    fn new(figure: &'a Figure, planes: Planes, tracks: Tracks) -> Self {
        let classes = planes.classes();
        let count = 2 * figure.edges().len();
        let ends = tracks.motorcycles.iter().map(|track| {
            let end = track
                .end
                .as_ref()
                .expect("inside of polygons nobody escapes");
            let [x, y, _] = planes.round(end);
            [x, y]
        });
        let mut shared = Shared {
            figure,
            ends: ends.collect(),
            slabs_of_track: vec![[u32::MAX; 2]; tracks.motorcycles.len()],
            tracks,
            classes,
            across: [PlaneId(0); 2],
            faces: Vec::new(),
            beside: vec![[u32::MAX; 2]; count],
            sources: vec![Sources::default(); count],
            refs: Vec::new(),
            triangles: vec![u32::MAX; count],
        };
        shared.find_faces();
        let first = PlaneId(shared.faces[0]);
        let other = (shared.faces.iter()).find(|&&f| !planes.turn(first, PlaneId(f)).is_zero());
        shared.across = [
            first,
            PlaneId(*other.expect("a polygon has two directions")),
        ];
        shared.find_slabs();
        Self {
            shared: Arc::new(shared),
            planes,
            count: Count::default(),
            twins: Vec::new(),
            seen: None,
        }
    }

    /// What is visible of each face, by the faces that may border on it.
    fn outlines(&mut self) -> Vec<Option<Outline>> {
        let pairs = self.candidates();
        let mut first = vec![0_usize; self.sources.len() + 1];
        for pair in &pairs {
            for face in pair {
                first[*face as usize + 1] += 1;
            }
        }
        for i in 1..first.len() {
            first[i] += first[i - 1];
        }
        let mut fill = first.clone();
        let mut others = vec![0; 2 * pairs.len()];
        for [f, g] in pairs {
            for (own, other) in [(f, g), (g, f)] {
                others[fill[own as usize]] = other;
                fill[own as usize] += 1;
            }
        }
        let faces = self.faces.clone();
        let found = self.spread(&faces, |envelope, &face| {
            let range = first[face as usize]..first[face as usize + 1];
            envelope.outline(face, &others[range])
        });
        let mut outlines: Vec<Option<Outline>> = vec![None; self.sources.len()];
        for (&face, outline) in faces.iter().zip(found) {
            outlines[face as usize] = Some(outline);
        }
        outlines
    }

    fn slab(&self, number: u32) -> &Slab {
        let SlabRef { face, index } = self.refs[number as usize];
        &self.sources[face as usize].slabs[index as usize]
    }
}

impl Shared<'_> {
    fn class(&self, plane: PlaneId) -> PlaneId {
        PlaneId(self.classes[plane.0 as usize])
    }

    /// The vertex at the start or the end of a wavefront edge at time zero.
    fn end_of(&self, face: u32, side: usize) -> usize {
        let edge = &self.figure.edges()[face as usize / 2];
        let ends = [edge.from, edge.to];
        ends[if face.is_multiple_of(2) {
            side
        } else {
            1 - side
        }]
        .index()
    }

    /// Finds the sides of edges on the inside, and which come one after another: those of one sector.
    fn find_faces(&mut self) {
        let mesh = self.figure.mesh();
        let next = |k: usize| (k + 1) % 3;
        let facing = |t: usize, k: usize| {
            let edge = mesh.across[t][k].edge?;
            let from = self.figure.edges()[edge as usize].from.index() as u32;
            Some(2 * edge + u32::from(mesh.corners[t][next(k)] != from))
        };
        for t in (0..mesh.corners.len()).filter(|&t| mesh.inside[t]) {
            for corner in 0..3 {
                // The side that starts at this corner.
                let Some(out) = facing(t, (corner + 2) % 3) else {
                    continue;
                };
                self.faces.push(out);
                self.triangles[out as usize] = t as u32;
                let vertex = mesh.corners[t][corner];
                let (mut at, mut k) = (t, corner);
                let inn = loop {
                    // The side that ends at it.
                    match facing(at, next(k)) {
                        Some(inn) => break inn,
                        None => {
                            at = mesh.across[at][next(k)].neighbour as usize;
                            k = (0..3)
                                .find(|&k| mesh.corners[at][k] == vertex)
                                .expect("neighbours share a side");
                        }
                    }
                };
                self.beside[out as usize][0] = inn;
                self.beside[inn as usize][1] = out;
            }
        }
        self.faces.sort_unstable();
    }
}
