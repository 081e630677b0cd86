//! A printed formula as it was read: nothing is simplified, every part knows its place.

use std::ops::Range;

use num_rational::BigRational;

use super::token::Symbol;

/// A part of a formula with the bytes it was read from.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Expression {
    /// What it is.
    pub kind: Kind,
    /// Where it stands in the text of the listing.
    pub span: Range<usize>,
}

/// The parts of formulas.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Kind {
    /// A number; a fraction of two integers counts as one.
    Number(BigRational),
    /// A name.
    Name(Symbol),
    /// Terms with their signs.
    Sum(Vec<Signed>),
    /// The first factor, then each further one with its operator.
    Product(Box<Expression>, Vec<(Operator, Expression)>),
    /// A power; the bytes of the exponent.
    Power(Box<Expression>, u32, Range<usize>),
    /// A square root.
    Root(Box<Expression>),
}

/// A term of a sum.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Signed {
    /// Whether it is subtracted.
    pub minus: bool,
    /// The bytes of the sign; none where none is printed.
    pub sign: Range<usize>,
    /// The term.
    pub term: Expression,
}

/// What joins a factor to those before it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Operator {
    /// Product, printed or implied.
    Times,
    /// Quotient.
    Over,
}

/// `label = label = … = expression`.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Formula {
    /// The labels, each with its place.
    pub labels: Vec<(Symbol, Range<usize>)>,
    /// What they are said to be.
    pub expression: Expression,
}
