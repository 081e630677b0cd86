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
use crate::failure::Failure;
use crate::statement::Statement;

/// Checks the bytes of a certificate file against the bytes of a statement file.
///
/// # Errors
/// [`CheckError::Rejected`] where the certificate is well formed and does not prove its claim; the other
/// variants where a file cannot be read or reaches a limit, which says nothing about the claim.
pub fn check(statement: &[u8], certificate: &[u8]) -> Result<Theorem, CheckError> {
    // One allowance for everything that is done for these two files.
    let mut work = Work::full();
    let statement = Statement::read_bytes(statement, &mut work)?;
    let certificate =
        Certificate::read(certificate, &statement.ring(), statement.unknowns().len(), &mut work)?;
    examine(&statement, &certificate, &mut work)
}

/// Checks a certificate against a statement, both read already.
pub fn check_read(statement: &Statement, certificate: &Certificate) -> Result<Theorem, CheckError> {
    // What was built in memory need not be well formed; what the reader accepts is.
    let (ring, mut work) = (statement.ring(), Work::full());
    let text = certificate.write(&ring);
    let read = Certificate::read(text.as_bytes(), &ring, statement.unknowns().len(), &mut work)?;
    examine(statement, &read, &mut work)
}

fn examine(statement: &Statement, certificate: &Certificate, work: &mut Work) -> Result<Theorem, CheckError> {
    let expected = statement.hash();
    if certificate.statement != expected {
        let actual = certificate.statement.clone();
        return Err(Failure::Rejected(Rejection::OtherStatement { expected, actual }).into());
    }
    let claim = certificate.argument.verify(statement, work)?;
    Ok(Theorem::established(statement, claim))
}
