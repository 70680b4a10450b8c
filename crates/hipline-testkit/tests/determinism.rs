//! Same input, same bits: on every run, in every thread, on every platform.

mod common;

use std::thread;

use common::run;
use hipline::Skeleton;
use hipline::skeleton::NodeKind;
use hipline_testkit::Case;
use hipline_testkit::generate::Family;

/// The 64 bits of FNV-1a over everything that a skeleton holds, in order.
fn hash(skeleton: &Skeleton) -> u64 {
    let mut state = 0xcbf2_9ce4_8422_2325_u64;
    let mut add = |word: u64| {
        for byte in word.to_le_bytes() {
            state = (state ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3);
        }
    };
    for node in skeleton.nodes() {
        [node.x, node.y, node.time]
            .iter()
            .for_each(|x| add(x.to_bits()));
        match node.kind {
            NodeKind::Input(vertex) => add(vertex.index() as u64),
            NodeKind::Event => add(u64::MAX),
            NodeKind::Infinite { direction } => {
                direction.iter().for_each(|x| add(x.to_bits()));
            }
        }
    }
    for arc in skeleton.arcs() {
        arc.nodes.iter().for_each(|node| add(node.index() as u64));
        arc.faces.iter().for_each(|face| add(face.index() as u64));
        add(arc.kind as u64);
    }
    for (f, face) in skeleton.faces().iter().enumerate() {
        add(face.edge.index() as u64);
        add(face.side as u64);
        let id = hipline::topology::FaceId::new(f);
        for cycle in std::iter::once(skeleton.boundary(id)).chain(skeleton.holes(id)) {
            add(cycle.len() as u64);
            cycle.iter().for_each(|node| add(node.index() as u64));
        }
    }
    state
}

#[test]
fn every_run_gives_the_same_bits() {
    for family in Family::all() {
        let case = family.generate(300, 11);
        let first = hash(&run(&case));
        let second = thread::scope(|scope| {
            let other = scope.spawn(|| hash(&run(&case)));
            other.join().expect("no panic")
        });
        assert_eq!(first, second, "{}", family.name());
    }
}

/// Families whose coordinates take nothing but sums and products, which are the same everywhere
/// (sines are not), and the hashes of their skeletons.
const PINNED: [(Family, u64); 8] = [
    (Family::Random, 0xcc97_712e_42c0_2c69),
    (Family::Orthogonal, 0x6ec8_97a0_4eae_cb8b),
    (Family::Skyline, 0x4206_fe76_26c9_be48),
    (Family::Monotone, 0x15b5_d1b0_427b_c75b),
    (Family::Comb, 0xbc66_f389_5e6a_1dc3),
    (Family::Segments, 0x0339_84aa_14d3_f645),
    (Family::SquareHoles, 0x6de0_8329_3b1a_0068),
    (Family::Windows, 0x04a1_1c95_4c73_d9aa),
];

/// The hash says whether another platform, compiler or version gives the same result. A change
/// that is meant to change results (other numbers of nodes, another order) renews these numbers
/// and says so in the changelog.
#[test]
fn results_are_those_of_every_other_platform() {
    let found: Vec<String> = PINNED
        .iter()
        .map(|(family, _)| {
            let name = format!("{family:?}");
            format!(
                "(Family::{name}, {:#018x})",
                hash(&run(&family.generate(400, 7)))
            )
        })
        .collect();
    let due: Vec<String> = PINNED
        .iter()
        .map(|(family, hash)| format!("(Family::{family:?}, {hash:#018x})"))
        .collect();
    println!("{}", found.join(",\n"));
    assert_eq!(found, due, "hashes of skeletons");
}

/// The inputs of the pinned results are the same everywhere, too.
#[test]
fn inputs_read_back_as_they_were() {
    for (family, _) in PINNED {
        let case = family.generate(400, 7);
        assert_eq!(Case::parse(&case.to_text()), Ok(case), "{}", family.name());
    }
}
