//! From a figure to the first triangulation (Lemma 3 of the paper).
//!
//! Each sector between two consecutive edges around a vertex gets a wavefront vertex, and
//! the triangles in it. Straight vertices are removed while everything still stands, and
//! then each terminal's vertex is doubled: a spoke that points ahead of the new wavefront
//! edge is opened into a triangle.

use super::{
    Batch, Kinetic,
    change::Changes,
    schedule::Agenda,
    triangulation::{Across, Spokes, Tip, Triangulation, next, prev},
};
use crate::{
    input::{Figure, Mesh, MeshEdge},
    predicates::{Bounds, Moment, PlaneId, Planes, Terminal},
    skeleton::{Region, Stats},
    topology::{TraceId, TriangleId, WaveId},
    wavefront::{End, Queue, Trace, Walk, Wave, Wavefront},
};
use hipline_num::Sign;

/// In which of the four directions the outside of a hull edge is framed: one that is
/// strictly ahead of it, and turns with the hull.
fn frame(from: [f64; 2], to: [f64; 2]) -> usize {
    let (nx, ny) = (from[1].total_cmp(&to[1]), to[0].total_cmp(&from[0]));
    if nx.is_gt() && ny.is_ge() {
        0
    } else if ny.is_gt() && nx.is_le() {
        1
    } else if nx.is_lt() && ny.is_le() {
        2
    } else {
        3
    }
}

/// Stands for a side of an edge that bounds no triangle.
const NO_SIDE: (TriangleId, u8) = (TriangleId::raw(u32::MAX), 0);

/// The triangles that are kept, in the order of their first vertices. An input mostly goes along
/// its shape, so that what is near each other in the plane is so in memory.
fn along_input(mesh: &Mesh, vertices: usize, kept: impl Fn(usize) -> bool) -> Vec<u32> {
    let first = |t: usize| {
        let [a, b, c] = mesh.corners[t];
        a.min(b).min(c) as usize
    };
    let mut next = vec![0_u32; vertices + 1];
    for t in (0..mesh.corners.len()).filter(|&t| kept(t)) {
        next[first(t) + 1] += 1;
    }
    for v in 0..vertices {
        next[v + 1] += next[v];
    }
    let mut order = vec![0; next[vertices] as usize];
    for t in (0..mesh.corners.len()).filter(|&t| kept(t)) {
        let place = &mut next[first(t)];
        order[*place as usize] = t as u32;
        *place += 1;
    }
    order
}

impl<'a> Kinetic<'a> {
    /// The state at time zero, terminals and straight vertices not yet treated.
    pub(super) fn new(figure: &'a Figure, region: Region, modified: bool) -> Self {
        let terminals = Terminal::with_caps(figure, modified);
        let planes = Planes::new(figure, &terminals);
        let faces = 2 * figure.edges().len() + terminals.len();
        let mut kinetic = Self {
            figure,
            planes,
            terminals,
            triangulation: Triangulation::default(),
            front: Wavefront::new(figure.vertices().len(), faces),
            queue: Queue::default(),
            agenda: Agenda::default(),
            now: Moment::Start,
            bounds: Bounds::START,
            batch: Batch::default(),
            changes: Changes::default(),
            stats: Stats::default(),
        };
        kinetic.triangulate(region);
        kinetic
    }

