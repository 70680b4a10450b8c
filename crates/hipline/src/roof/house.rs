//! From a footprint to a house: plan, overhang, skeleton, surface, walls and floor.

use super::{
    InvalidRoof, Mesh, RoofOptions, RoofShape, Steepness,
    plan::{Phase, Plan, plan},
    plane::orientation,
    solid::{self, Base},
    surface::{Lift, cut, lifted},
};
use crate::{
    input::{Figure, FigureBuilder},
    skeleton::{NodeKind, Options, Region, Skeleton},
    topology::{EdgeId, FaceId},
};

impl Skeleton {
    /// The hip roof over every bounded part of the plane that the skeleton covers: the inside
    /// of the polygons, and whatever else lines enclose. Unbounded parts are left out. It has
    /// eaves at height 0, and neither walls nor floor: for these, see [`Figure::roof`].
    ///
    /// A point that the wavefront reaches at time t is `slope * t` high; a slope of 1 is a
    /// pitch of 45 degrees for edges of unit speed.
    ///
    /// ```
    /// use hipline::Polygon;
    ///
    /// let square = vec![[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0]];
    /// let roof = Polygon::new([square])?.skeleton().roof(0.5)?;
    /// assert_eq!(roof.facets().len(), 4);
    /// assert!(roof.vertices().contains(&[2.0, 2.0, 1.0]));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Complexity
    /// O(n log n).
    ///
    /// # Errors
    /// If the slope is not finite and above zero, nothing is bounded, or rounding leaves no
    /// area.
    pub fn roof(&self, slope: f64) -> Result<Mesh, InvalidRoof> {
        RoofOptions::hip(slope).check()?;
        cut(lifted(
            self,
            &Lift {
                eaves: 0.0,
                slope,
                is_standing: &|_| false,
            },
        )?)
    }
}

impl Figure {
    /// The roof over the inside of the polygons, and whatever else lines enclose, with walls and
    /// floor: a closed solid, whose facets look outward (unless walls or floor are left out).
    ///
    /// Speeds of edges are kept: an edge of speed 2 rises half as steeply as the slope says.
    ///
    /// ```
    /// use hipline::{Polygon, roof::RoofOptions};
    ///
    /// let square = vec![[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0]];
    /// let options = RoofOptions { eaves: 3.0, overhang: 0.5, ..RoofOptions::hip(0.5) };
    /// let house = Polygon::new([square])?.figure().roof(&options)?;
    /// assert!(house.vertices().contains(&[2.0, 2.0, 4.0]));
    /// assert!(house.vertices().contains(&[-0.5, -0.5, 2.75]));
    /// house.check()?;
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Complexity
    /// That of the skeleton, and O(n log n); twice that with an overhang.
    ///
    /// # Errors
    /// See [`InvalidRoof`].
    pub fn roof(&self, options: &RoofOptions) -> Result<Mesh, InvalidRoof> {
        let options = &RoofOptions {
            steepness: self.steepness(options)?,
            ..options.clone()
        };
        let plan = plan(self, options)?;
        let base = Base {
            ground: options.ground,
            walls: options.walls,
            floor: options.floor,
        };
        let is_grown = options.overhang > 0.0;
        let mut mesh = if options.shape == RoofShape::Flat {
            if is_grown {
                return Err(InvalidRoof::Overhang(options.overhang));
            }
            solid::level(self, options.eaves)?
        } else if is_grown {
            let grown = Grown::new(self, &plan, options.overhang)?;
            let plan = Plan {
                slope: plan.slope,
                profiles: grown
                    .edges
                    .iter()
                    .map(|edge| plan.profiles[edge.index()].clone())
                    .collect(),
            };
            let mut roof = surface(&grown.figure, options, &plan, options.overhang)?;
            for facet in &mut roof.facets {
                facet.edge = facet.edge.map(|edge| grown.edges[edge.index()]);
            }
            roof
        } else {
            surface(self, options, &plan, 0.0)?
        };
        if is_grown {
            solid::close_overhang(&mut mesh, self, base, options.overhang)?;
        } else {
            solid::close(&mut mesh, base)?;
        }
        if touches_itself(self) || is_grown {
            mesh.split_fans();
        }
        Ok(mesh)
    }
}

