//! Exact expressions: numbers, declared symbols, `+ - * / ^`, brackets and `sqrt`, evaluated as they are read.
//!
//! ```text
//! expression = ["-" | "+"] product { ("+" | "-") product }
//! product    = power { ("*" | "/") power }
//! power      = atom [ "^" digits ]
//! atom       = digits [ "." digits ] | name | "sqrt" "(" expression ")" | "(" expression ")"
//! ```
//! A decimal is the exact rational it spells. There is no implicit product; one divides by constants only.

use std::ops::Range;

use super::error::{Located, StatementFault};
use crate::exact::{Arithmetic, Limit, Polynomial, Work, limits, read_natural};

/// The symbols an expression may use.
pub(super) struct Scope<'a> {
    /// Names of variables 0, 1, ….
    pub variables: &'a [String],
    /// Defined constants.
    pub constants: &'a [(String, Polynomial)],
}

/// Evaluates `text`; error spans are offsets in `text`.
pub(super) fn evaluate(
    text: &str,
    scope: &Scope<'_>,
    arithmetic: &mut Arithmetic<'_>,
) -> Result<Polynomial, Located> {
    let mut parser = Parser { text, at: 0, depth: 0, scope, arithmetic };
    let value = parser.expression()?;
    parser.skip_space();
    match parser.rest().chars().next() {
        None => Ok(value),
        Some('^') => parser.unexpected("brackets around a power that is raised to a power"),
        Some(_) => parser.unexpected("an operator (+ - * / ^) or the end"),
    }
}

struct Parser<'a, 'f, 'w> {
    text: &'a str,
    at: usize,
    depth: usize,
    scope: &'a Scope<'a>,
    arithmetic: &'w mut Arithmetic<'f>,
}

