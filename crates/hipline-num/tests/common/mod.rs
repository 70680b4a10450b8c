//! A slow and obvious oracle, and a seeded source of numbers.
#![allow(dead_code, reason = "each test file uses a part of it")]

use hipline_num::{IBig, Number, Sign, UBig, f64_to_parts, ilog2};
use std::cmp::Ordering;

/// SplitMix64.
pub struct Random(pub u64);

impl Random {
    pub fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    pub fn below(&mut self, n: u64) -> u64 {
        self.next() % n
    }

    /// An integer of at most `bits` bits, of any length equally.
    pub fn int(&mut self, bits: u64) -> IBig {
        let len = self.below(bits + 1) as usize;
        let mut m = UBig::ZERO;
        for _ in 0..len.div_ceil(64) {
            m = (m << 64) + UBig::from(self.next());
        }
        let excess = len.div_ceil(64) * 64 - len;
        let m = IBig::from(m >> excess);
        if self.next().is_multiple_of(2) { -m } else { m }
    }

    pub fn positive(&mut self, bits: u64) -> UBig {
        let i = self.int(bits);
        let m = if i < IBig::ZERO { -i } else { i };
        UBig::try_from(m).unwrap() + UBig::ONE
    }

    /// An f64 of any kind but infinite, with an exponent in the range given.
    pub fn float(&mut self, least: i32, most: i32) -> f64 {
        let span = (most - least + 1) as u64;
        let k = least + self.below(span) as i32;
        let mantissa = match self.below(4) {
            0 => 1.0,
            1 => 1.0 + (self.below(16) as f64) / 16.0,
            _ => 1.0 + (self.next() >> 12) as f64 / (1u64 << 52) as f64,
        };
        let sign = if self.next().is_multiple_of(2) {
            -1.0
        } else {
            1.0
        };
        let half = k / 2;
        sign * mantissa * 2f64.powi(half) * 2f64.powi(k - half)
    }
}

/// The scale of [`Slow`]: 2^SCALE.
pub const SCALE: usize = 4600;

/// lo ≤ x·2^SCALE ≤ hi.
#[derive(Clone, Debug)]
pub struct Slow {
    pub lo: IBig,
    pub hi: IBig,
}

fn floor_shift(x: &IBig) -> IBig {
    // Shifts of negative big integers round down.
    x >> SCALE
}

impl Slow {
    pub fn of_f64(x: f64) -> Self {
        let (m, t) = f64_to_parts(x);
        let m = m << (SCALE as i32 + t) as usize;
        Self {
            lo: m.clone(),
            hi: m,
        }
    }

    pub fn of_int(i: &IBig) -> Self {
        let m = i << SCALE;
        Self {
            lo: m.clone(),
            hi: m,
        }
    }

    /// The root by Newton's method on integers, from above.
    pub fn sqrt(&self) -> Self {
        let root = |x: &IBig| {
            if *x <= IBig::ZERO {
                return IBig::ZERO;
            }
            let n: IBig = x << SCALE;
            let bits = ilog2(&UBig::try_from(n.clone()).unwrap()).unwrap();
            let mut r = IBig::ONE << (bits / 2 + 1);
            loop {
                let next: IBig = (&r + &n / &r) >> 1usize;
                if next >= r {
                    return r;
                }
                r = next;
            }
        };
        Self {
            lo: root(&self.lo),
            hi: root(&self.hi) + IBig::ONE,
        }
    }

    pub fn div(&self, o: &Self) -> Self {
        assert!(o.lo > IBig::ZERO || o.hi < IBig::ZERO);
        if self.lo == self.hi && o.lo == o.hi {
            let quotient = (&self.lo << SCALE) / &o.lo;
            if &quotient * &o.lo == &self.lo << SCALE {
                return Self {
                    lo: quotient.clone(),
                    hi: quotient,
                };
            }
        }
        let mut ends = Vec::new();
        for a in [&self.lo, &self.hi] {
            for b in [&o.lo, &o.hi] {
                ends.push((a << SCALE) / b);
            }
        }
        let lo = ends.iter().min().unwrap() - IBig::ONE;
        let hi = ends.iter().max().unwrap() + IBig::ONE;
        Self { lo, hi }
    }

    pub fn ldexp(&self, k: i32) -> Self {
        if k >= 0 {
            Self {
                lo: &self.lo << k as usize,
                hi: &self.hi << k as usize,
            }
        } else {
            let k = k.unsigned_abs() as usize;
            let (lo, hi) = (&self.lo >> k, &self.hi >> k);
            let exact = &hi << k == self.hi;
            Self {
                lo,
                hi: if exact { hi } else { hi + IBig::ONE },
            }
        }
    }

    /// Whether the number may lie in [a − e, a + e] for the sum a of `parts`.
    pub fn may_be_within(&self, parts: &[f64], e: f64) -> bool {
        if !e.is_finite() || parts.iter().any(|p| !p.is_finite()) {
            return true;
        }
        let mut a = IBig::ZERO;
        for &p in parts {
            a += Self::of_f64(p).lo;
        }
        let e = Self::of_f64(e).lo;
        self.lo <= &a + &e && self.hi >= a - e
    }

    pub fn cmp_f64(&self, x: f64) -> Option<Ordering> {
        let x = Self::of_f64(x).lo;
        if self.hi < x {
            Some(Ordering::Less)
        } else if self.lo > x {
            Some(Ordering::Greater)
        } else if self.lo == self.hi {
            Some(Ordering::Equal)
        } else {
            None
        }
    }
}

impl Number for Slow {
    fn zero() -> Self {
        Self::of_int(&IBig::ZERO)
    }
    fn from_i64(i: i64) -> Self {
        Self::of_int(&IBig::from(i))
    }
    fn plus(&self, o: &Self) -> Self {
        Self {
            lo: &self.lo + &o.lo,
            hi: &self.hi + &o.hi,
        }
    }
    fn minus(&self, o: &Self) -> Self {
        self.plus(&o.negated())
    }
    fn times(&self, o: &Self) -> Self {
        let ends = [
            &self.lo * &o.lo,
            &self.lo * &o.hi,
            &self.hi * &o.lo,
            &self.hi * &o.hi,
        ];
        let exact = self.lo == self.hi && o.lo == o.hi;
        let lo = floor_shift(ends.iter().min().unwrap());
        let top = ends.iter().max().unwrap();
        let whole = exact && (&lo << SCALE) == *top;
        let hi = if whole {
            lo.clone()
        } else {
            floor_shift(top) + IBig::ONE
        };
        Self { lo, hi }
    }
    fn negated(&self) -> Self {
        Self {
            lo: -&self.hi,
            hi: -&self.lo,
        }
    }
    /// `None` if it is 0 or too close to tell.
    fn sign(&self) -> Option<Sign> {
        if self.lo > IBig::ZERO {
            Some(Sign::Positive)
        } else if self.hi < IBig::ZERO {
            Some(Sign::Negative)
        } else {
            None
        }
    }
}
