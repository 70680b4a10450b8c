//! The merge chain (section 3 of the paper): where the wavefronts of both chains meet, from west to east.
//!
//! It is at the border of one face of each chain at any time, and goes along their bisector until
//! it reaches the right chain of one of them. As faces come in the order of their edges, it never leaves a face
//! to the left.

use std::cmp::Ordering;

use super::{
    graph::{Graph, NONE, Seam, seen},
    number::Number,
    ring::{Kind, Side, Spot},
};

/// Where the merge chain leaves a face: across which arc, and at which place, seen from the lower chain.
#[derive(Debug, Clone, Copy)]
struct Exit<N> {
    link: u32,
    place: Spot<N>,
}

/// The tip of the merge chain.
struct Merge<'g, 'a, N> {
    graph: &'g mut Graph<'a, N>,
    /// The faces below and above.
    lower: u32,
    upper: u32,
    /// The last node, and where it is, seen from the lower chain.
    node: u32,
    place: Spot<N>,
    /// For a face of a wall that moves east: the first arc of its right chain that ends no further west than
    /// the tip.
    at: [u32; 2],
}

/// Draws the merge chain, and cuts off what is beyond it from both skeletons.
pub(super) fn merge<N: Number>(graph: &mut Graph<'_, N>) {
    let node = graph.ring.vertex(0);
    let lower = 0;
    let upper = graph.ring.count() - 1;
    let at = [lower, upper].map(|wave| graph.borders[wave as usize].right_first);
    let place = graph.spot(node, Side::Lower);
    Merge {
        graph,
        lower,
        upper,
        node,
        place,
        at,
    }
    .run();
}

impl<N: Number> Merge<'_, '_, N> {
    fn run(&mut self) {
        loop {
            self.graph.steps += 1;
            let exits = self.exits();
            let [lower, upper] = match exits {
                [None, None] => break,
                [lower, None] => [lower, None],
                [None, upper] => [None, upper],
                [Some(lower), Some(upper)] => match self.compare(lower.place, upper.place) {
                    Ordering::Less => [Some(lower), None],
                    Ordering::Greater => [None, Some(upper)],
                    Ordering::Equal => self.both(lower, upper),
                },
            };
            if let Some(exit) = lower.or(upper) {
                self.advance(exit.place);
            }
            if let Some(exit) = lower {
                self.lower = self.cross(exit);
                self.at[0] = self.graph.borders[self.lower as usize].right_first;
            }
            if let Some(exit) = upper {
                self.upper = self.cross(exit);
                self.at[1] = self.graph.borders[self.upper as usize].right_first;
            }
        }
        let last = self.graph.ring.vertex(self.graph.ring.lower);
        self.draw_to(last);
    }

    fn kinds(&self) -> [Kind; 2] {
        [self.graph.kind(self.lower), self.graph.kind(self.upper)]
    }

    /// Where the tip goes: by how much in x and y.
    fn course(&self) -> (i8, i8) {
        match self.kinds() {
            [Kind::Level, Kind::Level] => (1, 0),
            [Kind::Level, Kind::East] | [Kind::West, Kind::Level] => (1, 1),
            [Kind::Level, Kind::West] | [Kind::East, Kind::Level] => (1, -1),
            [Kind::East, Kind::West] => (0, -1),
            [Kind::West, Kind::East] => (0, 1),
            // A ghost arc: both walls are on one line.
            [Kind::East, Kind::East] | [Kind::West, Kind::West] => (1, 0),
        }
    }

    /// The order of two places along the course.
    fn compare(&self, p: Spot<N>, q: Spot<N>) -> Ordering {
        match self.course() {
            (0, dy) if dy < 0 => q.1.cmp(&p.1),
            (0, _) => p.1.cmp(&q.1),
            _ => p.0.cmp(&q.0),
        }
    }

