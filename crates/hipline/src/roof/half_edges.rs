//! Which directed edges a surface has, what lies beyond them, and the loops along its rim.
//!
//! No coordinate is read.

use super::mesh::edges;
use crate::topology::Sets;

/// A directed edge, with the cycle that it belongs to.
#[derive(Debug, Clone, Copy)]
struct HalfEdge {
    /// Start and end, in one number to sort by.
    key: u64,
    /// The corner after its end.
    next: u32,
    cycle: u32,
}

const fn key([a, b]: [u32; 2]) -> u64 {
    (a as u64) << 32 | b as u64
}

/// The directed edges of some cycles, sorted.
pub(super) struct HalfEdges(Vec<HalfEdge>);

/// A loop along the rim: each corner where the surface, as it is on the loop's left, passes by.
pub(super) struct Rim {
    /// The corners, the surface on the left.
    pub ring: Vec<u32>,
    /// A cycle that has one of the edges.
    pub cycle: usize,
}

impl HalfEdges {
    /// Of cycles, each with the number it is to be known by.
    pub fn new<'a>(cycles: impl IntoIterator<Item = (u32, &'a [u32])>) -> Self {
        let mut list = Vec::new();
        for (cycle, ring) in cycles {
            let after = ring.iter().skip(2).chain(ring.iter().take(2));
            list.extend(edges(ring).zip(after).map(|(edge, &next)| HalfEdge {
                key: key(edge),
                next,
                cycle,
            }));
        }
        list.sort_unstable_by_key(|h| (h.key, h.cycle));
        Self(list)
    }

    fn position(&self, edge: [u32; 2]) -> Option<usize> {
        self.0.binary_search_by_key(&key(edge), |h| h.key).ok()
    }

    /// The cycle with this directed edge.
    pub fn cycle(&self, edge: [u32; 2]) -> Option<usize> {
        Some(self.0[self.position(edge)?].cycle as usize)
    }

    /// The corners of triangles, three each, joined where triangles around a vertex hang together.
    /// The cycles are these triangles.
    pub fn fans(&self, triangles: &[[u32; 3]]) -> Sets {
        let corner = |t: usize, v: u32| {
            let k = triangles[t].iter().position(|&w| w == v);
            3 * t + k.expect("a corner of its triangle")
        };
        let mut fans = Sets::new(3 * triangles.len());
        for (t, triangle) in triangles.iter().enumerate() {
            for [a, b] in edges(triangle) {
                if let Some(other) = self.cycle([b, a]) {
                    fans.join(corner(t, a), corner(other, a));
                    fans.join(corner(t, b), corner(other, b));
                }
            }
        }
        fans
    }

    /// Two cycles that share a directed edge, if there are any: then this is no surface.
    pub fn conflict(&self) -> Option<([u32; 2], [usize; 2])> {
        let pair = self.0.windows(2).find(|pair| pair[0].key == pair[1].key)?;
        let edge = [(pair[0].key >> 32) as u32, pair[0].key as u32];
        Some((edge, [pair[0].cycle as usize, pair[1].cycle as usize]))
    }

    /// The edges with nothing beyond them, with their cycles.
    pub fn open(&self) -> impl Iterator<Item = ([u32; 2], usize)> {
        self.0.iter().filter_map(|h| {
            let (a, b) = ((h.key >> 32) as u32, h.key as u32);
            self.position([b, a])
                .is_none()
                .then_some(([a, b], h.cycle as usize))
        })
    }

    /// Pairs of cycles with a common edge.
    pub fn neighbours(&self) -> impl Iterator<Item = [usize; 2]> {
        self.0.iter().filter_map(|h| {
            let (a, b) = ((h.key >> 32) as u32, h.key as u32);
            let other = if a < b {
                self.position([b, a])?
            } else {
                return None;
            };
            Some([h.cycle, self.0[other].cycle].map(|c| c as usize))
        })
    }

    /// The loops along the rim. At a corner where several pass, each turns from cycle to cycle
    /// around it until it is at the rim again, so that it follows one sector of the surface.
    pub fn rims(&self) -> Vec<Rim> {
        let rim: Vec<([u32; 2], usize)> = self.open().collect();
        let mut is_done = vec![false; rim.len()];
        let find = |edge: [u32; 2]| rim.binary_search_by_key(&key(edge), |&(e, _)| key(e)).ok();
        let mut rims = Vec::new();
        for first in 0..rim.len() {
            let mut ring = Vec::new();
            let mut at = first;
            while !std::mem::replace(&mut is_done[at], true) {
                let [mut a, b] = rim[at].0;
                ring.push(a);
                // A rotation about b ends, at the latest, after all edges that there are.
                for _ in 0..self.0.len() {
                    let Some(i) = self.position([a, b]) else {
                        break;
                    };
                    let c = self.0[i].next;
                    if let Some(next) = find([b, c]) {
                        at = next;
                        break;
                    }
                    a = c;
                }
            }
            if !ring.is_empty() {
                rims.push(Rim {
                    ring,
                    cycle: rim[first].1,
                });
            }
        }
        rims
    }
}
