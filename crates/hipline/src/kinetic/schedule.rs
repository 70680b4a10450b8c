//! When does a triangle collapse next?

use std::{
    cell::{Cell, LazyCell, OnceCell, RefCell},
    cmp::Ordering,
};

use super::{
    Kinetic,
    triangulation::{Across, next, prev},
};
use crate::predicates::{Bounds, Corner, Moment, PlaneId, Planes};
use crate::topology::{Sets, TriangleId, WaveId};
use crate::wavefront::{Trace, Wavefront};
use hipline_num::{BallDd, Number, Sign, Wide};

pub(super) fn corner(front: &Wavefront, tip: super::triangulation::Tip) -> Corner {
    match tip.trace() {
        Some(x) => Corner::Finite(front.trace(x).pair),
        None => Corner::Ideal(tip.direction().expect("a tip is a vertex or a direction")),
    }
}

/// The moment at which two vertices meet whose paths cross, if they ever do.
pub(super) fn meeting_moment(planes: &Planes, u: &Trace, v: &Trace) -> Option<[PlaneId; 3]> {
    v.pair
        .into_iter()
        .map(|third| [u.pair[0], u.pair[1], third])
        .find(|&triple| !u.pair.contains(&triple[2]) && planes.do_meet(triple))
}

/// What is known of a moment besides its bounds.
#[derive(Clone, Copy, Debug)]
struct Closer {
    /// In double-double.
    fine: Option<BallDd>,
    /// Its number among the sets of equal ones, if it has one.
    class: u32,
    /// Its number among those that are known in 400 digits, if it is.
    wide: u32,
}

const NONE: u32 = u32::MAX;

impl Default for Closer {
    fn default() -> Self {
        Self {
            fine: None,
            class: NONE,
            wide: NONE,
        }
    }
}

/// A moment in few bytes: three planes, or the place of its triangle's corners among the roots.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Short([PlaneId; 3]);

impl Short {
    const START: Self = Self([NO_PLANE; 3]);

    /// The place among the roots, if it is one.
    fn root(self) -> Option<u32> {
        (self.0[0] == NO_PLANE && self.0[1] != NO_PLANE).then_some(self.0[1].0)
    }
}

const NO_PLANE: PlaneId = PlaneId(u32::MAX);

/// What few triangles have, by numbers that are used again.
#[derive(Debug)]
struct Store<T> {
    all: Vec<T>,
    unused: Vec<u32>,
}

impl<T> Default for Store<T> {
    fn default() -> Self {
        Self {
            all: Vec::new(),
            unused: Vec::new(),
        }
    }
}

impl<T> Store<T> {
    fn add(&mut self, value: T) -> u32 {
        let number = self.unused.pop().unwrap_or(self.all.len() as u32);
        match self.all.get_mut(number as usize) {
            Some(old) => *old = value,
            None => self.all.push(value),
        }
        number
    }

    fn remove(&mut self, number: u32) {
        self.unused.push(number);
    }

    fn get(&self, number: u32) -> &T {
        &self.all[number as usize]
    }
}

/// The moments of the queued triangles, with what has been found out about their order.
#[derive(Debug, Default)]
pub(super) struct Agenda {
    moments: Vec<Short>,
    /// The corners of triangles that collapse at roots, which are few.
    roots: Store<[Corner; 3]>,
    /// What is known besides, of figures in which bounds do not always decide.
    closer: OnceCell<Vec<Cell<Closer>>>,
    /// Moments of one of these sets are known to be equal.
    equal: RefCell<Sets>,
    /// Moments in 400 digits, of those that double-double does not tell apart.
    wide: RefCell<Store<Wide>>,
}

impl Agenda {
    pub(super) fn new(triangles: usize) -> Self {
        Self {
            moments: vec![Short::START; triangles],
            roots: Store::default(),
            closer: OnceCell::new(),
            equal: RefCell::default(),
            wide: RefCell::default(),
        }
    }

    pub(super) fn moment(&self, t: TriangleId) -> Moment {
        let short = self.moments[t.index()];
        match short.root() {
            Some(i) => Moment::Root(*self.roots.get(i)),
            None if short.0[0] == NO_PLANE => Moment::Start,
            None => Moment::Planes(short.0),
        }
    }

    pub(super) fn set(&mut self, t: TriangleId, moment: Moment) {
        let i = t.index();
        if let Some(root) = self.moments[i].root() {
            self.roots.remove(root);
        }
        self.moments[i] = match moment {
            Moment::Start => Short::START,
            Moment::Planes(triple) => Short(triple),
            Moment::Root(corners) => {
                let root = self.roots.add(corners);
                Short([NO_PLANE, PlaneId(root), NO_PLANE])
            }
        };
        if let Some(closer) = self.closer.get() {
            let known = closer[i].take();
            if known.wide != NONE {
                self.wide.get_mut().remove(known.wide);
            }
        }
    }

