//! `bound`: between which decimals the radius, or F/Wᵉ, of a patch lies.

use super::{Failure, NoAnswer, Source, Undecided, Verdict};
use crate::approximation::{Enclosure, EnclosureError, EndVerdict, Finding, enclose, judge};
use crate::control::Control;
use crate::exact::Polynomial;
use crate::statement::{Statement, Subject};

/// What is to be enclosed, and what is printed of it.
#[derive(Debug)]
pub struct Bounding {
    /// The patch.
    pub source: Source,
    /// A constant for each unknown.
    pub values: Vec<Polynomial>,
    /// Decimal places of the bounds.
    pub places: u32,
    /// A printed interval that is held against them.
    pub claim: Option<[String; 2]>,
}

/// Proved bounds.
#[derive(Debug)]
pub struct Bounded {
    /// The patch.
    pub source: Source,
    /// e, the degree of its surface.
    pub degree: u32,
    /// The bounds with their certificate, which the checker has accepted.
    pub enclosure: Enclosure,
    /// The printed interval, and what is true of its ends.
    pub claim: Option<([String; 2], Vec<EndVerdict>)>,
}

impl Bounded {
    /// Of the bounds, or of the printed interval.
    pub fn verdict(&self) -> Verdict {
        let Some((_, verdicts)) = &self.claim else { return Verdict::Enclosed };
        let any = |is: fn(&Finding) -> bool| verdicts.iter().any(|EndVerdict { finding, .. }| is(finding));
        if any(|finding| matches!(finding, Finding::Fails { .. })) {
            Verdict::Differs
        } else if any(|finding| matches!(finding, Finding::Open)) {
            Verdict::Undecided
        } else {
            Verdict::Agrees
        }
    }
}

/// Encloses the quantity over the whole patch.
///
/// # Errors
/// [`NoAnswer`]
pub fn bound(request: Bounding, control: &Control) -> Result<Bounded, NoAnswer> {
    let Bounding { source, values, places, claim } = request;
    let degree = degree_of(&source.statement)?;
    let enclosure =
        enclose(&source.statement, &values, places, control).map_err(|error| unenclosed(&source, error))?;
    let claim = claim.map(|printed| {
        let verdicts = judge(&source.statement, &enclosure, &printed).map_err(Failure::of)?;
        Ok::<_, Failure>((printed, verdicts))
    });
    Ok(Bounded { claim: claim.transpose()?, source, degree, enclosure })
}

/// e, the degree of the surface.
///
/// # Errors
/// For a bare system.
pub fn degree_of(statement: &Statement) -> Result<u32, Failure> {
    match statement.subject() {
        Subject::Patch(patch) => Ok(patch.surface.degree()),
        Subject::System(_) => Err(Failure::of(EnclosureError::NotAPatch)),
    }
}

/// What a search that ended without an enclosure comes to.
pub(super) fn unenclosed(source: &Source, error: EnclosureError) -> NoAnswer {
    let name = &source.name;
    let undecided = |undecided| Undecided { patch: Some(source.statement.clone()), ..undecided }.into();
    match error {
        EnclosureError::Interrupted(why) => undecided(Undecided::stopped(name, why)),
        EnclosureError::TooFine(_)
        | EnclosureError::NearZero(_)
        | EnclosureError::Unsettled { .. }
        | EnclosureError::Limit(_) => undecided(Undecided::new(name, error.to_string())),
        error => Failure::about(name, error).into(),
    }
}
