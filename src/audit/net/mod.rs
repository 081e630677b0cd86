//! A printed control net against a surface.

mod correction;
mod json;
mod matlab;
mod printed;

pub use correction::{NetChange, NetCorrection};
pub use json::from_json;
pub use matlab::from_matlab;
pub use printed::{Convention, PrintedNet};

use super::AuditError;
use crate::algebra::{FieldElement, polynomial_from_exact};
use crate::elimination::Control;
use crate::exact::Polynomial;
use crate::expand::{Basis, coefficients};
use crate::prove::{Attempt, ProveError, prove};
use crate::statement::Statement;

/// What an audit of a net found.
#[derive(Debug, Clone)]
pub struct NetAudit {
    /// The statement that the net lies on its surface.
    pub statement: Statement,
    /// Whether the independent checker has verified it.
    pub agrees: bool,
    /// All coefficients `c[r,s]` that do not vanish.
    pub residual: Vec<(u32, u32, Polynomial)>,
    /// How many coefficients there are.
    pub coefficients: usize,
    /// Every single change that puts the net on the surface.
    pub corrections: Vec<NetCorrection>,
}

impl NetAudit {
    /// Holds a net against its surface.
    ///
    /// # Errors
    /// Where the net makes no statement (the reason in the words of the statement reader), or at a limit.
    pub fn of(net: &PrintedNet, control: &Control<'_>) -> Result<Self, AuditError> {
        let statement =
            Statement::read(&net.statement()).map_err(|error| AuditError::Net(error.fault.to_string()))?;
        let all = coefficients(&statement, Basis::Bernstein)?.unwrap_or_default();
        let count = all.len();
        let residual: Vec<_> =
            all.into_iter().filter(|c| !c.value.is_zero()).map(|c| (c.index.0, c.index.1, c.value)).collect();
        let attempt = prove(&statement, control).map_err(|error| match error {
            ProveError::TooLarge(limit) => AuditError::TooLarge(limit),
            other => AuditError::Net(other.to_string()),
        })?;
        let agrees = match &attempt {
            Attempt::Proved { theorem, .. } => {
                matches!(theorem.claim(), crate::checker::Claim::Exact { .. }) && residual.is_empty()
            }
            Attempt::Undecided(_) => false,
        };
        let corrections =
            if residual.is_empty() { Vec::new() } else { correction::search(net, &statement, control)? };
        Ok(NetAudit { statement, agrees, residual, coefficients: count, corrections })
    }

    /// The coefficient of largest absolute value, as far as that can be decided.
    pub fn largest(&self) -> Option<&(u32, u32, Polynomial)> {
        let field = crate::prove::field_of(&self.statement);
        let size = |value: &Polynomial| -> Option<FieldElement> {
            let value = polynomial_from_exact(field, value).as_constant()?;
            let negative = value.sign()? == crate::algebra::Sign::Negative;
            Some(if negative { -&value } else { value })
        };
        let mut largest = self.residual.first()?;
        let mut of_largest = size(&largest.2)?;
        for entry in &self.residual[1..] {
            let of_entry = size(&entry.2)?;
            if (&of_entry - &of_largest).sign()? == crate::algebra::Sign::Positive {
                (largest, of_largest) = (entry, of_entry);
            }
        }
        Some(largest)
    }
}
