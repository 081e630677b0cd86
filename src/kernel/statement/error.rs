//! What can be wrong with a statement file, and where.

use std::fmt;
use std::ops::Range;

use super::place::Place;
use crate::exact::{Limit, RadicandsError};

/// A mistake in a statement file, with its place.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct StatementError {
    /// Where.
    pub place: Place,
    /// What is wrong.
    pub fault: StatementFault,
}

/// What is wrong, without the place.
#[derive(Debug, Clone, PartialEq, Eq)]
#[allow(missing_docs, reason = "the fields are what the message prints")]
pub enum StatementFault {
    /// Not TOML, in the words of the TOML reader (a duplicate key among them).
    Toml(String),
    /// Not UTF-8.
    Encoding,
    /// A key that the format does not know; the list of those it does.
    UnknownKey { key: String, expected: &'static str },
    /// A key that must be there is missing.
    MissingKey { key: &'static str, expected: &'static str },
    /// A value of the wrong kind.
    WrongType { expected: &'static str, found: &'static str },
    /// Two keys that exclude each other.
    Conflict { key: &'static str, with: &'static str },
    /// The radicands are not distinct primes.
    Radicands(RadicandsError),
    /// `convention` is neither of the two.
    Convention(String),
    /// A name that is not letters, digits and underscores, or is too long, or has a meaning already.
    Name { name: String, expected: &'static str },
    /// The same name twice.
    RepeatedName(String),
    /// A number outside its range.
    Range { what: &'static str, at_least: u32, at_most: u32, found: String },
    /// The net has the wrong number of rows.
    Rows { expected: u64, found: usize },
    /// A row has the wrong number of points.
    Columns { row: usize, expected: u64, found: usize },
    /// A point has not four entries.
    Entries { expected: &'static str, found: usize },
    /// A surface term whose degree differs from the first one's.
    NotHomogeneous { degree: u32, other: u32 },
    /// The surface is the zero polynomial, or a constant.
    NoSurface,
    /// Every weight of the net is the zero polynomial.
    NoDenominator,
    /// An assumption that is the zero polynomial.
    ZeroAssumed,
    /// In an expression something else was expected.
    Syntax { expected: &'static str, found: String },
    /// A symbol nobody declared.
    UnknownSymbol { name: String, expected: String },
    /// A square root outside the field; the field, and why.
    Root { value: String, outside: String },
    /// A division by zero.
    DivisionByZero,
    /// A division by something that contains an unknown.
    DivisionByUnknown,
    /// A limit of the format.
    Limit(Limit),
}

impl From<Limit> for StatementFault {
    fn from(limit: Limit) -> Self {
        StatementFault::Limit(limit)
    }
}

impl fmt::Display for StatementFault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        use StatementFault as Fault;
        match self {
            Fault::Toml(message) => write!(f, "not TOML: {message}"),
            Fault::Encoding => write!(f, "not UTF-8 text"),
            Fault::UnknownKey { key, expected } => {
                write!(f, "unknown key `{key}`, expected one of {expected}")
            }
            Fault::MissingKey { key, expected } => write!(f, "`{key}` is missing, expected {expected}"),
            Fault::WrongType { expected, found } => write!(f, "expected {expected}, found {found}"),
            Fault::Conflict { key, with } => write!(f, "`{key}` and `{with}` exclude each other"),
            Fault::Radicands(error) => error.fmt(f),
            Fault::Convention(found) => write!(
                f,
                "convention `{found}`, expected \"cartesian\" (point x, y, z and weight w) or \"homogeneous\" \
                 (premultiplied wx, wy, wz, w)"
            ),
            Fault::Name { name, expected } => write!(f, "`{name}` cannot be a name, expected {expected}"),
            Fault::RepeatedName(name) => write!(f, "`{name}` is declared twice"),
            Fault::Range { what, at_least, at_most, found } => {
                write!(f, "{what} is {found}, expected an integer from {at_least} to {at_most}")
            }
            Fault::Rows { expected, found } => {
                write!(f, "the net has {found} rows, expected {expected} (i = 0, …, m along u)")
            }
            Fault::Columns { row, expected, found } => {
                write!(
                    f,
                    "row {row} of the net has {found} points, expected {expected} (j = 0, …, n along v)"
                )
            }
            Fault::Entries { expected, found } => {
                write!(f, "a point of {found} entries, expected {expected}")
            }
            Fault::NotHomogeneous { degree, other } => {
                write!(
                    f,
                    "the surface is not homogeneous: it has terms of degree {degree} and of degree {other}"
                )
            }
            Fault::NoSurface => write!(f, "the surface is a constant, expected a polynomial in X, Y, Z, W"),
            Fault::NoDenominator => {
                write!(f, "every weight of the net is zero, expected a patch with a denominator")
            }
            Fault::ZeroAssumed => write!(f, "the zero polynomial is assumed not to vanish"),
            Fault::Syntax { expected, found } => write!(f, "expected {expected}, found {found}"),
            Fault::UnknownSymbol { name, expected } => {
                write!(f, "unknown symbol `{name}`, expected {expected}")
            }
            Fault::Root { value, outside } => write!(f, "the square root of {value} is not in {outside}"),
            Fault::DivisionByZero => write!(f, "division by zero"),
            Fault::DivisionByUnknown => {
                write!(f, "division by an expression with unknowns, expected a constant")
            }
            Fault::Limit(limit) => limit.fmt(f),
        }
    }
}

impl fmt::Display for StatementError {
    /// `12:18: unknown symbol …`, then the line and a caret under the offending text.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}:{}: {}\n{}", self.place.line, self.place.column, self.fault, self.place)
    }
}

impl std::error::Error for StatementError {}

/// A fault with the bytes of the file it concerns.
pub(super) type Located = (StatementFault, Range<usize>);

/// Finds the place of a fault.
pub(super) fn locate(text: &str, (fault, span): Located) -> StatementError {
    StatementError { place: Place::of(text, span), fault }
}
