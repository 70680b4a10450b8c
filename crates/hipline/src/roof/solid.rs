//! Walls, floor and soffit: what makes a roof a solid.
//!
//! Everything hangs on the rim of the roof. Below it, straight down to the floor, are the walls;
//! or, under an overhang, the soffit reaches from the rim to the tops of walls farther in.

use super::{
    InvalidRoof,
    half_edges::HalfEdges,
    mesh::{Mesh, Surface, edges},
    region::{self, Part, parts},
};
use crate::{input::Figure, topology::EdgeId};

/// What to add to a roof.
#[derive(Clone, Copy)]
pub(super) struct Base {
    /// The height of the floor.
    pub ground: f64,
    pub walls: bool,
    pub floor: bool,
}

/// Closes a roof, whose rim is level, by walls below its rim and floors between them.
pub(super) fn close(mesh: &mut Mesh, base: Base) -> Result<(), InvalidRoof> {
    let table = HalfEdges::new(mesh.cycles());
    let parts = parts(mesh.facets.len(), &table, |ring| {
        region::area(ring, &|v| mesh.plan(v))
    });
    let Some(&first) = parts.first().and_then(|part| part.rings.first()?.first()) else {
        return Ok(());
    };
    let rim = mesh.vertices[first as usize][2];
    let edge_of = |mesh: &Mesh, edge| table.cycle(edge).and_then(|f| mesh.facets[f].edge);
    if rim <= base.ground && base.floor {
        only_rim_touches(mesh, &parts, base.ground)?;
    }
    for part in &parts {
        stand(mesh, part, base, &edge_of)?;
    }
    Ok(())
}

/// Walls under the rings of a part, whose vertices are their tops, and the floor.
fn stand(
    mesh: &mut Mesh,
    part: &Part,
    base: Base,
    edge_of: &impl Fn(&Mesh, [u32; 2]) -> Option<EdgeId>,
) -> Result<(), InvalidRoof> {
    let rings: Vec<&[u32]> = part.rings.iter().map(Vec::as_slice).collect();
    let Some(&first) = rings.first().and_then(|ring| ring.first()) else {
        return Ok(());
    };
    let has_walls = base.walls && mesh.vertices[first as usize][2] > base.ground;
    let mut floor = Vec::new();
    if (base.floor || has_walls) && !region::fill(&rings, &|v| mesh.plan(v), &mut floor) {
        let [x, y] = mesh.plan(first);
        return Err(InvalidRoof::Rounding { x, y });
    }
    // The feet of the walls: one for each time that a ring passes by, so that walls which touch
    // along a vertical line do not share it.
    let mut feet: Vec<Vec<u32>> = part.rings.clone();
    if has_walls {
        for foot in feet.iter_mut().flatten() {
            let [x, y] = mesh.plan(*foot);
            *foot = mesh.vertex([x, y, base.ground]);
        }
        for (ring, feet) in rings.iter().zip(&feet) {
            for (k, [a, b]) in edges(ring).enumerate() {
                let [c, d] = [feet[k], feet[(k + 1) % feet.len()]];
                let wall = [c, d, b, a];
                let edge = edge_of(mesh, [a, b]);
                mesh.push(Surface::Wall, edge, [&wall[..]], &[[c, d, b], [c, b, a]]);
            }
        }
        rename(&mut floor, &rings, &feet, mesh.vertices.len());
    }
    if base.floor {
        floor.iter_mut().for_each(|triangle| triangle.reverse());
        feet.iter_mut().for_each(|ring| ring.reverse());
        mesh.push(
            Surface::Ground,
            None,
            feet.iter().map(Vec::as_slice),
            &floor,
        );
    }
    Ok(())
}

/// Gives the corners of triangles the names of the feet below them.
fn rename(triangles: &mut [[u32; 3]], rings: &[&[u32]], feet: &[Vec<u32>], count: usize) {
    let mut names = vec![u32::MAX; count];
    let mut is_pinched = false;
    let pairs = || {
        rings
            .iter()
            .zip(feet)
            .flat_map(|(ring, feet)| ring.iter().zip(feet))
    };
    for (&top, &foot) in pairs() {
        is_pinched |= names[top as usize] != u32::MAX;
        names[top as usize] = foot;
    }
    if !is_pinched {
        for corner in triangles.iter_mut().flatten() {
            *corner = names[*corner as usize];
        }
        return;
    }
    // A ring passes a corner along one sector: the triangles from the edge that leaves it around to
    // the one that arrives.
    let old = triangles.to_vec();
    let table = HalfEdges::new(old.iter().enumerate().map(|(t, tri)| (t as u32, &tri[..])));
    for (ring, feet) in rings.iter().zip(feet) {
        for ([at, mut next], &foot) in edges(ring).zip(feet) {
            while let Some(t) = table.cycle([at, next]) {
                let k = (0..3)
                    .find(|&k| old[t][k] == at)
                    .expect("a corner of its triangle");
                triangles[t][k] = foot;
                next = old[t][(k + 2) % 3];
            }
        }
    }
}

