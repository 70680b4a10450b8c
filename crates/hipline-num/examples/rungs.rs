//! What the sign of a sum of four c·√d costs on each rung, in nanoseconds.
//!
//! `cargo run --release -p hipline-num --example rungs`

use hipline_num::{Ball, BallDd, IBig, Number, Surd, UBig, round_ball_dd, round_quotient};
use std::hint::black_box;
use std::time::Instant;

const CASES: usize = 1000;

fn main() {
    let mut state = 0x5eed_u64;
    let mut random = |bits: u32| {
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        (state >> (64 - bits)) as i64
    };
    let cases: Vec<[(i64, i64); 4]> = (0..CASES)
        .map(|_| std::array::from_fn(|_| (random(40) - (1 << 39), random(50) + 1)))
        .collect();
    // 2^20·a·√d in four parts that cancel.
    let zeros: Vec<[(i64, i64); 4]> = (0..CASES)
        .map(|_| {
            let (a, b, d) = (random(20) + 1, random(20) + 1, random(30) + 1);
            [(a, d), (b, 4 * d), (-a, 9 * d), (a - b, 4 * d)]
        })
        .collect();
    // The first question below for operands that are ready, as they are in the engine.
    let f64_ready: Vec<[(Ball, Ball); 4]> = cases
        .iter()
        .map(|c| c.map(|(c, d)| (Ball::from_i64(c), Ball::from_i64(d).sqrt())))
        .collect();
    let dd_ready: Vec<[(BallDd, BallDd); 4]> = cases
        .iter()
        .map(|c| c.map(|(c, d)| (BallDd::from_i64(c), BallDd::from_i64(d).sqrt())))
        .collect();
    let surds = |cases: &[[(i64, i64); 4]]| -> Vec<[(Surd, Surd); 4]> {
        let root = |d: i64| Surd::sqrt_of(&UBig::from(d.unsigned_abs()));
        cases
            .iter()
            .map(|c| c.map(|(c, d)| (Surd::from_i64(c), root(d))))
            .collect()
    };
    let (exact, zero) = (surds(&cases), surds(&zeros));
    let integers: Vec<[(Surd, Surd); 4]> = cases
        .iter()
        .map(|c| c.map(|(c, d)| (Surd::from_i64(c), Surd::from_i64(d))))
        .collect();

    time("f64, roots included", &cases, |c| {
        sum(&c.map(|(c, d)| (Ball::from_i64(c), Ball::from_i64(d).sqrt())))
    });
    time("f64", &f64_ready, sum);
    time("double-double, roots included", &cases, |c| {
        sum(&c.map(|(c, d)| (BallDd::from_i64(c), BallDd::from_i64(d).sqrt())))
    });
    time("double-double", &dd_ready, sum);
    time("exact, all integers", &integers, sum);
    time("exact", &exact, sum);
    time("exact, zero", &zero, sum);
    time("exact, product of two such sums", &exact, |c| {
        let x = c[0].1.plus(&c[1].1);
        let y = c[2].1.plus(&c[3].1);
        x.times(&y).minus(&c[0].1).sign()
    });
    time("round a quotient, double-double", &dd_ready, |c| {
        round_ball_dd(&c[0].1.plus(&c[1].1), &c[2].1.plus(&c[3].1), -20)
    });
    time("round a quotient, exact", &exact, |c| {
        round_quotient(&c[0].1.plus(&c[1].1), &c[2].1.plus(&c[3].1), -20)
    });
    time("round a quotient, exact, integers", &integers, |c| {
        round_quotient(&c[0].1.plus(&c[1].1), &c[2].1.plus(&c[3].1), -20)
    });
    let big: Vec<IBig> = cases.iter().map(|c| IBig::from(c[0].0) * c[1].0).collect();
    time("read an integer of 90 bits, f64", &big, Ball::from_int);
    time(
        "read an integer of 90 bits, double-double",
        &big,
        BallDd::from_int,
    );
}

fn sum<T: Number>(c: &[(T, T); 4]) -> Option<hipline_num::Sign> {
    let [a, b, c, d] = c;
    a.0.times(&a.1)
        .plus(&b.0.times(&b.1))
        .plus(&c.0.times(&c.1))
        .plus(&d.0.times(&d.1))
        .sign()
}

/// Prints the least of several averages: noise only ever adds.
fn time<T, R>(what: &str, cases: &[T], f: impl Fn(&T) -> R) {
    let mut best = f64::INFINITY;
    for _ in 0..50 {
        let start = Instant::now();
        for c in cases {
            black_box(f(black_box(c)));
        }
        best = best.min(start.elapsed().as_nanos() as f64 / cases.len() as f64);
    }
    println!("{best:9.1} ns  {what}");
}
