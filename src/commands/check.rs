//! `check` and `canonical`: what the trusted part says of the bytes of files.

use std::path::Path;

use super::{Failure, Verdict};
use crate::checker::{self, CheckError, Place, Rejection, Theorem};
use crate::exact::Work;
use crate::statement::Statement;

/// What the checker says.
#[derive(Debug)]
pub struct Checked(pub Result<Theorem, Rejection>);

impl Checked {
    /// Verified or rejected.
    pub fn verdict(&self) -> Verdict {
        if self.0.is_ok() { Verdict::Verified } else { Verdict::Rejected }
    }
}

/// A file by the name that errors call it, and its bytes.
pub type Named<'a> = (&'a Path, &'a [u8]);

/// Holds a certificate against a statement, within an allowance.
///
/// # Errors
/// Where one of them cannot be read, or a limit is reached.
pub fn check(
    (statement, text): Named<'_>,
    (certificate, argument): Named<'_>,
    work: &mut Work,
) -> Result<Checked, Failure> {
    match checker::check_within(text, argument, work) {
        Ok(theorem) => Ok(Checked(Ok(theorem))),
        Err(CheckError::Rejected(rejection)) => Ok(Checked(Err(rejection))),
        Err(CheckError::Statement(error)) => Err(Failure::at(statement.display(), &error)),
        Err(CheckError::Certificate(error)) => Err(Failure::at(certificate.display(), &error)),
        Err(error @ CheckError::Limited { place: Place::Equations, .. }) => {
            Err(Failure::in_file(statement, error))
        }
        Err(error @ (CheckError::Limited { .. } | CheckError::Defect(_))) => {
            Err(Failure::in_file(certificate, error))
        }
    }
}

/// The canonical text of a statement, whose SHA-256 certificates name.
///
/// # Errors
/// Where it cannot be read.
pub fn canonical((file, text): Named<'_>) -> Result<String, Failure> {
    let read = Statement::read_bytes(text, &mut Work::full());
    read.map(|statement| statement.canonical()).map_err(|error| Failure::at(file.display(), &error))
}
