//! Tokens → formulas.
//!
//! ```text
//! listing    = formula { (Separator | Row) formula }
//! formula    = label "=" { label "=" } expression
//! expression = [sign] product { sign product }
//! product    = power { "*" power | "/" power | power }
//! power      = atom [ "^" exponent ]
//! atom       = number | name | root argument | fraction argument argument | bracket
//! ```
//! What a printed formula leaves open is refused, see the variants of [`ListingFault`].

use std::ops::Range;

use num_rational::BigRational;
use num_traits::{ToPrimitive, Zero};

use super::error::{ListingFault, Located, shown};
use super::expression::{Expression, Formula, Kind as Part, Operator, Signed};
use super::pieces::pieces;
use super::token::{Bracket, Kind, Token};
use crate::exact::{Limit, limits};

/// Reads all formulas; `text` is what the tokens were read from, for messages.
pub(super) fn formulas(text: &str, tokens: &[Token]) -> Result<Vec<Formula>, Located> {
    let mut formulas = Vec::new();
    for piece in pieces(tokens) {
        let mut parser = Parser { text, tokens: piece, at: 0, depth: 0 };
        formulas.push(parser.formula()?);
    }
    match formulas.is_empty() {
        true => Err((ListingFault::NoFormula, 0..text.len().min(1))),
        false => Ok(formulas),
    }
}

/// Reads a formula without a label.
pub(super) fn expression(text: &str, tokens: &[Token]) -> Result<Expression, Located> {
    let mut parser = Parser { text, tokens, at: 0, depth: 0 };
    let expression = parser.expression()?;
    match parser.peek() {
        None => Ok(expression),
        Some(_) => parser.expected("an operator or the end"),
    }
}

struct Parser<'a> {
    text: &'a str,
    tokens: &'a [Token],
    at: usize,
    depth: usize,
}

