//! Long work: Ctrl-C, the clock, memory, threads, and progress.

use std::io::{IsTerminal, Write};
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};

use bytesize::ByteSize;
use clap::Args;

use super::outcome::Failure;
use crate::elimination::{Control, Progress};

/// How often the memory in use is looked at.
const WATCH: Duration = Duration::from_millis(20);

static CANCELLED: AtomicBool = AtomicBool::new(false);
static MEMORY: AtomicBool = AtomicBool::new(false);

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

/// Does the work under a control that listens to Ctrl-C, the clock and the memory, and shows progress where that is seen.
pub(super) fn under_control<T>(limits: &Limits, work: impl FnOnce(&Control<'_>) -> T) -> Result<T, Failure> {
    ctrlc::set_handler(|| CANCELLED.store(true, Ordering::Relaxed)).map_err(Failure::of)?;
    if let Some(threads) = limits.threads {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(usize::from(threads));
        pool.build_global().map_err(Failure::of)?;
    }
    if let Some(most) = limits.max_memory {
        watch(most)?;
    }
    let start = Instant::now();
    let line = |progress: &Progress| {
        // One line, overwritten: there is no use for it in a file.
        let _ = write!(std::io::stderr().lock(), "\r\x1b[K{progress}");
    };
    let account = |progress: &Progress| {
        let _ = writeln!(std::io::stderr().lock(), "{:9.3} s  {progress}", start.elapsed().as_secs_f64());
    };
    let terminal = std::io::stderr().is_terminal();
    let result = work(&Control {
        deadline: limits.timeout.and_then(|timeout| start.checked_add(timeout)),
        cancelled: Some(&CANCELLED),
        memory: Some(&MEMORY),
        observer: match (limits.verbose, terminal) {
            (true, _) => Some(&account),
            (false, true) => Some(&line),
            (false, false) => None,
        },
        ..Control::default()
    });
    if terminal && !limits.verbose {
        let _ = write!(std::io::stderr().lock(), "\r\x1b[K");
    }
    Ok(result)
}

/// Watches the memory in use from a thread that ends with the process.
fn watch(most: ByteSize) -> Result<(), Failure> {
    let used = || memory_stats::memory_stats().map(|stats| stats.physical_mem as u64);
    if used().is_none() {
        return Err(Failure("--max-memory: this system does not tell how much memory is in use".to_owned()));
    }
    std::thread::spawn(move || {
        while used().is_none_or(|used| used <= most.as_u64()) {
            std::thread::sleep(WATCH);
        }
        MEMORY.store(true, Ordering::Relaxed);
    });
    Ok(())
}
