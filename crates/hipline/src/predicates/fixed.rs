//! The planes in exact numbers of a fixed width: the rung that meets exact ties.
//!
//! Where the approximations abstain, the answer nearly always is zero, and zero is seen where
//! integers cancel. Lengths are numbered when they are first asked for, so that a sum of roots is a list of numbers
//! with coefficients. Figures of equal parts have few different lengths.

use dashu_int::{IBig, UBig};
use hipline_num::{Fixed, Integer, Limbs, Radicals, Short, perfect_root};
use std::cell::RefCell;
use std::rc::Rc;

use super::{
    eaves::Tilted,
    expression::{Quadratic, any_meeting},
    lines::Line,
    memo::Memo,
    planes::{Plane, PlaneId, Planes, Rung, exact_time},
};

/// A length: an integer, times a root unless the number is 0.
#[derive(Clone, Copy, Debug)]
struct Length {
    /// `None` if it is too large.
    multiple: Option<i64>,
    root: u32,
}

/// The lengths of the normals of lines, as far as somebody asked for them.
#[derive(Debug, Default)]
pub(super) struct Lengths {
    radicals: Rc<Radicals>,
    /// For each line the index of its length in `found`, plus one; 0 as long as it is unknown.
    of_line: RefCell<Vec<u32>>,
    found: RefCell<Vec<Length>>,
}

/// Primes whose squares are looked for in radicands. A sum of two coprime squares has no
/// factor 4 and no prime factors of the form 4k + 3.
const PRIMES: [u32; 12] = [5, 13, 17, 29, 37, 41, 53, 61, 73, 89, 97, 101];

/// More of them, for the radicands of tilted eaves.
const OTHERS: [u32; 8] = [2, 3, 7, 11, 19, 23, 31, 43];

/// m and r with m² r = square, where r has no square factor that is easy to find.
fn reduced(square: &UBig, others: &[u32]) -> (UBig, UBig) {
    let (mut multiple, mut rest) = (UBig::ONE, square.clone());
    for &prime in PRIMES.iter().chain(others) {
        let p = UBig::from(prime * prime);
        while (&rest % &p).is_zero() {
            rest /= &p;
            multiple *= prime;
        }
    }
    match perfect_root(&rest) {
        Some(root) => (multiple * root, UBig::ONE),
        None => (multiple, rest),
    }
}

impl Lengths {
    fn of(&self, planes: &Planes, line: usize) -> Length {
        let mut of_line = self.of_line.borrow_mut();
        if of_line.len() <= line {
            of_line.resize(planes.lines.len(), 0);
        }
        if of_line[line] == 0 {
            of_line[line] = match &planes.lines[line] {
                Line::Tilted(tilted) => self.find(tilted.radicand(), &OTHERS),
                _ => self.find(&planes.square(line), &[]),
            };
        }
        self.found.borrow()[of_line[line] as usize - 1]
    }

    fn find(&self, square: &UBig, others: &[u32]) -> u32 {
        let (multiple, rest) = reduced(square, others);
        let root = if rest.is_one() {
            Some(0)
        } else {
            self.radicals.number(rest)
        };
        let multiple = i64::try_from(&IBig::from(multiple)).ok();
        let (multiple, root) = (root.and(multiple), root.unwrap_or(0));
        let mut found = self.found.borrow_mut();
        found.push(Length { multiple, root });
        found.len() as u32
    }
}

/// `a x + b y = c + s √root t` in integers; the root of 0 is one.
#[derive(Clone, Debug)]
pub(crate) struct Bare<I> {
    a: I,
    b: I,
    c: I,
    s: I,
    root: u32,
}

/// Integers that planes are kept in.
pub(crate) trait Kept: Integer {
    fn known(planes: &Planes) -> &Memo<Option<Bare<Self>>>;
}

impl Kept for i128 {
    fn known(planes: &Planes) -> &Memo<Option<Bare<Self>>> {
        &planes.known.small
    }
}

impl Kept for Short {
    fn known(planes: &Planes) -> &Memo<Option<Bare<Self>>> {
        &planes.known.short
    }
}

