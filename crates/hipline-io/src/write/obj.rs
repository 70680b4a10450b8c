//! The roof as Wavefront OBJ.

use std::io::{self, Write};

use hipline::{
    Skeleton,
    topology::{FaceId, NodeId},
};

use super::{number::Number, window::place};
use crate::FeatureName;

/// Writes the roof over one skeleton: a vertex at height `time * slope` for every finite
/// node, and each bounded face as a polygon that is counterclockwise from above.
///
/// # Errors
/// Those of `w`.
pub fn obj(w: impl Write, skeleton: &Skeleton, slope: f64) -> io::Result<()> {
    ObjWriter::new(w, slope).push(None, skeleton)
}

/// Writes the roofs over several skeletons into one file.
#[derive(Debug)]
pub struct ObjWriter<W> {
    w: W,
    slope: f64,
    vertices: usize,
}

impl<W: Write> ObjWriter<W> {
    /// A writer of roofs that rise by `slope` in one unit of time.
    pub const fn new(w: W, slope: f64) -> Self {
        Self {
            w,
            slope,
            vertices: 0,
        }
    }

    /// Ends writing and gives the writer back.
    pub fn into_inner(self) -> W {
        self.w
    }

    /// Adds a roof, as an object of its own if it has a name.
    ///
    /// # Errors
    /// Those of the writer.
    pub fn push(&mut self, name: Option<&FeatureName>, skeleton: &Skeleton) -> io::Result<()> {
        if let Some(FeatureName { index, id }) = name {
            match id {
                // A name with a line break would break the file.
                Some(id) => writeln!(self.w, "o {}", id.replace(['\n', '\r'], " "))?,
                None => writeln!(self.w, "o feature_{index}")?,
            }
        }
        let mut numbers = vec![0; skeleton.nodes().len()];
        for (number, node) in numbers.iter_mut().zip(skeleton.nodes()) {
            if node.time.is_finite() {
                self.vertices += 1;
                *number = self.vertices;
                let height = node.time * self.slope;
                writeln!(
                    self.w,
                    "v {} {} {}",
                    Number(node.x),
                    Number(node.y),
                    Number(height)
                )?;
            }
        }
        for i in 0..skeleton.faces().len() {
            let corners = joined(skeleton, FaceId::new(i));
            if corners.len() < 3 || corners.iter().any(|&n| numbers[n.index()] == 0) {
                continue;
            }
            self.w.write_all(b"f")?;
            for corner in corners {
                write!(self.w, " {}", numbers[corner.index()])?;
            }
            self.w.write_all(b"\n")?;
        }
        Ok(())
    }
}

/// The boundary of a face as one cycle. OBJ knows no holes: each is joined to the cycle by
/// an edge there and back, the shortest one between their corners that crosses nothing.
fn joined(skeleton: &Skeleton, face: FaceId) -> Vec<NodeId> {
    let mut cycle = skeleton.boundary(face).to_vec();
    let mut holes: Vec<&[NodeId]> = skeleton
        .holes(face)
        .filter(|hole| !hole.is_empty())
        .collect();
    let at = |n: NodeId| place(skeleton.node(n));
    while !holes.is_empty() {
        let mut bridges: Vec<(f64, usize, usize, usize)> = Vec::new();
        for (h, hole) in holes.iter().enumerate() {
            for (i, &a) in cycle.iter().enumerate() {
                for (j, &b) in hole.iter().enumerate() {
                    let ([ax, ay], [bx, by]) = (at(a), at(b));
                    bridges.push(((ax - bx).hypot(ay - by), h, i, j));
                }
            }
        }
        bridges.sort_by(|a, b| a.0.total_cmp(&b.0));
        let is_free = |&&(_, h, i, j): &&(f64, usize, usize, usize)| {
            let bridge = [at(cycle[i]), at(holes[h][j])];
            let edges = |c: &[NodeId]| {
                (0..c.len())
                    .map(|k| [at(c[k]), at(c[(k + 1) % c.len()])])
                    .collect::<Vec<_>>()
            };
            std::iter::once(cycle.as_slice())
                .chain(holes.iter().copied())
                .all(|c| !edges(c).iter().any(|e| cross(bridge, *e)))
        };
        let Some(&(_, h, i, j)) = bridges.iter().find(is_free).or(bridges.first()) else {
            break;
        };
        let hole = holes.remove(h);
        let detour = hole[j..]
            .iter()
            .chain(&hole[..=j])
            .copied()
            .chain([cycle[i]]);
        cycle.splice(i + 1..i + 1, detour.collect::<Vec<_>>());
    }
    cycle
}

/// Whether two segments cross in the inside of both.
fn cross([a, b]: [[f64; 2]; 2], [c, d]: [[f64; 2]; 2]) -> bool {
    let turn = |p: [f64; 2], q: [f64; 2], r: [f64; 2]| {
        (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0])
    };
    turn(a, b, c) * turn(a, b, d) < 0.0 && turn(c, d, a) * turn(c, d, b) < 0.0
}
