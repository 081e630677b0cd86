//! Typed access to a TOML document, with places.

use std::ops::Range;

use toml::Spanned;
use toml::de::{DeTable, DeValue};

use super::error::{Located, StatementFault};
use super::expression::{Scope, evaluate, moved};
use super::model::COORDINATES;
use crate::exact::{Arithmetic, Polynomial, limits};

/// A value with its place.
pub(super) type Value<'a> = Spanned<DeValue<'a>>;

/// The top-level table with the text it was read from.
pub(super) struct Document<'a> {
    text: &'a str,
    pub(super) table: DeTable<'a>,
}

impl<'a> Document<'a> {
    pub(super) fn parse(text: &'a str) -> Result<Self, Located> {
        let table = DeTable::parse(text).map_err(|error| {
            let message = error.message().lines().next().unwrap_or("").to_owned();
            (StatementFault::Toml(message), error.span().unwrap_or(0..0))
        })?;
        Ok(Document { text, table: table.into_inner() })
    }

    /// A key's value, or the error that it is missing.
    pub(super) fn required(&self, key: &'static str, expected: &'static str) -> Result<&Value<'a>, Located> {
        self.table.get(key).ok_or((StatementFault::MissingKey { key, expected }, 0..0))
    }

    /// An optional key.
    pub(super) fn optional(&self, key: &str) -> Option<&Value<'a>> {
        self.table.get(key)
    }

    /// A string read as an expression, or an integer.
    pub(super) fn expression(
        &self,
        value: &Value<'a>,
        scope: &Scope<'_>,
        arithmetic: &mut Arithmetic<'_>,
    ) -> Result<Polynomial, Located> {
        let span = value.span();
        let text = match value.get_ref() {
            DeValue::String(text) => text.clone().into_owned(),
            DeValue::Integer(number) => {
                let small = i64::from_str_radix(number.as_str(), number.radix()).ok();
                small
                    .ok_or_else(|| wrong_type(value, "an integer of 64 bits, or quotes around it"))?
                    .to_string()
            }
            _ => return Err(wrong_type(value, "an expression in quotes, or an integer")),
        };
        let offset = self.start_of_contents(&span, &text);
        let value = evaluate(&text, scope, arithmetic).map_err(|located| moved(located, &span, offset))?;
        arithmetic.charge_copy(&value).map_err(|limit| (limit.into(), span))?;
        Ok(value)
    }

    /// Where a string's contents start, if it is spelled without escapes.
    fn start_of_contents(&self, span: &Range<usize>, contents: &str) -> Option<usize> {
        let spelled = self.text.get(span.clone())?;
        let quotes = ["\"\"\"", "'''", "\"", "'"].into_iter().find(|quotes| spelled.starts_with(quotes));
        let quotes = quotes.unwrap_or("");
        let inside = spelled.strip_prefix(quotes)?.strip_suffix(quotes)?;
        // A newline right after three quotes is not part of the string.
        let plain =
            inside == contents || (quotes.len() == 3 && inside.trim_start_matches(['\r', '\n']) == contents);
        let skipped = spelled.len().checked_sub(quotes.len())?.checked_sub(contents.len())?;
        if plain { span.start.checked_add(skipped) } else { None }
    }
}

pub(super) fn wrong_type(value: &Value<'_>, expected: &'static str) -> Located {
    (StatementFault::WrongType { expected, found: value.get_ref().type_str() }, value.span())
}

pub(super) fn string<'a>(value: &'a Value<'_>, expected: &'static str) -> Result<&'a str, Located> {
    value.get_ref().as_str().ok_or_else(|| wrong_type(value, expected))
}

pub(super) fn array<'a, 'b>(
    value: &'a Value<'b>,
    expected: &'static str,
) -> Result<&'a [Value<'b>], Located> {
    value.get_ref().as_array().map(|items| &**items).ok_or_else(|| wrong_type(value, expected))
}

pub(super) fn integer(
    value: &Value<'_>,
    what: &'static str,
    at_least: u32,
    at_most: u32,
) -> Result<u32, Located> {
    let number = value.get_ref().as_integer().ok_or_else(|| wrong_type(value, "an integer"))?;
    let parsed = u32::from_str_radix(number.as_str(), number.radix()).ok();
    parsed.filter(|parsed| (at_least..=at_most).contains(parsed)).ok_or_else(|| {
        let found = number.to_string().chars().take(24).collect();
        (StatementFault::Range { what, at_least, at_most, found }, value.span())
    })
}

pub(super) fn check_name(name: &str, span: Range<usize>) -> Result<(), Located> {
    let well_formed = name.starts_with(|c: char| c.is_ascii_alphabetic())
        && name.chars().all(|c| c.is_ascii_alphanumeric() || c == '_')
        && limits::NAME.allows(name.len());
    let expected = if !well_formed {
        limits::A_NAME
    } else if name == "sqrt" || COORDINATES.contains(&name) {
        "a name other than sqrt and the surface's X, Y, Z, W"
    } else {
        return Ok(());
    };
    let name = name.chars().take(limits::NAME.length()).collect::<String>().escape_debug().to_string();
    Err((StatementFault::Name { name, expected }, span))
}
