//! A printed coefficient listing against the truth, and the other claims of its source.
//!
//! Nothing here is typed in but what the source prints: true coefficients come from `expand`, everything said about
//! them is computed. The paper's own listing is `paper.toml`.

mod claims;
mod compare;
mod correction;
mod decimal;
pub mod net;
mod site;
mod span;
mod targets;

pub use claims::{ClaimVerdict, Judgement};
pub use compare::{Difference, Finding, Relation};
pub use correction::{Change, Correction};
pub use decimal::decimal;
pub use targets::{Target, Targets};

use compare::{Printed, compare, explain};

use crate::control::{Control, Interrupted};
use crate::exact::{Limit, Stop, Work};
use crate::expand::ExpansionError;
use crate::formats::listing::{Listing, ListingError, ListingFault, Meaning, Scope, Symbol};
use crate::formats::net::NetError;
use crate::statement::{Place, Statement};

/// The paper's listing: Eq. 11, and what the paper claims beside it.
pub const PAPER: &str = include_str!("paper.toml");

/// What an audit found.
#[derive(Debug, Clone)]
pub struct Audit {
    /// One for each printed coefficient, in the order of the listing.
    pub findings: Vec<Finding>,
    /// Coefficients that are not zero and not in the listing, by their index.
    pub unlisted: Vec<Target>,
    /// One for each claim.
    pub claims: Vec<ClaimVerdict>,
    /// How many coefficients or equations the statement has, those that are zero among them.
    pub equations: usize,
    /// How many coefficients and claims are printed; if the work was stopped, not all of them were judged.
    pub printed: [usize; 2],
    /// What cut the work short, if anything did: judgements that had not been made are missing, and explanations.
    pub stopped: Option<Interrupted>,
}

/// What an audit comes to.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Verdict {
    /// Everything printed was judged, and nothing is wrong.
    Agrees,
    /// Something printed is wrong.
    Differs,
    /// Nothing is known to be wrong, but not everything was judged.
    Undecided,
}

/// Units of work for the explanations of all differences of a listing: what is found at all is found with much less.
const EXPLAINING: u64 = 400_000_000;

