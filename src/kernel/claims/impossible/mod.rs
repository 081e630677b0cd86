//! Claim `impossible`: the equations have no common zero, argued by a straight line of linear combinations.

mod check;
mod text;

use std::fmt;

use crate::equations::Premise;
use crate::exact::Polynomial;
use crate::statement::{Statement, Subject};

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
        let (field, assuming) = (statement.field(), assuming(statement));
        match statement.subject() {
            Subject::System(polynomials) => format!(
                "The system of {} polynomial{} has no zero{assuming} over any field containing {field}.",
                polynomials.len(),
                if polynomials.len() == 1 { "" } else { "s" }
            ),
            Subject::Patch(patch) => {
                let degree = patch.surface.degree();
                let (m, n) = patch.bidegree;
                let count = count_coefficients(m.saturating_mul(degree), n.saturating_mul(degree));
                let surface = statement.coordinate_ring().spell(&patch.surface);
                let patch = format!("this rational Bézier patch of bidegree ({m},{n})");
                let fails = match statement.unknowns() {
                    [] => format!("{patch} does not lie").replacen("this", "This", 1),
                    [one] => format!("For no value of {one}{assuming}, real or complex, does {patch} lie"),
                    many => {
                        let many = many.join(", ");
                        format!("For no values of {many}{assuming}, real or complex, does {patch} lie")
                    }
                };
                format!(
                    "{fails} on the surface {surface} = 0: its {count} coefficients c[r,s] have no common zero \
                     over any field containing {field}{assuming}."
                )
            }
        }
    }

    /// Lines under the sentence.
    pub(super) fn details(&self, _: &Statement) -> Vec<String> {
        let Refuted { steps, multiplier_terms } = self;
        vec![format!("replayed   {steps} steps with {multiplier_terms} terms in their multipliers")]
    }
}

/// ` with w ≠ 0`, or nothing.
pub(super) fn assuming(statement: &Statement) -> String {
    let ring = statement.ring();
    let assumed: Vec<String> =
        statement.nonzero().iter().map(|polynomial| format!("{} ≠ 0", ring.spell(polynomial))).collect();
    if assumed.is_empty() { String::new() } else { format!(" with {}", assumed.join(", ")) }
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
