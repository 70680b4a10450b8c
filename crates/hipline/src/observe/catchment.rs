//! What drains where: areas and outlines of faces, river systems, or any other groups of faces.
//!
//! Rain that falls on a face ends on the face's edge (Lemma 6 of Aichholzer and Aurenhammer 1996;
//! with weights it may cross into another face on its way), so the face is the catchment of
//! that side of the edge, and a river system has those of all its edges.

use super::{Terrain, Window, terrain::Sum};
use crate::{
    input::Figure,
    topology::{FaceId, Sets},
};
use std::collections::BTreeMap;

/// The connected components of a figure: river systems.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Systems {
    of_edges: Vec<usize>,
    count: usize,
}

impl Systems {
    /// The components, numbered by their first edges.
    ///
    /// # Complexity
    /// Nearly linear.
    #[must_use]
    pub fn new(figure: &Figure) -> Self {
        let mut sets = Sets::new(figure.vertices().len());
        for edge in figure.edges() {
            sets.join(edge.from.index(), edge.to.index());
        }
        let mut numbers = BTreeMap::new();
        let mut of_edges = Vec::with_capacity(figure.edges().len());
        for edge in figure.edges() {
            let root = sets.root(edge.from.index());
            let next = numbers.len();
            of_edges.push(*numbers.entry(root).or_insert(next));
        }
        Self {
            of_edges,
            count: numbers.len(),
        }
    }

    /// The number of components.
    #[must_use]
    pub const fn count(&self) -> usize {
        self.count
    }

    /// For each edge, its component.
    #[must_use]
    pub fn of_edges(&self) -> &[usize] {
        &self.of_edges
    }
}

/// What of a window drains into one thing.
#[derive(Debug, Clone, PartialEq)]
pub struct Catchment {
    /// What it drains into: the key that its faces were given.
    pub key: usize,
    /// The area in the plan, in square input units: compensated sums of rounded triangles.
    pub area: f64,
    /// Whether it goes on beyond the window.
    pub is_cut: bool,
    /// Its outline: polygons, each a shell, counterclockwise, and its holes. First points are not
    /// repeated.
    pub polygons: Vec<Vec<Vec<[f64; 2]>>>,
}

/// What is known of a catchment so far.
#[derive(Default)]
struct Found {
    area: Sum,
    is_cut: bool,
    /// The rings around each connected part, by its first triangle.
    parts: BTreeMap<usize, Vec<Vec<u32>>>,
}

impl Terrain {
    /// The catchments of groups of faces, ordered by the keys that they are given.
    ///
    /// # Complexity
    /// O(n log n) in the number of triangles.
    #[must_use]
    pub fn catchments(&self, key: impl Fn(FaceId) -> usize) -> Vec<Catchment> {
        let keys: Vec<usize> = self.triangles().iter().map(|t| key(t.face)).collect();
        let outlines = Outlines::new(self, &keys);
        let mut found: BTreeMap<usize, Found> = BTreeMap::new();
        for (triangle, &key) in self.triangles().iter().zip(&keys) {
            found
                .entry(key)
                .or_default()
                .area
                .add(self.plan_area(triangle));
        }
        for (part, ring) in outlines.rings() {
            let one = found.entry(keys[part]).or_default();
            one.is_cut |= self.is_cut(&ring);
            one.parts.entry(part).or_default().push(ring);
        }
        let catchment = |(key, one): (usize, Found)| Catchment {
            key,
            area: one.area.total(),
            is_cut: one.is_cut,
            polygons: one
                .parts
                .into_values()
                .map(|rings| self.polygon(&rings))
                .collect(),
        };
        found.into_iter().map(catchment).collect()
    }

    fn points(&self, ring: &[u32]) -> Vec<[f64; 2]> {
        let point = |&v: &u32| {
            let [x, y, _] = self.vertices()[v as usize];
            [x, y]
        };
        ring.iter().map(point).collect()
    }

