//! The planes of an input, and which wavefront edge follows which at the start.

use std::cmp::Ordering;

use dashu_int::IBig;
use dashu_int::ops::Gcd;
use hipline::skeleton::Side;

use super::graph::Graph;
use super::number::{Field, Num};

/// An integer vector.
pub(super) type Vector = [IBig; 2];

/// `u x v`.
pub(super) fn cross(u: &Vector, v: &Vector) -> IBig {
    &u[0] * &v[1] - &u[1] * &v[0]
}

/// `u . v`.
pub(super) fn dot(u: &Vector, v: &Vector) -> IBig {
    &u[0] * &v[0] + &u[1] * &v[1]
}

/// The face of one side of an edge (or of a terminal) and its plane.
///
/// The plane is `normal . (x, y) = level + rate * t` in scaled units; the unswept side is where
/// the left hand side is greater.
#[derive(Debug)]
pub(super) struct Face {
    /// Which edge.
    pub edge: usize,
    /// Which side of it.
    pub side: Side,
    /// Where its wavefront edge starts and ends at first (vertices).
    pub ends: [usize; 2],
    /// The direction of the wavefront edge, the unswept side on its left.
    pub direction: Vector,
    /// Its normal, towards the unswept side.
    pub normal: Vector,
    /// The constant of the plane.
    pub level: IBig,
    /// Speed times length of the normal.
    pub rate: Num,
    /// Speed, scaled to an integer.
    pub speed: IBig,
}

/// The input in exact integers.
#[derive(Debug)]
pub(super) struct Model {
    pub field: Field,
    pub faces: Vec<Face>,
    /// `next[f]`: the face whose wavefront edge follows that of `f` at time 0.
    pub next: Vec<usize>,
    /// Whether the wavefront edge starts inside the polygons.
    pub inside: Vec<bool>,
    /// The vertices, scaled to integers.
    pub points: Vec<Vector>,
    /// A coordinate is its integer times 2^-this.
    pub place_bits: i64,
    /// A speed is its integer times 2^-this.
    pub speed_bits: i64,
}

impl Model {
    /// Sets up planes and chains.
    pub(super) fn new(graph: &Graph) -> Self {
        let place_bits = common_bits(graph.vertices.iter().flatten().copied());
        let speed_bits = common_bits(graph.edges.iter().flat_map(|edge| edge.speeds));
        let points: Vec<Vector> = graph
            .vertices
            .iter()
            .map(|p| p.map(|x| scaled(x, place_bits)))
            .collect();
        let mut faces = Vec::new();
        let mut degree = vec![0; points.len()];
        for edge in &graph.edges {
            for end in edge.ends {
                degree[end] += 1;
            }
        }
        for (index, edge) in graph.edges.iter().enumerate() {
            let [p, q] = edge.ends;
            let [left, right] = edge.speeds.map(|speed| scaled(speed, speed_bits));
            let along: Vector = [0, 1].map(|k| &points[q][k] - &points[p][k]);
            let back = along.clone().map(|x| -x);
            let cap = if left > right {
                left.clone()
            } else {
                right.clone()
            };
            faces.push(face(
                index,
                Side::Left,
                [p, q],
                along.clone(),
                left,
                &points,
            ));
            faces.push(face(
                index,
                Side::Right,
                [q, p],
                back.clone(),
                right,
                &points,
            ));
            // A cap's normal points away from the segment, so it runs a quarter turn right of that.
            if degree[p] == 1 {
                let direction = [back[1].clone(), -&back[0]];
                faces.push(face(
                    index,
                    Side::Start,
                    [p, p],
                    direction,
                    cap.clone(),
                    &points,
                ));
            }
            if degree[q] == 1 {
                let direction = [along[1].clone(), -&along[0]];
                faces.push(face(index, Side::End, [q, q], direction, cap, &points));
            }
        }
        let squares: Vec<IBig> = faces.iter().map(|f| dot(&f.normal, &f.normal)).collect();
        let field = Field::new(&squares);
        for (face, square) in faces.iter_mut().zip(&squares) {
            face.rate = field.root(square).times(&face.speed);
        }
        let next = chains(&faces, points.len());
        let inside = inside(graph, &points, &faces, &next);
        Self {
            field,
            faces,
            next,
            inside,
            points,
            place_bits,
            speed_bits,
        }
    }
}

/// A face without its rate.
fn face(
    edge: usize,
    side: Side,
    ends: [usize; 2],
    direction: Vector,
    speed: IBig,
    points: &[Vector],
) -> Face {
    let gcd = IBig::from((&direction[0]).gcd(&direction[1]));
    let direction = direction.map(|x| x / &gcd);
    let normal = [-&direction[1], direction[0].clone()];
    let level = dot(&normal, &points[ends[0]]);
    Face {
        edge,
        side,
        ends,
        direction,
        normal,
        level,
        rate: Num::default(),
        speed,
    }
}