/// Without walls the roof stands on the floor: with its rim, and with nothing else.
fn only_rim_touches(mesh: &Mesh, parts: &[Part], ground: f64) -> Result<(), InvalidRoof> {
    let mut is_rim = vec![false; mesh.vertices.len()];
    for &v in parts.iter().flat_map(|part| part.rings.iter().flatten()) {
        is_rim[v as usize] = true;
    }
    match mesh
        .corners
        .iter()
        .find(|&&v| !is_rim[v as usize] && mesh.vertices[v as usize][2] <= ground)
    {
        Some(&v) => {
            let [x, y] = mesh.plan(v);
            Err(InvalidRoof::TouchesFloor { x, y })
        }
        None => Ok(()),
    }
}

/// Level facets on a figure's polygons, at a height: flat roofs.
pub(super) fn level(figure: &Figure, height: f64) -> Result<Mesh, InvalidRoof> {
    let (mut mesh, parts) = footprint(figure, height)?;
    let table = edge_table(figure);
    for part in &parts {
        let rings: Vec<&[u32]> = part.rings.iter().map(Vec::as_slice).collect();
        let mut triangles = Vec::new();
        if !region::fill(&rings, &|v| mesh.plan(v), &mut triangles) {
            let [x, y] = mesh.plan(rings[0][0]);
            return Err(InvalidRoof::Rounding { x, y });
        }
        let edge = edges(rings[0]).next().and_then(|edge| find(&table, edge));
        mesh.push(Surface::Roof, edge, rings, &triangles);
    }
    Ok(mesh)
}

/// Closes a roof that reaches beyond its footprint.
pub(super) fn close_overhang(
    mesh: &mut Mesh,
    figure: &Figure,
    base: Base,
    overhang: f64,
) -> Result<(), InvalidRoof> {
    let outline = HalfEdges::new(mesh.cycles());
    let outer: Vec<Vec<u32>> = outline.rims().into_iter().map(|rim| rim.ring).collect();
    let Some(&first) = outer.first().and_then(|ring| ring.first()) else {
        return Ok(());
    };
    let height = mesh.vertices[first as usize][2];
    if height < base.ground {
        return Err(InvalidRoof::BelowFloor {
            eaves: height,
            ground: base.ground,
        });
    }
    // The soffit is level, so nothing else may be as low as the rim.
    let mut is_rim = vec![false; mesh.vertices.len()];
    for &v in outer.iter().flatten() {
        is_rim[v as usize] = true;
    }
    let is_low = |v: &&u32| !is_rim[**v as usize] && mesh.vertices[**v as usize][2] <= height;
    if let Some(&v) = mesh.corners.iter().find(is_low) {
        let [x, y] = mesh.plan(v);
        return Err(InvalidRoof::Rounding { x, y });
    }
    // The tops of the walls, after the vertices that there are.
    let (tops, mut parts) = footprint(figure, height)?;
    let before = mesh.vertices.len() as u32;
    mesh.vertices.extend(&tops.vertices);
    for corner in parts.iter_mut().flat_map(|p| &mut p.rings).flatten() {
        *corner += before;
    }
    let walls = parts.iter().flat_map(|p| &p.rings);
    let inner: Vec<Vec<u32>> = walls
        .map(|ring| ring.iter().rev().copied().collect())
        .collect();
    let rings: Vec<&[u32]> = outer.iter().chain(&inner).map(Vec::as_slice).collect();
    let mut triangles = Vec::new();
    if !region::fill(&rings, &|v| mesh.plan(v), &mut triangles) {
        return Err(InvalidRoof::Overhang(overhang));
    }
    let table = HalfEdges::new(
        triangles
            .iter()
            .enumerate()
            .map(|(t, tri)| (t as u32, &tri[..])),
    );
    let area = |mesh: &Mesh, ring: &[u32]| region::area(ring, &|v| mesh.plan(v));
    for soffit in region::parts(triangles.len(), &table, |ring| area(mesh, ring)) {
        let is_outer = |v: &u32| *v < before;
        if !soffit.rings.iter().flatten().any(is_outer) {
            let [x, y] = mesh.plan(soffit.rings[0][0]);
            return Err(InvalidRoof::CourtyardClosed { x, y });
        }
        let reversed = |ring: &Vec<u32>| ring.iter().rev().copied().collect::<Vec<u32>>();
        let rings: Vec<Vec<u32>> = soffit.rings.iter().map(reversed).collect();
        let turned = |&t: &usize| {
            let [a, b, c] = triangles[t];
            [a, c, b]
        };
        let list: Vec<[u32; 3]> = soffit.cycles.iter().map(turned).collect();
        mesh.push(
            Surface::Soffit,
            None,
            rings.iter().map(Vec::as_slice),
            &list,
        );
    }
    let names = edge_table(figure);
    let edge_of = |_: &Mesh, edge: [u32; 2]| find(&names, edge.map(|v| v - before));
    for part in &parts {
        stand(mesh, part, base, &edge_of)?;
    }
    Ok(())
}

