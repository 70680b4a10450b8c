//! From a case that fails to the smallest one that still does.

use hipline::input::{Change, Place, Sides};

use crate::case::{Case, Part, Points};

/// Makes a case smaller, step by step, as long as it still fails.
///
/// Takes away parts, rings, vertices, edges, changes of speed and heights, then weights, then digits of numbers. `fails`
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
        let pieces =
            case.parts.iter().map(pieces).sum::<usize>() + case.changes.len() + case.heights.len();
        let large: f64 = bare
            .clone()
            .parts
            .iter_mut()
            .flat_map(Part::points_mut)
            .flatten()
            .map(|x| x.abs())
            .chain(case.changes.iter().map(|change| change.time + change.speed))
            .chain(case.heights.iter().map(|(_, height)| *height))
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
        without.renumber(|mut place| {
            let kept = place.part != p;
            place.part -= usize::from(place.part > p);
            kept.then_some(place)
        });
        without.heights.retain_mut(|(place, _)| {
            let kept = place.part != p;
            place.part -= usize::from(place.part > p);
            kept
        });
        if !without.parts.is_empty() {
            found.push(without);
        }
    }
    if !case.changes.is_empty() {
        let mut without = case.clone();
        without.changes.clear();
        found.push(without);
    }
    for (p, part) in case.parts.iter().enumerate() {
        for (smaller, names) in smaller_parts(part) {
            let mut next = case.clone();
            next.heights = heights_of(case, p, &smaller);
            next.parts[p] = smaller;
            next.renumber(|place| {
                if place.part != p {
                    return Some(place);
                }
                let name = names
                    .iter()
                    .find(|(old, _)| *old == [place.ring, place.index]);
                name.map(|&(_, [ring, index])| Place {
                    part: p,
                    ring,
                    index,
                })
            });
            found.push(next);
        }
    }
    found.extend(simpler_changes(case));
    found.extend(simpler_heights(case));
    found.extend(simpler_numbers(case));
    found
}

/// Without one of the changes, or with a simpler one.
fn simpler_changes(case: &Case) -> Vec<Case> {
    let mut found = Vec::new();
    for c in 0..case.changes.len() {
        let mut without = case.clone();
        without.changes.remove(c);
        found.push(without);
        let mut simpler = |f: &dyn Fn(&mut Change)| {
            let mut next = case.clone();
            f(&mut next.changes[c]);
            found.push(next);
        };
        simpler(&|change| change.sides = Sides::Both);
        simpler(&|change| change.time = 1.0);
        simpler(&|change| change.time = change.time.round());
        simpler(&|change| change.time = (change.time * 0.5).ceil());
        simpler(&|change| change.speed = 0.0);
        simpler(&|change| change.speed = 1.0);
        simpler(&|change| change.speed = change.speed.ceil());
    }
    found
}

/// The heights of a case when a part has lost some of its points.
fn heights_of(case: &Case, part: usize, smaller: &Part) -> Vec<(Place, f64)> {
    let names = |content: &Part, found: &dyn Fn([usize; 2], [f64; 2]) -> bool| {
        let points = content.numbered_points().into_iter();
        points
            .filter(|&(name, point)| found(name, point))
            .collect::<Vec<_>>()
    };
    let of = |&(place, height): &(Place, f64)| {
        if place.part != part {
            return vec![(place, height)];
        }
        let old = names(&case.parts[part], &|name, _| {
            name == [place.ring, place.index]
        });
        let is_there = |point: [f64; 2]| {
            old.iter()
                .any(|(_, was)| was.map(f64::to_bits) == point.map(f64::to_bits))
        };
        let new = names(smaller, &|_, point| is_there(point)).into_iter();
        let named = new.map(|([ring, index], _)| (Place { part, ring, index }, height));
        named.collect()
    };
    case.heights.iter().flat_map(of).collect()
}

/// Without one of the heights, or with a simpler one.
fn simpler_heights(case: &Case) -> Vec<Case> {
    let mut found = Vec::new();
    for i in 0..case.heights.len() {
        let mut without = case.clone();
        without.heights.remove(i);
        found.push(without);
        let height = case.heights[i].1;
        for simpler in [1.0, height.ceil(), (height * 0.5).ceil(), height * 0.5] {
            let mut next = case.clone();
            next.heights[i].1 = simpler;
            found.push(next);
        }
    }
    found
}

/// Old and new ring and number of edges.
type Names = Vec<([usize; 2], [usize; 2])>;

/// The names of the edges of ring 0, from their old numbers.
fn names(old: &[usize]) -> Names {
    let numbered = old.iter().enumerate();
    numbered.map(|(new, &old)| ([0, old], [0, new])).collect()
}

