//! Proofs in other languages, for those who trust other programs: proof assistants and computer-algebra systems.
//!
//! One file for each target. All of them write the same [`Case`], a statement with its argument, and leave the
//! verdict to the program they write for: nothing here is believed by anybody.

mod case;
mod coq;
mod flat;
mod integral;
mod lean;
mod macaulay2;
mod maxima;
mod pac;
mod pari;
mod script;
mod singular;
mod sympy;
pub mod text;

pub use case::{Case, ExportError, Reasoning, Term};
pub use pac::files as pac_files;

/// The languages.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Target {
    /// A Coq (Rocq) file whose theorem is the geometric statement.
    Coq,
    /// A Singular script.
    Singular,
    /// A Macaulay2 script.
    Macaulay2,
    /// A PARI/GP script.
    Pari,
    /// A Python script for SymPy.
    Sympy,
    /// A Maxima script.
    Maxima,
    /// A Lean 4 file for Mathlib.
    Lean,
    /// A proof in the practical algebraic calculus.
    Pac,
}

/// The text of a case in a language.
///
/// # Errors
/// [`ExportError::Inexpressible`] where the language lacks something.
pub fn export(case: &Case, target: Target) -> Result<String, ExportError> {
    match target {
        Target::Coq => coq::export(case),
        Target::Singular => singular::export(case),
        Target::Macaulay2 => macaulay2::export(case),
        Target::Pari => pari::export(case),
        Target::Sympy => sympy::export(case),
        Target::Maxima => maxima::export(case),
        Target::Lean => lean::export(case),
        Target::Pac => pac::export(case),
    }
}
