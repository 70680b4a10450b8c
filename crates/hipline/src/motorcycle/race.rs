//! All motorcycles at once, crash by crash in the order of time.
//!
//! A [`Hit`] says that a motorcycle gets to something that may stop it; whether it does is known
//! when all earlier hits of those concerned are settled. Who finds the hits is the [`Ground`]'s matter: all
//! pairs, or those that walk through one triangle. It may take *steps* of its own before the moment of the
//! next hit; steps have no effect but to find hits, so they are ordered by lower bounds in f64, and one that is
//! taken too early is only taken in vain.
//!
//! Hits are taken from the queue in clusters, of those whose bounds in f64 overlap: mostly one alone. In a cluster, the exact order
//! matters only among hits that have motorcycles in common. In symmetric figures many crashes are at one
//! moment, and nearly none of them have to be compared.

use super::{
    agenda::Agenda,
    births,
    field::{Field, Ground},
    hits::{Found, Hit, Obstacle, Queued, Step},
    tracks::{Crash, Meeting, Origin, Track, Tracks},
};
use crate::{predicates::Planes, topology::Sets};
use std::{cmp::Reverse, collections::BinaryHeap};

/// Hits that may depend on each other, and groups that do not.
#[derive(Default)]
struct Groups {
    /// All groups in which one may be born.
    fertile: Vec<Hit>,
    /// The other groups.
    sterile: Vec<Vec<Hit>>,
    /// Which of the latter hits of a motorcycle are in, ascending.
    group_of: Vec<(u32, usize)>,
}

/// The state between two moments.
struct Race<'a, G> {
    field: Field<'a>,
    ground: G,
    hits: BinaryHeap<Reverse<Queued>>,
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
            until: Vec::with_capacity(starters.len()),
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
        race.ground.start(&race.field, who, &mut race.found);
        race.file();
    }
    while race.advance() {}
    race.field.sort_meetings();
    Tracks {
        motorcycles: race.field.tracks,
        meetings: race.field.meetings,
    }
}

impl<'a, G: Ground> Race<'a, G> {
    /// Puts what was found into the queues.
    fn file(&mut self) {
        for hit in self.found.hits.drain(..) {
            if matches!(hit.on, Obstacle::Wall(_) | Obstacle::Vertex(_)) {
                let until = &mut self.field.until[hit.who as usize];
                *until = until.min(hit.bounds.high);
            }
            self.hits.push(Reverse(Queued(hit)));
        }
        let steps = self.found.steps.drain(..);
        self.steps.extend(steps.map(Reverse));
    }

    /// Settles the next cluster of hits. False if there is nothing left to do.
    fn advance(&mut self) -> bool {
        let mut cluster = Vec::new();
        let mut high = f64::NEG_INFINITY;
        self.gather(&mut cluster, &mut high);
        if let [hit] = *cluster {
            self.settle(&[hit]);
            return true;
        }
        if cluster.is_empty() {
            return false;
        }
        let Groups {
            fertile,
            sterile,
            group_of,
        } = self.groups(&cluster);
        let mut sterile: Vec<Option<Vec<Hit>>> = sterile.into_iter().map(Some).collect();
        let mut agenda = Agenda::new(&self.field, fertile);
        while let Some(moment) = agenda.pop() {
            let count = self.field.tracks.len();
            self.settle(&moment);
            if self.field.tracks.len() == count {
                continue;
            }
            // Whoever is born may get in the way of any of them.
            let mut fresh = Vec::new();
            self.gather(&mut fresh, &mut high);
            for hit in fresh {
                for who in std::iter::once(hit.who).chain(hit.on.other()) {
                    let group = group_of.binary_search_by_key(&who, |&(who, _)| who);
                    if let Ok(at) = group
                        && let Some(hits) = sterile[group_of[at].1].take()
                    {
                        hits.into_iter()
                            .for_each(|hit| agenda.add(&self.field, hit));
                    }
                }
                agenda.add(&self.field, hit);
            }
        }
        for hits in sterile.into_iter().flatten() {
            let mut agenda = Agenda::new(&self.field, hits);
            while let Some(moment) = agenda.pop() {
                self.settle(&moment);
            }
        }
        true
    }

