//! TOML with places, for listing files.

use std::ops::Range;

use toml::Spanned;
use toml::de::{DeTable, DeValue};

use super::error::{ListingFault, Located};
use super::expression::Expression;
use super::{Formula, ListingError, Notation};

/// A value with its place.
pub(super) type Value<'a> = Spanned<DeValue<'a>>;

/// A table of a file, the text of the file at hand.
#[derive(Clone, Copy)]
pub(super) struct Table<'t, 'a> {
    pub(super) text: &'a str,
    table: &'t DeTable<'a>,
    /// Where it stands, (start, end).
    span: (usize, usize),
}

pub(super) fn file_fault(message: String, span: Range<usize>) -> Located {
    (ListingFault::File { message }, span)
}

/// Parses a file; the closure reads its top-level table.
pub(super) fn parse<'a, T>(
    text: &'a str,
    read: impl FnOnce(Table<'_, 'a>) -> Result<T, Located>,
) -> Result<T, ListingError> {
    let parsed = DeTable::parse(text).map_err(|error| {
        let message = format!("not TOML: {}", error.message().lines().next().unwrap_or(""));
        file_fault(message, error.span().unwrap_or(0..0))
    });
    let read = parsed.and_then(|table| {
        let table = table.into_inner();
        read(Table { text, table: &table, span: (0, 0) })
    });
    read.map_err(|located| ListingError::at(text, located))
}

impl<'t, 'a> Table<'t, 'a> {
    /// Where it stands.
    pub(super) fn span(&self) -> Range<usize> {
        self.span.0..self.span.1
    }

    /// Refuses keys that are not in this list.
    pub(super) fn check_keys(&self, known: &[&str]) -> Result<(), Located> {
        match self.table.keys().find(|key| !known.contains(&key.get_ref().as_ref())) {
            None => Ok(()),
            Some(key) => {
                let name: String = key.get_ref().chars().take(40).collect();
                let message =
                    format!("unknown key `{}`, expected one of {}", name.escape_debug(), known.join(", "));
                Err(file_fault(message, key.span()))
            }
        }
    }

    pub(super) fn get(&self, key: &str) -> Option<&'t Value<'a>> {
        self.table.get(key)
    }

