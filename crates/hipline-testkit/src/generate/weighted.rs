//! Small cases with speeds of zero and speeds that change, mostly at the moments of events.

use hipline::input::{Change, Place, Sides};

use super::random::Random;
use super::small::{Kind, small_of};
use crate::case::{Case, Part};

/// How a case is weighted.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Weights {
    /// Some edges stand still for ever.
    Still,
    /// Some edges start late.
    Late,
    /// All edges change their speed at the same times, in the same way.
    Profile,
    /// All edges change their speed at the same times, each in its own way.
    Breaks,
    /// Some edges come to rest.
    Flat,
    /// Anything at any time.
    Wild,
}

impl Weights {
    /// All of them.
    pub const ALL: [Self; 6] = [
        Self::Still,
        Self::Late,
        Self::Profile,
        Self::Breaks,
        Self::Flat,
        Self::Wild,
    ];
}

/// The weighted small case of a seed: any kind of figure, any kind of weights. Its seeds are apart
/// from those of [`small`](super::small).
#[must_use]
pub fn small_weighted(seed: u64) -> Case {
    let mut random = Random::new(seed ^ 0x77ee_1847);
    let kind = *random.pick(&Kind::ALL);
    let weights = *random.pick(&Weights::ALL);
    let mut case = small_of(kind, random.next());
    case.comments = vec![format!("small_weighted({seed}): {kind:?}, {weights:?}")];
    change_speeds(&mut case, weights, &mut random);
    case
}

/// Gives speeds and changes of speed to a case that has none.
pub fn change_speeds(case: &mut Case, weights: Weights, random: &mut Random) {
    let same_sides = random.one_in(2);
    let few = random.one_in(2);
    let times = times(random);
    let profile: Vec<f64> = (0..3).map(|_| any_speed(random)).collect();
    let flat = random.one_in(2);
    for place in case.places() {
        let sides: &[Sides] = if same_sides {
            &[Sides::Both]
        } else {
            &[Sides::Left, Sides::Right]
        };
        for &side in sides {
            let mut speed = 1.0;
            let mut changes: Vec<[f64; 2]> = Vec::new();
            match weights {
                Weights::Still => {
                    speed = *random.pick(&[0.0, 0.0, 1.0, 1.0, 1.0, 2.0]);
                }
                Weights::Late => {
                    if random.one_in(if few { 3 } else { 2 }) {
                        let after = if flat { 1.0 } else { positive(random) };
                        speed = 0.0;
                        changes.push([*random.pick(&times), after]);
                    }
                }
                Weights::Profile => {
                    changes.extend(times.iter().zip(&profile).map(|(&t, &w)| [t, w]));
                }
                Weights::Breaks => {
                    speed = any_speed(random);
                    let each = times.iter().take(if few { 1 } else { 3 });
                    changes.extend(each.map(|&t| [t, any_speed(random)]));
                }
                Weights::Flat => {
                    speed = positive(random);
                    if random.one_in(2) {
                        changes.push([*random.pick(&times), 0.0]);
                    }
                }
                Weights::Wild => {
                    speed = any_speed(random);
                    for _ in 0..random.below(3) {
                        changes.push([*random.pick(&times), any_speed(random)]);
                    }
                }
            }
            changes.sort_by(|a, b| a[0].total_cmp(&b[0]));
            changes.dedup_by_key(|change| change[0].to_bits());
            set_speed(case, place, side, speed);
            case.changes
                .extend(changes.iter().map(|&[time, speed]| Change {
                    edge: place,
                    sides: side,
                    time,
                    speed,
                }));
        }
    }
}

/// One to three times in ascending order, such as have events on grids.
fn times(random: &mut Random) -> Vec<f64> {
    let choices = [1.0, 1.0, 0.5, 0.5, 2.0, 1.5, 0.25, 3.0, 0.75];
    let count = random.range(1, 3);
    let mut times: Vec<f64> = (0..count).map(|_| *random.pick(&choices)).collect();
    times.sort_by(f64::total_cmp);
    times.dedup_by_key(|time| time.to_bits());
    times
}

fn positive(random: &mut Random) -> f64 {
    *random.pick(&[1.0, 1.0, 1.0, 2.0, 0.5, 3.0])
}

fn any_speed(random: &mut Random) -> f64 {
    *random.pick(&[1.0, 1.0, 1.0, 0.0, 0.0, 2.0, 0.5])
}

/// Sets the speed of an edge on one side or both, where the sides of a ring's edge have but one.
fn set_speed(case: &mut Case, place: Place, side: Sides, speed: f64) {
    let Place { part, ring, index } = place;
    let count = case.edges(part, ring);
    match &mut case.parts[part] {
        Part::Polygon { rings, speeds } => {
            if speeds.is_empty() {
                *speeds = rings.iter().map(|ring| vec![1.0; ring.len()]).collect();
            }
            speeds[ring][index] = speed;
        }
        Part::Line { speeds, .. } | Part::Graph { speeds, .. } => {
            speeds.resize(count, [1.0; 2]);
            if side != Sides::Right {
                speeds[index][0] = speed;
            }
            if side != Sides::Left {
                speeds[index][1] = speed;
            }
        }
    }
}
