//! The trusted commands, `check STATEMENT CERTIFICATE` and `canonical STATEMENT`: what prints VERIFIED.

use std::fs::File;
use std::io::Read;
use std::path::Path;

use crate::checker::{self, CheckError, Place, Theorem};
use crate::exact::{Work, limits};
use crate::outcome::{Failure, Outcome, Status};
use crate::statement::{Statement, Subject};

/// Reads a file, but not more than one byte beyond its limit.
pub fn read_limited(path: &Path, limit: u64) -> Result<Vec<u8>, Failure> {
    let cannot = |error: std::io::Error| Failure(format!("{}: cannot be read: {error}", path.display()));
    let file = File::open(path).map_err(cannot)?;
    let mut bytes = Vec::new();
    file.take(limit.saturating_add(1)).read_to_end(&mut bytes).map_err(cannot)?;
    Ok(bytes)
}

/// What the checker says of two files.
///
/// # Errors
/// Where a file cannot be read, or a limit is reached.
pub fn examine(statement: &Path, certificate: &Path) -> Result<Result<Theorem, String>, Failure> {
    examine_within(statement, certificate, &mut Work::full())
}

/// The same with an allowance that the caller holds.
///
/// # Errors
/// As [`examine`] has them.
pub fn examine_within(
    statement: &Path,
    certificate: &Path,
    work: &mut Work,
) -> Result<Result<Theorem, String>, Failure> {
    let statement_bytes = read_limited(statement, limits::STATEMENT_BYTES.at_most)?;
    let certificate_bytes = read_limited(certificate, limits::CERTIFICATE_BYTES.at_most)?;
    match checker::check_within(&statement_bytes, &certificate_bytes, work) {
        Ok(theorem) => Ok(Ok(theorem)),
        Err(CheckError::Rejected(rejection)) => Ok(Err(rejection.to_string())),
        Err(CheckError::Statement(error)) => Err(Failure(format!("{}:{error}", statement.display()))),
        Err(CheckError::Certificate(error)) => Err(Failure(format!("{}:{error}", certificate.display()))),
        Err(error @ CheckError::Limited { place: Place::Equations, .. }) => {
            Err(Failure(format!("{}: {error}", statement.display())))
        }
        Err(error @ (CheckError::Limited { .. } | CheckError::Defect(_))) => {
            Err(Failure(format!("{}: {error}", certificate.display())))
        }
    }
}

/// `check`.
pub fn check(statement: &Path, certificate: &Path) -> Result<Outcome, Failure> {
    Ok(match examine(statement, certificate)? {
        Ok(theorem) => Outcome { text: verified(&theorem), status: Status::Established },
        Err(rejection) => Outcome {
            text: format!("REJECTED  {}: {rejection}\n", certificate.display()),
            status: Status::Wrong,
        },
    })
}

/// `canonical`.
pub fn canonical(statement: &Path) -> Result<Outcome, Failure> {
    let bytes = read_limited(statement, limits::STATEMENT_BYTES.at_most)?;
    let read = Statement::read_bytes(&bytes, &mut Work::full())
        .map_err(|error| Failure(format!("{}:{error}", statement.display())))?;
    Ok(Outcome::plain(read.canonical()))
}

/// What `check` prints of a theorem.
pub fn verified(theorem: &Theorem) -> String {
    let statement = theorem.statement();
    let mut lines = vec![format!("VERIFIED  {}", theorem.kind())];
    lines.push(String::new());
    lines.push(theorem.sentence());
    lines.push(String::new());
    lines.push(format!("title      {} (not checked)", statement.title()));
    lines.push(format!("statement  sha256 {}", statement.hash()));
    if matches!(statement.subject(), Subject::Patch(_)) && !statement.names_surface() {
        lines.push("surface    the file names none: the unit sphere".to_owned());
    }
    lines.extend(theorem.details());
    lines.push(String::new());
    lines.join("\n")
}
