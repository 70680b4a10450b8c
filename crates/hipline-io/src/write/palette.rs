//! The colours of pictures: a restrained palette on a light ground, faces in hill-shade.

use hipline::{
    Skeleton,
    skeleton::{ArcKind, Face, Side},
    topology::EdgeId,
};

use super::window::place;

pub(super) type Colour = [f64; 3];

pub(super) const BACKGROUND: &str = "#fbfaf6";
pub(super) const INPUT: &str = "#23272e";
pub(super) const NODE: &str = "#23272e";
pub(super) const OFFSET: &str = "#6b4a8c";
pub(super) const TRACK: &str = "#2c6d9e";
pub(super) const BORN: &str = "#c4452c";
pub(super) const LABEL: &str = "#4b5058";

/// Sunlit and averted faces; what lies between is mixed.
const LIGHT: Colour = [252.0, 236.0, 209.0];
const SHADE: Colour = [146.0, 167.0, 187.0];

/// Towards the light: the upper left, as cartographers have it, but not on the diagonal, so
/// that a wall to the north and one to the west differ.
const SUN: [f64; 2] = [-0.8829, 0.4695];

pub(super) const fn arc(kind: ArcKind) -> &'static str {
    match kind {
        ArcKind::Ridge => "#a8412f",
        ArcKind::Valley => "#2c6d9e",
        ArcKind::Ghost => "#8d8f94",
        ArcKind::Crease => "#b98a2f",
    }
}

/// The direction in which water runs down on a face; zero if its edge has no length.
pub(super) fn downhill(skeleton: &Skeleton, face: &Face) -> [f64; 2] {
    let [p, q] = ends(skeleton, face.edge);
    let [dx, dy] = [q[0] - p[0], q[1] - p[1]];
    let length = dx.hypot(dy);
    if length == 0.0 || !length.is_finite() {
        return [0.0, 0.0];
    }
    let [dx, dy] = [dx / length, dy / length];
    match face.side {
        Side::Left => [dy, -dx],
        Side::Right => [-dy, dx],
        Side::Start => [dx, dy],
        Side::End => [-dx, -dy],
    }
}

pub(super) fn ends(skeleton: &Skeleton, edge: EdgeId) -> [[f64; 2]; 2] {
    skeleton.input().edges[edge.index()].map(|v| place(&skeleton.nodes()[v.index()]))
}

/// The colour of a face by the direction it looks in, so that the roof is seen.
pub(super) fn hill_shade(downhill: [f64; 2]) -> Colour {
    mixed(f64::midpoint(
        1.0,
        downhill[0] * SUN[0] + downhill[1] * SUN[1],
    ))
}

/// Between shade (0) and light (1).
pub(super) fn mixed(light: f64) -> Colour {
    let light = light.clamp(0.0, 1.0);
    std::array::from_fn(|i| SHADE[i] + (LIGHT[i] - SHADE[i]) * light)
}

pub(super) fn hex(colour: Colour) -> String {
    let [r, g, b] = colour.map(|c| c.round().clamp(0.0, 255.0) as u8);
    format!("#{r:02x}{g:02x}{b:02x}")
}
