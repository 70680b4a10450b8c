//! What is inside, and whether the rings lie in one another as polygons should.
//!
//! The edges of rings cut the triangles into regions. Walking from outside across one ring
//! after the other, a region's *state* is the ring just entered (or none, outside of all);
//! crossing the ring of the state leaves it again, to the state from which it was entered.
//! Where rings are nested properly, every ring is entered from one state only, so a state
//! is one number and not a set. All other ways to be nested show as an edge of a ring that
//! is crossed from a wrong state.

use std::collections::HashMap;

use super::{Edge, Flaw, InvalidFigure, Mesh, MeshEdge, Place};

/// The state outside of all rings; inside ring r it is r + 1.
const OUTSIDE: u32 = 0;
/// A ring not entered yet; a triangle not visited yet.
const UNKNOWN: u32 = u32::MAX;

/// Fills in [`Mesh::inside`] by counting rings (even-odd), and reports rings that are
/// nested wrongly and polygons whose inside is disconnected.
pub(super) fn fill(vertices: &[[f64; 2]], edges: &[Edge], mesh: &mut Mesh, flaws: &mut Vec<Flaw>) {
    let Some(rings) = Rings::of(edges) else {
        return;
    };
    let mut nesting = Nesting {
        vertices,
        edges,
        outer: vec![UNKNOWN; rings.names.len()],
        flawed: vec![false; rings.names.len()],
        rings,
        flaws,
    };
    let regions = nesting.flood(mesh);
    nesting.connected(mesh, &regions);
}

/// Rings in one numbering.
struct Rings {
    /// The number of the first ring of each part.
    first: Vec<u32>,
    /// Part and ring of each.
    names: Vec<[u32; 2]>,
}

impl Rings {
    /// None if there is no ring.
    fn of(edges: &[Edge]) -> Option<Self> {
        let on_ring = || {
            edges
                .iter()
                .filter(|edge| edge.on_ring)
                .map(|edge| edge.source)
        };
        let last = on_ring().map(|source| source.part).max()?;
        let mut counts = vec![0; last as usize + 1];
        for source in on_ring() {
            let count = &mut counts[source.part as usize];
            *count = source.ring.saturating_add(1).max(*count);
        }
        let mut names = Vec::new();
        let mut first = counts;
        for (part, count) in first.iter_mut().enumerate() {
            let rings = std::mem::replace(count, names.len() as u32);
            names.extend((0..rings).map(|ring| [part as u32, ring]));
        }
        Some(Self { first, names })
    }

    /// The ring of an edge of the figure, unless it is an edge of a line or none at all.
    fn across(&self, edges: &[Edge], edge: Option<u32>) -> Option<u32> {
        let edge = &edges[edge? as usize];
        edge.on_ring
            .then(|| self.first[edge.source.part as usize] + edge.source.ring)
    }
}

/// The region of each triangle, and the state of each region.
struct Regions {
    of: Vec<u32>,
    states: Vec<u32>,
}

struct Nesting<'a> {
    vertices: &'a [[f64; 2]],
    edges: &'a [Edge],
    rings: Rings,
    /// The state from which each ring is entered.
    outer: Vec<u32>,
    /// Rings with a flaw already; one each is enough.
    flawed: Vec<bool>,
    flaws: &'a mut Vec<Flaw>,
}

