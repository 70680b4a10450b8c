//! The plane cut into cells along the axes, so that few walls are in each: a k-d tree.
//!
//! A cell is cut where the expected work of a path that goes through it becomes least: the surface area
//! heuristic of ray tracers, with perimeters for surfaces (MacDonald & Booth 1990; Wald & Havran 2006), over a
//! few lines of each axis. The cells at the rim reach to infinity.
//!
//! The memory is linear: a wall may be in several cells, but all cells together hold no more than eight times as
//! many walls as there are, and a cell hands its share of that to its parts.

use super::way::{Stay, Way};

/// Lines that are tried across each axis.
const LINES: usize = 16;
/// So few walls are not worth a cut.
const FEW: usize = 6;
/// What a step costs, in looks at walls.
const STEP: f64 = 4.0;
/// How many times as many walls as there are the cells may hold.
const SHARE: f64 = 8.0;
/// No cell is the part of a part of ... more than so many times.
const DEPTH: u32 = 96;

/// A part of the plane.
#[derive(Clone, Copy, Debug)]
pub(super) enum Node {
    /// What is below a line across an axis, and the next node, which is above.
    Cut { axis: u8, parts: u32, line: f64 },
    /// The same of a line of any direction, which has a number.
    Slant { parts: u32, line: u32 },
    /// A cell.
    Cell(u32),
}

/// A rectangle.
#[derive(Clone, Copy, Debug)]
pub(super) struct Extent {
    pub low: [f64; 2],
    pub high: [f64; 2],
}

impl Extent {
    /// The rectangle around finite coordinates.
    pub(super) fn around(places: impl Iterator<Item = [f64; 2]>) -> Self {
        let mut around = Self {
            low: [f64::INFINITY; 2],
            high: [f64::NEG_INFINITY; 2],
        };
        for place in places {
            for (axis, x) in place.into_iter().enumerate().filter(|(_, x)| x.is_finite()) {
                around.low[axis] = around.low[axis].min(x);
                around.high[axis] = around.high[axis].max(x);
            }
        }
        around
    }

    /// All of the plane.
    pub(super) const ALL: Self = Self {
        low: [f64::NEG_INFINITY; 2],
        high: [f64::INFINITY; 2],
    };

    /// What is below a line across an axis, and what is above.
    pub(super) fn cut(mut self, axis: usize, line: f64) -> [Self; 2] {
        let mut above = self;
        self.high[axis] = line;
        above.low[axis] = line;
        [self, above]
    }

    fn width(&self, axis: usize) -> f64 {
        self.high[axis] - self.low[axis]
    }

    fn perimeter(&self) -> f64 {
        self.width(0) + self.width(1)
    }
}

/// What the tree is built of: the cells' walls one after the other.
pub(super) struct Built {
    pub nodes: Vec<Node>,
    /// Where the walls of each cell start and end.
    pub cells: Vec<[u32; 2]>,
    /// Each wall, and which part of it is in the cell: its first end is 0, its last one 1.
    pub walls: Vec<(u32, Stay)>,
}

/// A cell that may be cut.
struct Open {
    node: u32,
    depth: u32,
    extent: Extent,
    walls: Vec<(u32, Stay)>,
    share: f64,
}

/// Cuts the plane for walls, of each of which its way and when it is there is told; the bounds are those of all that is of interest.
pub(super) fn build(stays: Vec<Stay>, way: impl Fn(usize) -> Way, bounds: Extent) -> Built {
    let count = stays.len();
    let mut built = Built {
        nodes: vec![Node::Cell(0)],
        cells: Vec::new(),
        walls: Vec::new(),
    };
    let mut open = vec![Open {
        node: 0,
        depth: 0,
        extent: Extent::ALL,
        walls: (0..).zip(stays).collect(),
        share: SHARE * count as f64,
    }];
    while let Some(cell) = open.pop() {
        match cell.parts(&way, &bounds) {
            Some((axis, line, parts)) => {
                let first = built.nodes.len() as u32;
                built.nodes[cell.node as usize] = Node::Cut {
                    axis: axis as u8,
                    parts: first,
                    line,
                };
                let all = parts.iter().map(Vec::len).sum::<usize>() as f64;
                for (k, (walls, extent)) in
                    (0..).zip(parts.into_iter().zip(cell.extent.cut(axis, line)))
                {
                    built.nodes.push(Node::Cell(0));
                    open.push(Open {
                        node: first + k,
                        depth: cell.depth + 1,
                        extent,
                        share: cell.share * walls.len() as f64 / all,
                        walls,
                    });
                }
            }
            None => {
                built.nodes[cell.node as usize] = Node::Cell(built.cells.len() as u32);
                let from = built.walls.len() as u32;
                built.walls.extend(cell.walls);
                built.cells.push([from, built.walls.len() as u32]);
            }
        }
    }
    built
}

/// The axis and the line of a cut, and what is on both sides.
type Parts = (usize, f64, [Vec<(u32, Stay)>; 2]);

impl Open {
    /// Where to cut it, and what is on both sides; nothing if it is not worth it.
    fn parts(&self, way: impl Fn(usize) -> Way, bounds: &Extent) -> Option<Parts> {
        if self.walls.len() <= FEW || self.depth >= DEPTH {
            return None;
        }
        let extent = Extent {
            low: [0, 1].map(|k| self.extent.low[k].max(bounds.low[k])),
            high: [0, 1].map(|k| self.extent.high[k].min(bounds.high[k])),
        };
        let (axis, line) = self.line(&way, &extent)?;
        let mut parts = [Vec::new(), Vec::new()];
        for &(wall, stay) in &self.walls {
            let sides = way(wall as usize).split(stay, axis, line);
            for (part, stay) in parts.iter_mut().zip(sides) {
                part.extend(stay.map(|stay| (wall, stay)));
            }
        }
        ((parts[0].len() + parts[1].len()) as f64 <= self.share).then_some((axis, line, parts))
    }

    /// The best line, and the axis that it is across.
    fn line(&self, way: impl Fn(usize) -> Way, extent: &Extent) -> Option<(usize, f64)> {
        // How many walls start and end between two neighbouring lines.
        let mut counts = [[[0_u32; 2]; LINES]; 2];
        let scale = [0, 1].map(|k| LINES as f64 / extent.width(k));
        for &(wall, stay) in &self.walls {
            let way = way(wall as usize);
            for (axis, counts) in counts.iter_mut().enumerate() {
                let [p, q] = stay.map(|time| way.at(axis, time) - extent.low[axis]);
                let strip = |x: f64| ((x * scale[axis]).max(0.0) as usize).min(LINES - 1);
                counts[strip(p.min(q))][0] += 1;
                counts[strip(p.max(q))][1] += 1;
            }
        }
        let whole = self.walls.len() as u32;
        let mut best = (f64::from(whole), None);
        for (axis, counts) in counts.iter().enumerate() {
            let width = extent.width(axis) / LINES as f64;
            let (mut below, mut above) = (0, whole);
            for k in 1..LINES {
                below += counts[k - 1][0];
                above -= counts[k - 1][1];
                let line = extent.low[axis] + width * k as f64;
                let inside = extent.low[axis] < line && line < extent.high[axis];
                let parts = extent.cut(axis, line);
                let cost = STEP
                    + (parts[0].perimeter() * f64::from(below)
                        + parts[1].perimeter() * f64::from(above))
                        / extent.perimeter();
                if inside && cost < best.0 {
                    best = (cost, Some((axis, line)));
                }
            }
        }
        best.1
    }
}
