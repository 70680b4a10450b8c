//! How edges move over time, and how high vertices are: all that a shape has besides places
//! and speeds.
//!
//! Three things make the speed of an edge, and they are independent of each other: its *weight* (a
//! number, kept with the shape), a *profile* (speeds by time, which the weight multiplies) and
//! a *start* (it stands still before). So a gable in a mansard roof is the weight 0 and the profile
//! of all, in whichever order they are given.

use std::collections::{BTreeMap, BTreeSet};

use hipline::{
    FigureBuilder,
    input::{Change, Place, Sides},
};

/// Speeds by time: pairs of a time and the speed from then on.
///
/// ```
/// use hipline_io::Profile;
///
/// let mansard = Profile::new(vec![[0.0, 1.0], [2.5, 4.0]])?;
/// assert_eq!(mansard.pieces()[1], [2.5, 4.0]);
/// assert!(Profile::new(vec![[1.0, 1.0]]).is_err());
/// # Ok::<(), String>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Profile(Vec<[f64; 2]>);

impl Profile {
    /// Checks that the first time is 0, that times increase, and that speeds are not negative.
    ///
    /// # Errors
    /// What is wrong with it, as a sentence.
    pub fn new(pieces: Vec<[f64; 2]>) -> Result<Self, String> {
        let Some([first, _]) = pieces.first() else {
            return Err("a profile has one pair of a time and a speed at least".to_owned());
        };
        if *first != 0.0 {
            return Err(format!(
                "a profile starts at the time 0, and this one at {first}"
            ));
        }
        if let Some([time, speed]) = pieces.iter().find(|p| !p.iter().all(|c| c.is_finite())) {
            return Err(format!(
                "the time {time} with the speed {speed} is not finite"
            ));
        }
        if let Some([_, speed]) = pieces.iter().find(|p| p[1] < 0.0) {
            return Err(format!("a speed must not be below 0, and this is {speed}"));
        }
        if let Some(pair) = pieces.windows(2).find(|pair| pair[0][0] >= pair[1][0]) {
            return Err(format!(
                "the times of a profile increase, but {} comes after {}",
                pair[1][0], pair[0][0]
            ));
        }
        Ok(Self(pieces))
    }

    /// The pairs of a time and the speed from then on; the first time is 0.
    #[must_use]
    pub fn pieces(&self) -> &[[f64; 2]] {
        &self.0
    }

    /// The speed at a time.
    fn at(&self, time: f64) -> f64 {
        let piece = self.0.iter().rev().find(|piece| piece[0] <= time);
        piece.unwrap_or(&self.0[0])[1]
    }

    /// The profile with all speeds multiplied, and another piece in it.
    pub(crate) fn with_piece(&self, factor: f64, piece: [f64; 2]) -> Self {
        let mut pieces = self.0.clone();
        pieces.iter_mut().for_each(|p| p[1] *= factor);
        pieces.retain(|p| p[0].to_bits() != piece[0].to_bits());
        let place = pieces.partition_point(|p| p[0] < piece[0]);
        pieces.insert(place, piece);
        Self(pieces)
    }
}

impl Default for Profile {
    /// The speed 1, always.
    fn default() -> Self {
        Self(vec![[0.0, 1.0]])
    }
}

/// How the edges of one ring, line or graph move, besides their weights, and how high its vertices are.
///
/// Edges and vertices are named by their numbers; those that are not there are found when the
/// figure is built. Pairs are for the left and the right side of an edge; of a ring, whose edges have one
/// speed on both sides, the left one counts.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Motion {
    /// When edges start; others start at the time 0.
    pub starts: BTreeMap<usize, [f64; 2]>,
    /// The profile of edges that have none of their own; without it, their speed is constant.
    pub profile: Option<Profile>,
    /// Profiles of edges.
    pub profiles: BTreeMap<usize, [Option<Profile>; 2]>,
    /// Heights of vertices.
    pub heights: BTreeMap<usize, f64>,
    /// The third coordinates that the file has, point by point; none if it has none at all.
    /// They are heights only if that is asked for: [`Document::heights_from_z`](crate::Document::heights_from_z).
    pub z: Vec<Option<f64>>,
}

impl Motion {
    /// Whether speeds are constant from the time 0 on.
    pub(crate) fn is_steady(&self) -> bool {
        self.starts.is_empty() && self.profile.is_none() && self.profiles.is_empty()
    }

    fn profile_of(&self, edge: usize, side: usize) -> Option<&Profile> {
        let own = self.profiles.get(&edge).and_then(|p| p[side].as_ref());
        own.or(self.profile.as_ref())
    }

    fn start(&self, edge: usize, side: usize) -> f64 {
        self.starts.get(&edge).map_or(0.0, |start| start[side])
    }

    /// The speed of a side of an edge at a time, whether it has started or not.
    fn speed(&self, edge: usize, side: usize, weight: f64, time: f64) -> f64 {
        self.profile_of(edge, side)
            .map_or(weight, |profile| weight * profile.at(time))
    }

    /// The speed of a side (0 left, 1 right) of an edge at the time 0.
    pub(crate) fn first_speed(&self, edge: usize, side: usize, weight: f64) -> f64 {
        if self.start(edge, side) > 0.0 {
            0.0
        } else {
            self.speed(edge, side, weight, 0.0)
        }
    }

    /// The changes of speed after that: pairs of a time and a speed.
    fn changes(&self, edge: usize, side: usize, weight: f64) -> Vec<[f64; 2]> {
        let start = self.start(edge, side);
        let mut changes = Vec::new();
        // What is no time is for the builder to find.
        if start != 0.0 {
            changes.push([start, self.speed(edge, side, weight, start)]);
        }
        if let Some(profile) = self.profile_of(edge, side) {
            let later = profile.0.iter().filter(|p| p[0] > start.max(0.0));
            changes.extend(later.map(|[time, speed]| [*time, weight * speed]));
        }
        changes
    }

    /// Tells a builder of all changes and heights. `weights` are those of the edges that there are.
    pub(crate) fn feed(
        &self,
        builder: &mut FigureBuilder,
        part: usize,
        ring: usize,
        weights: &[[f64; 2]],
    ) {
        let place = |index| Place { part, ring, index };
        let mut edges: BTreeSet<usize> = self
            .starts
            .keys()
            .chain(self.profiles.keys())
            .copied()
            .collect();
        if self.profile.is_some() {
            edges.extend(0..weights.len());
        }
        for edge in edges {
            self.feed_edge(builder, place(edge), weights);
        }
        for (&vertex, &height) in &self.heights {
            builder.elevate(place(vertex), height);
        }
    }

    fn feed_edge(&self, builder: &mut FigureBuilder, edge: Place, weights: &[[f64; 2]]) {
        let mut add = |sides, list: &[[f64; 2]]| {
            for &[time, speed] in list {
                builder.change(Change {
                    edge,
                    sides,
                    time,
                    speed,
                });
            }
        };
        let Some(&weight) = weights.get(edge.index) else {
            // The builder knows how to say that there is no such edge.
            return add(Sides::Both, &[[1.0, 1.0]]);
        };
        let [left, right] = [0, 1].map(|side| self.changes(edge.index, side, weight[side]));
        if left == right {
            add(Sides::Both, &left);
        } else {
            add(Sides::Left, &left);
            add(Sides::Right, &right);
        }
    }
}
