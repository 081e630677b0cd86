//! The phases of elimination, as they are told.

use std::fmt;

/// What elimination is doing.
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
            Progress::Shortening => f.write_str("shortening the proof"),
        }
    }
}
