//! The data that a file's replay computes with, as Coq definitions.

use num_bigint::BigInt;

use super::spell::{self, integer};
use super::unknowns::Unknowns;
use crate::certificate::{Premise, Step};
use crate::exact::Polynomial;
use crate::formats::export::case::Case;
use crate::formats::export::integral::{IntegralStep, integral_steps};
use crate::statement::Patch;

/// Conclusions are shown beside their data up to this length.
const SHOWN: usize = 100;

/// `Definition NAME : TYPE := VALUE.`
pub(super) fn definition(name: &str, of: &str, value: &str) -> String {
    format!("Definition {name} : {of} :=\n  {value}.\n\n")
}

/// A sum of terms.
pub(super) fn polynomial(name: &str, value: &Polynomial) -> String {
    definition(name, "list term", &spell::terms(value))
}

/// A list of sums of terms.
pub(super) fn polynomials(name: &str, values: &[Polynomial]) -> String {
    definition(name, "list (list term)", &spell::lines(values.iter().map(spell::terms)))
}

/// The control net: rows of points of four sums of terms.
pub(super) fn net(patch: &Patch) -> String {
    let point = |point: &[Polynomial; 4]| spell::list(point.iter().map(spell::terms));
    definition("net", "net_terms", &spell::rows(patch.net.iter().map(|row| row.iter().map(point).collect())))
}

/// Each assumption with the number of the variable that stands for its inverse.
pub(super) fn assumptions(case: &Case) -> String {
    let entries = case.assumptions.iter().zip(case.unknowns.len()..);
    let entries = entries.map(|(assumed, variable)| format!("({}, {variable})", spell::terms(assumed)));
    definition("assumptions", "list (list term * nat)", &spell::lines(entries))
}

/// The steps, where equations are multiplied by `scale`; each with its conclusion as people write it.
pub(super) fn certificate(case: &Case, unknowns: &Unknowns, scale: impl Fn(Premise) -> BigInt) -> String {
    let mut names = unknowns.names.clone();
    names.extend((1..=case.assumptions.len()).map(|k| format!("t_{k}")));
    let summand = |(premise, multiplier): &(Premise, Polynomial)| {
        format!("({}, {})", name_of(*premise), spell::terms(multiplier))
    };
    let step = |(number, (step, original)): (usize, (&IntegralStep, &Step))| {
        let shown = spell::expression(&original.conclusion, &case.field, &names);
        let shown = if shown.len() <= SHOWN { format!("{shown} = 0") } else { "...".into() };
        let summands: Vec<String> = step.summands.iter().map(summand).collect();
        format!(
            "(* {number}: {shown} *)\n   Derive [{}]\n     {} {}",
            summands.join(";\n     "),
            integer(&step.multiple),
            spell::terms(&step.conclusion)
        )
    };
    let steps = integral_steps(case.steps(), scale);
    definition(
        "certificate",
        "list derivation",
        &spell::lines((1..).zip(steps.iter().zip(case.steps())).map(step)),
    )
}

fn name_of(premise: Premise) -> String {
    match premise {
        Premise::Coefficient(r, s) => format!("c {r} {s}"),
        Premise::Equation(k) => format!("f {k}"),
        Premise::Nonzero(k) => format!("nonzero {k}"),
        Premise::Step(k) => format!("step {k}"),
    }
}
