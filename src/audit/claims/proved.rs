//! Claims that are theorems.

use super::{Claimed, Judged, Judgement};
use crate::audit::AuditError;
use crate::catalogue;
use crate::certificate::Argument;
use crate::checker::Claim;
use crate::control::Control;
use crate::document::Phrase;
use crate::elimination::Undecided;
use crate::formats::listing::Expectation;
use crate::prove::{Attempt, Reason, prove};
use crate::statement::Statement;

/// A built-in statement comes out as expected: proved anew, and checked.
pub(super) fn proved(
    at: &Claimed<'_>,
    name: &str,
    expected: Expectation,
    control: &Control,
) -> Result<Judged, AuditError> {
    let Some(entry) = catalogue::find(name) else {
        return Err(at.wrong(format!("`{name}` is not a built-in statement")));
    };
    let statement = Statement::read(&entry.statement()).map_err(|error| at.wrong(error.to_string()))?;
    let attempt = prove(&statement, control).map_err(|error| at.wrong(error.to_string()))?;
    Ok(match &attempt {
        Attempt::Proved { proof, .. } => {
            let found = match proof.theorem().claim() {
                Claim::Impossible(_) => Expectation::Impossible,
                _ => Expectation::Exact,
            };
            let how = match &proof.certificate().argument {
                Argument::Impossible(steps) => {
                    format!("{name}: PROVED impossible, a certificate of {} steps, checked", steps.len())
                }
                _ => format!("{name}: EXACT, checked"),
            };
            let judgement = if found == expected { Judgement::Holds } else { Judgement::Fails };
            (judgement, vec![Phrase::words(how)])
        }
        Attempt::Undecided(Reason::Elimination(Undecided::Interrupted(why))) => {
            return Err(why.clone().into());
        }
        Attempt::Undecided(_) => (Judgement::NotChecked, vec![Phrase::words(format!("{name}: UNDECIDED"))]),
    })
}
