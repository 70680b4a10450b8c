//! The property `edge_weights` of GeoJSON features.
//!
//! One entry for each ring or line, in the order of the file: a list with one number for
//! each edge, or one number for all its edges. One number in place of everything holds for
//! all edges. Of a geometry with a single ring or line, the list of its edges may stand
//! alone. On lines, `[left, right]` may stand for a number of an edge.

use serde_json::Value;

use super::text::is_closed;
use crate::document::{LineShape, PolygonShape, Shape};

/// A ring or line, and the speeds found for it.
struct Chain<'a> {
    edges: usize,
    is_line: bool,
    slot: Slot<'a>,
}

enum Slot<'a> {
    Ring(&'a mut Vec<f64>),
    Line(&'a mut Option<Vec<[f64; 2]>>),
}

/// Gives the edges of a shape their speeds.
pub(super) fn assign(shape: &mut Shape, weights: &Value) -> Result<(), String> {
    if weights.is_null() {
        return Ok(());
    }
    let mut chains = Vec::new();
    collect(shape, &mut chains);
    let entries: Vec<&Value> = match weights {
        Value::Array(list)
            if list.len() == chains.len()
                && !(chains.len() == 1 && stands_alone(list, &chains[0])) =>
        {
            list.iter().collect()
        }
        Value::Array(_) if chains.len() == 1 => vec![weights],
        Value::Array(list) => {
            return Err(format!(
                "edge_weights has {} entries, but there are {} rings or lines",
                list.len(),
                chains.len()
            ));
        }
        _ => vec![weights; chains.len()],
    };
    for (i, (chain, entry)) in chains.iter_mut().zip(entries).enumerate() {
        let speeds =
            speeds(chain, entry).map_err(|e| format!("edge_weights of ring or line {i}: {e}"))?;
        match &mut chain.slot {
            Slot::Ring(ring) => **ring = speeds.into_iter().map(|[w, _]| w).collect(),
            Slot::Line(line) => **line = Some(speeds),
        }
    }
    Ok(())
}

/// Whether the list belongs to the edges of the only chain: it is then as long as they are
/// many, and no entry is itself a list of all of them.
fn stands_alone(list: &[Value], chain: &Chain) -> bool {
    list.len() == chain.edges && !list.iter().any(Value::is_array)
}

fn collect<'a>(shape: &'a mut Shape, chains: &mut Vec<Chain<'a>>) {
    match shape {
        Shape::Empty | Shape::Points(_) | Shape::Graph(_) => {}
        Shape::Polygons(polygons) => {
            for PolygonShape { rings, speeds } in polygons {
                let speeds = speeds.insert(vec![Vec::new(); rings.len()]);
                for (ring, slot) in rings.iter().zip(speeds) {
                    let edges = ring.len() - usize::from(is_closed(ring));
                    chains.push(Chain {
                        edges,
                        is_line: false,
                        slot: Slot::Ring(slot),
                    });
                }
            }
        }
        Shape::Lines(lines) => {
            for LineShape { points, speeds } in lines {
                let edges = points.len().saturating_sub(1);
                chains.push(Chain {
                    edges,
                    is_line: true,
                    slot: Slot::Line(speeds),
                });
            }
        }
        Shape::Collection(shapes) => shapes.iter_mut().for_each(|s| collect(s, chains)),
    }
}

fn speeds(chain: &Chain, entry: &Value) -> Result<Vec<[f64; 2]>, String> {
    match entry {
        Value::Array(list) if list.len() == chain.edges => list
            .iter()
            .enumerate()
            .map(|(i, w)| speed(chain, w).map_err(|e| format!("edge {i}: {e}")))
            .collect(),
        Value::Array(list) => Err(format!("{} numbers for {} edges", list.len(), chain.edges)),
        _ => Ok(vec![speed(chain, entry)?; chain.edges]),
    }
}

