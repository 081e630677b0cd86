//! The steps of a refutation, and what is shown of constants.

use std::collections::BTreeMap;
use std::fmt::Write;

use super::super::case::{Case, ExportError};
use super::super::flat::{lift, rationals, sum_of_products};
use super::names::Names;
use crate::certificate::Premise;
use crate::exact::{Polynomial, Work};

/// The equations that have been written, by name: in the generators, as they are stated.
pub(super) type Known = BTreeMap<Premise, Polynomial>;

/// The Lean name of an equation.
pub(super) fn name(premise: Premise) -> String {
    match premise {
        Premise::Coefficient(r, s) => format!("c_{r}_{s}"),
        Premise::Equation(k) => format!("f_{k}"),
        Premise::Nonzero(k) => format!("n_{k}"),
        Premise::Step(k) => format!("s_{k}"),
    }
}

/// Each step with its conclusion as the certificate has it, and the contradiction. The equations must have been written.
pub(super) fn steps(case: &Case, names: &Names, known: &mut Known) -> Result<String, ExportError> {
    let mut text = String::new();
    for (number, step) in (1u32..).zip(case.steps()) {
        case.control.check()?;
        let mut factors = Vec::with_capacity(step.combination.len());
        let mut terms = Vec::with_capacity(step.combination.len());
        for (premise, multiplier) in &step.combination {
            let equation = known.get(premise).ok_or(ExportError::Premise(*premise))?;
            let multiplier = lift(case, multiplier)?;
            terms.push(format!("({}) * {}", names.spell(&multiplier), name(*premise)));
            factors.push((multiplier, equation));
        }
        let pairs: Vec<_> = factors.iter().map(|(multiplier, equation)| (multiplier, *equation)).collect();
        let reductions = names.root_terms(&sum_of_products(&pairs, &case.control)?, '-')?;
        let conclusion = lift(case, &step.conclusion)?;
        let own = Premise::Step(number);
        let _ = writeln!(
            text,
            "  have {} : ({} : ℝ) = 0 := by linear_combination {}{reductions}",
            name(own),
            names.spell(&conclusion),
            terms.join(" + "),
        );
        known.insert(own, conclusion);
    }
    // Without steps, or with another conclusion, this is an error in Lean: as it should be.
    let last = u32::try_from(case.steps().len()).unwrap_or(u32::MAX);
    let _ = writeln!(text, "  exact one_ne_zero {}", name(Premise::Step(last)));
    Ok(text)
}

/// `nonzero1`, …: the assumptions as definitions.
pub(super) fn assumptions(case: &Case, names: &Names) -> Result<String, ExportError> {
    let mut text = String::new();
    for (number, assumed) in (1..).zip(&case.assumptions) {
        let (parameters, value) =
            (super::names::reals(&names.arguments()), names.spell(&lift(case, assumed)?));
        let _ = writeln!(
            text,
            "/-- This is assumed not to be zero. -/\ndef nonzero{number}{parameters} : ℝ := {value}\n"
        );
    }
    Ok(text)
}

/// `(ht1 : nonzero1 r2 x1 * t1 = 1)` for every assumption: what a refutation assumes.
pub(super) fn inverse_hypotheses(names: &Names) -> String {
    let hypothesis =
        |(k, t): (usize, &String)| format!(" (ht{k} : nonzero{k}{} * {t} = 1)", names.arguments());
    (1..).zip(&names.inverses).map(hypothesis).collect()
}

/// The same as equations `n_1`, …, those that are used.
pub(super) fn inverse_equations(names: &Names, known: &Known) -> String {
    let mut text = String::new();
    for (premise, equation) in known {
        if let Premise::Nonzero(k) = premise {
            let _ = writeln!(text, "  simp only [nonzero{k}] at ht{k}");
            let (own, equation) = (name(*premise), names.spell(equation));
            let _ = writeln!(text, "  have {own} : ({equation} : ℝ) = 0 := by linear_combination ht{k}");
        }
    }
    text
}

/// ` (h1 : nonzero1 (Real.sqrt 2) x1 ≠ 0)`: what the theorem assumes; and, for each, the inverse and its proof.
pub(super) fn nonzero_hypotheses(names: &Names) -> (String, String, String) {
    let (mut hypotheses, mut inverses, mut proofs) = (String::new(), String::new(), String::new());
    let arguments = names.true_roots() + &super::names::spaced(&names.unknowns);
    for k in 1..=names.inverses.len() {
        let _ = write!(hypotheses, " (n{k} : nonzero{k}{arguments} ≠ 0)");
        let _ = write!(inverses, " (nonzero{k}{arguments})⁻¹");
        let _ = write!(proofs, " (mul_inv_cancel₀ n{k})");
    }
    (hypotheses, inverses, proofs)
}

/// A theorem that a constant of K is not zero: by its inverse.
pub(super) fn constant_is_not_zero(
    case: &Case,
    names: &Names,
    theorem: &str,
    constant: &Polynomial,
) -> Result<String, ExportError> {
    // Where there is none the text claims what is false, and Lean will say so.
    let inverse = constant.inverse(&case.field, &mut Work::full())?.unwrap_or_default();
    let (constant, inverse) = (lift(case, constant)?, lift(case, &inverse)?);
    let product = constant.multiply(&inverse, &rationals(), &mut Work::full())?;
    Ok(format!(
        "theorem {theorem}{}{} : ({} : ℝ) ≠ 0 := by\n  intro h\n  \
         have s_1 : (1 : ℝ) = 0 := by linear_combination ({}) * h{}\n  exact one_ne_zero s_1\n",
        super::names::reals(&super::names::spaced(&names.roots)),
        names.root_hypotheses(),
        names.spell(&constant),
        names.spell(&inverse),
        names.root_terms(&product, '-')?,
    ))
}
