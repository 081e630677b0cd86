//! Printed formulas: LaTeX and plain text, read without guessing.
//!
//! A listing says `label = expression` for some of the coefficients that `expand` computes. What it says is kept as it
//! stands ([`Expression`]), with places, so that an audit can point at the number that is wrong. The rules by which
//! doubtful spellings are read or refused are in `docs/listings.md`.

mod claim;
mod constant;
mod display;
mod error;
mod evaluate;
mod expression;
mod file;
mod grammar;
mod json;
mod latex;
mod number;
mod pieces;
mod plain;
mod table;
mod token;

pub use claim::{Claim, ClaimKind, Expectation};
pub use constant::{ConstantError, in_statement_language, read_constant};
pub use error::{ListingError, ListingFault};
pub use evaluate::Scope;
pub(crate) use evaluate::evaluate;
pub use expression::{Expression, Formula, Kind, Operator, Signed};
pub use file::{Listing, Meaning, Notation};
pub use json::is_expansion;
pub use table::{convention_word, is_net};
pub use token::Symbol;

use std::ops::Range;

use crate::exact::{Limit, Polynomial, Work};

/// Bytes of a listing.
pub const LISTING_BYTES: u64 = 1 << 20;

impl Notation {
    /// Reads the formulas of a text.
    ///
    /// # Errors
    /// [`ListingError`] at the first thing that cannot be read, or that can be read in two ways.
    pub fn read(self, text: &str) -> Result<Vec<Formula>, ListingError> {
        self.read_located(text).map_err(|located| ListingError::at(text, located))
    }

    fn read_located(self, text: &str) -> Result<Vec<Formula>, error::Located> {
        let tokens = match self {
            Notation::Latex => latex::tokens(text)?,
            Notation::Plain => plain::tokens(text, 0..text.len())?,
        };
        grammar::formulas(text, &tokens)
    }

    /// The same for a file that may have none.
    fn read_any(self, text: &str) -> Result<Vec<Formula>, error::Located> {
        match self.read_located(text) {
            Err((ListingFault::NoFormula, _)) => Ok(Vec::new()),
            read => read,
        }
    }
}

impl Expression {
    /// Reads a part of a text as one expression in plain notation.
    ///
    /// # Errors
    /// As [`Notation::read`].
    pub fn read(text: &str, part: Range<usize>) -> Result<Self, ListingError> {
        let end = part.end;
        let read = plain::tokens(text, part).and_then(|tokens| match tokens.is_empty() {
            true => {
                let found = "nothing".to_owned();
                Err((ListingFault::Expected { expected: "an expression", found }, end..end))
            }
            false => grammar::expression(text, &tokens),
        });
        read.map_err(|located| ListingError::at(text, located))
    }

    /// The value of a formula that was read from `text`.
    ///
    /// # Errors
    /// [`ListingError`] at an unknown name, a root outside K, a division that is none, or a limit.
    pub fn value(&self, text: &str, scope: &Scope, work: &mut Work) -> Result<Polynomial, ListingError> {
        evaluate(self, scope, work).map_err(|located| ListingError::at(text, located))
    }

    /// The value, where places do not matter.
    pub(crate) fn value_within(&self, scope: &Scope, work: &mut Work) -> Result<Polynomial, Option<Limit>> {
        evaluate(self, scope, work).map_err(|(fault, _)| match fault {
            ListingFault::Limit(limit) => Some(limit),
            _ => None,
        })
    }
}

/// Text as UTF-8, within a size.
///
/// # Errors
/// [`ListingError`] where it is neither.
pub fn decode(bytes: &[u8], at_most: u64) -> Result<&str, ListingError> {
    if bytes.len() as u64 > at_most {
        let limit = Limit::new("bytes in a listing", at_most);
        return Err(ListingError::at("", (limit.into(), 0..0)));
    }
    std::str::from_utf8(bytes).map_err(|error| {
        let valid = String::from_utf8_lossy(&bytes[..error.valid_up_to()]).into_owned();
        let fault = ListingFault::Expected {
            expected: "UTF-8 text",
            found: format!("byte {}", error.valid_up_to() + 1),
        };
        ListingError::at(&valid, (fault, valid.len()..valid.len()))
    })
}
