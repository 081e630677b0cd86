//! Watching and stopping long work.

use std::fmt;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Instant;

/// Why work stopped early.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Interrupted {
    /// The time allowed is over.
    Timeout,
    /// The user asked.
    Cancelled,
}

impl fmt::Display for Interrupted {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Interrupted::Timeout => "the time allowed is over",
            Interrupted::Cancelled => "interrupted",
        })
    }
}

/// What is going on.
#[derive(Debug, Clone, PartialEq, Eq)]
#[non_exhaustive]
pub enum Progress {
    /// Linear equations were solved.
    Linear {
        /// Variables eliminated so far.
        solved: usize,
        /// Equations that are left.
        left: usize,
    },
    /// A matrix is being reduced modulo a prime.
    Matrix {
        /// Degree of the multiples.
        degree: u32,
        /// Rows.
        rows: usize,
        /// Columns.
        columns: usize,
    },
    /// A polynomial is being computed exactly.
    Lifting {
        /// Multiples that go into it.
        rows: usize,
    },
}

impl fmt::Display for Progress {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Progress::Linear { solved, left } => {
                write!(f, "linear equations: {solved} variables eliminated, {left} equations left")
            }
            Progress::Matrix { degree, rows, columns } => {
                write!(f, "degree {degree}: {rows} multiples in {columns} monomials")
            }
            Progress::Lifting { rows } => write!(f, "computing a combination of {rows} multiples exactly"),
        }
    }
}

/// The strings by which long work is held: a deadline, a flag, an observer.
#[derive(Clone, Copy, Default)]
pub struct Control<'a> {
    /// When to stop.
    pub deadline: Option<Instant>,
    /// Set from elsewhere (a signal handler) to stop.
    pub cancelled: Option<&'a AtomicBool>,
    /// Told of progress.
    pub observer: Option<&'a dyn Fn(&Progress)>,
}

impl Control<'_> {
    /// Whether to go on.
    pub fn check(&self) -> Result<(), Interrupted> {
        if self.cancelled.is_some_and(|flag| flag.load(Ordering::Relaxed)) {
            return Err(Interrupted::Cancelled);
        }
        match self.deadline {
            Some(deadline) if Instant::now() >= deadline => Err(Interrupted::Timeout),
            _ => Ok(()),
        }
    }

    /// Tells the observer.
    pub fn observe(&self, progress: &Progress) {
        if let Some(observer) = self.observer {
            observer(progress);
        }
    }
}