    pub(super) fn string(&self, key: &str) -> Result<Option<&'t str>, Located> {
        self.get(key).map(|value| string(value, key)).transpose()
    }

    pub(super) fn flag(&self, key: &str) -> Result<bool, Located> {
        match self.get(key).map(|value| (value, value.get_ref().as_bool())) {
            None => Ok(false),
            Some((_, Some(flag))) => Ok(flag),
            Some((value, None)) => Err(wrong(value, key, "true or false")),
        }
    }

    pub(super) fn required(&self, key: &str, what: &str) -> Result<&'t Value<'a>, Located> {
        let missing = || file_fault(format!("`{key}` is missing, expected {what}"), self.span());
        self.get(key).ok_or_else(missing)
    }

    pub(super) fn table(&self, key: &str) -> Result<Option<Table<'t, 'a>>, Located> {
        let Some(value) = self.get(key) else { return Ok(None) };
        self.as_table(value, key).map(Some)
    }

    fn as_table(&self, value: &'t Value<'a>, key: &str) -> Result<Table<'t, 'a>, Located> {
        let table = value.get_ref().as_table().ok_or_else(|| wrong(value, key, "a table"))?;
        Ok(Table { text: self.text, table, span: (value.span().start, value.span().end) })
    }

    /// The tables of `[[key]]`.
    pub(super) fn tables(&self, key: &str) -> Result<Vec<Table<'t, 'a>>, Located> {
        let Some(value) = self.get(key) else { return Ok(Vec::new()) };
        let items = value.get_ref().as_array().ok_or_else(|| wrong(value, key, "a list of tables"))?;
        items.iter().map(|item| self.as_table(item, key)).collect()
    }

    /// Keys and values in the order of the file.
    pub(super) fn entries(&self) -> Vec<(&'t Spanned<std::borrow::Cow<'a, str>>, &'t Value<'a>)> {
        let mut entries: Vec<_> = self.table.iter().collect();
        entries.sort_by_key(|(key, _)| key.span().start);
        entries
    }

    /// The formulas in a string, with places in the file.
    pub(super) fn formulas(&self, value: &Value<'_>, notation: Notation) -> Result<Vec<Formula>, Located> {
        let contents = string(value, "formulas")?;
        let span = self.contents(value, contents)?;
        // All else blanked, so that places in the string are places in the file.
        let blank = |part: &str| -> String {
            part.bytes().map(|byte| if byte == b'\n' { '\n' } else { ' ' }).collect()
        };
        let (before, after) = (&self.text[..span.start], &self.text[span.end..]);
        notation.read_any(&format!("{}{}{}", blank(before), &self.text[span], blank(after)))
    }

    /// An expression in plain notation.
    pub(super) fn expression(&self, value: &Value<'_>, what: &str) -> Result<Expression, Located> {
        let text = string(value, what)?;
        Expression::read(text, 0..text.len())
            .map_err(|error| file_fault(format!("`{what}`: {}", error.fault), value.span()))
    }

    /// One formula in plain notation; a fault is placed at the value it stands in.
    pub(super) fn formula(&self, text: &str, value: &Value<'_>, what: &str) -> Result<Formula, Located> {
        let read = Notation::Plain.read_located(text);
        let formulas = read.map_err(|(fault, _)| file_fault(format!("`{what}`: {fault}"), value.span()))?;
        match <[Formula; 1]>::try_from(formulas) {
            Ok([formula]) => Ok(formula),
            Err(_) => Err(file_fault(format!("`{what}`: expected one formula"), value.span())),
        }
    }

    /// Where the contents of a string stand, if it is spelled without escapes.
    fn contents(&self, value: &Value<'_>, contents: &str) -> Result<Range<usize>, Located> {
        let span = value.span();
        let found = self.text.get(span.clone()).and_then(|spelled| spelled.find(contents));
        match found {
            Some(offset) => Ok(span.start + offset..span.start + offset + contents.len()),
            None => Err(file_fault("formulas belong between ''' and ''', without escapes".into(), span)),
        }
    }
}

fn wrong(value: &Value<'_>, key: &str, expected: &str) -> Located {
    let found = value.get_ref().type_str();
    file_fault(format!("`{key}`: expected {expected}, found {found}"), value.span())
}

pub(super) fn string<'t>(value: &'t Value<'_>, key: &str) -> Result<&'t str, Located> {
    value.get_ref().as_str().ok_or_else(|| wrong(value, key, "a string in quotes"))
}

/// A list of strings.
pub(super) fn strings<'t>(value: &'t Value<'_>, key: &str) -> Result<Vec<&'t str>, Located> {
    let items = value.get_ref().as_array().ok_or_else(|| wrong(value, key, "a list"))?;
    items.iter().map(|item| string(item, key)).collect()
}

/// A list of natural numbers.
pub(super) fn naturals(value: &Value<'_>, key: &str) -> Result<Vec<u32>, Located> {
    let items = value.get_ref().as_array().ok_or_else(|| wrong(value, key, "a list of indices"))?;
    let natural = |item: &Value<'_>| {
        let number = item.get_ref().as_integer()?;
        u32::from_str_radix(number.as_str(), number.radix()).ok()
    };
    items
        .iter()
        .map(|item| natural(item).ok_or_else(|| wrong(item, key, "an index, an integer from 0")))
        .collect()
}

/// Whether a TOML file holds a statement with a net, or with equations, rather than a listing.
pub fn is_net(text: &str) -> bool {
    DeTable::parse(text).is_ok_and(|table| {
        let table = table.get_ref();
        table.contains_key("net") || table.contains_key("polynomials")
    })
}

/// The convention of the net in a statement file.
pub fn convention_word(text: &str) -> Option<String> {
    let table = DeTable::parse(text).ok()?;
    Some(table.get_ref().get("convention")?.get_ref().as_str()?.to_owned())
}
