//! Long work: Ctrl-C, the clock, memory, threads, and progress.

use std::fmt::Display;
use std::io::{IsTerminal, Write};
use std::time::{Duration, Instant};

use bytesize::ByteSize;

use super::arguments::Limits;
use super::outcome::{Ended, Format, Outcome};
use crate::commands::Failure;
use crate::control::{Control, Why};

/// How often the memory in use is looked at.
const WATCH: Duration = Duration::from_millis(20);

/// Carries out a command under a control that listens to Ctrl-C, the clock and the memory, from the reading of its files to
/// the last word of its report, and shows progress where that is seen.
pub(super) fn under_control(
    limits: &Limits,
    (name, format): (&str, Format),
    command: impl FnOnce(&Control) -> Result<Outcome, Ended>,
) -> Result<Outcome, Failure> {
    let outcome = controlled(limits, |control| {
        command(control).map_err(|ended| ended.unless_stopped(name, control.check()))
    })?;
    Outcome::or_ended(outcome, format)
}

/// Does work under such a control.
fn controlled<T>(limits: &Limits, work: impl FnOnce(&Control) -> T) -> Result<T, Failure> {
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
        return Err(Failure::new("--max-memory: this system does not tell how much memory is in use"));
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
