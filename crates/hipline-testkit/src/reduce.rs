//! From a case that fails to the smallest one that still does.

use crate::case::{Case, Part, Points};

/// Makes a case smaller, step by step, as long as it still fails.
///
/// Takes away parts, rings, vertices and edges, then weights, then digits of coordinates. `fails`
/// must say no to cases that are no figures; it is called some thousand times.
#[must_use]
pub fn reduce(case: &Case, mut fails: impl FnMut(&Case) -> bool) -> Case {
    let mut best = case.clone();
    'again: loop {
        for step in steps(&best) {
            if simpler(&step, &best) && fails(&step) {
                best = step;
                continue 'again;
            }
        }
        return best;
    }
}

/// Counts first, then weights, then the length of the text; so no step can be undone.
fn simpler(a: &Case, b: &Case) -> bool {
    let weight = |case: &Case| {
        let mut bare = case.clone();
        bare.comments.clear();
        let pieces: usize = case.parts.iter().map(pieces).sum();
        let large: f64 = bare
            .clone()
            .parts
            .iter_mut()
            .flat_map(Part::points_mut)
            .flatten()
            .map(|x| x.abs())
            .sum();
        (pieces, bare.to_text().len(), large)
    };
    weight(a) < weight(b)
}

fn pieces(part: &Part) -> usize {
    match part {
        Part::Polygon { rings, .. } => 1 + rings.iter().map(|ring| 1 + ring.len()).sum::<usize>(),
        Part::Line { points, .. } => 1 + points.len(),
        Part::Graph {
            vertices, edges, ..
        } => 1 + vertices.len() + edges.len(),
    }
}

/// All cases one step away, boldest first.
fn steps(case: &Case) -> Vec<Case> {
    let mut found = Vec::new();
    for p in 0..case.parts.len() {
        let mut without = case.clone();
        without.parts.remove(p);
        if !without.parts.is_empty() {
            found.push(without);
        }
    }
    for (p, part) in case.parts.iter().enumerate() {
        for smaller in smaller_parts(part) {
            let mut next = case.clone();
            next.parts[p] = smaller;
            found.push(next);
        }
    }
    found.extend(simpler_numbers(case));
    found
}

/// A part with a piece taken away, or with a weight.
fn smaller_parts(part: &Part) -> Vec<Part> {
    match part {
        Part::Polygon { rings, speeds } => smaller_polygons(rings, speeds),
        Part::Line { points, speeds } => smaller_lines(points, speeds),
        Part::Graph {
            vertices,
            edges,
            speeds,
        } => smaller_graphs(vertices, edges, speeds),
    }
}

fn smaller_polygons(rings: &[Points], speeds: &[Vec<f64>]) -> Vec<Part> {
    type Speeds = Vec<Vec<f64>>;
    let mut found: Vec<(Vec<Points>, Speeds)> = Vec::new();
    let mut change = |f: &dyn Fn(&mut Vec<Points>, &mut Speeds)| {
        let (mut rings, mut speeds) = (rings.to_vec(), speeds.to_vec());
        f(&mut rings, &mut speeds);
        found.push((rings, speeds));
    };
    for r in 0..rings.len() {
        change(&|rings, speeds| {
            rings.remove(r);
            if r < speeds.len() {
                speeds.remove(r);
            }
        });
    }
    for (r, v) in (0..rings.len()).flat_map(|r| (0..rings[r].len()).map(move |v| (r, v))) {
        change(&|rings, speeds| {
            rings[r].remove(v);
            if r < speeds.len() {
                speeds[r].remove(v);
            }
        });
    }
    if !speeds.is_empty() {
        change(&|_, speeds| speeds.clear());
    }
    for (r, v) in (0..speeds.len()).flat_map(|r| (0..speeds[r].len()).map(move |v| (r, v))) {
        change(&|_, speeds| speeds[r][v] = 1.0);
    }
    found.retain(|(rings, _)| rings.first().is_some_and(|ring| ring.len() > 2));
    found
        .into_iter()
        .map(|(rings, speeds)| Part::Polygon { rings, speeds })
        .collect()
}

fn smaller_lines(points: &Points, speeds: &[[f64; 2]]) -> Vec<Part> {
    let mut found: Vec<(Points, Vec<[f64; 2]>)> = Vec::new();
    for v in 0..points.len() {
        let mut next = (points.clone(), speeds.to_vec());
        next.0.remove(v);
        if !next.1.is_empty() {
            next.1.remove(v.min(speeds.len() - 1));
        }
        found.push(next);
    }
    found.extend(
        simpler_speeds(speeds)
            .into_iter()
            .map(|speeds| (points.clone(), speeds)),
    );
    found.retain(|(points, _)| points.len() > 1);
    found
        .into_iter()
        .map(|(points, speeds)| Part::Line { points, speeds })
        .collect()
}

