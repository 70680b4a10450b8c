//! The ground of all motorcycles: cells with few walls and few motorcycles in them.
//!
//! A motorcycle goes from cell to cell of a tree (`tree`), and in each looks at the walls, and at those that are
//! there or have been. Two paths that cross do so in a cell that both go through, on its rim at least; the later one gets there
//! not later than when it is where they cross. Which cells a path goes through is found in f64 with bounds
//! (`way`): one too many costs time only.
//!
//! Where too many motorcycles come, a cell is cut in two, if that parts those who are there already; along their way, too, since many that go one way
//! side by side would each go through many cells that are cut across the axes.

use super::{
    encounter::{Window, encounter},
    field::{Field, Ground},
    hits::{Found, Step},
    tree::{self, Extent, Node},
    walls::Standing,
    way::{Line, Stay, Way},
};

/// No further entry.
const NONE: u32 = u32::MAX;
/// A cell with more motorcycles is cut.
const MANY: u32 = 12;
/// Cells with more walls than so many for each wall and motorcycle are not cut any more.
const WALLS: usize = 32;

/// Something that is in a list: a motorcycle in a cell, or a node that one has still to go to.
#[derive(Clone, Copy, Debug)]
struct Entry {
    what: u32,
    /// The next one of the list.
    next: u32,
    stay: Stay,
}

/// Lists in one block of memory.
#[derive(Default)]
struct Lists {
    entries: Vec<Entry>,
    free: Option<u32>,
}

impl Lists {
    /// Puts something in front of a list.
    fn push(&mut self, first: &mut u32, what: u32, stay: Stay) {
        let entry = Entry {
            what,
            next: *first,
            stay,
        };
        if let Some(at) = self.free {
            let next = self.entries[at as usize].next;
            self.free = (next != NONE).then_some(next);
            self.entries[at as usize] = entry;
            *first = at;
        } else {
            *first = u32::try_from(self.entries.len()).expect("fewer than 2^32 entries");
            self.entries.push(entry);
        }
    }

    /// Takes the first one from a list.
    fn pop(&mut self, first: &mut u32) -> Option<(u32, Stay)> {
        let at = *first;
        if at == NONE {
            return None;
        }
        let entry = self.entries[at as usize];
        *first = entry.next;
        self.entries[at as usize].next = self.free.unwrap_or(NONE);
        self.free = Some(at);
        Some((entry.what, entry.stay))
    }
}

/// The end of the tree where walls and motorcycles are.
#[derive(Clone, Copy, Debug)]
struct Cell {
    /// Where its walls start and end.
    walls: [u32; 2],
    /// The first one of its motorcycles, and how many there are.
    riders: u32,
    count: u32,
    /// With how many it is cut.
    many: u32,
}

/// The cells, and the walls and motorcycles in them.
pub(super) struct Cells<'a> {
    standing: Standing<'a>,
    nodes: Vec<Node>,
    cells: Vec<Cell>,
    lines: Vec<Line>,
    walls: Vec<(u32, Stay)>,
    riders: Lists,
    /// Where each motorcycle still has to go: first what it gets to first.
    ahead: Lists,
    first: Vec<u32>,
    /// When each takes its next step.
    due: Vec<f64>,
    ways: Vec<Way>,
    /// All that is to be before has been.
    now: f64,
}

impl<'a> Cells<'a> {
    /// The cells of walls; motorcycles start at places like those told.
    pub(super) fn new(standing: Standing<'a>, starts: impl Iterator<Item = [f64; 2]>) -> Self {
        let ends = |wall: usize| standing.ends(wall);
        let places = (0..standing.len()).flat_map(ends).chain(starts);
        let bounds = Extent::around(places);
        let tree::Built {
            nodes,
            lines,
            cells,
            walls,
        } = tree::build(
            vec![[0.0, 1.0]; standing.len()],
            |wall| Way::between(ends(wall)),
            bounds,
        );
        let cells = cells.into_iter().map(|walls| Cell {
            walls,
            riders: NONE,
            count: 0,
            many: MANY,
        });
        Self {
            cells: cells.collect(),
            standing,
            nodes,
            lines,
            walls,
            riders: Lists::default(),
            ahead: Lists::default(),
            first: Vec::new(),
            due: Vec::new(),
            ways: Vec::new(),
            now: f64::NEG_INFINITY,
        }
    }

