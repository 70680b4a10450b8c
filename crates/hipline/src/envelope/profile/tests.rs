//! Envelopes of random segments against the minimum, place by place.

use super::{Chart, Count, Meet, Piece, lower_envelope};
use hipline_num::Sign;
use std::cmp::Ordering;

/// `y = slope x + height`.
struct Lines(Vec<[i64; 2]>);

/// A fraction with a positive denominator.
type Fraction = [i64; 2];

fn compare(p: &Fraction, q: &Fraction) -> Ordering {
    (p[0] * q[1]).cmp(&(q[0] * p[1]))
}

impl Chart for Lines {
    type Spot = Fraction;

    fn order(&self, p: &Fraction, q: &Fraction) -> Ordering {
        compare(p, q)
    }

    fn meet(&self, a: u32, b: u32) -> Meet<Fraction> {
        let [[s, h], [t, k]] = [a, b].map(|i| self.0[i as usize]);
        match s.cmp(&t) {
            Ordering::Equal => Meet::Never(Sign::from(k.cmp(&h))),
            Ordering::Less => Meet::At([h - k, t - s], Sign::Positive),
            Ordering::Greater => Meet::At([k - h, s - t], Sign::Negative),
        }
    }
}

impl Lines {
    /// The height of a line at a place, times its denominator.
    fn at(&self, line: u32, x: &Fraction) -> i64 {
        let [s, h] = self.0[line as usize];
        s * x[0] + h * x[1]
    }
}

/// Numbers from a fixed seed.
struct Dice(u64);

impl Dice {
    fn roll(&mut self, most: u64) -> i64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 >> 20) as i64 % most as i64
    }
}

#[test]
fn envelopes_are_minima() {
    for seed in 1..400 {
        let mut dice = Dice(seed * 0x9e37_79b9);
        let count = 1 + dice.roll(30);
        let mut lines: Vec<[i64; 2]> = Vec::new();
        let mut pieces = Vec::new();
        while (pieces.len() as i64) < count {
            let line = [dice.roll(9) - 4, dice.roll(40)];
            let of = lines.iter().position(|l| *l == line).unwrap_or(lines.len());
            if of == lines.len() {
                lines.push(line);
            }
            let from = dice.roll(20);
            let to = from + 1 + dice.roll(12);
            pieces.push(Piece {
                from: [from, 1],
                to: [to, 1],
                of: of as u32,
            });
        }
        let chart = Lines(lines);
        let mut count = Count::default();
        let envelope = lower_envelope(&chart, pieces.clone(), &mut count);
        for pair in envelope.windows(2) {
            assert!(
                compare(&pair[0].to, &pair[1].from).is_le(),
                "seed {seed}: {envelope:?}"
            );
        }
        // Places between all that may happen at thirds, or at crossings of such lines.
        for x in 0..34 * 29 {
            let x = [2 * x + 1, 2 * 29];
            let covers =
                |p: &&Piece<Fraction>| compare(&p.from, &x).is_lt() && compare(&x, &p.to).is_lt();
            let least = pieces
                .iter()
                .filter(covers)
                .map(|p| chart.at(p.of, &x))
                .min();
            let found = envelope.iter().find(covers).map(|p| chart.at(p.of, &x));
            let is_end = |p: &Fraction| compare(p, &x).is_eq();
            if envelope.iter().any(|p| is_end(&p.from) || is_end(&p.to)) {
                continue;
            }
            assert_eq!(found, least, "seed {seed}: at {x:?}");
        }
    }
}
