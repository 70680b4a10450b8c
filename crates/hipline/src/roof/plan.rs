//! Which edges rise how steeply, and which stand still: a pure function of footprint and
//! options.
//!
//! A *profile* says how the wavefront of an edge moves: phases, each from a moment on, with a
//! speed. The roof is `slope` high for each unit of time, so an edge of speed w rises at
//! `slope / w`. An edge of speed 0 stands still, and its facet is a gable; after a break, another
//! speed is another slope, as a mansard roof has.

use super::{Gables, InvalidRoof, RoofOptions, RoofShape, Steepness, plane::orientation};
use crate::{
    input::{Edge, Figure, Source, SpeedChange},
    topology::{EdgeId, VertexId},
};

/// A stretch of time in which an edge moves at one speed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Phase {
    /// When it begins; it ends with the next one, or never.
    pub from: f64,
    /// The distance moved in one unit of time; 0 stands still.
    pub speed: f64,
}

/// How the edges of a footprint move.
#[derive(Debug, Clone, PartialEq)]
pub struct Plan {
    /// How much the roof rises in one unit of time; of a roof whose height is given, 1.
    pub slope: f64,
    /// For each edge of the figure, its phases: at least one, the first from 0.
    pub profiles: Vec<Vec<Phase>>,
}

/// The plan of a roof; flat roofs have that of hip roofs.
///
/// # Errors
/// Slopes that are not above 0, and edges that are not there.
pub fn plan(figure: &Figure, options: &RoofOptions) -> Result<Plan, InvalidRoof> {
    options.check()?;
    let slope = match options.steepness {
        Steepness::Slope(slope) => slope,
        Steepness::Height(_) => 1.0,
    };
    let edges = figure.edges();
    let at = |source: Source| {
        let mut found = (0..edges.len())
            .filter(move |&i| edges[i].source == source)
            .peekable();
        found
            .peek()
            .is_some()
            .then_some(found)
            .ok_or(InvalidRoof::NoEdge(source))
    };
    let mut speeds: Vec<f64> = edges.iter().map(|edge| edge.speeds[0]).collect();
    for &(source, steep) in &options.edge_slopes {
        if !(steep.is_finite() && steep > 0.0) {
            return Err(InvalidRoof::EdgeSlope {
                edge: source,
                slope: steep,
            });
        }
        for i in at(source)? {
            speeds[i] *= slope / steep;
        }
    }
    let has_break = matches!(options.shape, RoofShape::Mansard | RoofShape::Gambrel);
    let moving = |speed: f64| {
        let from = options.break_height / slope;
        if has_break && from > 0.0 {
            let speed_below = speed * (slope / options.lower_slope);
            let lower = Phase {
                from: 0.0,
                speed: speed_below,
            };
            vec![lower, Phase { from, speed }]
        } else {
            vec![Phase { from: 0.0, speed }]
        }
    };
    let mut profiles: Vec<Vec<Phase>> = speeds.into_iter().map(moving).collect();
    if matches!(options.shape, RoofShape::Gable | RoofShape::Gambrel) {
        let standing = Phase {
            from: 0.0,
            speed: 0.0,
        };
        match &options.gables {
            Gables::Auto => {
                for i in short_ends(figure) {
                    profiles[i] = vec![standing];
                }
            }
            Gables::Edges(list) => {
                for &source in list {
                    for i in at(source)? {
                        profiles[i] = vec![standing];
                    }
                }
            }
        }
    }
    Ok(Plan { slope, profiles })
}

