//! Maps of cases under which results must map along.

use hipline::input::{Change, Place, Sides};

use crate::agreement::{Drawn, End};
use crate::case::{Case, Part};
use crate::generate::Random;

/// A map of the plane, or another description of the same input.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Map {
    /// (x, y) to (y, x).
    SwapAxes,
    /// (x, y) to (-x, y).
    Mirror,
    /// (x, y) to (-y, x).
    Turn,
    /// Times 2 to a power.
    Scale(i32),
    /// Moved by integers.
    Translate([i32; 2]),
    /// Rings start at another vertex (by this many).
    Start(usize),
    /// Parts, and holes of polygons, in another order (of this seed).
    Order(u64),
}

impl Map {
    /// One of each.
    #[must_use]
    pub const fn some() -> [Self; 8] {
        [
            Self::SwapAxes,
            Self::Mirror,
            Self::Turn,
            Self::Scale(5),
            Self::Scale(-3),
            Self::Translate([1000, -77]),
            Self::Start(1),
            Self::Order(7),
        ]
    }

    /// Whether left becomes right. Then ties between equally fast edges on either side of a slower
    /// one may be decided the other way.
    #[must_use]
    pub const fn swaps_sides(self) -> bool {
        matches!(self, Self::SwapAxes | Self::Mirror)
    }

    /// Whether coordinates are only equal up to rounding afterwards (times are always exact).
    #[must_use]
    pub const fn rounds(self) -> bool {
        matches!(self, Self::Translate(_))
    }

    /// Whether edges keep their numbers.
    #[must_use]
    pub const fn keeps_names(self) -> bool {
        !matches!(self, Self::Start(_) | Self::Order(_))
    }

    fn point(self, [x, y]: [f64; 2]) -> [f64; 2] {
        match self {
            Self::Translate([dx, dy]) => [x + f64::from(dx), y + f64::from(dy)],
            other => other.vector([x, y]),
        }
    }

    fn vector(self, [x, y]: [f64; 2]) -> [f64; 2] {
        match self {
            Self::SwapAxes => [y, x],
            Self::Mirror => [-x, y],
            Self::Turn => [-y, x],
            Self::Scale(power) => [x * 2.0_f64.powi(power), y * 2.0_f64.powi(power)],
            Self::Translate(_) | Self::Start(_) | Self::Order(_) => [x, y],
        }
    }

    /// The mapped case. (Of translations, only exact ones are laws: see that coordinates are
    /// integers or the like.)
    #[must_use]
    pub fn apply(self, before: &Case) -> Case {
        let mut case = before.clone();
        for part in &mut case.parts {
            part.points_mut()
                .for_each(|point| *point = self.point(*point).map(|x| x + 0.0));
            match part {
                Part::Line { speeds, .. } | Part::Graph { speeds, .. } if self.swaps_sides() => {
                    speeds.iter_mut().for_each(|speeds| speeds.reverse());
                }
                Part::Polygon { rings, speeds } => match self {
                    Self::Start(by) => {
                        rings.iter_mut().for_each(|ring| rotate(ring, by));
                        speeds.iter_mut().for_each(|speeds| rotate(speeds, by));
                    }
                    Self::Order(seed) if rings.len() > 1 => {
                        // The same seed shuffles both in the same way.
                        Random::new(seed).shuffle(&mut rings[1..]);
                        if speeds.len() > 1 {
                            Random::new(seed).shuffle(&mut speeds[1..]);
                        }
                    }
                    _ => {}
                },
                _ => {}
            }
        }
        if let Self::Order(seed) = self {
            Random::new(seed).shuffle(&mut case.parts);
        }
        case.changes = before
            .changes
            .iter()
            .map(|change| self.change(before, change))
            .collect();
        for (vertex, height) in &mut case.heights {
            // In rings, which alone may start elsewhere, edges have the numbers of the vertices.
            *vertex = self.place(before, *vertex);
            if let Self::Scale(power) = self {
                *height *= 2.0_f64.powi(power);
            }
        }
        case
    }

    /// A change of speed, mapped.
    fn change(self, before: &Case, change: &Change) -> Change {
        let mut change = *change;
        change.edge = self.place(before, change.edge);
        match self {
            Self::SwapAxes | Self::Mirror => {
                change.sides = match change.sides {
                    Sides::Left => Sides::Right,
                    Sides::Right => Sides::Left,
                    Sides::Both => Sides::Both,
                };
            }
            Self::Scale(power) => change.time *= 2.0_f64.powi(power),
            _ => {}
        }
        change
    }

