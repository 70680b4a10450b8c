//! Parts against the whole.

use super::{of_parts, of_whole};
use crate::{
    Figure, FigureBuilder, Region, Skeleton,
    input::{Change, Place, Sides},
    skeleton::NodeKind,
};
use hipline_testkit::generate::Random;

/// A point of a small grid.
fn point(random: &mut Random) -> [f64; 2] {
    [0, 1].map(|_| random.below(7) as f64)
}

/// Polygons, lines and segments that touch each other, some with weights.
fn figure(seed: u64) -> Option<Figure> {
    let mut random = Random::new(seed);
    let mut builder = FigureBuilder::new();
    for part in 0..1 + random.below(4) {
        if random.below(2) == 0 {
            let n = 3 + random.below(3);
            let ring = (0..n).map(|_| point(&mut random)).collect();
            builder.polygon(vec![ring]);
        } else {
            let n = 2 + random.below(3);
            builder.polyline((0..n).map(|_| point(&mut random)).collect());
        }
        if random.below(4) == 0 {
            builder.change(Change {
                edge: Place {
                    part,
                    ring: 0,
                    index: random.below(2),
                },
                sides: Sides::Both,
                time: 0.5,
                speed: random.below(3) as f64,
            });
        }
    }
    builder.build().ok()
}

/// All arcs, by places and faces, whatever their order.
fn arcs(skeleton: &Skeleton) -> Vec<String> {
    let end = |id| {
        let node = skeleton.node(id);
        let kind = match node.kind {
            NodeKind::Input(v) => format!("{v}"),
            kind => format!("{kind:?}"),
        };
        format!("{} {} {} {kind}", node.x, node.y, node.time)
    };
    let face = |id| {
        let face = skeleton.face(id);
        format!("{} {:?} {}", face.edge, face.side, face.phase)
    };
    let mut list: Vec<String> = (skeleton.arcs().iter())
        .map(|arc| {
            // The order of the ends of a level arc is arbitrary.
            let mut halves = [
                format!("{} {}", end(arc.nodes[0]), face(arc.faces[0])),
                format!("{} {}", end(arc.nodes[1]), face(arc.faces[1])),
            ];
            halves.sort();
            format!("{halves:?} {:?}", arc.kind)
        })
        .collect();
    list.sort();
    list
}

#[test]
fn parts_make_the_whole() {
    let mut seen = 0;
    for seed in 0..20_000 {
        let Some(figure) = figure(seed) else { continue };
        for region in [Region::Interior, Region::Exterior, Region::Both] {
            for least in [1, 6] {
                let Some(parts) = figure.parts_from(region, 1, least) else {
                    continue;
                };
                seen += 1;
                let whole = of_whole(&figure, region, false);
                let merged = of_parts(&figure, region, &parts);
                assert_eq!(arcs(&merged), arcs(&whole), "seed {seed}, {region:?}");
                let faces = |s: &Skeleton| -> Vec<_> {
                    let of = |f: &crate::skeleton::Face| (f.edge, f.side, f.phase);
                    s.faces().iter().map(of).collect()
                };
                assert_eq!(faces(&merged), faces(&whole), "seed {seed}, {region:?}");
                assert_eq!(merged.nodes().len(), whole.nodes().len(), "seed {seed}");
                let lawful = [&merged, &whole].map(|s| s.verify(&figure).is_ok());
                assert_eq!(lawful[0], lawful[1], "seed {seed}");
            }
        }
    }
    assert!(seen > 1_000, "{seen}");
}