impl<'a> Parser<'a, '_, '_> {
    fn rest(&self) -> &'a str {
        self.text.get(self.at..).unwrap_or("")
    }

    fn skip_space(&mut self) {
        let blank =
            self.rest().len().saturating_sub(self.rest().trim_start_matches([' ', '\t', '\n', '\r']).len());
        self.at = self.at.saturating_add(blank);
    }

    fn take(&mut self, token: char) -> bool {
        self.skip_space();
        let found = self.rest().starts_with(token);
        if found {
            self.at = self.at.saturating_add(token.len_utf8());
        }
        found
    }

    /// The word at this place: a run of letters, digits and underscores, or a single other character.
    fn word(&self) -> &'a str {
        let rest = self.rest();
        let run = rest.find(|c: char| !(c.is_ascii_alphanumeric() || c == '_')).unwrap_or(rest.len());
        let length = if run > 0 { run } else { rest.chars().next().map_or(0, char::len_utf8) };
        rest.get(..length).unwrap_or("")
    }

    fn unexpected<T>(&self, expected: &'static str) -> Result<T, Located> {
        let word = self.word();
        let shown: String = word.chars().take(24).collect();
        let found = if word.is_empty() { "the end".into() } else { format!("`{}`", shown.escape_debug()) };
        Err((StatementFault::Syntax { expected, found }, self.at..self.at.saturating_add(word.len())))
    }

    fn located<T>(&self, start: usize, result: Result<T, impl Into<StatementFault>>) -> Result<T, Located> {
        result.map_err(|fault| (fault.into(), start..self.at))
    }

    fn expression(&mut self) -> Result<Polynomial, Located> {
        let start = self.at;
        let negative = self.take('-');
        if !negative {
            self.take('+');
        }
        let first = self.product()?;
        let mut summands = vec![self.signed(negative, first, start)?];
        loop {
            let minus = self.take('-');
            if !minus && !self.take('+') {
                break;
            }
            let next = self.product()?;
            summands.push(self.signed(minus, next, start)?);
        }
        // All at once: a sum that is added up term by term costs its length squared.
        match summands.len() {
            1 => Ok(summands.swap_remove(0)),
            _ => {
                let sum = self.arithmetic.sum(&summands);
                self.checked(start, sum)
            }
        }
    }

    /// The value, or its negative, which is a copy to be paid for.
    fn signed(&mut self, negative: bool, value: Polynomial, start: usize) -> Result<Polynomial, Located> {
        if !negative {
            return Ok(value);
        }
        let negated = self.arithmetic.negated(&value);
        self.located(start, negated)
    }

    fn product(&mut self) -> Result<Polynomial, Located> {
        self.skip_space();
        let start = self.at;
        let mut product = self.power()?;
        loop {
            let divide = self.take('/');
            if !divide && !self.take('*') {
                return Ok(product);
            }
            self.skip_space();
            let operand = self.at;
            let mut factor = self.power()?;
            if divide {
                factor = self.inverse(&factor, operand)?;
            }
            let result = self.arithmetic.product(&product, &factor);
            product = self.checked(start, result)?;
        }
    }

    fn inverse(&mut self, divisor: &Polynomial, start: usize) -> Result<Polynomial, Located> {
        if divisor.is_zero() {
            return self.located(start, Err(StatementFault::DivisionByZero));
        }
        let inverse = self.arithmetic.inverse(divisor);
        let inverse = self.located(start, inverse)?;
        let inverse = self.located(start, inverse.ok_or(StatementFault::DivisionByUnknown))?;
        self.checked(start, Ok(inverse))
    }

    fn power(&mut self) -> Result<Polynomial, Located> {
        self.skip_space();
        let start = self.at;
        let base = self.atom()?;
        if !self.take('^') {
            return Ok(base);
        }
        self.skip_space();
        let digits = self.rest().bytes().take_while(u8::is_ascii_digit).count();
        if digits == 0 {
            return self.unexpected("a natural number as exponent");
        }
        let exponent_start = self.at;
        let exponent = self.rest().get(..digits).and_then(|number| number.parse::<u32>().ok());
        self.at = self.at.saturating_add(digits);
        let Some(exponent) = exponent.filter(|&exponent| limits::EXPONENT.allows(exponent)) else {
            return self.located(exponent_start, Err(limits::EXPONENT));
        };
        let mut power = Polynomial::integer(1);
        for _ in 0..exponent {
            let next = self.arithmetic.product(&power, &base);
            power = self.checked(start, next)?;
        }
        Ok(power)
    }

    fn atom(&mut self) -> Result<Polynomial, Located> {
        self.skip_space();
        let start = self.at;
        match self.rest().chars().next() {
            Some(c) if c.is_ascii_digit() => self.number(),
            Some('(') => self.bracket(),
            Some(c) if c.is_ascii_alphabetic() => {
                let name = self.word();
                self.at = self.at.saturating_add(name.len());
                if name == "sqrt" { self.root(start) } else { self.symbol(name, start) }
            }
            _ => self.unexpected("a number, a symbol, sqrt(…) or a bracket"),
        }
    }

    fn bracket(&mut self) -> Result<Polynomial, Located> {
        self.skip_space();
        if !self.take('(') {
            return self.unexpected("`(`");
        }
        self.depth = self.depth.saturating_add(1);
        self.located(self.at.saturating_sub(1), limits::NESTING.check(self.depth))?;
        let value = self.expression()?;
        self.depth = self.depth.saturating_sub(1);
        if self.take(')') { Ok(value) } else { self.unexpected("`)` or an operator (+ - * / ^)") }
    }

    fn number(&mut self) -> Result<Polynomial, Located> {
        let start = self.at;
        let digits = |text: &str| text.bytes().take_while(u8::is_ascii_digit).count();
        let whole = digits(self.rest());
        let after = self.rest().get(whole..).unwrap_or("");
        let decimals = after.strip_prefix('.').map_or(0, digits);
        if after.starts_with('.') && decimals == 0 {
            self.at = self.at.saturating_add(whole).saturating_add(1);
            return self.unexpected("a digit after the decimal point");
        }
        let length = whole.saturating_add(if decimals > 0 { decimals.saturating_add(1) } else { 0 });
        let spelled: String = self.rest().chars().take(length).filter(|&c| c != '.').collect();
        self.at = self.at.saturating_add(length);
        self.located(start, limits::DIGITS.check(spelled.len()))?;
        let trimmed = spelled.trim_start_matches('0');
        let charged = self.arithmetic.work.charge_digits(spelled.len());
        self.located(start, charged)?;
        let (value, _) = read_natural(if trimmed.is_empty() { "0" } else { trimmed })
            .map_err(|_| (StatementFault::from(limits::DIGITS), start..self.at))?;
        let places = u32::try_from(decimals).unwrap_or(u32::MAX);
        let value = self.arithmetic.work.decimal(&value, places);
        self.kept(start, value.map(Polynomial::rational))
    }

    /// A number or a symbol, which is kept.
    fn kept(&mut self, start: usize, value: Result<Polynomial, Limit>) -> Result<Polynomial, Located> {
        let value = value.and_then(|value| self.arithmetic.charge_copy(&value).map(|()| value));
        self.located(start, value)
    }

    fn root(&mut self, start: usize) -> Result<Polynomial, Located> {
        let value = self.bracket()?;
        let field = self.arithmetic.field;
        let root = self.arithmetic.square_root(&value);
        match self.located(start, root)? {
            Ok(root) => self.checked(start, Ok(root)),
            Err(why) => {
                let argument = self.text.get(start..self.at).unwrap_or("").trim_start_matches("sqrt").trim();
                let mut value: String = argument.chars().take(40).collect();
                if value.len() < argument.len() {
                    value.push('…');
                }
                Err((StatementFault::Root { value, outside: format!("{field}{why}") }, start..self.at))
            }
        }
    }

    fn symbol(&mut self, name: &str, start: usize) -> Result<Polynomial, Located> {
        let names = self.scope.variables.len().saturating_add(self.scope.constants.len());
        let charged = self.arithmetic.work.charge_search(names);
        self.located(start, charged)?;
        let index = self.scope.variables.iter().position(|variable| variable == name);
        if let Some(index) = index.and_then(|index| u16::try_from(index).ok()) {
            return self.kept(start, Ok(Polynomial::variable(index)));
        }
        if let Some((_, value)) = self.scope.constants.iter().find(|(constant, _)| constant == name) {
            // Each use is a copy.
            let copy = self.arithmetic.copied(value);
            return self.located(start, copy);
        }
        let constants = self.scope.constants.iter().map(|(constant, _)| constant);
        let mut known: Vec<&str> = self.scope.variables.iter().chain(constants).map(String::as_str).collect();
        let shown = known.len().min(12);
        if known.len() > shown {
            known.truncate(shown);
            known.push("…");
        }
        let expected =
            if known.is_empty() { "numbers only".into() } else { format!("one of {}", known.join(", ")) };
        let name = name.chars().take(limits::NAME.length()).collect();
        self.located(start, Err(StatementFault::UnknownSymbol { name, expected }))
    }

    /// A result whose numbers a certificate can spell.
    fn checked(&mut self, start: usize, result: Result<Polynomial, Limit>) -> Result<Polynomial, Located> {
        let checked = result.and_then(|value| check_digits(value, self.arithmetic.work));
        self.located(start, checked)
    }
}

/// The value, if its numbers have no more digits than the format allows.
pub(super) fn check_digits(value: Polynomial, work: &mut Work) -> Result<Polynomial, Limit> {
    // 10^4096 has 13607 bits: only numbers of that many bits need a closer look.
    const BITS: u64 = 13_607;
    for number in value.terms().flat_map(|(_, q)| [q.numer(), q.denom()]) {
        if number.bits() > BITS {
            return Err(limits::DIGITS);
        }
        if number.bits() == BITS {
            work.charge_spelling(number)?;
            limits::DIGITS.check(number.magnitude().to_string().len())?;
        }
    }
    Ok(value)
}

/// Moves the place of a fault by the offset of its expression, or to the whole of it if that is not known.
pub(super) fn moved((fault, span): Located, whole: &Range<usize>, offset: Option<usize>) -> Located {
    let Some(offset) = offset else {
        return (fault, whole.clone());
    };
    (fault, span.start.saturating_add(offset)..span.end.saturating_add(offset))
}
