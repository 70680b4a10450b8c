//! Speeds, and what changes them: the phases of a wavefront edge.
//!
//! While its speed is constant, a wavefront edge moves on one plane; from the time of a
//! change on it moves on another one, which meets the first at that time. Each phase but
//! the first has a plane of its own, numbered after those of the edges and terminals:
//! `a x + b y = c + L (omega + w t)`, with `omega` such that the place at the change is the same.
//! After those comes one plane of one height, `t = T`, for each time T of a change, so that such a moment is
//! the meeting of three planes like any other.

use dashu_int::{IBig, ops::BitTest};
use hipline_num::{common_unit, f64_to_parts};
use std::cmp::Ordering;

use super::{PlaneId, Terminal, eaves::Eave};
use crate::{input::Figure, topology::EdgeId};

/// `mantissa * 2^exponent`.
type Dyadic = (IBig, i32);

fn sum(p: &Dyadic, q: &Dyadic) -> Dyadic {
    let unit = p.1.min(q.1);
    let at = |d: &Dyadic| &d.0 << (d.1 - unit) as usize;
    (at(p) + at(q), unit)
}

/// An integer over the given unit, which divides it.
fn over(value: &Dyadic, unit: i32) -> IBig {
    if value.0 == IBig::ZERO {
        IBig::ZERO
    } else {
        &value.0 << (value.1 - unit) as usize
    }
}

/// What one wavefront edge does over time.
#[derive(Debug, Clone)]
struct Course {
    /// Its plane in each phase.
    planes: Vec<PlaneId>,
    /// From when on, and how fast it moves then; the first one at time zero.
    speeds: Vec<[f64; 2]>,
    /// Whether its second phase starts at one end, as its eave is tilted.
    tilted: bool,
}

/// The phases of the wavefront edges whose speed changes.
#[derive(Debug, Default)]
pub(crate) struct Phases {
    courses: Vec<Course>,
    /// For each plane that is of a course: the plane, the course and the phase; sorted.
    of_plane: Vec<(PlaneId, u32, u32)>,
    /// The times of changes, ascending, and the planes of one height there.
    levels: Vec<(f64, PlaneId)>,
    /// For each time of a change, in the same order, the planes that others follow then, with those.
    steps: Vec<Vec<(PlaneId, PlaneId)>>,
    /// For each of these times, which eaves have their lower end there.
    births: Vec<Vec<u32>>,
    /// The plane of the second and later phases, in order, from number `first` of lines on: that of the
    /// first phase, and omega.
    later: Vec<(PlaneId, Dyadic)>,
    /// The tilted eaves, by edge, left side first.
    eaves: Vec<Eave>,
}

impl Phases {
    /// The phases of a figure; the lines of `lines` are those of the edges and terminals.
    pub(super) fn new(figure: &Figure, terminals: &[Terminal], lines: usize) -> Self {
        let mut phases = Self::default();
        if figure.changes().is_empty() && !figure.has_heights() {
            return phases;
        }
        let edges = figure.edges();
        for (e, right) in (0..edges.len()).flat_map(|e| [(e, false), (e, true)]) {
            phases.add_edge(figure, EdgeId::new(e), right);
        }
        for (i, terminal) in terminals.iter().enumerate() {
            let speeds = terminal.speeds(figure);
            if speeds.len() > 1 {
                phases.add_course(PlaneId(2 * (edges.len() + i) as u32), speeds);
            }
        }
        let mut line = lines;
        for course in phases.courses.iter_mut().filter(|course| !course.tilted) {
            let mut omega: Dyadic = (IBig::ZERO, 0);
            for pair in course.speeds.windows(2) {
                let [time, before, after] = [pair[1][0], pair[0][1], pair[1][1]].map(f64_to_parts);
                let slower = sum(&before, &(-after.0, after.1));
                omega = sum(&omega, &(slower.0 * time.0, slower.1 + time.1));
                let first = course.planes[0];
                course.planes.push(PlaneId(2 * line as u32 + (first.0 & 1)));
                phases.later.push((first, omega.clone()));
                line += 1;
            }
        }
        let mut eaves = phases.eaves.iter_mut();
        for course in phases.courses.iter_mut().filter(|course| course.tilted) {
            let eave = eaves.next().expect("each tilted course is an eave's");
            eave.facet = PlaneId(2 * line as u32);
            course.planes.push(eave.facet);
            line += 1;
        }
        for eave in &mut phases.eaves {
            eave.posts = [0, 2].map(|k| PlaneId(2 * line as u32 + k));
            line += 2;
        }
        for (c, course) in phases.courses.iter().enumerate() {
            let planes = course.planes.iter().enumerate();
            phases
                .of_plane
                .extend(planes.map(|(k, &plane)| (plane, c as u32, k as u32)));
        }
        phases.of_plane.sort_unstable();
        let mut times: Vec<f64> = phases
            .courses
            .iter()
            .flat_map(|course| course.speeds[1..].iter().map(|s| s[0]))
            .filter(|&time| time > 0.0)
            .collect();
        times.sort_by(f64::total_cmp);
        times.dedup_by_key(|time| time.to_bits());
        let levels = times.into_iter().enumerate();
        phases.levels = levels
            .map(|(i, time)| (time, PlaneId(2 * (line + i) as u32)))
            .collect();
        phases.sort_by_time();
        phases
    }

