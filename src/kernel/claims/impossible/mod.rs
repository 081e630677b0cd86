//! Claim `impossible`: the equations have no common zero, argued by a straight line of linear combinations.

mod check;
mod text;

use std::fmt;

use super::wording;
use crate::equations::Premise;
use crate::exact::Polynomial;
use crate::statement::{Patch, Statement, Subject};

pub(super) use check::verify;
pub(super) use text::{read, write};

/// One step: Σ multiplier · premise = conclusion.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Step {
    /// Premises in their order, each once, with non-zero multipliers.
    pub combination: Vec<(Premise, Polynomial)>,
    /// What the combination comes to.
    pub conclusion: Polynomial,
}

/// The equations and assumptions of the statement have no common zero over any field containing K.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Refuted {
    /// Steps replayed.
    pub steps: usize,
    /// Terms of all multipliers.
    pub multiplier_terms: usize,
}

/// What is wrong with well-formed steps.
#[derive(Debug, Clone, PartialEq, Eq)]
#[allow(missing_docs, reason = "the fields are what the message prints")]
pub enum Rejection {
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
}

impl Refuted {
    /// `impossible`.
    pub(super) fn kind(&self) -> &'static str {
        "impossible"
    }

    /// What was proved.
    pub(super) fn sentence(&self, statement: &Statement) -> String {
        match statement.subject() {
            Subject::Patch(patch) => patch_impossible(statement, patch),
            Subject::System(polynomials) => system_impossible(statement, polynomials.len()),
        }
    }

    /// Lines under the sentence.
    pub(super) fn details(&self, _: &Statement) -> Vec<String> {
        let Refuted { steps, multiplier_terms } = self;
        let plural = |count: &usize| if *count == 1 { "" } else { "s" };
        vec![format!(
            "replayed   {steps} step{}, {multiplier_terms} term{} in the multipliers",
            plural(steps),
            plural(multiplier_terms)
        )]
    }
}

fn patch_impossible(statement: &Statement, patch: &Patch) -> String {
    let degree = patch.surface.degree();
    let (m, n) = patch.bidegree;
    let count = count_coefficients(m.saturating_mul(degree), n.saturating_mul(degree));
    let surface = wording::surface(statement, patch);
    let with = wording::with_assumptions(statement);
    let patch = format!("rational Bézier patch of bidegree ({m},{n})");
    let values = match statement.unknowns() {
        [] => {
            return format!(
                "This {patch} does not lie on {surface}: its {count} coefficients c[r,s] are not all zero."
            );
        }
        [one] => format!("For no value of {one}"),
        many => format!("For no values of {}", many.join(", ")),
    };
    format!(
        "{values}{with}, real or complex, does this {patch} lie on {surface}: its {count} coefficients c[r,s] have \
         no common zero over any field containing {}{with}.",
        statement.field()
    )
}

fn system_impossible(statement: &Statement, polynomials: usize) -> String {
    if statement.unknowns().is_empty() {
        return "The polynomials of the system, all constants, are not all zero.".to_owned();
    }
    format!(
        "The system of {polynomials} polynomial{} has no zero{} over any field containing {}.",
        if polynomials == 1 { "" } else { "s" },
        wording::with_assumptions(statement),
        statement.field()
    )
}

fn count_coefficients(r: u32, s: u32) -> u64 {
    u64::from(r).saturating_add(1).saturating_mul(u64::from(s).saturating_add(1))
}

impl fmt::Display for Rejection {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
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
        }
    }
}
