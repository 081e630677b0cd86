//! Watching and stopping long work.

use std::cell::RefCell;
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
    /// The memory allowed is used up.
    Memory,
}

impl fmt::Display for Interrupted {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Interrupted::Timeout => "the time allowed is over",
            Interrupted::Cancelled => "interrupted",
            Interrupted::Memory => "the memory allowed is used up",
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
    /// Equations were split into homogeneous parts, and these combined to sparser ones.
    Parts {
        /// Independent changes of sign of variables that map the equations' span to itself.
        symmetries: usize,
        /// Equations before.
        equations: usize,
        /// Equations after.
        parts: usize,
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
    /// A matrix was reduced modulo a prime.
    Reduced {
        /// Degree of the multiples.
        degree: u32,
        /// Rank.
        rank: usize,
        /// New polynomials of lower degree than the multiples they come from.
        fallen: usize,
    },
    /// A polynomial is being computed exactly.
    Lifting {
        /// Multiples that go into it.
        rows: usize,
        /// The degree it has.
        degree: u32,
    },
    /// p-adic digits were computed.
    Digits {
        /// How many for each number.
        digits: usize,
    },
    /// A proof was found and is being made shorter.
    Shortening,
    /// Values of the unknowns are looked for.
    Starts {
        /// Random starts tried.
        tried: usize,
        /// Of so many.
        of: usize,
    },
    /// Values of the unknowns are being improved.
    Descent {
        /// Linear programs solved.
        round: usize,
        /// What is minimised, in the form d·10^e.
        reached: String,
    },
    /// Boxes of the unknowns' space are being excluded.
    Boxes {
        /// Boxes that are excluded.
        excluded: usize,
        /// Boxes known to be left.
        open: usize,
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
            Progress::Parts { symmetries, equations, parts } => {
                write!(f, "sign symmetries: {symmetries}; {equations} equations in {parts} homogeneous parts")
            }
            Progress::Reduced { degree, rank, fallen } => {
                write!(f, "degree {degree}: rank {rank}, {fallen} polynomials of lower degree found")
            }
            Progress::Lifting { rows, degree } => {
                write!(f, "exactly: a combination of {rows} multiples that has degree {degree}")
            }
            Progress::Digits { digits } => write!(f, "exactly: {digits} p-adic digits of each coefficient"),
            Progress::Starts { tried, of } => write!(f, "least squares: start {tried} of {of}"),
            Progress::Descent { round, reached } => write!(f, "linear programs: round {round}, {reached}"),
            Progress::Boxes { excluded, open } => {
                write!(f, "all values of the unknowns: {excluded} boxes excluded, {open} open")
            }
            Progress::Shortening => f.write_str("shortening the proof"),
        }
    }
}

/// The strings by which long work is held: a deadline, flags, an observer.
#[derive(Default)]
pub struct Control<'a> {
    /// When to stop.
    pub deadline: Option<Instant>,
    /// Set from elsewhere (a signal handler) to stop.
    pub cancelled: Option<&'a AtomicBool>,
    /// Set from elsewhere (whoever watches the memory) to stop.
    pub memory: Option<&'a AtomicBool>,
    /// Told of progress.
    pub observer: Option<&'a dyn Fn(&Progress)>,
    /// The last progress, for the account of what was reached.
    pub reached: RefCell<Option<Progress>>,
}

impl Control<'_> {
    /// Whether to go on.
    pub fn check(&self) -> Result<(), Interrupted> {
        if self.cancelled.is_some_and(|flag| flag.load(Ordering::Relaxed)) {
            return Err(Interrupted::Cancelled);
        }
        if self.memory.is_some_and(|flag| flag.load(Ordering::Relaxed)) {
            return Err(Interrupted::Memory);
        }
        match self.deadline {
            Some(deadline) if Instant::now() >= deadline => Err(Interrupted::Timeout),
            _ => Ok(()),
        }
    }

    /// Tells the observer.
    pub fn observe(&self, progress: &Progress) {
        self.reached.replace(Some(progress.clone()));
        if let Some(observer) = self.observer {
            observer(progress);
        }
    }
}
