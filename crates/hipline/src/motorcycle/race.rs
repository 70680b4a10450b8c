//! All motorcycles at once, crash by crash in the order of time.
//!
//! A [`Hit`] says that a motorcycle gets to something that may stop it; whether it does is known
//! when all earlier hits are settled. Who finds the hits is the [`Ground`]'s matter: all pairs, or those
//! that walk through one triangle. It may take *steps* of its own before the moment of the next
//! hit; steps have no effect but to find hits, so they are ordered by lower bounds in f64, and one that is
//! taken too early is only taken in vain.

use super::{
    births,
    tracks::{Crash, Meeting, Origin, Track, Tracks},
};
use crate::{
    predicates::{Bounds, Lane, Place, PlaneId, Planes, Rail},
    topology::VertexId,
};
use std::{
    cmp::{Ordering, Reverse},
    collections::BinaryHeap,
};

/// What a motorcycle may run into.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Obstacle {
    /// The inside of an edge, seen from the side of a plane; or a wall.
    Wall(PlaneId),
    /// A vertex.
    Vertex(VertexId),
    /// The track of another one that was there before, if it was there at all.
    Track(u32),
    /// Another one that arrives at the same moment.
    Rival(u32),
}

impl Obstacle {
    /// Of all that is at one place, what counts: a wall before a track before a meeting, and of
    /// several the one with the lowest number.
    const fn rank(self) -> (u8, u32) {
        match self {
            Self::Wall(plane) => (0, plane.0),
            Self::Vertex(vertex) => (1, vertex.index() as u32),
            Self::Track(who) => (2, who),
            Self::Rival(who) => (3, who),
        }
    }
}

/// A motorcycle gets to an obstacle.
#[derive(Clone, Copy, Debug)]
pub(super) struct Hit {
    pub who: u32,
    pub on: Obstacle,
    pub place: Place,
    pub bounds: Bounds,
    /// Where the ground found it.
    pub cell: u32,
}

/// A step that the ground wants to take not later than when a motorcycle gets somewhere.
#[derive(Clone, Copy, Debug)]
pub(super) struct Step {
    /// At most the time when it gets there.
    pub low: f64,
    pub who: u32,
    /// Where it gets: the ground knows.
    pub cell: u32,
    pub side: u32,
}

impl PartialEq for Step {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other).is_eq()
    }
}

impl Eq for Step {}

impl PartialOrd for Step {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Step {
    fn cmp(&self, other: &Self) -> Ordering {
        self.low
            .total_cmp(&other.low)
            .then_with(|| (self.who, self.cell).cmp(&(other.who, other.cell)))
    }
}

/// What a ground found.
#[derive(Debug, Default)]
pub(super) struct Found {
    pub hits: Vec<Hit>,
    pub steps: Vec<Step>,
}

/// The motorcycles so far, as a ground sees them.
pub(super) struct Field<'a> {
    pub planes: &'a Planes,
    pub tracks: Vec<Track>,
    /// The path of each.
    pub lanes: Vec<Lane>,
    /// When each starts, as far as f64 can tell.
    pub starts: Vec<Bounds>,
    pub meetings: Vec<Meeting>,
}

