//! The one canonical spelling of a polynomial over K, written and read.
//!
//! `2/3*sqrt(3)*w^2*z - 8*w - 4/3`: terms in the order of [`Monomial`], each `rational*sqrt(n)*powers`, the
//! rational in lowest terms and left out where it is 1 and something follows. The reader accepts exactly
//! what the writer writes. The grammar is in `proofs/FORMAT.md`.

use std::fmt;

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Signed, Zero};

use super::limits::{self, Limit};
use super::monomial::Monomial;
use super::numbers::negated;
use super::polynomial::Polynomial;
use super::radicands::Radicands;
use super::work::{Work, count};

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
        let mut text = String::new();
        // Writing to a String cannot fail.
        let _ = self.write(polynomial, &mut text);
        text
    }

    /// Writes the canonical spelling, term by term.
    ///
    /// # Errors
    /// Those of what is written to.
    pub fn write(&self, polynomial: &Polynomial, to: &mut impl fmt::Write) -> fmt::Result {
        if polynomial.is_zero() {
            to.write_str("0")?;
        }
        for (position, (monomial, coefficient)) in polynomial.terms().enumerate() {
            to.write_str(match (position, coefficient.is_negative()) {
                (0, false) => "",
                (0, true) => "-",
                (_, false) => " + ",
                (_, true) => " - ",
            })?;
            self.write_term(monomial, coefficient, to)?;
        }
        Ok(())
    }

    /// A term without its sign.
    fn write_term(
        &self,
        monomial: &Monomial,
        coefficient: &BigRational,
        to: &mut impl fmt::Write,
    ) -> fmt::Result {
        let (size, denominator) = (coefficient.numer().magnitude(), coefficient.denom());
        let mut between = "";
        if !(size.is_one() && denominator.is_one()) || *monomial == Monomial::one() {
            write!(to, "{size}")?;
            if !denominator.is_one() {
                write!(to, "/{denominator}")?;
            }
            between = "*";
        }
        if monomial.mask() != 0 {
            // A root of another field has no spelling, and what is written is read by nobody.
            let under_root = self.field.under_root(monomial.mask()).ok_or(fmt::Error)?;
            write!(to, "{between}sqrt({under_root})")?;
            between = "*";
        }
        for &(variable, exponent) in monomial.powers() {
            to.write_str(between)?;
            to.write_str(self.variables.get(usize::from(variable)).map_or("", String::as_str))?;
            if exponent > 1 {
                write!(to, "^{exponent}")?;
            }
            between = "*";
        }
        Ok(())
    }

    /// The length that spelling a polynomial has at most.
    pub(crate) fn text_bytes(polynomial: &Polynomial) -> u64 {
        // A name, `^` and up to four digits; signs, a root and its radicands; log₁₀ 2 < 1/3.
        let power = limits::NAME.at_most.saturating_add(6);
        let powers = count(polynomial.power_count()).saturating_mul(power);
        let terms = count(polynomial.term_count()).saturating_mul(48);
        polynomial.bit_count().div_ceil(3).saturating_add(powers).saturating_add(terms)
    }

    /// What spelling a polynomial costs: no more than its memory, and its numbers.
    pub(crate) fn charge_spelling(polynomial: &Polynomial, work: &mut Work) -> Result<(), Limit> {
        work.charge(polynomial.bytes().saturating_mul(10).saturating_add(Work::TERM))?;
        for (_, value) in polynomial.terms() {
            // Short numbers are in the price of the term.
            for number in [value.numer(), value.denom()] {
                if number.bits() > 128 {
                    work.charge_spelling(number)?;
                }
            }
        }
        Ok(())
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
    limits::DIGITS.check(digits).map_err(|limit| SpellingError::Limit { at: 0, limit })?;
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
        // Between two terms there are two spaces.
        let spaces = self.text.bytes().filter(|&byte| byte == b' ').count();
        let length = spaces.div_ceil(2).saturating_add(1);
        let kept = self.work.keep_each(length, 96).and_then(|()| self.work.charge_text(self.text.len()));
        self.limited(kept)?;
        let mut terms: Vec<Term> = Vec::with_capacity(length);
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
            let bytes = Polynomial::bytes_of(&monomial, coefficient.numer(), coefficient.denom());
            let kept = self.work.keep(bytes);
            self.limited(kept)?;
            terms.push((monomial, if negative { negated(coefficient) } else { coefficient }));
            self.limited(limits::TERMS.check(terms.len()))?;
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
        let at_most = limits::DIGITS.length().saturating_add(1);
        let digits = self.rest().bytes().take(at_most).take_while(u8::is_ascii_digit).count();
        // The number is written once more, to compare the text.
        let charged = self.work.charge_digits(digits.saturating_mul(2));
        self.limited(charged)?;
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
        let divisor = self.work.common_divisor(&numerator, &denominator);
        if !self.limited(divisor)?.is_one() || denominator <= BigInt::one() {
            self.at = start;
            return self.fail("a fraction in lowest terms");
        }
        Ok(BigRational::new_raw(numerator, denominator))
    }

    fn root(&mut self) -> Result<u8, SpellingError> {
        let start = self.at;
        let number = self.natural()?;
        let mask = self
            .ring
            .field
            .masks()
            .find(|&mask| mask != 0 && self.ring.field.under_root(mask) == Some(&number));
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
            Ok(0 | 1) => {
                self.at = start;
                self.fail("an exponent of at least 2, or none")
            }
            Ok(exponent) if limits::EXPONENT.allows(exponent) => Ok((variable, exponent)),
            _ => {
                self.at = start;
                self.limited(Err(limits::EXPONENT))
            }
        }
    }
}