    /// Copies the triangles of the region, frames the outside, makes wavefront edges.
    fn triangulate(&mut self, region: Region) {
        let mesh = self.figure.mesh();
        let outside = region != Region::Interior;
        let kept = |t: usize| mesh.is_in(t, region);
        let order = along_input(mesh, self.figure.vertices().len(), kept);
        let count = order.len();
        let mut number = vec![Across::NOTHING; mesh.corners.len()];
        for (i, &t) in order.iter().enumerate() {
            number[t as usize] = TriangleId::new(i).into();
        }
        // Each hull edge has a triangle, and there are as many more as the frame has turns.
        let first_hull = count;
        let hull = if outside { mesh.hull.len() } else { 0 };
        let waves = 2 * self.figure.edges().len();
        let room = count + 2 * hull + 8 + self.terminals.len();
        self.triangulation = Triangulation::with_capacity(room, waves + self.terminals.len());
        let neighbour = |edge: &MeshEdge| {
            if edge.neighbour & MeshEdge::HULL == 0 {
                number[edge.neighbour as usize]
            } else if outside {
                TriangleId::new(first_hull + (edge.neighbour & !MeshEdge::HULL) as usize).into()
            } else {
                Across::NOTHING
            }
        };
        let start = |edge: u32| self.figure.edges()[edge as usize].from.index() as u32;
        let mut sides = vec![NO_SIDE; waves];
        for t in order.into_iter().map(|t| t as usize) {
            let id = self.triangulation.push(
                // Vertices for now, to be replaced by wavefront vertices.
                mesh.corners[t].map(|v| Tip::from(TraceId::new(v as usize))),
                mesh.across[t].map(|edge| neighbour(&edge)),
            );
            for k in 0..3 {
                if let Some(edge) = mesh.across[t][k].edge {
                    let left = mesh.corners[t][next(k)] == start(edge);
                    sides[2 * edge as usize + usize::from(!left)] = (id, k as u8);
                }
            }
        }
        if outside {
            let place = |v: u32| self.figure.vertices()[v as usize];
            let direction: Vec<usize> = mesh
                .hull
                .iter()
                .map(|edge| frame(place(edge.from), place(edge.to)))
                .collect();
            for (i, edge) in mesh.hull.iter().enumerate() {
                let id = self.triangulation.push(
                    [
                        Tip::from(TraceId::new(edge.from as usize)),
                        Tip::from(TraceId::new(edge.to as usize)),
                        Tip::ideal(direction[i]),
                    ],
                    [Across::NOTHING, Across::NOTHING, neighbour(&edge.across)],
                );
                if let Some(e) = edge.across.edge {
                    let left = edge.from == start(e);
                    sides[2 * e as usize + usize::from(!left)] = (id, 2);
                }
            }
            for i in 0..mesh.hull.len() {
                self.fill_corner(first_hull, i, &direction);
            }
        }
        self.add_waves(&sides);
        self.add_vertices();
    }

    /// Fills the angle outside the end of hull edge `i` with triangles that have two corners
    /// at infinity. Counterclockwise around the vertex they come after the next hull edge's
    /// triangle and before this one's.
    fn fill_corner(&mut self, first_hull: usize, i: usize, direction: &[usize]) {
        let j = (i + 1) % direction.len();
        let (this, after) = (
            TriangleId::new(first_hull + i),
            TriangleId::new(first_hull + j),
        );
        let tip = self.triangulation.get(this).tips[1];
        let (mut last, mut side) = (after, 1);
        let turns = (direction[i] + 4 - direction[j]) % 4;
        for d in 0..turns {
            let from = direction[j] + d;
            let id = self.triangulation.push(
                [tip, Tip::ideal(from), Tip::ideal(from + 1)],
                [Across::NOTHING, Across::NOTHING, last.into()],
            );
            self.triangulation.attach(last, side, id.into());
            (last, side) = (id, 1);
        }
        self.triangulation.attach(last, side, this.into());
        self.triangulation.attach(this, 0, last.into());
    }

    /// One wavefront edge for each side of an edge that bounds a triangle, in the order of the
    /// input: so the first arcs have that order, too.
    fn add_waves(&mut self, sides: &[(TriangleId, u8)]) {
        let count = sides.iter().filter(|&&side| side != NO_SIDE).count();
        // Some will be split.
        self.front.waves.reserve(count + count / 4);
        for (face, &(t, k)) in sides.iter().enumerate() {
            if (t, k) == NO_SIDE {
                continue;
            }
            let face = face as u32;
            let wave = self.triangulation.push_wave(t);
            self.triangulation.attach(t, k as usize, wave.into());
            self.front.waves.push(Wave {
                plane: PlaneId(face),
                face,
            });
            self.register(wave);
        }
    }

