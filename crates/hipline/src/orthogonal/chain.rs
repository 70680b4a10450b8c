//! The skeleton of one chain (section 2 of the paper), by inserting its edges from west to east.
//!
//! Seen from its chain, every arc goes up: to the upper right, straight up, or to the upper left. [`Growth::unbounded`] is
//! the stack R of the paper, of the faces that reach to infinity, and [`Growth::ghosts`] is
//! the stack G of unfinished ghost arcs.

use super::{
    graph::{Graph, NONE},
    number::Number,
    ring::{Kind, Side, Spot},
};

/// A ghost arc that is not finished.
#[derive(Debug, Clone, Copy)]
struct Ghost {
    link: u32,
    /// How many faces were unbounded when it was begun, so that the last of them is the one it cuts.
    depth: usize,
}

/// What closed the face of a wall that moves west, when an edge of it had not yet been inserted.
#[derive(Debug, Clone, Copy)]
struct Closed {
    /// Where its face ends at the top.
    node: u32,
    /// The face that is on the left there.
    west: u32,
    /// Whether that is a level edge of the same height as the one to come.
    joint: bool,
}

struct Growth<'g, 'a, N> {
    graph: &'g mut Graph<'a, N>,
    side: Side,
    unbounded: Vec<u32>,
    ghosts: Vec<Ghost>,
}

/// Adds the skeleton of one chain to the graph; what goes to infinity stays without an end.
pub(super) fn grow<N: Number>(graph: &mut Graph<'_, N>, side: Side) {
    let mut waves = graph.ring.chain(side).peekable();
    let mut growth = Growth {
        graph,
        side,
        unbounded: Vec::new(),
        ghosts: Vec::new(),
    };
    let mut before: Option<u32> = None;
    let mut closed: Option<Closed> = None;
    while let Some(wave) = waves.next() {
        let kind = growth.graph.kind(wave);
        if kind != Kind::Level {
            // A wall of several edges is one wave; horizontal ghost arcs cut its face in the end.
            while waves
                .next_if(|&next| growth.graph.kind(next) == kind)
                .is_some()
            {}
        }
        let corner = growth.graph.ring.west_end(wave);
        if let Some(west) = before {
            match (growth.graph.kind(west), kind) {
                (Kind::Level, Kind::Level) => growth.begin_ghost(corner, west, wave),
                (Kind::Level, Kind::East) | (Kind::East, Kind::Level) => {
                    growth.graph.draw(corner, west, wave);
                    growth.unbounded.push(wave);
                }
                (Kind::Level, Kind::West) => {
                    let top = waves.peek().map(|&next| growth.graph.ring.west_end(next));
                    closed = growth.insert_west(corner, west, wave, top);
                }
                (Kind::West, Kind::Level) => {
                    growth.insert_level(corner, west, wave, closed.take());
                }
                (one, other) => unreachable!("{one:?} before {other:?} at {corner}"),
            }
        } else {
            growth.unbounded.push(wave);
        }
        before = Some(wave);
    }
    growth.finish();
}

impl<N: Number> Growth<'_, '_, N> {
    fn spot(&self, node: u32) -> Spot<N> {
        self.graph.spot(node, self.side)
    }

    fn begin_ghost(&mut self, node: u32, west: u32, east: u32) {
        let link = self.graph.draw(node, west, east);
        self.ghosts.push(Ghost {
            link,
            depth: self.unbounded.len(),
        });
    }

    /// A level edge after a wall that moves west.
    fn insert_level(&mut self, corner: u32, west: u32, wave: u32, closed: Option<Closed>) {
        let arc = self.graph.draw(corner, west, wave);
        let Some(closed) = closed else {
            self.unbounded.push(wave);
            return;
        };
        self.graph.links[arc as usize].to = closed.node;
        if closed.joint {
            self.begin_ghost(closed.node, closed.west, wave);
        } else {
            self.graph.draw(closed.node, closed.west, wave);
            self.unbounded.push(wave);
        }
    }

    /// A wall that moves west, after a level edge; `top` is where it ends. Its arcs go to the upper left and close
    /// faces, until one escapes or the face of the wall is closed itself.
    fn insert_west(
        &mut self,
        corner: u32,
        mut west: u32,
        wave: u32,
        top: Option<u32>,
    ) -> Option<Closed> {
        let mut from = corner;
        let top = top.map(|vertex| self.spot(vertex));
        loop {
            let ray = self.rising_ray();
            if ray == NONE {
                self.escape(from, west, wave);
                return None;
            }
            let (node, wall) = self.close_level(from, west, wave, ray);
            // Two walls face to face, up to where the first of them ends.
            let (x, _) = self.spot(node);
            let left = self.graph.borders[wall as usize].left_last;
            let left_end = (left != NONE).then(|| {
                let (a, b) = self.spot(self.graph.link(left).from);
                b + (x - a)
            });
            let right_end = top.map(|(a, b)| b + (a - x));
            let arc = self.graph.draw(node, wall, wave);
            let (end, order) = match (left_end, right_end) {
                (None, None) => {
                    self.unbounded.push(wave);
                    return None;
                }
                (Some(l), Some(r)) => (l.min(r), l.cmp(&r)),
                (Some(l), None) => (l, std::cmp::Ordering::Less),
                (None, Some(r)) => (r, std::cmp::Ordering::Greater),
            };
            let node = self.graph.event((x, end), wave);
            self.graph.links[arc as usize].to = node;
            if order.is_gt() {
                return Some(Closed {
                    node,
                    west: wall,
                    joint: false,
                });
            }
            self.graph.links[left as usize].to = node;
            self.unbounded.pop();
            west = self.graph.link(left).west;
            if order.is_eq() {
                return Some(Closed {
                    node,
                    west,
                    joint: true,
                });
            }
            from = node;
        }
    }

