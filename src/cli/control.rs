//! Long work: Ctrl-C, the clock, memory, threads, and progress.

use std::fmt::Display;
use std::io::{IsTerminal, Write};
use std::time::{Duration, Instant};

use bytesize::ByteSize;
use clap::Args;

use super::arguments::{Format, to_json};
use super::outcome::{Failure, Outcome, Status};
use crate::control::{Control, Interrupted, Why};
use crate::exact::limits;
use crate::report::stopped::stopped_by;

/// How often the memory in use is looked at.
const WATCH: Duration = Duration::from_millis(20);

/// What long work may use, and what it tells.
#[derive(Debug, Args)]
pub(super) struct Limits {
    /// Stop after this many seconds, UNDECIDED.
    #[arg(long, value_name = "SECONDS", value_parser = seconds)]
    timeout: Option<Duration>,
    /// Stop when the process uses more memory than this (500M, 2G), UNDECIDED.
    #[arg(long, value_name = "SIZE", value_parser = size)]
    max_memory: Option<ByteSize>,
    /// Threads for exact lifting [default: one for each core]; the result does not depend on it.
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..))]
    threads: Option<u16>,
    /// Tell the phases, with times, on stderr.
    #[arg(short, long)]
    verbose: bool,
}

fn seconds(text: &str) -> Result<Duration, String> {
    let seconds: f64 = text.parse().map_err(|_| "expected a number of seconds".to_owned())?;
    Duration::try_from_secs_f64(seconds).map_err(|_| "expected a number of seconds from 0".to_owned())
}

fn size(text: &str) -> Result<ByteSize, String> {
    text.parse().map_err(|_| "expected a size in bytes, such as 500M or 2G".to_owned())
}

/// Carries out a command under a control that listens to Ctrl-C, the clock and the memory, from the reading of its files to
/// the last word of its report, and shows progress where that is seen.
pub(super) fn under_control(
    limits: &Limits,
    (name, format): (&str, Format),
    command: impl FnOnce(&Control) -> Result<Outcome, Failure>,
) -> Result<Outcome, Failure> {
    controlled(limits, |control| match (command(control), control.check()) {
        // What the trusted part could not finish because it was stopped is no error.
        (Err(Failure(message)), Err(why)) if message.contains(&limits::ENDED.to_string()) => {
            stopped(name, format, &why)
        }
        (outcome, _) => outcome,
    })?
}

/// The work was stopped before anything was established.
pub(super) fn stopped(name: &str, format: Format, why: &Interrupted) -> Result<Outcome, Failure> {
    let text = match format {
        Format::Json => to_json(&serde_json::json!({
            "verdict": "UNDECIDED", "name": name, "reason": why.to_string(), "stopped": stopped_by(why.why),
        }))?,
        Format::Text | Format::Latex => format!("UNDECIDED  {name}: {why}\n"),
    };
    Ok(Outcome { text, status: Status::Undecided })
}

/// Does work under such a control.
pub(super) fn controlled<T>(limits: &Limits, work: impl FnOnce(&Control) -> T) -> Result<T, Failure> {
    if let Some(threads) = limits.threads {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(usize::from(threads));
        pool.build_global().map_err(Failure::of)?;
    }
    let start = Instant::now();
    let control = match limits.timeout.and_then(|timeout| start.checked_add(timeout)) {
        Some(deadline) => Control::until(deadline),
        None => Control::default(),
    };
    let terminal = std::io::stderr().is_terminal();
    let control = match (limits.verbose, terminal) {
        (true, _) => control.observed(move |progress| account(start, progress)),
        (false, true) => control.observed(line),
        (false, false) => control,
    };
    let stopper = control.clone();
    ctrlc::set_handler(move || stopper.stop(Why::Interrupt)).map_err(Failure::of)?;
    if let Some(most) = limits.max_memory {
        watch(most, used_memory, control.clone())?;
    }
    let result = work(&control);
    if terminal && !limits.verbose {
        let _ = write!(std::io::stderr().lock(), "\r\x1b[K");
    }
    Ok(result)
}

/// One line, overwritten: there is no use for it in a file.
fn line(progress: &dyn Display) {
    let _ = write!(std::io::stderr().lock(), "\r\x1b[K{progress}");
}

fn account(start: Instant, progress: &dyn Display) {
    let _ = writeln!(std::io::stderr().lock(), "{:9.3} s  {progress}", start.elapsed().as_secs_f64());
}

fn used_memory() -> Option<u64> {
    memory_stats::memory_stats().map(|stats| stats.physical_mem as u64)
}

/// Looks at the memory in use at once, and then from a thread that ends with the process.
fn watch(most: ByteSize, used: fn() -> Option<u64>, control: Control) -> Result<(), Failure> {
    let Some(now) = used() else {
        return Err(Failure("--max-memory: this system does not tell how much memory is in use".to_owned()));
    };
    if now > most.as_u64() {
        control.stop(Why::Memory);
        return Ok(());
    }
    std::thread::spawn(move || {
        while used().is_none_or(|used| used <= most.as_u64()) {
            std::thread::sleep(WATCH);
        }
        control.stop(Why::Memory);
    });
    Ok(())
}
