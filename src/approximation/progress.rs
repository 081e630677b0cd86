//! The phases of approximation, as they are told.

use std::fmt;

/// What approximation is doing.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) enum Progress {
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
            Progress::Starts { tried, of } => write!(f, "least squares: start {tried} of {of}"),
            Progress::Descent { round, reached } => write!(f, "linear programs: round {round}, {reached}"),
            Progress::Boxes { excluded, open } => {
                write!(f, "all values of the unknowns: {excluded} boxes excluded, {open} open")
            }
        }
    }
}
