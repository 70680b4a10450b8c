//! Motorcycles and walls that somebody places.

use super::{
    cells::Cells,
    model::{End, MotorcycleGraph},
    pairs::AllPairs,
    race,
    tracks::{Crash, Origin, Track},
    verify::{self, GraphViolation, GraphViolations},
    walls::{Segment, Standing},
};
use crate::{
    predicates::{
        Motion, Place, Planes, Rail, lines_of_wall, pair_of_motion, start_of_motion, wall_of_line,
    },
    topology::{MotorcycleId, WallId},
};
use std::collections::BTreeMap;

/// A motorcycle to be: where and when it starts, and its velocity.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Launch {
    /// Where it starts.
    pub place: [f64; 2],
    /// Its velocity, in units of length per unit of time.
    pub velocity: [f64; 2],
    /// When it starts: any number, mostly 0.
    pub time: f64,
}

impl Launch {
    /// A motorcycle that starts at time zero.
    #[must_use]
    pub const fn new(place: [f64; 2], velocity: [f64; 2]) -> Self {
        Self {
            place,
            velocity,
            time: 0.0,
        }
    }

    /// The same at another time.
    #[must_use]
    pub const fn at(mut self, time: f64) -> Self {
        self.time = time;
        self
    }
}

/// One reason why motorcycles and walls are refused.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum LaunchFlaw {
    /// A number of a motorcycle is infinite or NaN.
    #[error("motorcycle {}: its place, velocity and time have to be finite numbers", .motorcycle.index())]
    NotFinite {
        /// The motorcycle.
        motorcycle: MotorcycleId,
    },
    /// A motorcycle does not move.
    #[error("motorcycle {}: its velocity is zero", .motorcycle.index())]
    NoVelocity {
        /// The motorcycle.
        motorcycle: MotorcycleId,
    },
    /// Two motorcycles are one.
    #[error(
        "motorcycles {} and {}: they start at one place and time with one velocity",
        .first.index(), .second.index()
    )]
    Twins {
        /// The first one.
        first: MotorcycleId,
        /// The other one.
        second: MotorcycleId,
    },
    /// A coordinate of a wall is infinite or NaN.
    #[error("wall {}: its ends have to be finite numbers", .wall.index())]
    WallNotFinite {
        /// The wall.
        wall: WallId,
    },
    /// The ends of a wall are one point.
    #[error("wall {}: its ends are one point", .wall.index())]
    WallIsPoint {
        /// The wall.
        wall: WallId,
    },
    /// A number of a motorcycle is not zero and too small, or too large.
    #[error("motorcycle {}: the size of its numbers has to be between 2^-140 and 2^140, or zero", .motorcycle.index())]
    Range {
        /// The motorcycle.
        motorcycle: MotorcycleId,
    },
    /// A number of a wall is not zero and too small, or too large.
    #[error("wall {}: the size of its numbers has to be between 2^-140 and 2^140, or zero", .wall.index())]
    WallRange {
        /// The wall.
        wall: WallId,
    },
}

/// Motorcycles and walls were refused: every reason, motorcycles first.
#[derive(Debug, Clone, PartialEq)]
pub struct InvalidLaunch {
    /// The flaws.
    pub flaws: Vec<LaunchFlaw>,
}

impl std::fmt::Display for InvalidLaunch {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        for (i, flaw) in self.flaws.iter().enumerate() {
            if i > 0 {
                writeln!(f)?;
            }
            write!(f, "{flaw}")?;
        }
        Ok(())
    }
}

impl std::error::Error for InvalidLaunch {}

/// Whether numbers are zero or of a size with which nothing overflows.
fn in_range(numbers: impl IntoIterator<Item = f64>) -> bool {
    const HIGH: f64 = f64::from_bits((1023 + 140) << 52);
    const LOW: f64 = f64::from_bits((1023 - 140) << 52);
    numbers
        .into_iter()
        .all(|x| x == 0.0 || (LOW..=HIGH).contains(&x.abs()))
}

/// Every flaw.
fn check(launches: &[Launch], walls: &[[[f64; 2]; 2]]) -> Vec<LaunchFlaw> {
    let mut flaws = Vec::new();
    let mut seen = BTreeMap::new();
    for (i, launch) in launches.iter().enumerate() {
        let motorcycle = MotorcycleId::new(i);
        let ([x, y], [v, w]) = (launch.place, launch.velocity);
        let numbers = [x, y, v, w, launch.time];
        if numbers.iter().any(|x| !x.is_finite()) {
            flaws.push(LaunchFlaw::NotFinite { motorcycle });
        } else if v == 0.0 && w == 0.0 {
            flaws.push(LaunchFlaw::NoVelocity { motorcycle });
        } else if !in_range(numbers) {
            flaws.push(LaunchFlaw::Range { motorcycle });
        } else {
            // Zero has one sign.
            let key = numbers.map(|x| (x + 0.0).to_bits());
            let first = *seen.entry(key).or_insert(motorcycle);
            if first != motorcycle {
                flaws.push(LaunchFlaw::Twins {
                    first,
                    second: motorcycle,
                });
            }
        }
    }
    for (i, wall) in walls.iter().enumerate() {
        let number = WallId::new(i);
        let [p, q] = *wall;
        if wall.iter().flatten().any(|x| !x.is_finite()) {
            flaws.push(LaunchFlaw::WallNotFinite { wall: number });
        } else if p[0] - q[0] == 0.0 && p[1] - q[1] == 0.0 {
            flaws.push(LaunchFlaw::WallIsPoint { wall: number });
        } else if !in_range(wall.iter().flatten().copied()) {
            flaws.push(LaunchFlaw::WallRange { wall: number });
        }
    }
    flaws
}