    /// The new name of an edge, or of a vertex.
    fn place(self, before: &Case, mut place: Place) -> Place {
        let Place { part, ring, index } = place;
        match self {
            Self::Start(by) => {
                if let Part::Polygon { rings, .. } = &before.parts[part] {
                    let count = rings[ring].len();
                    place.index = (index + count - by % count) % count;
                }
            }
            Self::Order(seed) => {
                let shuffled = |count: usize, of: usize| {
                    let mut order: Vec<usize> = (0..count).collect();
                    Random::new(seed).shuffle(&mut order);
                    order.iter().position(|&old| old == of).expect("in range")
                };
                if let Part::Polygon { rings, .. } = &before.parts[part]
                    && ring > 0
                {
                    place.ring = 1 + shuffled(rings.len() - 1, ring - 1);
                }
                place.part = shuffled(before.parts.len(), part);
            }
            _ => {}
        }
        place
    }

    /// An arc's end, mapped. Scaling scales times too; speeds stay as they are.
    #[must_use]
    pub fn end(self, end: &End) -> End {
        let time = if let Self::Scale(power) = self {
            end.time() * 2.0_f64.powi(power)
        } else {
            end.time()
        };
        let direction = end.direction().map(|v| {
            if let Self::Scale(_) = self {
                v
            } else {
                self.vector(v)
            }
        });
        End::new(self.point(end.place()), time, direction)
    }

    /// Whether the arcs of a mapped case are those of the case, mapped.
    ///
    /// # Errors
    /// The first arcs that differ, in words.
    pub fn check(self, before: &[Drawn], after: &[Drawn]) -> Result<(), String> {
        if before.len() != after.len() {
            return Err(format!(
                "{self:?}: {} arcs become {}",
                before.len(),
                after.len()
            ));
        }
        if self.rounds() {
            return self.check_rounded(before, after);
        }
        // Names of faces are left out: with other numbers or sides they change.
        let bare = |arc: &Drawn, map: Self| {
            let mut ends = arc.ends.map(|end| map.end(&end));
            ends.sort_unstable();
            (ends, arc.kind() as u8)
        };
        let mut mapped: Vec<_> = before.iter().map(|arc| bare(arc, self)).collect();
        let mut found: Vec<_> = after.iter().map(|arc| bare(arc, Self::Start(0))).collect();
        mapped.sort_unstable();
        found.sort_unstable();
        match mapped.iter().zip(&found).find(|(due, found)| due != found) {
            None => Ok(()),
            Some((due, found)) => Err(format!("{self:?}: {due:?} became {found:?}")),
        }
    }

    /// Equal faces, kinds and times; places within rounding.
    fn check_rounded(self, before: &[Drawn], after: &[Drawn]) -> Result<(), String> {
        let mut left: Vec<&Drawn> = after.iter().collect();
        for arc in before {
            let due = arc.ends.map(|end| self.end(&end));
            let near = |found: &End, due: &End| {
                let slack = |k: usize| 4.0 * f64::EPSILON * (2000.0 + due.place()[k].abs());
                let close = (0..2).all(|k| (found.place()[k] - due.place()[k]).abs() <= slack(k));
                close
                    && found.time().total_cmp(&due.time()).is_eq()
                    && found.direction() == due.direction()
            };
            let same = |found: &&Drawn| {
                let ([a, b], [p, q]) = (&found.ends, &due);
                let straight = found.faces == arc.faces && near(a, p) && near(b, q);
                let [f, g] = found.faces;
                // Rounding may order the ends of an arc of one height the other way.
                let turned = [g, f] == arc.faces && near(a, q) && near(b, p);
                found.kind() == arc.kind() && (straight || turned)
            };
            let Some(found) = left.iter().position(same) else {
                return Err(format!("{self:?}: nothing like {arc}"));
            };
            left.swap_remove(found);
        }
        Ok(())
    }
}

fn rotate<T>(list: &mut [T], by: usize) {
    if !list.is_empty() {
        let by = by % list.len();
        list.rotate_left(by);
    }
}
