//! The facets of a roof: from a skeleton, or from any list of planar facets, cut into triangles.

use super::{
    InvalidRoof, ears, mend,
    mesh::{Mesh, Surface},
    region,
};
use crate::topology::Sets;
use crate::{
    skeleton::{NodeKind, Skeleton},
    topology::{EdgeId, FaceId, NodeId},
};

/// How a skeleton is lifted.
pub(super) struct Lift<'a> {
    /// The height of the eaves.
    pub eaves: f64,
    /// How much the roof rises in one unit of time.
    pub slope: f64,
    /// Faces that rise on the line of their edge: gables.
    pub is_standing: &'a dyn Fn(FaceId) -> bool,
}

/// The facets over the bounded part of a skeleton, not cut.
pub(super) fn lifted(skeleton: &Skeleton, lift: &Lift) -> Result<Mesh, InvalidRoof> {
    let bounded = bounded_faces(skeleton);
    let mut mesh = Mesh::default();
    mesh.vertices.reserve(skeleton.nodes().len());
    let mut number = vec![u32::MAX; skeleton.nodes().len()];
    let mut corners: Vec<u32> = Vec::new();
    let mut ends: Vec<usize> = Vec::new();
    for face in (0..skeleton.faces().len()).map(FaceId::new) {
        // With weights, a face that was overrun at once has no area and two nodes.
        if !bounded[face.index()] || skeleton.boundary(face).len() < 3 {
            continue;
        }
        corners.clear();
        ends.clear();
        let rings = std::iter::once(skeleton.boundary(face)).chain(skeleton.holes(face));
        for ring in rings {
            for &node in ring {
                corners.push(vertex(skeleton, node, lift, &mut number, &mut mesh)?);
            }
            ends.push(corners.len());
        }
        let surface = if (lift.is_standing)(face) {
            Surface::Wall
        } else {
            Surface::Roof
        };
        let starts = std::iter::once(0).chain(ends.iter().copied());
        let rings = starts.zip(&ends).map(|(from, &to)| &corners[from..to]);
        mesh.push(surface, Some(skeleton.face(face).edge), rings, &[]);
    }
    if mesh.facets.is_empty() {
        return Err(InvalidRoof::Unbounded);
    }
    Ok(mesh)
}

fn vertex(
    skeleton: &Skeleton,
    node: NodeId,
    lift: &Lift,
    number: &mut [u32],
    mesh: &mut Mesh,
) -> Result<u32, InvalidRoof> {
    let slot = &mut number[node.index()];
    if *slot == u32::MAX {
        let node = skeleton.node(node);
        let height = lift.eaves + node.time * lift.slope;
        if !height.is_finite() {
            return Err(InvalidRoof::TooHigh {
                x: node.x,
                y: node.y,
            });
        }
        *slot = mesh.vertex([node.x, node.y, height]);
    }
    Ok(*slot)
}

/// For each face, whether its connected part of the plane is bounded.
fn bounded_faces(skeleton: &Skeleton) -> Vec<bool> {
    let count = skeleton.faces().len();
    let is_infinite = |node: NodeId| matches!(skeleton.node(node).kind, NodeKind::Infinite { .. });
    if !skeleton.arcs().iter().any(|arc| is_infinite(arc.nodes[1])) {
        return vec![true; count];
    }
    let mut sets = Sets::new(count);
    for arc in skeleton.arcs() {
        let [a, b] = arc.faces.map(FaceId::index);
        sets.join(a, b);
    }
    let mut bounded = vec![true; count];
    for arc in skeleton
        .arcs()
        .iter()
        .filter(|arc| is_infinite(arc.nodes[1]))
    {
        bounded[sets.root(arc.faces[0].index())] = false;
    }
    (0..count).map(|face| bounded[sets.root(face)]).collect()
}

/// Vertices, and triangles with their faces.
pub(crate) type Tiles = (Vec<[f64; 3]>, Vec<([u32; 3], FaceId)>);

/// Faces of a plan, lifted, in triangles of positive area in the plan, each with its face: by the
/// means of [`cut`]. `None` if rounding leaves no area.
pub(crate) fn tiled<'a, R>(
    vertices: Vec<[f64; 3]>,
    faces: impl Iterator<Item = (FaceId, R)>,
) -> Option<Tiles>
where
    R: Iterator<Item = &'a [NodeId]>,
{
    let mut mesh = Mesh {
        vertices,
        ..Mesh::default()
    };
    for (face, rings) in faces {
        let rings: Vec<Vec<u32>> = rings
            .map(|ring| ring.iter().map(|node| node.index() as u32).collect())
            .collect();
        // The faces stand for edges here: facets only hand them on.
        let name = Some(EdgeId::new(face.index()));
        mesh.push(Surface::Roof, name, rings.iter().map(Vec::as_slice), &[]);
    }
    let mesh = cut(mesh).ok()?;
    let mut triangles = Vec::with_capacity(mesh.triangles.len());
    for facet in &mesh.facets {
        let face = FaceId::new(facet.edge?.index());
        triangles.extend(mesh.triangles_of(facet).iter().map(|&t| (t, face)));
    }
    Some((mesh.vertices, triangles))
}