    /// Goes to all cells where a motorcycle may be by a time.
    fn go(&mut self, field: &Field, who: u32, until: f64, found: &mut Found) {
        self.now = until;
        self.due[who as usize] = f64::INFINITY;
        loop {
            let first = self.first[who as usize];
            if first == NONE {
                return;
            }
            let low = self.ahead.entries[first as usize].stay[0];
            if low > until {
                return self.plan(field, who, low, found);
            }
            if let Some((node, stay)) = self.ahead.pop(&mut self.first[who as usize]) {
                self.go_down(field, who, node, stay, found);
            }
        }
    }

    /// Plans the next step of a motorcycle, unless it takes one before, or has stopped by then.
    fn plan(&mut self, field: &Field, who: u32, low: f64, found: &mut Found) {
        if low < self.due[who as usize] && low <= field.until[who as usize] {
            self.due[who as usize] = low;
            found.steps.push(Step { low, who });
        }
    }

    /// Goes to the first cell of a node, and notes the other parts.
    fn go_down(
        &mut self,
        field: &Field,
        who: u32,
        mut node: u32,
        mut stay: Stay,
        found: &mut Found,
    ) {
        let way = self.ways[who as usize];
        loop {
            let (parts, sides) = match self.nodes[node as usize] {
                Node::Cell(cell) => return self.enter(field, who, node, cell, stay, found),
                Node::Cut { axis, parts, line } => {
                    (parts, way.split(stay, usize::from(axis), line))
                }
                Node::Slant { parts, line } => {
                    (parts, way.split_by(stay, &self.lines[line as usize]))
                }
            };
            let (near, far) = match sides {
                [Some(below), Some(above)] if above[0] < below[0] => {
                    ((parts + 1, above), Some((parts, below)))
                }
                [Some(below), Some(above)] => ((parts, below), Some((parts + 1, above))),
                [Some(below), None] => ((parts, below), None),
                [None, Some(above)] => ((parts + 1, above), None),
                [None, None] => return,
            };
            if let Some((far, stay)) = far {
                self.ahead.push(&mut self.first[who as usize], far, stay);
            }
            (node, stay) = near;
        }
    }

    /// Looks around in a cell, and stays there.
    fn enter(
        &mut self,
        field: &Field,
        who: u32,
        node: u32,
        cell: u32,
        mut stay: Stay,
        found: &mut Found,
    ) {
        let Cell {
            walls: [from, to],
            riders,
            ..
        } = self.cells[cell as usize];
        stay[1] = stay[1].min(field.until[who as usize]);
        let known = found.hits.len();
        for &(wall, _) in &self.walls[from as usize..to as usize] {
            self.standing
                .hits(field, who, wall as usize, stay, &mut found.hits);
        }
        for hit in &found.hits[known..] {
            stay[1] = stay[1].min(hit.bounds.high);
        }
        let mut seen = found.hits.len();
        let mut next = riders;
        while next != NONE {
            let Entry {
                what: other,
                next: after,
                stay: stays,
            } = self.riders.entries[next as usize];
            let window = Window {
                from: [stays[0], stay[0]],
                until: [stays[1].min(field.until[other as usize]), stay[1]],
            };
            encounter(field, other, who, window, found);
            for hit in &found.hits[seen..] {
                if hit.who == who && field.is_certain(hit) {
                    stay[1] = stay[1].min(hit.bounds.high);
                }
            }
            seen = found.hits.len();
            next = after;
        }
        // What would be after it has stopped does not happen.
        let mut at = known;
        while at < found.hits.len() {
            let hit = &found.hits[at];
            let when = if hit.who == who {
                Some(hit.bounds)
            } else {
                hit.there
            };
            if when.is_some_and(|when| when.low > stay[1]) {
                found.hits.swap_remove(at);
            } else {
                at += 1;
            }
        }
        let into = &mut self.cells[cell as usize];
        self.riders.push(&mut into.riders, who, stay);
        into.count += 1;
        if into.count > into.many {
            self.cut(field, node, cell, found);
        }
    }