    fn cell(&self, t: TriangleId) -> &Cell<Closer> {
        let all = || vec![Cell::new(Closer::default()); self.moments.len()];
        &self.closer.get_or_init(all)[t.index()]
    }

    fn closer(&self, t: TriangleId) -> Closer {
        self.cell(t).get()
    }

    fn change(&self, t: TriangleId, change: impl FnOnce(&mut Closer)) {
        let mut closer = self.closer(t);
        change(&mut closer);
        self.cell(t).set(closer);
    }

    fn fine(&self, planes: &Planes, t: TriangleId) -> BallDd {
        self.closer(t).fine.unwrap_or_else(|| {
            let value = planes.fine(&self.moment(t));
            self.change(t, |closer| closer.fine = Some(value));
            value
        })
    }

    /// The set of moments equal to this one, if any was found to be.
    fn class(&self, t: TriangleId) -> Option<u32> {
        let class = self.closer(t).class;
        (class != NONE).then(|| self.equal.borrow_mut().root(class as usize) as u32)
    }

    fn unite(&self, a: TriangleId, b: TriangleId) {
        if let (Some(i), Some(j)) = (self.class(a), self.class(b)) {
            self.equal.borrow_mut().join(i as usize, j as usize);
            return;
        }
        let known = self.class(a).or_else(|| self.class(b));
        let class = known.unwrap_or_else(|| self.equal.borrow_mut().push());
        for t in [a, b] {
            self.change(t, |closer| closer.class = class);
        }
    }

    fn wide(&self, planes: &Planes, t: TriangleId) -> Wide {
        let number = self.closer(t).wide;
        if number != NONE {
            return *self.wide.borrow().get(number);
        }
        let value = planes.wide(&self.moment(t));
        let number = self.wide.borrow_mut().add(value);
        self.change(t, |closer| closer.wide = number);
        value
    }

    /// The exact order of two queued triangles whose bounds do not decide it.
    pub(super) fn compare(&self, planes: &Planes, a: TriangleId, b: TriangleId) -> Ordering {
        // What collapses with one wavefront edge has one moment by its definition.
        if self.moments[a.index()] == self.moments[b.index()] {
            return Ordering::Equal;
        }
        let difference = self.fine(planes, a).minus(&self.fine(planes, b));
        if let Some(sign) = difference.sign() {
            return sign.ordering();
        }
        let class = self.class(a);
        if class.is_some() && class == self.class(b) {
            return Ordering::Equal;
        }
        let [p, q] = [a, b].map(|t| self.moment(t));
        let fixed = || planes.compare_fixed(&p, &q);
        let wide = || {
            let difference = self.wide(planes, a).minus(&self.wide(planes, b));
            difference.sign().map(Sign::ordering)
        };
        // On a grid, what is as close as this is equal.
        let order = if planes.is_on_grid() {
            fixed().or_else(wide)
        } else {
            wide().or_else(fixed)
        };
        let order = order.unwrap_or_else(|| planes.compare(&p, &q));
        if order.is_eq() {
            self.unite(a, b);
        }
        order
    }
}

