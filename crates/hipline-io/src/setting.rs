//! Weights and heights that are given apart from a file: by a table, or by options.
//!
//! A setting names its target and what it is to have. What is general is applied before what is
//! particular, so the order of settings does not matter; two different ones for the very same
//! target are an error, and so is a target that is not there.

use std::{collections::HashMap, fmt, str::FromStr};

use hipline::input::Sides;

use crate::{
    Document, FeatureName, Profile,
    chain::{Chain, chains},
};

/// Which edges or vertices are meant: `None` stands for all.
///
/// As text: `EDGE` (of ring 0), `RING:EDGE` or `FEATURE:RING:EDGE`, each of them a number from 0 or
/// `*` for all; `*` alone stands for all edges of all rings. Rings and lines are numbered through the feature, in
/// the order of the file.
///
/// ```
/// use hipline_io::Target;
///
/// let target: Target = "yard:1:*".parse()?;
/// assert_eq!(target, Target { feature: Some("yard".into()), ring: Some(1), index: None });
/// assert_eq!("7".parse(), Ok(Target { feature: None, ring: Some(0), index: Some(7) }));
/// # Ok::<(), String>(())
/// ```
#[derive(Debug, Clone, PartialEq, Eq, Hash, Default)]
pub struct Target {
    /// The feature: the id of one or several; if none has it, the number of one.
    pub feature: Option<String>,
    /// The ring or line.
    pub ring: Option<usize>,
    /// The edge or vertex.
    pub index: Option<usize>,
}

impl Target {
    /// How many of its parts are named.
    fn rank(&self) -> usize {
        usize::from(self.feature.is_some())
            + usize::from(self.ring.is_some())
            + usize::from(self.index.is_some())
    }
}

impl FromStr for Target {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        // An id may have colons, numbers have none.
        let mut parts = text.rsplitn(3, ':').map(str::trim);
        let number = |part: &str| match part {
            "*" => Ok(None),
            _ => part.parse().map(Some).map_err(|_| {
                format!(
                    "{} is neither a number from 0 nor *",
                    crate::read::short(part)
                )
            }),
        };
        let index = number(parts.next().unwrap_or_default())?;
        let ring = match parts.next() {
            Some(ring) => number(ring)?,
            None => index.map(|_| 0),
        };
        let feature = parts.next().filter(|name| *name != "*");
        Ok(Self {
            feature: feature.map(str::to_owned),
            ring,
            index,
        })
    }
}

/// What a target is to have.
#[derive(Debug, Clone, PartialEq)]
pub enum Value {
    /// A weight: the speed, which a profile multiplies.
    Weight(f64),
    /// A speed from a time on; before that, what holds otherwise. The edge has a profile of its own
    /// then.
    From {
        /// The time, greater than 0.
        time: f64,
        /// The speed.
        speed: f64,
    },
    /// When it starts to move.
    Start(f64),
    /// A profile.
    Profile(Profile),
    /// The height of a vertex.
    Height(f64),
}

/// One thing that is given.
#[derive(Debug, Clone, PartialEq)]
pub struct Setting {
    /// To which edges or vertices.
    pub target: Target,
    /// On which sides; of no meaning for heights.
    pub sides: Sides,
    /// What.
    pub value: Value,
    /// How errors call it, such as `--weight 3=2` or `line 7 of speeds.csv`.
    pub origin: String,
}

/// A setting that cannot be.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("{origin}: {message}")]
pub struct SettingError {
    /// Where the setting comes from.
    pub origin: String,
    /// What is wrong with it.
    pub message: String,
}

/// Every setting that cannot be; its message lists the first 20, one a line.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct SettingErrors(pub Vec<SettingError>);

impl std::error::Error for SettingErrors {}

