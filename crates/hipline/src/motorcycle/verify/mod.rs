//! Checks a finished motorcycle graph against the laws that define it.
//!
//! It reads the result and the input only, asks the exact predicates, and knows neither race nor grounds. From what is told of a
//! motorcycle follow its planes, and from these and its end the exact places; then
//!
//! 1. who starts where, which planes each has, and who meets whom is what the input and the rules on births say;
//! 2. all numbers are the correctly rounded ones, bit for bit, and nobody ends before it starts;
//! 3. wherever a track touches a wall, or another track that was there before, it ends, and it is said to end in the
//!    first of these that counts;
//! 4. nobody ends where there is nothing.
//!
//! By induction over time there is one graph only that obeys all of them. What touches is looked for in the cells of a tree over
//! the tracks and walls as they are told (`contacts`).

mod contacts;
mod ends;
#[cfg(test)]
mod tests;

use super::{
    births,
    model::{End, Motorcycle, MotorcycleGraph, Origin, Spot},
    start,
};
use crate::{
    input::Figure,
    predicates::{Bounds, Lane, Place, PlaneId, Planes},
    skeleton::Side,
    topology::{EdgeId, MeetingId, MotorcycleId},
};
use std::cmp::Ordering;

/// One way in which a motorcycle graph breaks its laws.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum GraphViolation {
    /// Not as many motorcycles start on their own as there have to be.
    #[error("{found} motorcycles start on their own, but {expected} have to")]
    Count {
        /// How many there are.
        found: usize,
        /// How many there must be.
        expected: usize,
    },
    /// A motorcycle is not the one that starts at the vertex, launch or meeting, or names what does not exist.
    #[error("motorcycle {}: it starts where none does, or between other edges, or names what is not there", .motorcycle.index())]
    WrongStart {
        /// The motorcycle.
        motorcycle: MotorcycleId,
    },
    /// A number of a motorcycle is not the correctly rounded one.
    #[error("motorcycle {}: its start, stop or velocity is not the correctly rounded one", .motorcycle.index())]
    NotRounded {
        /// The motorcycle.
        motorcycle: MotorcycleId,
    },
    /// A motorcycle does not get to what is said to stop it, or not after it starts.
    #[error("motorcycle {}: its way does not lead to its end", .motorcycle.index())]
    NoWay {
        /// The motorcycle.
        motorcycle: MotorcycleId,
    },
    /// A motorcycle goes on where it has to stop.
    #[error("motorcycle {}: it goes on where it has to stop: {at:?}", .motorcycle.index())]
    GoesOn {
        /// The motorcycle.
        motorcycle: MotorcycleId,
        /// What stops it there.
        at: End,
    },
    /// A motorcycle stops for another reason than is told, or for none.
    #[error("motorcycle {}: it does not end as is told, but: {by:?}", .motorcycle.index())]
    WrongEnd {
        /// The motorcycle.
        motorcycle: MotorcycleId,
        /// What stops it there, if anything does.
        by: Option<End>,
    },
    /// The members, the spot or the place in the list of a meeting are wrong.
    #[error("meeting {}: its members, spot, number or child are wrong", .meeting.index())]
    WrongMeeting {
        /// The meeting.
        meeting: MeetingId,
    },
}

/// All violations found, at least one, in the order of the laws.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[error("{} violations; the first: {}", .list.len(), .list[0])]
pub struct GraphViolations {
    /// The violations.
    pub list: Vec<GraphViolation>,
}

/// A place on the way of a motorcycle, and bounds of the time.
#[derive(Clone, Copy)]
struct Stage {
    place: Place,
    bounds: Bounds,
}

/// A motorcycle by definition.
struct Rider {
    pair: [PlaneId; 2],
    lane: Lane,
    start: Stage,
    /// `None` if it escapes.
    stop: Option<Stage>,
}

/// What stands still.
#[derive(Clone, Copy)]
enum Walls<'a> {
    Figure(&'a Figure),
    /// How many motorcycles are given, and the walls.
    Given(usize, &'a [[[f64; 2]; 2]]),
}

struct Checker<'a> {
    graph: &'a MotorcycleGraph,
    planes: &'a Planes,
    walls: Walls<'a>,
    /// Some edges at each vertex of a figure: two that are not parallel, if there are.
    posts: Vec<[Option<PlaneId>; 2]>,
    riders: Vec<Rider>,
    /// What stops each, of all that is where it ends.
    causes: Vec<Option<End>>,
    list: Vec<GraphViolation>,
}

fn plane((edge, side): (EdgeId, Side)) -> PlaneId {
    PlaneId(2 * edge.index() as u32 + u32::from(side == Side::Right))
}

impl Walls<'_> {
    fn len(self) -> usize {
        match self {
            Self::Figure(figure) => figure.edges().len(),
            Self::Given(_, walls) => walls.len(),
        }
    }

    fn ends(self, wall: usize) -> [[f64; 2]; 2] {
        match self {
            Self::Figure(figure) => {
                let edge = figure.edges()[wall];
                [edge.from, edge.to].map(|v| figure.vertices()[v.index()])
            }
            Self::Given(_, walls) => walls[wall],
        }
    }
}

