//! Exact sums of square roots in integers of a fixed width: what [`Surd`](crate::Surd) is, without
//! memory of its own, where the numbers are not too large.
//!
//! The lengths of a figure are numbered once ([`Radicals`]): equal radicands have one number. A
//! value is a sum of integers times products of up to six *different* roots. As a polynomial in
//! the roots it is reduced: the square of a root is an integer.
//!
//! A value without terms is zero. The converse holds for sums of single roots from
//! different square classes only, so a value that has terms is not said to be different from zero: its sign comes from
//! a double-double of the sum as it stands, or this rung abstains. That is seldom: what
//! makes other rungs abstain is cancellation, and here it has happened exactly.

use crate::{BallDd, Integer, Number, Sign, number::sign_with_root};
use dashu_int::{IBig, UBig};
use smallvec::SmallVec;
use std::cell::RefCell;
use std::cmp::Ordering;
use std::collections::BTreeMap;
use std::rc::Rc;

/// The different radicands of a figure, numbered from 1 in the order in which they are asked for.
#[derive(Debug, Default)]
pub struct Radicals(RefCell<Table>);

#[derive(Debug, Default)]
struct Table {
    numbers: BTreeMap<UBig, u32>,
    values: Vec<Radical>,
}

#[derive(Debug)]
struct Radical {
    value: IBig,
    root: BallDd,
}

impl Radicals {
    /// The number of a radicand, which is not a perfect square; `None` if there are too many.
    pub fn number(&self, radicand: UBig) -> Option<u32> {
        let mut table = self.0.borrow_mut();
        if let Some(&number) = table.numbers.get(&radicand) {
            return Some(number);
        }
        let number = u32::try_from(table.values.len() + 1).ok();
        let number = number.filter(|number| number >> DIGITS == 0)?;
        let value = IBig::from(radicand.clone());
        let root = BallDd::from_int(&value).sqrt();
        table.values.push(Radical { value, root });
        table.numbers.insert(radicand, number);
        Some(number)
    }

    fn square<I: Integer>(&self, number: u32) -> Option<I> {
        I::from_int(&self.0.borrow().values[number as usize - 1].value)
    }

    fn root(&self, number: u32) -> BallDd {
        self.0.borrow().values[number as usize - 1].root
    }
}

/// A product of up to six different roots: their numbers, descending from the highest digits on; 0 where
/// there are no more.
type Product = u128;

/// Binary digits of the number of a root.
const DIGITS: u32 = 21;

/// As many numbers have room.
const FACTORS: u32 = u128::BITS / DIGITS;

/// Where the first number is.
const FIRST: u32 = (FACTORS - 1) * DIGITS;

/// The first number of a product.
fn first(p: Product) -> u32 {
    (p >> FIRST) as u32
}

/// The product without its first number.
fn rest(p: Product) -> Product {
    (p << DIGITS) & (Product::MAX >> (u128::BITS - FACTORS * DIGITS))
}

/// The numbers of a product.
fn factors(mut p: Product) -> impl Iterator<Item = u32> {
    std::iter::from_fn(move || {
        let next = first(p);
        p = rest(p);
        (next != 0).then_some(next)
    })
}

/// One integer times a product of roots.
#[derive(Clone, Debug)]
pub struct Term<I> {
    product: Product,
    coefficient: I,
}

type Terms<I> = SmallVec<<I as Integer>::Terms>;

#[derive(Clone, Debug)]
struct Sum<I: Integer> {
    rational: I,
    /// Sorted by product, which is not empty; no coefficient is zero.
    terms: Terms<I>,
}

/// An exact number that may be too large to know: then it abstains.
#[derive(Clone, Debug)]
pub struct Fixed<I: Integer> {
    /// `None` if no root is in it.
    radicals: Option<Rc<Radicals>>,
    /// `None` if something did not fit.
    sum: Option<Sum<I>>,
}

impl<I: Integer> Fixed<I> {
    /// An integer, if it is there.
    #[must_use]
    pub fn from_integer(i: Option<I>) -> Self {
        Self {
            radicals: None,
            sum: i.map(|rational| Sum {
                rational,
                terms: Terms::<I>::new(),
            }),
        }
    }

    /// A positive integer times a root by its number.
    #[must_use]
    pub fn scaled_root(i: Option<I>, root: u32, radicals: &Rc<Radicals>) -> Self {
        let term = |coefficient| Term {
            product: u128::from(root) << FIRST,
            coefficient,
        };
        Self {
            radicals: Some(Rc::clone(radicals)),
            sum: i.map(|i| Sum {
                rational: I::ZERO,
                terms: std::iter::once(term(i)).collect(),
            }),
        }
    }

