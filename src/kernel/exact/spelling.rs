//! The one canonical spelling of a polynomial over K, written and read.
//!
//! `2/3*sqrt(3)*w^2*z - 8*w - 4/3`: terms in the order of [`Monomial`], each `rational*sqrt(n)*powers`, the
//! rational in lowest terms and left out where it is 1 and something follows. The reader accepts exactly
//! what the writer writes. The grammar is in `proofs/FORMAT.md`.

use std::fmt::{self, Write as _};

use num_bigint::BigInt;
use num_integer::Integer;
use num_rational::BigRational;
use num_traits::{One, Signed, Zero};

use super::limits;
use super::monomial::Monomial;
use super::polynomial::Polynomial;
use super::radicands::Radicands;
use super::work::{Limit, Work};

/// The names that polynomials are spelled with: the field and its variables, by index.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Ring {
    /// The field of coefficients.
    pub field: Radicands,
    /// The name of each variable.
    pub variables: Vec<String>,
}

/// Where and why a text is not the canonical spelling of a polynomial.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum SpellingError {
    /// At this byte something else was expected.
    Expected {
        /// Offset in bytes.
        at: usize,
        /// What would have been right.
        expected: &'static str,
        /// What stands there, shortened.
        found: String,
    },
    /// A limit of the format, reached at this byte.
    Limit {
        /// Offset in bytes.
        at: usize,
        /// The limit.
        limit: Limit,
    },
}

impl fmt::Display for SpellingError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            SpellingError::Expected { expected, found, .. } => {
                write!(f, "expected {expected}, found {found}")
            }
            SpellingError::Limit { limit, .. } => limit.fmt(f),
        }
    }
}

impl std::error::Error for SpellingError {}

impl SpellingError {
    /// The same error in a text that has `offset` more bytes in front.
    pub fn moved_by(mut self, offset: usize) -> Self {
        let (SpellingError::Expected { at, .. } | SpellingError::Limit { at, .. }) = &mut self;
        *at = at.saturating_add(offset);
        self
    }

    /// The byte it is about.
    pub fn at(&self) -> usize {
        let (SpellingError::Expected { at, .. } | SpellingError::Limit { at, .. }) = self;
        *at
    }
}

impl Ring {
    /// A polynomial for a message: enough of it to see the difference, and never long to spell.
    pub fn excerpt(&self, polynomial: &Polynomial) -> String {
        const SHOWN: usize = 400;
        if polynomial.term_count() > 1000 || polynomial.bit_count() > 100_000 {
            return format!("a polynomial of {} terms", polynomial.term_count());
        }
        let text = self.spell(polynomial);
        match text.get(..SHOWN) {
            Some(start) => format!("{start}… ({} characters)", text.len()),
            None => text,
        }
    }

    /// The canonical spelling.
    pub fn spell(&self, polynomial: &Polynomial) -> String {
        if polynomial.is_zero() {
            return "0".into();
        }
        let mut text = String::new();
        for (position, (monomial, coefficient)) in polynomial.terms().enumerate() {
            text.push_str(match (position, coefficient.is_negative()) {
                (0, false) => "",
                (0, true) => "-",
                (_, false) => " + ",
                (_, true) => " - ",
            });
            self.spell_term(&mut text, monomial, &coefficient.abs());
        }
        text
    }

    fn spell_term(&self, text: &mut String, monomial: &Monomial, coefficient: &BigRational) {
        let mut factors = Vec::new();
        if !coefficient.is_one() || *monomial == Monomial::one() {
            factors.push(coefficient.to_string());
        }
        if monomial.mask() != 0 {
            factors.push(format!("sqrt({})", self.field.under_root(monomial.mask())));
        }
        for &(variable, exponent) in monomial.powers() {
            let mut factor = self.variables.get(usize::from(variable)).cloned().unwrap_or_default();
            if exponent > 1 {
                let _ = write!(factor, "^{exponent}"); // writing to a String cannot fail
            }
            factors.push(factor);
        }
        text.push_str(&factors.join("*"));
    }

    /// Reads a canonical spelling.
    pub fn read(&self, text: &str, work: &mut Work) -> Result<Polynomial, SpellingError> {
        Reader { ring: self, text, at: 0, work }.polynomial()
    }
}

/// Reads a natural number in canonical decimal spelling from the start of `text`; also the rest.
pub fn read_natural(text: &str) -> Result<(BigInt, &str), SpellingError> {
    let digits = text.bytes().take_while(u8::is_ascii_digit).count();
    let (number, rest) = text.split_at(digits);
    if digits == 0 {
        return Err(expected(0, "a number", text));
    }
    if digits > limits::DIGITS {
        return Err(SpellingError::Limit { at: 0, limit: Limit::digits() });
    }
    if digits > 1 && number.starts_with('0') {
        return Err(expected(0, "a number without leading zeros", text));
    }
    number.parse().map(|value| (value, rest)).map_err(|_| expected(0, "a number", text))
}

fn expected(at: usize, expected: &'static str, rest: &str) -> SpellingError {
    let mut found: String = rest.chars().take(24).collect::<String>().escape_debug().to_string();
    if rest.chars().count() > 24 {
        found.push('…');
    }
    let found = if found.is_empty() { "the end".into() } else { format!("`{found}`") };
    SpellingError::Expected { at, expected, found }
}

/// A term's sign, coefficient and monomial.
type Term = (Monomial, BigRational);

struct Reader<'a, 'w> {
    ring: &'a Ring,
    text: &'a str,
    at: usize,
    work: &'w mut Work,
}

