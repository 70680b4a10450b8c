//! Which measurements to make, given those made before.

use serde::Serialize;

use crate::input::Input;
use crate::measure::{Measured, Program};
use crate::options::Options;
use crate::worker::{self, Failure, Job};

/// An input, and what was measured on it.
#[derive(Debug, Clone)]
pub struct Row {
    pub input: Input,
    /// The size asked for; 0 for a file.
    pub n: usize,
    pub hipline: Measured,
    pub rival: Option<Rival>,
}

/// The better of the triangulations.
#[derive(Debug, Clone, Copy, Serialize)]
pub struct Rival {
    pub seconds: f64,
    /// "bulk" or "incremental".
    pub program: &'static str,
}

impl Row {
    /// Microseconds per vertex, of everything.
    pub const fn time(&self) -> f64 {
        self.hipline.per_vertex(1e6 * self.hipline.seconds())
    }

    /// Times the triangulation.
    pub fn ratio(&self) -> Option<f64> {
        self.rival
            .map(|rival| self.hipline.seconds() / rival.seconds)
    }
}

/// Makes all measurements; says on the standard error what it does, and what it leaves out.
pub fn run(options: &Options) -> Vec<Row> {
    let mut rows = Vec::new();
    for &input in &options.inputs {
        if let Some(path) = input.file(&options.data)
            && !path.exists()
        {
            println!("{}: left out, there is no {}", input.name(), path.display());
            continue;
        }
        let sizes = if let Input::Family(_) = input {
            &options.sizes[..]
        } else {
            &[0]
        };
        // What each program took, by vertices.
        let mut before: [Vec<(f64, f64)>; 3] = Default::default();
        for &n in sizes {
            let mut best: Option<Rival> = None;
            let mut hipline = None;
            for (program, before) in Program::ALL.into_iter().zip(&mut before) {
                let Some(measured) = one(options, program, input, n, before) else {
                    continue;
                };
                before.push((measured.vertices as f64, measured.seconds()));
                if program == Program::Hipline {
                    hipline = Some(measured);
                } else if best.is_none_or(|best| measured.seconds() < best.seconds) {
                    best = Some(Rival {
                        seconds: measured.seconds(),
                        program: program.name(),
                    });
                }
            }
            if let Some(hipline) = hipline {
                let row = Row {
                    input,
                    n,
                    hipline,
                    rival: best,
                };
                let ratio = row
                    .ratio()
                    .map_or_else(String::new, |ratio| format!(", {ratio:.1} times spade"));
                eprintln!(
                    "{} {}: {:.2} us per vertex{ratio}",
                    input.name(),
                    hipline.vertices,
                    row.time()
                );
                rows.push(row);
            }
        }
    }
    rows
}

/// One measurement, unless it would take too long.
fn one(
    options: &Options,
    program: Program,
    input: Input,
    n: usize,
    before: &[(f64, f64)],
) -> Option<Measured> {
    let name = format!("{} {n}, {}", input.name(), program.name());
    let limit = options.limit.as_secs_f64();
    let expected = expected(before, n as f64);
    if expected > limit {
        println!(
            "{name}: left out, it would take about {expected:.0} s, and the limit is {limit} s"
        );
        return None;
    }
    let job = Job {
        program,
        input,
        n,
        both_sides: options.both_sides,
        data: &options.data,
    };
    match worker::measure(job, options.limit) {
        Ok(measured) => return Some(measured),
        Err(Failure::Late(most)) => println!("{name}: ended after {} s", most.as_secs()),
        Err(Failure::Failed(reason)) => println!("{name}: failed, {reason}"),
    }
    None
}

/// How many seconds n vertices will take: the time grows on as it grew between the last two
/// sizes, but at least like n.
fn expected(before: &[(f64, f64)], n: f64) -> f64 {
    let power = match before {
        [] => return 0.0,
        [.., (n1, t1), (n2, t2)] if n2 > n1 => ((t2 / t1).ln() / (n2 / n1).ln()).clamp(1.0, 3.0),
        _ => 1.2,
    };
    let &(n2, t2) = before.last().expect("it is not empty");
    t2 * (n / n2).powf(power)
}

#[cfg(test)]
mod tests {
    use super::expected;

    #[test]
    fn growth_goes_on() {
        let seconds = |before: &[(f64, f64)]| expected(before, 1e5).round();
        assert_eq!(seconds(&[]).to_bits(), 0_f64.to_bits(), "nothing is known");
        assert_eq!(
            seconds(&[(1e3, 1.0), (1e4, 100.0)]).to_bits(),
            1e4_f64.to_bits(),
            "quadratic"
        );
        assert_eq!(
            seconds(&[(1e3, 1.0), (1e4, 1.0)]).to_bits(),
            10_f64.to_bits(),
            "at least linear"
        );
    }
}
