//! Checks a finished skeleton against the laws that every skeleton obeys.
//!
//! Independent of the engines: it reads the public result and the figure, and asks the exact
//! predicates. No decision here has a tolerance.
//!
//! 1. [`structure`]: ids, lists, incidences. An arc has one face on either side, and each of
//!    these has the arc in its boundary, exactly once, in the proper direction.
//! 2. [`places`]: every node lies exactly on the planes of all faces around it, and its
//!    coordinates and time are the correctly rounded ones, bit for bit.
//! 3. [`arcs`]: order of the ends, kinds, ghost arcs, directions; where valleys start; no
//!    local minimum.
//! 4. [`faces`]: each face is a simple polygon, counterclockwise, monotone to its edge.
//! 5. [`rotation`]: around each node, and at infinity, the arcs follow one another once
//!    around in the order of their exact directions; Euler's formula; the counts of Lemma 2
//!    of the 1996 paper.
//!
//! Why the faces then tile the region: the winding numbers of all boundaries around a point
//! add up to that of the region's boundary, because every arc is walked once in each
//! direction and only the bases remain; by 4, each winding number is zero outside of its
//! face and one inside; so every point of the region lies in exactly one face and no other
//! point in any. (At infinity, 5 shows that the jumps go once around.) The law that the areas
//! of the faces add up to the area of the region is no check of its own: the sum telescopes
//! to the area of the input by 1 alone, whatever the nodes' coordinates are.
//!
//! With weights, faces are neither monotone nor simply connected in general, and a new valley
//! can start at an event: there, 4 gives way to the sign of each face's area (as far as
//! double-double numbers tell it), and the laws on counts and valleys are skipped. Check 5
//! holds with any weights.

mod arcs;
mod certify;
mod faces;
mod places;
mod rotation;
mod structure;
#[cfg(test)]
mod tests;
mod violation;

pub use certify::Uncertified;
pub use violation::{Violation, Violations};

use super::{Face, Node, NodeKind, Side, Skeleton};
use crate::{
    input::Figure,
    predicates::{Heading, Place, PlaneId, Planes, Terminal},
    topology::{FaceId, VertexId},
};
use structure::Incidence;
use violation::Report;

/// Directed arcs and edges: `2 a` is arc a from its first node to its second, `2 a + 1` the
/// reverse; after the arcs come the edges. The face is on the left.
mod dart {
    /// No dart: a step of a boundary from infinity to infinity.
    pub(super) const JUMP: u32 = u32::MAX;
    /// No dart: none is known.
    pub(super) const NONE: u32 = u32::MAX;

    /// The other direction.
    pub(super) const fn twin(dart: u32) -> u32 {
        dart ^ 1
    }
}

/// What is known in the course of the checks.
struct Checker<'a> {
    skeleton: &'a Skeleton,
    figure: &'a Figure,
    planes: Planes,
    /// The terminals, then the caps of a modified skeleton.
    terminals: Vec<Terminal>,
    /// The plane of each face.
    plane_of: Vec<PlaneId>,
    unweighted: bool,
    incidence: Incidence,
    /// Where each node is; `None` for those at infinity and those undetermined.
    places: Vec<Option<Place>>,
    /// Directions of the arcs, first node to second; then those of the edges.
    headings: Vec<Heading>,
    report: Report,
}

impl Skeleton {
    /// Checks the laws that the straight skeleton of a figure obeys, without the engine that
    /// made it. Exact, without tolerances:
    ///
    /// * there is one face for each side of an edge (and each terminal, and each cap of a modified skeleton) in
    ///   the region, and
    ///   its boundary consists of arcs that know it on the proper side;
    /// * every node lies on the planes of all faces around it; its coordinates and time,
    ///   and the directions of unbounded arcs, are the correctly rounded ones, bit for bit;
    /// * arcs go up, have a length, and are ridges, valleys or ghosts as their planes say;
    /// * faces are simple, counterclockwise, monotone to their edges, and tile the region;
    /// * the roof has no local minimum, and valleys start at vertices or where others end;
    /// * Euler's formula and the counts of Lemma 2 of Aichholzer and Aurenhammer hold.
    ///
    /// Where an edge stands still for some time, the order of the arcs around the nodes is
    /// not checked, because faces stand upright there.
    ///
    /// With weights, the shapes of faces, the starts of valleys and the counts are checked
    /// in part or not at all, because the laws do not hold then. The laws do not single out one
    /// roof among all where several wavefronts could continue from one node.
    ///
    /// # Errors
    /// All violations found. Errors in the structure are reported alone, because nothing
    /// else can be asked then.
    ///
    /// # Complexity
    /// O(n log n) for n nodes.
    ///
    /// ```
    /// # use hipline::{FigureBuilder, Options};
    /// let mut builder = FigureBuilder::new();
    /// builder.polygon(vec![vec![[0.0, 0.0], [4.0, 0.0], [5.0, 3.0], [0.0, 2.0]]]);
    /// let figure = builder.build()?;
    /// let skeleton = figure.skeleton(Options::default());
    /// assert_eq!(skeleton.verify(&figure), Ok(()));
    /// # Ok::<(), hipline::InvalidFigure>(())
    /// ```
    pub fn verify(&self, figure: &Figure) -> Result<(), Violations> {
        self.examine(figure).report.into_result()
    }

