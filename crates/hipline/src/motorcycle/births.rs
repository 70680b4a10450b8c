//! Which motorcycle starts where others meet.
//!
//! Just before the meeting, what the wavefront has swept around the place are wedges of less than 180
//! degrees, one behind each motorcycle, between its own two wavefront edges. What is left are the slices
//! between neighbouring tracks. Afterwards each slice has one wavefront vertex, of the two wavefront edges that
//! bound it: the one that starts at the motorcycle on its clockwise side, and the one that ends
//! at the motorcycle on its counterclockwise side. It is reflex if more than 180 degrees are left between these two; then the
//! slice between the tracks has more than 180 degrees all the more, and there is at most
//! one such slice. In it, the angle that is left lies between 0 and 360 degrees, so that the sign of the turn
//! decides (Held & Huber 2012; chapter 5.1 of Mencil 2014). In narrower slices the wedges may overlap, as motorcycles
//! are faster than what the wavefront leaves of them; no motorcycle starts there.
//!
//! Two that meet head on leave two slices of 180 degrees: none starts.

use crate::predicates::{Course, Heading, Moment, Place, PlaneId, Planes};

/// Whether one starts between two neighbours, the second one counterclockwise of the first.
pub(super) fn is_born(planes: &Planes, [a, b]: &[[PlaneId; 2]; 2]) -> bool {
    planes.turn(a[0], b[1]).is_positive() && planes.turn_of_paths(*a, *b).is_negative()
}

/// The planes of the motorcycle that starts where those with the given planes meet, if any
/// does, and where.
pub(super) fn born(planes: &Planes, members: &[[PlaneId; 2]]) -> Option<([PlaneId; 2], Place)> {
    // Counterclockwise by direction; so are the tracks behind them.
    let mut around: Vec<([PlaneId; 2], Heading)> = (members.iter())
        .map(|&pair| (pair, planes.heading(Course::Moving(pair))))
        .collect();
    around.sort_by(|a, b| planes.compare_headings(&a.1, &b.1));
    let pair = (0..around.len()).find_map(|i| {
        let neighbours = [around[i].0, around[(i + 1) % around.len()].0];
        is_born(planes, &neighbours).then_some([neighbours[0][0], neighbours[1][1]])
    })?;
    // All their planes have this point in common; some three of them have no other one.
    let third = (members.iter().flatten().copied())
        .find(|&plane| !pair.contains(&plane) && planes.do_meet([pair[0], pair[1], plane]))
        .expect("different motorcycles meet in one point");
    let Moment::Planes(moment) = Moment::of_planes([pair[0], pair[1], third]) else {
        unreachable!("three planes meet");
    };
    Some((pair, Place::Event { pair, moment }))
}