    /// Both faces end at one place: which of them to leave first. Entering the face of a wall that moves west
    /// waits until the other side has settled; and if that enters one, too, they are on one plane, and only at the height
    /// of their ghost arc does the merge chain go between them.
    fn both(&self, lower: Exit<N>, upper: Exit<N>) -> [Option<Exit<N>>; 2] {
        let [below, above] = [lower, upper].map(|exit| self.graph.link(exit.link).east);
        let is_west = |wave| self.graph.kind(wave) == Kind::West;
        match [is_west(below), is_west(above)] {
            [false, false] => [Some(lower), Some(upper)],
            [true, false] => [None, Some(upper)],
            [false, true] => [Some(lower), None],
            [true, true] => match lower.place.1.cmp(&self.mouth(below, above)) {
                Ordering::Greater => [None, Some(upper)],
                Ordering::Less => [Some(lower), None],
                Ordering::Equal => [Some(lower), Some(upper)],
            },
        }
    }

    /// The height of the ghost arc between the faces of two walls on one line that move west, one of each
    /// chain: half way between the edges after them.
    fn mouth(&self, lower: u32, upper: u32) -> N {
        let [low, high] = [lower, upper].map(|wave| {
            let top = self.graph.borders[wave as usize].right_first;
            self.graph.spot(self.graph.link(top).from, Side::Lower).1
        });
        (low + high).half()
    }

    /// Goes on to a place, where a node is made if there is some way to go.
    fn advance(&mut self, place: Spot<N>) {
        if place != self.place {
            let node = self.graph.event(place, self.lower);
            self.draw_to(node);
            self.place = place;
        }
    }

    fn draw_to(&mut self, node: u32) {
        self.graph.seams.push(Seam {
            from: self.node,
            to: node,
            lower: self.lower,
            upper: self.upper,
        });
        self.node = node;
    }

    /// Ends an arc at the tip, forgets what comes after it, and returns the face beyond.
    fn cross(&mut self, exit: Exit<N>) -> u32 {
        let n = self.graph.ring.count();
        let link = *self.graph.link(exit.link);
        for end in [link.from, link.to] {
            if end != NONE
                && end >= n
                && end != self.node
                && self.graph.spot(end, Side::Lower) == self.place
            {
                self.graph.same.push([end, self.node]);
            }
        }
        self.graph.links[exit.link as usize].to = self.node;
        self.graph.borders[link.west as usize].right_last = exit.link;
        self.graph.borders[link.east as usize].left_last = exit.link;
        link.east
    }

    /// Where the tip would leave either face, if nothing happened to the other.
    fn exits(&mut self) -> [Option<Exit<N>>; 2] {
        match self.kinds() {
            [Kind::East, Kind::East] => self.leave_both_walls(),
            [Kind::East, _] => {
                let upper = self.leave(Side::Upper);
                [self.leave_wall(Side::Lower, upper), upper]
            }
            [_, Kind::East] => {
                let lower = self.leave(Side::Lower);
                [lower, self.leave_wall(Side::Upper, lower)]
            }
            _ => [self.leave(Side::Lower), self.leave(Side::Upper)],
        }
    }

    /// The tip and its course, seen from a chain.
    fn seen_from(&self, side: Side) -> (Spot<N>, (i8, i8)) {
        let (dx, dy) = self.course();
        match side {
            Side::Lower => (self.place, (dx, dy)),
            Side::Upper => (seen(self.place, side), (dx, -dy)),
        }
    }

    const fn faces(&self, side: Side) -> [u32; 2] {
        match side {
            Side::Lower => [self.lower, self.upper],
            Side::Upper => [self.upper, self.lower],
        }
    }

    /// Leaves the face of a level edge or of a wall that moves west, whose right chains have three arcs at most. Of
    /// two arcs that are reached at one place, it is left across the first.
    fn leave(&mut self, side: Side) -> Option<Exit<N>> {
        let [face, _] = self.faces(side);
        let mut link = self.graph.borders[face as usize].right_first;
        let mut exit: Option<Exit<N>> = None;
        while link != NONE {
            self.graph.steps += 1;
            if let Some(spot) = self.crossing(side, link) {
                let place = seen(spot, side);
                if exit.is_none_or(|exit| place.0 < exit.place.0) {
                    exit = Some(Exit { link, place });
                }
            }
            link = self.graph.link(link).after;
        }
        exit
    }