    /// Where to cut a cell so that its motorcycles are parted best, if that is worth while: across an axis, or
    /// along the way that they go.
    fn best_line(&self, riders: &[(u32, Stay)]) -> Option<Line> {
        let mut best = (riders.len() + riders.len() / 2, None);
        let way = |who: u32| &self.ways[who as usize];
        let middle = way(riders[riders.len() / 2].0);
        for normal in [[1.0, 0.0], [0.0, 1.0], middle.across()] {
            let place = |&(who, [from, until]): &(u32, Stay)| {
                let from = from.max(way(who).start());
                let time = if until.is_finite() {
                    f64::midpoint(from, until)
                } else {
                    from
                };
                way(who).along(normal, time)
            };
            let mut places: Vec<f64> = riders.iter().map(place).collect();
            places.sort_unstable_by(f64::total_cmp);
            let half = places.len() / 2;
            let offset = f64::midpoint(places[half - 1], places[half]);
            let line = Line { normal, offset };
            if !(offset.is_finite() && normal[0].is_finite() && normal[1].is_finite()) {
                continue;
            }
            let mut counts = [0; 2];
            for &(who, stay) in riders {
                let sides = line.split(way(who), stay);
                for (count, side) in counts.iter_mut().zip(sides) {
                    *count += usize::from(side.is_some_and(|stay| stay[0] <= self.now));
                }
            }
            let most = riders.len() * 3 / 4;
            if counts[0].max(counts[1]) <= most && counts[0] + counts[1] < best.0 {
                best = (counts[0] + counts[1], Some(line));
            }
        }
        best.1
    }

    /// Cuts a cell with many motorcycles.
    fn cut(&mut self, field: &Field, node: u32, number: u32, found: &mut Found) {
        let Cell {
            walls: [from, to],
            riders: mut list,
            ..
        } = self.cells[number as usize];
        let mut riders = Vec::new();
        while let Some((who, [from, until])) = self.riders.pop(&mut list) {
            let until = until.min(field.until[who as usize]);
            // Or else it has stopped before it would have come.
            if from <= until {
                riders.push((who, [from, until]));
            }
        }
        let may_grow = self.walls.len() <= WALLS * (self.standing.len() + self.ways.len());
        let line = if may_grow && riders.len() > MANY as usize / 2 {
            self.best_line(&riders)
        } else {
            None
        };
        let Some(line) = line else {
            for &(who, stay) in &riders {
                self.riders.push(&mut list, who, stay);
            }
            let cell = &mut self.cells[number as usize];
            cell.riders = list;
            cell.count = riders.len() as u32;
            cell.many = MANY.max(2 * cell.count);
            return;
        };
        let parts = self.nodes.len() as u32;
        for k in 0..2 {
            let first = self.walls.len() as u32;
            for at in from..to {
                let (wall, stay) = self.walls[at as usize];
                let way = Way::between(self.standing.ends(wall as usize));
                if let Some(stay) = line.split(&way, stay)[k] {
                    self.walls.push((wall, stay));
                }
            }
            let mut cell = Cell {
                walls: [first, self.walls.len() as u32],
                riders: NONE,
                count: 0,
                many: MANY,
            };
            for &(who, stay) in &riders {
                match line.split(&self.ways[who as usize], stay)[k] {
                    // It is not there yet, and may never be.
                    Some(stay) if stay[0] > self.now => {
                        let first = &mut self.first[who as usize];
                        self.ahead.push(first, parts + k as u32, stay);
                        self.plan(field, who, stay[0], found);
                    }
                    Some(stay) => {
                        self.riders.push(&mut cell.riders, who, stay);
                        cell.count += 1;
                    }
                    None => {}
                }
            }
            let place = if k == 0 {
                self.cells[number as usize] = cell;
                number
            } else {
                self.cells.push(cell);
                self.cells.len() as u32 - 1
            };
            self.nodes.push(Node::Cell(place));
        }
        self.nodes[node as usize] = Node::cut(line, parts, &mut self.lines);
    }
}

impl Ground for Cells<'_> {
    fn start(&mut self, field: &Field, who: u32, found: &mut Found) {
        let way = Way::of_track(field.planes, &field.tracks[who as usize]);
        self.ways.push(way);
        self.first.push(NONE);
        self.due.push(f64::INFINITY);
        let from = field.starts[who as usize];
        let stay = [from.low, f64::INFINITY];
        self.ahead.push(&mut self.first[who as usize], 0, stay);
        self.go(field, who, from.low, found);
    }

    fn step(&mut self, field: &Field, step: Step, found: &mut Found) {
        // Or else another step was planned before.
        if self.due[step.who as usize].to_bits() == step.low.to_bits() {
            self.go(field, step.who, step.low, found);
        }
    }
}
