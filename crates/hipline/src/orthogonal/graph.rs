//! The growing skeletons of both chains: arcs, and the chains of arcs that bound each face.

use std::ops::Range;

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

/// The ends of the chains of arcs that bound a face.
#[derive(Debug, Clone, Copy)]
pub(super) struct Border {
    /// The first and the last arc of the right chain.
    pub right_first: u32,
    pub right_last: u32,
    /// The last arc of the left chain.
    pub left_last: u32,
}

impl Border {
    const NONE: Self = Self {
        right_first: NONE,
        right_last: NONE,
        left_last: NONE,
    };
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
    /// For each wave, what bounds its face.
    pub borders: Vec<Border>,
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
            borders: vec![Border::NONE; n],
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

    /// The arcs of the merge chain beside a face. They follow one another, and those of the next face
    /// of its chain follow them; so the search goes on from where the last one ended.
    pub(super) fn visits(&self, last: &mut Visits, wave: u32) -> Range<u32> {
        let n = self.seams.len();
        let upper = self.ring.side(wave) == Side::Upper;
        let position = &mut last.0[usize::from(upper)];
        // From west to east it grows.
        let rank = |k: usize| {
            let seam = &self.seams[k];
            if upper { !seam.upper } else { seam.lower }
        };
        let own = if upper { !wave } else { wave };
        let mut first = *position;
        while first < n && rank(first) < own {
            first += 1;
        }
        while first > 0 && rank(first - 1) >= own {
            first -= 1;
        }
        let mut end = first;
        while end < n && rank(end) == own {
            end += 1;
        }
        *position = first;
        first as u32..end as u32
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
        let last = std::mem::replace(&mut self.borders[west as usize].right_last, link);
        if last == NONE {
            self.borders[west as usize].right_first = link;
        } else {
            self.links[last as usize].after = link;
        }
        let below = std::mem::replace(&mut self.borders[east as usize].left_last, link);
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

/// Where arcs of the merge chain were looked for last, beside a face of either chain.
#[derive(Debug, Default)]
pub(super) struct Visits([usize; 2]);

/// A place of the lower chain's view in that of a chain, or the other way round.
pub(super) fn seen<N: Number>((x, y): Spot<N>, side: Side) -> Spot<N> {
    match side {
        Side::Lower => (x, y),
        Side::Upper => (x, -y),
    }
}