/// The planes of motorcycles and walls, and where each starts.
fn starters(launches: &[Launch], walls: &[[[f64; 2]; 2]]) -> (Planes, Vec<Track>) {
    let motions: Vec<Motion> = (launches.iter())
        .map(|launch| Motion {
            place: launch.place,
            velocity: launch.velocity,
            time: launch.time,
        })
        .collect();
    let planes = Planes::of_motions(&motions, walls);
    let starters = (motions.iter().enumerate())
        .map(|(i, motion)| {
            let pair = pair_of_motion(i);
            // The line across that it passes.
            let line = start_of_motion(i)[usize::from(motion.velocity[0] == 0.0)];
            Track {
                pair,
                origin: Origin::Given,
                start: Place::On {
                    pair,
                    rail: Rail::Edge(line),
                },
                crash: Crash::Escape,
                end: None,
            }
        })
        .collect();
    (planes, starters)
}

impl MotorcycleGraph {
    /// The motorcycle graph of motorcycles and walls that are given.
    ///
    /// A motorcycle stops where it reaches a wall, or the track of another one that was there before; two
    /// that reach one place at one moment both stop, and none starts there. A wall on which a
    /// motorcycle starts does not stop it, unless it runs along it. `docs/motorcycles.md` tells
    /// the rules of all special cases. Walls may cross and touch as they like.
    ///
    /// Exact: every crash is decided by the signs of exact numbers, and what is told is rounded
    /// correctly.
    ///
    /// ```
    /// use hipline::motorcycle::{End, Launch, MotorcycleGraph};
    ///
    /// let launches = [
    ///     Launch::new([0., 0.], [1., 0.]),
    ///     Launch::new([3., -4.], [0., 2.]),
    ///     Launch::new([2., 1.], [-1., 0.]),
    /// ];
    /// let graph = MotorcycleGraph::new(&launches, &[[[0., 0.5], [0., 9.]]])?;
    /// let ends: Vec<End> = graph.motorcycles().iter().map(|m| m.end).collect();
    /// // The first one comes to (3, 0) at the time 3, the second one was there at the time 2.
    /// assert!(matches!(ends[0], End::Track(second) if second.index() == 1));
    /// assert_eq!(ends[1], End::Escape);
    /// assert!(matches!(ends[2], End::Wall(_)));
    /// # Ok::<(), hipline::motorcycle::InvalidLaunch>(())
    /// ```
    ///
    /// # Complexity
    /// Near n log n on ordinary input; O(n^2 log n) where tracks are long and many go the same way.
    ///
    /// # Errors
    /// Every flaw of the input.
    pub fn new(launches: &[Launch], walls: &[[[f64; 2]; 2]]) -> Result<Self, InvalidLaunch> {
        Self::given(launches, walls, false)
    }

    /// The same by a look at all pairs: the definition itself, to check [`MotorcycleGraph::new`] with.
    ///
    /// # Complexity
    /// O(n^2 log n), always.
    ///
    /// # Errors
    /// Every flaw of the input.
    pub fn of_all_pairs(
        launches: &[Launch],
        walls: &[[[f64; 2]; 2]],
    ) -> Result<Self, InvalidLaunch> {
        Self::given(launches, walls, true)
    }

    /// Checks the laws that the motorcycle graph of motorcycles and walls that are given obeys, as
    /// [`MotorcycleGraph::verify`] does for figures.
    ///
    /// # Complexity
    /// Near n log n on ordinary input.
    ///
    /// # Errors
    /// All violations of the first kind of law that is broken. All, too, if the input has flaws.
    pub fn verify_launches(
        &self,
        launches: &[Launch],
        walls: &[[[f64; 2]; 2]],
    ) -> Result<(), GraphViolations> {
        if !check(launches, walls).is_empty() {
            let count = GraphViolation::Count {
                found: self.motorcycles().len(),
                expected: 0,
            };
            return Err(GraphViolations { list: vec![count] });
        }
        let (planes, starters) = starters(launches, walls);
        let places: Vec<_> = starters
            .iter()
            .map(|track| (track.pair, track.start))
            .collect();
        verify::of_launches(self, &planes, &places, walls)
    }

    fn given(
        launches: &[Launch],
        walls: &[[[f64; 2]; 2]],
        all_pairs: bool,
    ) -> Result<Self, InvalidLaunch> {
        let flaws = check(launches, walls);
        if !flaws.is_empty() {
            return Err(InvalidLaunch { flaws });
        }
        let (planes, starters) = starters(launches, walls);
        let count = launches.len();
        let segments: Vec<Segment> = (walls.iter().enumerate())
            .map(|(i, &ends)| {
                let [line, first, last] = lines_of_wall(count, i);
                Segment {
                    ends,
                    line,
                    posts: [first, last],
                }
            })
            .collect();
        let walls = Standing::Walls(segments);
        let tracks = if all_pairs {
            race::run(&planes, starters, AllPairs(walls), false)
        } else {
            let cells = Cells::new(walls, launches.iter().map(|launch| launch.place));
            race::run(&planes, starters, cells, false)
        };
        let wall = |plane| End::Wall(WallId::new(wall_of_line(count, plane)));
        Ok(Self::of_tracks(&planes, &tracks, wall, |_| None))
    }
}
