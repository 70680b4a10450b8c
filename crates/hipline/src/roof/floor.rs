//! The floor that closes a roof to a solid.

use super::{Mesh, MeshFace};
use std::collections::BTreeMap;

impl Mesh {
    /// Closes a roof with horizontal floors at its eaves, one for each connected part, which
    /// look downward.
    ///
    /// Where lines lie inside a polygon, or polygons share an edge, the roof comes down to
    /// height 0 there and touches the floor. A closed mesh is returned as it is.
    ///
    /// # Complexity
    /// O(n log n).
    #[must_use]
    pub fn with_base(mut self) -> Self {
        // After [a, b] along a face's boundary comes [b, next[[a, b]]].
        let mut next: BTreeMap<[u32; 2], (usize, u32)> = BTreeMap::new();
        for (i, face) in self.faces.iter().enumerate() {
            for cycle in face.cycles() {
                for k in 0..cycle.len() {
                    let [a, b, c] = [0, 1, 2].map(|d| cycle[(k + d) % cycle.len()]);
                    next.insert([a, b], (i, c));
                }
            }
        }
        let mut parents: Vec<usize> = (0..self.faces.len()).collect();
        for (&[a, b], &(face, _)) in &next {
            if let Some(&(other, _)) = next.get(&[b, a]) {
                let (u, v) = (root(&mut parents, face), root(&mut parents, other));
                parents[u.max(v)] = u.min(v);
            }
        }
        // Rings along the edges with nothing beyond them, the roof on the left.
        let mut open: BTreeMap<[u32; 2], bool> = next
            .keys()
            .filter(|&&[a, b]| !next.contains_key(&[b, a]))
            .map(|&edge| (edge, false))
            .collect();
        let starts: Vec<[u32; 2]> = open.keys().copied().collect();
        let mut rings: BTreeMap<usize, Vec<Vec<u32>>> = BTreeMap::new();
        for first in starts {
            let mut ring = Vec::new();
            let mut edge = first;
            while open.insert(edge, true) == Some(false) {
                ring.push(edge[0]);
                // Turn around the end of the edge, from facet to facet.
                let [mut a, b] = edge;
                loop {
                    let (_, c) = next[&[a, b]];
                    edge = [b, c];
                    if open.contains_key(&edge) {
                        break;
                    }
                    a = c;
                }
            }
            if !ring.is_empty() {
                let part = root(&mut parents, next[&first].0);
                rings.entry(part).or_default().push(ring);
            }
        }
        for (_, mut rings) in rings {
            for ring in &mut rings {
                ring.reverse();
            }
            let area = |ring: &Vec<u32>| {
                let face = MeshFace {
                    boundary: ring.clone(),
                    holes: Vec::new(),
                    face: None,
                };
                self.plan_area(&face)
            };
            // Seen from above the outer ring is clockwise now.
            let order = |&a: &usize, &b: &usize| area(&rings[a]).total_cmp(&area(&rings[b]));
            let shell = (0..rings.len()).min_by(order).expect("a part has a ring");
            let boundary = rings.swap_remove(shell);
            self.faces.push(MeshFace {
                boundary,
                holes: rings,
                face: None,
            });
        }
        self
    }
}

fn root(parents: &mut [usize], mut i: usize) -> usize {
    while parents[i] != i {
        parents[i] = parents[parents[i]];
        i = parents[i];
    }
    i
}
