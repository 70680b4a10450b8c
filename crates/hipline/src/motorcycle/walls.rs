//! What stands still: the edges of a figure, or walls that somebody placed.

use super::{
    field::Field,
    hits::{Hit, Obstacle},
    tracks::Origin,
    way::Stay,
};
use crate::{
    input::Figure,
    predicates::{Bounds, Place, PlaneId, Planes, Rail},
    topology::VertexId,
};
use hipline_num::{Rough, Sign};

/// What stands still.
pub(super) enum Standing<'a> {
    Edges(Edges<'a>),
    Walls(Vec<Segment>),
}

impl Standing<'_> {
    /// How many walls there are.
    pub(super) fn len(&self) -> usize {
        match self {
            Self::Edges(edges) => edges.figure.edges().len(),
            Self::Walls(walls) => walls.len(),
        }
    }

    /// The ends of a wall.
    pub(super) fn ends(&self, wall: usize) -> [[f64; 2]; 2] {
        match self {
            Self::Edges(edges) => {
                let ends = edges.figure.edges()[wall];
                [ends.from, ends.to].map(|v| edges.figure.vertices()[v.index()])
            }
            Self::Walls(walls) => walls[wall].ends,
        }
    }

    /// Finds where a motorcycle gets to a wall, its ends among it; what it does at other times than
    /// those told need not be found.
    pub(super) fn hits(
        &self,
        field: &Field,
        who: u32,
        wall: usize,
        stay: Stay,
        found: &mut Vec<Hit>,
    ) {
        let during = |hit: &Hit| hit.bounds.high >= stay[0] && hit.bounds.low <= stay[1];
        match self {
            Self::Edges(edges) => {
                found.extend((edges.hits(field, who, wall).into_iter().flatten()).filter(during))
            }
            Self::Walls(walls) => found.extend(walls[wall].hit(field, who).filter(during)),
        }
    }
}

/// The edges of a figure, and which ones there are at each vertex.
pub(super) struct Edges<'a> {
    figure: &'a Figure,
    /// The vertices, roughly.
    places: Vec<[Rough; 2]>,
    /// Where the list of each vertex starts in `edges`.
    first: Vec<u32>,
    edges: Vec<u32>,
}

impl<'a> Edges<'a> {
    pub(super) fn new(figure: &'a Figure, planes: &Planes) -> Self {
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
        let places = figure.vertices().iter();
        Self {
            figure,
            places: places.map(|&vertex| planes.rough_vertex(vertex)).collect(),
            first,
            edges,
        }
    }

    /// The hit of a motorcycle on a vertex of its path, if that lies ahead. (None either if all edges
    /// there are along the path: then their other ends come before.)
    fn hit_vertex(&self, field: &Field, who: u32, vertex: VertexId) -> Option<Hit> {
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
        })
    }

    /// The hit of a motorcycle on the inside of an edge that its path crosses, if that lies
    /// ahead.
    fn hit_edge(&self, field: &Field, who: u32, edge: u32) -> Option<Hit> {
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
        })
    }

    /// On which side of a motorcycle's path a vertex is: the left is positive.
    fn side(&self, field: &Field, who: u32, vertex: VertexId) -> Sign {
        let lane = &field.lanes[who as usize];
        lane.side(&self.places[vertex.index()]).unwrap_or_else(|| {
            let pair = field.tracks[who as usize].pair;
            field
                .planes
                .side_of_path(self.figure.vertices()[vertex.index()], pair)
        })
    }

    /// Where a motorcycle gets to an edge: to one of its ends, or to its inside.
    fn hits(&self, field: &Field, who: u32, edge: usize) -> [Option<Hit>; 2] {
        let ends = self.figure.edges()[edge];
        let ends = [ends.from, ends.to];
        // It starts in a sector without edges.
        if let Origin::Vertex(start) = field.tracks[who as usize].origin
            && ends.contains(&start)
        {
            return [None; 2];
        }
        let sides = ends.map(|v| self.side(field, who, v));
        match sides[0] * sides[1] {
            Sign::Positive => [None; 2],
            Sign::Negative => [self.hit_edge(field, who, edge as u32), None],
            Sign::Zero => [0, 1].map(|k| {
                let hit = || self.hit_vertex(field, who, ends[k]);
                sides[k].is_zero().then(hit).flatten()
            }),
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
    fn hit(&self, field: &Field, who: u32) -> Option<Hit> {
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
