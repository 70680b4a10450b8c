//! The motorcycles so far, and what grounds are.

use super::{
    hits::{Found, Hit, Obstacle, Step},
    tracks::{Crash, Meeting, Origin, Track},
};
use crate::predicates::{Bounds, Lane, Place, Planes, Rail};
use std::cmp::Ordering;

/// The motorcycles so far, as a ground sees them.
pub(super) struct Field<'a> {
    pub planes: &'a Planes,
    pub tracks: Vec<Track>,
    /// The path of each.
    pub lanes: Vec<Lane>,
    /// When each starts, as far as f64 can tell.
    pub starts: Vec<Bounds>,
    /// By when each has stopped for certain, as far as is known.
    pub until: Vec<f64>,
    /// How long each that has stopped moved at least.
    pub lasted: Vec<f64>,
    /// All that happens before this moment has been settled.
    pub settled: f64,
    pub meetings: Vec<Meeting>,
}

impl Field<'_> {
    pub(super) fn add(&mut self, track: Track) -> u32 {
        self.lanes.push(self.planes.lane(track.pair));
        self.starts.push(self.planes.time_bounds(&track.start));
        self.until.push(f64::INFINITY);
        self.lasted.push(f64::INFINITY);
        self.tracks.push(track);
        self.tracks.len() as u32 - 1
    }

    /// Numbers the meetings by their rounded times, then by their first members.
    pub(super) fn sort_meetings(&mut self) {
        let mut order: Vec<(f64, u32, u32)> = (self.meetings.iter().enumerate())
            .map(|(i, meeting)| {
                let [_, _, time] = self.planes.round(&meeting.place);
                (time, meeting.members[0], i as u32)
            })
            .collect();
        order.sort_by(|p, q| p.0.total_cmp(&q.0).then(p.1.cmp(&q.1)));
        let mut number = vec![0; order.len()];
        for (new, &(_, _, old)) in order.iter().enumerate() {
            number[old as usize] = new as u32;
        }
        for track in &mut self.tracks {
            if let Crash::Meeting(meeting) = &mut track.crash {
                *meeting = number[*meeting as usize];
            }
            if let Origin::Meeting(meeting) = &mut track.origin {
                *meeting = number[*meeting as usize];
            }
        }
        let mut meetings: Vec<(u32, Meeting)> =
            number.into_iter().zip(self.meetings.drain(..)).collect();
        meetings.sort_by_key(|(number, _)| *number);
        self.meetings
            .extend(meetings.into_iter().map(|(_, meeting)| meeting));
    }

    /// Whether a motorcycle still moves.
    pub(super) fn moves(&self, who: u32) -> bool {
        self.tracks[who as usize].end.is_none()
    }

    /// Whether a hit is certain already, so that the motorcycle gets no further: on a wall, or on a track that is there.
    pub(super) fn is_certain(&self, hit: &Hit) -> bool {
        match hit.on {
            Obstacle::Wall(_) | Obstacle::Vertex(_) => true,
            Obstacle::Track(other) => {
                // Who still moves will stop at the moment that is settled next at the earliest.
                let lasts = self.settled.min(self.lasted[other as usize]);
                hit.there.is_some_and(|there| there.high <= lasts)
            }
            Obstacle::Rival(_) => false,
        }
    }

    /// Compares the times of two places whose bounds are known. Exact.
    pub(super) fn compare(&self, p: (&Place, Bounds), q: (&Place, Bounds)) -> Ordering {
        p.1.compare(q.1)
            .unwrap_or_else(|| self.planes.compare_instants(p.0, q.0))
    }

    /// Whether the track that a motorcycle gets to reaches as far as there.
    pub(super) fn is_reached(&self, hit: &Hit, other: u32) -> bool {
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
        let end = (end, self.planes.time_bounds(end));
        let bounds = hit.there.unwrap_or_else(|| self.planes.time_bounds(&there));
        self.compare((&there, bounds), end).is_le()
    }
}

/// Where motorcycles find what they may run into.
pub(super) trait Ground {
    /// A motorcycle starts.
    fn start(&mut self, field: &Field, who: u32, found: &mut Found);
    /// Takes a step.
    fn step(&mut self, field: &Field, step: Step, found: &mut Found);
}
