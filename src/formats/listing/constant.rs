//! Numbers and polynomials as they are printed, for the reader of statements.
//!
//! That reader is part of what is trusted, and its grammar is small: ASCII only, every product with its operator. What
//! this program prints, `8√3/3 − w²`, is plain notation here and is handed on in the spelling of certificates.

use std::borrow::Cow;

use super::{Expression, ListingError, Scope};
use crate::exact::{Polynomial, Radicands, Ring, Work};
use crate::statement::{Statement, StatementError};

/// Why a text is not an exact number.
#[derive(Debug, thiserror::Error)]
pub enum ConstantError {
    /// In the words of the reader of statements.
    #[error("{0}")]
    Statement(#[from] StatementError),
    /// In the words of the reader of printed formulas.
    #[error("{0}")]
    Printed(#[from] ListingError),
}

impl ConstantError {
    /// What is wrong, without the place.
    pub fn fault(&self) -> String {
        match self {
            ConstantError::Statement(error) => error.fault.to_string(),
            ConstantError::Printed(error) => error.fault.to_string(),
        }
    }
}

/// A text in the language of statements: one in ASCII is that already, any other is read as plain notation.
///
/// # Errors
/// As [`Expression::read`] and [`Expression::value`].
pub fn in_statement_language<'a>(text: &'a str, ring: &Ring) -> Result<Cow<'a, str>, ListingError> {
    if text.is_ascii() {
        return Ok(Cow::Borrowed(text));
    }
    let scope = Scope::of(&ring.field, &ring.variables);
    let value = Expression::read(text, 0..text.len())?.value(text, &scope, &mut Work::full())?;
    Ok(Cow::Owned(ring.spell(&value)))
}

/// Reads an exact constant of a field, in the language of statements or as this program prints it.
///
/// # Errors
/// With the place in the text.
pub fn read_constant(text: &str, field: &Radicands) -> Result<Polynomial, ConstantError> {
    let ring = Ring { field: field.clone(), variables: Vec::new() };
    let spelled = in_statement_language(text, &ring)?;
    Ok(Statement::read_constant(&spelled, field, &mut Work::full())?)
}
