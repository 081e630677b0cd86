//! `prove`: whether there is a patch on the surface, or a solution.

use super::{Failure, Source, Verdict};
use crate::checker::Claim;
use crate::control::Control;
use crate::problem::Problem;
use crate::prove::{Attempt, Reason, solve};

/// What came of a statement.
#[derive(Debug)]
pub struct Proved {
    /// The statement, over a larger field if it was extended.
    pub source: Source,
    /// The same, as the prover has it.
    pub problem: Problem,
    /// What came of it; its certificate is accepted by the checker.
    pub attempt: Attempt,
    /// Whether radicands were added.
    pub extended: bool,
}

impl Proved {
    /// Impossible, exact or undecided.
    pub fn verdict(&self) -> Verdict {
        match &self.attempt {
            Attempt::Undecided(_) => Verdict::Undecided,
            Attempt::Proved { proof, .. } => match proof.theorem().claim() {
                Claim::Impossible(_) => Verdict::Impossible,
                _ => Verdict::Exact,
            },
        }
    }
}

/// Proves a statement; where asked to `extend`, over a larger field if only that is found to have a zero.
///
/// # Errors
/// Where this program is at fault, or the larger field makes no statement.
pub fn prove(mut source: Source, extend: bool, control: &Control) -> Result<Proved, Failure> {
    let mut extended = false;
    loop {
        let problem = Problem::of(&source.statement);
        let attempt = solve(&problem, control).map_err(Failure::of)?;
        match extension_of(&attempt).filter(|_| extend) {
            // Each time the field grows, and four radicands are the limit.
            Some(radicands) => source = source.with_radicands(radicands)?,
            None => return Ok(Proved { source, problem, attempt, extended }),
        }
        extended = true;
    }
}

/// The radicands with which an undecided statement is exact.
fn extension_of(attempt: &Attempt) -> Option<&[u32]> {
    match attempt {
        Attempt::Undecided(Reason::Consistent(consistent)) => {
            consistent.extension.as_ref().map(|extension| extension.radicands.as_slice())
        }
        _ => None,
    }
}