    /// Asks all questions, and keeps what was found on the way.
    fn examine<'a>(&'a self, figure: &'a Figure) -> Checker<'a> {
        // Which of the two it is shows in the faces; what follows from that is checked.
        let caps = self.shows_caps_of(figure);
        let terminals = Terminal::with_caps(figure, caps);
        let planes = Planes::new(figure, &terminals);
        let mut checker = Checker {
            skeleton: self,
            figure,
            unweighted: planes.is_unweighted(),
            planes,
            terminals,
            plane_of: Vec::new(),
            incidence: Incidence::default(),
            places: Vec::new(),
            headings: Vec::new(),
            report: Report::default(),
        };
        checker.check_structure();
        if checker.report.is_empty() {
            checker.plane_of = self
                .faces
                .iter()
                .map(|face| checker.plane(face).expect("the phase was checked"))
                .collect();
            checker.check_places();
        }
        // From here on every node must have a place, but for those at infinity.
        let known = checker.places.iter().zip(&self.nodes);
        if !checker.places.is_empty()
            && known
                .into_iter()
                .all(|(p, n)| p.is_some() != n.is_at_infinity())
        {
            checker.check_arcs();
            checker.check_face_shapes();
            // Upright faces lie on top of one another in plan.
            if !checker.planes.has_upright() {
                checker.check_rotation();
            }
        }
        checker
    }
}

impl Skeleton {
    /// Whether it is a modified skeleton of this figure, or claims to be.
    fn shows_caps_of(&self, figure: &Figure) -> bool {
        let known = |face: &Face| face.edge.index() < self.input.edges.len();
        let ends = self.input.edges.iter().flatten();
        self.input.edges.len() == figure.edges().len()
            && self.faces.iter().all(known)
            && ends.into_iter().all(|v| v.index() < self.input.vertices)
            && self.is_modified()
    }
}

impl Node {
    const fn is_at_infinity(&self) -> bool {
        matches!(self.kind, NodeKind::Infinite { .. })
    }
}

impl Checker<'_> {
    /// The number of the terminal at a vertex, if it is one.
    fn terminal_at(&self, vertex: VertexId) -> Option<usize> {
        self.terminals[..self.figure.terminals()]
            .binary_search_by_key(&vertex.index(), |terminal| terminal.tip)
            .ok()
    }

    /// The plane of a face that belongs to the figure, if its edge has as many phases.
    fn plane(&self, face: &Face) -> Option<PlaneId> {
        let first = self.first_plane(face);
        self.planes.phases.plane(first, face.phase)
    }

    /// The plane of the first phase of a face's edge.
    fn first_plane(&self, face: &Face) -> PlaneId {
        let edge = &self.figure.edges()[face.edge.index()];
        let cap = |vertex: VertexId| {
            let plain = self.figure.terminals();
            let at = Terminal::find(&self.terminals, plain, vertex.index(), face.edge.index());
            self.terminal_plane(at.expect("the face of a terminal or a cap"))
        };
        match face.side {
            Side::Left => PlaneId(2 * face.edge.index() as u32),
            Side::Right => PlaneId(2 * face.edge.index() as u32 + 1),
            Side::Start => cap(edge.from),
            Side::End => cap(edge.to),
        }
    }

    /// The edges of each pair of caps of a modified skeleton, each with whether the cap is at its end: first the one
    /// that the wide sector is on the left of, seen from the vertex.
    fn caps(&self) -> impl Iterator<Item = [(usize, bool); 2]> + '_ {
        let (caps, _) = self.terminals[self.figure.terminals()..].as_chunks::<2>();
        caps.iter().map(|pair| {
            pair.each_ref().map(|cap| {
                let edge = &self.figure.edges()[cap.edge];
                (cap.edge, edge.to.index() == cap.tip)
            })
        })
    }

    /// The plane of the first phase of a terminal.
    fn terminal_plane(&self, terminal: usize) -> PlaneId {
        PlaneId(2 * (self.figure.edges().len() + terminal) as u32)
    }

    fn plane_of(&self, face: FaceId) -> PlaneId {
        self.plane_of[face.index()]
    }

    /// Two planes that are not parallel, the first turning left into the second.
    fn turning_left(&self, [i, j]: [PlaneId; 2]) -> [PlaneId; 2] {
        if self.planes.turn(i, j).is_positive() {
            [i, j]
        } else {
            [j, i]
        }
    }
}