/// Why there is no audit.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum AuditError {
    /// The listing does not fit the statement.
    #[error("{0}")]
    Listing(#[from] ListingError),
    /// A net that cannot be read, in words.
    #[error("{0}")]
    Net(String),
    /// A limit.
    #[error("{0}")]
    Limit(#[from] Limit),
    /// The statement has a surface condition that the trusted part could not expand.
    #[error("the statement is beyond the limits of the checker: {0}")]
    TooLarge(Stop),
    /// Stopped by the user or by the clock.
    #[error("stopped: {0}")]
    Interrupted(#[from] Interrupted),
}

impl From<NetError> for AuditError {
    fn from(error: NetError) -> Self {
        match error {
            NetError::Net(words) => AuditError::Net(words),
            NetError::Expression(error) => AuditError::Listing(error),
            NetError::Limit(limit) => AuditError::Limit(limit),
        }
    }
}

impl From<ExpansionError> for AuditError {
    fn from(error: ExpansionError) -> Self {
        match error {
            ExpansionError::Limit(limit) => AuditError::Limit(limit),
            ExpansionError::Interrupted(why) => AuditError::Interrupted(why),
        }
    }
}

impl Audit {
    /// One difference or one claim that fails is enough to differ; to agree, everything must have been judged.
    pub fn verdict(&self) -> Verdict {
        let wrong = self.findings.iter().any(|finding| !finding.agrees())
            || self.claims.iter().any(|claim| claim.judgement == Judgement::Fails);
        if wrong {
            Verdict::Differs
        } else if self.printed == [self.findings.len(), self.claims.len()] {
            Verdict::Agrees
        } else {
            Verdict::Undecided
        }
    }

    /// Whether every coefficient agrees and no claim fails.
    pub fn agrees(&self) -> bool {
        self.verdict() == Verdict::Agrees
    }

    /// Holds a listing against a statement. What is known when the work is stopped is kept.
    ///
    /// # Errors
    /// [`AuditError`] where a name or a label means nothing in the statement, or where the work is stopped before anything
    /// was judged.
    pub fn of(listing: &Listing, statement: &Statement, control: &Control) -> Result<Self, AuditError> {
        crate::checker::Equations::of(statement, &mut control.work())
            .map_err(|stop| control.unless_stopped(AuditError::TooLarge(stop)))?;
        control.check()?;
        let targets = Targets::of(statement, &listing.labels, listing.basis, control)?;
        // Nothing is all there is to list of a patch on its surface, and of no other.
        if listing.formulas.is_empty() && listing.claims.is_empty() && !targets.vanish() {
            let start = 0..listing.text.len().min(1);
            return Err(ListingError {
                place: Place::of(&listing.text, start),
                fault: ListingFault::NoFormula,
            }
            .into());
        }
        let scope = scope(listing, statement)?;
        let mut named: Vec<(Symbol, Target)> = Vec::new();
        let mut printed = Vec::new();
        let mut reading = control.work();
        for formula in &listing.formulas {
            let value = formula.expression.value(&listing.text, &scope, &mut reading);
            let value = value.map_err(|error| control.unless_stopped(AuditError::from(error)))?;
            for (label, span) in &formula.labels {
                let fault = |fault: ListingFault| ListingError {
                    place: Place::of(&listing.text, span.clone()),
                    fault,
                };
                let target = targets.resolve(label).ok_or_else(|| {
                    let label = label.as_str().chars().take(40).collect();
                    fault(ListingFault::UnknownLabel { label, expected: targets.expected() })
                })?;
                if let Some(first) = named.iter().position(|(_, other)| *other == target) {
                    let before: &Printed<'_> = &printed[first];
                    let line = before.place.line;
                    return Err(fault(ListingFault::RepeatedLabel { label: label.to_string(), line }).into());
                }
                named.push((label.clone(), target));
                printed.push(Printed {
                    label,
                    place: Place::of(&listing.text, span.clone()),
                    target,
                    expression: &formula.expression,
                    value: value.clone(),
                    text: &listing.text,
                });
            }
        }
        let mut audit = Audit {
            findings: Vec::with_capacity(printed.len()),
            unlisted: unlisted(&targets, &named),
            claims: Vec::new(),
            equations: targets.count(),
            printed: [printed.len(), listing.claims.len()],
            stopped: None,
        };
        let case = (statement, &targets, &scope, listing);
        match audit.complete(&printed, &named, case, control) {
            Ok(()) => Ok(audit),
            Err(AuditError::Interrupted(why)) if !audit.findings.is_empty() || !audit.claims.is_empty() => {
                Ok(Audit { stopped: Some(why), ..audit })
            }
            Err(error) => Err(error),
        }
    }

    /// First all differences, which are the verdict; then the claims; then what may explain the differences.
    fn complete(
        &mut self,
        printed: &[Printed<'_>],
        named: &[(Symbol, Target)],
        (statement, targets, scope, listing): (&Statement, &Targets, &Scope, &Listing),
        control: &Control,
    ) -> Result<(), AuditError> {
        for printed in printed {
            control.check()?;
            let finding = compare(printed, targets, &scope.field, &mut control.work());
            self.findings.push(finding.map_err(|limit| control.unless_stopped(AuditError::from(limit)))?);
        }
        for claim in &listing.claims {
            control.check()?;
            let case = claims::Case { statement, targets, findings: &self.findings, scope, listing };
            let judged = claims::judge(claim, &case, control);
            self.claims.push(judged.map_err(|error| control.unless_stopped(error))?);
        }
        let mut explaining = control.work().at_most(EXPLAINING);
        for (finding, printed) in self.findings.iter_mut().zip(printed) {
            control.check()?;
            explain(finding, printed, targets, named, scope, &mut explaining);
        }
        Ok(control.check()?)
    }
}

/// What the names of a listing mean: the unknowns themselves, and what the listing maps to them.
fn scope(listing: &Listing, statement: &Statement) -> Result<Scope, ListingError> {
    let unknowns = Scope::of(statement.field(), statement.unknowns());
    let mut given = Vec::new();
    for Meaning { name, expression, span } in &listing.names {
        let value = expression.value_within(&unknowns, &mut Work::full()).map_err(|limit| {
            let message = match limit {
                Some(limit) => limit.to_string(),
                None => format!(
                    "the meaning of `{name}` must be an expression in the statement's unknowns, {}",
                    statement.unknowns().join(", ")
                ),
            };
            ListingError {
                place: Place::of(&listing.text, span.clone()),
                fault: ListingFault::File { message },
            }
        })?;
        given.push((name.clone(), Some(value)));
    }
    // An unknown that the listing has its own name for goes by that name alone.
    let mut scope = unknowns;
    scope.names.retain(|_, meaning| !given.iter().any(|(_, value)| value == meaning));
    scope.names.extend(given);
    Ok(scope)
}

fn unlisted(targets: &Targets, named: &[(Symbol, Target)]) -> Vec<Target> {
    let Some((_, first)) = named.first() else { return Vec::new() };
    let is_listed = |target: &Target| named.iter().any(|(_, other)| other == target);
    let all = targets.like(*first).into_iter();
    all.filter(|target| !is_listed(target) && targets.value(*target).is_some_and(|v| !v.is_zero())).collect()
}
