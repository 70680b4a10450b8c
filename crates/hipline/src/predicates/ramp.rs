//! Where planes lead to when seen from one of them: what the faces of lower envelopes ask.

use hipline_num::Sign;

use super::{
    moment::{Closing, Moment},
    planes::{PlaneId, Planes},
};

impl Planes {
    /// The sign of the determinant D of three planes, zero if they have no single point in common; the vertex of
    /// planes i and j, the first turning left into the second, gets nearer to plane k over time if that of k, i, j is positive.
    pub(crate) fn closing(&self, triple: [PlaneId; 3]) -> Sign {
        self.sign_of(&Closing(triple))
    }

    /// Two planes that are not parallel, the first turning left into the second; `None` if they are.
    pub(crate) fn turning_left(&self, [i, j]: [PlaneId; 2]) -> Option<[PlaneId; 2]> {
        match self.turn(i, j) {
            Sign::Positive => Some([i, j]),
            Sign::Negative => Some([j, i]),
            Sign::Zero => None,
        }
    }

    /// Whether the vertex of two planes is ahead of a third one, to which it never gets nearer: zero if it is on it.
    pub(crate) fn lead_always(&self, vertex: [PlaneId; 2], plane: PlaneId) -> Sign {
        self.lead(&Moment::Start, vertex, plane)
    }
}
