//! A printed control net against a surface.

mod correction;
mod document;
mod json;
mod matlab;
mod printed;
mod reading;

pub use correction::{NetChange, NetCorrection};
pub use document::statement_from_json;
pub use json::from_json;
pub use matlab::from_matlab;
pub use printed::{Convention, PrintedNet};
pub use reading::Reading;

use super::AuditError;
use crate::algebra::{FieldElement, Sign, polynomial_from_exact};
use crate::certificate::{Argument, Certificate};
use crate::checker::check_read;
use crate::control::Control;
use crate::exact::Polynomial;
use crate::expand::{Basis, coefficients};
use crate::prove::field_of;
use crate::statement::Statement;

/// `c[r,s]`: r, s, and the value.
pub type Coefficient = (u32, u32, Polynomial);

/// What an audit of a net found.
#[derive(Debug, Clone)]
pub struct NetAudit {
    /// The statement that the net lies on its surface.
    pub statement: Statement,
    /// Whether the independent checker has verified it.
    pub agrees: bool,
    /// All coefficients `c[r,s]` that do not vanish.
    pub residual: Vec<Coefficient>,
    /// How many coefficients there are.
    pub coefficients: usize,
    /// Single changes that put the net on the surface, each exactly and alone: those with values in K that were found.
    pub corrections: Vec<NetCorrection>,
    /// What the two conventions leave, where no single change was found.
    pub readings: Vec<Reading>,
}

impl NetAudit {
    /// Holds a net against its surface.
    ///
    /// # Errors
    /// Where the net makes no statement (the reason in the words of the statement reader), or at a limit.
    pub fn of(net: &PrintedNet, control: &Control) -> Result<Self, AuditError> {
        let statement =
            Statement::read(&net.statement()).map_err(|error| AuditError::Net(error.fault.to_string()))?;
        let (coefficients, residual) = residual_of(&statement)?;
        let agrees = residual.is_empty();
        if agrees {
            // Without unknowns there is nothing to be searched for: the checker expands the net by itself.
            let argument = Argument::Exact(Vec::new());
            let certificate = Certificate { statement: statement.hash(), argument };
            check_read(&statement, &certificate).map_err(|error| {
                AuditError::Net(format!(
                    "the independent checker refused that the net is on the surface: {error}"
                ))
            })?;
        }
        let corrections = if agrees { Vec::new() } else { correction::search(net, &statement, control)? };
        let readings = match agrees || !corrections.is_empty() {
            true => Vec::new(),
            false => reading::readings(net, &statement, control)?,
        };
        Ok(NetAudit { statement, agrees, residual, coefficients, corrections, readings })
    }

    /// The coefficient of largest absolute value, as far as that can be decided.
    pub fn largest(&self) -> Option<&Coefficient> {
        largest(&self.statement, &self.residual)
    }
}

fn largest<'a>(statement: &Statement, residual: &'a [Coefficient]) -> Option<&'a Coefficient> {
    let mut largest = residual.first()?;
    let mut of_largest = size(statement, &largest.2)?;
    for entry in &residual[1..] {
        let of_entry = size(statement, &entry.2)?;
        if (&of_entry - &of_largest).sign() == Sign::Positive {
            (largest, of_largest) = (entry, of_entry);
        }
    }
    Some(largest)
}

/// The absolute value; `None` where the sign is out of reach.
fn size(statement: &Statement, value: &Polynomial) -> Option<FieldElement> {
    let value = polynomial_from_exact(field_of(statement), value).as_constant()?;
    reading::absolute(&value)
}

/// How many coefficients `c[r,s]` there are, and those that do not vanish.
fn residual_of(statement: &Statement) -> Result<(usize, Vec<Coefficient>), AuditError> {
    let all = coefficients(statement, Basis::Bernstein)?.unwrap_or_default();
    let count = all.len();
    let residual = all.into_iter().filter(|c| !c.value.is_zero()).map(|c| (c.index.0, c.index.1, c.value));
    Ok((count, residual.collect()))
}