    /// Where the course crosses an arc of the right chain of a face, seen from its chain.
    fn crossing(&self, side: Side, link: u32) -> Option<Spot<N>> {
        let ((x, y), course) = self.seen_from(side);
        let [face, other] = self.faces(side);
        let arc = self.graph.link(link);
        let (a, b) = self.graph.spot(arc.from, side);
        let end = (arc.to != NONE).then(|| self.graph.spot(arc.to, side).1);
        let below_end = |height: N| end.is_none_or(|end| height <= end);
        let is_wall = self.graph.kind(face) == Kind::West;
        let spot = match (self.graph.kind(arc.east), course) {
            // To the upper right.
            (Kind::East, (1, 0)) => (a + (y - b), y),
            (Kind::East, (1, -1)) => {
                let [falling, rising] = [x + y, b - a];
                ((falling - rising).half(), (falling + rising).half())
            }
            // Parallel; on it at one end only, where the arc of the other chain is crossed as well.
            (Kind::East, _) => return None,
            // Straight up: a ghost arc. (Above a wall, see below.)
            (Kind::Level, (1, dy)) if !is_wall => {
                let height = match dy {
                    0 => y,
                    1 => y + (a - x),
                    _ => y - (a - x),
                };
                let beyond = a >= x && height >= b && below_end(height);
                return beyond.then_some((a, height));
            }
            // To the upper left.
            (_, (1, 0)) => (a + b - y, y),
            (_, (1, 1)) => {
                let [falling, rising] = [a + b, y - x];
                ((falling - rising).half(), (falling + rising).half())
            }
            (_, (0, 1)) => (x, a + b - x),
            // Parallel, or along it if the walls beyond it are on one line: up to the height of their ghost arc.
            (Kind::West, (1, -1)) if x + y == a + b => {
                let height = match side {
                    Side::Lower => self.mouth(arc.east, other),
                    Side::Upper => -self.mouth(other, arc.east),
                };
                let ahead = height >= b && height <= y;
                return ahead.then_some((a + b - height, height));
            }
            _ => return None,
        };
        let inside = is_wall || spot.1 >= b && below_end(spot.1);
        inside.then_some(spot)
    }

    /// Leaves the face of a wall that moves east, whose right chain goes up and right in many steps. The course goes
    /// down; `other` is where it ends if it does not reach them.
    fn leave_wall(&mut self, side: Side, other: Option<Exit<N>>) -> Option<Exit<N>> {
        let ((x, y), (dx, _)) = self.seen_from(side);
        let index = usize::from(side == Side::Upper);
        let limit = other.map(|exit| exit.place.0);
        let end = |merge: &Self, link: u32| {
            let to = merge.graph.link(link).to;
            (to != NONE).then(|| merge.graph.spot(to, side))
        };
        if dx == 0 {
            while end(self, self.at[index]).is_some_and(|(a, _)| a < x) {
                self.step(index);
            }
            return Some(self.land_on_steps(side, (x, y)));
        }
        let falling = x + y;
        let mut link = self.at[index];
        while let Some((a, b)) = end(self, link).filter(|(a, b)| *a + *b < falling) {
            match limit.map(|limit| a.cmp(&limit)) {
                Some(Ordering::Greater) => return None,
                // What comes next may be straight up.
                Some(Ordering::Equal) => {
                    link = self.graph.link(link).after;
                    let high = end(self, link).is_none_or(|(_, b)| a + b >= falling);
                    let upright = self.graph.kind(self.graph.link(link).east) == Kind::West;
                    if !(upright && high && falling - a >= b) {
                        return None;
                    }
                    break;
                }
                _ => {
                    self.step(index);
                    link = self.at[index];
                }
            }
        }
        let arc = self.graph.link(link);
        let (a, b) = self.graph.spot(arc.from, side);
        let spot = if self.graph.kind(arc.east) == Kind::West {
            (a, falling - a)
        } else {
            let rising = b - a;
            ((falling - rising).half(), (falling + rising).half())
        };
        Some(Exit {
            link,
            place: seen(spot, side),
        })
    }

