//! The planes of an input, phase by phase, and which wavefront edge follows which at the start.

use std::cmp::Ordering;

use dashu_int::IBig;
use dashu_int::ops::Gcd;
use hipline::skeleton::Side;

use super::eaves::{Eave, Slant};
use super::graph::Graph;
use super::heading::{Heading, around};
use super::number::{Field, Num};
use super::ratio::Ratio;

/// An integer vector.
pub(super) type Vector = [IBig; 2];

/// `u . v`.
pub(super) fn dot(u: &Vector, v: &Vector) -> IBig {
    &u[0] * &v[0] + &u[1] * &v[1]
}

/// The plane on which the wavefront edge of one side of an edge (or of a terminal) moves as long as
/// its speed stays the same.
///
/// The plane is `normal . (x, y) = level + rate * t` in scaled units; the unswept side is where
/// the left hand side is greater.
#[derive(Debug)]
pub(super) struct Plane {
    /// Which edge.
    pub edge: usize,
    /// Which side of it.
    pub side: Side,
    /// How often the speed has changed.
    pub phase: u32,
    /// The number of the side among all, by edge, then side: that of its plane of phase 0.
    pub course: usize,
    /// From when on it moves on this plane.
    pub start: Ratio,
    /// The plane of the next phase.
    pub later: Option<usize>,
    /// What starts at the lower end of its tilted eave, if it is the wall below one.
    pub eave: Option<Eave>,
    /// Where its wavefront edge starts and ends at first (vertices).
    pub ends: [usize; 2],
    /// The direction of the wavefront edge, the unswept side on its left.
    pub direction: Heading,
    /// Its normal, towards the unswept side.
    pub normal: Heading,
    /// The square of the length of the normal.
    pub square: IBig,
    /// The constant of the plane.
    pub level: Num,
    /// Speed times length of the normal.
    pub rate: Num,
    /// Speed, scaled to an integer.
    pub speed: IBig,
}

impl Plane {
    /// Does it stand upright?
    pub(super) fn stands(&self) -> bool {
        self.speed == IBig::ZERO
    }
}

/// The input in exact integers.
#[derive(Debug)]
pub(super) struct Model {
    pub field: Field,
    /// First those of phase 0, one for each side and terminal, then the later ones.
    pub planes: Vec<Plane>,
    /// How many planes are of phase 0.
    pub courses: usize,
    /// `next[f]`: the side whose wavefront edge follows that of side `f` at time 0, terminals left
    /// out.
    pub next: Vec<usize>,
    /// The terminal at each vertex: the number of its plane of phase 0.
    pub terminals: Vec<Option<usize>>,
    /// Whether the wavefront edge starts inside the polygons.
    pub inside: Vec<bool>,
    /// The vertices, scaled to integers.
    pub points: Vec<Vector>,
    /// A coordinate is its integer times 2^-this.
    pub place_bits: i64,
    /// A speed is its integer times 2^-this; a time, times 2^(this - place_bits).
    pub speed_bits: i64,
}

impl Model {
    /// Sets up planes and chains.
    pub(super) fn new(graph: &Graph) -> Self {
        let changes = || graph.changes.iter();
        let speed_bits = graph.speed_bits();
        let times = changes().map(|change| change.time);
        let time_bits = common_bits(times.chain(graph.heights.iter().copied()));
        let place_bits =
            common_bits(graph.vertices.iter().flatten().copied()).max(speed_bits + time_bits);
        let points: Vec<Vector> = graph
            .vertices
            .iter()
            .map(|p| p.map(|x| scaled(x, place_bits)))
            .collect();
        let mut planes = first_planes(graph, &points, speed_bits);
        let courses = planes.len();
        let squares: Vec<IBig> = planes.iter().map(|f| f.square.clone()).collect();
        let slants = Slant::all(graph, &points, &planes, place_bits - speed_bits);
        let field = Field::new(squares.iter().chain(slants.iter().map(Slant::radicand)));
        for (plane, square) in planes.iter_mut().zip(&squares) {
            plane.rate = field.root(square).times(&plane.speed);
        }
        for (course, square) in squares.iter().enumerate() {
            let root = field.root(square);
            let list = graph.speeds(planes[course].edge, planes[course].side);
            let mut last = course;
            for &[time, speed] in &list[1..] {
                let time = scaled(time, place_bits - speed_bits);
                let speed = scaled(speed, speed_bits);
                let later = later_plane(&planes[last], &time, speed, &root);
                planes[last].later = Some(planes.len());
                last = planes.len();
                planes.push(later);
            }
        }
        for slant in &slants {
            let facet = planes.len();
            planes.push(slant.facet(&field, &planes));
            planes[slant.course].eave = Some(Eave {
                facet,
                rises: slant.rises,
            });
        }
        let next = chains(&field, &planes[..courses], points.len());
        let inside = inside(graph, &points, &planes[..courses], &next);
        let mut terminals = vec![None; points.len()];
        for (course, plane) in planes[..courses].iter().enumerate() {
            if is_terminal(plane) {
                terminals[plane.ends[0]] = Some(course);
            }
        }
        Self {
            field,
            planes,
            courses,
            next,
            terminals,
            inside,
            points,
            place_bits,
            speed_bits,
        }
    }

