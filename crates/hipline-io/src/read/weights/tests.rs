use super::*;
use crate::document::{LineShape, PolygonShape};
use serde_json::json;

fn properties(value: &Value) -> Map<String, Value> {
    value.as_object().unwrap().clone()
}

fn ring(n: usize) -> Vec<[f64; 2]> {
    (0..=n)
        .map(|i| [(i % n) as f64, (i % n * i % n) as f64])
        .collect()
}

fn polygon(sizes: &[usize]) -> Shape {
    let rings = sizes.iter().map(|&n| ring(n));
    Shape::Polygons(vec![PolygonShape::new(rings.collect())])
}

fn lines(sizes: &[usize]) -> Shape {
    let points = |&n: &usize| (0..=n).map(|i| [i as f64, 0.0]).collect();
    Shape::Lines(sizes.iter().map(points).map(LineShape::new).collect())
}

fn on_polygon(sizes: &[usize], weights: &Value) -> Result<Vec<Vec<f64>>, String> {
    let mut shape = polygon(sizes);
    assign(&mut shape, &properties(&json!({"edge_weights": weights})))?;
    let Shape::Polygons(mut polygons) = shape else {
        unreachable!()
    };
    Ok(polygons.remove(0).speeds.unwrap_or_default())
}

fn on_lines(sizes: &[usize], weights: &Value) -> Result<Vec<Vec<[f64; 2]>>, String> {
    let mut shape = lines(sizes);
    assign(&mut shape, &properties(&json!({"edge_weights": weights})))?;
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
        Err(
            "edge_weights of ring or line 0: edge 0: a weight is a number or a pair [left, right]"
                .to_owned()
        )
    );
}