impl Field<'_> {
    fn add(&mut self, track: Track) -> u32 {
        self.lanes.push(self.planes.lane(track.pair));
        self.starts.push(self.planes.time_bounds(&track.start));
        self.tracks.push(track);
        self.tracks.len() as u32 - 1
    }

    /// Whether a motorcycle still moves.
    pub(super) fn moves(&self, who: u32) -> bool {
        self.tracks[who as usize].end.is_none()
    }

    /// Compares the times of two places whose bounds are known. Exact.
    pub(super) fn compare(&self, p: (&Place, Bounds), q: (&Place, Bounds)) -> Ordering {
        p.1.compare(q.1)
            .unwrap_or_else(|| self.planes.compare_instants(p.0, q.0))
    }

    /// Whether the track that a motorcycle gets to reaches as far as there.
    fn is_reached(&self, hit: &Hit, other: u32) -> bool {
        let Some(end) = &self.tracks[other as usize].end else {
            // It was there before, and still moves.
            return true;
        };
        let (pair, own) = (
            self.tracks[other as usize].pair,
            self.tracks[hit.who as usize].pair,
        );
        let rail = match hit.place {
            Place::On { rail, .. } if rail == Rail::Path(pair) => Rail::Path(own),
            // At its own start.
            Place::On { pair: on, .. }
                if on == own && hit.place != self.tracks[hit.who as usize].start =>
            {
                return true;
            }
            // At the other one's start, on the way of this one.
            Place::On { rail, .. } => rail,
            _ => unreachable!("a track is hit where a path is crossed"),
        };
        let there = Place::On { pair, rail };
        let bounds = [&there, end].map(|place| self.planes.time_bounds(place));
        self.compare((&there, bounds[0]), (end, bounds[1])).is_le()
    }
}

/// Where motorcycles find what they may run into.
pub(super) trait Ground {
    /// A motorcycle starts. If a meeting bore it, the cells where the ground found that are told.
    fn start(&mut self, field: &Field, who: u32, cells: &[u32], found: &mut Found);
    /// Takes a step.
    fn step(&mut self, field: &Field, step: Step, found: &mut Found);
}

/// A hit in the queue: the first one is the greatest.
struct Queued<'a>(Hit, &'a Planes);

impl PartialEq for Queued<'_> {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other).is_eq()
    }
}

impl Eq for Queued<'_> {}

impl PartialOrd for Queued<'_> {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Queued<'_> {
    fn cmp(&self, other: &Self) -> Ordering {
        (self.0.bounds.compare(other.0.bounds))
            .unwrap_or_else(|| self.1.compare_instants(&self.0.place, &other.0.place))
            .reverse()
    }
}

/// The state between two moments.
struct Race<'a, G> {
    field: Field<'a>,
    ground: G,
    hits: BinaryHeap<Queued<'a>>,
    steps: BinaryHeap<Reverse<Step>>,
    found: Found,
    births: bool,
}

/// Lets motorcycles run on a ground until each has crashed or escapes; where they meet, new ones start if
/// `births` is set.
pub(super) fn run<G: Ground>(
    planes: &Planes,
    starters: Vec<Track>,
    ground: G,
    births: bool,
) -> Tracks {
    let mut race = Race {
        field: Field {
            planes,
            lanes: Vec::with_capacity(starters.len()),
            starts: Vec::with_capacity(starters.len()),
            tracks: Vec::with_capacity(starters.len()),
            meetings: Vec::new(),
        },
        ground,
        hits: BinaryHeap::new(),
        steps: BinaryHeap::new(),
        found: Found::default(),
        births,
    };
    for track in starters {
        let who = race.field.add(track);
        race.ground.start(&race.field, who, &[], &mut race.found);
        race.file();
    }
    while race.advance() {}
    Tracks {
        motorcycles: race.field.tracks,
        meetings: race.field.meetings,
    }
}

impl<'a, G: Ground> Race<'a, G> {
    /// Puts what was found into the queues.
    fn file(&mut self) {
        let planes = self.field.planes;
        let hits = self.found.hits.drain(..);
        self.hits.extend(hits.map(|hit| Queued(hit, planes)));
        let steps = self.found.steps.drain(..);
        self.steps.extend(steps.map(Reverse));
    }

    /// Takes a step, or settles a moment. False if there is nothing left to do.
    fn advance(&mut self) -> bool {
        while self
            .hits
            .peek()
            .is_some_and(|hit| !self.field.moves(hit.0.who))
        {
            self.hits.pop();
        }
        let until = self
            .hits
            .peek()
            .map_or(f64::INFINITY, |hit| hit.0.bounds.high);
        if let Some(&Reverse(step)) = self.steps.peek()
            && step.low <= until
        {
            self.steps.pop();
            if self.field.moves(step.who) {
                self.ground.step(&self.field, step, &mut self.found);
                self.file();
            }
            return true;
        }
        let Some(Queued(first, _)) = self.hits.pop() else {
            return false;
        };
        let batch = self.all_of_the_moment(first);
        self.settle(&batch);
        true
    }