    /// A sum of integers times roots by their numbers; 0 is the root of one.
    #[must_use]
    pub fn sum_of_roots<const N: usize>(
        parts: [(Option<I>, u32); N],
        radicals: &Rc<Radicals>,
    ) -> Self {
        let mut sum = Sum {
            rational: I::ZERO,
            terms: Terms::<I>::new(),
        };
        for (coefficient, root) in parts {
            let Some(coefficient) = coefficient else {
                return Self::from_integer(None);
            };
            if !coefficient.sign().is_zero()
                && sum.add(u128::from(root) << FIRST, coefficient).is_none()
            {
                return Self::from_integer(None);
            }
        }
        Self {
            radicals: (!sum.terms.is_empty()).then(|| Rc::clone(radicals)),
            sum: Some(sum),
        }
    }

    /// The result of an operation on two numbers.
    fn of(&self, o: &Self, sum: Option<Sum<I>>) -> Self {
        let radicals = match &sum {
            Some(sum) if !sum.terms.is_empty() => {
                self.radicals.as_ref().or(o.radicals.as_ref()).cloned()
            }
            _ => None,
        };
        Self { radicals, sum }
    }

    /// Whether it is zero for sure.
    #[must_use]
    pub fn is_zero(&self) -> bool {
        self.sum
            .as_ref()
            .is_some_and(|sum| sum.terms.is_empty() && sum.rational.sign().is_zero())
    }

    /// A double-double x and an exponent k such that the value is within the error of x 2^k.
    #[must_use]
    pub fn to_ball_dd(&self) -> Option<(BallDd, i32)> {
        let Sum { rational, terms } = self.sum.as_ref()?;
        let bits = terms.iter().map(|t| t.coefficient.bit_len()).max();
        let bits = bits.unwrap_or(0).max(rational.bit_len());
        // Far from what overflows in products and quotients of double-doubles.
        let drop = bits.saturating_sub(200) as i32;
        let scaled = |coefficient: &I| {
            let value = coefficient.to_ball_dd();
            if drop > 0 { value.ldexp(-drop) } else { value }
        };
        let mut sum = scaled(rational);
        if let Some(radicals) = &self.radicals {
            for term in terms {
                let mut value = scaled(&term.coefficient);
                for factor in factors(term.product) {
                    value = value.times(&radicals.root(factor));
                }
                sum = sum.plus(&value);
            }
        }
        Some((sum, drop))
    }

    /// The sign of a + b·√delta, where delta is not negative, if that can be told.
    #[must_use]
    pub fn sign_with_root(a: &Self, b: &Self, delta: &Self) -> Option<Sign> {
        if b.is_zero() || delta.is_zero() {
            return a.sign();
        }
        if let (Some((x, i)), Some((y, j)), Some((z, k))) =
            (a.to_ball_dd(), b.to_ball_dd(), delta.to_ball_dd())
        {
            // x 2^i + y 2^j sqrt(z 2^k), with an even k and in units of 2^i.
            let root = z.ldexp(k & 1).sqrt();
            let scaled = y.times(&root).ldexp(j + (k >> 1) - i);
            if let Some(sign) = x.plus(&scaled).sign() {
                return Some(sign);
            }
        }
        sign_with_root(a, b, delta)
    }

    /// self + o, or self - o.
    fn merged(&self, o: &Self, subtract: bool) -> Option<Sum<I>> {
        let (a, b) = (self.sum.as_ref()?, o.sum.as_ref()?);
        let join = |x: &I, y: &I| if subtract { x.minus(y) } else { x.plus(y) };
        let rational = join(&a.rational, &b.rational)?;
        if b.terms.is_empty() && a.terms.is_empty() {
            return Some(Sum {
                rational,
                terms: Terms::<I>::new(),
            });
        }
        if b.terms.is_empty() {
            return Some(Sum {
                rational,
                terms: a.terms.clone(),
            });
        }
        let mut terms = Terms::<I>::new();
        let (mut i, mut j) = (0, 0);
        loop {
            let (x, y) = (a.terms.get(i), b.terms.get(j));
            let order = match (x, y) {
                (None, None) => return Some(Sum { rational, terms }),
                (Some(_), None) => Ordering::Less,
                (None, Some(_)) => Ordering::Greater,
                (Some(x), Some(y)) => x.product.cmp(&y.product),
            };
            i += usize::from(order.is_le());
            j += usize::from(order.is_ge());
            match (x, y) {
                (Some(x), _) if order.is_lt() => terms.push(x.clone()),
                (_, Some(y)) if order.is_gt() => terms.push(Term {
                    product: y.product,
                    coefficient: if subtract {
                        y.coefficient.negated()?
                    } else {
                        y.coefficient.clone()
                    },
                }),
                (Some(x), Some(y)) => {
                    let coefficient = join(&x.coefficient, &y.coefficient)?;
                    if !coefficient.sign().is_zero() {
                        terms.push(Term {
                            product: x.product,
                            coefficient,
                        });
                    }
                }
                _ => unreachable!("one of both is there"),
            }
        }
    }

