//! Why a certificate was not accepted.

use std::fmt;

use crate::certificate::{CertificateError, Premise};
use crate::exact::Limit;
use crate::statement::StatementError;

/// Why there is no theorem.
#[derive(Debug, Clone, PartialEq, Eq)]
#[non_exhaustive]
#[allow(missing_docs, reason = "the fields are what the message prints")]
pub enum CheckError {
    /// The statement cannot be read.
    Statement(StatementError),
    /// The certificate cannot be read.
    Certificate(CertificateError),
    /// A limit was reached while the equations of the statement were derived.
    Equations(Limit),
    /// A limit was reached in this step, or (step 0) while stated values were tried.
    Replay { step: usize, limit: Limit },
    /// A limit was reached at this node of a tree.
    Subdivision { tree: &'static str, node: usize, limit: Limit },
    /// The certificate does not prove its claim.
    Rejected(Rejection),
}

/// What is wrong with a well-formed certificate.
#[derive(Debug, Clone, PartialEq, Eq)]
#[non_exhaustive]
#[allow(missing_docs, reason = "the fields are what the message prints")]
pub enum Rejection {
    /// The certificate is for a statement with another hash.
    OtherStatement { expected: String, actual: String },
    /// A premise that the statement does not have.
    NoSuchPremise { step: usize, premise: Premise },
    /// A premise that is the zero polynomial.
    ZeroPremise { step: usize, premise: Premise },
    /// A premise that equals an earlier one of another name.
    SamePremise { step: usize, premise: Premise, earlier: Premise },
    /// The combination does not come to the stated conclusion.
    WrongConclusion { step: usize, expected: String, actual: String },
    /// A conclusion that is zero.
    ZeroConclusion { step: usize },
    /// A conclusion that is an equation of the statement or an earlier conclusion.
    RepeatedConclusion { step: usize, earlier: Premise },
    /// A step that no later one uses.
    UnusedStep { step: usize },
    /// No step at all.
    NoSteps,
    /// The last conclusion is not 1.
    LastConclusion { step: usize, actual: String },
    /// An equation that does not vanish at the stated values.
    NotAZero { equation: Premise, actual: String },
    /// An assumption that vanishes at the stated values.
    AssumptionVanishes { assumption: Premise },
    /// A patch whose denominator W is the zero polynomial at the stated values.
    NoDenominator,
    /// Bounds for a bare system.
    NotAPatch,
    /// A radius along a patch whose surface is another than X² + Y² + Z² − W² = 0.
    NotTheUnitSphere,
    /// A negative bound on a radius.
    NegativeRadius,
    /// Not a binary tree in preorder.
    Tree { tree: &'static str },
    /// A box on which the coefficients do not have the sign that is claimed.
    Sign { tree: &'static str, node: usize },
    /// A box that is halved though its coefficients have the sign that is claimed.
    NeedlessHalving { tree: &'static str, node: usize },
    /// A bound that is not the best decimal of its length, as far as the stated point shows.
    NotReached { end: &'static str },
    /// An edge that is not what the certificate says: an arc of a great circle, or a point.
    Edge { edge: &'static str, expected: &'static str },
    /// More than one edge that is a point.
    Points { edge: &'static str },
    /// Unknowns that do not occur as a product.
    NotAProduct,
    /// A sum that is not shown to be nowhere positive on its box.
    NotExcluded { chart: usize, node: usize },
}

impl fmt::Display for Rejection {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Rejection::OtherStatement { expected, actual } => {
                write!(
                    f,
                    "the certificate is for another statement\nexpected  sha256 {expected}\nactual    sha256 {actual}"
                )
            }
            Rejection::NoSuchPremise { step, premise } => {
                write!(f, "step {step}: the statement has no {premise}")
            }
            Rejection::ZeroPremise { step, premise } => {
                write!(f, "step {step}: premise {premise} is the zero polynomial")
            }
            Rejection::SamePremise { step, premise, earlier } => {
                write!(f, "step {step}: premise {premise} equals {earlier}, expected the earlier name")
            }
            Rejection::WrongConclusion { step, expected, actual } => {
                write!(f, "step {step}: the conclusion is wrong\nexpected  {expected}\nactual    {actual}")
            }
            Rejection::ZeroConclusion { step } => write!(f, "step {step}: the conclusion is 0"),
            Rejection::RepeatedConclusion { step, earlier } => {
                write!(f, "step {step}: the conclusion is that of {earlier}")
            }
            Rejection::UnusedStep { step } => write!(f, "step {step}: no later step uses it"),
            Rejection::NoSteps => {
                write!(f, "there is no step\nexpected  a last conclusion 1\nactual    none")
            }
            Rejection::LastConclusion { step, actual } => {
                write!(f, "step {step}: the last conclusion is not 1\nexpected  1\nactual    {actual}")
            }
            Rejection::NotAZero { equation, actual } => {
                write!(f, "{equation} does not vanish at these values\nexpected  0\nactual    {actual}")
            }
            Rejection::AssumptionVanishes { assumption } => {
                write!(f, "the assumption of {assumption} fails: it vanishes at these values")
            }
            Rejection::NoDenominator => {
                write!(f, "the denominator W of the patch is the zero polynomial at these values")
            }
            Rejection::NotAPatch => {
                write!(f, "the claim is about a patch, but the statement is a system of equations")
            }
            Rejection::NotTheUnitSphere => {
                write!(
                    f,
                    "the claim is about the unit sphere X² + Y² + Z² − W² = 0, but the surface is another"
                )
            }
            Rejection::NegativeRadius => write!(f, "a bound on a radius is negative"),
            Rejection::Tree { tree } => write!(f, "{tree}: not a binary tree in preorder"),
            Rejection::Sign { tree, node } => {
                write!(
                    f,
                    "{tree}: on box {node} of the tree, the coefficients do not have the sign that is claimed"
                )
            }
            Rejection::NeedlessHalving { tree, node } => {
                write!(f, "{tree}: box {node} of the tree is halved, but need not be")
            }
            Rejection::NotReached { end } => {
                write!(
                    f,
                    "{end}: the stated point does not come within one unit of the last place of the bound"
                )
            }
            Rejection::Edge { edge, expected } => write!(f, "edge {edge}: it is not {expected}"),
            Rejection::Points { edge } => {
                write!(f, "edge {edge}: it is a point like another edge, which leaves no triangle")
            }
            Rejection::NotAProduct => {
                write!(f, "the equations are not polynomials in the stated products")
            }
            Rejection::NotExcluded { chart, node } => {
                write!(
                    f,
                    "chart {chart}: on box {node} of the tree, the sum is not shown to be nowhere positive"
                )
            }
        }
    }
}

impl fmt::Display for CheckError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            CheckError::Statement(error) => error.fmt(f),
            CheckError::Certificate(error) => error.fmt(f),
            CheckError::Equations(limit) => write!(f, "deriving the equations: {limit}"),
            CheckError::Replay { step: 0, limit } => write!(f, "trying the values: {limit}"),
            CheckError::Replay { step, limit } => write!(f, "step {step}: {limit}"),
            CheckError::Subdivision { tree, node, limit } => write!(f, "{tree}, box {node}: {limit}"),
            CheckError::Rejected(rejection) => rejection.fmt(f),
        }
    }
}

impl std::error::Error for CheckError {}

impl From<StatementError> for CheckError {
    fn from(error: StatementError) -> Self {
        CheckError::Statement(error)
    }
}

impl From<CertificateError> for CheckError {
    fn from(error: CertificateError) -> Self {
        CheckError::Certificate(error)
    }
}

impl From<Rejection> for CheckError {
    fn from(rejection: Rejection) -> Self {
        CheckError::Rejected(rejection)
    }
}
