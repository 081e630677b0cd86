//! Claim `exact`: the equations have a certain common zero.

mod check;
mod text;

use std::fmt;

use super::wording;
use crate::equations::Premise;
use crate::exact::Polynomial;
use crate::statement::{HomogeneousPoint, Statement, Subject};

pub(super) use check::{Zero, copies, evaluated, verify};
pub(super) use text::{read, spelled, value_lines, write};

/// At these values the patch lies on the surface.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ExactNet {
    /// The value of each unknown, a constant of K.
    pub values: Vec<Polynomial>,
    /// The control net at these values: rows i = 0..m along u, points j = 0..n along v.
    pub net: Vec<Vec<HomogeneousPoint>>,
    /// Whether every weight is positive, so that the patch is defined on the whole closed square.
    pub weights_positive: bool,
}

/// These values solve the system.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Solution {
    /// The value of each unknown, a constant of K.
    pub values: Vec<Polynomial>,
}

/// What is wrong with values.
#[derive(Debug, Clone, PartialEq, Eq)]
#[allow(missing_docs, reason = "the fields are what the message prints")]
pub enum Rejection {
    /// An equation that does not vanish at the stated values.
    NotAZero { equation: Premise, actual: String },
    /// An assumption that vanishes at the stated values.
    AssumptionVanishes { assumption: Premise },
    /// A patch whose denominator W is the zero polynomial at the stated values.
    NoDenominator,
}

impl ExactNet {
    /// `exact`.
    pub(super) fn kind(&self) -> &'static str {
        "exact"
    }

    /// What was proved.
    pub(super) fn sentence(&self, statement: &Statement) -> String {
        let defined = if self.weights_positive {
            "Every weight is positive, so the patch is defined on the whole square."
        } else {
            "Not every weight is positive; that the denominator vanishes nowhere on the square is not claimed."
        };
        let surface = match statement.subject() {
            Subject::Patch(patch) => wording::surface(statement, patch),
            Subject::System(_) => "the surface".to_owned(),
        };
        format!(
            "{}{} every point of the patch whose denominator is not zero lies on {surface}. {defined}",
            wording::at_values(statement),
            wording::where_assumptions(statement),
        )
    }

    /// Lines under the sentence.
    pub(super) fn details(&self, statement: &Statement) -> Vec<String> {
        spelled(statement, &self.values)
    }
}

impl Solution {
    /// `solution`.
    pub(super) fn kind(&self) -> &'static str {
        "solution"
    }

    /// What was proved.
    pub(super) fn sentence(&self, statement: &Statement) -> String {
        if statement.unknowns().is_empty() {
            return "Every polynomial of the system is zero.".to_owned();
        }
        let also =
            wording::assumptions(statement).map_or_else(String::new, |assumed| format!(", with {assumed}"));
        format!("The stated values in {} solve the system{also}.", statement.field())
    }

    /// Lines under the sentence.
    pub(super) fn details(&self, statement: &Statement) -> Vec<String> {
        spelled(statement, &self.values)
    }
}

impl fmt::Display for Rejection {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Rejection::NotAZero { equation, actual } => {
                write!(f, "{equation} does not vanish at these values\nexpected  0\nactual    {actual}")
            }
            Rejection::AssumptionVanishes { assumption } => {
                write!(f, "the assumption of {assumption} fails: it vanishes at these values")
            }
            Rejection::NoDenominator => {
                write!(f, "the denominator W of the patch is the zero polynomial at these values")
            }
        }
    }
}