/// Cuts facets into triangles: those of the roof in the plan, upright ones in the plane of the
/// axis that they run along.
///
/// All triangles of the roof get a positive area in the plan. Where rounded corners do not allow
/// that, facets are changed by as much as rounding has changed them: see [`mend`].
pub(super) fn cut(facets: Mesh) -> Result<Mesh, InvalidRoof> {
    let mut mesh = Mesh {
        vertices: facets.vertices,
        ..Mesh::default()
    };
    let given = Mesh {
        vertices: Vec::new(),
        ..facets
    };
    let (mut triangles, mut is_spoilt) = (Vec::new(), false);
    let mut rings: Vec<&[u32]> = Vec::new();
    for facet in &given.facets {
        triangles.clear();
        rings.clear();
        rings.extend(given.rings(facet));
        let is_cut = match facet.surface {
            Surface::Wall => upright(&mesh, &rings, &mut triangles),
            _ => region::fill(&rings, &|v| mesh.plan(v), &mut triangles),
        };
        if !is_cut && facet.surface == Surface::Wall {
            let [x, y] = mesh.plan(rings[0][0]);
            return Err(InvalidRoof::Rounding { x, y });
        }
        if !is_cut {
            is_spoilt = true;
            break;
        }
        mesh.push(facet.surface, facet.edge, rings.iter().copied(), &triangles);
    }
    if is_spoilt {
        mended(Mesh {
            vertices: mesh.vertices,
            ..given
        })
    } else {
        Ok(mesh)
    }
}

fn mended(given: Mesh) -> Result<Mesh, InvalidRoof> {
    let is_sloped = |f: &usize| given.facets[*f].surface != Surface::Wall;
    let sloped: Vec<usize> = (0..given.facets.len()).filter(is_sloped).collect();
    let Some(tiles) = mend::tile(&given, &sloped) else {
        let [x, y, _] = given.vertices[0];
        return Err(InvalidRoof::Rounding { x, y });
    };
    let mut mesh = Mesh {
        vertices: given.vertices.clone(),
        ..Mesh::default()
    };
    for tile in tiles {
        tile.add_to(&mut mesh);
    }
    for facet in given.facets.iter().filter(|f| f.surface == Surface::Wall) {
        let rings: Vec<&[u32]> = given.rings(facet).collect();
        let mut triangles = Vec::new();
        if !upright(&mesh, &rings, &mut triangles) {
            let [x, y] = mesh.plan(rings[0][0]);
            return Err(InvalidRoof::Rounding { x, y });
        }
        mesh.push(facet.surface, facet.edge, rings, &triangles);
    }
    mesh.compact();
    Ok(mesh)
}

/// Cuts an upright facet: seen along the axis that its foot is farther from, its corners are
/// points with exact coordinates again.
fn upright(mesh: &Mesh, rings: &[&[u32]], triangles: &mut Vec<[u32; 3]>) -> bool {
    let at = |v: u32| mesh.vertices[v as usize];
    let extent = |axis: usize| {
        let all = || rings.iter().copied().flatten().map(|&v| at(v)[axis]);
        all().fold(f64::NEG_INFINITY, f64::max) - all().fold(f64::INFINITY, f64::min)
    };
    let axis = usize::from(extent(1) > extent(0));
    let seen = |sign: f64| move |v: u32| [sign * at(v)[axis], at(v)[2]];
    // Which of its two sides is outside, the sense of its boundary tells.
    let area = region::area(rings[0], &seen(1.0));
    let sign = if area < 0.0 { -1.0 } else { 1.0 };
    if let &[ring] = rings
        && ears::cut(ring, &seen(sign), triangles)
    {
        return true;
    }
    region::fill(rings, &seen(sign), triangles)
}

impl Mesh {
    /// Drops vertices that no facet has.
    pub(super) fn compact(&mut self) {
        let mut number = vec![u32::MAX; self.vertices.len()];
        let mut vertices = Vec::with_capacity(self.vertices.len());
        let corners = self.corners.iter_mut();
        for corner in corners.chain(self.triangles.iter_mut().flatten()) {
            let slot = &mut number[*corner as usize];
            if *slot == u32::MAX {
                *slot = vertices.len() as u32;
                vertices.push(self.vertices[*corner as usize]);
            }
            *corner = *slot;
        }
        self.vertices = vertices;
    }
}