    fn multiplied(&self, o: &Self) -> Option<Sum<I>> {
        let (a, b) = (self.sum.as_ref()?, o.sum.as_ref()?);
        let mut product = Sum {
            rational: a.rational.times(&b.rational)?,
            terms: Terms::<I>::new(),
        };
        if a.terms.is_empty() && b.terms.is_empty() {
            return Some(product);
        }
        for (x, y) in [(a, b), (b, a)] {
            if x.rational.sign().is_zero() {
                continue;
            }
            if product.terms.is_empty() {
                product.terms.reserve_exact(y.terms.len());
                for t in &y.terms {
                    product.terms.push(Term {
                        product: t.product,
                        coefficient: t.coefficient.times(&x.rational)?,
                    });
                }
            } else {
                for t in &y.terms {
                    product.add(t.product, t.coefficient.times(&x.rational)?)?;
                }
            }
        }
        for x in &a.terms {
            for y in &b.terms {
                let mut coefficient = x.coefficient.times(&y.coefficient)?;
                let (roots, common) = joined(x.product, y.product)?;
                for factor in factors(common) {
                    let radicals = self.radicals.as_ref()?;
                    coefficient = coefficient.times(&radicals.square(factor)?)?;
                }
                product.add(roots, coefficient)?;
            }
        }
        Some(product)
    }
}

impl<I: Integer> Sum<I> {
    fn add(&mut self, product: Product, coefficient: I) -> Option<()> {
        if product == 0 {
            self.rational = self.rational.plus(&coefficient)?;
            return Some(());
        }
        match self.terms.binary_search_by(|t| t.product.cmp(&product)) {
            Ok(at) => {
                let sum = self.terms[at].coefficient.plus(&coefficient)?;
                if sum.sign().is_zero() {
                    self.terms.remove(at);
                } else {
                    self.terms[at].coefficient = sum;
                }
            }
            Err(at) => self.terms.insert(
                at,
                Term {
                    product,
                    coefficient,
                },
            ),
        }
        Some(())
    }
}

/// The roots that are in one of two products, and those in both; `None` if there are too many.
fn joined(mut p: Product, mut q: Product) -> Option<(Product, Product)> {
    let (mut single, mut common) = (Joint::default(), Joint::default());
    while p != 0 || q != 0 {
        let (a, b) = (first(p), first(q));
        if a >= b {
            p = rest(p);
        }
        if b >= a {
            q = rest(q);
        }
        if a == b {
            common.push(a)?;
        } else {
            single.push(a.max(b))?;
        }
    }
    Some((single.product, common.product))
}

#[derive(Default)]
struct Joint {
    product: Product,
    len: u32,
}

impl Joint {
    fn push(&mut self, number: u32) -> Option<()> {
        if self.len == FACTORS {
            return None;
        }
        self.product |= u128::from(number) << (FIRST - DIGITS * self.len);
        self.len += 1;
        Some(())
    }
}

impl<I: Integer> Number for Fixed<I> {
    fn zero() -> Self {
        Self::from_integer(Some(I::ZERO))
    }
    fn from_i64(i: i64) -> Self {
        Self::from_integer(I::from_i128(i.into()))
    }
    fn plus(&self, o: &Self) -> Self {
        self.of(o, self.merged(o, false))
    }
    fn minus(&self, o: &Self) -> Self {
        self.of(o, self.merged(o, true))
    }
    fn times(&self, o: &Self) -> Self {
        self.of(o, self.multiplied(o))
    }
    fn negated(&self) -> Self {
        let negated = |sum: &Sum<I>| {
            let mut terms = Terms::<I>::new();
            for term in &sum.terms {
                terms.push(Term {
                    product: term.product,
                    coefficient: term.coefficient.negated()?,
                });
            }
            let rational = sum.rational.negated()?;
            Some(Sum { rational, terms })
        };
        let sum = self.sum.as_ref().and_then(negated);
        Self {
            radicals: self.radicals.clone(),
            sum,
        }
    }
    fn sign(&self) -> Option<Sign> {
        let Sum { rational, terms } = self.sum.as_ref()?;
        let rational = rational.sign();
        let Some(first) = terms.first() else {
            return Some(rational);
        };
        let leading = first.coefficient.sign();
        if (rational.is_zero() || rational == leading)
            && terms[1..].iter().all(|t| t.coefficient.sign() == leading)
        {
            return Some(leading);
        }
        self.to_ball_dd()?.0.sign()
    }
}