impl fmt::Display for SettingErrors {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        const SHOWN: usize = 20;
        for (i, error) in self.0.iter().take(SHOWN).enumerate() {
            write!(f, "{}{error}", if i == 0 { "" } else { "\n" })?;
        }
        if self.0.len() > SHOWN {
            write!(f, "\nand {} more", self.0.len() - SHOWN)?;
        }
        Ok(())
    }
}

impl Document {
    /// Gives edges weights, profiles and starts, and vertices heights. They replace those of the file.
    /// Settings for all features pass over empty ones.
    ///
    /// # Errors
    /// Every setting that names what is not there, that contradicts another one, or that is for one
    /// side of a polygon's edge. The document is then in part changed.
    ///
    /// # Complexity
    /// Linear in the size of the document and of the settings, with those for all features counted
    /// once for each.
    pub fn set(&mut self, settings: &[Setting]) -> Result<(), SettingErrors> {
        let mut errors = contradictions(settings);
        let mut order: Vec<&Setting> = settings.iter().collect();
        // A speed from a time on holds whatever it was before: it comes last.
        let is_from = |value: &Value| matches!(value, Value::From { .. });
        order.sort_by_key(|setting| (is_from(&setting.value), setting.target.rank()));
        let mut per_feature: Vec<Vec<&Setting>> = vec![Vec::new(); self.features.len()];
        let mut by_id: HashMap<&str, Vec<usize>> = HashMap::new();
        for (i, feature) in self.features.iter().enumerate() {
            if let Some(id) = &feature.id {
                by_id.entry(id).or_default().push(i);
            }
        }
        for setting in order {
            let Some(name) = &setting.target.feature else {
                per_feature.iter_mut().for_each(|list| list.push(setting));
                continue;
            };
            let number = name.parse().ok().filter(|i| *i < self.features.len());
            let meant = by_id.get(name.as_str()).cloned();
            let meant = meant.unwrap_or_else(|| number.into_iter().collect());
            if meant.is_empty() {
                let name = crate::read::short(name);
                errors.push(setting.wrong(format!("there is no feature {name}")));
            }
            meant.iter().for_each(|&i| per_feature[i].push(setting));
        }
        for (feature, list) in self.features.iter_mut().zip(per_feature) {
            if list.is_empty() {
                continue;
            }
            let name = feature.name();
            let is_empty = feature.case.is_empty();
            let mut chains = chains(&mut feature.case);
            for setting in list {
                if is_empty && setting.target.feature.is_none() {
                    continue;
                }
                if let Err(message) = setting.apply(&mut chains) {
                    errors.push(setting.wrong(format!("{name}: {message}")));
                }
            }
        }
        if errors.is_empty() {
            Ok(())
        } else {
            Err(SettingErrors(errors))
        }
    }

    /// Takes the third coordinates of the file as heights of all vertices that have no other height.
    ///
    /// # Errors
    /// The first vertex without a third coordinate, and the first ring whose last point repeats its first
    /// one at another height, with the feature's name.
    pub fn heights_from_z(&mut self) -> Result<(), (FeatureName, String)> {
        for feature in &mut self.features {
            let name = feature.name();
            crate::chain::heights_from_z(&mut feature.case).map_err(|message| (name, message))?;
        }
        Ok(())
    }

    /// Divides all heights of vertices by a slope, which makes times of them: heights of a surface that
    /// rises by `slope` for each unit of time. Each quotient is rounded once.
    pub fn divide_heights(&mut self, slope: f64) {
        for feature in &mut self.features {
            for chain in chains(&mut feature.case) {
                for height in chain.motion.heights.values_mut() {
                    *height /= slope;
                }
            }
        }
    }
}