    /// Finds out what happens at each of the times.
    fn sort_by_time(&mut self) {
        self.steps = vec![Vec::new(); self.levels.len()];
        self.births = vec![Vec::new(); self.levels.len()];
        let find = |time: f64| {
            self.levels
                .binary_search_by(|level| level.0.total_cmp(&time))
        };
        for course in self.courses.iter().filter(|course| !course.tilted) {
            for (speed, planes) in course.speeds[1..].iter().zip(course.planes.windows(2)) {
                if let Ok(k) = find(speed[0]) {
                    self.steps[k].push((planes[0], planes[1]));
                }
            }
        }
        for (i, eave) in self.eaves.iter().enumerate() {
            if let Ok(k) = find(eave.from) {
                self.births[k].push(i as u32);
            }
        }
    }

    /// The planes that others follow at the time with this number, with those.
    pub(crate) fn steps(&self, level: usize) -> &[(PlaneId, PlaneId)] {
        &self.steps[level]
    }

    /// The tilted eaves whose lower end is at the time with this number; at time zero without one.
    pub(crate) fn births(&self, level: Option<usize>) -> Vec<Eave> {
        match level {
            Some(level) => (self.births[level].iter())
                .map(|&i| self.eaves[i as usize])
                .collect(),
            None => (self.eaves.iter().copied())
                .filter(|eave| eave.from <= 0.0)
                .collect(),
        }
    }

    /// What one side of an edge does over time, if it does more than moving.
    fn add_edge(&mut self, figure: &Figure, e: EdgeId, right: bool) {
        let edge = &figure.edges()[e.index()];
        let plane = PlaneId(2 * e.index() as u32 + u32::from(right));
        let speed = edge.speeds[usize::from(right)];
        let heights = [edge.from, edge.to].map(|v| figure.height(v));
        let changes = figure.changes_of(e, right);
        let changes = changes.iter().map(|change| [change.time, change.speed]);
        if !figure.has_height(e) {
            if changes.len() > 0 {
                self.add_course(
                    plane,
                    std::iter::once([0.0, speed]).chain(changes).collect(),
                );
            }
        } else if speed <= 0.0 {
            // It stands still for ever, or until it changes its speed.
            if changes.len() > 0 {
                self.add_course(plane, std::iter::once([0.0, 0.0]).chain(changes).collect());
            }
        } else if heights[0].to_bits() == heights[1].to_bits() {
            let start = [[0.0, 0.0], [heights[0], speed]];
            self.add_course(plane, start.into_iter().chain(changes).collect());
        } else {
            let [from, to] = if right {
                [heights[1], heights[0]]
            } else {
                heights
            };
            let low = from.min(to);
            self.courses.push(Course {
                planes: vec![plane],
                speeds: vec![[0.0, 0.0], [low, speed]],
                tilted: true,
            });
            self.eaves.push(Eave {
                edge: e,
                wall: plane,
                facet: plane,
                rises: from < to,
                from: low,
                to: from.max(to),
                posts: [plane; 2],
            });
        }
    }

    fn add_course(&mut self, plane: PlaneId, speeds: Vec<[f64; 2]>) {
        self.courses.push(Course {
            planes: vec![plane],
            speeds,
            tilted: false,
        });
    }

    /// Whether no speed changes.
    pub(crate) const fn is_empty(&self) -> bool {
        self.courses.is_empty()
    }

    /// The times of changes, ascending, each with a plane of one height.
    pub(crate) fn levels(&self) -> &[(f64, PlaneId)] {
        &self.levels
    }

    /// The first-phase plane and the omega of each later phase's plane, in the order of
    /// their lines.
    pub(super) fn later(&self) -> &[(PlaneId, Dyadic)] {
        &self.later
    }

