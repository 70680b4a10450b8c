//! Every file of the corpus: the library against the reference, and the laws of counting.

mod common;

use std::fs;
use std::path::PathBuf;

use common::repository;
use hipline::skeleton::NodeKind;
use hipline::{Options, Region, Skeleton};
use hipline_testkit::Case;
use hipline_testkit::hunt::{failure, overruns_at_zero};

fn files() -> Vec<PathBuf> {
    let folder = repository().join("corpus");
    let entries = fs::read_dir(folder).expect("the corpus");
    let mut files: Vec<PathBuf> = entries
        .map(|entry| entry.expect("an entry").path())
        .collect();
    files.retain(|file| file.extension().is_some_and(|ending| ending == "txt"));
    files.sort();
    files
}

/// The sum over finite nodes of (degree - 2), and the nodes at infinity.
fn weight(skeleton: &Skeleton) -> usize {
    let mut degree = vec![0; skeleton.nodes().len()];
    for node in skeleton.arcs().iter().flat_map(|arc| arc.nodes) {
        degree[node.index()] += 1;
    }
    let nodes = skeleton.nodes().iter().zip(degree);
    nodes
        .map(|(node, degree): (_, usize)| match node.kind {
            NodeKind::Input(_) => 0,
            NodeKind::Event => degree - 2,
            NodeKind::Infinite { .. } => 1,
        })
        .sum()
}

#[test]
fn every_case_is_right() {
    let mut wrong = Vec::new();
    let files = files();
    assert!(files.len() > 30, "only {} cases", files.len());
    for file in files {
        let name = file
            .file_name()
            .expect("a name")
            .to_string_lossy()
            .into_owned();
        let text = fs::read_to_string(&file).expect("text");
        let case = Case::parse(&text).unwrap_or_else(|error| panic!("{name}, {error}"));
        assert!(!case.comments.is_empty(), "{name} does not tell its origin");
        let figure = case
            .figure()
            .unwrap_or_else(|flaws| panic!("{name}: {flaws}"));
        for region in [Region::Interior, Region::Exterior, Region::Both] {
            let case = Case {
                region,
                ..case.clone()
            };
            if let Some(how) = failure(&case) {
                wrong.push(format!("{name}, {region:?}: {how}"));
            }
        }
        let skeleton = figure.skeleton(Options::default().region(Region::Both));
        if !overruns_at_zero(&skeleton)
            && let Err(violations) = skeleton.verify(&figure)
        {
            wrong.push(format!("{name}: {violations}"));
        }
        let (n, m) = (figure.vertices().len(), figure.edges().len());
        let t = figure.terminals();
        let first = skeleton.faces().iter().filter(|face| face.phase == 0);
        let first = first.count();
        // A terminal whose edge stands still, for a while or for ever, emits no wavefront edge at time zero.
        let stands = |speeds: &[f64; 2]| speeds.iter().any(|&speed| speed <= 0.0);
        let still =
            !case.heights.is_empty() || figure.edges().iter().any(|edge| stands(&edge.speeds));
        if first > 2 * m + t || first < 2 * m || (first < 2 * m + t && !still) {
            wrong.push(format!("{name}: {first} faces of phase 0, not 2m + t"));
        }
        // With weights, ghost arcs may be missing: a face may meet itself around an obstacle.
        if !case.is_weighted() && weight(&skeleton) + 2 != 2 * n + t {
            wrong.push(format!(
                "{name}: nodes of {}, not 2n + t - 2",
                weight(&skeleton)
            ));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}
