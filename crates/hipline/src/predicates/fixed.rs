//! The planes in exact numbers of a fixed width: the rung that meets exact ties.
//!
//! Where the approximations abstain, the answer nearly always is zero, and zero is seen where
//! integers cancel. Lengths are numbered when they are first asked for, so that a sum of roots is a list of numbers
//! with coefficients. Figures of equal parts have few different lengths.

use dashu_int::{IBig, UBig, ops::UnsignedAbs};
use hipline_num::{Fixed, Integer, Radicals, perfect_root};
use std::cell::RefCell;
use std::rc::Rc;

use super::{
    eaves::{Tilted, tabled},
    expression::Quadratic,
    planes::{Line, Plane, Planes, Rung, exact_time},
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

/// m and r with m² r = square, where r has no square factor that is easy to find.
fn reduced(square: &UBig) -> (UBig, UBig) {
    let (mut multiple, mut rest) = (UBig::ONE, square.clone());
    for prime in PRIMES {
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
        if of_line.is_empty() {
            of_line.resize(planes.lines.len(), 0);
        }
        if of_line[line] == 0 {
            let [a, b, _] = planes.lines[line].integers();
            let square = (&a * &a + &b * &b).unsigned_abs();
            of_line[line] = self.find(&square);
        }
        self.found.borrow()[of_line[line] as usize - 1]
    }

    fn find(&self, square: &UBig) -> u32 {
        let (multiple, rest) = reduced(square);
        let root = if rest.is_one() {
            0
        } else {
            self.radicals.number(rest)
        };
        let multiple = i64::try_from(&IBig::from(multiple)).ok();
        let mut found = self.found.borrow_mut();
        found.push(Length { multiple, root });
        found.len() as u32
    }
}

impl<I: Integer> Rung for Fixed<I> {
    fn line(planes: &Planes, line: usize) -> [Self; 4] {
        let [a, b, c] = match &planes.lines[line] {
            Line::Small { a, b, c } => [i128::from(*a), i128::from(*b), *c].map(I::from_i128),
            Line::Big(abc) => abc.each_ref().map(I::from_int),
            Line::Level(c) => {
                let [zero, one] = [0, 1].map(|i| Self::from_integer(I::from_i128(i)));
                return [zero.clone(), zero, Self::from_integer(I::from_int(c)), one];
            }
            Line::Tilted(_) => unreachable!("tilted planes have no line"),
        };
        let Length { multiple, root } = planes.lengths.of(planes, line);
        let multiple = multiple.and_then(|multiple| I::from_i128(multiple.into()));
        let length = if root == 0 {
            Self::from_integer(multiple)
        } else {
            Self::scaled_root(multiple, root, &planes.lengths.radicals)
        };
        [
            Self::from_integer(a),
            Self::from_integer(b),
            Self::from_integer(c),
            length,
        ]
    }
    // Its normal has a root in it: products of them have more than four.
    fn tilted(_: &Planes, _: usize, _: &Tilted) -> Plane<Self> {
        let unknown = || Self::from_integer(None);
        tabled(&[unknown(), unknown(), unknown(), unknown()])
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