/// The edges of a figure by their ends, sorted.
fn edge_table(figure: &Figure) -> Vec<([u32; 2], EdgeId)> {
    let mut table: Vec<([u32; 2], EdgeId)> = figure
        .edges()
        .iter()
        .enumerate()
        .map(|(i, edge)| {
            let [a, b] = [edge.from, edge.to].map(|v| v.index() as u32);
            ([a.min(b), a.max(b)], EdgeId::new(i))
        })
        .collect();
    table.sort_unstable();
    table
}

fn find(table: &[([u32; 2], EdgeId)], [a, b]: [u32; 2]) -> Option<EdgeId> {
    let key = [a.min(b), a.max(b)];
    let i = table.binary_search_by_key(&key, |entry| entry.0).ok()?;
    Some(table[i].1)
}

/// The inside of a figure's polygons: its vertices at a height, and the parts with their rings.
fn footprint(figure: &Figure, height: f64) -> Result<(Mesh, Vec<Part>), InvalidRoof> {
    if !figure.has_polygon() {
        return Err(InvalidRoof::NotPolygons);
    }
    let triangulation = figure.mesh();
    let inside: Vec<[u32; 3]> = triangulation
        .corners
        .iter()
        .zip(&triangulation.inside)
        .filter_map(|(corners, is_inside)| is_inside.then_some(*corners))
        .collect();
    let mesh = Mesh {
        vertices: figure
            .vertices()
            .iter()
            .map(|&[x, y]| [x, y, height])
            .collect(),
        ..Mesh::default()
    };
    let table = HalfEdges::new(
        inside
            .iter()
            .enumerate()
            .map(|(t, tri)| (t as u32, &tri[..])),
    );
    let parts = parts(inside.len(), &table, |ring| {
        region::area(ring, &|v| mesh.plan(v))
    });
    Ok((mesh, parts))
}

impl Mesh {
    /// All rings, each with the number of its facet.
    pub(super) fn cycles(&self) -> impl Iterator<Item = (u32, &[u32])> {
        let with_number = |(i, facet)| self.rings(facet).map(move |ring| (i as u32, ring));
        self.facets.iter().enumerate().flat_map(with_number)
    }

    /// Gives each fan of triangles around a vertex a vertex of its own, so that parts of a solid
    /// which touch in a point do not share it. Of a closed mesh.
    ///
    /// Only where a footprint touches itself is there anything to do.
    pub(super) fn split_fans(&mut self) {
        let all = self
            .triangles
            .iter()
            .enumerate()
            .map(|(t, tri)| (t as u32, &tri[..]));
        let table = HalfEdges::new(all);
        let mut sets = table.fans(&self.triangles);
        // The first fan around a vertex keeps it.
        let mut owner = vec![usize::MAX; self.vertices.len()];
        let mut names = vec![u32::MAX; 3 * self.triangles.len()];
        for i in 0..names.len() {
            let (root, v) = (sets.root(i), self.triangles[i / 3][i % 3]);
            if root == i {
                let is_first = owner[v as usize] == usize::MAX;
                owner[v as usize] = root;
                names[i] = if is_first {
                    v
                } else {
                    self.vertices.push(self.vertices[v as usize]);
                    self.vertices.len() as u32 - 1
                };
            } else {
                names[i] = names[root];
            }
        }
        let mut renamed = self.corners.clone();
        for ring in self.ends.windows(2) {
            let range = ring[0] as usize..ring[1] as usize;
            for ([a, b], new) in edges(&self.corners[range.clone()]).zip(&mut renamed[range]) {
                if let Some(t) = table.cycle([a, b]) {
                    *new = names[3 * t + (0..3).find(|&k| self.triangles[t][k] == a).expect("it")];
                }
            }
        }
        self.corners = renamed;
        for (i, &name) in names.iter().enumerate() {
            self.triangles[i / 3][i % 3] = name;
        }
    }
}
