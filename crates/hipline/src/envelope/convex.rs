//! Above a convex cell without valleys the roof is the lower envelope of the planes of its faces (section 4.1 of the thesis).
//!
//! The lower envelope of planes of one slope is the roof above a convex polygon, the one whose edges are all lines, long before any two of them
//! have met; it shrinks, and its edges vanish one after another.

use super::{Envelope, slabs::sorted};
use crate::{
    predicates::{Place, PlaneId},
    topology::WaveId,
    wavefront::Queue,
};
use std::cmp::Ordering;

impl Envelope<'_> {
    /// The pairs of planes (by class) that border on each other on their lower envelope; a few more where nodes are of high degree.
    ///
    /// # Complexity
    /// O(k log k) questions.
    pub(super) fn convex_pairs(&mut self, mut planes: Vec<PlaneId>) -> Vec<[PlaneId; 2]> {
        planes.sort_unstable();
        planes.dedup();
        let ring = self.by_direction(planes);
        let mut pairs = Vec::with_capacity(2 * ring.len());
        let count = ring.len();
        if count < 2 {
            return pairs;
        }
        let mut beside: Vec<[usize; 2]> = (0..count)
            .map(|i| [(i + count - 1) % count, (i + 1) % count])
            .collect();
        let vanishing = |i: usize, [before, after]: [usize; 2]| {
            self.vanishing([before, i, after].map(|k| ring[k]))
        };
        // Where each edge vanishes, as it is queued.
        let mut places: Vec<Option<Place>> = (beside.iter().enumerate())
            .map(|(i, &beside)| vanishing(i, beside))
            .collect();
        let bounds = |place: &Option<Place>| Some(self.planes.time_bounds(place.as_ref()?));
        let mut queue = Queue::default();
        queue.reset(count);
        queue.fill(
            (places.iter().enumerate())
                .filter_map(|(i, place)| Some((WaveId::new(i), bounds(place)?))),
        );
        pairs.extend((0..count).map(|i| [ring[i], ring[beside[i][1]]]));
        let exact = |places: &[Option<Place>], i: WaveId, j: WaveId| {
            let [p, q] = [i, j].map(|w| places[w.index()].as_ref().expect("it vanishes"));
            self.planes.compare_times(p, q)
        };
        let mut steps = 0;
        while let Some(gone) = queue.peek(&|i, j| exact(&places, i, j)) {
            queue.set(gone, None, &|i, j| exact(&places, i, j));
            steps += 1;
            let [a, c] = beside[gone.index()];
            beside[a][1] = c;
            beside[c][0] = a;
            pairs.push([ring[a], ring[c]]);
            for middle in [a, c] {
                places[middle] = vanishing(middle, beside[middle]);
                let bounds = bounds(&places[middle]);
                queue.set(WaveId::new(middle), bounds, &|i, j| exact(&places, i, j));
            }
        }
        self.count.planes += steps;
        pairs
    }

    /// Where the edge of the second one of three planes vanishes between those of the others, if it does.
    fn vanishing(&self, [a, b, c]: [PlaneId; 3]) -> Option<Place> {
        let shrinks =
            a != c && self.planes.turn(a, b).is_positive() && self.planes.turn(b, c).is_positive();
        shrinks.then(|| Place::Event {
            pair: [a, b],
            moment: sorted([a, b, c]),
        })
    }

    /// Planes in the order of their directions, counterclockwise; of those with one direction, the lowest.
    fn by_direction(&self, mut planes: Vec<PlaneId>) -> Vec<PlaneId> {
        let first = planes[0];
        let half = |i: PlaneId| match self.planes.turn(first, i) {
            sign if sign.is_positive() => 0,
            sign if sign.is_negative() => 1,
            _ => u8::from(!self.planes.same_direction(first, i)),
        };
        let mut keyed: Vec<(u8, PlaneId)> = planes.drain(..).map(|i| (half(i), i)).collect();
        let order = |&(k, i): &(u8, PlaneId), &(l, j): &(u8, PlaneId)| {
            k.cmp(&l).then_with(|| {
                if i == j {
                    Ordering::Equal
                } else {
                    self.planes.turn(j, i).ordering()
                }
            })
        };
        keyed.sort_by(order);
        let mut ring: Vec<(u8, PlaneId)> = Vec::with_capacity(keyed.len());
        for item in keyed {
            match ring.last_mut() {
                Some(last) if order(last, &item).is_eq() => {
                    if self.is_lower(item.1, last.1) {
                        *last = item;
                    }
                }
                _ => ring.push(item),
            }
        }
        ring.into_iter().map(|(_, i)| i).collect()
    }

    /// Whether one of two planes of one direction is below the other.
    fn is_lower(&self, i: PlaneId, j: PlaneId) -> bool {
        let across = self
            .across
            .into_iter()
            .find(|&k| !self.planes.turn(i, k).is_zero());
        let across = across.expect("they have two directions");
        let pair = self.planes.turning_left([i, across]).expect("they cross");
        // Where i is at time zero, j has not been yet, if it is later there.
        (self.planes.ahead(&Place::At { pair, time: 0.0 }, j)).is_positive()
    }
}