impl<'a> Parser<'a> {
    /// The next token that is no row break.
    fn peek(&self) -> Option<&'a Token> {
        self.tokens[self.at..].iter().find(|token| !token.kind.is_layout())
    }

    fn next(&mut self) -> Option<&'a Token> {
        let token = self.peek()?;
        self.skip_rows();
        self.at += 1;
        Some(token)
    }

    fn skip_rows(&mut self) {
        while self.tokens.get(self.at).is_some_and(|token| token.kind.is_layout()) {
            self.at += 1;
        }
    }

    fn take(&mut self, kind: &Kind) -> bool {
        let found = self.peek().is_some_and(|token| token.kind == *kind);
        if found {
            self.next();
        }
        found
    }

    /// The bytes of the next token, or of the end.
    fn place(&self) -> Range<usize> {
        let printed = self.tokens.iter().rev().find(|token| !token.kind.is_layout());
        let end = printed.map_or(0, |token| token.span.end);
        self.peek().map_or(end..end, |token| token.span.clone())
    }

    fn expected<T>(&self, expected: &'static str) -> Result<T, Located> {
        let span = self.place();
        let found = match self.peek() {
            Some(token) if !token.kind.is_layout() => shown(&self.text[token.span.clone()]),
            _ => "the end of the formula".into(),
        };
        Err((ListingFault::Expected { expected, found }, span))
    }

    fn formula(&mut self) -> Result<Formula, Located> {
        if self.peek().is_some_and(|token| token.kind == Kind::Separator) {
            self.next();
        }
        let mut labels = Vec::new();
        loop {
            let start = self.at;
            let Some(Token { kind: Kind::Name(symbol), span }) = self.peek() else {
                if labels.is_empty() {
                    return self.expected("a label, as in a_{1} = …");
                }
                break;
            };
            self.next();
            if !self.take(&Kind::Equals) {
                // Not a label: the expression starts here.
                if labels.is_empty() {
                    return self.expected("`=` after the label");
                }
                self.at = start;
                break;
            }
            labels.push((symbol.clone(), span.clone()));
        }
        let expression = self.expression()?;
        match self.peek() {
            None => Ok(Formula { labels, expression }),
            Some(Token { kind: Kind::Separator, .. }) => {
                self.next();
                match self.peek() {
                    None => Ok(Formula { labels, expression }),
                    Some(_) => self.expected("a new formula, `label = …`, after a comma"),
                }
            }
            Some(_) => self.expected("an operator, or the end of the formula"),
        }
    }

    fn expression(&mut self) -> Result<Expression, Located> {
        let start = self.place().start;
        let mut terms = Vec::new();
        loop {
            let (minus, sign) = match self.peek() {
                Some(Token { kind: Kind::Sign { minus }, span }) => {
                    self.next();
                    (*minus, span.clone())
                }
                _ if terms.is_empty() => (false, start..start),
                _ => break,
            };
            if let Some(Token { kind: Kind::Sign { .. }, span }) = self.peek() {
                return Err((ListingFault::TwoSigns, span.clone()));
            }
            terms.push(Signed { minus, sign, term: self.product()? });
        }
        let end = terms.last().map_or(start, |last| last.term.span.end);
        if let [Signed { minus: false, sign, .. }] = terms.as_slice()
            && sign.is_empty()
        {
            return Ok(terms.remove(0).term);
        }
        Ok(Expression { kind: Part::Sum(terms), span: start..end })
    }

    fn product(&mut self) -> Result<Expression, Located> {
        let mut first = self.power(None)?;
        let mut factors: Vec<(Operator, Expression)> = Vec::new();
        let mut slashed = false;
        loop {
            let broken = self.tokens.get(self.at).is_some_and(|token| token.kind.is_layout());
            match self.peek().map(|token| &token.kind) {
                Some(Kind::Times) => {
                    self.next();
                    factors.push((Operator::Times, self.power(None)?));
                    slashed = false;
                }
                Some(Kind::Slash) => {
                    if slashed {
                        return Err((ListingFault::TwoSlashes, self.place()));
                    }
                    self.next();
                    let divisor = self.power(None)?;
                    match literal_fraction(&first, &factors, &divisor) {
                        Some(fraction) => first = fraction,
                        None => factors.push((Operator::Over, divisor)),
                    }
                    slashed = true;
                }
                Some(Kind::Number(_) | Kind::Name(_) | Kind::Root | Kind::Fraction | Kind::Open(_)) => {
                    let before = factors.last().map_or(&first, |(_, factor)| factor);
                    let fault = self.juxtaposed(before, slashed, broken);
                    if let Some(fault) = fault {
                        return Err((fault, self.place()));
                    }
                    let before = before.clone();
                    let factor = self.power(Some(&before))?;
                    factors.push((Operator::Times, factor));
                }
                _ => break,
            }
        }
        if factors.is_empty() {
            return Ok(first);
        }
        let end = factors.last().map_or(first.span.end, |(_, last)| last.span.end);
        let span = first.span.start..end;
        Ok(Expression { kind: Part::Product(Box::new(first), factors), span })
    }

    /// Why no factor may follow here without an operator, if so.
    fn juxtaposed(&self, before: &Expression, slashed: bool, broken: bool) -> Option<ListingFault> {
        let next = self.peek()?;
        let after_number = matches!(before.kind, Part::Number(_));
        let unbounded_root = matches!(&before.kind, Part::Root(_))
            && self.text[before.span.clone()].starts_with('√')
            && !self.text[before.span.clone()].ends_with(')');
        Some(match next.kind {
            _ if slashed => ListingFault::ProductAfterSlash,
            _ if broken => ListingFault::ProductAcrossRows,
            Kind::Number(_) if after_number => ListingFault::NumbersSideBySide,
            Kind::Number(_) => ListingFault::NumberAfterFactor,
            _ if unbounded_root => ListingFault::ProductAfterRoot,
            _ => return None,
        })
    }

    /// `before` is the factor in front, if no operator stands between.
    fn power(&mut self, before: Option<&Expression>) -> Result<Expression, Located> {
        let base = self.atom(before)?;
        let start = base.span.start;
        if !self.take(&Kind::Caret) {
            return Ok(base);
        }
        let (exponent, span) = self.exponent()?;
        if self.peek().is_some_and(|token| token.kind == Kind::Caret) {
            return self.expected("brackets around a power that is raised to a power");
        }
        let whole = start..span.end;
        Ok(Expression { kind: Part::Power(Box::new(base), exponent, span), span: whole })
    }

    fn exponent(&mut self) -> Result<(u32, Range<usize>), Located> {
        let place = self.place();
        let token = self.next();
        let (value, span) = match token.map(|token| &token.kind) {
            Some(Kind::Number(value)) => (value, place.clone()),
            Some(Kind::Open(Bracket::Brace)) => {
                let Some(Token { kind: Kind::Number(value), span }) = self.next() else {
                    return Err((ListingFault::Exponent, place));
                };
                if !self.take(&Kind::Close(Bracket::Brace)) {
                    return Err((ListingFault::Exponent, place.start..span.end));
                }
                (value, span.clone())
            }
            _ => return Err((ListingFault::Exponent, place)),
        };
        if !value.is_integer() {
            return Err((ListingFault::Exponent, span));
        }
        match value.to_u32().filter(|&exponent| exponent <= limits::DEGREE) {
            Some(exponent) => Ok((exponent, span)),
            None => Err((Limit::new("in an exponent", limits::DEGREE.into()).into(), span)),
        }
    }

    fn atom(&mut self, before: Option<&Expression>) -> Result<Expression, Located> {
        let Some(token) = self.peek() else {
            return self.expected("a number, a name, a root or a bracket");
        };
        let span = token.span.clone();
        match &token.kind {
            Kind::Number(value) => {
                self.next();
                Ok(Expression { kind: Part::Number(value.clone()), span })
            }
            Kind::Name(symbol) => {
                self.next();
                Ok(Expression { kind: Part::Name(symbol.clone()), span })
            }
            Kind::Open(bracket) => self.bracket(*bracket),
            Kind::Root => {
                self.next();
                let inside = self.argument(&Kind::Root)?;
                let span = span.start..self.end_of_last();
                Ok(Expression { kind: Part::Root(Box::new(inside)), span })
            }
            Kind::Fraction => {
                self.next();
                let (numerator, denominator) =
                    (self.argument(&Kind::Fraction)?, self.argument(&Kind::Fraction)?);
                let whole = span.start..self.end_of_last();
                let kind = fraction(&numerator, &denominator);
                let mixed = before.is_some_and(|before| matches!(before.kind, Part::Number(_)))
                    && matches!(kind, Part::Number(_));
                match mixed {
                    true => Err((ListingFault::MixedNumber, whole)),
                    false => Ok(Expression { kind, span: whole }),
                }
            }
            _ => self.expected("a number, a name, a root or a bracket"),
        }
    }

    /// The end of the token read last.
    fn end_of_last(&self) -> usize {
        self.tokens[..self.at].last().map_or(0, |token| token.span.end)
    }

    /// The argument of a root or a fraction: in brackets, or a single token.
    fn argument(&mut self, what: &Kind) -> Result<Expression, Located> {
        match self.peek() {
            Some(Token { kind: Kind::Open(bracket @ (Bracket::Brace | Bracket::Round)), .. }) => {
                self.nested(*bracket)
            }
            // TeX takes one character for an argument without braces.
            Some(Token { kind: Kind::Number(_), span }) if *what == Kind::Fraction && span.len() > 1 => {
                let digits = self.text[span.clone()].to_owned();
                Err((ListingFault::BareDigits { digits }, span.clone()))
            }
            Some(Token { kind: Kind::Name(_), span }) if self.text[span.clone()].contains('_') => {
                self.expected("brackets around an argument with a subscript")
            }
            Some(Token { kind: Kind::Number(_) | Kind::Name(_), .. }) => self.atom(None),
            _ => self.expected("an argument in brackets, or a number"),
        }
    }

    fn bracket(&mut self, bracket: Bracket) -> Result<Expression, Located> {
        let inside = self.nested(bracket)?;
        // Braces are invisible: {a+b}c is printed as a+bc.
        match inside.kind {
            Part::Sum(_) | Part::Product(..) | Part::Power(..) if bracket == Bracket::Brace => {
                Err((ListingFault::BracesAround, inside.span))
            }
            _ => Ok(inside),
        }
    }

    fn nested(&mut self, bracket: Bracket) -> Result<Expression, Located> {
        let start = self.place();
        self.next();
        self.depth += 1;
        if self.depth > limits::NESTING {
            return Err((Limit::new("nested brackets", 64).into(), start));
        }
        let inside = self.expression()?;
        self.depth -= 1;
        let (opened, expected) = bracket.spelled();
        if self.take(&Kind::Close(bracket)) {
            let span = start.start..self.end_of_last();
            return Ok(Expression { span, ..inside });
        }
        match self.peek() {
            Some(Token { kind: Kind::Close(_) | Kind::Separator | Kind::Equals, .. }) | None => {
                Err((ListingFault::BracketKind { opened, expected }, self.place()))
            }
            Some(_) => self.expected("an operator or a closing bracket"),
        }
    }
}

/// A fraction; of two integers it is one number.
fn fraction(numerator: &Expression, denominator: &Expression) -> Part {
    match (&numerator.kind, &denominator.kind) {
        (Part::Number(n), Part::Number(d)) if is_proper(n, d) => Part::Number(n / d),
        _ => Part::Product(Box::new(numerator.clone()), vec![(Operator::Over, denominator.clone())]),
    }
}

fn is_proper(n: &BigRational, d: &BigRational) -> bool {
    n.is_integer() && d.is_integer() && !d.is_zero()
}

/// `80/3` at the start of a product: one number.
fn literal_fraction(
    first: &Expression,
    factors: &[(Operator, Expression)],
    divisor: &Expression,
) -> Option<Expression> {
    match (&first.kind, &divisor.kind) {
        (Part::Number(n), Part::Number(d)) if factors.is_empty() && is_proper(n, d) => {
            Some(Expression { kind: Part::Number(n / d), span: first.span.start..divisor.span.end })
        }
        _ => None,
    }
}