    /// The plane of a side or terminal at a time; of two, that of the new speed.
    pub(super) fn plane_at(&self, course: usize, time: &Ratio) -> usize {
        let mut plane = course;
        while let Some(later) = self.planes[plane].later
            && self.planes[later].start.compare(time, &self.field) != Ordering::Greater
        {
            plane = later;
        }
        plane
    }

    /// Which one is faster as soon as they differ, from now on.
    pub(super) fn faster(&self, i: usize, j: usize) -> Ordering {
        let (mut i, mut j) = (i, j);
        loop {
            let order = self.planes[i].speed.cmp(&self.planes[j].speed);
            if order != Ordering::Equal {
                return order;
            }
            let (later_i, later_j) = (self.planes[i].later, self.planes[j].later);
            let first = match (later_i, later_j) {
                (None, None) => return Ordering::Equal,
                (Some(_), None) => Ordering::Less,
                (None, Some(_)) => Ordering::Greater,
                (Some(a), Some(b)) => {
                    let start = |plane: usize| &self.planes[plane].start;
                    start(a).compare(start(b), &self.field)
                }
            };
            if first != Ordering::Greater {
                i = later_i.expect("there is a first change");
            }
            if first != Ordering::Less {
                j = later_j.expect("there is a first change");
            }
        }
    }
}

/// Is it beyond a vertex of degree one?
fn is_terminal(plane: &Plane) -> bool {
    matches!(plane.side, Side::Start | Side::End)
}

/// The planes of phase 0, by edge, then side; without their rates.
fn first_planes(graph: &Graph, points: &[Vector], speed_bits: i64) -> Vec<Plane> {
    let mut degree = vec![0; points.len()];
    for end in graph.edges.iter().flat_map(|edge| edge.ends) {
        degree[end] += 1;
    }
    let mut planes: Vec<Plane> = Vec::new();
    for (edge, content) in graph.edges.iter().enumerate() {
        let [p, q] = content.ends;
        let along: Vector = [0, 1].map(|k| &points[q][k] - &points[p][k]);
        let back = along.clone().map(|x| -x);
        let mut sides = vec![
            (Side::Left, [p, q], along.clone()),
            (Side::Right, [q, p], back.clone()),
        ];
        // A terminal's normal points away from the segment, so it runs a quarter turn right of that.
        if degree[p] == 1 {
            sides.push((Side::Start, [p, p], [back[1].clone(), -&back[0]]));
        }
        if degree[q] == 1 {
            sides.push((Side::End, [q, q], [along[1].clone(), -&along[0]]));
        }
        for (side, ends, direction) in sides {
            let gcd = IBig::from((&direction[0]).gcd(&direction[1]));
            let direction = direction.map(|x| x / &gcd);
            let normal = [-&direction[1], direction[0].clone()];
            let square = dot(&normal, &normal);
            planes.push(Plane {
                edge,
                side,
                phase: 0,
                course: planes.len(),
                start: Ratio::zero(),
                later: None,
                eave: None,
                ends,
                level: dot(&normal, &points[ends[0]]).into(),
                direction: direction.map(Num::from),
                normal: normal.map(Num::from),
                square,
                rate: Num::default(),
                speed: scaled(graph.speeds(edge, side)[0][1], speed_bits),
            });
        }
    }
    planes
}