    /// One wavefront vertex for each sector.
    fn add_vertices(&mut self) {
        self.front.traces.reserve(self.front.waves.len() * 2);
        // Each wavefront edge starts in one sector.
        for out in (0..self.front.waves.len()).map(WaveId::new) {
            let x = TraceId::new(self.front.traces.len());
            let mut fan = self.triangulation.fan(out);
            let (first, at) = fan.next().expect("a wavefront edge bounds a triangle");
            let (last, corner) = fan.last().unwrap_or((first, at));
            let vertex = self.triangulation.get(first).tips[at]
                .trace()
                .expect("a vertex");
            let inn = self.triangulation.get(last).across[next(corner)]
                .wave()
                .unwrap_or_else(|| panic!("the sector at v{} has no second edge", vertex.index()));
            let faces = [inn, out].map(|w| self.front.wave(w).face);
            self.front.push_trace(Trace {
                pair: faces.map(PlaneId),
                inn,
                out,
                born: vertex.index() as u32,
                end: End::Moving,
                turn: Sign::Zero,
                after_up: Walk::Open,
                after_down: Walk::Base(faces[1]),
            });
            self.front.after_base[faces[0] as usize] = Walk::Up(x);
        }
        // Now that every sector is known, rename the corners.
        for out in (0..self.front.waves.len()).map(WaveId::new) {
            let x = TraceId::new(out.index());
            let fan: Spokes = self.triangulation.fan(out).collect();
            for (t, corner) in fan {
                self.triangulation.triangles[t.index()].tips[corner] = x.into();
            }
        }
    }

    /// What happens at time zero.
    pub(super) fn start(&mut self) {
        for i in 0..self.front.traces.len() {
            let x = TraceId::new(i);
            let Trace { inn, out, .. } = *self.front.trace(x);
            let (i, j) = (self.front.wave(inn).plane, self.front.wave(out).plane);
            if i.0 ^ j.0 == 1 {
                continue; // a terminal: the two sides of one edge
            }
            let turn = self.planes.turn(i, j);
            let trace = self.front.trace_mut(x);
            trace.turn = turn;
            match turn {
                Sign::Positive => {}
                Sign::Negative => trace.pair = [j, i],
                Sign::Zero => match self.post_between(inn, out, None) {
                    Some(pair) => {
                        let trace = self.front.trace_mut(x);
                        trace.pair = pair;
                        trace.turn = Sign::Negative;
                    }
                    None => match self.post_below(inn, out) {
                        Some(pair) => self.front.trace_mut(x).pair = pair,
                        None => self.batch.straight.push(x),
                    },
                },
            }
        }
        let tips = self.prepare_terminals();
        let acute = self.wide_sectors();
        self.remove_straight_vertices();
        for (x, terminal) in tips {
            self.open_terminal(x, terminal, self.terminal_plane(terminal));
        }
        for (x, caps) in acute {
            self.open_caps(x, caps);
        }
        self.open_moved_terminals();
        self.refresh_pairs();
        self.start_facets(None);
        self.refresh_pairs();
        self.batch.dirty.clear();
        self.batch.fresh.clear();
        self.find_next_change();
        // Terminals that stand still, and facets over tilted eaves, get a triangle later.
        let eaves = self.planes.phases.eaves().len();
        let n = self.triangulation.len() + self.changes.closed.len() + eaves;
        self.queue.reset(n);
        self.agenda = Agenda::new(n);
        self.stats.steps += self.triangulation.len() as u64;
        let mut queued: Vec<(TriangleId, Bounds)> = Vec::with_capacity(n);
        for t in (0..self.triangulation.len()).map(TriangleId::new) {
            if self.triangulation.is_alive(t)
                && let Some((moment, bounds)) = self.next_collapse(t)
            {
                self.agenda.set(t, moment);
                queued.push((t, bounds));
            }
        }
        self.queue.fill(queued.into_iter());
    }

    /// The plane of terminal or cap number `i`.
    pub(super) fn terminal_plane(&self, i: usize) -> PlaneId {
        PlaneId(2 * (self.figure.edges().len() + i) as u32)
    }

