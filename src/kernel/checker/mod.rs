//! The independent checker: replays a certificate against a statement and returns a [`Theorem`].
//!
//! It derives the equations from the statement itself, by substitution into the surface polynomial, and
//! multiplies out what the certificate says. It knows no monomial order, no division and no elimination,
//! and uses nothing of the prover. (The prover uses it: both read statements and certificates with the
//! same readers and know the trusted numbers and polynomials, and the prover's reports evaluate the checker's
//! equations; what is found is found with arithmetic and an expansion of the prover's own.)

mod error;
mod theorem;

pub use crate::claims::{
    Bounded, BoundsRejection, Claim, CoverRejection, Covered, ExactNet, ExactRejection, Excluded,
    ImpossibleRejection, Refuted, Rejection, Solution, SubdivisionRejection, UnreachableRejection, written,
};
pub use crate::equations::Equations;
pub use crate::failure::Place;
pub use error::CheckError;
pub use theorem::Theorem;

use crate::certificate::Certificate;
use crate::exact::Work;
use crate::failure::{At, Failure};
use crate::statement::Statement;

/// Checks the bytes of a certificate file against the bytes of a statement file.
///
/// # Errors
/// [`CheckError::Rejected`] where the certificate is well formed and does not prove its claim; the other
/// variants where a file cannot be read or reaches a limit, which says nothing about the claim.
pub fn check(statement: &[u8], certificate: &[u8]) -> Result<Theorem, CheckError> {
    // One allowance for everything that is done for these two files.
    check_within(statement, certificate, &mut Work::full())
}

/// The same with an allowance that the caller holds.
///
/// # Errors
/// As [`check`] has them; where the allowance was ended from outside, a limit.
pub fn check_within(statement: &[u8], certificate: &[u8], work: &mut Work) -> Result<Theorem, CheckError> {
    check_text_within(&Statement::read_bytes(statement, work)?, certificate, work)
}

/// Checks a certificate against a statement, both read already.
///
/// # Errors
/// As [`check`] has them.
pub fn check_read(statement: &Statement, certificate: &Certificate) -> Result<Theorem, CheckError> {
    check_read_within(statement, certificate, &mut Work::full())
}

/// The same with an allowance that the caller holds.
///
/// # Errors
/// As [`check`] has them; where the allowance was ended from outside, a limit.
pub fn check_read_within(
    statement: &Statement,
    certificate: &Certificate,
    work: &mut Work,
) -> Result<Theorem, CheckError> {
    // What was built in memory need not be well formed; what the reader accepts is.
    check_text_within(statement, certificate.write(&statement.ring()).as_bytes(), work)
}

/// The bytes of a certificate file against a statement that was read already.
///
/// # Errors
/// As [`check`] has them; where the allowance was ended from outside, a limit.
pub fn check_text_within(
    statement: &Statement,
    certificate: &[u8],
    work: &mut Work,
) -> Result<Theorem, CheckError> {
    // Files that do not belong together are told apart before the certificate is read with the statement's names.
    if let Some(actual) = Certificate::statement_of(certificate) {
        same(statement, actual)?;
    }
    let certificate = Certificate::read(certificate, &statement.ring(), statement.unknowns().len(), work)?;
    same(statement, &certificate.statement)?;
    let claim = certificate.argument.verify(statement, work)?;
    // What the theorem holds and says.
    statement.charge_theorem(work).at(Place::Values).map_err(|failure: Failure<Rejection>| failure)?;
    Ok(Theorem::established(statement, claim))
}

/// A certificate is for the statement that it names.
fn same(statement: &Statement, named: &str) -> Result<(), CheckError> {
    let expected = statement.hash();
    if named == expected {
        return Ok(());
    }
    Err(Failure::Rejected(Rejection::OtherStatement { expected, actual: named.to_owned() }).into())
}