/// Of all that is at one place, what counts first.
fn rank(end: End) -> (u8, usize) {
    match end {
        End::Edge(edge, side) => (0, plane((edge, side)).0 as usize),
        End::Wall(wall) => (0, wall.index()),
        End::Vertex(vertex) => (1, vertex.index()),
        End::Track(who) => (2, who.index()),
        End::Meeting(meeting) => (3, meeting.index()),
        End::Escape => (4, 0),
    }
}

impl<'a> Checker<'a> {
    fn new(graph: &'a MotorcycleGraph, planes: &'a Planes, walls: Walls<'a>) -> Self {
        let mut posts = Vec::new();
        if let Walls::Figure(figure) = walls {
            posts.resize(figure.vertices().len(), [None; 2]);
            for (e, edge) in figure.edges().iter().enumerate() {
                let plane = PlaneId(2 * e as u32);
                for v in [edge.from, edge.to] {
                    let posts: &mut [Option<PlaneId>; 2] = &mut posts[v.index()];
                    match posts {
                        [None, _] => posts[0] = Some(plane),
                        [Some(first), None] if !planes.turn(*first, plane).is_zero() => {
                            posts[1] = Some(plane);
                        }
                        _ => {}
                    }
                }
            }
        }
        Self {
            graph,
            planes,
            walls,
            posts,
            riders: Vec::new(),
            causes: vec![None; graph.motorcycles().len()],
            list: Vec::new(),
        }
    }

    fn instant(&self, place: Place) -> Stage {
        Stage {
            place,
            bounds: self.planes.time_bounds(&place),
        }
    }

    fn compare(&self, p: &Stage, q: &Stage) -> Ordering {
        (p.bounds.compare(q.bounds))
            .unwrap_or_else(|| self.planes.compare_instants(&p.place, &q.place))
    }

    /// Whether a spot is what rounding makes of a place.
    fn is_rounded(&self, spot: Spot, place: &Place) -> bool {
        let told = [spot.x, spot.y, spot.time].map(|x| (x + 0.0).to_bits());
        told == self.planes.round(place).map(|x| (x + 0.0).to_bits())
    }

    fn run(mut self, starters: &[([PlaneId; 2], Origin, Place)]) -> Result<(), GraphViolations> {
        self.check_starts(starters);
        if self.list.is_empty() {
            self.check_ends();
        }
        if self.list.is_empty() {
            self.check_contacts();
            self.check_causes();
        }
        if self.list.is_empty() {
            Ok(())
        } else {
            Err(GraphViolations { list: self.list })
        }
    }

    /// Who starts, and that all that is named is there.
    fn check_starts(&mut self, starters: &[([PlaneId; 2], Origin, Place)]) {
        let all = self.graph.motorcycles();
        let from_meeting = |m: &Motorcycle| matches!(m.origin, Origin::Meeting(_));
        let own = all.iter().take_while(|m| !from_meeting(m)).count();
        if own != starters.len() {
            self.list.push(GraphViolation::Count {
                found: own,
                expected: starters.len(),
            });
        }
        let mut children = 0;
        for (meeting, id) in self.graph.meetings().iter().zip((0..).map(MeetingId::new)) {
            let members = &meeting.members;
            let is_sound = members.len() > 1
                && members.is_sorted_by(|a, b| a < b)
                && members
                    .iter()
                    .chain(&meeting.child)
                    .all(|who| who.index() < all.len())
                && members
                    .iter()
                    .all(|who| all[who.index()].end == End::Meeting(id))
                && (meeting.child).is_none_or(|who| all[who.index()].origin == Origin::Meeting(id));
            children += usize::from(meeting.child.is_some());
            if !is_sound {
                self.list.push(GraphViolation::WrongMeeting { meeting: id });
            }
        }
        let given = matches!(self.walls, Walls::Given(..));
        for (i, motorcycle) in all.iter().enumerate() {
            let id = MotorcycleId::new(i);
            let is_sound = match (motorcycle.origin, starters.get(i)) {
                (Origin::Meeting(meeting), _) => {
                    let meeting = self.graph.meetings().get(meeting.index());
                    !given
                        && motorcycle.between.is_some()
                        && meeting.is_some_and(|meeting| meeting.child == Some(id))
                }
                (origin, Some((pair, expected, _))) => {
                    origin == *expected
                        && (motorcycle.between).map(|[left, right]| [plane(right), plane(left)])
                            == (!given).then_some(*pair)
                }
                _ => false,
            };
            let names = match motorcycle.end {
                End::Escape => given,
                End::Edge(edge, _) => !given && edge.index() < self.walls.len(),
                End::Vertex(vertex) => vertex.index() < self.posts.len(),
                End::Wall(wall) => given && wall.index() < self.walls.len(),
                End::Track(other) => other.index() < all.len() && other != id,
                End::Meeting(meeting) => (self.graph.meetings())
                    .get(meeting.index())
                    .is_some_and(|meeting| meeting.members.contains(&id)),
            };
            if !(is_sound && names) || motorcycle.stop.is_none() != (motorcycle.end == End::Escape)
            {
                self.list
                    .push(GraphViolation::WrongStart { motorcycle: id });
            }
        }
        if all.len() != own + children && self.list.is_empty() {
            self.list.push(GraphViolation::Count {
                found: all.len() - children,
                expected: starters.len(),
            });
        }
        if self.list.is_empty() {
            self.set_riders(starters);
        }
    }