impl Nesting<'_> {
    fn flood(&mut self, mesh: &mut Mesh) -> Regions {
        let mut regions = Regions {
            of: vec![UNKNOWN; mesh.corners.len()],
            states: vec![OUTSIDE],
        };
        // Triangles of the region at hand that are to be looked at.
        let mut open = Vec::new();
        // Triangles across a ring, with their states and whether they are inside.
        let mut beyond: Vec<(u32, u32, bool)> = Vec::new();
        for hull in &mesh.hull {
            let MeshEdge { edge, neighbour } = hull.across;
            if neighbour >= MeshEdge::HULL {
                // All vertices on one line: no triangles and no rings either.
                return regions;
            }
            match self.rings.across(self.edges, edge) {
                Some(ring) => beyond.push((neighbour, self.cross(OUTSIDE, ring, edge), true)),
                None if regions.of[neighbour as usize] == UNKNOWN => {
                    regions.of[neighbour as usize] = 0;
                    open.push(neighbour);
                }
                None => {}
            }
        }
        let mut region = 0;
        let mut inside = false;
        loop {
            let state = regions.states[region as usize];
            while let Some(triangle) = open.pop() {
                mesh.inside[triangle as usize] = inside;
                for MeshEdge { edge, neighbour } in mesh.across[triangle as usize] {
                    let unknown =
                        neighbour < MeshEdge::HULL && regions.of[neighbour as usize] == UNKNOWN;
                    match self.rings.across(self.edges, edge) {
                        Some(ring) => {
                            // Also where the other side is known: it must be known the same.
                            let next = self.cross(state, ring, edge);
                            if unknown {
                                beyond.push((neighbour, next, !inside));
                            }
                        }
                        None if unknown => {
                            regions.of[neighbour as usize] = region;
                            open.push(neighbour);
                        }
                        None => {}
                    }
                }
            }
            let Some((start, state, parity)) = beyond.pop() else {
                return regions;
            };
            if regions.of[start as usize] == UNKNOWN {
                region = regions.states.len() as u32;
                inside = parity;
                regions.states.push(state);
                regions.of[start as usize] = region;
                open.push(start);
            }
        }
    }

    /// The state across an edge of a ring.
    fn cross(&mut self, state: u32, ring: u32, edge: Option<u32>) -> u32 {
        let outer = &mut self.outer[ring as usize];
        let entered = ring + 1;
        if state == entered {
            return *outer;
        }
        if *outer == state {
            return entered;
        }
        let edge = edge.expect("rings are made of edges of the figure");
        if *outer == UNKNOWN {
            *outer = state;
            self.enter(state, ring, edge, false);
        } else {
            // The ring is entered from two states; each is wrong beside the other.
            let other = *outer;
            let around = if state == OUTSIDE { other } else { state };
            self.enter(around, ring, edge, true);
        }
        entered
    }

    /// Judges whether a ring may be entered from a state; if it certainly may not, the pair
    /// is flawed in any case.
    fn enter(&mut self, state: u32, ring: u32, edge: u32, certainly_not: bool) {
        let [part, number] = self.rings.names[ring as usize];
        let Edge { from, source, .. } = self.edges[edge as usize];
        let place = Place {
            part: source.part as usize,
            ring: source.ring as usize,
            index: source.edge as usize,
        };
        let point = self.vertices[from.index()];
        let around = (state != OUTSIDE).then(|| self.rings.names[state as usize - 1]);
        let (blamed, flaw) = match (around, number) {
            // A shell outside of everything.
            (None, 0) => return,
            // A hole where its shell is not.
            (None, _) => (ring, Flaw::HoleOutsideShell { hole: place, point }),
            // A hole directly in its shell, a shell in another polygon's hole.
            (Some([outer, 0]), 1..) if outer == part && !certainly_not => return,
            (Some([outer, (1..)]), 0) if outer != part && !certainly_not => return,
            (Some([outer, hole @ (1..)]), 1..) if outer == part => {
                let outer = Place {
                    part: part as usize,
                    ring: hole as usize,
                    index: 0,
                };
                (
                    ring,
                    Flaw::HoleInHole {
                        inner: place,
                        outer,
                        point,
                    },
                )
            }
            // A shell inside its own hole.
            (Some([outer, hole @ (1..)]), 0) if outer == part => {
                let hole = Place {
                    part: part as usize,
                    ring: hole as usize,
                    index: 0,
                };
                (state - 1, Flaw::HoleOutsideShell { hole, point })
            }
            (Some(_), 1..) => (ring, Flaw::HoleOutsideShell { hole: place, point }),
            (Some([other, _]), 0) => (
                ring,
                Flaw::ShellsOverlap {
                    ring: place,
                    other: other as usize,
                    point,
                },
            ),
        };
        if !std::mem::replace(&mut self.flawed[blamed as usize], true) {
            self.flaws.push(flaw);
        }
    }

    /// Reports every polygon whose inside is more than one region.
    fn connected(&mut self, mesh: &Mesh, regions: &Regions) {
        let mut pieces = vec![0_usize; self.rings.names.len() + 1];
        for &state in &regions.states {
            pieces[state as usize] += 1;
        }
        for (ring, &[part, number]) in self.rings.names.iter().enumerate() {
            let state = ring + 1;
            if number == 0 && pieces[state] > 1 && self.part_is_nested(part) {
                let places = self.touching(part, state as u32, mesh, regions);
                self.flaws.push(Flaw::InteriorDisconnected {
                    part: part as usize,
                    pieces: pieces[state],
                    places,
                });
            }
        }
    }

    fn part_is_nested(&self, part: u32) -> bool {
        let first = self.rings.first[part as usize] as usize;
        let mut rings = self.rings.names[first..].iter().zip(&self.flawed[first..]);
        rings
            .by_ref()
            .take_while(|([other, _], _)| *other == part)
            .all(|(_, flawed)| !flawed)
    }

    /// The vertices at which two regions of the same state touch.
    fn touching(
        &self,
        part: u32,
        state: u32,
        mesh: &Mesh,
        regions: &Regions,
    ) -> Vec<(Place, [f64; 2])> {
        let mut first_region = HashMap::new();
        let mut touching = HashMap::new();
        for (corners, &region) in mesh.corners.iter().zip(&regions.of) {
            if regions.states[region as usize] == state {
                for corner in corners {
                    if *first_region.entry(*corner).or_insert(region) != region {
                        touching.insert(*corner, ());
                    }
                }
            }
        }
        // The first parts of split edges come before the other parts and start where the
        // caller's edges start, so the first edge found gives the caller's name.
        let mut places = Vec::new();
        for Edge { from, source, .. } in self
            .edges
            .iter()
            .filter(|edge| edge.on_ring && edge.source.part == part)
        {
            if touching.remove(&(from.index() as u32)).is_some() {
                let place = Place {
                    part: part as usize,
                    ring: source.ring as usize,
                    index: source.edge as usize,
                };
                places.push((place, self.vertices[from.index()]));
            }
        }
        places.sort_unstable_by_key(|&(place, _)| place);
        places.truncate(InvalidFigure::MAX_PLACES);
        places
    }
}
