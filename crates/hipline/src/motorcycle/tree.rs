//! The plane cut into cells by lines, so that few walls are in each: a k-d tree, with some cuts along walls.
//!
//! A cell is cut where the expected work of a path that goes through it becomes least: the surface area
//! heuristic of ray tracers, with perimeters for surfaces (MacDonald & Booth 1990; Wald & Havran 2006), over a
//! few lines of each axis. The cells at the rim reach to infinity.
//!
//! Long walls side by side, in any other direction than those of the axes, are not parted by such lines: each part has nearly as many as
//! the whole. There a cell is cut along one of its walls, if that halves them.
//!
//! The memory is linear: a wall may be in several cells, but all cells together hold no more than eight times as
//! many walls as there are, and a cell hands its share of that to its parts.

use super::way::{Line, Stay, Way};

/// Lines that are tried across each axis.
const LINES: usize = 16;
/// So few walls are not worth a cut.
const FEW: usize = 6;
/// What a step costs, in looks at walls.
const STEP: f64 = 4.0;
/// How many times as many walls as there are the cells may hold.
const SHARE: f64 = 8.0;
/// Cells with more walls are cut along walls where the axes do not part them,
const MANY: usize = 2 * FEW;
/// if no more than so many are on either side,
const MOST: f64 = 0.75;
/// and no more than so many on both together.
const DOUBLE: f64 = 1.25;
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

impl Node {
    /// The node that is cut by a line; lines across no axis are noted.
    pub(super) fn cut(line: Line, parts: u32, lines: &mut Vec<Line>) -> Self {
        if let Some(axis) = line.axis() {
            let line = line.offset;
            return Self::Cut { axis, parts, line };
        }
        lines.push(line);
        let line = lines.len() as u32 - 1;
        Self::Slant { parts, line }
    }
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

    /// What is below a line across an axis, and what is above.
    fn cut(mut self, axis: usize, line: f64) -> [Self; 2] {
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
#[derive(Default)]
pub(super) struct Built {
    pub nodes: Vec<Node>,
    /// Those that are across no axis.
    pub lines: Vec<Line>,
    /// Where the walls of each cell start and end.
    pub cells: Vec<[u32; 2]>,
    /// Each wall, and which part of it is in the cell: its first end is 0, its last one 1.
    pub walls: Vec<(u32, Stay)>,
}

/// About the part of the plane that is of interest in a cell: the corners of a convex polygon.
type Region = Vec<[f64; 2]>;

/// What of a region is below a line, and what is above, about.
fn clip(region: &Region, line: &Line) -> [Region; 2] {
    let above = |p: [f64; 2]| line.normal[0] * p[0] + line.normal[1] * p[1] - line.offset;
    let mut parts = [Region::new(), Region::new()];
    for (at, &q) in region.iter().enumerate() {
        let p = region[if at == 0 { region.len() } else { at } - 1];
        let [d, e] = [above(p), above(q)];
        if (d < 0.0) != (e < 0.0) {
            let part = d / (d - e);
            let between = [0, 1].map(|k| p[k] + part * (q[k] - p[k]));
            parts[0].push(between);
            parts[1].push(between);
        }
        parts[usize::from(e >= 0.0)].push(q);
    }
    parts
}

/// A cell that may be cut.
struct Open {
    node: u32,
    depth: u32,
    region: Region,
    walls: Vec<(u32, Stay)>,
    share: f64,
}

/// Cuts the plane for walls, of each of which its way and when it is there is told; the bounds are those of all that is of interest.
pub(super) fn build(stays: Vec<Stay>, way: impl Fn(usize) -> Way, bounds: Extent) -> Built {
    let count = stays.len();
    let mut built = Built::default();
    built.nodes.push(Node::Cell(0));
    let Extent {
        low: [left, bottom],
        high: [right, top],
    } = bounds;
    let mut open = vec![Open {
        node: 0,
        depth: 0,
        region: vec![[left, bottom], [right, bottom], [right, top], [left, top]],
        walls: (0..).zip(stays).collect(),
        share: SHARE * count as f64,
    }];
    while let Some(cell) = open.pop() {
        match cell.parts(&way) {
            Some((line, parts)) => {
                let first = built.nodes.len() as u32;
                built.nodes[cell.node as usize] = Node::cut(line, first, &mut built.lines);
                let all = parts.iter().map(Vec::len).sum::<usize>() as f64;
                for (k, (walls, region)) in
                    (0..).zip(parts.into_iter().zip(clip(&cell.region, &line)))
                {
                    built.nodes.push(Node::Cell(0));
                    open.push(Open {
                        node: first + k,
                        depth: cell.depth + 1,
                        region,
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

/// A line, and what is on both sides.
type Parts = (Line, [Vec<(u32, Stay)>; 2]);

/// How many walls are on both sides.
fn size((_, parts): &Parts) -> usize {
    parts[0].len() + parts[1].len()
}

impl Open {
    /// Where to cut it, and what is on both sides; nothing if it is not worth it.
    fn parts(&self, way: impl Fn(usize) -> Way) -> Option<Parts> {
        if self.walls.len() <= FEW || self.depth >= DEPTH {
            return None;
        }
        let whole = self.walls.len() as f64;
        let extent = Extent::around(self.region.iter().copied());
        let across_axis = (self.line(&way, &extent)).map(|line| self.split(&way, line));
        let is_good = |parts: &Parts| size(parts) as f64 <= DOUBLE * whole;
        let along_wall = if self.walls.len() <= MANY || across_axis.as_ref().is_some_and(is_good) {
            None
        } else {
            self.line_along(&way)
                .map(|line| self.split(&way, line))
                .filter(|parts| {
                    let most = parts.1[0].len().max(parts.1[1].len());
                    is_good(parts) && most as f64 <= MOST * whole
                })
        };
        along_wall
            .or(across_axis)
            .filter(|parts| size(parts) as f64 <= self.share)
    }

    /// What is on both sides of a line.
    fn split(&self, way: impl Fn(usize) -> Way, line: Line) -> Parts {
        let mut parts = [Vec::new(), Vec::new()];
        for &(wall, stay) in &self.walls {
            let sides = line.split(&way(wall as usize), stay);
            for (part, stay) in parts.iter_mut().zip(sides) {
                part.extend(stay.map(|stay| (wall, stay)));
            }
        }
        (line, parts)
    }

    /// A line along one of the walls, with as many on both sides.
    fn line_along(&self, way: impl Fn(usize) -> Way) -> Option<Line> {
        let half = self.walls.len() / 2;
        let normal = way(self.walls[half].0 as usize).across();
        let place = |&(wall, [from, until]): &(u32, Stay)| {
            way(wall as usize).along(normal, f64::midpoint(from, until))
        };
        let mut places: Vec<f64> = self.walls.iter().map(place).collect();
        places.sort_unstable_by(f64::total_cmp);
        let offset = f64::midpoint(places[half - 1], places[half]);
        let is_line = offset.is_finite() && normal.into_iter().all(f64::is_finite);
        is_line.then_some(Line { normal, offset })
    }

    /// The best line across an axis.
    fn line(&self, way: impl Fn(usize) -> Way, extent: &Extent) -> Option<Line> {
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
                    best = (cost, Some(Line::across(axis, line)));
                }
            }
        }
        best.1
    }
}