impl Figure {
    /// The slope above the break that gives a mansard or gambrel roof its height, with the break where it is asked for. If
    /// the break is above that height or all of the roof, it is lowered in proportion; so nothing is said then.
    fn steepness(&self, options: &RoofOptions) -> Result<Steepness, InvalidRoof> {
        let (Steepness::Height(height), RoofShape::Mansard | RoofShape::Gambrel) =
            (options.steepness, options.shape)
        else {
            return Ok(options.steepness);
        };
        options.check()?;
        let whole = RoofOptions {
            shape: if options.shape == RoofShape::Mansard {
                RoofShape::Hip
            } else {
                RoofShape::Gable
            },
            steepness: Steepness::Slope(1.0),
            ..options.clone()
        };
        let changed = plan(self, &whole)?.apply(self, 0.0);
        let figure = changed.as_ref().unwrap_or(self);
        let skeleton = figure.skeleton(Options::default().region(Region::Auto));
        let times = skeleton.nodes().iter().map(|node| node.time);
        let reach = times.filter(|time| time.is_finite()).fold(0.0, f64::max);
        let (above, inside) = (
            height - options.break_height,
            reach - options.break_height / options.lower_slope,
        );
        Ok(if above > 0.0 && inside > 0.0 {
            Steepness::Slope(above / inside)
        } else {
            options.steepness
        })
    }
}

/// The roof over a figure that reaches so far beyond the walls.
fn surface(
    figure: &Figure,
    options: &RoofOptions,
    plan: &Plan,
    overhang: f64,
) -> Result<Mesh, InvalidRoof> {
    let changed = plan.apply(figure, -overhang);
    let figure = changed.as_ref().unwrap_or(figure);
    let skeleton = figure.skeleton(Options::default().region(Region::Auto));
    let slope = match options.steepness {
        Steepness::Slope(_) => plan.slope,
        Steepness::Height(height) => {
            let is_finite = |kind| !matches!(kind, NodeKind::Infinite { .. });
            let nodes = skeleton.nodes().iter().filter(|node| is_finite(node.kind));
            height / (nodes.map(|node| node.time).fold(0.0, f64::max) - overhang)
        }
    };
    let steep = InvalidRoof::Slope(slope);
    if !(slope.is_finite() && slope > 0.0) {
        return Err(steep);
    }
    cut(lifted(
        &skeleton,
        &Lift {
            eaves: options.eaves - slope * overhang,
            slope,
            is_standing: &|face: FaceId| {
                let face = skeleton.face(face);
                plan.stands(face.edge.index(), face.phase)
            },
        },
    )?)
}

/// Whether some vertex has more than two edges: only then can a solid touch itself.
fn touches_itself(figure: &Figure) -> bool {
    let mut degrees = vec![0_u8; figure.vertices().len()];
    for edge in figure.edges() {
        for end in [edge.from, edge.to] {
            let degree = &mut degrees[end.index()];
            *degree = degree.saturating_add(1);
        }
    }
    degrees.iter().any(|&degree| degree > 2)
}

/// A footprint with its overhang.
struct Grown {
    figure: Figure,
    /// For each edge, the edge of the footprint that it was.
    edges: Vec<EdgeId>,
}