/// From a time on, the wavefront edge of a plane moves on at another speed, from where it is.
fn later_plane(before: &Plane, time: &IBig, speed: IBig, root: &Num) -> Plane {
    let rate = root.times(&speed);
    let slower = before.rate.minus(&rate);
    Plane {
        phase: before.phase + 1,
        start: Ratio::integer(time),
        later: None,
        eave: None,
        direction: before.direction.clone(),
        normal: before.normal.clone(),
        square: before.square.clone(),
        level: before.level.plus(&slower.times(time)),
        rate,
        speed,
        ..*before
    }
}

/// The least `k` for which all numbers times `2^k` are integers.
fn common_bits(numbers: impl Iterator<Item = f64>) -> i64 {
    numbers
        .filter_map(|x| decode(x).map(|(_, exponent)| -exponent))
        .max()
        .unwrap_or(0)
}

impl Graph {
    /// The least `k` for which all speeds times `2^k` are integers.
    pub(super) fn speed_bits(&self) -> i64 {
        let speeds = self.edges.iter().flat_map(|edge| edge.speeds);
        common_bits(speeds.chain(self.changes.iter().map(|change| change.speed)))
    }
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
pub(super) fn scaled(x: f64, bits: i64) -> IBig {
    decode(x).map_or(IBig::ZERO, |(mantissa, exponent)| {
        IBig::from(mantissa) << (exponent + bits) as usize
    })
}

/// At each vertex: sorts the sides by angle, and links what bounds the same sector.
fn chains(field: &Field, faces: &[Plane], vertices: usize) -> Vec<usize> {
    let mut next = vec![usize::MAX; faces.len()];
    let is_cap = |f: usize| is_terminal(&faces[f]);
    for vertex in 0..vertices {
        let mut leaving: Vec<usize> = (0..faces.len())
            .filter(|&f| !is_cap(f) && faces[f].ends[0] == vertex)
            .collect();
        leaving.sort_by(|&f, &g| around(field, &faces[f].direction, &faces[g].direction));
        for (i, &out) in leaving.iter().enumerate() {
            // The sector on the left of `out` ends at the next edge, whose other side arrives.
            let neighbour = &faces[leaving[(i + 1) % leaving.len()]];
            let arriving = (0..faces.len())
                .find(|&f| {
                    !is_cap(f) && faces[f].edge == neighbour.edge && faces[f].side != neighbour.side
                })
                .expect("every edge has two sides");
            next[arriving] = out;
        }
    }
    next
}

/// Which faces start inside the polygons (even-odd), decided once for each chain.
fn inside(graph: &Graph, points: &[Vector], faces: &[Plane], next: &[usize]) -> Vec<bool> {
    let mut inside = vec![None; faces.len()];
    for start in 0..faces.len() {
        if inside[start].is_some() || is_terminal(&faces[start]) {
            continue;
        }
        let parity = left_is_inside(graph, points, &faces[start]);
        let mut f = start;
        while inside[f].is_none() {
            inside[f] = Some(parity);
            f = next[f];
        }
    }
    // A terminal is where both sides of its edge are; the left one comes before it in the list.
    for f in 0..faces.len() {
        if is_terminal(&faces[f]) {
            let left = (0..f).find(|&g| faces[g].edge == faces[f].edge);
            inside[f] = inside[left.expect("every edge has sides")];
        }
    }
    inside
        .into_iter()
        .map(|known| known.expect("every side is in a chain"))
        .collect()
}

/// Is the place just left of the middle of a side inside the polygons?
fn left_is_inside(graph: &Graph, points: &[Vector], face: &Plane) -> bool {
    // A ray from the middle, along y unless the side itself is vertical; coordinates doubled.
    let [x, y]: Vector = [0, 1].map(|k| &points[face.ends[1]][k] - &points[face.ends[0]][k]);
    let normal: Vector = [-y, x];
    let (across, along) = if normal[1] == IBig::ZERO {
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
            odd ^= normal[along] < IBig::ZERO;
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
