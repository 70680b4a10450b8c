//! Balanced cuts: chords of a cell with at most two thirds of its extended valleys on either side (Lemma 14 of the thesis).
//!
//! The boundary of a cell with its extended valleys is an outerplanar graph ([`outerplanar`](super::outerplanar)). In the tree that is the dual of its triangulation,
//! each extended valley has weight one. Of the sides of triangles, the one with the least weight on its heavier side is taken: the lemma's centroid has
//! such a side with two thirds at most.
//!
//! *Where it departs from the thesis.* The cut goes not through the ends of the side but beside them, away from the valleys there: through a point in f64 and
//! in a direction of small integers, with as many digits as the room there is needs. All this is done with rounded coordinates: it tells
//! where to cut, not what is cut. Valleys whose motorcycles stop in the cell would cross others if extended: they count where they start, and cuts cross
//! their tracks close to the end.

use super::{
    Envelope,
    boundary::Cell,
    outerplanar::{Outerplanar, Side, Stub},
    section::Cut,
};
use hipline_num::{exponent, power_of_two};

/// Beside so many sides of triangles lines are looked for.
const SIDES: usize = 3;

/// The valley of a motorcycle that crashes into the track of another one ends earlier, but how much is not known: cuts that cross its
/// track after these parts of it are tried.
const STUBS: [f64; 2] = [0.9375, 0.9990234375];

/// Directions have so many binary digits at most.
const DIGITS: i32 = 24;

/// A line that may be a cut.
struct Trial {
    point: [f64; 2],
    toward: [i32; 2],
}

impl Envelope<'_> {
    /// Cuts between the valleys of a cell without holes, those that divide them most evenly first.
    ///
    /// # Complexity
    /// O(k log k) for k edges, but for finding where valleys leave the cell.
    pub(super) fn chords(&self, cell: &Cell) -> Vec<Cut> {
        let Some(graph) = Outerplanar::new(self, cell) else {
            return Vec::new();
        };
        let Some(mut sides) = graph.sides() else {
            return Vec::new();
        };
        let count = graph.points.len();
        let longer = |side: &Side| {
            let [i, j] = side.ends;
            let steps = (j + count - i) % count;
            steps.max(count - steps)
        };
        sides.sort_by_key(|side| (side.most, longer(side)));
        let is_balanced = |side: &Side| 3 * side.most <= 2 * graph.chords.len() + 2;
        debug_assert!(!graph.stubs.is_empty() || sides.first().is_none_or(is_balanced));
        let parts = if graph.stubs.is_empty() {
            &STUBS[..1]
        } else {
            &STUBS
        };
        let mut cuts = Vec::new();
        for side in sides.iter().take(SIDES) {
            for &part in parts {
                if let Some(line) = beside(&graph, side, part) {
                    cuts.push(Cut::chord(&self.planes, line.point, line.toward));
                }
            }
        }
        cuts
    }
}

/// A line beside the side of a triangle that crosses no valley.
fn beside(graph: &Outerplanar, side: &Side, stub: f64) -> Option<Trial> {
    let count = graph.points.len();
    let [i, j] = side.ends;
    // Whether the valley that an end of the side has is on its right.
    let on_right = |end: usize| {
        if let Some(of) = graph.chords.iter().find(|c| c.ends.contains(&end)) {
            let other = of.ends[usize::from(of.ends[0] == end)];
            return Some((other + count - i) % count < (j + count - i) % count);
        }
        let of = graph.stubs.iter().find(|stub| stub.start == end)?;
        let [p, q] = [i, j].map(|k| graph.points[k]);
        let [u, v, x, y] = [q[0] - p[0], q[1] - p[1], of.end[0] - p[0], of.end[1] - p[1]];
        Some(u * y - v * x < 0.0)
    };
    let is_left = match side.is_left {
        Some(is_left) => [is_left; 2],
        None => {
            let wanted = [on_right(i), on_right(j)];
            let any = wanted[0].or(wanted[1]).unwrap_or(true);
            wanted.map(|one| one.unwrap_or(any))
        }
    };
    let next = |k: usize, forward: bool| (k + if forward { 1 } else { count - 1 }) % count;
    let neighbours = [next(i, !is_left[0]), next(j, is_left[1])];
    let ends = side.ends.map(|k| graph.points[k]);
    let neighbours = neighbours.map(|k| graph.points[k]);
    [1, 3, 5, 8, 12].into_iter().find_map(|k| {
        let near = power_of_two(-k);
        let moved =
            [0, 1].map(|e| [0, 1].map(|x| ends[e][x] + near * (neighbours[e][x] - ends[e][x])));
        let trial = short_line(ends, moved)?;
        graph
            .divided(trial.point, trial.toward, stub)
            .is_some_and(|most| most <= side.most)
            .then_some(trial)
    })
}

