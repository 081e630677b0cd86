//! What can be wrong with a printed listing, and where.

use std::fmt;
use std::ops::Range;

use crate::exact::Limit;
use crate::statement::Place;

/// A mistake in a listing, or something that has two meanings, with its place.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ListingError {
    /// Where.
    pub place: Place,
    /// What is wrong.
    pub fault: ListingFault,
}

/// A fault with the bytes of the text it concerns.
pub(crate) type Located = (ListingFault, Range<usize>);

/// What is wrong, without the place.
#[derive(Debug, Clone, PartialEq, Eq)]
#[non_exhaustive]
#[allow(missing_docs, reason = "the fields are what the message prints")]
pub enum ListingFault {
    /// Something else belongs here.
    Expected { expected: &'static str, found: String },
    /// A LaTeX command that has no meaning in a formula, as far as this reader goes.
    Command { name: String },
    /// An environment that is not one of displayed formulas.
    Environment { name: String },
    /// `1/2w`: (1/2)·w or 1/(2w)?
    ProductAfterSlash,
    /// `a/b/c`.
    TwoSlashes,
    /// `2 3`.
    NumbersSideBySide,
    /// `w2`, `(w+1)2`.
    NumberAfterFactor,
    /// `2\frac{1}{3}`.
    MixedNumber,
    /// `^12`, `w_11`, `\sqrt 12` in LaTeX, where only the first digit counts.
    BareDigits { digits: String },
    /// `√6w`: does the root reach over w?
    ProductAfterRoot,
    /// Two factors with a line break between them.
    ProductAcrossRows,
    /// `(…]`.
    BracketKind { opened: &'static str, expected: &'static str },
    /// Braces of TeX around a sum or a product: they are not printed.
    BracesAround,
    /// `2 - -3`.
    TwoSigns,
    /// `1,5`: a decimal comma, or two numbers?
    DecimalComma,
    /// An exponent that is not a natural number.
    Exponent,
    /// A name that the listing's names do not map to an unknown.
    UnknownName { name: String, expected: String },
    /// A name that means two unknowns.
    AmbiguousName { name: String },
    /// A label that names no coefficient.
    UnknownLabel { label: String, expected: String },
    /// The same coefficient twice.
    RepeatedLabel { label: String, line: usize },
    /// A square root outside the field; the field, and why.
    Root { outside: String },
    /// A division by zero.
    DivisionByZero,
    /// A division by something that contains an unknown.
    DivisionByUnknown,
    /// There is no formula at all, and no claim, of a statement whose coefficients are not all zero.
    NoFormula,
    /// Not a listing file: what TOML says, or which key is wrong.
    File { message: String },
    /// A limit.
    Limit(Limit),
}

impl From<Limit> for ListingFault {
    fn from(limit: Limit) -> Self {
        ListingFault::Limit(limit)
    }
}

impl fmt::Display for ListingFault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        use ListingFault as Fault;
        match self {
            Fault::Expected { expected, found } => write!(f, "expected {expected}, found {found}"),
            Fault::Command { name } => write!(f, "`\\{name}` has no meaning in a formula of this reader"),
            Fault::Environment { name } => {
                write!(f, "`{name}` is not an environment of displayed formulas that this reader knows")
            }
            Fault::ProductAfterSlash => write!(
                f,
                "ambiguous: is this factor part of the divisor? write brackets, 1/(2w) or (1/2)w, or \\frac"
            ),
            Fault::TwoSlashes => write!(f, "ambiguous: a/b/c; write brackets, (a/b)/c or a/(b/c)"),
            Fault::NumbersSideBySide => {
                write!(f, "ambiguous: two numbers side by side; write 2·3 for the product")
            }
            Fault::NumberAfterFactor => {
                write!(
                    f,
                    "ambiguous: a number behind a factor; write it in front, or an operator between them"
                )
            }
            Fault::MixedNumber => write!(
                f,
                "ambiguous: a mixed number or a product? write 2·(1/3) or 7/3, with an operator between them"
            ),
            Fault::BareDigits { digits } => {
                write!(
                    f,
                    "ambiguous: without braces only the first digit of {digits} counts; write {{{digits}}}"
                )
            }
            Fault::ProductAfterRoot => {
                write!(f, "ambiguous: does the root reach over this factor? write √(…), or an operator")
            }
            Fault::ProductAcrossRows => write!(
                f,
                "ambiguous: two factors in two rows or columns; write an operator, or `=` if a new formula starts here"
            ),
            Fault::BracketKind { opened, expected } => {
                write!(f, "`{opened}` is still open, expected `{expected}` to close it")
            }
            Fault::BracesAround => write!(
                f,
                "braces are not printed: around a sum or a product write ( ), which a reader can see"
            ),
            Fault::TwoSigns => write!(f, "two signs in a row; write brackets around the second term"),
            Fault::DecimalComma => {
                write!(f, "ambiguous: a decimal comma, or two numbers? write 1.5 or an operator")
            }
            Fault::Exponent => write!(f, "expected a natural number as exponent"),
            Fault::UnknownName { name, expected } => {
                write!(f, "`{name}` is none of the unknowns, expected {expected}")
            }
            Fault::AmbiguousName { name } => write!(f, "`{name}` means two unknowns; map it explicitly"),
            Fault::UnknownLabel { label, expected } => {
                write!(f, "`{label}` names no coefficient, expected {expected}")
            }
            Fault::RepeatedLabel { label, line } => {
                write!(f, "`{label}` is listed twice, the first time in line {line}")
            }
            Fault::Root { outside } => write!(f, "this square root is not in {outside}"),
            Fault::DivisionByZero => write!(f, "division by zero"),
            Fault::DivisionByUnknown => write!(f, "division by an expression with unknowns"),
            Fault::NoFormula => write!(f, "no formula here, expected `label = expression`"),
            Fault::File { message } => f.write_str(message),
            Fault::Limit(limit) => limit.fmt(f),
        }
    }
}

impl ListingError {
    /// A fault at these bytes of a text.
    pub(crate) fn at(text: &str, (fault, span): Located) -> Self {
        ListingError { place: Place::of(text, span), fault }
    }
}

impl fmt::Display for ListingError {
    /// `12:18: ambiguous: …`, then the line and a caret under the offending text.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}:{}: {}\n{}", self.place.line, self.place.column, self.fault, self.place)
    }
}

impl std::error::Error for ListingError {}

/// What stands at the start of `rest`, for a message.
pub(super) fn shown(rest: &str) -> String {
    let word: String = rest.chars().take_while(|c| !c.is_whitespace()).take(16).collect();
    if word.is_empty() && rest.trim().is_empty() {
        "the end".into()
    } else if word.is_empty() {
        "a blank".into()
    } else {
        let plain = |c: char| if c.is_control() { '\u{fffd}' } else { c };
        format!("`{}`", word.chars().map(plain).collect::<String>())
    }
}
