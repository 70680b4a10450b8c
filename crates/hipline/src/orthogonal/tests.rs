//! What the engine refuses, and a first polygon by hand.

use crate::{
    Engine, Figure, FigureBuilder, NotApplicable, Options, Region,
    input::{Change, Place, Sides},
    topology::EdgeId,
};

const STEP: [[f64; 2]; 6] = [[0., 0.], [8., 0.], [8., 4.], [4., 4.], [4., 8.], [0., 8.]];

fn figure(edit: impl FnOnce(&mut FigureBuilder)) -> Figure {
    let mut builder = FigureBuilder::new();
    edit(&mut builder);
    builder.build().expect("a valid figure")
}

fn refusal(figure: &Figure, options: Options) -> NotApplicable {
    match figure.skeleton_by(Engine::Orthogonal, options) {
        Ok(skeleton) => panic!("computed: {skeleton:?}"),
        Err(reason) => reason,
    }
}

#[test]
fn a_step_has_the_nodes_one_expects() {
    let step = figure(|builder| {
        builder.polygon(vec![STEP.to_vec()]);
    });
    let skeleton = step
        .skeleton_by(Engine::Orthogonal, Options::default())
        .expect("it applies");
    let mut nodes: Vec<[f64; 3]> = skeleton.nodes()[6..]
        .iter()
        .map(|node| [node.x, node.y, node.time])
        .collect();
    nodes.sort_by(|a, b| a.partial_cmp(b).expect("finite"));
    // The reflex vertex and three convex ones meet in the middle of the corner.
    assert_eq!(nodes, [[2., 2., 2.], [2., 6., 2.], [6., 2., 2.]]);
    assert_eq!(skeleton.arcs().len(), 8);
    assert!(skeleton.stats().steps > 0, "steps are counted");
}

#[test]
fn refusals_tell_why() {
    let inside = Options::default();
    let step = |edit: fn(&mut FigureBuilder)| {
        figure(|builder| {
            builder.polygon(vec![STEP.to_vec()]);
            edit(builder);
        })
    };
    let plain = step(|_| {});
    assert_eq!(
        refusal(&plain, inside.region(Region::Both)),
        NotApplicable::NotInterior
    );
    let line = step(|builder| {
        builder.polyline(vec![[1., 1.], [2., 1.]]);
    });
    assert_eq!(refusal(&line, inside), NotApplicable::NotOneRing);
    let place = Place {
        part: 0,
        ring: 0,
        index: 2,
    };
    let high = step(|builder| {
        builder.elevate(
            Place {
                part: 0,
                ring: 0,
                index: 2,
            },
            0.5,
        );
        builder.elevate(
            Place {
                part: 0,
                ring: 0,
                index: 3,
            },
            0.5,
        );
    });
    assert_eq!(refusal(&high, inside), NotApplicable::Heights);
    let changing = figure(|builder| {
        builder.polygon(vec![STEP.to_vec()]);
        builder.change(Change {
            edge: place,
            sides: Sides::Both,
            time: 1.0,
            speed: 2.0,
        });
    });
    let speed = NotApplicable::Speed {
        edge: EdgeId::new(2),
    };
    assert_eq!(refusal(&changing, inside), speed);
    let fast = figure(|builder| {
        builder.weighted_polygon(vec![STEP.to_vec()], vec![vec![1., 1., 2., 1., 1., 1.]]);
    });
    assert_eq!(refusal(&fast, inside), speed);
    let slanted = figure(|builder| {
        let mut ring = STEP.to_vec();
        ring[3] = [4.0, 4.5];
        builder.polygon(vec![ring]);
    });
    assert_eq!(
        refusal(&slanted, inside),
        NotApplicable::NotOrthogonal {
            edge: EdgeId::new(2)
        }
    );
    // A cross of two bars with arms bent the same way around: monotone in no direction.
    let pinwheel = figure(|builder| {
        builder.polygon(vec![vec![
            [0., 0.],
            [2., 0.],
            [2., -4.],
            [0., -4.],
            [0., -6.],
            [4., -6.],
            [4., 0.],
            [8., 0.],
            [8., -2.],
            [10., -2.],
            [10., 2.],
            [4., 2.],
            [4., 6.],
            [6., 6.],
            [6., 8.],
            [2., 8.],
            [2., 2.],
            [-2., 2.],
            [-2., 4.],
            [-4., 4.],
            [-4., 0.],
        ]]);
    });
    assert_eq!(refusal(&pinwheel, inside), NotApplicable::NotMonotone);
}

#[test]
fn coordinates_of_all_ranges_are_computed_in_the_integers_they_need() {
    // Integers, thirds, and a range that needs hundreds of binary digits.
    for scales in [[1.0, 1.0], [1.0 / 3.0, 2e-9], [1e60, 2e-30]] {
        let ring = STEP.map(|[x, y]| [x * scales[0], y * scales[1]]);
        let step = figure(|builder| {
            builder.polygon(vec![ring.to_vec()]);
        });
        let by = |engine| {
            let skeleton = step
                .skeleton_by(engine, Options::default())
                .expect("it applies");
            let nodes = skeleton.nodes().iter();
            let mut bits: Vec<[u64; 3]> = nodes
                .map(|node| [node.x, node.y, node.time].map(f64::to_bits))
                .collect();
            bits.sort_unstable();
            (bits, skeleton.arcs().len())
        };
        assert_eq!(by(Engine::Orthogonal), by(Engine::Kinetic), "{scales:?}");
    }
}