/// Different settings for the very same target.
fn contradictions(settings: &[Setting]) -> Vec<SettingError> {
    let mut errors = Vec::new();
    let mut seen: HashMap<(&Target, u64, Option<bool>), &Setting> = HashMap::new();
    for setting in settings {
        // A time is never negative, so its bits are below these.
        let kind = match &setting.value {
            Value::From { time, .. } => time.to_bits(),
            Value::Weight(_) => u64::MAX,
            Value::Start(_) => u64::MAX - 1,
            Value::Profile(_) => u64::MAX - 2,
            Value::Height(_) => u64::MAX - 3,
        };
        let sides = match (&setting.value, setting.sides) {
            (Value::Height(_), _) => vec![None],
            (_, Sides::Left) => vec![Some(false)],
            (_, Sides::Right) => vec![Some(true)],
            (_, Sides::Both) => vec![Some(false), Some(true)],
        };
        for side in sides {
            let first = *seen.entry((&setting.target, kind, side)).or_insert(setting);
            if first.value != setting.value {
                errors.push(setting.wrong(format!("{} says otherwise", first.origin)));
                break;
            }
        }
    }
    errors
}

impl Setting {
    fn wrong(&self, message: String) -> SettingError {
        SettingError {
            origin: self.origin.clone(),
            message,
        }
    }

    fn apply(&self, chains: &mut [Chain]) -> Result<(), String> {
        let count = chains.len();
        match self.target.ring {
            None => chains
                .iter_mut()
                .enumerate()
                .try_for_each(|(i, chain)| self.apply_to(chain, i)),
            Some(i) => match chains.get_mut(i) {
                Some(chain) => self.apply_to(chain, i),
                None => Err(format!(
                    "there is no ring or line {i}, only {count} of them"
                )),
            },
        }
    }

    fn apply_to(&self, chain: &mut Chain, ring: usize) -> Result<(), String> {
        let is_height = matches!(self.value, Value::Height(_));
        let (what, count) = if is_height {
            ("vertex", chain.vertices)
        } else {
            ("edge", chain.edges)
        };
        if let Some(index) = self.target.index.filter(|index| *index >= count) {
            return Err(format!(
                "there is no {what} {index} in ring or line {ring}, which has {count}"
            ));
        }
        if chain.is_ring() && self.sides != Sides::Both && !is_height {
            return Err(format!(
                "ring {ring} is of a polygon, whose edges move alike on both sides"
            ));
        }
        if let (Value::Profile(profile), None) = (&self.value, self.target.index)
            && self.sides == Sides::Both
        {
            chain.motion.profiles.clear();
            chain.motion.profile = Some(profile.clone());
            return Ok(());
        }
        let indices = self.target.index.map_or(0..count, |index| index..index + 1);
        for index in indices {
            if let Value::Height(height) = self.value {
                chain.motion.heights.insert(index, height);
                continue;
            }
            for side in [0, 1] {
                if self.sides != (if side == 0 { Sides::Right } else { Sides::Left }) {
                    self.apply_to_side(chain, index, side);
                }
            }
        }
        Ok(())
    }

    fn apply_to_side(&self, chain: &mut Chain, edge: usize, side: usize) {
        let mut weight = chain.weight(edge);
        match &self.value {
            Value::Weight(w) => {
                weight[side] = *w;
                chain.set_weight(edge, weight);
            }
            Value::From { time, speed } => {
                let common = chain.motion.profile.clone();
                let own = &mut chain.motion.profiles.entry(edge).or_default()[side];
                let before = own.take().or(common).unwrap_or_default();
                *own = Some(before.with_piece(weight[side], [*time, *speed]));
                // The right side of a ring's edge has the weight of its left one: it comes last.
                if !chain.is_ring() || side == 1 {
                    weight[side] = 1.0;
                    weight[0] = if chain.is_ring() { 1.0 } else { weight[0] };
                    chain.set_weight(edge, weight);
                }
            }
            Value::Start(start) => {
                chain.motion.starts.entry(edge).or_default()[side] = *start;
            }
            Value::Profile(profile) => {
                chain.motion.profiles.entry(edge).or_default()[side] = Some(profile.clone());
            }
            Value::Height(_) => unreachable!("heights belong to vertices"),
        }
    }
}