impl Plan {
    /// The figure with these profiles, if they are others than its own. `started` is the time at which
    /// the figure's wavefront is, as seen from the profiles: below zero beyond the eaves.
    ///
    /// Edges with a single phase keep the changes of speed that they have.
    pub(super) fn apply(&self, figure: &Figure, started: f64) -> Option<Figure> {
        let edges = || figure.edges().iter().zip(&self.profiles);
        let keeps = |edge: &Edge, profile: &[Phase]| {
            let bits = profile[0].speed.to_bits();
            profile.len() == 1 && edge.speeds.iter().all(|speed| speed.to_bits() == bits)
        };
        if edges().all(|(edge, profile)| keeps(edge, profile)) {
            return None;
        }
        let mut changed = figure.clone();
        let mut changes: Vec<SpeedChange> = Vec::new();
        for (e, (edge, profile)) in edges().enumerate() {
            let id = EdgeId::new(e);
            if keeps(edge, profile) {
                for right in [false, true] {
                    changes.extend(figure.changes_of(id, right));
                }
                continue;
            }
            changed.edges_mut()[e].speeds = [profile[0].speed; 2];
            for right in [false, true] {
                changes.extend(profile.iter().skip(1).map(|phase| SpeedChange {
                    edge: id,
                    right,
                    time: phase.from - started,
                    speed: phase.speed,
                }));
            }
        }
        changed.set_changes(changes);
        Some(changed)
    }

    /// Whether an edge stands still in one of its phases.
    pub(super) fn stands(&self, edge: usize, phase: u32) -> bool {
        let phase = self.profiles[edge].get(phase as usize);
        phase.is_some_and(|phase| phase.speed <= 0.0)
    }
}

/// The edges of a figure where people expect gables: the short ends of the wings of a
/// building.
///
/// A side of a ring of four or more is a chain of edges on one line. It is an end if its two corners turn the
/// same way, so that the building lies between its neighbours; if these run in opposite
/// directions, more or less; if it is shorter than one of them, or both lead to reflex corners; and if it is shorter than each of them twice. Of two that
/// share a corner the shorter one is an end; of a ring with four sides of one length the first and the third are.
///
/// # Complexity
/// Linear.
#[must_use]
pub fn short_ends(figure: &Figure) -> Vec<usize> {
    rings(figure)
        .iter()
        .flat_map(|ring| ends_of(figure, ring))
        .collect()
}

/// The edges of each ring of the polygons, in the order of the ring.
fn rings(figure: &Figure) -> Vec<Vec<usize>> {
    let edges = figure.edges();
    let mut order: Vec<usize> = (0..edges.len()).filter(|&i| edges[i].on_ring).collect();
    order.sort_by_key(|&i| (edges[i].source, i));
    let same = |a: &usize, b: &usize| {
        let [a, b] = [*a, *b].map(|i| edges[i].source);
        (a.part, a.ring) == (b.part, b.ring)
    };
    let rings = order.chunk_by(same).map(|ring| {
        // The pieces of an edge that was split follow each other from its start on.
        let mut ring = ring.to_vec();
        for i in 1..ring.len() {
            let end = edges[ring[i - 1]].to;
            if let Some(k) = (i..ring.len()).find(|&k| edges[ring[k]].from == end) {
                ring.swap(i, k);
            }
        }
        ring
    });
    rings.collect()
}