    /// The motorcycles by definition, the children in the order of their numbers; their ends are not known yet.
    fn set_riders(&mut self, starters: &[([PlaneId; 2], Origin, Place)]) {
        for (i, motorcycle) in self.graph.motorcycles().iter().enumerate() {
            let (pair, place) = match (motorcycle.origin, starters.get(i)) {
                (Origin::Meeting(number), _) => {
                    let meeting = self.graph.meeting(number);
                    let born = if meeting.members.iter().all(|who| who.index() < i) {
                        let pairs: Vec<_> = (meeting.members.iter())
                            .map(|who| self.riders[who.index()].pair)
                            .collect();
                        births::born(self.planes, &pairs)
                    } else {
                        None
                    };
                    let told =
                        (motorcycle.between).map(|[left, right]| [plane(right), plane(left)]);
                    let Some((pair, place)) = born.filter(|(pair, _)| Some(*pair) == told) else {
                        self.list
                            .push(GraphViolation::WrongMeeting { meeting: number });
                        return;
                    };
                    (pair, place)
                }
                (_, Some((pair, _, place))) => (*pair, *place),
                _ => unreachable!("starts were counted"),
            };
            let start = self.instant(place);
            self.riders.push(Rider {
                pair,
                lane: self.planes.lane(pair),
                start,
                stop: None,
            });
        }
    }

    /// A cause at the place where a motorcycle ends.
    fn add_cause(&mut self, who: usize, end: End) {
        let cause = &mut self.causes[who];
        if cause.is_none_or(|known| rank(end) < rank(known)) {
            *cause = Some(end);
        }
    }

    /// Each ends by what counts there.
    fn check_causes(&mut self) {
        for (i, motorcycle) in self.graph.motorcycles().iter().enumerate() {
            let by = self.causes[i];
            let expected = by.unwrap_or(End::Escape);
            // Which meeting it is was seen at its members.
            let same = match (motorcycle.end, expected) {
                (End::Meeting(_), End::Meeting(_)) => true,
                (end, expected) => end == expected,
            };
            if !same {
                self.list.push(GraphViolation::WrongEnd {
                    motorcycle: MotorcycleId::new(i),
                    by,
                });
            }
        }
        self.list.dedup();
    }
}

/// Checks the graph of motorcycles and walls that were given.
pub(super) fn of_launches(
    graph: &MotorcycleGraph,
    planes: &Planes,
    starters: &[([PlaneId; 2], Place)],
    walls: &[[[f64; 2]; 2]],
) -> Result<(), GraphViolations> {
    let starters: Vec<_> = (starters.iter())
        .map(|&(pair, place)| (pair, Origin::Given, place))
        .collect();
    Checker::new(graph, planes, Walls::Given(starters.len(), walls)).run(&starters)
}

impl MotorcycleGraph {
    /// Checks the laws that the motorcycle graph of a figure obeys, without what made it. Exact, without
    /// tolerances:
    ///
    /// * one motorcycle starts in each sector of more than 180 degrees, and where the wavefront has a reflex vertex after a
    ///   meeting;
    /// * starts, stops and velocities are the correctly rounded ones, bit for bit;
    /// * each goes straight ahead until it first reaches an edge, a vertex, or a place where another one was before or is at
    ///   that moment, and no further; what is said to stop it is what counts there.
    ///
    /// There is one graph only that obeys them.
    ///
    /// ```
    /// # use hipline::Polygon;
    /// let polygon = Polygon::new([vec![[0., 0.], [8., 0.], [8., 6.], [4., 2.], [0., 6.]]])?;
    /// let graph = polygon.figure().motorcycles()?;
    /// assert_eq!(graph.verify(polygon.figure()), Ok(()));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Complexity
    /// Near n log n on ordinary input.
    ///
    /// # Errors
    /// All violations of the first kind of law that is broken, as the others make sense only then. All, too, if the figure is one
    /// that induces no motorcycle graph.
    pub fn verify(&self, figure: &Figure) -> Result<(), GraphViolations> {
        if start::check(figure).is_err() {
            let count = GraphViolation::Count {
                found: self.motorcycles().len(),
                expected: 0,
            };
            return Err(GraphViolations { list: vec![count] });
        }
        let planes = Planes::new(figure, &[]);
        let starters: Vec<_> = (start::starters(figure, &planes).iter())
            .map(|track| {
                let vertex = match track.origin {
                    super::tracks::Origin::Vertex(vertex) => vertex,
                    _ => unreachable!("starters are at vertices"),
                };
                (track.pair, Origin::Vertex(vertex), track.start)
            })
            .collect();
        Checker::new(self, &planes, Walls::Figure(figure)).run(&starters)
    }
}
