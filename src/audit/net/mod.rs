//! A printed control net against a surface.

mod correction;
mod reading;

pub use correction::{NetChange, NetCorrection};
pub use reading::Reading;

use super::AuditError;
use crate::algebra::{FieldElement, Sign, polynomial_from_exact};
use crate::certificate::Argument;
use crate::control::{Control, Interrupted};
use crate::exact::Polynomial;
use crate::expand::{Basis, coefficients_of};
use crate::formats::net::PrintedNet;
use crate::problem::{Problem, field_of};
use crate::proof::{NoProof, Proof};
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
    /// Whether the search for single changes came to its end; if not, there may be more.
    pub searched: bool,
    /// What cut the explanation short, if anything did.
    pub stopped: Option<Interrupted>,
}

impl NetAudit {
    /// Holds a net against its surface.
    ///
    /// # Errors
    /// Where the net makes no statement (the reason in the words of the statement reader), at a limit, or where the work is
    /// stopped before there is a verdict.
    pub fn of(net: &PrintedNet, control: &Control) -> Result<Self, AuditError> {
        let statement =
            Statement::read(&net.statement()).map_err(|error| AuditError::Net(error.fault.to_string()))?;
        let (coefficients, residual) = residual_of(&statement, control)?;
        let agrees = residual.is_empty();
        if agrees {
            // Without unknowns there is nothing to be searched for: the checker expands the net by itself.
            Proof::of(&statement, Argument::Exact(Vec::new()), control).map_err(|why| match why {
                NoProof::Interrupted(why) => AuditError::Interrupted(why),
                NoProof::Limit(limit) => AuditError::Limit(limit),
                NoProof::Refused(error) => AuditError::Net(format!(
                    "the independent checker refused that the net is on the surface: {error}"
                )),
            })?;
        }
        let mut audit = NetAudit {
            statement,
            agrees,
            residual,
            coefficients,
            corrections: Vec::new(),
            readings: Vec::new(),
            searched: agrees,
            stopped: None,
        };
        // The verdict is known: what stops the work now takes nothing away.
        match audit.explain(net, control) {
            Ok(()) => Ok(audit),
            Err(AuditError::Interrupted(why)) => Ok(NetAudit { stopped: Some(why), ..audit }),
            Err(error) => Err(error),
        }
    }

    /// Looks for what puts the net on the surface, or else for what each convention leaves.
    fn explain(&mut self, net: &PrintedNet, control: &Control) -> Result<(), AuditError> {
        if self.agrees {
            return Ok(());
        }
        self.searched = correction::search(net, self, control)?;
        if self.corrections.is_empty() {
            reading::readings(net, self, control)?;
        }
        Ok(())
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
fn residual_of(statement: &Statement, control: &Control) -> Result<(usize, Vec<Coefficient>), AuditError> {
    let all = coefficients_of(&Problem::of(statement), Basis::Bernstein, control)?.unwrap_or_default();
    let count = all.len();
    let residual = all.into_iter().filter(|c| !c.value.is_zero()).map(|c| (c.index.0, c.index.1, c.value));
    Ok((count, residual.collect()))
}