impl<'a> Reader<'a, '_> {
    fn rest(&self) -> &'a str {
        self.text.get(self.at..).unwrap_or("")
    }

    fn fail<T>(&self, message: &'static str) -> Result<T, SpellingError> {
        Err(expected(self.at, message, self.rest()))
    }

    /// A limit reached at this place.
    fn limited<T>(&self, result: Result<T, Limit>) -> Result<T, SpellingError> {
        result.map_err(|limit| SpellingError::Limit { at: self.at, limit })
    }

    fn take(&mut self, token: &str) -> bool {
        let found = self.rest().starts_with(token);
        if found {
            self.at = self.at.saturating_add(token.len());
        }
        found
    }

    fn polynomial(mut self) -> Result<Polynomial, SpellingError> {
        if self.text == "0" {
            return Ok(Polynomial::zero());
        }
        let mut terms: Vec<Term> = Vec::new();
        let mut negative = self.take("-");
        loop {
            let start = self.at;
            let limit = self.work.charge_search(64);
            self.limited(limit)?;
            let (monomial, coefficient) = self.term()?;
            if terms.last().is_some_and(|(last, _)| *last >= monomial) {
                self.at = start;
                return self.fail("terms in canonical order, each power product once");
            }
            terms.push((monomial, if negative { -coefficient } else { coefficient }));
            if terms.len() > limits::TERMS {
                return self.limited(Err(Limit::terms()));
            }
            if self.rest().is_empty() {
                return Ok(Polynomial::from_terms(terms));
            }
            negative = self.take(" - ");
            if !negative && !self.take(" + ") {
                return self.fail("` + `, ` - `, `*` or the end of the line");
            }
        }
    }

    fn term(&mut self) -> Result<Term, SpellingError> {
        let start = self.at;
        let mut coefficient = None;
        if self.rest().starts_with(|c: char| c.is_ascii_digit()) {
            let value = self.rational()?;
            if value.is_zero() {
                self.at = start;
                return self.fail("a non-zero coefficient");
            }
            if !self.take("*") {
                return Ok((Monomial::one(), value));
            }
            if value.is_one() {
                self.at = start;
                return self.fail("a coefficient 1 to be left out");
            }
            coefficient = Some(value);
        }
        let mask = if self.take("sqrt(") { self.root()? } else { 0 };
        let mut powers = Vec::new();
        if mask == 0 || self.take("*") {
            powers.push(self.power(None)?);
            while self.take("*") {
                powers.push(self.power(powers.last().copied())?);
            }
        }
        let end = self.at;
        match Monomial::new(mask, powers) {
            Some(monomial) => {
                self.at = start;
                let monomial = self.limited(monomial)?;
                self.at = end;
                Ok((monomial, coefficient.unwrap_or_else(BigRational::one)))
            }
            None => self.fail("variables in order"),
        }
    }

    fn natural(&mut self) -> Result<BigInt, SpellingError> {
        let start = self.at;
        let (value, rest) = read_natural(self.rest()).map_err(|error| error.moved_by(start))?;
        self.at = self.text.len().saturating_sub(rest.len());
        Ok(value)
    }

    fn rational(&mut self) -> Result<BigRational, SpellingError> {
        let start = self.at;
        let numerator = self.natural()?;
        if !self.take("/") {
            return Ok(BigRational::from_integer(numerator));
        }
        let denominator = self.natural()?;
        let charged = self.work.charge_gcd(&numerator, &denominator);
        self.limited(charged)?;
        if denominator <= BigInt::one() || !numerator.gcd(&denominator).is_one() {
            self.at = start;
            return self.fail("a fraction in lowest terms");
        }
        Ok(BigRational::new_raw(numerator, denominator))
    }

    fn root(&mut self) -> Result<u8, SpellingError> {
        let start = self.at;
        let number = self.natural()?;
        let mask =
            self.ring.field.masks().find(|&mask| mask != 0 && self.ring.field.under_root(mask) == number);
        match mask {
            Some(mask) if self.take(")") => Ok(mask),
            Some(_) => self.fail("`)`"),
            None => {
                self.at = start;
                self.fail("a product of distinct radicands of the field under the root")
            }
        }
    }

    /// A variable, with its exponent if that is not 1; it must come after `previous`.
    fn power(&mut self, previous: Option<(u16, u32)>) -> Result<(u16, u32), SpellingError> {
        let charged = self.work.charge_search(self.ring.variables.len());
        self.limited(charged)?;
        let start = self.at;
        let length = self.rest().find([' ', '*', '^']).unwrap_or(self.rest().len());
        let name = self.rest().get(..length).unwrap_or("");
        let index = self.ring.variables.iter().position(|variable| variable == name);
        let Some(variable) = index.and_then(|index| u16::try_from(index).ok()) else {
            return self.fail("a number, a root or a variable of the statement");
        };
        if previous.is_some_and(|(before, _)| before >= variable) {
            return self.fail("variables in the order of the statement, each once");
        }
        self.at = self.at.saturating_add(length);
        if !self.take("^") {
            return Ok((variable, 1));
        }
        match u32::try_from(self.natural()?) {
            Ok(exponent) if (2..=limits::DEGREE).contains(&exponent) => Ok((variable, exponent)),
            Ok(0 | 1) => {
                self.at = start;
                self.fail("an exponent of at least 2, or none")
            }
            _ => {
                self.at = start;
                self.limited(Err(Limit::new("in an exponent", limits::DEGREE.into())))
            }
        }
    }
}
