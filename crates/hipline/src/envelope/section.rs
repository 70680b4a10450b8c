//! The roof above a cut: slabs restricted to an upright plane are segments in it, and the roof is their lower envelope
//! (section 3.3 of the thesis).

use super::{
    Envelope,
    boundary::Node,
    profile::{Chart, Meet, Piece, lower_envelope},
};
use crate::predicates::{CellCorner, Line, PlaneId, Planes, Station, Track as Border};
use hipline_num::{Sign, power_of_two};
use std::{
    cell::{Cell, RefCell},
    cmp::Ordering,
    sync::Arc,
};

/// A cut, and along which axis places on it are told apart in f64.
#[derive(Clone, Debug)]
pub(super) struct Cut {
    pub line: Line,
    /// 1 for y.
    pub axis: usize,
    /// Whether it goes down along this axis.
    pub is_down: bool,
    /// A point of it, and its direction, unless it goes along a track.
    pub toward: Option<([f64; 2], [i32; 2])>,
    /// Whether only its stretch around that point cuts.
    pub is_chord: bool,
}

impl Cut {
    /// The cut up, or to the right, where a coordinate has the given value.
    pub(super) fn across(planes: &Planes, axis: usize, c: f64) -> Self {
        let mut point = [0.0; 2];
        point[axis] = c;
        let toward = [0, 1].map(|k| i32::from(k != axis));
        Self {
            is_chord: false,
            ..Self::chord(planes, point, toward)
        }
    }

    /// The cut through a point in a direction, within the stretch around the point.
    pub(super) fn chord(planes: &Planes, point: [f64; 2], toward: [i32; 2]) -> Self {
        let axis = usize::from(toward[1].abs() > toward[0].abs());
        Self {
            line: Line::Toward(Arc::new(Station::new(planes, point)), toward),
            axis,
            is_down: toward[axis] < 0,
            toward: Some((point, toward)),
            is_chord: true,
        }
    }

    /// How far along it a point is.
    pub(super) fn at(&self, point: [f64; 2]) -> f64 {
        if self.is_down {
            -point[self.axis]
        } else {
            point[self.axis]
        }
    }

    /// A point of it that many directions from its own, if it is in f64.
    pub(super) fn point(&self, t: f64) -> Option<[f64; 2]> {
        let (from, toward) = self.toward?;
        let [x, y] = [0, 1].map(|k| {
            let (p, d) = (from[k], f64::from(toward[k]));
            let way = t * d;
            let sum = p + way;
            let rest = sum - p;
            // What was rounded off (Dekker, Knuth).
            let off = [t.mul_add(d, -way), p - (sum - rest), way - rest];
            off.iter().all(|&x| x.abs() <= 0.0).then_some(sum)
        });
        Some([x?, y?])
    }

    /// On which side of it a box is, if that is plain: positive on the left.
    pub(super) fn side_of_box(&self, frame: &[[f64; 2]; 2]) -> Option<Sign> {
        let (from, toward) = self.toward?;
        let [dx, dy] = toward.map(f64::from);
        let mut bounds = [0.0; 2];
        let mut size = 0.0;
        for (factor, k) in [(-dy, 0), (dx, 1)] {
            let [low, high] = frame[k].map(|x| factor * (x - from[k]));
            bounds[0] += low.min(high);
            bounds[1] += low.max(high);
            size += low.abs() + high.abs();
        }
        // Each sum of two is off by one part in 2^52 of what goes into it at most.
        let slack = size * power_of_two(-50);
        if bounds[0] > slack {
            Some(Sign::Positive)
        } else if bounds[1] < -slack {
            Some(Sign::Negative)
        } else {
            None
        }
    }

    /// Bounds of how far along it a corner is.
    pub(super) fn along(&self, node: &Node) -> [f64; 2] {
        let [low, high] = node.frame[self.axis];
        if self.is_down {
            [-high, -low]
        } else {
            [low, high]
        }
    }
}

/// What a cut meets at a place.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Mark {
    /// Before all others.
    First,
    /// The source of a slab.
    Source(u32),
    /// The side of a slab: 0 at the start of its source.
    Side(u32, usize),
    /// Where two planes agree.
    Planes([PlaneId; 2]),
    /// After all others.
    Last,
}

/// A place on a cut, and bounds of where it is.
#[derive(Clone, Copy, Debug)]
pub(super) struct Spot {
    pub mark: Mark,
    pub bounds: [f64; 2],
}

/// A cut: the curves over it are the times of planes.
pub(super) struct Above<'a, 'b> {
    envelope: &'a Envelope<'b>,
    cut: &'a Cut,
    /// Whether two planes were found to agree all along the cut.
    tied: Cell<bool>,
    /// Faces on one plane whose slabs were found over one another.
    twins: RefCell<Vec<[u32; 2]>>,
}

impl Chart for Above<'_, '_> {
    type Spot = Spot;

    fn order(&self, p: &Spot, q: &Spot) -> Ordering {
        if p.bounds[1] < q.bounds[0] {
            return Ordering::Less;
        }
        if p.bounds[0] > q.bounds[1] {
            return Ordering::Greater;
        }
        match (p.mark, q.mark) {
            (p, q) if p == q => Ordering::Equal,
            (Mark::First, _) | (_, Mark::Last) => Ordering::Less,
            (Mark::Last, _) | (_, Mark::First) => Ordering::Greater,
            (p, q) if self.envelope.is_same_line(p, q) => Ordering::Equal,
            (p, q) => {
                let [p, q] = [p, q].map(|mark| self.envelope.line_of(mark));
                self.envelope.planes.compare_on_cut(&self.cut.line, &p, &q)
            }
        }
    }

