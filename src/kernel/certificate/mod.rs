//! How a claim is argued: a straight line of linear combinations, the values of the unknowns, or subdivisions.
//!
//! A certificate never carries its axioms: its premises are *names* of polynomials that the checker derives
//! from the statement. Text form, grammar and limits: `proofs/FORMAT.md`. There is one spelling of each
//! certificate, and the reader accepts no other.

mod bounds;
mod cover;
mod error;
mod read;
mod read_bounds;
mod seal;
mod write;
mod write_bounds;

use std::fmt;

use crate::exact::Polynomial;

pub use bounds::{
    Bounds, End, Odds, Quantity, Region, Side, Tree, Units, Unreachable, decimal_value, spell_decimal,
};
pub use cover::{Cover, EDGES, EdgeTree};
pub use error::{CertificateError, CertificateFault};

/// An argument for a claim about the statement with a certain hash.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Certificate {
    /// SHA-256 of the canonical statement, in lower-case hexadecimal.
    pub statement: String,
    /// The argument.
    pub argument: Argument,
}

/// The kinds of argument.
#[allow(clippy::large_enum_variant, reason = "one or two are alive at a time")]
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Argument {
    /// The equations have no common zero: steps that end in 1.
    Impossible(Vec<Step>),
    /// They have this one: a value in K for each unknown, in the statement's order.
    Exact(Vec<Polynomial>),
    /// At certain values the patch is this near to the surface.
    Bounds(Bounds),
    /// At no values is it nearer than this.
    Unreachable(Unreachable),
    /// At certain values the patch covers a spherical polygon, once and regularly.
    Cover(Cover),
}

/// One step: Σ multiplier · premise = conclusion.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Step {
    /// Premises in their order, each once, with non-zero multipliers.
    pub combination: Vec<(Premise, Polynomial)>,
    /// What the combination comes to.
    pub conclusion: Polynomial,
}

/// What a step may use: an equation of the statement or an earlier step. The order is that of spelling.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Premise {
    /// `c[r,s]`: the coefficient of uʳ(1−u)^(em−r)·vˢ(1−v)^(en−s) of the surface equation of degree e.
    Coefficient(u32, u32),
    /// `f[k]`: the k-th polynomial of a system, from 1.
    Equation(u32),
    /// `nonzero[k]`: the k-th assumption d, from 1, as the polynomial d·`t[k]` − 1 (Rabinowitsch).
    Nonzero(u32),
    /// The conclusion of an earlier step, from 1.
    Step(u32),
}

impl fmt::Display for Premise {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Premise::Coefficient(r, s) => write!(f, "c[{r},{s}]"),
            Premise::Equation(k) => write!(f, "f[{k}]"),
            Premise::Nonzero(k) => write!(f, "nonzero[{k}]"),
            Premise::Step(k) => write!(f, "step {k}"),
        }
    }
}
