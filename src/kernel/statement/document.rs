//! A statement file as a TOML document: the keys it may have, and typed access with places.

use std::ops::Range;

use toml::Spanned;
use toml::de::{DeTable, DeValue};

use super::error::StatementFault;
use super::patch::read_patch;
use super::source::{Located, is_unprintable, locate};
use super::{COORDINATES, Patch, Statement, StatementError, Subject};
use crate::exact::{Limit, Polynomial, Radicands, Work, limits};

use super::expression::{Scope, evaluate, moved};

/// A value with its place.
pub(super) type Value<'a> = Spanned<DeValue<'a>>;

/// A polynomial with the bytes of the file it was read from.
type LocatedPolynomial = (Polynomial, Range<usize>);

const KEYS: &str =
    "title, radicands, unknowns, nonzero, define, convention, surface, bidegree, net, polynomials";

impl Statement {
    /// Reads a statement file.
    ///
    /// # Errors
    /// [`StatementError`] with line, column, the offending text and what was expected.
    pub fn read(text: &str) -> Result<Statement, StatementError> {
        Statement::read_within(text, &mut Work::full())
    }

    /// Reads an exact constant of a field, in the notation of statement files.
    ///
    /// # Errors
    /// [`StatementError`] with the place in the text.
    pub fn read_constant(
        text: &str,
        field: &Radicands,
        work: &mut Work,
    ) -> Result<Polynomial, StatementError> {
        let scope = Scope { field, variables: &[], constants: &[] };
        evaluate(text, &scope, work).map_err(|located| locate(text, located))
    }

    fn read_within(text: &str, work: &mut Work) -> Result<Statement, StatementError> {
        let read = Document::parse(text).and_then(|document| document.statement(work));
        read.map_err(|located| locate(text, located))
    }

    /// Reads the bytes of a statement file, within the limits of the format and the work left.
    pub fn read_bytes(bytes: &[u8], work: &mut Work) -> Result<Statement, StatementError> {
        if bytes.len() > usize::try_from(limits::STATEMENT_BYTES).unwrap_or(usize::MAX) {
            let limit = Limit::new("bytes in a statement", limits::STATEMENT_BYTES);
            return Err(locate("", (limit.into(), 0..0)));
        }
        match std::str::from_utf8(bytes) {
            Ok(text) => Statement::read_within(text, work),
            Err(error) => {
                let valid = bytes.get(..error.valid_up_to()).unwrap_or(&[]);
                let valid = String::from_utf8_lossy(valid);
                Err(locate(&valid, (StatementFault::Encoding, valid.len()..valid.len())))
            }
        }
    }
}

/// The top-level table with the text it was read from.
pub(super) struct Document<'a> {
    text: &'a str,
    table: DeTable<'a>,
}

impl<'a> Document<'a> {
    fn parse(text: &'a str) -> Result<Self, Located> {
        let table = DeTable::parse(text).map_err(|error| {
            let message = error.message().lines().next().unwrap_or("").to_owned();
            (StatementFault::Toml(message), error.span().unwrap_or(0..0))
        })?;
        Ok(Document { text, table: table.into_inner() })
    }

    fn statement(&self, work: &mut Work) -> Result<Statement, Located> {
        self.check_keys()?;
        let title = self.title()?;
        let field = self.field()?;
        let unknowns = self.unknowns()?;
        let constants = self.constants(&field, &unknowns, work)?;
        let scope = Scope { field: &field, variables: &unknowns, constants: &constants };

        let nonzero = self.polynomials("nonzero", limits::ASSUMPTIONS, &scope, work)?.unwrap_or_default();
        if let Some((_, span)) = nonzero.iter().find(|(polynomial, _)| polynomial.is_zero()) {
            return Err((StatementFault::ZeroAssumed, span.clone()));
        }
        let subject = match self.polynomials("polynomials", limits::EQUATIONS, &scope, work)? {
            Some(polynomials) => {
                Subject::System(polynomials.into_iter().map(|(polynomial, _)| polynomial).collect())
            }
            None => Subject::Patch(self.patch(&scope, work)?),
        };
        let nonzero = nonzero.into_iter().map(|(polynomial, _)| polynomial).collect();
        let names_surface = self.optional("surface").is_some();
        let statement = Statement { title, field, unknowns, nonzero, subject, names_surface };
        if statement.bit_count() > limits::STATEMENT_BITS {
            let limit = Limit::new("bits in the numbers of a statement", limits::STATEMENT_BITS);
            return Err((limit.into(), 0..0));
        }
        Ok(statement)
    }

    fn check_keys(&self) -> Result<(), Located> {
        for key in self.table.keys() {
            if !KEYS.split(", ").any(|known| known == key.get_ref().as_ref()) {
                let name = key.get_ref().chars().take(limits::NAME).collect::<String>();
                let fault =
                    StatementFault::UnknownKey { key: name.escape_debug().to_string(), expected: KEYS };
                return Err((fault, key.span()));
            }
        }
        if self.table.contains_key("polynomials") {
            for key in ["net", "surface", "bidegree", "convention"] {
                if let Some(value) = self.table.get(key) {
                    return Err((StatementFault::Conflict { key, with: "polynomials" }, value.span()));
                }
            }
        }
        Ok(())
    }

