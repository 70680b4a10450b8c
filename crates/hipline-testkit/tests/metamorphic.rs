//! Maps of the input under which the library's results map along, bit for bit: swapped axes,
//! mirrors, quarter turns, powers of two, other starts of rings, other orders of parts and holes.
//! (Of translations times must be the same bits; places are rounded anew.)

mod common;

use common::{count, field, run};
use hipline_testkit::Case;
use hipline_testkit::agreement::drawn;
use hipline_testkit::generate::{Family, small, small_weighted};
use hipline_testkit::hunt::check_all;
use hipline_testkit::metamorphic::Map;

/// Whether a map moves every point without rounding.
fn is_exact(map: Map, case: &Case) -> bool {
    let Map::Translate(by) = map else { return true };
    let mut case = case.clone();
    case.parts
        .iter_mut()
        .flat_map(|part| part.points_mut())
        .all(|point| {
            (0..2).all(|k| {
                let (x, d) = (point[k], f64::from(by[k]));
                let sum = x + d;
                // The error of the sum (Knuth), which is an f64.
                let part = sum - x;
                (x - (sum - part)) + (d - part) == 0.0
            })
        })
}

/// How the skeleton of the case fails to map along.
fn failures(case: &Case) -> Vec<String> {
    let before = drawn(&run(case));
    let maps = Map::some().into_iter().filter(|&map| {
        // Ties between equally fast edges on either side of a slower one go by sides.
        is_exact(map, case) && !(map.swaps_sides() && case.is_weighted())
    });
    let check = |map: Map| map.check(&before, &drawn(&run(&map.apply(case)))).err();
    maps.filter_map(check).collect()
}

fn check(cases: impl Iterator<Item = Case> + Clone + Send) {
    check_all(cases, failures);
}

#[test]
fn small_cases_map_along() {
    check((0..count(4000, 200)).map(small));
}

#[test]
fn changing_speeds_map_along() {
    check((0..count(4000, 200)).map(small_weighted));
}

#[test]
fn families_map_along() {
    let n = count(300, 60) as usize;
    check(
        Family::all()
            .into_iter()
            .map(move |family| family.generate(n, 3)),
    );
}

#[test]
fn the_field_maps_along() {
    let cases = field(count(150, 60) as usize, 3);
    println!("{} cases", cases.len());
    check(cases.iter().cloned());
}