fn speed(chain: &Chain, entry: &Value) -> Result<[f64; 2], String> {
    if let Some(w) = entry.as_f64() {
        return Ok([w, w]);
    }
    match entry.as_array().map(Vec::as_slice) {
        Some([left, right]) if chain.is_line => match (left.as_f64(), right.as_f64()) {
            (Some(left), Some(right)) => Ok([left, right]),
            _ => Err("a pair of weights is two numbers".to_owned()),
        },
        Some(_) if chain.is_line => Err("a weight is a number or a pair [left, right]".to_owned()),
        Some(_) => Err("a weight on a polygon is one number; pairs are for lines".to_owned()),
        None => Err(format!(
            "{} is not a number",
            super::text::short(&entry.to_string())
        )),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    fn ring(n: usize) -> Vec<[f64; 2]> {
        (0..=n)
            .map(|i| [(i % n) as f64, (i % n * i % n) as f64])
            .collect()
    }

    fn polygon(sizes: &[usize]) -> Shape {
        Shape::Polygons(vec![PolygonShape {
            rings: sizes.iter().map(|&n| ring(n)).collect(),
            speeds: None,
        }])
    }

    fn lines(sizes: &[usize]) -> Shape {
        Shape::Lines(
            sizes
                .iter()
                .map(|&n| LineShape {
                    points: (0..=n).map(|i| [i as f64, 0.0]).collect(),
                    speeds: None,
                })
                .collect(),
        )
    }

    fn on_polygon(sizes: &[usize], weights: &Value) -> Result<Vec<Vec<f64>>, String> {
        let mut shape = polygon(sizes);
        assign(&mut shape, weights)?;
        let Shape::Polygons(mut polygons) = shape else {
            unreachable!()
        };
        Ok(polygons.remove(0).speeds.unwrap_or_default())
    }

    fn on_lines(sizes: &[usize], weights: &Value) -> Result<Vec<Vec<[f64; 2]>>, String> {
        let mut shape = lines(sizes);
        assign(&mut shape, weights)?;
        let Shape::Lines(lines) = shape else {
            unreachable!()
        };
        Ok(lines
            .into_iter()
            .map(|l| l.speeds.unwrap_or_default())
            .collect())
    }

    #[test]
    fn every_way_to_write_them() {
        let three = [1.0, 2.0, 3.0].to_vec();
        assert_eq!(
            on_polygon(&[3], &json!([[1, 2, 3]])),
            Ok(vec![three.clone()])
        );
        assert_eq!(on_polygon(&[3], &json!([1, 2, 3])), Ok(vec![three.clone()]));
        assert_eq!(on_polygon(&[3], &json!([2.5])), Ok(vec![vec![2.5; 3]]));
        assert_eq!(
            on_polygon(&[3, 4], &json!(2)),
            Ok(vec![vec![2.0; 3], vec![2.0; 4]])
        );
        assert_eq!(
            on_polygon(&[3, 4], &json!([[1, 2, 3], 0.5])),
            Ok(vec![three, vec![0.5; 4]])
        );
        assert_eq!(
            on_lines(&[1, 2], &json!([2, [1, [3, 4]]])),
            Ok(vec![vec![[2.0; 2]], vec![[1.0; 2], [3.0, 4.0]]])
        );
        assert_eq!(
            on_lines(&[2], &json!([1, 2])),
            Ok(vec![vec![[1.0; 2], [2.0; 2]]])
        );
        assert_eq!(
            on_lines(&[1], &json!([[[1, 2]]])),
            Ok(vec![vec![[1.0, 2.0]]])
        );
        assert_eq!(
            on_lines(&[2], &json!([[1, 2]])),
            Ok(vec![vec![[1.0; 2], [2.0; 2]]])
        );
    }

    #[test]
    fn what_does_not_fit_is_named() {
        for (sizes, weights, message) in [
            (
                &[3][..],
                json!([[1, 2]]),
                "edge_weights of ring or line 0: 2 numbers for 3 edges",
            ),
            (
                &[3, 3],
                json!([1]),
                "edge_weights has 1 entries, but there are 2 rings or lines",
            ),
            (
                &[3, 3],
                json!([1, [1, 2, "NaN"]]),
                "edge_weights of ring or line 1: edge 2: `\"NaN\"` is not a number",
            ),
            (
                &[3],
                json!([[1, 2, [1, 1]]]),
                "edge_weights of ring or line 0: edge 2: a weight on a polygon is one number; pairs are for lines",
            ),
            (
                &[3],
                json!({"a": 1}),
                "edge_weights of ring or line 0: `{\"a\":1}` is not a number",
            ),
        ] {
            assert_eq!(on_polygon(sizes, &weights), Err(message.to_owned()));
        }
        assert_eq!(
            on_lines(&[1], &json!([[[1, 2, 3]]])),
            Err("edge_weights of ring or line 0: edge 0: a weight is a number or a pair [left, right]".to_owned())
        );
    }
}
