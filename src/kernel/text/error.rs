//! What can be wrong with the text of a certificate, and where.

use std::fmt;

use crate::exact::{Limit, SpellingError};

/// A certificate that cannot be read, with its place. Lines and columns count from 1; columns in bytes.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct CertificateError {
    /// The line.
    pub line: usize,
    /// The column.
    pub column: usize,
    /// What is wrong.
    pub fault: CertificateFault,
}

/// What is wrong, without the place.
#[derive(Debug, Clone, PartialEq, Eq)]
#[allow(missing_docs, reason = "the fields are what the message prints")]
pub enum CertificateFault {
    /// Nothing in the file.
    Empty,
    /// The file ends before its `end` line.
    Truncated { expected: &'static str },
    /// The last line has no newline.
    NoFinalNewline,
    /// Text after the `end` line.
    AfterEnd,
    /// A carriage return: lines end with a single newline.
    CarriageReturn,
    /// Neither printable ASCII nor a newline.
    Character,
    /// A version of the format that this checker does not know; those that it does.
    Version { found: u32, known: &'static str },
    /// The line is not what belongs there.
    Line { expected: &'static str, found: String },
    /// A step out of turn.
    StepNumber { expected: u64, found: String },
    /// The count in the `end` line is wrong.
    Count { expected: u64, found: String },
    /// A premise that comes before its predecessor or twice.
    PremiseOrder { premise: String, previous: String },
    /// A step that is not earlier.
    LaterStep { step: String },
    /// An index with leading zeros, out of range, or no number.
    Index { found: String },
    /// A multiplier 0.
    ZeroMultiplier,
    /// A value with an unknown in it, or with a Rabinowitsch variable.
    NotConstant,
    /// A polynomial not in its canonical spelling.
    Spelling(SpellingError),
    /// Not a rational number.
    NotRational,
    /// A point that is not in the unit square.
    OutsideSquare,
    /// Not a decimal, or not with that many places.
    Decimal { places: u32, found: String },
    /// Not a binary tree in preorder.
    Tree,
    /// The last line of an argument by subdivision does not fit the text before it.
    Seal { expected: String, found: String },
    /// A limit of the format.
    Limit(Limit),
    /// Not the bytes that the writer would write.
    NotCanonical,
}

impl From<Limit> for CertificateFault {
    fn from(limit: Limit) -> Self {
        CertificateFault::Limit(limit)
    }
}

impl fmt::Display for CertificateFault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        use CertificateFault as Fault;
        match self {
            Fault::Empty => write!(f, "the certificate is empty"),
            Fault::Truncated { expected } => write!(f, "the certificate ends here, expected {expected}"),
            Fault::NoFinalNewline => write!(f, "the last line has no newline"),
            Fault::AfterEnd => write!(f, "text after the end line"),
            Fault::CarriageReturn => {
                write!(f, "carriage return, expected lines that end with a newline alone")
            }
            Fault::Character => write!(f, "a character that is not printable ASCII"),
            Fault::Version { found, known } => {
                write!(
                    f,
                    "version {found} of the format, and this checker knows the versions {known}; a newer one may know it"
                )
            }
            Fault::Line { expected, found } => write!(f, "expected {expected}, found `{found}`"),
            Fault::StepNumber { expected, found } => write!(f, "expected step {expected}, found `{found}`"),
            Fault::Count { expected, found } => write!(f, "expected end {expected}, found `{found}`"),
            Fault::PremiseOrder { premise, previous } => {
                write!(f, "premise {premise} after {previous}, expected premises in order, each once")
            }
            Fault::LaterStep { step } => write!(f, "premise {step} is not an earlier step"),
            Fault::Index { found } => {
                write!(f, "expected an index from 0 to 4294967295 without leading zeros, found `{found}`")
            }
            Fault::ZeroMultiplier => write!(f, "a multiplier 0, expected the premise to be left out"),
            Fault::NotConstant => write!(f, "expected a constant of the field"),
            Fault::Spelling(error) => error.fmt(f),
            Fault::NotRational => write!(f, "expected a rational number"),
            Fault::OutsideSquare => write!(f, "a point outside the unit square"),
            Fault::Decimal { places, found } => {
                write!(f, "expected a decimal with {places} places, found `{found}`")
            }
            Fault::Tree => write!(
                f,
                "expected a binary tree in preorder: `h` for a box that is halved, `.` for one that is not"
            ),
            Fault::Seal { expected, found } => write!(f, "expected `{expected}`, found `{found}`"),
            Fault::Limit(limit) => limit.fmt(f),
            Fault::NotCanonical => write!(f, "not the canonical spelling of this certificate"),
        }
    }
}

impl fmt::Display for CertificateError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}:{}: {}", self.line, self.column, self.fault)
    }
}

impl std::error::Error for CertificateError {}