impl Kinetic<'_> {
    /// Finds the next collapse of a triangle and sets it in the queue.
    pub(super) fn reschedule(&mut self, t: TriangleId) {
        self.stats.steps += 1;
        let found = if self.triangulation.is_alive(t) {
            self.next_collapse(t)
        } else {
            None
        };
        // Before its moment changes, by which it may be in order.
        self.enqueue(t, None);
        self.agenda
            .set(t, found.map_or(Moment::Start, |(moment, _)| moment));
        if let Some((_, bounds)) = found {
            self.enqueue(t, Some(bounds));
        }
    }

    /// Queues a triangle by its moment on the agenda, or takes it from the queue.
    pub(super) fn enqueue(&mut self, t: TriangleId, bounds: Option<Bounds>) {
        let Self {
            queue,
            planes,
            agenda,
            ..
        } = self;
        queue.set(t, bounds, &|a, b| agenda.compare(planes, a, b));
    }

    /// The moment for which a triangle was taken from the queue in this batch: equal to `now`.
    pub(super) fn due(&self, t: TriangleId) -> Option<Moment> {
        match self.agenda.moment(t) {
            Moment::Start => None,
            moment => (!self.queue.contains(t)).then_some(moment),
        }
    }

    /// How and when a triangle collapses next.
    pub(super) fn next_collapse(&self, t: TriangleId) -> Option<(Moment, Bounds)> {
        let triangle = self.triangulation.get(t);
        let mut best: Option<(Moment, Bounds)> = None;
        let waves = triangle.across.map(Across::wave);
        let count = waves.iter().flatten().count();
        if count == 0 {
            return self.next_flat(t);
        }
        for (k, wave) in waves.into_iter().enumerate() {
            let Some(wave) = wave else { continue };
            let triple = self.collapse_planes(wave);
            let [start, end] = [triangle.tips[next(k)], triangle.tips[prev(k)]].map(|tip| {
                self.front
                    .trace(tip.trace().expect("wavefront edges are finite"))
            });
            let turns = self.turns(triple, [start, end]);
            // The length is -(N + D t) times a number of the sign of both turns' product.
            if let Some(bounds) = self.planes.meeting_if(triple, turns) {
                best = Some(self.earlier(best, (Moment::of_planes(triple), bounds)));
            }
            if count == 1
                && let Some(apex) = triangle.tips[k].trace()
            {
                let [i, j] = self.front.trace(apex).pair;
                let plane = self.front.wave(wave).plane;
                if plane != i
                    && plane != j
                    && let Some(bounds) = self.planes.meeting_if([plane, i, j], Sign::Positive)
                {
                    best = Some(self.earlier(best, (Moment::of_planes([plane, i, j]), bounds)));
                }
            }
        }
        best
    }

    /// The planes whose meeting makes a wavefront edge vanish.
    pub(super) fn collapse_planes(&self, wave: WaveId) -> [PlaneId; 3] {
        let [start, end] = self.triangulation.ends(wave).map(|x| self.front.trace(x));
        let plane = |wave| self.front.wave(wave).plane;
        let (mut before, mut after) = (plane(start.inn), plane(end.out));
        // A vertex between walls on one line stands on the first plane of its pair.
        if !self.changes.closed.is_empty() || !self.planes.phases.eaves().is_empty() {
            if self.planes.turn(before, plane(wave)).is_zero() {
                before = start.pair[0];
            }
            if self.planes.turn(plane(wave), after).is_zero() {
                after = end.pair[0];
            }
        }
        [before, plane(wave), after]
    }

    /// The product of the turns at both ends of a wavefront edge.
    fn turns(&self, [before, plane, after]: [PlaneId; 3], ends: [&Trace; 2]) -> Sign {
        let phases = &self.planes.phases;
        let [start, end] = ends;
        // Posts stand between walls on one line, so that they turn another way for each of them.
        if phases.is_post(before) || phases.is_post(after) {
            self.planes.turn(before, plane) * self.planes.turn(plane, after)
        } else {
            start.turn * end.turn
        }
    }

    /// The earlier one of two collapses of a triangle; the first, if they coincide.
    fn earlier(&self, a: Option<(Moment, Bounds)>, b: (Moment, Bounds)) -> (Moment, Bounds) {
        let Some(a) = a else { return b };
        let order =
            a.1.compare(b.1)
                .unwrap_or_else(|| self.planes.compare(&a.0, &b.0));
        if order == Ordering::Greater { b } else { a }
    }

    /// When a triangle without a wavefront edge becomes flat.
    fn next_flat(&self, t: TriangleId) -> Option<(Moment, Bounds)> {
        let triangle = self.triangulation.get(t);
        let traces = triangle
            .tips
            .map(|tip| tip.trace().map(|x| self.front.trace(x)));
        // A corner that comes to lie between two others sees more than half a turn.
        if traces.iter().flatten().count() < 2
            || traces
                .iter()
                .flatten()
                .all(|trace| trace.turn == Sign::Positive)
        {
            return None;
        }
        let corners = triangle.tips.map(|tip| corner(&self.front, tip));
        // The ends of a spoke may meet: an event of the wavefront, at a moment of three planes.
        let meetings = LazyCell::new(|| {
            [0, 1, 2].map(|k| {
                let (u, v) = (traces[next(k)]?, traces[prev(k)]?);
                if !self.planes.paths_cross(u.pair, v.pair) {
                    return None;
                }
                Some((u, v, meeting_moment(&self.planes, u, v)?))
            })
        });
        let do_meet = || meetings.iter().any(Option::is_some);
        let bounds = self.planes.falling_root(&self.now, corners, do_meet)?;
        for (k, met) in meetings.iter().enumerate() {
            let &Some((u, v, triple)) = met else { continue };
            let meeting = Moment::of_planes(triple);
            let order = self.planes.bounds(&meeting).compare(bounds);
            if order.is_some_and(Ordering::is_ne) {
                continue;
            }
            // The area is zero then; if it does not rise, that is the root at which it falls.
            let slope = (self.planes).slope_at_meeting(triple, u.pair, v.pair, corners[k]);
            if slope != Sign::Positive {
                return Some((meeting, self.planes.bounds(&meeting)));
            }
        }
        Some((Moment::Root(corners), bounds))
    }
}