    /// A key's value, or the error that it is missing.
    pub(super) fn required(&self, key: &'static str, expected: &'static str) -> Result<&Value<'a>, Located> {
        self.table.get(key).ok_or((StatementFault::MissingKey { key, expected }, 0..0))
    }

    fn title(&self) -> Result<String, Located> {
        let value = self.required("title", "a string that names the statement")?;
        let title = string(value, "a string")?;
        if title.chars().count() > limits::TITLE || title.chars().any(is_unprintable) {
            let expected = "at most 200 characters on one line";
            return Err((
                StatementFault::WrongType { expected, found: "a longer or unprintable title" },
                value.span(),
            ));
        }
        Ok(title.to_owned())
    }

    fn field(&self) -> Result<Radicands, Located> {
        let value = self.required("radicands", "a list of primes, [] for Q")?;
        let mut radicands = Vec::new();
        for item in array(value, "a list of primes")? {
            radicands.push(integer(item, "a radicand", 2, limits::RADICAND)?);
        }
        Radicands::new(radicands).map_err(|error| (StatementFault::Radicands(error), value.span()))
    }

    fn unknowns(&self) -> Result<Vec<String>, Located> {
        let value = self.required("unknowns", "a list of names, [] for none")?;
        let items = array(value, "a list of names")?;
        if items.len() > limits::UNKNOWNS {
            return Err((Limit::new("unknowns", 1024).into(), value.span()));
        }
        let mut unknowns: Vec<String> = Vec::new();
        for item in items {
            let name = string(item, "a name")?;
            check_name(name, item.span())?;
            if unknowns.iter().any(|other| other == name) {
                return Err((StatementFault::RepeatedName(name.to_owned()), item.span()));
            }
            unknowns.push(name.to_owned());
        }
        Ok(unknowns)
    }

    /// The `[define]` table in the order of the file: each constant may use those above it.
    fn constants(
        &self,
        field: &Radicands,
        unknowns: &[String],
        work: &mut Work,
    ) -> Result<Vec<(String, Polynomial)>, Located> {
        let Some(value) = self.table.get("define") else {
            return Ok(Vec::new());
        };
        let table = value.get_ref().as_table().ok_or_else(|| wrong_type(value, "a table of constants"))?;
        let mut entries: Vec<_> = table.iter().collect();
        entries.sort_by_key(|(key, _)| key.span().start);
        let mut constants: Vec<(String, Polynomial)> = Vec::new();
        for (key, value) in entries {
            check_name(key.get_ref(), key.span())?;
            if KEYS.split(", ").any(|known| known == key.get_ref().as_ref()) {
                let expected = "another one: this is a key of the statement, which belongs above [define]";
                return Err((StatementFault::Name { name: key.get_ref().to_string(), expected }, key.span()));
            }
            if unknowns.iter().any(|unknown| unknown == key.get_ref()) {
                return Err((StatementFault::RepeatedName(key.get_ref().to_string()), key.span()));
            }
            let scope = Scope { field, variables: &[], constants: &constants };
            let constant = self.expression(value, &scope, work)?;
            constants.push((key.get_ref().to_string(), constant));
        }
        Ok(constants)
    }

    fn polynomials(
        &self,
        key: &'static str,
        at_most: usize,
        scope: &Scope<'_>,
        work: &mut Work,
    ) -> Result<Option<Vec<LocatedPolynomial>>, Located> {
        let Some(value) = self.table.get(key) else {
            return Ok(None);
        };
        let items = array(value, "a list of expressions")?;
        if items.len() > at_most {
            let fault = Limit::new("polynomials in one list", u64::try_from(at_most).unwrap_or(u64::MAX));
            return Err((fault.into(), value.span()));
        }
        let read = |item: &Value<'a>| Ok((self.expression(item, scope, work)?, item.span()));
        items.iter().map(read).collect::<Result<_, _>>().map(Some)
    }

    fn patch(&self, scope: &Scope<'_>, work: &mut Work) -> Result<Patch, Located> {
        let coordinates = COORDINATES.map(String::from);
        let surface_scope = Scope { variables: &coordinates, ..*scope };
        read_patch(self, scope, &surface_scope, work)
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
        work: &mut Work,
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
        let value = evaluate(&text, scope, work).map_err(|located| moved(located, &span, offset))?;
        work.charge_copy(&value).map_err(|limit| (limit.into(), span))?;
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

fn wrong_type(value: &Value<'_>, expected: &'static str) -> Located {
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

fn check_name(name: &str, span: Range<usize>) -> Result<(), Located> {
    let well_formed = name.starts_with(|c: char| c.is_ascii_alphabetic())
        && name.chars().all(|c| c.is_ascii_alphanumeric() || c == '_')
        && name.len() <= limits::NAME;
    let expected = if !well_formed {
        "a letter followed by at most 31 letters, digits and underscores"
    } else if name == "sqrt" || COORDINATES.contains(&name) {
        "a name other than sqrt and the surface's X, Y, Z, W"
    } else {
        return Ok(());
    };
    let name = name.chars().take(limits::NAME).collect::<String>().escape_debug().to_string();
    Err((StatementFault::Name { name, expected }, span))
}