    /// Takes the hits whose bounds overlap those of a cluster, whose upper bound is told, or the first of all if there is none.
    fn gather(&mut self, cluster: &mut Vec<Hit>, high: &mut f64) {
        let is_first = *high == f64::NEG_INFINITY;
        loop {
            let next = self
                .hits
                .peek()
                .map(|Reverse(Queued(hit))| (hit.who, hit.bounds));
            if let Some((who, _)) = next
                && !self.field.moves(who)
            {
                self.hits.pop();
                continue;
            }
            let is_first = is_first && cluster.is_empty();
            let next = next.filter(|(_, bounds)| is_first || bounds.low <= *high);
            // All that may be found up to there has to be found before.
            let until = match next {
                Some((_, bounds)) => high.max(bounds.high),
                None if is_first => f64::INFINITY,
                None => *high,
            };
            if let Some(&Reverse(step)) = self.steps.peek()
                && step.low <= until
            {
                self.steps.pop();
                if self.field.moves(step.who) {
                    self.ground.step(&self.field, step, &mut self.found);
                    self.file();
                }
                continue;
            }
            if next.is_none() {
                return;
            }
            cluster.extend(self.hits.pop().map(|Reverse(Queued(hit))| hit));
            *high = until;
        }
    }

    /// The hits of a cluster by groups that do not depend on each other: those in which one may be born, and
    /// the others.
    ///
    /// A hit depends on those of the same motorcycle, and on those of the other one that it runs into, unless that
    /// one was there before the cluster began.
    fn groups(&self, cluster: &[Hit]) -> Groups {
        let low = cluster
            .iter()
            .map(|hit| hit.bounds.low)
            .fold(f64::INFINITY, f64::min);
        let mut ids: Vec<u32> = cluster.iter().map(|hit| hit.who).collect();
        ids.sort_unstable();
        ids.dedup();
        let mut sets = Sets::new(ids.len());
        for hit in cluster {
            let before = hit.there.is_some_and(|there| there.high < low);
            let at = |id: u32| ids.binary_search(&id).ok();
            if let Some(other) = hit.on.other().filter(|_| !before)
                && let (Some(a), Some(b)) = (at(hit.who), at(other))
            {
                sets.join(a, b);
            }
        }
        let mut hits: Vec<(usize, Hit)> = (cluster.iter())
            .map(|hit| {
                let at = ids.binary_search(&hit.who).expect("it is among them");
                (sets.root(at), *hit)
            })
            .collect();
        hits.sort_by_key(|(component, _)| *component);
        let mut groups = Groups::default();
        for hits in hits.chunk_by(|a, b| a.0 == b.0) {
            let hits = || hits.iter().map(|(_, hit)| *hit);
            if hits().any(|hit| self.is_fertile(&hit)) {
                groups.fertile.extend(hits());
            } else {
                let number = groups.sterile.len();
                groups.group_of.extend(hits().map(|hit| (hit.who, number)));
                groups.sterile.push(hits().collect());
            }
        }
        groups.group_of.sort_unstable();
        groups.group_of.dedup();
        groups
    }

    /// Whether somebody may be born where two meet: if it is between them.
    fn is_fertile(&self, hit: &Hit) -> bool {
        let Obstacle::Rival(other) = hit.on else {
            return false;
        };
        let [a, b] = [hit.who, other].map(|who| self.field.tracks[who as usize].pair);
        self.births
            && [[a, b], [b, a]]
                .iter()
                .any(|members| births::is_born(self.field.planes, members))
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
        let moves = |hit: &&Hit| self.field.moves(hit.who) && self.counts(hit);
        let mut valid: Vec<Hit> = batch.iter().filter(moves).copied().collect();
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
            self.end(&hit, crash);
        }
        rivals.sort_by_key(|(group, hit)| (*group, hit.who));
        for group in rivals.chunk_by(|a, b| a.0 == b.0) {
            self.meet(group);
        }
    }

    fn end(&mut self, hit: &Hit, crash: Crash) {
        let who = hit.who as usize;
        let track = &mut self.field.tracks[who];
        track.crash = crash;
        track.end = Some(hit.place);
        self.field.until[who] = self.field.until[who].min(hit.bounds.high);
    }

    /// Ends those who meet, and starts who is born there.
    fn meet(&mut self, group: &[(u32, Hit)]) {
        let number = self.field.meetings.len() as u32;
        let mut members: Vec<u32> = group.iter().map(|(_, hit)| hit.who).collect();
        members.dedup();
        assert!(members.len() > 1, "motorcycle {} meets nobody", members[0]);
        for &(_, hit) in group {
            self.end(&hit, Crash::Meeting(number));
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
            self.ground.start(&self.field, child, &mut self.found);
            self.file();
        }
    }
}