/// A line with few digits about half way between one through two points and another one.
fn short_line(ends: [[f64; 2]; 2], moved: [[f64; 2]; 2]) -> Option<Trial> {
    let along = [0, 1].map(|k| moved[1][k] - moved[0][k]);
    let length = along[0].abs().max(along[1].abs());
    let apart = |e: usize| {
        let [u, v] = [0, 1].map(|k| moved[e][k] - ends[e][k]);
        (u * along[1] - v * along[0]).abs() / length
    };
    let room = apart(0).min(apart(1)) / 4.0;
    if !(room > 0.0 && length.is_finite()) {
        return None;
    }
    let digits = (exponent(length) - exponent(room)).max(2);
    if digits > DIGITS {
        return None;
    }
    let unit = power_of_two(exponent(length) - digits);
    let toward = along.map(|d| (d / unit).round() as i32);
    let grain = power_of_two(exponent(room).max(-900));
    let point = [0, 1].map(|k| (moved[0][k].midpoint(moved[1][k]) / grain).round() * grain);
    Some(Trial { point, toward })
}

impl Outerplanar {
    /// How many valleys are on the larger side of a line's stretch around a point, those that it crosses among them; `None` if
    /// the point is not inside.
    fn divided(&self, point: [f64; 2], toward: [i32; 2], stub: f64) -> Option<usize> {
        let [dx, dy] = toward.map(f64::from);
        let count = self.points.len();
        let place = |p: [f64; 2]| {
            let [x, y] = [0, 1].map(|i| p[i] - point[i]);
            (dx * y - dy * x, dx * x + dy * y)
        };
        let at = |k: usize| place(self.points[k]);
        // The corners before which the boundary crosses the line, nearest to the point, and whether from its left.
        let mut ends = [(f64::NEG_INFINITY, None), (f64::INFINITY, None)];
        let mut last = at(count - 1);
        for k in 0..count {
            let this = at(k);
            let [from, to] = [last.0, this.0].map(|side| side > 0.0);
            if from != to {
                let t = (last.1 * this.0 - this.1 * last.0) / (this.0 - last.0);
                let end = usize::from(t > 0.0);
                let is_nearer = if end == 0 {
                    t > ends[0].0
                } else {
                    t < ends[1].0
                };
                if is_nearer {
                    ends[end] = (t, Some((k, from)));
                }
            }
            last = this;
        }
        let [(_, Some((enter, true))), (_, Some((leave, false)))] = ends else {
            return None;
        };
        let is_left = |k: usize| (k + count - leave) % count < (enter + count - leave) % count;
        let mut counts = [0; 3];
        let mut add = |ends: [bool; 2]| {
            let both = usize::from(ends[0]);
            counts[if ends[0] == ends[1] { both } else { 2 }] += 1;
        };
        for chord in &self.chords {
            add(chord.ends.map(is_left));
        }
        for Stub { start, end } in &self.stubs {
            let from = self.points[*start];
            let to = [0, 1].map(|k| from[k] + stub * (end[k] - from[k]));
            add([is_left(*start), place(to).0 > 0.0]);
        }
        Some(counts[0].max(counts[1]) + counts[2])
    }
}