    fn step(&mut self, index: usize) {
        self.at[index] = self.graph.link(self.at[index]).after;
        self.graph.steps += 1;
    }

    /// Straight down onto the right chain of a wall that moves east, between it and a wall of the other
    /// chain that moves west.
    fn land_on_steps(&self, side: Side, (x, y): Spot<N>) -> Exit<N> {
        let index = usize::from(side == Side::Upper);
        let link = self.at[index];
        let arc = self.graph.link(link);
        let (a, b) = self.graph.spot(arc.from, side);
        let height = b + (x - a);
        let exit = |link, height| Exit {
            link,
            place: seen((x, height), side),
        };
        let ends_here = arc.to != NONE && self.graph.spot(arc.to, side).0 == x;
        if !ends_here || y == height {
            return exit(link, height);
        }
        // If the next arc goes straight up, it is between this wall and another one: on the line of the
        // other chain's, since they are equally far away.
        let [_, other] = self.faces(side);
        let upright = arc.after;
        let wall = self.graph.link(upright).east;
        if self.graph.kind(wall) != Kind::West {
            return exit(link, height);
        }
        let mouth = match side {
            Side::Lower => self.mouth(wall, other),
            Side::Upper => -self.mouth(other, wall),
        };
        if mouth > height {
            exit(upright, mouth)
        } else {
            exit(link, height)
        }
    }

    /// A ghost arc between the faces of two walls on one line that move east: it ends where either right chain reaches
    /// its height. The chain whose next node is further west is followed first.
    fn leave_both_walls(&mut self) -> [Option<Exit<N>>; 2] {
        let sides = [Side::Lower, Side::Upper];
        let mut links = self.at;
        loop {
            let arrived = [0, 1].map(|k| {
                let (height, side) = (seen(self.place, sides[k]).1, sides[k]);
                let arc = self.graph.link(links[k]);
                let end = (arc.to != NONE).then(|| self.graph.spot(arc.to, side));
                if let Some(end) = end.filter(|end| end.1 < height) {
                    return Err(end.0);
                }
                let (a, b) = self.graph.spot(arc.from, side);
                let upright = self.graph.kind(arc.east) == Kind::West;
                Ok(if upright { a } else { a + (height - b) })
            });
            let behind = match arrived {
                [Ok(p), Ok(q)] => {
                    return self.after_ghost([Some((links[0], p)), Some((links[1], q))]);
                }
                [Err(p), Err(q)] => usize::from(p > q),
                [Err(p), Ok(q)] if p <= q => 0,
                [Ok(p), Err(q)] if q <= p => 1,
                [Err(_), Ok(q)] => return self.after_ghost([None, Some((links[1], q))]),
                [Ok(p), Err(_)] => return self.after_ghost([Some((links[0], p)), None]),
            };
            self.graph.steps += 1;
            links[behind] = self.graph.link(links[behind]).after;
        }
    }

    /// The ends of a ghost arc between two walls: forgets the arcs that end further west than it does.
    fn after_ghost(&mut self, ends: [Option<(u32, N)>; 2]) -> [Option<Exit<N>>; 2] {
        let x = ends.iter().flatten().map(|end| end.1).min();
        for (index, side) in [Side::Lower, Side::Upper].into_iter().enumerate() {
            loop {
                let to = self.graph.link(self.at[index]).to;
                if to == NONE || Some(self.graph.spot(to, side).0) >= x {
                    break;
                }
                self.step(index);
            }
        }
        let height = self.place.1;
        ends.map(|end| {
            end.map(|(link, x)| Exit {
                link,
                place: (x, height),
            })
        })
    }
}
