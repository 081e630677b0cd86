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

/// `1.5e-40` as the statement language has it, `1.5/10^40`; `None` for anything else.
fn scientific(text: &str) -> Option<String> {
    let (mantissa, exponent) = text.trim().split_once(['e', 'E'])?;
    let (sign, digits) = match exponent.strip_prefix(['+', '-', '−']) {
        Some(digits) => (if exponent.starts_with('+') { '*' } else { '/' }, digits),
        None => ('*', exponent),
    };
    let decimal = |text: &str| {
        let (whole, rest) = text.split_once('.').unwrap_or((text, "0"));
        let all = |part: &str| !part.is_empty() && part.bytes().all(|byte| byte.is_ascii_digit());
        all(whole) && all(rest)
    };
    let unsigned = mantissa.strip_prefix(['-', '+', '−']).unwrap_or(mantissa);
    let minus = if mantissa.starts_with(['-', '−']) { "-" } else { "" };
    let whole = digits.parse::<u16>().ok().filter(|_| digits.bytes().all(|byte| byte.is_ascii_digit()))?;
    decimal(unsigned).then(|| format!("{minus}{unsigned}{sign}10^{whole}"))
}

/// Reads an exact constant of a field, in the language of statements, in scientific notation, or as this program prints it.
///
/// # Errors
/// With the place in the text.
pub fn read_constant(text: &str, field: &Radicands) -> Result<Polynomial, ConstantError> {
    let ring = Ring { field: field.clone(), variables: Vec::new() };
    let written = scientific(text);
    let spelled = in_statement_language(written.as_deref().unwrap_or(text), &ring)?;
    Ok(Statement::read_constant(&spelled, field, &mut Work::full())?)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn scientific_notation_is_the_number_that_it_spells() {
        let field = Radicands::new(vec![2]).unwrap();
        let read = |text: &str| read_constant(text, &field).map_err(|error| error.to_string());
        for (text, other) in [
            ("1e-40", "1/10^40"),
            ("-2.50E3", "-2500"),
            ("−7e+2", "-700"),
            ("0.125e-0", "1/8"),
            ("+3e1", "30"),
        ] {
            assert_eq!(read(text), read(other), "{text}");
            assert!(read(text).is_ok(), "{text}");
        }
        for text in
            ["e5", "1e", "1e-", "1.e5", ".5e1", "1e5e5", "1e99999999", "1e+-3", "1e٣", "0x1e3", "2*1e3"]
        {
            assert!(read(text).is_err(), "{text}");
        }
    }
}
