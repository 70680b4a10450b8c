//! The properties of GeoJSON features that tell how edges move and how high vertices are:
//! `edge_weights`, `edge_starts`, `profile`, `edge_profiles`, `vertex_heights`, `heights_from_z`.
//!
//! Lists have one entry for each ring or line, in the order of the file: a list with one item for
//! each edge or vertex, or one item for all of them. One item in place of everything holds for
//! all. Of a geometry with a single ring or line, the list of its items may stand
//! alone. On lines, `[left, right]` may stand for a number of an edge.

use serde_json::{Map, Value};

use crate::{
    chain::{Chain, chains, heights_from_z},
    document::Shape,
    motion::Profile,
    read::short,
};

/// A property that is a list of lists.
struct Property {
    name: &'static str,
    /// What its items belong to.
    what: &'static str,
    /// How many of these a ring or line has.
    count: fn(&Chain) -> usize,
    /// Whether a value is an item, and not a list of such.
    is_item: fn(&Value) -> bool,
    /// Gives an edge or vertex its item.
    give: fn(&mut Chain, usize, &Value) -> Result<(), String>,
}

const PROPERTIES: [Property; 4] = [
    Property {
        name: "edge_weights",
        what: "edge",
        count: |chain| chain.edges,
        is_item: |value| !value.is_array(),
        give: |chain, edge, value| {
            let pair = pair("weight", chain, value)?;
            chain.set_weight(edge, pair);
            Ok(())
        },
    },
    Property {
        name: "edge_starts",
        what: "edge",
        count: |chain| chain.edges,
        is_item: |value| !value.is_array(),
        give: |chain, edge, value| {
            let pair = pair("start", chain, value)?;
            if let Some(start) = pair.iter().find(|start| **start < 0.0) {
                return Err(format!(
                    "no edge starts before the time 0, and this is {start}"
                ));
            }
            chain.motion.starts.insert(edge, pair);
            Ok(())
        },
    },
    Property {
        name: "edge_profiles",
        what: "edge",
        count: |chain| chain.edges,
        is_item: is_profile,
        give: |chain, edge, value| {
            if !value.is_null() {
                let own = Some(profile(value)?);
                chain.motion.profiles.insert(edge, [own.clone(), own]);
            }
            Ok(())
        },
    },
    Property {
        name: "vertex_heights",
        what: "vertex",
        count: |chain| chain.vertices,
        is_item: |value| !value.is_array(),
        give: |chain, vertex, value| {
            let height = number(value)?;
            chain.motion.heights.insert(vertex, height);
            Ok(())
        },
    },
];

/// Takes from a feature's properties what they say of its shape.
pub(super) fn assign(shape: &mut Shape, properties: &Map<String, Value>) -> Result<(), String> {
    let given = |name: &str| properties.get(name).filter(|value| !value.is_null());
    for property in &PROPERTIES {
        if let Some(value) = given(property.name) {
            property.assign(&mut chains(shape), value)?;
        }
    }
    if let Some(value) = given("profile") {
        let common = profile(value).map_err(|e| format!("profile: {e}"))?;
        for chain in chains(shape) {
            chain.motion.profile = Some(common.clone());
        }
    }
    match given("heights_from_z") {
        None | Some(Value::Bool(false)) => Ok(()),
        Some(Value::Bool(true)) => {
            heights_from_z(shape).map_err(|e| format!("heights_from_z: {e}"))
        }
        Some(other) => Err(format!(
            "heights_from_z is {}, neither true nor false",
            short(&other.to_string())
        )),
    }
}

impl Property {
    fn assign(&self, chains: &mut [Chain], value: &Value) -> Result<(), String> {
        let name = self.name;
        let entries: Vec<&Value> = match value {
            _ if (self.is_item)(value) => vec![value; chains.len()],
            Value::Array(list)
                if list.len() == chains.len()
                    && !(chains.len() == 1 && self.stands_alone(list, &chains[0])) =>
            {
                list.iter().collect()
            }
            Value::Array(_) if chains.len() == 1 => vec![value],
            Value::Array(list) => {
                return Err(format!(
                    "{name} has {} entries, but there are {} rings or lines",
                    list.len(),
                    chains.len()
                ));
            }
            _ => vec![value; chains.len()],
        };
        for (i, (chain, entry)) in chains.iter_mut().zip(entries).enumerate() {
            self.assign_to(chain, entry)
                .map_err(|e| format!("{name} of ring or line {i}: {e}"))?;
        }
        Ok(())
    }

    /// Whether the list belongs to the edges of the only chain: it is then as long as they are
    /// many, and each entry is an item, not a list of all of them.
    fn stands_alone(&self, list: &[Value], chain: &Chain) -> bool {
        list.len() == (self.count)(chain) && list.iter().all(self.is_item)
    }

    fn assign_to(&self, chain: &mut Chain, entry: &Value) -> Result<(), String> {
        let (what, count) = (self.what, (self.count)(chain));
        match entry {
            Value::Array(list) if !(self.is_item)(entry) => {
                if list.len() != count {
                    let whats = if what == "edge" { "edges" } else { "vertices" };
                    let items = if self.name == "edge_profiles" {
                        "profiles"
                    } else {
                        "numbers"
                    };
                    return Err(format!("{} {items} for {count} {whats}", list.len()));
                }
                let mut items = list.iter().enumerate();
                items.try_for_each(|(i, item)| {
                    (self.give)(chain, i, item).map_err(|e| format!("{what} {i}: {e}"))
                })
            }
            _ => (0..count).try_for_each(|i| (self.give)(chain, i, entry)),
        }
    }
}

fn number(value: &Value) -> Result<f64, String> {
    value
        .as_f64()
        .ok_or_else(|| format!("{} is not a number", short(&value.to_string())))
}

/// A number for both sides, or, on lines, a pair.
fn pair(what: &str, chain: &Chain, value: &Value) -> Result<[f64; 2], String> {
    match value.as_array().map(Vec::as_slice) {
        None => number(value).map(|w| [w; 2]),
        Some(_) if chain.is_ring() => Err(format!(
            "a {what} on a polygon is one number; pairs are for lines"
        )),
        Some([left, right]) => match (left.as_f64(), right.as_f64()) {
            (Some(left), Some(right)) => Ok([left, right]),
            _ => Err(format!("a pair of {what}s is two numbers")),
        },
        Some(_) => Err(format!("a {what} is a number or a pair [left, right]")),
    }
}

/// Whether a value is a profile or stands for one, and is no list of profiles.
fn is_profile(value: &Value) -> bool {
    let first = |value: &Value| value.as_array().and_then(|list| list.first().cloned());
    match value {
        Value::Array(_) => first(value)
            .and_then(|v| first(&v))
            .is_some_and(|v| v.is_number()),
        _ => true,
    }
}

/// A list of pairs of a time and a speed.
fn profile(value: &Value) -> Result<Profile, String> {
    let wrong = || {
        let text = value.to_string();
        format!("{} is not a list of pairs [time, speed]", short(&text))
    };
    let pieces = value.as_array().ok_or_else(wrong)?.iter().map(|piece| {
        match piece.as_array().map(Vec::as_slice) {
            Some([time, speed]) => Some([time.as_f64()?, speed.as_f64()?]),
            _ => None,
        }
    });
    Profile::new(pieces.collect::<Option<_>>().ok_or_else(wrong)?)
}

#[cfg(test)]
mod tests;