fn smaller_graphs(vertices: &Points, edges: &[[usize; 2]], speeds: &[[f64; 2]]) -> Vec<Part> {
    let mut found = Vec::new();
    for drop in 0..vertices.len() {
        // Without a vertex; its two neighbours are joined if there are just two.
        let around: Vec<usize> = edges
            .iter()
            .filter_map(|&[a, b]| {
                if a == drop {
                    Some(b)
                } else {
                    (b == drop).then_some(a)
                }
            })
            .collect();
        let kept = || (0..edges.len()).filter(|&e| !edges[e].contains(&drop));
        let mut rest: Vec<[usize; 2]> = kept().map(|e| edges[e]).collect();
        let mut its: Vec<[f64; 2]> = kept().filter_map(|e| speeds.get(e).copied()).collect();
        if let [a, b] = around[..] {
            let (mut joined, mut joined_speeds) = (rest.clone(), its.clone());
            joined.push([a, b]);
            if !speeds.is_empty() {
                joined_speeds.push([1.0, 1.0]);
            }
            found.push((joined, joined_speeds));
        }
        found.push((std::mem::take(&mut rest), std::mem::take(&mut its)));
    }
    for e in 0..edges.len() {
        let (mut rest, mut its) = (edges.to_vec(), speeds.to_vec());
        rest.remove(e);
        if !its.is_empty() {
            its.remove(e);
        }
        found.push((rest, its));
    }
    found.extend(
        simpler_speeds(speeds)
            .into_iter()
            .map(|speeds| (edges.to_vec(), speeds)),
    );
    let compact = |(mut edges, speeds): (Vec<[usize; 2]>, Vec<[f64; 2]>)| {
        let used: Vec<usize> = (0..vertices.len())
            .filter(|v| edges.iter().flatten().any(|end| end == v))
            .collect();
        for end in edges.iter_mut().flatten() {
            *end = used.iter().position(|v| v == end).expect("it is used");
        }
        Part::Graph {
            vertices: used.iter().map(|&v| vertices[v]).collect(),
            edges,
            speeds,
        }
    };
    found
        .into_iter()
        .filter(|(edges, _)| !edges.is_empty())
        .map(compact)
        .collect()
}

fn simpler_speeds(speeds: &[[f64; 2]]) -> Vec<Vec<[f64; 2]>> {
    let mut found = Vec::new();
    if !speeds.is_empty() {
        found.push(Vec::new());
    }
    for (i, side) in (0..speeds.len()).flat_map(|i| [(i, 0), (i, 1)]) {
        let mut next = speeds.to_vec();
        next[i][side] = 1.0;
        found.push(next);
    }
    found
}

/// Fewer digits: all numbers at once, then one by one.
fn simpler_numbers(case: &Case) -> Vec<Case> {
    let mut found = Vec::new();
    let mut all = |f: &dyn Fn([f64; 2]) -> [f64; 2]| {
        let mut next = case.clone();
        next.parts
            .iter_mut()
            .flat_map(Part::points_mut)
            .for_each(|point| *point = f(*point).map(|x| x + 0.0));
        found.push(next);
    };
    let mut low = [f64::INFINITY; 2];
    for point in case.clone().parts.iter_mut().flat_map(Part::points_mut) {
        low = [low[0].min(point[0]), low[1].min(point[1])];
    }
    all(&|[x, y]| [x - low[0], y - low[1]]);
    all(&|[x, y]| [x - low[0].round(), y - low[1].round()]);
    for digits in 0..7 {
        let scale = 10.0_f64.powi(digits);
        all(&|p| p.map(|x| (x * scale).round() / scale));
    }
    for factor in [0.1, 0.5] {
        all(&|p| p.map(|x| (x * factor).round()));
        all(&|p| p.map(|x| x * factor));
    }
    let count = case.size();
    for (v, axis) in (0..count).flat_map(|v| [(v, 0), (v, 1)]) {
        let mut one = |f: &dyn Fn(f64) -> f64| {
            let mut next = case.clone();
            let point = next
                .parts
                .iter_mut()
                .flat_map(Part::points_mut)
                .nth(v)
                .expect("it is there");
            point[axis] = f(point[axis]) + 0.0;
            found.push(next);
        };
        one(&f64::round);
        one(&|x| (x * 0.5).round());
        one(&|x| x - x.signum());
        one(&|x| (x * 100.0).round() / 100.0);
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::generate::{Kind, small_of};

    #[test]
    fn any_figure_with_a_hole_shrinks_to_two_triangles() {
        let has_hole = |case: &Case| {
            let holes = case
                .parts
                .iter()
                .any(|part| matches!(part, Part::Polygon { rings, .. } if rings.len() > 1));
            holes && case.figure().is_ok()
        };
        let case = (0..)
            .map(|seed| small_of(Kind::Holes, seed))
            .find(has_hole)
            .expect("some have holes");
        let small = reduce(&case, has_hole);
        assert!(small.size() == 6 && has_hole(&small), "{}", small.to_text());
    }
}