/// The least `k` for which all numbers times `2^k` are integers.
fn common_bits(numbers: impl Iterator<Item = f64>) -> i64 {
    numbers
        .filter_map(|x| decode(x).map(|(_, exponent)| -exponent))
        .max()
        .unwrap_or(0)
}

/// The odd integer `m` and the exponent of `x = m * 2^exponent`; `None` for zero.
fn decode(x: f64) -> Option<(i64, i64)> {
    assert!(x.is_finite(), "the input is finite");
    let bits = x.to_bits();
    let (raw, fraction) = ((bits >> 52 & 0x7ff) as i64, (bits & ((1 << 52) - 1)) as i64);
    let (mantissa, exponent) = if raw == 0 {
        (fraction, -1074)
    } else {
        (fraction | 1 << 52, raw - 1075)
    };
    if mantissa == 0 {
        return None;
    }
    let zeros = i64::from(mantissa.trailing_zeros());
    let mantissa = mantissa >> zeros;
    Some((
        if bits >> 63 == 1 { -mantissa } else { mantissa },
        exponent + zeros,
    ))
}

/// `x * 2^bits`, which is an integer.
fn scaled(x: f64, bits: i64) -> IBig {
    decode(x).map_or(IBig::ZERO, |(mantissa, exponent)| {
        IBig::from(mantissa) << (exponent + bits) as usize
    })
}

/// Counterclockwise order of directions around a point, from the positive x axis.
pub(super) fn around(u: &Vector, v: &Vector) -> Ordering {
    let lower = |w: &Vector| w[1] < IBig::ZERO || (w[1] == IBig::ZERO && w[0] < IBig::ZERO);
    lower(u)
        .cmp(&lower(v))
        .then_with(|| IBig::ZERO.cmp(&cross(u, v)))
}

/// At each vertex: sorts the sides by angle, and links what bounds the same sector.
fn chains(faces: &[Face], vertices: usize) -> Vec<usize> {
    let mut next = vec![usize::MAX; faces.len()];
    let is_cap = |f: usize| matches!(faces[f].side, Side::Start | Side::End);
    for vertex in 0..vertices {
        let mut leaving: Vec<usize> = (0..faces.len())
            .filter(|&f| !is_cap(f) && faces[f].ends[0] == vertex)
            .collect();
        leaving.sort_by(|&f, &g| around(&faces[f].direction, &faces[g].direction));
        for (i, &out) in leaving.iter().enumerate() {
            // The sector on the left of `out` ends at the next edge, whose other side arrives.
            let neighbour = &faces[leaving[(i + 1) % leaving.len()]];
            let arriving = (0..faces.len())
                .find(|&f| {
                    !is_cap(f) && faces[f].edge == neighbour.edge && faces[f].side != neighbour.side
                })
                .expect("every edge has two sides");
            let cap = (0..faces.len()).find(|&f| is_cap(f) && faces[f].ends[0] == vertex);
            if let Some(cap) = cap {
                next[arriving] = cap;
                next[cap] = out;
            } else {
                next[arriving] = out;
            }
        }
    }
    next
}

/// Which faces start inside the polygons (even-odd), decided once for each chain.
fn inside(graph: &Graph, points: &[Vector], faces: &[Face], next: &[usize]) -> Vec<bool> {
    let mut inside = vec![None; faces.len()];
    for start in 0..faces.len() {
        if inside[start].is_some() || matches!(faces[start].side, Side::Start | Side::End) {
            continue;
        }
        let parity = left_is_inside(graph, points, &faces[start]);
        let mut f = start;
        while inside[f].is_none() {
            inside[f] = Some(parity);
            f = next[f];
        }
    }
    inside
        .into_iter()
        .map(|known| known.expect("every cap is in a chain with a side"))
        .collect()
}

/// Is the place just left of the middle of a side inside the polygons?
fn left_is_inside(graph: &Graph, points: &[Vector], face: &Face) -> bool {
    // A ray from the middle, along y unless the side itself is vertical; coordinates doubled.
    let (across, along) = if face.direction[0] == IBig::ZERO {
        (1, 0)
    } else {
        (0, 1)
    };
    let middle: Vector = [0, 1].map(|k| &points[face.ends[0]][k] + &points[face.ends[1]][k]);
    let mut odd = false;
    for (index, edge) in graph
        .edges
        .iter()
        .enumerate()
        .filter(|(_, edge)| edge.on_ring)
    {
        if index == face.edge {
            odd ^= face.normal[along] < IBig::ZERO;
            continue;
        }
        let [p, q] = edge.ends.map(|end| [0, 1].map(|k| &points[end][k] << 1));
        let (low, high) = if p[across] <= q[across] {
            (p, q)
        } else {
            (q, p)
        };
        if low[across] <= middle[across] && middle[across] < high[across] {
            let rise = (&high[along] - &low[along]) * (&middle[across] - &low[across]);
            odd ^= rise > (&middle[along] - &low[along]) * (&high[across] - &low[across]);
        }
    }
    odd
}
