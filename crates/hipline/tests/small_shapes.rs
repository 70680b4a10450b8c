//! Skeletons known by hand.

use hipline::{Figure, FigureBuilder, Options, Region, Skeleton, skeleton::NodeKind};
use hipline_testkit::generate::STRAIGHT_VERTICES;

fn polygon(rings: &[&[[f64; 2]]]) -> Figure {
    let mut builder = FigureBuilder::new();
    builder.polygon(rings.iter().map(|ring| ring.to_vec()).collect());
    builder.build().expect("a valid polygon")
}

fn lines(lines: &[&[[f64; 2]]]) -> Figure {
    let mut builder = FigureBuilder::new();
    for line in lines {
        builder.polyline(line.to_vec());
    }
    builder.build().expect("valid lines")
}

/// The event nodes, sorted: x, y, time.
fn events(skeleton: &Skeleton) -> Vec<[f64; 3]> {
    let mut list: Vec<_> = skeleton
        .nodes()
        .iter()
        .filter(|n| matches!(n.kind, NodeKind::Event))
        .map(|n| [n.x, n.y, n.time])
        .collect();
    list.sort_by(|a, b| a.partial_cmp(b).expect("numbers"));
    list
}

/// Lemma 2 of the paper: the sum over finite nodes of (degree - 2), and the nodes at infinity.
fn node_count(skeleton: &Skeleton) -> usize {
    let mut degree = vec![0; skeleton.nodes().len()];
    for arc in skeleton.arcs() {
        for node in arc.nodes {
            degree[node.index()] += 1;
        }
    }
    skeleton
        .nodes()
        .iter()
        .zip(degree)
        .map(|(node, degree)| match node.kind {
            NodeKind::Input(_) => 0,
            NodeKind::Event => degree - 2,
            NodeKind::Infinite { .. } => 1,
        })
        .sum()
}

fn whole_plane(figure: &Figure) -> Skeleton {
    let skeleton = figure.skeleton(Options::default().region(Region::Both));
    let (n, m, t) = (
        figure.vertices().len(),
        figure.edges().len(),
        figure.terminals(),
    );
    assert_eq!(skeleton.faces().len(), 2 * m + t, "faces");
    assert_eq!(
        node_count(&skeleton),
        2 * n + t - 2,
        "nodes: {:#?} {:#?}",
        skeleton.nodes(),
        skeleton.arcs()
    );
    skeleton
}

#[test]
fn square() {
    let figure = polygon(&[&[[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0]]]);
    let skeleton = figure.skeleton(Options::default());
    assert_eq!(events(&skeleton), [[2.0, 2.0, 2.0]]);
    assert_eq!(skeleton.arcs().len(), 4);
    whole_plane(&figure);
}

#[test]
fn rectangle() {
    let figure = polygon(&[&[[0.0, 0.0], [8.0, 0.0], [8.0, 4.0], [0.0, 4.0]]]);
    let skeleton = figure.skeleton(Options::default());
    assert_eq!(events(&skeleton), [[2.0, 2.0, 2.0], [6.0, 2.0, 2.0]]);
    assert_eq!(skeleton.arcs().len(), 5);
    whole_plane(&figure);
}

#[test]
fn l_shape() {
    let figure = polygon(&[&[
        [0.0, 0.0],
        [5.0, 0.0],
        [5.0, 5.0],
        [4.0, 5.0],
        [4.0, 4.0],
        [0.0, 4.0],
    ]]);
    let skeleton = figure.skeleton(Options::default());
    assert_eq!(node_count(&skeleton), 4);
    whole_plane(&figure);
}

#[test]
fn segment() {
    let figure = lines(&[&[[0.0, 0.0], [4.0, 0.0]]]);
    whole_plane(&figure);
    let figure = lines(&[&[[0.0, 0.0], [4.0, 3.0]]]);
    whole_plane(&figure);
}

#[test]
fn cross_of_segments() {
    let figure = lines(&[
        &[[-5.0, 0.0], [0.0, 0.0]],
        &[[0.0, 0.0], [5.0, 0.0]],
        &[[0.0, -5.0], [0.0, 0.0]],
        &[[0.0, 0.0], [0.0, 5.0]],
    ]);
    whole_plane(&figure);
}

#[test]
fn collinear_segments_with_a_gap() {
    let figure = lines(&[&[[0.0, 0.0], [4.0, 0.0]], &[[6.0, 0.0], [10.0, 0.0]]]);
    whole_plane(&figure);
}

#[test]
fn square_in_square() {
    let figure = polygon(&[
        &[[0.0, 0.0], [9.0, 0.0], [9.0, 9.0], [0.0, 9.0]],
        &[[3.0, 3.0], [6.0, 3.0], [6.0, 6.0], [3.0, 6.0]],
    ]);
    let skeleton = figure.skeleton(Options::default());
    assert_eq!(node_count(&skeleton), 8);
    whole_plane(&figure);
}

#[test]
fn comb() {
    let mut ring = vec![[0.0, 0.0], [12.0, 0.0]];
    for i in (0..6).rev() {
        let x = f64::from(i) * 2.0;
        ring.extend([[x + 2.0, 4.0], [x + 1.0, 4.0], [x + 1.0, 2.0], [x, 2.0]]);
    }
    let figure = polygon(&[&ring]);
    let skeleton = figure.skeleton(Options::default());
    assert_eq!(node_count(&skeleton), ring.len() - 2);
    whole_plane(&figure);
}

#[test]
fn collinear_vertices() {
    let figure = polygon(&[&STRAIGHT_VERTICES]);
    let skeleton = figure.skeleton(Options::default());
    assert_eq!(node_count(&skeleton), 6);
    whole_plane(&figure);
}