/// A part with a piece taken away, or with a weight; and how its edges are called then.
fn smaller_parts(part: &Part) -> Vec<(Part, Names)> {
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

fn smaller_polygons(rings: &[Points], speeds: &[Vec<f64>]) -> Vec<(Part, Names)> {
    type Speeds = Vec<Vec<f64>>;
    type Edges = Vec<Vec<[usize; 2]>>;
    let mut found: Vec<(Vec<Points>, Speeds, Edges)> = Vec::new();
    let olds: Edges = (0..rings.len())
        .map(|r| (0..rings[r].len()).map(|e| [r, e]).collect())
        .collect();
    let mut change = |f: &dyn Fn(&mut Vec<Points>, &mut Speeds, &mut Edges)| {
        let (mut rings, mut speeds, mut olds) = (rings.to_vec(), speeds.to_vec(), olds.clone());
        f(&mut rings, &mut speeds, &mut olds);
        found.push((rings, speeds, olds));
    };
    for r in 0..rings.len() {
        change(&|rings, speeds, olds| {
            rings.remove(r);
            olds.remove(r);
            if r < speeds.len() {
                speeds.remove(r);
            }
        });
    }
    for (r, v) in (0..rings.len()).flat_map(|r| (0..rings[r].len()).map(move |v| (r, v))) {
        change(&|rings, speeds, olds| {
            rings[r].remove(v);
            olds[r].remove(v);
            if r < speeds.len() {
                speeds[r].remove(v);
            }
        });
    }
    if !speeds.is_empty() {
        change(&|_, speeds, _| speeds.clear());
    }
    for (r, v) in (0..speeds.len()).flat_map(|r| (0..speeds[r].len()).map(move |v| (r, v))) {
        change(&|_, speeds, _| speeds[r][v] = 1.0);
    }
    found.retain(|(rings, ..)| rings.first().is_some_and(|ring| ring.len() > 2));
    let named = |(rings, speeds, olds): (Vec<Points>, Speeds, Edges)| {
        let mut names = Names::new();
        for (r, ring) in olds.iter().enumerate() {
            names.extend(ring.iter().enumerate().map(|(e, &old)| (old, [r, e])));
        }
        (Part::Polygon { rings, speeds }, names)
    };
    found.into_iter().map(named).collect()
}

fn smaller_lines(points: &Points, speeds: &[[f64; 2]]) -> Vec<(Part, Names)> {
    let all: Vec<usize> = (0..points.len() - 1).collect();
    let mut found: Vec<(Points, Vec<[f64; 2]>, Vec<usize>)> = Vec::new();
    for v in 0..points.len() {
        let mut next = (points.clone(), speeds.to_vec(), all.clone());
        next.0.remove(v);
        let edge = v.min(all.len() - 1);
        next.2.remove(edge);
        if !next.1.is_empty() {
            next.1.remove(edge);
        }
        found.push(next);
    }
    found.extend(
        simpler_speeds(speeds)
            .into_iter()
            .map(|speeds| (points.clone(), speeds, all.clone())),
    );
    found.retain(|(points, ..)| points.len() > 1);
    found
        .into_iter()
        .map(|(points, speeds, old)| (Part::Line { points, speeds }, names(&old)))
        .collect()
}

fn smaller_graphs(
    vertices: &Points,
    edges: &[[usize; 2]],
    speeds: &[[f64; 2]],
) -> Vec<(Part, Names)> {
    type Parts = (Vec<[usize; 2]>, Vec<[f64; 2]>, Vec<usize>);
    let all: Vec<usize> = (0..edges.len()).collect();
    let mut found: Vec<Parts> = Vec::new();
    for drop in 0..vertices.len() {
        // Without a vertex; its two neighbours are joined if there are just two.
        let around: Vec<(usize, usize)> = edges
            .iter()
            .enumerate()
            .filter_map(|(e, &[a, b])| {
                if a == drop {
                    Some((b, e))
                } else {
                    (b == drop).then_some((a, e))
                }
            })
            .collect();
        let kept: Vec<usize> = (0..edges.len())
            .filter(|&e| !edges[e].contains(&drop))
            .collect();
        let rest: Vec<[usize; 2]> = kept.iter().map(|&e| edges[e]).collect();
        let its: Vec<[f64; 2]> = kept
            .iter()
            .filter_map(|&e| speeds.get(e).copied())
            .collect();
        if let [(a, e), (b, _)] = around[..] {
            let (mut joined, mut its, mut kept) = (rest.clone(), its.clone(), kept.clone());
            joined.push([a, b]);
            kept.push(e);
            its.extend(speeds.get(e));
            found.push((joined, its, kept));
        }
        found.push((rest, its, kept));
    }
    for e in 0..edges.len() {
        let (mut rest, mut its, mut kept) = (edges.to_vec(), speeds.to_vec(), all.clone());
        rest.remove(e);
        kept.remove(e);
        if !its.is_empty() {
            its.remove(e);
        }
        found.push((rest, its, kept));
    }
    found.extend(
        simpler_speeds(speeds)
            .into_iter()
            .map(|speeds| (edges.to_vec(), speeds, all.clone())),
    );
    let compact = |(mut edges, speeds, old): Parts| {
        let used: Vec<usize> = (0..vertices.len())
            .filter(|v| edges.iter().flatten().any(|end| end == v))
            .collect();
        for end in edges.iter_mut().flatten() {
            *end = used.iter().position(|v| v == end).expect("it is used");
        }
        let graph = Part::Graph {
            vertices: used.iter().map(|&v| vertices[v]).collect(),
            edges,
            speeds,
        };
        (graph, names(&old))
    };
    found
        .into_iter()
        .filter(|(edges, ..)| !edges.is_empty())
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
        let mut next = speeds.to_vec();
        next[i][side] = next[i][1 - side];
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
    for factor in [0.1, 0.5] {
        let mut next = case.clone();
        let points = next.parts.iter_mut().flat_map(Part::points_mut);
        points.for_each(|point| *point = point.map(|x| x * factor));
        let changes = next.changes.iter_mut();
        changes.for_each(|change| change.time *= factor);
        let heights = next.heights.iter_mut();
        heights.for_each(|(_, height)| *height *= factor);
        found.push(next);
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
