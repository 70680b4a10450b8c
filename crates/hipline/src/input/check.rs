//! The invariants of a [`Mesh`], for debug builds and tests.

use super::{
    Edge, Mesh, MeshEdge,
    range::Scale,
    triangulate::{NONE, coord},
};

/// One side of an edge of the mesh: a side of a triangle, or a hull edge from the outside.
struct Side {
    from: u32,
    to: u32,
    /// The name by which the other side calls it: a triangle, or hull edge plus `HULL`.
    name: u32,
    across: MeshEdge,
}

impl Mesh {
    /// Checks everything that [`Mesh`] promises, by exact decisions.
    ///
    /// # Errors
    /// The first promise that is broken.
    pub(super) fn check(
        &self,
        vertices: &[[f64; 2]],
        edges: &[Edge],
        scale: Scale,
    ) -> Result<(), String> {
        let points: Vec<_> = vertices
            .iter()
            .map(|&point| coord(scale.apply(point)))
            .collect();
        for (t, corners) in self.corners.iter().enumerate() {
            let [a, b, c] = corners.map(|corner| points[corner as usize]);
            ensure(robust::orient2d(a, b, c) > 0.0, || {
                format!("triangle {t} is not counterclockwise")
            })?;
        }
        ensure(self.across.len() == self.corners.len(), || {
            "one triple of sides for each triangle".into()
        })?;
        ensure(self.inside.len() == self.corners.len(), || {
            "one flag for each triangle".into()
        })?;
        self.check_hull(&points)?;
        self.check_sides(edges)?;
        self.check_euler(vertices.len())?;
        self.check_inside(edges)
    }

    fn sides(&self) -> impl Iterator<Item = Side> + '_ {
        let inner =
            self.corners
                .iter()
                .zip(&self.across)
                .enumerate()
                .flat_map(|(t, (corners, across))| {
                    (0..3).map(move |k| Side {
                        from: corners[(k + 1) % 3],
                        to: corners[(k + 2) % 3],
                        name: t as u32,
                        across: across[k],
                    })
                });
        inner.chain(self.hull.iter().enumerate().map(|(h, edge)| Side {
            from: edge.from,
            to: edge.to,
            name: h as u32 + MeshEdge::HULL,
            across: edge.across,
        }))
    }

    /// The hull is closed, turns right only, and (so that it goes around once) turns from
    /// leftward to rightward once.
    fn check_hull(&self, points: &[robust::Coord<f64>]) -> Result<(), String> {
        ensure(self.hull.len() >= 2, || "there is a hull".into())?;
        let mut turns = 0;
        for (h, edge) in self.hull.iter().enumerate() {
            let next = &self.hull[(h + 1) % self.hull.len()];
            ensure(edge.to == next.from, || {
                format!("hull edge {h} ends where the next one starts")
            })?;
            let [a, b, c] = [edge.from, edge.to, next.to].map(|v| points[v as usize]);
            ensure(robust::orient2d(a, b, c) <= 0.0, || {
                format!("the hull turns left after hull edge {h}")
            })?;
            let rightward = |a: robust::Coord<f64>, b: robust::Coord<f64>| (a.x, a.y) < (b.x, b.y);
            turns += usize::from(!rightward(a, b) && rightward(b, c));
        }
        ensure(turns == 1, || format!("the hull goes around {turns} times"))
    }

    /// The two sides of every edge name each other, and the figure's edge between them has
    /// their ends; every edge of the figure is there.
    fn check_sides(&self, edges: &[Edge]) -> Result<(), String> {
        let mut sides: Vec<Side> = self.sides().collect();
        sides.sort_unstable_by_key(|side| {
            (side.from.min(side.to), side.from.max(side.to), side.from)
        });
        ensure(sides.len().is_multiple_of(2), || {
            "sides come in pairs".into()
        })?;
        let mut seen = vec![false; edges.len()];
        for pair in sides.chunks_exact(2) {
            let [one, other] = pair else { continue };
            let label = || format!("the edge {} -> {}", one.from, one.to);
            ensure(one.from == other.to && one.to == other.from, || {
                format!("{} has two sides", label())
            })?;
            let mutual = one.across.neighbour == other.name && other.across.neighbour == one.name;
            ensure(mutual, || {
                format!("the sides of {} name each other", label())
            })?;
            ensure(one.across.edge == other.across.edge, || {
                format!("the sides of {} agree on the figure", label())
            })?;
            if let Some(index) = one.across.edge {
                let edge = edges[index as usize];
                let ends = [edge.from, edge.to].map(|end| end.index() as u32);
                let fits = ends == [one.from, one.to] || ends == [one.to, one.from];
                ensure(fits, || format!("{} is the figure's edge {index}", label()))?;
                ensure(!std::mem::replace(&mut seen[index as usize], true), || {
                    format!("edge {index} is there twice")
                })?;
            }
        }
        match seen.iter().position(|&seen| !seen) {
            Some(index) => Err(format!("edge {index} of the figure is not in the mesh")),
            None => Ok(()),
        }
    }

    /// Every vertex is used, and V - E + F = 2 with the outer face.
    fn check_euler(&self, vertices: usize) -> Result<(), String> {
        let mut used = vec![false; vertices];
        for side in self.sides() {
            used[side.from as usize] = true;
        }
        ensure(used.iter().all(|&used| used), || {
            "every vertex is in the mesh".into()
        })?;
        let edges = (3 * self.corners.len() + self.hull.len()) / 2;
        let faces = self.corners.len() + 1;
        ensure(vertices + faces == edges + 2, || {
            format!("Euler: {vertices} - {edges} + {faces} is not 2")
        })
    }

    /// Inside and outside change across the edges of rings and nowhere else.
    fn check_inside(&self, edges: &[Edge]) -> Result<(), String> {
        let inside = |name: u32| name < MeshEdge::HULL && self.inside[name as usize];
        for side in self.sides() {
            let ring = side
                .across
                .edge
                .is_some_and(|edge| edge != NONE && edges[edge as usize].on_ring);
            let changes = inside(side.name) != inside(side.across.neighbour);
            ensure(ring == changes, || {
                format!("inside and outside at {} -> {}", side.from, side.to)
            })?;
        }
        Ok(())
    }
}

fn ensure(holds: bool, message: impl FnOnce() -> String) -> Result<(), String> {
    if holds { Ok(()) } else { Err(message()) }
}
