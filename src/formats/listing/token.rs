//! What printed formulas are made of, whatever the notation.

use std::ops::Range;

use num_rational::BigRational;

use super::error::Located;

/// A token with the bytes it was read from.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Token {
    pub(super) kind: Kind,
    pub(super) span: Range<usize>,
}

/// The kinds of tokens.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) enum Kind {
    /// An integer or a decimal.
    Number(BigRational),
    /// A symbol with its subscript.
    Name(Symbol),
    /// `+` or `-`.
    Sign { minus: bool },
    /// `*`, `\cdot`, ….
    Times,
    /// `/`.
    Slash,
    /// `^` in front of an exponent.
    Caret,
    /// `\frac`: two arguments follow, each an [`Kind::Open`] … [`Kind::Close`] of braces or a single token.
    Fraction,
    /// `\sqrt`, `sqrt`, `√`: one argument follows.
    Root,
    /// An opening bracket.
    Open(Bracket),
    /// A closing bracket.
    Close(Bracket),
    /// `=`.
    Equals,
    /// `,`, `;` or a full stop: what follows is another formula.
    Separator,
    /// `&`: the edge of a column.
    Column,
    /// The end of a row: `\\`, or a line break in plain text.
    Row,
}

impl Kind {
    /// Whether this is only layout.
    pub(super) fn is_layout(&self) -> bool {
        matches!(self, Kind::Row | Kind::Column)
    }
}

/// The kinds of brackets. Braces are TeX's invisible ones.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Bracket {
    Round,
    Square,
    Curly,
    Brace,
}

impl Bracket {
    /// How it is printed, opening and closing.
    pub(super) fn spelled(self) -> (&'static str, &'static str) {
        match self {
            Bracket::Round => ("(", ")"),
            Bracket::Square => ("[", "]"),
            Bracket::Curly => ("\\{", "\\}"),
            Bracket::Brace => ("{", "}"),
        }
    }
}

/// A name as it is compared: `w_{11}`, `w_11` and `w11` are one symbol, `w_{1,1}` is another.
#[derive(Debug, Clone, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Symbol(String);

impl Symbol {
    /// The symbol of a spelled name: underscores, braces and spaces do not count.
    pub fn new(spelled: &str) -> Self {
        let counts = |c: &char| !matches!(c, '_' | '{' | '}' | '[' | ']' | '\\') && !c.is_whitespace();
        // a[1,2] and a_{1,2} are the same.
        Symbol(spelled.chars().filter(counts).collect())
    }

    /// The letters, digits and commas that count.
    pub fn as_str(&self) -> &str {
        &self.0
    }

    /// The letters in front and the indices after them: `a14` is a, 14; `a1,4` is a, 1, 4.
    pub fn indices(&self) -> Option<(&str, Vec<u32>)> {
        let start = self.0.find(|c: char| c.is_ascii_digit())?;
        let (letters, rest) = self.0.split_at(start);
        let indices: Option<Vec<u32>> = rest.split(',').map(|index| index.parse().ok()).collect();
        indices.map(|indices| (letters, indices))
    }
}

impl std::fmt::Display for Symbol {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(&self.0)
    }
}

/// The tokens of one stretch of mathematics.
pub(super) type Tokens = Result<Vec<Token>, Located>;
