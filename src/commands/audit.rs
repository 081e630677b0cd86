//! `audit`: a printed listing, or a printed control net, against the truth.

use super::{Failure, NoAnswer, Source, Undecided, Verdict};
use crate::audit::net::NetAudit;
use crate::audit::{Audit, AuditError};
use crate::control::Control;
use crate::exact::Ring;
use crate::formats::listing::{Listing, in_statement_language};
use crate::formats::net::PrintedNet;
use crate::statement::COORDINATES;

/// A listing of formulas, held against a statement.
#[derive(Debug)]
pub struct AuditedListing {
    /// What is printed.
    pub listing: Listing,
    /// What is true.
    pub source: Source,
    /// What was found.
    pub audit: Audit,
}

/// A net, held against a surface.
#[derive(Debug)]
pub struct AuditedNet {
    /// What is printed.
    pub net: PrintedNet,
    /// What was found.
    pub audit: NetAudit,
}

impl AuditedListing {
    /// Whether all that is printed is right.
    pub fn verdict(&self) -> Verdict {
        self.audit.verdict().into()
    }
}

impl AuditedNet {
    /// Whether the net lies on the surface.
    pub fn verdict(&self) -> Verdict {
        if self.audit.agrees { Verdict::Agrees } else { Verdict::Differs }
    }
}

/// The listing with what its names mean in the statement, `w_{11}=w`, and which coefficients its labels name, `a_{14}=4,2`.
///
/// # Errors
/// Where one of them cannot be read.
pub fn mapped(mut listing: Listing, names: &[String], labels: &[String]) -> Result<Listing, Failure> {
    for mapping in names {
        listing.map_name(mapping).map_err(|error| Failure::about("--name", error))?;
    }
    for mapping in labels {
        listing.map_label(mapping).map_err(|error| Failure::about("--label", error))?;
    }
    Ok(listing)
}

/// Holds a listing against a statement. `place` is what errors call the listing.
///
/// # Errors
/// [`NoAnswer`]
pub fn audit_listing(
    place: &str,
    listing: Listing,
    source: Source,
    control: &Control,
) -> Result<AuditedListing, NoAnswer> {
    match Audit::of(&listing, &source.statement, control) {
        Ok(audit) => Ok(AuditedListing { listing, source, audit }),
        Err(error) => Err(unaudited(place, error)),
    }
}

/// Holds a net against its surface, or against another one in the language of statements.
///
/// # Errors
/// [`NoAnswer`]
pub fn audit_net(
    place: &str,
    mut net: PrintedNet,
    surface: Option<&str>,
    control: &Control,
) -> Result<AuditedNet, NoAnswer> {
    if let Some(surface) = surface {
        let ring = Ring { field: net.field.clone(), variables: COORDINATES.map(String::from).to_vec() };
        let surface = in_statement_language(surface, &ring);
        let surface = surface.map_err(|error| Failure::about("--surface", error.fault))?;
        net.surface = Some(surface.into_owned());
    }
    match NetAudit::of(&net, control) {
        Ok(audit) => Ok(AuditedNet { net, audit }),
        Err(error) => Err(unaudited(place, error)),
    }
}

/// An audit that was interrupted, or that the checker cannot follow, has no verdict; any other error is one.
fn unaudited(place: &str, error: AuditError) -> NoAnswer {
    match error {
        AuditError::Interrupted(why) => {
            let reason = format!("the audit was stopped: {why}");
            Undecided { reason, named: false, ..Undecided::stopped(place, why) }.into()
        }
        error @ AuditError::TooLarge(_) => Undecided::new(place, error.to_string()).into(),
        error => failure(place, error).into(),
    }
}

/// The place of a fault in a listing is a line of it.
pub(super) fn failure(place: &str, error: AuditError) -> Failure {
    match error {
        AuditError::Listing(error) => Failure::at(place, &error),
        error => Failure::in_file(place.as_ref(), error),
    }
}
