//! Skeletons of chains, as results of their own (section 2).

use std::fmt;

use super::chains::{Chains, NONE, Side as Course, Start, Trouble};
use crate::{
    input::Figure,
    predicates::{PlaneId, Planes, turn},
    skeleton::{Region, Side, Skeleton, Stats, assemble},
    topology::EdgeId,
    wavefront::Walk,
};

/// A monotone chain that goes on to infinity at both ends: a line whose first and last edges are
/// taken as rays.
///
/// The wavefront on one side of it never meets that on the other, nor itself.
#[derive(Debug, Clone, Copy)]
pub struct Chain<'a> {
    figure: &'a Figure,
}

/// Why a figure is no monotone chain, or has no skeleton as one.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum InvalidChain {
    /// The figure is not one line in which each edge goes on from the one before.
    #[error("the figure is not one line")]
    NotOneLine,
    /// No direction is such that no edge goes against it.
    #[error("edge {} turns the chain back: it is monotone in no direction", .edge.index())]
    NotMonotone {
        /// The first edge for which there is none.
        edge: EdgeId,
    },
    /// A speed is zero or changes, or a vertex has a height.
    #[error("edge {} does not move with one positive speed", .edge.index())]
    Speed {
        /// The edge.
        edge: EdgeId,
    },
    /// A ray vanishes in one moment, all of it: a faster edge on its line overruns it, or it meets the
    /// other ray face to face.
    #[error("the ray of edge {} vanishes at once, as far as it goes", .edge.index())]
    RayVanishes {
        /// The edge.
        edge: EdgeId,
    },
    /// Terminals have no side of a chain.
    #[error("a chain has a left and a right side only")]
    NoSide,
}

/// The range of directions of the edges so far: the rightmost and the leftmost one.
struct Fan([[[f64; 2]; 2]; 2]);

impl Fan {
    /// Widens it for one more edge; whether all of them still lie within a half turn.
    fn widen(&mut self, edge: [[f64; 2]; 2]) -> bool {
        let [right, left] = self.0;
        let (from_right, from_left) = (turn(right, edge), turn(left, edge));
        if !from_right.is_negative() && !from_left.is_positive() {
            return true;
        }
        if from_left.is_positive() && !from_right.is_negative() {
            self.0[1] = edge;
            return true;
        }
        if from_right.is_negative() && !from_left.is_positive() {
            self.0[0] = edge;
            return true;
        }
        false
    }
}

impl<'a> Chain<'a> {
    /// The chain of a figure that is one line; its speeds are those of the line.
    ///
    /// # Errors
    /// If it is no such line, is monotone in no direction, or has speeds that are zero or change.
    ///
    /// # Complexity
    /// O(n).
    pub fn new(figure: &'a Figure) -> Result<Self, InvalidChain> {
        let edges = figure.edges();
        let goes_on = edges.windows(2).all(|pair| pair[0].to == pair[1].from);
        let open = figure.vertices().len() == edges.len() + 1;
        if edges.is_empty() || !goes_on || !open || edges.iter().any(|edge| edge.on_ring) {
            return Err(InvalidChain::NotOneLine);
        }
        let still =
            |e: &usize| edges[*e].speeds.contains(&0.0) || figure.has_height(EdgeId::new(*e));
        let changes = figure.changes().first().map(|change| change.edge);
        if let Some(edge) = changes.or((0..edges.len()).find(still).map(EdgeId::new)) {
            return Err(InvalidChain::Speed { edge });
        }
        let ends = |e: usize| [edges[e].from, edges[e].to].map(|v| figure.vertices()[v.index()]);
        let mut fan = Fan([ends(0); 2]);
        if let Some(e) = (1..edges.len()).find(|&e| !fan.widen(ends(e))) {
            return Err(InvalidChain::NotMonotone {
                edge: EdgeId::new(e),
            });
        }
        Ok(Self { figure })
    }

    /// The skeleton on the left or on the right side of the chain.
    ///
    /// It is a [`Skeleton`] of the line with the faces of that side only, and without terminals. The bases of
    /// the first and the last face are rays: where the boundary of such a face goes from the line's last
    /// vertex (or, before its first one, from infinity), it goes along the ray. Its region is
    /// [`Region::Both`], though it covers one side. What reads skeletons of whole regions is not made for it: its
    /// wavefronts are open, which [`Skeleton::offset`] refuses, and [`Skeleton::verify`] misses the other side.
    ///
    /// # Errors
    /// If a ray vanishes at once, all of it; and for sides that a chain does not have.
    ///
    /// # Complexity
    /// O(n log n) time, O(n) memory.
    pub fn skeleton(&self, side: Side) -> Result<Skeleton, InvalidChain> {
        let n = self.figure.edges().len() as u32;
        let start = match side {
            Side::Left => Start {
                side: Course::Lower,
                planes: (0..n).map(|e| PlaneId(2 * e)).collect(),
                vertices: (1..n).collect(),
                ends: [None; 2],
            },
            Side::Right => Start {
                side: Course::Lower,
                planes: (0..n).rev().map(|e| PlaneId(2 * e + 1)).collect(),
                vertices: (1..n).rev().collect(),
                ends: [None; 2],
            },
            Side::Start | Side::End => return Err(InvalidChain::NoSide),
        };
        let planes = Planes::new(self.figure, &[]);
        let vanishes = |Trouble(plane)| InvalidChain::RayVanishes {
            edge: EdgeId::new((plane.0 >> 1) as usize),
        };
        let faces = 2 * n as usize;
        let starts = [start];
        let mut chains =
            Chains::new(&planes, self.figure.vertices(), faces, &starts).map_err(vanishes)?;
        chains.propagate().map_err(vanishes)?;
        chains.run_to_infinity();
        let stats = Stats {
            edge_events: chains.events,
            ..Stats::default()
        };
        Ok(assemble(
            self.figure,
            &planes,
            &[],
            chains.into_front(),
            Region::Both,
            stats,
        ))
    }
}

impl fmt::Display for Chain<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "a chain of {} edges", self.figure.edges().len())
    }
}

impl Chains<'_> {
    /// Lets what is left move on for ever.
    fn run_to_infinity(&mut self) {
        for w in 0..self.waves.len() {
            let wave = self.waves[w];
            if wave.death != NONE || wave.joined != NONE {
                continue;
            }
            let id = crate::topology::TraceId::raw;
            let last = match wave.end {
                NONE => wave.tail,
                end => Walk::Up(id(end)),
            };
            let first = match wave.start {
                NONE => wave.head,
                start => Walk::Down(id(start)),
            };
            match last {
                Walk::Up(x) => self.front.trace_mut(x).after_up = first,
                Walk::Down(x) => self.front.trace_mut(x).after_down = first,
                Walk::Base(face) => self.front.after_base[face as usize] = first,
                Walk::Open => unreachable!("every boundary has a last walk"),
            }
        }
    }
}