    /// Whether an edge of a ring lies on the border of the window.
    fn is_cut(&self, ring: &[u32]) -> bool {
        let window: Window = self.window();
        let limits = [window.min(), window.max()];
        let points = self.points(ring);
        (0..points.len()).any(|i| {
            let (p, q) = (points[i], points[(i + 1) % points.len()]);
            let is_at = |axis: usize, limit: [f64; 2]| {
                [p, q]
                    .iter()
                    .all(|x| x[axis].total_cmp(&limit[axis]).is_eq())
            };
            limits.iter().any(|&l| is_at(0, l) || is_at(1, l))
        })
    }

    /// The rings around one connected part: the largest one is the shell.
    fn polygon(&self, rings: &[Vec<u32>]) -> Vec<Vec<[f64; 2]>> {
        let mut rings: Vec<Vec<[f64; 2]>> = rings.iter().map(|r| self.points(r)).collect();
        let area = |ring: &Vec<[f64; 2]>| {
            let [x0, y0] = ring[0];
            let next = ring.iter().skip(1).chain(ring.first());
            let terms = ring
                .iter()
                .zip(next)
                .map(|(p, q)| (p[0] - x0) * (q[1] - y0) - (q[0] - x0) * (p[1] - y0));
            terms.sum::<f64>()
        };
        rings.sort_by(|a, b| area(b).total_cmp(&area(a)));
        rings
    }
}

/// The edges of triangles, to go around groups of them.
struct Outlines<'a> {
    terrain: &'a Terrain,
    keys: &'a [usize],
    /// The triangle on the left of each directed edge.
    left: BTreeMap<[u32; 2], u32>,
    sets: Sets,
}

impl<'a> Outlines<'a> {
    fn new(terrain: &'a Terrain, keys: &'a [usize]) -> Self {
        let mut left = BTreeMap::new();
        for (i, triangle) in terrain.triangles().iter().enumerate() {
            let [a, b, c] = triangle.corners;
            for edge in [[a, b], [b, c], [c, a]] {
                left.insert(edge, i as u32);
            }
        }
        let mut sets = Sets::new(keys.len());
        for (&[a, b], &i) in &left {
            if let Some(&j) = left.get(&[b, a])
                && keys[i as usize] == keys[j as usize]
            {
                sets.join(i as usize, j as usize);
            }
        }
        Self {
            terrain,
            keys,
            left,
            sets,
        }
    }

    /// Whether the group ends at an edge of one of its triangles.
    fn is_border(&self, [a, b]: [u32; 2], triangle: u32) -> bool {
        self.left
            .get(&[b, a])
            .is_none_or(|&other| self.keys[other as usize] != self.keys[triangle as usize])
    }

    /// The rings around the groups, each with the first triangle of its connected part.
    fn rings(mut self) -> Vec<(usize, Vec<u32>)> {
        let mut rings = Vec::new();
        let mut done: BTreeMap<[u32; 2], bool> = BTreeMap::new();
        let all: Vec<([u32; 2], u32)> = self.left.iter().map(|(&e, &t)| (e, t)).collect();
        for (first, triangle) in all {
            if done.contains_key(&first) || !self.is_border(first, triangle) {
                continue;
            }
            let part = self.sets.root(triangle as usize);
            let mut ring = Vec::new();
            let (mut edge, mut triangle) = (first, triangle);
            while done.insert(edge, true).is_none() {
                ring.push(edge[0]);
                // Turn around the end of the edge, from triangle to triangle.
                loop {
                    let corners = self.terrain.triangles()[triangle as usize].corners;
                    let at = corners.iter().position(|&v| v == edge[1]).unwrap_or(0);
                    edge = [corners[at], corners[(at + 1) % 3]];
                    if self.is_border(edge, triangle) {
                        break;
                    }
                    // Enter the neighbour by the same edge, from its other side.
                    triangle = self.left[&[edge[1], edge[0]]];
                    edge = [edge[1], edge[0]];
                }
            }
            rings.push((part, ring));
        }
        rings
    }
}
