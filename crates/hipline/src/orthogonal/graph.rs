//! The growing skeletons of both chains: arcs, and the chains of arcs that bound each face.

use super::{
    number::Number,
    ring::{Kind, Ring, Side, Spot},
};

/// No arc, no node.
pub(super) const NONE: u32 = u32::MAX;

/// An arc of a chain's skeleton, directed away from the chain.
#[derive(Debug, Clone, Copy)]
pub(super) struct Link {
    /// The node where it starts: the vertices of the figure, then events.
    pub from: u32,
    /// The node where it ends, or [`NONE`] as long as it is a ray.
    pub to: u32,
    /// The wave whose face is west of it; of a wall of several edges, the first of them.
    pub west: u32,
    /// The wave whose face is east of it.
    pub east: u32,
    /// The next arc of the right chain of the face in the west.
    pub after: u32,
    /// The arc before it in the left chain of the face in the east.
    pub below: u32,
}

/// An arc of the merge chain, from west to east.
#[derive(Debug, Clone, Copy)]
pub(super) struct Seam {
    pub from: u32,
    pub to: u32,
    pub lower: u32,
    pub upper: u32,
}

/// A node that is no vertex: its place, seen from the lower chain, and its time.
#[derive(Debug, Clone, Copy)]
pub(super) struct Event<N> {
    pub place: Spot<N>,
    pub time: N,
}

/// Both skeletons, and what merges them.
#[derive(Debug)]
pub(super) struct Graph<'a, N> {
    pub ring: Ring<'a>,
    pub links: Vec<Link>,
    pub events: Vec<Event<N>>,
    /// For each wave, the first and the last arc of its right chain, and the last one of its left chain.
    pub right_first: Vec<u32>,
    pub right_last: Vec<u32>,
    pub left_last: Vec<u32>,
    /// The merge chain.
    pub seams: Vec<Seam>,
    /// Pairs of an event and the node that it was found to be.
    pub same: Vec<[u32; 2]>,
    /// Elementary steps so far.
    pub steps: u64,
}

impl<'a, N: Number> Graph<'a, N> {
    pub(super) fn new(ring: Ring<'a>) -> Self {
        let n = ring.count() as usize;
        Self {
            links: Vec::with_capacity(2 * n),
            events: Vec::with_capacity(2 * n),
            right_first: vec![NONE; n],
            right_last: vec![NONE; n],
            left_last: vec![NONE; n],
            seams: Vec::with_capacity(n),
            same: Vec::new(),
            steps: 0,
            ring,
        }
    }

    #[inline]
    pub(super) fn kind(&self, wave: u32) -> Kind {
        self.ring.kind(wave)
    }

    #[inline]
    pub(super) fn link(&self, link: u32) -> &Link {
        &self.links[link as usize]
    }

    /// Where a node is, seen from a chain.
    #[inline]
    pub(super) fn spot(&self, node: u32, side: Side) -> Spot<N> {
        let n = self.ring.count();
        let place = if node < n {
            self.ring.place(node)
        } else {
            self.events[(node - n) as usize].place
        };
        seen(place, side)
    }

    /// The place of a wall, or the height of a level edge, seen from its chain.
    #[inline]
    pub(super) fn line(&self, wave: u32) -> N {
        let (x, y) = self.spot(self.ring.west_end(wave), self.ring.side(wave));
        if self.kind(wave) == Kind::Level { y } else { x }
    }

    /// When a wave reaches a place, seen from its chain.
    #[inline]
    pub(super) fn time(&self, wave: u32, (x, y): Spot<N>) -> N {
        match self.kind(wave) {
            Kind::Level => y - self.line(wave),
            Kind::East => x - self.line(wave),
            Kind::West => self.line(wave) - x,
        }
    }

    /// Gives back what was taken in reserve.
    pub(super) fn shrink(&mut self) {
        self.links.shrink_to_fit();
        self.events.shrink_to_fit();
        self.seams.shrink_to_fit();
    }

    /// A new node where a wave is at a place, seen from its chain.
    pub(super) fn event(&mut self, spot: Spot<N>, wave: u32) -> u32 {
        let time = self.time(wave, spot);
        let place = seen(spot, self.ring.side(wave));
        self.events.push(Event { place, time });
        self.ring.count() + self.events.len() as u32 - 1
    }

    /// A new arc, a ray for the time being, at the ends of the right chain of the face in the west and of the left chain
    /// of the one in the east.
    pub(super) fn draw(&mut self, from: u32, west: u32, east: u32) -> u32 {
        let link = self.links.len() as u32;
        let last = std::mem::replace(&mut self.right_last[west as usize], link);
        if last == NONE {
            self.right_first[west as usize] = link;
        } else {
            self.links[last as usize].after = link;
        }
        let below = std::mem::replace(&mut self.left_last[east as usize], link);
        self.links.push(Link {
            from,
            to: NONE,
            west,
            east,
            after: NONE,
            below,
        });
        self.steps += 1;
        link
    }
}

/// A place of the lower chain's view in that of a chain, or the other way round.
pub(super) fn seen<N: Number>((x, y): Spot<N>, side: Side) -> Spot<N> {
    match side {
        Side::Lower => (x, y),
        Side::Upper => (x, -y),
    }
}
