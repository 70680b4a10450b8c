//! What stands still: the edges of a figure, or walls that somebody placed.

use super::{
    field::Field,
    hits::{Found, Hit, Obstacle},
};
use crate::{
    input::Figure,
    predicates::{Bounds, Place, PlaneId, Rail},
    topology::VertexId,
};
use hipline_num::Sign;

/// The edges of a figure, and which ones there are at each vertex.
pub(super) struct Edges<'a> {
    figure: &'a Figure,
    /// Where the list of each vertex starts in `edges`.
    first: Vec<u32>,
    edges: Vec<u32>,
}

impl<'a> Edges<'a> {
    pub(super) fn new(figure: &'a Figure) -> Self {
        let mut first = vec![0_u32; figure.vertices().len() + 1];
        let ends = || figure.edges().iter().map(|edge| [edge.from, edge.to]);
        for v in ends().flatten() {
            first[v.index() + 1] += 1;
        }
        for v in 1..first.len() {
            first[v] += first[v - 1];
        }
        let mut next = first.clone();
        let mut edges = vec![0; 2 * figure.edges().len()];
        for (e, ends) in ends().enumerate() {
            for v in ends {
                edges[next[v.index()] as usize] = e as u32;
                next[v.index()] += 1;
            }
        }
        Self {
            figure,
            first,
            edges,
        }
    }

    pub(super) const fn figure(&self) -> &'a Figure {
        self.figure
    }

    /// The hit of a motorcycle on a vertex of its path, if that lies ahead. (None either if all edges
    /// there are along the path: then their other ends come before.)
    pub(super) fn hit_vertex(
        &self,
        field: &Field,
        who: u32,
        vertex: VertexId,
        cell: u32,
    ) -> Option<Hit> {
        let pair = field.tracks[who as usize].pair;
        let [from, to] = [0, 1].map(|k| self.first[vertex.index() + k] as usize);
        // Any edge there that is not parallel to the path tells when it is reached.
        let plane = (self.edges[from..to].iter())
            .map(|&edge| PlaneId(2 * edge))
            .find(|&plane| !field.planes.moves_away(pair, plane).is_zero())?;
        let place = Place::On {
            pair,
            rail: Rail::Edge(plane),
        };
        ahead(field, who, place).map(|bounds| Hit {
            who,
            on: Obstacle::Vertex(vertex),
            place,
            bounds,
            there: None,
            cell,
        })
    }

    /// The hit of a motorcycle on the inside of an edge that its path crosses, if that lies
    /// ahead.
    pub(super) fn hit_edge(&self, field: &Field, who: u32, edge: u32, cell: u32) -> Option<Hit> {
        let pair = field.tracks[who as usize].pair;
        let plane = PlaneId(2 * edge);
        let place = Place::On {
            pair,
            rail: Rail::Edge(plane),
        };
        let bounds = ahead(field, who, place)?;
        let from_right = field.planes.moves_away(pair, plane).is_positive();
        Some(Hit {
            who,
            on: Obstacle::Wall(PlaneId(plane.0 + u32::from(from_right))),
            place,
            bounds,
            there: None,
            cell,
        })
    }

    /// Finds where a motorcycle gets to an edge, its ends among it.
    pub(super) fn hits(&self, field: &Field, who: u32, edge: usize, found: &mut Found) {
        let pair = field.tracks[who as usize].pair;
        let ends = self.figure.edges()[edge];
        let ends = [ends.from, ends.to];
        let sides = ends.map(|v| {
            field
                .planes
                .side_of_path(self.figure.vertices()[v.index()], pair)
        });
        for k in 0..2 {
            if sides[k].is_zero() {
                found.hits.extend(self.hit_vertex(field, who, ends[k], 0));
            }
        }
        if (sides[0] * sides[1]).is_negative() {
            found.hits.extend(self.hit_edge(field, who, edge as u32, 0));
        }
    }
}

/// The bounds of the time of a place on the path of a motorcycle, if it comes after the start.
fn ahead(field: &Field, who: u32, place: Place) -> Option<Bounds> {
    let bounds = field.planes.time_bounds(&place);
    let start = (
        &field.tracks[who as usize].start,
        field.starts[who as usize],
    );
    field
        .compare((&place, bounds), start)
        .is_gt()
        .then_some(bounds)
}

/// A wall that somebody placed: a segment.
#[derive(Clone, Copy, Debug)]
pub(super) struct Segment {
    pub ends: [[f64; 2]; 2],
    /// Its line, and the lines across it through its ends.
    pub line: PlaneId,
    pub posts: [PlaneId; 2],
}

impl Segment {
    /// Where a motorcycle gets to the wall. It does not see a wall on which it starts, unless it runs
    /// along it.
    pub(super) fn hit(&self, field: &Field, who: u32, cell: u32) -> Option<Hit> {
        let track = &field.tracks[who as usize];
        let pair = track.pair;
        let sides = self.ends.map(|end| field.planes.side_of_path(end, pair));
        let (place, bounds) = match sides[0] * sides[1] {
            Sign::Positive => return None,
            Sign::Zero if sides == [Sign::Zero; 2] => self.hit_along(field, who)?,
            _ => {
                let rail = Rail::Edge(self.line);
                let place = Place::On { pair, rail };
                (place, ahead(field, who, place)?)
            }
        };
        Some(Hit {
            who,
            on: Obstacle::Wall(self.line),
            place,
            bounds,
            there: None,
            cell,
        })
    }

    /// The same of a wall along the path.
    fn hit_along(&self, field: &Field, who: u32) -> Option<(Place, Bounds)> {
        let track = &field.tracks[who as usize];
        let pair = track.pair;
        let places = self.posts.map(|post| Place::On {
            pair,
            rail: Rail::Edge(post),
        });
        let bounds = places.map(|place| field.planes.time_bounds(&place));
        let order = field.compare((&places[0], bounds[0]), (&places[1], bounds[1]));
        let near = usize::from(order.is_gt());
        if let Some(bounds) = ahead(field, who, places[near]) {
            return Some((places[near], bounds));
        }
        ahead(field, who, places[1 - near])?;
        Some((track.start, field.starts[who as usize]))
    }
}
