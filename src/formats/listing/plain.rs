//! Plain text → tokens: `a14 = -16*w^2 + (80/3)·√6·w`, as programs and this one print it.

use std::ops::Range;

use super::error::{ListingFault, Located, shown};
use super::number::{digits_at, number_at};
use super::token::{Bracket, Kind, Symbol, Token, Tokens};

const SUPERSCRIPTS: &str = "⁰¹²³⁴⁵⁶⁷⁸⁹";

/// The tokens of a part of a text. A line break ends a row; `#` starts a comment.
pub(super) fn tokens(text: &str, part: Range<usize>) -> Tokens {
    let mut lexer = Lexer { text, at: part.start, end: part.end, tokens: Vec::new() };
    while lexer.step()? {}
    Ok(lexer.tokens)
}

struct Lexer<'a> {
    text: &'a str,
    at: usize,
    end: usize,
    tokens: Vec<Token>,
}

impl<'a> Lexer<'a> {
    fn rest(&self) -> &'a str {
        &self.text[self.at..self.end]
    }

    fn push(&mut self, kind: Kind, length: usize) {
        self.tokens.push(Token { kind, span: self.at..self.at + length });
        self.at += length;
    }

    fn step(&mut self) -> Result<bool, Located> {
        let rest = self.rest();
        self.at += rest.len() - rest.trim_start_matches([' ', '\t', '\r', '\u{a0}']).len();
        let Some(first) = self.rest().chars().next() else {
            return Ok(false);
        };
        let length = first.len_utf8();
        match first {
            '\n' => self.push(Kind::Row, 1),
            '#' => self.at += self.rest().find('\n').unwrap_or(self.rest().len()),
            '0'..='9' => {
                let read = number_at(self.rest());
                let (value, length) = read.map_err(|fault| (fault, self.at..self.at + 1))?;
                self.push(Kind::Number(value), length);
            }
            '+' => self.push(Kind::Sign { minus: false }, 1),
            '-' | '−' => self.push(Kind::Sign { minus: true }, length),
            '*' if self.rest().starts_with("**") => self.push(Kind::Caret, 2),
            '*' | '·' | '×' => self.push(Kind::Times, length),
            '/' => self.push(Kind::Slash, 1),
            '=' => self.push(Kind::Equals, 1),
            '^' => self.push(Kind::Caret, 1),
            '√' => self.push(Kind::Root, length),
            '(' => self.push(Kind::Open(Bracket::Round), 1),
            ')' => self.push(Kind::Close(Bracket::Round), 1),
            '[' => self.push(Kind::Open(Bracket::Square), 1),
            ']' => self.push(Kind::Close(Bracket::Square), 1),
            '{' => self.push(Kind::Open(Bracket::Curly), 1),
            '}' => self.push(Kind::Close(Bracket::Curly), 1),
            ',' | ';' => self.push(Kind::Separator, 1),
            '.' if !self.rest()[1..].starts_with(|c: char| c.is_ascii_digit()) => {
                self.push(Kind::Separator, 1);
            }
            c if c.is_alphabetic() => self.name(),
            c if SUPERSCRIPTS.contains(c) => self.superscript(),
            _ => {
                let expected =
                    if first == '.' { "a digit in front of the decimal point" } else { "a formula" };
                let fault = ListingFault::Expected { expected, found: shown(self.rest()) };
                return Err((fault, self.at..self.at + length));
            }
        }
        Ok(true)
    }

    /// Letters, digits and underscores; `_{…}` or `[1,2]` may follow.
    fn name(&mut self) {
        let rest = self.rest();
        let run = |text: &str| {
            text.find(|c: char| !(c.is_alphanumeric() || c == '_') || SUPERSCRIPTS.contains(c))
                .unwrap_or(text.len())
        };
        let length = run(rest);
        if &rest[..length] == "sqrt" {
            return self.push(Kind::Root, length);
        }
        let after = &rest[length..];
        let indices = |open: char, close: char| {
            let inside = after.strip_prefix(open)?.split_once(close)?.0;
            let plain = !inside.is_empty()
                && inside.split(',').all(|index| {
                    let index = index.trim();
                    digits_at(index) == index.len() && !index.is_empty()
                });
            plain.then_some(inside.len() + 2)
        };
        let braced = if rest[..length].ends_with('_') { indices('{', '}') } else { None };
        let total = length + braced.or_else(|| indices('[', ']')).unwrap_or(0);
        self.push(Kind::Name(Symbol::new(&rest[..total])), total);
    }

    /// `w²`: a caret and a number in one.
    fn superscript(&mut self) {
        let run = self.rest().find(|c| !SUPERSCRIPTS.contains(c)).unwrap_or(self.rest().len());
        let value = |c: char| SUPERSCRIPTS.chars().position(|other| other == c).unwrap_or(0);
        let digits: String = self.rest()[..run].chars().map(|c| value(c).to_string()).collect();
        let number = number_at(&digits).map_or_else(|_| num_traits::Zero::zero(), |(number, _)| number);
        self.tokens.push(Token { kind: Kind::Caret, span: self.at..self.at });
        self.push(Kind::Number(number), run);
    }
}
