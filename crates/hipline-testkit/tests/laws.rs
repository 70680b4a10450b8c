//! The reference engine on random small cases: laws, and maps under which results map along.

use hipline::Region;
use hipline_testkit::agreement::drawn_reference;
use hipline_testkit::case::Case;
use hipline_testkit::generate::{Family, small, small_tilted, small_weighted};
use hipline_testkit::metamorphic::Map;
use hipline_testkit::reference::{Graph, RefKind, Reference, check_laws, reference};

fn cases() -> u64 {
    std::env::var("HIPLINE_CASES")
        .ok()
        .and_then(|count| count.parse().ok())
        .unwrap_or(500)
}

fn run(case: &Case, region: Region) -> (Graph, Reference) {
    let figure = case
        .figure()
        .unwrap_or_else(|flaws| panic!("{}\n{flaws:?}", case.to_text()));
    let graph = Graph::from(&figure);
    let result = reference(&graph, region);
    (graph, result)
}

#[test]
fn results_obey_the_laws() {
    let mut wrong = Vec::new();
    let all = (0..cases()).flat_map(|seed| [small(seed), small_weighted(seed), small_tilted(seed)]);
    for case in all {
        let (graph, result) = run(&case, Region::Both);
        if let Err(law) = check_laws(&graph, &result) {
            wrong.push(format!("{law}\n{}", case.to_text()));
        }
    }
    assert!(
        wrong.is_empty(),
        "{} wrong\n{}",
        wrong.len(),
        wrong[..wrong.len().min(8)].join("\n")
    );
}

/// What the random cases are worth: every kind of event must be among them.
#[test]
fn cases_cover_the_degeneracies() {
    let mut seen = std::collections::BTreeMap::new();
    let mut sizes = [0_usize; 41];
    let all = (0..cases()).flat_map(|seed| [small(seed), small_weighted(seed)]);
    for case in all {
        let (graph, result) = run(&case, Region::Both);
        sizes[graph.edges.len().min(40)] += 1;
        let degrees = result.degrees();
        let mut found = std::collections::BTreeSet::new();
        for arc in &result.arcs {
            let [from, to] = arc.nodes.map(|node| result.nodes[node].time);
            let [p, q] = arc.nodes.map(|node| result.nodes[node]);
            let upright = match q.kind {
                RefKind::Infinite([x, y]) => x == 0.0 && y == 0.0,
                _ => (0..2).all(|k| p.place[k].total_cmp(&q.place[k]).is_eq()),
            };
            let end = if upright && to.is_infinite() {
                "upright unbounded"
            } else if upright {
                "upright"
            } else if to.is_infinite() {
                "unbounded"
            } else if from.total_cmp(&to).is_eq() {
                if to > 0.0 { "level" } else { "level at 0" }
            } else {
                "ordinary"
            };
            let weighted = if !case.changes.is_empty() {
                "changing"
            } else if case.is_weighted() {
                "weighted"
            } else {
                "plain"
            };
            found.insert(format!("{weighted} {end} {:?}", arc.kind));
        }
        for (node, &degree) in result.nodes.iter().zip(&degrees) {
            if node.kind == RefKind::Event {
                found.insert(format!("node of {} arcs", degree.min(9)));
            }
        }
        for what in found {
            *seen.entry(what).or_insert(0) += 1;
        }
    }
    println!("{seen:#?}\nedges: {sizes:?}");
    for due in [
        "plain level Ridge",
        "plain ordinary Ghost",
        "plain unbounded Ghost",
        "weighted level Ridge",
        "weighted level at 0 Ridge",
        "weighted ordinary Ghost",
        "weighted upright Valley",
        "weighted upright unbounded Ghost",
        "changing level Crease",
        "changing level Ridge",
        "changing level at 0 Ridge",
        "changing upright Ridge",
        "changing upright Ghost",
        "changing ordinary Ghost",
        "node of 5 arcs",
        "node of 6 arcs",
        "node of 8 arcs",
    ] {
        assert!(seen.contains_key(due), "no {due} in {seen:?}");
    }
}

#[test]
fn halves_add_up_to_the_whole() {
    let all = (0..cases() / 4).flat_map(|seed| [small(seed), small_weighted(seed)]);
    for case in all {
        let whole = drawn_reference(&run(&case, Region::Both).1);
        let mut halves = drawn_reference(&run(&case, Region::Interior).1);
        halves.extend(drawn_reference(&run(&case, Region::Exterior).1));
        halves.sort_unstable();
        assert_eq!(whole, halves, "{}", case.to_text());
    }
}

#[test]
fn results_map_along() {
    let mut wrong = Vec::new();
    let all = (0..cases() / 4).flat_map(|seed| [small(seed), small_weighted(seed)]);
    for case in all {
        let before = drawn_reference(&run(&case, Region::Both).1);
        for map in Map::some() {
            if map.swaps_sides() && case.is_weighted() {
                continue;
            }
            let mapped = map.apply(&case);
            let after = drawn_reference(&run(&mapped, Region::Both).1);
            if let Err(difference) = map.check(&before, &after) {
                wrong.push(format!("{difference}\n{}", case.to_text()));
            }
        }
    }
    assert!(
        wrong.is_empty(),
        "{} wrong\n{}",
        wrong.len(),
        wrong[..wrong.len().min(8)].join("\n")
    );
}

#[test]
fn families_obey_the_laws() {
    for family in Family::all() {
        let case = family.generate(18, 5);
        let (graph, result) = run(&case, Region::Both);
        let laws = check_laws(&graph, &result);
        assert_eq!(laws, Ok(()), "{}", case.to_text());
    }
}

#[test]
fn families_are_figures_of_the_asked_size() {
    for (family, seed) in Family::all().into_iter().zip(1..) {
        let case = family.generate(3000, seed);
        assert!(
            case.figure().is_ok(),
            "{}: {:?}",
            family.name(),
            case.figure().err()
        );
        assert!(
            (1500..=6400).contains(&case.size()),
            "{}: {}",
            family.name(),
            case.size()
        );
        assert_eq!(Family::named(family.name()), Some(family), "name");
        assert_eq!(case, family.generate(3000, seed), "deterministic");
    }
}