    /// The left ray of the last unbounded face, if it goes to the upper right.
    fn rising_ray(&self) -> u32 {
        let last = self.unbounded[self.unbounded.len() - 1];
        let ray = self.graph.borders[last as usize].left_last;
        let rises = ray != NONE && {
            let link = self.graph.link(ray);
            [link.west, link.east]
                .iter()
                .any(|&wave| self.graph.kind(wave) == Kind::East)
        };
        if rises { ray } else { NONE }
    }

    /// A node where a ghost arc of the last unbounded face ends.
    fn land(&mut self, ghost: Ghost, height: impl Fn(N) -> N, face: u32) -> u32 {
        let (x, _) = self.spot(self.graph.link(ghost.link).from);
        let node = self.graph.event((x, height(x)), face);
        self.graph.links[ghost.link as usize].to = node;
        node
    }

    /// An arc to the upper left that nothing stops: it ends all ghost arcs of the last unbounded face, above which it passes.
    fn escape(&mut self, mut from: u32, mut west: u32, wave: u32) {
        let depth = self.unbounded.len();
        let (x, y) = self.spot(from);
        while let Some(ghost) = self.ghosts.pop_if(|ghost| ghost.depth == depth) {
            let node = self.land(ghost, |at| x + y - at, west);
            let arc = self.graph.draw(from, west, wave);
            self.graph.links[arc as usize].to = node;
            west = self.graph.link(ghost.link).west;
            from = node;
        }
        self.graph.draw(from, west, wave);
        self.unbounded.push(wave);
    }

    /// An arc to the upper left meets the left ray of the last unbounded face, a level one, and closes it there, with
    /// all its ghost arcs. Returns the node and the face beyond the ray, that of a wall.
    fn close_level(&mut self, mut from: u32, mut west: u32, wave: u32, mut ray: u32) -> (u32, u32) {
        let depth = self.unbounded.len();
        let wall = self.graph.link(ray).west;
        let (x, y) = self.spot(from);
        let (a, b) = self.spot(self.graph.link(ray).from);
        let [falling, rising] = [x + y, b - a];
        let apex = ((falling - rising).half(), (falling + rising).half());
        let start =
            |growth: &Self, ghost: &Ghost| growth.spot(growth.graph.link(ghost.link).from).0;
        while let Some(&ghost) = self.ghosts.last()
            && ghost.depth == depth
            && start(self, &ghost) > apex.0
        {
            self.ghosts.pop();
            let node = self.land(ghost, |at| falling - at, west);
            let arc = self.graph.draw(from, west, wave);
            self.graph.links[arc as usize].to = node;
            west = self.graph.link(ghost.link).west;
            from = node;
        }
        let node = self.graph.event(apex, west);
        let arc = self.graph.draw(from, west, wave);
        self.graph.links[arc as usize].to = node;
        let mut end = self.ghosts.len();
        if let Some(ghost) = self.ghosts.last()
            && ghost.depth == depth
            && start(self, ghost) == apex.0
        {
            self.graph.links[ghost.link as usize].to = node;
            end -= 1;
        }
        let first = self.ghosts[..end]
            .iter()
            .rposition(|ghost| ghost.depth != depth)
            .map_or(0, |k| k + 1);
        for k in first..end {
            ray = self.land_on_ray(self.ghosts[k], ray, rising);
        }
        self.ghosts.truncate(first);
        self.graph.links[ray as usize].to = node;
        self.unbounded.pop();
        (node, wall)
    }

    /// A ghost arc ends on the left ray of its face, which goes on as another arc.
    fn land_on_ray(&mut self, ghost: Ghost, ray: u32, rising: N) -> u32 {
        let east = self.graph.link(ghost.link).east;
        let node = self.land(ghost, |at| rising + at, east);
        self.graph.links[ray as usize].to = node;
        let west = self.graph.link(ray).west;
        self.graph.draw(node, west, east)
    }

    /// Ends the ghost arcs that are left where there is a ray to the upper right above them.
    fn finish(&mut self) {
        let mut at = (0, NONE);
        for ghost in std::mem::take(&mut self.ghosts) {
            if at.0 != ghost.depth {
                let face = self.unbounded[ghost.depth - 1];
                let ray = self.graph.borders[face as usize].left_last;
                let rises = ray != NONE && self.graph.kind(self.graph.link(ray).west) == Kind::East;
                at = (ghost.depth, if rises { ray } else { NONE });
            }
            if at.1 != NONE {
                let (a, b) = self.spot(self.graph.link(at.1).from);
                at.1 = self.land_on_ray(ghost, at.1, b - a);
            }
        }
    }
}
