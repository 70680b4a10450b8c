//! The `coordinates` member: lists of lists, down to positions.

use std::fmt;

use serde::{
    Deserialize, Deserializer,
    de::{Error, IgnoredAny, MapAccess, SeqAccess, Visitor},
};

use crate::read::position::Position;

/// A position, or a list of such.
pub(super) enum Coordinates {
    /// Two or three numbers; what follows them is dropped.
    Position(Position),
    /// Anything deeper, or an empty list.
    List(Vec<Coordinates>),
}

impl Coordinates {
    /// One point, or none; its count.
    pub fn point(self) -> Option<usize> {
        match self {
            Self::Position(_) => Some(1),
            Self::List(list) => list.is_empty().then_some(0),
        }
    }

    pub fn points(self) -> Option<Vec<Position>> {
        self.list()?
            .into_iter()
            .map(|c| match c {
                Self::Position(p) => Some(p),
                Self::List(_) => None,
            })
            .collect()
    }

    pub fn chains(self) -> Option<Vec<Vec<Position>>> {
        self.list()?.into_iter().map(Self::points).collect()
    }

    pub fn polygons(self) -> Option<Vec<Vec<Vec<Position>>>> {
        self.list()?.into_iter().map(Self::chains).collect()
    }

    fn list(self) -> Option<Vec<Self>> {
        match self {
            Self::List(list) => Some(list),
            Self::Position(_) => None,
        }
    }
}

/// What can stand in a list: the visitor learns only here which it is.
enum Item {
    Number(f64),
    Nested(Coordinates),
}

struct ItemVisitor;

impl<'de> Visitor<'de> for ItemVisitor {
    type Value = Item;

    fn expecting(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.write_str("a number or a list of coordinates")
    }

    fn visit_f64<E: Error>(self, v: f64) -> Result<Item, E> {
        Ok(Item::Number(v))
    }

    // `as` rounds to nearest, as the decimals would.
    fn visit_u64<E: Error>(self, v: u64) -> Result<Item, E> {
        Ok(Item::Number(v as f64))
    }

    fn visit_i64<E: Error>(self, v: i64) -> Result<Item, E> {
        Ok(Item::Number(v as f64))
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut seq: A) -> Result<Item, A::Error> {
        let first = match seq.next_element()? {
            None => return Ok(Item::Nested(Coordinates::List(Vec::new()))),
            Some(Item::Number(x)) => {
                let Some(Item::Number(y)) = seq.next_element()? else {
                    return Err(Error::custom("a position needs two numbers"));
                };
                let z = seq.next_element::<Third>()?.and_then(|third| third.0);
                while seq.next_element::<IgnoredAny>()?.is_some() {}
                let place = [x, y];
                return Ok(Item::Nested(Coordinates::Position(Position { place, z })));
            }
            Some(Item::Nested(first)) => first,
        };
        let mut list = vec![first];
        while let Some(item) = seq.next_element()? {
            match item {
                Item::Nested(c) => list.push(c),
                Item::Number(_) => {
                    return Err(Error::custom("a number among lists of coordinates"));
                }
            }
        }
        Ok(Item::Nested(Coordinates::List(list)))
    }
}

/// A third coordinate: a number, or anything else, which is none.
struct Third(Option<f64>);

struct ThirdVisitor;

impl<'de> Visitor<'de> for ThirdVisitor {
    type Value = Third;

    fn expecting(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.write_str("anything")
    }

    fn visit_f64<E: Error>(self, v: f64) -> Result<Third, E> {
        Ok(Third(Some(v)))
    }

    fn visit_u64<E: Error>(self, v: u64) -> Result<Third, E> {
        Ok(Third(Some(v as f64)))
    }

    fn visit_i64<E: Error>(self, v: i64) -> Result<Third, E> {
        Ok(Third(Some(v as f64)))
    }

    fn visit_bool<E: Error>(self, _: bool) -> Result<Third, E> {
        Ok(Third(None))
    }

    fn visit_str<E: Error>(self, _: &str) -> Result<Third, E> {
        Ok(Third(None))
    }

    fn visit_unit<E: Error>(self) -> Result<Third, E> {
        Ok(Third(None))
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut seq: A) -> Result<Third, A::Error> {
        while seq.next_element::<IgnoredAny>()?.is_some() {}
        Ok(Third(None))
    }

    fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<Third, A::Error> {
        while map.next_entry::<IgnoredAny, IgnoredAny>()?.is_some() {}
        Ok(Third(None))
    }
}

impl<'de> Deserialize<'de> for Third {
    fn deserialize<D: Deserializer<'de>>(d: D) -> Result<Self, D::Error> {
        d.deserialize_any(ThirdVisitor)
    }
}

impl<'de> Deserialize<'de> for Item {
    fn deserialize<D: Deserializer<'de>>(d: D) -> Result<Self, D::Error> {
        d.deserialize_any(ItemVisitor)
    }
}

impl<'de> Deserialize<'de> for Coordinates {
    fn deserialize<D: Deserializer<'de>>(d: D) -> Result<Self, D::Error> {
        match Item::deserialize(d)? {
            Item::Nested(c) => Ok(c),
            Item::Number(_) => Err(Error::custom("coordinates are a list, not a number")),
        }
    }
}