    /// Finds the vertices at terminals, and gives them a pair of planes to stand on.
    fn prepare_terminals(&mut self) -> Vec<(TraceId, usize)> {
        let mut list = Vec::with_capacity(self.terminals.len());
        for i in 0..self.front.traces.len() {
            let trace = self.front.traces[i];
            let plane = self.front.wave(trace.inn).plane;
            if plane.0 ^ self.front.wave(trace.out).plane.0 != 1 {
                continue;
            }
            let tip = trace.born as usize;
            let terminal = self.terminals[..self.figure.terminals()]
                .binary_search_by_key(&tip, |terminal| terminal.tip)
                .expect("both sides of an edge meet at a terminal only");
            // From the edge's side to the terminal's the wavefront turns right.
            let cap = self.terminal_plane(terminal);
            self.front.traces[i].pair = [cap, plane];
            if self.planes.stands_still(cap) {
                self.front.traces[i].turn = Sign::Negative;
                self.changes.closed.insert(terminal, TraceId::new(i));
            } else {
                list.push((TraceId::new(i), terminal));
            }
        }
        list
    }

    /// Doubles the vertex of a terminal.
    pub(super) fn open_terminal(&mut self, x: TraceId, terminal: usize, cap_plane: PlaneId) {
        let cap_face = (2 * self.figure.edges().len() + terminal) as u32;
        let trace = *self.front.trace(x);
        let fan: Spokes = self.triangulation.fan(trace.out).collect();
        // A spoke ahead of the terminal's wavefront edge: there is one, because no angle
        // between spokes reaches 180 degrees.
        let ahead = |&(t, corner): &(TriangleId, usize)| {
            let far = self.triangulation.get(t).tips[prev(corner)];
            match far.trace() {
                Some(far) => {
                    let far = self.front.trace(far);
                    self.planes.lead(&self.now, far.pair, cap_plane) == Sign::Positive
                }
                None => self
                    .planes
                    .heads(cap_plane, far.direction().expect("a direction"))
                    .is_positive(),
            }
        };
        let cut = fan[..fan.len() - 1]
            .iter()
            .position(ahead)
            .expect("some spoke points ahead");
        let cap = self.triangulation.push_wave(fan[cut].0);
        self.front.waves.push(Wave {
            plane: cap_plane,
            face: cap_face,
        });
        self.register(cap);
        if cap_plane != self.terminal_plane(terminal) {
            self.front.late.insert(cap_face, cap_plane);
        }
        // `x` becomes the first one, where the wavefront arrives; the second one is new.
        let second = self.front.push_trace(Trace {
            pair: [self.front.wave(trace.out).plane, cap_plane],
            inn: cap,
            turn: Sign::Negative,
            ..trace
        });
        let inn = self.front.wave(trace.inn).plane;
        let first = self.front.trace_mut(x);
        first.pair = [cap_plane, inn];
        first.out = cap;
        first.turn = Sign::Negative;
        first.after_down = Walk::Base(cap_face);
        self.front.after_base[cap_face as usize] = Walk::Up(second);
        self.batch.fresh.push(second);
        for &(t, corner) in &fan[..=cut] {
            self.triangulation.triangles[t.index()].tips[corner] = second.into();
        }
        let (before, corner) = fan[cut];
        let (after, other) = fan[cut + 1];
        let far = self.triangulation.get(before).tips[prev(corner)];
        let opened = self.triangulation.push(
            [far, x.into(), second.into()],
            [cap.into(), before.into(), after.into()],
        );
        self.triangulation.attach(opened, 0, cap.into());
        self.triangulation
            .attach(before, next(corner), opened.into());
        self.triangulation.attach(after, prev(other), opened.into());
    }

    /// The planes of vertices beside wavefront edges that were overrun have changed.
    fn refresh_pairs(&mut self) {
        let mut closed: Vec<TraceId> = self.changes.closed.values().copied().collect();
        closed.sort_unstable();
        for (x, trace) in self.front.traces.iter_mut().enumerate() {
            let planes = [trace.inn, trace.out].map(|w| self.front.waves[w.index()].plane);
            // The pair of a terminal that stands still is no such one, nor is one with a post.
            let stands = closed.binary_search(&TraceId::new(x)).is_ok()
                || self.planes.phases.is_post(trace.pair[0]);
            if trace.end == End::Moving && !stands {
                let [i, j] = planes;
                trace.pair = if trace.turn == Sign::Positive {
                    [i, j]
                } else {
                    [j, i]
                };
            }
        }
    }
}
