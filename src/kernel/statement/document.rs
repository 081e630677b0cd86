//! A statement file: the keys it has, and what they mean.

use std::ops::Range;

use super::error::{Located, StatementError, StatementFault, locate};
use super::expression::{Scope, evaluate};
use super::keys::{Document, Value, array, check_name, integer, string, wrong_type};
use super::model::{COORDINATES, Patch, Statement, Subject};
use super::patch::read_patch;
use super::place::is_unprintable;
use crate::exact::{Arithmetic, Limit, Polynomial, Radicands, Work, limits};

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
        let scope = Scope { variables: &[], constants: &[] };
        evaluate(text, &scope, &mut Arithmetic::new(field, work)).map_err(|located| locate(text, located))
    }

    fn read_within(text: &str, work: &mut Work) -> Result<Statement, StatementError> {
        // What the TOML reader makes of a text: at most so much for each byte of it, where tables nest in
        // tables.
        const BYTES: u64 = 640;
        let held = work.held();
        let kept = work.keep_each(text.len(), BYTES).map_err(|limit| (limit.into(), 0..0));
        let of_document = work.held().saturating_sub(held);
        let read = kept.and_then(|()| Document::parse(text)?.statement(work));
        work.release(of_document);
        read.map_err(|located| locate(text, located))
    }

    /// Reads the bytes of a statement file, within the limits of the format and the work left.
    pub fn read_bytes(bytes: &[u8], work: &mut Work) -> Result<Statement, StatementError> {
        limits::STATEMENT_BYTES.check(bytes.len()).map_err(|limit| locate("", (limit.into(), 0..0)))?;
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

impl Document<'_> {
    fn statement(&self, work: &mut Work) -> Result<Statement, Located> {
        self.check_keys()?;
        let title = self.title()?;
        let field = self.field()?;
        let unknowns = self.unknowns()?;
        let constants = self.constants(&unknowns, &mut Arithmetic::new(&field, work))?;
        let scope = Scope { variables: &unknowns, constants: &constants };

        let arithmetic = &mut Arithmetic::new(&field, work);
        let nonzero =
            self.polynomials("nonzero", limits::ASSUMPTIONS, &scope, arithmetic)?.unwrap_or_default();
        if let Some((_, span)) = nonzero.iter().find(|(polynomial, _)| polynomial.is_zero()) {
            return Err((StatementFault::ZeroAssumed, span.clone()));
        }
        let subject = match self.polynomials("polynomials", limits::EQUATIONS, &scope, arithmetic)? {
            Some(polynomials) => {
                Subject::System(polynomials.into_iter().map(|(polynomial, _)| polynomial).collect())
            }
            None => Subject::Patch(self.patch(&scope, arithmetic)?),
        };
        let nonzero = nonzero.into_iter().map(|(polynomial, _)| polynomial).collect();
        let names_surface = self.optional("surface").is_some();
        let hash = String::new();
        let statement = Statement { title, field, unknowns, nonzero, subject, names_surface, hash };
        let fits = limits::STATEMENT_BITS.check(statement.bit_count());
        fits.and_then(|()| statement.hashed(work)).map_err(|limit| (limit.into(), 0..0))
    }

    fn check_keys(&self) -> Result<(), Located> {
        for key in self.table.keys() {
            if !KEYS.split(", ").any(|known| known == key.get_ref().as_ref()) {
                let name = key.get_ref().chars().take(limits::NAME.length()).collect::<String>();
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

    fn title(&self) -> Result<String, Located> {
        let value = self.required("title", "a string that names the statement")?;
        let title = string(value, "a string")?;
        if !limits::TITLE.allows(title.chars().count()) || title.chars().any(is_unprintable) {
            let found = "a longer or unprintable title";
            return Err((StatementFault::WrongType { expected: limits::A_TITLE, found }, value.span()));
        }
        Ok(title.to_owned())
    }

    fn field(&self) -> Result<Radicands, Located> {
        let value = self.required("radicands", "a list of primes, [] for Q")?;
        let mut radicands = Vec::new();
        for item in array(value, "a list of primes")? {
            radicands.push(integer(item, "a radicand", 2, limits::RADICAND.number())?);
        }
        Radicands::new(radicands).map_err(|error| (StatementFault::Radicands(error), value.span()))
    }

    fn unknowns(&self) -> Result<Vec<String>, Located> {
        let value = self.required("unknowns", "a list of names, [] for none")?;
        let items = array(value, "a list of names")?;
        limits::UNKNOWNS.check(items.len()).map_err(|limit| (limit.into(), value.span()))?;
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
        unknowns: &[String],
        arithmetic: &mut Arithmetic<'_>,
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
            let charged = arithmetic.work.charge_search(unknowns.len().saturating_add(100));
            charged.map_err(|limit| (limit.into(), key.span()))?;
            if KEYS.split(", ").any(|known| known == key.get_ref().as_ref()) {
                let expected = "another one: this is a key of the statement, which belongs above [define]";
                return Err((StatementFault::Name { name: key.get_ref().to_string(), expected }, key.span()));
            }
            if unknowns.iter().any(|unknown| unknown == key.get_ref()) {
                return Err((StatementFault::RepeatedName(key.get_ref().to_string()), key.span()));
            }
            let scope = Scope { variables: &[], constants: &constants };
            let constant = self.expression(value, &scope, arithmetic)?;
            constants.push((key.get_ref().to_string(), constant));
        }
        Ok(constants)
    }

    fn polynomials(
        &self,
        key: &'static str,
        at_most: Limit,
        scope: &Scope<'_>,
        arithmetic: &mut Arithmetic<'_>,
    ) -> Result<Option<Vec<LocatedPolynomial>>, Located> {
        let Some(value) = self.table.get(key) else {
            return Ok(None);
        };
        let items = array(value, "a list of expressions")?;
        at_most.check(items.len()).map_err(|limit| (limit.into(), value.span()))?;
        let read = |item: &Value<'_>| Ok((self.expression(item, scope, arithmetic)?, item.span()));
        items.iter().map(read).collect::<Result<_, _>>().map(Some)
    }

    fn patch(&self, scope: &Scope<'_>, arithmetic: &mut Arithmetic<'_>) -> Result<Patch, Located> {
        let coordinates = COORDINATES.map(String::from);
        let surface_scope = Scope { variables: &coordinates, ..*scope };
        read_patch(self, scope, &surface_scope, arithmetic)
    }
}