impl Grown {
    /// Moves all edges outward, each at its first speed; those that stand still move at speed 1.
    fn new(figure: &Figure, plan: &Plan, overhang: f64) -> Result<Self, InvalidRoof> {
        if figure.edges().iter().any(|edge| !edge.on_ring) {
            return Err(InvalidRoof::NotPolygons);
        }
        let invalid = InvalidRoof::Overhang(overhang);
        let outward: Vec<f64> = plan
            .profiles
            .iter()
            .map(|profile| match profile[0].speed {
                speed if speed > 0.0 => speed,
                _ => 1.0,
            })
            .collect();
        let single = |&speed: &f64| vec![Phase { from: 0.0, speed }];
        let moving = Plan {
            slope: plan.slope,
            profiles: outward.iter().map(single).collect(),
        };
        let changed = moving.apply(figure, 0.0);
        let figure = changed.as_ref().unwrap_or(figure);
        let skeleton = figure.skeleton(Options::default().region(Region::Exterior));
        let offset = skeleton.offset(figure, overhang).map_err(|_| invalid)?;
        // The wavefront has the unswept outside on its left: turned around, it has the roof there.
        let (mut shells, mut holes): (Vec<Ring>, Vec<Ring>) = (Vec::new(), Vec::new());
        for cycle in offset.loops() {
            let n = cycle.points().len();
            let ring = Ring {
                points: cycle.points().iter().rev().copied().collect(),
                edges: (0..n)
                    .map(|k| skeleton.face(cycle.faces()[(2 * n - 2 - k) % n]).edge)
                    .collect(),
            };
            if cycle.area() < 0.0 {
                shells.push(ring);
            } else {
                holes.push(ring);
            }
        }
        let mut polygons: Vec<Vec<Ring>> = shells.into_iter().map(|shell| vec![shell]).collect();
        // A courtyard belongs to the smallest shell around it.
        polygons.sort_by(|a, b| a[0].area().total_cmp(&b[0].area()));
        for hole in holes {
            let around = polygons
                .iter_mut()
                .find(|polygon| polygon[0].contains(&hole));
            around.ok_or(invalid)?.push(hole);
        }
        let mut builder = FigureBuilder::new();
        for polygon in &polygons {
            let speed = |edge: &EdgeId| outward[edge.index()];
            builder.weighted_polygon(
                polygon.iter().map(|ring| ring.points.clone()).collect(),
                polygon
                    .iter()
                    .map(|ring| ring.edges.iter().map(speed).collect())
                    .collect(),
            );
        }
        let grown = builder.build().map_err(|_| invalid)?;
        let edge = |source: crate::input::Source| {
            let ring = &polygons[source.part as usize][source.ring as usize];
            ring.edges[source.edge as usize]
        };
        Ok(Self {
            edges: grown.edges().iter().map(|e| edge(e.source)).collect(),
            figure: grown,
        })
    }
}

/// A ring of a footprint with its overhang; each edge starts at the point of its number.
struct Ring {
    points: Vec<[f64; 2]>,
    edges: Vec<EdgeId>,
}

impl Ring {
    fn sides(&self) -> impl Iterator<Item = [[f64; 2]; 2]> {
        let next = self.points.iter().skip(1).chain(self.points.first());
        self.points.iter().zip(next).map(|(&p, &q)| [p, q])
    }

    fn area(&self) -> f64 {
        let [x, y] = self.points[0];
        let cross = |[p, q]: [[f64; 2]; 2]| (p[0] - x) * (q[1] - y) - (q[0] - x) * (p[1] - y);
        self.sides().map(cross).sum()
    }

    /// Whether a ring that does not cross this one is inside of it.
    fn contains(&self, other: &Self) -> bool {
        let on_side = |p: [f64; 2]| {
            let mut is_inside = false;
            for [a, b] in self.sides() {
                let turn = orientation(a, b, p);
                if turn == 0.0 && (0..2).all(|k| a[k].min(b[k]) <= p[k] && p[k] <= a[k].max(b[k])) {
                    return None;
                }
                if (a[1] <= p[1]) != (b[1] <= p[1]) && (turn > 0.0) == (b[1] > a[1]) {
                    is_inside = !is_inside;
                }
            }
            Some(is_inside)
        };
        other
            .points
            .iter()
            .find_map(|&p| on_side(p))
            .unwrap_or(false)
    }
}
