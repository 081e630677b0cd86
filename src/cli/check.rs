//! `prove-cap check STATEMENT CERTIFICATE` and `prove-cap canonical STATEMENT`: the trusted commands.

use std::fs::File;
use std::io::Read;
use std::path::Path;

use super::outcome::{Failure, Outcome, Status};
use crate::checker::{CheckError, Claim, Theorem, check, written};
use crate::exact::{Polynomial, Work, limits};
use crate::statement::{Statement, Subject};

/// Reads a file, but not more than one byte beyond its limit.
pub(super) fn read_limited(path: &Path, limit: u64) -> Result<Vec<u8>, Failure> {
    let cannot = |error: std::io::Error| Failure(format!("{}: cannot be read: {error}", path.display()));
    let file = File::open(path).map_err(cannot)?;
    let mut bytes = Vec::new();
    file.take(limit.saturating_add(1)).read_to_end(&mut bytes).map_err(cannot)?;
    Ok(bytes)
}

/// What the checker says of two files.
pub(super) fn examine(statement: &Path, certificate: &Path) -> Result<Result<Theorem, String>, Failure> {
    let statement_bytes = read_limited(statement, limits::STATEMENT_BYTES)?;
    let certificate_bytes = read_limited(certificate, limits::CERTIFICATE_BYTES)?;
    match check(&statement_bytes, &certificate_bytes) {
        Ok(theorem) => Ok(Ok(theorem)),
        Err(CheckError::Rejected(rejection)) => Ok(Err(rejection.to_string())),
        Err(CheckError::Statement(error)) => Err(Failure(format!("{}:{error}", statement.display()))),
        Err(CheckError::Certificate(error)) => Err(Failure(format!("{}:{error}", certificate.display()))),
        Err(error @ CheckError::Equations(_)) => Err(Failure(format!("{}: {error}", statement.display()))),
        Err(error @ (CheckError::Replay { .. } | CheckError::Subdivision { .. })) => {
            Err(Failure(format!("{}: {error}", certificate.display())))
        }
    }
}

/// `check`.
pub fn run(statement: &Path, certificate: &Path) -> Result<Outcome, Failure> {
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
    let bytes = read_limited(statement, limits::STATEMENT_BYTES)?;
    let read = Statement::read_bytes(&bytes, &mut Work::full())
        .map_err(|error| Failure(format!("{}:{error}", statement.display())))?;
    Ok(Outcome::plain(read.canonical()))
}

fn verified(theorem: &Theorem) -> String {
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
    match theorem.claim() {
        Claim::Impossible { steps, multiplier_terms } => {
            let plural = |count: &usize| if *count == 1 { "" } else { "s" };
            lines.push(format!(
                "replayed   {steps} step{}, {multiplier_terms} term{} in the multipliers",
                plural(steps),
                plural(multiplier_terms)
            ));
        }
        Claim::Bounds { values, boxes, .. } => {
            lines.push(format!("replayed   {boxes} boxes"));
            lines.extend(spelled(statement, values));
        }
        Claim::Cover { values, corners, boxes, inward, .. } => {
            lines.push(format!("replayed   {boxes} boxes"));
            lines.push(format!("normal     {}", if *inward { "inward" } else { "outward" }));
            lines.extend(spelled(statement, values));
            let ring = statement.ring();
            for (at, corner) in ["(0,0)", "(1,0)", "(1,1)", "(0,1)"].iter().zip(corners) {
                let corner = corner.each_ref().map(|x| written(&ring, x)).join(", ");
                lines.push(format!("corner     {at} → ({corner})"));
            }
        }
        Claim::Unreachable { boxes, .. } => lines.push(format!("replayed   {boxes} boxes")),
        Claim::Exact { values, .. } | Claim::Solution { values } => lines.extend(spelled(statement, values)),
    }
    lines.push(String::new());
    lines.join("\n")
}

/// The values of the unknowns, a line each.
fn spelled(statement: &Statement, values: &[Polynomial]) -> Vec<String> {
    let ring = statement.ring();
    let pairs = statement.unknowns().iter().zip(values);
    pairs.map(|(name, value)| format!("value      {name} = {}", written(&ring, value))).collect()
}