    /// The speed of every later phase's plane, in the order of their lines.
    pub(super) fn later_speeds(&self) -> impl Iterator<Item = f64> + '_ {
        let speeds = |course: &Course| course.speeds[1..].to_vec();
        self.courses
            .iter()
            .filter(|course| !course.tilted)
            .flat_map(move |course| speeds(course).into_iter().map(|s| s[1]))
    }

    fn find(&self, plane: PlaneId) -> Option<(&Course, usize)> {
        let at = self.of_plane.binary_search_by_key(&plane, |p| p.0).ok()?;
        let (_, course, phase) = self.of_plane[at];
        Some((&self.courses[course as usize], phase as usize))
    }

    /// The plane of the first phase of a plane's wavefront edge, and the number of the phase.
    pub(crate) fn origin(&self, plane: PlaneId) -> (PlaneId, u32) {
        match self.find(plane) {
            Some((course, phase)) => (course.planes[0], phase as u32),
            None => (plane, 0),
        }
    }

    /// From when on a wavefront edge moves on a plane.
    pub(crate) fn time_of(&self, plane: PlaneId) -> f64 {
        self.find(plane)
            .map_or(0.0, |(course, phase)| course.speeds[phase][0])
    }

    /// The plane of one phase of a wavefront edge, named by its first plane.
    pub(crate) fn plane(&self, first: PlaneId, phase: u32) -> Option<PlaneId> {
        if phase == 0 {
            return Some(first);
        }
        let (course, _) = self.find(first)?;
        course.planes.get(phase as usize).copied()
    }

    /// The plane that follows at the given time, if the speed changes then.
    pub(crate) fn after(&self, plane: PlaneId, time: f64) -> Option<PlaneId> {
        let (course, phase) = self.find(plane)?;
        let [from, _] = *course.speeds.get(phase + 1)?;
        if course.tilted {
            return None;
        }
        (from.to_bits() == time.to_bits()).then(|| course.planes[phase + 1])
    }

    /// All tilted eaves.
    pub(crate) fn eaves(&self) -> &[Eave] {
        &self.eaves
    }

    /// The tilted eave whose wall is the given plane.
    pub(crate) fn eave_of(&self, wall: PlaneId) -> Option<&Eave> {
        let at = self
            .eaves
            .binary_search_by_key(&wall, |eave| eave.wall)
            .ok()?;
        Some(&self.eaves[at])
    }

    /// Whether a plane stands across the end of a tilted eave.
    pub(crate) fn is_post(&self, plane: PlaneId) -> bool {
        let first = self.eaves.first().map(|eave| eave.posts[0].0);
        let last = self.eaves.last().map(|eave| eave.posts[1].0 + 1);
        first.is_some_and(|first| plane.0 >= first) && last.is_some_and(|last| plane.0 <= last)
    }

    /// Exponents that the unit of coordinates must not exceed, and that which they stay below, for the
    /// heights of tilted eaves to be integers over the unit of time.
    pub(super) fn height_range(&self, speed_unit: i32) -> Option<(i32, i32)> {
        let heights = self.eaves.iter().flat_map(|eave| [eave.from, eave.to]);
        let used: Vec<f64> = heights.filter(|&h| h > 0.0).collect();
        if used.is_empty() {
            return None;
        }
        let (low, bits) = common_unit(used);
        Some((low + speed_unit, low + speed_unit + bits))
    }

    /// Whether the plane has a plane after it.
    pub(crate) fn will_change(&self, plane: PlaneId) -> bool {
        self.find(plane)
            .is_some_and(|(course, phase)| phase + 1 < course.planes.len())
    }

    /// Compares what two wavefront edges of equal speed will do: which one will be the faster one, as soon as
    /// their speeds differ?
    pub(super) fn compare_futures(&self, i: PlaneId, j: PlaneId) -> Ordering {
        let future = |plane| {
            // A wall below a tilted eave never moves: a facet grows beside it.
            let course = self.find(plane).filter(|(course, _)| !course.tilted);
            course.map_or(&[][..], |(course, phase)| &course.speeds[phase + 1..])
        };
        let (mut p, mut q) = (future(i), future(j));
        loop {
            match (p, q) {
                ([], []) => return Ordering::Equal,
                ([a, rest @ ..], [b, others @ ..]) if a[0].to_bits() == b[0].to_bits() => {
                    let order = a[1].total_cmp(&b[1]);
                    if order.is_ne() {
                        return order;
                    }
                    (p, q) = (rest, others);
                }
                // One of them changes first; until then their speeds are equal.
                _ => {
                    let is_first = match (p.first(), q.first()) {
                        (Some(a), Some(b)) => a[0] < b[0],
                        (first, _) => first.is_some(),
                    };
                    let (plane, list) = if is_first { (i, p) } else { (j, q) };
                    let faster = self.grows(plane, list);
                    return if is_first { faster } else { faster.reverse() };
                }
            }
        }
    }

    /// Whether the first change of `rest`, the last changes of a plane's course, is to a higher speed.
    fn grows(&self, plane: PlaneId, rest: &[[f64; 2]]) -> Ordering {
        let (course, _) = self.find(plane).expect("its speed changes");
        let at = course.speeds.len() - rest.len();
        course.speeds[at][1].total_cmp(&course.speeds[at - 1][1])
    }
}

/// Exponents of the smallest digit of the omegas and of the one beyond the largest.
pub(super) fn range(later: &[(PlaneId, Dyadic)]) -> Option<(i32, i32)> {
    let used = later.iter().map(|(_, omega)| omega);
    used.filter(|omega| omega.0 != IBig::ZERO)
        .map(|(mantissa, exponent)| {
            let zeros = mantissa.trailing_zeros().unwrap_or(0) as i32;
            let bits = mantissa.bit_len() as i32;
            (exponent + zeros, exponent + bits)
        })
        .reduce(|p, q| (p.0.min(q.0), p.1.max(q.1)))
}

/// The omega of a later phase, as an integer over the unit of coordinates.
pub(super) fn offset(omega: &Dyadic, unit: i32) -> IBig {
    let (mantissa, exponent) = omega;
    if *mantissa == IBig::ZERO {
        return IBig::ZERO;
    }
    if *exponent >= unit {
        over(omega, unit)
    } else {
        // The digits below the unit are zeros.
        mantissa >> (unit - exponent) as usize
    }
}
