//! Roofs are closed, look upward and cover their polygon.

mod offset_support;

use hipline::{
    Figure, FigureBuilder, Options, Region,
    roof::{InvalidRoof, Mesh, MeshFace, MeshFlaw},
};
use offset_support::{ELL, FUNNEL, HOLE, OUTER, PLUS, RECTANGLE, SQUARE, lines, polygon, polygons};

/// Checks the roof of a figure and all that is made of it.
fn check(figure: &Figure, area: f64) -> Result<Mesh, String> {
    let roof = figure
        .skeleton(Options::default())
        .roof(0.5)
        .map_err(|e| e.to_string())?;
    let tolerance = 1e-9 * area;
    let plan = |mesh: &Mesh| mesh.faces.iter().map(|f| mesh.plan_area(f)).sum::<f64>();
    if (plan(&roof) - area).abs() > tolerance {
        return Err(format!("the roof covers {} of {area}", plan(&roof)));
    }
    let flat = roof.triangulate();
    if (plan(&flat) - area).abs() > tolerance {
        return Err(format!("the triangles cover {} of {area}", plan(&flat)));
    }
    let solid = roof.clone().with_base();
    solid.check().map_err(|flaw| format!("polygons: {flaw}"))?;
    if plan(&solid).abs() > tolerance {
        return Err(format!("floor and roof differ by {}", plan(&solid)));
    }
    let triangles = solid.triangulate();
    triangles
        .check()
        .map_err(|flaw| format!("triangles: {flaw}"))?;
    for face in &triangles.faces {
        let folded = if face.face.is_some() {
            triangles.plan_area(face) < 0.0
        } else {
            triangles.plan_area(face) > 0.0
        };
        if folded {
            return Err(format!(
                "{face:?} of {} is folded over",
                triangles.plan_area(face)
            ));
        }
    }
    if triangles.clone().with_base() != triangles {
        return Err("a closed mesh has no base to add".to_owned());
    }
    Ok(roof)
}

#[test]
fn shapes_known_by_hand() {
    let cases: [(&str, Figure, f64, usize); 7] = [
        ("square", polygon(&[SQUARE]), 16.0, 5),
        ("rectangle", polygon(&[RECTANGLE]), 32.0, 6),
        ("ell", polygon(&[ELL]), 28.0, 10),
        ("plus", polygon(&[PLUS]), 20.0, 17),
        ("hole", polygon(&[OUTER, HOLE]), 72.0, 12),
        (
            "funnel",
            polygon(&[FUNNEL]),
            offset_support::area(FUNNEL),
            8,
        ),
        (
            "straight",
            polygon(&[&[[0.0, 0.0], [2.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0]]]),
            16.0,
            6,
        ),
    ];
    for (name, figure, area, vertices) in cases {
        let roof = check(&figure, area).unwrap_or_else(|e| panic!("{name}: {e}"));
        assert_eq!(roof.vertices.len(), vertices, "{name}: {:?}", roof.vertices);
        assert_eq!(roof.faces.len(), figure.edges().len(), "{name}: facets");
    }
}

#[test]
fn heights_are_times_times_slope() {
    let roof = polygon(&[RECTANGLE])
        .skeleton(Options::default())
        .roof(0.25)
        .expect("a roof");
    let mut tops: Vec<_> = roof.vertices.iter().filter(|v| v[2] > 0.0).collect();
    tops.sort_by(|a, b| a[0].total_cmp(&b[0]));
    assert_eq!(tops, [&[2.0, 2.0, 0.5], &[6.0, 2.0, 0.5]]);
}

#[test]
fn several_polygons_have_several_floors() {
    let mut builder = FigureBuilder::new();
    builder.polygon(vec![SQUARE.to_vec()]);
    builder.polygon(vec![SQUARE.iter().map(|p| [p[0] + 9.0, p[1]]).collect()]);
    let figure = builder.build().expect("valid");
    let roof = check(&figure, 32.0).expect("a roof");
    let solid = roof.with_base();
    assert_eq!(solid.faces.iter().filter(|f| f.face.is_none()).count(), 2);
}

#[test]
fn weights() {
    let mut builder = FigureBuilder::new();
    builder.weighted_polygon(
        vec![vec![
            [0.0, 0.0],
            [2.0, 0.0],
            [4.0, 0.0],
            [4.0, 4.0],
            [0.0, 4.0],
        ]],
        vec![vec![1.0, 2.0, 0.5, 3.0, 1.0]],
    );
    check(&builder.build().expect("valid"), 16.0).expect("a roof");
}

#[test]
fn only_what_is_bounded() {
    let square = polygon(&[SQUARE]);
    let both = square
        .skeleton(Options::default().region(Region::Both))
        .roof(1.0)
        .expect("a roof");
    assert_eq!(both.faces.len(), 4);
    let outside = square
        .skeleton(Options::default().region(Region::Exterior))
        .roof(1.0);
    assert_eq!(outside, Err(InvalidRoof::Unbounded));
    let line = lines(&[&[[0.0, 0.0], [1.0, 0.0]]]);
    assert_eq!(
        line.skeleton(Options::default()).roof(1.0),
        Err(InvalidRoof::Unbounded)
    );
    for slope in [0.0, -1.0, f64::INFINITY] {
        assert_eq!(
            square.skeleton(Options::default()).roof(slope),
            Err(InvalidRoof::Slope(slope))
        );
    }
}

#[test]
fn the_check_finds_flaws() {
    let solid = polygon(&[SQUARE])
        .skeleton(Options::default())
        .roof(1.0)
        .expect("a roof")
        .with_base();
    let mut open = solid.clone();
    open.faces.pop();
    assert!(matches!(open.check(), Err(MeshFlaw::Open { .. })));
    let mut twice = solid.clone();
    twice.faces.push(twice.faces[0].clone());
    assert!(matches!(
        twice.check(),
        Err(MeshFlaw::SameDirection {
            first: 0,
            second: 5,
            ..
        })
    ));
    let mut turned = solid.clone();
    turned.faces[0].boundary.reverse();
    assert!(turned.check().is_err());
    let mut needle = solid.clone();
    needle.faces.push(MeshFace {
        boundary: vec![0, 1],
        holes: Vec::new(),
        face: None,
    });
    assert_eq!(needle.check(), Err(MeshFlaw::FewCorners { face: 5 }));
    let mut stray = solid.clone();
    stray.faces[4].boundary[0] = 99;
    assert_eq!(
        stray.check(),
        Err(MeshFlaw::NoVertex {
            face: 4,
            vertex: 99
        })
    );
    let mut point = solid;
    for vertex in &mut point.vertices {
        *vertex = [1.0; 3];
    }
    assert_eq!(point.check(), Err(MeshFlaw::Point { face: 0 }));
}

#[test]
fn buildings() {
    let mut failures = Vec::new();
    let list = polygons(&["spacenet", "osm-helsinki", "momepy-bubenec"], 500);
    for (id, figure, area) in &list {
        if let Err(message) = check(figure, *area) {
            failures.push(format!("{id}: {message}"));
        }
    }
    println!("{} roofs, {} flawed", list.len(), failures.len());
    for failure in failures.iter().take(30) {
        println!("{failure}");
    }
    assert!(
        failures.is_empty(),
        "{} of {} roofs are flawed",
        failures.len(),
        list.len()
    );
}