    /// All hits of the moment of the first one.
    fn all_of_the_moment(&mut self, first: Hit) -> Vec<Hit> {
        let mut batch = vec![first];
        while let Some(Queued(hit, _)) = self.hits.peek() {
            if self.field.moves(hit.who) {
                let now = (&first.place, first.bounds);
                if self.field.compare((&hit.place, hit.bounds), now).is_ne() {
                    break;
                }
                batch.push(*hit);
            }
            self.hits.pop();
        }
        batch
    }

    /// Whether what is hit is there.
    fn counts(&self, hit: &Hit) -> bool {
        match hit.on {
            Obstacle::Wall(_) | Obstacle::Vertex(_) => true,
            Obstacle::Track(other) => self.field.is_reached(hit, other),
            Obstacle::Rival(other) => self.field.moves(other),
        }
    }

    /// Settles all hits of one moment.
    fn settle(&mut self, batch: &[Hit]) {
        let mut valid: Vec<Hit> = batch
            .iter()
            .filter(|hit| self.counts(hit))
            .copied()
            .collect();
        valid.sort_by_key(|hit| (hit.who, hit.on.rank()));
        // Those that meet, by the first one of their meeting.
        let mut rivals: Vec<(u32, Hit)> = Vec::new();
        for hits in valid.chunk_by(|a, b| a.who == b.who) {
            let hit = hits[0];
            let crash = match hit.on {
                Obstacle::Wall(plane) => Crash::Wall(plane),
                Obstacle::Vertex(vertex) => Crash::Vertex(vertex),
                Obstacle::Track(other) => Crash::Track(other),
                Obstacle::Rival(other) => {
                    let group = other.min(hit.who);
                    rivals.extend(hits.iter().map(|hit| (group, *hit)));
                    continue;
                }
            };
            self.end(hit.who, crash, hit.place);
        }
        rivals.sort_by_key(|(group, hit)| (*group, hit.who));
        for group in rivals.chunk_by(|a, b| a.0 == b.0) {
            self.meet(group);
        }
    }

    fn end(&mut self, who: u32, crash: Crash, place: Place) {
        let track = &mut self.field.tracks[who as usize];
        track.crash = crash;
        track.end = Some(place);
    }

    /// Ends those who meet, and starts who is born there.
    fn meet(&mut self, group: &[(u32, Hit)]) {
        let number = self.field.meetings.len() as u32;
        let mut members: Vec<u32> = group.iter().map(|(_, hit)| hit.who).collect();
        members.dedup();
        assert!(members.len() > 1, "motorcycle {} meets nobody", members[0]);
        for &(_, hit) in group {
            self.end(hit.who, Crash::Meeting(number), hit.place);
        }
        let place = group[0].1.place;
        let pairs: Vec<_> = (members.iter())
            .map(|&who| self.field.tracks[who as usize].pair)
            .collect();
        let born = if self.births {
            births::born(self.field.planes, &pairs)
        } else {
            None
        };
        let child = born.map(|(pair, start)| {
            self.field.add(Track {
                pair,
                origin: Origin::Meeting(number),
                start,
                crash: Crash::Escape,
                end: None,
            })
        });
        self.field.meetings.push(Meeting {
            place,
            members,
            child,
        });
        if let Some(child) = child {
            let mut cells: Vec<u32> = group.iter().map(|(_, hit)| hit.cell).collect();
            cells.sort_unstable();
            cells.dedup();
            self.ground
                .start(&self.field, child, &cells, &mut self.found);
            self.file();
        }
    }
}