impl Kept for Limbs {
    fn known(planes: &Planes) -> &Memo<Option<Bare<Self>>> {
        &planes.known.long
    }
}

impl<I: Integer> Bare<I> {
    /// `None` if something does not fit, or the plane is of a later phase.
    fn new(planes: &Planes, id: PlaneId) -> Option<Self> {
        let line = (id.0 >> 1) as usize;
        if line >= planes.first_later {
            return None;
        }
        if let Line::Level(_) | Line::Tilted(_) = planes.lines[line] {
            return None;
        }
        let [a, b, c] = planes.integers_as(line, I::from_i128, I::from_int);
        let Length { multiple, root } = planes.lengths.of(planes, line);
        let mut s = I::from_i128(multiple?.into())?;
        if let Some(speeds) = &planes.speeds {
            s = s.times(&I::from_int(&speeds.exact[id.0 as usize])?)?;
        }
        let [a, b, c] = if id.0 & 1 == 0 {
            [a?, b?, c?]
        } else {
            [a?.negated()?, b?.negated()?, c?.negated()?]
        };
        Some(Self { a, b, c, s, root })
    }

    fn minor(&self, o: &Self) -> Option<I> {
        self.a.times(&o.b)?.minus(&o.a.times(&self.b)?)
    }
}

/// `N` and `D` of three planes, in one go: neither products of roots nor sums of such are in them.
fn met<I: Kept>(planes: &Planes, triple: [PlaneId; 3]) -> Option<(Fixed<I>, Fixed<I>)> {
    // Long integers take much room.
    let count = [2 * planes.lines.len(), 32];
    let [i, j, k] = triple.map(|id| I::known(planes).get(id.0, count, || Bare::new(planes, id)));
    let (i, j, k) = (i?, j?, k?);
    let (jk, ki, ij) = (j.minor(&k)?, k.minor(&i)?, i.minor(&j)?);
    let n = (jk.times(&i.c)?)
        .plus(&ki.times(&j.c)?)?
        .plus(&ij.times(&k.c)?)?;
    let parts = [
        (jk.times(&i.s), i.root),
        (ki.times(&j.s), j.root),
        (ij.times(&k.s), k.root),
    ];
    Some((
        Fixed::from_integer(Some(n)),
        Fixed::sum_of_roots(parts, &planes.lengths.radicals),
    ))
}

/// The root that a plane has in it.
fn root<I: Integer>(planes: &Planes, line: usize) -> Fixed<I> {
    let Length { multiple, root } = planes.lengths.of(planes, line);
    let multiple = multiple.and_then(|multiple| I::from_i128(multiple.into()));
    if root == 0 {
        Fixed::from_integer(multiple)
    } else {
        Fixed::scaled_root(multiple, root, &planes.lengths.radicals)
    }
}

impl<I: Kept> Rung for Fixed<I> {
    fn meeting(planes: &Planes, triple: [PlaneId; 3]) -> (Self, Self) {
        met(planes, triple).unwrap_or_else(|| any_meeting(planes, triple))
    }
    fn line(planes: &Planes, line: usize) -> [Self; 4] {
        if let Line::Level(c) = &planes.lines[line] {
            let [zero, one] = [0, 1].map(|i| Self::from_integer(I::from_i128(i)));
            return [zero.clone(), zero, Self::from_integer(I::from_int(c)), one];
        }
        let [a, b, c] = planes.integers_as(line, I::from_i128, I::from_int);
        [
            Self::from_integer(a),
            Self::from_integer(b),
            Self::from_integer(c),
            root(planes, line),
        ]
    }
    fn tilted(planes: &Planes, line: usize, tilted: &Tilted) -> Plane<Self> {
        tilted.plane(&root(planes, line))
    }
    fn integer(value: &IBig, _shift: i32) -> Self {
        Self::from_integer(I::from_int(value))
    }
    fn time(planes: &Planes, time: f64) -> [Self; 2] {
        exact_time(planes, time).map(|i| Self::from_integer(I::from_int(&i)))
    }
    fn falling_root(_: &Quadratic<Self>) -> Option<Self> {
        None
    }
}
