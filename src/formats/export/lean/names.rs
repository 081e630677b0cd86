//! What things are called in the Lean text, and how polynomials are spelled there.

use std::fmt::Write;

use num_traits::{One, Signed};

use crate::exact::{Limit, Polynomial};

use super::super::case::{Case, Reasoning};
use super::super::flat::quotients;

/// p and q = 1 − p, variables beyond all generators.
pub(super) const P: u16 = u16::MAX - 1;
pub(super) const Q: u16 = u16::MAX;
/// The values of a curve's coordinates: a0, a1, …, then b0, …, c0, …, d0, …
pub(super) const VALUES: u16 = 40_000;
/// X, Y, Z, W.
pub(super) const COORDINATES: u16 = 50_000;
/// How many values one coordinate has room for.
pub(super) const ROOM: u16 = 64;

/// The names of the generators.
pub(super) struct Names {
    pub(super) radicands: Vec<u32>,
    pub(super) roots: Vec<String>,
    pub(super) unknowns: Vec<String>,
    pub(super) inverses: Vec<String>,
}

impl Names {
    pub(super) fn of(case: &Case) -> Names {
        let count = |letter: char, count: usize| (1..=count).map(move |k| format!("{letter}{k}")).collect();
        // With values in place of the unknowns a net has none.
        let patch_with_values = matches!(
            (&case.argument, &case.subject),
            (Reasoning::Exact(_), crate::statement::Subject::Patch(_))
        );
        Names {
            radicands: case.field.values().to_vec(),
            roots: case.field.values().iter().map(|radicand| format!("r{radicand}")).collect(),
            unknowns: count('x', if patch_with_values { 0 } else { case.unknowns.len() }),
            inverses: count('t', case.assumptions.len()),
        }
    }

    /// ` r2 r3 x1 x2`: what definitions depend on, with a space in front of each.
    pub(super) fn arguments(&self) -> String {
        spaced(self.roots.iter().chain(&self.unknowns))
    }

    /// ` (Real.sqrt 2) (Real.sqrt 3)`.
    pub(super) fn true_roots(&self) -> String {
        spaced(self.radicands.iter().map(|radicand| format!("(Real.sqrt {radicand})")))
    }

    /// ` (hr2 : r2 ^ 2 = 2)` for every root.
    pub(super) fn root_hypotheses(&self) -> String {
        spaced(self.radicands.iter().map(|d| format!("(hr{d} : r{d} ^ 2 = {d})")))
    }

    /// The proofs of these for the true roots.
    pub(super) fn root_proofs(&self) -> String {
        spaced(self.radicands.iter().map(|_| "(Real.sq_sqrt (by norm_num))"))
    }

    /// What a polynomial in the generators, and in p, q and values, is with every root² replaced: ` + (…) * hr2 …`, the
    /// multiples of root² − radicand that it contains, with the given sign.
    pub(super) fn root_terms(&self, polynomial: &Polynomial, sign: char) -> Result<String, Limit> {
        let mut text = String::new();
        for (radicand, quotient) in self.radicands.iter().zip(quotients(polynomial, &self.radicands)?) {
            if !quotient.is_zero() {
                let _ = write!(text, " {sign} ({}) * hr{radicand}", self.spell(&quotient));
            }
        }
        Ok(text)
    }

    /// A polynomial as Lean reads it: `2/3*r3*x1^2 - 8*x1 - 4/3`.
    pub(super) fn spell(&self, polynomial: &Polynomial) -> String {
        let mut text = String::new();
        for (monomial, coefficient) in polynomial.terms() {
            text += match (text.is_empty(), coefficient.is_negative()) {
                (true, false) => "",
                (true, true) => "-",
                (false, false) => " + ",
                (false, true) => " - ",
            };
            let powers = monomial.powers().iter().map(|&(variable, exponent)| {
                let name = self.name(variable);
                if exponent == 1 { name } else { format!("{name}^{exponent}") }
            });
            let mut factors: Vec<String> = powers.collect();
            let size = coefficient.abs();
            if factors.is_empty() || !size.is_one() {
                factors.insert(0, size.to_string());
            }
            text += &factors.join("*");
        }
        if text.is_empty() { "0".to_owned() } else { text }
    }

    fn name(&self, variable: u16) -> String {
        match variable {
            P => "p".to_owned(),
            Q => "q".to_owned(),
            COORDINATES.. => ["X", "Y", "Z", "W"][usize::from(variable - COORDINATES) % 4].to_owned(),
            VALUES.. => {
                let (coordinate, index) = ((variable - VALUES) / ROOM, (variable - VALUES) % ROOM);
                format!("{}{index}", ["a", "b", "c", "d"][usize::from(coordinate) % 4])
            }
            _ => {
                let mut all = self.roots.iter().chain(&self.unknowns).chain(&self.inverses);
                all.nth(variable.into()).cloned().unwrap_or_default()
            }
        }
    }
}

/// The words with a space in front of each.
pub(super) fn spaced<W: std::fmt::Display>(words: impl IntoIterator<Item = W>) -> String {
    words.into_iter().fold(String::new(), |mut text, word| {
        let _ = write!(text, " {word}");
        text
    })
}

/// ` (x1 x2 : ℝ)`, or nothing for no names.
pub(super) fn reals(names: &str) -> String {
    if names.is_empty() { String::new() } else { format!(" ({} : ℝ)", names.trim_start()) }
}
