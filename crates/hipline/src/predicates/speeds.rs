//! The speeds of planes, and the planes that exist because speeds change.

use dashu_int::IBig;
use hipline_num::{BallDd, Number, common_unit, in_units};

use super::{
    Terminal,
    lines::Line,
    phases::{self, Phases},
    planes::{PlaneId, Planes, Rung, Speeds, exact_time},
};
use crate::{
    input::Figure,
    topology::{EdgeId, VertexId},
};

/// The speeds of all planes of edges and terminals, of later phases and of facets over tilted eaves.
fn all<'a>(
    figure: &'a Figure,
    terminals: &'a [Terminal],
    phases: &'a Phases,
) -> impl Iterator<Item = f64> + 'a {
    let edges = figure.edges().iter().enumerate().flat_map(|(e, edge)| {
        if figure.has_height(EdgeId::new(e)) {
            [0.0; 2]
        } else {
            edge.speeds
        }
    });
    let terminals = terminals.iter().flat_map(|terminal| {
        let high = figure.height(VertexId::new(terminal.tip)) > 0.0;
        [if high { 0.0 } else { terminal.speed }; 2]
    });
    let later = phases.later_speeds().flat_map(|w| [w, w]);
    let facets = phases.eaves().iter().flat_map(|eave| {
        let speed = figure.edges()[eave.edge.index()].speeds[(eave.wall.0 & 1) as usize];
        [speed, speed]
    });
    edges.chain(terminals).chain(later).chain(facets)
}

/// The unit of all speeds, as an exponent, and the digits of the largest one over it.
pub(super) fn unit(figure: &Figure, terminals: &[Terminal], phases: &Phases) -> (i32, i32) {
    common_unit(all(figure, terminals, phases))
}

impl Planes {
    /// The lines of later phases: copies of those of the first ones.
    pub(super) fn add_later_phases(&mut self) {
        let later = self.phases.later().iter();
        let later: Vec<(usize, IBig)> = later
            .map(|(first, omega)| ((first.0 >> 1) as usize, phases::offset(omega, self.unit)))
            .collect();
        for (line, offset) in later {
            self.lines.push(self.lines[line].clone());
            self.push_near(self.doubles[line]);
            self.offsets.push(offset);
        }
    }

    /// The planes of one height. Returns their speeds.
    fn add_levels(&mut self) -> Vec<IBig> {
        let mut speeds = Vec::new();
        let times: Vec<f64> = self.phases.levels().iter().map(|level| level.0).collect();
        for time in times {
            let [p, q] = exact_time(self, time);
            let c = -p;
            let doubles = [
                BallDd::from_i64(0),
                BallDd::from_i64(0),
                BallDd::integer(&c, self.shift),
                BallDd::from_i64(1),
            ];
            self.push_near(doubles);
            self.lines.push(Line::Level(c));
            speeds.extend([q.clone(), q]);
        }
        speeds
    }

    /// The speeds of all planes, and the planes that come with those of edges and terminals.
    pub(super) fn set_speeds(&mut self, figure: &Figure, terminals: &[Terminal], unit: (i32, i32)) {
        #[expect(clippy::float_cmp, reason = "asks for the number one itself")]
        let plain = figure.edges().iter().all(|e| e.speeds == [1.0, 1.0]);
        if plain && self.phases.is_empty() {
            return;
        }
        let (unit, bits) = unit;
        let shift = if bits > 20 || self.shift > 0 {
            (bits - 10).max(0)
        } else {
            0
        };
        let all = all(figure, terminals, &self.phases);
        let mut exact: Vec<IBig> = all.map(|w| in_units(w, unit)).collect();
        self.time_unit = self.unit - unit;
        self.add_later_phases();
        self.add_eaves(figure, unit, shift);
        // The posts stand still.
        exact.resize(exact.len() + 4 * self.phases.eaves().len(), IBig::ZERO);
        self.speeds = Some(Speeds { exact, shift });
        let mut levels = self.add_levels();
        let speeds = self.speeds.as_mut().expect("just set");
        speeds.exact.append(&mut levels);
    }

    /// Which of two planes is the faster one? Of equally fast ones, the one whose wavefront
    /// edge will be the faster one as soon as their speeds differ.
    pub(crate) fn compare_speeds(&self, i: PlaneId, j: PlaneId) -> std::cmp::Ordering {
        match &self.speeds {
            None => std::cmp::Ordering::Equal,
            Some(speeds) => speeds.exact[i.0 as usize]
                .cmp(&speeds.exact[j.0 as usize])
                .then_with(|| self.phases.compare_futures(i, j)),
        }
    }

    /// Whether two planes have one speed.
    pub(super) fn are_equally_fast(&self, i: PlaneId, j: PlaneId) -> bool {
        let equal = |speeds: &Speeds| speeds.exact[i.0 as usize] == speeds.exact[j.0 as usize];
        self.speeds.as_ref().is_none_or(equal)
    }

    /// Whether a wavefront edge does not move.
    pub(crate) fn stands_still(&self, plane: PlaneId) -> bool {
        let still = |speeds: &Speeds| speeds.exact[plane.0 as usize] == IBig::ZERO;
        self.speeds.as_ref().is_some_and(still)
    }

    /// The post across a tilted eave at one of its ends, given the plane of the wall below it.
    pub(crate) fn post_at(
        &self,
        edges: &[[VertexId; 2]],
        wall: PlaneId,
        vertex: VertexId,
    ) -> Option<PlaneId> {
        let eave = self.phases.eave_of(wall)?;
        let edge = edges[eave.edge.index()];
        let at_end = (edge[0] != vertex) != (wall.0 % 2 == 1);
        Some(eave.posts[usize::from(at_end)])
    }

    /// Whether some wavefront edge stands still for some time: then faces may stand upright.
    pub(crate) fn has_upright(&self) -> bool {
        let zero = |speeds: &Speeds| speeds.exact.contains(&IBig::ZERO);
        self.speeds.as_ref().is_some_and(zero)
    }

    /// The moment of a time at which speeds change, by its plane of one height.
    pub(crate) fn moment_of_level(&self, level: PlaneId) -> Option<[PlaneId; 3]> {
        let first = PlaneId(0);
        let others = (1..self.first_later as u32).map(|line| PlaneId(2 * line));
        let mut triple = others
            .map(|other| [first, other, level])
            .find(|triple| self.do_meet(*triple))?;
        triple.sort_unstable();
        Some(triple)
    }
}