fn ends_of(figure: &Figure, ring: &[usize]) -> Vec<usize> {
    let point = |v: VertexId| figure.vertices()[v.index()];
    let ends = |i: usize| [figure.edges()[i].from, figure.edges()[i].to].map(point);
    let turn = |a: usize, b: usize| {
        let ([p, q], [_, r]) = (ends(a), ends(b));
        orientation(p, q, r)
    };
    let n = ring.len();
    let Some(first) = (0..n).find(|&k| turn(ring[(k + n - 1) % n], ring[k]) != 0.0) else {
        return Vec::new();
    };
    // The sides: chains of edges on one line.
    let mut sides: Vec<Vec<usize>> = Vec::new();
    for k in 0..n {
        let i = ring[(first + k) % n];
        match sides.last_mut() {
            Some(side) if turn(side[side.len() - 1], i) == 0.0 => side.push(i),
            _ => sides.push(vec![i]),
        }
    }
    let vector = |side: &[usize]| {
        let ([p, _], [_, q]) = (ends(side[0]), ends(side[side.len() - 1]));
        [q[0] - p[0], q[1] - p[1]]
    };
    let dot = |u: [f64; 2], v: [f64; 2]| u[0] * v[0] + u[1] * v[1];
    let m = sides.len();
    // Positive if the ring is counterclockwise; inside a hole, ends are those of the courtyard.
    let area: f64 = ring
        .iter()
        .map(|&i| {
            let ([p, q], [o, _]) = (ends(i), ends(ring[0]));
            (p[0] - o[0]) * (q[1] - o[1]) - (q[0] - o[0]) * (p[1] - o[1])
        })
        .sum();
    let is_shell = figure.edges()[ring[0]].source.ring == 0;
    if !is_shell {
        return Vec::new();
    }
    let vectors: Vec<[f64; 2]> = sides.iter().map(|side| vector(side)).collect();
    let is_end = |k: usize| {
        let (before, after) = ((k + m - 1) % m, (k + 1) % m);
        let corner = |a: usize, b: usize| {
            turn(sides[a][sides[a].len() - 1], sides[b][0]) * area.signum() > 0.0
        };
        // Whether both neighbours lead to the body of the building.
        let is_wing = |k: usize| {
            let [first, last] = [(k + m - 2) % m, (k + 2) % m];
            !corner(first, before) && !corner(after, last)
        };
        let lengths = [before, k, after].map(|i| dot(vectors[i], vectors[i]));
        let is_equal = m == 4 && lengths[0] <= lengths[1] && lengths[2] <= lengths[1];
        m >= 4
            && corner(before, k)
            && corner(k, after)
            && dot(vectors[before], vectors[after]) < 0.0
            // The hip of an end is a triangle, so half of its length leads in to the ridge.
            && lengths[1] < 4.0 * lengths[0].min(lengths[2])
            && (lengths[1] < lengths[0].max(lengths[2])
                || (is_equal && k.is_multiple_of(2))
                || is_wing(k))
    };
    let mut order: Vec<usize> = (0..m).filter(|&k| is_end(k)).collect();
    let length = |k: usize| dot(vectors[k], vectors[k]);
    order.sort_by(|&a, &b| length(a).total_cmp(&length(b)).then(a.cmp(&b)));
    // Where two ends share a corner, the shorter one is the gable.
    let mut chosen = vec![false; m];
    for k in order {
        chosen[k] = !chosen[(k + m - 1) % m] && !chosen[(k + 1) % m];
    }
    (0..m)
        .filter(|&k| chosen[k])
        .flat_map(|k| sides[k].clone())
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::FigureBuilder;

    fn figure(rings: &[&[[f64; 2]]]) -> Figure {
        let mut builder = FigureBuilder::new();
        builder.polygon(rings.iter().map(|ring| ring.to_vec()).collect());
        builder.build().expect("a polygon")
    }

    const RECTANGLE: &[[f64; 2]] = &[[0., 0.], [9., 0.], [9., 4.], [0., 4.]];
    const ELL: &[[f64; 2]] = &[[0., 0.], [6., 0.], [6., 6.], [4., 6.], [4., 2.], [0., 2.]];

    fn edge(edge: u32) -> Source {
        Source {
            part: 0,
            ring: 0,
            edge,
        }
    }

    #[test]
    fn gables_are_at_the_short_ends() {
        let tee: &[[f64; 2]] = &[
            [0., 0.],
            [9., 0.],
            [9., 2.],
            [6., 2.],
            [6., 6.],
            [3., 6.],
            [3., 2.],
            [0., 2.],
        ];
        let square: &[[f64; 2]] = &[[0., 0.], [4., 0.], [4., 4.], [0., 4.]];
        let chain: &[[f64; 2]] = &[[0., 0.], [9., 0.], [9., 1.], [9., 4.], [0., 4.]];
        let triangle: &[[f64; 2]] = &[[0., 0.], [9., 0.], [4., 7.]];
        let clockwise: Vec<[f64; 2]> = RECTANGLE.iter().rev().copied().collect();
        type Case<'a> = (&'a str, &'a [[f64; 2]], &'a [usize]);
        let short_arms: &[[f64; 2]] = &[
            [0., 0.],
            [18., 0.],
            [18., 7.],
            [12.5, 7.],
            [12.5, 14.],
            [5.5, 14.],
            [5.5, 7.],
            [0., 7.],
        ];
        let wings: &[[f64; 2]] = &[
            [0., 0.],
            [20., 0.],
            [20., 14.],
            [12., 14.],
            [12., 7.],
            [8., 7.],
            [8., 14.],
            [0., 14.],
        ];
        let stem: &[[f64; 2]] = &[
            [0., 0.],
            [18., 0.],
            [18., 7.],
            [12.5, 7.],
            [12.5, 13.],
            [6.5, 13.],
            [6.5, 7.],
            [0., 7.],
        ];
        let cases: [Case; 10] = [
            ("a tee with short arms", short_arms, &[1, 4, 7]),
            ("a u with wide wings", wings, &[2, 6]),
            ("a stem as wide as long", stem, &[1, 4, 7]),
            ("rectangle", RECTANGLE, &[1, 3]),
            ("clockwise", &clockwise, &[1, 3]),
            ("ell", ELL, &[2, 5]),
            ("tee", tee, &[1, 4, 7]),
            ("square", square, &[0, 2]),
            ("a corner of 180 degrees", chain, &[1, 2, 4]),
            ("triangle", triangle, &[]),
        ];
        for (name, ring, expected) in cases {
            let mut found = short_ends(&figure(&[ring]));
            found.sort_unstable();
            assert_eq!(found, expected, "{name}");
        }
        let yard: &[[f64; 2]] = &[[2., 1.], [7., 1.], [7., 3.], [2., 3.]];
        let mut found = short_ends(&figure(&[RECTANGLE, yard]));
        found.sort_unstable();
        assert_eq!(found, [1, 3], "a courtyard has none");
    }

    #[test]
    fn slopes_are_speeds() {
        let options = RoofOptions {
            edge_slopes: vec![(edge(1), 2.0)],
            ..RoofOptions::hip(0.5)
        };
        let plan = plan(&figure(&[RECTANGLE]), &options).expect("a plan");
        let speeds: Vec<f64> = plan.profiles.iter().map(|p| p[0].speed).collect();
        assert_eq!(speeds, [1.0, 0.25, 1.0, 1.0]);
        assert_eq!(plan.slope.to_bits(), 0.5_f64.to_bits());
    }

    #[test]
    fn gambrels_break_between_gables() {
        let options = RoofOptions {
            shape: RoofShape::Gambrel,
            lower_slope: 2.0,
            break_height: 3.0,
            ..RoofOptions::hip(0.5)
        };
        let plan = plan(&figure(&[RECTANGLE]), &options).expect("a plan");
        let [lower, upper] = [(0.0, 0.25), (6.0, 1.0)].map(|(from, speed)| Phase { from, speed });
        let gable = Phase {
            from: 0.0,
            speed: 0.0,
        };
        assert_eq!(
            plan.profiles,
            [
                vec![lower, upper],
                vec![gable],
                vec![lower, upper],
                vec![gable]
            ]
        );
    }

    #[test]
    fn what_is_not_there_is_named() {
        let figure = figure(&[ELL]);
        let gables = RoofOptions {
            shape: RoofShape::Gable,
            gables: Gables::Edges(vec![edge(6)]),
            ..RoofOptions::default()
        };
        assert_eq!(plan(&figure, &gables), Err(InvalidRoof::NoEdge(edge(6))));
        assert_eq!(
            InvalidRoof::NoEdge(edge(6)).to_string(),
            "there is no part 0, ring 0, edge 6"
        );
        let slope = |slope| RoofOptions {
            edge_slopes: vec![(edge(0), slope)],
            ..RoofOptions::default()
        };
        for wrong in [0.0, -1.0, f64::INFINITY] {
            assert_eq!(
                plan(&figure, &slope(wrong)),
                Err(InvalidRoof::EdgeSlope {
                    edge: edge(0),
                    slope: wrong
                })
            );
        }
    }
}