    fn meet(&self, a: u32, b: u32) -> Meet<Spot> {
        let [i, j] = [a, b].map(|slab| self.envelope.class(self.envelope.slab(slab).plane));
        if i == j {
            let faces = [a, b].map(|slab| self.envelope.refs[slab as usize].face);
            if faces[0] != faces[1] {
                self.twins.borrow_mut().push(faces);
            }
            return Meet::Never(Sign::from(b.cmp(&a)));
        }
        // Positive where a is later, so higher.
        let line = Line::Border(Border::Equal([i, j]));
        let planes = &self.envelope.planes;
        match planes.slope_on_cut(&self.cut.line, &line) {
            Sign::Zero => {
                let side = planes.side_of_cut(&self.cut.line, &line);
                if side.is_zero() {
                    self.tied.set(true);
                }
                Meet::Never(-side)
            }
            slope => {
                let bounds = self.envelope.bounds_on(self.cut, &line);
                let mark = Mark::Planes([i, j]);
                Meet::At(Spot { mark, bounds }, -slope)
            }
        }
    }
}

impl<'a, 'b> Above<'a, 'b> {
    pub(super) fn new(envelope: &'a Envelope<'b>, cut: &'a Cut) -> Self {
        Self {
            envelope,
            cut,
            tied: Cell::new(false),
            twins: RefCell::default(),
        }
    }

    /// The part of the cut below a slab.
    pub(super) fn restrict(&self, number: u32) -> Option<[Spot; 2]> {
        let planes = &self.envelope.planes;
        let bounds = [f64::NEG_INFINITY, f64::INFINITY];
        let mut ends = [Mark::First, Mark::Last].map(|mark| Spot { mark, bounds });
        let wanted = [
            (Mark::Source(number), Sign::Positive),
            (Mark::Side(number, 0), Sign::Positive),
            (Mark::Side(number, 1), Sign::Negative),
        ];
        for (mark, side) in wanted {
            let line = self.envelope.line_of(mark);
            let slope = planes.slope_on_cut(&self.cut.line, &line) * side;
            if slope.is_zero() {
                if (planes.side_of_cut(&self.cut.line, &line) * side).is_negative() {
                    return None;
                }
                continue;
            }
            let bounds = self.envelope.bounds_on(self.cut, &line);
            let spot = Spot { mark, bounds };
            if slope.is_positive() {
                if self.order(&spot, &ends[0]).is_gt() {
                    ends[0] = spot;
                }
            } else if self.order(&spot, &ends[1]).is_lt() {
                ends[1] = spot;
            }
            if self.order(&ends[0], &ends[1]).is_ge() {
                return None;
            }
        }
        Some(ends)
    }
}

impl Envelope<'_> {
    /// The line on which a place on a cut lies.
    pub(super) fn line_of(&self, mark: Mark) -> Line {
        let border = match mark {
            Mark::Source(number) => {
                let slab = self.slab(number);
                match slab.beside {
                    None => Border::Level(slab.plane, 0.0),
                    Some(x) => Border::Equal([slab.plane, x]),
                }
            }
            Mark::Side(number, end) => {
                let slab = self.slab(number);
                Border::Across(slab.plane, slab.ends[end].into())
            }
            Mark::Planes(pair) => Border::Equal(pair),
            Mark::First | Mark::Last => unreachable!("no line is there"),
        };
        Line::Border(border)
    }

    /// Whether two marks lie on one line by definition: as neighbouring slabs do, which is costly to find out.
    fn is_same_line(&self, p: Mark, q: Mark) -> bool {
        let side = |mark: Mark| match mark {
            Mark::Side(number, end) => {
                let slab = self.slab(number);
                Some((self.class(slab.plane), slab.ends[end]))
            }
            _ => None,
        };
        let pair = |mark: Mark| {
            let pair = match mark {
                Mark::Planes(pair) => pair,
                Mark::Source(number) => {
                    let slab = self.slab(number);
                    [slab.plane, slab.beside?].map(|plane| self.class(plane))
                }
                _ => return None,
            };
            Some([pair[0].min(pair[1]), pair[0].max(pair[1])])
        };
        side(p).is_some() && side(p) == side(q) || pair(p).is_some() && pair(p) == pair(q)
    }

    /// Bounds of where a cut crosses a line.
    pub(super) fn bounds_on(&self, cut: &Cut, line: &Line) -> [f64; 2] {
        let corner = CellCorner::Of(cut.line.clone(), line.clone());
        let [low, high] = self.planes.bounds_of(&corner)[cut.axis];
        if cut.is_down {
            [-high, -low]
        } else {
            [low, high]
        }
    }

    /// The roof of some slabs above a cut, from its start to its end; `None` if two of them agree all along it, so that each may
    /// be visible on one side only.
    ///
    /// # Complexity
    /// O(k α(k) log k) questions for k slabs.
    pub(super) fn section(&mut self, cut: &Cut, slabs: &[u32]) -> Option<Vec<Piece<Spot>>> {
        let mut count = self.count;
        let chart = Above::new(self, cut);
        let mut pieces = Vec::new();
        for &of in slabs {
            if let Some([from, to]) = chart.restrict(of) {
                pieces.push(Piece { from, to, of });
            }
        }
        count.sections += pieces.len() as u64;
        let roof = lower_envelope(&chart, pieces, &mut count.merging);
        let tied = chart.tied.get();
        let twins = chart.twins.take();
        self.twins.extend(twins);
        self.count = count;
        (!tied).then_some(roof)
    }
}
