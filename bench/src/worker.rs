//! A measurement in a process of its own, ended if it takes too long.

use std::ffi::OsString;
use std::io::Read as _;
use std::path::Path;
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

use crate::input::{self, Input};
use crate::measure::{self, Measured, Program};

/// The first argument of a process that measures.
pub const FLAG: &str = "--worker";

/// What to measure.
#[derive(Debug, Clone, Copy)]
pub struct Job<'a> {
    pub program: Program,
    pub input: Input,
    pub n: usize,
    pub both_sides: bool,
    pub data: &'a Path,
}

/// Why there is no measurement.
#[derive(Debug)]
pub enum Failure {
    /// It took longer than this.
    Late(Duration),
    /// It failed; the last that it said.
    Failed(String),
}

/// Has a process measure, and waits for it; at most for twice the limit and a little, because
/// repetitions and the making of the input take time too.
pub fn measure(job: Job<'_>, limit: Duration) -> Result<Measured, Failure> {
    let failed = |e: std::io::Error| Failure::Failed(e.to_string());
    let mut child = Command::new(std::env::current_exe().map_err(failed)?)
        .arg(FLAG)
        .args([job.program.name(), job.input.name(), &job.n.to_string()])
        .arg(if job.both_sides { "both" } else { "interior" })
        .arg(job.data)
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .map_err(failed)?;
    let most = 2 * limit + Duration::from_secs(20);
    let start = Instant::now();
    let status = loop {
        if let Some(status) = child.try_wait().map_err(failed)? {
            break status;
        }
        if start.elapsed() > most {
            child.kill().and_then(|()| child.wait()).map_err(failed)?;
            return Err(Failure::Late(most));
        }
        std::thread::sleep(Duration::from_millis(20));
    };
    let mut said = String::new();
    if status.success() {
        let mut out = child.stdout.take().expect("it is piped");
        out.read_to_string(&mut said).map_err(failed)?;
        serde_json::from_str(&said).map_err(|e| Failure::Failed(e.to_string()))
    } else {
        let mut err = child.stderr.take().expect("it is piped");
        err.read_to_string(&mut said).map_err(failed)?;
        let first = said.lines().map(str::trim).find(|line| !line.is_empty());
        Err(Failure::Failed(format!(
            "{status}: {}",
            first.unwrap_or("it said nothing")
        )))
    }
}

/// The other side: measures and prints.
pub fn serve(arguments: &[OsString]) -> Result<(), String> {
    let [program, input, n, side, data] = arguments else {
        return Err("a worker takes five arguments".to_owned());
    };
    let text = |argument: &OsString| argument.to_string_lossy().into_owned();
    let program = Program::ALL
        .into_iter()
        .find(|p| p.name() == text(program))
        .ok_or("unknown program")?;
    let input = input::named(&text(input)).ok_or("unknown input")?;
    let n = text(n).parse().map_err(|_| "not a size")?;
    let cases = input.cases(n, Path::new(data))?;
    let measured = measure::measure(program, cases, side == "both")?;
    println!(
        "{}",
        serde_json::to_string(&measured).map_err(|e| e.to_string())?
    );
    Ok(())
}
