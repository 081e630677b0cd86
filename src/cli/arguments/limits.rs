//! `--timeout`, `--max-memory`, `--threads` and `--verbose`.

use std::time::Duration;

use bytesize::ByteSize;
use clap::Args;

/// What long work may use, and what it tells.
#[derive(Debug, Args)]
pub(in crate::cli) struct Limits {
    /// Stop after this many seconds, UNDECIDED.
    #[arg(long, value_name = "SECONDS", value_parser = seconds)]
    pub(in crate::cli) timeout: Option<Duration>,
    /// Stop when the process uses more memory than this (500M, 2G), UNDECIDED.
    #[arg(long, value_name = "SIZE", value_parser = size)]
    pub(in crate::cli) max_memory: Option<ByteSize>,
    /// Threads for exact lifting [default: one for each core]; the result does not depend on it.
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..))]
    pub(in crate::cli) threads: Option<u16>,
    /// Tell the phases, with times, on stderr.
    #[arg(short, long)]
    pub(in crate::cli) verbose: bool,
}

fn seconds(text: &str) -> Result<Duration, String> {
    let seconds: f64 = text.parse().map_err(|_| "expected a number of seconds".to_owned())?;
    Duration::try_from_secs_f64(seconds).map_err(|_| "expected a number of seconds from 0".to_owned())
}

fn size(text: &str) -> Result<ByteSize, String> {
    text.parse().map_err(|_| "expected a size in bytes, such as 500M or 2G".to_owned())
}
